"""What is estimated: unknowns with their priors, and the scenario that a set of values makes."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.model.parameters import SHORTHANDS, value_of, with_values
from plategait.model.scenario import Scenario
from plategait.units import Quantity, parse

_FACTOR = Quantity("", "", "1.1", above=0)
# Ends of a normal prior, in standard deviations from its middle.
_TAILS = 3.0


@dataclass(frozen=True, kw_only=True)
class Unknown:
    """One parameter to estimate, with its prior between two ends: even or normal, in the value or its logarithm.

    Parameters
    ----------
    name : str
        A shorthand of `plategait.model.parameters`, or what a factor is laid on.
    low, high : float
        Ends of the prior, SI.
    logarithmic : bool
        In the logarithm: for what may differ by factors.
    shape : {"even", "normal"}
        Even where nothing is known; normal about the middle, three standard deviations to either end, where it was
        measured.
    quantity : Quantity
        What it measures.
    """

    name: str
    low: float
    high: float
    logarithmic: bool = False
    shape: Literal["even", "normal"] = "even"
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
        place = np.asarray(u, dtype=float)
        if self.shape == "normal":
            from scipy.special import ndtr, ndtri

            tail = ndtr(-_TAILS)
            place = 0.5 + 0.5 * ndtri(tail + (1 - 2 * tail) * place) / _TAILS
        if self.logarithmic:
            return self.low * (self.high / self.low) ** place
        return self.low + (self.high - self.low) * place

    def share(self, value: float) -> float:
        """Share of the prior below an SI value; the inverse of `value`."""
        if self.logarithmic:
            place = math.log(value / self.low) / math.log(self.high / self.low)
        else:
            place = (value - self.low) / (self.high - self.low)
        if self.shape == "normal":
            from scipy.special import ndtr

            tail = ndtr(-_TAILS)
            place = (ndtr((2 * place - 1) * _TAILS) - tail) / (1 - 2 * tail)
        return float(place)

    def measured(self, value: float, sd: float) -> Unknown:
        """Same parameter with what was measured of it for a prior, SI."""
        if self.logarithmic:
            factor = math.exp(_TAILS * sd / value)
            return replace(self, low=value / factor, high=value * factor, shape="normal")
        return replace(self, low=value - _TAILS * sd, high=value + _TAILS * sd, shape="normal")


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
"""Factor on the bending damping told: wide, as c_b is hardly ever known and looks like ω_n in what bends."""
PLATE_HEIGHT = Unknown(
    name="plate_height", low=-5e-3, high=5e-3, quantity=Quantity("m", "mm", "5 mm", at_least=-1, at_most=1)
)
"""Height of the plate's surface above the axis that it turns about: 5 mm to either side of what is told."""
CONTACT_DAMPING = Unknown(name="contact_damping", low=0.3, high=3.0, logarithmic=True)
"""Factor on the contact damping told."""

ALWAYS = (NATURAL_FREQUENCY, FRICTION_ANGLE, FRICTION_RATIO)
OF_THE_SETUP = (BENDING_DAMPING, PLATE_HEIGHT)
"""Sought too unless they are fixed: what nobody knows of an object, and few of a plate."""
ON_REQUEST = (MASS, CONTACT_DAMPING)
ALL = (*ALWAYS, *OF_THE_SETUP, *ON_REQUEST)
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
        changes = {field: value_of(base, field) * by for field, by in factors.items()}
        if PLATE_HEIGHT.name in by_name:
            changes["motion.height"] = by_name[PLATE_HEIGHT.name]
        return with_values(base, changes)


def unknowns(
    base: Scenario,
    *,
    free: Sequence[str] = (),
    friction_ratio: float | None = None,
    fixed: Sequence[str] = (),
    measured: Mapping[str, tuple[float, float]] | None = None,
) -> Unknowns:
    """Choose what to estimate.

    Parameters
    ----------
    base : Scenario
    free : sequence of str
        Of "mass", "contact_damping": estimated as well.
    friction_ratio : float, optional
        β, where it is known.
    fixed : sequence of str
        Parameters that the scenario holds already, "bending_damping" and "plate_height" among them.
    measured : mapping of str to (value, sd), optional
        What is known from elsewhere of "plate_height" (m) or of "bending_damping" (as a factor on the scenario's).

    Raises
    ------
    InputError
        For a name that is none of these, or a spread that is not above 0.
    """
    _check_names("free", free, [p.name for p in ON_REQUEST])
    _check_names("fixed", fixed, [p.name for p in ALL])
    _check_names("measured", measured or (), [p.name for p in OF_THE_SETUP])
    for name in set(fixed) & {*free, *(measured or {})}:
        raise InputError("fixed", name, "nothing that is told or sought otherwise", f"leaving fixed {name} out")
    if friction_ratio is not None:
        if not 0 < friction_ratio <= 1:
            raise InputError("friction_ratio", friction_ratio, "above 0 and at most 1", "0.53")
        base = with_values(base, {"friction_ratio": friction_ratio})
        fixed = [*fixed, "friction_ratio"]
    if base.sheet.bending_damping == 0:  # no factor changes it
        fixed = [*fixed, BENDING_DAMPING.name]
    parameters = [p for p in ALL if p.name not in fixed and (p not in ON_REQUEST or p.name in free)]
    if not parameters:
        raise InputError("fixed", ", ".join(fixed), "fewer than all parameters", "friction_ratio")
    return Unknowns(base, tuple(_prior(p, base, (measured or {}).get(p.name)) for p in parameters))


def _check_names(field: str, names: Iterable[str], allowed: Sequence[str]) -> None:
    for name in names:
        if name not in allowed:
            raise InputError(field, name, f"one of {', '.join(allowed)}", allowed[0])


def _prior(parameter: Unknown, base: Scenario, measured: tuple[float, float] | None) -> Unknown:
    """Parameter with the prior that fits what is told of it."""
    if measured is not None:
        value, sd = measured
        if not sd > 0 or (parameter.logarithmic and not value > 0):
            raise InputError(f"measured.{parameter.name}", f"{value:g} ± {sd:g}", "a spread above 0",
                             f'fixed="{parameter.name}"')  # fmt: skip
        return parameter.measured(value, sd)
    if parameter is PLATE_HEIGHT:
        height = base.motion.height
        return replace(parameter, low=height + parameter.low, high=height + parameter.high)
    return parameter
