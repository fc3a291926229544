"""Sampled trajectories as tables of knots for the core: each one once, and no further than it is run."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from plategait.engine.recording import RunRequest
from plategait.model.motion import Samples
from plategait.model.scenario import Scenario


def table_step(scenario: Scenario) -> float:
    """Time between knots, s: a number that single precision holds, so that the core puts them where they are."""
    samples = scenario.motion.samples
    finest = 1.0 if samples is None else max(min(samples.finest_step / 2, scenario.duration), 2 * scenario.dt)
    return float(np.float32(finest))


def table_bytes(runs: Iterable[RunRequest]) -> float:
    """Memory that `tables` takes at most: knots of 12 numbers, and the copies that the spline makes of them."""
    taken = {
        id(s): 12 * 8 * 3 * min(s.time[-1], r.scenario.duration) / table_step(r.scenario)
        for r in runs
        if (s := r.scenario.motion.samples)
    }
    return sum(taken.values())


def tables(runs: Sequence[RunRequest]) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.int64]]:
    """Knots of the sampled trajectories of runs, to the end of the longest run on each.

    Returns
    -------
    knots : (n, 12) array
        Of all trajectories, one after the other; empty where no run has any.
    first, count : (n_runs,) arrays
        Where the knots of each run begin, and how many they are. A run without samples gets a plate that stays.
    """
    # Found by identity first, as hashing a long trajectory takes milliseconds.
    equal: dict[Samples, Samples] = {}
    shared: dict[int, Samples] = {}
    keys: list[tuple[int, float] | None] = []
    ends: dict[tuple[int, float] | None, float] = {}
    for r in runs:
        samples, key = r.scenario.motion.samples, None
        if samples is not None:
            if id(samples) not in shared:
                shared[id(samples)] = equal.setdefault(samples, samples)
            key = (id(shared[id(samples)]), table_step(r.scenario))
        keys.append(key)
        ends[key] = max(ends.get(key, 0.0), r.steps * r.scenario.dt)
    if not shared:
        return np.zeros((0, 12)), np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64)
    made = {key: shared[key[0]].knots(key[1], end) if key else np.zeros((2, 12)) for key, end in ends.items()}
    count = {key: len(knots) for key, knots in made.items()}
    first = dict(zip(made, np.cumsum([0, *count.values()][:-1]), strict=True))
    return (
        np.concatenate(list(made.values())),
        np.array([first[key] for key in keys], dtype=np.int64),
        np.array([count[key] for key in keys], dtype=np.int64),
    )
