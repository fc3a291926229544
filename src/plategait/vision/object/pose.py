"""Where an object lies in a frame."""

from __future__ import annotations

import math
from typing import NamedTuple


class Pose(NamedTuple):
    """The object in one picture: middle (x, y), m; angle, rad; why it is uncertain; spacing of the markers, m."""

    x: float
    y: float
    angle: float
    reason: str = ""
    spacing: float = math.nan


NO_POSE = Pose(math.nan, math.nan, math.nan, "markers not seen")
