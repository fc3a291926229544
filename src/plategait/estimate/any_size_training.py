"""Makes what the any-size method is regressed on: `python -m plategait.estimate.any_size_training`.

Objects and plates are drawn, run, and read as the method reads a measured curve. What nobody knows of an object and of
its plate (c_b, V, the height, how it lies, the noise of the rates) is drawn too, so that the spread holds it. Both what
was read and what was learnt are shipped, so that tests can see that these belong together, and those to the engine.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.curve.spin_curve import curve_of
from plategait.errors import InputError
from plategait.estimate.any_size import INPUTS, SOUGHT, reading
from plategait.estimate.kriging import Kriging, learn
from plategait.model.outline import Disk, Ellipse, Outline, Rectangle
from plategait.model.presets import preset
from plategait.model.scenario import Scenario
from plategait.model.sheet import Sheet
from plategait.model.similarity import bending_over_weight, frequency_at
from plategait.simulation.run import simulate_all

SEED = 5
OBJECTS = 600
ACCELERATIONS = np.geomspace(1.5, 7.5, 15)
"""Γ at which each object is run."""
ELONGATION = 1.2
"""Most length over width."""
NOISE = 0.02
"""Of the rates that are read, relative."""
_ACROSS = 8  # nodes, as the source's disk has
_REFERENCE = 0.04  # m, radius at which times and in-plane joints are the cheese's


def drawn(rng: np.random.Generator) -> Scenario:
    """Object and plate drawn at random."""

    def between(low: float, high: float) -> float:
        return math.exp(rng.uniform(math.log(low), math.log(high)))

    cheese = preset("cheese").scenario
    radius, density, stiffness = between(0.010, 0.200), between(1.0, 6.0), between(0.08, 2.0)
    k_b = stiffness**2 * density * cheese.gravity * radius**3
    ratio = density * cheese.sheet.area / cheese.sheet.mass
    times = math.sqrt(radius / _REFERENCE)
    sheet = Sheet(
        name="drawn", outline=_outline(rng, radius), pitch=2 * radius / _ACROSS, mass=1.0, bending_stiffness=k_b,
        axial_stiffness=cheese.sheet.axial_stiffness * ratio * radius / _REFERENCE,
        axial_damping=cheese.sheet.axial_damping * ratio * times,
    )  # fmt: skip
    sheet = sheet.replace(mass=density * sheet.area)
    sheet = sheet.replace(bending_damping=2 * between(0.06, 0.3) * k_b / sheet.natural_frequency)
    friction = cheese.friction.with_angle(math.radians(rng.uniform(20, 60))).with_ratio(rng.uniform(0.3, 0.9))
    return cheese.replace(**{
        "sheet": sheet, "friction": friction.replace(transition_speed=between(0.045, 0.08)),
        "motion.angle": math.radians(between(1.5, 12.0)), "motion.stroke": min(between(1e-3, 8e-3), 0.3 * radius),
        "motion.height": rng.uniform(2e-3, 8e-3), "motion.ramp": 0.1 * times, "start.angle": rng.uniform(0, math.pi),
        "duration": 1.6 * times, "transient": 0.5 * times, "slip_limit": radius / 2,
        "time_step": min(1e-4 * times, 0.85 * sheet.stable_time_step),
    })  # fmt: skip


def _outline(rng: np.random.Generator, radius: float) -> Outline:
    """Disk, ellipse or rectangle of about that radius."""
    longer = math.sqrt(rng.uniform(1.0, ELONGATION))
    kind = rng.integers(3)
    if kind == 0:
        return Disk(radius=radius)
    if kind == 1:
        return Ellipse(length=2 * radius * longer, width=2 * radius / longer)
    return Rectangle(length=1.75 * radius * longer, width=1.75 * radius / longer)


def simulated(scenarios: Sequence[Scenario], seed: int = SEED) -> list[Curve]:
    """Spin curves of objects, one start each, with the noise of a measurement."""
    each = [s.replace(**{"motion.frequency": frequency_at(s, a)}) for s in scenarios for a in ACCELERATIONS]
    simulations = simulate_all(each, repeats=1, seed=seed)
    curves, n = [], len(ACCELERATIONS)
    for i in range(len(scenarios)):
        part = slice(n * i, n * (i + 1))
        frequencies = [s.motion.frequency for s in each[part]]
        curve = curve_of("drawn", frequencies, [s.observations for s in simulations[part]])
        noise = 1 + NOISE * np.random.default_rng([seed, i]).normal(size=n)
        rates = curve.spin_rate_deg_s * noise
        curves.append(replace(curve, spin_rate_deg_s=rates, spin_rate_sd_deg_s=NOISE * np.abs(rates)))
    return curves


def rows_of(scenarios: Sequence[Scenario], curves: Sequence[Curve]) -> Array:
    """(n, inputs and sought) what was read of each object, and what is sought; fewer where one cannot be read."""
    rows = []
    for scenario, curve in zip(scenarios, curves, strict=True):
        try:
            read = reading(curve, scenario).values
        except InputError:  # ran off before it was seen to spin
            continue
        sought = math.log(bending_over_weight(scenario.sheet, scenario.gravity)), math.degrees(scenario.friction.angle)
        rows.append([*read, *sought])
    return np.array(rows)


def objects(count: int, seed: int = SEED) -> list[Scenario]:
    """The first so many objects of those that the method is made from."""
    rng = np.random.default_rng(seed)
    return [drawn(rng) for _ in range(count)]


def learnt(rows: Array) -> dict[str, Kriging]:
    """Regression of each number that is sought."""
    inputs = rows[:, : len(INPUTS)]
    return {name: learn(inputs, rows[:, len(INPUTS) + i]) for i, name in enumerate(SOUGHT)}


def as_csv(rows: Array) -> str:
    """Rows, six digits each."""
    return "\n".join([",".join((*INPUTS, *SOUGHT)), *(",".join(f"{x:.6g}" for x in row) for row in rows)]) + "\n"


def as_toml(regressions: dict[str, Kriging]) -> str:
    """What was learnt, and how far each value is from what all others say of it."""
    lines = ["# Written by python -m plategait.estimate.any_size_training.", "[domain]", f"elongation = {ELONGATION}"]
    for name, regression in regressions.items():
        lengths = ", ".join(f"{x:.4g}" for x in regression.lengths)
        sd = float(np.sqrt(np.mean(regression.left_out() ** 2)))
        lines += ["", f"[{name}]", f"lengths = [{lengths}]", f"signal = {regression.signal:.4g}",
                  f"noise = {regression.noise:.4g}", f"left_out_sd = {sd:.3g}"]  # fmt: skip
    return "\n".join(lines) + "\n"


def main() -> None:
    """Run the objects, learn, and write both beside this module."""
    scenarios = objects(OBJECTS)
    rows = rows_of(scenarios, simulated(scenarios))
    folder = Path(__file__).parent / "data"
    (folder / "any_size.csv").write_text(as_csv(rows), encoding="utf-8")
    text = as_toml(learnt(rows))
    (folder / "any_size.toml").write_text(text, encoding="utf-8")
    print(f"wrote any_size.csv and any_size.toml: {len(rows)} of {OBJECTS} objects can be read\n{text}")


if __name__ == "__main__":
    main()
