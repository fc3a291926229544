"""The source's estimator: natural frequency from the peak, friction angle from the sharpness, (5.6) and (5.7)."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal

import numpy as np

from plategait import published
from plategait.curve.curve import Curve
from plategait.curve.lorentz import LorentzFit
from plategait.curve.spin_curve import fit_curve
from plategait.errors import InputError
from plategait.estimate.shipped import shipped
from plategait.estimate.unknowns import FRICTION_ANGLE, NATURAL_FREQUENCY
from plategait.files.plain import plain
from plategait.model.fragment import Fragment
from plategait.model.measured import Measured
from plategait.model.outline import Disk, Outline
from plategait.model.presets import nominal_natural_frequency
from plategait.model.scenario import Scenario

Coefficients = Literal["published", "refitted"]
Method = Literal["linear", "quadratic"]
# Objects and plates are told from those that it was made from no finer than this.
SLACK = 0.02


@dataclass(frozen=True)
class Line:
    """One calibrated polynomial of a fit's number, lowest power first, its residual spread and where it holds.

    ω_n in π rad/s over f0 (5.6), or α in deg over b/f0 (5.7). ω_n is nominal: see `plategait.published`.
    """

    powers: tuple[float, ...]
    sd: float
    low: float
    high: float

    def __call__(self, x: float) -> float:
        """Value at `x`."""
        return float(np.polynomial.polynomial.polyval(x, self.powers))

    def slope(self, x: float) -> float:
        """Slope at `x`."""
        return float(np.polynomial.polynomial.polyval(x, np.polynomial.polynomial.polyder(self.powers)))

    def spread(self, x: float, x_sd: float) -> float:
        """Standard deviation of the value: of the calibration, and of the fit behind `x`."""
        return math.hypot(self.sd, self.slope(x) * x_sd)


@dataclass(frozen=True)
class LinearEstimate:
    """ω_n (rad/s) and α (rad) by (5.6) and (5.7) or what takes their place, each with a standard deviation.

    Attributes
    ----------
    refused : tuple of str
        Why it must not be used: outside what the method was made from. Empty where it may.
    nominal : bool
        Whether ω_n is as the source counts it, 3 % below that of the model's dish mode (`plategait.published`).
    logarithmic : bool
        Whether ω_n is normal in its logarithm, as what is known within a factor is.
    """

    natural_frequency: float
    natural_frequency_sd: float
    friction_angle: float
    friction_angle_sd: float
    method: str
    coefficients: str
    refused: tuple[str, ...]
    nominal: bool = True
    logarithmic: bool = False

    def interval(self, name: str, reach: float = 1.645) -> tuple[float, float]:
        """Interval of "natural_frequency" or "friction_angle", SI: 90 %, or so many standard deviations either way."""
        value, sd = getattr(self, name), reach * getattr(self, f"{name}_sd")
        if self.logarithmic and name == NATURAL_FREQUENCY.name:
            return value * math.exp(-sd / value), value * math.exp(sd / value)
        return value - sd, value + sd

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`, with 90 % intervals; None where refused."""
        numbers = {}
        for unknown in (NATURAL_FREQUENCY, FRICTION_ANGLE):
            low, high = self.interval(unknown.name)
            told = {"median": getattr(self, unknown.name), "sd": getattr(self, f"{unknown.name}_sd"), "low": low,
                    "high": high}  # fmt: skip
            values = {key: None if self.refused else plain(value / unknown.scale) for key, value in told.items()}
            numbers[unknown.name] = {"unit": unknown.unit} | values
        return {"method": self.method, "coefficients": self.coefficients, "parameters": numbers,
                "refused": list(self.refused)}  # fmt: skip

    def to_fragment(self, scenario: Scenario) -> Fragment:
        """Scenario fragment for the object of a scenario, with 95 % intervals."""
        if self.refused:
            raise InputError("--out", "nothing that may be used", "a curve within the method's domain",
                             "--method posterior")  # fmt: skip
        own = nominal_natural_frequency(scenario.sheet) if self.nominal else None
        k = scenario.sheet.with_natural_frequency(self.natural_frequency, nominal=own).bending_stiffness
        share = 2 * self.natural_frequency_sd / self.natural_frequency
        stiffness = Measured(k, k * share, k * (1 - 1.96 * share), k * (1 + 1.96 * share))
        if self.logarithmic:
            stiffness = Measured(k, k * math.expm1(share), k * math.exp(-1.96 * share), k * math.exp(1.96 * share))
        mu, mu_sd = math.tan(self.friction_angle), self.friction_angle_sd / math.cos(self.friction_angle) ** 2
        return Fragment(
            {
                "sheet.bending_stiffness": stiffness,
                "friction.static": Measured(mu, mu_sd, mu - 1.96 * mu_sd, mu + 1.96 * mu_sd),
            },
            source=f"plategait estimate --method {self.method}, {self.coefficients} coefficients",
        )


