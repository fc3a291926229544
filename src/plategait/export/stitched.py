"""Trajectories of plates that are told one motion after the other."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from plategait.export.trajectory import Trajectory, check_count, check_rate
from plategait.model.course import Course, Kinematics, Layer, gone_over, kinematics
from plategait.model.machine import Machine, machine_of
from plategait.model.motion import AXES, PlateMotion
from plategait.model.needs import join_duration
from plategait.units import FREQUENCY


def stitched(
    told: Sequence[tuple[float, PlateMotion]],
    still: PlateMotion,
    until: float,
    rate: float | str = "1 kHz",
    machine: Machine | Path | str = "source-robot",
) -> Trajectory:
    """Trajectory of a plate that stands, is told motions, and stops in the end; gone over to as a session does.

    Parameters
    ----------
    told : sequence of (s, PlateMotion)
        When the plate is told what, in order.
    still : PlateMotion
        What it does before, and in the end.
    until : float
        When it begins to stop, s.
    rate : float or str
        Samples per second, at least 8 per period of the fastest sine.
    machine : Machine, Path or str
        Whose limits the ways from one motion to the next keep.

    Raises
    ------
    InputError
        For a rate that is too low, too many samples, or a change that the machine cannot make.
    """
    hertz, shaker = FREQUENCY.read(rate, "rate"), machine_of(machine)
    course: Course = (Layer(still, 0.0, still.ramp),)
    parts: list[Kinematics] = []
    done = 0
    for time, motion in (*((time, motion) for time, motion in told if time < until), (until, still)):
        if motion == course[-1].motion:
            continue
        check_rate(motion, hertz)
        stop = math.ceil(time * hertz - 1e-6)
        check_count(stop, hertz, "rate", f'"{0.5 * hertz:g} Hz"')
        parts.append(kinematics(course, np.arange(done, stop) / hertz))
        course = gone_over(course, motion, time, join_duration(course, motion, time, shaker, "motion"))
        done = stop
    count = max(math.ceil((course[-1].begin + course[-1].duration) * hertz - 1e-6) + 1, done + 1)
    check_count(count, hertz, "rate", f'"{0.5 * hertz:g} Hz"')
    parts.append(kinematics(course, np.arange(done, count) / hertz))
    position, speed, acceleration = (
        np.concatenate([getattr(part, name) for part in parts], axis=1)
        for name in ("position", "speed", "acceleration")
    )
    moved = tuple(axis for d, axis in enumerate(AXES) if np.abs(position[d]).max() > 0)
    axes = moved or tuple(axis for d, axis in enumerate(AXES) if shaker.limits[0, d] > 0)
    return Trajectory(hertz, np.arange(float(count)) / hertz, position, speed, acceleration, axes, cycle=False)
