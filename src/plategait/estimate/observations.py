"""What was measured: spin rates and run-offs, each under its plate motion."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.curve.protocol import Protocol, measured_as
from plategait.errors import InputError
from plategait.estimate.handling import Handling
from plategait.estimate.readings import Readings, gather, is_read, unused
from plategait.model.motion import PlateMotion, Wave
from plategait.model.scenario import Scenario

MOST_CONDITIONS = 60
LEAST_RATES = 3
# Run-offs are told apart no finer than a plate's frequency is set, Hz.
FREQUENCY_STEP = 0.05
# Cosine of the phase of the stroke, 45 deg, up to which an object spins the way that it does in phase.
IN_PHASE = 0.7


@dataclass(frozen=True, order=True)
class Condition:
    """A plate motion, and how it was observed.

    Attributes
    ----------
    angle, stroke : float
        Angular amplitude A_p, rad, and stroke B_p, m.
    frequency : float
        Hz; 0 where it stands for all frequencies of an amplitude.
    height : float
        Of the plate above its axis, m, over what the scenario says.
    phase : float
        Of the stroke before the turning, rad; 0 as in the source.
    duration, slip_limit : float
        For how long it was observed, s, and up to which slip, m; 0 where they are as the scenario says.
    """

    angle: float
    stroke: float
    frequency: float
    height: float = 0.0
    phase: float = 0.0
    duration: float = 0.0
    slip_limit: float = 0.0

    def motion(self, like: PlateMotion) -> PlateMotion:
        """Plate motion of this condition, in all else like another."""
        changes = {"frequency": self.frequency, "angle": self.angle, "height": like.height + self.height}
        if self.phase == 0:
            return like.replace(stroke=self.stroke, **changes)  # type: ignore[no-any-return]
        wave = Wave(axis="x", amplitude=self.stroke, phase=self.phase)
        return like.replace(stroke=0.0, waves=(*like.waves, wave), **changes)  # type: ignore[no-any-return]

    def at(self, frequency: float) -> Condition:
        """Same at another frequency, Hz."""
        return replace(self, frequency=frequency)

    def applied(self, scenario: Scenario) -> Scenario:
        """Scenario under this motion, observed as long and up to the slip that this point was."""
        moved: Scenario = scenario.replace(motion=self.motion(scenario.motion))
        if not self.duration and not self.slip_limit:
            return moved
        duration, limit = self.duration or scenario.duration, self.slip_limit or scenario.slip_limit
        return measured_as(moved, Protocol(duration, scenario.measured_from, limit))

    @property
    def amplitude(self) -> Condition:
        """All but the frequency: points that share it lie on one spin curve, with one run-off."""
        return replace(self, frequency=0.0, duration=0.0, slip_limit=0.0)

    @property
    def text(self) -> str:
        """For people, the frequency left out: "A_p = 3 deg, B_p = 3 mm"."""
        return self._told(f"the plate {1e3 * self.height:+.3g} mm" if self.height else "")

    def text_at(self, height: float) -> str:
        """The same with the plate's height told, where the scenario has it at `height`, m."""
        return self._told(f"height {1e3 * (height + self.height):.3g} mm")

    def _told(self, height: str) -> str:
        parts = [f"A_p = {math.degrees(self.angle):.3g} deg", f"B_p = {1e3 * self.stroke:.3g} mm", height]
        return ", ".join(filter(None, [*parts, f"phase {math.degrees(self.phase):.3g} deg" if self.phase else ""]))


@dataclass(frozen=True, eq=False)
class Compared:
    """Measured numbers that the engine gives too.

    Attributes
    ----------
    quantity : (n,) int array
        0 for a spin rate, k for the k-th of the readings.
    condition : (n,) int array
        Condition of each.
    value, sd : (n,) arrays
        Rates in deg/s, readings SI; the sd of a rate may be NaN.
    """

    quantity: NDArray[np.int64]
    condition: NDArray[np.int64]
    value: Array
    sd: Array


