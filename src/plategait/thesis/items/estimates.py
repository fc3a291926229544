"""Figs. 5.11 and 5.12 and appendix B: estimated on real stiffness and friction."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from plategait import published
from plategait.plots.style import legend_beside
from plategait.published import PublishedCurve
from plategait.thesis import draw
from plategait.thesis.fits import Fits, ensemble_spread, published_curves, simulated_fits
from plategait.thesis.item import Cell, Check, Comparison, Item, Spec, Table
from plategait.thesis.regressions import Regression
from plategait.thesis.runs import Results

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True)
class _Estimated:
    """What one of the figures estimates: names in the fits, in the published curves and regressions, and its unit."""

    name: str
    real: str
    printed: Callable[[PublishedCurve], float]
    regression: Callable[[Fits], Regression]
    unit: str


_ESTIMATED = {
    "fig5.11": _Estimated("omega", "omega_pi", lambda c: c.omega_estimate_pi, lambda f: f.omega_check, "π rad/s"),
    "fig5.12": _Estimated("alpha", "alpha_deg", lambda c: c.alpha_estimate_deg, lambda f: f.alpha_check, "deg"),
}
# Numbers of the regression and by how much each may be off.
_ALLOWED = {"r2": 0.05, "slope": 0.05, "intercept": 2.0}


def fig_estimates(spec: Spec, results: Results) -> Item:
    """Estimated against real values with the 95 % band, Fig. 5.11 or 5.12."""
    quantity = _ESTIMATED[spec.name]
    figure, panels = draw.panels(2, width=6)
    comparisons: list[Comparison] = []
    for axes, angle, letter in zip(panels, published.AMPLITUDES, "ab", strict=True):
        _draw_estimates(axes, quantity, results, angle, f"({letter}) $A_p$ = {angle} deg")
        comparisons += _compare_regression(quantity, results, angle)
    return spec.item(
        figures=[(spec.name, figure)],
        comparisons=comparisons,
        notes=[
            "For a regression on its own data the slope equals R², and the intercept follows from the mean: "
            "these are one number, not three."
        ],
    )


def _draw_estimates(axes: Axes, quantity: _Estimated, results: Results, angle: int, title: str) -> None:
    fits = simulated_fits(results, angle)
    real = getattr(fits, quantity.real)
    axes.plot(real, [quantity.printed(c) for c in published_curves(angle)], **draw.PUBLISHED)
    axes.plot(
        real, getattr(fits, f"{quantity.name}_estimate"), "o", mfc="white", color=draw.COLOURS[0], ms=4, label="ours"
    )
    draw.line(axes, quantity.regression(fits), real, band=True)
    axes.plot(real, real, color=draw.COLOURS[6], lw=0.8, label="estimated as real")
    draw.plain(axes, f"real ({quantity.unit})", f"estimated ({quantity.unit})", title)
    legend_beside(axes)


def _compare_regression(quantity: _Estimated, results: Results, angle: int) -> list[Comparison]:
    line = quantity.regression(simulated_fits(results, angle))
    return [
        Comparison(
            f"{'R²' if attribute == 'r2' else attribute}, A_p = {angle} deg",
            published.regression(angle)[f"{attribute}_{quantity.name}"],
            getattr(line, attribute),
            allowed,
            absolute=True,
            spread=_spread(results, angle, quantity.regression, attribute),
        )
        for attribute, allowed in _ALLOWED.items()
    ]


def _spread(results: Results, angle: int, regression: Callable[[Fits], Regression], attribute: str) -> float:
    """Spread over the starts of one number of a regression."""
    return ensemble_spread(results, angle, lambda fits: float(getattr(regression(fits), attribute)))


def appendix_b(spec: Spec, results: Results) -> Item:
    """Do slope and intercept of α̂ on α differ from 1 and 0? Tables B.1 and B.2."""
    columns = ("A_p (deg)", "number", "published", "ours", "sd over the starts", "where")
    return spec.item(
        tables=[Table(spec.name, columns, tuple(row for a in published.AMPLITUDES for row in _test_rows(results, a)))],
        checks=[check for a in published.AMPLITUDES for check in _judge_tests(results, a)],
        notes=[
            "In-sample the slope equals R² whatever the truth: the test then asks only whether R² is near enough 1 for "
            "so few points, and a lower R² fails it."
        ],
    )


def _tests(line: Regression) -> dict[str, float]:
    """Numbers of the tests by their published names."""
    return {
        "t_slope": line.t_slope()[0],
        "t_intercept": line.t_intercept()[0],
        "p_intercept": line.t_intercept()[1],
        "t_unit_slope": line.t_slope(1.0)[0],
        "p_unit_slope": line.t_slope(1.0)[1],
        "slope_alpha": line.slope,
        "intercept_alpha": line.intercept,
        "freedom": float(line.freedom),
    }


def _test_rows(results: Results, angle: int) -> list[tuple[Cell, ...]]:
    printed, check = published.regression(angle), _ESTIMATED["fig5.12"].regression
    spread = {f"{attribute}_alpha": _spread(results, angle, check, attribute) for attribute in ("slope", "intercept")}
    return [
        (angle, name.replace("_", " "), printed[name].value, value, spread.get(name, math.nan), printed[name].where)
        for name, value in _tests(simulated_fits(results, angle).alpha_check).items()
    ]


def _judge_tests(results: Results, angle: int) -> list[Check]:
    tests = _tests(simulated_fits(results, angle).alpha_check)
    return [
        Check(f"{what}, A_p = {angle} deg", "p above 0.05", f"p = {p:.3f}", p > 0.05)
        for what, p in (
            ("slope does not differ from 1", tests["p_unit_slope"]),
            ("intercept does not differ from 0", tests["p_intercept"]),
        )
    ]
