"""How probable the measured points are, given parameters: rates, run-offs, noise and outliers."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.estimate.discrepancy import Discrepancy
from plategait.estimate.emulator import RateEmulator, RunOffEmulator, fit_rates, fit_run_off
from plategait.estimate.observations import Condition, Observations
from plategait.estimate.runs import EngineRuns
from plategait.estimate.unknowns import Unknown

NOISE = Unknown(name="noise", low=0.005, high=0.3, logarithmic=True)
"""Relative standard deviation of the rates, an unknown of its own where the data do not come with theirs."""
LEAST_NOISE = 1.0  # deg/s, of a relative noise: no camera sees a rate better
# One rate in fifty may be anything, a slipped decimal point or a lost sign included: Cauchy, ten times as wide as its
# own noise. Its tail falls so slowly that no noise grows to take it in.
OUTLIER_SHARE = 0.02
OUTLIER_SPREAD = 10.0
# A run-off that no emulator foresaw: an island of stability, the plate knocked, the object cut unevenly.
SURPRISE = 0.01
# Runs near the data for each number of a plane through them, of which slopes are learnt; where fewer are, all runs.
LEAST_PLANE = 3
# Rounds in which the amounts of the model's error and the weights of the outliers are brought together.
REWEIGHTED = 3


@dataclass(frozen=True, eq=False)
class Likelihood:
    """Emulators of the rates, readings and run-offs that were measured, with the data beside them.

    Attributes
    ----------
    data : Observations
    rates : RateEmulator
        Of every condition, and after them of each reading at every condition.
    run_offs : dict
        Emulator by amplitude, None where the runs did not bracket the run-off.
    noise : float or None
        Relative noise where it is known and the data do not come with their own; None: the last parameter.
    discrepancy : Discrepancy or None
        Of the model; None takes it as right.
    wander : (columns,) array or None
        Scatter of each column of the rates where friction differs from point to point, in its unit.
    """

    data: Observations
    rates: RateEmulator
    run_offs: dict[Condition, RunOffEmulator | None]
    noise: float | None
    discrepancy: Discrepancy | None = None
    wander: Array | None = None

    @property
    def noise_is_unknown(self) -> bool:
        """Whether the noise is sampled with the parameters."""
        return self.noise is None and bool(np.isnan(self.data.sd[self.data.rated]).any())

    def split(self, u: Array) -> tuple[Array, Array]:
        """Parameters (n, d), and the relative noise (n,) of each sample."""
        if self.noise_is_unknown:
            return u[:, :-1], np.asarray(NOISE.value(u[:, -1]))
        return u, np.full(len(u), 0.0 if self.noise is None else self.noise)

    def predicted(self, parameters: Array) -> Array:
        """Rates and readings (n, points) as `Observations.compared` has them."""
        return self.rates(parameters)[:, self._columns]

    @cached_property
    def _columns(self) -> NDArray[np.int64]:
        compared = self.data.compared
        return compared.quantity * len(self.data.conditions) + compared.condition

    def spread(self, predicted: Array, noise: Array) -> Array:
        """Standard deviation (n, points) of points about the prediction: measurement, friction, chaos, emulator, model.

        The model's changes of known shape come on top: see `deviations`.
        """
        own = self.data.compared.sd
        relative = np.hypot(noise[:, None] * predicted, LEAST_NOISE)
        measured = np.where(np.isfinite(own), own, relative)
        if self.wander is not None:
            measured = np.hypot(measured, self.wander[self._columns])
        own = 0.0 if self.discrepancy is None else self.discrepancy.own[self._columns]
        return np.hypot(np.hypot(measured, own * predicted), self.error)

    @property
    def error(self) -> Array:
        """Error (points,) of the emulators."""
        return self.rates.error[self._columns]

    @property
    def emulated(self) -> NDArray[np.bool_]:
        """Points (points,) that are emulated: where enough of the engine's runs stayed on the plate."""
        return np.isfinite(self.error)

    def deviations(self, u: Array) -> tuple[Array, Array]:
        """Deviations (n, points) of the points from the prediction, in units of their spread, and amounts (n, k).

        The amounts of the model's changes are the likeliest for each sample; the squares of both add up to χ².
        """
        residuals = self._residuals(u)
        return residuals.deviation, residuals.amounts

    def point_terms(self, u: Array) -> tuple[Array, Array]:
        """Log densities (n, points) of the points as inliers, and as outliers; shares taken in."""
        residuals = self._residuals(u)
        return self._log_densities(residuals.deviation, residuals.spread)

    def _log_densities(self, deviation: Array, spread: Array) -> tuple[Array, Array]:
        log_normal = -0.5 * deviation**2 - np.log(spread) - 0.5 * math.log(math.tau)
        log_cauchy = -np.log1p((deviation / OUTLIER_SPREAD) ** 2) - np.log(OUTLIER_SPREAD * spread) - math.log(math.pi)
        inlier = np.where(self.emulated, log_normal, 0.0) + math.log1p(-OUTLIER_SHARE)
        outlier = np.where(self.emulated, log_cauchy, -math.inf) + math.log(OUTLIER_SHARE)
        return inlier, outlier

    def _residuals(self, u: Array) -> _Residuals:
        """What is left of the points once the likeliest amounts of the model's changes are taken off."""
        parameters, noise = self.split(u)
        predicted = self.predicted(parameters)
        spread = self.spread(predicted, noise)
        usable = np.where(self.emulated, spread, 1.0)
        off = (self.data.compared.value - predicted) / usable
        if self.discrepancy is None:
            return _Residuals(off, spread, np.zeros((len(u), 0)), np.zeros(len(u)))
        change = self.discrepancy.changes(parameters)[:, :, self._columns] * (predicted / usable)[:, None, :]
        return self._without_changes(off, spread, np.where(self.emulated, change, 0.0))

    def _without_changes(self, off: Array, spread: Array, change: Array) -> _Residuals:
        """Residuals (n, points) less what amounts of the changes (n, k, points) take off them, all in spreads.

        Amounts have a standard normal prior. Outliers pull at none: each point counts by its odds of being an inlier.
        """
        deviation = off
        amounts: Array = np.zeros(change.shape[:2])
        precision = np.eye(change.shape[1])
        for _ in range(REWEIGHTED):
            inlier, outlier = self._log_densities(deviation, np.where(self.emulated, spread, 1.0))
            counted = change / (1 + np.exp(np.clip(outlier - inlier, -50, 50)))[:, None, :]
            precision = counted @ change.transpose(0, 2, 1) + np.eye(change.shape[1])
            amounts = np.asarray(np.linalg.solve(precision, counted @ off[:, :, None])[:, :, 0], dtype=float)
            deviation = off - np.einsum("nk,nkp->np", amounts, change)
        _, log_precision = np.linalg.slogdet(precision)
        return _Residuals(deviation, spread, amounts, -0.5 * np.sum(amounts**2, axis=1) - 0.5 * log_precision)

    def run_off_terms(self, u: Array) -> Array:
        """Log probability (n, amplitudes) that the object begins to run off where it did."""
        parameters, _ = self.split(u)
        terms = []
        for amplitude, (low, high) in self.data.brackets().items():
            emulator = self.run_offs.get(amplitude)
            if emulator is None or (low == 0 and math.isinf(high)):
                terms.append(np.zeros(len(u)))
            else:
                terms.append(np.logaddexp(emulator.log_between(parameters, low, high), math.log(SURPRISE)))
        return np.stack(terms, axis=1)

    def __call__(self, u: Array) -> Array:
        """Log likelihood (n,) of samples (n, d or d + 1) of the unit cube."""
        residuals = self._residuals(u)
        inlier, outlier = self._log_densities(residuals.deviation, residuals.spread)
        points = np.logaddexp(inlier, outlier).sum(axis=1) + residuals.log_amounts
        return points + self.run_off_terms(u).sum(axis=1)


