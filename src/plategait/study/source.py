"""The study of the source's unknowns, from the first evaluation to what it may claim."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.model.presets import preset
from plategait.study.aims import KIND, residuals
from plategait.study.evaluation import FITS_FROM, Evaluation, evaluate, joined
from plategait.study.inference import OutOfSample, Step, backward, deviations_of_curves, found_on, step_with
from plategait.study.search import Learnt, learnt, losses, misfits, near_best, posterior, search
from plategait.study.unknowns import NAMES, UNKNOWNS, Choice

SEEDS = 3
FIRST, GENERATIONS = 96, 12
"""Evaluations of each seed over the priors, and generations of the evolution strategy from the best of them."""
REPEATS = 4
"""Starts of each run with which choices are told at the end."""
QUANTILES = (0.05, 0.5, 0.95)
DETERMINED = 0.5
"""An unknown is determined by the published data where the posterior is narrower than this share of the prior."""


@dataclass(frozen=True, eq=False)
class Told:
    """A choice simulated with several starts.

    Attributes
    ----------
    name : str
    choice : Choice
    fits : (fits_from, curves, outputs) array
    at_12 : float
        Rate at A_p = 12 deg and 12 Hz, deg/s.
    loss : (fits_from,) array
        Of all aims, by where the fit begins.
    by_kind : mapping of str to float
        Share of each kind of aim in the loss, where the fit begins first.
    """

    name: str
    choice: Choice
    fits: Array
    at_12: float
    loss: Array
    by_kind: Mapping[str, float]


@dataclass(frozen=True, eq=False)
class SourceStudy:
    """What the study found.

    Attributes
    ----------
    learnt : Learnt
        From the evaluations of all seeds.
    steps : tuple of Step
        Departures one by one under the law of the best choice, each set simulated.
    chosen : Step
        The set that pays for itself.
    by_seed : tuple of Step
        The same set found from each seed's own evaluations.
    samples : (n, d) array
        Posterior of all unknowns under the chosen law, in deviations of the priors.
    told : tuple of Told
        The printed choice, today's preset, the chosen one and those found on parts of the curves, simulated.
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
            "steps": [{"free": list(s.free), "misfit": s.misfit, "criterion": s.criterion} for s in self.steps],
            "told": [
                {"name": t.name, "loss": t.loss.tolist(), "rate_at_12_hz_deg_s": t.at_12, **_deviations(t)}
                for t in self.told
            ],
            "out_of_sample": [vars(o) for o in self.out_of_sample],
        }  # fmt: skip


def _deviations(told: Told) -> dict[str, float]:
    f0, largest, ratio, missing = deviations_of_curves(told.fits[0])
    return {"median_f0": f0, "largest_f0": largest, "median_b_over_f0": ratio, "without_fit": missing}


def todays_preset() -> Choice:
    """What the preset `cheese` takes."""
    scenario, printed = preset("cheese").scenario, preset("cheese-as-printed").scenario
    sheet, plain = scenario.sheet, printed.sheet
    return Choice(
        {
            "height": scenario.motion.height,
            "c_b factor": sheet.bending_damping / plain.bending_damping,
            "c_c factor": sheet.axial_damping / plain.axial_damping,
            "k_c factor": sheet.axial_stiffness / plain.axial_stiffness,
            "k_t/k_b": sheet.torsion_stiffness / sheet.bending_stiffness,
            "c_t/c_b": sheet.torsion_damping / sheet.bending_damping,
            "slip limit": 0.02,
        },
        scenario.friction.law,
    )


def study_source(
    folder: Path | str,
    *,
    seeds: int = SEEDS,
    first: int = FIRST,
    generations: int = GENERATIONS,
    dask: object = None,
    progress: Callable[[float], object] | None = None,
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
    share = 0.9 / seeds
    searches: list[Learnt] = []
    for seed in range(seeds):
        report = None if progress is None else (lambda x, s=seed, p=progress: p(share * (s + x)))
        searches.append(search(folder, seed, first=first, generations=generations, dask=dask, progress=report))
    evaluation = joined(*(each.evaluation for each in searches))
    found = learnt(evaluation, near_best(evaluation))
    law = evaluation.choices[int(losses(evaluation).argmin())].law
    steps = _simulated(backward(found, law), folder, dask)
    chosen = min(steps, key=lambda step: step.criterion)
    halves = found_on(found, chosen.free, chosen.law)
    choices = {
        "as printed": Choice({}),
        "today's preset": todays_preset(),
        "found on all curves": chosen.choice,
        **{f"found on {name}": step.choice for name, (step, _) in halves.items()},
    }
    report = None if progress is None else (lambda x: progress(0.9 + 0.1 * x))
    told = tell(choices, folder, dask=dask, progress=report)
    by_name = {each.name: each for each in told}
    return SourceStudy(
        found,
        steps,
        chosen,
        tuple(step_with(each, chosen.free, chosen.law) for each in searches),
        posterior(found, chosen.law, seed=0)[0],
        told,
        tuple(
            OutOfSample(name, *deviations_of_curves(by_name[f"found on {name}"].fits[0], members))
            for name, (_, members) in halves.items()
        ),
    )


def _simulated(steps: Sequence[Step], folder: Path, dask: object) -> tuple[Step, ...]:
    """Steps with the misfit of their choices simulated, in place of the surrogate's."""
    made = evaluate([step.choice for step in steps], folder, "departures", repeats=REPEATS, dask=dask)
    misfit = misfits(made)
    return tuple(
        replace(step, misfit=float(m), criterion=float(m) + len(step.free) * math.log(len(KIND)))
        for step, m in zip(steps, misfit, strict=True)
    )


def tell(
    choices: Mapping[str, Choice],
    folder: Path,
    *,
    dask: object = None,
    progress: Callable[[float], object] | None = None,
) -> tuple[Told, ...]:
    """Simulate choices with `REPEATS` starts each."""
    made = evaluate(list(choices.values()), folder, "told", repeats=REPEATS, dask=dask, progress=progress)
    return tuple(_told(name, made, i) for i, name in enumerate(choices))


def _told(name: str, made: Evaluation, i: int) -> Told:
    at = np.full(len(FITS_FROM), made.at_12[i])
    aims = residuals(made.fits[i], at)
    squares = aims.values[0] ** 2
    by_kind = {str(kind): float(squares[kind == KIND].sum()) for kind in dict.fromkeys(KIND)}
    return Told(name, made.choices[i], made.fits[i], float(made.at_12[i]), aims.loss(), by_kind)
