"""Reference engine: rigid tiles hinged at their edges, as section 3.2.2 draws them, in plain NumPy.

Slow and independent of the native core, which puts the mass at nodes instead. Every lattice node is the centre of
a rigid square tile with rotary inertia; neighbours are joined at the midpoint of their shared edge (Figs. 3.2, 3.3).
The joint is Kelvin–Voigt in compression and bending, free (or Kelvin–Voigt) in torsion, and stiff otherwise.

Vectors are stored (3, tiles, runs) and quaternions (4, tiles, runs): runs lie side by side.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Coefficient = float | Array
Friction = Literal["thesis", "adams"]


@dataclass(frozen=True, eq=False)
class TileModel:
    """A sheet of rigid tiles and its contact with the plate, in SI units; the values default to Table 4.1.

    Joint and contact coefficients may also be (runs,) arrays, one value for each run of a batch.

    Parameters
    ----------
    rest : (n, 2) array
        Tile centres in pitches: ``Lattice.rest``.
    edges : (joints, 2) array
        Joined tiles, the one further along the grid second: ``Lattice.axial_edges``.
    pitch, thickness, node_mass
        Tile side l, thickness d and mass m.
    k_c, c_c, k_b, c_b, k_t, c_t
        Stiffness and damping in compression (N/m), bending and torsion (N m/rad).
    rotary_inertia
        Share of a uniform tile's rotary inertia; the source's own bending equation (3.3) has point masses.
    shear_ratio
        Stiffness of the degrees of freedom the joint holds, as a multiple of ``k_c``; the time step must resolve it.
        From 1 to 40 the highest spin rates rise by less than a tenth.
    k_contact, c_contact
        Contact law (3.1) of one tile, in N/mm^2.2 and N s/m.
    contact_ramp
        Depth over which the contact damping rises by a cubic step, m; 0 for at once.
    contact_at
        One contact point at the centre of a tile, or four at its corners with a quarter of the law each.
    contact_face
        Whether the contact points lie in the mid-plane or on the lower face, half a thickness down.
    """

    rest: Array
    edges: NDArray[np.integer]
    pitch: float = 0.01
    thickness: float = 0.0025
    node_mass: float = 2.62e-4
    k_c: Coefficient = 790.0
    c_c: Coefficient = 0.49
    k_b: Coefficient = 1.5585e-4
    c_b: Coefficient = 2.4236e-7
    k_t: Coefficient = 0.0
    c_t: Coefficient = 0.0
    rotary_inertia: float = 1.0
    shear_ratio: float = 8.0
    k_contact: Coefficient = 11.86
    c_contact: Coefficient = 7.65
    contact_ramp: float = 0.0
    contact_at: Literal["centre", "corners"] = "centre"
    contact_face: Literal["middle", "lower"] = "middle"

    @cached_property
    def joints(self) -> tuple[NDArray[np.intp], NDArray[np.intp], NDArray[np.intp]]:
        """Tile behind, tile ahead and grid direction (0 or 1) of each joint; those along x come first."""
        along = np.abs(np.diff(self.rest[self.edges], axis=1)[:, 0]).argmax(axis=1)
        order = np.argsort(along, kind="stable")
        behind, ahead = self.edges[order].T.astype(np.intp)
        return behind, ahead, along[order]

    @cached_property
    def gather(self) -> tuple[Array, Array]:
        """(tiles, joints) matrices that add what acts on the tiles behind and ahead of the joints."""
        tiles = np.arange(len(self.rest))[:, None]
        return (tiles == self.joints[0]).astype(float), (tiles == self.joints[1]).astype(float)

    @property
    def inertia(self) -> tuple[float, float]:
        """Moments of inertia of a tile about an in-plane axis and about its normal."""
        m, side, d = self.rotary_inertia * self.node_mass, self.pitch, self.thickness
        return m * (side**2 + d**2) / 12, m * side**2 / 6

    @property
    def contact_points(self) -> Array:
        """(points, 3) contact points in the frame of a tile."""
        z = -self.thickness / 2 if self.contact_face == "lower" else 0.0
        if self.contact_at == "centre":
            return np.array([[0, 0, z]])
        return np.array(
            [[x, y, z] for x in (-self.pitch / 2, self.pitch / 2) for y in (-self.pitch / 2, self.pitch / 2)]
        )

    @property
    def contact_mobility(self) -> tuple[float, float]:
        """Largest speed gained per impulse at the contact points when all are pushed alike, normal and tangential."""
        (I_x, I_z), m = self.inertia, self.node_mass
        points = self.contact_points
        x, z = np.abs(points[0, 0]), points[0, 2]
        return len(points) * max(1 / m, x**2 / I_x), len(points) * max(1 / m + z**2 / I_x, 2 * x**2 / I_z)


# ------------------------------------------------------------------------------------------------- vibration


def tile_modes(model: TileModel) -> tuple[Array, Array]:
    """Free out-of-plane modes at small angles, no plate and no damping.

    The stiff out-of-plane shear is taken as exact: deflections and slopes are projected onto the motions in which
    all shared edges stay together at their midpoints.

    Returns
    -------
    frequency : (modes,) array
        Natural angular frequencies, rad/s, rising.
    shape : (modes, n) array
        Deflection of the tile centres, each mode of unit modal mass.
    """
    n, half = len(model.rest), model.pitch / 2
    I_x, _ = model.inertia
    behind, ahead, along = model.joints
    joint = np.arange(len(behind))

    # Unknowns: deflection w, slopes along x and y of every tile.
    gap = np.zeros((len(joint), 3, n))
    gap[joint, 0, ahead], gap[joint, 0, behind] = 1, -1
    gap[joint, 1 + along, ahead] = gap[joint, 1 + along, behind] = -half
    bend, twist = np.zeros_like(gap), np.zeros_like(gap)
    bend[joint, 1 + along, ahead], bend[joint, 1 + along, behind] = 1, -1
    twist[joint, 2 - along, ahead], twist[joint, 2 - along, behind] = 1, -1
    gap, bend, twist = (a.reshape(len(joint), 3 * n) for a in (gap, bend, twist))

    # Free motions, with masses divided out: the null space of the gaps.
    scale = np.repeat([model.node_mass, I_x, I_x], n) ** -0.5
    _, size, rows = np.linalg.svd(gap * scale)
    basis = scale[:, None] * rows[np.sum(size > 1e-9 * size[0]) :].T
    stiffness = float(model.k_b) * bend.T @ bend + float(model.k_t) * twist.T @ twist
    square, vectors = np.linalg.eigh(basis.T @ stiffness @ basis)
    return np.sqrt(np.maximum(square, 0)), (basis @ vectors)[:n].T


# --------------------------------------------------------------------------------------------------- vectors


def _cross(a: Array, b: Array) -> Array:
    return np.stack([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def _dot(a: Array, b: Array) -> Array:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _unit(a: Array) -> Array:
    return a / np.sqrt(_dot(a, a) + 1e-30)


def _axes(q: Array) -> tuple[Array, Array, Array]:
    """Axes of tiles of attitude q (scalar first): two in the plane and the normal."""
    w, x, y, z = q
    e_x = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)])
    e_y = np.stack([2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)])
    return e_x, e_y, _cross(e_x, e_y)


def _turn(q: Array, angle: Array) -> Array:
    """Attitude after a small rotation, to second order and kept of unit length."""
    w, v = q[0], q[1:]
    turned = q + 0.5 * np.concatenate([-_dot(angle, v)[None], w * angle + _cross(angle, v)])
    turned -= 0.125 * _dot(angle, angle) * q
    return turned / np.sqrt((turned**2).sum(axis=0))


# --------------------------------------------------------------------------------------------------- physics


def joint_forces(
    model: TileModel, x: Array, v: Array, axes: tuple[Array, Array, Array], w: Array
) -> tuple[Array, Array]:
    """Force and moment of the joint units on every tile (section 3.2.2).

    Force acts at the middle of the gap and moments come in pairs, so that joints carry no net force or moment.
    """
    behind, ahead, along = model.joints
    n_x, half = int(np.sum(along == 0)), model.pitch / 2
    e_x, e_y, e_z = axes
    a_i = np.concatenate([e_x[:, behind[:n_x]], e_y[:, behind[n_x:]]], axis=1)
    a_j = np.concatenate([e_x[:, ahead[:n_x]], e_y[:, ahead[n_x:]]], axis=1)
    across = _unit(e_z[:, behind] + e_z[:, ahead])
    normal = _unit(a_i + a_j)
    edge = _cross(across, normal)

    gap = x[:, ahead] - x[:, behind] - half * (a_i + a_j)
    arm_i, arm_j = half * a_i + 0.5 * gap, -half * a_j - 0.5 * gap
    w_i, w_j = w[:, behind], w[:, ahead]
    opening = v[:, ahead] + _cross(w_j, arm_j) - v[:, behind] - _cross(w_i, arm_i)
    turning = w_j - w_i

    # Compression along the normal; shear held by a penalty with the damping of the compression joint.
    k_c, c_c, ratio = model.k_c, model.c_c, model.shear_ratio
    force = -(ratio * k_c * gap + c_c * opening) + (ratio - 1) * k_c * _dot(gap, normal) * normal

    # Bending by the angle between the tiles, true when large: θ / sin θ with sin θ = |a_i × a_j|.
    bend = _cross(a_i, a_j)
    sine, cosine = np.sqrt(_dot(bend, bend)), _dot(a_i, a_j)
    bend *= np.where(sine > 1e-9, np.arctan2(sine, cosine) / np.maximum(sine, 1e-9), 1.0)
    swivel_k, swivel_c = ratio * k_c * half**2 / 3, c_c * half**2 / 3
    moment = -(model.k_b * _dot(bend, edge) + model.c_b * _dot(turning, edge)) * edge
    moment -= (swivel_k * _dot(bend, across) + swivel_c * _dot(turning, across)) * across
    if np.any(model.k_t) or np.any(model.c_t):
        twist = _dot(_cross(e_z[:, behind], e_z[:, ahead]), normal)
        moment -= (model.k_t * twist + model.c_t * _dot(turning, normal)) * normal

    to_behind, to_ahead = model.gather
    total = (to_ahead - to_behind) @ force
    couple = to_ahead @ (_cross(arm_j, force) + moment) - to_behind @ (_cross(arm_i, force) + moment)
    return total, couple


def friction_coefficient(law: Friction, slip: Array, mu_s: Array, mu_k: Array, V: float) -> Array:
    """Coefficient of (3.2), or the cubic steps of the source's solver: 0 to μ_s at V, then to μ_k at 10 V."""
    if law == "thesis":
        return np.where(slip < V, mu_s, mu_k)
    rise, fall = np.minimum(slip / V, 1), np.clip((slip - V) / (9 * V), 0, 1)
    return mu_s * rise**2 * (3 - 2 * rise) + (mu_k - mu_s) * fall**2 * (3 - 2 * fall)


