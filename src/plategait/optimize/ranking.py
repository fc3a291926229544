"""Which motions are better: first those that stay, then those that reach what is sought, then those that cost least."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from plategait.arrays import Array
from plategait.optimize.goal import AIMED, Goal
from plategait.optimize.trials import Trial


def ranks(trials: Sequence[Trial], goal: Goal, allowed: float = AIMED) -> Array:
    """(n,) place of each trial, 0 for the best: what an evolution strategy may be told, which does not see NaN.

    Those none of whose runs failed come first: of a goal to reach, those that reach it by their cost, then the others
    by how far off they are. Then come those that failed, by how soon: those that lasted longest first. Last come those
    that show nothing to measure.

    Parameters
    ----------
    trials : sequence of Trial
    goal : Goal
    allowed : float
        Deviation up to which a goal counts as reached: more while a search may still look around.
    """
    keys = [_key(trial, goal, allowed) for trial in trials]
    places = np.empty(len(keys))
    places[sorted(range(len(keys)), key=keys.__getitem__)] = np.arange(len(keys))
    return places


def _key(trial: Trial, goal: Goal, allowed: float) -> tuple[int, float, float]:
    if trial.failed:
        return 2, -trial.lasted, 0.0
    if not trial.counted:
        return 3, 0.0, 0.0
    if goal.fastest:
        return 0, -abs(trial.spin_rate), 0.0
    deviation = goal.deviation(trial.twist)
    return (0, trial.cost(goal.cost), deviation) if deviation <= allowed else (1, deviation, 0.0)


def largest_chance(failed: int, runs: int, confidence: float) -> float:
    """Upper bound of a chance of which `failed` of `runs` were seen, one-sided (Clopper and Pearson)."""
    if failed >= runs:
        return 1.0
    from scipy.special import betaincinv

    return float(betaincinv(failed + 1, runs - failed, confidence))


def least_chance(failed: int, runs: int, confidence: float) -> float:
    """Lower bound of a chance of which `failed` of `runs` were seen, at a one-sided confidence."""
    if failed == 0:
        return 0.0
    from scipy.special import betaincinv

    return float(betaincinv(failed, runs - failed + 1, 1 - confidence))


def runs_without_failure(permitted: float, confidence: float) -> int:
    """Runs that must all go well to bound the chance of failure: the least n with 1 − (1 − confidence)^(1/n) ≤ it."""
    return max(1, math.ceil(math.log(1 - confidence) / math.log1p(-permitted) - 1e-9))
