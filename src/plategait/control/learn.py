"""Learning an object's response while it is steered: what each pulse did, against what was expected of it."""

from __future__ import annotations

import math

import numpy as np

from plategait.arrays import Array
from plategait.control.response import LONGEST, STOPPING, TICK, Response

# How far another object's rates may be from those of the one that is known: as a share, and m/s, m/s, rad/s.
_SHARE = 0.4
_RATES = np.array([15e-3, 10e-3, math.radians(20)])
# The same of how they change with the place, per m.
_SLOPES = _RATES / 0.03
# By which the uncertainty grows with each pulse, so that what changes is learnt anew.
_FORGETTING = 1.03


class Learner:
    """Recursive least squares on the rates of each motion: a normal prior from the menu, and each pulse as it was.

    Parameters
    ----------
    response : Response
        Of the object that is known; stays as it is.
    """

    def __init__(self, response: Response) -> None:
        self._lags, self._spread = response.lags, response.spread
        self.rates = response.rates.copy()
        floor = np.column_stack([_RATES, _SLOPES, _SLOPES])
        deviation = _SHARE * np.abs(self.rates) + 0.3 * floor
        self._covariance = np.einsum("mci,ij->mcij", deviation**2, np.eye(3))

    def saw(self, motion: int, ticks: int, before: Array, after: Array, noise: Array) -> Array:
        """Take in a pulse; the tick's map of that motion from now on.

        Parameters
        ----------
        motion, ticks : int
        before, after : (3,) arrays
            Pose at rest before it and after it; the angle as it went on.
        noise : (3,) array
            Standard deviation of those.
        """
        middle = (before[:2] + after[:2]) / 2
        where = np.array([1.0, *middle])
        for c in range(3):
            moved = float(after[c] - before[c])
            effect = where * _gain(ticks, float(self._lags[motion, c]))
            covariance = self._covariance[motion, c] * _FORGETTING
            variance = float(self._spread[motion, c]) ** 2 * ticks / LONGEST + 2 * float(noise[c]) ** 2
            along = covariance @ effect
            gain = along / (float(effect @ along) + variance)
            self.rates[motion, c] += gain * (moved - float(effect @ self.rates[motion, c]))
            self._covariance[motion, c] = covariance - np.outer(gain, along)
        return Response(self.rates[motion : motion + 1], self._lags[motion : motion + 1],
                        self._spread[motion : motion + 1], np.zeros(1, dtype=bool)).maps[0]  # fmt: skip


def _gain(ticks: int, lag: float) -> float:
    """Displacement by a pulse over the velocity that it leads to, s."""
    share = 1 - math.exp(-TICK / lag)
    kept = (1 - share) ** ticks
    going = TICK * (ticks - (1 - share) * (1 - kept) / share)
    stopping = math.exp(-TICK / STOPPING)
    return going + TICK * (1 - kept) * stopping / (1 - stopping)
