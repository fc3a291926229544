"""How well a picture's points tell where the rest of the plate is: extrapolation from few of them, in figures."""

from __future__ import annotations

import math

import numpy as np

from plategait.arrays import Array
from plategait.vision.plate.view import project

# What a corner's place is known to at best, px.
LEAST_NOISE = 0.25
# The object lies within this share of the plate's half sides.
WITHIN = 0.7


def doubt(H: Array, plate: Array, pixels: Array, size: tuple[float, float], lens: Array | None) -> float:
    """Standard deviation, m, of the worst known place about the plate's middle under a homography fitted to points.

    That of linear least squares about the fit, with the noise that the residuals show.

    Parameters
    ----------
    H : (3, 3) array
        Fitted, from plate coordinates, m, to pixels.
    plate, pixels : (n, 2) arrays
        The points that it was fitted to, m and px.
    size : (length, width)
        Of the plate, m.
    lens : (3, 3) array, optional
        Where the fit was that of a rigid plate before it: six numbers instead of eight.
    """
    ways = _ways(H, lens)
    J = _slopes(H, ways, plate)
    free = 2 * len(plate) - len(ways)
    if free <= 0:
        return math.inf
    residual = np.linalg.norm(project(H, plate) - pixels, axis=1)
    noise = max(LEAST_NOISE, math.sqrt(float(np.sum(residual**2)) / free))
    inverse = np.linalg.pinv(J)
    x, y = WITHIN * size[0] / 2, WITHIN * size[1] / 2
    places = np.array([[-x, -y], [x, -y], [x, y], [-x, y]])
    spread = (_slopes(H, ways, places) @ inverse).reshape(len(places), 2, -1)
    worst = 0.0
    for place, shift in zip(places, spread, strict=True):
        near = place + np.array([[0.0, 0.0], [1e-4, 0.0], [0.0, 1e-4]])
        p = project(H, near)
        to_plate = np.linalg.pinv(np.stack([p[1] - p[0], p[2] - p[0]], axis=1) / 1e-4)
        worst = max(worst, float(np.linalg.norm(to_plate @ shift, 2)))
    return noise * worst


def _ways(H: Array, lens: Array | None) -> Array:
    """(k, 3, 3) ways in which a homography may be otherwise: any, or as a rigid plate moves."""
    if lens is None:
        scale = np.abs(H).max(axis=0)  # numbers alike in size keep the inverse well
        ways = np.zeros((8, 3, 3))
        for k in range(8):
            ways[k, k // 3, k % 3] = scale[k % 3]
        return ways
    M = np.linalg.inv(lens) @ H
    M = M / float(np.linalg.norm(M[:, 0]))
    ways = []
    for axis in np.eye(3):
        turned = np.column_stack([np.cross(axis, M[:, 0]), np.cross(axis, M[:, 1]), np.zeros(3)])
        moved = np.column_stack([np.zeros(3), np.zeros(3), axis])
        ways += [lens @ turned, lens @ moved]
    return np.array(ways) * float(np.linalg.norm(H[:, 0]) / np.linalg.norm((lens @ M)[:, 0]))


def _slopes(H: Array, ways: Array, points: Array) -> Array:
    """(2 n, k) how pixels of points move in each way."""
    v = np.column_stack([points, np.ones(len(points))])
    p = v @ H.T
    u = p[:, :2] / p[:, 2:]
    change = np.einsum("kij,nj->nik", ways, v)
    return ((change[:, :2] - u[:, :, None] * change[:, 2:]) / p[:, 2:, None]).reshape(2 * len(points), len(ways))
