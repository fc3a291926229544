"""The proof of a search's best motion: heats of the favourites and a test, all from fresh starts.

Among hundreds of trials some are lucky. What they showed chooses who runs again, and is forgotten then.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from plategait.optimize.goal import Goal
from plategait.optimize.ranking import largest_chance, ranks
from plategait.optimize.trials import Trial

HEATS = ((16, 4), (8, 8), (4, 16))
"""Motions and runs of each in the heats: half of them go on to twice the runs, so that each heat costs the same."""
MOST_ROUNDS, MOST_TESTS = 4, 2
"""Rounds of heats at most, each of the next favourites, and tests in each."""


@dataclass(frozen=True, eq=False)
class Proof:
    """A motion that was tested.

    Attributes
    ----------
    trial : Trial
        The motion with the runs of its test alone, in none of which it was chosen.
    certain : bool
        Whether the test bounds its chance of failure as asked for.
    tests : int
        Tests made until then.
    """

    trial: Trial
    certain: bool
    tests: int


def prove(
    trials: Sequence[Trial],
    goal: Goal,
    again: Callable[[Sequence[Trial], int], list[Trial]],
    test: int,
    permitted: float,
    confidence: float,
) -> Proof:
    """The best of some trials that passes heats and a test; where none does the one that failed least in its test.

    Parameters
    ----------
    trials : sequence of Trial
    goal : Goal
    again : callable
        Runs motions anew, so often each.
    test : int
        Runs of the test.
    permitted, confidence : float
        Chance of failure that is permitted, and with which confidence it is to be bounded.
    """
    order, tested = _ordered(trials, goal), []
    for _ in range(MOST_ROUNDS):
        favourites, order = order[: HEATS[0][0]], order[HEATS[0][0] :]
        for trial in _heats(favourites, goal, again)[:MOST_TESTS]:
            tested += again([trial], test)
            if largest_chance(tested[-1].failed, tested[-1].runs, confidence) <= permitted:
                return Proof(tested[-1], True, len(tested))
        if not order:
            break
    tested = tested or again(_ordered(trials, goal)[:1], test)
    return Proof(min(tested, key=lambda trial: trial.failed), False, len(tested))


def _heats(
    favourites: Sequence[Trial], goal: Goal, again: Callable[[Sequence[Trial], int], list[Trial]]
) -> list[Trial]:
    """Favourites that no heat saw fail, the best first."""
    heat = again(favourites, HEATS[0][1])
    for motions, runs in HEATS[1:]:
        left = [trial for trial in _ordered(heat, goal)[:motions] if trial.failed == 0]
        more = again(left, runs) if left else []
        heat = [trial.joined(other) for trial, other in zip(left, more, strict=True)]
    return [trial for trial in _ordered(heat, goal) if trial.failed == 0 and trial.counted]


def _ordered(trials: Sequence[Trial], goal: Goal) -> list[Trial]:
    return [trials[i] for i in np.argsort(ranks(trials, goal), kind="stable")]


def better(one: Proof, other: Proof, goal: Goal) -> bool:
    """Whether one is better than another: first that its test was passed, then that it reaches the goal, then how."""
    return standing(one, goal) < standing(other, goal)


def standing(proof: Proof, goal: Goal) -> tuple[bool, float, float]:
    """What proofs are compared by, the least for the best."""
    trial = proof.trial
    if goal.fastest:
        return not proof.certain, 0.0, -abs(float(np.nan_to_num(trial.spin_rate)))
    return (
        not proof.certain,
        max(goal.deviation(trial.twist), 1.0),
        float(np.nan_to_num(trial.cost(goal.cost), nan=np.inf)),
    )
