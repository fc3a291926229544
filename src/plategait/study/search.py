"""The joint search: choices spread over the priors, then an evolution strategy from the best, and what they teach.

A surrogate of every fit is learnt from all evaluations, so that a posterior, holding curves out and weighing subsets of
departures cost no further simulation.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np
from scipy.optimize import least_squares
from scipy.stats import qmc

from plategait.arrays import Array, Flags
from plategait.optimize.strategy import evolution_strategy
from plategait.study.aims import KIND, N_CURVES, residuals, residuals_of
from plategait.study.evaluation import FITS_FROM, OUTPUTS, Evaluation, evaluate, joined
from plategait.study.progress import Progress, part
from plategait.study.surrogate import Surrogate, learn
from plategait.study.unknowns import LAWS, UNKNOWNS, Choice, choice_at, deviations_of

FARTHEST = 2.5
"""Deviations of the priors beyond which nothing is tried."""
LOWEST = np.array([0.0 if unknown.one_sided else -FARTHEST for unknown in UNKNOWNS])
"""Least deviation of each unknown that is tried."""
WALKERS, STEPS, BURNT = 64, 1500, 500
POPULATION, STEP = 16, 0.5
"""Of a generation, and how far the first goes from the best choice, in deviations of the priors."""
FLAT = 40.0
"""Loss above the least that halves how much an evaluation counts twice over."""


@dataclass(frozen=True, eq=False)
class Learnt:
    """The surrogate of all fits, and what the published numbers make of it.

    Attributes
    ----------
    evaluation : Evaluation
        What it was learnt from.
    surrogates : tuple of Surrogate
        By where the fit begins: of the logarithms of the fits and of the rate at 12 Hz, and of whether each curve is
        without a fit.
    """

    evaluation: Evaluation
    surrogates: tuple[Surrogate, ...]

    def residuals(self, x: Array, used: Flags | None = None) -> Array:
        """(n, places × aims) residuals at standardised unknowns (n, d) over all places where a fit may begin.

        The places are weighed as one; `used` says which aims count.
        """
        used = np.ones(len(KIND), dtype=bool) if used is None else used
        told = np.stack([surrogate(x) for surrogate in self.surrogates])
        for place, surrogate in zip(told, self.surrogates, strict=True):
            place[:, ~np.isfinite(surrogate.error)] = np.nan
        # All places at once, as though they were other choices: a call of a few rows costs as much as one of many.
        told = told.reshape(-1, told.shape[2])
        error = np.stack([s.error[:_FITS].reshape(N_CURVES, len(OUTPUTS)) for s in self.surrogates])
        values = residuals(
            np.exp(told[:, :_FITS]).reshape(-1, N_CURVES, len(OUTPUTS)), np.exp(told[:, _FITS]),
            np.maximum(told[:, _FITS + 1 + N_CURVES :], 0), np.repeat(error, len(x), axis=0),
            np.clip(told[:, _FITS + 1 : _FITS + 1 + N_CURVES], 0, 1),
        ).values[:, used]  # fmt: skip
        places = np.concatenate(np.split(values, len(self.surrogates)), axis=1)
        return places / np.sqrt(len(FITS_FROM))

    def misfit(self, x: Array, used: Flags | None = None) -> Array:
        """(n,) loss over all places where a fit may begin, in the mean; over the aims `used`."""
        return (self.residuals(x, used) ** 2).sum(axis=1)


_FITS = N_CURVES * len(OUTPUTS)


def standardised(choices: Sequence[Choice]) -> Array:
    """(n, d + 1) deviations of the priors, and the law as ±1."""
    signs = [_sign(choice.law) for choice in choices]
    return np.column_stack([np.stack([deviations_of(choice) for choice in choices]), signs])


def _sign(law: str) -> float:
    return 1.0 if law == LAWS[1] else -1.0


def learnt(evaluation: Evaluation, used: Flags | None = None) -> Learnt:
    """Learn every fit from evaluations, to be right where the loss over the aims `used` is low."""
    x, weight, surrogates = standardised(evaluation.choices), near_best(evaluation, used), []
    for k in range(len(FITS_FROM)):
        fits = evaluation.fits[:, k]
        with np.errstate(invalid="ignore", divide="ignore"):
            logs = np.log(np.column_stack([fits.reshape(len(x), -1), evaluation.at_12]))
        plain = np.column_stack([np.isnan(fits[:, :, 0]), evaluation.gaits])
        surrogates.append(learn(x, np.column_stack([logs, plain]), weight))
    return Learnt(evaluation, tuple(surrogates))


def spread(count: int, seed: int) -> list[Choice]:
    """Choices that fill the priors, both laws in turn; every second pair departs in a third of the unknowns only.

    Few departures are what is asked for in the end, and most choices with all of them lie far from those.
    """
    with warnings.catch_warnings():
        # Other counts than powers of two are only a little less even.
        warnings.simplefilter("ignore", UserWarning)
        rng = np.random.default_rng(seed)
        shares = qmc.Sobol(len(UNKNOWNS), seed=rng).random(count)  # pyright: ignore[reportCallIssue]
    z = np.stack([unknown.quantile(shares[:, i]) for i, unknown in enumerate(UNKNOWNS)], axis=1)
    z[(rng.random(z.shape) > 1 / 3) & (np.arange(count) % 4 >= 2)[:, None]] = 0
    return [choice_at(row, LAWS[i % 2]) for i, row in enumerate(np.clip(z, -FARTHEST, FARTHEST))]


def prior(z: Array) -> Array:
    """(n,) squared deviations (n, d) of the priors; infinite where nothing is tried."""
    outside = ((z > FARTHEST) | (z < LOWEST)).any(axis=1)
    return np.where(outside, np.inf, (z**2).sum(axis=1))


def posterior(found: Learnt, law: str, seed: int) -> Array:
    """Samples (n, d) of the unknowns' deviations under one law."""
    import emcee

    d = len(UNKNOWNS)

    def log_probability(z: Array) -> Array:
        weight = prior(z)
        inside = np.isfinite(weight)
        value = np.full(len(z), -np.inf)
        if inside.any():
            x = np.column_stack([z[inside], np.full(inside.sum(), _sign(law))])
            value[inside] = -0.5 * (found.misfit(x) + weight[inside])
        return value

    start = np.minimum(np.abs(np.random.default_rng(seed).normal(0, 1, (WALKERS, d))), FARTHEST)
    sampler = emcee.EnsembleSampler(WALKERS, d, log_probability, vectorize=True)
    sampler.random_state = np.random.RandomState(seed).get_state()
    sampler.run_mcmc(start, STEPS)
    return np.asarray(sampler.get_chain(discard=BURNT, thin=10, flat=True))


