"""Picture of the study of freshness: what a rate knows, the scores of objects, and hits over false alarms."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.plots.style import BLUE, GREEN, GREY, ORANGE, RED, label_axes, new_figure
from plategait.study.questions.batches import batch_scores, learn_rule, operating_curve

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def draw(
    frequencies: Mapping[int, Sequence[float]], marks: Mapping[int, Array], chosen: tuple[int, Sequence[float]],
    rates: Sequence[Array], sizes: Sequence[int],
) -> Figure:  # fmt: skip
    """Changes of the rate by stiffness and friction; scores of the objects that were told; hits over false alarms.

    Parameters
    ----------
    frequencies : mapping
        Hz, by A_p in deg.
    marks : mapping of (2, n) arrays
        Relative change of the rate by stiffness and by friction, by A_p.
    chosen : (A_p, frequencies)
        Of the films.
    rates : sequence of (objects, films) arrays
        Fresh and aged to learn from; fresh, aged and rough to tell.
    sizes : sequence of int
        Objects of a batch.
    """
    figure = new_figure(11, 3.6)
    axes: list[Axes] = list(figure.subplots(1, 3))
    angle, films = chosen
    for (a, changes), marker in zip(marks.items(), "^os", strict=True):
        strong = {"alpha": 1.0 if a == angle else 0.4, "ms": 4, "lw": 1.4 if a == angle else 0.8}
        for change, line, colour, what in zip(changes, ("-", "--"), (BLUE, RED), ("stiffer", "rougher"), strict=True):
            axes[0].plot(frequencies[a], 100 * change, marker + line, color=colour, label=f"{what}, {a} deg", **strong)
    for f in films:
        axes[0].axvline(f, color=GREY, lw=0.7, ls=":")
    axes[0].axhline(0, color=GREY, lw=0.7)
    axes[0].set_title("20 % of stiffness, 2 deg of friction", fontsize=10)
    axes[0].legend(frameon=False, fontsize=7)
    label_axes(axes[0], "plate frequency, Hz", "change of the spin rate, %")
    rule = learn_rule(rates[0], rates[1])
    fresh, aged, rough = (rule.scores(some) for some in rates[2:])
    every = np.concatenate([fresh, aged, rough])
    bins = np.linspace(every.min(), every.max(), 19).tolist()
    for scores, colour, line, label in ((fresh, GREEN, "-", "fresh"), (aged, ORANGE, "-", "20 % stiffer"),
                                        (rough, RED, "--", "2 deg rougher")):  # fmt: skip
        axes[1].hist(scores, bins, histtype="step", color=colour, lw=1.4, label=label, ls=line)
    axes[1].axvline(0, color=GREY, lw=0.8)
    axes[1].set_title("three films of an object", fontsize=10)
    axes[1].legend(frameon=False, fontsize=8)
    label_axes(axes[1], "score", "objects")
    for size, colour in zip(sizes, (ORANGE, GREEN, BLUE), strict=True):
        means = (fresh, aged) if size == 1 else (batch_scores(fresh, size, 1), batch_scores(aged, size, 2))
        label = "one object" if size == 1 else f"{size} objects"
        axes[2].plot(*operating_curve(*means), color=colour, lw=1.6, label=label)
    axes[2].plot(*operating_curve(fresh, rough), color=RED, lw=1, ls="--", label="one, 2 deg rougher")
    axes[2].plot([0, 1], [0, 1], color=GREY, lw=0.7)
    axes[2].set_title("batches of so many objects", fontsize=10)
    axes[2].legend(frameon=False, fontsize=8, loc="lower right")
    label_axes(axes[2], "false alarms among fresh", "aged that are found")
    return figure
