"""Least squares over several channels at once, their noise and its correlation taken from the residuals."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array
from plategait.identify.series import structure
from plategait.model.fragment import Fragment
from plategait.model.measured import CONFIDENCE, Measured

# From parameters (p, batch) to what they predict (n, channels, batch).
Model = Callable[[Array], Array]

_STEP = 1e-6  # of a difference quotient: the root of rounding, for parameters of order 1, with a margin
_PASSES = 4  # of weighting anew; the weights hardly change after the second
_NO_NOISE = 1e-7  # share of a channel's range under which its scatter is numerical
_HUGE = 1e6  # stands for what diverged
_PRECISION = 1e-9  # of the cost, relative
_DAMPING = 1e-3  # of the first step
_EVALUATIONS = 60  # of one pass: a good start takes about 5
_SETTLED = 1e-4  # change of parameters under which the weights have settled
_SIGNIFICANT = 2.0  # standard errors beyond which a correlation of neighbouring residuals is no chance


@dataclass(frozen=True, eq=False)
class Fit:
    """Parameters that were fitted, with their covariance.

    Parameters
    ----------
    parameters : (p,) array
    covariance : (p, p) array
        Widened where the residuals hang together.
    structure : float
        Largest correlation of neighbouring residuals of a channel.
    structured : bool
        Whether that is more than chance.
    dof : float
        Degrees of freedom.
    """

    parameters: Array
    covariance: Array
    structure: float
    structured: bool
    dof: float

    def measured(self, i: int, scale: float) -> Measured:
        """Parameter i times `scale`, with its interval."""
        return interval(scale * self.parameters[i], abs(scale) * math.sqrt(self.covariance[i, i]), self.dof)

    @property
    def structure_note(self) -> str:
        """What to say where the residuals are structured."""
        return (
            f"neighbouring residuals correlate by {self.structure:.2f}, intervals widened: the model misses something"
        )

    def correlation(self, i: int, j: int) -> float:
        """Correlation of two parameters."""
        size = math.sqrt(self.covariance[i, i] * self.covariance[j, j])
        return float(self.covariance[i, j] / size) if 0 < size < math.inf else 0.0


def interval(value: float, sd: float, dof: float) -> Measured:
    """Value with the interval that Student's t gives it."""
    from scipy.special import stdtrit

    if not math.isfinite(sd):
        return unbounded(value)
    reach = float(stdtrit(max(dof, 1.0), (1 + CONFIDENCE) / 2)) * float(sd)
    return Measured(float(value), float(sd), float(value) - reach, float(value) + reach)


def unbounded(value: float) -> Measured:
    """Value whose interval is infinite: nothing is known of it."""
    return Measured(float(value), math.inf, -math.inf, math.inf)


def determined(measured: Measured) -> bool:
    """Whether an interval leaves out zero and is no wider than the value."""
    return bool(measured.low > 0 and measured.high - measured.low <= abs(measured.value))


def if_determined(measured: Measured | None) -> Measured | None:
    """The same where it is determined, else None."""
    return measured if measured is not None and determined(measured) else None


def undetermined_note(name: str, measured: Measured, factor: float, unit: str) -> list[str]:
    """What to say of a parameter that is not determined; nothing of one that is."""
    if determined(measured):
        return []
    if not math.isfinite(measured.sd):
        return [f"{name} not determined"]
    return [f"{name} not determined: anywhere from {factor * measured.low:.3g} to {factor * measured.high:.3g} {unit}"]


def scaled(measured: Measured, scale: float) -> Measured:
    """Measured value in other units, or of a wider piece; `scale` above 0."""
    m = measured
    return Measured(scale * m.value, scale * m.sd, scale * m.low, scale * m.high)


def fragment_of(parameters: Mapping[str, Measured], correlation: float, source: str) -> Fragment:
    """Fragment of up to two parameters with their correlation."""
    matrix = np.array([[1.0, correlation], [correlation, 1.0]]) if len(parameters) == 2 else None
    return Fragment(parameters, matrix, source=source)


