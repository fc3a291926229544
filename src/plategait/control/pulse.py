"""Pulses: a motion for some ticks and then a plate that stands; where each of them brings an object."""

from __future__ import annotations

import numpy as np

from plategait.arrays import Array
from plategait.control.response import DELAY, LONGEST, TAIL, TICK, Response, resting

TICKS = (4, 6, 9, 13, 20, 30)
"""Lengths of the pulses that are chosen from."""
SHORT = 6
"""Ticks of the pulses by which the rest of a way is counted."""
_MOST = 36
_STOP = np.linalg.matrix_power(resting().maps[0], TAIL + DELAY)


class Pulses:
    """All pulses of a menu, the first of them none, and where they end by the response.

    Attributes
    ----------
    motion, ticks : (k,) int arrays
    times : (k,) array
        s.
    ends : (k, 3, 7) array
        Pose after each, at rest, of (1, pose, velocity) before.
    spread : (k, 3) array
        Standard deviation of that, m and rad.
    """

    def __init__(self, response: Response) -> None:
        count = len(response)
        self.motion = np.array([0, *np.repeat(np.arange(1, count), len(TICKS))])
        self.ticks = np.array([0, *np.tile(TICKS, count - 1)])
        self.times = self.ticks * TICK
        self.spread = response.spread[self.motion] * np.sqrt(self.ticks / LONGEST)[:, None]
        self.ends = np.zeros((len(self.ticks), 3, 7))
        self.ends[0] = _STOP[1:4]
        self._going = np.zeros((count, _MOST + 1, 3, 7))
        for motion, map_ in enumerate(response.maps):
            self.learnt(motion, map_)

    def copy(self) -> Pulses:
        """The same pulses, to learn apart."""
        other = Pulses.__new__(Pulses)
        other.__dict__.update(self.__dict__)
        other.ends, other._going = self.ends.copy(), self._going.copy()
        return other

    def learnt(self, motion: int, map_: Array) -> None:
        """Take another response to one motion."""
        power = np.eye(7)
        for ticks in range(_MOST + 1):
            self._going[motion, ticks] = (_STOP @ power)[1:4]
            power = map_ @ power
        if motion:
            own = self.motion == motion
            self.ends[own] = self._going[motion, self.ticks[own]]

    def going(self, motion: int, state: Array) -> Array:
        """(ticks + 1, 3) poses at rest, where a motion goes on for 0, 1, 2, … ticks more."""
        return self._going[motion] @ state

    def short(self, place: Array) -> tuple[Array, Array]:
        """Displacements (n, 3) by short pulses from rest at a place (x, y), and their times (n,)."""
        state = np.array([1.0, *place, 0.0, 0.0, 0.0, 0.0])
        chosen = self.ticks == SHORT
        return self.ends[chosen] @ state - state[1:4], self.times[chosen]
