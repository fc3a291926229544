"""Trajectories for a machine: a plate's motion at a fixed rate, once from rest to rest or as a cycle without a jump."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError, check_kind
from plategait.model.course import Course, Layer, gone_over, kinematics
from plategait.model.machine import Machine, machine_of
from plategait.model.motion import AXES, PlateMotion
from plategait.model.needs import excess, join_duration, needs, start_duration
from plategait.shown import Shown
from plategait.units import Quantity

# Samples per period of the fastest sine: a cubic through positions and speeds is then within 0.1 % of its amplitude.
LEAST_SAMPLES = 8
MOST_SAMPLES = 1_000_000
LONGEST_CYCLE = 10.0  # s
# What frequencies, and a rate and a period, may differ by from a ratio of whole numbers to count as one.
_SAME = 1e-9
_LARGEST_RATIO = 1000
_MOVES = '--stroke "3 mm"'
_DURATION = Quantity("s", "s", "4 s", above=0)
_RATE = Quantity("Hz", "Hz", "1 kHz", above=0)


@dataclass(frozen=True, eq=False, repr=False)
class Trajectory(Shown):
    """Where a plate is to be, at a fixed rate.

    Attributes
    ----------
    rate : float
        Samples per second.
    time : (n,) array
        s, from 0 on.
    position, speed, acceleration : (6, n) arrays
        On each degree of freedom, in the order of x, y, z, rx, ry, rz: m and rad, per s and s².
    axes : tuple of str
        The degrees of freedom that move or are held off their rest.
    cycle : bool
        Whether it is played over and over: after the last sample comes the first again, one sample later.
    """

    rate: float
    time: Array
    position: Array
    speed: Array
    acceleration: Array
    axes: tuple[str, ...]
    cycle: bool

    @property
    def duration(self) -> float:
        """Time until a cycle begins anew, or the plate has come to rest, s."""
        return (len(self.time) if self.cycle else len(self.time) - 1) / self.rate

    def of(self, axis: str) -> Array:
        """(3, n) position, speed and acceleration on one degree of freedom."""
        d = AXES.index(axis)
        return np.stack([self.position[d], self.speed[d], self.acceleration[d]])


def trajectory(
    motion: PlateMotion,
    rate: float | str = "1 kHz",
    machine: Machine | Path | str = "source-robot",
    *,
    duration: float | str = "4 s",
    cycle: bool = False,
) -> Trajectory:
    """Trajectory of a plate's motion, within the limits of a machine.

    From rest to rest: from where the motion's offset holds the plate, by its smooth start, until `duration`, and by as
    smooth a stop back there. Both take the motion's ramp, or longer where the machine asks for it. As a cycle: the
    fewest whole periods that are a whole number of samples.

    Source: docs/export.md.

    Parameters
    ----------
    motion : PlateMotion
    rate : float or str
        Samples per second, at least 8 per period of the fastest sine.
    machine : Machine, Path or str
        What is to make it: a machine, its file, or a name of `MACHINES`.
    duration : float or str
        Until the plate begins to stop, s; a cycle does not use it.
    cycle : bool
        One cycle, to be played over and over.

    Raises
    ------
    InputError
        When the motion is beyond the machine's limits, the rate is too low, the trajectory too long, or no cycle
        closes: for frequencies without a common period, a rate that no few periods fit, or a sampled trajectory.
    """
    check_kind(motion, PlateMotion, "motion", "scenario.motion")
    hertz, shaker = _RATE.read(rate, "rate"), machine_of(machine)
    _check_limits(motion, shaker)
    check_rate(motion, hertz)
    if cycle:
        periods, count = _closed(motion, hertz)
        # Whole periods are shared out evenly: a rate that is off by less than can be typed opens no gap.
        time = (periods / count) * np.arange(float(count))
        course: Course = (Layer(motion),)
    else:
        course, end = _from_rest_to_rest(motion, shaker, _DURATION.read(duration, "duration"))
        count = math.ceil(end * hertz * (1 - _SAME)) + 1
        check_count(count, hertz, "duration", f'"{0.5 * MOST_SAMPLES / hertz:.3g} s"')
        time = np.arange(float(count)) / hertz
    moves = kinematics(course, time)
    position, speed, acceleration = moves.position, moves.speed, moves.acceleration
    axes = tuple(axis for d, axis in enumerate(AXES) if np.abs(position[d]).max() > 0)
    if not axes:
        raise InputError("motion", "a plate that stands still", "one that moves", _MOVES)
    return Trajectory(hertz, np.arange(float(count)) / hertz, position, speed, acceleration, axes, cycle)


def _from_rest_to_rest(motion: PlateMotion, machine: Machine, duration: float) -> tuple[Course, float]:
    """Course that starts at once and stops from `duration` on, and when it has stopped, s."""
    started: Course = (Layer(motion, 0.0, start_duration(motion, machine, "motion")),)
    still = motion.replace(angle=0.0, stroke=0.0, waves=(), samples=None)
    stop = join_duration(started, still, duration, machine, "motion")
    return gone_over(started, still, duration, stop), duration + stop


def _closed(motion: PlateMotion, rate: float) -> tuple[float, int]:
    """Duration of the shortest cycle, s, and how many samples it has."""
    if motion.samples is not None:
        raise InputError("cycle", "a sampled trajectory, which ends", "left out where a motion has samples",
                         "the trajectory from rest to rest")  # fmt: skip
    if not motion.terms():
        raise InputError("cycle", "a plate that stands still", "for a plate that moves", _MOVES)
    period = _common_period(motion)
    samples = Fraction(rate * period).limit_denominator(max(1, math.floor(LONGEST_CYCLE / period)))
    exact = rate * period
    if samples == 0 or abs(float(samples) - exact) > _SAME * exact:
        near = max(1, round(exact)) / period
        raise InputError("rate", f"{rate:.9g} Hz", f"a whole number of samples in some periods of {1 / period:.9g} Hz "
                         f"that take {LONGEST_CYCLE:g} s at most", f'"{near:.12g} Hz"')  # fmt: skip
    check_count(samples.numerator, rate, "rate", f'"{max(1, round(1000 * period)) / period:.12g} Hz"')
    return samples.denominator * period, samples.numerator


def _common_period(motion: PlateMotion) -> float:
    """Shortest time after which all sines repeat, s."""
    common: Fraction | None = None
    for _, _, frequency, _ in motion.terms():
        exact = frequency / motion.frequency
        ratio = Fraction(exact).limit_denominator(_LARGEST_RATIO)
        if ratio == 0 or abs(float(ratio) - exact) > _SAME * exact:
            near = Fraction(exact).limit_denominator(12) or Fraction(1, 12)
            got = f"sines of {frequency:.9g} Hz and {motion.frequency:.9g} Hz, which have no common period"
            raise InputError("cycle", got, "for frequencies whose ratios are those of whole numbers",
                             f"a ratio of {float(near):.12g}, {near}, or the trajectory from rest to rest")  # fmt: skip
        common = ratio if common is None else _common_divisor(common, ratio)
    assert common is not None
    period = 1 / (float(common) * motion.frequency)
    if period > LONGEST_CYCLE:
        raise InputError("cycle", f"a common period of {period:.4g} s", f"at most {LONGEST_CYCLE:g} s",
                         "ratios of small whole numbers, or the trajectory from rest to rest")  # fmt: skip
    return period


def _common_divisor(one: Fraction, other: Fraction) -> Fraction:
    return Fraction(math.gcd(one.numerator * other.denominator, other.numerator * one.denominator),
                    one.denominator * other.denominator)  # fmt: skip


def check_rate(motion: PlateMotion, rate: float) -> None:
    """Refuse a rate, Hz, that is too low for a motion."""
    fastest = 1 / motion.shortest_period if motion.terms() else 0.0
    least = LEAST_SAMPLES * fastest
    if motion.samples is not None:
        least = max(least, 1 / motion.samples.finest_step)
    if rate < least * (1 - _SAME):
        allowed = f"at least {least:.9g} Hz, for {LEAST_SAMPLES} samples in each period of the fastest sine"
        raise InputError("rate", f"{rate:.9g} Hz", f"{allowed} and one for each sample given",
                         f'"{1.25 * least:.3g} Hz"')  # fmt: skip


def check_count(count: int, rate: float, field: str, hint: str) -> None:
    """Refuse more samples than anyone reads."""
    if count > MOST_SAMPLES:
        raise InputError(
            field, f"{count} samples at {rate:.9g} Hz", f"such that there are at most {MOST_SAMPLES}", hint
        )


def _check_limits(motion: PlateMotion, machine: Machine) -> None:
    """Refuse a motion that a machine cannot make, and say how much of it the machine could."""
    over = excess(needs(motion, machine, start=False), machine)
    if over:
        raise InputError("motion", "; ".join(over), f"within the limits of {machine.name}", _instead(motion, machine))


def _instead(motion: PlateMotion, machine: Machine) -> str:
    """The largest share of a motion's sines that a machine can make, or a frequency that it can."""
    if motion.samples is not None:
        return "a smaller or slower motion"
    fastest = 1 / motion.shortest_period if motion.terms() else 0.0
    if machine.frequency is not None and fastest > machine.frequency:
        motion = motion.replace(frequency=motion.frequency * machine.frequency / fastest)
        if not excess(needs(motion, machine, start=False), machine):
            return f'--frequency "{_floored(motion.frequency)} Hz"'
    low, high = 0.0, 1.0
    for _ in range(12):
        share = 0.5 * (low + high)
        if excess(needs(_smaller(motion, share), machine, start=False), machine):
            high = share
        else:
            low = share
    if low == 0:
        return "a motion on degrees of freedom, and about an offset, that the machine has"
    said = f'--angle "{_floored(math.degrees(low * motion.angle))} deg" '
    said += f'--stroke "{_floored(1e3 * low * motion.stroke)} mm"'
    if motion.waves:
        said += f", and the waves' amplitudes times {_floored(low)}"
    return said


def _smaller(motion: PlateMotion, share: float) -> PlateMotion:
    waves = tuple(wave.replace(amplitude=share * wave.amplitude) for wave in motion.waves)
    smaller: PlateMotion = motion.replace(angle=share * motion.angle, stroke=share * motion.stroke, waves=waves)
    return smaller


def _floored(value: float) -> str:
    """Three digits of a number, towards zero."""
    if value == 0:
        return "0"
    place = 10.0 ** (math.floor(math.log10(abs(value))) - 2)
    return f"{math.trunc(value / place * (1 + 1e-9)) * place:.3g}"
