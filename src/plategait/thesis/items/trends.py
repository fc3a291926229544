"""Figs. 5.6 to 5.10 and 5.15: how the fits of the spin curves go with stiffness, friction and damping."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from plategait import published
from plategait.thesis import draw
from plategait.thesis.cases import DAMPINGS, Case, damping_variant, reference_cases
from plategait.thesis.fits import Fits, ensemble_spread, published_fits, simulated_fits
from plategait.thesis.item import Check, Comparison, Item, Spec, Table, verdict
from plategait.thesis.items.chapter5 import LETTERS, WHY_WIDTHS
from plategait.thesis.regressions import Regression, regress
from plategait.thesis.runs import Results, value_of

_Regressed = Callable[[Fits], Regression]
# Of each regression figure: what lies across and up, its regression, labels, published names, least R².
_REGRESSED: dict[str, tuple[str, str, _Regressed, str, str, dict[str, str], float]] = {
    "fig5.6": (
        "omega_pi",
        "peak",
        lambda f: regress(f.omega_pi, f.peak),
        "ω_n (π rad/s)",
        "ω_Br max (deg/s)",
        {"r2": "r2_peak"},
        0.0,
    ),
    "fig5.7": (
        "f0_hz",
        "omega_pi",
        lambda f: f.of_omega,
        "f0 (Hz)",
        "ω_n (π rad/s)",
        {"r2": "r2_f0", "slope": "p1", "intercept": "q1"},
        0.95,
    ),
    "fig5.8": (
        "half_width_hz",
        "alpha_deg",
        lambda f: regress(f.half_width_hz, f.alpha_deg),
        "b (Hz)",
        "α (deg)",
        {"r2": "r2_width"},
        0.0,
    ),
    "fig5.9": (
        "ratio",
        "alpha_deg",
        lambda f: f.of_alpha,
        "b/f0",
        "α (deg)",
        {"r2": "r2_ratio", "slope": "p2", "intercept": "q2"},
        0.85,
    ),
}
_NAMES = {"p1": "p1", "q1": "q1", "p2": "p2", "q2": "q2"}


def fig_regression(spec: Spec, results: Results) -> Item:
    """One of Figs. 5.6 to 5.9: fits against what was simulated, with the regression of both amplitudes."""
    x_name, y_name, regressed, x_label, y_label, numbers, least = _REGRESSED[spec.name]
    figure, panels = draw.panels(2)
    comparisons: list[Comparison] = []
    checks: list[Check] = []
    rows: list[tuple[str | float | int | None, ...]] = []
    for axes, angle, letter in zip(panels, published.AMPLITUDES, LETTERS, strict=False):
        fits, known = simulated_fits(results, angle), published_fits(angle)
        line = regressed(fits)
        x, y = getattr(fits, x_name), getattr(fits, y_name)
        by_alpha = spec.name in ("fig5.6", "fig5.7")
        groups = fits.alpha_deg if by_alpha else fits.omega_pi
        draw.scatter(axes, x, y, list(groups), " deg" if by_alpha else "π")
        if spec.name != "fig5.6":
            axes.plot(getattr(known, x_name), getattr(known, y_name), **draw.PUBLISHED)
        draw.line(axes, line, x)
        axes.legend(frameon=False, fontsize=7)
        draw.plain(axes, x_label, y_label, f"({letter}) A_p = {angle} deg")
        for attribute, name in numbers.items():
            comparisons.append(
                Comparison(
                    f"{_NAMES.get(name, 'R²')}, A_p = {angle} deg",
                    published.regression(angle)[name],
                    getattr(line, attribute),
                    0.05 if attribute == "r2" else 0.25,
                    absolute=attribute == "r2",
                    spread=ensemble_spread(results, angle, lambda f, a=attribute: float(getattr(regressed(f), a))),
                )
            )
        if least:
            checks.append(Check(f"R² at A_p = {angle} deg", f"at least {least:g}", f"{line.r2:.2f}", line.r2 >= least))
        rows += [
            (angle, o, a, float(u), float(v)) for o, a, u, v in zip(fits.omega_pi, fits.alpha_deg, x, y, strict=True)
        ]
    columns = ("A_p (deg)", "simulated ω_n (π rad/s)", "simulated α (deg)", x_label, y_label)
    return Item(
        spec.name,
        spec.title,
        verdict(comparisons, checks),
        ((spec.name, figure),),
        (Table(spec.name, columns, tuple(rows)),),
        tuple(comparisons),
        tuple(checks),
        WHY_WIDTHS if spec.name in ("fig5.8", "fig5.9") else _WHY_SLOPES,
    )


_WHY_SLOPES = (
    "f0 of the stiff sheets comes out 3 to 7 % low at A_p = 3 deg (docs/fidelity.md), so that f0 spans less than in "
    "the source and the slope p1 is steeper.",
    "At A_p = 12 deg our f0 moves by up to 0.6 Hz with α, where the published one does not: this lowers R².",
)


def damping_cases() -> list[Case]:
    """Cases of Fig. 5.10."""
    return [case.but(damping_variant(eta)) for case in reference_cases() if case.angle_deg == 3 for eta in DAMPINGS]


def fig_5_10(spec: Spec, results: Results) -> Item:
    """Width of the curve against the damping of the joints."""
    cases = damping_cases()
    eta = np.array(DAMPINGS * (len(cases) // len(DAMPINGS)))
    ratio = np.array([value_of(results[c].fit, "b_over_f0") for c in cases])
    line = regress(eta, ratio)
    low, high = (float(np.nanmean(ratio[eta == x])) for x in (min(DAMPINGS), max(DAMPINGS)))
    change = high / low - 1
    figure, (axes,) = draw.panels(1)
    draw.scatter(axes, eta, ratio, [c.omega_pi for c in cases], "π")
    draw.line(axes, line, eta)
    axes.legend(frameon=False, fontsize=8)
    draw.plain(axes, "η: c_b and c_c over the preset's", "b/f0")
    comparisons = (Comparison("R² of b/f0 on η", published.regression(3)["r2_damping"], line.r2, 0.1, absolute=True),)
    checks = (
        Check("share of b/f0 that damping explains", "R² below 0.1", f"{line.r2:.3f}", line.r2 < 0.1),
        Check(
            "damping does not set the width",
            "b/f0 changes by less than 10 % over eightfold damping",
            f"{100 * change:+.1f} %",
            abs(change) < 0.1,
        ),
    )
    rows = tuple(
        (c.omega_pi, float(e), value_of(results[c].fit, "f0_hz"), float(r), results[c].member_spread("b_over_f0"))
        for c, e, r in zip(cases, eta, ratio, strict=True)
    )
    return Item(
        spec.name,
        spec.title,
        verdict(comparisons, checks),
        (("fig5.10", figure),),
        (Table("fig5.10", ("ω_n (π rad/s)", "η", "f0 (Hz)", "b/f0", "sd of b/f0"), rows),),
        comparisons,
        checks,
        (
            "The range of η is not printed; 0.25 to 2 is shown. η multiplies the preset's damping, whose c_b is "
            "ten times the printed one.",
            "What slope there is comes from the soft sheets at low damping, which then run off later and show more of "
            "their peak; α moves b/f0 several times as much.",
        ),
    )


def fig_5_15(spec: Spec, results: Results) -> Item:
    """Bending against rotation frequency at A_p = 3 deg."""
    fits = simulated_fits(results, 3)
    omegas = sorted(set(fits.omega_pi))
    ours = [float(np.nanmax(fits.peak[fits.omega_pi == o])) / 360 for o in omegas]
    rows = [r for r in published.numbers()["rotation"]["rows"] if r[0] == 3]
    figure, (axes,) = draw.panels(1)
    axes.plot(omegas, [o / 2 for o in omegas], "o-", color=draw.COLOURS[0], label="bending f_n")
    axes.plot(omegas, ours, "s-", color=draw.COLOURS[3], label="rotation f_B, ours")
    axes.plot(omegas, [r[4] for r in rows], **draw.PUBLISHED)
    axes.legend(frameon=False)
    draw.plain(axes, "ω_n (π rad/s)", "frequency (Hz)")
    share = 100 * ours[-1] / 16.5
    comparisons = (Comparison("f_B / f_n of 33π (%)", published.single("share_33"), share, 0.15),)
    return Item(spec.name, spec.title, verdict(comparisons), (("fig5.15", figure),), comparisons=comparisons)
