"""Primitives: the few motions that a planner begins with, verified from poses that nothing was chosen by."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array
from plategait.model.motion import PlateMotion
from plategait.optimize.space import Space
from plategait.optimize.trials import Trial

DIRECTIONS = {
    "forward": (0, 1.0),
    "back": (0, -1.0),
    "left": (1, 1.0),
    "right": (1, -1.0),
    "turn left": (2, 1.0),
    "turn right": (2, -1.0),
}
"""Component of the velocity (along, across, turning counter-clockwise) and its sign, by name."""
SURE = 3.0
"""Standard deviations over the starts that a primitive's speed must be above."""
# Weight of the speed in other directions, and of the spread over starts, each in sizes of a cell.
_ASIDE, _SPREAD = 4.0, 1.0
# 99.5 % point of the normal distribution: of a mean, both its own error and that of the runs that it stands for.
_NORMAL = 2.807


@dataclass(frozen=True, eq=False)
class Primitive:
    """A motion in one direction, and what fresh runs of it gave.

    Attributes
    ----------
    name : str
    trial : Trial
    """

    name: str
    trial: Trial

    @property
    def verified(self) -> bool:
        """Whether nothing failed and every run went the right way."""
        if self.trial.failed or not self.trial.counted:
            return False
        if self.name not in DIRECTIONS:
            return True
        component, sign = DIRECTIONS[self.name]
        return bool((sign * self.trial.twists[:, component] > 0).all())

    @property
    def interval(self) -> Array:
        """(3, 2) in which the mean velocity of as many fresh runs lies, at 99 %, SI."""
        half = _NORMAL * self.trial.spread * math.sqrt(2 / self.trial.counted)
        return np.stack([self.trial.twist - half, self.trial.twist + half], axis=1)


def candidates(trials: Sequence[Trial], sizes: Array) -> dict[str, list[Trial]]:
    """Trials in the order in which they serve, by the name of a primitive."""
    ordered = {name: sorted(trials, key=lambda t: -_merit(name, t, sizes)) for name in DIRECTIONS}
    return {name: [t for t in each if _merit(name, t, sizes) > 0] for name, each in ordered.items()}


def in_turn(name: str, trials: Sequence[Trial], sizes: Array) -> list[Trial]:
    """Those that go the right way for sure, the one that serves best first."""
    component, sign = DIRECTIONS[name]
    sure = [t for t in trials if not t.failed and sign * t.twist[component] > SURE * t.spread[component]]
    return sorted(sure, key=lambda t: -_merit(name, t, sizes))


def _merit(name: str, trial: Trial, sizes: Array) -> float:
    component, sign = DIRECTIONS[name]
    if trial.failed or not trial.counted:
        return -math.inf
    velocity = trial.twist / sizes
    aside = math.sqrt(float((velocity**2).sum() - velocity[component] ** 2))
    spread = float(trial.spread[component] / sizes[component]) if trial.counted > 1 else 0.0
    return float(sign * velocity[component]) - _ASIDE * aside - _SPREAD * SURE * spread


def still(space: Space) -> PlateMotion:
    """The plate at rest: on it an object stays where it is."""
    return space.base.replace(angle=0.0, stroke=0.0, waves=(), samples=None)
