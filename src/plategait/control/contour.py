"""A controller that carries an object along a path: pulses that get on without leaving it."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

from plategait.arrays import Array
from plategait.control.blend import BlendingController
from plategait.control.goal import WITHIN
from plategait.control.menu import Menu
from plategait.control.path import STEP, Path
from plategait.control.pulse import PAUSE, Pulses
from plategait.control.response import stopped
from plategait.errors import InputError

# How far ahead along the path one pulse may come, m.
_AHEAD = 0.05
# What a millimetre beside the path counts on each millimetre of it, s/m³; over how much of it what is left where a
# pulse ends will be made up for, m; and the share of all this that counts on the ways between strokes.
_BESIDE, _MENDED, _BETWEEN = 0.06e9, 8e-3, 0.02
# Where the way along the path is counted anew, m.
_EVERY = 5e-3
# What no pulse is surer than, m.
_SURE = 0.6e-3
# First pulses that a second one is thought of after.
_KEPT = 20
# Of the gauge's way, m/s: one that is slower is none.
_SLOWEST = 1e-3


class ContourController(BlendingController):
    """Chooses pulses by the time that the rest of the path takes, and by how far beside it they go and end.

    Parameters
    ----------
    menu, pulses
        As of `BlendingController`.
    path : Path
        Which begins where the object lies.

    Raises
    ------
    InputError
        Where no motions carry the object along it.
    """

    def __init__(self, menu: Menu, pulses: Pulses, path: Path) -> None:
        super().__init__(menu, pulses, np.array([*path.points[0], math.nan]))
        self.path, self._arc = path, path.arc
        # Where a pulse is stopped, the angle does not matter.
        self._scale = np.array([WITHIN, WITHIN, np.inf])
        self._weight = _BESIDE * np.where(path.drawn, 1.0, _BETWEEN)
        self._rest = self._rest_of_it()
        self._lay: Array = path.points[0]
        self._place = 0
        self.finished = False

    def _rest_of_it(self) -> Array:
        """(n,) time that the rest of the path takes from each of its points, in mixtures of pulses, s."""
        points = self.path.points
        steps, every = np.diff(points, axis=0), max(round(_EVERY / STEP), 1)
        times = np.zeros(len(steps))
        for begin in range(0, len(steps), every):
            part = slice(begin, begin + every)
            middle = min(begin + every // 2, len(steps))
            velocities = self.pulses.at(points[middle])[1:, :2] / self._costs_at(middle)[1:, None]
            times[part] = _planar_times(velocities, steps[part])
        if not np.isfinite(times).all():
            x, y = 1e3 * points[int(np.argmax(~np.isfinite(times)))]
            raise InputError("path", f"({x:.0f}, {y:.0f}) mm on it", "where the motions carry the object every way",
                             "a machine that also tilts the plate, or a path nearer to the middle")  # fmt: skip
        return np.concatenate([np.cumsum(times[::-1])[::-1], [0.0]])

    @property
    def expected_time(self) -> float:
        """What the whole path takes by the response, s."""
        return float(self._rest[0])

    @property
    def progress(self) -> float:
        """Share of the path that is done."""
        return float(self._arc[self._place] / self._arc[-1])

    def plan(self, state: Array) -> tuple[int, Array]:
        """Pulse to make from a state (6,), and where it ends; none once the object is at the end of the path."""
        pulses = self.pulses
        here = stopped(state)
        self._come_to(here[:2])
        if self.finished:
            return super().plan(state)
        ends = pulses.ends(here)
        own = self.costs() + self.outside(ends, pulses.spread)
        beside, places = self._along(here[:2], self._place, ends[:, :2])
        total = own + beside + self._left(ends[:, :2], places)
        kept = np.argsort(total)[:_KEPT]
        for k, second in zip(kept.tolist(), pulses.ends(ends[kept]), strict=True):
            further, after = self._along(ends[k, :2], int(places[k]), second[:, :2])
            both = own[k] + beside[k] + self.costs() + self.outside(second, pulses.spread)
            total[k] = min(total[k], float((both + further + self._left(second[:, :2], after)).min()))
        total[0] = np.inf
        best = int(total.argmin())
        self.goal = np.array([*self.path.points[places[best]], math.nan])
        return best, ends[best]

    def costs(self) -> Array:
        """(k,) what each pulse counts by itself, s: its time, that of the rest after it, and what is unsure of it."""
        return self._costs_at(self._place)

    def _costs_at(self, place: int) -> Array:
        unsure = np.maximum((self.pulses.spread[:, :2] ** 2).sum(axis=1), _SURE**2)
        return self.pulses.times + PAUSE + _MENDED * self._weight[place] * unsure

    def _come_to(self, here: Array) -> None:
        """Note how far along the path the object has come since it last lay still: never back, and skipping nothing."""
        _, places = self._along(self._lay, self._place, here[None])
        self._lay, self._place = here, int(places[0])
        end = self.path.points[-1]
        near = self._arc[-1] - self._arc[self._place] < 0.5 * WITHIN
        if near and float(np.linalg.norm(here - end)) < 0.6 * WITHIN:
            self.finished = True
            self.aim(np.array([*end, math.nan]))

    def _left(self, ends: Array, places: NDArray[np.int64]) -> Array:
        """(k,) what is left at points of the path, s, and what it counts that ends (k, 2) lie beside them."""
        off = ((ends - self.path.points[places]) ** 2).sum(axis=-1)
        return self._rest[places] + _MENDED * self._weight[places] * off

    def _along(self, begin: Array, place: int, ends: Array) -> tuple[Array, NDArray[np.int64]]:
        """What straight moves to ends (k, 2) count for how far beside the path they go, s, and the points they come to.

        The integral of the squared distance between the path, from a place on, and the move that keeps step with it.
        Of all points that a move may be said to come to it is the one from which the whole takes least.
        """
        part = slice(place, place + round(_AHEAD / STEP))
        near = self.path.points[part]
        gone = self._arc[part] - self._arc[place]
        weight = self._weight[part] * np.diff(gone, prepend=0.0)
        off, moves = near - begin, ends - begin
        share = np.maximum(gone, STEP)
        squares = np.cumsum(weight * (off**2).sum(axis=1))
        crossed = np.cumsum((weight * gone)[:, None] * off, axis=0) / share[:, None]
        steps = np.cumsum(weight * gone**2) / share**2
        cost = squares - 2 * moves @ crossed.T + (moves**2).sum(axis=1)[:, None] * steps
        mending = _MENDED * self._weight[part] * ((ends[:, None] - near) ** 2).sum(axis=-1)
        best = (cost + mending + self._rest[part]).argmin(axis=1)
        return np.maximum(cost[np.arange(len(ends)), best], 0.0), place + best


def _planar_times(velocities: Array, ways: Array) -> Array:
    """(n,) time that ways (n, 2) take by mixtures of velocities (k, 2), s; infinite where none goes some way."""
    try:
        sides = ConvexHull(velocities).equations
    except QhullError:
        return np.full(len(ways), np.inf)
    if (sides[:, 2] > -_SLOWEST).any():
        return np.full(len(ways), np.inf)
    return np.maximum((ways @ (sides[:, :2] / -sides[:, 2:]).T).max(axis=-1), 0.0)
