"""The two links of Fig. 3.5(a), against conservation of energy, the linearised system and (3.3)."""

import numpy as np
import pytest
from scipy import linalg

from plategait.theory.two_links import (
    Joints,
    Strip,
    angles_of_markers,
    between,
    driven_rate,
    energy,
    fastest_rates,
    integrate,
    joint_moment,
    two_link_rate,
)

STRIP = Strip()
K_B, C_B = 1.558e-4, 2.424e-7  # Table 4.1 in N m/rad and N m s/rad
# Of the straight strip: point masses in the middle of each link, in units of m l².
MASS = np.array([[2.5, 0.75], [0.75, 0.25]])


def solve(joints, start, end, steps, *, centripetal=True):
    rate = two_link_rate(STRIP, joints, centripetal=centripetal)
    return integrate(rate, np.array(start, dtype=float)[:, None], end / steps, steps)[:, :, 0]


def test_undamped_links_keep_their_energy():
    joints = Joints(K_B, 0.0, 2 * K_B, 0.0)
    drifts = []
    for steps in (1000, 2000):
        energies = energy(STRIP, joints, solve(joints, (0.8, -0.9, 20.0, -30.0), 0.2, steps))
        drifts.append(np.ptp(energies) / (0.5 * K_B))
    # Global error of order four: half the step, a sixteenth of the drift; 10 allows for the terms of higher order.
    assert drifts[1] < drifts[0] / 10
    # (ω step)^4 of the fast mode, about 600 rad/s at 1e-4 s: 1.3e-5, with a margin for the large angles.
    assert drifts[1] < 1e-4


def test_the_energy_shows_the_term_that_3_3_drops():
    joints = Joints(K_B, 0.0)
    start = (0.8, -0.9, 20.0, -30.0)
    whole, dropped = (
        np.ptp(energy(STRIP, joints, solve(joints, start, 0.2, 2000, centripetal=centripetal)))
        for centripetal in (True, False)
    )
    # The term does work that no energy accounts for: orders of magnitude above the drift of the integration.
    assert dropped > 1000 * whole


def test_damping_only_takes_energy():
    joints = Joints(K_B, C_B)
    energies = energy(STRIP, joints, solve(joints, (0.5, 0.5, 0.0, 0.0), 0.2, 4000))
    assert np.all(np.diff(energies) < 1e-12 * K_B)  # rounding of a sum of terms of the size of k_b


@pytest.mark.parametrize("wall", [1.0, 2.0])
def test_small_swings_have_the_frequencies_of_the_linearised_links(wall):
    weightless, joints = Strip(gravity=0.0), Joints(K_B, 0.0, wall * K_B, 0.0)
    squares, shapes = linalg.eigh(np.diag([wall * K_B, K_B]), STRIP.inertia * MASS)
    for omega, shape in zip(np.sqrt(squares), shapes.T, strict=True):
        period, small = 2 * np.pi / omega, 1e-4 * shape / np.abs(shape).max()
        states = integrate(two_link_rate(weightless, joints), np.r_[small, 0, 0][:, None], period / 4000, 4000)
        # Terms of second order in the angle are left out: 1e-4 of it. A wrong period would not bring it back.
        np.testing.assert_allclose(states[-1, :2, 0], small, atol=1e-4 * 1e-4 * 10)
    assert fastest_rates(weightless, joints)[0] == pytest.approx(np.sqrt(squares[1]))


def test_links_at_rest_hang_where_statics_puts_them():
    joints = Joints(K_B, 10 * C_B)
    phi_1, phi_2 = solve(joints, (0.0, 0.0, 0.0, 0.0), 1.5, 5000)[-1, :2]
    assert K_B * phi_2 == pytest.approx(
        0.5 * STRIP.weight * np.cos(phi_1 + phi_2), rel=1e-6
    )  # the slow mode, 16 /s, settles to e^-24
    assert K_B * phi_1 == pytest.approx(STRIP.weight * (1.5 * np.cos(phi_1) + 0.5 * np.cos(phi_1 + phi_2)), rel=1e-6)


@pytest.mark.parametrize("centripetal", [True, False])
def test_the_motion_satisfies_3_3(centripetal):
    joints = Joints(K_B, C_B, 3 * K_B, C_B)
    rate = two_link_rate(STRIP, joints, centripetal=centripetal)
    for state in np.random.default_rng(1).normal(size=(20, 4)) * (1.0, 1.0, 30.0, 30.0):
        phi_1, phi_2, v_1, v_2 = state
        a_1, a_2 = rate(0, state)[2:]
        m, g, length = STRIP.mass, STRIP.gravity, STRIP.length
        # (3.3) as printed.
        printed = (
            m * g * length * np.cos(phi_1 + phi_2) / 2
            - m * length**2 * a_2 / 4
            - (1 + 2 * np.cos(phi_2)) * m * length**2 * a_1 / 4
        )
        dropped = m * length**2 * np.sin(phi_2) * v_1**2 / 2
        size = abs(K_B * phi_2) + abs(C_B * v_2) + m * length**2 * (abs(a_1) + abs(a_2))
        moment = joint_moment(STRIP, (phi_1, phi_2), (a_1, a_2), v_1, centripetal=centripetal)
        # Rounding of a few terms of this size.
        assert moment == pytest.approx(printed - centripetal * dropped, abs=1e-13 * size)
        assert C_B * v_2 + K_B * phi_2 == pytest.approx(float(moment), abs=1e-12 * size)


def test_joint_2_driven_by_link_1_moves_as_in_the_whole():
    joints, steps, step = Joints(K_B, C_B), 2000, 1e-4
    rate = two_link_rate(STRIP, joints)
    whole = integrate(rate, np.zeros((4, 1)), step / 2, 2 * steps)
    acceleration = np.array([rate(0, state)[2] for state in whole])
    driven = driven_rate(STRIP, joints, whole[:, 0], whole[:, 2], acceleration)
    alone = integrate(driven, np.zeros((2, 1)), step, steps)
    # Both integrations are off by some (step × 490 rad/s)^4 / 120 = 5e-8 of the motion per radian swung.
    np.testing.assert_allclose(alone[:, 0], whole[::2, 1], atol=1e-6)


def test_between_steps_the_solution_is_as_good_as_at_them():
    omega = 100.0
    states = integrate(lambda _, s: np.stack([s[1], -(omega**2) * s[0]]), np.array([[1.0], [0.0]]), 1e-3, 100)
    time = np.linspace(0, 0.1, 777)
    # Cubic through values and slopes: (ω step)^4/384 = 2.6e-7; the integration: (ω step)^4/120 per radian, 10 of them.
    np.testing.assert_allclose(between(states, 1e-3, time)[:, 0, 0], np.cos(omega * time), atol=2e-5)


def test_markers_give_the_angles_they_were_made_from():
    phi_1, phi_2 = np.random.default_rng(2).uniform(-1.2, 1.2, (2, 50))
    links = np.stack([np.stack([np.cos(a), -np.sin(a)], axis=1) for a in (phi_1, phi_1 + phi_2)], axis=1)
    markers = np.concatenate([np.zeros((50, 1, 2)), np.cumsum(links, axis=1)], axis=1) * 37 + (5, 7)
    for mirrored in (1, -1):
        angles = angles_of_markers(markers * (mirrored, 1))
        np.testing.assert_allclose(angles, (phi_1, phi_2), atol=1e-12)  # rounding
