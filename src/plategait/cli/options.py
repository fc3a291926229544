"""Options that the commands share, and the scenario that they add up to."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from plategait.cli.command import refuse
from plategait.engine import engines
from plategait.fragment import overlay, read_fragment
from plategait.presets import PRESETS, as_scenario
from plategait.scenario import Scenario
from plategait.units import ANGULAR_FREQUENCY, PLATE_ANGLE, PLATE_STROKE, Quantity

if TYPE_CHECKING:
    from numpy.random import Generator

_STEP = Quantity("s", "s", "1e-4 s", above=0)
_DURATION = Quantity("s", "s", "4 s", above=0)
_COEFFICIENT = Quantity("", "", "0.75", at_least=0)

ScenarioName = Annotated[
    str, typer.Argument(metavar="[SCENARIO]", help=f"A TOML file, or one of {', '.join(PRESETS)}.")
]
Sheet = Annotated[str | None, typer.Option("--sheet", help="Take the sheet of this preset or scenario file instead.")]
NaturalFrequency = Annotated[
    str | None,
    typer.Option("--natural-frequency", help='Scale the bending stiffness to this dish mode: "10 pi rad/s", "5 Hz".'),
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
Json = Annotated[bool, typer.Option("--json", help="Print one JSON object instead of a table.")]


def refuse_idle_seed(context: typer.Context, repeats: int) -> None:
    """Refuse a seed where the only run starts where the scenario says."""
    if repeats == 1:
        refuse(context, ["seed"], "where nothing is left to chance", "--repeats 4")


def build(
    name: str,
    *,
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
    """Scenario with the options of the command line laid over it, each read under its option's name.

    Measured parameters are laid under them, drawn from their uncertainty where a generator is given.
    """
    scenario = overlay(as_scenario(name), [read_fragment(path) for path in measured or []], generator)
    changes: dict[str, Any] = {}
    if sheet is not None:
        changes["sheet"] = as_scenario(sheet, "--sheet").sheet
    if natural_frequency is not None:
        omega = ANGULAR_FREQUENCY.read(natural_frequency, "--natural-frequency")
        changes["sheet"] = changes.get("sheet", scenario.sheet).with_natural_frequency(omega)
    if frequency is not None:
        changes["motion.frequency"] = frequency
    if angle is not None:
        changes["motion.angle"] = PLATE_ANGLE.read(angle, "--angle")
    if stroke is not None:
        changes["motion.stroke"] = PLATE_STROKE.read(stroke, "--stroke")
    if mu_s is not None:
        changes["friction.static"] = _COEFFICIENT.read(mu_s, "--mu-s")
        changes["friction.kinetic"] = changes["friction.static"] * scenario.friction.ratio
    if mu_k is not None:
        changes["friction.kinetic"] = _COEFFICIENT.read(mu_k, "--mu-k")
    if friction_law is not None:
        changes["friction.law"] = friction_law
    if duration is not None:
        changes["duration"] = _DURATION.read(duration, "--duration")
        if scenario.transient is not None and scenario.transient >= changes["duration"]:
            changes["transient"] = None
    if dt is not None:
        changes["time_step"] = _STEP.read(dt, "--dt")
    return scenario.replace(**changes) if changes else scenario
