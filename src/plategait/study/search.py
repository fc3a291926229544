"""The joint search: evaluations spread over the priors, then where the published numbers draw them, and a posterior.

A surrogate of every fit, learnt from the evaluations, is what is searched, so that holding curves out and weighing
subsets of departures cost no further simulation.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np
from scipy.optimize import least_squares
from scipy.stats import qmc

from plategait.arrays import Array, Flags
from plategait.study.aims import KIND, residuals
from plategait.study.evaluation import FITS_FROM, OUTPUTS, Evaluation, evaluate, joined
from plategait.study.surrogate import Surrogate, learn
from plategait.study.unknowns import LAWS, UNKNOWNS, Choice, choice_at, deviations_of

FARTHEST = 2.5
"""Deviations of the priors beyond which nothing is tried."""
WALKERS, STEPS, BURNT = 64, 1500, 500


@dataclass(frozen=True, eq=False)
class Learnt:
    """The surrogate of all fits, and what the published numbers make of it.

    Attributes
    ----------
    evaluation : Evaluation
        What it was learnt from.
    surrogates : tuple of Surrogate
        By where the fit begins: of the logarithms of the fits, and of that of the rate at 12 Hz.
    """

    evaluation: Evaluation
    surrogates: tuple[Surrogate, ...]

    def fits(self, x: Array, fit_from: int = 0) -> tuple[Array, Array]:
        """Fits (n, curves, outputs) and rates at 12 Hz (n,) at standardised unknowns (n, d)."""
        logs = self.surrogates[fit_from](x)
        missing = ~np.isfinite(self.surrogates[fit_from].error)
        logs[:, missing] = np.nan
        return np.exp(logs[:, :-1]).reshape(len(x), -1, len(OUTPUTS)), np.exp(logs[:, -1])

    def error(self, fit_from: int = 0) -> Array:
        """(curves, outputs) relative errors."""
        return self.surrogates[fit_from].error[:-1].reshape(-1, len(OUTPUTS))

    def residuals(self, x: Array, used: Flags | None = None) -> Array:
        """(n, places × aims) residuals over all places where a fit may begin, weighed as one; of the aims `used`."""
        used = np.ones(len(KIND), dtype=bool) if used is None else used
        places = [residuals(*self.fits(x, k), self.error(k)).values[:, used] for k in range(len(FITS_FROM))]
        return np.concatenate(places, axis=1) / np.sqrt(len(FITS_FROM))

    def misfit(self, x: Array, used: Flags | None = None) -> Array:
        """(n,) loss over all places where a fit may begin, in the mean; over the aims `used`."""
        return (self.residuals(x, used) ** 2).sum(axis=1)


def standardised(choices: Sequence[Choice]) -> Array:
    """(n, d + 1) deviations of the priors, and the law as ±1."""
    law = np.array([1.0 if choice.law == LAWS[1] else -1.0 for choice in choices])
    return np.column_stack([np.stack([deviations_of(choice) for choice in choices]), law])


def learnt(evaluation: Evaluation, weight: Array | None = None) -> Learnt:
    """Learn every fit from evaluations."""
    x, surrogates = standardised(evaluation.choices), []
    for k in range(len(FITS_FROM)):
        with np.errstate(invalid="ignore", divide="ignore"):
            logs = np.log(np.column_stack([evaluation.fits[:, k].reshape(len(x), -1), evaluation.at_12]))
        surrogates.append(learn(x, logs, weight))
    return Learnt(evaluation, tuple(surrogates))


def spread(count: int, seed: int) -> list[Choice]:
    """Choices that fill the priors, both laws in turn."""
    with warnings.catch_warnings():
        # Other counts than powers of two are only a little less even.
        warnings.simplefilter("ignore", UserWarning)
        shares = qmc.Sobol(len(UNKNOWNS), seed=np.random.default_rng(seed)).random(count)  # pyright: ignore[reportCallIssue]
    z = np.stack([unknown.quantile(shares[:, i]) for i, unknown in enumerate(UNKNOWNS)], axis=1)
    return [choice_at(row, LAWS[i % 2]) for i, row in enumerate(np.clip(z, -FARTHEST, FARTHEST))]


def prior(z: Array) -> Array:
    """(n,) squared deviations (n, d) of the priors; infinite where a one-sided unknown is below the printed value."""
    one_sided = np.array([unknown.one_sided for unknown in UNKNOWNS])
    outside = (np.abs(z) > FARTHEST).any(axis=1) | (z[:, one_sided] < 0).any(axis=1)
    return np.where(outside, np.inf, (z**2).sum(axis=1))


def posterior(
    found: Learnt, law: str, seed: int, used: Flags | None = None, free: Flags | None = None
) -> tuple[Array, Array]:
    """Samples (n, d) of the unknowns' deviations under one law, and the misfit of each.

    Parameters
    ----------
    used : (aims,) bool array, optional
        Aims that count; all by default.
    free : (d,) bool array, optional
        Unknowns that may depart from the printed value; all by default.
    """
    import emcee

    d = len(UNKNOWNS)
    free = np.ones(d, dtype=bool) if free is None else free
    sign = 1.0 if law == LAWS[1] else -1.0

    def whole(z: Array) -> Array:
        full = np.zeros((len(z), d))
        full[:, free] = z
        return full

    def log_probability(z: Array) -> Array:
        full = whole(z)
        weight = prior(full)
        inside = np.isfinite(weight)
        value = np.full(len(z), -np.inf)
        if inside.any():
            x = np.column_stack([full[inside], np.full(inside.sum(), sign)])
            value[inside] = -0.5 * (found.misfit(x, used) + weight[inside])
        return value

    rng = np.random.default_rng(seed)
    start = np.abs(rng.normal(0, 0.3, (WALKERS, int(free.sum()))))
    sampler = emcee.EnsembleSampler(WALKERS, int(free.sum()), log_probability, vectorize=True)
    sampler.random_state = np.random.RandomState(seed).get_state()
    sampler.run_mcmc(start, STEPS)
    samples = whole(np.asarray(sampler.get_chain(discard=BURNT, thin=10, flat=True)))
    return samples, found.misfit(np.column_stack([samples, np.full(len(samples), sign)]), used)


def best(
    found: Learnt, law: str, free: Flags, used: Flags | None = None, starts: int = 4, seed: int = 0
) -> tuple[Array, float]:
    """Deviations (d,) of least misfit and prior together, with some unknowns free, and that misfit."""
    rng = np.random.default_rng(seed)
    sign = 1.0 if law == LAWS[1] else -1.0
    low = np.array([0.0 if unknown.one_sided else -FARTHEST for unknown in UNKNOWNS])[free]

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
        tries = [np.clip(z, low + 0.05, None), *rng.uniform(low / 2, FARTHEST / 2, (starts, len(z)))]
        results = [
            least_squares(at, start, jac=cast("Any", slopes), bounds=(low, FARTHEST), max_nfev=60) for start in tries
        ]
        z = min(results, key=lambda r: r.cost).x
    return whole(z), float(found.misfit(np.append(whole(z), sign)[None], used)[0])


def search(
    folder: Path,
    seed: int,
    *,
    first: int = 96,
    rounds: Sequence[int] = (48, 48),
    dask: object = None,
    progress: Callable[[float], object] | None = None,
) -> Learnt:
    """Evaluate choices over the priors, then where the posterior is, and learn from all of them.

    Parameters
    ----------
    folder : Path
        Of the stores, in which an interrupted search goes on.
    seed : int
        Of what is tried.
    first, rounds : int
        Evaluations over the priors, and in each round after that.
    dask, progress
        See `plategait.campaign.run.sweep`.
    """
    total = first + sum(rounds)
    report = None if progress is None else (lambda x: progress(x * first / total))
    start = [Choice({}, law) for law in LAWS] + spread(first - len(LAWS), seed)
    evaluation = evaluate(start, folder, f"seed{seed}-0", dask=dask, progress=report)
    done = first
    for number, count in enumerate(rounds, start=1):
        found = learnt(evaluation)
        choices: list[Choice] = []
        rng = np.random.default_rng([seed, number])
        for law in LAWS:
            samples, _ = posterior(found, law, seed)
            chosen = samples[rng.choice(len(samples), count // 2, replace=False)]
            # A little wider than the posterior, so that the surrogate learns its rim.
            one_sided = np.array([u.one_sided for u in UNKNOWNS])
            wider = np.clip(chosen + rng.normal(0, 0.3, chosen.shape), -FARTHEST, FARTHEST)
            choices += [choice_at(np.where(one_sided, np.abs(z), z), law) for z in wider]
        report = None if progress is None else (lambda x, d=done, c=count, p=progress: p((d + c * x) / total))
        evaluation = joined(evaluation, evaluate(choices, folder, f"seed{seed}-{number}", dask=dask, progress=report))
        done += count
    return learnt(evaluation)
