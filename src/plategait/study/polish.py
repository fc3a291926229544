"""Sets of departures polished by simulation: the surrogate proposes each set's best, and learns from what it gives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from plategait.arrays import Flags
from plategait.study.evaluation import Evaluation, evaluate, joined
from plategait.study.inference import HALVES, Step, backward, smallest, step_with
from plategait.study.search import learnt, misfits
from plategait.study.unknowns import NAMES

ROUNDS = 3
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
        The same departures found on part of the curves, by the names of `HALVES`.
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
    progress: Callable[[float], object] | None = None,
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
    for number in range(rounds):
        found = learnt(evaluation)
        proposed = backward(found, law)
        free = smallest([trial.told() for trial in trials] or proposed).free
        # As printed once, then what each half of the curves asks for: each round fills whole stores.
        halves = [step_with(learnt(evaluation, used), free, law, used) for used, _ in HALVES.values()]
        asked = [*proposed[number > 0 :], *halves]
        report = None if progress is None else (lambda x, n=number, p=progress: p((n + x) / rounds))
        made = evaluate(
            [step.choice for step in asked], folder, f"round-{number}", starts=STARTS, dask=dask, progress=report
        )
        trials += [_Trial(step, tuple(start.only(i) for start in made)) for i, step in enumerate(asked)]
        evaluation = joined(evaluation, *made)
    steps = tuple(_best(trials, None, lambda s, n=n: len(s.free) == n) for n in range(len(NAMES) + 1))
    chosen = smallest(steps)
    halves = {
        name: _best(trials, used, lambda s: set(s.free) <= set(chosen.free)) for name, (used, _) in HALVES.items()
    }
    return Polished(evaluation, steps, chosen, halves)


def _best(trials: Sequence[_Trial], used: Flags | None, among: Callable[[Step], bool]) -> Step:
    """Proposal of least simulated loss over the aims `used`, prior included."""
    told = [trial.told(used) for trial in trials if among(trial.step)]
    return min(told, key=lambda step: step.misfit + float((step.deviations**2).sum()))
