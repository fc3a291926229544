"""The closed forms, against numerical integration, published values and independent methods."""

import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import integrate, linalg

from plategait.errors import InputError
from plategait.theory import rigid as theory
from plategait.theory import vibration

RADIUS, MASS, FRICTION = 0.04, 0.0136, 0.75
AREA = np.pi * RADIUS**2
TINY = 1e-12  # relative: rounding of a handful of operations

slips = st.floats(-1, 1).filter(lambda v: v != 0)
accelerations = st.floats(-100, 100)
offsets = st.floats(-0.05, 0.05)


def disk_half(slip, theta_acceleration, y_B, side):
    """Half of (2.2): moment of the strips of a disk on one side of the ξ axis."""

    def strip(arm):
        chord = 2 * np.sqrt(RADIUS**2 - arm**2)
        return arm * theory.pressure(y_B + arm, theta_acceleration, MASS, AREA) * chord

    integral = integrate.quad(strip, *sorted((0.0, side * RADIUS)), epsabs=0, epsrel=1e-10)[0]
    return -np.sign(slip) * FRICTION * integral


@given(slip=slips, theta_acceleration=accelerations, y_B=offsets)
def test_disk_moment_is_the_integral_of_the_pressure(slip, theta_acceleration, y_B):
    moment = theory.disk_rotation_moment(RADIUS, MASS, FRICTION, slip, theta_acceleration, y_B=y_B)
    halves = [disk_half(slip, theta_acceleration, y_B, side) for side in (1, -1)]
    within = 1e-8 * max(map(abs, halves))  # the quadrature is asked for 1e-10; the end of a chord costs it some digits
    assert sorted([moment.contributing, moment.braking]) == pytest.approx(sorted(halves), abs=within)
    assert moment.total == pytest.approx(sum(halves), abs=within)


@given(slip=slips, theta_acceleration=accelerations, y_B=offsets)
def test_disk_moment_is_the_second_term_of_2_3_alone(slip, theta_acceleration, y_B):
    moment = theory.disk_rotation_moment(RADIUS, MASS, FRICTION, slip, theta_acceleration, y_B=y_B)
    expected = -np.sign(slip) * FRICTION * theta_acceleration * MASS * RADIUS**2 / 4
    # Rounding of the halves, of which the sum is a small difference.
    assert moment.total == pytest.approx(expected, abs=TINY * abs(moment.contributing))
    assert moment.total == moment.contributing + moment.braking


@given(slip=slips, theta_acceleration=accelerations, y_B=offsets)
def test_the_braking_half_opposes_the_total_while_contact_is_full(slip, theta_acceleration, y_B):
    if abs(theta_acceleration) > theory.full_contact_limit(RADIUS, y_B):
        return
    moment = theory.disk_rotation_moment(RADIUS, MASS, FRICTION, slip, theta_acceleration, y_B=y_B)
    assert moment.contributing * moment.braking < 0
    assert abs(moment.contributing) >= abs(moment.braking)
    assert moment.contributing * moment.total >= 0


@given(
    points=st.lists(st.tuples(offsets, st.floats(1e-4, 1e-2)), min_size=1, max_size=12),
    slip=slips,
    theta_acceleration=accelerations,
)
def test_moment_of_point_masses_is_minus_the_cross_product_about_z(points, slip, theta_acceleration):
    y, m = np.transpose(points)
    arm = np.zeros((len(y), 3))
    arm[:, 1] = y - np.average(y, weights=m)
    force = np.zeros((len(y), 3))
    force[:, 0] = -np.sign(slip) * FRICTION * m * (9.81 + y * theta_acceleration)
    about_z = np.cross(arm, force)[:, 2]
    moment = theory.rotation_moment(y, m, FRICTION, slip, theta_acceleration)
    within = TINY * np.abs(force).sum() * 0.1  # rounding of the arms, which are at most 0.1 m
    assert moment.total == pytest.approx(-about_z.sum(), abs=within)
    halves = [-about_z[side].sum() for side in (arm[:, 1] > 0, arm[:, 1] < 0)]
    assert sorted([moment.contributing, moment.braking]) == pytest.approx(sorted(halves), abs=within)


def test_point_masses_converge_to_the_disk():
    def error(pitch):
        centres = np.arange(pitch / 2, RADIUS, pitch)
        centres = np.concatenate([-centres[::-1], centres])
        x, y = np.meshgrid(centres, centres)
        y = y[np.hypot(x, y) < RADIUS]
        points = theory.rotation_moment(y, MASS / len(y), FRICTION, -1, 50.0)
        disk = theory.disk_rotation_moment(RADIUS, MASS, FRICTION, -1, 50.0)
        return max(abs(points.total / disk.total - 1), abs(points.contributing / disk.contributing - 1))

    # The ragged edge of n tiles across costs about n^-1.5: 0.1 % at 80 tiles, 0.01 % at 400.
    assert error(RADIUS / 40) < 4e-3
    assert error(RADIUS / 200) < 4e-4


