"""Patches of one colour in a warped picture, measured finer than a pixel."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from plategait.arrays import Array, Picture
from plategait.vision.plate.rectified import Grid

# What a byte of likeness is for the markers' own colour, and the least, as a share of it, that counts.
FULL_LIKENESS, FAINT = 128, 0.15
# Areas of markers that are looked for, m².
LEAST_AREA, MOST_AREA = 8e-6, 250e-6


class Blob(NamedTuple):
    """A patch of one colour: middle (x, y), m; area, m²; long side over short; direction of the long side, rad."""

    middle: Array
    area: float
    aspect: float
    axis: float
    fill: float


def blobs_in(binary: Picture, grid: Grid, likeness: Picture | None = None) -> list[Blob]:
    """Connected patches with an area that a marker may have, the largest first.

    With a likeness, middles and areas are weighted by it, which makes them finer than a pixel.
    """
    import cv2

    contours, nesting = cv2.findContours(binary, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    rows, columns = binary.shape
    least, most = 0.4 * LEAST_AREA / grid.pitch**2, MOST_AREA / grid.pitch**2
    blobs = []
    for contour, nest in zip(contours, [] if nesting is None else nesting[0], strict=True):
        if nest[3] >= 0:  # a hole
            continue
        # The contour runs through the middles of the outermost pixels.
        if len(contour) < 4 or not least < cv2.contourArea(contour) + len(contour) / 2 + 1 < most:
            continue
        left, top, width, height = cv2.boundingRect(contour)
        # Room for the soft edge.
        x0, y0, x1, y1 = max(0, left - 2), max(0, top - 2), min(columns, left + width + 2), min(rows, top + height + 2)
        inside = np.zeros((y1 - y0, x1 - x0), np.uint8)
        cv2.drawContours(inside, [contour], -1, (1,), cv2.FILLED, offset=(-x0, -y0))
        if likeness is None:
            weight = inside.astype(np.float32)
        else:
            near = cv2.dilate(inside, np.ones((5, 5), np.uint8))
            foreign = (binary[y0:y1, x0:x1] > 0) & (inside == 0)
            weight = np.minimum(likeness[y0:y1, x0:x1] / FULL_LIKENESS, 1.0) * near * ~foreign
            weight[weight < FAINT] = 0
        m = cv2.moments(weight.astype(np.float32))
        if m["m00"] <= 0:
            continue
        middle = grid.plate(np.array([m["m10"] / m["m00"] + x0, m["m01"] / m["m00"] + y0]))
        a, b, c = m["mu20"] / m["m00"], m["mu11"] / m["m00"], m["mu02"] / m["m00"]
        root = math.hypot((a - c) / 2, b)
        large, small = (a + c) / 2 + root, max((a + c) / 2 - root, 1e-3)
        # Rows run against y.
        axis = -0.5 * math.atan2(2 * b, a - c)
        fill = min(1.0, m["m00"] / (12 * math.sqrt(large * small)))
        blobs.append(Blob(middle, m["m00"] * grid.pitch**2, math.sqrt(large / small), axis, fill))
    return sorted(blobs, key=lambda blob: -blob.area)
