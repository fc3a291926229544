"""What is estimated: parameters with their priors, and the scenario that a set of values makes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.model.parameters import SHORTHANDS, value_of, with_values
from plategait.model.scenario import Scenario


@dataclass(frozen=True)
class Parameter:
    """One unknown with its prior: uniform between two ends, or uniform in the logarithm.

    Parameters
    ----------
    name : str
    low, high : float
        Ends of the prior, SI.
    logarithmic : bool
        Uniform in the logarithm: for what may differ by factors.
    unit : str
        Unit that people read it in, and `scale` the SI value of that unit.
    """

    name: str
    low: float
    high: float
    logarithmic: bool = False
    unit: str = ""
    scale: float = 1.0

    def value(self, u: Array | float) -> Array:
        """SI value at the share `u` (0 to 1) of the prior."""
        if self.logarithmic:
            return self.low * (self.high / self.low) ** np.asarray(u)
        return self.low + (self.high - self.low) * np.asarray(u)

    def share(self, value: float) -> float:
        """Share of the prior below an SI value; the inverse of `value`."""
        if self.logarithmic:
            return math.log(value / self.low) / math.log(self.high / self.low)
        return (value - self.low) / (self.high - self.low)


NATURAL_FREQUENCY = Parameter("natural_frequency", 0.8 * math.pi, 45 * math.pi, True, "π rad/s", math.pi)
"""ω_n, set by scaling k_b. The source's objects lie between 1.4π and 33π."""
FRICTION_ANGLE = Parameter("friction_angle", math.radians(10), math.radians(70), False, "deg", math.radians(1))
"""α = atan μ_s."""
FRICTION_RATIO = Parameter("friction_ratio", 0.2, 1.0)
"""β = μ_k/μ_s."""
MASS = Parameter("mass", 0.8, 1.25, True)
"""Factor on the mass told."""
BENDING_DAMPING = Parameter("bending_damping", 0.1, 10.0, True)
"""Factor on the bending damping told."""
CONTACT_DAMPING = Parameter("contact_damping", 0.3, 3.0, True)
"""Factor on the contact damping told."""

ALWAYS = (NATURAL_FREQUENCY, FRICTION_ANGLE, FRICTION_RATIO)
ON_REQUEST = (MASS, BENDING_DAMPING, CONTACT_DAMPING)
# What each factor multiplies; with the mass the bending stiffness, so that ω_n stays what it is.
_SCALED = {
    "mass": ("sheet.mass", "sheet.bending_stiffness", "sheet.torsion_stiffness"),
    "bending_damping": ("sheet.bending_damping",),
    "contact_damping": ("contact.damping",),
}


@dataclass(frozen=True)
class Unknowns:
    """The parameters to estimate, and the scenario that holds everything else.

    Parameters
    ----------
    base : Scenario
        The object and the plate as told; its natural frequency and friction count only where they are not unknown.
    parameters : tuple of Parameter
    """

    base: Scenario
    parameters: tuple[Parameter, ...]

    @property
    def names(self) -> list[str]:
        """Names of the parameters."""
        return [p.name for p in self.parameters]

    def values(self, u: Array) -> Array:
        """SI values (n, d) at shares (n, d) of the priors."""
        return np.stack([p.value(u[:, i]) for i, p in enumerate(self.parameters)], axis=1)

    def scenario(self, values: Sequence[float] | Array) -> Scenario:
        """Scenario with the unknowns at SI values (d,)."""
        given = dict(zip(self.names, map(float, values), strict=True))
        made = with_values(self.base, {name: value for name, value in given.items() if name in SHORTHANDS})
        factors = {name: factor for name, factor in given.items() if name in _SCALED}
        return with_values(
            made, {field: value_of(made, field) * by for name, by in factors.items() for field in _SCALED[name]}
        )


def unknowns(
    base: Scenario, *, free: Sequence[str] = (), friction_ratio: float | None = None, known: Sequence[str] = ()
) -> Unknowns:
    """Choose what to estimate.

    Parameters
    ----------
    base : Scenario
    free : sequence of str
        Of "mass", "bending_damping", "contact_damping": estimated as well.
    friction_ratio : float, optional
        β, where it is known.
    known : sequence of str
        Parameters that the scenario holds already.

    Raises
    ------
    InputError
        For a name that is none of these.
    """
    by_name = {p.name: p for p in (*ALWAYS, *ON_REQUEST)}
    for name in (*free, *known):
        if name not in by_name:
            raise InputError("--free", name, f"one of {', '.join(p.name for p in ON_REQUEST)}", "mass")
    if friction_ratio is not None:
        if not 0 < friction_ratio <= 1:
            raise InputError("friction_ratio", friction_ratio, "above 0 and at most 1", "0.53")
        base = with_values(base, {"friction_ratio": friction_ratio})
        known = [*known, "friction_ratio"]
    chosen = [p for p in ALWAYS if p.name not in known] + [p for p in ON_REQUEST if p.name in free]
    if not chosen:
        raise InputError("known", ", ".join(known), "fewer than all parameters", "friction_ratio")
    return Unknowns(base, tuple(chosen))
