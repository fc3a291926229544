"""The picture of an atlas: which velocities an object reaches, how certain they are, and the primitives among them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.moves.atlas import Atlas
from plategait.moves.report import PEOPLES
from plategait.plots.style import BLUE, GREEN, GREY, ORANGE, RED, label_axes, new_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_LABELS = ("along the bar (mm/s)", "across it (mm/s)", "turning (deg/s)")
# Where the names of primitives stand that lie near to each other, points.
_ASIDE = {"turn left": (8, 14), "turn right": (8, -20), "hold": (-30, -14), "back": (-6, 10)}
_COLOURS = (BLUE, ORANGE, GREEN, RED, GREY)


def plot_atlas(atlas: Atlas, beside: Sequence[tuple[str, Array]] = ()) -> Figure:
    """Map of the velocities with the turning as colour, turning over the way along, and what is reached in all.

    Parameters
    ----------
    atlas : Atlas
    beside : sequence of (machine, velocities)
        Other atlases whose reachable sets are drawn beside this one's, mm/s and deg/s.
    """
    figure = new_figure(12.0, 4.2)
    left, middle, right = figure.subplots(1, 3, width_ratios=(1.25, 1, 1))
    twists = atlas.twists * PEOPLES
    _draw_map(left, figure, atlas, twists)
    _draw_turning(middle, atlas, twists)
    _draw_reached(right, [(atlas.machine.name, twists), *beside])
    figure.suptitle(
        f"{atlas.scenario.name} on {atlas.machine.name}: {len(twists)} velocities, each with a motion, "
        f"from {atlas.runs} runs", fontsize=10,
    )  # fmt: skip
    return figure


def _draw_map(axes: Axes, figure: Figure, atlas: Atlas, twists: Array) -> None:
    order = np.argsort(np.abs(twists[:, 2]))[::-1]
    most = max(np.abs(twists[:, 2]).max(), 1.0)
    marks = axes.scatter(*twists[order, :2].T, c=twists[order, 2], cmap="coolwarm", vmin=-most, vmax=most, s=26,
                         edgecolors="black", linewidths=0.3)  # fmt: skip
    figure.colorbar(marks, ax=axes, label=_LABELS[2])
    for primitive in atlas.primitives:
        along, across, _ = primitive.trial.twist * PEOPLES
        axes.plot(along, across, "*", ms=12, mfc="white", mec="black")
        aside = _ASIDE.get(primitive.name, (6, 7))
        axes.annotate(primitive.name, (along, across), aside, textcoords="offset points", fontsize=8)
    label_axes(axes, _LABELS[0], _LABELS[1])
    axes.set_title("velocities, and the primitives (stars)", fontsize=9)


def _draw_turning(axes: Axes, atlas: Atlas, twists: Array) -> None:
    """Turning over the way along, with the 90 % region of each."""
    from matplotlib.patches import Ellipse

    for trial, twist in zip(atlas.cells.values(), twists, strict=True):
        covariance = atlas.covariance(trial) * np.outer(PEOPLES, PEOPLES)
        values, vectors = np.linalg.eigh(covariance[np.ix_((0, 2), (0, 2))])
        # 90 % of a plane normal distribution: −2 ln 0.1.
        width, height = 2 * np.sqrt(4.605 * np.maximum(values, 0.0))
        angle = math.degrees(math.atan2(vectors[1, 0], vectors[0, 0]))
        axes.add_patch(Ellipse((twist[0], twist[2]), width, height, angle=angle, fc=BLUE, alpha=0.25, lw=0))
    axes.plot(twists[:, 0], twists[:, 2], ".", color=BLUE, ms=3)
    label_axes(axes, _LABELS[0], _LABELS[2])
    axes.set_title("where 90 % of fresh runs lie", fontsize=9)


def _draw_reached(axes: Axes, atlases: Sequence[tuple[str, Array]]) -> None:
    """Outlines of what is reached along and across, whatever the turning."""
    for (machine, twists), colour in zip(atlases, _COLOURS, strict=False):
        outline = _hull(twists[:, :2])
        turns = f"{twists[:, 2].min():.0f} to {twists[:, 2].max():.0f} deg/s"
        axes.fill(*outline.T, color=colour, alpha=0.15, lw=0)
        axes.plot(*np.vstack([outline, outline[:1]]).T, color=colour, lw=1.2, label=f"{machine}, {turns}")
    label_axes(axes, _LABELS[0], _LABELS[1])
    axes.legend(frameon=False, fontsize=7.5)
    axes.set_title("what is reached", fontsize=9)


def _hull(points: Array) -> Array:
    """Corners of the convex hull of points in a plane; the points themselves where they span none."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        return points[ConvexHull(points).vertices]
    except (QhullError, ValueError):
        return points
