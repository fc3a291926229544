"""Sheets of a material against plate theory: bending, twist, plane, mass and damping; what Poisson's ratio costs."""

from __future__ import annotations

import functools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.polynomial import legendre
from scipy import linalg

from plategait.model.material import Material
from plategait.model.modes import transverse_matrix
from plategait.model.outline import Disk, Polygon, Rectangle
from plategait.model.sheet import Sheet
from plategait.theory.vibration import cantilever_frequencies, free_disk_frequency

pytestmark = pytest.mark.linear_algebra

E, H, RHO = 0.5e6, 1e-3, 1100.0
RADIUS = SIDE = 0.04


def plate(outline, pitch, poisson=0.0, **more):
    return Sheet.from_material(outline, E, H, RHO, poisson_ratio=poisson, pitch=pitch, **more)


def stiffness(poisson):
    return E * H**3 / (12 * (1 - poisson**2))


@functools.cache
def free_square(poisson, n=12):
    """ω a² √(ρh/D) of twist, saddle and dish of a free square by the Rayleigh-Ritz method with Legendre polynomials."""
    node, weight = legendre.leggauss(2 * n)
    values = [np.array([legendre.legval(node, legendre.legder(c, d)) * 2**d for c in np.eye(n)]) for d in range(3)]

    def integral(a, b):
        return (values[a] * weight / 2) @ values[b].T

    i00, i11, i22, i20 = integral(0, 0), integral(1, 1), integral(2, 2), integral(2, 0)
    coupled = np.kron(i20, i20.T) + np.kron(i20.T, i20)
    bending = np.kron(i22, i00) + np.kron(i00, i22) + poisson * coupled + 2 * (1 - poisson) * np.kron(i11, i11)
    return np.sqrt(linalg.eigh(bending, np.kron(i00, i00), eigvals_only=True)[3:6])


def test_the_ritz_method_gives_the_published_square():
    # K. M. Liew, Y. Xiang and S. Kitipornchai, Computers & Structures 49 (1993) 1: ν = 0.3, in the same form.
    assert free_square(0.3) == pytest.approx([13.468, 19.596, 24.270], abs=1e-3)


def square_errors(poisson, across):
    modes = plate(Rectangle(length=SIDE, width=SIDE), SIDE / across, poisson).free_modes
    scale = math.sqrt(stiffness(poisson) / (RHO * H)) / SIDE**2
    exact = free_square(poisson) * scale
    return np.array([modes.twist.omega, modes.saddle.omega, modes.dish.omega]) / exact - 1


def test_a_free_square_without_poisson_ratio_becomes_a_plate():
    errors = np.array([square_errors(0.0, across) for across in (8, 16, 32)])
    # Central differences: second order where lines bend. Twist lacks half a cell along the edge: first order.
    assert (np.abs(errors[:, 1:]) < np.array([[0.01], [0.0025], [0.001]])).all()
    assert (np.abs(errors[:, 0]) < [0.08, 0.04, 0.02]).all()


@pytest.mark.parametrize(("poisson", "twist", "saddle", "dish"), [(0.3, -0.02, 0.14, -0.08), (0.5, -0.02, 0.31, -0.10)])
def test_what_poissons_ratio_costs_a_free_square(poisson, twist, saddle, dish):
    # The missing coupling 2 ν w_xx w_yy: no finer pitch mends it. docs/materials.md tells these numbers. Of twist's
    # error 1.6 % are the pitch's.
    assert square_errors(poisson, 32) == pytest.approx([twist, saddle, dish], abs=0.012)


def disk_errors(poisson, pitch):
    modes = plate(Disk(radius=RADIUS), pitch, poisson).free_modes
    numbers = {"radius": RADIUS, "plate_stiffness": stiffness(poisson), "mass_per_area": RHO * H, "poisson": poisson}
    saddle, dish = free_disk_frequency(2, 0, **numbers), free_disk_frequency(0, 1, **numbers)
    return np.array([modes.twist.omega / saddle, modes.saddle.omega / saddle, modes.dish.omega / dish]) - 1


def test_a_free_disk_without_poisson_ratio_becomes_a_plate():
    errors = np.abs([disk_errors(0.0, pitch) for pitch in (10e-3, 5e-3, 2.5e-3)])
    # The staircase of its edge, on which no line bends, is first order: half a pitch of the radius, twice.
    assert (errors < [[0.14], [0.09], [0.035]]).all()
    assert (np.diff(errors, axis=0) < 0).all()


def test_what_poissons_ratio_costs_a_disk():
    # As docs/materials.md tells them, at the usual pitch of eight nodes across.
    assert disk_errors(0.3, 10e-3) == pytest.approx([-0.135, -0.008, -0.178], abs=2e-3)
    assert disk_errors(0.5, 10e-3) == pytest.approx([-0.146, 0.141, -0.225], abs=2e-3)


