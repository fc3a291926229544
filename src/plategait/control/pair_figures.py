"""Pictures of two sheets on one plate: what they can do apart from each other, and their ways to their goals."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.control.figures import draw_plate
from plategait.control.pair_reach import PairReach
from plategait.control.steer import Steering
from plategait.model.scenario import Scenario
from plategait.plots.style import GREEN, GREY, LINES, RED, label_axes, legend_below, new_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_SLOW = 10.0  # s, at the end of the colours


def plot_pair(
    reach: PairReach,
    ways: tuple[Steering, Steering],
    scenario: Scenario,
    tried: Sequence[tuple[Steering, Steering]] = (),
) -> Figure:
    """Draw what is reachable, by where both sheets lie across the bar, and the ways of a pair over its plate.

    Parameters
    ----------
    reach : PairReach
    ways : (Steering, Steering)
        Of the pair that is drawn on its plate.
    scenario : Scenario
        Of either sheet, with its plate.
    tried : sequence of (Steering, Steering), optional
        Pairs whose goals are marked where they lie across the bar: filled where they were reached.
    """
    figure = new_figure(11.0, 5.0)
    left, right = figure.subplots(1, 2)
    _draw_reach(left, reach)
    for one, other in tried:
        y = [1e3 * way.arrivals[0].goal.y for way in (one, other)]
        left.plot(y[0], y[1], "o", ms=5, mec="black", mfc="white" if not one.reached else "black", zorder=3)
    poses = np.concatenate([way.poses for way in ways] + [way.aims[:1] for way in ways])
    radius = max(scenario.sheet.outline.size()) / 2
    draw_plate(right, scenario, np.concatenate([poses - radius, poses + radius]))
    for way, name, (colour, dash) in zip(ways, ("first", "second"), LINES, strict=False):
        right.plot(*(1e3 * way.poses[:, :2].T), color=colour, lw=1, ls=dash, label=f"way of the {name} sheet")
        _ring(right, way.poses[0], radius, GREY, ":")
        _ring(right, way.poses[-1], radius, colour, dash)
        arrival = way.arrivals[0]
        mark, mark_colour, word = ("+", GREEN, "reached") if arrival.reached else ("x", RED, "not reached")
        right.plot(1e3 * arrival.goal.x, 1e3 * arrival.goal.y, mark, ms=9, mew=1.5, color=mark_colour,
                   label=f"goal, {word}")  # fmt: skip
    right.plot([], [], color=GREY, ls=":", label="rim at the start")
    legend_below(figure, columns=5)
    told = ways[0].arrivals[0]
    right.set_title(f"both held after {told.time:.1f} s" if told.reached else told.status, fontsize=10)
    return figure


def _draw_reach(axes: Axes, reach: PairReach) -> None:
    edge = 1e3 * float(reach.places[-1] + (reach.places[1] - reach.places[0]) / 2)
    longest = np.where(reach.ways == reach.times.shape[2], reach.times.max(axis=2), np.nan)
    shown = axes.imshow(np.minimum(longest, _SLOW).T, origin="lower", extent=(-edge, edge, -edge, edge),
                        cmap="viridis_r", vmin=0, vmax=_SLOW)  # fmt: skip
    axes.set_facecolor("#D0D0D0")
    axes.figure.colorbar(shown, ax=axes, shrink=0.8, label="slowest of the twelve ways (s), grey: not all of them")
    label_axes(axes, "first sheet across the bar (mm)", "second sheet across the bar (mm)")
    axes.set_title("one sheet by 10 mm or 20 deg, the other left where it is", fontsize=10)


def _ring(axes: Axes, pose: Array, radius: float, colour: str, line: str) -> None:
    from matplotlib.patches import Circle

    axes.add_patch(Circle((1e3 * pose[0], 1e3 * pose[1]), 1e3 * radius, fill=False, ec=colour, ls=line, lw=1.2))
