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
from plategait.plots.failures import Failures, draw_failures, failure_handles, marker_of
from plategait.plots.style import GREY, LINES, MARKERS, PARTLY_FAILED, head, label_axes, legend_below, mark, new_figure
from plategait.plots.symbols import SPIN_RATE as SPIN_RATE_LABEL
from plategait.plots.symbols import label_of, motion_in_words, unit_read, value_with
from plategait.simulation.ensemble import Ensemble
from plategait.simulation.registry import all_observables

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.tri import Triangulation

# Curves that can be told apart in one picture; more make a map.
MOST_CURVES = len(LINES)
SPIN_RATE = "spin_rate"


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
    unit: str

    @property
    def label(self) -> str:
        return label_of(self.parameter, self.unit)

    @property
    def different(self) -> int:
        return len(set(self.values.tolist()))


def plot_campaign(campaign: Campaign, show: str = SPIN_RATE) -> Figure:
    """Draw the spin rate, or another observable, over what was swept.

    That is a curve, a family of curves, a map with contour lines, or one panel for each parameter.

    Gaits are squares (sliding), triangles (walking) and circles (running), as in Figs. 4.4 and 4.7, half-filled where
    some runs of a point failed. Points that failed are marked by what went wrong: over one parameter in a band under
    the axes, a row for each curve, and in a map where they lie, which has no colour there. The head tells what was
    held.

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
        return _single(campaign, drawn, numbers[0])
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
        return _Drawn(np.degrees(points.rate), np.degrees(points.spread), SPIN_RATE_LABEL, points)
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
    if parameter.quantity is None or not parameter.unit:
        return _Column(parameter, values, "")
    size, unit = unit_read(parameter, np.unique(values).tolist())
    return _Column(parameter, values / size, unit)


def _order(numbers: Sequence[_Column], columns: Sequence[_Column]) -> tuple[_Column, _Column]:
    """Parameter along the curves, frequency or the one of most values, and the other."""
    by_name = [c for c in numbers if c.parameter.name == "motion.frequency"]
    along = by_name[0] if by_name else max(numbers, key=lambda c: c.different)
    return along, next(c for c in columns if c is not along)


def _draw_curve(axes: Axes, x: NDArray, drawn: _Drawn, members: Sequence[int], colour: str, dash: Any) -> None:
    order = sorted(members, key=lambda i: float(x[i]))
    sound = np.array([i for i in order if not drawn.points.failed[i] and math.isfinite(drawn.value[i])], dtype=int)
    spread = np.nan_to_num(drawn.spread[sound])
    axes.errorbar(x[sound], drawn.value[sound], spread, color=colour, ls=dash, lw=1.2, elinewidth=0.8)


def _draw_marks(axes: Axes, x: NDArray, y: NDArray, points: Ensemble, members: Sequence[int], size: float,
                colour: str = "") -> None:  # fmt: skip
    """Mark points by gait, half-filled where some runs failed; `colour` takes the place of each gait's own."""
    member = np.zeros(len(x), dtype=bool)
    member[list(members)] = True
    # A failed point has a mark as well where some of its runs went on.
    marked = member & np.isfinite(points.rate)
    for gait, (marker, own) in MARKERS.items():
        for in_part in (False, True):
            chosen = marked & np.array([g == gait for g in points.gait]) & (points.partly_failed == in_part)
            if chosen.any():
                style = mark(colour or own, in_part)
                axes.plot(x[chosen], y[chosen], marker, ms=size, mew=0.22 * size, zorder=3, clip_on=False, **style)


def _failures(x: NDArray, points: Ensemble, members: Sequence[int], **style: Any) -> Failures:
    """Those of some points that failed."""
    failed = [i for i in members if points.failed[i]]
    return Failures(x[failed], [points.failure[i] for i in failed], **style)


def _from_zero(axes: Axes, drawn: _Drawn) -> None:
    """Begin the axes at zero, unless values are below it or all far above."""
    value = drawn.value[np.isfinite(drawn.value)]
    if len(value) and 0 <= value.min() < 0.5 * value.max():
        axes.set_ylim(bottom=0)


def _head(axes: Axes, campaign: Campaign, drawn: _Drawn, bars: bool) -> None:
    """Say what the campaign is called, what it held, how many runs there are of a point, and how many are missing."""
    plan, runs = campaign.plan, drawn.points.runs
    words = motion_in_words(plan.scenario.motion, [p.name for p in plan.parameters])
    many = f"{runs} runs a point" + (", bars: their sd" if bars else "") if runs > 1 else "1 run a point"
    left = len(campaign.done) - int(campaign.done.sum())
    details = ", ".join(filter(None, (words, many, f"{left} points not yet run" if left else "")))
    head(axes, plan.name, [details])


def _handles(points: Ensemble, colour: str = "") -> list[Any]:
    """Legend of the marks that are there; `colour` takes the place of each gait's own."""
    from matplotlib.lines import Line2D

    gaits = {g for g, rate in zip(points.gait, points.rate, strict=True) if math.isfinite(rate)}
    marks = [
        (gait or "gait unknown", marker, mark(colour or own))
        for gait, (marker, own) in MARKERS.items()
        if gait in gaits
    ]
    if points.partly_failed.any():
        marks.append((PARTLY_FAILED, "s", mark(GREY, True)))
    kinds = [kind for kind, failed in zip(points.failure, points.failed, strict=True) if failed]
    handles = [
        Line2D([], [], ls="", marker=marker, color=GREY, ms=6.5, mew=1.4, label=label, **style)
        for label, marker, style in marks
    ]
    return [*handles, *failure_handles(kinds)]


