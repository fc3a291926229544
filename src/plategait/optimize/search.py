"""The search: motions spread over the space, an evolution strategy from the best, and a proof of what it finds.

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

from plategait.arrays import Array, Flags
from plategait.model.motion import PlateMotion
from plategait.optimize.goal import Goal
from plategait.optimize.proof import HEATS, Proof, better, prove
from plategait.optimize.ranking import ranks, runs_without_failure
from plategait.optimize.space import Space
from plategait.optimize.strategy import evolution_strategy
from plategait.optimize.trials import Bench, Trial

STARTS = (1, 1, 3)
"""Runs of a motion in the first, the second and the last third of the generations.

A motion on which the object stays does the same from every start, to a few per cent; uncertain is whether it stays.
"""
LOOSE = 0.2
"""Share of the spread that counts as reaching a goal at first."""
SHORT = 0.05
"""First steps from where another strategy ended, as a share of each range."""
# How far a strategy starts from the ends of the ranges.
_EDGE = 0.02


@dataclass(frozen=True)
class Generations:
    """How long an evolution strategy goes on.

    Attributes
    ----------
    population, count : int
        Motions of a generation, and generations.
    """

    population: int
    count: int

    def starts(self, generation: int) -> int:
        """Runs of each motion of a generation, counted from 0."""
        return STARTS[min(generation * len(STARTS) // self.count, len(STARTS) - 1)]

    @property
    def runs(self) -> int:
        """Runs of all of them."""
        return self.population * sum(self.starts(generation) for generation in range(self.count))


@dataclass(frozen=True)
class Effort:
    """How much is run.

    Attributes
    ----------
    first : int
        Motions spread over the space, one run each.
    at_rest, freed : Generations
        Of the strategy with all freedoms at rest, and of the one with them; the latter alone where there are none.
    test : int
        Runs of the test, in none of which the object may fail.
    """

    first: int
    at_rest: Generations
    freed: Generations
    test: int

    def expected(self, has_freedoms: bool) -> int:
        """Runs of a search all of whose proofs succeed at once."""
        proof = sum(motions * runs for motions, runs in HEATS) + self.test
        return self.first + self.freed.runs + proof + (self.at_rest.runs + proof if has_freedoms else 0)


def usual_generations(variables: int) -> Generations:
    """Generations for a number of variables: the populations are those usual for CMA-ES, 4 + 3 ln d and even."""
    population = max(8, 2 * math.ceil((4 + 3 * math.log(max(variables, 1))) / 2))
    return Generations(population, 27 + 3 * max(variables - 3, 0))


def usual_effort(space: Space, permitted: float, confidence: float) -> Effort:
    """Effort for a space and what is to be bounded."""
    variables, at_rest = len(space.variables), int(np.isnan(space.neutral).sum())
    first = 64 + 32 * max(variables - 3, 0)
    test = runs_without_failure(permitted, confidence)
    return Effort(first, usual_generations(at_rest), usual_generations(variables), test)


@dataclass(frozen=True, eq=False)
class Found:
    """What a search found.

    Attributes
    ----------
    proof : Proof
        Of the best motion.
    at_rest : Proof, optional
        Of the best motion in which the freedoms that were asked for are at rest; None where there are none.
    trials : tuple of Trial
        All that was tried, in its order.
    runs : int
        All runs made.
    seed : int
    """

    proof: Proof
    at_rest: Proof | None
    trials: tuple[Trial, ...]
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
        """All of it: where freedoms were asked for, first with them at rest, then with them from the best there is."""
        neutral = self.space.neutral
        every, plain = np.ones(len(neutral), dtype=bool), ~np.isfinite(neutral)
        first = self._try(spread(self.space, self.effort.first, self.seed), 1)
        at_rest, last = None, []
        if plain.any() and not plain.all():
            rested = [trial for trial in first if (trial.shares == neutral)[~plain].all()]
            last = self._evolve(rested, plain, self.effort.at_rest)
            at_rest = self._proved([t for t in self.trials if (t.shares == neutral)[~plain].all()])
            first = [trial for trial in first if (trial.shares != neutral)[~plain].any()]
        self._evolve(first, every, self.effort.freed, last)
        best = self._proved(self.trials)
        if at_rest is not None and better(at_rest, best, self.goal):
            best = at_rest
        return Found(best, at_rest, tuple(self.trials), self.runs, self.seed)

    def _evolve(
        self, first: Sequence[Trial], varies: Flags, generations: Generations, evolved: Sequence[Trial] = ()
    ) -> list[Trial]:
        """Let a strategy go from the best of a spread, or of what another ended with; gives its last generation.

        Its first steps are half of what parts the motions of the spread, or short ones about where the other ended.
        The variables (d,) that do not vary stay as they are there.
        """
        allowed, dimension = self._allowed(first, generations.count), int(varies.sum())
        both = [*first, *evolved]
        best = int(ranks(both, self.goal, allowed[0]).argmin())
        start, step = both[best].shares, SHORT if best >= len(first) else 0.5 * self.effort.first ** (-1 / dimension)
        strategy = evolution_strategy(
            np.clip(start[varies], _EDGE, 1 - _EDGE), step, [0.0] * dimension, [1.0] * dimension,
            generations.population, self.seed, "optimize",
        )  # fmt: skip
        made: list[Trial] = []
        for generation in range(generations.count):
            asked = strategy.ask()
            whole = [start.copy() for _ in asked]
            for shares, own in zip(whole, asked, strict=True):
                shares[varies] = own
            made = self._try(whole, generations.starts(generation))
            strategy.tell(asked, ranks(made, self.goal, allowed[generation]).tolist())
        return made

    def _allowed(self, first: Sequence[Trial], count: int) -> Array:
        """(count,) deviation up to which each generation counts a goal as reached.

        At first so much that a fifth of the spread counts, so that the cheapest way is looked for before the goal is
        narrowed down upon; in the last third only what is reached (the ε-constrained method of Takahama and Sakai).
        """
        stays = [self.goal.deviation(trial.twist) for trial in first if not trial.failed and trial.counted]
        begin = max(1.0, float(np.quantile(stays, LOOSE))) if stays else 1.0
        progress = np.arange(count) * len(STARTS) / (count * (len(STARTS) - 1))
        return 1 + (begin - 1) * np.maximum(1 - progress, 0.0) ** 2

    def _try(self, shares: Sequence[Array], runs: int) -> list[Trial]:
        made = self._made([(each, self.space.at(each)) for each in shares], runs)
        self.trials += made
        return made

    def _made(self, asked: Sequence[tuple[Array, PlateMotion]], runs: int) -> list[Trial]:
        self.batch += 1
        self.runs += runs * len(asked)
        return self.bench.try_motions(asked, runs, self.batch)

    def _proved(self, trials: Sequence[Trial]) -> Proof:
        def again(some: Sequence[Trial], runs: int) -> list[Trial]:
            return self._made([(trial.shares, trial.motion) for trial in some], runs)

        return prove(trials, self.goal, again, self.effort.test, self.permitted, self.confidence)


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
    has_plain = bool(np.isnan(neutral).any())
    at_rest = (np.arange(count) % 2 == 1)[:, None] & np.isfinite(neutral)[None] & has_plain
    return list(np.where(at_rest, neutral[None], shares))
