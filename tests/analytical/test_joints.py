"""Joints alone: ring-down, the two-link cantilever, strips and plates against beam and plate theory."""

from __future__ import annotations

import math

import numpy as np
import pytest
from bench import flat, observed_order, run, strip

from plategait.model.modes import transverse_matrix
from plategait.model.outline import Disk
from plategait.model.sheet import Sheet
from plategait.theory.vibration import cantilever_frequencies, free_disk_frequency


def test_one_joint_rings_down_as_a_damped_oscillator():
    # Three nodes, one joint: with w = (1, −2, 1) the joint turns by 6 w/l and m w'' = −(k/l²) 6 w − (c/l²) 6 w'.
    sheet = strip(3, bending_stiffness=1.56e-4, bending_damping=2e-7)
    per_mass = 6 / (sheet.pitch**2 * sheet.node_mass)
    omega2, decay = sheet.bending_stiffness * per_mass, sheet.bending_damping * per_mass / 2
    omega = math.sqrt(omega2 - decay**2)
    shape = np.array([1.0, -2.0, 1.0])
    duration, start = 0.03, 1e-5
    exact = (
        start * math.exp(-decay * duration) * (math.cos(omega * duration) + decay / omega * math.sin(omega * duration))
    )
    steps = np.array([4e-5, 2e-5, 1e-5])
    errors = []
    for dt in steps:
        positions = flat(sheet, 1.0)
        positions[:, 2] += start * shape
        recording = run(sheet, duration=duration, dt=dt, gravity=0.0, positions=positions)
        errors.append((recording.positions[:, 2] - 1.0) @ shape / 6 - exact)
    assert abs(errors[-1]) < 0.02 * start
    assert 0.9 < observed_order(errors, steps) < 1.1  # semi-implicit Euler: phase and decay are first order


def test_the_two_link_cantilever_has_its_two_frequencies():
    # Two nodes held, two free, hinges at the second and third: K = k_b/l² [[5, −2], [−2, 1]], ω = (√2 ± 1) √(k_b/m l²).
    sheet = strip(4)
    held = np.array([True, True, False, False])
    unit = math.sqrt(sheet.bending_stiffness / (sheet.node_mass * sheet.pitch**2))
    for factor, shape in ((math.sqrt(2) - 1, (1.0, 1 + math.sqrt(2))), (math.sqrt(2) + 1, (1.0, 1 - math.sqrt(2)))):
        period = 2 * math.pi / (factor * unit)
        positions = flat(sheet, 1.0)
        positions[2:, 2] += 1e-5 * np.array(shape)
        # After a whole number of periods it is back; at a quarter more it is flat.
        for periods, expected in ((3.0, 1.0), (3.25, 0.0)):
            recording = run(
                sheet, duration=periods * period, dt=period / 20_000, gravity=0.0, positions=positions, held=held
            )
            np.testing.assert_allclose((recording.positions[2:, 2] - 1.0) / 1e-5, expected * np.array(shape), atol=2e-3)
            assert np.all(recording.positions[:2, 2] == 1.0), "held nodes stay"


def test_a_joint_holds_right_through_a_fold():
    # Moment against angle at any angle: the force on the end node of a bent strip is k_b θ/l, whatever θ.
    sheet = strip(3)
    for degrees in (1, 30, 90, 150, 175):
        theta = math.radians(degrees)
        pitch, dt = sheet.pitch, 1e-9
        positions = [[-pitch, 0, 1], [0, 0, 1], [pitch * math.cos(theta), 0, 1 + pitch * math.sin(theta)]]
        recording = run(sheet, duration=dt, dt=dt, gravity=0.0, positions=positions)
        force = np.linalg.norm(recording.velocities[2]) * sheet.node_mass / dt
        assert force == pytest.approx(
            sheet.bending_stiffness * theta / pitch, rel=1e-6
        )  # the arc-cosine's polynomial: 1.3e-8


@pytest.mark.parametrize("ratio", [0.25, 1.0, 8.0])
def test_a_sheared_patch_stores_and_resists_what_its_diagonals_do(ratio):
    # x += γ y: edges along x keep their length l, those along y become l √(1 + γ²), diagonals l √(1 + (1 ± γ)²).
    sheet, shear, dt = strip(5, 5, shear_ratio=ratio), 0.1, 1e-9
    k, edge = sheet.axial_stiffness * sheet.pitch**2, math.hypot(1, shear)
    diagonals = [(s, math.hypot(1, 1 + s * shear)) for s in (-1, 1)]
    edges, cells = 5 * 4, 4 * 4
    energy = (
        edges * k * (edge - 1) ** 2 / 2 + cells * ratio * k * sum((d - math.sqrt(2)) ** 2 for _, d in diagonals) / 2
    )
    stretching = (edge - 1) * shear / edge
    shearing = sum((d - math.sqrt(2)) * s * (1 + s * shear) / d for s, d in diagonals)
    rest = flat(sheet, 1.0)
    positions = rest + shear * np.outer(rest[:, 1], [1, 0, 0])
    recording = run(sheet, duration=dt, dt=dt, gravity=0.0, positions=positions)
    assert recording["axial_energy"][0] == pytest.approx(energy, rel=1e-9)
    # What the forces do along the shear is the energy's slope: Σ F_x y = −dE/dγ. A step turns by ω dt = 1e-5 at most.
    forces = recording.velocities * sheet.node_mass / dt
    slope = edges * k * stretching + cells * ratio * k * shearing
    assert forces[:, 0] @ rest[:, 1] == pytest.approx(-slope, rel=1e-7)


