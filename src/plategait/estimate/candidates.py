"""Candidate measurements: the plate motions among which the next one is chosen, all of which the plate can make."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from plategait.errors import InputError
from plategait.estimate.observations import FREQUENCY_STEP, Condition
from plategait.estimate.particles import stratified
from plategait.model.machine import Machine
from plategait.model.motion import PlateMotion
from plategait.model.needs import excess, needs

# Motions span the gaits about the usual run-off, A_p ω_p² = 8e4 deg/s² in the source.
USUAL_ACCELERATION = math.radians(8e4)
SPAN = (0.5, 1.2)
# Frequencies of each amplitude where amplitudes are told one by one; motions where they are told by ranges.
FREQUENCIES, MOTIONS = 15, 60
MOST_AMPLITUDES = 12
# What a plate can be set to: a tenth of a degree or millimetre, a degree of phase.
STEPS = (math.radians(0.1), 1e-4, 1e-4, math.radians(1))

Span = tuple[float, float]


@dataclass(frozen=True)
class Reach:
    """What a plate can make: of each number single values and ranges (low, high), SI.

    Attributes
    ----------
    angle, stroke, phase : tuple of (low, high)
        A_p (rad), B_p (m), and the phase of the stroke before the turning (rad).
    height : tuple of (low, high)
        Of the plate's surface above its axis, m, as `Condition.height` counts it.
    frequency : (low, high)
        Hz.
    motion : PlateMotion
        What else the plate does.
    machine : Machine, optional
        What drives it, and cannot do more than it can.
    """

    angle: tuple[Span, ...]
    stroke: tuple[Span, ...]
    height: tuple[Span, ...]
    phase: tuple[Span, ...]
    frequency: Span
    motion: PlateMotion
    machine: Machine | None = None

    def allows(self, condition: Condition) -> bool:
        """Whether the plate can make a motion."""
        for name in ("angle", "stroke", "height", "phase"):
            value = getattr(condition, name)
            if not any(low - 1e-9 <= value <= high + 1e-9 for low, high in getattr(self, name)):
                return False
        low, high = self.frequency
        if not low - 1e-9 <= condition.frequency <= high + 1e-9:
            return False
        return self.machine is None or not excess(needs(condition.motion(self.motion), self.machine), self.machine)

    def grid(self, seed: int = 0) -> tuple[Condition, ...]:
        """Motions to choose from: a row of frequencies for each amplitude, or spread over the ranges if there are any.

        Raises
        ------
        InputError
            When the plate can make none of them.
        """
        told = [self.angle, self.stroke, self.height, self.phase]
        singles = all(low == high for spans in told for low, high in spans)
        each = list(itertools.product(*told)) if singles else []
        if singles and len(each) <= MOST_AMPLITUDES:
            rows = [[span[0] for span in spans] for spans in each]
            motions = [c for row in rows for c in self._row(row)]
        else:
            motions = self._spread(told, seed)
        motions = [c for c in dict.fromkeys(motions) if self.allows(c)]
        if not motions:
            raise InputError("candidate_frequency", "no motion that the plate can make", "a wider range, or a machine "
                             "that can do more", '"10:30 Hz"')  # fmt: skip
        return tuple(motions)

    def _row(self, values: Sequence[float]) -> list[Condition]:
        """Frequencies of one amplitude."""
        return [self._motion(values, share) for share in np.linspace(0, 1, FREQUENCIES)]

    def _spread(self, told: Sequence[tuple[Span, ...]], seed: int) -> list[Condition]:
        """Motions spread evenly over the values and ranges (a Latin hypercube), at numbers that one can set."""
        shares = stratified(MOTIONS, len(told) + 1, np.random.default_rng(seed))
        return [
            self._motion([_at(spans, u, step) for spans, u, step in zip(told, share, STEPS, strict=False)], share[-1])
            for share in shares
        ]

    def _motion(self, values: Sequence[float], share: float) -> Condition:
        """Motion of an amplitude at a share of its frequencies."""
        angle, stroke, height, phase = values
        low, high = self._frequencies(angle)
        frequency = min(max(round(low + (high - low) * float(share), 2), low), high)
        return Condition(angle, stroke, frequency, height, phase)

    def _frequencies(self, angle: float) -> Span:
        """Frequencies worth a try at an angular amplitude, as far as the plate makes them, Hz."""
        usual = math.sqrt(USUAL_ACCELERATION / angle) / math.tau
        low, high = max(SPAN[0] * usual, self.frequency[0]), min(SPAN[1] * usual, self.frequency[1])
        return (low, high) if low < high else (max(self.frequency[0], 0.5 * self.frequency[1]), self.frequency[1])


def alike(one: Condition, other: Condition) -> bool:
    """Whether two motions differ by less than one can set."""
    pairs = zip(_set(one), _set(other), (*STEPS, FREQUENCY_STEP), strict=True)
    return all(abs(a - b) < 0.5 * step for a, b, step in pairs)


def _set(c: Condition) -> tuple[float, ...]:
    return c.angle, c.stroke, c.height, c.phase, c.frequency


def _at(spans: tuple[Span, ...], u: float, step: float) -> float:
    """Value at a share of spans, each of which counts alike, to a step that one can set."""
    place = min(int(u * len(spans)), len(spans) - 1)
    low, high = spans[place]
    value = low + (high - low) * (u * len(spans) - place)
    return min(max(round(value / step) * step, low), high)


def reach_of(
    conditions: Sequence[Condition],
    motion: PlateMotion,
    *,
    angle: Sequence[Span] = (),
    stroke: Sequence[Span] = (),
    height: Sequence[Span] = (),
    phase: Sequence[Span] = (),
    frequency: Span | None = None,
    machine: Machine | None = None,
) -> Reach:
    """What a plate can make, as far as it is told; of the rest what it made in the measurement.

    Parameters
    ----------
    conditions : sequence of Condition
        What was measured: frequencies up to the highest are taken as possible.
    motion : PlateMotion
        Whose height the heights are told against.
    angle, stroke, height, phase : sequences of (low, high)
        See `Reach`; heights absolute.
    frequency : (low, high), optional
    machine : Machine, optional
    """
    return Reach(
        angle=tuple(angle) or _made([c.angle for c in conditions]),
        stroke=tuple(stroke) or _made([c.stroke for c in conditions]),
        height=tuple((a - motion.height, b - motion.height) for a, b in height)
        or _made([c.height for c in conditions]),
        phase=tuple(phase) or _made([c.phase for c in conditions]),
        frequency=frequency or (0.0, max(c.frequency for c in conditions)),
        motion=motion,
        machine=machine,
    )


def _made(values: Sequence[float]) -> tuple[Span, ...]:
    """What was made: each value where they are few, else all between them."""
    different = sorted(set(values))
    return tuple((v, v) for v in different) if len(different) <= 3 else ((different[0], different[-1]),)
