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
# The lift is small beside the markers' distance: this share of it, where nothing else is known.
USUAL_LIFT = 0.15
# The correction must take out this share of the squared scatter, or it is not applied.
LEAST_GAIN = 0.1
ROUNDS, HUBER = 6, 1.5
# Harmonics of the plate's swing, and of the place around the object, that the lift is made of.
SWINGS, SHAPES = 3, 3
# What a single frame's angle is known to, rad, and most lift as a share of the markers' distance.
NOISE, MOST_LIFT = math.radians(0.7), 0.8


@dataclass(frozen=True, eq=False)
class Bending:
    """What was found of the lift of the rim marker.

    Attributes
    ----------
    turn : (n,) array
        By how much the angle is seen turned, rad.
    lift : (n,) array
        Of the rim marker over the centre marker, m.
    """

    turn: Array
    lift: Array


def bending(time: Array, angle: Array, apart: Array, place: Array, eye: Array, frequency: float) -> Bending | None:
    """Lift of the rim marker in each sure frame; None where the frames do not tell it.

    Parameters
    ----------
    time, angle, apart : (n,) arrays
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
    length, phase = float(np.median(apart)), 2 * math.pi * frequency * time
    own, wobble = _line(time, angle, turns), _waves(phase, SWINGS)[0][:, 1:]
    n, m, w = (2 * SWINGS + 1) * (2 * SHAPES + 1), own.shape[1], wobble.shape[1]
    nothing = np.zeros((len(time), m + w))
    lift, turn, weight = np.zeros(len(time)), np.zeros(len(time)), np.ones(2 * len(time))
    for _ in range(ROUNDS):
        # Where the marker is, not where it is seen, is what its lift depends on.
        true = angle - turn
        swings, shapes = _waves(phase, SWINGS), _waves(true, SHAPES)
        basis = (swings[0][:, :, None] * shapes[0][:, None, :]).reshape(len(time), -1)
        order = (swings[1][:, None] + shapes[1][None, :]).ravel()
        sight = (place + length * np.stack([np.cos(true), np.sin(true)], axis=1) - eye[:, :2]) / eye[:, 2:]
        seen, slopes = _seen(lift, true, sight)
        rows = np.concatenate([
            np.concatenate([slopes[0][:, None] * basis, own, wobble, np.zeros((len(time), 1))], axis=1),
            np.concatenate([slopes[1][:, None] * basis, nothing, np.ones((len(time), 1))], axis=1),
        ])  # fmt: skip
        # Linear about the lift so far.
        data = np.concatenate([angle - seen[0] + slopes[0] * lift, apart / length - seen[1] + 1 + slopes[1] * lift])
        ridge = np.zeros((n, rows.shape[1]))
        ridge[:, :n] = np.diag((1.0 + order) * NOISE / USUAL_LIFT)
        A = np.concatenate([rows * weight[:, None], ridge])
        found = np.linalg.lstsq(A, np.concatenate([data * weight, np.zeros(n)]), rcond=None)[0]
        missed = np.abs(data - rows @ found)
        scale = max(1.48 * float(np.median(missed)), 1e-6)
        weight = np.sqrt(np.minimum(1.0, HUBER * scale / np.maximum(missed, 1e-12)))
        lift = np.clip(basis @ found[:n], -MOST_LIFT, MOST_LIFT)
        turn = _seen(lift, true, sight)[0][0]
    plain = np.concatenate([own, wobble], axis=1)
    before, after = (_scatter(plain, v, weight[: len(time)]) for v in (angle, angle - turn))
    return Bending(turn, lift * length) if after < (1 - LEAST_GAIN) * before else None


def _seen(lift: Array, true: Array, sight: Array) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """Turn seen, rad, and distance seen, of a marker lifted by a share of its distance; and their slopes over it."""
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
    found = np.linalg.lstsq(plain * weight[:, None], angle * weight, rcond=None)[0]
    return float(np.average((angle - plain @ found) ** 2, weights=weight**4))


def _line(time: Array, angle: Array, turns: float) -> Array:
    """(n, k) straight pieces that the smooth turning is made of: one a turn at most, or they would take up the lift."""
    knots = np.linspace(time[0], time[-1], 1 + int(np.clip(turns / 1.5, 1, MOST_PIECES)))
    hats = [np.interp(time, knots, np.eye(len(knots))[k]) for k in range(len(knots))]
    return np.stack(hats, axis=1)
