"""A controller that blends the menu's motions in time: pulses from rest to rest, each chosen with the next in mind."""

from __future__ import annotations

import math

import numpy as np

from plategait.arrays import Array
from plategait.control.goal import WITHIN, WITHIN_ANGLE
from plategait.control.menu import Menu
from plategait.control.observer import Observer
from plategait.control.pulse import PAUSE, Pulses
from plategait.control.response import stopped, wrapped
from plategait.control.room import room_of
from plategait.control.value import TimeToGo
from plategait.model.motion import PlateMotion

REST = 9
"""Ticks that an object is left to come to rest, and seen to, before the next pulse."""
BLIND = 0.15
"""Time without a frame after which a plate is stopped, s."""
# An object is there within this share of the tolerances, and brought nearer than that where it is not.
_THERE, _WELL = 0.85, 0.6
# What not being there yet counts, s.
_FURTHER = 0.4
# Time that what is unsure will take, over the standard deviations: m and rad per s.
_MENDING = 2 * np.array([0.03, 0.03, math.radians(80)])
# What is kept from the edge beside so many standard deviations, m, and how much nearer counts as a second, m.
_KEPT_OFF, _SURE, _OVER = 10e-3, 2.0, 5e-3
# First pulses that a second one is thought of after, and the share of the time to go that they are chosen by.
_KEPT, _HOPED = 24, 0.8
# How much longer than planned a pulse may go on.
_LONGER, _LATE = 1.5, 4


class BlendingController:
    """Chooses a motion each tick, so that an object comes to its goal and stays there.

    From rest all pulses are weighed by how much of the time to go (`TimeToGo`) they save over the time that they take
    and that what is unsure of them will take, the most promising ones also with a second pulse after them; ends near
    the edge count against them. While one goes, it is stopped where it comes nearest to where it was to end.

    Parameters
    ----------
    menu : Menu
    pulses : Pulses
        Of the menu, by the response as it is known.
    goal : (3,) array
        x, y, m, and the angle, rad; NaN for any.
    most : int, optional
        Pulses that it may make: as many as it takes by default.
    within : (float, float)
        How near to the goal counts as there, m and rad.
    looks : bool
        Whether frames come, without which it stops.
    """

    def __init__(
        self,
        menu: Menu,
        pulses: Pulses,
        goal: Array,
        most: int | None = None,
        within: tuple[float, float] = (WITHIN, WITHIN_ANGLE),
        looks: bool = True,
    ) -> None:
        self.menu, self.pulses, self.goal = menu, pulses, goal
        self._room = room_of(menu.scenario) - _KEPT_OFF
        self._within = np.array(within)
        self._scale = self._within[[0, 0, 1]]
        self.motion, self.made, self._most = 0, 0, most
        self._rested, self._going, self._planned = REST, 0, 0
        self._target, self._looks = goal, looks
        self._togo: TimeToGo | None = None
        self.finished = True
        """Whether being at the goal is all that is left to do."""

    def aim(self, goal: Array) -> None:
        """Go for another goal from now on."""
        self.goal, self._togo = goal, None

    def learnt(self, motion: int, rates: Array) -> None:
        """Take other rates (3, p) of one motion."""
        self.pulses = self.pulses.learnt(motion, rates)

    @property
    def at_rest(self) -> bool:
        """Whether the object has been left to come to rest."""
        return self.motion == 0 and self._rested >= REST

    def choose(self, observer: Observer) -> int:
        """Motion to take hold from now on, as its place in the menu."""
        blind = self._looks and observer.since_seen > BLIND
        if self.motion == 0:
            self._rested += 1
            if self.at_rest and not blind and (self._most is None or self.made < self._most):
                self._begin(observer)
        else:
            self._going += 1
            if blind or self._over(observer):
                self.motion, self._rested = 0, 0
        return self.motion

    def told(self, motions: tuple[PlateMotion, ...]) -> PlateMotion:
        """Motion that the plate is told, of a menu's motions at its height."""
        return motions[self.motion]

    def _begin(self, observer: Observer) -> None:
        """Decide on the next pulse, or on none."""
        pulse, end = self.plan(observer.expected())
        motion = int(self.pulses.motion[pulse])
        if motion:
            self.motion, self._target = motion, end
            self._planned, self._going, self._rested = int(self.pulses.ticks[pulse]), 0, 0
            self.made += 1

    def _over(self, observer: Observer) -> bool:
        """Whether the object comes nearest now to where it was to end."""
        state = observer.expected()
        most = round(_LONGER * self._planned) + _LATE
        ends = self.pulses.going(self.motion, state, max(most - self._going, 0))
        off = wrapped(ends - self._target) / self._scale
        return int((off**2).sum(axis=1).argmin()) == 0

    def _off(self, poses: Array) -> Array:
        """(…,) how far from the goal poses (…, 3) are, over the tolerances: the greater of distance and angle."""
        ways = wrapped(np.nan_to_num(self.goal) - poses)
        turn = np.zeros(ways.shape[:-1]) if math.isnan(self.goal[2]) else np.abs(ways[..., 2])
        return np.maximum(np.hypot(ways[..., 0], ways[..., 1]) / self._within[0], turn / self._within[1])

    def left(self, poses: Array) -> Array:
        """(…,) time that the way from poses (…, 3) to the goal takes yet, s."""
        if self._togo is None:
            self._togo = TimeToGo(self.pulses, self.costs(), self.goal, self.menu.reach)
        time = self._togo.of(poses)
        return np.where(self._off(poses) < _WELL, 0.3 * time, time + _FURTHER)

    def outside(self, poses: Array, spread: Array) -> Array:
        """(…,) what poses near the edge, and farther out than the goal, count, s."""
        over = np.abs(poses[..., :2]) + _SURE * spread[..., :2] - np.maximum(self._room, np.abs(self.goal[:2]))
        return np.maximum(over, 0.0).sum(axis=-1) / _OVER

    def costs(self) -> Array:
        """(k,) what each pulse counts by itself, s."""
        pulses = self.pulses
        return pulses.times + PAUSE + (pulses.spread / _MENDING).sum(axis=1)

    def plan(self, state: Array) -> tuple[int, Array]:
        """Pulse to make from a state (6,), and where it ends; the first, which is none, where the object is there."""
        pose = stopped(state)
        best = 0 if self._off(pose) < _THERE else int(self.gains(pose).argmax())
        return best, self.pulses.ends(pose)[best]

    def gains(self, pose: Array) -> Array:
        """(k,) time to go that each pulse from rest at a pose (3,) saves, over the time that it takes."""
        pulses = self.pulses
        ends = pulses.ends(pose)
        alone, left = self.costs(), self.left(ends)
        own = alone + self.outside(ends, pulses.spread)
        gain = (left[0] - left) / own
        hopes = own + _HOPED * left
        hopes[0] = gain[0] = -np.inf
        kept = np.argpartition(hopes[1:], min(_KEPT, len(hopes) - 2))[:_KEPT] + 1
        second = pulses.ends(ends[kept])
        both = own[kept, None] + alone + self.outside(second, pulses.spread)
        gain[kept] = np.maximum(gain[kept], ((left[0] - self.left(second)) / both).max(axis=1))
        return gain
