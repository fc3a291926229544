"""What a motion needs of the machine: how far, how fast, against which loads."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError, check_kind
from plategait.model.course import Course, Kinematics, course_of, gone_over, kinematics, most_on
from plategait.model.machine import Machine, machine_of
from plategait.model.motion import AXES, SHORTEST_RAMP, PlateMotion
from plategait.shown import Shown

# Points per period of the fastest sine: the largest of them is within 1e-4 of a sine's peak.
_POINTS, _MOST_POINTS = 240, 240_000
# A limit counts as kept within this share, so that a motion may be at its limit.
_SLACK = 1e-6
# Longest that a change of motion may take over the ramp that it asks for.
_LONGEST_JOIN = 256

WHAT = ("position", "speed", "acceleration", "jerk", "load")


@dataclass(frozen=True, eq=False, repr=False)
class Needs(Shown):
    """What a motion needs.

    Source: the loads of section 2.2.1 of the dissertation.

    Attributes
    ----------
    peaks : (5, 6) array
        Largest position, speed, acceleration, jerk and inertial load on each degree of freedom, SI: m and N, rad and
        N·m. The loads are NaN where the machine does not tell its masses.
    frequency : float
        Of the fastest sine, Hz; 0 where there is none.
    power, mean_power : float
        Largest and mean of what the drives give, W: what one of them gives back does not drive another.
    """

    peaks: Array
    frequency: float
    power: float
    mean_power: float


def needs(motion: PlateMotion, machine: Machine | Path | str, *, start: bool = True) -> Needs:
    """What a motion needs of a machine.

    Source: the loads of section 2.2.1 of the dissertation.

    Parameters
    ----------
    motion : PlateMotion
    machine : Machine, its name or file
    start : bool
        Whether its smooth start counts, which may need more than what follows.

    Raises
    ------
    InputError
        For what is no motion or no machine.
    """
    check_kind(motion, PlateMotion, "motion", "scenario.motion")
    machine = machine_of(machine)
    going = kinematics(course_of(motion.replace(ramp=0.0)), _times(motion))
    peaks, power = _peaks(going, machine), _power(going, machine)
    most, mean = float(power.max()), float(power.mean())
    if start and motion.ramp > SHORTEST_RAMP:
        starting = kinematics(course_of(motion), _between(0.0, motion.ramp, motion))
        peaks, most = np.maximum(peaks, _peaks(starting, machine)), max(most, float(_power(starting, machine).max()))
    fastest = 1 / motion.shortest_period if motion.terms() else 0.0
    return Needs(peaks, fastest, most, mean)


def _times(motion: PlateMotion) -> Array:
    """Times over which a motion shows all that it does once it goes."""
    end = motion.period if motion.terms() else 0.0
    end = max(end, motion.samples.time[-1] if motion.samples else 0.0)
    return _between(0.0, end, motion)


def _between(begin: float, end: float, *motions: PlateMotion) -> Array:
    steps = [end - begin, *(motion.shortest_period for motion in motions)]
    steps += [2 * motion.samples.finest_step for motion in motions if motion.samples]
    finest = min(steps) / _POINTS
    count = min(max(_POINTS, math.ceil((end - begin) / finest)), _MOST_POINTS) if end > begin else 1
    return np.linspace(begin, end, count + 1)


def _peaks(moves: Kinematics, machine: Machine) -> Array:
    largest = [np.abs(part).max(axis=1) for part in (moves.position, moves.speed, moves.acceleration, moves.jerk)]
    return np.array([*largest, machine.inertial_loads * largest[2]])


def _power(moves: Kinematics, machine: Machine) -> Array:
    """(n,) what the drives give at each time, W."""
    each = machine.inertial_loads[:, None] * moves.acceleration * moves.speed
    return np.maximum(each, 0.0).sum(axis=0)


def excess(needed: Needs, machine: Machine) -> list[str]:
    """What is needed beyond a machine's limits, each in a few words; empty where the motion is within them."""
    over, limits = [], machine.limits
    if machine.frequency is not None and needed.frequency > machine.frequency * (1 + _SLACK):
        over.append(f"a sine of {needed.frequency:.4g} Hz, above {machine.frequency:.4g} Hz")
    for d, axis in enumerate(AXES):
        for kind, name in enumerate(WHAT):
            need, limit = needed.peaks[kind, d], limits[kind, d]
            if need > limit * (1 + _SLACK):
                if limit == 0:
                    over.append(f"motion on {axis}, which it does not move")
                    break
                over.append(f"{_said(need, kind, axis)} of {name} on {axis}, above {_said(limit, kind, axis)}")
    if machine.power is not None and needed.power > machine.power * (1 + _SLACK):
        over.append(f"{needed.power:.4g} W, above {machine.power:.4g} W")
    return over


