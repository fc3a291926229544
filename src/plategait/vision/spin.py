"""From angles seen frame by frame to a spin rate: what a camera's frames can tell, and what they cannot.

An orientation is known up to a whole turn (or the part of one after which the object looks the same), and only at the
frames. Rates that differ by a turn per frame are therefore one to the camera, and a plate that swings near a multiple
of the frame rate makes the object's swing look slow.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array, Flags
from plategait.simulation.observables import BLOCKS, SETTLED_RATE, SETTLED_SHARE, student_95

# Fewest sure frames, and the least share of all, that a rate is given for.
FEWEST_SURE, LEAST_SHARE = 12, 0.2
# Least agreement of the steps from frame to frame (length of their mean direction) that can be followed.
LEAST_AGREEMENT = 0.6
# A rate that fits the steps this much less well than the best is told apart from it.
DISTINGUISHABLE = 0.95
# A turn between frames above this share of half of what the eye can tell may be a turn the other way.
MOST_TURN = 0.85
# Steps, before and after, that predict the turn across a gap; how much the rate may change over it; most doubt.
NEIGHBOURS, RATE_CHANGE, MOST_DOUBT = 15, 0.15, 0.6 * math.pi
# Swing of the object within a plate period that the interval is widened for where it cannot be seen, rad.
SWING = math.radians(5)
# Widest half interval of a rate: as a share of it, or rad/s.
MOST_HALF, MOST_HALF_RATE = 0.3, math.radians(20)
# A frame is an outlier by this many times the usual scatter about its neighbours, and by no less than this angle, rad.
OUTLIER_FACTOR, OUTLIER, OUTLIER_NEIGHBOURS = 6.0, math.radians(6), 5
# Sure frames in a block of time, at least on average.
FRAMES_PER_BLOCK = 6
# Steps that the search for the rate looks at, and Huber's constant for robust fits.
MOST_STEPS, HUBER = 4000, 1.345


@dataclass(frozen=True)
class Spin:
    """Spin rate from sure frames, counter-clockwise positive.

    Attributes
    ----------
    rate, low, high : float
        Rate and its 95 % interval, rad/s; NaN where the frames do not determine it.
    settled : bool
        Whether the two halves of what was measured agree.
    sd : float
        Standard deviation of the rate over blocks of time, rad/s.
    aliases : tuple of float
        Other rates that these frames cannot tell from this one, rad/s, nearest first.
    reason : str
        Why there is no rate; empty where there is one.
    notes : tuple of str
        What to know about the rate.
    """

    rate: float
    low: float
    high: float
    settled: bool
    sd: float
    aliases: tuple[float, ...] = ()
    reason: str = ""
    notes: tuple[str, ...] = ()


def apparent_frequency(frequency: float, fps: float) -> float:
    """Frequency as which a camera of `fps` frames per second shows a swing at `frequency`, both Hz: at most fps / 2."""
    rest = frequency % fps
    return min(rest, fps - rest)


def spin_of(
    time: Array,
    angle: Array,
    sure: Flags,
    *,
    symmetry: int = 1,
    fps: float | None = None,
    plate_frequency: float | None = None,
) -> Spin:
    """Spin rate with its interval from orientations seen in single frames.

    The steps between neighbouring sure frames give the rate that makes most of them agree; with it the angles are
    joined to one line, also over gaps that are short enough; a robust line through them, with the swing at the plate's
    frequency beside it, is the rate. The interval comes from blocks of time, as in `observables.spin_rate`.

    Parameters
    ----------
    time, angle : (n,) arrays
        s and rad; angles count modulo a turn over `symmetry`.
    sure : (n,) bool array
        Frames to use.
    symmetry : int
        Turns of a full circle over this look the same.
    fps : float, optional
        Frames per second; from the times by default.
    plate_frequency : float, optional
        Of the plate, Hz, as it is or as the camera sees it.
    """
    share = float(sure.mean()) if len(sure) else 0.0
    if len(sure) < FEWEST_SURE:
        return _no_rate(f"only {len(sure)} frames, and a rate takes {FEWEST_SURE}")
    if sure.sum() < FEWEST_SURE or share < LEAST_SHARE:
        return _no_rate(f"only {int(sure.sum())} of {len(sure)} frames are sure")
    t, phase = time[sure], symmetry * angle[sure]
    rate, agreement, rivals = rate_of_steps(np.diff(t), np.diff(phase))
    if agreement < LEAST_AGREEMENT:
        return _no_rate("the object turns too differently from frame to frame to be followed")
    base = _frame_interval(np.diff(t))
    if abs(rate) * base > MOST_TURN * math.pi:
        return _no_rate("the object turns so far between frames that it may turn either way")
    line, part = unwrapped(t, phase, rate)
    line = line / symmetry
    notes = []
    if part[-1] > 0:
        notes.append(f"turns may be missed over {part[-1]} gaps; the rate is that of the parts between them")
    swing, margin = swing_seen(plate_frequency, fps or 1 / base, float(t[-1] - t[0]), notes)
    smooth, slope = fitted(t, line, part, swing)
    if abs(slope - rate / symmetry) > max(0.25 * abs(rate) / symmetry, 0.3 * math.pi / base / symmetry):
        return _no_rate("the steps between frames and the whole clip give two different rates")
    half, spread = uncertainty(t, smooth, part, slope)
    if math.isnan(half):
        return _no_rate("too short for an interval")
    half += margin
    if half > max(MOST_HALF * abs(slope), MOST_HALF_RATE):
        return _no_rate(f"the rate scatters by {math.degrees(half):.0f} deg/s about {math.degrees(slope):.0f} deg/s")
    aliases = tuple(slope + (r - rate) / symmetry for r in rivals)
    settled = _settled(t, smooth, part, max(SETTLED_SHARE * abs(slope), SETTLED_RATE, 2 * half))
    return Spin(slope, slope - half, slope + half, settled, spread, aliases, "", tuple(notes))


def rate_of_steps(interval: Array, step: Array) -> tuple[float, float, tuple[float, ...]]:
    """Rate that most steps agree on, how well they do (1: fully), and the rates that fit as well, nearest first.

    Parameters
    ----------
    interval, step : (n,) arrays
        Time, s, and turn, rad up to whole circles, between neighbouring sure frames.
    """
    if len(step) > MOST_STEPS:
        few = np.linspace(0, len(step) - 1, MOST_STEPS).astype(int)
        interval, step = interval[few], step[few]
    base = _frame_interval(interval)
    # Long gaps make narrow peaks, which a changing rate would smear: they tell nothing here.
    near = interval < 3.5 * base
    interval, step = interval[near], step[near]
    spacing = 2 * math.pi / base
    grid = np.linspace(-1.5, 1.5, 601) * spacing  # half a turn per frame, and a whole one on either side of it
    fits = np.array([np.mean(np.cos(step - w * interval)) for w in grid])
    slow = np.abs(grid) <= 0.5001 * spacing
    best = float(grid[slow][np.argmax(fits[slow])])
    best += float(np.median(_wrapped(step - best * interval) / interval))
    agreement = float(abs(np.mean(np.exp(1j * (step - best * interval)))))
    rivals = [best + k * spacing for k in (-1, 1)]
    fit = [float(np.mean(np.cos(step - w * interval))) for w in (best, *rivals)]
    return best, agreement, tuple(w for w, f in zip(rivals, fit[1:], strict=True) if f > DISTINGUISHABLE * fit[0])


def unwrapped(time: Array, phase: Array, rate: float) -> tuple[Array, NDArray[np.intp]]:
    """Angles without their jumps by whole circles, and the number of the part that each belongs to.

    A step is predicted from its neighbours' rate. Where it lasts so long that the prediction may be half a turn off,
    a new part begins, whose turns to the one before are unknown.
    """
    interval = np.diff(time)
    base = _frame_interval(interval)
    error = _wrapped(np.diff(phase) - rate * interval)
    close = interval < 2.5 * base
    excess = np.where(close, error / interval, np.nan)
    local, spread = np.empty_like(error), np.empty_like(error)
    for k in range(len(error)):
        around = excess[max(0, k - NEIGHBOURS) : k + NEIGHBOURS + 1]
        around = around[np.isfinite(around)]
        local[k] = np.median(around) if len(around) else 0.0
        spread[k] = 1.48 * np.median(np.abs(around - local[k])) * base if len(around) else math.pi
    predicted = (rate + local) * interval
    step = predicted + _wrapped(np.diff(phase) - predicted)
    doubt = 2 * spread + np.where(close, 0.0, RATE_CHANGE * np.abs(rate + local) * interval)
    breaks = doubt > np.where(close, math.pi, MOST_DOUBT)
    part = np.concatenate([[0], np.cumsum(breaks)])
    return phase[0] + np.concatenate([[0.0], np.cumsum(step)]), part


def outliers(time: Array, angle: Array, part: NDArray[np.intp], plate_frequency: float | None, fps: float) -> Flags:
    """Frames whose angle, joined to a line, is far out of line with those around it: wrongly seen."""
    swing = swing_seen(plate_frequency, fps, float(np.ptp(time)), [])[0]
    smooth, slope = fitted(time, angle, part, swing)
    off = smooth - slope * time
    padded = np.pad(off, OUTLIER_NEIGHBOURS, mode="reflect")
    local = np.median(np.lib.stride_tricks.sliding_window_view(padded, 2 * OUTLIER_NEIGHBOURS + 1), axis=1)
    off = np.abs(off - local)
    return off > max(OUTLIER_FACTOR * 1.48 * float(np.median(off)), OUTLIER)


def fitted(time: Array, angle: Array, part: NDArray[np.intp], swing: tuple[float, ...]) -> tuple[Array, float]:
    """Angles less the swing, rad, and the robust slope of their line, rad/s; each part has its own height.

    Huber's weights, five rounds; the swing is a sine and cosine at each frequency of `swing`, Hz.
    """
    middle = time.mean()
    _, part = np.unique(part, return_inverse=True)
    columns = [time - middle] + [np.asarray(part == k, dtype=float) for k in range(part.max() + 1)]
    waves = [wave(2 * math.pi * f * time) for f in swing for wave in (np.cos, np.sin)]
    A = np.column_stack(columns + waves)
    weight = np.ones(len(time))
    solution = np.zeros(A.shape[1])
    for _ in range(5):
        root = np.sqrt(weight)
        solution = np.linalg.lstsq(A * root[:, None], angle * root, rcond=None)[0]
        residual = np.abs(angle - A @ solution)
        scale = 1.48 * float(np.median(residual))
        if scale < 1e-9:
            break
        weight = np.minimum(1.0, HUBER * scale / np.maximum(residual, 1e-12))
    waved = A[:, len(columns) :] @ solution[len(columns) :]
    return angle - waved, float(solution[0])


def swing_seen(
    frequency: float | None, fps: float, duration: float, notes: list[str]
) -> tuple[tuple[float, ...], float]:
    """Frequencies, Hz, of the swing that can be fitted, and what the rest of it may do to the rate, rad/s."""
    if frequency is None:
        return (), 0.0
    frequencies: list[float] = []
    margin = 0.0
    for order in (1, 2):
        f = apparent_frequency(order * frequency, fps)
        beats = f * duration
        if beats >= 1.0:
            # Two of one frequency, or one at half the frame rate, cannot be told apart from each other.
            if all(abs(f - g) * duration >= 1.0 for g in frequencies) and (fps / 2 - f) * duration >= 0.5:
                frequencies.append(f)
        else:
            bias = SWING / order * min(2 * math.pi * f, 4 / duration)
            if bias > 0.0 and beats > 1e-3:
                name = "the plate" if order == 1 else "twice the plate's frequency"
                notes.append(
                    f"{name} is near a multiple of the frame rate: a swing is seen as one of {f:.3g} Hz, slower than "
                    f"the clip lasts; the interval is wider for it"
                )
            margin += bias
    return tuple(frequencies), margin


def uncertainty(time: Array, angle: Array, part: NDArray[np.intp], slope: float) -> tuple[float, float]:
    """Half the 95 % interval of a slope by those of blocks of time, and their spread, rad/s; NaN for too few blocks."""
    slopes, weights = _block_slopes(time, angle, part)
    n = len(slopes)
    if n < 2:
        return math.nan, math.nan
    spread = math.sqrt(float(np.average((slopes - slope) ** 2, weights=weights)) * n / (n - 1))
    return student_95(n - 1) * spread / math.sqrt(n), spread


def _settled(time: Array, angle: Array, part: NDArray[np.intp], tolerance: float) -> bool:
    """Whether the slopes of both halves agree within a tolerance, rad/s."""
    first = time < (time[0] + time[-1]) / 2
    if min(np.sum(first), np.sum(~first)) < 3:
        return False
    before, after = (fitted(time[half], angle[half], part[half], ())[1] for half in (first, ~first))
    return abs(after - before) <= tolerance


def _block_slopes(time: Array, angle: Array, part: NDArray[np.intp]) -> tuple[Array, Array]:
    """Slope of each of up to eight equal spans of time, rad/s, and the sure time in each, s."""
    blocks = int(np.clip(len(time) // FRAMES_PER_BLOCK, 2, BLOCKS))
    edges = np.linspace(time[0], time[-1] + 1e-9, blocks + 1)
    slopes, weights = [], []
    for a, b in pairwise(edges):
        own = (time >= a) & (time < b)
        if own.sum() < 4 or np.ptp(time[own]) < 0.3 * (b - a):
            continue
        try:
            slope = fitted(time[own], angle[own], part[own], ())[1]
        except np.linalg.LinAlgError:
            continue
        slopes.append(slope)
        weights.append(float(np.ptp(time[own])))
    return np.array(slopes), np.array(weights)


def _frame_interval(interval: Array) -> float:
    """Shortest usual time between neighbouring sure frames, s."""
    ordered = np.sort(interval)
    return float(ordered[len(ordered) // 10])


def _wrapped(angle: Array) -> Array:
    return (angle + math.pi) % (2 * math.pi) - math.pi


def _no_rate(reason: str) -> Spin:
    return Spin(math.nan, math.nan, math.nan, False, math.nan, (), reason)
