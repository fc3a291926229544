"""Refits the linear method's coefficients to this package's own spin curves: `python -m plategait.estimate.training`.

The source's objects (section 5.6.1) are run, their curves fitted, and (5.6), (5.7) and their quadratic forms fitted to
what comes out. ω_n is nominal, as the source counts it: see `plategait.published`.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from plategait import published
from plategait.arrays import Array
from plategait.curve.protocol import measured_as
from plategait.curve.spin_curve import spin_curve
from plategait.model.presets import preset

FREQUENCIES = {3: np.arange(13.0, 31.5, 1.0).tolist(), 12: np.arange(9.0, 16.0, 0.5).tolist()}
"""Of the plate, Hz, by A_p (deg)."""
REPEATS = 4


def simulated_fits(angle_deg: int) -> Array:
    """(n, 4) ω_n (π rad/s), α (deg), f0 (Hz), b/f0 of the source's objects at one amplitude, by our engine."""
    base = measured_as(preset("cheese").scenario).replace(**{"motion.angle": math.radians(angle_deg)})
    rows = []
    for c in (c for c in published.curves() if c.angle_deg == angle_deg):
        static, nominal = math.tan(math.radians(c.alpha_deg)), published.NOMINAL_NATURAL_FREQUENCY
        friction = base.friction.replace(static=static, kinetic=published.FRICTION_RATIO * static)
        sheet = base.sheet.with_natural_frequency(c.omega_pi * math.pi, nominal=nominal)
        fit = spin_curve(base.replace(sheet=sheet, friction=friction), FREQUENCIES[angle_deg], repeats=REPEATS).fit
        if fit is not None:
            rows.append((c.omega_pi, c.alpha_deg, fit.f0_hz, fit.half_width_hz / fit.f0_hz))
    return np.array(rows)


def refitted(fits: Array, degree: int) -> dict[str, tuple[tuple[float, ...], float]]:
    """Polynomials of ω_n over f0 and of α over b/f0, each with its residual standard deviation."""
    polynomials = {}
    for name, y, x in (("omega", fits[:, 0], fits[:, 2]), ("alpha", fits[:, 1], fits[:, 3])):
        powers = np.polynomial.Polynomial.fit(x, y, degree).convert().coef
        residual = y - np.polynomial.polynomial.polyval(x, powers)
        sd = float(np.sqrt(np.sum(residual**2) / (len(y) - degree - 1)))
        polynomials[name] = (tuple(map(float, powers)), sd)
    return polynomials


def text(methods: dict[str, dict[int, dict[str, tuple[tuple[float, ...], float]]]]) -> str:
    """Refitted coefficients as TOML, by method, amplitude and what they estimate."""
    lines = [
        "# Written by python -m plategait.estimate.training. Lowest power first;",
        "# omega (nominal) in pi rad/s over f0 in Hz (5.6), alpha in deg over b/f0 (5.7).",
    ]
    for method, angles in methods.items():
        for angle, lines_of in angles.items():
            for name, (powers, sd) in lines_of.items():
                numbers = ", ".join(f"{p:.6g}" for p in powers)
                lines += ["", f"[refitted.{method}.{angle}deg.{name}]", f"powers = [{numbers}]", f"sd = {sd:.3g}"]
    return "\n".join(lines) + "\n"


def main() -> None:
    """Run the objects, refit, and write the coefficients beside this module."""
    fits = {angle: simulated_fits(angle) for angle in published.AMPLITUDES}
    methods = {
        method: {angle: refitted(f, degree) for angle, f in fits.items()}
        for method, degree in (("linear", 1), ("quadratic", 2))
    }
    path = Path(__file__).parent / "data" / "coefficients.toml"
    path.write_text(text(methods), encoding="utf-8")
    print(f"wrote {path.name}: {', '.join(f'{len(f)} curves at {a} deg' for a, f in fits.items())}")


if __name__ == "__main__":
    main()
