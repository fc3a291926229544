"""Physics of the reference engine: rigid tiles hinged at their edges, as section 3.2.2 draws them, in plain NumPy.

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
from numpy.typing import NDArray

from plategait.arrays import Array

Coefficient = float | Array
Friction = Literal["thesis", "adams"]

# Rounds of the power method, after which the fastest rates stand still within a percent.
_POWER_STEPS = 100


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
        From 1 to 40 the highest spin rates rise by less than a tenth. A penalty in place of the rigid joint, and not
        `Sheet.shear_ratio`, which is the stiffness of the lattice's diagonals: tiles have none, so `tile_runs` refuses
        a sheet that sets it.
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
    def swivel(self) -> tuple[Coefficient, Coefficient]:
        """Stiffness and damping of the joint about the sheet's normal: those of its edge, held along its length."""
        lever = (self.pitch / 2) ** 2 / 3
        return self.shear_ratio * self.k_c * lever, self.c_c * lever

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
    """Free out-of-plane modes of one sheet at small angles, no plate and no damping.

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
    k_b, k_t = np.asarray(model.k_b).item(), np.asarray(model.k_t).item()
    stiffness = k_b * bend.T @ bend + k_t * twist.T @ twist
    square, vectors = np.linalg.eigh(basis.T @ stiffness @ basis)
    return np.sqrt(np.maximum(square, 0)), (basis @ vectors)[:n].T


# --------------------------------------------------------------------------------------------------- vectors


def _cross(a: Array, b: Array) -> Array:
    product = np.empty(np.broadcast_shapes(a.shape, b.shape))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        np.multiply(a[j], b[k], out=product[i])
        product[i] -= a[k] * b[j]
    return product


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


@dataclass(frozen=True, eq=False)
class Pull:
    """What the joints do to the tiles.

    Attributes
    ----------
    force, couple : (3, n, runs) arrays
        On every tile, N and N m.
    gap : (3, joints, runs) array
        Between the edges, m.
    stretch : (joints, runs) array
        Part of the gap along the joint, m.
    bend, swivel, twist : (joints, runs) arrays
        Angles about the edge, the sheet's normal and the joint, rad.
    rates : (6, joints, runs) array
        Of the gap, the bend, the swivel and the twist.
    """

    force: Array
    couple: Array
    gap: Array
    stretch: Array
    bend: Array
    swivel: Array
    twist: Array
    rates: Array


def joint_forces(model: TileModel, x: Array, v: Array, axes: tuple[Array, Array, Array], w: Array) -> Pull:
    """Forces and moments of the joint units on every tile (section 3.2.2).

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
    stretch = _dot(gap, normal)
    force = -(ratio * k_c * gap + c_c * opening) + (ratio - 1) * k_c * stretch * normal

    # Bending by the angle between the tiles, true when large: θ / sin θ with sin θ = |a_i × a_j|.
    fold = _cross(a_i, a_j)
    sine, cosine = np.sqrt(_dot(fold, fold)), _dot(a_i, a_j)
    fold *= np.where(sine > 1e-9, np.arctan2(sine, cosine) / np.maximum(sine, 1e-9), 1.0)
    bend, swivel = _dot(fold, edge), _dot(fold, across)
    rates = np.concatenate([opening, [_dot(turning, edge), _dot(turning, across), _dot(turning, normal)]])
    swivel_k, swivel_c = model.swivel
    moment = -(model.k_b * bend + model.c_b * rates[3]) * edge
    moment -= (swivel_k * swivel + swivel_c * rates[4]) * across
    twist = np.zeros_like(bend)
    if np.any(model.k_t) or np.any(model.c_t):
        twist = _dot(_cross(e_z[:, behind], e_z[:, ahead]), normal)
        moment -= (model.k_t * twist + model.c_t * rates[5]) * normal

    to_behind, to_ahead = model.gather
    total = (to_ahead - to_behind) @ force
    couple = to_ahead @ (_cross(arm_j, force) + moment) - to_behind @ (_cross(arm_i, force) + moment)
    return Pull(total, couple, gap, stretch, bend, swivel, twist, rates)


def joint_energy(model: TileModel, pull: Pull) -> tuple[Array, Array, Array]:
    """Energy stored in compression (and what holds the joints together), bending and torsion, (runs,) arrays, J."""
    ratio, (swivel_k, _) = model.shear_ratio, model.swivel
    held = ratio * _dot(pull.gap, pull.gap) - (ratio - 1) * pull.stretch**2
    axial = 0.5 * (model.k_c * held + swivel_k * pull.swivel**2).sum(axis=0)
    return axial, 0.5 * (model.k_b * pull.bend**2).sum(axis=0), 0.5 * (model.k_t * pull.twist**2).sum(axis=0)


def joint_loss(model: TileModel, pull: Pull, after: Array, dt: float) -> Array:
    """Energy that the dampers took over a step, (runs,) array, J, by the rates midway to those `after` it."""
    gap, (bend, swivel, twist) = np.split((pull.rates * (pull.rates + after)).sum(axis=1), 2)
    return dt / 2 * (model.c_c * gap.sum(axis=0) + model.c_b * bend + model.swivel[1] * swivel + model.c_t * twist)


def stable_step(model: TileModel) -> Array:
    """Longest time step of each run, (runs,) array, s: the joints of a flat sheet are stable under semi-implicit Euler.

    From the highest natural frequency ω and the highest rate of decay λ, by the power method: ω² dt² + 2 λ dt < 4.
    """
    n, (I_x, I_z), small = len(model.rest), model.inertia, 1e-6
    runs = max(np.size(c) for c in (model.k_c, model.c_c, model.k_b, model.c_b, model.k_t, model.c_t))
    root = np.sqrt([model.node_mass] * 3 + [I_x, I_x, I_z])[:, None, None]
    flat = np.zeros((3, n, runs))
    flat[:2] = (model.rest.T * model.pitch)[..., None]
    level = np.zeros((4, n, runs))
    level[0] = 1

    def highest(moves: bool) -> Array:
        u = np.random.default_rng(0).normal(size=(6, n, runs))
        growth = np.zeros(runs)
        for _ in range(_POWER_STEPS):
            u /= np.sqrt((u**2).sum(axis=(0, 1)))
            shift, turn = np.split(small * u / root, 2)
            if moves:
                pull = joint_forces(model, flat + shift, 0 * flat, _axes(_turn(level, turn)), 0 * flat)
            else:
                pull = joint_forces(model, flat, shift, _axes(level), turn)
            u = -np.concatenate([pull.force, pull.couple]) / (small * root)
            growth = np.sqrt((u**2).sum(axis=(0, 1)))
        return growth

    square, decay = highest(True), highest(False)
    return (np.sqrt(decay**2 + 4 * square) - decay) / square


def friction_coefficient(law: Friction, slip: Array, mu_s: Array, mu_k: Array, V: float, ratio: float = 10.0) -> Array:
    """Coefficient of (3.2), or the cubic steps of the source's solver: 0 to μ_s at V, then to μ_k at `ratio` V."""
    if law == "thesis":
        return np.where(slip < V, mu_s, mu_k)
    rise, fall = np.minimum(slip / V, 1), np.clip((slip - V) / ((ratio - 1) * V), 0, 1)
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


def contact_energy(model: TileModel, depth: Array) -> Array:
    """Energy stored in the contact (3.1) at every contact point, J."""
    return 1e-3 / 3.2 * model.k_contact / len(model.contact_points) * (1e3 * np.maximum(depth, 0)) ** 3.2
