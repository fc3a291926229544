"""The command that reads the axial joint off a recording of a pressed link."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from plategait.cli import report
from plategait.cli.groups import grouped
from plategait.cli.identify.shared import LENGTH, OutputOptions, between
from plategait.identify.fit import if_determined
from plategait.model.measured import as_text
from plategait.units import Quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from plategait.identify.compression.result import CompressionResult

_THICKNESS = Quantity("m", "mm", "2.5 mm", above=0, at_most=1)


@grouped
def compression(
    recording: Annotated[Path, typer.Argument(metavar="PRESS.csv", help="Columns time_s, displacement_mm, force_N.")],
    *,
    thickness: Annotated[str, typer.Option("--thickness", help="d of the pressed link.")] = "2.5 mm",
    length: Annotated[str, typer.Option("--length", help="l, side of the pressed square.")] = "10 mm",
    method: Annotated[
        Literal["trajectory", "regression"], typer.Option("--method", help="trajectory, or regression as in (3.8).")
    ] = "trajectory",
    offset: Annotated[
        bool, typer.Option("--offset", help="Fit the force at displacement 0 as well: a preload, an unknown touch.")
    ] = False,
    start: Annotated[str | None, typer.Option("--from", help='Time from which the jaw touches: "0.05 s".')] = None,
    end: Annotated[str | None, typer.Option("--to", help="Time until which it does.")] = None,
    output: OutputOptions,
) -> None:
    """Stiffness and damping of the axial joint from displacement and force of a press."""
    output.check()
    from plategait.identify.compression.result import identify_compression, read_pressing

    result = identify_compression(
        read_pressing(recording),
        thickness=_THICKNESS.read(thickness, "--thickness"),
        length=LENGTH.read(length, "--length"),
        method=method,
        offset=offset,
        window=between(start, end),
    )
    output.deliver(
        result,
        determined=bool(result.parameters),
        answered="sheet.axial_stiffness" in result.parameters,
        draw=_draw,
        show=_print,
    )


def _draw(result: CompressionResult) -> Figure:
    from plategait.identify.compression.figures import plot_compression

    return plot_compression(result)


def _print(result: CompressionResult) -> None:
    rows = [
        ["of the surface, k_s", as_text(if_determined(result.surface_stiffness), factor=1e-3), "N/mm"],
        ["of the surface, c_s", as_text(if_determined(result.surface_damping), factor=1e-3), "N/(mm/s)"],
        ["axial stiffness k_c (3.9)", as_text(if_determined(result.stiffness), factor=1e-3), "N/mm"],
        ["axial damping c_c (3.9)", as_text(if_determined(result.damping), factor=1e-3), "N/(mm/s)"],
        ["correlation of the two", f"{result.correlation:.2f}", ""],
        ["missed of the force", f"{result.residual_rms:.3g}", "N rms"],
    ]
    if result.offset:
        rows.append(["force at displacement 0", as_text(result.offset), "N"])
    report.print_table(f"{result.method}, 95 % intervals", ["", "", ""], rows)
    for note in result.notes:
        print(note)