@dataclass(frozen=True, eq=False)
class Observations:
    """Measured points.

    Attributes
    ----------
    conditions : tuple of Condition
        The different ones, in order of amplitude and frequency.
    which : (n,) int array
        Condition of each point.
    rate : (n,) array
        Spin rate, deg/s, positive the way that the object spins; NaN where it failed or nothing was measured.
    sd : (n,) array
        Standard deviation of each rate, deg/s; NaN where unknown.
    failed : (n,) bool array
        Whether the object ran off, folded or left the plate.
    notes : tuple of str
        What was left out, and why, and what of the files is odd.
    readings : tuple of Readings
        What else was read of the object at those points.
    handling : Handling
        What of the measurement differs from point to point, unseen.
    """

    conditions: tuple[Condition, ...]
    which: NDArray[np.int64]
    rate: Array
    sd: Array
    failed: NDArray[np.bool_]
    notes: tuple[str, ...] = ()
    readings: tuple[Readings, ...] = ()
    handling: Handling = field(default_factory=Handling)

    @property
    def rated(self) -> NDArray[np.bool_]:
        """Points with a rate to compare."""
        return np.isfinite(self.rate) & ~self.failed

    @property
    def frequency(self) -> Array:
        """Plate frequency of each point, Hz."""
        return np.array([self.conditions[i].frequency for i in self.which])

    @cached_property
    def compared(self) -> Compared:
        """Every number to compare with what the engine gives: the rates, then the readings."""
        rated = self.rated
        condition = [self.which[rated], *(r.which for r in self.readings)]
        return Compared(
            quantity=np.repeat(np.arange(len(condition)), [len(w) for w in condition]),
            condition=np.concatenate(condition),
            value=np.concatenate([self.rate[rated], *(r.value for r in self.readings)]),
            sd=np.concatenate([self.sd[rated], *(r.sd for r in self.readings)]),
        )

    def brackets(self) -> dict[Condition, tuple[float, float]]:
        """By amplitude, the frequencies (Hz) between which the object begins to run off.

        The highest at which it stayed below the lowest at which it failed; 0 or infinity where there is none.
        """
        brackets = {}
        for amplitude in dict.fromkeys(c.amplitude for c in self.conditions):
            members = np.array([self.conditions[i].amplitude == amplitude for i in self.which])
            failed, stayed = self.frequency[members & self.failed], self.frequency[members & self.rated]
            first = float(failed.min(initial=math.inf))
            last = float(stayed[stayed <= first].max(initial=0.0))
            if last == first:  # seen to do both
                last, first = last - FREQUENCY_STEP, first + FREQUENCY_STEP
            brackets[amplitude] = (last, first)
        return brackets


def observe_curves(
    curves: Sequence[Curve], motions: Sequence[PlateMotion], handling: Handling | None = None
) -> Observations:
    """Points of one or several measured curves, each taken at the amplitudes of its motion.

    Rates beyond a curve's first failure are left out: such islands belong to another motion. A curve's rates count
    positive the way that its object mostly spins.

    Raises
    ------
    InputError
        With too few rates to say anything, or too many different plate motions.
    """
    points: list[_Point] = []
    notes: list[str] = []
    for curve, motion in zip(curves, motions, strict=True):
        notes += curve.notes
        of_curve = list(_points(curve, motion))
        first = _first_failures(of_curve)
        island = [p for p in of_curve if not p.failed and p.condition.frequency > first[p.condition.amplitude]]
        for amplitude, at in first.items():
            listed = sorted(p.condition.frequency for p in island if p.condition.amplitude == amplitude)
            if listed:
                hertz = ", ".join(f"{f:g}" for f in listed)
                notes.append(f"left out: rates at {hertz} Hz, beyond the first failure at {at:g} Hz")
        points += [p for p in of_curve if p not in island]
    # Failures beyond the first of their amplitude say nothing more of where it begins.
    first = _first_failures(points)
    points = [p for p in points if not p.failed or p.condition.frequency <= first[p.condition.amplitude]]
    conditions = sorted({p.condition for p in points})
    if len(conditions) > MOST_CONDITIONS:
        raise InputError("curve", f"{len(conditions)} different plate motions", f"at most {MOST_CONDITIONS}",
                         "averaging neighbouring frequencies")  # fmt: skip
    notes += filter(None, [unused(curves)])
    which = np.array([conditions.index(p.condition) for p in points], dtype=np.int64)
    readings = gather((p.curve, p.row, int(c)) for p, c in zip(points, which, strict=True) if not p.failed)
    data = Observations(
        tuple(conditions),
        which,
        np.array([p.rate for p in points], dtype=float),
        np.array([p.sd for p in points], dtype=float),
        np.array([p.failed for p in points], dtype=bool),
        tuple(notes),
        readings,
        handling or Handling(),
    )
    different = len(set(data.which[data.rated].tolist()))
    if different < LEAST_RATES:
        raise InputError("curve", f"spin rates at {different} plate frequencies", f"at least {LEAST_RATES} of them",
                         "measuring at 14, 20 and 25 Hz")  # fmt: skip
    return data