def test_signs_are_those_of_the_text():
    # Ẍ > 0 leaves the object behind: it slips towards -x. With Θ̈ > 0 that is Ẍ Θ̈ > 0, clockwise, n > 0.
    moment = theory.disk_rotation_moment(RADIUS, MASS, FRICTION, -0.1, 50.0)
    assert moment.total > 0 > moment.braking
    # Clockwise is against ω_B. For a uniform disk θ̈_B = -n / (m r²/2) = -μ Θ̈ / 2, whatever its size and mass.
    spin = theory.spin_acceleration(moment.total, MASS * RADIUS**2 / 2)
    assert spin == pytest.approx(-FRICTION * 50.0 / 2, rel=TINY)


def test_moments_follow_arrays_of_slip_and_acceleration():
    slip, acceleration = np.array([-1.0, 0.0, 1.0]), np.array([[20.0], [-20.0]])
    moment = theory.disk_rotation_moment(RADIUS, MASS, FRICTION, slip, acceleration)
    assert moment.total.shape == moment.contributing.shape == (2, 3)
    np.testing.assert_array_equal(np.sign(moment.total), [[1, 0, -1], [-1, 0, 1]])
    np.testing.assert_array_equal(np.sign(moment.braking), [[-1, 0, 1], [1, 0, -1]])


@pytest.mark.parametrize("y_B", [0.0, 0.03, -0.03])
@pytest.mark.parametrize("direction", [1, -1])
def test_full_contact_ends_where_the_pressure_reaches_zero(y_B, direction):
    limit = theory.full_contact_limit(RADIUS, y_B)
    edges = np.array([y_B - RADIUS, y_B + RADIUS])

    def lowest(share):
        return theory.pressure(edges, direction * share * limit, MASS, AREA).min()

    assert lowest(0.999) > 0
    if direction * y_B <= 0:  # the way that drops the far edge
        assert lowest(1.001) < 0


def test_pressure_carries_the_weight():
    arm, weight = np.polynomial.legendre.leggauss(20)  # exact for the square plate's linear pressure
    y = 0.02 + 0.05 * arm
    force = 0.1 * 0.05 * weight @ theory.pressure(y, 30.0, MASS, 0.01)
    assert force == pytest.approx(MASS * (9.81 + 0.02 * 30.0), rel=TINY)


def test_inertial_loads_of_x_and_theta_x_do_not_depend_on_the_bar():
    inertia = (1e-3, 2e-3, 3e-3)
    np.testing.assert_array_equal(theory.inertial_loads(0.5, inertia), [0.5, 0.5, 0.5, *inertia])
    loads = theory.inertial_loads(0.5, inertia, bar_length=0.4)
    np.testing.assert_allclose(loads, [0.5, 0.5, 0.5, 1e-3, 2e-3 + 0.08, 3e-3 + 0.08], rtol=TINY)


def test_friction_work_over_the_stopping_distance_is_the_kinetic_energy():
    distance = theory.stopping_distance(1.2, FRICTION)
    assert FRICTION * MASS * 9.81 * distance == pytest.approx(0.5 * MASS * 1.2**2, rel=TINY)


def test_cantilever_parameters_are_those_of_the_tables():
    parameter = vibration.cantilever_frequencies(1.0, 1.0, 1.0)
    assert (abs(parameter - [3.516, 22.03, 61.70]) < [5e-4, 5e-3, 5e-3]).all()  # half a unit of the last digit
    root = np.sqrt(parameter)
    # cos βL = -1 / cosh βL, to rounding of a root below 8.
    np.testing.assert_allclose(np.cos(root), -1 / np.cosh(root), atol=1e-14)


def test_cantilever_frequencies_scale_with_stiffness_mass_and_length():
    ratio = vibration.cantilever_frequencies(8.0, 2.0, 3.0) / vibration.cantilever_frequencies(1.0, 1.0, 1.0)
    np.testing.assert_allclose(ratio, np.sqrt(8 / 2) / 3**2, rtol=TINY)


@pytest.mark.parametrize(
    ("diameters", "circles", "published"),
    [(2, 0, 5.253), (0, 1, 9.084), (3, 0, 12.23), (1, 1, 20.52), (4, 0, 21.6), (2, 1, 35.25), (0, 2, 38.55)],
)
def test_free_disk_parameters_are_those_of_the_tables(diameters, circles, published):
    # Leissa (1969), ν = 0.33: computed by hand, right to 4 in 1000; neighbouring modes differ by 4 % or more.
    assert vibration.free_disk_parameter(diameters, circles, 0.33) == pytest.approx(published, rel=4e-3)


