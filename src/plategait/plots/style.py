"""How every picture looks: colours, markers, axes, and how a figure is written."""

from __future__ import annotations

import io
import math
import re
import textwrap
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from matplotlib.figure import Figure
from matplotlib.ticker import AutoLocator, FuncFormatter, LogLocator, MaxNLocator, NullFormatter

from plategait.files.output import PICTURES, check_writable, write_whole

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.typing import ColorType


# Okabe and Ito's colours, told apart by colour-blind readers and in grey.
BLUE, ORANGE, GREEN, RED, GREY = "#0072B2", "#E69F00", "#009E73", "#D55E00", "#7F7F7F"
SKY, PURPLE = "#56B4E9", "#CC79A7"

# Curves of one picture: each has a colour and a dash of its own, so that none is told by its colour alone.
LINES: tuple[tuple[str, Any], ...] = (
    (BLUE, "-"), (ORANGE, "--"), (GREEN, "-."), (RED, ":"), (SKY, (0, (8, 2))), (PURPLE, (0, (3, 1, 1, 1, 1, 1))),
)  # fmt: skip
# Names, and what is said beside them, points.
_NAME, SMALL = 11.0, 8.5


# As in Figs. 4.4 and 4.7.
MARKERS = {"sliding": ("s", BLUE), "walking": ("^", GREEN), "running": ("o", RED), "": ("D", GREY)}


PARTLY_FAILED = "half-filled: some of the runs failed"


def save(figure: Figure, path: Path | str) -> None:
    """Write a figure by its suffix (.png, .pdf, .svg), whole or not at all.

    Raises
    ------
    InputError
        When the file cannot be written or has another suffix.
    """
    # Matplotlib's PDFs do not bear a full disk.
    content, kind = io.BytesIO(), check_writable(path, PICTURES, "plot").suffix.lower()
    figure.savefig(content, dpi=160, format=kind.removeprefix("."))
    write_whole(content.getbuffer(), path, PICTURES, "plot")


class ShownFigure(Figure):
    """A figure that a notebook shows by itself, whether or not anybody there has imported pyplot."""

    def _repr_png_(self) -> bytes:
        """The picture, as a notebook asks for it."""
        picture = io.BytesIO()
        self.savefig(picture, format="png", dpi=100)
        return picture.getvalue()


def new_figure(width: float, height: float) -> Figure:
    """Empty figure of a size in inches."""
    return ShownFigure(figsize=(width, height), layout="constrained")


def label_axes(axes: Axes, x: str, y: str) -> None:
    """Label both axes, count them in ones, twos and fives, and leave out the frame they do not need."""
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    axes.spines[["top", "right"]].set_visible(False)
    for axis in (axes.xaxis, axes.yaxis):
        if isinstance(axis.get_major_locator(), AutoLocator):
            axis.set_major_locator(MaxNLocator(nbins="auto", steps=[1, 2, 5, 10]))


def plain_logarithms(axis: Axis) -> None:
    """Number a logarithmic axis 0.1, 1, 10 and not by powers, over few decades also the twos and fives."""
    low, high = axis.get_view_interval()
    axis.set_major_locator(LogLocator(subs=(1, 2, 5) if high < 300 * low else (1,)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())


def head(axes: Axes, name: str, details: Sequence[str] = ()) -> None:
    """Write the name of a picture over it, and over its axes in smaller letters what was held fixed and found.

    Parameters
    ----------
    name : str
        As it stands: a dollar sign in it is one.
    details : sequence of str
        Lines in Matplotlib's mathtext; see `plain_text`.
    """
    figure = axes.figure
    broad = int(11 * figure.bbox.width / figure.dpi)  # letters in a line, about
    title = "\n".join(textwrap.wrap(name, broad, max_lines=2, placeholder=" …"))
    figure.suptitle(title, x=0.01, ha="left", fontsize=_NAME, parse_math=False)
    axes.set_title("\n".join(details), loc="left", fontsize=SMALL, linespacing=1.35)


def plain_text(words: str) -> str:
    """Words as they stand, for where mathtext is read."""
    return words.replace("$", r"\$")


def legend_below(figure: Figure, handles: Sequence[Artist] | None = None, columns: int = 4) -> None:
    """One legend for a whole figure, under its panels, where it covers nothing: of all their labels, each once."""
    if handles is None:
        of_labels: dict[str, Artist] = {}
        for axes in figure.axes:
            for handle, label in zip(*axes.get_legend_handles_labels(), strict=True):
                of_labels.setdefault(label, handle)
        handles = list(of_labels.values())
    if handles:
        labels = [str(handle.get_label()) for handle in handles]
        room = 72 * figure.get_figwidth()
        while columns > 1 and _legend_width(labels, columns) > room:
            columns -= 1
        figure.legend(handles, labels, loc="outside lower center", ncols=min(columns, len(handles)), frameon=False,
                      fontsize=SMALL)  # fmt: skip


def _legend_width(labels: Sequence[str], columns: int) -> float:
    """About how wide a legend is, points: of each column its longest label, with what Matplotlib puts around it."""
    rows = math.ceil(len(labels) / columns)
    longest = [max(map(_letters, labels[i : i + rows])) for i in range(0, len(labels), rows)]
    return sum(SMALL * (0.6 * letters + 4.8) for letters in longest)


def _letters(label: str) -> int:
    """Letters of a label as it is printed, a symbol of mathtext for one."""
    return len(re.sub(r"[$_^{}]", "", re.sub(r"\\[a-zA-Z,]+", "x", label)))


def legend_beside(axes: Axes, **options: Any) -> None:
    """The legend of one panel at its right, where it covers nothing."""
    if axes.get_legend_handles_labels()[0]:
        axes.legend(
            **{"frameon": False, "fontsize": SMALL, "loc": "upper left", "bbox_to_anchor": (1.0, 1.0)} | options
        )


def mark(colour: ColorType, partly_failed: bool = False) -> dict[str, Any]:
    """How a point's mark is filled: white, or half of it in its colour where some of its runs failed."""
    if partly_failed:
        return {"mec": colour, "mfc": colour, "mfcalt": "white", "fillstyle": "left"}
    return {"mec": colour, "mfc": "white"}
