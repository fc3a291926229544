"""Spinning: sheets under one plate motion after the other, and how fast each is seen to spin, and where."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array, Flags
from plategait.control.menu import RAMP
from plategait.control.plant import Plant
from plategait.estimate.observations import Condition
from plategait.model.motion import PlateMotion
from plategait.model.scenario import Scenario

SPUN, SKIPPED = 0.9, 0.3
"""How long a sheet is spun under each motion, and what of that is not read, s."""
MOTIONS: tuple[Condition, ...] = tuple(
    Condition(math.radians(angle), stroke, frequency)
    for angle, stroke, frequency in ((4, 1e-3, 28.0), (4, 1e-3, 26.0), (7, 1e-3, 22.0), (7, 1e-3, 18.0),
                                     (4, 1.5e-3, 18.0), (7, 1.5e-3, 16.0), (4, 1.5e-3, 22.0), (4, 1e-3, 14.0))
)  # fmt: skip
"""What sheets like the preset `cheese` are spun under: of 38 motions the one that leaves least of the stiffness unsure,
where friction, mass and damping are unsure too, and each after it that leaves least beside those before."""
PAUSE = 12
"""Ticks for which a plate stands until a sheet has come to rest and is seen."""
# What an angle is read with beside the camera's noise, rad: a sheet trembles with its plate.
_TREMBLE = math.radians(1.0)
# Fewest frames that tell a rate.
_FEWEST = 8


@dataclass(frozen=True, eq=False)
class Spins:
    """How n sheets spun under c motions.

    Attributes
    ----------
    rates, sd : (n, c) arrays
        deg/s; NaN where a sheet was not spun, was lost, or was not seen.
    places : (n, c) array
        Where it lay meanwhile, across the bar, m: what the plate does to a sheet goes with that.
    """

    rates: Array
    sd: Array
    places: Array

    @classmethod
    def none(cls, n: int, c: int) -> Spins:
        """Of nothing yet."""
        return cls(*np.full((3, n, c), math.nan))

    def read(self, c: int, plant: Plant, motion: PlateMotion, spun: Flags) -> None:
        """Spin some sheets of a plant under the c-th motion, the others resting, and take in what was seen."""
        still = motion.replace(angle=0.0, stroke=0.0)
        seen: list[list[tuple[float, float, float]]] = [[] for _ in range(len(plant))]
        skipped = SKIPPED + plant.camera.delay
        for tick in range(round(SPUN / plant.tick)):
            told = plant.step([motion if on else still for on in spun])
            if tick * plant.tick >= skipped:
                for i in np.flatnonzero(spun & told.new):
                    seen[i].append((float(told.taken[i]), float(told.poses[i, 2]), float(told.poses[i, 1])))
        for i in np.flatnonzero(spun & ~plant.failed):
            of_sheet = np.array(seen[i]).reshape(-1, 3)
            self.rates[i, c], self.sd[i, c] = rate_of(of_sheet[:, :2], plant.camera.angle_noise)
            self.places[i, c] = of_sheet[:, 2].mean() if len(of_sheet) else math.nan


def plate_motion(condition: Condition, scenario: Scenario) -> PlateMotion:
    """Motion that a plate is told."""
    return condition.motion(scenario.motion.replace(ramp=RAMP, waves=(), samples=None))


def rate_of(seen: Array, noise: float) -> tuple[float, float]:
    """Slope of the line through angles (n, 2) seen over time, s and rad, and its standard deviation, deg/s."""
    if len(seen) < _FEWEST:
        return math.nan, math.nan
    time, angle = seen[:, 0] - seen[:, 0].mean(), np.unwrap(seen[:, 1])
    squares = float(time @ time)
    rate = float(time @ (angle - angle.mean())) / squares
    return math.degrees(rate), math.degrees(math.hypot(noise, _TREMBLE) / math.sqrt(squares))
