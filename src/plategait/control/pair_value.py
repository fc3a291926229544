"""How long the ways of two sheets on one plate still are: what each pulse does to one, it does to the other as well."""

from __future__ import annotations

import itertools
import math

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import map_coordinates
from scipy.spatial import ConvexHull, QhullError

from plategait.arrays import Array, Flags
from plategait.control.pulse import Pulses
from plategait.control.reach import SCALE

Single = NDArray[np.float32]

# Points of the grid across the bar, along it, and of angles, for each of the sheets.
_ACROSS, _ALONG, _ANGLES = 15, 17, 20
_FAR = 0.1  # m
# Ticks of the pulses that ways are made of.
_TICKS = (3, 8, 18)
_SWEEPS, _ENOUGH = 100, 0.05
# What short ways are thought to take that no mixture of pulses goes, at most: so much, s, and so much slower than at
# the scale's speeds.
_ABOUT, _SLOWER = 4.0, 4.0
# What any way takes at most, s, and what is as good as nothing.
_MOST, _NONE = 60.0, 1e-6


class PairTable:
    """What pulses do to two sheets at once, on a grid of both places across the bar, and of both x or both angles.

    It depends on no goal: `PairTime` finds times to one by it.

    Parameters
    ----------
    pulses : Pulses
    costs : (k,) array
        What each pulse counts by itself, s.
    reach : float
        How far from the middle of the plate the sheets may be, m.
    part : {0, 2}
        Whether it is x or the angles.
    """

    def __init__(self, pulses: Pulses, costs: Array, reach: float, part: int) -> None:
        self.part, self.reach, self.pulses = part, reach, pulses
        self.scale = SCALE[[1, 1, part, part]]
        count = _ANGLES if part == 2 else _ALONG
        own = 2 * math.pi / _ANGLES if part == 2 else 2 * _FAR / (_ALONG - 1)
        across = 2 * reach / (_ACROSS - 1)
        self.shape, self.steps = (_ACROSS, _ACROSS, count, count), np.array([across, across, own, own])
        self.first = np.array([-reach, -reach, 0.0, 0.0] if part == 2 else [-reach, -reach, -_FAR, -_FAR])
        self._usable = np.isin(pulses.ticks, _TICKS)
        self._alone = costs[self._usable]
        places = np.linspace(-reach, reach, _ACROSS)
        rows = [self._worth(places[i], places[j], i, j) for i, j in itertools.product(range(_ACROSS), repeat=2)]
        most = max(len(cost) for cost, _ in rows)
        self._costs, ahead = np.full((len(rows), most), _MOST), np.zeros((len(rows), most, 4))
        for row, (cost, at) in enumerate(rows):
            self._costs[row, : len(cost)], ahead[row, : len(at)] = cost, at
        low = np.clip(np.floor(ahead[..., :2]), 0, _ACROSS - 2).astype(np.int64)
        self._low, self._share = low, np.clip(ahead[..., :2] - low, 0.0, 1.0).astype(np.float32)
        self._shifts = [self._shifted(ahead[..., k]) for k in (2, 3)]

    def speeds(self, places: Array) -> Array:
        """(m, 4) what pulses do per second at places (2,) across the bar: to both places, and both x or angles."""
        one, other = (self.pulses.at(np.array([0.0, y]))[self._usable] for y in places)
        moved = np.column_stack([one[:, 1], other[:, 1], one[:, self.part], other[:, self.part]])
        return moved / self._alone[:, None]

    def _worth(self, one: float, other: float, i: int, j: int) -> tuple[Array, Array]:
        """Costs (m,) of the pulses worth making at a node, and where (m, 4) they lead, in steps of the grid."""
        speeds = self.speeds(np.array([one, other]))
        scaled = speeds / self.scale
        try:
            worth = ConvexHull(scaled).vertices
        except QhullError:  # both at one place
            worth = ConvexHull(scaled[:, [0, 2]]).vertices
        costs = self._alone[worth]
        at = speeds[worth] * costs[:, None] / self.steps
        at[:, :2] += (i, j)
        out = np.maximum(np.abs(at[:, :2] - (_ACROSS - 1) / 2) - (_ACROSS - 1) / 2, 0.0).sum(axis=1)
        return costs + _MOST * out, at

    def _shifted(self, moved: Array) -> Single:
        """(n, m, c, c) matrices that read numbers on a grid at places moved (n, m) steps on."""
        count = self.shape[2]
        at = moved[..., None] + np.arange(count)
        if self.part == 2:
            at = np.remainder(at, count)
            low = np.floor(at).astype(np.int64) % count
            high = (low + 1) % count
        else:
            at = np.clip(at, 0.0, count - 1.0)
            low = np.minimum(np.floor(at).astype(np.int64), count - 2)
            high = low + 1
        share = at - np.floor(at) if self.part == 2 else at - low
        unit = np.eye(count, dtype=np.float32)
        return ((1 - share[..., None]) * unit[low] + share[..., None] * unit[high]).astype(np.float32)

    def nodes(self) -> Array:
        """(a, a, c, c, 4) what the grid's points stand for; the last two are counted from the goals."""
        axes = [first + step * np.arange(count) for first, step, count in
                zip(self.first, self.steps, self.shape, strict=True)]  # fmt: skip
        return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)

    def iterated(self, times: Array, closed: Flags | None) -> Single:
        """Times by the best pulses one after the other, from times at which to begin; none where it is closed."""
        single: Single = times.astype(np.float32)
        costs = self._costs[..., None, None].astype(np.float32)
        corners = [(self._low[..., 0] + i, self._low[..., 1] + j,
                    np.abs(1 - i - self._share[..., 0]) * np.abs(1 - j - self._share[..., 1]))
                   for i, j in itertools.product((0, 1), repeat=2)]  # fmt: skip
        for _ in range(_SWEEPS):
            before = single
            there = sum(share[..., None, None] * single[i, j] for i, j, share in corners)
            ahead = self._shifts[0] @ there @ self._shifts[1].swapaxes(-1, -2) + costs
            single = np.minimum(single, ahead.min(axis=1).reshape(self.shape))
            if closed is not None:
                single[closed] = _MOST
            if (before - single).max() < _ENOUGH:
                break
        return single