def normal_force(model: TileModel, depth: Array, free_speed: Array, dt: float) -> Array:
    """Contact law (3.1) on all contact points, never adhesive, linearly implicit in the speed off the plate."""
    share = len(model.contact_points)
    mm = 1e3 * np.maximum(depth, 0)
    spring = model.k_contact / share * mm**2.2
    slope = 2200 * model.k_contact / share * mm**1.2
    s = np.minimum(depth / model.contact_ramp, 1) if model.contact_ramp else np.ones_like(depth)
    resistance = model.c_contact / share * s**2 * (3 - 2 * s) + slope * dt
    force = (spring - resistance * free_speed) / (1 + dt * model.contact_mobility[0] * resistance)
    return np.where(depth > 0, np.maximum(force, 0), 0)


def plate_motion(time: float, A_p: Array, B_p: Array, omega: Array, ramp: float) -> tuple[Array, Array, Array, Array]:
    """Θ, X and their rates: (4.1) and (4.2) times a quintic start."""
    s = min(time / ramp, 1.0) if ramp else 1.0
    level, rate = s**3 * (10 - 15 * s + 6 * s**2), 30 * s**2 * (1 - s) ** 2 / ramp if ramp else 0.0
    sine, speed = np.sin(omega * time), omega * np.cos(omega * time)
    wave, wave_rate = level * sine, level * speed + rate * sine
    return -A_p * wave, B_p * wave, -A_p * wave_rate, B_p * wave_rate


