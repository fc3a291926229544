"""Batches of a food told apart by spin rates: a linear rule learnt on other objects, and how often it is wrong."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array

_BATCHES = 400
"""Batches that are drawn from the objects."""


@dataclass(frozen=True, eq=False)
class Rule:
    """Fisher's linear discriminant between fresh and aged objects.

    Attributes
    ----------
    weights, middle : (k,) arrays
        Of what is measured of an object.
    """

    weights: Array
    middle: Array

    def scores(self, seen: Array) -> Array:
        """Score of each object (n, k): -1/2 in the mean of the fresh ones it was learnt on, 1/2 in that of the aged."""
        return np.asarray((seen - self.middle) @ self.weights, dtype=np.float64)


def learn_rule(fresh: Array, aged: Array) -> Rule:
    """Rule from objects (n, k) whose batch is known.

    The weights are those of R. A. Fisher, The use of multiple measurements in taxonomic problems (1936): the means'
    difference over the covariance within the batches, scaled so that the means are 1 apart.
    """
    apart = aged.mean(axis=0) - fresh.mean(axis=0)
    within = np.cov(np.concatenate([fresh - fresh.mean(axis=0), aged - aged.mean(axis=0)]).T, ddof=2)
    weights = np.linalg.solve(np.atleast_2d(within), apart)
    return Rule(weights / (apart @ weights), (fresh.mean(axis=0) + aged.mean(axis=0)) / 2)


def batch_scores(scores: Array, size: int, seed: int, count: int = _BATCHES) -> Array:
    """(count,) mean scores of batches of so many objects, drawn from those (n,) that were measured."""
    drawn = np.random.default_rng([seed, size]).integers(len(scores), size=(count, size))
    return np.asarray(scores[drawn].mean(axis=1), dtype=np.float64)


def told_wrong(fresh: Array, aged: Array, size: int) -> float:
    """Share of batches that are told wrong by the sign of their mean score, as often fresh as aged ones."""
    if size == 1:
        return float((np.mean(fresh > 0) + np.mean(aged < 0)) / 2)
    return float((np.mean(batch_scores(fresh, size, 1) > 0) + np.mean(batch_scores(aged, size, 2) < 0)) / 2)


def told_apart(one: Array, other: Array, size: int) -> float:
    """Share of pairs of batches that are said to differ: whose mean scores differ by more than 1/2."""
    return float(np.mean(np.abs(batch_scores(one, size, 3) - batch_scores(other, size, 4)) > 0.5))


def told_aged(fresh: Array, aged: Array, size: int) -> float:
    """Share of pairs of batches of which the aged one is found: its mean score is more than 1/2 above the other's."""
    return float(np.mean(batch_scores(aged, size, 4) - batch_scores(fresh, size, 3) > 0.5))


def separation(fresh: Array, aged: Array) -> float:
    """Difference of the mean scores over the standard deviation within the batches."""
    return float((aged.mean() - fresh.mean()) / np.sqrt((fresh.var(ddof=1) + aged.var(ddof=1)) / 2))


def operating_curve(fresh: Array, aged: Array) -> tuple[Array, Array]:
    """False alarms among the fresh and hits among the aged, at every threshold of the score."""
    at = np.sort(np.concatenate([[-np.inf], fresh, aged, [np.inf]]))[::-1]
    return np.array([np.mean(fresh > t) for t in at]), np.array([np.mean(aged > t) for t in at])
