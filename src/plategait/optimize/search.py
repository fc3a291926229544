"""The search: motions spread over the space, an evolution strategy from the best, and a proof of what it finds.

How many runs each part takes follows from the number of variables and from the chance of failure that is permitted; no
number here was fitted to an object.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array, Flags
from plategait.model.motion import PlateMotion
from plategait.optimize.goal import AIMED, Goal
from plategait.optimize.proof import CONFIRMED, FINER, HEATS, Proof, agree, better, prove, standing
from plategait.optimize.ranking import ranks, runs_without_failure
from plategait.optimize.space import Space
from plategait.optimize.spread import scattered, spread
from plategait.optimize.strategy import evolution_strategy
from plategait.optimize.symmetry import nearest_images
from plategait.optimize.trials import Bench, Trial

STARTS = (1, 1, 3)
"""Runs of a motion in the first, the second and the last third of the generations.

A motion on which the object stays does the same from every start, to a few per cent; uncertain is whether it stays.
"""
LOOSE = 0.2
"""Share of the spread that counts as reaching a goal at first."""
SHORT = 0.05
"""First steps from where another strategy ended, as a share of each range."""
CARRYING, BEGINNINGS, ROAMING = 256, 3, 0.1
"""Motions of the spread from which a search for a velocity sets out, how often it does, and its first steps then.

Few motions carry an object without turning it: what is near the goal at first decides whether it is found.
"""
CONFIRMATION = 10**6 + 1
"""Number of the batch of a confirmation, apart from those of a search: what a search confirmed need not run again."""
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
    stages : tuple of Generations
        Of the strategy with all freedoms at rest, and of one more with each freedom in turn (`Space.stages`). Where an
        object is to be carried, of the strategies from each beginning, all of which have all freedoms.
    test : int
        Runs of the test, in none of which the object may fail.
    """

    first: int
    stages: tuple[Generations, ...]
    test: int

    @property
    def expected(self) -> int:
        """Runs of a search all of whose proofs succeed at once: that of its best, and of the best without freedoms."""
        proof = sum(motions * runs for motions, runs in HEATS) + self.test
        return self.first + sum(stage.runs for stage in self.stages) + proof * min(len(self.stages), 2)


def usual_generations(variables: int) -> Generations:
    """Generations for a number of variables: the populations are those usual for CMA-ES, 4 + 3 ln d and even."""
    population = max(8, 2 * math.ceil((4 + 3 * math.log(max(variables, 1))) / 2))
    return Generations(population, 27 + 3 * max(variables - 3, 0))


def usual_effort(space: Space, goal: Goal, permitted: float, confidence: float) -> Effort:
    """Effort for a space, what is sought in it and what is to be bounded."""
    if goal.way:
        one = usual_generations(len(space.variables))
        return Effort(CARRYING, (one,) * BEGINNINGS, runs_without_failure(permitted, confidence))
    first = 64 + 32 * max(len(space.variables) - 3, 0)
    stages = tuple(usual_generations(int(varies.sum())) for varies in space.stages)
    return Effort(first, stages, runs_without_failure(permitted, confidence))


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
        """All of it: first with all freedoms at rest, then with one more of them in turn from the best there is."""
        if self.goal.way:
            return self._carried()
        first = self._try(spread(self.space, self.effort.first, self.seed), 1)
        stages = self.space.stages
        rested, roamed = [t for t in first if self._rests(t)], [t for t in first if not self._rests(t)]
        if len(stages) == 1:
            self._evolve(first, stages[0], self.effort.stages[0])
            return Found(self._proved(self.trials), None, tuple(self.trials), self.runs, self.seed)
        last = self._evolve(rested, stages[0], self.effort.stages[0])
        at_rest = self._proved([trial for trial in self.trials if self._rests(trial)])
        for varies, generations in zip(stages[1:], self.effort.stages[1:], strict=True):
            # The spread with freedoms has all of them: only the last strategy can go on from there.
            last = self._evolve(roamed if varies.all() else [], varies, generations, last)
        best = self._proved(self.trials)
        if better(at_rest, best, self.goal):
            best = at_rest
        return Found(best, at_rest, tuple(self.trials), self.runs, self.seed)

    def _rests(self, trial: Trial) -> bool:
        """Whether all freedoms are at rest in a trial."""
        neutral = self.space.neutral
        return bool((np.isnan(neutral) | (trial.shares == neutral)).all())

    def _evolve(
        self, first: Sequence[Trial], varies: Flags, generations: Generations, evolved: Sequence[Trial] = ()
    ) -> list[Trial]:
        """Let a strategy go from the best of a spread, or of what another ended with; gives its last generation.

        Its first steps are half of what parts the motions of the spread, or short ones about where the other ended.
        The variables (d,) that do not vary stay as they are there.
        """
        allowed, dimension = self._allowed([*first, *evolved], generations.count), int(varies.sum())
        both = [*first, *evolved]
        best = int(ranks(both, self.goal, allowed[0]).argmin())
        step = SHORT if best >= len(first) else 0.5 * self.effort.first ** (-1 / dimension)
        return self._climb(both[best].shares, step, varies, generations, allowed, self.seed)

    def _carried(self) -> Found:
        """Search for a motion that carries: strategies with all freedoms, each from another motion near the goal.

        Until the goal is reached nothing else counts: cheap motions that hardly move lead nowhere. The best of each is
        proved, as all that a strategy ends with may be too uncertain, or do otherwise at a finer step.
        """
        first = self._try(list(scattered(self.space, self.effort.first, self.seed)), 1)
        varies = np.ones(len(self.space.variables), dtype=bool)
        beginnings = nearest_images(self.space, self.goal, first, len(self.effort.stages))
        proofs = []
        for number, (start, generations) in enumerate(zip(beginnings, self.effort.stages, strict=False)):
            before = len(self.trials)
            self._climb(start, ROAMING, varies, generations, np.full(generations.count, AIMED), self.seed + number)
            proofs.append(self._proved(self.trials[before:]))
        best = min(proofs, key=lambda proof: standing(proof, self.goal))
        return Found(best, None, tuple(self.trials), self.runs, self.seed)

    def _climb(
        self, start: Array, step: float, varies: Flags, generations: Generations, allowed: Array, seed: int
    ) -> list[Trial]:
        """Generations of a strategy from shares (d,) of which some vary; gives the last."""
        strategy = evolution_strategy(
            np.clip(start[varies], _EDGE, 1 - _EDGE), step, [0.0] * int(varies.sum()), [1.0] * int(varies.sum()),
            generations.population, seed, "optimize",
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
        begin = max(AIMED, float(np.quantile(stays, LOOSE))) if stays else AIMED
        progress = np.arange(count) * len(STARTS) / (count * (len(STARTS) - 1))
        return AIMED + (begin - AIMED) * np.maximum(1 - progress, 0.0) ** 2

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

        return prove(trials, self.goal, again, self.effort.test, self.permitted, self.confidence, self._holds)

    def _holds(self, trial: Trial) -> bool:
        """Whether a motion that passed its test reaches the goal, and does the same at a tenth of the step."""
        if self.goal.fastest:
            return True
        if self.goal.deviation(trial.twist) > 1:
            return False
        self.runs += CONFIRMED
        (fine,) = self.bench.try_motions([(trial.shares, trial.motion)], CONFIRMED, CONFIRMATION, finer=FINER)
        return agree(fine, trial, self.goal)
