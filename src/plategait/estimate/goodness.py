"""Goodness of fit: whether any parameters explain the data, by what the posterior itself would have given instead.

Each sample of the posterior predicts rates about which measured ones scatter. The measured residuals are held against
what such scatter gives by chance, sample by sample, and the probabilities averaged: posterior predictive p-values
(Gelman, Meng and Stern, 1996), which take the noise as uncertain as it is.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.estimate.likelihood import Likelihood
from plategait.estimate.observations import Observations
from plategait.estimate.posterior import Posterior

# The data are not explained where chance alone would give so bad a fit less often than this.
SIGNIFICANCE = 0.01
# Points whose odds of being outliers exceed this are named.
OUTLIER_ODDS = 0.5
# Share of the rates beyond which outliers are no exception.
MOST_OUTLIERS = 0.25
# A noise that had to be taken larger than this explains nothing.
LARGEST_NOISE = 0.15
# Samples that the data are held against.
DRAWS = 500
# Replicas of the residuals, and how many of these there must be to hang together.
REPLICAS, LEAST_RESIDUALS = 4000, 6


@dataclass(frozen=True)
class Goodness:
    """How well the parameters of the posterior explain the data.

    Attributes
    ----------
    chi2 : float
        Squared deviations of the inliers from the prediction, in units of their spread: median over the posterior.
    inliers : int
        Rates that count in it; about as large as `chi2` where the data are explained.
    p : float
        Posterior predictive probability of deviations as large.
    p_runs : float
        Posterior predictive probability of residuals that hang together as much over the plate frequency.
    n_outliers, n_rates : int
        Rates and readings that are probably outliers, of how many.
    outliers : tuple of float
        Plate frequencies of the rates among them, Hz.
    outlying_readings : tuple of str
        The readings among them, in words.
    read : bool
        Whether there are readings beside the rates.
    run_offs : tuple of str
        Where the object stayed or ran off against every prediction, in words.
    noise : float
        Median relative noise that was needed; NaN where the data came with theirs.
    """

    chi2: float
    inliers: int
    p: float
    p_runs: float
    n_outliers: int
    n_rates: int
    outliers: tuple[float, ...]
    run_offs: tuple[str, ...]
    noise: float
    outlying_readings: tuple[str, ...] = ()
    read: bool = False

    @property
    def explained(self) -> bool:
        """Whether the data are explained."""
        return not self.complaints

    @property
    def complaints(self) -> tuple[str, ...]:
        """What is wrong, in words; empty where the data are explained."""
        return tuple(self._complaints())

    @property
    def _points(self) -> str:
        return "rates and readings" if self.read else "rates"

    def _complaints(self) -> Iterator[str]:
        if self.p < SIGNIFICANCE:
            yield f"the {self._points} lie further from every prediction than their noise allows (p = {self.p:.1g})"
        if self.p_runs < SIGNIFICANCE:
            yield f"the {self._points} lie above and below the predictions in stretches (p = {self.p_runs:.1g})"
        if self.n_outliers > max(1, MOST_OUTLIERS * self.n_rates):
            yield f"{self.n_outliers} of {self.n_rates} {self._points} would have to be outliers"
        yield from self.run_offs
        if self.noise > LARGEST_NOISE:
            yield f"only a noise of {100 * self.noise:.0f} % would explain the rates"


def goodness_of_fit(posterior: Posterior) -> Goodness:
    """Hold the data against the samples of the posterior."""
    from scipy.special import chdtrc

    likelihood, data = posterior.likelihood, posterior.data
    draws = posterior.full[:: max(1, len(posterior.full) // DRAWS)]
    outlying = _outlying(likelihood, draws)
    counts = ~outlying & likelihood.emulated
    frequency = np.array([data.conditions[i].frequency for i in data.compared.condition])
    # Neighbours are of one quantity: errors of a rate and of a reading at one frequency have nothing to do.
    order = np.lexsort((frequency[counts], data.compared.quantity[counts]))
    deviation, amounts = likelihood.deviations(draws)
    deviation = deviation[:, counts][:, order]
    chi2 = np.sum(deviation**2, axis=1) + np.sum(amounts**2, axis=1)
    return Goodness(
        chi2=float(np.median(chi2)),
        inliers=int(counts.sum()),
        p=float(np.mean(chdtrc(counts.sum(), chi2))) if counts.any() else 1.0,
        p_runs=_p_runs(deviation),
        n_outliers=int(outlying.sum()),
        n_rates=len(outlying),
        outliers=tuple(float(f) for f in np.unique(frequency[outlying & (data.compared.quantity == 0)])),
        outlying_readings=tuple(_outlying_readings(data, outlying)),
        read=bool(data.readings),
        run_offs=tuple(_run_offs(likelihood, draws)),
        noise=float(np.median(posterior.noise)) if likelihood.noise_is_unknown else math.nan,
    )


def _outlying(likelihood: Likelihood, draws: Array) -> NDArray[np.bool_]:
    """Rated points (points,) that are probably outliers."""
    inlier, outlier = likelihood.point_terms(draws)
    return np.mean(1 / (1 + np.exp(np.clip(inlier - outlier, -50, 50))), axis=0) > OUTLIER_ODDS


def _outlying_readings(data: Observations, outlying: NDArray[np.bool_]) -> Iterator[str]:
    """Readings that are probably outliers, in words."""
    for i in np.flatnonzero(outlying & (data.compared.quantity > 0)):
        reading = data.readings[data.compared.quantity[i] - 1]
        condition = data.conditions[data.compared.condition[i]]
        yield f"{reading.observable.label} at {condition.frequency:g} Hz"


def _p_runs(deviation: Array) -> float:
    """Posterior predictive probability of neighbours as alike as these deviations (draws, points): one-sided."""
    if deviation.shape[1] < LEAST_RESIDUALS:
        return 1.0
    replicas = np.sort(_likeness(np.random.default_rng(0).normal(size=(REPLICAS, deviation.shape[1]))))
    beyond = len(replicas) - np.searchsorted(replicas, _likeness(deviation))
    return float(np.mean((1 + beyond) / (1 + len(replicas))))


def _likeness(deviation: Array) -> Array:
    """Correlation (n,) of neighbouring deviations (n, points)."""
    alike = np.sum(deviation[:, 1:] * deviation[:, :-1], axis=1)
    return alike / np.maximum(np.sum(deviation**2, axis=1), 1e-300)


def _run_offs(likelihood: Likelihood, draws: Array) -> Iterator[str]:
    """Where the object stayed though whatever fits has run off there, or ran off where whatever fits stays."""
    parameters, _ = likelihood.split(draws)
    for amplitude, (low, high) in likelihood.data.brackets().items():
        emulator = likelihood.run_offs.get(amplitude)
        if emulator is None:
            continue
        if np.mean(np.exp(emulator.log_between(parameters, low, math.inf))) < SIGNIFICANCE:
            yield f"it stayed at {low:.4g} Hz, where whatever fits the rates has run off"
        if math.isfinite(high) and np.mean(np.exp(emulator.log_between(parameters, 0.0, high))) < SIGNIFICANCE:
            yield f"it ran off at {high:.4g} Hz, where whatever fits the rates stays"
