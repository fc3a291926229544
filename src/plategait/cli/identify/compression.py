"""The command that reads the axial joint off a recording of a pressed link."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from plategait.cli import options, report
from plategait.cli.identify import shared as identified
from plategait.identify.fit import known
from plategait.model.measured import words
from plategait.units import Quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from plategait.identify.compression.result import CompressionResult

_THICKNESS = Quantity("m", "mm", "2.5 mm", above=0, at_most=1)


def compression(
    recording: Annotated[Path, typer.Argument(metavar="PRESS.csv", help="Columns time_s, displacement_mm, force_N.")],
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
    out: identified.Out = None,
    plot: options.Plot = None,
    as_json: options.Json = False,
) -> None:
    """Stiffness and damping of the axial joint from displacement and force of a press."""
    identified.check_files(out, plot)
    from plategait.identify.compression.result import identify_compression, read_pressing
    from plategait.identify.series import Window

    result = identify_compression(
        read_pressing(recording),
        thickness=_THICKNESS.read(thickness, "--thickness"),
        length=identified.LENGTH.read(length, "--length"),
        method=method,
        offset=offset,
        window=Window(*identified.between(start, end)),
    )

    def draw() -> Figure:
        from plategait.identify.compression.figures import plot_compression

        return plot_compression(result)

    identified.deliver(
        result,
        bool(result.parameters),
        out=out,
        plot=plot,
        as_json=as_json,
        draw=draw,
        show=lambda: _print(result),
        answered="sheet.axial_stiffness" in result.parameters,
    )


def _print(result: CompressionResult) -> None:
    rows = [
        ["of the surface, k_s", words(known(result.surface_stiffness), factor=1e-3), "N/mm"],
        ["of the surface, c_s", words(known(result.surface_damping), factor=1e-3), "N/(mm/s)"],
        ["axial stiffness k_c (3.9)", words(known(result.stiffness), factor=1e-3), "N/mm"],
        ["axial damping c_c (3.9)", words(known(result.damping), factor=1e-3), "N/(mm/s)"],
        ["correlation of the two", f"{result.correlation:.2f}", ""],
        ["missed of the force", f"{result.residual_rms:.3g}", "N rms"],
    ]
    if result.offset:
        rows.append(["force at displacement 0", words(result.offset), "N"])
    report.print_table(f"{result.method}, 95 % intervals", ["", "", ""], rows)
    for note in result.notes:
        print(note)
