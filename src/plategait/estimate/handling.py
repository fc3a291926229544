"""How a measurement is handled: what differs from point to point though the object is the same.

Run-offs are chaotic. Laid down half a millimetre beside, or with the plate started faster, the same object begins to
fail a quarter to more than a hertz elsewhere (`benchmarks/run_off_scatter.py`). Nobody knows these of a measurement, so
the runs that teach the emulators differ in them as measurements do, and the emulators learn how sharp a run-off is.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

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
    """

    offset: float = OFFSET
    turn: float = TURN
    ramp: float | None = None

    def drawn(self, sets: int, points: int, generator: np.random.Generator) -> list[dict[str, float]]:
        """Changes to the scenario of each point of each set, set by set: numbers by dotted name, SI."""
        ramps = generator.uniform(0.0, SLOWEST_RAMP, sets) if self.ramp is None else np.full(sets, self.ramp)
        starts = generator.normal(0.0, 1.0, (sets, points, 3)) * (self.offset, self.offset, self.turn)
        return [
            {"motion.ramp": ramp, "start.x": x, "start.y": y, "start.angle": turn}
            for ramp, of_set in zip(ramps.tolist(), starts.tolist(), strict=True)
            for x, y, turn in of_set
        ]
