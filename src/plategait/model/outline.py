"""Outlines that a sheet can be cut to, and the grid squares inside them."""

from __future__ import annotations

import io
import math
import warnings
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Annotated, Literal, get_args

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, field_validator, model_validator

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.files.input import LARGEST_PICTURE, read_bytes
from plategait.model.base import Model
from plategait.units import Length, Offset

# Of a picture; it is held once, at two bytes each while it is read.
MOST_PIXELS = 100_000_000
# Of the grid over a sheet: laying out a lattice of as many takes two seconds, a step of it milliseconds.
MOST_SQUARES = 250_000
MOST_CORNERS = 1000
# Those that Pillow reads by itself: some others start a program.
_FORMATS = ("PNG", "JPEG", "BMP", "GIF", "TIFF", "WEBP", "PPM")
_EDGE = 1e-9  # of a polygon's extent: what is nearer to an edge lies on it
_TRIANGLE = '[["0 mm", "0 mm"], ["60 mm", "0 mm"], ["0 mm", "60 mm"]]'
_ROWS = '[".##.", "####", ".##."]'


class Disk(Model):
    """A round sheet."""

    shape: Literal["disk"] = "disk"
    radius: Length = Field(description="radius")

    def size(self) -> tuple[float, float]:
        """Length along x and width along y, m."""
        return 2 * self.radius, 2 * self.radius

    def contains(self, x: Array, y: Array) -> NDArray[np.bool_]:
        """Whether points about the middle of the bounding box lie inside."""
        return np.hypot(x, y) <= self.radius


class Ellipse(Model):
    """An oval sheet."""

    shape: Literal["ellipse"] = "ellipse"
    length: Length = Field(description="full length along x (the bar)")
    width: Length = Field(description="full width along y")

    def size(self) -> tuple[float, float]:
        """Length along x and width along y, m."""
        return self.length, self.width

    def contains(self, x: Array, y: Array) -> NDArray[np.bool_]:
        """Whether points about the middle of the bounding box lie inside."""
        return np.hypot(2 * x / self.length, 2 * y / self.width) <= 1


class Rectangle(Model):
    """A rectangular sheet."""

    shape: Literal["rectangle"] = "rectangle"
    length: Length = Field(description="length along x (the bar)")
    width: Length = Field(description="width along y")

    def size(self) -> tuple[float, float]:
        """Length along x and width along y, m."""
        return self.length, self.width

    def contains(self, x: Array, y: Array) -> NDArray[np.bool_]:
        """Whether points about the middle of the bounding box lie inside."""
        return (np.abs(x) <= self.length / 2) & (np.abs(y) <= self.width / 2)


class Polygon(Model):
    """A sheet with straight edges, given by its corners in order."""

    shape: Literal["polygon"] = "polygon"
    corners: tuple[tuple[Offset, Offset], ...] = Field(description="corners (x, y) in order", examples=[_TRIANGLE])

    @model_validator(mode="after")
    def _at_least_a_triangle(self) -> Polygon:
        if len(self.corners) > MOST_CORNERS:
            raise InputError("corners", f"{len(self.corners)} corners", f"at most {MOST_CORNERS}",
                             "leaving out corners that are nearer to each other than the pitch")  # fmt: skip
        corners = np.array(self.corners).reshape(-1, 2)
        spread = corners - corners[:1]
        if len(corners) < 3 or np.linalg.matrix_rank(spread, tol=_EDGE * np.abs(spread).max()) < 2:
            got = f"{len(corners)} corners" + (" on one line" if len(corners) > 1 else "")
            raise InputError("corners", got, "3 or more corners that span an area", _TRIANGLE)
        return self

    def size(self) -> tuple[float, float]:
        """Length along x and width along y, m."""
        length, width = np.ptp(np.array(self.corners), axis=0)
        return float(length), float(width)

    def contains(self, x: Array, y: Array) -> NDArray[np.bool_]:
        """Whether points about the middle of the bounding box lie inside (even-odd rule).

        A point on an edge is inside where both sides of the edge are: all points a hair around it decide.
        """
        corners = np.array(self.corners)
        corners = corners - (corners.min(axis=0) + corners.max(axis=0)) / 2
        inside = np.ones(np.broadcast(x, y).shape, dtype=bool)
        for direction in (np.arange(8) + 0.5) * math.pi / 4:  # none along an edge that people draw
            near_x = x + _EDGE * max(self.size()) * math.cos(direction)
            near_y = y + _EDGE * max(self.size()) * math.sin(direction)
            odd = np.zeros_like(inside)
            for (x0, y0), (x1, y1) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
                if y0 != y1:
                    straddles = (y0 > near_y) != (y1 > near_y)
                    odd ^= straddles & (near_x < x0 + (near_y - y0) * (x1 - x0) / (y1 - y0))
            inside &= odd
        return inside


@dataclass(frozen=True, eq=False)
class _Picture:
    """(rows, columns) pixels that are sheet, top row first. No array itself, which pydantic could not compare."""

    dark: NDArray[np.bool_]


