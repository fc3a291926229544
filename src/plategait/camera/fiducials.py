"""Printed marks: four ArUco markers at the corners of the plate, and two rectangles on the object."""

from __future__ import annotations

import io
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.files.output import check_writable, write_whole

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


DICTIONARY = "DICT_4X4_50"
_BLACK = (
    ("######", "#.#..#", "##.#.#", "###..#", "###.##", "######"),
    ("######", "######", "#....#", "#.##.#", "#.#.##", "######"),
    ("######", "###..#", "###..#", "###.##", "#..#.#", "######"),
    ("######", "#.##.#", "#.##.#", "##.###", "##..##", "######"),
)  # of that dictionary, markers 0 to 3
IDS = (0, 1, 2, 3)
MODULES = 6
"""Squares along the side of a marker, its black border included; a white margin of one square goes around it."""
CORNER_SIGNS = ((-1, 1), (1, 1), (1, -1), (-1, -1))
"""Where markers 0 to 3 lie, signs of x and y: clockwise seen from above, from the corner at -x and +y."""

CENTRE_MARKER = (0.012, 0.006)
"""Length along the radial line and width of the marker in the middle of the object, m."""
RIM_MARKER = (0.006, 0.006)
"""The same of the marker near its rim."""
RIM_PLACE = 0.8
"""Where the rim marker's middle lies: share of the way from the object's middle to its edge."""

_MM_PER_INCH = 25.4
_PAGES = ((210.0, 297.0), (297.0, 420.0), (420.0, 594.0), (594.0, 841.0))  # A4 to A1, mm
_WORDS = 10.0  # size of letters, points
_SHEET_MARGIN = 12.0  # what printers leave white, mm


@dataclass(frozen=True, eq=False)
class PlateTarget:
    """Where the corner markers lie on a plate.

    Parameters
    ----------
    size : (float, float)
        Of the plate along the bar (x) and across it (y), m.
    marker : float
        Side of a marker's black square, m.
    corners : (4, 4, 2) array
        Of each marker in the order of `IDS`: top left, top right, bottom right, bottom left of the marker as printed
        with y upwards, as a detector gives them. Plate coordinates, m: x along the bar, y across, origin in the middle.
    """

    size: tuple[float, float]
    marker: float
    corners: Array


def plate_target(size_x: float, size_y: float, marker: float = 0.02) -> PlateTarget:
    """Lay the four markers out: each a white margin away from the edges at its corner.

    Parameters
    ----------
    size_x, size_y : float
        Plate along and across the bar, m.
    marker : float
        Side of a marker, m.

    Raises
    ------
    InputError
        When a size is no length, or four markers do not fit.
    """
    for name, value in (("plate", size_x), ("plate", size_y), ("marker", marker)):
        if not 1e-3 <= value <= 10:
            raise InputError(name, f"{1e3 * value:g} mm", "a length from 1 mm to 10 m", "100 mm")
    margin = marker / MODULES
    if 2 * (marker + 2 * margin) > min(size_x, size_y):
        fits = 1e3 * min(size_x, size_y) / 2 / (1 + 2 / MODULES)
        raise InputError("marker", f"{1e3 * marker:g} mm", f"at most {fits:.3g} mm on this plate", f"{fits / 2:.2g} mm")
    signs = np.array(CORNER_SIGNS, dtype=float)
    middles = signs * (np.array([size_x, size_y]) / 2 - margin - marker / 2)
    around = np.array([[-1, 1], [1, 1], [1, -1], [-1, -1]]) * marker / 2
    return PlateTarget((size_x, size_y), marker, middles[:, None] + around)


def marker_modules(number: int) -> NDArray[np.bool_]:
    """(6, 6) squares of a marker of `IDS`, True where black, top row first."""
    return np.array([[square == "#" for square in row] for row in _BLACK[number]])


def write_target_pdf(target: PlateTarget, path: Path | str) -> Path:
    """Draw a plate's markers, and the object's two, at true scale: a PDF of two pages, with a ruler to check by.

    The plate's sheet goes on the smallest page from A4 to A1 that it fits; it is cut along its outline and glued on.

    Raises
    ------
    InputError
        When the plate fits no page, or the file cannot be written.
    """
    from matplotlib.backends.backend_pdf import PdfPages

    check_writable(path, (".pdf",))
    content = io.BytesIO()
    with PdfPages(content, metadata={"Title": "plategait target"}) as pdf:
        pdf.savefig(_plate_page(target))
        pdf.savefig(_object_page())
    write_whole(content.getbuffer(), path, (".pdf",))
    return Path(path)


