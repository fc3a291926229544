"""Picture of the study of identifiability, from plain arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.plots.style import BLUE, GREEN, GREY, ORANGE, RED, label_axes, new_figure
from plategait.study.questions.profiles import GRID, Profiles

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_LABELS = ("k_b/M", "c_b/M", "μ_s", "β")
_COLOURS = (BLUE, RED, GREEN, ORANGE)


def draw(bounds: Mapping[str, Array], steps: Sequence[Array], readings: Sequence[str], profiles: Profiles) -> Figure:
    """Bounds of what may be measured; bounds along the shortest list; profile likelihoods.

    Parameters
    ----------
    bounds : mapping of str to (4,) array
        Standard deviation of each logarithm, by what is measured.
    steps : sequence of (4,) array
        The same after each reading of the list.
    readings : sequence of str
        The list in words.
    profiles : Profiles
        Of the whole list.
    """
    figure = new_figure(12, 4.2)
    axes: list[Axes] = list(figure.subplots(1, 3))
    y = np.arange(len(bounds))
    for i, (label, colour) in enumerate(zip(_LABELS, _COLOURS, strict=True)):
        axes[0].plot([100 * b[i] for b in bounds.values()], y, "o", color=colour, label=label)
        axes[1].plot([100 * step[i] for step in steps], range(len(steps)), "o-", color=colour, lw=1)
        axes[2].plot(100 * GRID, profiles.values[i], color=colour, lw=1.4)
    axes[0].set_yticks(y, list(bounds), fontsize=8)
    axes[1].set_yticks(range(len(steps)), [f"+ {text}" for text in readings], fontsize=7)
    for axis in axes[:2]:
        axis.set_xscale("log")
        axis.set_xticks([3, 10, 30, 100], ["3", "10", "30", "100"])
        axis.set_xticks([], minor=True)
        axis.invert_yaxis()
        for wanted in (10, 20):
            axis.axvline(wanted, color=GREY, lw=0.8, ls=":")
        label_axes(axis, "left unknown, % (Cramér–Rao)", "")
    axes[0].legend(frameon=False, fontsize=8)
    axes[0].set_title("what may be measured, mass weighed", fontsize=10)
    axes[1].set_title("the shortest list", fontsize=10)
    axes[2].set_title("its profile likelihoods", fontsize=10)
    axes[2].axhline(1, color=GREY, lw=0.8, ls=":")
    axes[2].set_ylim(0, 9)
    label_axes(axes[2], "off the truth, %", "χ² over its least")
    return figure
