"""Pictures of a steering: how far the object is from its goal over time, and its way over the plate."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.control.follow import Following
from plategait.control.goal import WITHIN, WITHIN_ANGLE, Goal
from plategait.control.steer import Steering
from plategait.model.scenario import Plate, Scenario
from plategait.plots.style import (
    BLUE,
    GREEN,
    GREY,
    RED,
    label_axes,
    legend_below,
    new_figure,
    plain_logarithms,
    plain_text,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# Length of the strokes that show angles, and what is shown around the way, mm.
_STROKE, _ROUND = 6.0, 12.0


def plot_steering(
    way: Steering,
    goals: Sequence[Goal] = (),
    scenario: Scenario | None = None,
    within: tuple[float, float] = (WITHIN, WITHIN_ANGLE),
    title: str = "",
) -> Figure:
    """Distance and angle from the goal over time, with the tolerances, and the way over the plate.

    Parameters
    ----------
    way : Steering
    goals : sequence of Goal, optional
        Those that it was aimed at, if left out.
    scenario : Scenario, optional
        With its plate, of which the rim is drawn.
    within : (float, float), optional
        How near counts as there, m and rad.
    title : str
    """
    goals = goals or [arrival.goal for arrival in way.arrivals]
    figure = new_figure(11.0, 4.8)
    axes = figure.subplot_mosaic([["distance", "plate"], ["turn", "plate"]], width_ratios=(1.25, 1))
    above, below, plate = axes["distance"], axes["turn"], axes["plate"]
    above.sharex(below)
    off = way.poses - way.aims
    distance = 1e3 * np.hypot(off[:, 0], off[:, 1])
    turn = np.degrees(np.abs(np.remainder(off[:, 2] + math.pi, 2 * math.pi) - math.pi))
    _draw_error(above, way, distance, 1e3 * within[0])
    _draw_error(below, way, turn, math.degrees(within[1]))
    label_axes(above, "", "distance to the goal (mm)")
    label_axes(below, "time (s)", "angle from it (deg)")
    if not np.isfinite(turn).any():
        below.text(0.5, 0.5, "any angle", transform=below.transAxes, ha="center", color=GREY)
    draw_plate(plate, scenario, np.concatenate([way.poses, [goal.pose for goal in goals]]))
    plate.plot(*(1e3 * way.poses[:, :2].T), color=BLUE, lw=1)
    _mark(plate, way.poses[0], GREY)
    _mark(plate, way.poses[-1], BLUE)
    for number, goal in enumerate(goals):
        reached = number < len(way.arrivals) and way.arrivals[number].reached
        name = "" if len(goals) == 1 else str(number + 1)
        _mark(plate, goal.pose, GREEN if reached else RED, name, within[0], "o" if reached else "X")
    _legend(figure, way, goals)
    tolerances = f"within {1e3 * within[0]:.3g} mm and {math.degrees(within[1]):.3g} deg (dashed)"
    figure.suptitle(", ".join(filter(None, (plain_text(title), tolerances))), fontsize=10, x=0.01, ha="left")
    return figure


def _legend(figure: Figure, way: Steering, goals: Sequence[Goal]) -> None:
    """What the marks and lines are; a stroke at a mark looks the way that the object does."""
    from matplotlib.lines import Line2D

    reached = [number < len(way.arrivals) and way.arrivals[number].reached for number in range(len(goals))]
    handles = [
        Line2D([], [], color=BLUE, lw=1.2, marker="o", ms=4, label="way of the object, to where it ended"),
        Line2D([], [], color=GREY, lw=1.5, marker="o", ms=4, label="start"),
        *[Line2D([], [], color=GREEN, lw=1.5, marker="o", ms=4, label="goal, reached")] * any(reached),
        *[Line2D([], [], color=RED, lw=1.5, marker="X", ms=5, label="goal, not reached")] * (not all(reached)),
    ]
    legend_below(figure, handles)


def plot_following(following: Following, scenario: Scenario | None = None, title: str = "") -> Figure:
    """How far the object was from each point of its path when it came by, and its way along the path."""
    figure = new_figure(11.0, 4.8)
    left, right = figure.subplots(1, 2, width_ratios=(1.25, 1))
    path, way = following.path, following.way
    for begin, end in path.ends:
        arc, part = 1e3 * path.arc[begin:end], slice(begin, end)
        left.fill_between(
            arc, 1e3 * following.nearest[part], 1e3 * following.farthest[part], color=BLUE, alpha=0.2, lw=0,
            label="nearest to farthest within a pass",
        )  # fmt: skip
        left.plot(arc, 1e3 * following.errors[part], color=BLUE, lw=1.2)
    left.axhline(1e3 * following.rms, color=GREY, lw=0.8, ls="--", label=f"r.m.s., {1e3 * following.rms:.2g} mm")
    left.set_ylim(bottom=0)
    label_axes(left, "along the path (mm)", "distance from it (mm)")
    draw_plate(right, scenario, np.concatenate([way.poses[:, :2], path.points]))
    for stroke in path.strokes:
        right.plot(*(1e3 * stroke.T), color=RED, lw=3, alpha=0.4, label="path")
    right.plot(*(1e3 * way.poses[:, :2].T), color=BLUE, lw=0.8, label="way of the object, to where it ended")
    right.plot([], [], color=GREY, lw=1.5, marker="o", ms=4, label="start")
    _mark(right, way.poses[0], GREY)
    _mark(right, way.poses[-1], BLUE)
    legend_below(figure, columns=5)
    figure.suptitle(plain_text(title), fontsize=10, x=0.01, ha="left")
    return figure


def _draw_error(axes: Axes, way: Steering, error: Array, within: float) -> None:
    axes.semilogy(way.times, np.maximum(error, 1e-2), color=BLUE, lw=1.2)
    axes.axhline(within, color=GREY, lw=0.8, ls="--")
    for time in way.times[1:][np.any(np.diff(np.nan_to_num(way.aims), axis=0) != 0, axis=1)]:
        axes.axvline(float(time), color=GREY, lw=0.6)
    axes.set_ylim(bottom=0.1)
    plain_logarithms(axes.yaxis)


def draw_plate(axes: Axes, scenario: Scenario | None, poses: Array) -> None:
    """Rim of the plate, if it is known, and the bar's axis, mm, so far as poses (n, 3) lie."""
    from matplotlib.patches import Rectangle

    plate = (scenario.plate if scenario else None) or Plate()
    length, width = 1e3 * plate.length, 1e3 * plate.width
    if scenario is not None:
        axes.add_patch(Rectangle((-length / 2, -width / 2), length, width, fill=False, ec=GREY, lw=1.2))
    axes.plot([-length / 2, length / 2], [0, 0], color=GREY, lw=0.8, ls="-.")
    low, high = 1e3 * np.nanmin(poses[:, :2], axis=0), 1e3 * np.nanmax(poses[:, :2], axis=0)
    middle, half = (low + high) / 2, 0.5 * float((high - low).max()) + _ROUND
    axes.set_xlim(middle[0] - half, middle[0] + half)
    axes.set_ylim(middle[1] - half, middle[1] + half)
    axes.set_aspect("equal")
    label_axes(axes, "along the bar (mm)", "across it (mm)")


def _mark(axes: Axes, pose: Array, colour: str, name: str = "", within: float = 0.0, marker: str = "o") -> None:
    """A pose as a dot with a stroke the way it looks, and a circle of what counts as there."""
    from matplotlib.patches import Circle

    x, y = 1e3 * pose[:2]
    axes.plot(x, y, marker, ms=4 if marker == "o" else 6, color=colour)
    if math.isfinite(pose[2]):
        axes.plot([x, x + _STROKE * math.cos(pose[2])], [y, y + _STROKE * math.sin(pose[2])], color=colour, lw=1.5)
    if within:
        axes.add_patch(Circle((x, y), 1e3 * within, fill=False, ec=colour, lw=0.8))
    if name:
        axes.annotate(name, (x, y), (6, -12), textcoords="offset points", fontsize=8, color=colour,
                      bbox={"boxstyle": "round,pad=0.1", "fc": "white", "ec": "none", "alpha": 0.8})  # fmt: skip
