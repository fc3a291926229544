"""Random scenarios and commands for `benchmarks.fuzz`: most of them sensible, some extreme, some nonsense."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from plategait.model.motion import AXES
from plategait.model.presets import PRESETS

SHAPES = ("disk", "ellipse", "rectangle", "polygon", "mask")
# Shares of fields that are extreme or nonsense: in most scenarios none, in some a few, in some many.
WILDNESS = (0.0, 0.0, 0.0, 0.02, 0.05, 0.3)
EXTREMES = (0.0, -0.0, 5e-324, 1e-300, 1e-30, 1e-12, 1e-6, 1e6, 1e12, 1e30, 1e300, -1e-9, -1.0, -1e30)
NONSENSE = (
    math.nan, math.inf, -math.inf, None, True, "", " ", "abc", "1 parsec", "12 deg mm", "1e400 mm", "nan m", "mm",
    "3 mm mm", "1/0 m", "1,5 mm", "-0 s", "١٢ mm", "1 " + "m" * 5000, "1" * 400, 10**400, [], {}, [1.0], b"1 mm",
    "\x1b[31m1 mm", "1 mm\n2 mm", "1\x00mm", "é", 1j,
)  # fmt: skip


class Draw:
    """A generator with a share of wild answers."""

    def __init__(self, generator: np.random.Generator) -> None:
        self.generator = generator
        self.wildness = float(generator.choice(WILDNESS))

    def chance(self, share: float) -> bool:
        return bool(self.generator.random() < share)

    def choice(self, options: Sequence[Any]) -> Any:
        return options[int(self.generator.integers(len(options)))]

    def whole(self, low: int, high: int) -> int:
        return int(self.generator.integers(low, high + 1))

    def uniform(self, low: float, high: float) -> float:
        return float(self.generator.uniform(low, high))

    def near(self, typical: float, factor: float = 3.0) -> float:
        """Within a factor of what is typical, evenly in its logarithm."""
        return typical * factor ** self.uniform(-1, 1)

    def number(self, sensible: float, unit: str = "", scale: float = 1.0) -> Any:
        """A bare SI number, or text in a unit that is `scale` SI units; now and then something else."""
        if self.chance(self.wildness):
            return self.choice(NONSENSE) if self.chance(0.4) else self.choice(EXTREMES)
        return f"{sensible / scale!r} {unit}".strip() if unit and self.chance(0.4) else sensible

    def word(self, *options: str) -> Any:
        return self.choice(NONSENSE) if self.chance(self.wildness / 2) else self.choice(options)

    def length(self, typical: float, factor: float = 3.0) -> Any:
        return self.number(self.near(typical, factor), "mm", 1e-3)

    def offset(self, reach: float) -> Any:
        return self.number(self.uniform(-reach, reach), "mm", 1e-3)


def scenario_fields(draw: Draw) -> dict[str, Any]:
    """Fields of a whole scenario, as a TOML file would hold them."""
    plate = {"length": draw.length(0.1, 4), "width": draw.length(0.1, 4)} if draw.chance(0.4) else None
    reach = draw.choice([0.0, 0.01, 0.06, 0.3])
    fields: dict[str, Any] = {
        "name": draw.word("fuzz", "a \"b\" c", "x" * 300, "\x1b[2J", "é漢"),
        "sheet": sheet_fields(draw),
        "motion": motion_fields(draw),
        "contact": {
            "stiffness": draw.number(draw.near(11860.0, 100), "N/mm", 1e3), "damping": draw.number(draw.near(7.65, 30)),
            "damping_ramp": draw.choice([0.0, draw.length(1e-4)]), "tile_area": draw.number(1e-4, "mm^2", 1e-6),
        },
        "friction": friction_fields(draw),
        "start": {"x": draw.offset(reach), "y": draw.offset(reach), "angle": draw.number(draw.uniform(-4, 4))},
        "gravity": draw.number(draw.choice([9.81, 0.0, draw.near(9.81)])),
        "duration": draw.number(draw.uniform(0.002, 0.05), "s"),
    }  # fmt: skip
    fields |= {"plate": plate} if plate else {}
    fields |= {"transient": draw.number(draw.uniform(0, 0.02))} if draw.chance(0.3) else {}
    fields |= {"time_step": draw.number(draw.near(3e-5), "s")} if draw.chance(0.3) else {}
    fields |= {"slip_limit": draw.length(0.01)} if draw.chance(0.2) else {}
    fields |= {str(draw.word("friktion", "sheet.mass", "x")): 1} if draw.chance(draw.wildness / 4) else {}
    return fields


def sheet_fields(draw: Draw) -> dict[str, Any]:
    fields = {
        "outline": outline_fields(draw), "mass": draw.number(draw.near(0.0136), "g", 1e-3),
        "pitch": draw.length(0.01, 1.6), "bending_stiffness": draw.number(draw.near(1.56e-4, 100)),
        "bending_damping": draw.number(draw.choice([0.0, draw.near(2.4e-7, 10)])),
        "axial_stiffness": draw.number(draw.near(790.0, 10), "N/mm", 1e3),
        "axial_damping": draw.number(draw.choice([0.0, draw.near(0.49, 5)])),
    }  # fmt: skip
    if draw.chance(0.3):
        fields["torsion_stiffness"] = draw.number(draw.near(1.56e-4, 10))
        fields["torsion_damping"] = draw.number(draw.choice([0.0, 2.4e-7]))
    if draw.chance(0.3):
        fields["shear_ratio"] = draw.near(1.0, 10)
    for name in list(fields):
        if draw.chance(draw.wildness / 10):
            del fields[name]
    return fields


def outline_fields(draw: Draw) -> Any:
    shape = draw.choice(SHAPES)
    fields: dict[str, Any] = {"shape": draw.word(shape)}
    if shape == "disk":
        fields["radius"] = draw.length(0.03)
    elif shape == "polygon":
        turns = np.sort(draw.generator.random(draw.whole(2, 9)))
        if draw.chance(0.2):  # edges that cross
            draw.generator.shuffle(turns)
        radii = [draw.near(0.03) for _ in turns]
        fields["corners"] = [
            [draw.number(r * math.cos(2 * math.pi * t)), draw.number(r * math.sin(2 * math.pi * t))]
            for r, t in zip(radii, turns, strict=True)
        ]
    elif shape == "mask":
        columns, filled = draw.whole(1, 7), draw.uniform(0.5, 1.1)
        fields["rows"] = [
            "".join("#" if draw.chance(filled) else "." for _ in range(columns)) for _ in range(draw.whole(1, 7))
        ]
        fields["width_of_picture"] = draw.length(0.05, 2)
    else:
        fields |= {"length": draw.length(0.05), "width": draw.length(0.05)}
    return draw.choice(NONSENSE) if draw.chance(draw.wildness / 10) else fields


def motion_fields(draw: Draw) -> dict[str, Any]:
    fields: dict[str, Any] = {
        "frequency": draw.number(draw.near(24.0, 4), "Hz"),
        "angle": draw.number(draw.choice([0.0, draw.uniform(-0.3, 0.3)]), "deg", math.pi / 180),
        "stroke": draw.offset(draw.choice([0.0, 0.006])), "height": draw.offset(0.05),
        "ramp": draw.number(draw.choice([0.0, draw.uniform(0, 0.1)]), "s"),
    }  # fmt: skip
    if draw.chance(0.4):
        fields["waves"] = [wave_fields(draw) for _ in range(draw.whole(0, 5))]
    if draw.chance(0.25):
        fields["samples"] = sample_fields(draw)
    if draw.chance(0.2):
        axis = draw.choice(AXES)
        size = draw.uniform(-0.5, 0.5) if axis.startswith("r") else draw.uniform(-0.05, 0.05)
        fields["offset"] = {axis: draw.number(size)}
    return fields


def wave_fields(draw: Draw) -> dict[str, Any]:
    axis = draw.choice(AXES)
    size = draw.uniform(-0.3, 0.3) if axis.startswith("r") else draw.uniform(-0.006, 0.006)
    amplitude = draw.number(size, *(("deg", math.pi / 180) if axis.startswith("r") else ("mm", 1e-3)))
    return {
        "axis": draw.word(axis), "amplitude": amplitude, "ratio": draw.number(draw.choice([1, 2, 0.5, draw.near(1.0)])),
        "phase": draw.number(draw.uniform(-7, 7)),
    }  # fmt: skip


def sample_fields(draw: Draw) -> dict[str, Any]:
    """A trajectory; some end long after the run, some have samples very near each other."""
    steps = [draw.near(draw.choice([1e-3, 0.01]), 5) for _ in range(draw.whole(1, 30))]
    if draw.chance(0.2):
        steps[draw.whole(0, len(steps) - 1)] = draw.choice([1e-9, 1e-300, 300.0, 36_000.0, 1e30])
    time = np.cumsum([0.0, *steps]).tolist()
    fields = {}
    for axis in AXES:
        if draw.chance(0.3):
            reach = 0.3 if axis.startswith("r") else 0.004
            fields[axis] = [draw.uniform(-reach, reach) for _ in time]
            if draw.chance(draw.wildness):
                fields[axis][0] = draw.choice([math.nan, 1e30, 1e308])
    return {"time": time, **fields}


def friction_fields(draw: Draw) -> dict[str, Any]:
    static = draw.choice([0.0, draw.uniform(0, 1.5)])
    return {
        "static": draw.number(static), "kinetic": draw.number(static * draw.uniform(0, 1)),
        "transition_speed": draw.number(draw.near(0.1, 10), "mm/s", 1e-3), "law": draw.word("thesis", "adams"),
        "kinetic_speed_ratio": draw.number(draw.uniform(1.1, 20)),
    }  # fmt: skip


# Commands ------------------------------------------------------------------------------------------------------------

GARBAGE = (
    "",
    "-",
    "--",
    "nothing.toml",
    "/",
    "..",
    "nan",
    "-1",
    "0",
    "1e400",
    "a\x1b[31mb",
    "é" * 200,
    "x" * 5000,
    "None",
)
OPTIONS: dict[str, tuple[str, ...]] = {
    "--frequency": ("24 Hz", "7", "0 Hz", "1e9 Hz", "24 hz", "12:14:1Hz"),
    "--angle": ("3 deg", "12 deg", "3", "-3 deg", "400 deg"),
    "--stroke": ("3 mm", "0", "2 m", "3"),
    "--mu-s": ("0.75", "0", "-1", "1e30"),
    "--mu-k": ("0.4", "2"),
    "--friction-law": ("thesis", "adams", "coulomb"),
    "--dt": ("1e-4 s", "5e-5", "1 s", "1e-30 s", "0"),
    "--natural-frequency": ("10 pi rad/s", "5 Hz", "0 Hz", "50 Hz"),
    "--sheet": ("pancake", "cheese", "nothing.toml"),
    "--repeats": ("1", "2", "0", "1000000", "two"),
    "--seed": ("1", "-1", "99999999999999999999"),
    "--engine": ("cpu", "cpu64", "gpu"),
    "--out": ("run.nc", "curve.csv", "run.txt", "missing/run.nc"),
    "--count": ("3", "0", "1000"),
    "--machine": ("source-robot", "fuzz.toml", "nothing.toml"),
    "--draws": ("0", "3"),
}  # fmt: skip
TAKEN = {
    "simulate": ("--frequency", "--angle", "--stroke", "--mu-s", "--mu-k", "--friction-law", "--dt",
                 "--natural-frequency", "--sheet", "--repeats", "--seed", "--engine", "--out", "--draws"),
    "curve": ("--angle", "--stroke", "--mu-s", "--friction-law", "--dt", "--sheet", "--repeats", "--engine", "--out"),
    "modes": ("--sheet", "--natural-frequency", "--count"),
    "needs": ("--frequency", "--angle", "--stroke", "--machine"),
    "scenario": (),
    "fit": (),
}  # fmt: skip
OTHERS = ("identify", "estimate", "track", "target", "shoot", "sweep", "plot", "thesis", "nonsense", "--version")


def command(draw: Draw, folder: Path, scenario_text: str) -> list[str]:
    """Arguments of a command; files that it names are written to the folder."""
    (folder / "fuzz.toml").write_text(_spoilt(draw, scenario_text), encoding="utf-8", errors="replace")
    (folder / "curve.csv").write_text(_spoilt(draw, _curve_text(draw)), encoding="utf-8", errors="replace")
    if draw.chance(0.1):
        return [draw.choice(OTHERS), *(draw.choice(GARBAGE) for _ in range(draw.whole(1, 3)))]
    name = draw.choice(list(TAKEN))
    target = "curve.csv" if name == "fit" else draw.choice(["fuzz.toml", "fuzz.toml", *PRESETS])
    arguments = [name, draw.choice(GARBAGE) if draw.chance(0.05) else target]
    for option in TAKEN[name]:
        if draw.chance(0.2):
            arguments += [option, draw.choice(GARBAGE) if draw.chance(0.1) else draw.choice(OPTIONS[option])]
    if name in ("simulate", "curve"):
        arguments += ["--duration", draw.choice(["0.05 s", "0.02", "20 ms", "0 s", "-1", "1e30 s", "1e-30 s"])]
    if name == "curve":
        ranges = ["12:14:1Hz", "24 Hz", "10:20:5", "20:10:1Hz", "1:1e9:1e-9Hz", "0:5:1Hz", "::", "a:b:c", "nan:1:1"]
        arguments += ["--frequency", draw.choice(ranges)]
    return [*arguments, *(["--json"] if draw.chance(0.5) else [])]


def _curve_text(draw: Draw) -> str:
    rows = [
        f"{10 + i},{draw.near(100)!r},{draw.choice(['walking', '', 'dancing'])},{draw.choice(['', '', 'slipped'])}"
        for i in range(draw.whole(0, 12))
    ]
    return "\n".join(["frequency_hz,spin_rate_deg_s,gait,failure", *rows]) + "\n"


def _spoilt(draw: Draw, text: str) -> str:
    """Text, in some cases cut, with a piece doubled or a character changed."""
    if not text or draw.chance(0.6):
        return text
    at = draw.whole(0, len(text) - 1)
    strange = draw.choice(['"', "\x00", "[", "=", "9" * 6000])
    return draw.choice([text[:at], text[:at] + text[max(0, at - 40) :], text[:at] + strange + text[at + 1 :]])
