"""Kriging: regression by a Gaussian process, whose relevance of each input is learnt."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plategait.arrays import Array

_JITTER = 1e-6
# Ends of what is learnt, as logarithms: length scales over the inputs' spread, variances over that of the values.
_LENGTHS, _SIGNAL, _NOISE = (-2.0, 6.0), (-3.0, 6.0), (-8.0, 1.0)


@dataclass(frozen=True, eq=False)
class Kriging:
    """A Gaussian process with a squared-exponential kernel, conditioned on what was seen.

    Attributes
    ----------
    inputs : (n, d) array
    values : (n,) array
    lengths : (d,) array
        Over which each input matters, in standard deviations of the inputs; long for one that does not.
    signal, noise : float
        Variances, over that of the values.
    """

    inputs: Array
    values: Array
    lengths: Array
    signal: float
    noise: float

    def __call__(self, at: Array) -> tuple[Array, Array]:
        """Mean and standard deviation (m,) of a value at inputs (m, d), what no input tells included."""
        centre, spread = self._scales
        kernel = self.signal * _kernel(((at - centre) / spread)[:, None], self._scaled[None], self.lengths)
        mean = kernel @ (self._inverse @ self._whitened)
        variance = self.signal + self.noise - np.einsum("ij,jk,ik->i", kernel, self._inverse, kernel)
        return (
            self.values.mean() + self.values.std() * mean,
            self.values.std() * np.sqrt(np.maximum(variance, self.noise)),
        )

    def left_out(self) -> Array:
        """(n,) value less what all others say of it."""
        away = self.values.std() * (self._inverse @ self._whitened) / np.diag(self._inverse)
        return np.asarray(away, dtype=np.float64)

    @cached_property
    def _scales(self) -> tuple[Array, Array]:
        return self.inputs.mean(axis=0), self.inputs.std(axis=0)

    @cached_property
    def _scaled(self) -> Array:
        centre, spread = self._scales
        return (self.inputs - centre) / spread

    @cached_property
    def _whitened(self) -> Array:
        return (self.values - self.values.mean()) / self.values.std()

    @cached_property
    def _inverse(self) -> Array:
        kernel = self.signal * _kernel(self._scaled[:, None], self._scaled[None], self.lengths)
        return np.asarray(np.linalg.inv(kernel + (self.noise + _JITTER) * np.eye(len(kernel))), dtype=np.float64)


def _kernel(a: Array, b: Array, lengths: Array) -> Array:
    return np.exp(-0.5 * np.sum(((a - b) / lengths) ** 2, axis=-1))


def learn(inputs: Array, values: Array) -> Kriging:
    """Kriging of values (n,) over inputs (n, d), at the lengths and variances of the greatest likelihood."""
    from scipy.optimize import minimize

    x = (inputs - inputs.mean(axis=0)) / inputs.std(axis=0)
    y = (values - values.mean()) / values.std()
    squares = (x[:, None] - x[None]) ** 2
    dimensions = x.shape[1]

    def cost(log: Array) -> tuple[float, Array]:
        """Negative logarithm of the likelihood, and its slopes."""
        lengths, signal, noise = np.exp(log[:-2]), np.exp(log[-2]), np.exp(log[-1])
        smooth = signal * np.exp(-0.5 * squares @ lengths**-2)
        factor = np.linalg.cholesky(smooth + (noise + _JITTER) * np.eye(len(y)))
        inverse = np.linalg.inv(factor)
        inverse = inverse.T @ inverse
        weights = inverse @ y
        pull = np.outer(weights, weights) - inverse
        drawn = pull * smooth
        slopes = [-0.5 * np.sum(drawn * squares[:, :, j]) / lengths[j] ** 2 for j in range(dimensions)]
        value = 0.5 * y @ weights + np.sum(np.log(np.diag(factor)))
        return float(value), np.array([*slopes, -0.5 * np.sum(drawn), -0.5 * noise * np.trace(pull)])

    first = np.array([*np.full(dimensions, 1.0), 0.0, -1.5])
    found = minimize(cost, first, jac=True, method="L-BFGS-B", bounds=[*[_LENGTHS] * dimensions, _SIGNAL, _NOISE])
    return Kriging(inputs, values, np.exp(found.x[:-2]), float(np.exp(found.x[-2])), float(np.exp(found.x[-1])))
