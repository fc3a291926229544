"""The study of the source's unknowns, from the first evaluation to what it may claim."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.study.aims import KIND, residuals_of
from plategait.study.defaults import FIRST, GENERATIONS, SEEDS
from plategait.study.evaluation import FITS_FROM, Evaluation, evaluate, joined
from plategait.study.findings import Findings, find
from plategait.study.inference import HALVES, OutOfSample, Step, deviations_of_curves, step_with
from plategait.study.polish import ROUNDS, polish, refined
from plategait.study.progress import Progress, part
from plategait.study.search import POPULATION, Learnt, learnt, losses, posterior, search
from plategait.study.unknowns import NAMES, UNKNOWNS, Choice

STARTS = 4
"""Starts of each run, beside the nominal one, with which choices are told at the end."""
QUANTILES = (0.05, 0.5, 0.95)
DETERMINED = 0.5
"""An unknown is determined by the published data where the posterior is narrower than this share of the prior."""


@dataclass(frozen=True, eq=False)
class Told:
    """A choice simulated with several starts that the search has not seen.

    Attributes
    ----------
    name : str
    choice : Choice
    fits : (fits_from, curves, outputs) array
        Medians over the starts.
    without_fit : float
        Curves without a fit where it begins first, mean of the starts.
    at_12 : float
        Rate at A_p = 12 deg and 12 Hz, deg/s.
    loss : (fits_from,) array
        Of all aims, by where the fit begins, mean of the starts.
    noise : float
        Standard deviation of the loss of one start, over the starts.
    by_kind : mapping of str to float
        Share of each kind of aim in the loss, where the fit begins first.
    findings : Findings
        What the search does not look at: of all starts together.
    """

    name: str
    choice: Choice
    fits: Array
    without_fit: float
    at_12: float
    loss: Array
    noise: float
    by_kind: Mapping[str, float]
    findings: Findings


@dataclass(frozen=True, eq=False)
class SourceStudy:
    """What the study found.

    Attributes
    ----------
    learnt : Learnt
        From the evaluations of all seeds.
    steps : tuple of Step
        Departures one by one under the law of the best choice, each set polished by simulation.
    chosen : Step
        The set that pays for itself.
    by_seed : tuple of Step
        The same set found from each seed's own evaluations.
    samples : (n, d) array
        Posterior of all unknowns under the chosen law, in deviations of the priors.
    told : tuple of Told
        The printed choice, one factor at a time, the chosen one and those found on parts of the curves, simulated.
    out_of_sample : tuple of OutOfSample
    """

    learnt: Learnt
    steps: tuple[Step, ...]
    chosen: Step
    by_seed: tuple[Step, ...]
    samples: Array
    told: tuple[Told, ...]
    out_of_sample: tuple[OutOfSample, ...]

    def interval(self, name: str) -> tuple[float, float, float]:
        """5 %, 50 % and 95 % of an unknown, SI."""
        i = NAMES.index(name)
        low, middle, high = np.quantile(UNKNOWNS[i].value(self.samples[:, i]), QUANTILES)
        return float(low), float(middle), float(high)

    def narrowing(self, name: str) -> float:
        """Width of the posterior over that of the prior."""
        i = NAMES.index(name)
        prior_sd = np.sqrt(1 - 2 / np.pi) if UNKNOWNS[i].one_sided else 1.0
        return float(np.std(self.samples[:, i]) / prior_sd)

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`."""
        return {
            "evaluations": len(self.learnt.evaluation.choices),
            "law": self.chosen.law,
            "departures": list(self.chosen.free),
            "values": {name: self.chosen.choice[name] for name in self.chosen.free},
            "by_seed": [{name: step.choice[name] for name in self.chosen.free} for step in self.by_seed],
            "unknowns": {
                name: {"interval": self.interval(name), "narrowing": self.narrowing(name),
                       "determined": self.narrowing(name) < DETERMINED}
                for name in NAMES
            },
            "steps": [
                {"free": list(s.free), "values": {name: s.choice[name] for name in s.free}, "misfit": s.misfit,
                 "error": s.error, "criterion": s.criterion}
                for s in self.steps
            ],
            "told": [
                {"name": t.name, "values": dict(t.choice.values), "loss": t.loss.tolist(), "noise": t.noise,
                 "by_kind": dict(t.by_kind), "rate_at_12_hz_deg_s": t.at_12, "findings": t.findings.summary(),
                 **_deviations(t)}
                for t in self.told
            ],
            "out_of_sample": [vars(o) for o in self.out_of_sample],
        }  # fmt: skip


def _deviations(told: Told) -> dict[str, float]:
    f0, largest, ratio, _ = deviations_of_curves(told.fits[0])
    return {"median_f0": f0, "largest_f0": largest, "median_b_over_f0": ratio, "without_fit": told.without_fit}


