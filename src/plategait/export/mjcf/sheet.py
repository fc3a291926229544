"""The sheet in MJCF: a body for each node of the lattice, and what joins them: springs and rods, or a shell."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from xml.etree import ElementTree as ET

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.export.mjcf.markup import Value, add
from plategait.model.lattice import Lattice
from plategait.model.scenario import Scenario

_COLOUR = (0.95, 0.8, 0.35, 1.0)
# A contact's share of what else pulls the node: small, so that spring and damper are those of a real one.
_IMPEDANCE = 0.01
# Where nothing rests: that of the source's cheese, m.
_WEIGHTLESS_DEPTH = 2e-5
# Nothing is drawn of the rods that bend.
_UNSEEN = (0.0, 0.0, 0.0, 0.0)


def add_bodies(world: ET.Element, scenario: Scenario, start: Array, *, contact: bool) -> list[str]:
    """Add a point mass for each node, with a sphere that touches the plate if wanted; give the names."""
    mass, radius = scenario.sheet.node_mass, 0.5 * scenario.sheet.thickness
    names = [f"node{k}" for k in range(len(start))]
    for name, where in zip(names, start, strict=True):
        body = add(world, "body", name=name, pos=tuple(where))
        # Three slides never turn: any inertia will do.
        add(body, "inertial", pos=(0.0, 0.0, 0.0), mass=mass, diaginertia=(0.4 * mass * radius**2,) * 3)
        for letter, axis in zip("xyz", np.eye(3), strict=True):
            add(body, "joint", name=f"{name}{letter}", type="slide", axis=tuple(axis))
        add(body, "site", name=name, size=(1e-4,), group=5)
        if contact:
            add(body, "geom", type="sphere", size=(radius,), rgba=_COLOUR, **contact_of(scenario))
    return names


def contact_of(scenario: Scenario) -> dict[str, Value]:
    """Attributes of a contact: (3.1) with the secant of its spring at rest, and Coulomb friction by μ_k."""
    sheet, contact = scenario.sheet, scenario.contact
    depth = contact.static_depth(sheet.node_mass, sheet.pitch, scenario.gravity) or _WEIGHTLESS_DEPTH
    share = sheet.pitch**2 / contact.tile_area
    spring = 1e-3 * share * contact.stiffness * (1e3 * depth) ** 2.2 / depth
    return {
        "contype": 1, "conaffinity": 0, "condim": 3, "priority": 1, "friction": (scenario.friction.kinetic, 0.0, 0.0),
        "solref": (-spring / sheet.node_mass, -share * contact.damping / sheet.node_mass),
        "solimp": (_IMPEDANCE, _IMPEDANCE, 0.001, 0.5, 2.0),
    }  # fmt: skip


def add_nodes(sections: Mapping[str, ET.Element], scenario: Scenario, names: Sequence[str]) -> None:
    """Add the lattice's joints: springs along grid and diagonals, rods along the grid's lines, the cells' torsion."""
    sheet, tendons, deformable = scenario.sheet, sections["tendon"], sections["deformable"]
    lattice, pitch = sheet.lattice, sheet.pitch
    for edges, length, share in (
        (lattice.axial_edges, pitch, 1.0),
        (lattice.diagonal_edges, math.sqrt(2) * pitch, sheet.shear_ratio),
    ):
        for edge in edges:
            spring = add(tendons, "spatial", springlength=length, stiffness=share * sheet.axial_stiffness,
                         damping=sheet.axial_damping, width=5e-4, rgba=_COLOUR)  # fmt: skip
            for node in edge:
                add(spring, "site", site=names[int(node)])
    if sheet.bending_stiffness > 0:
        # A rod of the section πr⁴/4 bends at each node as a joint of k_b does: E I = k_b l.
        radius = 0.5 * sheet.thickness
        young = sheet.bending_stiffness * pitch / (math.pi * radius**4 / 4)
        for i, line in enumerate(line for line in lattice.axial_lines if len(line) > 2):
            pairs = " ".join(f"{n} {n + 1}" for n in range(len(line) - 1))
            rod = add(deformable, "flex", name=f"line{i}", dim=1, radius=radius, element=pairs, rgba=_UNSEEN,
                      body=" ".join(names[node] for node in line))  # fmt: skip
            add(rod, "elasticity", young=young, damping=sheet.bending_damping / sheet.bending_stiffness)
            add(rod, "contact", contype=0, conaffinity=0, selfcollide="none")
    if sheet.torsion_stiffness > 0 or sheet.torsion_damping > 0:
        _add_torsion(tendons, scenario, names)


def _add_torsion(tendons: ET.Element, scenario: Scenario, names: Sequence[str]) -> None:
    """Add the torsion of each cell: its warp x1 - x2 - x3 + x4 has the energy k_t/l² warp²."""
    sheet = scenario.sheet
    per_square = 2 / sheet.pitch**2
    for cell in sheet.lattice.cells.tolist():
        for letter in "xyz":
            warp = add(tendons, "fixed", springlength=0.0, stiffness=per_square * sheet.torsion_stiffness,
                       damping=per_square * sheet.torsion_damping)  # fmt: skip
            for node, sign in zip(cell, (1.0, -1.0, -1.0, 1.0), strict=True):
                add(warp, "joint", joint=f"{names[node]}{letter}", coef=sign)


def add_shell(sections: Mapping[str, ET.Element], scenario: Scenario, names: Sequence[str]) -> None:
    """Add a shell of the same bending stiffness D = k_b and in-plane stiffness k_c, isotropic with ν = 0.

    Raises
    ------
    InputError
        When the lattice has no triangle, as a strip of one row has none.
    """
    sheet = scenario.sheet
    triangles = triangles_of(sheet.lattice)
    if not len(triangles):
        raise InputError("form", "a shell of a sheet without width", "nodes for such a sheet", '"nodes"')
    # E t³/12 = k_b and E t = k_c: a thickness that the joints have, beside the one that is drawn.
    bends = sheet.bending_stiffness > 0
    thickness = math.sqrt(12 * sheet.bending_stiffness / sheet.axial_stiffness) if bends else sheet.thickness
    damping = sheet.bending_damping / sheet.bending_stiffness if bends else sheet.axial_damping / sheet.axial_stiffness
    shell = add(sections["deformable"], "flex", name="sheet", dim=2, radius=0.5 * sheet.thickness, rgba=_COLOUR,
                body=" ".join(names), element=" ".join(map(str, triangles.ravel().tolist())))  # fmt: skip
    add(shell, "elasticity", young=sheet.axial_stiffness / thickness, poisson=0.0, thickness=thickness,
        damping=damping, elastic2d="both" if bends else "stretch")  # fmt: skip
    add(shell, "contact", selfcollide="none", **contact_of(scenario))


def triangles_of(lattice: Lattice) -> NDArray[np.int64]:
    """(n, 3) triangles counter-clockwise: two of each full square, with diagonals in turn, one where a corner lacks."""
    number, found = lattice.number, []
    columns, rows = number.shape
    for i in range(columns - 1):
        for j in range(rows - 1):
            a, b, c, d = (int(n) for n in (number[i, j], number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]))
            if min(a, b, c, d) >= 0:
                found += [(a, b, c), (a, c, d)] if (i + j) % 2 else [(a, b, d), (b, c, d)]
            elif sum(n >= 0 for n in (a, b, c, d)) == 3:
                found.append(tuple(n for n in (a, b, c, d) if n >= 0))
    return np.array(found, dtype=np.int64).reshape(-1, 3)
