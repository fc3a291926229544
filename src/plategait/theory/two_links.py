"""Two links on a wall, bending under gravity: the model of Fig. 3.5(a), whole.

Each link is rigid, of length l, with its mass m in the middle, as a node sits in the middle of its tile: that is what
the coefficients of (3.3) say. Joint 1 ties link 1 to the wall, joint 2 ties link 2 to link 1, both are Kelvin–Voigt.
φ1 is the angle of link 1 below the horizontal, φ2 that of link 2 below the line of link 1. With

    T = m l² [ (3/4 + cos(φ2)/2) φ1'² + (1/4 + cos(φ2)/2) φ1' φ2' + φ2'²/8 ]
    V = -m g l [ (3/2) sin φ1 + (1/2) sin(φ1 + φ2) ] + k1 φ1²/2 + k_b φ2²/2

Lagrange's equation of φ2 is (3.3) but for one term: (1/2) m l² sin(φ2) φ1'², the centripetal acceleration of joint 2,
which (3.3) leaves out.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.theory.rigid import GRAVITY

Rate = Callable[[int, Array], Array]

LEAST_ROWS = 12
"""Of a recording: three times what is fitted to each angle."""


@dataclass(frozen=True)
class Strip:
    """One link of the strip: SI.

    Parameters
    ----------
    mass : float
        m, kg. By default that of section 3.3.2.
    length : float
        l, m.
    gravity : float
        g, m/s².
    """

    mass: float = 0.285e-3
    length: float = 0.01
    gravity: float = GRAVITY

    @property
    def inertia(self) -> float:
        """m l², kg m²."""
        return self.mass * self.length**2

    @property
    def weight(self) -> float:
        """m g l, N m."""
        return self.mass * self.gravity * self.length


@dataclass(frozen=True)
class Joints:
    """Both joints; each number may be an array, one entry per column of a batch.

    Parameters
    ----------
    k_b, c_b : float or (batch,) array
        Joint 2, N m/rad and N m s/rad.
    k_1, c_1 : float or (batch,) array, optional
        Joint 1, at the wall; as joint 2 if left out.
    """

    k_b: float | Array
    c_b: float | Array
    k_1: float | Array | None = None
    c_1: float | Array | None = None

    @property
    def wall(self) -> tuple[float | Array, float | Array]:
        """Stiffness and damping of joint 1."""
        return self.k_b if self.k_1 is None else self.k_1, self.c_b if self.c_1 is None else self.c_1


def joint_moment(
    strip: Strip,
    phi: tuple[ArrayLike, ArrayLike],
    acceleration: tuple[ArrayLike, ArrayLike],
    rate_1: ArrayLike,
    *,
    centripetal: bool = True,
) -> Array:
    """Moment c_b φ2' + k_b φ2 that joint 2 must give, the right side of (3.3).

    Parameters
    ----------
    phi, acceleration : pairs of (n,) array_like
        φ1, φ2 (rad) and their second derivatives (rad/s²).
    rate_1 : (n,) array_like
        φ1', rad/s.
    centripetal : bool
        Whether the term that (3.3) drops is kept.

    Returns
    -------
    (n,) array, N m
    """
    phi_1, phi_2 = map(np.asarray, phi)
    acc_1, acc_2 = map(np.asarray, acceleration)
    moment = 0.5 * strip.weight * np.cos(phi_1 + phi_2)
    moment = moment - 0.25 * strip.inertia * acc_2 - 0.25 * (1 + 2 * np.cos(phi_2)) * strip.inertia * acc_1
    if centripetal:
        moment = moment - 0.5 * strip.inertia * np.sin(phi_2) * np.asarray(rate_1) ** 2
    return moment


def two_link_rate(strip: Strip, joints: Joints, *, centripetal: bool = True) -> Rate:
    """Rate of change of the state (φ1, φ2, φ1', φ2') of both links, (4, batch) to (4, batch)."""
    inertia, weight = strip.inertia, strip.weight
    k_1, c_1 = joints.wall
    coupling = 0.5 * inertia * centripetal

    def rate(_: int, state: Array) -> Array:
        phi_1, phi_2, v_1, v_2 = state
        cos_2, sin_2, tip = np.cos(phi_2), np.sin(phi_2), 0.5 * weight * np.cos(phi_1 + phi_2)
        # Symmetric mass matrix [[a, b], [b, c]] and moments of the two equations.
        a, b, c = inertia * (1.5 + cos_2), inertia * (0.25 + 0.5 * cos_2), 0.25 * inertia
        first = tip + 1.5 * weight * np.cos(phi_1) + inertia * sin_2 * v_2 * (v_1 + 0.5 * v_2) - k_1 * phi_1 - c_1 * v_1
        second = tip - coupling * sin_2 * v_1 * v_1 - joints.k_b * phi_2 - joints.c_b * v_2
        determinant = a * c - b * b
        change = np.empty_like(state)
        change[0], change[1] = v_1, v_2
        change[2], change[3] = (c * first - b * second) / determinant, (a * second - b * first) / determinant
        return change

    return rate


def driven_rate(
    strip: Strip, joints: Joints, phi_1: Array, rate_1: Array, acc_1: Array, *, centripetal: bool = True
) -> Rate:
    """Rate of change of the state (φ2, φ2') of joint 2, (2, batch) to (2, batch), link 1 moving as given.

    Parameters
    ----------
    phi_1, rate_1, acc_1 : (2 steps + 1, batch) arrays
        φ1, φ1' and φ1'' at every half step of the integration.
    """
    inertia, weight = strip.inertia, strip.weight
    coupling = 0.5 * inertia * centripetal

    def rate(half_step: int, state: Array) -> Array:
        phi_2, v_2 = state
        moment = 0.5 * weight * np.cos(phi_1[half_step] + phi_2) - joints.k_b * phi_2 - joints.c_b * v_2
        moment -= 0.25 * inertia * (1 + 2 * np.cos(phi_2)) * acc_1[half_step]
        moment -= coupling * np.sin(phi_2) * rate_1[half_step] ** 2
        change = np.empty_like(state)
        change[0], change[1] = v_2, moment / (0.25 * inertia)
        return change

    return rate


def integrate(rate: Rate, start: Array, step: float, steps: int) -> Array:
    """Fourth-order Runge–Kutta solution at every step, for a whole batch at once.

    Parameters
    ----------
    rate : callable
        Of the index of the half step and the state.
    start : (states, batch) array
    step : float
        s.
    steps : int

    Returns
    -------
    (steps + 1, states, batch) array
    """
    states = np.empty((steps + 1, *start.shape))
    states[0] = state = start
    with np.errstate(over="ignore", invalid="ignore"):  # a wild guess may diverge; whoever fits sees that
        for i in range(steps):
            one = rate(2 * i, state)
            two = rate(2 * i + 1, state + 0.5 * step * one)
            three = rate(2 * i + 1, state + 0.5 * step * two)
            four = rate(2 * i + 2, state + step * three)
            states[i + 1] = state = state + step / 6 * (one + 2 * two + 2 * three + four)
    return states


def between(states: Array, step: float, time: Array) -> Array:
    """Angles of a solution at any times from its start, by the cubic through angles and rates at the steps.

    Parameters
    ----------
    states : (steps + 1, 2 a, batch) array
        The first half of the states are angles, the second their rates.
    time : (n,) array
        s, from 0 to the end of the solution.

    Returns
    -------
    (n, a, batch) array
    """
    angles = states.shape[1] // 2
    place = np.clip((time / step).astype(int), 0, max(len(states) - 2, 0))
    u = (time / step - place)[:, None, None]
    left, right = states[place], states[np.minimum(place + 1, len(states) - 1)]
    position = (1 + 2 * u) * (1 - u) ** 2 * left[:, :angles] + u**2 * (3 - 2 * u) * right[:, :angles]
    return position + step * (u * (1 - u) ** 2 * left[:, angles:] - u**2 * (1 - u) * right[:, angles:])


def energy(strip: Strip, joints: Joints, state: Array) -> Array:
    """Kinetic, gravitational and elastic energy of states (..., 4), J."""
    phi_1, phi_2, v_1, v_2 = np.moveaxis(state, -1, 0)
    cos_2 = np.cos(phi_2)
    kinetic = (0.75 + 0.5 * cos_2) * v_1**2 + (0.25 + 0.5 * cos_2) * v_1 * v_2 + v_2**2 / 8
    height = -(1.5 * np.sin(phi_1) + 0.5 * np.sin(phi_1 + phi_2))
    elastic = 0.5 * joints.wall[0] * phi_1**2 + 0.5 * joints.k_b * phi_2**2
    return strip.inertia * kinetic + strip.weight * height + elastic


def fastest_rates(strip: Strip, joints: Joints) -> tuple[float, float]:
    """Largest undamped angular frequency and largest rate of decay of the straight strip, 1/s: steps resolve these."""
    (k_1, c_1), k_b, c_b = joints.wall, joints.k_b, joints.c_b
    mass = strip.inertia * np.array([[2.5, 0.75], [0.75, 0.25]])
    stiffness, damping = (np.diag([np.max(one), np.max(two)]) for one, two in ((k_1, k_b), (c_1, c_b)))
    squares, decays = (np.linalg.eigvals(np.linalg.solve(mass, matrix)).real.max() for matrix in (stiffness, damping))
    return float(np.sqrt(squares)), float(decays)


@dataclass(frozen=True, eq=False)
class Angles:
    """Joint angles of a strip over time.

    Parameters
    ----------
    time : (n,) array
        Rising, s.
    phi_1, phi_2 : (n,) arrays
        Angle of link 1 below the horizontal, and of link 2 below the line of link 1, rad.
    """

    time: Array
    phi_1: Array
    phi_2: Array

    def __post_init__(self) -> None:
        """Refuse what is no recording."""
        for name in ("time", "phi_1", "phi_2"):
            values = np.asarray(getattr(self, name), dtype=float)
            object.__setattr__(self, name, values)
            if values.shape != (len(self.time),) or not np.isfinite(values).all():
                raise InputError(name, f"shape {values.shape}, {np.isfinite(values).sum()} of them finite",
                                 "one finite number for each row", "leaving out rows without a number")  # fmt: skip
        if not (np.diff(self.time) > 0).all():
            raise InputError("time", "a time no later than the one before", "rising", "sorting the rows")


def angles_of_markers(markers: ArrayLike) -> tuple[Array, Array]:
    """Joint angles φ1, φ2 (rad) from markers.

    Parameters
    ----------
    markers : (n, 3, 2) array_like
        x and y of the markers at wall, joint and tip, y upwards, in any unit of length. A strip that points to the
        left is taken as its mirror image.
    """
    links = np.diff(np.asarray(markers, dtype=float), axis=1)
    side = 1.0 if links[:, :, 0].sum() >= 0 else -1.0
    below = np.arctan2(-links[:, :, 1], side * links[:, :, 0])
    return below[:, 0], (below[:, 1] - below[:, 0] + np.pi) % (2 * np.pi) - np.pi


def strip_angles(
    strip: Strip, joints: Joints, time: Array, start: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
) -> Array:
    """Angles (n, 2) of the two links at `time` (from 0, s) after a release from `start` (φ1, φ2, φ1', φ2')."""
    # Errors of 1e-7 of the motion, far under any camera's; of what has decayed after a row or two, a little more.
    omega, decay = fastest_rates(strip, joints)
    step = min(0.05 / omega, 0.5 / max(decay, omega))
    steps = max(int(np.ceil(time[-1] / step)), 1)
    states = integrate(two_link_rate(strip, joints), np.array(start)[:, None], time[-1] / steps, steps)
    return between(states, time[-1] / steps, time)[:, :, 0]
