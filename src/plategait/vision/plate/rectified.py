"""The plate as seen from straight above: pictures warped to plate coordinates."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array, Flags, Picture
from plategait.vision.frames import Frame
from plategait.vision.plate.view import project

# Longest side of a warped picture, px, and its size over the plate's, a little beyond which it reaches.
MOST_PIXELS, MARGIN = 440, 1.08


@dataclass(frozen=True, eq=False)
class Grid:
    """Pixels of warped pictures, and where on the plate they lie.

    Attributes
    ----------
    shape : (rows, columns)
    pitch : float
        Side of a pixel, m. Columns run along x, rows against y, so that it looks as from above.
    corner : (x, y)
        Middle of the first pixel, m.
    """

    shape: tuple[int, int]
    pitch: float
    corner: tuple[float, float]

    @classmethod
    def over(cls, size: tuple[float, float], H: Array) -> Grid:
        """Cover a plate (m) about as finely as pictures under this homography show it."""
        points = np.array([[0.0, 0.0], [1e-3, 0.0], [0.0, 1e-3]])
        p = project(H, points)
        scale = 1e3 * float(max(np.linalg.norm(p[1] - p[0]), np.linalg.norm(p[2] - p[0])))
        pitch = max(1 / scale, MARGIN * max(size) / MOST_PIXELS)
        rows, columns = (int(MARGIN * s / pitch) + 1 for s in (size[1], size[0]))
        return cls((rows, columns), pitch, (-pitch * (columns - 1) / 2, pitch * (rows - 1) / 2))

    @property
    def to_plate(self) -> Array:
        """(3, 3) from (column, row) to plate coordinates, m."""
        return np.array([[self.pitch, 0, self.corner[0]], [0, -self.pitch, self.corner[1]], [0, 0, 1.0]])

    def plate(self, pixels: Array) -> Array:
        """(…, 2) plate coordinates, m, of (column, row)."""
        return np.asarray(self.corner) + pixels * (self.pitch, -self.pitch)

    def pixels(self, plate: Array) -> Array:
        """(…, 2) (column, row) of plate coordinates, m."""
        return (plate - np.asarray(self.corner)) / (self.pitch, -self.pitch)

    def part(self, middle: Array, reach: float) -> tuple[Grid, tuple[slice, slice]]:
        """Part within `reach` of a point, m, along either axis, and where it lies in this one."""
        column, row = np.round(self.pixels(middle)).astype(int)
        half = int(reach / self.pitch) + 1
        top, left = (min(max(0, k - half), n - 1) for k, n in ((row, self.shape[0]), (column, self.shape[1])))
        bottom, right = (max(min(k + half + 1, n), 1) for k, n in ((row, self.shape[0]), (column, self.shape[1])))
        bottom, right = max(bottom, top + 1), max(right, left + 1)
        corner = (self.corner[0] + left * self.pitch, self.corner[1] - top * self.pitch)
        return Grid((bottom - top, right - left), self.pitch, corner), (slice(top, bottom), slice(left, right))

    @property
    def inner(self) -> Flags:
        """(rows, columns) whether a pixel is on the plate itself, in a picture of the whole plate."""
        rows, columns = self.shape
        inner = np.zeros(self.shape, bool)
        # The picture reaches a little beyond the plate.
        inner[rows // 25 : -(rows // 25), columns // 25 : -(columns // 25)] = True
        return inner

    def mask(self, polygons: list[Array]) -> Picture:
        """1 outside these polygons on the plate, m; 0 inside."""
        import cv2

        mask = np.ones(self.shape, np.uint8)
        for polygon in polygons:
            cv2.fillConvexPoly(mask, np.round(self.pixels(polygon)).astype(np.int32), (0,))
        return mask

    def warp(self, frame: Frame, H: Array) -> Picture:
        """(rows, columns, 3) picture, Y, U and V, of the plate from above."""
        import cv2

        M = H @ self.to_plate
        # The middle of a chroma pixel lies between those of four luma pixels.
        half = np.array([[0.5, 0, -0.25], [0, 0.5, -0.25], [0, 0, 1.0]]) @ M
        size = self.shape[::-1]
        flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
        planes = [cv2.warpPerspective(frame.luma, M, size, flags=flags)]
        planes += [cv2.warpPerspective(c, half, size, flags=flags, borderValue=(128,)) for c in frame.chroma]
        return cv2.merge(planes).astype(np.uint8, copy=False)
