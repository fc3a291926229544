"""What a sheet is made of: from modulus, density and thickness to the lattice's joints, by plate theory.

An isotropic plate of Young's modulus E, Poisson's ratio ν and thickness h has D = E h³/(12 (1 − ν²)) and in its plane
E h. Its energy of bending per area is D/2 (w_xx² + w_yy² + 2 ν w_xx w_yy + 2 (1 − ν) w_xy²), the lattice's
k_b/2 (w_xx² + w_yy²) + k_t w_xy²: the same for k_b = D and k_t = (1 − ν) D but for the term that couples the two
curvatures, which no joint has. docs/materials.md tells what that costs.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from pydantic import Field

from plategait.model.base import Model
from plategait.units import Density, LossFactor, PoissonRatio, YoungModulus

DAMPING_RATIO = "damping_ratio"
USUAL_POISSON_RATIO = 0.3


class Material(Model):
    """An isotropic, linearly elastic material of small strain.

    Source: plate theory; docs/materials.md has each law.

    Examples
    --------
    >>> silicone = Material(young_modulus="0.5 MPa", density="1100 kg/m^3", poisson_ratio=0.5)
    >>> round(1e6 * silicone.plate_stiffness(1e-3), 1)  # N µm, per width
    55.6
    """

    name: str = Field(default="material", description="what it is called", examples=['"silicone"'])
    young_modulus: YoungModulus = Field(description="E")
    poisson_ratio: PoissonRatio = Field(default=USUAL_POISSON_RATIO, description="ν")
    density: Density | None = Field(default=None, description="ρ; not needed where the sheet's mass is told")
    loss_factor: LossFactor | None = Field(
        default=None,
        description="η = tan δ at the frequency of the sheet's dish mode; no damping if left out",
    )

    def plate_stiffness(self, thickness: float) -> float:
        """D = E h³/(12 (1 − ν²)) of a plate of thickness h in m: N·m, the moment per width over the curvature."""
        return self.young_modulus * thickness**3 / (12 * (1 - self.poisson_ratio**2))

    def joints(self, thickness: float) -> dict[str, float]:
        """Elastic joints of a sheet of this thickness (m), by the names of its fields, whatever its pitch.

        Returns
        -------
        dict of str to float
            ``bending_stiffness`` k_b = D and ``torsion_stiffness`` k_t = (1 − ν) D, N·m/rad; ``axial_stiffness`` k_c,
            N/m, and ``shear_ratio`` r, of which the lattice's Young's modulus along its lines, k_c (1 + 2r)/(1 + r) per
            width, is E h, and its shear modulus, r k_c, is E h/(2 (1 + ν)).
        """
        nu, bending = self.poisson_ratio, self.plate_stiffness(thickness)
        ratio = (math.sqrt(nu * nu + 2 * (1 + nu)) - nu) / (2 * (1 + nu))
        return {
            "bending_stiffness": bending,
            "torsion_stiffness": (1 - nu) * bending,
            "axial_stiffness": self.young_modulus * thickness * (1 + ratio) / (1 + 2 * ratio),
            "shear_ratio": ratio,
        }

    def damping(
        self, joints: Mapping[str, float], natural_frequency: float, in_plane_frequency: float
    ) -> dict[str, float]:
        """Dampers of those joints by the loss factor η, c = k η/ω each.

        Parameters
        ----------
        joints : mapping
            As `joints` gives them.
        natural_frequency : float
            ω_n, rad/s, at which bending and torsion have the loss factor η: the dish mode's damping ratio is η/2.
            Kelvin–Voigt joints have one relaxation time: at another frequency the loss factor is η ω/ω_n.
        in_plane_frequency : float
            rad/s, at which the axial joints have it, far above: dampers tuned to ω_n would be as stiff as walls there.
        """
        loss = self.loss_factor or 0.0
        return {
            "bending_damping": loss / natural_frequency * joints["bending_stiffness"],
            "torsion_damping": loss / natural_frequency * joints["torsion_stiffness"],
            "axial_damping": loss / in_plane_frequency * joints["axial_stiffness"],
        }


KEYS = ("material", *(name for name in Material.model_fields if name != "name"), DAMPING_RATIO)
"""What a sheet may be told in place of its joints, and of its mass."""

DERIVED = (
    "bending_stiffness", "bending_damping", "axial_stiffness", "axial_damping", "shear_ratio", "torsion_stiffness",
    "torsion_damping",
)  # fmt: skip
"""What a sheet is then not told, as it follows."""
