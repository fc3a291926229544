"""The scenarios of the dissertation: which object, at which amplitude, on which friction, over which frequencies."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from plategait import published
from plategait.curve.protocol import REGENERATED
from plategait.model.inferred import number_of
from plategait.model.parameters import with_values
from plategait.model.presets import preset
from plategait.model.scenario import Scenario
from plategait.published import FRICTION_RATIO, NOMINAL_NATURAL_FREQUENCY, REFERENCE_ALPHA

# Below these the fit does not look: Hz by A_p. At 12 deg the roughest object only begins to slide at 8.4 Hz, where
# B_p ω_p² = μ_s g, and a Lorentzian has no onset.
FIT_FROM = {3: 13.0, 12: 9.0}

GAIT_ANGLES = (1, 3, 6, 12, 24)
"""Angular amplitudes of Figs. 4.6, 4.7 and 5.2(a), deg; the source names 1, 3, 6, 12 and 24."""
STIFFNESSES = (1.4, 3.5, 7.5, 10.0, 15.0, 23.0, 33.0, 320.0)
"""Natural frequencies of Fig. 4.7(a) to (h), π rad/s."""
FRICTION_ANGLES = (3.0, 8.0, 15.0, 24.23, 33.02, 40.36, 47.73, 56.31, 65.0, 72.0, 80.0)
"""Friction angles of Fig. 4.8, deg; the source shows 0 to 80."""
DAMPINGS = (0.25, 0.5, 1.0, 2.0)
"""Factors η on c_b and c_c in Fig. 5.10."""
PANCAKE_ANGLES = (2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26)
"""Angular amplitudes of Fig. 2.11, deg."""
# A_p ω_p² about which the peaks lie, deg/s².
USUAL_ACCELERATION = 8e4


@dataclass(frozen=True, order=True)
class Case:
    """One curve to simulate: an object at one amplitude and friction, over the plate's frequency.

    Attributes
    ----------
    angle_deg : float
        A_p.
    omega_pi : float
        ω_n in π rad/s, set by scaling k_b from the nominal 10π; of the cheese only.
    alpha_deg : float
        Friction angle; of the cheese only.
    variant : str
        Modelling choice that departs from the presets, by its name in `VARIANTS`.
    preset : str
        Preset that is shaken.
    """

    angle_deg: float
    omega_pi: float = 10.0
    alpha_deg: float = REFERENCE_ALPHA
    variant: str = ""
    preset: str = "cheese"

    def but(self, variant: str) -> Case:
        """Same curve with one modelling choice changed."""
        return replace(self, variant=variant)

    @property
    def frequencies(self) -> tuple[float, ...]:
        """Plate frequencies, Hz."""
        if self.preset != "cheese":
            return (7.0,)
        if any((c.angle_deg, c.omega_pi) == (self.angle_deg, self.omega_pi) for c in published.curves()):
            if self.angle_deg == 3:
                return tuple(np.arange(13.0, 31.5, 1.0))
            first = 6.0 if self.alpha_deg == REFERENCE_ALPHA and not self.variant else FIT_FROM[12]
            return tuple(np.arange(first, 16.0, 0.5))
        usual = math.sqrt(USUAL_ACCELERATION / self.angle_deg) / math.tau
        return tuple(np.round(usual * np.linspace(0.5, 1.2, 13), 1).tolist())

    @property
    def scenario(self) -> Scenario:
        """What is run, at the preset's frequency."""
        changes: dict[str, Any] = {
            "name": self.label,
            "motion.angle": math.radians(self.angle_deg),
            "duration": REGENERATED.duration,
            "transient": REGENERATED.transient,
            "slip_limit": REGENERATED.slip_limit,
        }
        if self.preset == "cheese":
            changes |= {
                "natural_frequency": self.omega_pi * math.pi,
                "friction_angle": math.radians(self.alpha_deg),
                "friction_ratio": 1.0 if self.variant == "one friction" else FRICTION_RATIO,
            }
        nominal = None if self.variant == "dish mode" else NOMINAL_NATURAL_FREQUENCY
        base = with_values(preset(self.preset).scenario, changes, nominal)
        return with_values(base, _departures(self.variant, base)) if self.variant else base

    @property
    def label(self) -> str:
        """Name of the curve in words."""
        if self.preset != "cheese":
            return f"{self.preset}, A_p = {self.angle_deg:g} deg"
        name = f"A_p = {self.angle_deg:g} deg, ω_n = {self.omega_pi:g}π rad/s, α = {self.alpha_deg:g} deg"
        return f"{name}, {self.variant}" if self.variant else name


VARIANTS = {
    "half step": "time step halved",
    "plate on its axis": f"plate surface on its axis (h = 0) instead of {1e3 * number_of('motion.height'):g} mm above",
    "plate at 12 mm": f"plate surface 12 mm above its axis instead of {1e3 * number_of('motion.height'):g} mm",
    "printed damping": f"c_b as printed instead of {number_of('sheet.bending_damping'):g} times that",
    "smooth friction": "the smooth friction law of the source's solver instead of (3.2)",
    "one friction": "μ_k = μ_s instead of β = 0.53",
    "damped torsion": "torsion damped like bending instead of free",
    "slow start": "plate starts over 0.5 s",
    "dish mode": "ω_n scaled from the model's own dish mode, 10.3π, instead of the nominal 10π",
    "soft impact": "contact damping rising over 0.1 mm instead of at once",
}
"""Departures from the presets that the modelling-choices page weighs."""


_DAMPING = "damping x "


def damping_variant(factor: float) -> str:
    """Name of the variant whose c_b and c_c are multiplied by `factor`; none for 1."""
    return "" if factor == 1 else f"{_DAMPING}{factor:g}"


def damping_factor(variant: str) -> float:
    """Factor on c_b and c_c of a variant."""
    return float(variant.removeprefix(_DAMPING)) if variant.startswith(_DAMPING) else 1.0


def _departures(variant: str, scenario: Scenario) -> dict[str, Any]:
    """Changes to a scenario that make one modelling choice differently."""
    sheet = scenario.sheet
    if variant.startswith(_DAMPING):
        factor = damping_factor(variant)
        return {
            "sheet.bending_damping": factor * sheet.bending_damping,
            "sheet.axial_damping": factor * sheet.axial_damping,
        }
    departures: dict[str, dict[str, Any]] = {
        "half step": {"time_step": scenario.dt / 2},
        "plate on its axis": {"motion.height": 0.0},
        "plate at 12 mm": {"motion.height": 0.012},
        "printed damping": {"sheet.bending_damping": sheet.bending_damping / number_of("sheet.bending_damping")},
        "smooth friction": {"friction.law": "adams"},
        "one friction": {},
        "damped torsion": {"sheet.torsion_damping": sheet.bending_damping},
        "slow start": {"motion.ramp": 0.5},
        "dish mode": {},
        "soft impact": {"contact.damping_ramp": 1e-4},
    }
    return departures[variant]


def fitted_cases() -> list[Case]:
    """Cases of the 44 published curves, in their order."""
    return [Case(c.angle_deg, c.omega_pi, c.alpha_deg) for c in published.curves()]


def reference_cases() -> list[Case]:
    """Cases among them at the reference friction angle."""
    return [case for case in fitted_cases() if case.alpha_deg == REFERENCE_ALPHA]


def with_half_step() -> list[Case]:
    """Fitted cases, and the reference ones again at half the time step."""
    return fitted_cases() + [case.but("half step") for case in reference_cases()]
