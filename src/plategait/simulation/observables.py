"""What a motion shows: spin rate, gait, failure, drift, contact, bending. Energy is in `plategait.simulation.energy`.

All take plain arrays of samples, so simulated runs and tracked videos go through the same code.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.shown import Shown

GAITS = ("sliding", "walking", "running")
FAILURES = ("slipped", "turned over", "folded", "left the plate", "diverged")

# A leg counts as off the plate in a period when it is so for longer than this share of it: shorter than that is one
# integration step's rattle, not a stride.
SHORTEST_STRIDE = 0.01
# A sheet is folded when its halves hide this much of its area from its own mean plane.
FOLDED_AREA = 0.5
# Centre this far below the plate's surface, m: no sheet that the plate carries lies so deep in it.
HANGING_DEPTH = 1e-3
# Blocks of whole periods that the spin rate's interval is made from.
BLOCKS = 8
# A run has settled when its two halves agree within this share, or within this rate.
SETTLED_SHARE = 0.05
SETTLED_RATE = math.radians(2)


@dataclass(frozen=True)
class SpinRate:
    """Mean angular velocity about the plate's normal, counter-clockwise positive.

    Attributes
    ----------
    rate, low, high : float
        Rate and its 95 % interval, rad/s; NaN when there was too little to measure.
    settled : bool
        Whether the two halves of what was measured agree.
    sd : float
        Standard deviation of the rate over blocks of whole periods, rad/s.
    """

    rate: float
    low: float
    high: float
    settled: bool
    sd: float = math.nan


@dataclass(frozen=True)
class Failure:
    """How a run failed, and when (s).

    Attributes
    ----------
    kind : str
        One of `FAILURES`.
    time : float
        When, s.
    first_sign : float, optional
        When anything first went wrong, s, where that was before: a sheet that falls off the plate has slipped on its
        way. What a run shows is measured up to there.
    """

    kind: str
    time: float
    first_sign: float = math.inf

    @property
    def sound_until(self) -> float:
        """End of what can be measured, s."""
        return min(self.time, self.first_sign)


def rotation(cross: Array, dot: Array) -> Array:
    """Unwrapped best-fit rotation in the plate frame, rad.

    Parameters
    ----------
    cross, dot : (n,) arrays
        Sums over the nodes of X0 × p and X0 · p, with X0 the rest and p the present position in the plate's plane: the
        angle between them is the least-squares rotation.
    """
    return np.unwrap(np.arctan2(cross, dot))


def spin_rate(time: Array, angle: Array, period: float, start: float, end: float) -> SpinRate:
    """Turn over whole plate periods between two times, over the time they take.

    Over whole periods the swing within them cancels exactly, which it does not in a fitted slope. The interval comes
    from up to eight blocks of whole periods, whose rates need not be independent of the swing, only of each other.
    Fewer than two whole periods give NaN.

    Parameters
    ----------
    time, angle : (n,) arrays
        s and rad.
    period, start, end : float
        Plate period and the window to measure in, s; its last whole periods count.
    """
    periods = math.floor((end - start) / period + 1e-6)
    if periods < 2 or len(time) < 4:
        return SpinRate(math.nan, math.nan, math.nan, False)
    start = end - periods * period
    blocks = min(BLOCKS, periods)
    edges = start + period * np.round(np.linspace(0, periods, blocks + 1))
    slopes, weights = np.diff(np.interp(edges, time, angle)) / np.diff(edges), np.diff(edges)
    rate = float(np.average(slopes, weights=weights))
    spread = math.sqrt(float(np.average((slopes - rate) ** 2, weights=weights)) * blocks / (blocks - 1))
    half = student_95(blocks - 1) * spread / math.sqrt(blocks)
    # The first and the last whole periods, as many as half the window holds.
    span = periods // 2 * period
    first, last = (float(np.diff(np.interp([a, a + span], time, angle))[0]) / span for a in (start, end - span))
    settled = abs(last - first) <= max(SETTLED_SHARE * abs(rate), SETTLED_RATE)
    return SpinRate(rate, rate - half, rate + half, settled, spread)


@dataclass(frozen=True, eq=False, repr=False)
class Twist(Shown):
    """Mean velocity in the plate's plane, and how it differs from stride to stride.

    Attributes
    ----------
    mean : (3,) array
        Along the bar and across it, m/s, and turning, rad/s, counter-clockwise positive; NaN when there was too little
        to measure.
    covariance : (3, 3) array
        Of the means over each stride, one plate period.
    """

    mean: Array
    covariance: Array


def twist(time: Array, moves: Array, period: float, start: float, end: float) -> Twist:
    """Way over whole plate periods between two times, over the time that they take; fewer than two give NaN.

    Parameters
    ----------
    time : (n,) array
        s.
    moves : (3, n) array
        Centre along and across the bar, m, and unwrapped rotation, rad, in the plate's frame.
    period, start, end : float
        Plate period and the window to measure in, s; its last whole periods count.
    """
    periods = math.floor((end - start) / period + 1e-6)
    if periods < 2 or len(time) < 4:
        return Twist(np.full(3, math.nan), np.full((3, 3), math.nan))
    edges = end - period * np.arange(periods, -1, -1)
    strides = np.diff([np.interp(edges, time, move) for move in moves]) / np.diff(edges)
    return Twist(strides.mean(axis=1), np.cov(strides))


def student_95(freedom: int) -> float:
    """Student's t, 97.5 % point, within 0.2 % (scipy.stats takes half a second to import)."""
    if freedom < len(_STUDENT_95):
        return _STUDENT_95[freedom]
    # Cornish–Fisher expansion about the normal point 1.95996.
    return 1.95996 + 2.37227 / freedom + 2.8225 / freedom**2


