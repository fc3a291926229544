"""What the dissertation prints, as data: each number with its page or table, and the errata among them.

Its ω_n are nominal. It calls Table 4.1's sheet 10π rad/s, and makes the others by scaling that sheet's k_b; the model's
dish mode with that k_b is 10.32π. So ``sheet.with_natural_frequency(ω_n, nominal=NOMINAL_NATURAL_FREQUENCY)`` of Table
4.1's sheet is the object that it calls ω_n, and what (5.6) estimates is nominal too
(`plategait.model.presets.nominal_natural_frequency`).
"""

from __future__ import annotations

import csv
import math
import tomllib
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any, Literal

AMPLITUDES = (3, 12)
"""Angular amplitudes A_p of chapter 5, deg."""
NOMINAL_NATURAL_FREQUENCY = 10 * math.pi
"""ω_n that the dissertation gives Table 4.1's sheet, rad/s."""
RADIUS, STROKE = 0.04, 0.003
"""Radius of the objects of chapter 5 and the plate's linear amplitude B_p, m (Table 4.1, section 5.3.1)."""
REFERENCE_ALPHA = 36.87
"""Friction angle of Table 4.1's sheet, atan 0.75, deg."""
FRICTION_RATIO = 0.53
"""β = μ_k/μ_s of all objects of chapters 4 and 5 (section 4.5)."""


@dataclass(frozen=True)
class Number:
    """One printed number."""

    value: float
    where: str
    unit: str = ""


@dataclass(frozen=True)
class PublishedCurve:
    """One of the 44 curves of Fig. 5.5, by its row in Tables 5.1 to 5.8 and A.1 or A.2.

    The tables print estimates, not the fits; `f0_hz` and `b_over_f0` are worked back through (5.6) and (5.7).
    """

    angle_deg: int
    omega_pi: float
    alpha_deg: float
    omega_estimate_pi: float
    omega_error_pi: float
    alpha_estimate_deg: float
    alpha_error_deg: float
    r2: float
    table: str
    r2_table: str

    @property
    def f0_hz(self) -> float:
        """Frequency of the peak, Hz."""
        coefficients = regression(self.angle_deg)
        return (self.omega_estimate_pi - coefficients["q1"].value) / coefficients["p1"].value

    @property
    def b_over_f0(self) -> float:
        """Half width at half maximum over the frequency of the peak."""
        coefficients = regression(self.angle_deg)
        return (self.alpha_estimate_deg - coefficients["q2"].value) / coefficients["p2"].value

    @property
    def half_width_hz(self) -> float:
        """Half width at half maximum b, Hz."""
        return self.b_over_f0 * self.f0_hz


@dataclass(frozen=True)
class Erratum:
    """A place where the source disagrees with itself."""

    where: str
    says: str
    implies: str
    used: str


def _text(name: str) -> str:
    return (files("plategait.published") / "data" / name).read_text(encoding="utf-8")


@cache
def numbers() -> dict[str, Any]:
    """Everything in numbers.toml, as read."""
    return tomllib.loads(_text("numbers.toml"))


@cache
def curves() -> tuple[PublishedCurve, ...]:
    """All 44 published curves."""
    texts = ("table", "r2_table")
    rows = csv.DictReader(_text("estimates.csv").splitlines())
    read = [{k: v if k in texts else float(v) for k, v in row.items()} for row in rows]
    return tuple(PublishedCurve(**{**row, "angle_deg": int(row["angle_deg"])}) for row in read)  # type: ignore[arg-type]


@cache
def regression(angle_deg: int) -> dict[str, Number]:
    """Coefficients and statistics of sections 5.4 to 5.6 and appendix B at one amplitude, by name."""
    return {name: Number(**entry) for name, entry in numbers()["regression"][str(angle_deg)].items()}


def residual_sd(angle_deg: int, name: Literal["omega", "alpha"]) -> float:
    """Residual standard deviation of (5.6), π rad/s, or (5.7), deg, to the tables' digits.

    Not printed itself: of the errors in Tables 5.1 to 5.8, where a line takes two degrees of freedom.
    """
    attribute, real = {"omega": ("omega_estimate_pi", "omega_pi"), "alpha": ("alpha_estimate_deg", "alpha_deg")}[name]
    residuals = [getattr(c, attribute) - getattr(c, real) for c in curves() if c.angle_deg == angle_deg]
    return round(math.sqrt(sum(r * r for r in residuals) / (len(residuals) - 2)), 2)


def domain(angle_deg: int, name: Literal["omega", "alpha"]) -> tuple[float, float]:
    """Where the method holds at one amplitude: ω_n in π rad/s or α in deg."""
    low, high = numbers()["domain"][str(angle_deg)][name]
    return float(low), float(high)


@cache
def single(name: str) -> Number:
    """One number of chapters 2, 4 or 5 by name."""
    return Number(**numbers()["single"][name])


@cache
def errata() -> tuple[Erratum, ...]:
    """Where the source disagrees with itself."""
    return tuple(Erratum(**entry) for entry in tomllib.loads(_text("errata.toml"))["erratum"])
