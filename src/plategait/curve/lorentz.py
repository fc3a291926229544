"""The Lorentz line shape of a spin curve: shape, first guess and fit (section 5.3.2).

Frequencies are in Hz; rates may be in any unit, and peaks come out in the same.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal, cast

import numpy as np
from numpy.typing import ArrayLike

from plategait.arrays import Array
from plategait.curve.peak import anywhere, unseen_peak, unseen_top
from plategait.errors import InputError
from plategait.shown import Shown

# scipy, not lmfit: lmfit takes 0.9 s to import and 55 ms to fit with intervals, scipy.optimize 0.35 s and 10 ms.

Interval = tuple[float, float]

# How far an end of an interval is sought: a factor 100 in peak and half-width, one and a half spans in f0.
_REACH = (np.log(100), 1.5, np.log(100))
_LIMIT = 40.0  # scaled parameters stay within ±40, e^40 in peak and half-width: no overflow
_EVALUATIONS = 100  # of one minimisation: a good curve takes about 10, a curve without a peak may take thousands
_SIGNIFICANCE = 0.01  # of the tests that reject a given sd, or a peak
_ROUNDING = 1e-24  # share of the squared rates under which squared residuals are rounding


def lorentzian(frequency: ArrayLike, peak: float, f0: float, half_width: float) -> Array:
    """Lorentz line shape, equation (5.5).

    Parameters
    ----------
    frequency : array_like
        Plate frequency f_p, Hz, any shape.
    peak : float
        Largest spin rate ω_Br max, at `f0`.
    f0 : float
        Frequency of the peak, Hz.
    half_width : float
        Half width at half maximum b, Hz, not 0.

    Returns
    -------
    array of the shape of `frequency`
        Spin rate, in the unit of `peak`.
    """
    return peak / (1 + ((np.asarray(frequency, dtype=float) - f0) / half_width) ** 2)


@dataclass(frozen=True, repr=False)
class LorentzFit(Shown):
    """A spin curve as three numbers with intervals, equation (5.5). Call it to evaluate the line.

    Parameters
    ----------
    peak : float
        ω_Br max, in the unit of the rates; negative where the object spins the other way.
    f0_hz, half_width_hz : float
        Frequency of the peak and half width at half maximum b, Hz.
    r2 : float
        Coefficient of determination, weighted as the fit was.
    n_points : int
        Points used: those with a rate.
    confidence : float
        Coverage of the intervals, between 0 and 1.
    peak_interval, f0_interval, half_width_interval : (low, high)
        Interval of each parameter by itself.
    interval_method : str
        "profile likelihood", or "covariance" (with Student's t) where the residuals are mere rounding.
    scatter : str
        "given": the intervals rest on `sd` as given. "residual": on the scatter of the residuals, because no
        `sd` was given or the residuals are too large for it.
    """

    peak: float
    f0_hz: float
    half_width_hz: float
    r2: float
    n_points: int
    confidence: float
    peak_interval: Interval
    f0_interval: Interval
    half_width_interval: Interval
    interval_method: Literal["profile likelihood", "covariance"]
    scatter: Literal["given", "residual"]

    def told(self) -> list[tuple[str, str]]:
        """Its numbers with their intervals."""
        three = (("peak", self.peak, self.peak_interval, ""), ("f0", self.f0_hz, self.f0_interval, " Hz"),
                 ("half width", self.half_width_hz, self.half_width_interval, " Hz"))  # fmt: skip
        rows = [(name, f"{value:.4g}{unit} ({low:.4g} to {high:.4g})") for name, value, (low, high), unit in three]
        return [*rows, ("R²", f"{self.r2:.3f}"), ("points", str(self.n_points)),
                ("intervals", f"{100 * self.confidence:g} %, {self.interval_method}")]  # fmt: skip

    def __call__(self, frequency: ArrayLike) -> Array:
        """Spin rate of the fitted line at `frequency` (Hz, any shape), in the unit of the rates."""
        return lorentzian(frequency, self.peak, self.f0_hz, self.half_width_hz)


def first_guess(frequency: ArrayLike, rate: ArrayLike) -> tuple[float, float, float]:
    """Guess peak, f0 (Hz) and half-width (Hz) of a spin curve without iterating.

    The inverse of (5.5) is a parabola in f, so y ≈ y² (c₀ + c₁ f + c₂ f²) is a linear least-squares problem in
    which large rates count most. Where that parabola has no minimum, the largest rate and a quarter of the span.

    Parameters
    ----------
    frequency, rate : (n,) array_like
        Finite, at least one rate not 0, at least two distinct frequencies.

    Returns
    -------
    peak, f0, half_width : float
    """
    f, y = np.asarray(frequency, dtype=float), np.asarray(rate, dtype=float)
    top = int(np.argmax(np.abs(y)))
    centre, span, largest = f[top], float(np.ptp(f)), y[top]
    x, v = (f - centre) / span, y / largest
    c0, c1, c2 = np.linalg.lstsq((v**2)[:, None] * np.stack([np.ones_like(x), x, x**2], axis=1), v, rcond=None)[0]
    base = c0 - c1**2 / (4 * c2) if c2 > 0 else 0.0
    if base <= 0:
        return float(largest), float(centre), span / 4
    return float(largest / base), float(centre - span * c1 / (2 * c2)), float(span * np.sqrt(base / c2))


def fit_lorentzian(
    frequency: ArrayLike,
    rate: ArrayLike,
    *,
    sd: ArrayLike | None = None,
    confidence: float = 0.95,
    ends_in_failure: bool = False,
) -> LorentzFit:
    """Fit (5.5) to a spin curve by least squares, as section 5.3.2 does (Levenberg-Marquardt).

    Parameters
    ----------
    frequency : (n,) array_like
        Plate frequencies, Hz, in any order, repeats allowed.
    rate : (n,) array_like
        Spin rates in any unit. NaN (a failed run) leaves that point out.
    sd : (n,) array_like, optional
        Standard deviation of each rate, in its unit. Weights the points; sizes the intervals too, unless the
        residuals are too large for it by a χ² test at 1 %.
    confidence : float
        Coverage asked of the intervals.
    ends_in_failure : bool
        Whether the object ran off at the next higher frequency. Then a curve that only rises may end at its peak, as
        the source's do at A_p = 12 deg.

    Returns
    -------
    LorentzFit

    Raises
    ------
    InputError
        Unequal lengths; a frequency that is not finite and above 0; an infinite rate; an `sd` that is not finite and
        above 0; a confidence outside (0, 1); fewer than 4 points with a rate, or than 4 distinct frequencies; rates
        all alike; or a curve that does not show its peak, because

        - its samples do not show it, by the rule of `curve.peak.unseen_peak`: the highest rate is at an end, f0 is
          where nothing was measured, or fewer than three of the frequencies are within b of it, or
        - a straight line or an exponential fits better by an F test at 1 % (where the curve ends in failure, one that
          falls), or
        - the intervals leave it open: peak or b has no bound, f0 may lie outside the frequencies by more than half an
          interval or, where the curve ends in failure, anywhere in a range as wide as they span.
    """
    f, y, sds = _checked(frequency, rate, sd, confidence)
    if fault := unseen_top(f, y, ends_in_failure=ends_in_failure):
        raise _no_peak(f, y, fault)
    curve = _Curve(f, y, sds)
    best, cost = curve.best_of(curve.starts())
    peak, f0, half_width = map(float, curve.in_units(best))
    if fault := unseen_peak(f, y, f0, half_width, ends_in_failure=ends_in_failure):
        raise _no_peak(f, y, fault, f0)
    if curve.has_rival(cost, ends_in_failure):
        raise _no_peak(f, y, "a curve that a straight line or an exponential fits better")
    threshold, sd_holds = _threshold(cost, len(f) - 3, sd is not None, confidence)
    bounds, method = curve.intervals(best, cost, threshold)
    peaks, centres, widths = ((float(min(ends)), float(max(ends))) for ends in curve.in_units(bounds))
    if fault := _unbounded(f, peaks, centres, widths, ends_in_failure):
        raise _no_peak(f, y, fault, f0)
    return LorentzFit(
        peak=peak,
        f0_hz=f0,
        half_width_hz=half_width,
        r2=1 - cost / curve.spread(),
        n_points=len(f),
        confidence=confidence,
        peak_interval=peaks,
        f0_interval=centres,
        half_width_interval=widths,
        interval_method=method,
        scatter="given" if sd_holds else "residual",
    )


def _are_numbers(values: ArrayLike) -> bool:
    """Whether they become numbers, such as None, which stands for what was not measured."""
    try:
        np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        return False
    return True


def _checked(
    frequency: ArrayLike, rate: ArrayLike, sd: ArrayLike | None, confidence: float
) -> tuple[Array, Array, Array]:
    """Frequencies, rates and their sd (alike if not given) of the points that have a rate, or InputError."""
    for field, values in (("frequency", frequency), ("rate", rate), ("sd", [] if sd is None else sd)):
        if not _are_numbers(values):
            raise InputError(field, values, "numbers", "[20.0, 22.0, 24.0, 26.0]")
    f, y = np.asarray(frequency, dtype=float), np.asarray(rate, dtype=float)
    sds = np.full(f.shape, np.nanmax(np.abs(y), initial=0) or 1.0) if sd is None else np.asarray(sd, dtype=float)
    if f.ndim != 1:
        raise InputError("frequency", f"shape {f.shape}", "a list of frequencies", "[20, 22, 24, 26]")
    for field, values in (("rate", y), ("sd", sds)):
        if values.shape != f.shape:
            raise InputError(
                field, f"shape {values.shape}", f"one value for each of {len(f)} frequencies", f"{len(f)} values"
            )
    if not 0 < confidence < 1:
        raise InputError("confidence", confidence, "between 0 and 1", "0.95")
    has_rate = ~np.isnan(y)
    for field, bad, allowed, hint in (
        ("frequency", f[~(np.isfinite(f) & (f > 0))], "finite and above 0, in Hz", "24.0"),
        ("rate", y[np.isinf(y)], "finite, or NaN for a failed run", "nan"),
        ("sd", sds[has_rate & ~(np.isfinite(sds) & (sds > 0))], "finite and above 0 wherever there is a rate", "None"),
    ):
        if len(bad):
            raise InputError(field, bad.tolist(), allowed, hint)
    f, y, sds = f[has_rate], y[has_rate], sds[has_rate]
    if len(np.unique(f)) < 4:
        got = f"{len(f)} rates at {len(np.unique(f))} frequencies"
        raise InputError("rate", got, "rates at 4 distinct frequencies or more", "more frequencies")
    if np.ptp(y) <= 1e-12 * np.abs(y).max():
        raise InputError("rate", y.tolist(), "a curve that rises or falls", "frequencies where the object spins")
    return f, y, sds


def _threshold(cost: float, dof: int, sd_is_known: bool, confidence: float) -> tuple[float, bool]:
    """Rise of the cost at an interval's ends, and whether it rests on the sd as given rather than on the residuals."""
    from scipy import special

    if sd_is_known and cost <= special.chdtri(dof, _SIGNIFICANCE):
        return float(special.ndtri((1 + confidence) / 2)) ** 2, True
    return cost / dof * float(special.stdtrit(dof, (1 + confidence) / 2)) ** 2, False


def _unbounded(f: Array, peaks: Interval, centres: Interval, widths: Interval, ends_in_failure: bool) -> str | None:
    """What the intervals leave open, if anything: see `fit_lorentzian`."""
    each = np.unique(f)
    low, high = each[0] - (each[1] - each[0]) / 2, each[-1] + (each[-1] - each[-2]) / 2
    inside = low <= centres[0] and (ends_in_failure or centres[1] <= high)
    if not (inside and centres[1] - centres[0] <= np.ptp(f)):
        return f"a peak {anywhere(*centres, digits=4)}"
    if not np.isfinite([*peaks, *widths]).all() or widths[0] == 0:
        return f"a half width {anywhere(*widths, digits=2)}"
    return None


def _no_peak(f: Array, y: Array, got: str, f0: float | None = None) -> InputError:
    """Refusal that says where to measure more: about the peak that the line has, or else about the highest rate."""
    near = float(f[np.argmax(np.abs(y))]) if f0 is None else float(np.clip(f0, f.min(), f.max()))
    side = "beyond" if near == f.max() else "below" if near == f.min() else "around"
    return InputError("rate", got, "a curve that shows its peak", f"adding frequencies {side} {near:.4g} Hz")


class _Curve:
    """Points to fit and the least-squares problem, in scaled parameters (ln |peak|, f0, ln half-width).

    Rates are taken over the largest, frequencies from their middle in spans.
    """

    def __init__(self, f: Array, y: Array, sds: Array) -> None:
        self.f, self.y = f, y
        self.largest, self.centre, self.span = y[np.argmax(np.abs(y))], (f.min() + f.max()) / 2, np.ptp(f)
        self.x, self.v, self.w = (f - self.centre) / self.span, y / self.largest, np.abs(self.largest) / sds

    def in_units(self, p: Array) -> tuple[Array, Array, Array]:
        """Peak, f0 and half-width of p (3, ...)."""
        return self.largest * np.exp(p[0]), self.centre + self.span * p[1], self.span * np.exp(p[2])

    def starts(self) -> list[Array]:
        """Points to start from: the guess by the inverse, and the largest rate with a quarter of the span."""
        peak, f0, half_width = first_guess(self.f, self.y)
        guess = [np.log(peak / self.largest), (f0 - self.centre) / self.span, np.log(half_width / self.span)]
        return [np.array(guess), np.array([0.0, self.x[np.argmax(self.v)], np.log(0.25)])]

    def line(self, p: Array) -> tuple[Array, Array, float]:
        """Line (n,), distance from f0 in half-widths (n,), and half-width."""
        peak, half_width = np.exp(np.clip(p[::2], -_LIMIT, _LIMIT))
        u = (self.x - p[1]) / half_width
        return peak / (1 + u**2), u, half_width

    def residual(self, p: Array) -> Array:
        """Weighted residuals (n,)."""
        return self.w * (self.line(p)[0] - self.v)

    def jacobian(self, p: Array) -> Array:
        """Derivatives (n, 3) of the weighted residuals by p."""
        line, u, half_width = self.line(p)
        common = self.w * line * 2 * u / (1 + u**2)
        return np.column_stack([self.w * line, common / half_width, common * u])

    def minimise(self, start: Array, held: int | None = None) -> tuple[Array, float]:
        """Least squares from `start`, one parameter held if asked: parameters and weighted sum of squares."""
        from scipy.optimize import least_squares

        free = [i for i in range(3) if i != held]

        def whole(part: Array) -> Array:
            p = start.copy()
            p[free] = part
            return p

        def residual(part: Array) -> Array:
            return self.residual(whole(part))

        def jacobian(part: Array) -> Array:
            return self.jacobian(whole(part))[:, free]

        solution = least_squares(residual, start[free], cast("Any", jacobian), method="lm", max_nfev=_EVALUATIONS)
        return np.clip(whole(solution.x), -_LIMIT, _LIMIT), 2 * float(solution.cost)

    def best_of(self, starts: Iterable[Array], held: int | None = None) -> tuple[Array, float]:
        """Lowest of the minima reached from `starts`: see `minimise`."""
        return min((self.minimise(start, held) for start in starts), key=lambda minimum: minimum[1])

    def spread(self) -> float:
        """Weighted sum of squares about the weighted mean."""
        return float(np.sum((self.w * (self.v - np.average(self.v, weights=self.w**2))) ** 2))

    def has_rival(self, cost: float, ends_in_failure: bool) -> bool:
        """Whether a line without a peak does as well as one of this cost, by an F test: see `fit_lorentzian`."""
        from scipy.special import fdtri

        dof, rival_dof = len(self.x) - 3, len(self.x) - 2
        least = self.monotone_cost(falling_only=ends_in_failure) / rival_dof
        return bool(cost / dof > fdtri(dof, rival_dof, 1 - _SIGNIFICANCE) * least)

    def intervals(
        self, best: Array, cost: float, threshold: float
    ) -> tuple[Array, Literal["profile likelihood", "covariance"]]:
        """Ends (3, 2) where the profile of each parameter rises by `threshold`, and how they were found."""
        jacobian = self.jacobian(best)
        wald = np.sqrt(np.diag(np.linalg.pinv(jacobian.T @ jacobian)) * threshold)
        if threshold <= _ROUNDING * float(np.sum((self.w * self.v) ** 2)):
            return best[:, None] + np.outer(wald, [-1, 1]), "covariance"
        ends = [[self._profile_end(best, cost, threshold, i, d, wald[i]) for d in (-1, 1)] for i in range(3)]
        return np.array(ends), "profile likelihood"

    def _profile_end(self, best: Array, cost: float, threshold: float, i: int, direction: int, wald: float) -> float:
        """Where the cost, minimised over the other two parameters, has risen by `threshold`; infinite if nowhere."""
        from scipy.optimize import root_scalar

        nearest = best

        @cache  # a step is minimised from the last one too, so asking twice must not give two answers
        def rise(step: float) -> float:
            nonlocal nearest
            starts = np.stack([best, nearest])
            starts[:, i] = best[i] + direction * step
            nearest, at_step = self.best_of(starts, held=i)
            return np.sqrt(max(at_step - cost, 0)) - np.sqrt(threshold)

        inside, outside = 0.0, float(np.clip(wald, 1e-9, _REACH[i]))
        while rise(outside) < 0:
            if outside == _REACH[i]:
                return direction * np.inf
            inside, outside = outside, min(2 * outside, _REACH[i])
        return best[i] + direction * root_scalar(rise, bracket=(inside, outside), xtol=1e-4 * outside).root

    def monotone_cost(self, falling_only: bool) -> float:
        """Weighted sum of squares of the best of a straight line and an exponential, neither of which peaks.

        Of those that do not rise, if asked; a constant is one of them.
        """
        terms = np.stack([np.ones_like(self.x), self.x], axis=1)
        log_weight = self.w * np.maximum(self.v, 0)
        logs = np.log(np.maximum(self.v, np.finfo(float).tiny))
        straight = np.linalg.lstsq(self.w[:, None] * terms, self.w * self.v, rcond=None)[0]
        power = np.linalg.lstsq(log_weight[:, None] * terms, log_weight * logs, rcond=None)[0]
        rivals = [line for line, slope in ((terms @ straight, straight[1]), (np.exp(terms @ power), power[1]))
                  if slope <= 0 or not falling_only]  # fmt: skip
        return min([self.spread(), *(float(np.sum((self.w * (rival - self.v)) ** 2)) for rival in rivals)])
