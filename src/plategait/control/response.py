"""How an object responds to motions of its plate: velocities that depend on where it lies, each reached with a lag.

Over a second and more a motion carries an object at a steady velocity; over the tenths of a second that a controller
deals in, it is still on its way there, and how fast it goes depends on how far from the bar it lies: of each component
of the velocity w' = (V(x, y) - w) / lag, with a polynomial V.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array, Flags

TICK = 1 / 60
"""Time between two decisions, s."""
DELAY = 2
"""Ticks after which a new motion takes hold: about half of the time in which the plate goes over to it."""
STOPPING = 0.05
"""Lag with which an object comes to rest on a plate that stands, s: measured, the same for all motions."""
LONGEST = 24
"""Ticks of the longest pulse that responses are fitted to."""
LENGTH = 0.05
"""Length that places are measured in within polynomials, m."""
ACROSS = ((0, 0), (0, 1), (0, 2), (0, 3), (0, 4))
"""Powers of x and y where nothing changes along the bar, as with a plate that only rocks about it and shakes along it.

Of pulses of 0.4 s a straight line leaves 3.5 mm and 5.4 deg, a parabola 3.0 mm and 2.1 deg, the third power 1.2 mm and
1.6 deg, the fourth 1.0 mm and 0.9 deg (medians over the motions of a menu).
"""
ANYHOW = (*ACROSS, (1, 0), (2, 0), (1, 1), (3, 0), (4, 0))
"""The same of a plate that tilts or turns otherwise too."""


@dataclass(frozen=True)
class Field:
    """Monomials in the place of an object, beyond some reach those of the nearest place within it.

    Attributes
    ----------
    powers : tuple of (int, int)
        Of x and y, the first (0, 0).
    reach : float
        m.
    """

    powers: tuple[tuple[int, int], ...] = ACROSS
    reach: float = math.inf

    def __len__(self) -> int:
        """Return the number of monomials."""
        return len(self.powers)

    def at(self, places: Array) -> Array:
        """(…, p) monomials at places (…, 2)."""
        near = np.minimum(np.maximum(places, -self.reach), self.reach) / LENGTH
        x, y = near[..., 0], near[..., 1]
        monomials = np.empty((*x.shape, len(self.powers)))
        for k, (i, j) in enumerate(self.powers):
            monomials[..., k] = x**i * y**j if i else y**j
        return monomials

    def slopes(self, place: Array) -> Array:
        """(p, 2) how they change with the place, per m."""
        x, y = np.clip(place, -self.reach, self.reach) / LENGTH
        inside = np.abs(place) <= self.reach
        return np.array([(i * x ** max(i - 1, 0) * y**j * inside[0], j * x**i * y ** max(j - 1, 0) * inside[1])
                         for i, j in self.powers]) / LENGTH  # fmt: skip


@dataclass(frozen=True, eq=False)
class Response:
    """How an object responds to m motions, the first of them a plate that stands.

    States are (x, y, angle, and their velocities).

    Attributes
    ----------
    rates : (m, 3, p) array
        Coefficients of each component of the velocity, m/s, m/s, rad/s, in the monomials of the field.
    lags : (m, 3) array
        Lag of each component, s.
    spread : (m, 3) array
        Root mean square of what remains unexplained where a pulse of `LONGEST` ticks ends, m, m, rad.
    failed : (m,) bool array
        Motions with which an object was lost, folded or turned over.
    field : Field
    """

    rates: Array
    lags: Array
    spread: Array
    failed: Flags
    field: Field = Field()

    def __len__(self) -> int:
        """Return the number of motions."""
        return len(self.rates)

    def of(self, which: Sequence[int] | NDArray[np.int64]) -> Response:
        """Response to some of the motions."""
        chosen = np.asarray(which)
        return Response(
            self.rates[chosen], self.lags[chosen], self.spread[chosen], self.failed[chosen], self.field
        )  # fmt: skip

    def step(self, which: int | NDArray[np.int64], states: Array) -> Array:
        """(…, 6) states a tick later, each under its own motion."""
        wanted = (self.rates[which] @ self.field.at(states[..., :2])[..., None])[..., 0]
        velocity = states[..., 3:] + (1 - np.exp(-TICK / self.lags[which])) * (wanted - states[..., 3:])
        return np.concatenate([states[..., :3] + TICK * velocity, velocity], axis=-1)

    def slope(self, motion: int, state: Array) -> Array:
        """(6, 6) how a state a tick later changes with the state now."""
        share = 1 - np.exp(-TICK / self.lags[motion])
        velocity = np.zeros((3, 6))
        velocity[:, :2] = share[:, None] * (self.rates[motion] @ self.field.slopes(state[:2]))
        velocity[:, 3:] = np.diag(1 - share)
        slope = np.concatenate([TICK * velocity, velocity])
        slope[:3, :3] += np.eye(3)
        return slope

    def going(self, which: NDArray[np.int64], states: Array, ticks: int) -> Array:
        """(n, ticks + 1, 3) poses at rest, where motions go on for 0, 1, 2, … ticks more from states (n, 6)."""
        poses = [stopped(states)]
        for _ in range(ticks):
            states = self.step(which, states)
            poses.append(stopped(states))
        return np.stack(poses, axis=1)


def stopped(states: Array) -> Array:
    """(…, 3) poses in which objects come to rest on a plate that stands, from states (…, 6)."""
    left = math.exp(-TICK / STOPPING)
    return states[..., :3] + TICK * left / (1 - left) * states[..., 3:]


def resting(count: int = 1, field: Field = Field()) -> Response:
    """Response to a plate that stands, so many times."""
    return Response(np.zeros((count, 3, len(field))), np.full((count, 3), STOPPING), np.zeros((count, 3)),
                    np.zeros(count, dtype=bool), field)  # fmt: skip


def wrapped(poses: Array) -> Array:
    """Differences of poses (…, 3), whose angles are brought into ±π."""
    angle = np.remainder(poses[..., 2:] + math.pi, 2 * math.pi) - math.pi
    return np.concatenate([poses[..., :2], angle], axis=-1)