_STUDENT_95 = (math.inf, 12.7062, 4.30265, 3.18245, 2.77645, 2.57058, 2.44691, 2.36462)


def period_means(time: Array, values: Array, period: float, start: float, end: float) -> Array:
    """(n_periods, …) means of samples over each whole plate period between two times."""
    index = np.floor((time - start) / period - 1e-9).astype(int)
    count = math.floor((end - start) / period + 1e-6)
    within = (time > start) & (index >= 0) & (index < count)
    sums = np.zeros((count, *values.shape[1:]))
    np.add.at(sums, index[within], values[within])
    return sums / np.maximum(np.bincount(index[within], minlength=count), 1).reshape(-1, *([1] * (values.ndim - 1)))


def period_maxima(time: Array, values: Array, period: float, start: float, end: float) -> Array:
    """(n_periods,) largest of the samples of each whole plate period between two times; NaN where one has none."""
    index = np.floor((time - start) / period - 1e-9).astype(int)
    count = math.floor((end - start) / period + 1e-6)
    within = (time > start) & (index >= 0) & (index < count)
    largest = np.full(count, -math.inf)
    np.maximum.at(largest, index[within], values[within])
    return np.where(np.isfinite(largest), largest, math.nan)


def gait(left: Array, right: Array, flight: Array) -> str:
    """Gait by the dissertation's definition (section 4.3), from each whole period's means.

    The legs are the halves of the object left and right of the bar axis where they are now. Sliding: both touch all the
    time. Walking: at least one does. Running: both are off the plate at some time. The gait of most periods is the
    run's.

    Parameters
    ----------
    left, right, flight : (n_periods,) arrays
        Share of each period in which the left leg touches, the right leg touches, nothing touches.
    """
    if len(flight) == 0:
        return ""
    runs = flight > SHORTEST_STRIDE
    walks = ~runs & (np.minimum(left, right) < 1 - SHORTEST_STRIDE)
    counts = [np.sum(~runs & ~walks), np.sum(walks), np.sum(runs)]
    return GAITS[int(np.argmax(counts))]


