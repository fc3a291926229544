"""Runs of the engine at parameter sets, under the plate motions that were measured."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.engine.engines import engine
from plategait.engine.recording import RunRequest
from plategait.estimate.emulator import brackets
from plategait.estimate.handling import Handling
from plategait.estimate.observations import Condition
from plategait.estimate.unknowns import Unknowns
from plategait.model.scenario import Scenario
from plategait.simulation.observation import glance


@dataclass(frozen=True, eq=False)
class EngineRuns:
    """What the engine gave.

    Attributes
    ----------
    u : (n, d) array
        Parameters, as shares of their priors.
    conditions : tuple of Condition
    rates : (n, c) array
        Spin rates, deg/s; NaN where a run failed or lies beyond its first failure.
    failed : (n, c) bool array
    values : mapping of str to (n, c) array
        Observables by name, SI; NaN where the rates are.
    """

    u: Array
    conditions: tuple[Condition, ...]
    rates: Array
    failed: NDArray[np.bool_]
    values: Mapping[str, Array] = field(default_factory=dict)

    def columns(self) -> Array:
        """(n, c + …) rates of every condition, and after them each observable's values at every condition."""
        return np.concatenate([self.rates, *self.values.values()], axis=1)

    def of(self, sets: NDArray[np.int64]) -> EngineRuns:
        """Some of the parameter sets, by number."""
        values = {name: of_all[sets] for name, of_all in self.values.items()}
        return EngineRuns(self.u[sets], self.conditions, self.rates[sets], self.failed[sets], values)

    def joined(self, more: EngineRuns) -> EngineRuns:
        """Both, one after the other."""
        return EngineRuns(np.concatenate([self.u, more.u]), self.conditions, np.concatenate([self.rates, more.rates]),
                      np.concatenate([self.failed, more.failed]),
                      {name: np.concatenate([x, more.values[name]]) for name, x in self.values.items()})  # fmt: skip

    def brackets(self, amplitude: Condition) -> tuple[Array, Array]:
        """Frequencies (n,) between which each run of one amplitude begins to fail; 0 or infinity where none."""
        columns = [i for i, c in enumerate(self.conditions) if c.amplitude == amplitude]
        return brackets(self.failed[:, columns], [self.conditions[i].frequency for i in columns])


def run_engine(
    unknowns: Unknowns,
    u: Array,
    conditions: Sequence[Condition],
    *,
    handling: Handling | None = None,
    observables: Sequence[str] = (),
    changed: Callable[[Scenario], Scenario] | None = None,
    seed: int = 0,
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> EngineRuns:
    """Run the engine at every parameter set (n, d) under every condition.

    Parameters
    ----------
    unknowns : Unknowns
    u : (n, d) array
        Parameters, as shares of their priors.
    conditions : sequence of Condition
    handling : Handling, optional
        What differs from run to run besides; if left out, all is as the scenario says.
    observables : sequence of str
        What else is kept of each run.
    changed : callable, optional
        What else is changed of each set's scenario: another model of the same object.
    seed : int
        Of the differences in handling.
    threads : int, optional
        Cores for the engine; all by default.
    progress : callable, optional
        Called with the fraction done.
    """
    objects = map(unknowns.scenario, unknowns.values(u))
    if changed is not None:
        objects = map(changed, objects)
    scenarios = [c.applied(s) for s in objects for c in conditions]
    if handling is not None:
        drawn = handling.drawn(len(u), len(conditions), np.random.default_rng(seed))
        scenarios = [s.replace(**changes) for s, changes in zip(scenarios, drawn, strict=True)]
    recordings = engine("cpu").run([RunRequest(s) for s in scenarios], threads=threads, progress=progress)
    glances = [glance(s, r, observables) for s, r in zip(scenarios, recordings, strict=True)]
    shape = (len(u), len(conditions))
    rates = np.degrees([g.spin.rate for g in glances]).reshape(shape)
    failed = np.array([g.failure is not None for g in glances]).reshape(shape)
    out = failed | _beyond(failed, conditions)
    values = {
        name: np.where(out, math.nan, np.reshape([g.values[name] for g in glances], shape)) for name in observables
    }
    return EngineRuns(u, tuple(conditions), np.where(out, math.nan, rates), failed, values)


def _beyond(failed: NDArray[np.bool_], conditions: Sequence[Condition]) -> NDArray[np.bool_]:
    """Points (n, c) beyond the first failure of their amplitude."""
    frequency = np.array([c.frequency for c in conditions])
    beyond = np.zeros_like(failed)
    for amplitude in dict.fromkeys(c.amplitude for c in conditions):
        columns = [i for i, c in enumerate(conditions) if c.amplitude == amplitude]
        _, first = brackets(failed[:, columns], frequency[columns])
        beyond[:, columns] = frequency[columns] > first[:, None]
    return beyond
