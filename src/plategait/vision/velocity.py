"""How fast an object wanders over the plate, from where it was seen frame by frame."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array
from plategait.vision.spin import FEWEST_SURE, SWING, fitted, swing_seen, uncertainty

# Swing of a place within a plate period that the interval is widened for where it cannot be seen, m.
UNSEEN_SWING = 1e-3
# Half of 95 % of a normal distribution, in standard deviations.
HALF_95 = 1.96
# Frames around each that its own velocity is taken from: at least, and s.
LEAST_AROUND, AROUND = 7, 0.3


@dataclass(frozen=True)
class Velocity:
    """Mean velocity along x and y on the plate, m/s, each with half its 95 % interval; NaN where it is not known."""

    x: float
    y: float
    x_half: float
    y_half: float


UNKNOWN = Velocity(math.nan, math.nan, math.nan, math.nan)


def velocity_of(time: Array, place: Array, plate_frequency: float | None, fps: float) -> Velocity:
    """Mean velocity of a place (n, 2), m, seen at these times (n,), s; the plate's swing does not count.

    The interval comes from blocks of time, as that of the spin rate does.
    """
    seen = np.isfinite(place).all(axis=1)
    if seen.sum() < FEWEST_SURE:
        return UNKNOWN
    t, part = time[seen], np.zeros(int(seen.sum()), dtype=np.intp)
    swing, margin = swing_seen(plate_frequency, fps, float(np.ptp(t)), [])
    rates = []
    for line in place[seen].T:
        smooth, slope = fitted(t, line, part, swing)
        half = uncertainty(t, smooth, part, slope)[0] + margin / SWING * UNSEEN_SWING
        rates.append((slope, half) if math.isfinite(half) else (math.nan, math.nan))
    (x, x_half), (y, y_half) = rates
    return Velocity(x, y, x_half, y_half)


def local_velocity(time: Array, values: Array) -> tuple[Array, Array]:
    """(n,) slope of values (n,) over time around each, and half its 95 % interval; NaN where too few are seen."""
    slope, half = np.full(len(time), math.nan), np.full(len(time), math.nan)
    seen = np.nonzero(np.isfinite(values))[0]
    for k in seen:
        near = seen[np.abs(time[seen] - time[k]) <= AROUND / 2]
        if len(near) < LEAST_AROUND:
            continue
        t = time[near] - time[near].mean()
        square = float(t @ t)
        slope[k] = float(t @ values[near]) / square
        residual = values[near] - values[near].mean() - slope[k] * t
        half[k] = HALF_95 * math.sqrt(float(residual @ residual) / (len(near) - 2) / square)
    return slope, half
