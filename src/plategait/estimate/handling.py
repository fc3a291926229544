"""How a measurement is handled: what differs from point to point though the object is the same.

Run-offs are chaotic. Laid down half a millimetre beside, or with the plate started faster, the same object begins to
fail a quarter to more than a hertz elsewhere (`benchmarks/run_off_scatter.py`). Nobody knows these of a measurement, so
the runs that teach the emulators differ in them as measurements do, and the emulators learn how sharp a run-off is.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from plategait.errors import InputError
from plategait.units import Quantity

_RAMP = Quantity("s", "s", "0.1 s", at_least=0, at_most=1e3)
_SCATTER = Quantity("rad", "deg", "3 deg", at_least=0, at_most=0.5)

# As a hand lays an object down.
OFFSET, TURN = 5e-4, math.radians(5)
# Of plates whose start nobody told, s.
SLOWEST_RAMP = 0.3


@dataclass(frozen=True)
class Handling:
    """What differs from point to point.

    Parameters
    ----------
    offset : float
        Standard deviation of where the object is laid down, on each axis, m.
    turn : float
        Of the angle at which it is, rad.
    ramp : float or None
        Time in which the plate comes to its full swing, s. None where it is not known: anything up to `SLOWEST_RAMP`,
        the same for all points of one object.
    friction_scatter : float
        Standard deviation of the friction angle from point to point about that of the object, rad: food's wanders. It
        is no part of `drawn`: how the rates follow it is learnt (`plategait.estimate.likelihood`), not drawn.
    """

    offset: float = OFFSET
    turn: float = TURN
    ramp: float | None = None
    friction_scatter: float = 0.0

    def drawn(self, sets: int, points: int, generator: np.random.Generator) -> list[dict[str, float]]:
        """Changes to the scenario of each point of each set, set by set: numbers by dotted name, SI."""
        ramps = generator.uniform(0.0, SLOWEST_RAMP, sets) if self.ramp is None else np.full(sets, self.ramp)
        starts = generator.normal(0.0, 1.0, (sets, points, 3)) * (self.offset, self.offset, self.turn)
        return [
            {"motion.ramp": ramp, "start.x": x, "start.y": y, "start.angle": turn}
            for ramp, of_set in zip(ramps.tolist(), starts.tolist(), strict=True)
            for x, y, turn in of_set
        ]


def handling_of(ramp: float | str | None, friction_scatter: float | str, fixed: Collection[str]) -> Handling:
    """Handling as it was told; `fixed` are the parameters that are not sought.

    Raises
    ------
    InputError
        For a number that cannot be, or friction that scatters about an angle that is not sought.
    """
    told = None if ramp is None else _RAMP.read(ramp, "ramp")
    scatter = _SCATTER.read(friction_scatter, "friction_scatter")
    if scatter and "friction_angle" in fixed:
        raise InputError("friction_scatter", friction_scatter, "left out where the friction angle is fixed",
                         "leaving one of both out")  # fmt: skip
    return Handling(ramp=told, friction_scatter=scatter)
