"""The search: motions spread over the space, an evolution strategy from the best, heats of the favourites, a test.

How many runs each part takes follows from the number of variables and from the chance of failure that is permitted; no
number here was fitted to an object.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import qmc

from plategait.arrays import Array
from plategait.model.motion import PlateMotion
from plategait.optimize.goal import Goal
from plategait.optimize.ranking import largest_chance, ranks, runs_without_failure
from plategait.optimize.space import Space
from plategait.optimize.strategy import evolution_strategy
from plategait.optimize.trials import Bench, Trial

STARTS = (1, 1, 3)
"""Runs of a motion in the first, the second and the last third of the generations.

A motion on which the object stays does the same from every start, to a few per cent; uncertain is whether it stays.
"""
HEATS = ((16, 4), (8, 8), (4, 16))
"""Motions and runs of each in the heats: half of them go on to twice the runs, so that each heat costs the same."""
MOST_ROUNDS, MOST_TESTS = 4, 2
"""Rounds of heats at most, each of the next favourites, and tests in each."""


@dataclass(frozen=True)
class Effort:
    """How much is run.

    Attributes
    ----------
    first : int
        Motions spread over the space, one run each.
    population, generations : int
        Of the evolution strategy.
    test : int
        Runs of the test, in none of which the object may fail.
    """

    first: int
    population: int
    generations: int
    test: int

    @property
    def expected(self) -> int:
        """Runs of a search that passes its first test."""
        third = [self.starts(g) for g in range(self.generations)]
        heats = sum(motions * runs for motions, runs in HEATS)
        return self.first + self.population * sum(third) + heats + self.test

    def step(self, variables: int) -> float:
        """How far the first generation goes, as a share of each range: half of what parts the spread's motions."""
        return 0.5 * self.first ** (-1 / variables)

    def starts(self, generation: int) -> int:
        """Runs of each motion of a generation, counted from 0."""
        return STARTS[min(generation * len(STARTS) // self.generations, len(STARTS) - 1)]


def usual_effort(variables: int, permitted: float, confidence: float) -> Effort:
    """Effort for a number of variables: the populations are those usual for CMA-ES, 4 + 3 ln d and even."""
    further = max(variables - 3, 0)
    population = max(8, 2 * math.ceil((4 + 3 * math.log(variables)) / 2))
    return Effort(64 + 32 * further, population, 27 + 3 * further, runs_without_failure(permitted, confidence))


@dataclass(frozen=True, eq=False)
class Found:
    """What a search found.

    Attributes
    ----------
    best : Trial
        The best motion with the runs of its test alone, in none of which it was chosen.
    certain : bool
        Whether the test bounds its chance of failure as asked for.
    trials : tuple of Trial
        All that was tried, in its order.
    generations : tuple of (mean, step) of float arrays
        Where the strategy was after each generation, and how far it went on each variable, in shares of the ranges.
    tests : int
        Tests made.
    runs : int
        All runs made.
    seed : int
    """

    best: Trial
    certain: bool
    trials: tuple[Trial, ...]
    generations: tuple[tuple[Array, Array], ...]
    tests: int
    runs: int
    seed: int


def search(
    space: Space, goal: Goal, bench: Bench, *, effort: Effort, permitted: float, confidence: float, seed: int
) -> Found:
    """Search a space for the motion that does best.

    Parameters
    ----------
    space, goal, bench
    effort : Effort
    permitted, confidence : float
        Chance of failure that is permitted, and with which confidence it is to be bounded.
    seed : int
        Of what is tried.
    """
    return _Search(space, goal, bench, effort, permitted, confidence, seed).run()


class _Search:
    """One search while it goes on."""

    def __init__(
        self, space: Space, goal: Goal, bench: Bench, effort: Effort, permitted: float, confidence: float, seed: int
    ) -> None:
        self.space, self.goal, self.bench, self.effort = space, goal, bench, effort
        self.permitted, self.confidence, self.seed = permitted, confidence, seed
        self.trials: list[Trial] = []
        self.runs = self.batch = 0

    def run(self) -> Found:
        """All of it."""
        first = self._try(spread(self.space, self.effort.first, self.seed), 1)
        start = self._ordered(first)[0].shares
        dimension = len(start)
        strategy = evolution_strategy(
            np.clip(start, 0.02, 0.98), self.effort.step(dimension), [0.0] * dimension, [1.0] * dimension,
            self.effort.population, self.seed, "optimize",
        )  # fmt: skip
        generations = []
        for generation in range(self.effort.generations):
            asked = strategy.ask()
            made = self._try([np.asarray(shares) for shares in asked], self.effort.starts(generation))
            strategy.tell(asked, ranks(made, self.goal).tolist())
            generations.append((np.array(strategy.result.xfavorite), np.array(strategy.result.stds)))
        best, certain, tests = self._proved()
        return Found(best, certain, tuple(self.trials), tuple(generations), tests, self.runs, self.seed)

    def _try(self, shares: Sequence[Array], runs: int) -> list[Trial]:
        made = self._made([(each, self.space.at(each)) for each in shares], runs)
        self.trials += made
        return made

    def _again(self, trials: Sequence[Trial], runs: int) -> list[Trial]:
        return self._made([(trial.shares, trial.motion) for trial in trials], runs)

    def _made(self, asked: Sequence[tuple[Array, PlateMotion]], runs: int) -> list[Trial]:
        self.batch += 1
        self.runs += runs * len(asked)
        return self.bench.try_motions(asked, runs, self.batch)

    def _proved(self) -> tuple[Trial, bool, int]:
        """The best of all trials that passes heats and a test, all from fresh starts; else the least likely to fail.

        Among so many trials some are lucky: what they showed chooses who runs, and is forgotten then.
        """
        order, tested = self._ordered(self.trials), []
        for _ in range(MOST_ROUNDS):
            favourites, order = order[: HEATS[0][0]], order[HEATS[0][0] :]
            for trial in self._heats(favourites)[:MOST_TESTS]:
                tested += self._again([trial], self.effort.test)
                if largest_chance(tested[-1].failed, tested[-1].runs, self.confidence) <= self.permitted:
                    return tested[-1], True, len(tested)
            if not order:
                break
        tested = tested or self._again(self._ordered(self.trials)[:1], self.effort.test)
        return min(tested, key=lambda trial: trial.failed), False, len(tested)

    def _heats(self, favourites: Sequence[Trial]) -> list[Trial]:
        """Favourites that no heat saw fail, the best first."""
        heat = self._again(favourites, HEATS[0][1])
        for motions, runs in HEATS[1:]:
            left = [trial for trial in self._ordered(heat)[:motions] if trial.failed == 0]
            more = self._again(left, runs) if left else []
            heat = [trial.joined(other) for trial, other in zip(left, more, strict=True)]
        return [trial for trial in self._ordered(heat) if trial.failed == 0 and trial.counted]

    def _ordered(self, trials: Sequence[Trial]) -> list[Trial]:
        return [trials[i] for i in np.argsort(ranks(trials, self.goal), kind="stable")]


def spread(space: Space, count: int, seed: int) -> list[Array]:
    """Shares (d,) that fill a space evenly; where freedoms were asked for, every second leaves them all at rest.

    The optimum without the freedoms is one of the motions with them, so that they cannot be worse for being many.
    """
    with warnings.catch_warnings():
        # Other counts than powers of two are only a little less even.
        warnings.simplefilter("ignore", UserWarning)
        generator = qmc.Sobol(len(space.variables), seed=np.random.default_rng(seed))  # pyright: ignore[reportCallIssue]
        shares = generator.random(count)
    neutral = space.neutral
    at_rest = (np.arange(count) % 2 == 1)[:, None] & np.isfinite(neutral)[None]
    return list(np.where(at_rest, neutral[None], shares))
