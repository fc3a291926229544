"""Where pictures are taken from."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# The camera looks along the bar from its free end, a little from the side and from above; rad.
AZIMUTH, ELEVATION, FIELD_OF_VIEW = math.radians(-24), math.radians(27), math.radians(24)


@dataclass(frozen=True, eq=False)
class Camera:
    """A pinhole: where it is, its axes (rows: right, up, forward), focal length and middle in pixels."""

    eye: Array
    axes: Array
    focal: float
    middle: Array

    @classmethod
    def framing(cls, points: Array, size: tuple[int, int]) -> Camera:
        """Look at points from the direction of `AZIMUTH` and `ELEVATION` so that they fill the frame."""
        ca, sa, ce, se = math.cos(AZIMUTH), math.sin(AZIMUTH), math.cos(ELEVATION), math.sin(ELEVATION)
        forward = -np.array([ce * ca, ce * sa, se])
        right = np.array([-sa, ca, 0.0])
        axes = np.stack([right, np.cross(right, forward), forward])
        target = (points.min(axis=0) + points.max(axis=0)) / 2
        focal = size[1] / 2 / math.tan(FIELD_OF_VIEW / 2)
        distance = float(np.linalg.norm(np.ptp(points, axis=0)))
        while True:
            camera = cls(target - distance * forward, axes, focal, np.zeros(2))
            seen, depth = camera.project(points)
            if depth.min() > 0 and (np.ptp(seen, axis=0) <= np.array(size) * (0.86, 0.70)).all():
                break
            distance *= 1.02
        middle = np.array(size) * (0.5, 0.535) - (seen.min(axis=0) + seen.max(axis=0)) / 2
        return cls(camera.eye, axes, focal, middle)

    def project(self, points: Array) -> tuple[Array, Array]:
        """(…, 2) pixels and (…) distance along the view."""
        x, y, depth = np.moveaxis((points - self.eye) @ self.axes.T, -1, 0)
        scale = self.focal / np.maximum(depth, 1e-6)
        return np.stack([x * scale, -y * scale], axis=-1) + self.middle, depth

    def plane(self, origin: Array, u: Array, v: Array) -> Array:
        """(3, 3) homography from coordinates on a plane to pixels."""
        lens = np.array([[self.focal, 0, self.middle[0]], [0, -self.focal, self.middle[1]], [0, 0, 1]])
        return lens @ self.axes @ np.stack([u, v, origin - self.eye], axis=1)
