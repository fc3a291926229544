"""Pictures of a campaign: curves over one swept parameter, families of curves or maps over two."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from plategait.campaign.opened import Campaign
from plategait.campaign.refine import curves
from plategait.errors import InputError
from plategait.model.parameters import Parameter
from plategait.plots.style import BLUE, GREEN, GREY, MARKERS, ORANGE, PARTLY_FAILED, RED, mark
from plategait.simulation.ensemble import Ensemble
from plategait.units import parse

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Curves that can be told apart in one picture; more make a map.
MOST_CURVES = 6
_COLOURS = (BLUE, ORANGE, GREEN, RED, "#56B4E9", "#CC79A7")
_RATE = "spin rate $\\omega_B$ (deg/s)"
_NAMES = {
    "motion.frequency": "plate frequency $f_p$",
    "motion.angle": "angular amplitude $A_p$",
    "motion.stroke": "linear amplitude $B_p$",
    "natural_frequency": "natural frequency $\\omega_n$",
    "friction_angle": "friction angle $\\alpha$",
    "friction_ratio": "friction ratio $\\mu_k/\\mu_s$",
}


@dataclass(frozen=True, eq=False)
class _Column:
    """One swept parameter, in the unit that people read."""

    parameter: Parameter
    values: NDArray

    @property
    def label(self) -> str:
        name = _NAMES.get(self.parameter.name, self.parameter.name)
        return f"{name} ({self.parameter.quantity.display})" if self.parameter.unit else name  # type: ignore[union-attr]

    @property
    def different(self) -> int:
        return len(set(self.values.tolist()))


def plot_campaign(campaign: Campaign) -> Figure:
    """Spin rate over what was swept: a curve, a family of curves, a map with contour lines, or one panel for each.

    Gaits are squares (sliding), triangles (walking) and circles (running), as in Figs. 4.4 and 4.7, half-filled where
    some runs of a point failed; failed points are crosses.

    Raises
    ------
    InputError
        When no point has been run, or only words were swept.
    """
    if not campaign.done.any():
        raise InputError(
            "store", f"{campaign.path} without a point that has been run", "one with points", "plategait sweep"
        )
    shown = campaign.outcomes
    columns = [_column(campaign, p) for p in campaign.plan.parameters]
    numbers = [c for c in columns if c.parameter.quantity is not None]
    if not numbers:
        raise InputError("store", "a sweep of words", "a sweep of a number", '[grid] "motion.frequency" = "12:30:1 Hz"')
    if len(columns) == 1:
        figure = _figure(6.4, 4.2)
        _draw_curve(figure.add_subplot(), numbers[0].values, shown, range(len(shown.rate)), "black", "")
        _finish(figure.axes[0], numbers[0].label, campaign)
        return figure
    if len(columns) == 2 and not campaign.plan.sample:
        along, across = _order(numbers, columns)
        if across.different <= MOST_CURVES:
            return _family(campaign, shown, along, across)
    if len(columns) == len(numbers) == 2 and min(c.different for c in columns) > 1:
        return _map(campaign, shown, numbers[0], numbers[1])
    return _panels(campaign, shown, numbers)


def _figure(width: float, height: float) -> Figure:
    return Figure(figsize=(width, height), layout="constrained")


def _column(campaign: Campaign, parameter: Parameter) -> _Column:
    values = np.asarray(campaign.data[parameter.name].values)
    if parameter.quantity is not None and parameter.unit:
        values = values / parse(f"1 {parameter.quantity.display}", parameter.unit)
    return _Column(parameter, values)


def _order(numbers: Sequence[_Column], columns: Sequence[_Column]) -> tuple[_Column, _Column]:
    """Parameter along the curves, frequency or the one of most values, and the other."""
    by_name = [c for c in numbers if c.parameter.name == "motion.frequency"]
    along = by_name[0] if by_name else max(numbers, key=lambda c: c.different)
    return along, next(c for c in columns if c is not along)


def _draw_curve(axes: Axes, x: NDArray, shown: Ensemble, members: Sequence[int], colour: str, label: str) -> None:
    order = [i for i in sorted(members, key=lambda i: float(x[i]))]
    good = np.array([i for i in order if not shown.failed[i] and math.isfinite(shown.rate[i])], dtype=int)
    rate, spread = np.degrees(shown.rate), np.degrees(np.nan_to_num(shown.spread))
    axes.errorbar(x[good], rate[good], spread[good], color=colour, lw=1.0, elinewidth=0.8, label=label or None)
    _draw_marks(axes, x, rate, shown, order, size=6.5, colour=colour if label else "")


def _draw_marks(axes: Axes, x: NDArray, y: NDArray, shown: Ensemble, members: Sequence[int], size: float,
                colour: str = "") -> None:  # fmt: skip
    """Mark points by gait, half-filled where some runs failed, and with a cross where the point failed.

    The cross lies at 0 where y has no number. `colour` takes the place of each gait's own.
    """
    there = np.zeros(len(x), dtype=bool)
    there[list(members)] = True
    # A failed point has a mark as well where some of its runs went on.
    marked = there & np.isfinite(shown.rate)
    for gait, (marker, own) in MARKERS.items():
        for in_part in (False, True):
            here = marked & np.array([g == gait for g in shown.gait]) & (shown.partly_failed == in_part)
            if here.any():
                axes.plot(x[here], y[here], marker, ms=size, mew=0.22 * size, zorder=3, **mark(colour or own, in_part))
    failed = there & shown.failed
    if failed.any():
        heights = np.where(np.isfinite(y), y, 0.0)[failed]
        # Wider than a mark that it may lie on.
        axes.plot(x[failed], heights, "x", color=colour or GREY, ms=1.5 * size, mew=0.2 * size, zorder=4, clip_on=False)


def _finish(axes: Axes, x_label: str, campaign: Campaign, *, handles: Sequence[Any] = ()) -> None:
    axes.set_xlabel(x_label)
    axes.set_ylabel(_RATE)
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_title(_title(campaign), loc="left", fontsize=11)
    axes.legend(handles=[*handles, *_gait_handles(campaign.outcomes)], frameon=False, fontsize=8.5)


def _title(campaign: Campaign) -> str:
    left = len(campaign.done) - int(campaign.done.sum())
    return campaign.plan.name + (f" ({left} points not yet run)" if left else "")


def _gait_handles(shown: Ensemble) -> list[Any]:
    """Legend of the marks that are there."""
    from matplotlib.lines import Line2D

    gaits = {g for g, rate in zip(shown.gait, shown.rate, strict=True) if math.isfinite(rate)}
    marks = [
        (gait or "gait unknown", marker, mark(colour)) for gait, (marker, colour) in MARKERS.items() if gait in gaits
    ]
    if shown.failed.any():
        marks.append(("failed", "x", mark(GREY)))
    if shown.partly_failed.any():
        marks.append((PARTLY_FAILED, "s", mark(GREY, True)))
    return [
        Line2D([], [], ls="", marker=marker, ms=6.5, mew=1.4, label=label, **style) for label, marker, style in marks
    ]


def _family(campaign: Campaign, shown: Ensemble, along: _Column, across: _Column) -> Figure:
    from matplotlib.lines import Line2D

    figure = _figure(6.8, 4.4)
    axes, handles = figure.add_subplot(), []
    for colour, (key, members) in zip(_COLOURS, curves(campaign.points, along.parameter.name).items(), strict=False):
        label = across.parameter.shown(key[0])  # type: ignore[arg-type]
        _draw_curve(axes, along.values, shown, members, colour, label)
        handles.append(Line2D([], [], color=colour, lw=1.5, label=label))
    handles.insert(0, Line2D([], [], ls="", label=f"{across.label.split(' (')[0]}:"))
    _finish(axes, along.label, campaign, handles=handles)
    return figure


def _map(campaign: Campaign, shown: Ensemble, x: _Column, y: _Column) -> Figure:
    figure = _figure(6.8, 5.0)
    axes = figure.add_subplot()
    good = ~shown.failed & np.isfinite(shown.rate)
    rate = np.degrees(shown.rate)
    if good.sum() >= 4 and np.ptp(rate[good]) > 0 and _spread_out(x.values[good], y.values[good]):
        filled = axes.tricontourf(x.values[good], y.values[good], rate[good], levels=12, cmap="viridis", alpha=0.85)
        lines = axes.tricontour(
            x.values[good], y.values[good], rate[good], levels=list(filled.levels)[::2], colors="white", linewidths=0.8
        )
        axes.clabel(lines, fontsize=7.5, fmt="%g")
        figure.colorbar(filled, ax=axes, label=_RATE)
    _draw_marks(axes, x.values, y.values, shown, range(len(rate)), size=5)
    _finish(axes, x.label, campaign)
    axes.set_ylabel(y.label)
    axes.legend(handles=_gait_handles(shown), frameon=False, fontsize=8.5, loc="upper left", bbox_to_anchor=(0, -0.12),
                ncols=4)  # fmt: skip
    return figure


def _spread_out(x: NDArray, y: NDArray) -> bool:
    """Whether points lie on no line, so that contours can be drawn."""
    offsets = np.stack([(v - v.mean()) / (np.ptp(v) or 1.0) for v in (x, y)])
    return bool(np.linalg.matrix_rank(offsets, tol=1e-6) == 2)


def _panels(campaign: Campaign, shown: Ensemble, numbers: Sequence[_Column]) -> Figure:
    figure = _figure(max(6.4, 3.4 * len(numbers)), 3.8)
    panels: Any = figure.subplots(1, len(numbers), sharey=True, squeeze=False)[0]
    rate = np.degrees(shown.rate)
    for axes, column in zip(panels, numbers, strict=True):
        _draw_marks(axes, column.values, rate, shown, range(len(rate)), size=5)
        axes.set_xlabel(column.label)
        axes.spines[["top", "right"]].set_visible(False)
    panels[0].set_ylabel(_RATE)
    panels[0].set_title(_title(campaign), loc="left", fontsize=11)
    panels[-1].legend(handles=_gait_handles(shown), frameon=False, fontsize=8.5)
    return figure
