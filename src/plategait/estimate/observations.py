"""What was measured: spin rates and run-offs, each under its plate motion."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.errors import InputError
from plategait.model.motion import PlateMotion

MOST_CONDITIONS = 60
LEAST_RATES = 3
# Run-offs are told apart no finer than a plate's frequency is set, Hz.
FREQUENCY_STEP = 0.05


@dataclass(frozen=True, order=True)
class Condition:
    """A plate motion: frequency (Hz), angular amplitude A_p (rad) and stroke B_p (m)."""

    angle: float
    stroke: float
    frequency: float

    def motion(self, like: PlateMotion) -> PlateMotion:
        """Plate motion of this condition, in all else like another."""
        moved: PlateMotion = like.replace(frequency=self.frequency, angle=self.angle, stroke=self.stroke)
        return moved

    @property
    def amplitude(self) -> tuple[float, float]:
        """Amplitudes (angle, stroke), which the points of one curve share."""
        return self.angle, self.stroke


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
    """

    conditions: tuple[Condition, ...]
    which: NDArray[np.int64]
    rate: Array
    sd: Array
    failed: NDArray[np.bool_]
    notes: tuple[str, ...] = ()

    @property
    def rated(self) -> NDArray[np.bool_]:
        """Points with a rate to compare."""
        return np.isfinite(self.rate) & ~self.failed

    @property
    def frequency(self) -> Array:
        """Plate frequency of each point, Hz."""
        return np.array([self.conditions[i].frequency for i in self.which])

    def brackets(self) -> dict[tuple[float, float], tuple[float, float]]:
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


def observe_curves(curves: Sequence[Curve], motions: Sequence[PlateMotion]) -> Observations:
    """Points of one or several measured curves, each taken at the amplitudes of its motion.

    Rates beyond a curve's first failure are left out: such islands belong to another motion. A curve's rates count
    positive the way that its object mostly spins.

    Raises
    ------
    InputError
        With too few rates to say anything, or too many different plate motions.
    """
    points: list[tuple[Condition, float, float, bool]] = []
    notes: list[str] = []
    for curve, motion in zip(curves, motions, strict=True):
        notes += curve.notes
        failed = curve.failed
        first = float(curve.frequency_hz[failed].min(initial=math.inf))
        # By their number, not their sum: one slipped decimal point must not turn all the others round.
        turn = -1.0 if np.nansum(np.sign(curve.spin_rate_deg_s[~failed])) < 0 else 1.0
        angles = curve.angle_deg if curve.angle_deg is not None else np.full(len(failed), math.nan)
        island = ~failed & (curve.frequency_hz > first) & np.isfinite(curve.spin_rate_deg_s)
        if island.any():
            listed = ", ".join(f"{f:g}" for f in sorted(curve.frequency_hz[island]))
            notes.append(f"left out: rates at {listed} Hz, beyond the first failure at {first:g} Hz")
        for i, frequency in enumerate(curve.frequency_hz):
            angle = motion.angle if math.isnan(angles[i]) else math.radians(angles[i])
            condition = Condition(angle, motion.stroke, float(frequency))
            rate = turn * float(curve.spin_rate_deg_s[i])
            if not island[i] and (failed[i] or math.isfinite(rate)):
                sd = float(curve.spin_rate_sd_deg_s[i])
                points.append((condition, math.nan if failed[i] else rate, sd if sd > 0 else math.nan, bool(failed[i])))
    points = _up_to_the_first_failure(points)
    conditions = sorted({p[0] for p in points})
    if len(conditions) > MOST_CONDITIONS:
        raise InputError("curve", f"{len(conditions)} different plate motions", f"at most {MOST_CONDITIONS}",
                         "averaging neighbouring frequencies")  # fmt: skip
    columns = list(zip(*points, strict=True)) if points else [(), (), (), ()]
    which = np.array([conditions.index(c) for c in columns[0]], dtype=np.int64)
    data = Observations(tuple(conditions), which, np.array(columns[1], dtype=float), np.array(columns[2], dtype=float),
                        np.array(columns[3], dtype=bool), tuple(notes))  # fmt: skip
    different = len(set(data.which[data.rated].tolist()))
    if different < LEAST_RATES:
        raise InputError("curve", f"spin rates at {different} plate frequencies", f"at least {LEAST_RATES} of them",
                         "measuring at 14, 20 and 25 Hz")  # fmt: skip
    return data


def _up_to_the_first_failure(
    points: list[tuple[Condition, float, float, bool]],
) -> list[tuple[Condition, float, float, bool]]:
    """Points without the failures beyond the first of their amplitude, which say nothing more of where it begins."""
    first: dict[tuple[float, float], float] = {}
    for condition, _, _, failed in points:
        if failed:
            first[condition.amplitude] = min(first.get(condition.amplitude, math.inf), condition.frequency)
    return [p for p in points if not p[3] or p[0].frequency <= first[p[0].amplitude]]
