"""How long a way still is: the least time in which short pulses, one after the other, add up to a displacement."""

from __future__ import annotations

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from plategait.arrays import Array
from plategait.errors import InputError

# Displacements that weigh the same, per second: so the hull is as round as can be.
SCALE = np.array([0.03, 0.03, 1.0])


class Reach:
    """Times that displacements take by short pulses from a place, in any mixture: the gauge of their convex hull.

    Parameters
    ----------
    moved : (n, 3) array
        Displacement by each pulse, m, m, rad.
    times : (n,) array
        What each takes, s.
    field : str
        What errors call the goal.

    Raises
    ------
    InputError
        Where no mixture goes some way.
    """

    def __init__(self, moved: Array, times: Array, field: str = "goal") -> None:
        velocities = moved / times[:, None] / SCALE
        refused = InputError(field, "a pose that this machine cannot carry the object to",
                             "reached by its motions: none was found that goes some way from there",
                             "a machine that also tilts the plate, or a place nearer to the middle")  # fmt: skip
        try:
            sides = ConvexHull(velocities).equations
        except QhullError:
            raise refused from None
        if (sides[:, 3] >= -1e-6).any():
            raise refused
        self._normals = sides[:, :3] / -sides[:, 3:] / SCALE

    def time(self, ways: Array) -> Array:
        """(…,) time that displacements (…, 3) take, s."""
        return (ways @ self._normals.T).max(axis=-1)
