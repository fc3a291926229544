"""What was asked of the regeneration, in one table: targets against what was measured."""

from __future__ import annotations

import numpy as np

from plategait import published
from plategait.thesis.cases import Case
from plategait.thesis.fits import ensemble_spread, simulated_fits
from plategait.thesis.item import Check, Item, Spec, verdict
from plategait.thesis.items import chapter4, friction, tables, trends
from plategait.thesis.items.chapter5 import curve_targets, with_half_step
from plategait.thesis.runs import Results


def target_cases() -> list[Case]:
    """Cases that the targets rest on."""
    return [*with_half_step(), *trends.damping_cases(), *chapter4.stiffness_cases(), *friction.friction_cases()]


def targets(spec: Spec, results: Results) -> Item:
    """Check every target, with the spread over the starts where it is one number."""
    checks = list(curve_targets(results))
    for angle in published.AMPLITUDES:
        fits = simulated_fits(results, angle)
        for what, line, least in (("ω_n on f0", fits.of_omega, 0.95), ("α on b/f0", fits.of_alpha, 0.85)):
            spread = ensemble_spread(
                results, angle, lambda f, w=what: (f.of_omega if w == "ω_n on f0" else f.of_alpha).r2
            )
            measured = f"{line.r2:.3f}, sd {spread:.3f} over the starts"
            checks.append(Check(f"R² of {what}, A_p = {angle} deg", f"at least {least:g}", measured, line.r2 >= least))
    checks += trends.fig_5_10(spec, results).checks
    peaks = [c.deviation for c in tables.table_5_9(spec, results).comparisons]
    worst = float(np.nanmax(np.abs(peaks)))
    checks.append(
        Check(
            "ω_Br max of Table 5.9",
            "within 15 %",
            f"{100 * min(peaks):+.0f} to {100 * max(peaks):+.0f} %",
            worst <= 0.15,
        )
    )
    optimum = chapter4.fig_4_7(spec, results).checks
    held = [c.holds for c in optimum]
    checks.append(
        Check("Fig. 4.7: one best acceleration for each object", "8 of 8", f"{sum(held)} of {len(held)}", all(held))
    )
    angles = friction.fig_4_8(spec, results)
    found = ", ".join(f"{c.measured:.0f}" if np.isfinite(c.measured) else "none" for c in angles.comparisons)
    checks.append(
        Check(
            "Fig. 4.8: best α while sliding, walking, running",
            "40, 60, 30 deg, each within 10",
            f"{found} deg",
            all(c.holds for c in angles.comparisons),
        )
    )
    return Item(spec.name, spec.title, verdict(checks=checks), checks=tuple(checks))
