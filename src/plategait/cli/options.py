"""Options that the commands share, and the scenario that they add up to."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from plategait.cli.command import refuse
from plategait.cli.filmed import LENGTH, read_size
from plategait.cli.material_options import MaterialOptions
from plategait.engine import engines
from plategait.errors import InputError
from plategait.model.fragment import overlay, read_fragment
from plategait.model.parameters import find_parameter, kinetic_follows, with_values
from plategait.model.presets import PRESETS, as_scenario
from plategait.model.scenario import Plate, Scenario
from plategait.units import FREQUENCY, Quantity

if TYPE_CHECKING:
    from numpy.random import Generator

ScenarioName = Annotated[
    str, typer.Argument(metavar="[SCENARIO]", help=f"A TOML file, or one of {', '.join(PRESETS)}.")
]
Sheet = Annotated[str | None, typer.Option("--sheet", help="Take the sheet of this preset or scenario file instead.")]
NaturalFrequency = Annotated[
    str | None,
    typer.Option("--natural-frequency", help='Scale the bending stiffness to this dish mode: "10 pi rad/s", "5 Hz".'),
]
PlateSize = Annotated[
    str | None,
    typer.Option("--plate-size", help='A plate that ends, along the bar and across it: "150 mm", "200 mm x 150 mm".'),
]
SlipLimit = Annotated[
    str | None,
    typer.Option(
        "--slip-limit",
        help='Failed once it has slipped so far: "15 mm". Left out with --plate-size, the plate\'s edge decides.',
    ),
]
Angle = Annotated[str | None, typer.Option("--angle", help='Angular amplitude A_p of the plate: "3 deg".')]
Stroke = Annotated[str | None, typer.Option("--stroke", help='Linear amplitude B_p of the plate: "3 mm".')]
MuS = Annotated[
    str | None, typer.Option("--mu-s", help="Static friction. The kinetic one keeps its ratio to it unless given.")
]
MuK = Annotated[str | None, typer.Option("--mu-k", help="Kinetic friction, at most the static one.")]
Law = Annotated[str | None, typer.Option("--friction-law", help='"thesis" (step at V) or "adams" (smooth).')]
Duration = Annotated[str | None, typer.Option("--duration", help='Simulated time: "4 s".')]
Repeats = Annotated[
    int, typer.Option("--repeats", help="Runs from slightly different starts; mean and spread are reported.")
]
Seed = Annotated[int, typer.Option("--seed", help="Of the different starts.")]
Dt = Annotated[str | None, typer.Option("--dt", help='Time step: "1e-4 s". Chosen from the stiffness if left out.')]
_ENGINES = ", ".join(f"{name} ({row.summary})" for name, row in engines.ENGINES.items())
Engine = Annotated[engines.Engine, typer.Option("--engine", help=f"{_ENGINES}.")]
Plot = Annotated[Path | None, typer.Option("--plot", help="Write a plot: .png, .pdf or .svg.")]
With = Annotated[
    list[Path] | None,
    typer.Option(
        "--with", help="Lay measured parameters (.toml of identify or estimate) over the scenario; repeatable."
    ),
]
Draws = Annotated[
    int,
    typer.Option("--draws", help="Run this many draws of what --with is uncertain of; 0 runs its values only.", min=0),
]
Dask = Annotated[str | None, typer.Option("--dask", help="Run on the Dask cluster at this address.")]
Json = Annotated[bool, typer.Option("--json", help="Print one JSON object instead of a table.")]

SHARE = Quantity("", "", "0.05", above=0)


def read_share(text: str, option: str, quantity: Quantity = SHARE) -> float:
    """A share as a number, or in percent."""
    if text.strip().endswith("%"):
        in_percent = replace(quantity, at_least=100 * quantity.at_least, at_most=100 * quantity.at_most,
                             example=f"{100 * float(quantity.example):g}%")  # fmt: skip
        return in_percent.read(text.strip()[:-1].strip(), option) / 100
    return quantity.read(text, option)


def refuse_idle_seed(context: typer.Context, repeats: int) -> None:
    """Refuse a seed where the only run starts where the scenario says."""
    if repeats == 1:
        refuse(context, ["seed"], "where nothing is left to chance", "--repeats 4")


@dataclass(frozen=True)
class ObjectOptions(MaterialOptions):
    """Object and plate as typed, laid over a scenario."""

    natural_frequency: NaturalFrequency = None
    plate_size: PlateSize = None
    slip_limit: SlipLimit = None
    angle: Angle = None
    stroke: Stroke = None
    mu_s: MuS = None
    mu_k: MuK = None
    measured: With = None

    def over(self, scenario: str, frequency: str | None = None, generator: Generator | None = None) -> Scenario:
        """Scenario of a name with these laid over it, measured parameters drawn where a generator is given."""
        hertz = FREQUENCY.read(frequency, "--frequency") if frequency is not None else None
        own = {field.name for field in fields(self)} - {field.name for field in fields(MaterialOptions)}
        laid_over = {name: getattr(self, name) for name in own}
        return build(scenario, made=self, frequency=hertz, generator=generator, **laid_over)

    def assumed(self, name: str, scenario: Scenario, *, friction_told: bool = False) -> list[str]:
        """What is taken for want of anybody's word, the limit of slip on a plate that ends among it."""
        said = super().assumed(name, scenario, friction_told=friction_told)
        if self.plate_size is None or self.slip_limit is not None or _limits_slip(name, self.measured or []):
            return said
        limit = f"no limit of slip below the plate's diagonal, {1e3 * scenario.slip_limit:.0f} mm"
        return [*said, f"{limit}: its edge decides (--slip-limit for one)"]