def fit(model: Model, data: Array, start: Array, lower: Array, upper: Array, *, correlated: bool = True) -> Fit:
    """Fit a model to channels whose noise is white in time, of unknown size, and may be correlated between channels.

    Markers shared by two angles make such a correlation. Channels are weighted by the inverse covariance of their
    residuals, found anew after each pass, which is the maximum-likelihood estimate.

    Parameters
    ----------
    model : callable
        From parameters (p, batch) to predictions (n, channels, batch).
    data : (n, channels) array
    start, lower, upper : (p,) arrays
        Parameters of order 1, and their limits.
    correlated : bool
        Whether the noise of one channel may correlate with that of another.
    """
    n, channels = data.shape
    size = np.maximum(np.ptp(data, axis=0), np.finfo(float).tiny)
    weight, floor = np.diag(size**-2), np.diag((_NO_NOISE * size) ** 2)
    point = _at(model, data, np.clip(start, lower, upper), lower, upper)
    for _ in range(_PASSES):
        before, point = point, _minimise(model, data, point, weight, lower, upper)
        normal = _normal(point.slopes, weight)
        weight = np.asarray(np.linalg.inv(_scatter(point, normal, weight, correlated) + floor), dtype=float)
        if np.max(np.abs(point.parameters - before.parameters)) < _SETTLED:
            break
    whitened = point.residual @ np.linalg.cholesky(weight)
    correlation = max(structure(whitened[:, c]) for c in range(channels))
    structured = correlation > _SIGNIFICANT / math.sqrt(n)
    widening = (1 + correlation) / (1 - correlation) if structured else 1.0
    normal = _normal(point.slopes, weight)
    covariance = widening * _inverse(normal)
    # What moves nothing is not known at all.
    covariance[np.diag_indices(len(start))] += np.where(np.diag(normal) > 0, 0.0, np.inf)
    return Fit(point.parameters, covariance, correlation, structured, (n * channels - len(start)) / widening)


@dataclass(frozen=True, eq=False)
class _Point:
    """Parameters (p,), their residuals (n, channels), and the slopes of these (n, channels, p)."""

    parameters: Array
    residual: Array
    slopes: Array


def _at(model: Model, data: Array, p: Array, lower: Array, upper: Array) -> _Point:
    """Value and slopes, from one batch: that takes hardly longer than a single run."""
    steps = np.where(p + _STEP > upper, -_STEP, _STEP)  # they point into the limits
    with np.errstate(all="ignore"):  # what diverges is put right below
        moved = model(np.column_stack([p, p[:, None] + np.diag(steps)]))
        residual = np.clip(np.nan_to_num(moved[:, :, 0] - data, nan=_HUGE), -_HUGE, _HUGE)
        slopes = (moved[:, :, 1:] - moved[:, :, :1]) / steps
    return _Point(p, residual, np.nan_to_num(np.clip(slopes, -_HUGE, _HUGE)))


def _minimise(model: Model, data: Array, point: _Point, weight: Array, lower: Array, upper: Array) -> _Point:
    """Levenberg–Marquardt between limits, on the normal equations: there are many rows and few parameters."""
    damping, cost = _DAMPING, _cost(point, weight)
    for _ in range(_EVALUATIONS):
        p, normal = point.parameters, _normal(point.slopes, weight)
        gradient = np.einsum("ncp,cd,nd->p", point.slopes, weight, point.residual, optimize=True)
        loose = ~((p <= lower) & (gradient > 0) | (p >= upper) & (gradient < 0)) & (np.diag(normal) > 0)
        step = np.zeros_like(p)
        inner = normal[np.ix_(loose, loose)]
        step[loose] = -np.linalg.lstsq(inner + damping * np.diag(np.diag(inner)), gradient[loose], rcond=None)[0]
        trial = _at(model, data, np.clip(p + step, lower, upper), lower, upper)
        gained = cost - _cost(trial, weight)
        if gained >= 0:
            point, cost, damping = trial, cost - gained, damping / 10
        else:
            damping *= 10
        if abs(gained) <= _PRECISION * cost or damping > 1 / _PRECISION:
            break
    return point


def _cost(point: _Point, weight: Array) -> float:
    return float(np.sum((point.residual @ weight) * point.residual))


def _normal(slopes: Array, weight: Array) -> Array:
    """Normal matrix (p, p) of weighted slopes."""
    return np.einsum("ncp,cd,ndq->pq", slopes, weight, slopes, optimize=True)


def _inverse(normal: Array) -> Array:
    """Inverse of a normal matrix, scaled so that parameters of any size come out alike."""
    size = np.sqrt(np.where(np.diag(normal) > 0, np.diag(normal), 1.0))
    return np.asarray(np.linalg.pinv(normal / np.outer(size, size), hermitian=True)) / np.outer(size, size)


def _scatter(point: _Point, normal: Array, weight: Array, correlated: bool) -> Array:
    """Covariance (channels, channels) of the residuals.

    Each channel's residuals have lost the freedom that the parameters took from it, which the diagonal of the hat
    matrix counts.
    """
    taken = np.einsum("pq,ncp,cd,ndq->c", _inverse(normal), point.slopes, weight, point.slopes, optimize=True)
    spare = np.sqrt(np.maximum(len(point.residual) - taken, 1.0))
    covariance = point.residual.T @ point.residual / np.outer(spare, spare)
    return covariance if correlated else np.diag(np.diag(covariance))
