"""Straight lines through points, with all that sections 5.4 to 5.6 and appendix B ask of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from plategait.arrays import Array
from plategait.errors import InputError


@dataclass(frozen=True)
class Regression:
    """Least-squares line y = slope x + intercept.

    Attributes
    ----------
    slope, intercept, r2 : float
    slope_error, intercept_error : float
        Standard errors.
    freedom : int
        Points less two.
    mean_x, sum_squares, residual_variance : float
        x̄, S_xx and MS_E of (B.3).
    """

    slope: float
    intercept: float
    r2: float
    slope_error: float
    intercept_error: float
    freedom: int
    mean_x: float
    sum_squares: float
    residual_variance: float

    def __call__(self, x: ArrayLike) -> Array:
        """Height of the line at `x`."""
        return self.slope * np.asarray(x, dtype=float) + self.intercept

    def band(self, x: ArrayLike, confidence: float = 0.95) -> tuple[Array, Array]:
        """Interval of the line itself at `x` (dashed in Figs. 5.11 and 5.12)."""
        from scipy.special import stdtrit

        x = np.asarray(x, dtype=float)
        error = np.sqrt(self.residual_variance * (1 / (self.freedom + 2) + (x - self.mean_x) ** 2 / self.sum_squares))
        half = float(stdtrit(self.freedom, (1 + confidence) / 2)) * error
        return self(x) - half, self(x) + half

    def t_slope(self, expected: float = 0.0) -> tuple[float, float]:
        """Student's t and two-sided p of the slope against `expected`, (B.3) and (B.5)."""
        return self._test(abs(self.slope - expected) / self.slope_error)

    def t_intercept(self, expected: float = 0.0) -> tuple[float, float]:
        """Student's t and two-sided p of the intercept against `expected`."""
        return self._test(abs(self.intercept - expected) / self.intercept_error)

    def _test(self, t: float) -> tuple[float, float]:
        return t, two_sided_p(t, self.freedom)


def two_sided_p(t: float, freedom: int) -> float:
    """Probability of a Student's t of this size or more, either way (Excel's TDIST with two tails)."""
    from scipy.special import stdtr

    return float(2 * stdtr(freedom, -abs(t)))


def regress(x: ArrayLike, y: ArrayLike) -> Regression:
    """Fit a line through points; pairs with a NaN are left out.

    Raises
    ------
    InputError
        For fewer than three pairs, or x all alike.
    """
    x, y = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
    finite = np.isfinite(x) & np.isfinite(y)
    x, y = x[finite], y[finite]
    if len(x) < 3 or np.ptp(x) == 0:
        raise InputError("points", f"{len(x)} pairs", "3 or more pairs at different x", "more curves")
    mean_x, mean_y = float(x.mean()), float(y.mean())
    sxx = float(((x - mean_x) ** 2).sum())
    total = float(((y - mean_y) ** 2).sum())
    slope = float(((x - mean_x) * (y - mean_y)).sum()) / sxx
    intercept = mean_y - slope * mean_x
    residual = float(((y - slope * x - intercept) ** 2).sum())
    variance = residual / (len(x) - 2)
    return Regression(
        slope=slope,
        intercept=intercept,
        r2=1 - residual / total if total > 0 else 1.0,
        slope_error=float(np.sqrt(variance / sxx)),
        intercept_error=float(np.sqrt(variance * (1 / len(x) + mean_x**2 / sxx))),
        freedom=len(x) - 2,
        mean_x=mean_x,
        sum_squares=sxx,
        residual_variance=variance,
    )
