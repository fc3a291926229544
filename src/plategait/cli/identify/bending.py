"""The command that reads the bending joint off a recording of a sagging strip."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from plategait.cli import report
from plategait.cli.command import refuse
from plategait.cli.groups import grouped
from plategait.cli.identify.shared import LENGTH, OutputOptions, between
from plategait.identify.fit import if_determined
from plategait.model.measured import as_text
from plategait.units import Quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from plategait.identify.bending.result import BendingResult
    from plategait.theory.two_links import Strip

_MASS = Quantity("kg", "g", "0.285 g", above=0, at_most=0.1)


@dataclass(frozen=True)
class StripOptions:
    """The strip."""

    mass: Annotated[str, typer.Option("--mass", help="Of one of the two links.")] = "0.285 g"
    length: Annotated[str, typer.Option("--length", help="Of one link: half the free strip.")] = "10 mm"
    width: Annotated[str | None, typer.Option("--width", help="Of the strip. The length of a link if left out.")] = None

    @property
    def strip(self) -> Strip:
        """One link."""
        from plategait.theory.two_links import Strip

        return Strip(_MASS.read(self.mass, "--mass"), LENGTH.read(self.length, "--length"))

    @property
    def width_m(self) -> float | None:
        """Width of the strip, m."""
        return LENGTH.read(self.width, "--width") if self.width is not None else None


@dataclass(frozen=True)
class ModelOptions:
    """How the recording is fitted, and which part of it."""

    method: Annotated[
        Literal["trajectory", "regression"], typer.Option("--method", help="trajectory, or regression as in (3.5).")
    ] = "trajectory"
    wall: Annotated[
        Literal["measured", "free", "joint"],
        typer.Option("--wall", help="Joint 1: measured (moves as recorded), free (fitted), joint (as joint 2)."),
    ] = "measured"
    centripetal: Annotated[
        bool, typer.Option("--centripetal/--no-centripetal", help="Keep the term that (3.3) drops.")
    ] = True
    start: Annotated[str | None, typer.Option("--from", help='Time of the release: "0.05 s".')] = None
    end: Annotated[str | None, typer.Option("--to", help="Time until which the strip swings freely.")] = None


@grouped
def bending(
    context: typer.Context,
    recording: Annotated[
        Path,
        typer.Argument(metavar="CANTILEVER.csv", help="Columns time_s, phi1_deg, phi2_deg, or time_s, x0_mm to y2_mm."),
    ],
    *,
    strip: StripOptions,
    model: ModelOptions,
    y_down: Annotated[
        bool, typer.Option("--y-down", help="y of the markers counts downwards, as in pictures.")
    ] = False,
    output: OutputOptions,
) -> None:
    """Stiffness and damping of the bending joint from how a released strip sags."""
    output.check()
    if model.method == "regression":
        refuse(context, ["wall"], "with --method regression", "--method trajectory")
    from plategait.identify.bending.recording import read_angles
    from plategait.identify.bending.result import identify_bending

    result = identify_bending(
        read_angles(recording, y_down=y_down),
        strip=strip.strip,
        width=strip.width_m,
        method=model.method,
        wall=model.wall,
        centripetal=model.centripetal,
        window=between(model.start, model.end),
    )
    output.deliver(
        result,
        determined=bool(result.parameters),
        answered="sheet.bending_stiffness" in result.parameters,
        draw=_draw,
        show=_print,
    )


def _draw(result: BendingResult) -> Figure:
    from plategait.identify.bending.figures import plot_bending

    return plot_bending(result)


def _print(result: BendingResult) -> None:
    from plategait.identify.bending.result import PER_DEGREE

    rows = [
        ["bending stiffness k_b", as_text(if_determined(result.stiffness), factor=PER_DEGREE), "N*mm/deg"],
        ["bending damping c_b", as_text(if_determined(result.damping), factor=PER_DEGREE), "N*mm/(deg/s)"],
    ]
    if result.wall_stiffness and result.wall_damping:
        rows += [
            ["stiffness at the wall", as_text(if_determined(result.wall_stiffness), factor=PER_DEGREE), "N*mm/deg"],
            ["damping at the wall", as_text(if_determined(result.wall_damping), factor=PER_DEGREE), "N*mm/(deg/s)"],
        ]
    rows += [
        ["correlation of the two", f"{result.correlation:.2f}", ""],
        ["missed of the angle", f"{math.degrees(result.residual_rms):.3g}", "deg rms"],
    ]
    link = f"links of {1e3 * result.strip.mass:.4g} g and {1e3 * result.strip.length:.4g} mm"
    report.print_table(f"{result.method}, {link}, 95 % intervals", ["", "", ""], rows)
    for note in result.notes:
        print(note)
