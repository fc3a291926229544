"""What the dissertation leaves open about its simulations: each unknown with a prior that favours what is printed."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from scipy import special

from plategait.arrays import Array
from plategait.published import NOMINAL_NATURAL_FREQUENCY

Scale = Literal["linear", "log"]


@dataclass(frozen=True)
class Unknown:
    """One number that the source does not print, or that its solver may have changed.

    Attributes
    ----------
    name : str
    printed : float
        What is printed, or the plainest assumption where nothing is.
    sd : float
        Standard deviation of the prior about it: of the number itself, or of its natural logarithm.
    scale : {"linear", "log"}
    why : str
        Why it is open.
    unit : str
        That people read; empty for a factor or ratio.
    one_sided : bool
        Whether it can only be above the printed value.
    """

    name: str
    printed: float
    sd: float
    scale: Scale
    why: str
    unit: str = ""
    one_sided: bool = False

    def value(self, z: Array) -> Array:
        """Numbers at `z` standard deviations of the prior from the printed one."""
        return self.printed + self.sd * z if self.scale == "linear" else self.printed * np.exp(self.sd * z)

    def deviation(self, value: Array | float) -> Array:
        """Standard deviations of the prior between the printed value and this one."""
        value = np.asarray(value, dtype=float)
        return (value - self.printed if self.scale == "linear" else np.log(value / self.printed)) / self.sd

    def quantile(self, share: Array) -> Array:
        """Deviations `z` that shares in (0, 1) of the prior lie below."""
        return special.ndtri(0.5 + 0.5 * share) if self.one_sided else special.ndtri(share)


UNKNOWNS = (
    Unknown("k_c factor", 1.0, math.log(2.5), "log", "k_c is inferred from a pressed link with an error not told"),
    Unknown("k_c exponent", 0.0, 0.8, "linear",
            "section 4.4 changes the elasticity, which may be k_c with k_b: k_c as (ω_n/10π) to this power"),
    Unknown("c_b factor", 1.0, math.log(3), "log", "the source's implicit solver adds damping that it does not report"),
    Unknown("c_b exponent", 0.0, 0.5, "linear", "damping may go with elasticity too: c_b as (ω_n/10π) to this power"),
    Unknown("c_c factor", 1.0, math.log(2), "log", "the same, in compression"),
    Unknown("contact damping factor", 1.0, math.log(2), "log", "the same, in the contact"),
    Unknown("k_t/k_b", 0.0, 0.3, "linear", "the links' torsion is left out of section 3.2.2; a sheet has some",
            one_sided=True),
    Unknown("c_t/c_b", 0.0, 0.3, "linear", "the same, of damping", one_sided=True),
    Unknown("shear ratio", 1.0, math.log(3), "log",
            "the links' joints have no in-plane shear to yield in; a lattice's diagonals have", one_sided=True),
    Unknown("height", 0.0, 6e-3, "linear", "the plate's surface over the bar is not printed", "m", one_sided=True),
    Unknown("transition speed", 0.1, math.log(1.5), "log", "V of (3.2) may mean the solver's smooth law", "m/s"),
    Unknown("ramp", 0.1, math.log(2.5), "log", "how the motion starts is not printed", "s"),
    Unknown("slip limit", 0.015, math.log(1.4), "log", "10 mm is printed; over which time is not", "m"),
    Unknown("duration", 1.6, math.log(1.25), "log", "how long each frequency is run is not printed", "s"),
)  # fmt: skip
NAMES = tuple(unknown.name for unknown in UNKNOWNS)
LAWS: tuple[str, str] = ("thesis", "adams")
"""Laws of friction: (3.2) as printed, and the smooth one of the source's solver."""


@dataclass(frozen=True)
class Choice:
    """One way of settling what is open.

    Attributes
    ----------
    values : mapping of str to float
        By the names of `UNKNOWNS`, SI; those left out are as printed.
    law : str
        One of `LAWS`.
    """

    values: Mapping[str, float]
    law: str = "thesis"

    def __getitem__(self, name: str) -> float:
        """Value of an unknown."""
        return self.values.get(name, _PRINTED[name])


_PRINTED = {unknown.name: unknown.printed for unknown in UNKNOWNS}


def choice_at(z: Array, law: str = "thesis") -> Choice:
    """Choice at deviations (d,) of the priors."""
    return Choice({u.name: float(u.value(x)) for u, x in zip(UNKNOWNS, z, strict=True)}, law)


def deviations_of(choice: Choice) -> Array:
    """(d,) deviations of the priors of a choice."""
    return np.array([float(u.deviation(choice[u.name])) for u in UNKNOWNS])


def parameters(choice: Choice, printed: Mapping[str, float], omega: float) -> dict[str, Any]:
    """Parameters of a scenario that a choice sets, by dotted name, for an object of ω_n (rad/s).

    Parameters
    ----------
    printed : mapping of str to float
        Printed values of what is scaled, SI, of Table 4.1's sheet.
    """
    softer = omega / NOMINAL_NATURAL_FREQUENCY
    stiffness = printed["sheet.bending_stiffness"] * softer**2
    c_b = choice["c_b factor"] * softer ** choice["c_b exponent"] * printed["sheet.bending_damping"]
    k_c = choice["k_c factor"] * softer ** choice["k_c exponent"] * printed["sheet.axial_stiffness"]
    return {
        "sheet.bending_stiffness": stiffness,
        "sheet.bending_damping": c_b,
        "sheet.axial_stiffness": k_c,
        "sheet.axial_damping": choice["c_c factor"] * printed["sheet.axial_damping"],
        "sheet.shear_ratio": choice["shear ratio"],
        "sheet.torsion_stiffness": choice["k_t/k_b"] * stiffness,
        "sheet.torsion_damping": choice["c_t/c_b"] * c_b,
        "contact.damping": choice["contact damping factor"] * printed["contact.damping"],
        "motion.height": choice["height"],
        "motion.ramp": choice["ramp"],
        "friction.transition_speed": choice["transition speed"],
        "friction.law": choice.law,
        "slip_limit": choice["slip limit"],
        "duration": choice["duration"],
    }
