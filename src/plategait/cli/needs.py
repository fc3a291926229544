"""`plategait needs`: what the motion of a scenario needs of a machine, and whether it has that."""

from __future__ import annotations

import math
from typing import Annotated

import numpy as np
import typer

from plategait.cli import options, report
from plategait.files.plain import plain
from plategait.model.machine import MACHINES, Machine, machine_of
from plategait.model.motion import AXES
from plategait.model.needs import Needs, excess, needs
from plategait.units import FREQUENCY

Frequency = Annotated[str | None, typer.Option("--frequency", help='Frequency of the plate: "24 Hz".')]
MachineName = Annotated[str, typer.Option("--machine", help=f"A machine's TOML file, or one of {', '.join(MACHINES)}.")]

# What each kind of need is called in JSON, on translations and rotations, and its factor over SI.
_KINDS = (
    ("position_mm", "position_deg"), ("speed_mm_s", "speed_deg_s"), ("acceleration_m_s2", "acceleration_deg_s2"),
    ("jerk_m_s3", "jerk_deg_s3"), ("force_n", "torque_n_m"),
)  # fmt: skip
_SCALES = ((1e3, math.degrees(1)), (1e3, math.degrees(1)), (1.0, math.degrees(1)), (1.0, math.degrees(1)), (1.0, 1.0))
_HEADINGS = ("", "position", "speed", "acceleration", "jerk", "load")
_UNITS = (("mm", "deg"), ("mm/s", "deg/s"), ("m/s²", "deg/s²"), ("m/s³", "deg/s³"), ("N", "N·m"))


def needs_command(
    scenario: options.ScenarioName = "cheese",
    machine: MachineName = "source-robot",
    frequency: Frequency = None,
    angle: options.Angle = None,
    stroke: options.Stroke = None,
    as_json: options.Json = False,
) -> None:
    """What the plate's motion needs of a machine: reach, speed, acceleration, jerk, loads and power.

    Ends with status 1 where that is more than the machine has.
    """
    hertz = FREQUENCY.read(frequency, "--frequency") if frequency is not None else None
    motion = options.build(scenario, frequency=hertz, angle=angle, stroke=stroke).motion
    shaker = machine_of(machine, "--machine")
    needed = needs(motion, shaker)
    beyond = excess(needed, shaker)
    if as_json:
        report.print_json(_numbers(needed, shaker, beyond))
    else:
        _print(needed, shaker, beyond)
    if beyond:
        raise typer.Exit(1)


def _moved(needed: Needs) -> list[int]:
    """Degrees of freedom that the motion moves or holds off their rest."""
    return [d for d in range(len(AXES)) if needed.peaks[0, d] > 0]


def _numbers(needed: Needs, machine: Machine, beyond: list[str]) -> dict[str, object]:
    by_axis = {}
    for d in _moved(needed):
        turns = AXES[d].startswith("r")
        by_axis[AXES[d]] = {
            names[turns]: plain(float(scales[turns] * value))
            for names, scales, value in zip(_KINDS, _SCALES, needed.peaks[:, d], strict=True)
        }
    return {
        "machine": machine.name, "within": not beyond, "beyond": beyond, "frequency_hz": needed.frequency,
        "power_w": plain(needed.power), "mean_power_w": plain(needed.mean_power), "needs": by_axis,
    }  # fmt: skip


def _print(needed: Needs, machine: Machine, beyond: list[str]) -> None:
    rows, limits = [], machine.limits
    for d in _moved(needed):
        turns = AXES[d].startswith("r")
        kinds = zip(_SCALES, _UNITS, needed.peaks[:, d], limits[:, d], strict=True)
        shown = [
            f"{scales[turns] * value:.4g} {units[turns]}" + _of(scales[turns] * limit, value, limit)
            for scales, units, value, limit in kinds
        ]
        rows.append([AXES[d], *("–" if text.startswith("nan") else text for text in shown)])
    report.print_table(f"what the motion needs of {machine.name}", list(_HEADINGS), rows)
    if np.isfinite(needed.power):
        print(f"power {needed.power:.3g} W at most, {needed.mean_power:.3g} W in the mean")
    print("beyond the machine: " + "; ".join(beyond) if beyond else "within the machine's limits")


def _of(shown: float, value: float, limit: float) -> str:
    """The limit beside a need, where there is one."""
    return f" of {shown:.4g}" if np.isfinite(limit) and np.isfinite(value) else ""
