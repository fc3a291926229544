"""Figures of chapter 5: spin curves, their fits, and what the fits say of stiffness and friction."""

from __future__ import annotations

import math

import numpy as np

from plategait import published
from plategait.curve.lorentz import lorentzian
from plategait.thesis import draw
from plategait.thesis.cases import GAIT_ANGLES, Case, fitted_cases, reference_cases
from plategait.thesis.fits import published_fits, simulated_fits
from plategait.thesis.item import Check, Comparison, Item, Spec, Table, verdict
from plategait.thesis.runs import Results, value_of

LETTERS = "abcdefgh"
WHY_WIDTHS = (
    "The soft sheets (3.5π, 10π) run off at A_p = 3 deg soon after their peak: their fits see one flank and come out "
    "narrow, while 23π and 33π stay on and come out as published. Within each ω_n the width rises with α as "
    "published, but the objects lie apart, which lowers R² of α on b/f0.",
    "At A_p = 12 deg our curves are about 15 % wider than the published ones for every object alike, so that α is "
    "still told apart, with another p2 and q2.",
)
_FREQUENCY = "plate frequency $f_p$ (Hz)"
_RATE = "spin rate $\\omega_B$ (deg/s)"


def with_half_step() -> list[Case]:
    """Fitted cases, and the reference ones again at half the time step."""
    return fitted_cases() + [case.but("half step") for case in reference_cases()]


def fig_5_2(spec: Spec, results: Results) -> Item:
    """Spin curves by amplitude and by stiffness."""
    figure, (left, right) = draw.panels(2)
    for i, angle in enumerate(GAIT_ANGLES):
        runs = results[Case(angle)]
        draw.curve(left, runs, runs.curve.frequency_hz, draw.COLOURS[i], f"{angle:g} deg")
    stiff = [c for c in reference_cases() if c.angle_deg == 3]
    for i, case in enumerate(stiff):
        runs = results[case]
        draw.curve(right, runs, runs.curve.frequency_hz, draw.COLOURS[i], f"{case.omega_pi:g}π rad/s")
    draw.plain(left, _FREQUENCY, _RATE, "(a) ω_n = 10π rad/s, by A_p")
    draw.plain(right, _FREQUENCY, _RATE, "(b) A_p = 3 deg, by ω_n")
    for axes in (left, right):
        draw.gait_legend(axes)
        axes.legend(frameon=False, fontsize=8)
    best = {angle: results[Case(angle)] for angle in GAIT_ANGLES}
    tops = {a: r.curve.frequency_hz[r.best] if r.best >= 0 else math.nan for a, r in best.items()}
    kept = best[24].curve.fitted
    still_rising = bool(best[24].best == np.flatnonzero(kept)[-1]) if kept.any() else False
    peaks = [value_of(results[c].fit, "f0_hz") for c in stiff]
    comparisons = (
        Comparison(
            "frequency of the highest rate at A_p = 3 deg, 10π (Hz)",
            published.single("peak_3deg"),
            tops[3],
            0.05,
            spread=results[Case(3)].member_spread("f0_hz"),
            half_step=results.effect(Case(3), "half step", "f0_hz"),
        ),
    )
    checks = (
        Check(
            "A_p = 24 deg runs off without a peak",
            "rate highest at its last stable frequency",
            "rising to its end" if still_rising else "falls before its end",
            still_rising,
        ),
        Check(
            "A_p = 1 deg peaks far higher than 3 deg",
            "above 1.5 times",
            f"{tops[1]:.0f} against {tops[3]:.0f} Hz",
            bool(tops[1] > 1.5 * tops[3]),
        ),
        Check(
            "each ω_n has its own f0, rising",
            "rising",
            ", ".join(f"{p:.1f}" for p in peaks) + " Hz",
            bool(np.all(np.diff(peaks) > 0)),
        ),
    )
    rows = [
        (case.angle_deg, case.omega_pi, f, r, s, g, x)
        for case in sorted({Case(a) for a in GAIT_ANGLES} | set(stiff))
        for f, r, s, g, x in zip(
            case.frequencies,
            results[case].curve.spin_rate_deg_s,
            results[case].curve.spin_rate_sd_deg_s,
            results[case].curve.gait,
            results[case].curve.failure_in_words,
            strict=True,
        )
    ]
    columns = ("A_p (deg)", "ω_n (π rad/s)", "f_p (Hz)", "ω_B (deg/s)", "sd (deg/s)", "gait", "failure")
    return Item(
        spec.name,
        spec.title,
        verdict(comparisons, checks),
        (("fig5.2", figure),),
        (Table("fig5.2", columns, tuple(rows)),),
        comparisons,
        checks,
        ("The source's curves are wider at the top in A_p; ours run off at the same acceleration.",)
        if not still_rising
        else (),
    )


def fig_5_3(spec: Spec, results: Results) -> Item:
    """Lorentz distribution (5.1)."""
    figure, (axes,) = draw.panels(1)
    x = np.linspace(-5, 5, 301)
    areas = []
    for i, width in enumerate((0.5, 1.0, 2.0)):
        axes.plot(x, lorentzian(x, 1 / (math.pi * width), 0.0, width), color=draw.COLOURS[i], label=f"λ = {width:g}")
        wide = np.linspace(-4000, 4000, 2_000_001)
        areas.append(float(np.trapezoid(lorentzian(wide, 1 / (math.pi * width), 0.0, width), wide)))
    axes.legend(frameon=False)
    draw.plain(axes, "x", "g(x)")
    checks = (
        Check(
            "area under each",
            "1 within 0.001",
            ", ".join(f"{a:.4f}" for a in areas),
            all(abs(a - 1) < 1e-3 for a in areas),
        ),
    )
    return Item(
        spec.name,
        spec.title,
        verdict(checks=checks),
        (("fig5.3", figure),),
        checks=checks,
        notes=("Closed form; the three widths are not printed, 0.5, 1 and 2 are shown.",),
    )