ONE_AT_A_TIME = Choice({"height": 7e-3, "c_b factor": 10.0, "slip limit": 0.02})
"""A plate height and a damping, each found by varying it alone (docs/fidelity.md)."""


def study_source(
    folder: Path | str,
    *,
    seeds: int = SEEDS,
    first: int = FIRST,
    generations: int = GENERATIONS,
    dask: object = None,
    progress: Progress | None = None,
) -> SourceStudy:
    """Search what the source leaves open, and say what may be claimed.

    Parameters
    ----------
    folder : path
        Where the stores of all evaluations lie; an interrupted study goes on in it.
    seeds : int
        Independent searches.
    first, generations : int
        Evaluations of each over the priors, and generations of the evolution strategy after that.
    dask, progress
        See `plategait.campaign.run.sweep`.

    Raises
    ------
    InputError
        For a number out of range, or a folder that holds another study.
    """
    for name, value, least in (("seeds", seeds, 1), ("evaluations", first, 32)):
        if value < least:
            raise InputError(name, value, f"at least {least}", str(least))
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    within = _parts(
        progress, seeds * (first + generations * POPULATION), 4 * ROUNDS * POPULATION, 4 * POPULATION, 16 * (1 + STARTS)
    )
    searches: list[Learnt] = []
    for seed in range(seeds):
        report = part(within[0], seed / seeds, 1 / seeds)
        searches.append(search(folder, seed, first=first, generations=generations, dask=dask, progress=report))
    evaluation = joined(*(each.evaluation for each in searches))
    law = evaluation.choices[int(losses(evaluation).argmin())].law
    polished = polish(evaluation, law, folder, dask=dask, progress=within[1])
    found = learnt(polished.evaluation)
    samples = posterior(found, law, seed=0)
    chosen = refined(polished.chosen, samples, folder, dask=dask, progress=within[2])
    steps = tuple(chosen if len(step.free) == len(chosen.free) else step for step in polished.steps)
    free = chosen.free
    by_seed = [step_with(each, free, law) for each in searches]
    choices = {
        "as printed": Choice({}),
        "one factor at a time": ONE_AT_A_TIME,
        "found on all curves": chosen.choice,
        **{f"found on {name}": step.choice for name, step in polished.halves.items()},
        **{f"found from seed {seed}": step.choice for seed, step in enumerate(by_seed)},
    }
    told = tell(choices, folder, dask=dask, progress=within[3])
    by_name = {each.name: each for each in told}
    return SourceStudy(
        found,
        steps,
        chosen,
        tuple(by_seed),
        samples,
        told,
        tuple(
            OutOfSample(name, *deviations_of_curves(by_name[f"found on {name}"].fits[0], members))
            for name, (_, members) in HALVES.items()
        ),
    )


def _parts(progress: Progress | None, *sizes: float) -> list[Progress | None]:
    """Reports of parts of such sizes, one after the other."""
    return [part(progress, sum(sizes[:i]) / sum(sizes), size / sum(sizes)) for i, size in enumerate(sizes)]


def tell(
    choices: Mapping[str, Choice],
    folder: Path,
    *,
    dask: object = None,
    progress: Progress | None = None,
) -> tuple[Told, ...]:
    """Simulate choices from `STARTS` starts that the search has not seen, and what it does not look at."""
    within = _parts(progress, 1, 1)
    each = list(choices.values())
    _, *made = evaluate(each, folder, "told", starts=STARTS, seed=1, dask=dask, progress=within[0])
    found = find(each, folder, "found", starts=STARTS - 1, seed=1, dask=dask, progress=within[1])
    return tuple(_told(name, made, i, findings) for i, (name, findings) in enumerate(zip(choices, found, strict=True)))


def _told(name: str, made: Sequence[Evaluation], i: int, findings: Findings) -> Told:
    starts = joined(*(m.only(i) for m in made))
    fits = starts.fits
    aims = [residuals_of(starts, k) for k in range(len(FITS_FROM))]
    loss = np.array([a.loss() for a in aims])
    squares = (aims[0].values ** 2).mean(axis=0)
    with warnings.catch_warnings():
        # A curve that no start has a fit of has no median either.
        warnings.simplefilter("ignore", RuntimeWarning)
        middle = np.nanmedian(fits, axis=0)
    return Told(
        name, made[0].choices[i], middle, float(np.isnan(fits[:, 0, :, 0]).sum(axis=1).mean()),
        float(np.mean(starts.at_12)), loss.mean(axis=1), float(loss.mean(axis=0).std(ddof=1)),
        {str(kind): float(squares[kind == KIND].sum()) for kind in dict.fromkeys(KIND)}, findings,
    )  # fmt: skip
