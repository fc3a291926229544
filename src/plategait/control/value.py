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
_ACROSS, _ALONG, _ANGLES = 11, 21, 24
_FAR = 0.1  # m
# Where the goal is near, in steps of the grid.
_NEAR = 1.5
_SWEEPS, _ENOUGH = 20, 0.02
# What ways are thought to take at most before they are known, over mixtures of pulses at the goal.
_MOST = 4.0


class TimeToGo:
    """Times that ways to a goal take, the best pulses one after the other: value iteration on a grid.

    What an object does depends on where it lies across the bar, and along it hardly within a way; so the grid holds the
    place across, and how far the goal is along the bar and in angle. Near the goal, where the grid is too coarse, ways
    count by mixtures of pulses (`Reach`).

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
        self._goal, self._any = goal, bool(np.isnan(goal[2]))
        angles = 1 if self._any else _ANGLES
        self._first = np.array([-reach, -_FAR, 0.0])
        self._steps = np.array([2 * reach / (_ACROSS - 1), 2 * _FAR / (_ALONG - 1), 2 * math.pi / angles])
        self._last = np.array([_ACROSS - 1, _ALONG - 1, angles])
        y, dx, angle = (first + step * np.arange(count) for first, step, count in
                        zip(self._first, self._steps, (_ACROSS, _ALONG, angles), strict=True))  # fmt: skip
        x = float(np.clip(goal[0], -reach, reach))
        self._mixture = Reach(pulses.at(np.clip(goal[:2], -reach, reach))[pulses.short], costs[pulses.short])
        poses = np.stack(np.meshgrid(y, dx, angle, indexing="ij"), axis=-1)
        ways = self._ways(poses)
        times = self._mixture.time(ways)
        times = np.where(self._near(ways), times, _MOST * times)
        ahead = [self._ahead(pulses, costs, np.array([x, place]), poses[i]) for i, place in enumerate(y)]
        for _ in range(_SWEEPS):
            before = times.copy()
            for i, (own, places) in enumerate(ahead):
                self._grid = np.concatenate([times, times[:, :, :1]], axis=2)
                times[i] = np.minimum(times[i], (own + self._told(places)).min(axis=0))
            if (before - times).max() < _ENOUGH:
                break
        self._grid = np.concatenate([times, times[:, :, :1]], axis=2)

    def of(self, poses: Array) -> Array:
        """(…,) time that the way from poses (…, 3) to the goal takes, s."""
        places = np.stack([poses[..., 1], poses[..., 0] - self._goal[0], poses[..., 2] - self._turned], axis=-1)
        ways = self._ways(places)
        return np.where(self._near(ways), self._mixture.time(ways), self._told(places))

    @property
    def _turned(self) -> float:
        return 0.0 if self._any else float(self._goal[2])

    def _ways(self, places: Array) -> Array:
        """(…, 3) ways to the goal from places (…, 3): y, and x and angle from the goal's."""
        ways = wrapped(np.stack([-places[..., 1], self._goal[1] - places[..., 0], -places[..., 2]], axis=-1))
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

    def _ahead(self, pulses: Pulses, costs: Array, place: Array, poses: Array) -> tuple[Array, Array]:
        """Costs (m, 1, 1) of pulses worth making at a place, and where (m, …, 3) they bring an object from places."""
        moved = pulses.at(place)[1:]
        worth = ConvexHull(moved / costs[1:, None] / SCALE).vertices
        return costs[1:][worth][:, None, None], poses + moved[worth][:, None, None, (1, 0, 2)]
