"""What was asked of the regeneration, in one table: targets against what was measured."""

from __future__ import annotations

import numpy as np

from plategait import published
from plategait.thesis.cases import Case, with_half_step
from plategait.thesis.fits import Fits, ensemble_spread, simulated_fits
from plategait.thesis.item import Check, Item, Spec
from plategait.thesis.items import acceleration, friction, tables, trends
from plategait.thesis.items.spin_curves import curve_targets
from plategait.thesis.regressions import Regression
from plategait.thesis.runs import Results


def target_cases() -> list[Case]:
    """Cases that the targets rest on."""
    return [*with_half_step(), *trends.damping_cases(), *acceleration.stiffness_cases(), *friction.friction_cases()]


def targets(spec: Spec, results: Results) -> Item:
    """Check every target, with the spread over the starts where it is one number."""
    checks = [
        *curve_targets(results),
        *_judge_regressions(results),
        *trends.damping_checks(results),
        _judge_peaks(results),
        _judge_optimum(results),
        _judge_friction(results),
    ]
    return spec.item(checks=checks)


def _judge_regressions(results: Results) -> list[Check]:
    """R² of (5.6) and (5.7) at both amplitudes."""

    def of_omega(fits: Fits) -> Regression:
        return fits.of_omega

    def of_alpha(fits: Fits) -> Regression:
        return fits.of_alpha

    checks = []
    for angle in published.AMPLITUDES:
        for what, regression, least in (("ω_n on f0", of_omega, 0.95), ("α on b/f0", of_alpha, 0.85)):
            r2 = regression(simulated_fits(results, angle)).r2
            spread = ensemble_spread(results, angle, lambda fits, r=regression: r(fits).r2)
            measured = f"{r2:.3f}, sd {spread:.3f} over the starts"
            checks.append(Check(f"R² of {what}, A_p = {angle} deg", f"at least {least:g}", measured, r2 >= least))
    return checks


def _judge_peaks(results: Results) -> Check:
    deviations = [c.deviation for c in tables.peak_comparisons(results)]
    worst = float(np.nanmax(np.abs(deviations)))
    measured = f"{100 * min(deviations):+.0f} to {100 * max(deviations):+.0f} %"
    return Check("ω_Br max of Table 5.9", "within 15 %", measured, worst <= 0.15)


def _judge_optimum(results: Results) -> Check:
    holds = [c.holds for c in acceleration.optimum_checks(results)]
    measured = f"{sum(holds)} of {len(holds)}"
    return Check("Fig. 4.7: one best acceleration for each object", "8 of 8", measured, all(holds))


def _judge_friction(results: Results) -> Check:
    comparisons = friction.gait_comparisons(results)
    angles = ", ".join(f"{c.measured:.0f}" if np.isfinite(c.measured) else "none" for c in comparisons)
    return Check(
        "Fig. 4.8: best α while sliding, walking, running",
        "40, 60, 30 deg, each within 10",
        f"{angles} deg",
        all(c.holds for c in comparisons),
    )
