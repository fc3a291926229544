"""Sampled trajectories as tables of knots for the core: each one once, and no further than it is run."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.engine.recording import RunRequest
from plategait.model.motion import PlateMotion, Samples
from plategait.model.scenario import Scenario

# A knot of 12 numbers, and the copies that the spline makes of it.
KNOT_BYTES = 12 * 8 * 3


@dataclass(frozen=True)
class Followed:
    """A trajectory that one run follows: its table's step, and how far it is followed, s."""

    samples: Samples
    step: float
    end: float = math.inf


def table_step(scenario: Scenario, motion: PlateMotion | None = None) -> float:
    """Time between knots, s: a number that single precision holds, so that the core puts them where they are.

    Of a motion that the scenario's plate goes over to, if one is given.
    """
    samples = (motion or scenario.motion).samples
    finest = 1.0 if samples is None else max(min(samples.finest_step / 2, scenario.duration), 2 * scenario.dt)
    return float(np.float32(finest))


def followed(run: RunRequest) -> Followed | None:
    """What a run follows to its end; None where its plate has no sampled trajectory."""
    samples = run.scenario.motion.samples
    return None if samples is None else Followed(samples, table_step(run.scenario), run.steps * run.scenario.dt)


def table_bytes(runs: Iterable[RunRequest]) -> float:
    """Memory that `tables` takes at most."""
    taken = {
        id(s): KNOT_BYTES * min(s.time[-1], r.scenario.duration) / table_step(r.scenario)
        for r in runs
        if (s := r.scenario.motion.samples)
    }
    return sum(taken.values())


def tables(all_followed: Sequence[Followed | None]) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.int64]]:
    """Knots of sampled trajectories, to the furthest that each is followed.

    Returns
    -------
    knots : (n, 12) array
        Of all trajectories, one after the other; empty where there is none.
    first, count : (n_followed,) arrays
        Where the knots of each begin, and how many they are. Where there is none, the plate stays.
    """
    # Found by identity first, as hashing a long trajectory takes milliseconds.
    equal: dict[Samples, Samples] = {}
    shared: dict[int, Samples] = {}
    keys: list[tuple[int, float] | None] = []
    ends: dict[tuple[int, float] | None, float] = {}
    for one in all_followed:
        key = None
        if one is not None:
            if id(one.samples) not in shared:
                shared[id(one.samples)] = equal.setdefault(one.samples, one.samples)
            key = (id(shared[id(one.samples)]), one.step)
            ends[key] = max(ends.get(key, 0.0), one.end)
        ends.setdefault(key, 0.0)
        keys.append(key)
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
