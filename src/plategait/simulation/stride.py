"""What a stride is: duty of the legs and the phase between them, exchange of energies, cost, Froude number.

All take plain arrays, so that a pendulum and a spring in closed form can be held against them. The quantities are those
of legged locomotion: Alexander, *Principles of Animal Locomotion* (2003); the recovery is Cavagna's.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from plategait.arrays import Array, Flags
from plategait.engine.recording import Recording
from plategait.model.scenario import Scenario
from plategait.simulation import observables

ROW: tuple[str, ...] = (
    "duty", "flight", "leg_phase", "pendulum", "spring", "bent", "spin_rate", "turn", "cost", "froude", "failed"
)  # fmt: skip
"""What `stride_row` measures."""


def positive_work(energy: Array) -> float:
    """Sum of an energy's increases over a record, J."""
    rise = np.diff(energy)
    return float(rise[rise > 0].sum())


def recovery(one: Array, other: Array) -> float:
    """Share of the work on two energies that they give each other: 1 for a pendulum, 0 for two that rise together.

    Cavagna's percentage recovery over 100: (W₁ + W₂ − W₁₊₂)/(W₁ + W₂), with W the sum of increases.

    Parameters
    ----------
    one, other : (n,) arrays
        Energies at the same times, J.
    """
    apart = positive_work(one) + positive_work(other)
    return 1 - positive_work(one + other) / apart if apart > 0 else math.nan


def leg_phase(time: Array, left: Array, right: Array, period: float) -> float:
    """How far the right leg's contact lags the left one's, in periods from 0 to 1: 0.5 for a biped that walks or runs.

    By the first harmonic of both; NaN where one leg never lifts.

    Parameters
    ----------
    time : (n,) array
        Over whole periods, s.
    left, right : (n,) arrays
        Share of the time in which each leg touches.
    period : float
        s.
    """
    turning = np.exp(-2j * math.pi * time / period)
    both = [complex(np.mean((leg - leg.mean()) * turning)) for leg in (left, right)]
    if min(abs(harmonic) for harmonic in both) < 1e-3:
        return math.nan
    return float(-np.angle(both[1] / both[0]) / math.tau) % 1.0


def stride_row(scenario: Scenario, recording: Recording) -> dict[str, float]:
    """Numbers of a run's strides in the mean over whole plate periods, from the transient to the end or the failure.

    Returns
    -------
    dict
        ``duty`` (the lesser of the legs' shares of contact in a period, median over periods), ``flight``,
        ``leg_phase``, ``pendulum`` (recovery between kinetic and potential energy), ``spring`` (between both and the
        bending energy), ``bent`` (bending's share of the work on all three), ``spin_rate``, rad/s, ``turn`` per
        period, rad, ``cost`` of transport (mean power over weight and the rim's speed), ``froude`` (speed of the rim
        squared over g and radius), ``failed``, 0 or 1. NaN where fewer than three periods are sound.
    """
    period, time = scenario.motion.period, recording["time"]
    failure = observables.first_failure(recording.channels, period, scenario.slip_limit, None, recording.diverged)
    end = float(time[-1]) if failure is None else failure.sound_until
    periods = max(0, math.floor((end - scenario.measured_from) / period + 1e-6))
    row = dict.fromkeys(ROW, math.nan) | {"failed": float(failure is not None)}
    if periods < 3:
        return row
    start = end - periods * period
    inside = (time > start) & (time <= end)
    angle = observables.rotation(recording["spin_cross"], recording["spin_dot"])
    spin = observables.spin_rate(time, angle, period, scenario.measured_from, end).rate
    left, right, flight = (
        observables.period_means(time, recording[name], period, start, end)
        for name in ("left_contact", "right_contact", "flight")
    )
    power = float(recording["plate_work"][inside].sum()) / (end - start)
    return row | _energies(recording.channels, inside) | _speed(scenario, spin, power) | {
        "duty": float(np.median(np.minimum(left, right))),
        "flight": float(np.median(flight)),
        "leg_phase": leg_phase(time[inside], recording["left_contact"][inside], recording["right_contact"][inside],
                               period),
    }  # fmt: skip


def _energies(channels: Mapping[str, Array], inside: Flags) -> dict[str, float]:
    kinetic, height, bending = (channels[f"{n}_energy"][inside] for n in ("kinetic", "gravity", "bending"))
    works = [positive_work(energy) for energy in (kinetic, height, bending)]
    return {
        "pendulum": recovery(kinetic, height),
        "spring": recovery(kinetic + height, bending),
        "bent": works[2] / sum(works) if sum(works) > 0 else math.nan,
    }


def _speed(scenario: Scenario, spin: float, power: float) -> dict[str, float]:
    """What goes with the speed of the rim; its radius is half of the sheet's longest side."""
    radius = max(scenario.sheet.outline.size()) / 2
    weight, speed = scenario.sheet.mass * scenario.gravity, abs(spin) * radius
    return {
        "spin_rate": spin,
        "turn": spin * scenario.motion.period,
        "cost": power / (weight * speed) if speed > 0 else math.nan,
        "froude": speed**2 / (scenario.gravity * radius),
    }
