"""The optimum: the motion that was found, and how far it can be relied on."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from plategait.model.machine import Machine
from plategait.model.scenario import Scenario
from plategait.model.scenario_file import write_scenario
from plategait.optimize.goal import LEAST_RATE, Goal
from plategait.optimize.proof import agree, standing
from plategait.optimize.ranking import largest_chance, least_chance
from plategait.optimize.search import Found
from plategait.optimize.space import Space, Variable
from plategait.optimize.trials import Trial, no_failure
from plategait.shown import Shown, in_short
from plategait.simulation.observables import student_95


@dataclass(frozen=True, eq=False)
class Sensitivity:
    """What a little less and a little more of one variable does.

    Attributes
    ----------
    variable : Variable
    value : float
        At the optimum, SI.
    less, more : (value, Trial) or None
        Where it was moved to, and what that does; None where the range or the machine ends there.
    """

    variable: Variable
    value: float
    less: tuple[float, Trial] | None
    more: tuple[float, Trial] | None


@dataclass(frozen=True, eq=False, repr=False)
class Optimum(Shown):
    """The motion that does best, and how far it can be relied on.

    Attributes
    ----------
    scenario : Scenario
        The object on the motion.
    goal : Goal
    machine : Machine
    space : Space
    found : tuple of Found
        By each search; the best of them is what counts.
    permitted, confidence : float
    sensitivities : tuple of Sensitivity
    confirmation : Trial
        The motion at a tenth of the time step.
    """

    scenario: Scenario
    goal: Goal
    machine: Machine
    space: Space
    found: tuple[Found, ...]
    permitted: float
    confidence: float
    sensitivities: tuple[Sensitivity, ...]
    confirmation: Trial

    def told(self) -> list[tuple[str, str]]:
        """What the motion does, and whether it can be relied on."""
        motion, twist = self.scenario.motion, self.trial.twist
        return [
            ("object", self.scenario.name), ("machine", self.machine.name), ("goal", in_short(self.goal)),
            ("plate", f"{motion.frequency:.4g} Hz, {math.degrees(motion.angle):.3g} deg, {1e3 * motion.stroke:.3g} mm"),
            ("velocity", f"{1e3 * twist[0]:.3g} and {1e3 * twist[1]:.3g} mm/s, {math.degrees(twist[2]):.4g} deg/s"),
            ("fails", f"at most {100 * self.chance_of_failure:.2g} % at {100 * self.confidence:g} % confidence"),
            ("reached", "yes" if self.reached else "no"), ("confirmed", "yes" if self.confirmed else "no"),
            ("runs", str(self.evaluations)),
        ]  # fmt: skip

    @property
    def chosen(self) -> Found:
        """The search that found it."""
        return best_of(self.found, self.goal)

    @property
    def trial(self) -> Trial:
        """The motion with the runs of its test, in none of which it was chosen."""
        return self.chosen.proof.trial

    @property
    def certain(self) -> bool:
        """Whether the chance of failure is bounded as asked for."""
        return self.chosen.proof.certain

    @property
    def chance_of_failure(self) -> float:
        """Upper bound of the chance of failure, at the confidence asked for."""
        return largest_chance(self.trial.failed, self.trial.runs, self.confidence)

    @property
    def reached(self) -> bool:
        """Whether what was sought is reached: a spin that counts as one, or the velocity that was asked for."""
        if self.goal.fastest:
            return bool(abs(self.trial.spin_rate) > LEAST_RATE)
        return self.goal.deviation(self.trial.twist) <= 1

    @property
    def confirmed(self) -> bool:
        """Whether the motion does the same at a tenth of the time step.

        See `plategait.optimize.proof.agree`; and it does not fail more often than is permitted, as far as so few runs
        can tell.
        """
        fine = self.confirmation
        return (
            agree(fine, self.trial, self.goal)
            and least_chance(fine.failed, fine.runs, self.confidence) <= self.permitted
        )

    @property
    def sound(self) -> bool:
        """Whether it is reached, does not fail more often than permitted, and is confirmed."""
        return self.certain and self.reached and self.confirmed

    @property
    def gain(self) -> tuple[float, float] | None:
        """What the freedoms add to the spin rate, rad/s, with half its 95 % interval over the searches.

        Of one search the interval is over the starts alone, and says nothing of how much luck the search had. None
        without freedoms, or where no spin is sought.
        """
        pairs = [(each.proof.trial, each.at_rest.trial) for each in self.found if each.at_rest is not None]
        if not pairs or not self.goal.fastest:
            return None
        gains = [abs(freed.spin_rate) - abs(rest.spin_rate) for freed, rest in pairs]
        if len(pairs) == 1:
            freed, rest = pairs[0]
            return gains[0], math.hypot(freed.half_width[2], rest.half_width[2])
        half = student_95(len(gains) - 1) * float(np.std(gains, ddof=1)) / math.sqrt(len(gains))
        return float(np.mean(gains)), half

    @property
    def evaluations(self) -> int:
        """Runs of all searches, heats and tests included."""
        return sum(found.runs for found in self.found)

    @property
    def trials(self) -> tuple[Trial, ...]:
        """All motions that were tried."""
        return tuple(trial for found in self.found for trial in found.trials)

    def toml(self) -> str:
        """Scenario of the optimum as a file."""
        return write_scenario(self.scenario)


def best_of(found: Sequence[Found], goal: Goal) -> Found:
    """Search that found the best motion."""
    return min(found, key=lambda each: standing(each.proof, goal))


def front(trials: Sequence[Trial], cost: str) -> list[Trial]:
    """Trials that none is both faster and cheaper than, of those of which no run failed; the slowest first.

    Parameters
    ----------
    trials : sequence of Trial
    cost : str
        What they cost (`plategait.optimize.goal.COSTS`).
    """
    stays = [trial for trial, fine in zip(trials, no_failure(trials), strict=True) if fine]
    left, best = [], math.inf
    for trial in sorted(stays, key=lambda t: -abs(t.spin_rate)):
        value = trial.cost(cost)  # type: ignore[arg-type]
        if value < best:
            left.append(trial)
            best = value
    return left[::-1]