def slip(time: Array, x: Array, y: Array, period: float) -> Array:
    """Distance of the centre, averaged over the plate period around each time, from where it lay at first, m.

    The averaging takes out the centre's swing within each period, which is part of every gait.
    """
    n = len(time)
    if n < 2:
        return np.hypot(x - x[0], y - y[0])
    half = round(min(period / (time[1] - time[0]) / 2, n))
    # Near the ends the window shrinks to both sides alike, so that no time sees what comes later than its period.
    reach = np.minimum(half, np.minimum(np.arange(n), np.arange(n)[::-1]))
    after, before = np.arange(n) + reach + 1, np.arange(n) - reach

    def smooth(values: Array) -> Array:
        sums = np.concatenate([[0.0], np.cumsum(values)])
        return (sums[after] - sums[before]) / (after - before)

    return np.hypot(smooth(x) - x[0], smooth(y) - y[0])


def first_failure(
    channels: Mapping[str, Array],
    period: float,
    slip_limit: float,
    plate_size: tuple[float, float] | None = None,
    diverged: bool = False,
) -> Failure | None:
    """First thing that went wrong in a run, or None.

    Failed are: the centre slipped further than the limit, or the sheet turned over (the dissertation's two, section
    4.3); also a sheet that folded, left the plate, or ceased to be finite. A sheet has left the plate once its centre
    is beyond the edge, or once it folds or turns over hanging from it; one that slips first, on its way off, is told by
    where it ended, with the slip as the first sign.

    Parameters
    ----------
    channels : mapping
        ``time``, ``centre_x``, ``centre_y`` (plate frame) and, where known, the area vector ``area_x/y/z`` over the
        area at rest; whatever else it holds must be finite too.
    period, slip_limit : float
        s and m.
    plate_size : (length, width), optional
        m.
    diverged : bool
        Whether the recording ends because the motion ceased to be finite.
    """
    time, x, y = channels["time"], channels["centre_x"], channels["centre_y"]
    # Squares, such as an energy, cease to be finite before the centre does.
    finite = np.all([np.isfinite(values) for values in channels.values()], axis=0)
    last = int(np.argmin(finite)) if not finite.all() else len(time)
    signs: list[tuple[str, NDArray[np.bool_]]] = []
    if last > 0:
        # The swing of the last half period is not averaged out: it may look like a slip.
        averaged = (time[:last] <= time[last - 1] - period / 2) | (time[last - 1] < period)
        signs.append(("slipped", averaged & (slip(time[:last], x[:last], y[:last], period) > slip_limit)))
    beyond = hanging = np.zeros(last, dtype=bool)
    if plate_size is not None:
        beyond = (np.abs(x[:last]) > plate_size[0] / 2) | (np.abs(y[:last]) > plate_size[1] / 2)
        if "centre_z" in channels:
            hanging = channels["centre_z"][:last] < -HANGING_DEPTH
    if "area_z" in channels and channels["area_z"][0] > 0:
        area = np.stack([channels[f"area_{axis}"][:last] for axis in "xyz"])
        size = np.linalg.norm(area, axis=0)
        folded, over = size < FOLDED_AREA, (size >= FOLDED_AREA) & (area[2] < 0)
        beyond = beyond | (hanging & (folded | over))
        signs += [("folded", folded & ~hanging), ("turned over", over & ~hanging)]
    signs.append(("left the plate", beyond))
    failures = [Failure(kind, float(time[np.argmax(sign)])) for kind, sign in signs if sign.any()]
    if diverged or last < len(time):
        failures.append(Failure("diverged", float(time[max(last - 1, 0)])))
    first = min(failures, key=lambda failure: failure.time, default=None)
    if first is not None and first.kind == "slipped":
        return next((replace(f, first_sign=first.time) for f in failures if f.kind == "left the plate"), first)
    return first
