"""The picture of an atlas: which velocities an object reaches, how certain they are, and the primitives among them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.moves.atlas import Atlas
from plategait.moves.report import PEOPLES
from plategait.plots.style import BLUE, LINES, label_axes, legend_below, new_figure, plain_text

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_LABELS = ("along the bar (mm/s)", "across it (mm/s)", "turning (deg/s)")
# Primitives nearer to each other than this share of a panel have one mark together.
_NEAR = 0.045


def plot_atlas(atlas: Atlas, beside: Sequence[tuple[str, Array]] = ()) -> Figure:
    """Map of the velocities with the turning as colour, turning over the way along, and what is reached in all.

    Parameters
    ----------
    atlas : Atlas
    beside : sequence of (machine, velocities)
        Other atlases whose reachable sets are drawn beside this one's, mm/s and deg/s.
    """
    figure = new_figure(12.0, 5.0)
    left, middle, right = figure.subplots(1, 3, width_ratios=(1.25, 1, 1))
    twists = atlas.twists * PEOPLES
    _draw_map(left, figure, atlas, twists)
    _draw_turning(middle, atlas, twists)
    _draw_reached(right, [(atlas.machine.name, twists), *beside])
    for axes, columns in ((left, (0, 1)), (middle, (0, 2))):
        _number_primitives(axes, atlas, columns)
    legend_below(figure, columns=3)
    names = "   ".join(f"{i} {primitive.name}" for i, primitive in enumerate(atlas.primitives, start=1))
    figure.suptitle(
        plain_text(
            f"{atlas.scenario.name} on {atlas.machine.name}: {len(twists)} velocities, each with a motion, from "
            f"{atlas.runs} runs\nPrimitives: {names or 'none'}"
        ),
        fontsize=10, x=0.01, ha="left",
    )  # fmt: skip
    return figure


def _number_primitives(axes: Axes, atlas: Atlas, columns: tuple[int, int]) -> None:
    """Numbers where primitives lie, those together that lie together."""
    low, high = np.array([axes.get_xlim(), axes.get_ylim()]).T
    groups: list[tuple[Array, list[str]]] = []
    for number, primitive in enumerate(atlas.primitives, start=1):
        place = (primitive.trial.twist * PEOPLES)[list(columns)]
        near = [names for at, names in groups if (np.abs((at - place) / (high - low)) < _NEAR).all()]
        near[0].append(str(number)) if near else groups.append((place, [str(number)]))
    for place, names in groups:
        axes.text(place[0], place[1], " ".join(names), ha="center", va="center", fontsize=8, zorder=5, gid="primitives",
                  bbox={"boxstyle": "round,pad=0.25", "fc": "white", "ec": "black", "lw": 0.8})  # fmt: skip


def _draw_map(axes: Axes, figure: Figure, atlas: Atlas, twists: Array) -> None:
    order = np.argsort(np.abs(twists[:, 2]))[::-1]
    most = max(np.abs(twists[:, 2]).max(), 1.0)
    marks = axes.scatter(*twists[order, :2].T, c=twists[order, 2], cmap="coolwarm", vmin=-most, vmax=most, s=26,
                         edgecolors="black", linewidths=0.3)  # fmt: skip
    figure.colorbar(marks, ax=axes, label=_LABELS[2])
    label_axes(axes, _LABELS[0], _LABELS[1])
    axes.set_title("velocities, and the primitives among them", loc="left", fontsize=9)


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
    axes.set_title("where 90 % of fresh runs lie", loc="left", fontsize=9)


def _draw_reached(axes: Axes, atlases: Sequence[tuple[str, Array]]) -> None:
    """Outlines of what is reached along and across, whatever the turning."""
    for (machine, twists), (colour, dash) in zip(atlases, LINES, strict=False):
        outline = _hull(twists[:, :2])
        turns = f"turning at {twists[:, 2].min():.0f} to {twists[:, 2].max():.0f} deg/s".replace("-", "−")
        axes.fill(*outline.T, color=colour, alpha=0.15, lw=0)
        axes.plot(*np.vstack([outline, outline[:1]]).T, color=colour, ls=dash, lw=1.4,
                  label=f"{plain_text(machine)}, {turns}")  # fmt: skip
    label_axes(axes, _LABELS[0], _LABELS[1])
    axes.set_title("what is reached", loc="left", fontsize=9)


def _hull(points: Array) -> Array:
    """Corners of the convex hull of points in a plane; the points themselves where they span none."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        return points[ConvexHull(points).vertices]
    except (QhullError, ValueError):
        return points