# ------------------------------------------------------------------------------------------------------ runs


def run_tiles(
    model: TileModel,
    A_p: ArrayLike,
    B_p: ArrayLike,
    frequency: ArrayLike,
    *,
    mu_s: ArrayLike = 0.75,
    mu_k: ArrayLike = 0.40,
    V: float = 0.1,
    friction: Friction = "thesis",
    duration: float = 3.0,
    time_step: float = 4e-5,
    sample_interval: float = 2e-3,
    ramp_duration: float = 0.1,
    plate_height: float = 0.0,
    gravity: float = 9.81,
    offset: ArrayLike = 0.0,
) -> dict[str, Array]:
    """Run a batch of plate motions side by side, each from the flat sheet at rest.

    Parameters
    ----------
    A_p, B_p, frequency : floats or (runs,) arrays
        Angular amplitude (rad), linear amplitude (m) and frequency (Hz) of the plate.
    mu_s, mu_k : floats or (runs,) arrays
        Static and kinetic friction coefficients.
    V : float
        Friction transition velocity, m/s.
    friction
        Law (3.2), or the smooth law of the source's solver.
    duration, time_step, sample_interval, ramp_duration : floats
        Seconds. Semi-implicit Euler; 4e-5 s resolves Table 4.1 with the default ``shear_ratio``.
    plate_height : float
        Height of the plate's surface above the axis of Θ, m; the surface at rest is z = 0.
    gravity : float
        m/s².
    offset : (tiles, 3) or (runs, tiles, 3) array, optional
        Displacement of the tiles at the start, m, for ensembles.

    Returns
    -------
    dict of arrays
        ``time`` (samples,); ``position`` (runs, samples, tiles, 3), tile centres in the world;
        ``plate_angle`` and ``plate_shift`` (runs, samples), Θ and X.
    """
    given = (np.atleast_1d(np.asarray(a, dtype=float)) for a in (A_p, B_p, frequency, mu_s, mu_k))
    amplitude, shake, hertz, rough, slippery = np.broadcast_arrays(*given)
    runs, n, dt = len(hertz), len(model.rest), time_step
    omega, m, (I_x, I_z) = 2 * np.pi * hertz, model.node_mass, model.inertia
    points, (_, slip_mobility) = model.contact_points, model.contact_mobility

    x = np.zeros((runs, n, 3))
    x[..., :2] = model.rest * model.pitch
    # At the height where the spring of (3.1) carries the weight.
    x[..., 2] = -points[0, 2] - 1e-3 * (m * gravity / np.max(model.k_contact)) ** (1 / 2.2)
    x = np.ascontiguousarray(np.moveaxis(x + np.asarray(offset), 0, -1).swapaxes(0, 1))
    v, w, q = np.zeros_like(x), np.zeros_like(x), np.zeros((4, n, runs))
    q[0] = 1
    down = np.array([0, 0, -gravity])[:, None, None]

    def per_inertia(couple: Array, normal: Array) -> Array:
        return couple / I_x + (1 / I_z - 1 / I_x) * _dot(couple, normal) * normal

    every, steps = round(sample_interval / dt), round(duration / dt)
    kept: list[tuple[float, Array, Array, Array]] = []
    for step in range(steps + 1):
        time = step * dt
        angle, shift, angle_rate, shift_rate = plate_motion(time, amplitude, shake, omega, ramp_duration)
        if step % every == 0:
            kept.append((time, x, angle, shift))
        axes = _axes(q)
        force, couple = joint_forces(model, x, v, axes, w)
        couple -= (I_z - I_x) * _dot(w, axes[2]) * _cross(w, axes[2])

        # Where the step would end without the plate; then the plate's impulses at the contact points.
        v = v + dt * (force / m + down)
        w = w + dt * per_inertia(couple, axes[2])
        zero, sine, cosine = np.zeros(runs), np.sin(angle), np.cos(angle)
        up, spin = np.stack([zero, -sine, cosine])[:, None], np.stack([angle_rate, zero, zero])[:, None]
        impulse, angular_impulse = np.zeros_like(v), np.zeros_like(v)
        for p in points:
            arm = p[0] * axes[0] + p[1] * axes[1] + p[2] * axes[2]
            r = x + arm
            r[0] -= shift
            r[2] += plate_height  # from the axis of Θ
            u = v + _cross(w, arm) - _cross(spin, r)
            u[0] -= shift_rate
            speed_off = _dot(u, up)
            pressed = normal_force(model, plate_height - _dot(r, up), speed_off, dt)
            slip = u - speed_off * up
            slip_speed = np.sqrt(_dot(slip, slip) + 1e-20)
            # Friction may stop the slip of a step, never reverse it.
            mu = friction_coefficient(friction, slip_speed, rough, slippery, V)
            drag = np.minimum(mu * pressed, slip_speed / (dt * slip_mobility))
            push = dt * (pressed * up - (drag / slip_speed) * slip)
            impulse += push
            angular_impulse += _cross(arm, push)
        v = v + impulse / m
        w = w + per_inertia(angular_impulse, axes[2])
        x = x + dt * v
        q = _turn(q, dt * w)

    times, centres, angles, shifts = (np.array(a) for a in zip(*kept, strict=True))
    return {
        "time": times,
        "position": centres.transpose(3, 0, 2, 1),
        "plate_angle": angles.T,
        "plate_shift": shifts.T,
    }
