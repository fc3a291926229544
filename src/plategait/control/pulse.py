"""Pulses: a motion for some ticks and then a plate that stands; where each of them brings an object."""

from __future__ import annotations

import copy

import numpy as np

from plategait.arrays import Array, Flags
from plategait.control.response import LONGEST, TICK, Response

TICKS = (3, 5, 8, 12, 18, 26)
"""Lengths of the pulses that are chosen from."""
PAUSE = 0.2
"""Time between two pulses that is counted, s."""
SHORT = 8
"""Ticks of the pulses by which the rest of a way is counted."""
# Places, in shares of the reach, at which pulses are followed, for what they do between.
_PLACES = np.linspace(-1, 1, 15)


class Pulses:
    """All pulses of a menu, the first of them none, and where they end by the response.

    Attributes
    ----------
    response : Response
    motion, ticks : (k,) int arrays
    times : (k,) array
        s.
    moved : (k, 3, p) array
        Displacement from rest to rest, in the monomials of the response's field.
    spread : (k, 3) array
        Standard deviation of that, m and rad.
    """

    def __init__(self, response: Response) -> None:
        count = len(response)
        self.response = response
        self.motion = np.array([0, *np.repeat(np.arange(1, count), len(TICKS))])
        self.ticks = np.array([0, *np.tile(TICKS, count - 1)])
        self.times = self.ticks * TICK
        self.spread = response.spread[self.motion] * np.sqrt(self.ticks / LONGEST)[:, None]
        self.moved = np.zeros((len(self.ticks), 3, len(response.field)))
        field = response.field
        along = _PLACES if any(i for i, _ in field.powers) else np.zeros(1)
        x, y = np.meshgrid(along, _PLACES)
        self._places = (field.reach if np.isfinite(field.reach) else 0.05) * np.column_stack([x.ravel(), y.ravel()])
        self._explain = np.linalg.pinv(field.at(self._places))
        for motion in range(1, count):
            self._follow(motion)

    def learnt(self, motion: int, rates: Array) -> Pulses:
        """These pulses by other rates (3, p) of one motion."""
        other, known = copy.copy(self), self.response
        changed = known.rates.copy()
        changed[motion] = rates
        other.response = Response(changed, known.lags, known.spread, known.failed, known.field)
        other.moved = self.moved.copy()
        other._follow(motion)
        return other

    def _follow(self, motion: int) -> None:
        states = np.concatenate([self._places, np.zeros((len(self._places), 4))], axis=1)
        ends = self.response.going(np.full(len(states), motion), states, max(TICKS))[:, TICKS] - states[:, None, :3]
        self.moved[self.motion == motion] = np.einsum("pn,ntc->tcp", self._explain, ends)

    def ends(self, poses: Array) -> Array:
        """(…, k, 3) poses after each pulse, from rest at poses (…, 3)."""
        moved = self.response.field.at(poses[..., :2]) @ self.moved.reshape(-1, self.moved.shape[2]).T
        return poses[..., None, :] + moved.reshape(*poses.shape[:-1], -1, 3)

    def at(self, place: Array) -> Array:
        """(k, 3) displacement by each pulse from rest at a place (x, y)."""
        return self.moved @ self.response.field.at(place)

    @property
    def short(self) -> Flags:
        """(k,) pulses by which the rest of a way is counted."""
        return self.ticks == SHORT

    def going(self, motion: int, state: Array, ticks: int) -> Array:
        """(ticks + 1, 3) poses at rest, where a motion goes on for 0, 1, 2, … ticks more."""
        return self.response.going(np.array([motion]), state[None], ticks)[0]
