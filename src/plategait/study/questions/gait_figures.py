"""Pictures of the study of gaits, from plain arrays."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array, Flags
from plategait.plots.style import (
    BLUE,
    GREEN,
    GREY,
    MARKERS,
    RED,
    label_axes,
    legend_below,
    new_figure,
    plain_logarithms,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def collapse(
    found: tuple[Array, Array, Array], told: tuple[Array, Array, Array], softness: tuple[Array, Array, Array],
    disks: Flags,
) -> Figure:  # fmt: skip
    """Where sliding ends, running begins and the sheet runs off: over Γ alone, over Λ, and against the laws.

    Parameters
    ----------
    found, told : three (n,) arrays each
        Γ over the rigid limit, as found and by the laws.
    softness : three (n,) arrays
        Λ there.
    disks : (n,) bool array
        Others are drawn hollow.
    """
    figure = new_figure(10, 3.8)
    left, right = figure.subplots(1, 2, width_ratios=(3, 2))
    looks = (("sliding ends", *MARKERS["walking"]), ("running begins", *MARKERS["running"]), ("run-off", "x", GREY))
    for gamma, soft, (label, marker, colour) in zip(found, softness, looks, strict=True):
        for which, filled in ((disks, True), (~disks, False)):
            face = colour if filled and marker != "x" else "none"
            left.plot(soft[which], gamma[which], marker, ms=5, mec=colour if marker != "x" else GREY, mfc=face,
                      color=colour, label=label if filled else None)  # fmt: skip
    for gamma, soft, (_, _, colour) in zip(told, softness, looks, strict=True):
        order = np.argsort(soft)
        left.plot(soft[order], gamma[order], "-", lw=1, color=colour)
    left.set_xscale("log")
    plain_logarithms(left.xaxis)
    left.set_ylim(0.5, 4.5)
    label_axes(left, "softness Λ", "Γ over the rigid limit")
    left.legend(frameon=False, fontsize=8)
    for gamma, law, (label, marker, colour) in zip(found[:2], told[:2], looks[:2], strict=True):
        right.plot(law, gamma, marker, ms=5, color=colour, label=label)
    right.plot([0.9, 4], [0.9, 4], "-", lw=1, color=GREY)
    label_axes(right, "by the law", "found")
    return figure


def bodies(gammas: Array, numbers: Mapping[str, Mapping[tuple[str, float], Array]]) -> Figure:
    """What the soft disk, its rigid twin and the T on three arms do at the same Γ.

    Parameters
    ----------
    gammas : (Γ,) array
    numbers : mapping
        By what is drawn, then by body and A_p in deg: (Γ,) arrays.
    """
    figure = new_figure(11, 4.8)
    axes = figure.subplots(2, len(numbers), squeeze=False)
    angles = sorted({angle for by_body in numbers.values() for _, angle in by_body})
    for column, (title, by_body) in enumerate(numbers.items()):
        for row, angle in enumerate(angles):
            axis = axes[row, column]
            for (name, _), colour in zip([key for key in by_body if key[1] == angle], (BLUE, RED, GREEN), strict=False):
                axis.plot(gammas, by_body[name, angle], "o-", ms=3.5, lw=1.2, color=colour, label=name)
            label_axes(axis, "Γ" if row else "", "")
        axes[0, column].set_title(title, fontsize=9)
    for row, angle in enumerate(angles):
        axes[row, 0].set_ylabel(f"A_p = {angle:g} deg")
    legend_below(figure)
    return figure