def _said(value: float, kind: int, axis: str) -> str:
    """A need with the unit that people read."""
    turns, per = axis.startswith("r"), ("", "/s", "/s²", "/s³")
    if WHAT[kind] == "load":
        return f"{value:.4g} {'N·m' if turns else 'N'}"
    return f"{math.degrees(value):.4g} deg{per[kind]}" if turns else f"{1e3 * value:.4g} mm{per[kind]}"


def surely_within(most: Array | None, motion: PlateMotion | None, machine: Machine) -> bool:
    """Whether bounds tell that a machine's limits are kept, without looking at the motion at many times.

    Parameters
    ----------
    most : (4, 6) array, optional
        Position, speed, acceleration and jerk that are never exceeded, SI; nothing is sure without.
    motion : PlateMotion, optional
        Whose sines count against the machine's frequency.
    machine : Machine
    """
    if most is None or not (most <= machine.limits[:4]).all():
        return False
    if motion is not None and machine.frequency is not None and 1 / motion.shortest_period > machine.frequency:
        return False
    if not machine.limits_rates:
        return True
    # What is not told has no limit.
    loads = np.nan_to_num(machine.inertial_loads) * most[2]
    return bool((loads <= machine.limits[4]).all()) and loads @ most[1] <= (machine.power or math.inf)


@lru_cache(maxsize=4096)
def check_motion(motion: PlateMotion, machine: Machine, field: str = "motion", start: bool = True) -> None:
    """Refuse a motion that a machine cannot make.

    Raises
    ------
    InputError
        With the first limit that is not kept.
    """
    over = excess(needs(motion, machine, start=start), machine)
    if over:
        raise InputError(field, over[0], f"within the limits of {machine.name}", "a smaller or slower motion")


def join_duration(course: Course, motion: PlateMotion, time: float, machine: Machine | None, field: str) -> float:
    """Time that a plate takes to go over to another motion, s: its ramp, or longer where the machine asks for it.

    What the plate did before is taken to be within the machine's limits.

    Raises
    ------
    InputError
        When there is no ramp, or the motion, or going over to it, is beyond the machine's limits.
    """
    if motion.ramp <= SHORTEST_RAMP:
        raise InputError(f"{field}.ramp", f"{motion.ramp:g} s", "above 0 s where a motion changes", '"0.1 s"')
    if machine is None:
        return motion.ramp
    if not surely_within(motion.most, motion, machine):
        check_motion(motion, machine, field, start=False)
    if not machine.limits_rates and motion.samples is None and _sines_alone(course):
        # Between one sine and another the plate is nowhere that neither of them is within reach of.
        return motion.ramp
    duration = motion.ramp
    while duration <= _LONGEST_JOIN * motion.ramp:
        joined = gone_over(course, motion, time, duration)
        if surely_within(most_on(joined, time), None, machine):
            return duration
        times = _between(time, time + duration, *(layer.motion for layer in joined))
        moves = kinematics(joined, times)
        reached = Needs(_peaks(moves, machine), 0.0, float(_power(moves, machine).max()), math.nan)
        if not excess(reached, machine):
            return duration
        duration *= math.sqrt(2)
    raise InputError(field, "a change that no join keeps within the limits", f"one that {machine.name} can make",
                     "a motion that leaves the machine some room")  # fmt: skip


def _sines_alone(course: Course) -> bool:
    for layer in course:  # noqa: SIM110, twice as fast as `all`
        if layer.motion.samples is not None:
            return False
    return True


def join_durations(
    courses: Sequence[Course],
    motions: Sequence[PlateMotion],
    times: Sequence[float],
    machine: Machine | None,
    fields: Sequence[str],
) -> list[float]:
    """`join_duration` of many plates at once: the same numbers, sooner where bounds tell them.

    Raises
    ------
    InputError
        As of `join_duration`, for the first plate of which it does.
    """
    sure = np.zeros(len(motions), dtype=bool)
    if machine is not None and not machine.limits_rates:
        bounds = [motion.most for motion in motions]
        told = [k for k, bound in enumerate(bounds) if bound is not None]
        most = np.array([bounds[k][0] for k in told]).reshape(-1, len(AXES))  # type: ignore[index]
        fastest = 1 / np.array([motions[k].shortest_period for k in told])
        sure[told] = (most <= machine.limits[0]).all(axis=1) & (fastest <= (machine.frequency or math.inf))
    return [
        motion.ramp
        if known and motion.ramp > SHORTEST_RAMP and _sines_alone(course)
        else join_duration(course, motion, time, machine, field)
        for known, course, motion, time, field in zip(sure.tolist(), courses, motions, times, fields, strict=True)
    ]


def start_duration(motion: PlateMotion, machine: Machine, field: str) -> float:
    """Time that a plate takes to start a motion, s: its ramp, or longer where the machine asks for it.

    Raises
    ------
    InputError
        When the motion, or any start of it, is beyond the machine's limits.
    """
    still = motion.with_valid(angle=0.0, stroke=0.0, waves=(), samples=None)
    return join_duration(course_of(still), motion, 0.0, machine, field)
