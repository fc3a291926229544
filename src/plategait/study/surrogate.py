"""What the simulations would give under choices that were not run: quadratic in the unknowns, learnt from some."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array

RIDGES = 10.0 ** np.arange(-2, 4)
"""Penalties on the coefficients that are tried; leaving out one evaluation in turn decides."""
# Outputs known of fewer evaluations than this share are not learnt.
LEAST_SHARE = 0.5


@dataclass(frozen=True, eq=False)
class Surrogate:
    """Outputs over the unknowns.

    Attributes
    ----------
    coefficients : (terms, outputs) array
    error : (outputs,) array
        Root mean square of what it misses of an evaluation that was left out: its own error, and chaos. Infinite for an
        output that is not learnt.
    """

    coefficients: Array
    error: Array

    def __call__(self, x: Array) -> Array:
        """Outputs (n, outputs) at standardised unknowns (n, d)."""
        return _terms(x) @ self.coefficients


def _terms(x: Array) -> Array:
    """(n, terms) constant, linear, squares and products."""
    one, other = np.triu_indices(x.shape[1], 1)
    return np.column_stack([np.ones(len(x)), x, x**2, x[:, one] * x[:, other]])


def learn(x: Array, outputs: Array, weight: Array | None = None) -> Surrogate:
    """Learn outputs (n, outputs), NaN where there is none, at standardised unknowns (n, d).

    Parameters
    ----------
    weight : (n,) array, optional
        How much each evaluation counts; all alike by default.
    """
    terms = _terms(x)
    weight = np.ones(len(x)) if weight is None else weight
    coefficients = np.zeros((terms.shape[1], outputs.shape[1]))
    error = np.full(outputs.shape[1], np.inf)
    # Outputs that the same evaluations have are learnt together.
    patterns, group = np.unique(np.isfinite(outputs), axis=1, return_inverse=True)
    for number, rows in enumerate(patterns.T):
        columns = np.flatnonzero(group.ravel() == number)
        if rows.mean() >= LEAST_SHARE:
            coefficients[:, columns], error[columns] = _ridge(terms[rows], outputs[np.ix_(rows, columns)], weight[rows])
    return Surrogate(coefficients, error)


def _ridge(terms: Array, y: Array, weight: Array) -> tuple[Array, Array]:
    """Coefficients (terms, k) of the penalty under which an evaluation that is left out is met best, and errors (k,).

    Leaving one out changes its residual by 1/(1 - h), h the diagonal of the hat matrix.
    """
    root = np.sqrt(weight)[:, None]
    centre = np.average(y, axis=0, weights=weight)
    wanted = root * (y - centre)
    u, s, vt = np.linalg.svd(root * terms, full_matrices=False)
    projected = u.T @ wanted
    best, least = np.zeros((terms.shape[1], y.shape[1])), np.full(y.shape[1], np.inf)
    for ridge in RIDGES:
        shrink = (s**2 / (s**2 + ridge))[:, None]
        leverage = np.minimum((u**2) @ shrink, 1 - 1e-6)
        residual = (wanted - u @ (shrink * projected)) / (1 - leverage)
        error = np.sqrt((residual**2).sum(axis=0) / weight.sum())
        better = error < least
        least[better] = error[better]
        best[:, better] = (vt.T @ (shrink / s[:, None] * projected))[:, better]
    best[0] += centre
    return best, least