@cache
def calibrations() -> Mapping[str, Any]:
    """Coefficients that `plategait.estimate.training` refits, as shipped."""
    text = shipped("coefficients.toml")
    return tomllib.loads(text)


def line(method: Method, coefficients: Coefficients, angle_deg: int, of: Literal["omega", "alpha"]) -> Line:
    """Calibrated line of one amplitude."""
    if coefficients == "published":
        numbers, index = published.regression(angle_deg), {"omega": 1, "alpha": 2}[of]
        powers = (numbers[f"q{index}"].value, numbers[f"p{index}"].value)
        return Line(powers, published.residual_sd(angle_deg, of), *published.domain(angle_deg, of))
    entry = calibrations()[coefficients][method][f"{angle_deg}deg"][of]
    return Line(tuple(entry["powers"]), entry["sd"], *published.domain(angle_deg, of))


def estimate_linear(
    fit: LorentzFit,
    scenario: Scenario,
    *,
    method: Method = "linear",
    coefficients: Coefficients | None = None,
) -> LinearEstimate:
    """Estimate ω_n and α from a Lorentz fit by (5.6) and (5.7).

    Parameters
    ----------
    fit : LorentzFit
        Of a measured spin curve.
    scenario : Scenario
        Tells the plate's amplitudes and the object's size, which must be those of the calibration.
    method : {"linear", "quadratic"}
        "quadratic" as section 5.6.2 suggests; with refitted coefficients only.
    coefficients : {"published", "refitted"}, optional
        Those of section 5.6.1, or of this package's own simulations. By default published where there are any.

    Raises
    ------
    InputError
        For an amplitude, stroke or size that the method knows nothing of, or an unknown method.
    """
    coefficients = _coefficients(method, coefficients)
    angle = _amplitude(scenario, method)
    omega_line, alpha_line = (line(method, coefficients, angle, of) for of in ("omega", "alpha"))
    f0_sd, b_sd = (_sd(fit.f0_interval), _sd(fit.half_width_interval))
    ratio = fit.half_width_hz / fit.f0_hz
    ratio_sd = ratio * math.hypot(b_sd / fit.half_width_hz, f0_sd / fit.f0_hz)
    omega, alpha = omega_line(fit.f0_hz), alpha_line(ratio)
    outside = [
        f"{name} would be {value:.3g} {unit}, and at A_p = {angle} deg the method holds from {domain.low:g} to "
        f"{domain.high:g} {unit}"
        for name, value, unit, domain in (("ω_n", omega, "π rad/s", omega_line), ("α", alpha, "deg", alpha_line))
        if not domain.low <= value <= domain.high
    ]
    return LinearEstimate(
        natural_frequency=omega * math.pi,
        natural_frequency_sd=omega_line.spread(fit.f0_hz, f0_sd) * math.pi,
        friction_angle=math.radians(alpha),
        friction_angle_sd=math.radians(alpha_line.spread(ratio, ratio_sd)),
        method=method,
        coefficients=coefficients,
        refused=tuple(outside),
    )


