"""How every picture looks: colours, markers, axes, and how a figure is written."""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING, Any

from matplotlib.figure import Figure

from plategait.files.output import PICTURES, check_writable, write_whole

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.typing import ColorType


# Okabe and Ito's colours, told apart by colour-blind readers and in grey.
BLUE, ORANGE, GREEN, RED, GREY = "#0072B2", "#E69F00", "#009E73", "#D55E00", "#7F7F7F"


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
    """Label both axes and leave out the frame they do not need."""
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    axes.spines[["top", "right"]].set_visible(False)


def mark(colour: ColorType, partly_failed: bool = False) -> dict[str, Any]:
    """How a point's mark is filled: white, or half of it in its colour where some of its runs failed."""
    if partly_failed:
        return {"mec": colour, "mfc": colour, "mfcalt": "white", "fillstyle": "left"}
    return {"mec": colour, "mfc": "white"}
