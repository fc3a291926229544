"""The objects of the published spin curves that the engine is held against, at the reference friction angle."""

from __future__ import annotations

import math

import numpy as np

from plategait import published
from plategait.model.presets import preset
from plategait.model.scenario import Scenario

# (A_p in deg, ω_n over π): f0 in Hz.
F0 = {(c.angle_deg, c.omega_pi): c.f0_hz for c in published.curves() if c.alpha_deg == published.REFERENCE_ALPHA}


def scenario(angle_deg: float, omega_over_pi: float) -> Scenario:
    """The cheese as the dissertation varies it: k_b scaled from the nominal 10π, mass kept, α = 36.87 deg, β = 0.53."""
    cheese = preset("cheese").scenario
    nominal = published.NOMINAL_NATURAL_FREQUENCY
    static = math.tan(math.radians(published.REFERENCE_ALPHA))
    return cheese.replace(
        **{
            "sheet": cheese.sheet.with_natural_frequency(omega_over_pi * math.pi, nominal=nominal),
            "motion.angle": math.radians(angle_deg),
            "friction.static": static,
            "friction.kinetic": published.FRICTION_RATIO * static,
        }
    )


def frequencies(angle_deg: float) -> np.ndarray:
    """Plate frequencies that cover the curve."""
    return np.arange(12, 34, 1.0) if angle_deg == 3 else np.arange(6, 16, 0.5)
