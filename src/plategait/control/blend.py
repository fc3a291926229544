"""A controller that blends the menu's motions in time: pulses from rest to rest, each chosen with the next in mind."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.control.goal import WITHIN, WITHIN_ANGLE
from plategait.control.menu import Menu, room_of
from plategait.control.observer import Observer
from plategait.control.pulse import Pulses
from plategait.control.reach import Reach
from plategait.control.response import wrapped

REST = 9
"""Ticks that an object is left to come to rest, and seen to, before the next pulse."""
BLIND = 0.15
"""Time without a frame after which a plate is stopped, s."""
# An object stays where it is within these shares of the tolerances.
_NEAR, _NEAR_ANGLE = 0.6, 0.6
# What time in motion, each pulse, and not being there yet counts, beside the time that the rest of the way takes.
_MOVING, _PULSE, _FURTHER = 0.3, 0.05, 0.1
# Time that what is unsure will take, over the standard deviations: m and rad per s.
_MENDING = 2 * np.array([0.03, 0.03, math.radians(80)])
# How far beyond its room an object may be expected before it counts as a second, m.
_OVER = 5e-3
# Standard deviations that are kept from the edge.
_SURE = 2.0
# First pulses that a second one is thought of after.
_KEPT = 24
_ALIKE = 4
_DEPTH = 4
_LATE = 4


class BlendingController:
    """Chooses a motion each tick, so that an object comes to its goal and stays there.

    From rest all pulses are weighed by the time that they take, by what is then left of the way, as it takes mixtures
    of short pulses (`Reach`), by how unsure they are, and by whether they end near the edge; the most promising ones
    with a second pulse after them. While one goes, it is stopped where it comes nearest to where it was to end.

    Parameters
    ----------
    menu : Menu
    pulses : Pulses
        Of the menu, by the response as it is known: changed as it is learnt.
    goal : (3,) array
        x, y, m, and the angle, rad; NaN for any.
    most : int, optional
        Pulses that it may make: as many as it takes by default.
    """

    def __init__(self, menu: Menu, pulses: Pulses, goal: Array, most: int | None = None) -> None:
        self.menu, self.pulses, self.goal = menu, pulses, goal
        self._room = room_of(menu.scenario)
        self._scale = np.array([WITHIN, WITHIN, WITHIN_ANGLE])
        self.motion, self.made, self._most = 0, 0, most
        self._rested, self._going, self._planned = REST, 0, 0
        self._target = goal
        self._reach: Reach | None = None

    def aim(self, goal: Array) -> None:
        """Go for another goal from now on."""
        self.goal, self._reach = goal, None

    def forget(self) -> None:
        """Count the rest of the way anew, after the response has been learnt better."""
        self._reach = None

    @property
    def at_rest(self) -> bool:
        """Whether the object has been left to come to rest."""
        return self.motion == 0 and self._rested >= REST

    def choose(self, observer: Observer) -> int:
        """Motion to take hold from now on, as its place in the menu."""
        blind = observer.since_seen > BLIND
        if self.motion == 0:
            self._rested += 1
            if self.at_rest and not blind and (self._most is None or self.made < self._most):
                self._begin(observer.expected())
        else:
            self._going += 1
            nearest = self._nearest(observer.expected())
            late = self._going > 1.5 * self._planned + _LATE
            if blind or late or nearest == 0:
                self.motion, self._rested = 0, 0
        return self.motion

    def _begin(self, state: Array) -> None:
        pulse, end = self.plan(state)
        motion = int(self.pulses.motion[pulse])
        if motion:
            self.motion, self._target = motion, end
            self._planned, self._going, self._rested = int(self.pulses.ticks[pulse]), 0, 0
            self.made += 1

    def _nearest(self, state: Array) -> int:
        off = wrapped(self.pulses.going(self.motion, state) - self._target) / self._scale
        return int((off**2).sum(axis=1).argmin())

    def left(self, poses: Array) -> Array:
        """(…,) time that the way from poses (…, 3) to the goal takes yet, s."""
        ways = self._way(poses)
        if self._reach is None:
            place = np.clip(self.goal[:2], -self._room, self._room)
            self._reach = Reach(*self.pulses.short(place))
        near = (np.hypot(ways[..., 0], ways[..., 1]) < _NEAR * WITHIN) & (
            np.abs(ways[..., 2]) < _NEAR_ANGLE * WITHIN_ANGLE
        )
        time = self._reach.time(ways)
        return np.where(near, 0.3 * time, time + _FURTHER)

    def _way(self, poses: Array) -> Array:
        goal = np.where(np.isnan(self.goal), 0.0, self.goal)
        ways = wrapped(goal - poses)
        if math.isnan(self.goal[2]):
            ways[..., 2] = 0.0
        return ways

    def there(self, pose: Array) -> bool:
        """Whether a pose is as near as the controller brings an object."""
        way = self._way(pose)
        return bool(math.hypot(way[0], way[1]) < 0.85 * WITHIN and abs(way[2]) < 0.85 * WITHIN_ANGLE)

    def outside(self, poses: Array, spread: Array) -> Array:
        """(…,) what poses near the edge or beyond count, s."""
        over = np.abs(poses[..., :2]) + _SURE * spread[..., :2] - (self._room - _OVER)
        return np.maximum(over, 0.0).sum(axis=-1) / _OVER

    def costs(self) -> Array:
        """(k,) what each pulse counts by itself, s."""
        pulses = self.pulses
        unsure = (pulses.spread / _MENDING).sum(axis=1)
        return _MOVING * pulses.times + _PULSE * (pulses.ticks > 0) + unsure

    def plan(self, state: Array) -> tuple[int, Array]:
        """Pulse to make from a state (7,), and where it ends; the first, which is none, where the object is there."""
        pulses = self.pulses
        ends = pulses.ends @ state
        if self.there(ends[0]):
            return 0, ends[0]
        alone = self.costs()
        own = alone + self.outside(ends, pulses.spread)
        total = own + self.left(ends)
        # Ways of further pulses, each kept with the pulse that it begins with: a beam search.
        first, paid, poses = np.arange(len(own)), own, ends
        for _ in range(_DEPTH - 1):
            kept = self._beam(first, paid, poses)
            first, from_rest = first[kept], np.concatenate([np.ones((len(kept), 1)), poses[kept]], axis=1)
            poses = np.einsum("kij,nj->nki", pulses.ends[1:, :, :4], from_rest)
            paid = paid[kept][:, None] + alone[1:] + self.outside(poses, pulses.spread[1:])
            whole = paid + self.left(poses)
            np.minimum.at(total, first, whole.min(axis=1))
            first, paid, poses = np.repeat(first, whole.shape[1]), paid.ravel(), poses.reshape(-1, 3)
        total[0] = np.inf
        best = int(total.argmin())
        return best, ends[best]

    def _beam(self, first: NDArray[np.int64], paid: Array, poses: Array) -> NDArray[np.int64]:
        """Ways to go on with: the most promising ones, few of them with the same pulse first."""
        promise = paid + 0.8 * self.left(poses)
        promise[first == 0] = np.inf
        order = np.argsort(promise)[: 20 * _KEPT]
        of_first = first[order]
        turn = np.zeros(len(order), dtype=np.int64)
        seen: dict[int, int] = {}
        for i, pulse in enumerate(of_first.tolist()):
            turn[i] = seen[pulse] = seen.get(pulse, 0) + 1
        return order[turn <= _ALIKE][:_KEPT]
