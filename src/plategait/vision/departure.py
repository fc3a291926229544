"""Whether an object stays on its place on the plate, slips away from it, or leaves the plate; and when."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array, Flags
from plategait.curve.protocol import USUAL

# Places are averaged over so long, s, which is some periods of the plate and some frames.
AVERAGED = 0.15
# What is known of the start, s.
START = 0.15
# An object was moving away when it was lost if it had come so far, m, was so fast, m/s, over so long, s.
LEAST_WAY, LEAST_SPEED, LAST = 6e-3, 0.02, 0.35
# Time at the end without it that means that it has gone rather than been hidden, s.
GONE = 0.25


@dataclass(frozen=True)
class Departure:
    """What became of the object.

    Attributes
    ----------
    kind : str
        "slipped", "left the plate", or empty where it stayed or nothing is known.
    time : float
        When it had slipped by the limit, or was last seen, s; NaN where it stayed.
    drift : float
        Farthest that it was seen from where it was at first, m.
    """

    kind: str
    time: float
    drift: float


def departure_of(
    time: Array, place: Array, radius: float, plate: tuple[float, float], limit: float = USUAL.slip_limit
) -> Departure:
    """What became of an object that was seen at these places.

    Parameters
    ----------
    time : (n,) array
        s.
    place : (n, 2) array
        Of its middle on the plate, m; NaN where it was not seen.
    radius : float
        m.
    plate : (length, width)
        m.
    limit : float
        It has slipped once it is so far from where it was, m.
    """
    seen = np.isfinite(place).all(axis=1)
    if seen.sum() < 4:
        return Departure("", math.nan, math.nan)
    t, smooth = time[seen], averaged(time[seen], place[seen])
    start = np.median(smooth[t <= t[0] + START], axis=0)
    moved = np.linalg.norm(smooth - start, axis=1)
    drift = float(moved.max())
    far = moved > limit
    slipped = float(t[np.argmax(far)]) if far.any() else math.nan
    lost = time[-1] - t[-1] > GONE
    if lost and _leaving(t, smooth, start, radius, plate):
        return Departure("left the plate", slipped if far.any() else float(t[-1]), drift)
    return Departure("slipped" if far.any() else "", slipped, drift)


def _leaving(time: Array, place: Array, start: Array, radius: float, plate: tuple[float, float]) -> bool:
    """Whether an object was moving off the plate when it was last seen."""
    last = time >= time[-1] - LAST
    away = place[-1] - start
    if last.sum() < 3 or np.linalg.norm(away) < LEAST_WAY:
        return False
    velocity = np.array([np.polyfit(time[last], place[last, k], 1)[0] for k in range(2)])
    speed = float(np.linalg.norm(velocity))
    # Away from where it was, and its edge over the plate's or soon there.
    beyond = (np.abs(place[-1] + velocity * LAST) + radius > np.array(plate) / 2).any()
    return speed > LEAST_SPEED and float(velocity @ away) > 0.5 * speed * float(np.linalg.norm(away)) and bool(beyond)


def averaged(time: Array, place: Array) -> Array:
    """(n, 2) medians of the places (n, 2) around each time, so that single wrong ones do not count."""
    first, last = np.searchsorted(time, time - AVERAGED / 2), np.searchsorted(time, time + AVERAGED / 2, side="right")
    # At the ends the window stays as wide: a median of few is no more than one of them.
    first = np.minimum(first, np.maximum(last - 3, 0))
    last = np.minimum(np.maximum(last, first + 3), len(time))
    return np.array([np.median(place[a:b], axis=0) for a, b in zip(first, last, strict=True)])


def hidden_after(time: Array, seen: Flags) -> float:
    """When it was last seen, where that was well before the end, s; NaN where it was seen until then."""
    if not seen.any() or time[-1] - time[seen][-1] < GONE:
        return math.nan
    return float(time[seen][-1])
