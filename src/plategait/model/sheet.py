"""The sheet: outline, size, mass and joints (section 3.2.2)."""

from __future__ import annotations

import math
from functools import cached_property

import numpy as np
from pydantic import Field

from plategait.errors import InputError
from plategait.model.base import Model
from plategait.model.lattice import Lattice
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
)


class Sheet(Model):
    """A thin soft object: a lattice of mass nodes with Kelvin–Voigt joints between neighbours.

    The joints belong to one tile edge, whatever the pitch: the plate stiffness per width is D = k_b, the in-plane one
    k_c. So a finer pitch is the same material, and results converge. The sheet is an isotropic plate of Poisson ratio
    zero when ``torsion_stiffness == bending_stiffness``; the dissertation leaves torsion free.

    In its plane the lattice yields in shear by its diagonals, of stiffness ``shear_ratio`` times k_c and damping c_c.
    The joint of section 3.2.2 has no in-plane shear freedom: a ratio above 1 is nearer its rigid tiles.
    """

    name: str = Field(default="sheet", description="what the results call it", examples=['"cheese"'])
    outline: Outline = Field(
        description=f"what it is cut to: {', '.join(SHAPES[:-1])} or {SHAPES[-1]}",
        examples=['{ shape = "disk", radius = "40 mm" }'],
    )
    mass: Mass = Field(description="M, whole mass, shared evenly by the nodes")
    pitch: Length = Field(default=0.01, description="l, distance between nodes")
    thickness: Length = Field(
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
