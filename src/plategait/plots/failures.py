"""What failed, drawn apart from what was measured: in a band of its own under the axes, by what went wrong."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from plategait.arrays import Array
from plategait.plots.style import SMALL

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.typing import ColorType

# Marks of failures, all of them strokes: a mark with an inside is a rate.
MARKS = {"slipped": "x", "ran off": "x", "left the plate": "+", "turned over": "1", "folded": "2", "diverged": "3"}
_UNKNOWN = "4"
_DARK = "#404040"
_BAND = "#EFEFEF"
# Of one row of failures, and between them and the lowest of the axes: shares of the axes' height.
_ROW, _GAP = 0.055, 0.03
# Of a mark in it, points.
_SIZE = 8.0


@dataclass(frozen=True, eq=False)
class Failures:
    """Points of one curve that failed: where they lie along the axes, what went wrong at each, how the curve looks."""

    x: Array
    kind: Sequence[str]
    colour: ColorType = _DARK
    dash: Any = ""


def draw_failures(axes: Axes, rows: Sequence[Failures], scale: float = 1.0) -> None:
    """Draw failed points in a band under the axes, a row for each curve that has any. Called when all else is drawn.

    The axes end where they ended; the band lies below, so that no failure is taken for a rate of zero. `scale` makes
    its rows and marks smaller.
    """
    from matplotlib.patches import Rectangle

    rows = [row for row in rows if len(row.x)]
    if not rows:
        return
    low, high = axes.get_ylim()
    ticks = [tick for tick in axes.get_yticks() if low - 1e-9 * (high - low) <= tick <= high]
    row_height = scale * _ROW
    band = row_height * len(rows)
    axes.set_ylim(high - (high - low) / (1 - band - _GAP), high)
    axes.set_yticks(ticks)
    axes.spines["left"].set_bounds(low, high)
    axes.add_patch(Rectangle((0, 0), 1, band, transform=axes.transAxes, color=_BAND, lw=0, zorder=0))
    axes.text(-0.012, band / 2, "failed", transform=axes.transAxes, ha="right", va="center", fontsize=SMALL)
    for i, row in enumerate(reversed(rows)):
        kinds, height, within = np.array(row.kind, dtype=object), (i + 0.5) * row_height, axes.get_xaxis_transform()
        if row.dash:
            axes.plot([row.x.min(), row.x.max()], [height, height], color=row.colour, ls=row.dash, lw=0.8, alpha=0.7,
                      transform=within)  # fmt: skip
        for kind in dict.fromkeys(row.kind):
            x = row.x[kinds == kind]
            axes.plot(x, np.full(len(x), height), marker_of(kind), color=row.colour, ms=scale * _SIZE,
                      mew=0.19 * scale * _SIZE, transform=within, zorder=4, gid="failed")  # fmt: skip


def marker_of(kind: str) -> str:
    """Mark of a kind of failure."""
    return MARKS.get(kind, _UNKNOWN)


def failure_handles(kinds: Sequence[str]) -> list[Artist]:
    """Legend of the failures that there are."""
    from matplotlib.lines import Line2D

    names = {kind: kind if kind in MARKS else "failed" for kind in dict.fromkeys(kinds)}
    return [
        Line2D([], [], ls="", marker=marker_of(kind), color=_DARK, ms=_SIZE, mew=1.5, label=name)
        for kind, name in names.items()
    ]
