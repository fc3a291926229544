"""Published spin curves that the engine is held against: f0 from Tables 5.1 to 5.8, worked back with section 5.6.1's
p and q; all at B_p = 3 mm and a friction angle of 36.87 deg."""

from __future__ import annotations

import math

import numpy as np

from plategait.presets import NOMINAL_NATURAL_FREQUENCY, preset
from plategait.scenario import Scenario

# (A_p in deg, ω_n over π): f0 in Hz.
F0 = {
    (3, 3.5): 23.528,
    (3, 10.0): 25.060,
    (3, 23.0): 27.383,
    (3, 33.0): 29.002,
    (12, 1.4): 11.782,
    (12, 3.5): 12.012,
    (12, 6.5): 12.784,
    (12, 10.0): 13.414,
}


def scenario(angle_deg: float, omega_over_pi: float) -> Scenario:
    """The cheese as the dissertation varies it: k_b scaled, mass kept, friction angle 36.87 deg, β = 0.53."""
    cheese = preset("cheese").scenario
    sheet = cheese.sheet.with_natural_frequency(omega_over_pi * math.pi, nominal=NOMINAL_NATURAL_FREQUENCY)
    static = math.tan(math.radians(36.87))
    return cheese.replace(
        **{
            "sheet": sheet,
            "motion.angle": math.radians(angle_deg),
            "friction.static": static,
            "friction.kinetic": 0.53 * static,
        }
    )


def frequencies(angle_deg: float) -> np.ndarray:
    """Plate frequencies that cover the curve."""
    return np.arange(12, 34, 1.0) if angle_deg == 3 else np.arange(6, 16, 0.5)