def ritz(diameters, poisson, n_terms=9):
    """Frequency parameters by the Rayleigh-Ritz method with r^(n+2k), which needs no edge condition."""
    node, weight = np.polynomial.legendre.leggauss(40)
    r, weight = ((node + 1) / 2)[:, None], weight / 2
    n, power = diameters, diameters + 2 * np.arange(n_terms)
    f, slope, curvature = r**power, power * r ** (power - 1.0), power * (power - 1) * r ** (power - 2.0)
    hoop, twist = slope / r - n**2 * f / r**2, n * (slope / r - f / r**2)

    def integral(one, other):
        return one.T @ ((weight * r[:, 0])[:, None] * other)

    bending = integral(curvature + hoop, curvature + hoop)
    gauss = integral(curvature, hoop) + integral(hoop, curvature) - 2 * integral(twist, twist)
    return np.sqrt(np.abs(linalg.eigh(bending - (1 - poisson) * gauss, integral(f, f), eigvals_only=True)))


@pytest.mark.parametrize("poisson", [0.0, 0.33, -0.5, 0.5])
@pytest.mark.parametrize(("diameters", "circles"), [(2, 0), (0, 1), (3, 0), (1, 1), (2, 1), (0, 2), (6, 1)])
def test_free_disk_parameters_are_those_of_the_ritz_method(diameters, circles, poisson):
    # Nine polynomials converge to rounding, which powers of r amplify to about 1e-8 at worst.
    expected = ritz(diameters, poisson)[circles]
    assert vibration.free_disk_parameter(diameters, circles, poisson) == pytest.approx(expected, rel=1e-6)


def test_the_saddle_and_the_dish_of_a_lattice_become_those_of_a_free_disk():
    k_b, mass_per_area = 1e-4, 2.62
    sheet = {"radius": RADIUS, "plate_stiffness": k_b, "mass_per_area": mass_per_area}
    saddle, dish = vibration.free_disk_frequency(2, 0, **sheet), vibration.free_disk_frequency(0, 1, **sheet)
    scale = np.sqrt(k_b / mass_per_area) / RADIUS**2
    assert (saddle / scale, dish / scale) == pytest.approx((6.1530, 8.2439), abs=5e-5)  # ν = 0, by the Ritz method
    stiffer = vibration.free_disk_frequency(2, 0, **{**sheet, "plate_stiffness": 4 * k_b})
    assert stiffer == pytest.approx(2 * saddle, rel=TINY)


@pytest.mark.parametrize(
    ("field", "call"),
    [
        ("mass", lambda: theory.pressure(0, 0, 0, 1)),
        ("area", lambda: theory.pressure(0, 0, 1, -1)),
        ("half_width", lambda: theory.full_contact_limit(0)),
        ("gravity", lambda: theory.full_contact_limit(1, gravity=0)),
        ("radius", lambda: theory.disk_rotation_moment(0, 1, 1, 1, 1)),
        ("mass", lambda: theory.disk_rotation_moment(1, float("nan"), 1, 1, 1)),
        ("friction", lambda: theory.disk_rotation_moment(1, 1, -0.1, 1, 1)),
        ("y", lambda: theory.rotation_moment([], [], 1, 1, 1)),
        ("masses", lambda: theory.rotation_moment([0, 1], [1, 1, 1], 1, 1, 1)),
        ("masses", lambda: theory.rotation_moment([0, 1], [1, 0], 1, 1, 1)),
        ("inertia_z", lambda: theory.spin_acceleration(1, 0)),
        ("plate_mass", lambda: theory.inertial_loads(0, (1, 1, 1))),
        ("I_y", lambda: theory.inertial_loads(1, (1, 0, 1))),
        ("bar_length", lambda: theory.inertial_loads(1, (1, 1, 1), -1)),
        ("friction", lambda: theory.stopping_distance(1, 0)),
        ("length", lambda: vibration.cantilever_frequencies(1, 1, float("inf"))),
        ("(diameters, circles)", lambda: vibration.free_disk_parameter(0, 0)),
        ("(diameters, circles)", lambda: vibration.free_disk_parameter(1, 0)),
        ("(diameters, circles)", lambda: vibration.free_disk_parameter(-2, 1)),
        ("poisson", lambda: vibration.free_disk_parameter(2, 0, 0.6)),
        ("plate_stiffness", lambda: vibration.free_disk_frequency(2, 0, radius=1, plate_stiffness=0, mass_per_area=1)),
    ],
)
def test_bad_input_is_refused_by_name(field, call):
    with pytest.raises(InputError) as refused:
        call()
    assert refused.value.field == field


def test_importing_needs_no_scipy():
    modules = "plategait.theory.rigid, plategait.curve.lorentz"
    script = f"import sys, {modules}; sys.exit('scipy' in sys.modules or 'lmfit' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", script], check=False).returncode == 0
