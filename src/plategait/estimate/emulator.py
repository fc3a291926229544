"""Emulators: what the engine would give at parameters where it has not been run, learnt from where it has."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations_with_replacement

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plategait.arrays import Array

FOLDS = 5
# Runs short of which a condition's rates are not emulated.
LEAST_RUNS = 12
# Parameters that move the rates less are drawn together by as much, to no less than this share: splines take near for
# alike, and what hardly matters must not tell runs apart. It halves the errors of five unknowns.
LEAST_RELEVANCE = 0.2
# No run-off is known better than to this share of its frequency, however wide the brackets that it is learnt from:
# what differs unseen from one measurement to the next moves it by this or more (benchmarks/run_off_scatter.py).
SHARPEST_RUN_OFF = 0.01
# Runs that begin to fail elsewhere than their neighbours, on the far side of an island of stability: their share, and
# the probability of any bracket among them.
ODD_SHARE, ODD_PROBABILITY = 0.05, 0.05


@dataclass(frozen=True, eq=False)
class RateEmulator:
    """Spin rates over the unit cube of the parameters, one column a condition: cubic splines with a quadratic trend.

    Attributes
    ----------
    error : (c,) array
        Error found by leaving out a fifth of the runs in turn, deg/s: what 68 % of those near the data stay within. It
        holds the spread that chaos gives the engine's own runs too. Infinite where too few runs stayed on the plate.
    """

    splines: tuple[tuple[NDArray[np.int64], Callable[[Array], Array]], ...]
    error: Array

    def __call__(self, u: Array) -> Array:
        """Spin rates (n, c), deg/s, at parameters (n, d)."""
        rates = np.zeros((len(u), len(self.error)))
        for columns, spline in self.splines:
            rates[:, columns] = spline(u)
        return rates


def fit_rates(u: Array, rates: Array, weight: NDArray[np.bool_]) -> RateEmulator:
    """Learn spin rates.

    Parameters
    ----------
    u : (n, d) array
        Parameters of the runs.
    rates : (n, c) array
        NaN where a run failed.
    weight : (n,) bool array
        Runs whose errors count: those near what was measured.
    """
    stayed = np.isfinite(rates)
    error = np.full(rates.shape[1], math.inf)
    splines = []
    for pattern in np.unique(stayed, axis=1).T:
        columns = np.flatnonzero((stayed == pattern[:, None]).all(axis=0))
        rows = np.flatnonzero(pattern)
        if len(rows) < max(LEAST_RUNS, _terms(u.shape[1], 2) + 2):
            continue
        values = rates[np.ix_(rows, columns)]
        relevance = _relevance(u[rows], values)
        splines.append((columns, _spline(u[rows], values, relevance)))
        error[columns] = _left_out_error(u[rows], values, weight[rows], relevance)
    return RateEmulator(tuple(splines), error)


def _spline(u: Array, values: Array, relevance: Array) -> Callable[[Array], Array]:
    from scipy.interpolate import RBFInterpolator

    degree = 2 if len(u) > 2 * _terms(u.shape[1], 2) else 1
    spline = RBFInterpolator(u * relevance, values, kernel="cubic", degree=degree, smoothing=1e-3)
    return lambda at: spline(at * relevance)


def _relevance(u: Array, values: Array) -> Array:
    """How much each parameter (d,) moves the values (n, c), the most being 1: slopes of a quadratic through them."""
    spread = values.std(axis=0)
    scaled = (values - values.mean(axis=0))[:, spread > 0] / spread[spread > 0]
    terms = polynomial(u, 2)
    ridge = 1e-2 * np.eye(terms.shape[1])
    coefficients = np.linalg.solve(terms.T @ terms + ridge, terms.T @ scaled)
    step = 1e-3
    slopes = [
        np.sqrt(np.mean(((polynomial(u + step * axis, 2) - terms) @ coefficients) ** 2)) for axis in np.eye(u.shape[1])
    ]
    return np.clip(np.array(slopes) / max(max(slopes), 1e-300), LEAST_RELEVANCE, 1.0)


def _left_out_error(u: Array, values: Array, weight: NDArray[np.bool_], relevance: Array) -> Array:
    fold = np.arange(len(u)) % FOLDS
    residual = np.empty_like(values)
    for k in range(FOLDS):
        spline = _spline(u[fold != k], values[fold != k], relevance)
        residual[fold == k] = spline(u[fold == k]) - values[fold == k]
    near = weight if weight.sum() >= LEAST_RUNS else np.ones(len(u), dtype=bool)
    # Not the root mean square: a left-out run at the rim of the rest is extrapolated to, which no sample is.
    return np.quantile(np.abs(residual[near]), 0.68, axis=0)


def _terms(dimensions: int, degree: int) -> int:
    return math.comb(dimensions + degree, degree)


def polynomial(u: Array, degree: int) -> Array:
    """(n, t) products of the parameters, centred, up to a degree."""
    centred = 2 * u - 1
    columns = [np.ones(len(u))]
    for k in range(1, degree + 1):
        columns += [np.prod(centred[:, c], axis=1) for c in combinations_with_replacement(range(u.shape[1]), k)]
    return np.stack(columns, axis=1)


@dataclass(frozen=True, eq=False)
class RunOffEmulator:
    """Frequency from which the object runs off, over the parameters: a polynomial, and how sharp it is.

    Attributes
    ----------
    coefficients : (t,) array
        Hz.
    degree : int
    width : float
        Standard deviation about the polynomial, Hz: chaos, and what the polynomial misses.
    """

    coefficients: Array
    degree: int
    width: float

    def __call__(self, u: Array) -> Array:
        """Run-off frequency (n,), Hz, at parameters (n, d)."""
        return polynomial(u, self.degree) @ self.coefficients

    def log_between(self, u: Array, low: float, high: float) -> Array:
        """Log probability (n,) that the object begins to run off between two frequencies (Hz)."""
        return log_between(self(u), self.width, np.full(len(u), low), np.full(len(u), high))


def log_between(centre: Array, width: float | Array, low: Array, high: Array) -> Array:
    """Log of the normal probability between two ends, either of which may be infinite (or 0 below)."""
    from scipy.special import log_ndtr

    a, b = (low - centre) / width, (high - centre) / width
    # The far tail is that of the nearer end: mirrored, so that differences are of small numbers.
    mirrored = a + b > 0
    a, b = np.where(mirrored, -b, a), np.where(mirrored, -a, b)
    upper, lower = log_ndtr(b), log_ndtr(a)
    return upper + np.log1p(-np.exp(np.minimum(lower - upper, -1e-12)))


def fit_run_off(u: Array, low: Array, high: Array, near: NDArray[np.bool_]) -> RunOffEmulator | None:
    """Learn the run-off frequency from runs that each bracket it: regression on interval-censored values.

    Parameters
    ----------
    u : (n, d) array
        Parameters of the runs.
    low, high : (n,) arrays
        Highest frequency at which the object stayed and lowest at which it failed, Hz; 0 or infinity where none.
    near : (n,) bool array
        Runs near what was measured. Only they count once they are enough for the polynomial.

    Returns
    -------
    RunOffEmulator or None
        None where no run bracketed it from both sides.
    """
    from scipy.optimize import minimize

    degree = 3 if u.shape[1] <= 3 else 2
    if near.sum() >= 2.5 * _terms(u.shape[1], degree):
        u, low, high = u[near], low[near], high[near]
    else:
        degree = 2 if len(u) >= 2.5 * _terms(u.shape[1], 2) else 1
    both = (low > 0) & np.isfinite(high)
    if both.sum() < 2:
        return None
    terms = polynomial(u, degree)
    middle = np.where(both, 0.5 * (low + high), np.where(low > 0, low, np.where(np.isfinite(high), high, 0.0)))
    start, *_ = np.linalg.lstsq(terms[both], middle[both], rcond=1e-2)
    spread = max(float(np.std(terms[both] @ start - middle[both])), 0.3)
    sharpest = SHARPEST_RUN_OFF * float(np.median(middle[both]))

    def cost(x: Array) -> tuple[float, Array]:
        centre, width = terms @ x[:-1], sharpest + math.exp(x[-1])
        value, slope, by_width = _censored(centre, width, low, high)
        ridge = 1e-3 * x[1:-1]
        gradient = -np.append(terms.T @ slope, by_width * math.exp(x[-1]))
        gradient[1:-1] += 2 * ridge
        return float(-value + ridge @ x[1:-1]), gradient

    minimum = minimize(cost, np.append(start, math.log(spread)), jac=True, method="L-BFGS-B",
                     bounds=[(None, None)] * len(start) + [(math.log(1e-3), math.log(10.0))])  # fmt: skip
    return RunOffEmulator(minimum.x[:-1], degree, sharpest + math.exp(minimum.x[-1]))


def _censored(centre: Array, width: float, low: Array, high: Array) -> tuple[float, Array, float]:
    """Log likelihood of interval-censored normals and a few odd ones, its slope by each centre, and by the width."""
    log_p = log_between(centre, width, low, high)
    log_all = np.logaddexp(log_p + math.log1p(-ODD_SHARE), math.log(ODD_SHARE * ODD_PROBABILITY))
    sound = np.exp(log_p + math.log1p(-ODD_SHARE) - log_all)
    a, b = (low - centre) / width, (high - centre) / width

    def density(x: Array) -> Array:
        return np.exp(np.minimum(-0.5 * np.square(np.clip(x, -1e3, 1e3)) - 0.5 * math.log(math.tau) - log_p, 50.0))

    at_a, at_b = density(a), np.where(np.isfinite(b), density(b), 0.0)
    finite_b = np.where(np.isfinite(b), b, 0.0)
    slope = sound * (at_a - at_b) / width
    by_width = float(np.sum(sound * (at_a * a - at_b * finite_b)) / width)
    return float(log_all.sum()), slope, by_width


def brackets(failed: NDArray[np.bool_], frequency: ArrayLike) -> tuple[Array, Array]:
    """Frequencies (n,) between which runs at rising frequencies (n, c) begin to fail; 0 or infinity where none."""
    f = np.asarray(frequency, dtype=float)
    first = np.where(failed, f, math.inf).min(axis=1)
    last = np.where(~failed & (f < first[:, None]), f, 0.0).max(axis=1)
    return last, first
