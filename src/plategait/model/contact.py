"""Contact and friction between sheet and plate (section 3.2.3)."""

from __future__ import annotations

import math
from typing import Annotated, Literal

from pydantic import Field, model_validator

from plategait.errors import InputError
from plategait.model.base import Model
from plategait.published import FRICTION_RATIO
from plategait.units import ANGLE, Area, AxialDamping, AxialStiffness, Coefficient, Depth, Quantity, Speed


class Contact(Model):
    """Kelvin–Voigt contact of (3.1), f = k a^2.2 + c da/dt with the depth a in mm, never adhesive.

    `stiffness` times 1 mm is the force at a depth of 1 mm. Both belong to one tile of `tile_area`; a lattice of another
    pitch takes its share, so that the force per area stays.
    """

    stiffness: AxialStiffness = Field(default=11860.0, description="k_contact of one tile, force at 1 mm over 1 mm")
    damping: AxialDamping = Field(default=7.65, description="c_contact of one tile")
    damping_ramp: Depth = Field(
        default=0.0, description="depth over which the damping rises to its full value (0: at once)"
    )
    tile_area: Area = Field(default=1e-4, description="area of the tile that stiffness and damping belong to")

    def static_depth(self, node_mass: float, pitch: float, gravity: float) -> float:
        """Depth at which a node at rest is carried, m."""
        force_at_1mm = self.stiffness * 1e-3 * pitch**2 / self.tile_area
        return 1e-3 * (node_mass * gravity / force_at_1mm) ** (1 / 2.2)


class Friction(Model):
    """Coulomb friction with a transition in slip speed (3.2).

    ``law="thesis"``: μ_s below `transition_speed`, μ_k at and above it, nothing at rest, and never more than stops the
    slip within a step. ``law="adams"``: the smooth form of the source's solver, 0 → μ_s over `transition_speed`,
    μ_s → μ_k up to `kinetic_speed_ratio` times it.
    """

    static: Coefficient = Field(default=0.75, description="mu_s")
    kinetic: Coefficient = Field(default=0.40, description="mu_k, at most mu_s")
    transition_speed: Speed = Field(default=0.1, description="V, where static friction ends")
    kinetic_speed_ratio: Annotated[float, Quantity("", "", "10", above=1)] = Field(
        default=10.0, description="of the smooth law: full mu_k at this multiple of V"
    )
    law: Literal["thesis", "adams"] = Field(default="thesis", description='"thesis" (3.2) or "adams" (smooth)')

    @model_validator(mode="after")
    def _kinetic_below_static(self) -> Friction:
        if self.kinetic > self.static:
            raise InputError("kinetic", self.kinetic, f"at most the static coefficient {self.static:g}",
                             f"{FRICTION_RATIO * self.static:.3g}")  # fmt: skip
        return self

    @property
    def angle(self) -> float:
        """Friction angle α = atan μ_s, rad."""
        return math.atan(self.static)

    @property
    def ratio(self) -> float:
        """β = μ_k/μ_s (1 where there is no friction)."""
        return self.kinetic / self.static if self.static else 1.0

    def with_angle(self, angle: float | str) -> Friction:
        """Same law at another friction angle α, with β kept, as in section 4.5."""
        alpha = ANGLE.read(angle, "angle")
        if not 0 <= alpha < math.pi / 2:
            raise InputError("angle", angle, "at least 0 deg and below 90 deg", '"36.87 deg"')
        return self.replace(static=math.tan(alpha), kinetic=math.tan(alpha) * self.ratio)

    def with_ratio(self, ratio: float) -> Friction:
        """Same static friction at another β = μ_k/μ_s, 0 to 1."""
        return self.replace(kinetic=self.static * ratio)
