"""Figs. 5.6 to 5.10 and 5.15: how the fits of the spin curves go with stiffness, friction and damping."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from plategait import published
from plategait.arrays import Array
from plategait.model.inferred import number_of
from plategait.plots.style import legend_beside
from plategait.plots.symbols import typeset
from plategait.thesis import draw
from plategait.thesis.cases import DAMPINGS, Case, damping_variant, reference_cases
from plategait.thesis.fits import Fits, ensemble_spread, published_fits, simulated_fits
from plategait.thesis.item import Cell, Check, Comparison, Item, Spec, Table
from plategait.thesis.items.spin_curves import WHY_WIDTHS
from plategait.thesis.regressions import Regression, regress
from plategait.thesis.runs import CaseRuns, Results, value_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class _Trend:
    """One of Figs. 5.6 to 5.9.

    Attributes
    ----------
    across, up : (attribute of `Fits`, label)
        What lies along the axes.
    regression : callable
    printed : dict
        Published names of numbers of the regression.
    least_r2 : float
        That the target asks for; 0 for none.
    by_alpha : bool
        Whether points of one friction angle are joined, else those of one object.
    """

    across: tuple[str, str]
    up: tuple[str, str]
    regression: Callable[[Fits], Regression]
    printed: dict[str, str]
    least_r2: float
    by_alpha: bool


_OMEGA, _ALPHA = ("omega_pi", "ω_n (π rad/s)"), ("alpha_deg", "α (deg)")
_TRENDS = {
    "fig5.6": _Trend(
        across=_OMEGA,
        up=("peak", "ω_Br max (deg/s)"),
        regression=lambda f: regress(f.omega_pi, f.peak),
        printed={"r2": "r2_peak"},
        least_r2=0.0,
        by_alpha=True,
    ),
    "fig5.7": _Trend(
        across=("f0_hz", "f0 (Hz)"),
        up=_OMEGA,
        regression=lambda f: f.of_omega,
        printed={"r2": "r2_f0", "slope": "p1", "intercept": "q1"},
        least_r2=0.95,
        by_alpha=True,
    ),
    "fig5.8": _Trend(
        across=("half_width_hz", "b (Hz)"),
        up=_ALPHA,
        regression=lambda f: regress(f.half_width_hz, f.alpha_deg),
        printed={"r2": "r2_width"},
        least_r2=0.0,
        by_alpha=False,
    ),
    "fig5.9": _Trend(
        across=("ratio", "b/f0"),
        up=_ALPHA,
        regression=lambda f: f.of_alpha,
        printed={"r2": "r2_ratio", "slope": "p2", "intercept": "q2"},
        least_r2=0.85,
        by_alpha=False,
    ),
}
_WHY_SLOPES = (
    "f0 of the stiff sheets comes out 3 to 7 % low at A_p = 3 deg (docs/fidelity.md), so that f0 spans less than in "
    "the source and the slope p1 is steeper.",
    "At A_p = 12 deg our f0 moves by up to 0.6 Hz with α, where the published one does not: this lowers R².",
)


def fig_regression(spec: Spec, results: Results) -> Item:
    """One of Figs. 5.6 to 5.9: fits against what was simulated, with the regression of both amplitudes."""
    trend = _TRENDS[spec.name]
    columns = ("A_p (deg)", "simulated ω_n (π rad/s)", "simulated α (deg)", trend.across[1], trend.up[1])
    rows = tuple(row for angle in published.AMPLITUDES for row in _trend_rows(trend, results, angle))
    return spec.item(
        figures=[(spec.name, _draw_trend(trend, results))],
        tables=[Table(spec.name, columns, rows)],
        comparisons=[c for angle in published.AMPLITUDES for c in _compare_trend(trend, results, angle)],
        checks=[_judge_r2(trend, results, angle) for angle in published.AMPLITUDES] if trend.least_r2 else [],
        notes=_WHY_SLOPES if trend.by_alpha else WHY_WIDTHS,
    )


def _trend_rows(trend: _Trend, results: Results, angle: int) -> list[tuple[Cell, ...]]:
    fits = simulated_fits(results, angle)
    points = zip(fits.omega_pi, fits.alpha_deg, getattr(fits, trend.across[0]), getattr(fits, trend.up[0]), strict=True)
    return [(angle, omega, alpha, float(x), float(y)) for omega, alpha, x, y in points]


def _draw_trend(trend: _Trend, results: Results) -> Figure:
    figure, panels = draw.panels(2, width=6)
    for axes, angle, letter in zip(panels, published.AMPLITUDES, "ab", strict=True):
        fits, printed = simulated_fits(results, angle), published_fits(angle)
        x, y = getattr(fits, trend.across[0]), getattr(fits, trend.up[0])
        groups, unit = (fits.alpha_deg, " deg") if trend.by_alpha else (fits.omega_pi, "π")
        draw.scatter(axes, x, y, list(groups), unit)
        if trend.up[0] != "peak":  # which is not printed curve by curve
            axes.plot(getattr(printed, trend.across[0]), getattr(printed, trend.up[0]), **draw.PUBLISHED)
        draw.line(axes, trend.regression(fits), x)
        draw.plain(axes, typeset(trend.across[1]), typeset(trend.up[1]), f"({letter}) $A_p$ = {angle} deg")
        legend_beside(axes, fontsize=7)
    return figure


def _compare_trend(trend: _Trend, results: Results, angle: int) -> list[Comparison]:
    line = trend.regression(simulated_fits(results, angle))
    return [
        Comparison(
            f"{'R²' if attribute == 'r2' else name}, A_p = {angle} deg",
            published.regression(angle)[name],
            getattr(line, attribute),
            0.05 if attribute == "r2" else 0.25,
            absolute=attribute == "r2",
            spread=ensemble_spread(results, angle, lambda f, a=attribute: float(getattr(trend.regression(f), a))),
        )
        for attribute, name in trend.printed.items()
    ]


def _judge_r2(trend: _Trend, results: Results, angle: int) -> Check:
    r2 = trend.regression(simulated_fits(results, angle)).r2
    return Check(f"R² at A_p = {angle} deg", f"at least {trend.least_r2:g}", f"{r2:.2f}", r2 >= trend.least_r2)


def damping_cases() -> list[Case]:
    """Cases of Fig. 5.10."""
    return [case.but(damping_variant(eta)) for case in reference_cases() if case.angle_deg == 3 for eta in DAMPINGS]


def damping_change(eta: Array, ratio: Array) -> float:
    """Relative change of the mean b/f0 from the least to the most damping; NaN where either has none."""
    low, high = (ratio[(eta == x) & np.isfinite(ratio)] for x in (eta.min(), eta.max()))
    return float(high.mean() / low.mean() - 1) if len(low) and len(high) else math.nan


@dataclass(frozen=True, eq=False)
class _Damped:
    """Runs at every damping, and the factor η of each."""

    runs: tuple[CaseRuns, ...]
    eta: Array

    @property
    def ratio(self) -> Array:
        """Widths b/f0."""
        return np.array([value_of(r.fit, "b_over_f0") for r in self.runs])

    @property
    def regression(self) -> Regression:
        """b/f0 on η."""
        return regress(self.eta, self.ratio)

    @property
    def change(self) -> float:
        """Relative change of the mean b/f0 from the least to the most damping."""
        return damping_change(self.eta, self.ratio)


def _damped(results: Results) -> _Damped:
    cases = damping_cases()
    return _Damped(tuple(results[c] for c in cases), np.array(DAMPINGS * (len(cases) // len(DAMPINGS))))


def fig_5_10(spec: Spec, results: Results) -> Item:
    """Width of the curve against the damping of the joints."""
    damped = _damped(results)
    r2 = damped.regression.r2
    return spec.item(
        figures=[(spec.name, _draw_damping(damped))],
        tables=[Table(spec.name, ("ω_n (π rad/s)", "η", "f0 (Hz)", "b/f0", "sd of b/f0"), _damping_rows(damped))],
        comparisons=[Comparison("R² of b/f0 on η", published.regression(3)["r2_damping"], r2, 0.1, absolute=True)],
        checks=damping_checks(results),
        notes=[
            "The range of η is not printed; 0.25 to 2 is shown. η multiplies the preset's damping, whose c_b is "
            f"{number_of('sheet.bending_damping'):g} times the printed one.",
            "What slope there is comes from the soft sheets at low damping, which then run off later and show more of "
            "their peak; α moves b/f0 several times as much.",
        ],
    )


def _damping_rows(damped: _Damped) -> tuple[tuple[Cell, ...], ...]:
    return tuple(
        (r.case.omega_pi, float(eta), value_of(r.fit, "f0_hz"), float(ratio), r.member_spread("b_over_f0"))
        for r, eta, ratio in zip(damped.runs, damped.eta, damped.ratio, strict=True)
    )


def _draw_damping(damped: _Damped) -> Figure:
    figure, (axes,) = draw.panels(1)
    draw.scatter(axes, damped.eta, damped.ratio, [r.case.omega_pi for r in damped.runs], "π")
    draw.line(axes, damped.regression, damped.eta)
    draw.plain(axes, "$\\eta$: $c_b$ and $c_c$ over the preset's", "$b/f_0$")
    legend_beside(axes)
    return figure


def damping_checks(results: Results) -> tuple[Check, ...]:
    """Whether damping leaves the width of the curve alone."""
    damped = _damped(results)
    r2, change = damped.regression.r2, damped.change
    return (
        Check("share of b/f0 that damping explains", "R² below 0.1", f"{r2:.3f}", r2 < 0.1),
        Check(
            "damping does not set the width",
            "b/f0 changes by less than 10 % over eightfold damping",
            f"{100 * change:+.1f} %",
            abs(change) < 0.1,
        ),
    )


def fig_5_15(spec: Spec, results: Results) -> Item:
    """Bending against rotation frequency at A_p = 3 deg."""
    fits = simulated_fits(results, 3)
    omegas = sorted(set(fits.omega_pi))
    rotation = [float(np.nanmax(fits.peak[fits.omega_pi == o])) / 360 for o in omegas]
    share = 100 * rotation[-1] / 16.5
    return spec.item(
        figures=[(spec.name, _draw_frequencies(omegas, rotation))],
        comparisons=[Comparison("f_B / f_n of 33π (%)", published.single("share_33"), share, 0.15)],
    )


def _draw_frequencies(omegas: list[float], rotation: list[float]) -> Figure:
    printed = [row[4] for row in published.numbers()["rotation"]["rows"] if row[0] == 3]
    figure, (axes,) = draw.panels(1)
    axes.plot(omegas, [o / 2 for o in omegas], "o-", color=draw.COLOURS[0], label="bending $f_n$")
    axes.plot(omegas, rotation, "s-", color=draw.COLOURS[3], label="rotation $f_B$, ours")
    axes.plot(omegas, printed, **draw.PUBLISHED)
    draw.plain(axes, "$\\omega_n$ (π rad/s)", "frequency (Hz)")
    legend_beside(axes)
    return figure