def _single(campaign: Campaign, drawn: _Drawn, along: _Column) -> Figure:
    figure = new_figure(6.4, 4.4)
    axes, members = figure.add_subplot(), range(len(drawn.value))
    _draw_curve(axes, along.values, drawn, members, "black", "-")
    _draw_marks(axes, along.values, drawn.value, drawn.points, members, size=6.5)
    label_axes(axes, along.label, drawn.label)
    _from_zero(axes, drawn)
    draw_failures(axes, [_failures(along.values, drawn.points, members)])
    _head(axes, campaign, drawn, bars=True)
    legend_below(figure, _handles(drawn.points))
    return figure


def _family(campaign: Campaign, drawn: _Drawn, along: _Column, across: _Column) -> Figure:
    from matplotlib.lines import Line2D

    figure = new_figure(6.8, 4.8)
    axes, handles, failures = figure.add_subplot(), [], []
    for (colour, dash), (key, members) in zip(
        LINES, curves(campaign.points, along.parameter.name).items(), strict=False
    ):
        _draw_curve(axes, along.values, drawn, members, colour, dash)
        _draw_marks(axes, along.values, drawn.value, drawn.points, members, size=6.0, colour=colour)
        failures.append(_failures(along.values, drawn.points, members, colour=colour, dash=dash))
        handles.append(Line2D([], [], color=colour, ls=dash, lw=1.5, label=value_with(across.parameter, key[0])))  # type: ignore[arg-type]
    label_axes(axes, along.label, drawn.label)
    _from_zero(axes, drawn)
    draw_failures(axes, failures)
    _head(axes, campaign, drawn, bars=True)
    legend_below(figure, [*handles, *_handles(drawn.points, GREY)], columns=3 if len(handles) == 3 else 4)
    return figure


def _map(campaign: Campaign, drawn: _Drawn, x: _Column, y: _Column) -> Figure:
    figure = new_figure(6.8, 5.2)
    axes, points = figure.add_subplot(), drawn.points
    sound = ~points.failed & np.isfinite(drawn.value)
    if mesh := _triangles(x.values, y.values, sound):
        value = np.where(sound, drawn.value, 0.0)
        levels = _levels(drawn.value[sound])
        filled = axes.tricontourf(mesh, value, levels=levels, cmap="viridis", alpha=0.85, extend="neither")
        lines = axes.tricontour(mesh, value, levels=levels[1:-1:2], colors="white", linewidths=0.8)
        figure.colorbar(filled, ax=axes, label=drawn.label, ticks=lines.levels).add_lines(lines)
    _draw_marks(axes, x.values, y.values, points, range(len(drawn.value)), size=5)
    for kind in dict.fromkeys(k for k, failed in zip(points.failure, points.failed, strict=True) if failed):
        at = points.failed & np.array([k == kind for k in points.failure])
        axes.plot(x.values[at], y.values[at], marker_of(kind), color="#404040", ms=7, mew=1.2, zorder=4, clip_on=False)
    label_axes(axes, x.label, y.label)
    # No mark lies on the edge of the map.
    axes.use_sticky_edges = False
    axes.margins(0.04)
    _head(axes, campaign, drawn, bars=False)
    legend_below(figure, _handles(points))
    return figure


def _levels(values: Array) -> Array:
    from matplotlib.ticker import MaxNLocator

    return np.asarray(
        MaxNLocator(nbins=15, steps=[1, 2, 2.5, 5, 10]).tick_values(float(values.min()), float(values.max()))
    )


def _triangles(x: NDArray, y: NDArray, sound: NDArray[np.bool_]) -> Triangulation | None:
    """Triangles between points, without those that touch a failed one; None where there are too few to colour."""
    from matplotlib.tri import Triangulation

    if sound.sum() < 4 or not _spread_out(x[sound], y[sound]):
        return None
    # In shares of the map, so that the triangles do not depend on the units.
    share = [(v - v.min()) / np.ptp(v) for v in (x, y)]
    corners = Triangulation(*share).triangles
    whole = sound[corners].all(axis=1)
    return Triangulation(x, y, corners[whole]) if whole.any() else None


def _spread_out(x: NDArray, y: NDArray) -> bool:
    """Whether points lie on no line, so that contours can be drawn."""
    offsets = np.stack([(v - v.mean()) / (np.ptp(v) or 1.0) for v in (x, y)])
    return bool(np.linalg.matrix_rank(offsets, tol=1e-6) == 2)


def _panels(campaign: Campaign, drawn: _Drawn, numbers: Sequence[_Column]) -> Figure:
    figure = new_figure(max(6.4, 3.4 * len(numbers)), 4.2)
    panels: Any = figure.subplots(1, len(numbers), squeeze=False)[0]
    members = range(len(drawn.value))
    for i, (axes, column) in enumerate(zip(panels, numbers, strict=True)):
        _draw_marks(axes, column.values, drawn.value, drawn.points, members, size=5)
        label_axes(axes, column.label, "" if i else drawn.label)
        _from_zero(axes, drawn)
        draw_failures(axes, [_failures(column.values, drawn.points, members)])
    _head(panels[0], campaign, drawn, bars=False)
    legend_below(figure, _handles(drawn.points))
    return figure
