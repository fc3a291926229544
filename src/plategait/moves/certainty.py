"""How certain a velocity is: its covariance over starts, widened until it tells of starts that it has not seen."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from plategait.arrays import Array
from plategait.optimize.trials import Trial

COVERED = 0.9
"""Share of fresh runs that the region of a covariance is to hold."""
CHI2 = 6.2514
"""Squared distance within which that share of a normal velocity lies: χ² with three degrees of freedom."""
# Spread that no number of like runs can do away with, as a share of the size of a cell.
_FLOOR = 0.02


def covariance(twists: Array, sizes: Array) -> Array:
    """(3, 3) covariance of the velocity of one more run beside those known (n, 3), SI."""
    n = len(twists)
    floor = np.diag((_FLOOR * sizes) ** 2)
    return (1 + 1 / n) * (np.atleast_2d(np.cov(twists.T)) + floor) if n > 1 else floor + np.diag(sizes**2)


def distances_left_out(twists: Array, sizes: Array) -> Array:
    """(n,) squared distance of each run from the mean of the others, by their covariance."""
    distances = np.empty(len(twists))
    for i, twist in enumerate(twists):
        others = np.delete(twists, i, axis=0)
        off = twist - others.mean(axis=0)
        distances[i] = off @ np.linalg.solve(covariance(others, sizes), off)
    return distances


def widening(trials: Sequence[Trial], sizes: Array) -> float:
    """Factor on all covariances with which their 90 % regions hold 90 % of runs left out; 1 where too few are known.

    A few starts tell a covariance too narrowly, and velocities are not normal: both are mended by what is seen of runs
    left out, over all motions together.
    """
    known = [distances_left_out(t.twists, sizes) for t in trials if t.counted > 4]
    return float(np.quantile(np.concatenate(known), COVERED)) / CHI2 if known else 1.0
