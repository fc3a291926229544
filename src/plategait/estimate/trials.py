"""Trials: the engine run at chosen parameters under the plate motions that were measured."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.estimate.emulator import brackets
from plategait.estimate.observations import Condition
from plategait.estimate.unknowns import Unknowns
from plategait.simulation.run import simulate_all


@dataclass(frozen=True, eq=False)
class Trials:
    """What the engine gave.

    Attributes
    ----------
    u : (n, d) array
        Parameters, as shares of their priors.
    conditions : tuple of Condition
    rates : (n, c) array
        Spin rates, deg/s; NaN where a run failed or lies beyond its first failure.
    failed : (n, c) bool array
    """

    u: Array
    conditions: tuple[Condition, ...]
    rates: Array
    failed: NDArray[np.bool_]

    def joined(self, more: Trials) -> Trials:
        """Both, one after the other."""
        return Trials(np.concatenate([self.u, more.u]), self.conditions, np.concatenate([self.rates, more.rates]),
                      np.concatenate([self.failed, more.failed]))  # fmt: skip

    def brackets(self, amplitude: tuple[float, float]) -> tuple[Array, Array]:
        """Frequencies (n,) between which each run of one amplitude begins to fail; 0 or infinity where none."""
        columns = [i for i, c in enumerate(self.conditions) if c.amplitude == amplitude]
        return brackets(self.failed[:, columns], [self.conditions[i].frequency for i in columns])


def run_trials(
    unknowns: Unknowns,
    u: Array,
    conditions: Sequence[Condition],
    *,
    seed: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Trials:
    """Run the engine at every parameter set (n, d) under every condition."""
    values = unknowns.values(u)
    scenarios = []
    for row in values:
        made = unknowns.scenario(row)
        scenarios += [made.replace(motion=c.motion(made.motion)) for c in conditions]
    runs = simulate_all(scenarios, seed=seed, progress=progress)
    shape = (len(u), len(conditions))
    rates = np.degrees([r.spin_rate for r in runs]).reshape(shape)
    failed = np.array([r.failed for r in runs]).reshape(shape)
    trials = Trials(u, tuple(conditions), np.where(failed, math.nan, rates), failed)
    for amplitude in dict.fromkeys(c.amplitude for c in conditions):
        columns = [i for i, c in enumerate(conditions) if c.amplitude == amplitude]
        _, first = trials.brackets(amplitude)
        beyond = np.array([conditions[i].frequency for i in columns]) > first[:, None]
        rates = trials.rates[:, columns]
        trials.rates[:, columns] = np.where(beyond, math.nan, rates)
    return trials
