"""What two sheets that feel the same motion can do apart from each other, by where they lie across the bar."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

from plategait.arrays import Array
from plategait.control.pulse import PAUSE, Pulses

WAY = np.array([10e-3, 10e-3, math.radians(20)])
"""Displacements that are asked for: along the bar, across it, m, and turning, rad."""
# Ticks of the pulses that are mixed.
_TICKS = (3, 8, 18)
# Singular values of displacements, over the greatest, that count.
_RANK = 1e-6


@dataclass(frozen=True, eq=False)
class PairReach:
    """What mixtures of short pulses do to one of two sheets while the other ends where it began.

    Attributes
    ----------
    places : (a,) array
        Of the sheets across the bar, m.
    rank : (a, a) int array
        Numbers, of the six that say where both sheets lie, that pulses can change independently if they may go back.
    times : (a, a, 12) array
        s that each of twelve ways takes: `WAY` forwards along x, y and the angle of the first sheet, then of the
        second, then the same backwards. Infinite where no mixture of pulses goes it.
    """

    places: Array
    rank: NDArray[np.int64]
    times: Array

    @property
    def ways(self) -> NDArray[np.int64]:
        """(a, a) how many of the twelve ways some mixture goes."""
        return np.isfinite(self.times).sum(axis=2)


def pair_reach(pulses: Pulses, reach: float, count: int = 15) -> PairReach:
    """Find what two sheets can do apart from each other, on a grid of both places across the bar.

    Parameters
    ----------
    pulses : Pulses
        Of either sheet.
    reach : float
        How far from the bar they may be, m.
    count : int
        Places across the bar.
    """
    places = np.linspace(-reach, reach, count)
    moved = np.array([pulses.at(np.array([0.0, y])) for y in places])[:, np.isin(pulses.ticks, _TICKS)] / WAY
    costs = pulses.times[np.isin(pulses.ticks, _TICKS)] + PAUSE
    rank, times = np.zeros((count, count), dtype=np.int64), np.full((count, count, 12), np.inf)
    for i in range(count):
        for j in range(i, count):
            both = np.concatenate([moved[i], moved[j]], axis=1)
            sizes = np.linalg.svd(both, compute_uv=False)
            rank[i, j] = rank[j, i] = int((sizes > _RANK * sizes[0]).sum())
            times[i, j] = _times(both, costs)
            times[j, i] = times[i, j].reshape(2, 2, 3)[:, ::-1].ravel()
    return PairReach(places, rank, times)


def _times(moved: Array, costs: Array) -> Array:
    """(12,) least time in which mixtures of displacements (m, 6), in units of the ways, go each of the ways."""
    ways = np.concatenate([np.eye(6), -np.eye(6)])
    # Linear programmes do not like numbers that are nearly nothing.
    found = [linprog(costs, A_eq=np.round(moved, 9).T, b_eq=way) for way in ways]
    return np.array([each.fun if each.status == 0 else np.inf for each in found])
