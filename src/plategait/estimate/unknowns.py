"""What is estimated: unknowns with their priors, and the scenario that a set of values makes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.model.parameters import SHORTHANDS, value_of, with_values
from plategait.model.scenario import Scenario
from plategait.units import Quantity, parse

_FACTOR = Quantity("", "", "1.1", above=0)


@dataclass(frozen=True, kw_only=True)
class Unknown:
    """One parameter to estimate, with its prior: uniform between two ends, or uniform in the logarithm.

    Parameters
    ----------
    name : str
        A shorthand of `plategait.model.parameters`, or what a factor is laid on.
    low, high : float
        Ends of the prior, SI.
    logarithmic : bool
        Uniform in the logarithm: for what may differ by factors.
    quantity : Quantity
        What it measures.
    """

    name: str
    low: float
    high: float
    logarithmic: bool = False
    quantity: Quantity = _FACTOR

    @property
    def unit(self) -> str:
        """Unit that people read it in."""
        return self.quantity.display.replace("pi", "π")

    @property
    def scale(self) -> float:
        """SI value of that unit."""
        return parse(f"1 {self.quantity.display}", self.quantity.unit)

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


NATURAL_FREQUENCY = Unknown(
    name="natural_frequency",
    low=0.8 * math.pi,
    high=45 * math.pi,
    logarithmic=True,
    quantity=replace(SHORTHANDS["natural_frequency"], display="pi rad/s"),
)
"""ω_n, set by scaling k_b. The source's objects lie between 1.4π and 33π."""
FRICTION_ANGLE = Unknown(
    name="friction_angle", low=math.radians(10), high=math.radians(70), quantity=SHORTHANDS["friction_angle"]
)
"""α = atan μ_s."""
FRICTION_RATIO = Unknown(name="friction_ratio", low=0.2, high=1.0, quantity=SHORTHANDS["friction_ratio"])
"""β = μ_k/μ_s."""
MASS = Unknown(name="mass", low=0.8, high=1.25, logarithmic=True)
"""Factor on the mass told."""
BENDING_DAMPING = Unknown(name="bending_damping", low=0.1, high=10.0, logarithmic=True)
"""Factor on the bending damping told."""
CONTACT_DAMPING = Unknown(name="contact_damping", low=0.3, high=3.0, logarithmic=True)
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
    parameters : tuple of Unknown
    """

    base: Scenario
    parameters: tuple[Unknown, ...]

    @property
    def names(self) -> list[str]:
        """Names of the parameters."""
        return [p.name for p in self.parameters]

    def values(self, u: Array) -> Array:
        """SI values (n, d) at shares (n, d) of the priors."""
        return np.stack([p.value(u[:, i]) for i, p in enumerate(self.parameters)], axis=1)

    def scenario(self, values: Sequence[float] | Array) -> Scenario:
        """Scenario with the unknowns at SI values (d,)."""
        by_name = dict(zip(self.names, map(float, values), strict=True))
        base = with_values(self.base, {name: value for name, value in by_name.items() if name in SHORTHANDS})
        factors = {field: by for name, by in by_name.items() for field in _SCALED.get(name, ())}
        return with_values(base, {field: value_of(base, field) * by for field, by in factors.items()})


def unknowns(
    base: Scenario, *, free: Sequence[str] = (), friction_ratio: float | None = None, fixed: Sequence[str] = ()
) -> Unknowns:
    """Choose what to estimate.

    Parameters
    ----------
    base : Scenario
    free : sequence of str
        Of "mass", "bending_damping", "contact_damping": estimated as well.
    friction_ratio : float, optional
        β, where it is known.
    fixed : sequence of str
        Parameters that the scenario holds already.

    Raises
    ------
    InputError
        For a name that is none of these.
    """
    names = [p.name for p in (*ALWAYS, *ON_REQUEST)]
    for name in (*free, *fixed):
        if name not in names:
            raise InputError("--free", name, f"one of {', '.join(p.name for p in ON_REQUEST)}", "mass")
    if friction_ratio is not None:
        if not 0 < friction_ratio <= 1:
            raise InputError("friction_ratio", friction_ratio, "above 0 and at most 1", "0.53")
        base = with_values(base, {"friction_ratio": friction_ratio})
        fixed = [*fixed, "friction_ratio"]
    parameters = [p for p in ALWAYS if p.name not in fixed] + [p for p in ON_REQUEST if p.name in free]
    if not parameters:
        raise InputError("fixed", ", ".join(fixed), "fewer than all parameters", "friction_ratio")
    return Unknowns(base, tuple(parameters))
