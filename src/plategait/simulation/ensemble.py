"""What several starts of one scenario show together: one rule for every command, file and figure.

- A point has failed when at least half of its runs did. A tie counts as failed: where the object goes as often as it
  stays nothing can be relied on, and a fit or an estimate had better do without the point than believe in it.
- Rate, spread, gait and every other mean are over the runs that did not fail, and over nothing else. What a run showed
  before it failed belongs to no lasting motion, so where all failed there is no number.
- The gait is that of most of these runs, in a tie the livelier, as the source names a gait by the most that the legs do
  (section 4.3): running is what has no leg on the plate at some time.
- The failure is the commonest among the runs that failed, with the median of its times. It is told wherever a run
  failed, with how many did: a point that has not failed may have failed in part.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plategait.arrays import Array, Flags
from plategait.shown import Shown
from plategait.simulation.observables import FAILURES, GAITS, student_95

# What `together` takes of each run, by the names that stores and files use.
TAKEN = (
    "spin_rate", "spin_rate_sd", "spin_rate_low", "spin_rate_high", "settled", "gait", "failure", "failure_time",
)  # fmt: skip


@dataclass(frozen=True, eq=False, repr=False)
class Ensemble(Shown):
    """What n points show, each over its runs.

    Attributes
    ----------
    runs : int
        Of each point.
    failed_runs, counted_runs : (n,) int arrays
        Runs that failed, and runs that the rate is over.
    rate, spread, low, high : (n,) arrays
        Mean spin rate, its standard deviation over the runs and the 95 % interval of the mean, rad/s; of a single run
        both are over its blocks of periods. NaN where there is none.
    settled : (n,) bool array
        Whether the point has not failed and each run that did not has settled.
    gait : tuple of str
        Empty where nothing was measured.
    failure : tuple of str
        Commonest failure; empty where no run failed.
    failure_time : (n,) array
        Median time of that failure, s; NaN where no run failed.
    """

    runs: int
    failed_runs: NDArray[np.int64]
    counted_runs: NDArray[np.int64]
    rate: Array
    spread: Array
    low: Array
    high: Array
    settled: Flags
    gait: tuple[str, ...]
    failure: tuple[str, ...]
    failure_time: Array

    @property
    def failed(self) -> Flags:
        """Points at which at least half of the runs failed."""
        return fails(self.failed_runs, self.runs)

    @property
    def partly_failed(self) -> Flags:
        """Points at which some runs failed and some did not, whether or not the point counts as failed."""
        return (self.failed_runs > 0) & (self.failed_runs < self.runs)


def fails(failed_runs: ArrayLike, runs: ArrayLike) -> Flags:
    """Whether a point has failed: at least half of its runs did, and one at least."""
    failed = np.asarray(failed_runs)
    return (failed > 0) & (2 * failed >= np.asarray(runs))


def mean_of_unfailed(values: ArrayLike, failed: ArrayLike) -> Array:
    """Means over the last axis of the values of runs that did not fail, where finite; NaN where there is none."""
    values = np.asarray(values, dtype=float)
    counted = np.isfinite(values) & ~np.asarray(failed, dtype=bool)
    number = counted.sum(axis=-1)
    total = np.where(counted, values, 0.0).sum(axis=-1)
    return np.where(number > 0, total / np.maximum(number, 1), np.nan)


def together(
    *,
    spin_rate: ArrayLike,
    spin_rate_sd: ArrayLike,
    spin_rate_low: ArrayLike,
    spin_rate_high: ArrayLike,
    settled: ArrayLike,
    gait: ArrayLike,
    failure: ArrayLike,
    failure_time: ArrayLike,
) -> Ensemble:
    """What points show over their runs.

    Parameters
    ----------
    spin_rate, spin_rate_sd, spin_rate_low, spin_rate_high : (n, runs) arrays
        Of each run, with its standard deviation over blocks of periods and 95 % interval, rad/s.
    settled : (n, runs) bool array
    gait, failure : (n, runs) arrays of str
        Empty where there is none.
    failure_time : (n, runs) array
        s.
    """
    kinds = np.asarray(failure).astype(object)
    failed, rate = kinds != "", np.asarray(spin_rate, dtype=float)
    counted = np.isfinite(rate) & ~failed
    number, mean = counted.sum(axis=1), mean_of_unfailed(rate, failed)
    own_sd, own_low, own_high = (mean_of_unfailed(x, ~counted) for x in (spin_rate_sd, spin_rate_low, spin_rate_high))
    off = np.where(counted, rate - mean[:, None], 0.0)
    spread = np.where(number > 1, np.sqrt((off**2).sum(axis=1) / np.maximum(number - 1, 1)), own_sd)
    half = np.array([student_95(max(n - 1, 1)) for n in number.tolist()]) * spread / np.sqrt(np.maximum(number, 1))
    failed_runs = failed.sum(axis=1)
    commonest, times = _failures(kinds, np.asarray(failure_time, dtype=float))
    return Ensemble(
        runs=failed.shape[1],
        failed_runs=failed_runs,
        counted_runs=number,
        rate=mean,
        spread=spread,
        low=np.where(number > 1, mean - half, own_low),
        high=np.where(number > 1, mean + half, own_high),
        settled=~fails(failed_runs, failed.shape[1]) & (np.asarray(settled, dtype=bool) | failed).all(axis=1),
        gait=_gaits(np.asarray(gait).astype(object), failed),
        failure=commonest,
        failure_time=times,
    )


def _gaits(gait: NDArray[np.object_], failed: Flags) -> tuple[str, ...]:
    livelier_first = GAITS[::-1]
    counts = np.stack([((gait == kind) & ~failed).sum(axis=1) for kind in livelier_first], axis=1)
    return tuple(livelier_first[row.argmax()] if row.any() else "" for row in counts)


def _failures(kinds: NDArray[np.object_], times: Array) -> tuple[tuple[str, ...], Array]:
    """Commonest failure of each point, of equals the first of `FAILURES`, and its median time."""
    counts = np.stack([(kinds == kind).sum(axis=1) for kind in FAILURES], axis=1)
    commonest = [FAILURES[row.argmax()] if row.any() else "" for row in counts]
    medians = [
        float(np.median(time[own == kind])) if kind else np.nan
        for kind, own, time in zip(commonest, kinds, times, strict=True)
    ]
    return tuple(commonest), np.array(medians)
