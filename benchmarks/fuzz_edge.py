"""Sheets at the edge of a plate, on it, over it and beyond, and on turntables: what they are, and what they may do."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from benchmarks.fuzz_inputs import Draw, sheet_fields
from plategait.model.motion import AXES
from plategait.model.presets import PRESETS, preset
from plategait.model.scenario import Scenario
from plategait.simulation.result import Simulation

# A sheet may move this many times faster than any point of the plate ever does, and fall.
BOUNCE = 3.0
# Furthest that a rough sheet turns against a slow turntable, rad: the static law lets it creep.
CREEP = math.radians(3)
TURNTABLE = "turntable"


def edge_fields(draw: Draw) -> dict[str, Any]:
    """A sheet near the edge of a plate that may be smaller than it, and that may shake hard."""
    if draw.chance(0.15):
        return turntable_fields(draw)
    length, width = draw.near(0.08, 4), draw.near(0.08, 4)
    beyond, static = draw.choice([0.0, 0.05]), draw.choice([0.0, 0.75, draw.uniform(0, 1.5)])
    known = preset(draw.choice(PRESETS)).scenario
    return {
        "name": "edge",
        "sheet": known.sheet if draw.chance(0.5) else sheet_fields(draw),
        "contact": known.contact,
        "friction": {"static": static, "kinetic": static * draw.uniform(0, 1)},
        "plate": {"length": length, "width": width},
        "motion": {
            "frequency": draw.near(16.0), "angle": draw.choice([0.0, draw.uniform(0, 0.26)]),
            "stroke": draw.choice([0.0, draw.uniform(0, 0.006)]), "height": draw.uniform(-0.03, 0.03),
            "ramp": draw.choice([0.0, 0.1]), "waves": _shaking(draw),
        },
        "start": {
            "x": draw.uniform(-1, 1) * (length / 2 + beyond), "y": draw.uniform(-1, 1) * (width / 2 + beyond),
            "angle": draw.uniform(-3, 3),
        },
        "duration": draw.uniform(0.2, 0.8), "slip_limit": draw.choice([0.01, 1.0]),
    }  # fmt: skip


def _shaking(draw: Draw) -> list[dict[str, Any]]:
    hard, waves = draw.choice([0.0, 0.3, 1.0, 3.0]), []
    for _ in range(draw.whole(0, 3)):
        axis = draw.choice(AXES)
        size = hard * draw.uniform(-1, 1) * (0.15 if axis.startswith("r") else 0.006)
        waves.append({"axis": axis, "amplitude": size, "ratio": draw.choice([0.5, 1, 2]), "phase": draw.uniform(-3, 3)})
    return waves


def turntable_fields(draw: Draw) -> dict[str, Any]:
    """A rough sheet amid a table that begins any number of turns away, and turns on."""
    duration, turns = draw.uniform(0.5, 2.0), draw.choice([0, 1, 3, 1000, -50_000]) * 2 * math.pi
    time = np.linspace(0, duration, 200)
    share = time / duration
    # Eight tenths of what friction can hold at the rim of the presets' sheets, at the most.
    speed_up = 100.0 * draw.uniform(-1, 1) * duration**2 / 5.77
    angle = turns + speed_up * share**3 * (10 - 15 * share + 6 * share**2)
    return {
        "name": TURNTABLE, "sheet": preset(draw.choice(["cheese", "cheese-as-printed"])).scenario.sheet,
        "friction": {"static": 0.75, "kinetic": 0.4}, "duration": duration,
        "motion": {
            "frequency": 10.0, "angle": 0.0, "stroke": 0.0, "ramp": 0.0,
            "samples": {"time": time.tolist(), "rz": angle.tolist()},
        },
    }  # fmt: skip


def absurdities(simulation: Simulation) -> Iterator[str]:
    """What a run called sound shows that cannot be."""
    scenario = simulation.scenario
    for recording, observation in zip(simulation.recordings, simulation.observations, strict=True):
        if not observation.energy.closes:
            continue
        bound = _most_energy(scenario, recording["centre_z"].min(), recording["centre_z"][0])
        for name in ("kinetic", "contact", "axial", "bending", "torsion"):
            most = recording[f"{name}_energy"].max()
            if not most <= 1.05 * min(bound, observation.energy.given):
                yield f"{name} energy {most:.3g} J of {observation.energy.given:.3g} J given, {bound:.3g} J possible"
        if observation.failure is None and scenario.plate is not None:
            ends = abs(recording["centre_x"][-1]), abs(recording["centre_y"][-1])
            if ends[0] > scenario.plate.length / 2 or ends[1] > scenario.plate.width / 2:
                yield "no failure, and its centre ends beyond the plate"
        if scenario.name == TURNTABLE:
            turned = np.unwrap(np.arctan2(recording["spin_cross"], recording["spin_dot"]))
            if observation.failure is not None or not np.ptp(turned) <= CREEP:
                yield f"turns {math.degrees(np.ptp(turned)):.1f} deg against the turntable; {observation.failure}"


def _most_energy(scenario: Scenario, lowest: float, first: float) -> float:
    """Energy that the sheet may have, J, by the plate's largest speed and its fall, and what it is laid down with."""
    motion, plate = scenario.motion, scenario.plate
    speed = np.zeros(len(AXES))
    for axis, amplitude, frequency, _ in motion.terms():
        speed[axis] += abs(amplitude) * (2 * math.pi * frequency + (2 / motion.ramp if motion.ramp > 0 else 0.0))
    if motion.samples is not None:
        for d, axis in enumerate(AXES):
            if values := getattr(motion.samples, axis):
                speed[d] += np.abs(np.diff(values) / np.diff(motion.samples.time)).max()
    reach = math.hypot(*scenario.sheet.outline.size()) + abs(motion.height)
    reach += math.hypot(plate.length, plate.width) / 2 if plate else 0.0
    fastest = float(np.linalg.norm(speed[:3]) + reach * np.linalg.norm(speed[3:]))
    mass, fall = scenario.sheet.mass, max(0.0, float(first - lowest)) + 0.02
    return mass * ((BOUNCE * fastest) ** 2 / 2 + scenario.gravity * fall)
