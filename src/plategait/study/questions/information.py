"""What measurements hold of an object: slopes of what is read over its parameters, and Cramér–Rao bounds."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array
from plategait.model.scenario import Scenario
from plategait.study.measured import Columns, Measured
from plategait.study.runs import Runs

PARAMETERS = ("mass", "stiffness", "damping", "friction", "ratio")
"""M, k_b, c_b, μ_s and β, each by its logarithm. With the mass goes the stiffness in the plane, which nobody knows."""
STEP = 0.12
"""Of the central differences: wide enough that what differs from start to start does not hide the slope."""
NOISE = {"spin_rate": 0.02, "bending_amplitude": 0.05}
"""Relative, of what is read: of films and of what they show of the bending."""
FLOOR = {"spin_rate": math.radians(1), "bending_amplitude": math.radians(0.1)}
"""No rate is read better than to a degree a second, rad/s, and no angle than to a tenth of a degree, rad."""
PRIOR = 2.0
"""Standard deviation of each logarithm before anything is measured: what no measurement tells stays finite."""


def changed(scenario: Scenario, logs: Mapping[str, float]) -> Scenario:
    """Scenario with parameters multiplied by the exponentials of so much."""
    factor = {name: math.exp(logs.get(name, 0.0)) for name in PARAMETERS}
    sheet, friction = scenario.sheet, scenario.friction
    static = factor["friction"] * friction.static
    return scenario.replace(
        sheet=sheet.replace(
            mass=factor["mass"] * sheet.mass,
            axial_stiffness=factor["mass"] * sheet.axial_stiffness,
            axial_damping=factor["mass"] * sheet.axial_damping,
            bending_stiffness=factor["stiffness"] * sheet.bending_stiffness,
            bending_damping=factor["damping"] * sheet.bending_damping,
        ),
        friction=friction.replace(static=static, kinetic=static * min(1.0, factor["ratio"] * friction.ratio)),
    )


def variants(base: Scenario, parameters: Sequence[str] = PARAMETERS) -> list[Scenario]:
    """The object itself, then with each parameter up and down."""
    return [base, *(changed(base, {name: sign * STEP}) for name in parameters for sign in (1, -1))]


def measure_variants(
    runs: Runs,
    base: Scenario,
    motions: Sequence[Mapping[str, float]],
    parameters: Sequence[str] = PARAMETERS,
    *,
    repeats: int = 2,
    half_step: bool = True,
) -> Measured:
    """Runs of `variants` under each motion, in this order."""
    scenarios = [variant.replace(**motion) for variant in variants(base, parameters) for motion in motions]
    return runs.measure(scenarios, repeats=repeats, half_step=half_step)


@dataclass(frozen=True)
class Slopes:
    """Slopes of the logarithm of what is read over those of the parameters.

    Attributes
    ----------
    values : (m, p) array
        0 where an object of the difference ran off.
    noise : (m,) array
        Standard deviation of each reading's logarithm.
    names : tuple of (motion's number, reading)
    """

    values: Array
    noise: Array
    names: tuple[tuple[int, str], ...]

    def of(self, which: Sequence[int]) -> Slopes:
        """Some of the readings."""
        return Slopes(self.values[list(which)], self.noise[list(which)], tuple(self.names[i] for i in which))

    def information(self, weighed: float | None = None) -> Array:
        """(p, p) Fisher information, the prior's included; with the mass known to so much where it is weighed."""
        rows = self.values / self.noise[:, None]
        information = rows.T @ rows + np.eye(self.values.shape[1]) / PRIOR**2
        if weighed is not None:
            information[0, 0] += 1 / weighed**2
        return information

    def bounds(self, weighed: float | None = None) -> Array:
        """(p,) least standard deviation of each logarithm, all others unknown."""
        return np.sqrt(np.diag(np.linalg.inv(self.information(weighed))))


def noise_of(reading: str, seen: Array) -> Array:
    """Standard deviation of the logarithm of what is read: relative noise, and the floor."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.nan_to_num(np.hypot(NOISE[reading], FLOOR[reading] / np.abs(seen)), nan=math.inf)


def slopes_of(
    columns: Columns, motions: int, readings: Sequence[str] = ("spin_rate",), parameters: Sequence[str] = PARAMETERS
) -> Slopes:
    """Slopes from the columns of `measure_variants`."""
    values, noise, names = [], [], []
    for reading in readings:
        seen = columns[reading].reshape(1 + 2 * len(parameters), motions)
        with np.errstate(invalid="ignore", divide="ignore"):
            logs = np.log(np.where(seen > 0, seen, math.nan))
        slope = (logs[1::2] - logs[2::2]).T / (2 * STEP)
        values.append(np.nan_to_num(np.where(np.isfinite(logs[0])[:, None], slope, 0.0)))
        noise.append(noise_of(reading, seen[0]))
        names += [(i, reading) for i in range(motions)]
    return Slopes(np.concatenate(values), np.concatenate(noise), tuple(names))
