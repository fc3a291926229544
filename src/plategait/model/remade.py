"""A sheet of a material made anew of another modulus, density or thickness, where its joints are a material's.

A sheet keeps its joints and forgets what they were made of (`plategait.model.material`). Of an isotropic plate they
tell it: E and ν by the lattice's own shear ratio and k_c; k_b and k_t agree with both, or the sheet is no such plate.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import get_args

from plategait.errors import InputError
from plategait.model.material import Material
from plategait.model.sheet import Sheet
from plategait.units import Density, Quantity, YoungModulus

# Joints are a material's where they agree to rounding, in files to ten digits.
_SAME = 1e-6

_MODULUS: Quantity = get_args(YoungModulus)[1]
_DENSITY: Quantity = get_args(Density)[1]

OF_A_MATERIAL: Mapping[str, Quantity] = {"sheet.young_modulus": _MODULUS, "sheet.density": _DENSITY}
"""Names that a sheet of a material has beside its fields, and what they measure; its thickness is a field."""
THICKNESS = "sheet.thickness"


def material_of(sheet: Sheet) -> Material | None:
    """Material whose plate of this thickness has these joints; None where no isotropic material does.

    Its density is the mass over the lattice's squares and the thickness. Damping is not looked at.
    """
    r, h = sheet.shear_ratio, sheet.thickness
    # What `Material.joints` makes of ν, solved for it.
    nu = (1 - 2 * r * r) / (2 * r * r + 2 * r)
    if not -1 < nu <= 0.5 + _SAME:
        return None
    modulus = sheet.axial_stiffness * (1 + 2 * r) / (1 + r) / h
    density = sheet.mass / (sheet.area * h)
    if not (_MODULUS.at_least <= modulus <= _MODULUS.at_most and _DENSITY.at_least <= density <= _DENSITY.at_most):
        return None
    made = Material(name=sheet.name, young_modulus=modulus, poisson_ratio=min(nu, 0.5), density=density)
    joints = made.joints(h)
    alike = all(
        math.isclose(getattr(sheet, name), joints[name], rel_tol=_SAME)
        for name in ("bending_stiffness", "torsion_stiffness")
    )
    return made if alike else None


def remade(sheet: Sheet, told: Mapping[str, float]) -> Sheet:
    """Sheet of the same outline and pitch, of another modulus, density or thickness, and all else that follows.

    Parameters
    ----------
    told : mapping
        SI values by the names of `OF_A_MATERIAL`, and `THICKNESS`. What is not told stays: the modulus, the density and
        the loss factor at the frequencies to which it belongs.

    Raises
    ------
    InputError
        When the sheet's joints are those of no material.
    """
    made = material_of(sheet)
    if made is None or made.density is None:
        name, got = next(iter(told.items()))
        raise InputError(name, got, "left out for a sheet whose joints are told and not its material",
                         "young_modulus in its scenario file, or natural_frequency here")  # fmt: skip
    thickness = told.get(THICKNESS, sheet.thickness)
    modulus = told.get("sheet.young_modulus", made.young_modulus)
    density = told.get("sheet.density", made.density)
    joints = made.replace(young_modulus=modulus).joints(thickness)
    stiffer = modulus / made.young_modulus
    thicker, denser = thickness / sheet.thickness, density / made.density
    # c = k η/ω: of bending with ω² as D/(ρ h), in the plane with ω² as E/ρ.
    bending = math.sqrt(stiffer * thicker**3 * denser * thicker)
    return sheet.made_of(
        mass=sheet.mass * denser * thicker, thickness=thickness, **joints,
        bending_damping=sheet.bending_damping * bending, torsion_damping=sheet.torsion_damping * bending,
        axial_damping=sheet.axial_damping * thicker * math.sqrt(stiffer * denser),
    )  # fmt: skip
