"""The posterior of an object's parameters, with the engine in the loop.

The engine runs at parameters spread over the prior, emulators learn what it gives, a sampler finds where the data are
likely, and the engine runs there again: each round learns the emulators anew, nearer to what was measured.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.estimate.discrepancy import (
    ALTERNATIVES,
    WITHIN_THE_LAW,
    Change,
    Discrepancy,
    measure_discrepancy,
    presumed_discrepancy,
)
from plategait.estimate.emulator import SHARPEST_RUN_OFF, RunOffEmulator
from plategait.estimate.likelihood import LEAST_NOISE, Likelihood, learn
from plategait.estimate.observations import Observations
from plategait.estimate.particles import Particles, explore, folded, stratified
from plategait.estimate.runs import EngineRuns, run_engine
from plategait.estimate.unknowns import FRICTION_ANGLE, Unknowns
from plategait.shown import Shown

Progress = Callable[[float], object]

# A run-off that a round leaves at least this share as wide is as sharp as it gets.
NO_SHARPER = 0.8
# Log posterior below the best at which a walker has strayed: one in a million of normal ones in six dimensions.
STRAYED = 20.0
# Relative noise with which the parameter sets that other models run too are told from the rest.
ROUGHLY = 0.3


@dataclass(frozen=True)
class Effort:
    """How thoroughly the posterior is sought.

    Parameters
    ----------
    first_round, later_round : int
        Parameter sets that the engine runs in the first round, over the whole prior, and in each one after it. 48 teach
        a quadratic of three unknowns with half of them spare.
    more_per_unknown : int
        Further ones a round for each unknown beyond three.
    most_rounds : int
        After the first; at least one follows it.
    good_enough : float
        Share of the measurement's own error below which the emulators' errors end the rounds.
    near : float
        Log likelihood below the best within which runs lie near what was measured: four standard deviations.
    model_sets : int
        Parameter sets that other models run too, the likeliest after two rounds; with another law of friction those
        like the data of the first round before.
    walkers, steps, burn_in, thin : int
        Of the sampler; steps of each walker, of which the first are left out, and of the rest all but every so many.
    """

    first_round: int = 48
    later_round: int = 32
    more_per_unknown: int = 4
    most_rounds: int = 3
    good_enough: float = 0.3
    near: float = 8.0
    model_sets: int = 16
    walkers: int = 96
    steps: int = 400
    burn_in: int = 200
    thin: int = 5

    def rounds(self, dimensions: int) -> tuple[int, int]:
        """Parameter sets of the first round and of each later one, for so many unknowns."""
        more = self.more_per_unknown * max(0, dimensions - 3)
        return self.first_round + more, self.later_round + more


@dataclass(frozen=True, eq=False, repr=False)
class Posterior(Shown):
    """Samples of the parameters that the data allow.

    Attributes
    ----------
    unknowns : Unknowns
    data : Observations
    u : (n, d) array
        Samples as shares of the priors, the noise's left out.
    noise : (n,) array
        Relative noise of each sample; 0 where the data came with theirs.
    likelihood : Likelihood
        Of the last round.
    runs : EngineRuns
        Every run of the engine.
    full : (n, d or d + 1) array
        Samples with the noise's share, as `likelihood` takes them.
    """

    unknowns: Unknowns
    data: Observations
    u: Array
    noise: Array
    likelihood: Likelihood
    runs: EngineRuns
    full: Array

    @property
    def values(self) -> Array:
        """Samples (n, d), SI."""
        return self.unknowns.values(self.u)


@dataclass(frozen=True, eq=False)
class _Round:
    """What is known after a round: every run so far, what was learnt of them, and where the data are likely."""

    runs: EngineRuns
    likelihood: Likelihood
    particles: Particles


def estimate_posterior(
    data: Observations,
    unknowns: Unknowns,
    *,
    noise: float | None = None,
    model_error: float = 0.0,
    any_law: bool = False,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
    effort: Effort | None = None,
) -> Posterior:
    """Sample the posterior.

    Parameters
    ----------
    data : Observations
    unknowns : Unknowns
    noise : float, optional
        Relative noise of the rates that come without a spread of their own; estimated too if left out.
    model_error : float
        How far the model may be off, as a share of what other models change: see `plategait.estimate.discrepancy`.
    any_law : bool
        Whether the law of friction may be another one too.
    seed : int
        Of the sampling.
    threads : int, optional
        Cores for the engine; all by default.
    progress : callable, optional
        Called with the fraction done.
    effort : Effort, optional
        How thoroughly.

    Returns
    -------
    Posterior
    """
    effort = effort or Effort()
    generator = np.random.default_rng(seed)
    dimensions = len(unknowns.parameters)
    first, later = effort.rounds(dimensions)
    wandering = _wandering(unknowns, data)

    def run(u: Array, before: int, changed: Change | None = None) -> EngineRuns:
        report = None if progress is None else _part(progress, before, len(u), first + 2 * later)
        names, handling = [r.name for r in data.readings], data.handling
        return run_engine(unknowns, u, data.conditions, handling=handling, observables=names, changed=changed,
                          seed=seed + before, threads=threads, progress=report)  # fmt: skip

    def compared_with_others(own: EngineRuns) -> Discrepancy:
        alternatives = ALTERNATIVES if any_law else WITHIN_THE_LAW
        return measure_discrepancy(lambda change: run(own.u, first, change), own, model_error, alternatives)

    def learn_from(runs: EngineRuns, near: NDArray[np.bool_]) -> _Round:
        likelihood = learn(data, runs, near, noise, discrepancy, wandering)
        return _Round(runs, likelihood, explore(likelihood, dimensions + likelihood.noise_is_unknown, generator))

    runs = run(stratified(first, dimensions, generator), 0)
    discrepancy = None
    if model_error > 0:  # another law of friction may lead elsewhere from the start
        like = runs.of(_like(data, runs, effort.model_sets)) if any_law else None
        discrepancy = compared_with_others(like) if like else presumed_discrepancy(runs, model_error)
    latest = learn_from(runs, np.ones(first, dtype=bool))
    u = _promising(latest.particles, dimensions, later, generator)
    before = None
    for later_round in range(effort.most_rounds):
        runs = latest.runs.joined(run(u, len(latest.runs.u)))
        latest = learn_from(runs, _near(latest.likelihood, runs.u, effort.near))
        if later_round == 0 and model_error > 0:  # compared where the data are likely
            likeliest = np.argsort(-_scores(latest.likelihood, runs.u), kind="stable")[: effort.model_sets]
            discrepancy = compared_with_others(runs.of(likeliest))
            latest = learn_from(runs, _near(latest.likelihood, runs.u, effort.near))
        if _emulates(latest, before, effort.good_enough, generator):
            break
        before, u = latest, _promising(latest.particles, dimensions, later, generator)
    full = _sample(latest, effort, generator)
    parameters, sampled_noise = latest.likelihood.split(full)
    return Posterior(unknowns, data, parameters, sampled_noise, latest.likelihood, latest.runs, full)


def _wandering(unknowns: Unknowns, data: Observations) -> tuple[int, float] | None:
    """Place of the friction angle among the unknowns, and its scatter from point to point as a share of its prior."""
    if not data.handling.friction_scatter:
        return None
    place = unknowns.names.index(FRICTION_ANGLE.name)
    prior = unknowns.parameters[place]
    return place, data.handling.friction_scatter / (prior.high - prior.low)


def _part(progress: Progress, before: int, size: int, total: int) -> Progress:
    """Progress of a round of `size` parameter sets, `before` of the `total` done."""
    return lambda done: progress(min(1.0, (before + size * done) / total))


def _emulates(latest: _Round, before: _Round | None, good_enough: float, generator: np.random.Generator) -> bool:
    """Whether the emulators add little to what the measurement leaves open, or a run-off gets no sharper."""
    likelihood, data = latest.likelihood, latest.likelihood.data
    parameters, noise = likelihood.split(latest.particles.resampled(1.0, 256, generator))
    spread = np.median(likelihood.spread(likelihood.predicted(parameters), noise), axis=0)
    error = likelihood.error
    if not np.isfinite(error).all() or np.quantile(error / spread, 0.75) >= good_enough:
        return False
    return all(
        _learnt(likelihood.run_offs[amplitude], before and before.likelihood.run_offs[amplitude], low, high)
        for amplitude, (low, high) in data.brackets().items()
        if math.isfinite(high) and low > 0
    )


def _learnt(run_off: RunOffEmulator | None, before: RunOffEmulator | None, low: float, high: float) -> bool:
    """Whether a run-off is emulated as sharply as its bracket (Hz) asks, or as it is: chaos leaves it a width."""
    if run_off is None:
        return False
    sharp = run_off.width < max(0.5 * (high - low), 2 * SHARPEST_RUN_OFF * high)
    return sharp or (before is not None and run_off.width > NO_SHARPER * before.width)


def _near(likelihood: Likelihood, u: Array, within: float) -> NDArray[np.bool_]:
    """Runs whose parameters lie near what was measured."""
    scores = _scores(likelihood, u)
    return scores > scores.max() - within


def _scores(likelihood: Likelihood, u: Array) -> Array:
    """Log likelihood (n,) of parameters (n, d), at the noise that suits each best."""
    if not likelihood.noise_is_unknown:
        return likelihood(u)
    levels = np.linspace(0.05, 0.95, 7)
    return np.max([likelihood(np.column_stack([u, np.full(len(u), level)])) for level in levels], axis=0)


def _like(data: Observations, runs: EngineRuns, size: int) -> NDArray[np.int64]:
    """Runs whose rates are roughly those measured, the likest first: another model may well make them so."""
    rate, simulated = data.rate[data.rated], runs.rates[:, data.which[data.rated]]
    off = np.abs(simulated - rate) / (ROUGHLY * np.abs(rate) + LEAST_NOISE)
    return np.argsort(np.mean(np.where(np.isfinite(off), np.minimum(off, 3.0), 3.0), axis=1), kind="stable")[:size]


def _promising(particles: Particles, dimensions: int, size: int, generator: np.random.Generator) -> Array:
    """Where to run the engine next: three quarters from the posterior, a quarter from its wider surroundings."""
    warm = particles.temperature(200)
    close = particles.resampled(max(2.0, warm), size - size // 4, generator)
    wide = particles.resampled(max(8.0, 4 * warm), size // 4, generator)
    u = np.concatenate([close, wide])[:, :dimensions]
    return folded(u + generator.normal(0, 0.01, u.shape))


def _sample(latest: _Round, effort: Effort, generator: np.random.Generator) -> Array:
    """Samples of the posterior: walkers that start all over it, so that none of its parts is missed."""
    import emcee

    particles, walkers = latest.particles, effort.walkers
    start = particles.resampled(particles.temperature(4 * walkers), walkers, generator)
    start = folded(start + generator.normal(0, 1e-4, start.shape))

    def log_posterior(x: Array) -> Array:
        inside = ((x > 0) & (x < 1)).all(axis=1)
        value = np.full(len(x), -np.inf)
        if inside.any():
            value[inside] = latest.likelihood(x[inside])
        return value

    sampler = emcee.EnsembleSampler(
        walkers,
        start.shape[1],
        log_posterior,
        vectorize=True,
        moves=[(emcee.moves.DEMove(), 0.7), (emcee.moves.StretchMove(), 0.3)],
    )
    # The sampler keeps a generator of the old kind; it is given its seed through a state.
    sampler.random_state = np.random.RandomState(generator.integers(2**31)).get_state()
    begun = sampler.run_mcmc(start, effort.burn_in)
    assert begun is not None
    # A walker far below the best sits on a place of no weight, which it may not leave: it goes on from another's.
    score, places = np.asarray(begun.log_prob), np.asarray(begun.coords).copy()
    strayed = score < score.max() - STRAYED
    others = generator.choice(np.flatnonzero(~strayed), int(strayed.sum()))
    places[strayed] = folded(places[others] + generator.normal(0, 1e-5, (len(others), places.shape[1])))
    sampler.reset()
    sampler.run_mcmc(places, effort.steps - effort.burn_in, skip_initial_state_check=True)
    return np.asarray(sampler.get_chain(thin=effort.thin, flat=True))