@dataclass(frozen=True, eq=False)
class _Residuals:
    """Deviations (n, points) in units of their spread (n, points), and the amounts (n, k) of the model's changes.

    `log_amounts` (n,) is what integrating over the amounts adds to the log likelihood at the likeliest ones.
    """

    deviation: Array
    spread: Array
    amounts: Array
    log_amounts: Array


def learn(
    data: Observations,
    runs: EngineRuns,
    near: NDArray[np.bool_],
    noise: float | None,
    discrepancy: Discrepancy | None = None,
    wandering: tuple[int, float] | None = None,
) -> Likelihood:
    """Likelihood from the engine's runs; those `near` (n,) what was measured count most.

    `wandering` is a parameter's place among the unknowns and its standard deviation from point to point, as a share of
    its prior.
    """
    run_offs = {}
    for amplitude in data.brackets():
        emulator = fit_run_off(runs.u, *runs.brackets(amplitude), near)
        if emulator is not None and discrepancy is not None:
            emulator = replace(emulator, width=math.hypot(emulator.width, discrepancy.run_off(amplitude)))
        run_offs[amplitude] = emulator
    wander = None if wandering is None else scatter_of(runs.u, runs.columns(), near, *wandering)
    return Likelihood(data, fit_rates(runs.u, runs.columns(), near), run_offs, noise, discrepancy, wander)


def scatter_of(u: Array, columns: Array, near: NDArray[np.bool_], which: int, sd: float) -> Array:
    """Scatter (c,) of columns (n, c) where one parameter scatters by `sd`: by their slope near the data.

    Slopes are those of a plane through the runs that stayed; of a column of which few did, none is told.
    """
    rows = near if near.sum() >= LEAST_PLANE * (u.shape[1] + 1) else np.ones(len(u), dtype=bool)
    terms = np.column_stack([np.ones(len(u)), u])
    scatter = np.zeros(columns.shape[1])
    for c in range(columns.shape[1]):
        use = rows & np.isfinite(columns[:, c])
        if use.sum() > terms.shape[1] + 1:
            plane = np.linalg.lstsq(terms[use], columns[use, c], rcond=None)[0]
            scatter[c] = abs(plane[1 + which]) * sd
    return scatter
