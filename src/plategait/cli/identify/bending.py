"""The command that reads the bending joint off a recording of a sagging strip."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from plategait.cli import options, report
from plategait.cli.command import refuse
from plategait.cli.identify import shared as identified
from plategait.identify.fit import known
from plategait.model.measured import words
from plategait.units import Quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from plategait.identify.bending.result import BendingResult

_MASS = Quantity("kg", "g", "0.285 g", above=0, at_most=0.1)


def bending(
    context: typer.Context,
    recording: Annotated[
        Path,
        typer.Argument(metavar="CANTILEVER.csv", help="Columns time_s, phi1_deg, phi2_deg, or time_s, x0_mm to y2_mm."),
    ],
    mass: Annotated[str, typer.Option("--mass", help="Of one of the two links.")] = "0.285 g",
    length: Annotated[str, typer.Option("--length", help="Of one link: half the free strip.")] = "10 mm",
    width: Annotated[
        str | None, typer.Option("--width", help="Of the strip. The length of a link if left out.")
    ] = None,
    method: Annotated[
        Literal["trajectory", "regression"], typer.Option("--method", help="trajectory, or regression as in (3.5).")
    ] = "trajectory",
    wall: Annotated[
        Literal["measured", "free", "joint"],
        typer.Option("--wall", help="Joint 1: measured (moves as recorded), free (fitted), joint (as joint 2)."),
    ] = "measured",
    centripetal: Annotated[
        bool, typer.Option("--centripetal/--no-centripetal", help="Keep the term that (3.3) drops.")
    ] = True,
    start: Annotated[str | None, typer.Option("--from", help='Time of the release: "0.05 s".')] = None,
    end: Annotated[str | None, typer.Option("--to", help="Time until which the strip swings freely.")] = None,
    y_down: Annotated[
        bool, typer.Option("--y-down", help="y of the markers counts downwards, as in pictures.")
    ] = False,
    out: identified.Out = None,
    plot: options.Plot = None,
    as_json: options.Json = False,
) -> None:
    """Stiffness and damping of the bending joint from how a released strip sags."""
    identified.check_files(out, plot)
    if method == "regression":
        refuse(context, ["wall"], "with --method regression", "--method trajectory")
    from plategait.identify.bending.recording import read_angles
    from plategait.identify.bending.result import identify_bending
    from plategait.identify.series import Window
    from plategait.theory.two_links import Strip

    strip = Strip(_MASS.read(mass, "--mass"), identified.LENGTH.read(length, "--length"))
    result = identify_bending(
        read_angles(recording, y_down=y_down),
        strip=strip,
        width=identified.LENGTH.read(width, "--width") if width is not None else None,
        method=method,
        wall=wall,
        centripetal=centripetal,
        window=Window(*identified.between(start, end)),
    )

    def draw() -> Figure:
        from plategait.identify.bending.figures import plot_bending

        return plot_bending(result)

    identified.deliver(
        result,
        bool(result.parameters),
        out=out,
        plot=plot,
        as_json=as_json,
        draw=draw,
        show=lambda: _print(result),
        answered="sheet.bending_stiffness" in result.parameters,
    )


def _print(result: BendingResult) -> None:
    from plategait.identify.bending.result import PER_DEGREE

    rows = [
        ["bending stiffness k_b", words(known(result.stiffness), factor=PER_DEGREE), "N*mm/deg"],
        ["bending damping c_b", words(known(result.damping), factor=PER_DEGREE), "N*mm/(deg/s)"],
    ]
    if result.wall_stiffness and result.wall_damping:
        rows += [
            ["stiffness at the wall", words(known(result.wall_stiffness), factor=PER_DEGREE), "N*mm/deg"],
            ["damping at the wall", words(known(result.wall_damping), factor=PER_DEGREE), "N*mm/(deg/s)"],
        ]
    rows += [
        ["correlation of the two", f"{result.correlation:.2f}", ""],
        ["missed of the angle", f"{math.degrees(result.residual_rms):.3g}", "deg rms"],
    ]
    link = f"links of {1e3 * result.strip.mass:.4g} g and {1e3 * result.strip.length:.4g} mm"
    report.print_table(f"{result.method}, {link}, 95 % intervals", ["", "", ""], rows)
    for note in result.notes:
        print(note)