def best(
    found: Learnt, law: str, free: Flags, used: Flags | None = None, guesses: Sequence[Array] = ()
) -> tuple[Array, float]:
    """Deviations (d,) of least misfit and prior together, with some unknowns free, and that misfit.

    Parameters
    ----------
    free : (d,) bool array
    used : (aims,) bool array, optional
        Aims that count; all by default.
    guesses : sequence of (d,) array
        Deviations to go down from, beside those of the evaluation of least loss.
    """
    sign, low = _sign(law), LOWEST[free]

    def whole(z: Array) -> Array:
        full = np.zeros(len(UNKNOWNS))
        full[free] = z
        return full

    def deviations(points: Array) -> Array:
        """(m, residuals) of points (m, free)."""
        x = np.column_stack([np.stack([whole(z) for z in points]), np.full(len(points), sign)])
        return np.column_stack([found.residuals(x, used), points])

    def at(z: Array) -> Array:
        return deviations(z[None])[0]

    def slopes(z: Array) -> Array:
        # All forward differences at once, as the surrogate takes many points nearly as fast as one.
        apart = 1e-4
        values = deviations(np.vstack([z, z + apart * np.eye(len(z))]))
        return (values[1:] - values[0]).T / apart

    z = np.zeros(int(free.sum()))
    if len(z):
        least = deviations_of(found.evaluation.choices[int(losses(found.evaluation, used).argmin())])
        tries = [np.clip(guess[free], low + 0.02, FARTHEST - 0.02) for guess in (least, *guesses)]
        results = [
            least_squares(at, start, jac=cast("Any", slopes), bounds=(low, FARTHEST), max_nfev=40) for start in tries
        ]
        z = min(results, key=lambda r: r.cost).x
    return whole(z), float(found.misfit(np.append(whole(z), sign)[None], used)[0])


