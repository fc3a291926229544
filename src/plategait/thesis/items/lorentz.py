"""Figs. 5.3 and 5.4: the Lorentz distribution, and three spin curves that it was fitted to."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from plategait import published
from plategait.arrays import Array
from plategait.curve.lorentz import lorentzian
from plategait.thesis import draw
from plategait.thesis.cases import Case
from plategait.thesis.item import Check, Comparison, Item, Spec
from plategait.thesis.runs import CaseRuns, Results, value_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


_WIDTHS = (0.5, 1.0, 2.0)


def fig_5_3(spec: Spec, results: Results) -> Item:
    """Lorentz distribution (5.1)."""
    wide = np.linspace(-4000, 4000, 2_000_001)
    areas = [float(np.trapezoid(_distribution(wide, width), wide)) for width in _WIDTHS]
    return spec.item(
        figures=[(spec.name, _draw_distributions())],
        checks=[
            Check(
                "area under each",
                "1 within 0.001",
                ", ".join(f"{a:.4f}" for a in areas),
                all(abs(a - 1) < 1e-3 for a in areas),
            )
        ],
        notes=["Closed form; the three widths are not printed, 0.5, 1 and 2 are shown."],
    )


def _distribution(x: Array, width: float) -> Array:
    return lorentzian(x, 1 / (math.pi * width), 0.0, width)


def _draw_distributions() -> Figure:
    figure, (axes,) = draw.panels(1)
    x = np.linspace(-5, 5, 301)
    for i, width in enumerate(_WIDTHS):
        axes.plot(x, _distribution(x, width), color=draw.COLOURS[i], ls=draw.DASHES[i], label=f"$\\lambda$ = {width:g}")
    draw.plain(axes, "$x$", "$g(x)$")
    draw.finish(axes)
    return figure


# Numbers of a fit that section 5.3.2 prints: attribute, quantity, and deviation allowed (relative; of R² absolute).
_PRINTED = (
    ("peak", "ω_Br max, deg/s", 0.15),
    ("f0_hz", "f0, Hz", 0.05),
    ("half_width_hz", "b, Hz", 0.15),
    ("r2", "R²", 0.03),
)


def fig_5_4(spec: Spec, results: Results) -> Item:
    """Three curves with their fits."""
    figure, panels = draw.panels(3, width=4.8)
    comparisons: list[Comparison] = []
    for axes, letter, (omega, alpha, *printed) in zip(
        panels, "abc", published.numbers()["examples"]["rows"], strict=False
    ):
        runs, name = results[Case(3, omega, alpha)], f"({letter}) {omega:g}π, {alpha:g} deg"
        title = f"({letter}) $\\omega_n$ = {omega:g}π rad/s, $\\alpha$ = {alpha:g} deg"
        _draw_example(axes, runs, title, printed)
        comparisons += _compare_fit(results, runs, name, printed)
    return spec.item(
        figures=[(spec.name, figure)],
        comparisons=comparisons,
        notes=["Where a curve's f0 is low, the sheet drifts off the plate before the rate has turned over."],
    )


def _draw_example(axes: Axes, runs: CaseRuns, title: str, printed: list[float]) -> None:
    peak, f0, width, _ = printed
    failures = [draw.curve(axes, runs, runs.curve.frequency_hz, draw.COLOURS[0], "ours, fit", fit=True)]
    grid = np.linspace(13, 31, 200)
    axes.plot(grid, lorentzian(grid, peak, f0, width), color="black", ls="--", lw=1, label="published fit")
    draw.plain(axes, draw.FREQUENCY, draw.RATE, title)
    draw.finish(axes, failures)


def _compare_fit(results: Results, runs: CaseRuns, name: str, printed: list[float]) -> list[Comparison]:
    return [
        Comparison(
            f"{name}: {quantity}",
            published.Number(value, "section 5.3.2, Fig. 5.4"),
            value_of(runs.fit, attribute),
            allowed,
            spread=runs.member_spread(attribute),
            half_step=results.effect(runs.case, "half step", attribute),
        )
        for (attribute, quantity, allowed), value in zip(_PRINTED, printed, strict=True)
    ]
