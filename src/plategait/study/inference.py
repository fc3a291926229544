"""What the search may claim: which departures are paid for, whether they hold on curves they were not found on."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array, Flags
from plategait.study.aims import AT_REFERENCE, KIND, OF_CURVE, PUBLISHED_F0, PUBLISHED_RATIO, REFERENCE
from plategait.study.search import Learnt, best
from plategait.study.unknowns import NAMES, Choice, choice_at


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
        Sum of squares over all aims, in units of what each may miss.
    criterion : float
        Misfit and k ln n for k departures (the Bayesian information criterion).
    """

    free: tuple[str, ...]
    law: str
    deviations: Array
    misfit: float
    criterion: float

    @property
    def choice(self) -> Choice:
        """Values of the unknowns."""
        return choice_at(self.deviations, self.law)


def step_with(found: Learnt, free: Sequence[str], law: str, used: Flags | None = None) -> Step:
    """Best choice with these unknowns free, over the aims `used`."""
    flags = np.array([name in free for name in NAMES])
    z, misfit = best(found, law, flags, used)
    n = len(KIND) if used is None else int(used.sum())
    return Step(tuple(free), law, z, misfit, misfit + len(free) * math.log(n))


def backward(found: Learnt, law: str) -> list[Step]:
    """Departures one by one, the most useful last to go: from none to all."""
    steps = [step_with(found, NAMES, law)]
    while steps[-1].free:
        free = steps[-1].free
        tried = [step_with(found, tuple(name for name in free if name != left), law) for left in free]
        steps.append(min(tried, key=lambda step: step.misfit))
    return steps[::-1]


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


def found_on(found: Learnt, free: Sequence[str], law: str) -> dict[str, tuple[Step, Flags]]:
    """Choices found on part of the curves, and the curves left to be told by each."""
    halves = {
        "α = 36.87 deg": (AT_REFERENCE, ~REFERENCE),
        "the other friction angles": (OF_CURVE & ~AT_REFERENCE, REFERENCE),
    }
    return {name: (step_with(found, free, law, used), told) for name, (used, told) in halves.items()}
