"""What a camera sees of a tilted plate: its angle and the object's position over time, and the angle smoothed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.files.table import Column, read_table

EXAMPLE = "time_s,angle_deg,position_mm"
LEAST_ROWS = 8
_PRUDENCE = 1.4  # weight of the degrees of freedom in cross-validation: 1 follows noise every so often
_COLUMNS = {"time": Column("s"), "angle": Column("rad"), "position": Column("m")}


@dataclass(frozen=True, eq=False)
class TiltRecording:
    """What a camera saw of one tilt.

    Attributes
    ----------
    name : str
    time, angle, position : (n,) arrays
        s; of the plate, rad; of the object along the slope, on the plate, in either direction, m.

    Raises
    ------
    InputError
        Columns of unlike length or too short, numbers that are not finite, a time that does not rise, or an angle
        beyond 90 deg.
    """

    name: str
    time: Array
    angle: Array
    position: Array

    def __post_init__(self) -> None:
        """Refuse what is no recording."""
        columns = (self.time, self.angle, self.position)
        if len({np.shape(c) for c in columns}) > 1 or np.ndim(self.time) != 1 or len(self.time) < LEAST_ROWS:
            raise InputError(
                self.name, [np.shape(c) for c in columns], f"columns of {LEAST_ROWS} rows or more", EXAMPLE
            )
        if not all(np.isfinite(c).all() for c in columns) or not (np.diff(self.time) > 0).all():
            raise InputError(self.name, "nothing of that sort", "finite numbers with a rising time", EXAMPLE)
        if (furthest := float(np.abs(self.angle).max())) >= math.pi / 2:
            got = f"{math.degrees(furthest):.4g} deg"
            raise InputError(f"{self.name}, angle", got, "below 90 deg either way", "the heading angle_deg")


def read_tilt(path: Path | str) -> TiltRecording:
    """Read the columns time, angle and position of one tilt.

    Raises
    ------
    InputError
        See `plategait.files.table.read_table` and `TiltRecording`.
    """
    name = Path(path).name
    table = read_table(path, _COLUMNS, field=name, example=EXAMPLE, least_rows=LEAST_ROWS, rising="time")
    return TiltRecording(table.path.name, table["time"], table["angle"], table["position"])


def noise_of(values: Array) -> float:
    """Sd of the noise, from the median of third differences, which a smooth motion hardly moves.

    Positions that a camera rounded to the same numbers show their steps only: the noise is at least that of rounding.
    """
    steps = np.abs(np.diff(values))
    steps = steps[steps > 0]
    rounding = steps.min() / np.sqrt(12) if len(steps) else 0.0
    third = np.abs(np.diff(values, 3))
    return float(max(np.median(third) / 0.6745 / np.sqrt(20) if len(third) else 0.0, rounding))


@dataclass(frozen=True, eq=False)
class Tilt:
    """The plate's angle as a smooth function of time.

    Attributes
    ----------
    time, angle : (n,) arrays
        s and rad, smoothed.
    noise : float
        Sd of one measured angle, rad.
    penalty : float
        λ of the smoothing spline.
    """

    time: Array
    angle: Array
    noise: float = 0.0
    penalty: float = 0.0

    def sd(self, time: float) -> float:
        """Sd of the smoothed angle at a time with its bias, rad: √H_ii σ (G. Wahba, J. R. Stat. Soc. B 45, 1983)."""
        if self.noise == 0:
            return 0.0
        impulse = np.zeros_like(self.time)
        nearest = int(np.argmin(np.abs(self.time - time)))
        impulse[nearest] = 1.0
        return self.noise * math.sqrt(max(0.0, float(_smoothed(self.time, impulse, self.penalty)[nearest])))

    def at(self, time: float | Array) -> Array:
        """Angle at a time, rad."""
        return np.asarray(np.interp(time, self.time, self.angle))

    def rate(self, time: float) -> float:
        """How fast it turns about a time, rad/s."""
        near = 0.5
        low, high = max(self.time[0], time - near), min(self.time[-1], time + near)
        return float((self.at(high) - self.at(low)) / (high - low))

    @cached_property
    def _integrals(self) -> list[tuple[Array, Array, Array]]:
        """Sine and cosine with their first and second integrals over the time, exact where they are straight."""
        return [_integrated(self.time, f(self.angle)) for f in (np.sin, np.cos)]

    def travel(self, since: float) -> tuple[Array, Array]:
        """Double integrals of sin θ and cos θ from a time on, at every row, s²; 0 before it."""
        both = []
        for value, once, twice in self._integrals:
            i = min(int(np.searchsorted(self.time, since, "right")) - 1, len(self.time) - 2)
            dt, slope = since - self.time[i], (value[i + 1] - value[i]) / (self.time[i + 1] - self.time[i])
            once_then = once[i] + dt * (value[i] + dt * slope / 2)
            twice_then = twice[i] + dt * (once[i] + dt * (value[i] / 2 + dt * slope / 6))
            both.append(np.where(self.time > since, twice - twice_then - once_then * (self.time - since), 0.0))
        return both[0], both[1]


def _integrated(time: Array, value: Array) -> tuple[Array, Array, Array]:
    dt = np.diff(time)
    once = np.concatenate([[0.0], np.cumsum(dt * (value[:-1] + value[1:]) / 2)])
    twice = np.concatenate([[0.0], np.cumsum(dt * (once[:-1] + dt * (2 * value[:-1] + value[1:]) / 6))])
    return value, once, twice


def _smoothed(time: Array, values: Array, penalty: float) -> Array:
    """Values (n,) of the natural cubic spline g that makes Σ(y - g)² + λ ∫g''² least (Ch. H. Reinsch, 1967).

    With its second derivatives γ at the inner rows, (R + λ Q'Q) γ = Q'y and g = y - λ Qγ, both matrices banded: a
    hundred times as fast as building scipy's spline, and right for more rows.
    """
    from scipy.linalg import solveh_banded

    step = np.diff(time)
    left, right = 1 / step[:-1], 1 / step[1:]
    middle = -(left + right)
    bands = np.zeros((3, len(middle)))
    bands[0] = (step[:-1] + step[1:]) / 3 + penalty * (left**2 + middle**2 + right**2)
    bands[1, :-1] = step[1:-1] / 6 + penalty * (middle[:-1] * left[1:] + right[:-1] * middle[1:])
    bands[2, :-2] = penalty * right[:-2] * left[2:]
    bent = solveh_banded(bands, np.diff(np.diff(values) / step), lower=True)
    taken = np.zeros_like(time)
    taken[:-2] += left * bent
    taken[1:-1] += middle * bent
    taken[2:] += right * bent
    return np.asarray(values - penalty * taken, dtype=float)


def smooth_tilt(time: Array, angle: Array) -> Tilt:
    """Smooth the plate's angle by a cubic spline, as much as generalised cross-validation says.

    A smoothing spline of penalty λ weighs its neighbours by a kernel of width h = (λ / rows per second)^¼ and height
    0.354 / h, which gives the degrees of freedom that it takes (B. W. Silverman, Spline smoothing, Ann. Statist. 12,
    1984).
    """
    if len(time) < 8 or noise_of(angle) == 0:
        return Tilt(time, angle)
    n, duration = len(time), time[-1] - time[0]
    best = (np.inf, Tilt(time, angle))
    for h in np.geomspace(duration / n, duration / 4, 12):
        penalty = float(n / duration * h**4)
        smooth = _smoothed(time, angle, penalty)
        taken = min(2 + 0.354 * duration / h, 0.6 * n)
        squares = float(np.sum((angle - smooth) ** 2))
        tilt = Tilt(time, smooth, float(np.sqrt(squares / (n - taken))), penalty)
        best = min(best, (squares / (n - _PRUDENCE * taken) ** 2, tilt), key=lambda trial: trial[0])
    return best[1]
