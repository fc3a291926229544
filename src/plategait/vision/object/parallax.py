"""What bending does to the angle seen by a camera that looks at a slant, and the angle without it.

A rim marker that the bent object lifts by h is seen on the plate's plane away from where it is, by h times the slope of
the line of sight: sideways, which turns the angle, or outwards, which changes its distance from the centre marker. The
lift repeats with the plate's swing and depends on where on the plate the marker is; both its effects, over all frames,
tell it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array

# Fewest frames and turns that tell the lift, and pieces of the line that the angle is measured against, per turn.
FEWEST, LEAST_TURNS, MOST_PIECES = 20, 0.3, 6
# The lift is small beside the markers' spacing: this share of it, where nothing else is known.
USUAL_LIFT = 0.15
# The correction must take out this share of the squared scatter, or it is not applied; and as so many unknowns would of
# mere noise.
LEAST_GAIN, UNKNOWNS = 0.1, 16
ROUNDS, HUBER = 6, 1.5
# Harmonics of the plate's swing, and of the place around the object, that the lift is made of.
SWINGS, SHAPES = 3, 3
# What a single frame's angle is known to, rad, and most lift as a share of the markers' spacing.
NOISE, MOST_LIFT = math.radians(0.7), 0.8


@dataclass(frozen=True, eq=False)
class Parallax:
    """What the lift of the rim marker does in a clip.

    Attributes
    ----------
    turn : (n,) array
        By how much the angle appears turned, rad.
    lift : (n,) array
        Of the rim marker over the centre marker, m.
    """

    turn: Array
    lift: Array


def rim_parallax(
    time: Array, angle: Array, spacing: Array, place: Array, eye: Array, frequency: float
) -> Parallax | None:
    """Lift of the rim marker in each sure frame; None where the frames do not tell it.

    A robust fit, linear about the lift so far in each of its rounds (Gauss-Newton).

    Parameters
    ----------
    time, angle, spacing : (n,) arrays
        s, rad (joined over whole turns), m, as seen on the plate's plane.
    place : (n, 2) array
        Of the centre marker, m.
    eye : (n, 3) array
        Of the camera, in the plate's frame, m.
    frequency : float
        Of the plate, Hz, true or as the camera sees it.
    """
    turns = abs(float(angle[-1] - angle[0])) / (2 * math.pi) if len(angle) else 0.0
    if len(time) < FEWEST or turns < LEAST_TURNS or not np.isfinite(eye).all():
        return None
    length, phase = float(np.median(spacing)), 2 * math.pi * frequency * time
    plain = np.concatenate([_line(time, angle, turns), _waves(phase, SWINGS)[0][:, 1:]], axis=1)
    lift, turn, weight = np.zeros(len(time)), np.zeros(len(time)), np.ones(2 * len(time))
    for _ in range(ROUNDS):
        # Where the marker is, not where it is seen, is what its lift depends on.
        true = angle - turn
        basis, order = _lift_basis(phase, true)
        sight = (place + length * np.stack([np.cos(true), np.sin(true)], axis=1) - eye[:, :2]) / eye[:, 2:]
        apparent, slopes = _apparent(lift, true, sight)
        rows = _design(basis, plain, slopes)
        data = np.concatenate(
            [angle - apparent[0] + slopes[0] * lift, spacing / length - apparent[1] + 1 + slopes[1] * lift]
        )
        solution = _ridge(rows * weight[:, None], data * weight, (1.0 + order) * NOISE / USUAL_LIFT)
        residual = np.abs(data - rows @ solution)
        scale = max(1.48 * float(np.median(residual)), 1e-6)
        weight = np.sqrt(np.minimum(1.0, HUBER * scale / np.maximum(residual, 1e-12)))
        lift = np.clip(basis @ solution[: basis.shape[1]], -MOST_LIFT, MOST_LIFT)
        turn = _apparent(lift, true, sight)[0][0]
    before, after = (_scatter(plain, v, weight[: len(time)]) for v in (angle, angle - turn))
    return Parallax(turn, lift * length) if after < (1 - LEAST_GAIN - UNKNOWNS / len(time)) * before else None


def _lift_basis(phase: Array, angle: Array) -> tuple[Array, Array]:
    """(n, k) harmonics of the plate's swing times those of the place around the object, and the order of each."""
    swings, shapes = _waves(phase, SWINGS), _waves(angle, SHAPES)
    basis = (swings[0][:, :, None] * shapes[0][:, None, :]).reshape(len(phase), -1)
    return basis, (swings[1][:, None] + shapes[1][None, :]).ravel()


def _design(basis: Array, plain: Array, slopes: tuple[Array, Array]) -> Array:
    """(2 n, k) what lift, plain motion and a longer spacing do to the angles, and to the spacings."""
    one = np.ones((len(basis), 1))
    angles = np.concatenate([slopes[0][:, None] * basis, plain, np.zeros_like(one)], axis=1)
    return np.concatenate([angles, np.concatenate([slopes[1][:, None] * basis, np.zeros_like(plain), one], axis=1)])


def _ridge(rows: Array, data: Array, penalty: Array) -> Array:
    """Least squares with a penalty on the first unknowns."""
    n = len(penalty)
    ridge = np.zeros((n, rows.shape[1]))
    ridge[:, :n] = np.diag(penalty)
    rows, data = np.concatenate([rows, ridge]), np.concatenate([data, np.zeros(n)])
    return np.asarray(np.linalg.lstsq(rows, data, rcond=None)[0], dtype=float)


def _apparent(lift: Array, true: Array, sight: Array) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """Apparent turn, rad, and spacing of a marker lifted by a share of its distance; and their slopes over the lift."""
    along = np.cos(true) * sight[:, 0] + np.sin(true) * sight[:, 1]
    aside = np.cos(true) * sight[:, 1] - np.sin(true) * sight[:, 0]

    def at(h: Array) -> tuple[Array, Array]:
        forward, sideways = np.sqrt(1 - h**2) + h * along, h * aside
        return np.arctan2(sideways, forward), np.hypot(sideways, forward)

    step = 1e-4
    high, low = at(lift + step), at(lift - step)
    return at(lift), ((high[0] - low[0]) / (2 * step), (high[1] - low[1]) / (2 * step))


def _waves(phase: Array, orders: int) -> tuple[Array, Array]:
    """(n, 2 orders + 1) constant, cosines and sines; and the order of each."""
    columns = [np.ones_like(phase), *(f(k * phase) for k in range(1, orders + 1) for f in (np.cos, np.sin))]
    return np.stack(columns, axis=1), np.array([0.0, *(k for k in range(1, orders + 1) for _ in range(2))])


def _scatter(plain: Array, angle: Array, weight: Array) -> float:
    """Mean square, rad², of what a plain motion leaves of the angles, with the weights that strays have lost."""
    solution = np.linalg.lstsq(plain * weight[:, None], angle * weight, rcond=None)[0]
    return float(np.average((angle - plain @ solution) ** 2, weights=weight**4))


def _line(time: Array, angle: Array, turns: float) -> Array:
    """(n, k) straight pieces that the smooth turning is made of: one a turn at most, or they would take up the lift."""
    knots = np.linspace(time[0], time[-1], 1 + int(np.clip(turns / 1.5, 1, MOST_PIECES)))
    hats = [np.interp(time, knots, np.eye(len(knots))[k]) for k in range(len(knots))]
    return np.stack(hats, axis=1)
