"""How sharp the edges in a picture are, in the direction in which they are least: what motion blurs one way."""

from __future__ import annotations

import math

import numpy as np

from plategait.arrays import Flags, Picture

# Directions looked at, about the circle's half.
DIRECTIONS = 4
# An edge's levels are looked for within so many pixels of it, and are at least this share of the picture's.
REACH, LEAST_EDGE = 6, 0.4
# Levels between the dark and the light of a picture below which it shows nothing, and fewest pixels near edges.
LEAST_LEVELS, FEWEST = 20.0, 40
# Of the pixels near edges, the share that counts as on edges across a direction.
ON_EDGES = 0.03


def sharpness(part: Picture, chosen: Flags | None = None) -> float:
    """Steepest change from pixel to pixel at edges, over their height, in the direction in which it is least.

    About a half for a sharp edge, 1/n for one that is blurred over n pixels; NaN where there is no edge.

    Parameters
    ----------
    part : (rows, columns) array
        Brightness.
    chosen : (rows, columns) array, optional
        Where to look.
    """
    import cv2

    if min(part.shape) < 2 * REACH:
        return math.nan
    levels = cv2.GaussianBlur(part, (3, 3), 0).astype(np.float32)  # or noise would be steep
    low, high = np.percentile(levels if chosen is None else levels[chosen], [2, 98])
    if high - low < LEAST_LEVELS:
        return math.nan
    window = np.ones((2 * REACH + 1, 2 * REACH + 1), np.uint8)
    height = cv2.dilate(levels, window) - cv2.erode(levels, window)
    at_edges = height > LEAST_EDGE * float(high - low)
    if chosen is not None:
        at_edges &= chosen
    if at_edges.sum() < FEWEST:
        return math.nan
    right, down = (cv2.Sobel(levels, cv2.CV_32F, *order, ksize=1, scale=0.5) for order in ((1, 0), (0, 1)))
    steepest = []
    for k in range(DIRECTIONS):
        turn = math.pi * k / DIRECTIONS
        steep = np.abs(math.cos(turn) * right + math.sin(turn) * down)
        steepest.append(float(np.percentile(steep[at_edges] / height[at_edges], 100 * (1 - ON_EDGES))))
    return min(steepest)
