"""Cells of the velocities that an object may have, and the best motions known of each."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.optimize.trials import Trial

Cell = tuple[int, int, int]
SIZES = (50e-3, 20e-3, math.radians(100))
"""Size of a cell along the bar and across it, m/s, and turning, rad/s: 0 is in the middle of one."""
EFFORT = 50.0
"""Acceleration (m/s²) that weighs as much as a spread over starts of one cell."""
_KEPT = 3


def cell_of(twist: Array, sizes: Array) -> Cell:
    """Cell in which a velocity (along, across, turning) lies, SI."""
    along, across, turn = (round(float(share)) for share in twist / sizes)
    return along, across, turn


def quality(trial: Trial, sizes: Array) -> float:
    """Effort and uncertainty of a motion together, the less the better; infinite where a run failed."""
    if trial.failed or not trial.counted:
        return math.inf
    spread = float(np.sqrt(np.mean((trial.spread / sizes) ** 2))) if trial.counted > 1 else 1.0
    return trial.cost("acceleration") / EFFORT + spread


@dataclass(eq=False)
class Archive:
    """The best motions known of each cell (the map of MAP-Elites).

    Attributes
    ----------
    sizes : (3,) array
        Of a cell, SI.
    best : dict of Cell to list of Trial
        The best few, best first.
    """

    sizes: Array
    best: dict[Cell, list[Trial]] = field(default_factory=dict)

    def add(self, trials: Iterable[Trial]) -> int:
        """Take in motions of which no run failed; how many found a cell that was empty."""
        new = 0
        for trial in trials:
            if not math.isfinite(quality(trial, self.sizes)):
                continue
            cell = cell_of(trial.twist, self.sizes)
            own = self.best.setdefault(cell, [])
            new += not own
            own.append(trial)
            own.sort(key=lambda each: quality(each, self.sizes))
            del own[_KEPT:]
        return new

    @property
    def elites(self) -> list[Trial]:
        """Best motion of each cell, in the order of the cells."""
        return [self.best[cell][0] for cell in sorted(self.best)]


def check_sizes(sizes: tuple[float, float, float]) -> Array:
    """Sizes as an array.

    Raises
    ------
    InputError
        For one that is not above 0.
    """
    for name, size, example in zip(("along", "across", "turn"), sizes, ("50 mm/s", "20 mm/s", "100 deg/s"),
                                   strict=True):  # fmt: skip
        if not (math.isfinite(size) and size > 0):
            raise InputError(f"cell_{name}", size, "a size above 0", example)
    return np.array(sizes)
