"""Similarity: the dimensionless groups of a scenario, and the scenario of another size that moves alike."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from plategait.errors import InputError
from plategait.model.lattice import Lattice
from plategait.model.outline import Disk, Mask, Outline, Polygon
from plategait.model.scenario import Scenario
from plategait.model.sheet import Sheet

Kept = Literal["contact", "friction", "gravity", "height", "stroke"]
KEPT: tuple[Kept, ...] = ("contact", "friction", "height", "stroke", "gravity")
"""What a laboratory does not change with the object, and what may so break similarity."""


@dataclass(frozen=True)
class Groups:
    """The numbers that decide how an object moves, whatever its size.

    Lengths are over the radius r of `equivalent_radius`, times over √(r/g).

    Attributes
    ----------
    amplitude : float
        A_p, rad.
    acceleration : float
        Γ = r A_p ω_p²/g, the plate's greatest acceleration at the rim over gravity: the frequency's group.
    stroke, height : float
        B_p/r, and the height of the plate over its axis, over r.
    stiffness : float
        ω_n √(r/g): stiffness against weight.
    damping : float
        Damping ratio of the mode of ω_n.
    static, ratio : float
        μ_s and β.
    transition : float
        V/√(g r).
    depth : float
        How deep the contact lets the object sink at rest, over r.
    """

    amplitude: float
    acceleration: float
    stroke: float
    height: float
    stiffness: float
    damping: float
    static: float
    ratio: float
    transition: float
    depth: float


def equivalent_radius(lattice: Lattice, pitch: float) -> float:
    """Radius of the disk with the same radius of gyration about its centre, m: √2 of the r.m.s. distance of the area.

    Of a disk it is the radius, and of no shape does it depend on how the object lies.
    """
    x = lattice.rest - lattice.rest.mean(axis=0)
    # Each node stands for a square of the pitch, which has a sixth of its square about its own middle.
    return pitch * math.sqrt(2 * (float(np.mean(np.sum(x**2, axis=1))) + 1 / 6))


def elongation(lattice: Lattice) -> float:
    """Length over width of the ellipse with the same moments of area; 1 for a disk or a square."""
    x = lattice.rest - lattice.rest.mean(axis=0)
    least, most = np.linalg.eigvalsh(x.T @ x / len(x) + np.eye(2) / 12)
    return math.sqrt(most / least)


def bending_over_weight(sheet: Sheet, gravity: float) -> float:
    """√(D/(ρ g r³)) with the plate stiffness D = k_b and the mass per area ρ: of a disk a seventh of its ω_n √(r/g)."""
    radius = equivalent_radius(sheet.lattice, sheet.pitch)
    return math.sqrt(sheet.bending_stiffness * sheet.area / (sheet.mass * gravity * radius**3))


def groups(scenario: Scenario) -> Groups:
    """Dimensionless groups of a scenario whose plate turns about the bar and shakes along it."""
    sheet, motion, friction, g = scenario.sheet, scenario.motion, scenario.friction, scenario.gravity
    if g <= 0:
        raise InputError("gravity", g, "above 0 for groups that are made with it", "9.81")
    radius, mode = equivalent_radius(sheet.lattice, sheet.pitch), sheet.free_modes.natural
    return Groups(
        amplitude=motion.angle,
        acceleration=radius * motion.angle * (2 * math.pi * motion.frequency) ** 2 / g,
        stroke=motion.stroke / radius,
        height=motion.height / radius,
        stiffness=mode.omega * math.sqrt(radius / g),
        damping=mode.damping_ratio,
        static=friction.static,
        ratio=friction.ratio,
        transition=friction.transition_speed / math.sqrt(g * radius),
        depth=scenario.contact.static_depth(sheet.node_mass, sheet.pitch, g) / radius,
    )


def frequency_at(scenario: Scenario, acceleration: float) -> float:
    """Plate frequency at which Γ is so much, Hz."""
    radius = equivalent_radius(scenario.sheet.lattice, scenario.sheet.pitch)
    return math.sqrt(acceleration * scenario.gravity / (radius * scenario.motion.angle)) / (2 * math.pi)


def similar(scenario: Scenario, factor: float, *, keep: Collection[Kept] = ()) -> Scenario:
    """Scenario of an object so many times as large in all its lengths, with the same groups: it moves alike.

    All lengths take the factor, all times its root (gravity stays), all masses its cube. Its spin rates are those of
    the original over the root of the factor. Outlines from pictures scale as well.

    Parameters
    ----------
    scenario : Scenario
        Of a plate moved by sines on `angle` and `stroke` alone.
    factor : float
        Above 0.
    keep : collection of {"contact", "friction", "gravity", "height", "stroke"}
        What stays as it is, and so breaks the similarity: stiffness and damping of the contact, V, the height of the
        plate, B_p. With "gravity" no time is scaled, and Γ grows with the size.

    Raises
    ------
    InputError
        For a factor not above 0, a name that is none of these, or a plate that moves otherwise.
    """
    if not (factor > 0 and math.isfinite(factor)):
        raise InputError("factor", factor, "above 0", "2.0")
    for name in keep:
        if name not in KEPT:
            raise InputError("keep", name, f"some of {', '.join(KEPT)}", KEPT[0])
    if scenario.motion.waves or scenario.motion.samples:
        raise InputError("motion", "waves or samples", "angle and stroke alone", "a scenario without them")
    s, t = factor, 1.0 if "gravity" in keep else math.sqrt(factor)
    force = s**4 / t**2
    sheet, motion, contact, friction = scenario.sheet, scenario.motion, scenario.contact, scenario.friction
    changes: dict[str, Any] = {
        "sheet": sheet.replace(
            outline=_scaled(sheet.outline, s), pitch=s * sheet.pitch, thickness=s * sheet.thickness,
            mass=s**3 * sheet.mass,
            bending_stiffness=force * s * sheet.bending_stiffness,
            bending_damping=force * s * t * sheet.bending_damping,
            torsion_stiffness=force * s * sheet.torsion_stiffness,
            torsion_damping=force * s * t * sheet.torsion_damping,
            axial_stiffness=force / s * sheet.axial_stiffness, axial_damping=force * t / s * sheet.axial_damping,
        ),
        "motion.frequency": motion.frequency / t, "motion.ramp": t * motion.ramp,
        "start.x": s * scenario.start.x, "start.y": s * scenario.start.y,
        "duration": t * scenario.duration, "slip_limit": s * scenario.slip_limit, "time_step": t * scenario.dt,
        "transient": None if scenario.transient is None else t * scenario.transient,
        "plate": scenario.plate and {"length": s * scenario.plate.length, "width": s * scenario.plate.width},
    }  # fmt: skip
    if "contact" not in keep:
        # A node has s² of the tile's area; the force goes with the depth to the 2.2.
        changes |= {"contact.stiffness": force / s**4.2 * contact.stiffness,
                    "contact.damping": force * t / s**3 * contact.damping,
                    "contact.damping_ramp": s * contact.damping_ramp}  # fmt: skip
    if "friction" not in keep:
        changes["friction.transition_speed"] = s / t * friction.transition_speed
    if "height" not in keep:
        changes["motion.height"] = s * motion.height
    if "stroke" not in keep:
        changes["motion.stroke"] = s * motion.stroke
    return scenario.replace(**changes)


def _scaled(outline: Outline, factor: float) -> Outline:
    """Outline with all its lengths times a factor."""
    if isinstance(outline, Polygon):
        return outline.replace(corners=tuple((factor * x, factor * y) for x, y in outline.corners))
    if isinstance(outline, Disk):
        return outline.replace(radius=factor * outline.radius)
    if isinstance(outline, Mask):
        return outline.replace(width_of_picture=factor * outline.width_of_picture)
    return outline.replace(length=factor * outline.length, width=factor * outline.width)
