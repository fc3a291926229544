"""The proof of a search's best motion: heats of the favourites and a test, all from fresh starts.

Among hundreds of trials some are lucky. What they showed chooses who runs again, and is forgotten then.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from plategait.optimize.goal import LEAST_RATE, LEAST_VELOCITY, Goal
from plategait.optimize.ranking import largest_chance, ranks
from plategait.optimize.trials import Trial

HEATS = ((16, 4), (8, 8), (4, 16))
"""Motions and runs of each in the heats: half of them go on to twice the runs, so that each heat costs the same."""
MOST_ROUNDS, MOST_TESTS = 4, 2
"""Rounds of heats at most, each of the next favourites, and tests in each."""
FINER, CONFIRMED = 10, 16
"""How many times as fine the time step of a confirmation is, and its runs."""


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
    holds : bool
        Whether it reaches what is sought, at a tenth of the time step too; not asked of the fastest spin.
    """

    trial: Trial
    certain: bool
    tests: int
    holds: bool = True


Holds = Callable[[Trial], bool]
"""Whether a motion that passed its test reaches what is sought, at a tenth of the time step too."""


def prove(
    trials: Sequence[Trial],
    goal: Goal,
    again: Callable[[Sequence[Trial], int], list[Trial]],
    test: int,
    permitted: float,
    confidence: float,
    holds: Holds = lambda trial: True,
) -> Proof:
    """The best of some trials that passes heats and a test, and holds; where none does the nearest to that.

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
    holds : callable
        What else is asked of a motion that passed its test.
    """
    order, tested = _ordered(trials, goal), list[Proof]()

    def proved(trial: Trial) -> Proof:
        (made,) = again([trial], test)
        certain = largest_chance(made.failed, made.runs, confidence) <= permitted
        return Proof(made, certain, len(tested) + 1, certain and holds(made))

    for _ in range(MOST_ROUNDS):
        favourites, order = order[: HEATS[0][0]], order[HEATS[0][0] :]
        for trial in _heats(favourites, goal, again)[:MOST_TESTS]:
            tested.append(proved(trial))
            if tested[-1].holds:
                return tested[-1]
        if not order:
            break
    tested = tested or [proved(_ordered(trials, goal)[0])]
    return min(tested, key=lambda proof: (not proof.certain, proof.trial.failed, standing(proof, goal)))


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


def agree(fine: Trial, usual: Trial, goal: Goal) -> bool:
    """Whether a motion does the same at a tenth of the time step, as far as what is sought goes.

    Its velocity is within 5 % of what it was, or 5 mm/s and 5 deg/s, and what the starts leave uncertain of either.
    """
    if not fine.counted or not usual.counted:
        return False
    least = np.array([LEAST_VELOCITY, LEAST_VELOCITY, LEAST_RATE])
    allowed = np.maximum(0.05 * abs(usual.twist), least) + np.nan_to_num(fine.half_width + usual.half_width)
    return bool((np.abs(fine.twist - usual.twist) <= allowed)[list(goal.sought)].all())


def standing(proof: Proof, goal: Goal) -> tuple[bool, bool, float, float]:
    """What proofs are compared by, the least for the best."""
    trial = proof.trial
    if goal.fastest:
        return not proof.certain, not proof.holds, 0.0, -abs(float(np.nan_to_num(trial.spin_rate)))
    return (
        not proof.certain,
        not proof.holds,
        max(goal.deviation(trial.twist), 1.0),
        float(np.nan_to_num(trial.cost(goal.cost), nan=np.inf)),
    )
