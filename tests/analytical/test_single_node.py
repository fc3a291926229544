"""One node on a still plate: how it settles, how far it slides, how it bounces."""

from __future__ import annotations

import math

import numpy as np
import pytest
from bench import flat, observed_order, run, strip

from plategait.model.contact import Contact, Friction

NODE = strip(1)


def test_a_node_settles_at_the_depth_that_carries_it():
    # k a^2.2 = m g with a in mm. The contact is overdamped with a time constant of 30 ms: 1 s is 30 of them, and the
    # rest is round-off of the fifth root.
    recording = run(NODE, duration=1.0, dt=1e-4, positions=flat(NODE))
    depth = 1e-3 * (2.6e-4 * 9.81 / 11.86) ** (1 / 2.2)
    assert recording.positions[0, 2] == pytest.approx(-depth, rel=1e-6)


def test_a_sliding_node_stops_where_coulomb_says():
    # From v0 down to V at mu_k g, from V to rest at mu_s g; semi-implicit Euler is first order in the step.
    v0, V, mu_s, mu_k, g = 1.0, 0.1, 0.75, 0.40, 9.81
    exact = (v0**2 - V**2) / (2 * mu_k * g) + V**2 / (2 * mu_s * g)
    depth = Contact().static_depth(NODE.node_mass, NODE.pitch, g)
    steps = np.array([4e-4, 2e-4, 1e-4, 5e-5]) / 4
    errors = []
    for dt in steps:
        recording = run(NODE, duration=0.5, dt=dt, positions=flat(NODE, -depth), velocities=[[v0, 0, 0]])
        errors.append(recording.positions[0, 0] - exact)
        assert np.abs(recording.velocities[0]).max() < 1e-9, "friction must stop it and never push it back"
    assert abs(errors[-1]) / exact < 2e-4
    assert 0.7 < observed_order(errors, steps) < 1.5


def test_both_friction_laws_agree_above_their_transition():
    # Above V_d = 10 V both laws are mu_k: the same deceleration while the node is faster than that.
    depth = Contact().static_depth(NODE.node_mass, NODE.pitch, 9.81)
    speeds = []
    for law in ("thesis", "adams"):
        friction = Friction(law=law, transition_speed=0.01)
        recording = run(
            NODE, duration=0.1, dt=1e-4, positions=flat(NODE, -depth), velocities=[[1.0, 0, 0]], friction=friction
        )
        speeds.append(recording.velocities[0, 0])
    assert speeds[0] == pytest.approx(1.0 - 0.40 * 9.81 * 0.1, rel=1e-4)
    assert speeds[1] == pytest.approx(speeds[0], rel=1e-9)


def test_an_undamped_bounce_keeps_its_speed_and_lasts_as_long_as_the_power_law_says():
    # For f = k a^p the contact lasts 2 a_max/v0 √π Γ(1+1/(p+1))/Γ(1/2+1/(p+1)), and the speed comes back whole.
    # The contact damping is taken linearly implicit, which costs speed in proportion to the step.
    p, v0, m = 2.2, 0.2, NODE.node_mass
    k = 11.86 * 1000**2.2
    deepest = ((p + 1) * m * v0**2 / (2 * k)) ** (1 / (p + 1))
    lasts = 2 * deepest / v0 * math.sqrt(math.pi) * math.gamma(1 + 1 / (p + 1)) / math.gamma(0.5 + 1 / (p + 1))
    steps = np.array([4e-6, 2e-6, 1e-6, 5e-7])
    lost, depths = [], []
    for dt in steps:
        recording = run(
            NODE, duration=2 * lasts, dt=dt, gravity=0.0, positions=flat(NODE), velocities=[[0, 0, -v0]],
            contact=Contact(damping=0.0), snapshots=1,
        )  # fmt: skip
        lost.append(1 - recording.velocities[0, 2] / v0)
        depths.append(-float(recording.snapshots[:, 0, 2].min()))
    assert 0 < lost[-1] < 0.01
    assert 0.9 < observed_order(lost, steps) < 1.1
    assert depths[-1] == pytest.approx(deepest, rel=0.01)  # sampled every other step, and damped a little
    touching = recording.snapshots[:, 0, 2] < 0
    sampled = recording.snapshot_time[1] - recording.snapshot_time[0]
    assert touching.sum() * sampled == pytest.approx(lasts, rel=0.02)


def test_the_damped_contact_of_table_4_1_does_not_bounce():
    recording = run(NODE, duration=0.2, dt=1e-4, positions=flat(NODE, 1e-3), snapshots=1)
    landed = recording.snapshots[:, 0, 2] < 0
    assert landed[-1]
    assert landed[np.argmax(landed) :].all(), "c_contact is far above critical: once down it stays down"


def test_contact_never_pulls():
    # A node thrown upwards from rest depth leaves at once, on the parabola of free flight.
    depth = Contact().static_depth(NODE.node_mass, NODE.pitch, 9.81)
    recording = run(NODE, duration=0.02, dt=1e-5, positions=flat(NODE, -depth), velocities=[[0, 0, 0.5]])
    # The damper may not hold it back; the spring adds what it held, k a^3.2/3.2 = 1.8e-8 J of 3.3e-5 J.
    assert recording.velocities[0, 2] == pytest.approx(0.5 - 9.81 * 0.02, rel=2e-3)
