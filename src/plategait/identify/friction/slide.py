"""One object on a plate that is slowly tilted: at rest, then sliding, as one model fitted to the recorded positions.

The plate turns so slowly that the object obeys s'' = g (sin θ - μ_k cos θ) along the plate from the moment t_s at which
it begins to slip, and rests before. What the turning adds (the centrifugal s θ'² and, through the normal force,
2 μ_k s' θ') is left out: it is under 1 % of the acceleration at 2 deg/s, and grows with the rate.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from plategait.arrays import Array
from plategait.identify.friction.recording import Tilt, noise_of
from plategait.identify.series import structure
from plategait.theory.rigid import GRAVITY

CONFIDENCE = 0.95
_SPEED_WINDOW = 0.15  # s, over which a speed is taken
_SIGNIFICANT = 5.0  # sds: no chance among thousands of windows
_LEAST_SPEED = 2e-3  # m/s: slower is creep
_LEAST_TRAVEL = 1e-3  # m: shorter is a twitch
_STOPPED = 0.7  # share of the largest speed below which the object was held up
_GRID = 60  # slip times tried at once
_ROUNDS = 12  # of ever finer grids at most


class Stretch(NamedTuple):
    """Rows of a slide, the last one not included."""

    first: int
    end: int


class Range(NamedTuple):
    """A value and the ends of its 95 % interval."""

    value: float
    low: float
    high: float


def find_slides(time: Array, position: Array) -> list[Stretch]:
    """Stretches in which the object moves faster than noise and creep, each up to where it is fastest.

    What follows the largest speed (a stop, the end of the plate) belongs to no slide.

    Parameters
    ----------
    time, position : (n,) arrays
        s and m.
    """
    interval = float(np.median(np.diff(time)))
    half = min(max(2, round(_SPEED_WINDOW / interval / 2)), (len(time) - 1) // 2)
    if half < 1:
        return []
    # Slope of the straight line through each window of 2 half + 1 rows.
    weights = np.arange(-half, half + 1.0)
    speed = np.abs(np.correlate(position, weights, "same")) / (interval * (weights @ weights))
    speed[:half], speed[-half:] = speed[half], speed[-half - 1]
    noise = noise_of(position)
    fast = speed > max(_SIGNIFICANT * noise / (interval * np.sqrt(weights @ weights)), _LEAST_SPEED)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], fast, [False]]).astype(int)))
    slides = []
    for first, end in zip(edges[::2], edges[1::2], strict=True):
        top = first + int(np.argmax(speed[first:end]))
        held_up = bool(np.any(speed[top:] < _STOPPED * speed[top]))
        last = top + 1 if held_up else min(top + half + 1, len(time))
        if abs(position[end - 1] - position[first]) > max(_SIGNIFICANT * noise, _LEAST_TRAVEL):
            slides.append(Stretch(int(first), int(last)))
    return slides


@dataclass(frozen=True, eq=False)
class SlideFit:
    """The model of rest and slide, fitted.

    Attributes
    ----------
    slip_time : Range or None
        t_s, s; None where the object was already moving in the first row.
    slip_angle : Range or None
        α = θ(t_s), rad.
    kinetic : Range
        μ_k; its interval is wide where the slide is too short to tell.
    rate : float
        How fast the plate turned when it slipped, rad/s.
    at_bound : bool
        Whether μ_k was held at tan α, above which nothing would have begun to slide.
    noise : float
        Sd of what the model leaves, m.
    structure : float
        Correlation of neighbouring residuals; white noise has 0.
    fitted : (n,) array
        Positions of the model, m.
    """

    slip_time: Range | None
    slip_angle: Range | None
    kinetic: Range
    rate: float
    at_bound: bool
    noise: float
    structure: float
    fitted: Array


class _Trial(NamedTuple):
    """Best fit for one slip time."""

    squares: float
    kinetic: float
    curvature: float
    bound: bool
    fitted: Array


def _at_rest(time: Array, moving: bool) -> Array:
    """(n, 1 or 2) orthonormal columns of what goes on without the slide: a place, and an even speed if it moves."""
    columns = [np.ones_like(time)] + [time - time.mean()] * moving
    return np.stack([c / np.sqrt(c @ c) for c in columns], axis=1)


def _solve(tilt: Tilt, position: Array, basis: Array, slip_time: float, bounded: bool) -> _Trial:
    """Least squares of position = basis + g (∬sin θ - μ_k ∬cos θ) for μ_k, at most tan θ(t_s) if bounded."""
    sine, cosine = tilt.travel(slip_time)

    def rest(y: Array) -> Array:
        return y - basis @ (basis.T @ y)

    column, target = rest(-GRAVITY * cosine), rest(position - GRAVITY * sine)
    curvature = float(column @ column)
    kinetic = float(column @ target) / curvature if curvature > 0 else 0.0
    highest = float(np.tan(tilt.at(slip_time)))
    bound = bounded and kinetic > highest
    kinetic = highest if bound else kinetic
    left = target - kinetic * column
    return _Trial(float(left @ left), kinetic, curvature, bound, position - left)


def fit_slide(tilt: Tilt, position: Array, between: tuple[float, float], creeps: bool = False) -> SlideFit:
    """Fit the slip time and μ_k of one slide, both with profile-likelihood intervals.

    The slip time is continuous, not the time of a frame, so that a slow camera does not bias it.

    Parameters
    ----------
    tilt : Tilt
        Of the rows fitted, from rest to the end of the slide.
    position : (n,) array
        Along the plate, downhill, m.
    between : (low, high)
        Where to seek the slip time, s.
    creeps : bool
        Whether the object creeps at an even speed before it slips.
    """
    from scipy.special import stdtrit

    time = tilt.time
    basis = _at_rest(time, creeps)
    freedom = max(1, len(time) - basis.shape[1] - 2)
    factor = 1 + float(stdtrit(freedom, (1 + CONFIDENCE) / 2)) ** 2 / freedom
    slips, trials = _likely(lambda slip: _solve(tilt, position, basis, slip, True), between, time, factor)
    i = min(range(len(trials)), key=lambda j: trials[j].squares)
    best, slip = trials[i], Range(slips[i], slips[0], slips[-1])
    margin = 1.96 * tilt.sd(slip.value)
    alpha = _widened(Range(*(float(tilt.at(t)) for t in slip)), margin)
    kinetic = _kinetic(tilt, slips, trials, best, factor)
    return SlideFit(
        slip, alpha, _widened(kinetic, _per_angle(kinetic.value, alpha.value) * margin), tilt.rate(slip.value),
        best.bound, float(np.sqrt(best.squares / freedom)), structure(position - best.fitted), best.fitted,
    )  # fmt: skip


def _likely(
    trial: Callable[[float], _Trial], between: tuple[float, float], time: Array, factor: float
) -> tuple[list[float], list[_Trial]]:
    """Slip times whose squares are under `factor` times the least, on a grid that closes in on them."""
    low, high = between
    size = max(8, int(2 * np.sum((time >= low) & (time <= high))))
    for _ in range(_ROUNDS):
        grid = np.linspace(low, high, size)
        trials = [trial(t) for t in grid]
        squares = np.array([t.squares for t in trials])
        within = np.flatnonzero(squares <= factor * squares.min())
        first, last = int(within[0]), int(within[-1])
        low, high = grid[max(first - 1, 0)], grid[min(last + 1, size - 1)]
        if last - first > _GRID / 3 or high - low < 1e-9:
            break
        size = _GRID
    return [float(t) for t in grid[first : last + 1]], trials[first : last + 1]  # type: ignore[possibly-unbound]


def _kinetic(tilt: Tilt, slips: list[float], trials: list[_Trial], best: _Trial, factor: float) -> Range:
    """Profile-likelihood interval of μ_k: at each likely slip time, what still keeps the squares under the limit."""
    low, high = best.kinetic, best.kinetic
    for slip, trial in zip(slips, trials, strict=True):
        spare = max(0.0, factor * best.squares - trial.squares)
        spread = float(np.sqrt(spare / max(trial.curvature, 1e-300)))
        low = min(low, trial.kinetic - spread)
        high = max(high, min(trial.kinetic + spread, float(np.tan(tilt.at(slip)))))
    return Range(best.kinetic, low, high)


def fit_moving(tilt: Tilt, position: Array) -> SlideFit:
    """Fit μ_k alone to an object that moves from the first row on, at a speed of its own."""
    from scipy.special import stdtrit

    time = tilt.time
    trial = _solve(tilt, position, _at_rest(time, True), time[0], False)
    freedom = max(1, len(time) - 3)
    noise = float(np.sqrt(trial.squares / freedom))
    spread = float(stdtrit(freedom, (1 + CONFIDENCE) / 2)) * noise / np.sqrt(max(trial.curvature, 1e-300))
    kinetic = Range(trial.kinetic, trial.kinetic - spread, trial.kinetic + spread)
    middle = float(time.mean())
    kinetic = _widened(kinetic, _per_angle(kinetic.value, float(tilt.at(middle))) * 1.96 * tilt.sd(middle))
    return SlideFit(
        None, None, kinetic, tilt.rate(time[0]), False, noise, structure(position - trial.fitted), trial.fitted
    )


def _widened(interval: Range, margin: float) -> Range:
    """Interval with another, independent uncertainty added."""
    low, high = (float(np.hypot(end - interval.value, margin)) for end in interval[1:])
    return Range(interval.value, interval.value - low, interval.value + high)


def _per_angle(kinetic: float, angle: float) -> float:
    """dμ_k/dθ at the same acceleration, g (sin θ - μ_k cos θ)."""
    return 1 + kinetic * float(np.tan(angle))
