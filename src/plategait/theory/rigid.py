"""Closed forms of a rigid object on the plate (chapter 2), beside the simulation. SI throughout, with angles in rad."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from plategait.arrays import Array
from plategait.errors import InputError

GRAVITY = 9.81
"""Gravitational acceleration, m/s²."""


def pressure(
    y_r: ArrayLike, theta_acceleration: ArrayLike, mass: float, area: float, gravity: float = GRAVITY
) -> Array:
    """Contact pressure under a thin rigid object that follows the plate, equation (2.1).

    Holds where it is at least 0 all over the object: see `full_contact_limit`. Contact does not pull, so a negative
    value means that the object has left the plate and that the formula no longer applies. Valid for small tilts, which
    leave gravity and the inertial force normal to the plate.

    Parameters
    ----------
    y_r : array_like
        Distance ᵐy_r from the bar axis, m.
    theta_acceleration : array_like
        Angular acceleration Θ̈ of the plate about the bar, right-handed, rad/s². Broadcasts with `y_r`.
    mass, area : float
        Mass m_B, kg, and contact area A_B, m², of the object, above 0.
    gravity : float
        Gravitational acceleration, m/s².

    Returns
    -------
    array
        Pressure, Pa.

    Raises
    ------
    InputError
        A mass or an area not above 0.
    """
    require_positive(mass=mass, area=area)
    return mass / area * (gravity + np.asarray(y_r, dtype=float) * np.asarray(theta_acceleration, dtype=float))


def full_contact_limit(half_width: float, y_B: float = 0.0, gravity: float = GRAVITY) -> float:
    """Largest ``|Θ̈|`` at which (2.1) stays at or above 0 over the whole object, whichever way the plate turns.

    The edge farther from the bar lifts first, when the plate drops away under it at g: ``|Θ̈| = g / (h + |ᵐy_B|)``.

    Parameters
    ----------
    half_width : float
        Half the object's extent along y_m, m, above 0 (the radius of a disk).
    y_B : float
        Distance ᵐy_B of its middle from the bar axis, m.
    gravity : float
        Gravitational acceleration, m/s², above 0.

    Returns
    -------
    float
        Angular acceleration, rad/s².

    Raises
    ------
    InputError
        A half-width or a gravity not above 0.
    """
    require_positive(half_width=half_width, gravity=gravity)
    return gravity / (half_width + abs(y_B))


def half_lift_limit(mean_distance: float, gravity: float = GRAVITY) -> float:
    """``|Θ̈|`` from which a rigid object on a stiff elastic bed has the half on one side of the bar lift clear of it.

    The bed's pressure is then 0 along the bar and grows evenly towards the other rim: it carries the weight m g at
    ⟨y²⟩/⟨|y|⟩, over half of the object, and turns the inertia m ⟨y²⟩. So ``|Θ̈| = g / ⟨|y|⟩``: for a disk 3π/4 at the
    rim, in g. Derived here; the source has (2.1) up to `full_contact_limit` only.

    Parameters
    ----------
    mean_distance : float
        ⟨|y|⟩, mean distance from the bar over an object that lies evenly about it, m, above 0: 4 r/(3π) for a disk.
    gravity : float
        Gravitational acceleration, m/s², above 0.

    Returns
    -------
    float
        Angular acceleration, rad/s².

    Raises
    ------
    InputError
        A distance or a gravity not above 0.
    """
    require_positive(mean_distance=mean_distance, gravity=gravity)
    return gravity / mean_distance


@dataclass(frozen=True, eq=False)
class RotationMoment:
    """Friction moment about the centre of mass, split at the ξ axis (section 2.3), N·m.

    Signs are the source's: positive is **clockwise** seen from above the plate (from +z_m), which is minus the
    right-handed moment about z_m. An object that lags behind Ẍ slips towards -Ẍ, so Ẍ Θ̈ > 0 gives n > 0.

    Parameters
    ----------
    total : array
        n of (2.2).
    contributing : array
        The half whose moment has the sign of n: n₊ where n ≥ 0.
    braking : array
        The other half, which an object that bends off the plate loses: n₋ where n ≥ 0.
    """

    total: Array
    contributing: Array
    braking: Array


def disk_rotation_moment(
    radius: float,
    mass: float,
    friction: float,
    slip_velocity: ArrayLike,
    theta_acceleration: ArrayLike,
    *,
    y_B: float = 0.0,
    gravity: float = GRAVITY,
) -> RotationMoment:
    """Friction moment on a uniform rigid disk in full contact: (2.2) integrated over either half disk.

    The first moment of mass vanishes over the whole disk, so that (2.3) leaves n = -sign(ẋ_B) μ Θ̈ m r²/4 wherever
    the disk lies. Each half has the first moment ±2 m r/(3π) and the second m r²/8.

    Parameters
    ----------
    radius, mass : float
        m and kg, above 0.
    friction : float
        Coefficient μ, at least 0.
    slip_velocity : array_like
        ᵐẋ_B, velocity of the disk along the bar relative to the plate. Only its sign counts; 0 gives no moment.
    theta_acceleration : array_like
        Θ̈, rad/s², at most `full_contact_limit` in size. Broadcasts with `slip_velocity`.
    y_B : float
        Distance of the centre from the bar axis, m.
    gravity : float
        Gravitational acceleration, m/s².

    Returns
    -------
    RotationMoment

    Raises
    ------
    InputError
        A radius or mass not above 0, or a friction below 0.
    """
    require_positive(radius=radius, mass=mass)
    first, second = 2 * mass * radius / (3 * np.pi), mass * radius**2 / 8
    return _moment([(first, second), (-first, second)], friction, slip_velocity, theta_acceleration, y_B, gravity)


def rotation_moment(
    y: ArrayLike,
    masses: ArrayLike,
    friction: float,
    slip_velocity: ArrayLike,
    theta_acceleration: ArrayLike,
    *,
    gravity: float = GRAVITY,
) -> RotationMoment:
    """Friction moment on a rigid set of point masses in full contact, (2.2) with sums for integrals.

    Parameters
    ----------
    y : (n,) array_like
        Distance ᵐy of each mass from the bar axis, m. Their centre of mass is ᵐy_B.
    masses : (n,) array_like or float
        Masses, kg, above 0; a single number is the mass of each.
    friction, slip_velocity, theta_acceleration, gravity
        As in `disk_rotation_moment`.

    Returns
    -------
    RotationMoment

    Raises
    ------
    InputError
        No points, lengths that differ, a mass not above 0, or a friction below 0.
    """
    positions, m = np.asarray(y, dtype=float), np.asarray(masses, dtype=float)
    if positions.ndim != 1 or not positions.size:
        raise InputError("y", f"shape {positions.shape}", "a list of positions", "[-0.01, 0.01]")
    if m.shape not in ((), positions.shape):
        raise InputError("masses", f"shape {m.shape}", f"one, or one for each of {positions.size} points", "2.62e-4")
    if not (m > 0).all():
        raise InputError("masses", m.tolist(), "above 0, in kg", "2.62e-4")
    m = np.broadcast_to(m, positions.shape)
    y_B = float(np.average(positions, weights=m))
    arm = positions - y_B
    halves = [(float(m[half] @ arm[half]), float(m[half] @ arm[half] ** 2)) for half in (arm > 0, arm < 0)]
    return _moment(halves, friction, slip_velocity, theta_acceleration, y_B, gravity)


def _moment(
    halves: list[tuple[float, float]],
    friction: float,
    slip_velocity: ArrayLike,
    theta_acceleration: ArrayLike,
    y_B: float,
    gravity: float,
) -> RotationMoment:
    """Equation (2.3) for each half, given its first and second moment of mass about the ξ axis."""
    if not friction >= 0:
        raise InputError("friction", friction, "at least 0", "0.75")
    acceleration = np.asarray(theta_acceleration, dtype=float)
    drag = -np.sign(np.asarray(slip_velocity, dtype=float)) * friction
    one, other = (drag * ((gravity + y_B * acceleration) * s1 + acceleration * s2) for s1, s2 in halves)
    total, clockwise, counter = one + other, np.maximum(one, other), np.minimum(one, other)
    return RotationMoment(total, np.where(total >= 0, clockwise, counter), np.where(total >= 0, counter, clockwise))


def spin_acceleration(moment: ArrayLike, inertia_z: float) -> Array:
    """Angular acceleration of the object in its plane, θ̈_B = -n / I_z.

    Parameters
    ----------
    moment : array_like
        n, N·m, clockwise positive, as in `RotationMoment`.
    inertia_z : float
        Moment of inertia about the normal through the centre of mass, kg·m² (a uniform disk: m r²/2), above 0.

    Returns
    -------
    array
        rad/s², **counter-clockwise** positive seen from above: right-handed about z_m, as ᵐθ_B and ω_B are.

    Raises
    ------
    InputError
        An inertia not above 0.
    """
    require_positive(inertia_z=inertia_z)
    return -np.asarray(moment, dtype=float) / inertia_z


def inertial_loads(plate_mass: float, inertia: tuple[float, float, float], bar_length: float = 0.0) -> Array:
    """Inertial load on the handling position in each of six degrees of freedom, n₁ and n₂ of section 2.2.1.

    X and Θ_X do not depend on the length of the bar, which is why the plate moves in those two.

    Parameters
    ----------
    plate_mass : float
        m_p, kg, above 0.
    inertia : (I_x, I_y, I_z)
        Moments of inertia of the plate about its centre of mass, kg·m², above 0; x lies along the bar.
    bar_length : float
        Distance L from the handling position to the centre of mass, m, at least 0; the bar weighs nothing.

    Returns
    -------
    (6,) array
        Loads against X, Y, Z (kg) and Θ_X, Θ_Y, Θ_Z (kg·m²).

    Raises
    ------
    InputError
        A mass or an inertia not above 0, or a length below 0.
    """
    i_x, i_y, i_z = inertia
    require_positive(plate_mass=plate_mass, I_x=i_x, I_y=i_y, I_z=i_z)
    if not bar_length >= 0:
        raise InputError("bar_length", bar_length, "at least 0, in m", "0.5")
    lever = plate_mass * bar_length**2
    return np.array([plate_mass, plate_mass, plate_mass, i_x, i_y + lever, i_z + lever])


def stopping_distance(speed: float, friction: float, gravity: float = GRAVITY) -> float:
    """Way that a block slides on a level plate at rest before Coulomb friction stops it, v² / (2 μ g).

    Parameters
    ----------
    speed : float
        Initial speed, m/s.
    friction : float
        Coefficient μ_k, above 0.
    gravity : float
        Gravitational acceleration, m/s², above 0.

    Returns
    -------
    float
        m.

    Raises
    ------
    InputError
        A friction or a gravity not above 0.
    """
    require_positive(friction=friction, gravity=gravity)
    return speed**2 / (2 * friction * gravity)


def require_positive(**values: float) -> None:
    """Refuse an argument that is not finite and above 0, by its name."""
    for field, value in values.items():
        if not 0 < value < np.inf:
            raise InputError(field, value, "finite and above 0", "1.0")
