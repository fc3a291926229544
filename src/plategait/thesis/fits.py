"""The fits of the 44 curves as columns, their regressions, and what (5.6) and (5.7) estimate from them."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from plategait import published
from plategait.arrays import Array
from plategait.errors import InputError
from plategait.published import PublishedCurve
from plategait.thesis.cases import Case
from plategait.thesis.regressions import Regression, regress
from plategait.thesis.runs import Results, value_of


@dataclass(frozen=True, eq=False)
class Fits:
    """Fits at one amplitude: (n,) columns in the order of the published tables; NaN where a curve has no fit.

    Attributes
    ----------
    omega_pi, alpha_deg : arrays
        What was simulated.
    f0_hz, half_width_hz, peak : arrays
        Parameters of (5.5); deg/s for the peak.
    """

    omega_pi: Array
    alpha_deg: Array
    f0_hz: Array
    half_width_hz: Array
    peak: Array

    @property
    def ratio(self) -> Array:
        """Widths b/f0."""
        return self.half_width_hz / self.f0_hz

    @property
    def of_omega(self) -> Regression:
        """ω_n (π rad/s) on f0 (Hz): p1 and q1 of (5.6)."""
        return regress(self.f0_hz, self.omega_pi)

    @property
    def of_alpha(self) -> Regression:
        """α (deg) on b/f0: p2 and q2 of (5.7)."""
        return regress(self.ratio, self.alpha_deg)

    @property
    def omega_estimate(self) -> Array:
        """ω̂_n by (5.6), π rad/s."""
        return self.of_omega(self.f0_hz)

    @property
    def alpha_estimate(self) -> Array:
        """α̂ by (5.7), deg."""
        return self.of_alpha(self.ratio)

    @property
    def omega_check(self) -> Regression:
        """Estimated on real ω_n (Fig. 5.11)."""
        return regress(self.omega_pi, self.omega_estimate)

    @property
    def alpha_check(self) -> Regression:
        """Estimated on real α (Fig. 5.12)."""
        return regress(self.alpha_deg, self.alpha_estimate)


def published_curves(angle_deg: int) -> list[PublishedCurve]:
    """Published curves at one amplitude."""
    return [c for c in published.curves() if c.angle_deg == angle_deg]


def published_fits(angle_deg: int) -> Fits:
    """Published fits as columns; the peaks are not published curve by curve."""
    curves = published_curves(angle_deg)
    f0, width = np.array([c.f0_hz for c in curves]), np.array([c.half_width_hz for c in curves])
    omega, alpha = np.array([c.omega_pi for c in curves]), np.array([c.alpha_deg for c in curves])
    return Fits(omega, alpha, f0, width, np.full(len(curves), math.nan))


def simulated_fits(results: Results, angle_deg: int, member: int | None = None) -> Fits:
    """Fits of our curves as columns: of the ensemble's means, or of one start by itself."""
    curves = published_curves(angle_deg)
    runs = [results[Case(c.angle_deg, c.omega_pi, c.alpha_deg)] for c in curves]
    fits = [r.fit if member is None else r.member_fits[member] for r in runs]

    def column(name: str) -> Array:
        return np.array([value_of(fit, name) for fit in fits])

    omega, alpha = np.array([c.omega_pi for c in curves]), np.array([c.alpha_deg for c in curves])
    return Fits(omega, alpha, column("f0_hz"), column("half_width_hz"), column("peak"))


def ensemble_spread(results: Results, angle_deg: int, number: Callable[[Fits], float]) -> float:
    """Standard deviation, over the starts, of a number made of all the fits at one amplitude."""
    values = []
    for member in range(results.repeats):
        try:
            values.append(number(simulated_fits(results, angle_deg, member)))
        except InputError:
            continue
    return float(np.std(values, ddof=1)) if len(values) > 1 else math.nan
