"""What the search may claim: which departures are paid for, whether they hold on curves they were not found on."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array, Flags
from plategait.study.aims import (
    AT_REFERENCE,
    HAS_FIT,
    OF_CURVE,
    PUBLISHED_F0,
    PUBLISHED_RATIO,
    REFERENCE,
)
from plategait.study.search import Learnt, best
from plategait.study.unknowns import NAMES, Choice, choice_at

AS_GOOD = 6.0
"""Difference of the criterion up to which the evidence against the larger one is not strong (Kass and Raftery 1995)."""


@dataclass(frozen=True, eq=False)
class Step:
    """The best choice with some unknowns free.

    Attributes
    ----------
    free : tuple of str
        Unknowns that depart from the printed value.
    law : str
    deviations : (d,) array
        Of the priors.
    misfit : float
        Sum of squares over all aims, in units of what each may miss; of several starts their mean.
    error : float
        Standard error of that mean; 0 for what a surrogate tells.
    """

    free: tuple[str, ...]
    law: str
    deviations: Array
    misfit: float
    error: float = 0.0

    @property
    def criterion(self) -> float:
        """Misfit and k ln n for k departures and n aims (the Bayesian information criterion)."""
        return self.misfit + len(self.free) * math.log((~HAS_FIT).sum())

    @property
    def choice(self) -> Choice:
        """Values of the unknowns."""
        # Rounded, so that round-off of another processor is no other study.
        return choice_at(np.round(self.deviations, 3), self.law)


def step_with(
    found: Learnt, free: Sequence[str], law: str, used: Flags | None = None, guesses: Sequence[Array] = ()
) -> Step:
    """Best choice with these unknowns free, over the aims `used`, gone down to from the guesses too."""
    flags = np.array([name in free for name in NAMES])
    z, misfit = best(found, law, flags, used, guesses)
    return Step(tuple(free), law, z, misfit)


def backward(found: Learnt, law: str, among: Sequence[str] = NAMES) -> list[Step]:
    """Departures one by one, the most useful last to go: from none to all of those that may be taken."""
    steps = [step_with(found, among, law, guesses=[np.full(len(NAMES), 0.5)])]
    while steps[-1].free:
        free, guess = steps[-1].free, steps[-1].deviations
        tried = [step_with(found, tuple(name for name in free if name != left), law, guesses=[guess]) for left in free]
        steps.append(min(tried, key=lambda step: step.misfit))
    return steps[::-1]


def smallest(steps: Sequence[Step]) -> Step:
    """Smallest set of departures as good as the best: within `AS_GOOD`, or its error, of the least criterion."""
    least = min(steps, key=lambda step: step.criterion)
    limit = least.criterion + max(AS_GOOD, least.error)
    return min((step for step in steps if step.criterion <= limit), key=lambda step: (len(step.free), step.criterion))


@dataclass(frozen=True)
class OutOfSample:
    """How curves come out that a choice was not found on.

    Attributes
    ----------
    found_on : str
    median_f0, largest_f0, median_ratio : float
        |Δf0| and |Δ(b/f0)|, relative.
    missing : int
        Curves without a fit.
    """

    found_on: str
    median_f0: float
    largest_f0: float
    median_ratio: float
    missing: int


def deviations_of_curves(fits: Array, members: Flags | None = None) -> tuple[float, float, float, int]:
    """Median and largest |Δf0|, median |Δ(b/f0)| (relative) and curves without a fit, of fits (curves, outputs)."""
    members = np.ones(len(fits), dtype=bool) if members is None else members
    f0, ratio = fits[members, 0] / PUBLISHED_F0[members] - 1, fits[members, 1] / PUBLISHED_RATIO[members] - 1
    return (
        float(np.nanmedian(np.abs(f0))),
        float(np.nanmax(np.abs(f0))),
        float(np.nanmedian(np.abs(ratio))),
        int(np.isnan(f0).sum()),
    )


HALVES = {
    "α = 36.87 deg": (AT_REFERENCE | HAS_FIT, ~REFERENCE),
    "the other friction angles": ((OF_CURVE & ~AT_REFERENCE) | HAS_FIT, REFERENCE),
}
"""Aims that a choice is found on, and the curves that it then tells.

That a curve was published at all is no measurement left out: the object stayed on the plate.
"""
