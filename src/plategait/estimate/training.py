"""Refits the linear method's coefficients to this package's own spin curves: `python -m plategait.estimate.training`.

The source's objects (section 5.6.1) are run, their curves fitted, and (5.6), (5.7) and their quadratic forms fitted to
what comes out. ω_n is nominal, as the source counts it: see `plategait.published`. Both the fits and the coefficients
are shipped, so that tests can see that these belong to those, and those to the engine.
"""

from __future__ import annotations

import csv
import math
from dataclasses import astuple, dataclass, fields
from pathlib import Path

import numpy as np

from plategait import published
from plategait.arrays import Array
from plategait.curve.protocol import measured_as
from plategait.curve.spin_curve import spin_curve
from plategait.estimate.shipped import shipped
from plategait.model.presets import preset
from plategait.published import PublishedCurve

FREQUENCIES = {3: np.arange(13.0, 31.5, 1.0).tolist(), 12: np.arange(9.0, 16.0, 0.5).tolist()}
"""Of the plate, Hz, by A_p (deg)."""
REPEATS = 4
DEGREES = {"linear": 1, "quadratic": 2}
"""Of the polynomials, by method."""

Polynomial = tuple[tuple[float, ...], float]
"""Powers, lowest first, and residual standard deviation."""


@dataclass(frozen=True)
class TrainingFit:
    """Fit of one of the source's objects, by our engine."""

    angle_deg: int
    omega_pi: float
    alpha_deg: float
    f0_hz: float
    b_over_f0: float


def simulated_fit(curve: PublishedCurve) -> TrainingFit | None:
    """Run the object of a published curve and fit what comes out; None without a peak."""
    base = measured_as(preset("cheese").scenario).replace(**{"motion.angle": math.radians(curve.angle_deg)})
    static, nominal = math.tan(math.radians(curve.alpha_deg)), published.NOMINAL_NATURAL_FREQUENCY
    friction = base.friction.replace(static=static, kinetic=published.FRICTION_RATIO * static)
    sheet = base.sheet.with_natural_frequency(curve.omega_pi * math.pi, nominal=nominal)
    scenario = base.replace(sheet=sheet, friction=friction)
    fit = spin_curve(scenario, FREQUENCIES[curve.angle_deg], repeats=REPEATS).fit
    if fit is None:
        return None
    return TrainingFit(curve.angle_deg, curve.omega_pi, curve.alpha_deg, fit.f0_hz, fit.half_width_hz / fit.f0_hz)


def shipped_fits() -> list[TrainingFit]:
    """Fits that the shipped coefficients were made from."""
    rows = csv.DictReader(shipped("fits.csv").splitlines())
    return [TrainingFit(int(row.pop("angle_deg")), **{name: float(cell) for name, cell in row.items()}) for row in rows]


def fits_as_csv(fits: list[TrainingFit]) -> str:
    """Fits with all their digits."""
    heading = ",".join(field.name for field in fields(TrainingFit))
    return "\n".join([heading, *(",".join(f"{cell!r}" for cell in astuple(fit)) for fit in fits)]) + "\n"


def refitted(fits: list[TrainingFit], degree: int) -> dict[str, Polynomial]:
    """Polynomials of ω_n over f0 and of α over b/f0 of the fits at one amplitude."""

    def column(name: str) -> Array:
        return np.array([getattr(fit, name) for fit in fits])

    return {
        "omega": _polynomial(column("f0_hz"), column("omega_pi"), degree),
        "alpha": _polynomial(column("b_over_f0"), column("alpha_deg"), degree),
    }


def _polynomial(x: Array, y: Array, degree: int) -> Polynomial:
    powers = np.polynomial.Polynomial.fit(x, y, degree).convert().coef
    residual = y - np.polynomial.polynomial.polyval(x, powers)
    return tuple(map(float, powers)), float(np.sqrt(np.sum(residual**2) / (len(y) - degree - 1)))


def coefficients_as_toml(fits: list[TrainingFit]) -> str:
    """Refitted coefficients by method, amplitude and what they estimate."""
    lines = [
        "# Written by python -m plategait.estimate.training. Lowest power first;",
        "# omega (nominal) in pi rad/s over f0 in Hz (5.6), alpha in deg over b/f0 (5.7).",
    ]
    for method, degree in DEGREES.items():
        for angle in published.AMPLITUDES:
            for name, (powers, sd) in refitted([f for f in fits if f.angle_deg == angle], degree).items():
                numbers = ", ".join(f"{p:.6g}" for p in powers)
                lines += ["", f"[refitted.{method}.{angle}deg.{name}]", f"powers = [{numbers}]", f"sd = {sd:.3g}"]
    return "\n".join(lines) + "\n"


def main() -> None:
    """Run the objects, refit, and write fits and coefficients beside this module."""
    fits = [fit for curve in published.curves() if (fit := simulated_fit(curve)) is not None]
    folder = Path(__file__).parent / "data"
    (folder / "fits.csv").write_text(fits_as_csv(fits), encoding="utf-8")
    (folder / "coefficients.toml").write_text(coefficients_as_toml(fits), encoding="utf-8")
    print(f"wrote fits.csv and coefficients.toml: {len(fits)} of {len(published.curves())} curves have a fit")


if __name__ == "__main__":
    main()