def losses(evaluation: Evaluation, used: Flags | None = None) -> Array:
    """(choices,) misfit of evaluations themselves and squared deviations of the prior, together."""
    z = np.stack([deviations_of(choice) for choice in evaluation.choices])
    return misfits(evaluation, used) + (z**2).sum(axis=1)


def misfits(evaluation: Evaluation, used: Flags | None = None) -> Array:
    """(choices,) sums of squares over the aims `used`, over all places where a fit may begin in the mean."""
    places = [residuals_of(evaluation, k).loss(used) for k in range(len(FITS_FROM))]
    return np.mean(places, axis=0)


def near_best(evaluation: Evaluation, used: Flags | None = None) -> Array:
    """(choices,) weights with which a surrogate learns: it is to be right where the loss is low."""
    loss = losses(evaluation, used)
    return 1 / (1 + (loss - loss.min()) / FLAT) ** 2


def search(
    folder: Path,
    seed: int,
    *,
    first: int,
    generations: int,
    dask: object = None,
    progress: Progress | None = None,
) -> Learnt:
    """Evaluate choices over the priors, go down from the best by CMA-ES, and learn from all of them.

    Parameters
    ----------
    folder : Path
        Of the stores, in which an interrupted search goes on.
    seed : int
        Of what is tried.
    first, generations : int
        Evaluations over the priors, and generations of `POPULATION` from the best of them.
    dask, progress
        See `plategait.campaign.run.sweep`.

    Raises
    ------
    InputError
        When the package `cma` is not installed.
    """
    total = first + generations * POPULATION
    report = part(progress, 0, first / total)
    start = [Choice({}, law) for law in LAWS] + spread(first - len(LAWS), seed)
    (evaluation,) = evaluate(start, folder, f"seed{seed}-0", dask=dask, progress=report)
    best_so_far = evaluation.choices[int(losses(evaluation).argmin())]
    strategy = _strategy(deviations_of(best_so_far), seed)
    for number in range(1, generations + 1):
        if number > 1:
            # What the surrogate takes for the best so far: right more often than chance, and free.
            expected, _ = best(learnt(evaluation), best_so_far.law, np.ones(len(UNKNOWNS), bool))
            strategy.inject([expected], force=True)
        asked = strategy.ask()
        done = (first + (number - 1) * POPULATION) / total
        report = part(progress, done, POPULATION / total)
        # Rounded, so that round-off of another processor is no other study.
        choices = [choice_at(np.round(z, 3), best_so_far.law) for z in asked]
        (made,) = evaluate(choices, folder, f"seed{seed}-{number}", dask=dask, progress=report)
        strategy.tell(asked, losses(made).tolist())
        evaluation = joined(evaluation, made)
    return learnt(evaluation)


def _strategy(z: Array, seed: int) -> Any:
    """The evolution strategy from deviations `z` of the priors."""
    inside = np.clip(z, LOWEST + 0.05, FARTHEST - 0.05)
    highest = [FARTHEST] * len(UNKNOWNS)
    return evolution_strategy(inside, STEP, LOWEST.tolist(), highest, POPULATION, seed, "study")
