"""Refits the linear method's coefficients to this package's own spin curves: `python -m plategait.estimate.training`.

The source's objects (section 5.6.1) are run, their curves fitted, and (5.6), (5.7) and their quadratic forms fitted to
what comes out. The published coefficients are kept as they are.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from plategait.curve import spin_curve
from plategait.presets import preset
from plategait.protocol import measured_as

OBJECTS = {
    3: ((3.5, 10.0, 23.0, 33.0), (24.23, 33.02, 36.87, 40.36, 47.73, 56.31), np.arange(13.0, 31.5, 1.0)),
    12: ((1.4, 3.5, 6.5, 10.0), (24.23, 28.81, 33.02, 36.87, 40.36), np.arange(9.0, 16.0, 0.5)),
}
"""ω_n (π rad/s), α (deg) and plate frequencies (Hz) by A_p (deg), Tables 5.1 to 5.8."""
DOMAIN = {3: {"omega": (0.0, 40.0), "alpha": (24.0, 57.0)}, 12: {"omega": (0.0, 12.0), "alpha": (24.0, 41.0)}}
"""Where section 5.5 says that the method holds; 5.4 gives ω_n an upper end at 12 deg only."""
PUBLISHED = {
    3: {"omega": ((-121.62, 5.30), 1.42), "alpha": ((-74.71, 545.02), 3.33)},
    12: {"omega": ((-64.51, 5.65), 0.69), "alpha": ((-54.10, 379.24), 1.57)},
}
"""q, p of section 5.6.1, and the residual standard deviations of Tables 5.1 to 5.8."""
BETA = 0.53
REPEATS = 4
Array = NDArray[np.float64]


def simulated_fits(angle_deg: int) -> Array:
    """(n, 4) ω_n (π rad/s), α (deg), f0 (Hz), b/f0 of the source's objects at one amplitude, by our engine."""
    omegas, alphas, frequencies = OBJECTS[angle_deg]
    base = measured_as(preset("cheese").scenario).replace(**{"motion.angle": math.radians(angle_deg)})
    rows = []
    for omega in omegas:
        for alpha in alphas:
            friction = base.friction.replace(static=math.tan(math.radians(alpha)),
                                             kinetic=BETA * math.tan(math.radians(alpha)))  # fmt: skip
            sheet = base.sheet.with_natural_frequency(omega * math.pi)
            curve = spin_curve(base.replace(sheet=sheet, friction=friction), frequencies, repeats=REPEATS)
            if curve.fit is not None:
                rows.append((omega, alpha, curve.fit.f0_hz, curve.fit.half_width_hz / curve.fit.f0_hz))
    return np.array(rows)


def refitted(fits: Array, degree: int) -> dict[str, tuple[tuple[float, ...], float]]:
    """Polynomials of ω_n over f0 and of α over b/f0, each with its residual standard deviation."""
    found = {}
    for name, y, x in (("omega", fits[:, 0], fits[:, 2]), ("alpha", fits[:, 1], fits[:, 3])):
        powers = np.polynomial.Polynomial.fit(x, y, degree).convert().coef
        residual = y - np.polynomial.polynomial.polyval(x, powers)
        sd = float(np.sqrt(np.sum(residual**2) / (len(y) - degree - 1)))
        found[name] = (tuple(map(float, powers)), sd)
    return found


def text(tables: dict[str, dict[str, dict[int, dict[str, tuple[tuple[float, ...], float]]]]]) -> str:
    """Coefficients as TOML."""
    lines = [
        "# Written by python -m plategait.estimate.training. Lowest power first;",
        "# omega in pi rad/s over f0 in Hz (5.6), alpha in deg over b/f0 (5.7); low to high: where it holds.",
    ]
    for coefficients, methods in tables.items():
        for method, angles in methods.items():
            for angle, lines_of in angles.items():
                for name, (powers, sd) in lines_of.items():
                    low, high = DOMAIN[angle][name]
                    numbers = ", ".join(f"{p:.6g}" for p in powers)
                    lines += ["", f"[{coefficients}.{method}.{angle}deg.{name}]", f"powers = [{numbers}]",
                              f"sd = {sd:.3g}", f"low = {low:g}", f"high = {high:g}"]  # fmt: skip
    return "\n".join(lines) + "\n"


def main() -> None:
    """Run the objects, refit, and write the coefficients beside this module."""
    fits = {angle: simulated_fits(angle) for angle in OBJECTS}
    tables = {
        "published": {"linear": PUBLISHED},
        "refitted": {
            "linear": {angle: refitted(f, 1) for angle, f in fits.items()},
            "quadratic": {angle: refitted(f, 2) for angle, f in fits.items()},
        },
    }
    path = Path(__file__).parent / "data" / "coefficients.toml"
    path.write_text(text(tables), encoding="utf-8")
    print(f"wrote {path.name}: {', '.join(f'{len(f)} curves at {a} deg' for a, f in fits.items())}")


if __name__ == "__main__":
    main()
