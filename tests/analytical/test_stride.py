"""Strides against closed forms: energies that are exchanged, legs in turn, a rigid half that lifts."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plategait.errors import InputError
from plategait.simulation.stride import leg_phase, positive_work, recovery
from plategait.theory.rigid import half_lift_limit

TIME = np.linspace(0, 3, 3001)[1:]


def test_a_pendulum_gives_all_back_and_two_that_rise_together_nothing():
    kinetic = np.sin(math.tau * TIME) ** 2
    assert recovery(kinetic, 2 - kinetic) == pytest.approx(1.0)
    assert recovery(kinetic, 3 * kinetic) == pytest.approx(0.0, abs=1e-12)
    # Two sines of equal swing, a quarter apart: their sum swings √2 times as far as one, where both swing twice.
    assert recovery(np.sin(math.tau * TIME), np.cos(math.tau * TIME)) == pytest.approx(1 - math.sqrt(0.5), abs=1e-3)
    assert math.isnan(recovery(np.ones(5), np.ones(5)))
    # Up by 1 each period.
    assert positive_work(0.5 * np.sin(math.tau * TIME)) == pytest.approx(3.0, abs=0.5)


@pytest.mark.parametrize("lag", [0.1, 0.5, 0.9])
def test_the_phase_of_the_legs_is_how_far_the_right_one_lags(lag):
    def leg(begin: float) -> np.ndarray:
        return (((TIME - begin) % 1.0) < 0.6).astype(float)

    # Samples are a thousandth of a period apart.
    assert leg_phase(TIME, leg(0.2), leg(0.2 + lag), 1.0) == pytest.approx(lag, abs=2e-3)


def test_legs_that_never_lift_have_no_phase():
    assert math.isnan(leg_phase(TIME, np.ones_like(TIME), np.ones_like(TIME), 1.0))


def test_half_of_a_rigid_disk_lifts_at_three_quarters_of_pi():
    radius = 0.04
    mean_distance = 4 * radius / (3 * math.pi)
    assert radius * half_lift_limit(mean_distance) / 9.81 == pytest.approx(0.75 * math.pi)
    # The same by moments, for a bar of length 2 a across the axis: pressure p y over half of it carries the weight,
    # and its moment turns the inertia m a²/3.
    a, mass = 0.03, 0.01
    slope = mass * 9.81 / (a**2 / 2)
    assert half_lift_limit(a / 2) == pytest.approx(slope * a**3 / 3 / (mass * a**2 / 3))
    with pytest.raises(InputError, match="mean_distance"):
        half_lift_limit(0.0)
