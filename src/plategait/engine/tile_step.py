"""One time step of rigid tiles on the plate: their joints, the plate's impulses, and the work of both."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from plategait.engine.tiles import (
    Array,
    Friction,
    Pull,
    TileModel,
    _axes,
    _cross,
    _dot,
    _turn,
    friction_coefficient,
    joint_forces,
    normal_force,
    plate_motion,
)


@dataclass(frozen=True, eq=False)
class Plate:
    """How the plates of a batch move and rub.

    Attributes
    ----------
    angle, stroke, omega, mu_s, mu_k : (runs,) arrays
        A_p, B_p, ω_p, rad, m and rad/s; friction coefficients.
    ramp, height, gravity, V, ratio : floats
        Duration of the smooth start, s; height of the surface above the axis of Θ, m; m/s²; friction's transition
        speed, m/s, and where the smooth law ends over it.
    law : {"thesis", "adams"}
        (3.2), or the smooth law of the source's solver.
    """

    angle: Array
    stroke: Array
    omega: Array
    mu_s: Array
    mu_k: Array
    ramp: float
    height: float
    gravity: float
    V: float
    ratio: float
    law: Friction

    def across(self, x: Array, time: float) -> Array:
        """(n, runs) places across the bar, in the plate frame."""
        angle = self.pose(time)[0]
        return np.cos(angle) * x[1] + np.sin(angle) * (x[2] + self.height)

    def pose(self, time: float) -> tuple[Array, Array, Array, Array]:
        """Θ, X and their rates."""
        return plate_motion(time, self.angle, self.stroke, self.omega, self.ramp)


@dataclass(frozen=True, eq=False)
class Tiles:
    """Places and velocities (3, n, runs) of tiles, their attitudes (4, n, runs) and angular velocities (3, n, runs)."""

    x: Array
    v: Array
    q: Array
    w: Array

    @cached_property
    def axes(self) -> tuple[Array, Array, Array]:
        """Two axes in the plane of each tile, and its normal."""
        return _axes(self.q)

    def pull(self, model: TileModel) -> Pull:
        """What the joints do."""
        return joint_forces(model, self.x, self.v, self.axes, self.w)


@dataclass(frozen=True, eq=False)
class Work:
    """What the plate did over a step: (runs,) arrays, J; and which tiles it touched, (n, runs)."""

    contact: Array
    friction: Array
    plate: Array
    touched: NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class _Touch:
    """Forces at one contact point of each tile, and what is needed for their work."""

    arm: Array | None
    pressed: Array
    drag: Array
    ground: Array

    def at_point(self, v: Array, w: Array) -> Array:
        """Velocity of the point."""
        return v if self.arm is None else v + _cross(w, self.arm)


def step(model: TileModel, plate: Plate, tiles: Tiles, pull: Pull, time: float, dt: float) -> tuple[Tiles, Work]:
    """Semi-implicit Euler from `time`, at which the joints `pull`: the plate's impulses after the joints'."""
    m, (I_x, I_z), axes = model.node_mass, model.inertia, tiles.axes
    couple = pull.couple - (I_z - I_x) * _dot(tiles.w, axes[2]) * _cross(tiles.w, axes[2])

    def per_inertia(moment: Array) -> Array:
        return moment / I_x + (1 / I_z - 1 / I_x) * _dot(moment, axes[2]) * axes[2]

    # Where the step would end without the plate.
    v = tiles.v + dt * (pull.force / m + np.array([0, 0, -plate.gravity])[:, None, None])
    w = tiles.w + dt * per_inertia(couple)
    angle, shift, angle_rate, shift_rate = plate.pose(time)
    zero = np.zeros_like(angle)
    up = np.stack([zero, -np.sin(angle), np.cos(angle)])[:, None]
    spin = np.stack([angle_rate, zero, zero])[:, None]
    origin = np.stack([shift, zero, zero - plate.height])[:, None]
    touches = [
        _touch(model, plate, tiles.x, v, w, axes, p, up, spin, origin, shift_rate, dt) for p in model.contact_points
    ]
    for touch in touches:
        push = dt * (touch.pressed * up - touch.drag)
        v = v + push / m
        if touch.arm is not None:
            w = w + per_inertia(_cross(touch.arm, push))
    # By the velocity midway, work and kinetic energy agree.
    work = _work(touches, up, (tiles.v + v) / 2, (tiles.w + w) / 2, dt)
    return Tiles(tiles.x + dt * v, v, _turn(tiles.q, dt * w), w), work


def _touch(
    model: TileModel, plate: Plate, x: Array, v: Array, w: Array, axes: tuple[Array, Array, Array], point: Array,
    up: Array, spin: Array, origin: Array, shift_rate: Array, dt: float,
) -> _Touch:  # fmt: skip
    """Force of the plate at one contact point of every tile, by where the step would end without it."""
    arm = point[0] * axes[0] + point[1] * axes[1] + point[2] * axes[2] if np.any(point) else None
    r = (x if arm is None else x + arm) - origin  # from the axis of Θ
    ground = _cross(spin, r)
    ground[0] += shift_rate
    u = (v if arm is None else v + _cross(w, arm)) - ground
    speed_off = _dot(u, up)
    pressed = normal_force(model, plate.height - _dot(r, up), speed_off, dt)
    slip = u - speed_off * up
    slip_speed = np.sqrt(_dot(slip, slip) + 1e-20)
    # Friction may stop the slip of a step, never reverse it.
    mu = friction_coefficient(plate.law, slip_speed, plate.mu_s, plate.mu_k, plate.V, plate.ratio)
    drag = np.minimum(mu * pressed, slip_speed / (dt * model.contact_mobility[1]))
    return _Touch(arm, pressed, (drag / slip_speed) * slip, ground)


def _work(touches: list[_Touch], up: Array, v: Array, w: Array, dt: float) -> Work:
    """Work of the plate's forces over a step of mean velocities v and w."""
    contact, friction, plate = 0.0, 0.0, 0.0
    for touch in touches:
        u = touch.at_point(v, w) - touch.ground
        contact = contact - dt * (touch.pressed * _dot(u, up)).sum(axis=0)
        friction = friction + dt * _dot(touch.drag, u).sum(axis=0)
        plate = plate + dt * _dot(touch.pressed * up - touch.drag, touch.ground).sum(axis=0)
    touched = np.any([touch.pressed > 0 for touch in touches], axis=0)
    return Work(contact, friction, plate, touched)  # type: ignore[arg-type]
