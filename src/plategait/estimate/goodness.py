"""Goodness of fit: whether any parameters explain the data."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.estimate.likelihood import SURPRISE, Likelihood
from plategait.estimate.posterior import Posterior

# The data are not explained where chance alone would give so bad a fit less often than this.
SIGNIFICANCE = 0.01
# Points whose odds of being outliers exceed this are named.
OUTLIER_ODDS = 0.5
# Share of the rates beyond which outliers are no exception.
MOST_OUTLIERS = 0.25
# A noise that had to be taken larger than this explains nothing.
LARGEST_NOISE = 0.15
# Permutations of the residuals, and how many of them there must be to permute.
PERMUTATIONS, LEAST_RESIDUALS = 4000, 6


@dataclass(frozen=True)
class Goodness:
    """How well the best parameters explain the data.

    Attributes
    ----------
    chi2 : float
        Squared deviations of the inliers from the best prediction, in units of their spread.
    freedom : int
        Inliers less parameters.
    p : float
        Probability of a fit as bad by chance.
    p_runs : float
        Probability by chance of residuals that hang together as much over the plate frequency.
    n_outliers, n_rates : int
        Rates that are probably outliers, of how many.
    outliers : tuple of float
        Their plate frequencies, Hz.
    run_off_missed : bool
        Whether no parameters run off where the object did.
    noise : float
        Median relative noise that was needed; NaN where the data came with theirs.
    """

    chi2: float
    freedom: int
    p: float
    p_runs: float
    n_outliers: int
    n_rates: int
    outliers: tuple[float, ...]
    run_off_missed: bool
    noise: float

    @property
    def explained(self) -> bool:
        """Whether the data are explained."""
        return not self.complaints

    @property
    def complaints(self) -> tuple[str, ...]:
        """What is wrong, in words; empty where the data are explained."""
        return tuple(self._complaints())

    def _complaints(self) -> Iterator[str]:
        if self.p < SIGNIFICANCE:
            yield f"the rates lie further from every prediction than their noise allows (p = {self.p:.1g})"
        if self.p_runs < SIGNIFICANCE:
            yield f"the rates lie above and below the best prediction in stretches (p = {self.p_runs:.1g})"
        if self.n_outliers > max(1, MOST_OUTLIERS * self.n_rates):
            yield f"{self.n_outliers} of {self.n_rates} rates would have to be outliers"
        if self.run_off_missed:
            yield "no parameters that fit the rates run off where the object did"
        if self.noise > LARGEST_NOISE:
            yield f"only a noise of {100 * self.noise:.0f} % would explain the rates"


def goodness_of_fit(posterior: Posterior) -> Goodness:
    """Compare the data with the best of the samples."""
    from scipy.special import chdtrc

    likelihood, data = posterior.likelihood, posterior.data
    best = posterior.full[[int(np.argmax(likelihood(posterior.full)))]]
    outlying = _outlying(posterior)
    deviation = np.where(outlying, 0.0, _deviation(likelihood, best))
    frequency = data.frequency[data.rated]
    freedom = int((~outlying).sum()) - best.shape[1]
    chi2 = float(np.sum(deviation**2))
    return Goodness(
        chi2=chi2,
        freedom=freedom,
        p=float(chdtrc(freedom, chi2)) if freedom > 0 else 1.0,
        p_runs=_p_runs(deviation[np.argsort(frequency, kind="stable")]),
        n_outliers=int(outlying.sum()),
        n_rates=len(outlying),
        outliers=tuple(float(f) for f in np.unique(frequency[outlying])),
        run_off_missed=bool(likelihood.run_off_terms(best).min() < math.log(2 * SURPRISE)),
        noise=float(np.median(posterior.noise)) if likelihood.noise_is_unknown else math.nan,
    )


def _deviation(likelihood: Likelihood, sample: Array) -> Array:
    """Deviations (points,) of the rates from the prediction of one sample (1, d), in units of their spread."""
    parameters, noise = likelihood.split(sample)
    predicted = likelihood.predicted(parameters)
    return (likelihood.data.rate[likelihood.data.rated] - predicted)[0] / likelihood.spread(predicted, noise)[0]


def _outlying(posterior: Posterior) -> NDArray[np.bool_]:
    """Rated points (points,) that are probably outliers, over some five hundred of the samples."""
    inlier, outlier = posterior.likelihood.point_terms(posterior.full[:: max(1, len(posterior.full) // 500)])
    return np.mean(1 / (1 + np.exp(np.clip(inlier - outlier, -50, 50))), axis=0) > OUTLIER_ODDS


def _p_runs(deviation: Array) -> float:
    """Probability by chance of neighbouring residuals as alike as these: a permutation test, one-sided."""
    if len(deviation) < LEAST_RESIDUALS:
        return 1.0
    shuffled = np.random.default_rng(0).permuted(np.tile(deviation, (PERMUTATIONS, 1)), axis=1)
    alike = np.sum(shuffled[:, 1:] * shuffled[:, :-1], axis=1)
    return float((1 + np.sum(alike >= np.sum(deviation[1:] * deviation[:-1]))) / (1 + len(alike)))
