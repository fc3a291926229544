"""How probable the measured points are, given parameters: rates, run-offs, noise and outliers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.estimate.emulator import RateEmulator, RunOffEmulator, fit_rates, fit_run_off
from plategait.estimate.observations import Observations
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
    """

    data: Observations
    rates: RateEmulator
    run_offs: dict[tuple[float, float], RunOffEmulator | None]
    noise: float | None

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
        """Standard deviation (n, points) of the points about the prediction: measurement, chaos, emulator."""
        own = self.data.compared.sd
        relative = np.hypot(noise[:, None] * predicted, LEAST_NOISE)
        measured = np.where(np.isfinite(own), own, relative)
        return np.hypot(measured, self.error)

    @property
    def error(self) -> Array:
        """Error (points,) of the emulators."""
        return self.rates.error[self._columns]

    @property
    def emulated(self) -> NDArray[np.bool_]:
        """Points (points,) that are emulated: where enough of the engine's runs stayed on the plate."""
        return np.isfinite(self.error)

    def deviations(self, u: Array) -> Array:
        """Deviations (n, points) of the points from the prediction of each sample, in units of their spread."""
        parameters, noise = self.split(u)
        predicted = self.predicted(parameters)
        return (self.data.compared.value - predicted) / self.spread(predicted, noise)

    def point_terms(self, u: Array) -> tuple[Array, Array]:
        """Log densities (n, points) of the points as inliers, and as outliers; shares taken in."""
        parameters, noise = self.split(u)
        predicted = self.predicted(parameters)
        sd = self.spread(predicted, noise)
        deviation = (self.data.compared.value - predicted) / np.where(self.emulated, sd, 1.0)
        log_normal = -0.5 * deviation**2 - np.log(sd) - 0.5 * math.log(math.tau)
        log_cauchy = -np.log1p((deviation / OUTLIER_SPREAD) ** 2) - np.log(OUTLIER_SPREAD * sd) - math.log(math.pi)
        inlier = np.where(self.emulated, log_normal, 0.0) + math.log1p(-OUTLIER_SHARE)
        outlier = np.where(self.emulated, log_cauchy, -math.inf) + math.log(OUTLIER_SHARE)
        return inlier, outlier

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
        inlier, outlier = self.point_terms(u)
        return np.logaddexp(inlier, outlier).sum(axis=1) + self.run_off_terms(u).sum(axis=1)


def learn(data: Observations, runs: EngineRuns, near: NDArray[np.bool_], noise: float | None) -> Likelihood:
    """Likelihood from the engine's runs; those `near` (n,) what was measured count most."""
    run_offs = {}
    for amplitude in data.brackets():
        low, high = runs.brackets(amplitude)
        run_offs[amplitude] = fit_run_off(runs.u, low, high, near)
    columns = np.concatenate([runs.rates, *(runs.values[r.name] for r in data.readings)], axis=1)
    return Likelihood(data, fit_rates(runs.u, columns, near), run_offs, noise)