@dataclass(frozen=True)
class ScenarioOptions(ObjectOptions):
    """All that may be laid over a scenario."""

    sheet: Sheet = None
    friction_law: Law = None
    duration: Duration = None
    dt: Dt = None


@dataclass(frozen=True)
class EnsembleOptions:
    """How a scenario is run, as typed."""

    repeats: Repeats = 1
    seed: Seed = 0
    engine: Engine = "cpu"


def build(
    name: str,
    *,
    made: MaterialOptions | None = None,
    plate_size: str | None = None,
    slip_limit: str | None = None,
    sheet: str | None = None,
    natural_frequency: str | None = None,
    frequency: float | None = None,
    angle: str | None = None,
    stroke: str | None = None,
    mu_s: str | None = None,
    mu_k: str | None = None,
    friction_law: str | None = None,
    duration: str | None = None,
    dt: str | None = None,
    measured: list[Path] | None = None,
    generator: Generator | None = None,
) -> Scenario:
    """Scenario with the options of the command line laid over it.

    Another scenario's sheet comes first. Measured parameters are laid over it, drawn from their uncertainty where a
    generator is given, and all other options over them. An error names the scenario's parameter, which `Command` turns
    into the option that was typed.
    """
    scenario = as_scenario(name)
    if made is not None and made.of_a_material:
        for option, typed in (("--sheet", sheet), ("--natural-frequency", natural_frequency)):
            if typed is not None:
                raise InputError(
                    option, typed, "left out where a material is told", "leaving out --young and --material"
                )
    if sheet is not None:
        scenario = scenario.replace(sheet=as_scenario(sheet, "--sheet").sheet)
    scenario = overlay(scenario, [read_fragment(path) for path in measured or []], generator)
    if made is not None:
        scenario = made.laid_over(scenario)
    motion = {
        "natural_frequency": natural_frequency, "motion.frequency": frequency, "motion.angle": angle,
        "motion.stroke": stroke, "friction.static": mu_s, "friction.kinetic": mu_k, "friction.law": friction_law,
        "duration": duration, "time_step": dt, "slip_limit": slip_limit,
    }  # fmt: skip
    changes: dict[str, Any] = {}
    if plate_size is not None:
        length, width = read_size(plate_size)
        changes["plate"] = Plate(length=length, width=width)
        if not _limits_slip(name, measured or []):
            # Nowhere on the plate is as far: its edge decides, as the source's own limit is that of an endless plate.
            changes["slip_limit"] = min(math.hypot(length, width), LENGTH.at_most)
    changes |= {name: find_parameter(name, scenario).read(value) for name, value in motion.items() if value is not None}
    if scenario.transient is not None and scenario.transient >= changes.get("duration", math.inf):
        changes["transient"] = None
    return with_values(scenario, kinetic_follows(changes, scenario))


def _limits_slip(name: str, measured: list[Path]) -> bool:
    """Whether a scenario's file, or what is laid over it, says itself at which slip a run has failed."""
    told = name not in PRESETS and "slip_limit" in as_scenario(name).model_fields_set
    return told or any("slip_limit" in read_fragment(path).parameters for path in measured)
