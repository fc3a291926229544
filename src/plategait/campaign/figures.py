"""Pictures of a campaign: curves over one swept parameter, families of curves or maps over two."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.campaign.opened import Campaign
from plategait.campaign.refine import curves
from plategait.errors import InputError
from plategait.model.parameters import Parameter
from plategait.plots.style import BLUE, GREEN, GREY, MARKERS, ORANGE, PARTLY_FAILED, RED, label_axes, mark, new_figure
from plategait.simulation.ensemble import Ensemble
from plategait.simulation.registry import all_observables
from plategait.units import parse

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Curves that can be told apart in one picture; more make a map.
MOST_CURVES = 6
SPIN_RATE = "spin_rate"
_COLOURS = (BLUE, ORANGE, GREEN, RED, "#56B4E9", "#CC79A7")
_NAMES = {
    "motion.frequency": "plate frequency $f_p$",
    "motion.angle": "angular amplitude $A_p$",
    "motion.stroke": "linear amplitude $B_p$",
    "natural_frequency": "natural frequency $\\omega_n$",
    "friction_angle": "friction angle $\\alpha$",
    "friction_ratio": "friction ratio $\\mu_k/\\mu_s$",
}


@dataclass(frozen=True, eq=False)
class _Drawn:
    """What is drawn over what was swept, and what the runs of each point show together."""

    value: Array
    spread: Array
    label: str
    points: Ensemble


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


def plot_campaign(campaign: Campaign, show: str = SPIN_RATE) -> Figure:
    """Draw the spin rate, or another observable, over what was swept.

    That is a curve, a family of curves, a map with contour lines, or one panel for each parameter.

    Gaits are squares (sliding), triangles (walking) and circles (running), as in Figs. 4.4 and 4.7, half-filled where
    some runs of a point failed; failed points are crosses.

    Parameters
    ----------
    show : str
        Observable by its name (`plategait.simulation.registry`); the spin rate by default.

    Raises
    ------
    InputError
        When no point has been run, only words were swept, or the store has no such observable.
    """
    if not campaign.done.any():
        raise InputError(
            "store", f"{campaign.path} without a point that has been run", "one with points", "plategait sweep"
        )
    drawn = _drawn(campaign, show)
    columns = [_column(campaign, p) for p in campaign.plan.parameters]
    numbers = [c for c in columns if c.parameter.quantity is not None]
    if not numbers:
        raise InputError("store", "a sweep of words", "a sweep of a number", '[grid] "motion.frequency" = "12:30:1 Hz"')
    if len(columns) == 1:
        figure = new_figure(6.4, 4.2)
        _draw_curve(figure.add_subplot(), numbers[0].values, drawn, range(len(drawn.value)), "black", "")
        _finish(figure.axes[0], numbers[0].label, campaign, drawn)
        return figure
    if len(columns) == 2 and not campaign.plan.sample:
        along, across = _order(numbers, columns)
        if across.different <= MOST_CURVES:
            return _family(campaign, drawn, along, across)
    if len(columns) == len(numbers) == 2 and min(c.different for c in columns) > 1:
        return _map(campaign, drawn, numbers[0], numbers[1])
    return _panels(campaign, drawn, numbers)


def _drawn(campaign: Campaign, show: str) -> _Drawn:
    points = campaign.outcomes
    if show == SPIN_RATE:
        label = "spin rate $\\omega_B$ (deg/s)"
        return _Drawn(np.degrees(points.rate), np.degrees(points.spread), label, points)
    value, spread = campaign.observable(show)
    observable = all_observables().get(show)
    if observable is None:  # of a package that is not installed here
        attributes = campaign.data[show].attrs
        return _Drawn(value, spread, f"{attributes['long_name']} ({attributes.get('units', '1')})", points)
    unit = "" if observable.read_in in ("1", "") else f" ({observable.read_in})"
    scale = 100.0 if observable.read_in == "%" else observable.scale
    return _Drawn(scale * value, scale * spread, (observable.label or observable.long_name) + unit, points)


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


def _draw_curve(axes: Axes, x: NDArray, drawn: _Drawn, members: Sequence[int], colour: str, label: str) -> None:
    order = sorted(members, key=lambda i: float(x[i]))
    sound = np.array([i for i in order if not drawn.points.failed[i] and math.isfinite(drawn.value[i])], dtype=int)
    spread = np.nan_to_num(drawn.spread[sound])
    axes.errorbar(x[sound], drawn.value[sound], spread, color=colour, lw=1.0, elinewidth=0.8, label=label or None)
    _draw_marks(axes, x, drawn.value, drawn.points, order, size=6.5, colour=colour if label else "")


def _draw_marks(axes: Axes, x: NDArray, y: NDArray, points: Ensemble, members: Sequence[int], size: float,
                colour: str = "") -> None:  # fmt: skip
    """Mark points by gait, half-filled where some runs failed, and with a cross where the point failed.

    The cross lies at 0 where y has no number. `colour` takes the place of each gait's own.
    """
    member = np.zeros(len(x), dtype=bool)
    member[list(members)] = True
    # A failed point has a mark as well where some of its runs went on.
    marked = member & np.isfinite(points.rate)
    for gait, (marker, own) in MARKERS.items():
        for in_part in (False, True):
            chosen = marked & np.array([g == gait for g in points.gait]) & (points.partly_failed == in_part)
            if chosen.any():
                style = mark(colour or own, in_part)
                axes.plot(x[chosen], y[chosen], marker, ms=size, mew=0.22 * size, zorder=3, **style)
    failed = member & points.failed
    if failed.any():
        heights = np.where(np.isfinite(y), y, 0.0)[failed]
        # Wider than a mark that it may lie on.
        axes.plot(x[failed], heights, "x", color=colour or GREY, ms=1.5 * size, mew=0.2 * size, zorder=4, clip_on=False)


def _finish(axes: Axes, x_label: str, campaign: Campaign, drawn: _Drawn, *, handles: Sequence[Any] = ()) -> None:
    label_axes(axes, x_label, drawn.label)
    axes.set_title(_title(campaign), loc="left", fontsize=11)
    axes.legend(handles=[*handles, *_gait_handles(drawn.points)], frameon=False, fontsize=8.5)


def _title(campaign: Campaign) -> str:
    left = len(campaign.done) - int(campaign.done.sum())
    return campaign.plan.name + (f" ({left} points not yet run)" if left else "")


def _gait_handles(points: Ensemble) -> list[Any]:
    """Legend of the marks that are there."""
    from matplotlib.lines import Line2D

    gaits = {g for g, rate in zip(points.gait, points.rate, strict=True) if math.isfinite(rate)}
    marks = [
        (gait or "gait unknown", marker, mark(colour)) for gait, (marker, colour) in MARKERS.items() if gait in gaits
    ]
    if points.failed.any():
        marks.append(("failed", "x", mark(GREY)))
    if points.partly_failed.any():
        marks.append((PARTLY_FAILED, "s", mark(GREY, True)))
    return [
        Line2D([], [], ls="", marker=marker, ms=6.5, mew=1.4, label=label, **style) for label, marker, style in marks
    ]


def _family(campaign: Campaign, drawn: _Drawn, along: _Column, across: _Column) -> Figure:
    from matplotlib.lines import Line2D

    figure = new_figure(6.8, 4.4)
    axes, handles = figure.add_subplot(), []
    for colour, (key, members) in zip(_COLOURS, curves(campaign.points, along.parameter.name).items(), strict=False):
        label = across.parameter.text_of(key[0])  # type: ignore[arg-type]
        _draw_curve(axes, along.values, drawn, members, colour, label)
        handles.append(Line2D([], [], color=colour, lw=1.5, label=label))
    handles.insert(0, Line2D([], [], ls="", label=f"{across.label.split(' (')[0]}:"))
    _finish(axes, along.label, campaign, drawn, handles=handles)
    return figure


def _map(campaign: Campaign, drawn: _Drawn, x: _Column, y: _Column) -> Figure:
    figure = new_figure(6.8, 5.0)
    axes = figure.add_subplot()
    sound = ~drawn.points.failed & np.isfinite(drawn.value)
    along, across, value = x.values[sound], y.values[sound], drawn.value[sound]
    if sound.sum() >= 4 and np.ptp(value) > 0 and _spread_out(along, across):
        filled = axes.tricontourf(along, across, value, levels=12, cmap="viridis", alpha=0.85)
        lines = axes.tricontour(along, across, value, levels=list(filled.levels)[::2], colors="white", linewidths=0.8)
        axes.clabel(lines, fontsize=7.5, fmt="%g")
        figure.colorbar(filled, ax=axes, label=drawn.label)
    _draw_marks(axes, x.values, y.values, drawn.points, range(len(drawn.value)), size=5)
    _finish(axes, x.label, campaign, drawn)
    axes.set_ylabel(y.label)
    below = {"loc": "upper left", "bbox_to_anchor": (0, -0.12), "ncols": 4}
    axes.legend(handles=_gait_handles(drawn.points), frameon=False, fontsize=8.5, **below)
    return figure


def _spread_out(x: NDArray, y: NDArray) -> bool:
    """Whether points lie on no line, so that contours can be drawn."""
    offsets = np.stack([(v - v.mean()) / (np.ptp(v) or 1.0) for v in (x, y)])
    return bool(np.linalg.matrix_rank(offsets, tol=1e-6) == 2)


def _panels(campaign: Campaign, drawn: _Drawn, numbers: Sequence[_Column]) -> Figure:
    figure = new_figure(max(6.4, 3.4 * len(numbers)), 3.8)
    panels: Any = figure.subplots(1, len(numbers), sharey=True, squeeze=False)[0]
    for axes, column in zip(panels, numbers, strict=True):
        _draw_marks(axes, column.values, drawn.value, drawn.points, range(len(drawn.value)), size=5)
        axes.set_xlabel(column.label)
        axes.spines[["top", "right"]].set_visible(False)
    panels[0].set_ylabel(drawn.label)
    panels[0].set_title(_title(campaign), loc="left", fontsize=11)
    panels[-1].legend(handles=_gait_handles(drawn.points), frameon=False, fontsize=8.5)
    return figure
