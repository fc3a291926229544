"""Sampled series: cut to a window, thinned, smoothed and differentiated."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.files.output import whole_file

if TYPE_CHECKING:
    from scipy.interpolate import BSpline


MOST_ROWS = 20_000
_DEGREE = 5  # the fourth derivative is continuous, so that the second, which the dynamics need, is smooth
_MOST_INTERVALS = 60
_ROWS_PER_INTERVAL = 5
_GROWTH = 1.25  # from one number of intervals tried to the next


@dataclass(frozen=True)
class Window:
    """Part of a recording that is used.

    Parameters
    ----------
    start, end : float
        Times, s, both included.
    """

    start: float = -math.inf
    end: float = math.inf

    def cut(self, time: Array, *series: Array, least: int) -> tuple[Array, ...]:
        """Rows within the window of time and series.

        Raises
        ------
        InputError
            When fewer than `least` rows are left.
        """
        inside = (time >= self.start) & (time <= self.end)
        if inside.sum() < least:
            hint = f"--from {_text(time[0])} --to {_text(time[-1])}" if len(time) >= least else "a longer recording"
            raise InputError("recording", f"{inside.sum()} rows within the times asked for", f"at least {least} rows",
                             hint)  # fmt: skip
        return tuple(values[inside] for values in (time, *series))


def _text(seconds: float) -> str:
    return f'"{seconds:.4g} s"'


def thin(time: Array, *series: Array, most: int = MOST_ROWS) -> tuple[list[Array], int]:
    """Means over blocks of rows where there are more than `most` rows, and the rows in a block (1: nothing done)."""
    block = -(-len(time) // most)
    if block == 1:
        return [time, *series], 1
    whole = len(time) // block * block
    return [values[:whole].reshape(-1, block).mean(axis=1) for values in (time, *series)], block


@dataclass(frozen=True, eq=False)
class Smooth:
    """A series as a spline.

    Parameters
    ----------
    spline : BSpline
        Of time.
    sd : float
        Of the scatter about it.
    """

    spline: BSpline
    sd: float

    def __call__(self, time: Array, derivative: int = 0) -> Array:
        """Value, or derivative, at `time`."""
        return np.asarray(self.spline(time, nu=derivative))

    def matrix(self, time: Array, derivative: int = 0) -> Array:
        """Matrix (len(time), coefficients) that turns coefficients into values, or derivatives, at `time`."""
        from scipy.interpolate import BSpline

        knots, degree = self.spline.t, int(self.spline.k)
        size = len(knots) - degree - 1
        return np.asarray(BSpline(knots, np.eye(size), degree)(time, nu=derivative))

    @property
    def coefficients(self) -> Array:
        """Coefficients of the spline."""
        return np.asarray(self.spline.c)


def smooth(time: Array, values: Array) -> Smooth:
    """Least-squares spline whose number of intervals generalised cross-validation picks.

    Few samples get a parabola or a cubic, more a quintic. A regression spline rather than a smoothing one: that is
    curved up to its very ends, where a released strip accelerates most.

    Parameters
    ----------
    time : (n,) array
        Rising, s.
    values : (n,) array
    """
    splines = (_spline(time, values, degree, intervals) for degree, intervals in _candidates(len(time)))
    return min(splines, key=lambda scored: scored[0])[1]


def follow(time: Array, values: Array) -> Smooth:
    """Spline fine enough to follow whatever the samples show, noise and all: a start for one that a model restrains."""
    intervals = max(1, min(len(time) // _ROWS_PER_INTERVAL, _MOST_INTERVALS))
    return _spline(time, values, min(_DEGREE, len(time) // 2), intervals)[1]


def _candidates(n: int) -> list[tuple[int, int]]:
    """Degrees and numbers of intervals to try for n samples."""
    most = min(n // 3, _MOST_INTERVALS)
    counts = sorted({round(_GROWTH**i) for i in range(40) if _GROWTH**i <= max(most, 1)})
    return [(d, 1) for d in (1, 2, 3) if n > d + 1] + [(_DEGREE, k) for k in counts if n > k + _DEGREE + 2]


def _spline(time: Array, values: Array, degree: int, intervals: int) -> tuple[float, Smooth]:
    """Score of a spline and the spline."""
    from scipy.interpolate import make_lsq_spline

    # Interior knots at quantiles of the samples, so that none lacks data.
    inner = np.quantile(time, np.linspace(0, 1, intervals + 1)[1:-1])
    knots = np.r_[[time[0]] * (degree + 1), inner, [time[-1]] * (degree + 1)]
    spline: Any = make_lsq_spline(time, values, knots, degree)
    n, size = len(time), intervals + degree
    squares = float(np.sum((values - spline(time)) ** 2))
    return squares / (n - size) ** 2, Smooth(spline, math.sqrt(squares / (n - size)))


def structure(residual: Array) -> float:
    """Correlation of each residual with the next one: about 0 for noise, near 1 where a model misses something."""
    centred = residual - residual.mean()
    total = float(centred @ centred)
    return float(centred[1:] @ centred[:-1]) / total if total > 0 else 0.0


def rounded(values: Array, step: float) -> Array:
    """Values rounded to multiples of a step; 0 leaves them."""
    return np.round(values / step) * step if step else values


def write_recording(path: Path | str, heading: list[str], columns: list[Array]) -> None:
    """Write a recording as CSV, whole or not at all."""
    with whole_file(path, (".csv",), "recording") as temporary:
        np.savetxt(
            temporary, np.column_stack(columns), fmt="%.10g", delimiter=",", header=",".join(heading), comments=""
        )
