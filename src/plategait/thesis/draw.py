"""Pictures that several items share. They draw and compute nothing."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from plategait.arrays import Array
from plategait.plots import symbols
from plategait.plots.failures import Failures, draw_failures, failure_handles
from plategait.plots.style import label_axes, legend_beside, mark
from plategait.thesis.regressions import Regression
from plategait.thesis.runs import CaseRuns

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.typing import ColorType

GAIT_MARKERS = {"sliding": "s", "walking": "^", "running": "o", "": "D"}
COLOURS = ("#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#7F7F7F", "#000000")
FREQUENCY, ACCELERATION, RATE = symbols.FREQUENCY, symbols.ACCELERATION, symbols.SPIN_RATE
# Dashes beside the colours, so that no curve is told by its colour alone.
DASHES = ("-", "--", "-.", ":", (0, (8, 2)), (0, (3, 1, 1, 1, 1, 1)), (0, (5, 1)), (0, (1, 1)))
PUBLISHED = {"color": "black", "ls": "none", "marker": "x", "ms": 5, "mew": 1.2, "label": "published"}


def panels(columns: int, rows: int = 1, width: float = 5.0, height: float = 3.6) -> tuple[Figure, list[Axes]]:
    """Figure with a grid of panels."""
    from matplotlib.figure import Figure as MatplotlibFigure

    figure = MatplotlibFigure(figsize=(width * columns, height * rows), layout="constrained")
    axes: Any = figure.subplots(rows, columns, squeeze=False)
    return figure, list(axes.ravel())


def plain(axes: Axes, x: str, y: str, title: str = "") -> None:
    """Label the axes and take the frame away."""
    label_axes(axes, x, y)
    axes.set_title(title, loc="left", fontsize=9.5)


def curve(axes: Axes, runs: CaseRuns, x: ArrayLike, colour: ColorType, label: str, fit: bool = False) -> Failures:
    """Spin rates that did not fail, marked by gait, up to the run-off; with the spread over the starts.

    Half-filled marks are of points at which some starts failed. What failed is returned, to be drawn when all curves
    are (`finish`).
    """
    dash = DASHES[COLOURS.index(colour)] if colour in COLOURS else "-"
    x = np.asarray(x, dtype=float)
    fitted, rate = runs.curve.fitted, runs.curve.spin_rate_deg_s
    axes.plot(
        x[fitted],
        rate[fitted],
        color=colour,
        lw=0.8 if fit else 1.2,
        ls=(0, (1, 2)) if fit else dash,
        label=None if fit else label,
    )
    _mark_gaits(axes, runs, x, colour)
    if fit and runs.fit is not None and fitted.any():
        grid = np.linspace(runs.fit_from, x[fitted].max() + 2, 200)
        axes.plot(grid, runs.fit(grid), color=colour, lw=1.2, ls=dash, label=label)
    failed = runs.curve.failed
    kinds = [kind for kind, fails in zip(runs.curve.failure, failed, strict=True) if fails]
    return Failures(x[failed], kinds, colour, dash)


def finish(axes: Axes, failures: Sequence[Failures] = (), **legend: Any) -> None:
    """Draw what failed on the curves of a panel in a band under it, and its legend beside it."""
    axes.set_ylim(bottom=min(0.0, axes.get_ylim()[0]) if axes.get_ylim()[0] < -20 else 0.0)
    draw_failures(axes, failures, scale=0.7 if len(failures) < 4 else 0.5)
    for handle in failure_handles([kind for row in failures for kind in row.kind]):
        axes.add_line(handle)  # type: ignore[arg-type]
    legend_beside(axes, **legend)


def _mark_gaits(axes: Axes, runs: CaseRuns, x: Array, colour: ColorType) -> None:
    curve = runs.curve
    rate, sd = curve.spin_rate_deg_s, np.nan_to_num(curve.spin_rate_sd_deg_s)
    for gait, marker in GAIT_MARKERS.items():
        for in_part in (False, True):
            at = curve.fitted & (np.array(curve.gait) == gait) & (curve.partly_failed == in_part)
            if at.any():
                style = mark(colour, in_part)
                axes.errorbar(x[at], rate[at], sd[at], fmt=marker, ms=3.5, color=colour, lw=0.8, **style)


def gait_legend(axes: Axes) -> None:
    """Say which marker is which gait, and that half of it is filled where some starts failed."""
    for gait, marker in list(GAIT_MARKERS.items())[:3]:
        axes.plot([], [], marker, mfc="white", color="#7F7F7F", ms=4, label=gait)
    axes.plot([], [], "s", ls="", ms=4, label="some starts failed", **mark("#7F7F7F", True))


def scatter(axes: Axes, x: Array, y: Array, groups: Sequence[float], unit: str = "") -> None:
    """Points joined within each group."""
    for i, group in enumerate(sorted(set(groups))):
        members = np.array([g == group for g in groups])
        axes.plot(
            x[members], y[members], marker="os^Dv<>p"[i % 8], color=COLOURS[i % len(COLOURS)], lw=0.7, ms=3.5,
            label=f"{group:g}{unit}",
        )  # fmt: skip


def line(axes: Axes, regression: Regression, x: ArrayLike, band: bool = False) -> None:
    """Regression line, with its 95 % band if asked."""
    grid = np.linspace(np.nanmin(x), np.nanmax(x), 50)
    axes.plot(grid, regression(grid), color="black", lw=1.6, label=f"regression, $R^2$ = {regression.r2:.2f}")
    if band:
        low, high = regression.band(grid)
        axes.plot(grid, low, "--", grid, high, "--", color="black", lw=0.9)