class Mask(Model):
    """A sheet cut to a picture: its dark (or, where there is transparency, opaque) pixels."""

    shape: Literal["mask"] = "mask"
    width_of_picture: Length = Field(description="what the width of the whole picture measures, along x")
    image: Path | None = Field(default=None, description="picture file", examples=['"leaf.png"'])
    rows: tuple[str, ...] = Field(
        default=(), description='or the picture as text, top row first: "#" is sheet', examples=[_ROWS]
    )

    @field_validator("image", mode="after")
    @classmethod
    def _from_anywhere(cls, image: Path | None) -> Path | None:
        return image and image.absolute()

    @model_validator(mode="after")
    def _has_a_sheet(self) -> Mask:
        if self.rows and self.image is not None:
            raise InputError("image", str(self.image), "left out where rows are given", "one of the two")
        if len({len(row) for row in self.rows}) > 1:
            raise InputError("rows", self.rows, "rows of equal length", _ROWS)
        if not self._picture.dark.any():
            raise InputError("image" if self.image else "rows", "nothing dark in the picture",
                             "a dark object on a light ground", f"rows = {_ROWS}")  # fmt: skip
        return self

    def pixels(self) -> NDArray[np.bool_]:
        """(columns, rows) pixels of the sheet, cropped to it; row 0 at the bottom."""
        dark = self._picture.dark
        columns, rows = np.nonzero(dark.any(axis=0))[0], np.nonzero(dark.any(axis=1))[0]
        return dark[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1][::-1].T

    @cached_property
    def _picture(self) -> _Picture:
        """The whole picture; a file is read once."""
        if self.rows:
            letters = np.array(self.rows, dtype=str)
            return _Picture(letters.view("U1").reshape(len(letters), -1) == "#")
        if self.image is None:
            raise InputError("image", "nothing", "a picture file, or rows of text", 'image = "leaf.png"')
        return _Picture(_dark_pixels(self.image))

    def _pixel_size(self) -> float:
        return self.width_of_picture / self._picture.dark.shape[1]

    def size(self) -> tuple[float, float]:
        """Length along x and width along y, m."""
        columns, rows = self.pixels().shape
        return columns * self._pixel_size(), rows * self._pixel_size()

    def contains(self, x: Array, y: Array) -> NDArray[np.bool_]:
        """Whether points about the middle of the bounding box lie inside."""
        pixels, (length, width) = self.pixels(), self.size()
        i = np.floor((x / length + 0.5) * pixels.shape[0]).astype(int)
        j = np.floor((y / width + 0.5) * pixels.shape[1]).astype(int)
        within = (i >= 0) & (i < pixels.shape[0]) & (j >= 0) & (j < pixels.shape[1])
        return within & pixels[i.clip(0, pixels.shape[0] - 1), j.clip(0, pixels.shape[1] - 1)]


def _dark_pixels(path: Path) -> NDArray[np.bool_]:
    """(rows, columns) opaque pixels of a picture, or its dark ones where it has no transparency."""
    from PIL import Image

    allowed, works = "a picture file that can be read", '"leaf.png"'
    content = io.BytesIO(read_bytes(path, LARGEST_PICTURE, "image", allowed, works))
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of large pictures: there is a limit of our own
            picture = Image.open(content, formats=_FORMATS)
        if picture.width * picture.height > MOST_PIXELS:
            allowed = f"a picture of at most {MOST_PIXELS / 1e6:.0f} million pixels"
            size = f"{picture.width} × {picture.height} pixels"
            raise InputError("image", f"{path} ({size})", allowed, "a smaller copy")
        gray = np.asarray(picture.convert("LA"))
    except InputError:
        raise
    except Exception:  # Pillow's own, and Python's for a spoilt file
        raise InputError("image", f"{path} (no picture)", allowed, works) from None
    opaque = gray[..., 1] > 127
    return opaque if not opaque.all() else gray[..., 0] < 128


Outline = Annotated[Disk | Ellipse | Rectangle | Polygon | Mask, Field(discriminator="shape")]
SHAPES: tuple[str, ...] = tuple(kind.model_fields["shape"].default for kind in get_args(get_args(Outline)[0]))
"""What outlines are called in files."""


def occupied_squares(outline: Outline, pitch: float) -> NDArray[np.bool_]:
    """Grid squares whose middle lies inside an outline.

    The grid is centred on the outline's bounding box; the dissertation's disk (radius 40 mm, pitch 10 mm) comes out as
    8 × 8 squares less three at each corner, rows of 4, 6, 8, 8, 8, 8, 6, 4.

    Raises
    ------
    InputError
        When no square lies inside, or the squares fall into pieces that only touch at corners or not at all.
    """
    columns, rows = (max(1, round(min(extent / pitch, 1e9))) for extent in outline.size())
    if columns * rows > MOST_SQUARES:
        raise InputError("pitch", f"{1e3 * pitch:g} mm", f"coarse enough for at most {MOST_SQUARES} squares",
                         f'"{1e3 * max(outline.size()) / 100:g} mm"')  # fmt: skip
    x = (np.arange(columns, dtype=np.float64) - (columns - 1) / 2) * pitch
    y = (np.arange(rows, dtype=np.float64) - (rows - 1) / 2) * pitch
    # A hair inwards, so that a middle on the very edge falls the same way on every side.
    inside = outline.contains(x[:, None] * (1 - 1e-12), y[None, :] * (1 - 1e-12))
    finer = f'"{1e3 * min(min(outline.size()) / 8, pitch / 2):.3g} mm"'
    if not inside.any():
        raise InputError(
            "pitch", f"{1e3 * pitch:g} mm", "fine enough for at least one grid square inside the outline", finer
        )
    pieces = _count_pieces(inside)
    if pieces > 1:
        whole = "corners in their order around it" if isinstance(outline, Polygon) else "a mask without gaps"
        raise InputError("outline", f"{pieces} separate pieces at a pitch of {1e3 * pitch:g} mm",
                         "one connected piece", f"{whole}, or a finer pitch such as {finer}")  # fmt: skip
    return inside


def _count_pieces(squares: NDArray[np.bool_]) -> int:
    """Pieces that hang together along edges, by flooding one after the other."""
    left, pieces = set(zip(*np.nonzero(squares), strict=True)), 0
    while left:
        pieces += 1
        front = [left.pop()]
        while front:
            i, j = front.pop()
            for neighbour in ((i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)):
                if neighbour in left:
                    left.remove(neighbour)
                    front.append(neighbour)
    return pieces
