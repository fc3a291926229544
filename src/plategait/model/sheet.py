"""The sheet: outline, size, mass and joints (section 3.2.2)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from pydantic import Field, model_validator

from plategait.errors import InputError
from plategait.model.base import Model, quantity_of, unknown_field
from plategait.model.lattice import Lattice
from plategait.model.material import DERIVED, KEYS, Material
from plategait.model.materials import material_told
from plategait.model.modes import Modes, free_modes
from plategait.model.outline import SHAPES, Outline, occupied_squares
from plategait.units import (
    ANGULAR_FREQUENCY,
    AxialDamping,
    AxialStiffness,
    BendingDamping,
    BendingStiffness,
    Length,
    Mass,
    Ratio,
    Thickness,
)

_NODES_FOR_DAMPING = 1500


class Sheet(Model):
    """A thin soft object: a lattice of mass nodes with Kelvin–Voigt joints between neighbours.

    The joints belong to one tile edge, whatever the pitch: the plate stiffness per width is D = k_b, the in-plane one
    k_c. So a finer pitch is the same material, and results converge. The sheet is an isotropic plate of Poisson ratio
    zero when ``torsion_stiffness == bending_stiffness``; the dissertation leaves torsion free.

    In its plane the lattice yields in shear by its diagonals, of stiffness ``shear_ratio`` times k_c and damping c_c.
    The joint of section 3.2.2 has no in-plane shear freedom: a ratio above 1 is nearer its rigid tiles.

    In place of the joints, and of the mass, a material can be told, here and in files: ``young_modulus``, ``density``,
    ``poisson_ratio``, ``loss_factor`` or ``damping_ratio``, or ``material`` by its name. See `from_material`.
    """

    also_read: ClassVar[tuple[str, ...]] = KEYS

    name: str = Field(default="sheet", description="what the results call it", examples=['"cheese"'])
    outline: Outline = Field(
        description=f"what it is cut to: {', '.join(SHAPES[:-1])} or {SHAPES[-1]}",
        examples=['{ shape = "disk", radius = "40 mm" }'],
    )
    mass: Mass = Field(description="M, whole mass, shared evenly by the nodes")
    pitch: Length = Field(default=0.01, description="l, distance between nodes")
    thickness: Thickness = Field(
        default=0.0025, description="d, drawn and used to convert measurements; contact is at mid-plane"
    )
    bending_stiffness: BendingStiffness = Field(description="k_b")
    bending_damping: BendingDamping = Field(default=0.0, description="c_b")
    axial_stiffness: AxialStiffness = Field(description="k_c")
    axial_damping: AxialDamping = Field(default=0.0, description="c_c")
    shear_ratio: Ratio = Field(
        default=1.0, description="in-plane stiffness of the diagonals over k_c: 1 is as stiff as compression"
    )
    torsion_stiffness: BendingStiffness = Field(default=0.0, description="k_t, free in the dissertation")
    torsion_damping: BendingDamping = Field(default=0.0, description="c_t")

    @model_validator(mode="before")
    @classmethod
    def _of_a_material(cls, data: Any) -> Any:
        return cls._fields_of_a_material(data) if isinstance(data, dict) and not data.keys().isdisjoint(KEYS) else data

    @classmethod
    def _fields_of_a_material(cls, data: Mapping[str, Any]) -> dict[str, Any]:
        """Every field of a sheet that is told its material, the joints and the mass that follow among them."""
        rest = {name: value for name, value in data.items() if name not in KEYS}
        for name in rest:
            if name not in cls.model_fields:
                raise unknown_field(cls, name)
            if name in DERIVED:
                raise InputError(name, rest[name], "left out where a material is told, as it follows",
                                 "leaving it out, or Sheet.from_material")  # fmt: skip
        material = material_told({name: value for name, value in data.items() if name in KEYS})
        if "mass" in rest and "density" in data:
            raise InputError("density", data["density"], "left out where the mass is told", "one of the two")
        if "mass" not in rest and material.density is None:
            raise InputError("density", "nothing", "given, or else the mass", 'density = "1100 kg/m^3"')
        thickness = quantity_of(cls, "thickness")
        if "thickness" not in rest or thickness is None:
            raise InputError("thickness", "nothing", "given with a material", 'thickness = "1 mm"')
        joints = material.joints(thickness.read(rest["thickness"], "thickness"))
        sheet = cls(**{"mass": 1.0, **rest, **joints})
        if material.density is not None and "mass" not in rest:
            sheet = sheet.made_of(mass=material.density * sheet.thickness * sheet.area)
        damping: dict[str, float] = {}
        if material.loss_factor:
            # A bar as long as the sheet rings lengthwise at π/L √(E/ρ).
            stretch = material.young_modulus * sheet.thickness * sheet.area / sheet.mass
            longest = sheet.pitch * max(sheet.lattice.occupied.shape)
            damping = material.damping(joints, sheet.quick_natural_frequency, math.pi / longest * math.sqrt(stretch))
        return {name: getattr(sheet, name) for name in cls.model_fields} | damping

    @classmethod
    def from_material(
        cls,
        outline: Outline,
        young_modulus: float | str | None = None,
        thickness: float | str | None = None,
        density: float | str | None = None,
        *,
        poisson_ratio: float | None = None,
        loss_factor: float | None = None,
        damping_ratio: float | None = None,
        mass: float | str | None = None,
        material: Material | str | None = None,
        pitch: float | str | None = None,
        name: str | None = None,
    ) -> Sheet:
        """Sheet of an isotropic material, its joints by plate theory (docs/materials.md).

        Parameters
        ----------
        outline : Disk, Ellipse, Rectangle, Polygon or Mask
            What it is cut to.
        young_modulus : float or str
            E, Pa; text may say "0.5 MPa". May be left out where `material` tells it, as may those below.
        thickness : float or str
            h, m.
        density : float or str
            ρ, kg/m³. A node weighs ρ h l²: the mass is that of the lattice's squares, so that the mass per area, and
            with it every frequency and pressure, is the material's; it comes to the outline's as the pitch shrinks.
        poisson_ratio : float, optional
            ν, 0.3 if nobody says. At 0 the lattice is the plate; docs/materials.md has the errors elsewhere.
        loss_factor : float, optional
            η at the dish mode's frequency; none is no damping.
        damping_ratio : float, optional
            ζ of the dish mode in its place, η/2.
        mass : float or str, optional
            Weighed mass in place of the density, kg.
        material : Material or str, optional
            A named one (`plategait materials`), whose numbers hold where nothing else is told.
        pitch : float or str, optional
            l, m; 10 mm.
        name : str, optional
            What the results call it.

        Raises
        ------
        InputError
            When a number is not as it must be, or two contradict each other, such as mass and density.

        Examples
        --------
        >>> from plategait.model.outline import Rectangle
        >>> sheet = Sheet.from_material(Rectangle(length="60 mm", width="40 mm"), "0.5 MPa", "1 mm", "1100 kg/m^3")
        >>> round(1e3 * sheet.mass, 3)
        2.64
        """
        told = {
            "young_modulus": young_modulus, "thickness": thickness, "density": density, "poisson_ratio": poisson_ratio,
            "loss_factor": loss_factor, "damping_ratio": damping_ratio, "mass": mass, "material": material,
            "pitch": pitch, "name": name,
        }  # fmt: skip
        if young_modulus is None and material is None:
            raise InputError("young_modulus", "nothing", "given, or else a material", '"0.5 MPa"')
        return cls(outline=outline, **{key: value for key, value in told.items() if value is not None})

    def model_post_init(self, context: object) -> None:
        """Lay out the lattice now, so that an outline without a sheet is refused at once."""
        _ = self.lattice

    @cached_property
    def lattice(self) -> Lattice:
        """Topology of the nodes."""
        return Lattice(occupied_squares(self.outline, self.pitch))

    def made_of(self, **fields: float) -> Sheet:
        """Same outline of another mass or other joints, of valid numbers: the nodes need not be laid out anew."""
        other = self.with_valid(**fields)
        other.__dict__["lattice"] = self.lattice
        return other

    @property
    def area(self) -> float:
        """Area of the lattice's squares, m²: near that of the outline, and the nearer the finer the pitch."""
        return self.lattice.n_nodes * self.pitch**2

    @property
    def node_mass(self) -> float:
        """Mass of one node m, kg."""
        return self.mass / self.lattice.n_nodes

    @cached_property
    def free_modes(self) -> Modes:
        """Free-vibration modes, with no plate and no gravity."""
        return free_modes(
            self.lattice, self.pitch, self.node_mass,
            self.bending_stiffness, self.bending_damping, self.torsion_stiffness, self.torsion_damping,
        )  # fmt: skip

    @property
    def natural_frequency(self) -> float:
        """First-order natural angular frequency ω_n, rad/s: of the dish mode, in which the sheet bends up and down.

        Of a sheet so much longer than wide that no mode is a dish, the lowest mode that bends it: `Modes.natural`.

        Raises
        ------
        InputError
            When no mode bends the sheet.
        """
        return self.free_modes.natural.omega

    @property
    def quick_natural_frequency(self) -> float:
        """`natural_frequency`, rad/s; of more nodes than take a second, that of the same sheet at a coarser pitch."""
        share = self.lattice.n_nodes / _NODES_FOR_DAMPING
        if share <= 1:
            return self.natural_frequency
        coarser: Sheet = self.replace(pitch=1.1 * self.pitch * math.sqrt(share))
        return coarser.natural_frequency

    def with_natural_frequency(self, omega: float | str, nominal: float | str | None = None) -> Sheet:
        """Same sheet, same mass, at another natural frequency: k_b scaled by the square, as in section 4.4.

        Parameters
        ----------
        omega : float or str
            Wanted ω_n, rad/s; text may say "10 pi rad/s" or "5 Hz".
        nominal : float or str, optional
            What this sheet's own ω_n is taken to be, rad/s. By default its `natural_frequency`, so that the result's
            is what was asked for. The dissertation calls Table 4.1's sheet 10π (its dish mode is 10.32π): pass
            ``10 * pi`` to scale exactly as it does.

        Raises
        ------
        InputError
            When a frequency is not as said, or the sheet has no bending stiffness to scale.
        """
        wanted = ANGULAR_FREQUENCY.read(omega, "natural_frequency")
        own = self.natural_frequency if nominal is None else ANGULAR_FREQUENCY.read(nominal, "nominal")
        if own == 0 or self.bending_stiffness == 0:
            raise InputError("bending_stiffness", self.bending_stiffness, "above 0 to be scaled to a natural frequency",
                             '"2.72e-3 N*mm/deg"')  # fmt: skip
        ratio = wanted / own
        scaled: Sheet = self.replace(
            bending_stiffness=self.bending_stiffness * ratio * ratio,
            torsion_stiffness=self.torsion_stiffness * ratio * ratio,
        )
        return scaled

    @cached_property
    def stable_time_step(self) -> float:
        """Largest time step at which the joints are stable, s.

        The lattice's eigenvalues are bounded by ω² ≤ (4 (1 + r) k_c + 32 (k_b + k_t)/l²)/m and
        γ ≤ (8 c + 32 (c_b + c_t)/l²)/m, with r the `shear_ratio` and the axial damping implicit for each pair of nodes,
        c = c_c/(1 + 2 c_c dt/m). A line of springs k has eigenvalues of at most 4 k; the grid's two directions are
        perpendicular, so that together they have no more, 4 k_c, and the diagonals likewise 4 r k_c. Semi-implicit
        Euler with explicit damping is stable while 2 γ dt + ω² dt² < 4, a cubic in dt. The contact is implicit and
        sets no limit.
        """
        per_pitch = 32 / self.pitch**2
        axial = 8 * self.axial_damping / self.node_mass
        bending = per_pitch * (self.bending_damping + self.torsion_damping) / self.node_mass
        in_plane = 4 * (1 + self.shear_ratio) * self.axial_stiffness
        squared = (in_plane + per_pitch * (self.bending_stiffness + self.torsion_stiffness)) / self.node_mass
        # In steps of the limit that explicit dampers would have, all coefficients are of the order of 1.
        unit = 4 / (axial + bending + math.sqrt((axial + bending) ** 2 + 4 * squared))
        axial, bending, squared = axial * unit, bending * unit, squared * unit**2
        cubic = (axial * squared / 4, squared + axial * bending / 2, axial + 2 * bending, -4.0)
        slope = (3 * cubic[0], 2 * cubic[1], cubic[2])
        # Newton's rule on what rises and bends upward; the root lies between 1 and 2.
        x = 2.0
        for _ in range(8):
            x -= float(np.polyval(cubic, x) / np.polyval(slope, x))
        return unit * x