def _page(width: float, height: float) -> tuple[Figure, float, float]:
    """Blank page that takes a drawing of this size (mm), and the page's size."""
    from matplotlib.figure import Figure

    for short, long in _PAGES:
        for w, h in ((short, long), (long, short)):
            if width <= w - 2 * _SHEET_MARGIN and height <= h - 2 * _SHEET_MARGIN:
                return Figure(figsize=(w / _MM_PER_INCH, h / _MM_PER_INCH)), w, h
    most = [p - 2 * _SHEET_MARGIN - extra for p, extra in zip(_PAGES[-1], (0, 50), strict=True)]
    raise InputError("plate", f"{width:g} x {height:g} mm with its ruler",
                     f"at most {most[0]:g} x {most[1]:g} mm, which fits A1", "100 mm x 100 mm")  # fmt: skip


def _drawing(figure: Figure, width: float, height: float) -> Axes:
    """Axes over the whole page in mm, origin in the middle: nothing is fitted, so that the scale is true."""
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set_xlim(-width / 2, width / 2)
    axes.set_ylim(-height / 2, height / 2)
    axes.axis("off")
    return axes


def _plate_page(target: PlateTarget) -> Figure:
    from matplotlib.patches import Rectangle

    size_x, size_y = 1e3 * target.size[0], 1e3 * target.size[1]
    figure, width, height = _page(max(size_x, 125.0), size_y + 50)
    axes = _drawing(figure, width, height)
    axes.add_patch(Rectangle((-size_x / 2, -size_y / 2), size_x, size_y, fill=False, lw=0.3, ec="0.5"))
    module = 1e3 * target.marker / MODULES
    for number, corners in zip(IDS, 1e3 * target.corners, strict=True):
        left, top = corners[0]
        for row, column in np.argwhere(marker_modules(number)):
            # A hair wider, so that no viewer shows white lines between neighbours.
            place = (left + column * module, top - (row + 1) * module)
            axes.add_patch(Rectangle(place, module + 0.01, module + 0.01, color="black", lw=0))
    for dx, dy in ((3, 0), (0, 3)):
        axes.plot([-dx, dx], [-dy, dy], color="0.6", lw=0.3)
    length = 10 * int(min(size_x, 100.0) // 10) if size_x >= 20 else 10
    _ruler(axes, -size_x / 2, -size_y / 2 - 8, length)
    right = max(size_x, 80.0) / 2
    axes.annotate("", (right, -size_y / 2 - 17), (right - 15, -size_y / 2 - 17), arrowprops={"arrowstyle": "->"})
    axes.text(right - 17, -size_y / 2 - 17, "$x$, away from the bar's root", ha="right", va="center", fontsize=_WORDS)
    words = (
        f"plate {size_x:g} mm × {size_y:g} mm, markers {1e3 * target.marker:.4g} mm",
        "Print at 100 %, check by the ruler, cut along the outline, glue on.",
    )
    for line, text in enumerate(words):
        axes.text(0, size_y / 2 + 9 - 5 * line, text, ha="center", va="bottom", fontsize=_WORDS)
    return figure


def _object_page() -> Figure:
    from matplotlib.patches import Rectangle

    figure, width, height = _page(150, 100)
    axes = _drawing(figure, width, height)
    for row in range(4):
        for column in range(3):
            x, y = -45 + 40 * column, 30 - 15 * row
            for (length, across), shift in ((CENTRE_MARKER, 0.0), (RIM_MARKER, 15.0)):
                size = 1e3 * length, 1e3 * across
                axes.add_patch(Rectangle((x + shift, y), *size, facecolor="#12408c", lw=0))
    _ruler(axes, -45, -30, 100)
    words = (
        "Cut out one long and one square marker. Glue the long one on the middle of the",
        "object, pointing outwards, and the square one on the same radial line near the rim.",
    )
    for k, line in enumerate(words):
        axes.text(0, 50 - 5 * k, line, ha="center", fontsize=_WORDS)
    return figure


def _ruler(axes: Axes, x: float, y: float, length: int) -> None:
    """Draw a ruler with a tick each mm."""
    axes.plot([x, x + length], [y, y], color="black", lw=0.4)
    for k in range(length + 1):
        axes.plot([x + k, x + k], [y, y + (3 if k % 10 == 0 else 2 if k % 5 == 0 else 1)], color="black", lw=0.35)
    for k in range(0, length + 1, 10 if length <= 50 else 50):
        axes.text(x + k, y - 1, f"{k} mm" if k == length else f"{k}", ha="center", va="top", fontsize=_WORDS - 1)
