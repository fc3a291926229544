"""How long a way still is: the least time that pulses take to a goal, from places all over the plate."""

from __future__ import annotations

import math

import numpy as np
from scipy.ndimage import map_coordinates
from scipy.spatial import ConvexHull

from plategait.arrays import Array, Flags
from plategait.control.pulse import Pulses
from plategait.control.reach import SCALE, Reach
from plategait.control.response import wrapped

# Points of the grid across the bar, along it, and of angles.
_ACROSS, _ALONG, _ANGLES = 11, 15, 24
# Where the goal is near, in steps of the grid.
_NEAR = 1.5
_SWEEPS, _ENOUGH = 20, 0.02
# What ways are thought to take at most before they are known, over mixtures of pulses at the goal.
_MOST = 4.0


class TimeToGo:
    """Times that ways to a goal take, the best pulses one after the other: value iteration on a grid of poses.

    Near the goal, where the grid is too coarse, ways count by mixtures of pulses (`Reach`).

    Parameters
    ----------
    pulses : Pulses
    costs : (k,) array
        What each pulse counts by itself, s.
    goal : (3,) array
        x, y, m, and the angle, rad; NaN for any.
    reach : float
        How far from the middle of the plate an object may be, m.

    Raises
    ------
    InputError
        Where no mixture of pulses goes some way from the goal.
    """

    def __init__(self, pulses: Pulses, costs: Array, goal: Array, reach: float) -> None:
        self._goal, self._any = np.nan_to_num(goal), bool(np.isnan(goal[2]))
        counts = (_ACROSS, _ALONG, 1 if self._any else _ANGLES)
        self._first = np.array([-reach, -reach, self._goal[2]])
        self._last = np.array([_ACROSS - 1, _ALONG - 1, counts[2]])
        self._steps = np.array([2 * reach, 2 * reach, 2 * math.pi]) / self._last
        y, x, angle = (f + s * np.arange(n) for f, s, n in zip(self._first, self._steps, counts, strict=True))
        self._mixture = Reach(pulses.at(np.clip(goal[:2], -reach, reach))[pulses.short], costs[pulses.short])
        places = np.stack(np.meshgrid(y, x, angle, indexing="ij"), axis=-1)
        ways = self._ways(places)
        times = self._mixture.time(ways)
        times = np.where(self._near(ways), times, _MOST * times)
        # Where nothing changes along the bar, all of a line along it has the same pulses.
        along = any(i for i, _ in pulses.response.field.powers)
        lines = [(slice(i, i + 1), slice(j, j + 1) if along else slice(None))
                 for i in range(_ACROSS) for j in range(_ALONG if along else 1)]  # fmt: skip
        ahead = [self._ahead(pulses, costs, places[line]) for line in lines]
        for _ in range(_SWEEPS):
            before = times.copy()
            for line, (own, ends) in zip(lines, ahead, strict=True):
                self._hold(times)
                times[line] = np.minimum(times[line], (own + self._told(ends)).min(axis=0))
            if (before - times).max() < _ENOUGH:
                break
        self._hold(times)

    def of(self, poses: Array) -> Array:
        """(…,) time that the way from poses (…, 3) to the goal takes, s."""
        places = poses[..., (1, 0, 2)]
        ways = self._ways(places)
        return np.where(self._near(ways), self._mixture.time(ways), self._told(places))

    def _hold(self, times: Array) -> None:
        """Take times as what is told from now on, the first angle once more after the last."""
        self._grid = np.concatenate([times, times[:, :, :1]], axis=2)

    def _ways(self, places: Array) -> Array:
        """(…, 3) ways to the goal from places (…, 3): y, x and angle."""
        ways = wrapped(self._goal - places[..., (1, 0, 2)])
        if self._any:
            ways[..., 2] = 0.0
        return ways

    def _near(self, ways: Array) -> Flags:
        return np.asarray((np.abs(ways[..., (1, 0, 2)]) < _NEAR * self._steps).all(axis=-1))

    def _told(self, places: Array) -> Array:
        """(…,) what the grid holds at places (…, 3)."""
        at = (places - self._first) / self._steps
        at[..., 2] = np.remainder(at[..., 2], self._last[2])
        at = np.clip(at, 0.0, self._last)
        return map_coordinates(self._grid, np.moveaxis(at, -1, 0), order=1, mode="nearest")

    def _ahead(self, pulses: Pulses, costs: Array, places: Array) -> tuple[Array, Array]:
        """Costs (m, 1, …) of pulses worth making along a line of places, and where (m, …, 3) they bring an object."""
        moved = pulses.at(places[0, 0, 0, (1, 0)])[1:]
        worth = ConvexHull(moved / costs[1:, None] / SCALE).vertices
        return costs[1:][worth][:, None, None, None], places + moved[worth][:, None, None, None, (1, 0, 2)]
