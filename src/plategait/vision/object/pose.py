"""Where an object lies in a frame."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from plategait.arrays import Array


class Pose(NamedTuple):
    """The object in one picture.

    Middle (x, y), m; angle, rad; why it is uncertain; spacing of the markers, m; distances of the edge from the middle
    in the directions of `plategait.vision.object.rim`, m.
    """

    x: float
    y: float
    angle: float
    reason: str = ""
    spacing: float = math.nan
    rim: Array | None = None


NO_POSE = Pose(math.nan, math.nan, math.nan, "markers not seen")


def middle_of(pose: Pose) -> Array | None:
    """(2,) where the object's middle is, m; None where it is not seen."""
    return np.array([pose.x, pose.y]) if math.isfinite(pose.x) else None
