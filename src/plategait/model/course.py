"""The course of a plate: the motions that it was given one after the other, each gone over to without a jolt.

The native core moves the plate by the same rule (`native/plate.hpp`): each layer's motion takes over from what the
plate did before it by a quintic from 0 to 1, so that position, speed and acceleration are continuous. The smooth start
is the first layer's, from where the motion holds the plate.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array
from plategait.model.motion import AXES, SHORTEST_RAMP, PlateMotion

# So many times its duration after its begin, a layer has been gone over to in single precision too.
_OVER = 1 + 1e-5
# Largest first, second and third derivative of the quintic, over a duration of 1.
_STEEPEST = np.array([15 / 8, 10 / math.sqrt(3), 60.0])


@dataclass(frozen=True)
class Layer:
    """One motion of a course.

    Attributes
    ----------
    motion : PlateMotion
    begin, duration : float
        Since when the plate goes over to it, and how long that takes, s.
    table_begin : float
        When its sampled trajectory begins, s; its sines count from the start of the run.
    """

    motion: PlateMotion
    begin: float = 0.0
    duration: float = 0.0
    table_begin: float = 0.0

    def is_over(self, time: float) -> bool:
        """Whether the plate has gone over to it for good, so that nothing before it matters."""
        return time - self.begin > self.duration * _OVER + SHORTEST_RAMP


Course = tuple[Layer, ...]


def course_of(motion: PlateMotion) -> Course:
    """Course of a plate that is given one motion at the start."""
    return (Layer(motion, 0.0, motion.ramp),)


def still_needed(course: Course, time: float) -> Course:
    """Course without the layers that no longer matter."""
    # The first layer also tells where the plate stood before it.
    for i in range(len(course) - 1, 0, -1):
        layer = course[i]
        if time - layer.begin > layer.duration * _OVER + SHORTEST_RAMP:  # as `is_over`, asked many times a second
            return course[i:]
    return course


def gone_over(course: Course, motion: PlateMotion, time: float, duration: float) -> Course:
    """Course that goes over to another motion from a time on.

    A sampled trajectory that stays the same goes on; another one begins at that time.
    """
    before = course[-1]
    same = motion.samples is not None and motion.samples == before.motion.samples
    layer = Layer(motion, time, duration, before.table_begin if same else time)
    return (*still_needed(course, time), layer)


@dataclass(frozen=True, eq=False)
class Kinematics:
    """How a plate moves at some times: each (6, n), m or rad, per s, s² and s³, in the order of `AXES`."""

    position: Array
    speed: Array
    acceleration: Array
    jerk: Array


def kinematics(course: Course, time: Array) -> Kinematics:
    """Position, speed, acceleration and jerk of a plate on its course, in closed form.

    Parameters
    ----------
    course : Course
    time : (n,) array
        s, none before the last layer's begin but the first layer's.
    """
    moves = np.zeros((4, len(AXES), len(time)))
    moves[0] = np.array(course[0].motion.offset.pose)[:, None]
    for layer in course:
        target = _of_motion(layer, time)
        w, w1, w2, w3 = _level(time - layer.begin, layer.duration)
        p, v, a, j = target - moves
        moves[0] += w * p
        moves[1] += w1 * p + w * v
        moves[2] += w2 * p + 2 * w1 * v + w * a
        moves[3] += w3 * p + 3 * w2 * v + 3 * w1 * a + w * j
    return Kinematics(*moves)


def most_on(course: Course, time: float) -> Array | None:
    """(4, 6) position, speed, acceleration and jerk that a plate never exceeds from a time on.

    Not the least such numbers: those of each motion, and of the way from one to the next, are added up. None where a
    layer follows a sampled trajectory.
    """
    most = np.zeros((4, len(AXES)))
    most[0] = np.abs(course[0].motion.offset.pose)
    for layer in course:
        own = layer.motion.most
        if own is None:
            return None
        if layer.duration <= SHORTEST_RAMP or layer.is_over(time):
            most = own
            continue
        p, v, a, _ = own + most
        w1, w2, w3 = _STEEPEST / layer.duration ** np.arange(1, 4)
        most = np.maximum(own, most)
        most[1] += w1 * p
        most[2] += w2 * p + 2 * w1 * v
        most[3] += w3 * p + 3 * w2 * v + 3 * w1 * a
    return most


def _level(time: Array, duration: float) -> tuple[Array, Array, Array, Array]:
    """Quintic from 0 to 1, and its derivatives."""
    if duration <= SHORTEST_RAMP:
        still = np.zeros_like(time)
        return np.ones_like(time), still, still, still
    s = np.clip(time / duration, 0.0, 1.0)
    inside = (s > 0) & (s < 1)
    return (
        s**3 * (10 - 15 * s + 6 * s**2),
        30 * s**2 * (1 - s) ** 2 / duration,
        60 * s * (1 - s) * (1 - 2 * s) / duration**2,
        inside * 60 * (1 - 6 * s + 6 * s**2) / duration**3,
    )


def _of_motion(layer: Layer, time: Array) -> Array:
    """(4, 6, n) what a layer's motion would be by itself: position and its derivatives."""
    moves = np.zeros((4, len(AXES), len(time)))
    moves[0] = np.array(layer.motion.offset.pose)[:, None]
    for d, amplitude, frequency, phase in layer.motion.terms():
        omega = 2 * math.pi * frequency
        angle = omega * time + 2 * math.pi * phase
        sine, cosine = amplitude * np.sin(angle), amplitude * np.cos(angle)
        moves[:, d] += [sine, omega * cosine, -(omega**2) * sine, -(omega**3) * cosine]
    if layer.motion.samples is not None:
        moves += layer.motion.samples.derivatives(time - layer.table_begin)
    return moves
