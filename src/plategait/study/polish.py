"""Sets of departures polished by simulation: the surrogate proposes each set's best, and learns from what it gives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from scipy.stats import qmc

from plategait.arrays import Array, Flags
from plategait.study.evaluation import CHOICES_OF_STORE, Evaluation, evaluate, joined
from plategait.study.inference import HALVES, Step, backward, smallest, step_with
from plategait.study.progress import Progress, part
from plategait.study.search import learnt, misfits
from plategait.study.unknowns import NAMES

ROUNDS = 3
MIDDLE = (0.05, 0.95)
"""Quantiles of the posterior between which the chosen departures are looked for once more."""
STARTS = 3
"""Starts of each run beside the nominal one: one start's loss has a standard deviation of 5 to 50."""


@dataclass(frozen=True, eq=False)
class Polished:
    """What simulations leave of the surrogate's proposals.

    Attributes
    ----------
    evaluation : Evaluation
        All that there were before, and those of the rounds.
    steps : tuple of Step
        Best simulated set of each number of departures, from none to all.
    chosen : Step
        The smallest that pays for itself.
    halves : mapping of str to Step
        The same departures found on part of the curves, by the names of `HALVES`: each of its own proposals only.
    """

    evaluation: Evaluation
    steps: tuple[Step, ...]
    chosen: Step
    halves: Mapping[str, Step]


@dataclass(frozen=True, eq=False)
class _Trial:
    """A proposal, and what it gave from each start."""

    step: Step
    starts: tuple[Evaluation, ...]

    def told(self, used: Flags | None = None) -> Step:
        """The proposal with its simulated misfit over the aims `used`."""
        misfit = np.array([misfits(start, used)[0] for start in self.starts])
        error = misfit.std(ddof=1) / np.sqrt(len(misfit))
        return replace(self.step, misfit=float(misfit.mean()), error=float(error))


def polish(
    evaluation: Evaluation,
    law: str,
    folder: Path,
    *,
    rounds: int = ROUNDS,
    dask: object = None,
    progress: Progress | None = None,
) -> Polished:
    """Propose, simulate and learn in turn.

    Parameters
    ----------
    evaluation : Evaluation
        What to begin from.
    law : str
        Of friction.
    folder, dask, progress
        See `plategait.study.evaluation.evaluate`.
    """
    trials: list[_Trial] = []
    of_half: dict[str, list[_Trial]] = {name: [] for name in HALVES}
    known = evaluation
    for number in range(rounds + 1):
        # Each round fills whole stores: as printed once, and what each half of the curves asks for; the last for these.
        proposed = backward(learnt(known), law)[number > 0 :] if number < rounds else []
        chosen = smallest(_simplest_to_fullest(trials) or proposed)
        halves = [step_with(learnt(known, used), chosen.free, law, used) for used, _ in HALVES.values()]
        report = part(progress, number / (rounds + 1), 1 / (rounds + 1))
        told = _simulated([*proposed, *halves], folder, f"round-{number}", dask, report)
        trials += told[: len(proposed)]
        for name, trial in zip(HALVES, told[len(proposed) :], strict=True):
            of_half[name].append(trial)
        known = joined(known, *(start for trial in told for start in trial.starts))
    steps = _simplest_to_fullest(trials)
    chosen = smallest(steps)
    found_on = {name: _best(of_half[name], used, lambda s: s.free == chosen.free) for name, (used, _) in HALVES.items()}
    return Polished(known, steps, chosen, found_on)


def refined(
    chosen: Step, samples: Array, folder: Path, *, dask: object = None, progress: Progress | None = None
) -> Step:
    """The chosen departures looked for once more: over the middle of their posterior, by simulations alone.

    The surrogate is right within a few per cent of a fit, which the misfit is too steep for near its least.

    Parameters
    ----------
    samples : (n, d) array
        Posterior of all unknowns, in deviations of the priors.
    """
    free = np.array([name in chosen.free for name in NAMES])
    if not free.any():
        return chosen
    low, high = np.quantile(samples[:, free], MIDDLE, axis=0)
    # Even shares of each range, no two alike, from a fixed seed.
    sampler = qmc.LatinHypercube(int(free.sum()), seed=np.random.default_rng(0))  # pyright: ignore[reportCallIssue]
    shares = sampler.random(CHOICES_OF_STORE)
    z = np.zeros((CHOICES_OF_STORE, len(NAMES)))
    z[:, free] = low + shares * (high - low)
    trials = _simulated([replace(chosen, deviations=row) for row in z], folder, "refined", dask, progress)
    return min([chosen, *(trial.told() for trial in trials)], key=_with_prior)


def _simulated(steps: Sequence[Step], folder: Path, name: str, dask: object, progress: Progress | None) -> list[_Trial]:
    """Proposals simulated from the nominal start and `STARTS` others."""
    choices = [step.choice for step in steps]
    made = evaluate(choices, folder, name, starts=STARTS, dask=dask, progress=progress)
    return [_Trial(step, tuple(start.only(i) for start in made)) for i, step in enumerate(steps)]


def _with_prior(step: Step) -> float:
    return step.misfit + float((step.deviations**2).sum())


def _simplest_to_fullest(trials: Sequence[_Trial]) -> tuple[Step, ...]:
    """Best simulated set of each number of departures, from none to all; none where nothing was simulated."""
    numbers = sorted({len(trial.step.free) for trial in trials})
    return tuple(_best(trials, None, lambda s, n=n: len(s.free) == n) for n in numbers)


def _best(trials: Sequence[_Trial], used: Flags | None, among: Callable[[Step], bool]) -> Step:
    """Proposal of least simulated loss over the aims `used`, prior included."""
    told = [trial.told(used) for trial in trials if among(trial.step)]
    return min(told, key=_with_prior)