def _observed(curve: Curve, i: int) -> tuple[float, float]:
    """Duration (s) and slip limit (m) of a curve's point, where it tells them: to two digits, else 0.

    Clips of one length differ by a frame or two, which makes no other condition of them.
    """
    told = ((column[i] if column is not None else math.nan) for column in (curve.duration, curve.slip_limit))
    duration, limit = (float(f"{value:.2g}") if math.isfinite(value) else 0.0 for value in told)
    return duration, limit


@dataclass(frozen=True, eq=False)
class _Point:
    """One measured point, and the row of the curve that tells it."""

    condition: Condition
    rate: float
    sd: float
    failed: bool
    curve: Curve
    row: int


def _points(curve: Curve, motion: PlateMotion) -> Iterator[_Point]:
    """Points of a curve at which something was measured; rates positive the way that its object mostly spins."""
    failed = curve.failed
    conditions = [_condition(curve, motion, i) for i in range(len(failed))]
    # By their number, not their sum: one slipped decimal point must not turn all the others round. A stroke out of
    # phase may turn the spin itself; where none is in phase, the rates are taken as they stand.
    in_phase = ~failed & np.array([math.cos(c.phase) > IN_PHASE for c in conditions], dtype=bool)
    turn = -1.0 if np.nansum(np.sign(curve.spin_rate_deg_s[in_phase])) < 0 else 1.0
    for i, condition in enumerate(conditions):
        rate, sd = turn * float(curve.spin_rate_deg_s[i]), float(curve.spin_rate_sd_deg_s[i])
        if failed[i] or math.isfinite(rate) or is_read(curve, i):
            yield _Point(
                condition, math.nan if failed[i] else rate, sd if sd > 0 else math.nan, bool(failed[i]), curve, i
            )


def _condition(curve: Curve, motion: PlateMotion, i: int) -> Condition:
    """Plate motion of a curve's point: what the curve tells, else the motion."""

    def told(column: Array | None, otherwise: float) -> float:
        return otherwise if column is None or math.isnan(column[i]) else float(column[i])

    duration, slip_limit = _observed(curve, i)
    return Condition(
        angle=math.radians(told(curve.angle_deg, math.degrees(motion.angle))),
        stroke=told(curve.stroke, motion.stroke),
        frequency=float(curve.frequency_hz[i]),
        height=told(curve.height, motion.height) - motion.height,
        phase=told(curve.phase, 0.0),
        duration=duration,
        slip_limit=slip_limit,
    )


def _first_failures(points: Sequence[_Point]) -> dict[Condition, float]:
    """Lowest frequency at which any failed, Hz, by amplitude; infinite where none did."""
    first: dict[Condition, float] = {}
    for p in points:
        at = p.condition.frequency if p.failed else math.inf
        first[p.condition.amplitude] = min(first.get(p.condition.amplitude, math.inf), at)
    return first