def fig_5_4(spec: Spec, results: Results) -> Item:
    """Three curves with their fits."""
    figure, panels = draw.panels(3, width=3.8)
    comparisons: list[Comparison] = []
    for i, (omega, alpha, peak, f0, width, r2) in enumerate(published.numbers()["examples"]["rows"]):
        case = Case(3, omega, alpha)
        runs, name = results[case], f"({LETTERS[i]}) {omega:g}π, {alpha:g} deg"
        draw.curve(panels[i], runs, runs.curve.frequency_hz, draw.COLOURS[0], "ours", fit=True)
        grid = np.linspace(13, 31, 200)
        panels[i].plot(grid, lorentzian(grid, peak, f0, width), color="black", ls="--", lw=1, label="published fit")
        panels[i].legend(frameon=False, fontsize=8)
        draw.plain(panels[i], _FREQUENCY, _RATE, name)
        for key, unit, value, allowed in (
            ("peak", "ω_Br max, deg/s", peak, 0.15),
            ("f0_hz", "f0, Hz", f0, 0.05),
            ("half_width_hz", "b, Hz", width, 0.15),
            ("r2", "R²", r2, 0.03),
        ):
            comparisons.append(
                Comparison(
                    f"{name}: {unit}",
                    published.Number(value, "section 5.3.2, Fig. 5.4"),
                    value_of(runs.fit, key),
                    allowed,
                    spread=runs.member_spread(key),
                    half_step=results.effect(case, "half step", key),
                )
            )
    return Item(
        spec.name,
        spec.title,
        verdict(comparisons),
        (("fig5.4", figure),),
        comparisons=tuple(comparisons),
        notes=("Where a curve's f0 is low, the sheet drifts off the plate before the rate has turned over.",),
    )


def fig_5_5(spec: Spec, results: Results) -> Item:
    """All 44 curves and how far their fits are from the published ones."""
    figure, panels = draw.panels(4, 2, width=3.6, height=3.0)
    rows: list[tuple[str | float | int | None, ...]] = []
    for axes, (angle, omega) in zip(
        panels, sorted({(c.angle_deg, c.omega_pi) for c in published.curves()}), strict=True
    ):
        members = [c for c in published.curves() if (c.angle_deg, c.omega_pi) == (angle, omega)]
        for i, curve in enumerate(members):
            runs = results[Case(angle, omega, curve.alpha_deg)]
            draw.curve(axes, runs, runs.curve.frequency_hz, draw.COLOURS[i], f"{curve.alpha_deg:g}", fit=True)
            fit = runs.fit
            ours, ratio = value_of(fit, "f0_hz"), value_of(fit, "b_over_f0")
            rows.append(
                (
                    angle,
                    omega,
                    curve.alpha_deg,
                    curve.f0_hz,
                    ours,
                    100 * (ours / curve.f0_hz - 1),
                    runs.member_spread("f0_hz"),
                    results.effect(runs.case, "half step", "f0_hz"),
                    curve.b_over_f0,
                    ratio,
                    100 * (ratio / curve.b_over_f0 - 1),
                    runs.member_spread("b_over_f0"),
                    results.effect(runs.case, "half step", "b_over_f0"),
                    value_of(fit, "peak"),
                    runs.member_spread("peak"),
                    value_of(fit, "r2"),
                )
            )
        axes.legend(frameon=False, fontsize=6.5, title="α (deg)", title_fontsize=7)
        draw.plain(axes, _FREQUENCY, _RATE, f"A_p = {angle} deg, ω_n = {omega:g}π")
    columns = (
        "A_p (deg)",
        "ω_n (π rad/s)",
        "α (deg)",
        "f0 published (Hz)",
        "f0 (Hz)",
        "deviation (%)",
        "sd (Hz)",
        "half step (Hz)",
        "b/f0 published",
        "b/f0",
        "deviation (%) of b/f0",
        "sd of b/f0",
        "half step of b/f0",
        "ω_Br max (deg/s)",
        "sd (deg/s)",
        "R²",
    )
    checks = curve_targets(results)
    return Item(
        spec.name,
        spec.title,
        verdict(checks=checks),
        (("fig5.5", figure),),
        (Table("fig5.5", columns, tuple(rows)),),
        checks=checks,
        notes=WHY_WIDTHS,
    )


def curve_targets(results: Results) -> tuple[Check, ...]:
    """Medians over the 44 curves against what was set for them."""
    f0: list[float] = []
    ratio: list[float] = []
    for angle in published.AMPLITUDES:
        known, ours = published_fits(angle), simulated_fits(results, angle)
        f0 += list(np.abs(ours.f0_hz / known.f0_hz - 1))
        ratio += list(np.abs(ours.ratio / known.ratio - 1))
    missing = int(np.isnan(f0).sum())
    middle_f0, middle_ratio = float(np.nanmedian(f0)), float(np.nanmedian(ratio))
    return (
        Check("every curve has a fit", "44 of 44", f"{44 - missing} of 44", missing == 0),
        Check("median |Δf0|", "at most 3 %", f"{100 * middle_f0:.1f} %", middle_f0 <= 0.03),
        Check("median |Δ(b/f0)|", "at most 15 %", f"{100 * middle_ratio:.1f} %", middle_ratio <= 0.15),
    )
