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
from plategait.estimate.emulator import SHARPEST_RUN_OFF
from plategait.estimate.likelihood import Likelihood, learn
from plategait.estimate.observations import Observations
from plategait.estimate.trials import Trials, run_trials
from plategait.estimate.unknowns import Unknowns

FIRST_ROUND = 48
LATER_ROUND = 32
# At least one round follows the first, and no more than this.
MOST_ROUNDS = 3
# Emulators are good enough when their errors are below this share of the measurement's own.
GOOD_ENOUGH = 0.2
# Each unknown beyond three asks for this many more runs a round.
MORE_PER_UNKNOWN = 16
# Runs whose log likelihood lies within this of the best are near what was measured.
NEAR = 8.0
CLOUD = 2**14
GENERATIONS = 8
WALKERS, BURN_IN, STEPS, THIN = 96, 200, 400, 5

# Points of the unit cube with their log likelihoods.
Cloud = tuple[Array, Array]


@dataclass(frozen=True, eq=False)
class Posterior:
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
    trials : Trials
        Every run of the engine.
    full : (n, d or d + 1) array
        Samples with the noise's share, as `likelihood` takes them.
    """

    unknowns: Unknowns
    data: Observations
    u: Array
    noise: Array
    likelihood: Likelihood
    trials: Trials
    full: Array

    @property
    def values(self) -> Array:
        """Samples (n, d), SI."""
        return self.unknowns.values(self.u)


def estimate_posterior(
    data: Observations,
    unknowns: Unknowns,
    *,
    noise: float | None = None,
    seed: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Posterior:
    """Sample the posterior.

    Parameters
    ----------
    data : Observations
    unknowns : Unknowns
    noise : float, optional
        Relative noise of the rates that come without a spread of their own; estimated too if left out.
    seed : int
        Of the sampling.
    progress : callable, optional
        Called with the fraction done.

    Returns
    -------
    Posterior
    """
    generator = np.random.default_rng(seed)
    dimensions = len(unknowns.parameters)
    more = MORE_PER_UNKNOWN * max(0, dimensions - 3)
    first, later = FIRST_ROUND + 2 * more, LATER_ROUND + more
    u = stratified(first, dimensions, generator)
    trials: Trials | None = None
    likelihood: Likelihood | None = None
    cloud: Cloud | None = None
    for i in range(1 + MOST_ROUNDS):

        def report(done: float, i: int = i, size: int = len(u), before: int = len(trials.u) if trials else 0) -> None:
            if progress is not None:
                progress(min(1.0, (before + size * done) / (first + 2 * later)) if i < 3 else 1.0)

        fresh = run_trials(unknowns, u, data.conditions, seed=seed, progress=report)
        trials = fresh if trials is None else trials.joined(fresh)
        likelihood = _learn(data, trials, likelihood, noise)
        cloud = _cloud(likelihood, dimensions, generator)
        if i and _good_enough(likelihood, cloud, generator):
            break
        u = _promising(cloud, dimensions, later, generator)
    assert likelihood is not None
    assert trials is not None
    assert cloud is not None
    full = _sample(likelihood, cloud, generator)
    parameters, sampled_noise = likelihood.split(full)
    return Posterior(unknowns, data, parameters, sampled_noise, likelihood, trials, full)


def stratified(size: int, dimensions: int, generator: np.random.Generator) -> Array:
    """Latin hypercube: (size, dimensions) points of the unit cube, one in each of `size` strata of each axis."""
    strata = generator.permuted(np.tile(np.arange(size), (dimensions, 1)), axis=1).T
    return (strata + generator.random((size, dimensions))) / size


def _good_enough(likelihood: Likelihood, cloud: Cloud, generator: np.random.Generator) -> bool:
    """Whether the emulators add little to what the measurement leaves open."""
    u, score = cloud
    likely = u[_resampled(score, 1.0, 256, generator)]
    parameters, noise = likelihood.split(likely)
    spread = np.median(likelihood.spread(likelihood.predicted(parameters), noise), axis=0)
    error = likelihood.rates.error[likelihood.data.which[likelihood.data.rated]]
    known = np.isfinite(error)
    rates_known = bool(known.all() and np.quantile(error / spread, 0.75) < GOOD_ENOUGH)
    brackets = likelihood.data.brackets()
    run_offs_known = all(
        emulator is not None and emulator.width < max(0.5 * (high - low), 2 * SHARPEST_RUN_OFF)
        for amplitude, emulator in likelihood.run_offs.items()
        for low, high in [brackets[amplitude]]
        if math.isfinite(high) and low > 0
    )
    return rates_known and run_offs_known


def _learn(data: Observations, trials: Trials, before: Likelihood | None, noise: float | None) -> Likelihood:
    """Learn from all runs; those that the likelihood before finds probable count most."""
    everywhere = np.ones(len(trials.u), dtype=bool)
    if before is None:
        return learn(data, trials, everywhere, noise)
    return learn(data, trials, _near(before, trials.u), noise)


def _near(likelihood: Likelihood, u: Array) -> NDArray[np.bool_]:
    """Runs whose parameters lie near what was measured."""
    if likelihood.noise_is_unknown:
        levels = np.linspace(0.05, 0.95, 7)
        scores = np.max([likelihood(np.column_stack([u, np.full(len(u), level)])) for level in levels], axis=0)
    else:
        scores = likelihood(u)
    return scores > scores.max() - NEAR


def _cloud(likelihood: Likelihood, dimensions: int, generator: np.random.Generator) -> Cloud:
    """Points of the cube and their log likelihoods, ever denser where the data are likely.

    Each generation spreads about the best of all before it, at a temperature that keeps enough of them; once that
    temperature is 1, the points cover the posterior.
    """
    dimensions += likelihood.noise_is_unknown
    u = stratified(CLOUD, dimensions, generator)
    score = likelihood(u)
    for _ in range(GENERATIONS):
        temperature = _temperature(score, 50 * dimensions)
        parents = u[_resampled(score, temperature, CLOUD // 4, generator)]
        step = (
            generator.normal(0, 1, parents.shape) @ np.linalg.cholesky(np.cov(parents.T) + 1e-8 * np.eye(dimensions)).T
        )
        children = _folded(parents + 0.5 * step)
        u, score = np.concatenate([u, children]), np.concatenate([score, likelihood(children)])
        if temperature == 1:
            break
    return u, score


def _folded(u: Array) -> Array:
    """Points beyond the unit cube mirrored back into it."""
    u = np.abs(u) % 2
    return np.where(u > 1, 2 - u, u)


def _temperature(score: Array, least: float) -> float:
    """Temperature at which the weights of a cloud amount to at least so many points."""
    temperature = 1.0
    while temperature < 1e6:
        weight = np.exp((score - score.max()) / temperature)
        if weight.sum() ** 2 / np.sum(weight**2) >= least:
            break
        temperature *= 1.5
    return temperature


def _resampled(score: Array, temperature: float, size: int, generator: np.random.Generator) -> NDArray[np.int64]:
    weight = np.exp((score - score.max()) / temperature)
    return generator.choice(len(score), size=size, p=weight / weight.sum())


def _promising(cloud: Cloud, dimensions: int, size: int, generator: np.random.Generator) -> Array:
    """Where to run the engine next: three quarters from the posterior, a quarter from its wider surroundings."""
    u, score = cloud
    close = _resampled(score, max(2.0, _temperature(score, 200)), size - size // 4, generator)
    wide = _resampled(score, max(8.0, 4 * _temperature(score, 200)), size // 4, generator)
    chosen = u[np.concatenate([close, wide])][:, :dimensions]
    return _folded(chosen + generator.normal(0, 0.01, chosen.shape))


def _sample(likelihood: Likelihood, cloud: Cloud, generator: np.random.Generator) -> Array:
    """Samples of the posterior: walkers that start all over it, so that none of its parts is missed."""
    import emcee

    u, score = cloud
    start = u[_resampled(score, _temperature(score, 4 * WALKERS), WALKERS, generator)]
    start = _folded(start + generator.normal(0, 1e-4, start.shape))

    def log_posterior(x: Array) -> Array:
        inside = ((x > 0) & (x < 1)).all(axis=1)
        value = np.full(len(x), -np.inf)
        if inside.any():
            value[inside] = likelihood(x[inside])
        return value

    sampler = emcee.EnsembleSampler(
        WALKERS, start.shape[1], log_posterior, vectorize=True,
        moves=[(emcee.moves.DEMove(), 0.7), (emcee.moves.StretchMove(), 0.3)],
    )  # fmt: skip
    # The sampler keeps a generator of the old kind; it is given its seed through a state.
    sampler.random_state = np.random.RandomState(generator.integers(2**31)).get_state()
    sampler.run_mcmc(start, STEPS)
    return np.asarray(sampler.get_chain(discard=BURN_IN, thin=THIN, flat=True))
