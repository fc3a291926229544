"""What is sought of a motion: the fastest spin, or a given velocity at the least cost."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.units import Quantity

Cost = Literal["acceleration", "torque", "power", "bending"]

COSTS: Mapping[Cost, Quantity] = {
    "acceleration": Quantity("m/s^2", "m/s^2", "50 m/s^2"),
    "torque": Quantity("N*m", "N*m", "0.1 N*m"),
    "power": Quantity("W", "W", "5 W"),
    "bending": Quantity("rad", "deg", "2 deg"),
}
"""What a motion can cost, and what each is measured in.

acceleration
    Largest of the plate under the rim of the object: of the translations, and of the rotations at half the object's
    size, together.
torque
    Largest inertial torque of any rotation.
power
    Largest that the drives give together.
bending
    Largest bending amplitude of the object, the mean over the runs.
"""

SHARE, LEAST_VELOCITY, LEAST_RATE = 0.03, 5e-3, math.radians(5)
"""A velocity is reached within this share of it, and within as much in any case: m/s and rad/s."""
AIMED = 0.5
"""Share of that within which a search keeps, so that runs from other starts reach it too."""
VELOCITY = Quantity("m/s", "mm/s", "100 mm/s", at_least=-10, at_most=10)
RATE = Quantity("rad/s", "deg/s", "300 deg/s", at_least=-math.radians(36e3), at_most=math.radians(36e3))
"""What may be sought: nothing slides at 10 m/s, or turns a hundred times a second."""
_COMPONENTS = {"along": VELOCITY, "across": VELOCITY, "spin": RATE}


@dataclass(frozen=True)
class Goal:
    """What is sought.

    Attributes
    ----------
    along, across, spin : float, optional
        Mean velocity to reach along the bar and across it, m/s, and turning, rad/s, counter-clockwise positive; what is
        left out may be anything. Text may carry a unit. With all left out the fastest spin either way is sought.
    least : {"acceleration", "torque", "power", "bending"}, optional
        What is to be least while that is reached (`COSTS`); the acceleration if left out.
    """

    along: float | None = None
    across: float | None = None
    spin: float | None = None
    least: Cost | None = None

    def __post_init__(self) -> None:
        """Refuse a cost where nothing is to be reached, and what is no number or no cost."""
        for name, quantity in _COMPONENTS.items():
            if (value := getattr(self, name)) is not None:
                object.__setattr__(self, name, quantity.read(value, name))
        if self.least is not None and self.least not in COSTS:
            raise InputError("least", self.least, f"one of {', '.join(COSTS)}", "power")
        if self.least is not None and self.fastest:
            raise InputError("least", self.least, "left out where the fastest spin is sought", '--spin "300 deg/s"')

    @property
    def fastest(self) -> bool:
        """Whether the fastest spin is sought."""
        return self.along is None and self.across is None and self.spin is None

    @property
    def sought(self) -> tuple[int, ...]:
        """Which of along, across and turning are sought."""
        if self.fastest:
            return (2,)
        return tuple(i for i, name in enumerate(_COMPONENTS) if getattr(self, name) is not None)

    @property
    def cost(self) -> Cost:
        """What is to be least."""
        return self.least or "acceleration"

    @property
    def way(self) -> float:
        """Speed at which the object is to travel, m/s."""
        return math.hypot(self.along or 0.0, self.across or 0.0)

    def deviation(self, twist: Array) -> float:
        """How far a velocity (along, across, turning) is off, as a share of what counts as reached: 1 at the most."""
        off = 0.0
        for value, name, least in zip(twist, _COMPONENTS, (LEAST_VELOCITY, LEAST_VELOCITY, LEAST_RATE), strict=True):
            wanted = getattr(self, name)
            if wanted is not None:
                off = max(off, abs(value - wanted) / max(SHARE * abs(wanted), least)) if np.isfinite(value) else np.inf
        return float(off)

    @property
    def words(self) -> str:
        """What is sought, in words."""
        if self.fastest:
            return "the fastest spin"
        parts = []
        for name, said in (("along", "along the bar"), ("across", "across it")):
            if (value := getattr(self, name)) is not None:
                parts.append(f"{1e3 * value:.4g} mm/s {said}")
        if self.spin is not None:
            parts.append(f"{math.degrees(self.spin):.4g} deg/s")
        return f"{', '.join(parts)} with the least {self.cost}"