def _coefficients(method: Method, coefficients: Coefficients | None) -> Coefficients:
    """Coefficients to use, which the method must have."""
    if method not in ("linear", "quadratic"):
        raise InputError("--method", method, "posterior, linear, quadratic or any-size", "posterior")
    allowed: tuple[Coefficients, ...] = ("published", "refitted") if method == "linear" else ("refitted",)
    if coefficients is not None and coefficients not in allowed:
        raise InputError("--coefficients", coefficients, f"{' or '.join(allowed)} for --method {method}", "refitted")
    return coefficients or allowed[0]


def _amplitude(scenario: Scenario, method: Method) -> int:
    """A_p (deg) of the calibration that holds for a scenario, whose plate and object must be the source's."""
    motion, outline = scenario.motion, scenario.sheet.outline
    angle = next((a for a in published.AMPLITUDES if abs(math.degrees(motion.angle) / a - 1) < SLACK), None)
    if angle is None:
        raise InputError("--angle", f"{math.degrees(motion.angle):.3g} deg",
                         f"3 deg or 12 deg for --method {method}", '"3 deg", or --method posterior')  # fmt: skip
    if abs(motion.stroke / published.STROKE - 1) > SLACK:
        raise InputError("--stroke", f"{1e3 * motion.stroke:.3g} mm", f"3 mm for --method {method}",
                         '"3 mm", or --method posterior')  # fmt: skip
    if abs(getattr(outline, "radius", 0.0) / published.RADIUS - 1) > SLACK:
        raise InputError("--radius", _described(outline), f"a disk of 40 mm for --method {method}",
                         '"40 mm", or --method posterior')  # fmt: skip
    return angle


def _described(outline: Outline) -> str:
    """An outline in words."""
    if isinstance(outline, Disk):
        return f"a disk of {1e3 * outline.radius:.4g} mm"
    length, width = (f"{1e3 * extent:.4g}" for extent in outline.size())
    return f"a {outline.shape} of {length} x {width} mm"


def _sd(interval: tuple[float, float]) -> float:
    """Standard deviation behind a 95 % interval."""
    return (interval[1] - interval[0]) / (2 * 1.96)


def fitted_alone(curves: Sequence[Curve], method: Method) -> Curve:
    """The one curve that the method takes, with its Lorentz fit; InputError for several."""
    return fit_curve(alone(curves, method))


def alone(curves: Sequence[Curve], method: str) -> Curve:
    """The one curve that a method takes.

    Raises
    ------
    InputError
        For several.
    """
    if len(curves) != 1:
        raise InputError("CURVE.csv", f"{len(curves)} curves", f"one curve for --method {method}", "--method posterior")
    return curves[0]


def lorentz_of(curve: Curve, method: Method) -> LorentzFit:
    """Lorentz fit of a curve.

    Raises
    ------
    InputError
        For a curve without one.
    """
    if curve.fit is None:
        raise InputError("CURVE.csv", f"a curve without a Lorentz fit ({curve.no_fit})",
                         f"one with a peak for --method {method}", "--method posterior")  # fmt: skip
    return curve.fit


def at_amplitude_of(curve: Curve, base: Scenario, method: str) -> Scenario:
    """Scenario at the amplitudes in the curve's own columns, if it has any.

    Raises
    ------
    InputError
        For a curve of several amplitudes, or with the shaking out of phase.
    """
    changes = {}
    for name, column, unit, scale in (
        ("angle", curve.angle_deg, "deg", math.radians(1)),
        ("stroke", curve.stroke, "m", 1.0),
        ("phase", curve.phase, "rad", 1.0),
    ):
        told = [] if column is None else np.unique(column[np.isfinite(column)]).tolist()
        if len(told) > 1 or (name == "phase" and any(told)):
            raise InputError("CURVE.csv", f"points at {' and '.join(f'{a:g}' for a in told[:4])} {unit}",
                             f"of one {'amplitude' if name == 'angle' else name} for --method {method}",
                             "--method posterior")  # fmt: skip
        if told and name != "phase":
            changes[f"motion.{name}"] = scale * told[0]
    return base.replace(**changes)
