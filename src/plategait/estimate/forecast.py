"""What to expect of candidate measurements: the rate and the run-off of every sample of the posterior under each."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plategait.arrays import Array
from plategait.estimate.candidates import Reach, alike
from plategait.estimate.emulator import RateEmulator, RunOffEmulator, fit_rates, fit_run_off
from plategait.estimate.likelihood import LEAST_NOISE
from plategait.estimate.observations import Condition
from plategait.estimate.posterior import Posterior
from plategait.estimate.runs import EngineRuns, run_engine

DRAWS = 40  # of the posterior that the engine runs: enough for a quadratic of three unknowns
MORE_DRAWS = 8  # for each unknown beyond
SAMPLES = 2000  # of the posterior, for which the emulators stand in
# Quantiles of the run-off frequency at which there are candidates too.
RUN_OFF_QUANTILES = (0.2, 0.35, 0.5, 0.65, 0.8)
USUAL_NOISE = 0.05  # relative, where the data came with their own
UNINFORMATIVE = 1e6  # noise of what no emulator tells
LEAST_EFFECTIVE = 40  # samples, fewer of which say nothing of a spread
MOST_MEASUREMENTS = 40
FUTURES = 8


@dataclass(frozen=True, eq=False)
class Forecast:
    """Samples of the posterior with what to expect of each under every candidate.

    Attributes
    ----------
    conditions : tuple of Condition
        The candidates.
    values : (n, d) array
        Samples, SI.
    outcome, sd : (n, c, q) arrays
        What a measurement reads, and its noise: the spin rate, deg/s, then each observable that the data have, SI.
        How far the model may be off is part of the noise.
    stays : (n, c) array
        Probability that the object stays on the plate.
    once : bool
        Whether a motion tells nothing more the second time, as the model is off by the same again.
    """

    conditions: tuple[Condition, ...]
    values: Array
    outcome: Array
    sd: Array
    stays: Array
    once: bool = False

    @cached_property
    def even(self) -> Array:
        """Weights (n,) before any further measurement."""
        return np.full(len(self.values), 1 / len(self.values))

    def variances(self, weight: Array) -> Array:
        """Weighted variance (d,) of the parameters."""
        mean = weight @ self.values
        return weight @ (self.values - mean) ** 2

    def expected_variances(self, weight: Array) -> Array:
        """Variance (c, d) of the parameters to expect after each candidate, its readings taken as Gaussian."""
        stays = weight[:, None] * self.stays
        fails = weight[:, None] - stays
        return self._share(stays, rated=True) + self._share(fails, rated=False)

    def _share(self, weight: Array, rated: bool) -> Array:
        """Share of the expected variance (c, d) that comes of one outcome, with weights (n, c)."""
        total = weight.sum(axis=0) + 1e-300
        share = weight / total
        mean = share.T @ self.values
        variance = np.maximum(share.T @ self.values**2 - mean**2, 0.0)
        if rated:
            deviation = self.outcome - np.einsum("nc,ncq->cq", share, self.outcome)
            noise = np.einsum("nc,ncq->cq", share, self.sd**2)
            # Each reading in units of its own spread, of which none is left where no sample stays.
            scale = np.sqrt(np.einsum("nc,ncq->cq", share, deviation**2) + noise) + 1e-150
            deviation = deviation / scale
            spread = np.einsum("nc,ncq,ncp->cqp", share, deviation, deviation)
            spread += (noise / scale**2 + 1e-12)[:, :, None] * np.eye(noise.shape[1])
            covariance = np.einsum("nc,ncq,nd->cqd", share, deviation, self.values)
            explained = np.sum(covariance * np.linalg.solve(spread, covariance), axis=1)
            variance = np.maximum(variance - explained, 0.0)
        return total[:, None] * variance

    def measured(self, weight: Array, candidate: int, truth: int, generator: np.random.Generator) -> Array:
        """Weights (n,) after one candidate is measured, were one of the samples the truth."""
        stays = self.stays[:, candidate]
        if generator.random() < stays[truth]:
            outcome, sd = self.outcome[:, candidate], self.sd[:, candidate]
            seen = generator.normal(outcome[truth], sd[truth])
            score = np.sum(-0.5 * ((seen - outcome) / sd) ** 2 - np.log(sd), axis=1)
            weight = weight * stays * np.exp(score - score.max())
        else:
            weight = weight * (1 - stays)
        return weight / weight.sum()


def forecast_of(
    posterior: Posterior,
    reach: Reach,
    *,
    noise: float | None = None,
    seed: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Forecast:
    """Run the engine at draws of the posterior under candidates, and emulate it at many more samples.

    Parameters
    ----------
    posterior : Posterior
    reach : Reach
        What the plate can make.
    noise : float, optional
        Relative noise of a measurement; that of the posterior if left out.
    seed : int
    progress : callable, optional
        Called with the fraction done.
    """
    generator = np.random.default_rng(seed)
    size = DRAWS + MORE_DRAWS * max(0, posterior.u.shape[1] - 3)
    draws = posterior.u[generator.choice(len(posterior.u), size, replace=False)]
    samples = posterior.u[generator.choice(len(posterior.u), SAMPLES, replace=False)]
    grid = reach.grid(seed)
    amplitudes = list(dict.fromkeys(c.amplitude for c in grid))
    readings = posterior.data.readings
    names = [r.name for r in readings]
    runs = run_engine(posterior.unknowns, draws, grid, handling=posterior.data.handling, observables=names, seed=seed,
                      progress=progress)  # fmt: skip
    emulators = _Emulators.of(runs, amplitudes)
    median_noise = float(np.median(posterior.noise)) if noise is None else noise
    relative = np.array([median_noise if median_noise > 0 else USUAL_NOISE, *(r.relative for r in readings)])
    candidates = [*grid, *(c for a in amplitudes for c in _between(emulators, a, samples) if reach.allows(c))]
    model = _model_error(posterior, samples, len(relative))
    once = model is not None
    if once:
        seen = posterior.data.conditions
        candidates = [c for c in candidates if not any(alike(c, other) for other in seen)] or candidates
    columns = [emulators.expect(c, samples, relative) for c in candidates]
    outcome, sd, stays = (np.stack([column[k] for column in columns], axis=1) for k in range(3))
    if model is not None:
        sd = np.hypot(sd, model[:, None] * outcome)
    return Forecast(tuple(candidates), posterior.unknowns.values(samples), outcome, sd, stays, once)


def _model_error(posterior: Posterior, samples: Array, quantities: int) -> Array | None:
    """How far the model may be off (n, q), relative, at motions like those measured; None where it is taken as right.

    The amounts of its changes are common to all motions, their shapes unlike: each counts as a scatter by itself.
    """
    discrepancy = posterior.likelihood.discrepancy
    if discrepancy is None:
        return None
    squares = np.sum(discrepancy.changes(samples) ** 2, axis=1) + discrepancy.own**2
    return np.sqrt(np.mean(squares.reshape(len(samples), quantities, -1), axis=2))


@dataclass(frozen=True, eq=False)
class _Emulators:
    """What was read of every condition that the engine ran, and the run-off of every amplitude, over the parameters."""

    runs: EngineRuns
    rates: RateEmulator
    run_offs: dict[Condition, RunOffEmulator | None]

    @staticmethod
    def of(runs: EngineRuns, amplitudes: Sequence[Condition]) -> _Emulators:
        """Learn from runs, all of which count alike."""
        near = np.ones(len(runs.u), dtype=bool)
        run_offs = {a: fit_run_off(runs.u, *runs.brackets(a), near) for a in amplitudes}
        columns = np.concatenate([runs.rates, *runs.values.values()], axis=1)
        return _Emulators(runs, fit_rates(runs.u, columns, near), run_offs)

    def expect(self, condition: Condition, samples: Array, noise: Array) -> tuple[Array, Array, Array]:
        """What a measurement reads (n, q), its noise (n, q) and the probability to stay (n,) under one candidate.

        `noise` (q,) is relative.
        """
        from scipy.special import ndtr

        grid, run_off = self.runs.conditions, self.run_offs[condition.amplitude]
        nearest = min((i for i, c in enumerate(grid) if c.amplitude == condition.amplitude),
                      key=lambda i: abs(grid[i].frequency - condition.frequency))  # fmt: skip
        if run_off is not None:
            stays = ndtr((run_off(samples) - condition.frequency) / run_off.width)
        else:
            stays = np.full(len(samples), 1.0 - self.runs.failed[:, nearest].mean())
        columns = nearest + len(grid) * np.arange(len(noise))
        error = self.rates.error[columns]
        if grid[nearest].frequency != condition.frequency:
            error = np.full(len(noise), math.inf)
        learnt = np.isfinite(error)
        read = np.where(learnt, self.rates(samples)[:, columns], 0.0)
        # Where nothing was learnt, only whether it stays is told. No camera sees a rate better than a degree a second.
        least = np.where(np.arange(len(noise)) == 0, LEAST_NOISE, 1e-9)
        sd = np.where(learnt, np.hypot(noise * np.abs(read) + least, np.where(learnt, error, 0.0)), UNINFORMATIVE)
        return read, sd, stays


def _between(emulators: _Emulators, amplitude: Condition, samples: Array) -> list[Condition]:
    """Conditions between those that the engine ran, where the run-off is expected."""
    run_off = emulators.run_offs[amplitude]
    if run_off is None:
        return []
    return [amplitude.at(round(float(f), 2)) for f in np.quantile(run_off(samples), RUN_OFF_QUANTILES)]


def programme(forecast: Forecast, scale: Array, count: int) -> list[tuple[int, Array]]:
    """The next measurements one after the other, each the best after those before it, all known beforehand.

    Parameters
    ----------
    forecast : Forecast
    scale : (d,) array
        Standard deviations worth having, which set what matters how much.
    count : int

    Returns
    -------
    list of (candidate, (d,) array)
        And the variances expected after it: readings straight in the parameters and Gaussian, runs off as they come.
    """
    values = forecast.values - forecast.values.mean(axis=0)
    stays = forecast.stays / np.maximum(forecast.stays.sum(axis=0), 1e-300)
    prior = np.cov(values.T).reshape(values.shape[1], -1)
    inverse = np.linalg.inv(prior + 1e-12 * np.diag(np.diag(prior)))
    deviation = forecast.outcome - np.einsum("nc,ncq->cq", stays, forecast.outcome)
    slopes = np.einsum("nc,ncq,nd->cqd", stays, deviation, values) @ inverse
    # What a straight line leaves of a reading counts as noise of it.
    left = np.einsum("nc,ncq->cq", stays, (deviation - np.einsum("cqd,nd->ncq", slopes, values)) ** 2 + forecast.sd**2)
    probability, chosen = forecast.stays.mean(axis=0), []
    covariance, closed = prior, np.zeros(len(probability), dtype=bool)
    for _ in range(count):
        gain = slopes @ covariance  # (c, q, d)
        spread = gain @ slopes.transpose(0, 2, 1) + (left + 1e-300)[:, :, None] * np.eye(left.shape[1])
        told = gain.transpose(0, 2, 1) @ np.linalg.solve(spread, gain)
        after = covariance - probability[:, None, None] * told
        if closed.all():
            break
        loss = np.sum(np.diagonal(after, axis1=1, axis2=2) / scale**2, axis=1)
        best = int(np.argmin(np.where(closed, math.inf, loss)))
        covariance, closed[best] = after[best], forecast.once
        chosen.append((best, np.diag(covariance).copy()))
    return chosen


def measurements_needed(forecast: Forecast, scale: Array, goals: Array, seed: int) -> tuple[int, int, int]:
    """Least, median and most measurements until every precision is reached, over several futures.

    Parameters
    ----------
    forecast : Forecast
    scale : (d,) array
        Standard deviations worth having, which set what matters how much.
    goals : (d,) array
        Standard deviations wanted; infinite where none is.
    seed : int
    """
    generator = np.random.default_rng(seed)
    counts = sorted(_future(forecast, scale, goals, generator) for _ in range(FUTURES))
    return counts[0], counts[len(counts) // 2], counts[-1]


def _future(forecast: Forecast, scale: Array, goals: Array, generator: np.random.Generator) -> int:
    """Measurements that one future takes, its truth one of the samples."""
    truth, weight = int(generator.integers(len(forecast.values))), forecast.even
    closed = np.zeros(len(forecast.conditions), dtype=bool)
    for count in range(MOST_MEASUREMENTS):
        sd = np.sqrt(forecast.variances(weight))
        if (sd <= goals).all():
            return count
        if count and 1 / np.sum(weight**2) < LEAST_EFFECTIVE:
            # Too few samples left to go on: from here the spread falls with the root of the number.
            return min(MOST_MEASUREMENTS, math.ceil(count * float(np.max(sd / goals)) ** 2))
        if closed.all():
            break
        loss = np.sum(forecast.expected_variances(weight) / scale**2, axis=1)
        best = int(np.argmin(np.where(closed, math.inf, loss)))
        weight, closed[best] = forecast.measured(weight, best, truth, generator), forecast.once
    return MOST_MEASUREMENTS
