"""Learning an object's response while it is steered: what each pulse did, against what was expected of it."""

from __future__ import annotations

import math

import numpy as np

from plategait.arrays import Array
from plategait.control.response import LONGEST, STOPPING, TICK, Response

# How far another object's rates may be from those of the one that is known: as a share, and m/s, m/s, rad/s.
_SHARE = 0.4
_RATES = np.array([15e-3, 10e-3, math.radians(20)])
# How much of that may go with the first, second, … power of the place.
_POWERS = (1.0, 1.7, 0.5, 0.25, 0.25)
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
        self._lags, self._spread, self._field = response.lags, response.spread, response.field
        self.rates = response.rates.copy()
        floor = _RATES[:, None] * [_POWERS[i + j] for i, j in self._field.powers]
        deviation = _SHARE * np.abs(self.rates) + 0.3 * floor
        self._covariance = np.einsum("mci,ij->mcij", deviation**2, np.eye(len(self._field)))

    def saw(self, motion: int, ticks: int, before: Array, after: Array, noise: Array) -> Array:
        """Take in a pulse; the rates (3, p) of that motion from now on.

        Parameters
        ----------
        motion, ticks : int
        before, after : (3,) arrays
            Pose at rest before it and after it; the angle as it went on.
        noise : (3,) array
            Standard deviation of those.
        """
        where = self._field.at((before[:2] + after[:2]) / 2)
        for c in range(3):
            moved = float(after[c] - before[c])
            effect = where * _gain(ticks, float(self._lags[motion, c]))
            covariance = self._covariance[motion, c] * _FORGETTING
            variance = float(self._spread[motion, c]) ** 2 * ticks / LONGEST + 2 * float(noise[c]) ** 2
            along = covariance @ effect
            gain = along / (float(effect @ along) + variance)
            self.rates[motion, c] += gain * (moved - float(effect @ self.rates[motion, c]))
            self._covariance[motion, c] = covariance - np.outer(gain, along)
        return self.rates[motion].copy()


def _gain(ticks: int, lag: float) -> float:
    """Displacement by a pulse over the velocity that it leads to, s."""
    share = 1 - math.exp(-TICK / lag)
    kept = (1 - share) ** ticks
    going = TICK * (ticks - (1 - share) * (1 - kept) / share)
    stopping = math.exp(-TICK / STOPPING)
    return going + TICK * (1 - kept) * stopping / (1 - stopping)