@pytest.mark.parametrize("ratio", [0.25, 1.0, 8.0])
def test_a_cell_rings_down_in_shear_by_its_diagonals(ratio):
    # u = γ/2 (y, x) stretches the two diagonals of four nodes by ±γ l/√2 and no edge: γ'' = −2 (r k_c γ + c_c γ')/m.
    sheet, start = strip(2, 2, shear_ratio=ratio, axial_damping=0.05), 1e-5
    omega2 = 2 * ratio * sheet.axial_stiffness / sheet.node_mass
    decay = sheet.axial_damping / sheet.node_mass
    omega = math.sqrt(omega2 - decay**2)
    rest = flat(sheet, 1.0)
    shape = np.column_stack([rest[:, 1], rest[:, 0], np.zeros(4)]) / 2
    for quarters in (3, 4):
        duration = quarters * math.pi / 2 / omega
        recording = run(sheet, duration=duration, dt=duration / 20_000, gravity=0.0, positions=rest + start * shape)
        expected = math.exp(-decay * duration) * (
            math.cos(omega * duration) + decay / omega * math.sin(omega * duration)
        )
        # First order in a step of ω dt = 3e-4, with the strain of 1e-5 itself.
        left = (recording.positions - rest) * shape
        assert left.sum() / (shape**2).sum() == pytest.approx(start * expected, abs=1e-3 * start)


def test_joints_carry_no_net_force_or_moment():
    # Any motion whatever: momentum and angular momentum of a free sheet stay, to round-off.
    rng = np.random.default_rng(7)
    sheet = strip(4, 3, bending_damping=2.4e-7, torsion_stiffness=1e-4, torsion_damping=1e-7, shear_ratio=4)
    positions = flat(sheet, 1.0) + rng.normal(0, 5e-4, (12, 3))
    velocities = rng.normal(0, 0.1, (12, 3))
    recording = run(sheet, duration=0.05, dt=5e-5, gravity=0.0, positions=positions, velocities=velocities)
    before = velocities.sum(axis=0), np.cross(positions, velocities).sum(axis=0)
    after = recording.velocities.sum(axis=0), np.cross(recording.positions, recording.velocities).sum(axis=0)
    np.testing.assert_allclose(after[0], before[0], atol=1e-12)
    # Semi-implicit Euler keeps angular momentum exactly when the forces are central at the old positions.
    np.testing.assert_allclose(after[1], before[1], atol=1e-12)


@pytest.mark.linear_algebra
def test_a_clamped_strip_becomes_an_euler_bernoulli_beam():
    # A joint stands for the beam half a pitch to either side of it. With two nodes held, the first joint's beam begins
    # midway between them: n free nodes are a cantilever of n + 1 pitches.
    length, area_mass, D = 0.08, 2.6, 1.56e-4
    exact = cantilever_frequencies(D, area_mass, length)[:2]
    pitches = np.array([0.01, 0.005, 0.0025, 0.00125])
    errors = []
    for pitch in pitches:
        sheet = strip(round(length / pitch) + 1, pitch=pitch)
        matrix = transverse_matrix(sheet.lattice, pitch, D, 0.0)[2:, 2:] / (area_mass * pitch**2)
        errors.append(np.sqrt(np.linalg.eigvalsh(matrix)[:2]) / exact - 1)
    errors = np.array(errors)
    assert np.abs(errors[-1]).max() < 2e-3
    for mode in range(2):
        assert observed_order(errors[:, mode], pitches) > 1.7  # second order, as central differences are


def test_a_free_isotropic_disk_becomes_a_plate():
    # k_t = k_b makes the lattice an isotropic plate of Poisson ratio zero, D = k_b. The staircase edge is first order.
    D, area_mass, radius = 1.56e-4, 2.6, 0.04
    exact = {
        name: free_disk_frequency(n, s, radius=radius, plate_stiffness=D, mass_per_area=area_mass)
        for name, n, s in (("saddle", 2, 0), ("dish", 0, 1))
    }
    errors = []
    for pitch in (0.005, 0.0025):
        sheet = Sheet(
            outline=Disk(radius=radius), pitch=pitch, mass=area_mass * math.pi * radius**2,
            bending_stiffness=D, torsion_stiffness=D, axial_stiffness=790.0,
        )  # fmt: skip
        modes = sheet.free_modes
        assert modes.saddle.omega == pytest.approx(modes.twist.omega, rel=0.06), (
            "isotropy: the pair is one mode turned by 45 deg"
        )
        errors.append([getattr(modes, name).omega / value - 1 for name, value in exact.items()])
    errors = np.abs(errors)
    assert errors[1].max() < 0.04
    assert (errors[1] < errors[0]).all()


@pytest.mark.linear_algebra
def test_the_engine_rings_at_the_frequencies_of_the_modes():
    # Let go in the shape of its dish mode, the cheese comes back after one period: engine and eigenproblem agree.
    sheet = Sheet(
        outline=Disk(radius=0.04),
        mass=13.6e-3,
        bending_stiffness=1.56e-4,
        axial_stiffness=790.0,
        torsion_stiffness=5e-5,
    )
    for mode in (sheet.free_modes.dish, sheet.free_modes.saddle, sheet.free_modes.twist):
        period = 2 * math.pi / mode.omega
        for periods, expected in ((1.0, 1.0), (1.25, 0.0), (1.5, -1.0)):
            positions = flat(sheet, 1.0)
            positions[:, 2] += 1e-5 * mode.shape
            recording = run(sheet, duration=periods * period, dt=period / 5000, gravity=0.0, positions=positions)
            # First-order phase error of the step: 2π · 1.5 · π/5000 = 0.006.
            np.testing.assert_allclose((recording.positions[:, 2] - 1.0) / 1e-5, expected * mode.shape, atol=0.01)
