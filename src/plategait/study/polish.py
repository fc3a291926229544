"""Sets of departures polished by simulation: the surrogate proposes each set's best, and learns from what it gives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from plategait.arrays import Flags
from plategait.study.evaluation import Evaluation, evaluate, joined
from plategait.study.inference import HALVES, Step, backward, smallest, step_with
from plategait.study.search import learnt, losses, misfits
from plategait.study.unknowns import NAMES, Choice, deviations_of

ROUNDS = 4


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
        What to begin from; its first choice is the printed one.
    law : str
        Of friction.
    folder, dask, progress
        See `plategait.study.evaluation.evaluate`.
    """
    printed = Step((), law, np.zeros(len(NAMES)), float(misfits(evaluation)[_printed(evaluation, law)]))
    simulated: list[Step] = [printed]
    for number in range(rounds):
        proposed = backward(learnt(evaluation), law)[1:]
        free = smallest(simulated if number else [printed, *proposed]).free
        halves = [step_with(learnt(evaluation, used), free, law, used) for used, _ in HALVES.values()]
        report = None if progress is None else (lambda x, n=number, p=progress: p((n + x) / rounds))
        choices = [step.choice for step in (*proposed, *halves)]
        made = evaluate(choices, folder, f"round-{number}", dask=dask, progress=report)
        simulated += [replace(s, misfit=float(m)) for s, m in zip(proposed, misfits(made), strict=False)]
        evaluation = joined(evaluation, made)
    steps = tuple(
        min((s for s in simulated if len(s.free) == n), key=_total)
        for n in range(max(len(s.free) for s in simulated) + 1)
    )
    chosen = smallest(steps)
    halves = {name: best_within(evaluation, chosen.free, law, used) for name, (used, _) in HALVES.items()}
    return Polished(evaluation, steps, chosen, halves)


def _total(step: Step) -> float:
    return step.misfit + float((step.deviations**2).sum())


def _printed(evaluation: Evaluation, law: str) -> int:
    return evaluation.choices.index(Choice({}, law))


def best_within(evaluation: Evaluation, free: Sequence[str], law: str, used: Flags | None = None) -> Step:
    """The simulated choice of least loss over the aims `used` that departs in nothing but `free`."""
    z = np.stack([deviations_of(choice) for choice in evaluation.choices])
    outside = np.array([name not in free for name in NAMES])
    inside = (np.abs(z[:, outside]) < 1e-9).all(axis=1) & np.array([c.law == law for c in evaluation.choices])
    loss = np.where(inside, losses(evaluation, used), np.inf)
    i = int(loss.argmin())
    return Step(tuple(free), law, z[i], float(misfits(evaluation, used)[i]))
