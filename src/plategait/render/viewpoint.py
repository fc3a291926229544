"""Where pictures of a run are taken from."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from plategait.arrays import Array
from plategait.camera.camera import Camera

# The camera looks along the bar from its free end, a little from the side and from above; rad.
AZIMUTH, ELEVATION, FIELD_OF_VIEW = math.radians(-24), math.radians(27), math.radians(24)
# Share of the picture's width and height that the points may fill, and where their middle is put.
FILLED, MIDDLE = (0.86, 0.70), (0.5, 0.535)


def framing(points: Array, size: tuple[int, int]) -> Camera:
    """Camera from `AZIMUTH` and `ELEVATION` for which points (n, 3), m, fill a picture of a size, px."""
    ca, sa, ce, se = math.cos(AZIMUTH), math.sin(AZIMUTH), math.cos(ELEVATION), math.sin(ELEVATION)
    towards = np.array([ce * ca, ce * sa, se])
    target = (points.min(axis=0) + points.max(axis=0)) / 2
    distance = float(np.linalg.norm(np.ptp(points, axis=0)))
    while True:
        camera = Camera.looking_at(target + distance * towards, target, *size, FIELD_OF_VIEW)
        pixels, depth = camera.project_with_depth(points)
        if depth.min() > 0 and (np.ptp(pixels, axis=0) <= np.array(size) * FILLED).all():
            break
        distance *= 1.02
    matrix = camera.matrix.copy()
    matrix[:2, 2] += np.array(size) * MIDDLE - (pixels.min(axis=0) + pixels.max(axis=0)) / 2
    return replace(camera, matrix=matrix)
