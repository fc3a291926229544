"""The command that reads the bending joint off a recording of a sagging strip."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from plategait.cli import options, report
from plategait.identify.likelihood import known
from plategait.identify.shown import words
from plategait.output import check_writable
from plategait.units import Quantity

if TYPE_CHECKING:
    from plategait.identify.bending import BendingResult

PICTURES = (".png", ".pdf", ".svg")
_MASS = Quantity("kg", "g", "0.285 g", above=0)
_LENGTH = Quantity("m", "mm", "10 mm", above=0)
_TIME = Quantity("s", "s", "0.05 s")


def bending(
    recording: Annotated[
        Path,
        typer.Argument(metavar="CANTILEVER.csv", help="Columns time_s, phi1_deg, phi2_deg, or time_s, x0_mm to y2_mm."),
    ],
    mass: Annotated[str, typer.Option("--mass", help="Of one of the two links.")] = "0.285 g",
    length: Annotated[str, typer.Option("--length", help="Of one link: half the free strip.")] = "10 mm",
    width: Annotated[
        str | None, typer.Option("--width", help="Of the strip. The length of a link if left out.")
    ] = None,
    method: Annotated[str, typer.Option("--method", help="trajectory, or regression as in (3.5).")] = "trajectory",
    wall: Annotated[
        str,
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
    out: Annotated[Path | None, typer.Option("--out", help="Write the result to lay over a scenario: .toml.")] = None,
    plot: options.Plot = None,
    as_json: options.Json = False,
) -> None:
    """Stiffness and damping of the bending joint from how a released strip sags."""
    if out:
        check_writable(out, (".toml",), "--out")
    if plot:
        check_writable(plot, PICTURES, "--plot")
    from plategait.identify.bending import identify_bending
    from plategait.identify.markers import read_angles
    from plategait.identify.recording import Window
    from plategait.identify.two_links import Strip

    strip = Strip(_MASS.read(mass, "--mass"), _LENGTH.read(length, "--length"))
    result = identify_bending(
        read_angles(recording, y_down=y_down),
        strip=strip,
        width=_LENGTH.read(width, "--width") if width is not None else None,
        method=method,  # type: ignore[arg-type]
        wall=wall,  # type: ignore[arg-type]
        centripetal=centripetal,
        window=Window(
            _TIME.read(start, "--from") if start is not None else -math.inf,
            _TIME.read(end, "--to") if end is not None else math.inf,
        ),
    )
    if out and result.parameters:
        from plategait.fragment import write_fragment

        write_fragment(result.to_fragment(), out)
    if plot:
        from plategait.identify.figures import plot_bending
        from plategait.plots import save

        save(plot_bending(result), plot)
    report.print_json(result.summary()) if as_json else _print(result)
    raise typer.Exit(0 if "sheet.bending_stiffness" in result.parameters else 1)


def _print(result: BendingResult) -> None:
    from plategait.identify.bending import PER_DEGREE

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