class PairTime:
    """Times that the ways of two sheets to their goals take together: value iteration on the grid of a `PairTable`.

    Near the goals, where the grid is too coarse, ways count by mixtures of the pulses there.

    Parameters
    ----------
    table : PairTable
    goals : (2, 3) array
        x, y, m, and the angle, rad, of either sheet.
    apart : float
        How near the sheets may be, m.
    """

    def __init__(self, table: PairTable, goals: Array, apart: float) -> None:
        self._table = table
        self._goal = np.array([*goals[:, 1], 0.0, 0.0])
        self._offset = np.array([0.0, 0.0, *goals[:, table.part]])
        try:
            rest = np.zeros((1, 4))
            self._sides = ConvexHull(np.concatenate([rest, table.speeds(goals[:, 1]) / table.scale])).equations
        except QhullError:  # both at one place
            self._sides = np.zeros((0, 5))
        nodes = table.nodes()
        ways, closed = self._ways(nodes), None
        near, times = self._near(ways), np.full(table.shape, _MOST)
        times[near] = np.minimum(self._by_mixture(ways[near]), self._about(ways[near]))
        if table.part == 0:
            along = nodes[..., 2] - nodes[..., 3] + goals[0, 0] - goals[1, 0]
            closed = np.hypot(along, nodes[..., 0] - nodes[..., 1]) < apart
        self._times = table.iterated(times, closed)

    def of(self, poses: Array) -> Array:
        """(…,) times from poses (2, …, 3) of the sheets, s."""
        table = self._table
        places = np.stack([*poses[..., 1], *poses[..., table.part]], axis=-1) - self._offset
        ways = self._ways(places)
        near = self._near(ways)
        at, times = (places - table.first) / table.steps, self._times
        if table.part == 2:
            at[..., 2:] = np.remainder(at[..., 2:], table.shape[2])
            times = np.concatenate([times, times[:, :, :1]], axis=2)
            times = np.concatenate([times, times[..., :1]], axis=3)
        at = np.clip(at, 0.0, np.array(times.shape) - 1.0)
        told = map_coordinates(times, np.moveaxis(at, -1, 0), order=1, mode="nearest")
        told[near] = np.minimum(told[near], self._by_mixture(ways[near]))
        return told

    def _ways(self, places: Array) -> Array:
        """(…, 4) ways from places to the goal, angles in ±π."""
        ways = self._goal - places
        if self._table.part == 2:
            ways[..., 2:] = np.remainder(ways[..., 2:] + math.pi, 2 * math.pi) - math.pi
        return ways

    def _near(self, ways: Array) -> Flags:
        return np.asarray((np.abs(ways) < self._table.steps).all(axis=-1))

    def _by_mixture(self, ways: Array) -> Array:
        """(…,) time of ways (…, 4) by a mixture of pulses at the goals; infinite where none goes that way."""
        if not len(self._sides):
            return np.full(ways.shape[:-1], np.inf)
        along, far = ways / self._table.scale @ self._sides[:, :4].T, -self._sides[:, 4]
        times = np.where(far > _NONE, along / np.maximum(far, _NONE), np.where(along > _NONE, np.inf, 0.0))
        return times.max(axis=-1)

    def _about(self, ways: Array) -> Array:
        return _ABOUT + _SLOWER * np.abs(ways / self._table.scale).max(axis=-1)