@settings(max_examples=40, deadline=None)
@given(
    modulus=st.floats(1e3, 1e10), thickness=st.floats(1e-4, 5e-3), density=st.floats(50, 8000),
    poisson=st.floats(-0.4, 0.5), loss=st.floats(1e-3, 1.0),
)  # fmt: skip
def test_frequencies_scale_as_a_plates_and_the_dish_is_damped_as_told(modulus, thickness, density, poisson, loss):
    sheet = Sheet.from_material(
        Disk(radius=RADIUS), modulus, thickness, density, poisson_ratio=poisson, loss_factor=loss
    )
    usual = plate(Disk(radius=RADIUS), 0.01, poisson)
    scale = thickness / H * math.sqrt(modulus / E * RHO / density)
    assert sheet.natural_frequency == pytest.approx(usual.natural_frequency * scale, rel=1e-7)
    # Kelvin–Voigt: ζ = η/2 at the dish, and proportional to the frequency at every other mode.
    for mode in sheet.free_modes.modes[:6]:
        assert mode.damping_ratio == pytest.approx(loss / 2 * mode.omega / sheet.natural_frequency, rel=1e-6)


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.5])
def test_a_clamped_strip_is_a_beam_of_a_wide_plates_stiffness(poisson):
    # The lattice does not curl across, as a wide plate does not: k_b = D, which is E h³/12 over 1 − ν² of a beam.
    length, pitch = 0.08, 1e-3
    strip = plate(Rectangle(length=length + pitch, width=pitch), pitch, poisson)
    matrix = transverse_matrix(strip.lattice, pitch, strip.bending_stiffness, strip.torsion_stiffness)[2:, 2:]
    omega = math.sqrt(np.linalg.eigvalsh(matrix / strip.node_mass)[0])
    beam = cantilever_frequencies(E * H**3 / 12, RHO * H, length)[0]
    # 80 links: 0.1 %, second order.
    assert omega == pytest.approx(beam / math.sqrt(1 - poisson**2), rel=2e-3)


def plane_stiffness(sheet):
    """(2n, 2n) stiffness of small displacements in the plane, x and y of each node in turn, N/m."""
    lattice, n = sheet.lattice, sheet.lattice.n_nodes
    matrix = np.zeros((2 * n, 2 * n))
    kinds = (
        (lattice.axial_edges, sheet.axial_stiffness),
        (lattice.diagonal_edges, sheet.shear_ratio * sheet.axial_stiffness),
    )
    for edges, k in kinds:
        for i, j in edges:
            along = lattice.rest[j] - lattice.rest[i]
            along = along / np.linalg.norm(along)
            row = np.zeros(2 * n)
            row[2 * i : 2 * i + 2], row[2 * j : 2 * j + 2] = -along, along
            matrix += k * np.outer(row, row)
    return matrix


@pytest.mark.parametrize("poisson", [0.0, 1 / 3, 0.5])
def test_stretched_along_its_lines_a_strip_has_youngs_modulus(poisson):
    errors = []
    for across in (4, 8):
        columns = 3 * across
        sheet = plate(Rectangle(length=columns * 1e-3, width=across * 1e-3), 1e-3, poisson)
        x = sheet.lattice.rest[:, 0]
        matrix, ends = plane_stiffness(sheet), np.abs(x) > x.max() - 0.5
        # Ends pulled apart by 1, free to narrow; one node held across.
        held = np.concatenate([2 * np.flatnonzero(ends), [1]])
        free = np.setdiff1d(np.arange(len(matrix)), held)
        moved = np.zeros(len(matrix))
        moved[2 * np.flatnonzero(x > 0)] = 1.0
        moved[free] = 0.0
        moved[free] = np.linalg.solve(matrix[np.ix_(free, free)], -matrix[np.ix_(free, held)] @ moved[held])
        pull = (matrix @ moved)[2 * np.flatnonzero(ends & (x > 0))].sum()
        errors.append(pull * (columns - 1) / (E * H * across) - 1)
    # Lines at the edge have diagonals on one side only: first order in the pitch over the width.
    assert abs(errors[1]) < 0.05
    assert errors[1] == pytest.approx(errors[0] / 2, rel=0.35)


@pytest.mark.parametrize("poisson", [0.0, 1 / 3, 0.5])
def test_a_sheared_cell_has_the_shear_modulus(poisson):
    material = Material(young_modulus=E, poisson_ratio=poisson)
    joints = material.joints(H)
    # Pure shear γ: one diagonal of a cell lengthens by γ l/√2, one shortens, no edge changes; G h γ²/2 per area.
    energy = 2 * joints["shear_ratio"] * joints["axial_stiffness"] * (1 / math.sqrt(2)) ** 2 / 2
    assert energy == pytest.approx(E * H / (2 * (1 + poisson)) / 2, rel=1e-12)


def test_the_mass_is_that_of_the_squares_and_comes_to_the_outlines():
    triangle = Polygon(corners=((0, 0), (0.1, 0), (0.05, 0.0866)))
    true = RHO * H * 0.1 * 0.0866 / 2
    errors = []
    for pitch in (10e-3, 2e-3):
        sheet = plate(triangle, pitch)
        assert sheet.node_mass == pytest.approx(RHO * H * pitch**2, rel=1e-12)
        errors.append(abs(sheet.mass / true - 1))
    assert errors[0] < 0.08
    assert errors[1] < 0.02
