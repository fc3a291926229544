"""Sheets and motions of every kind, drawn at random, for whoever compares the lab's engine with the package's."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import plategait as pg
from plategait.lab.scenario_json import plain_scenario
from plategait.model.motion import AXES

LETTER = ("######", "#.....", "#.....", "######", "#.....", "#....#", "######")
SHAPES = ("disk", "ellipse", "rectangle", "polygon", "mask")


def plain(scenario: pg.Scenario) -> dict[str, Any]:
    """Scenario as the page has it."""
    return plain_scenario(scenario)[0]


def random_groups(count: int, each: int, seed: int, duration: float = 0.5) -> list[list[pg.Scenario]]:
    """Groups of scenarios that share a lattice and else differ in everything; the same for a seed.

    Each shape comes as often as any other.
    """
    generator = np.random.default_rng(seed)
    groups = []
    for i in range(count):
        cut = {
            "outline": outline(generator, SHAPES[i % len(SHAPES)]),
            "pitch": float(generator.uniform(0.0055, 0.0115)),
        }
        groups.append([scenario(generator, cut, duration) for _ in range(each)])
    return groups


def scenario(generator: np.random.Generator, cut: dict[str, Any], duration: float) -> pg.Scenario:
    """One scenario of an outline and pitch, as strange as the model allows."""

    def uniform(low: float, high: float) -> float:
        return float(generator.uniform(low, high))

    def near(typical: float, factor: float = 3.0) -> float:
        return typical * factor ** uniform(-1, 1)

    def chance(share: float) -> bool:
        return uniform(0, 1) < share

    static = uniform(0.1, 1.2)
    plate = {"length": uniform(0.05, 0.12), "width": uniform(0.05, 0.12)} if chance(0.35) else None
    reach = 0.4 * min(plate.values()) if plate else 0.01
    fields: dict[str, Any] = {
        "sheet": {
            **cut, "mass": near(0.008),
            "bending_stiffness": near(1.6e-4) * (not chance(0.05)), "bending_damping": near(1.4e-6) * chance(0.8),
            "axial_stiffness": near(790.0), "axial_damping": near(0.4) * chance(0.8), "shear_ratio": near(1.0, 2.0),
            "torsion_stiffness": near(1e-4) * chance(0.5), "torsion_damping": near(1e-6) * chance(0.4),
        },
        "motion": motion(generator),
        "contact": {
            "stiffness": near(11860.0), "damping": near(7.65) * chance(0.9), "damping_ramp": 1e-4 * chance(0.3),
            "tile_area": near(1e-4, 1.5),
        },
        "friction": {
            "static": static, "kinetic": static * uniform(0.2, 1.0), "transition_speed": near(0.08),
            "kinetic_speed_ratio": uniform(1.5, 12.0), "law": "adams" if chance(0.4) else "thesis",
        },
        "start": {"x": uniform(-reach, reach), "y": uniform(-reach, reach), "angle": uniform(-4, 4)},
        "plate": plate, "gravity": near(9.81, 1.5) * (not chance(0.03)), "duration": duration, "slip_limit": 0.02,
        "transient": 0.3 * duration if chance(0.5) else None,
    }  # fmt: skip
    if chance(0.15):
        fields["time_step"] = 0.5 * pg.Scenario(**fields).dt
    return pg.Scenario(**fields)


def outline(generator: np.random.Generator, shape: str) -> dict[str, Any]:
    """Outline of some centimetres; a polygon or a picture hangs together at any pitch asked for here."""
    size = float(generator.uniform(0.03, 0.08))
    other = size * float(generator.uniform(0.5, 1.5))
    if shape == "disk":
        return {"shape": shape, "radius": size / 2}
    if shape in ("ellipse", "rectangle"):
        return {"shape": shape, "length": size, "width": other}
    if shape == "polygon":
        count = int(generator.integers(3, 8))
        angles = np.arange(count) * 2 * math.pi / count + float(generator.uniform(0, 7))
        radii = 0.05 * generator.uniform(0.75, 1.0, count)
        corners = np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=1)
        return {"shape": shape, "corners": corners.tolist()}
    return {"shape": shape, "width_of_picture": 0.075, "rows": LETTER}


def motion(generator: np.random.Generator) -> dict[str, Any]:
    """Motion with some of what it may have: sines out of phase, an offset, samples, no ramp."""

    def uniform(low: float, high: float) -> float:
        return float(generator.uniform(low, high))

    fields: dict[str, Any] = {
        "frequency": uniform(6, 40), "angle": uniform(-0.06, 0.06), "stroke": uniform(-0.003, 0.003),
        "height": uniform(-0.005, 0.01), "ramp": 0.0 if uniform(0, 1) < 0.2 else uniform(0.02, 0.2),
    }  # fmt: skip
    if uniform(0, 1) < 0.3:
        fields["offset"] = {
            "rx": uniform(-0.05, 0.05), "ry": uniform(-0.05, 0.05), "rz": uniform(-1, 1), "z": uniform(-0.01, 0.01),
        }  # fmt: skip
    if uniform(0, 1) < 0.4:
        fields["waves"] = [
            {"axis": axis, "amplitude": uniform(0, 0.02) if axis.startswith("r") else uniform(0, 8e-4),
             "ratio": float(generator.choice([1.0, 0.5, 2.0, 1.5, 2 / 3, 1.37])), "phase": uniform(-4, 4)}
            for axis in generator.choice(AXES, int(generator.integers(1, 4)))
        ]  # fmt: skip
    if uniform(0, 1) < 0.25:
        time = np.concatenate([[0.0], np.cumsum(generator.uniform(0.004, 0.03, int(generator.integers(1, 40))))])
        axes = generator.choice(AXES, int(generator.integers(1, 4)), replace=False)
        fields["samples"] = {"time": time.tolist()} | {
            str(axis): (generator.uniform(-1, 1, len(time)) * (0.02 if axis.startswith("r") else 5e-4)).tolist()
            for axis in axes
        }
    return fields


def random_cuts(count: int, seed: int) -> list[dict[str, Any]]:
    """Outlines with a pitch, plain: half of them in round numbers, so that middles of squares lie on their edges."""
    generator = np.random.default_rng(seed)
    return [_cut(generator, str(generator.choice(SHAPES)), bool(i % 2)) for i in range(count)]


def _cut(generator: np.random.Generator, shape: str, is_round: bool) -> dict[str, Any]:
    def length(low: float, high: float) -> float:
        size = float(generator.uniform(low, high))
        return round(1e3 * size) / 1e3 if is_round else size

    pitch = float(generator.choice([0.002, 0.0025, 0.004, 0.01])) if is_round else length(0.0015, 0.02)
    fields: dict[str, Any] = {}
    if shape == "disk":
        fields["radius"] = length(0.002, 0.06)
    elif shape in ("ellipse", "rectangle"):
        fields |= {"length": length(0.002, 0.1), "width": length(0.002, 0.1)}
    elif shape == "polygon":
        count, along = int(generator.integers(3, 9)), generator.uniform(0, 1) < 0.1
        fields["corners"] = [
            [0.01 * k, 0.02 * k + 0.003] if along else [length(-0.06, 0.06), length(-0.06, 0.06)] for k in range(count)
        ]
    else:
        dark = generator.uniform(0, 1, generator.integers(1, 12, 2)) < 0.85
        fields["rows"] = ["".join(".#"[int(pixel)] for pixel in row) for row in dark]
        fields["width_of_picture"] = length(0.01, 0.1)
    return {"outline": {"shape": shape, **fields}, "pitch": pitch}
