"""The command that reads stiffness and damping off a recorded free vibration."""

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
from plategait.model.measured import as_text
from plategait.model.presets import as_scenario
from plategait.units import Quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from plategait.identify.modes.result import RingResult
    from plategait.identify.series import Window

_LENGTH_SD = Quantity("m", "mm", "0.2 mm", at_least=0)
_AREA_MASS = Quantity("kg/m^2", "kg/m^2", "2.7 kg/m^2", above=0)


@dataclass(frozen=True)
class SpecimenOptions:
    """What rings: a whole sheet, or a strip of it."""

    support: Annotated[
        Literal["free", "cantilever"],
        typer.Option("--support", help="free: the whole sheet, its dish mode. cantilever: a strip clamped level."),
    ] = "free"
    sheet: Annotated[str, typer.Option("--sheet", help="Preset or scenario file whose sheet it is.")] = "cheese"
    length: Annotated[str | None, typer.Option("--length", help='Free length of the strip: "20 mm".')] = None
    length_sd: Annotated[str, typer.Option("--length-sd", help='How sure that is, one sd: "0.2 mm".')] = "0 mm"
    mass_per_area: Annotated[
        str | None, typer.Option("--mass-per-area", help='Of the strip: "2.7 kg/m^2". The sheet\'s if left out.')
    ] = None


@grouped
def ring(
    context: typer.Context,
    recording: Annotated[
        Path, typer.Argument(metavar="RING.csv", help="Columns time_s and one of deflection_mm, angle_deg, signal.")
    ],
    *,
    specimen: SpecimenOptions,
    start: Annotated[str | None, typer.Option("--from", help='Time from which it rings freely: "0.05 s".')] = None,
    end: Annotated[str | None, typer.Option("--to", help="Time until which it does.")] = None,
    mode: Annotated[
        int | None, typer.Option("--mode", help="Which mode, from 1 for the slowest; the strongest.")
    ] = None,
    output: OutputOptions,
) -> None:
    """Bending stiffness and damping from how a sheet, or a strip of it, rings after it was let go."""
    output.check()
    if specimen.support == "free":
        refuse(context, ["length", "length_sd", "mass_per_area"], "with --support free", "--support cantilever")
    result = _identify(recording, specimen, between(start, end), mode)
    determined = result.stiffness is not None
    output.deliver(
        result,
        determined=determined,
        answered=determined,
        draw=_draw,
        show=_print,
    )


def _identify(recording: Path, specimen: SpecimenOptions, window: Window, mode: int | None) -> RingResult:
    from plategait.identify.modes.fit import identify_ring
    from plategait.identify.modes.recording import read_ring

    length, mass = specimen.length, specimen.mass_per_area
    return identify_ring(
        read_ring(recording),
        as_scenario(specimen.sheet, "--sheet").sheet,
        support=specimen.support,
        length=None if length is None else LENGTH.read(length, "--length"),
        length_sd=_LENGTH_SD.read(specimen.length_sd, "--length-sd"),
        mass_per_area=None if mass is None else _AREA_MASS.read(mass, "--mass-per-area"),
        start=window.start,
        end=window.end,
        mode=mode,
    )


def _draw(result: RingResult) -> Figure:
    from plategait.identify.modes.figures import plot_ring

    return plot_ring(result)


def _print(result: RingResult) -> None:
    rows = [
        [
            f"mode {i}" + (" *" if i - 1 == result.mode_index else ""),
            as_text(m.omega, factor=1 / (2 * math.pi)),
            as_text(m.damping_ratio),
            f"{100 * m.share:.0f} %",
            "rings" if m.rings else "settles",
        ]
        for i, m in enumerate(result.modes, start=1)
    ]
    report.print_table(f"{result.name}: modes, with 95 % intervals", ["", "Hz", "damping ratio", "share", ""], rows)
    if result.stiffness:
        per_degree = 1e3 * math.radians(1)
        rows = [
            ["natural frequency", as_text(result.natural_frequency, factor=1 / math.pi), "π rad/s"],
            ["bending stiffness", as_text(result.stiffness, factor=per_degree), "N*mm/deg"],
            ["bending damping", as_text(result.damping, factor=per_degree), "N*mm/(deg/s)"],
        ]
        report.print_table(f"{result.sheet}, from mode {(result.mode_index or 0) + 1}", ["", "", ""], rows)
    for note in result.notes:
        print(note)
