"""Outlines as they are typed: a shape with its sizes, corners in a CSV file, or a picture with its width."""

from __future__ import annotations

from plategait.cli.filmed import LENGTH, read_size
from plategait.errors import InputError
from plategait.files.headings import Column
from plategait.files.table import read_table
from plategait.model.outline import Disk, Ellipse, Mask, Outline, Polygon, Rectangle

_PICTURES = (".png", ".jpg", ".jpeg", ".bmp", ".gif", ".tif", ".tiff", ".webp")
_CORNERS = "a .csv with a row for each corner in order, whose first line names the columns: x_mm,y_mm"
_ALLOWED = "a shape with its size, a .csv of corners, or a picture with its width"


def read_outline(text: str, option: str = "--outline") -> Outline:
    """Outline of what was typed.

    Parameters
    ----------
    text : str
        "disk 40 mm" (its radius), "ellipse 90 mm x 50 mm", "rectangle 60 mm" (a square), "corners.csv" (a row for each
        corner in order, columns x_mm and y_mm or in another unit), "leaf.png 70 mm" (the width of the whole picture).

    Raises
    ------
    InputError
        For anything else, or a file that cannot be read.
    """
    words = text.strip()
    if words.lower().endswith(".csv"):
        return _corners(words, option)
    for suffix in _PICTURES:
        name, found, width = words.partition(f"{suffix} ")
        if found:
            return Mask(image=name + suffix, width_of_picture=_length(width, name + suffix, option))
    shape, _, size = words.partition(" ")
    if shape.lower() == "disk" and size:
        return Disk(radius=_length(size, "disk", option))
    kinds = {"ellipse": Ellipse, "rectangle": Rectangle}
    if shape.lower() not in kinds or not size:
        meant = {"circle": "disk", "disc": "disk", "square": "rectangle", "oval": "ellipse"}.get(shape.lower(), "")
        known = f'"{meant} {size}"' if meant and size else '"disk 40 mm", "rectangle 90 mm x 60 mm" or corners.csv'
        raise InputError(option, text, _ALLOWED, known)
    try:
        length, width = read_size(size, option)
    except InputError as error:
        raise InputError(option, error.got, error.allowed, _beside(shape, error.hint)) from None
    return kinds[shape.lower()](length=length, width=width)


def _corners(file: str, option: str) -> Polygon:
    """Polygon of a CSV file, in whose errors a corner is a line of it."""
    # In metres where no unit is told, which is refused: nobody means 37 m.
    columns = {"x": Column("m", "m"), "y": Column("m", "m")}
    try:
        table = read_table(file, columns, field=option, example="x_mm,y_mm", least_rows=3)
    except InputError as error:
        if not error.allowed.startswith("a table with one column"):
            raise
        raise InputError(option, error.got, _CORNERS, "x_mm,y_mm as the first line") from None
    if table.unitless:
        got = f"columns {','.join(table.unitless.values())} without a unit in {table.path.name}"
        raise InputError(option, got, _CORNERS, "x_mm,y_mm as the first line")
    try:
        return Polygon(corners=tuple(zip(table["x"].tolist(), table["y"].tolist(), strict=True)))
    except InputError as error:
        part, _, place = error.field.partition(".")
        corner, _, axis = place.partition(".")
        if part != "corners" or not corner.isdigit():
            raise
        name, row = "xy"[int(axis)], int(corner)
        where, got = f"{table.path.name} line {table.lines[row]}, {name}", f"{1e3 * table[name][row]:.10g} mm"
        hint = f"the unit of the numbers in the heading, such as {name}_mm"
        raise InputError(where, got, "from -10 m to 10 m", hint) from None


def _length(typed: str, beside: str, option: str) -> float:
    """Length typed behind a word, which stands before what to type instead too."""
    try:
        return LENGTH.read(typed.strip(), option)
    except InputError as error:
        raise InputError(option, error.got, error.allowed, _beside(beside, error.hint)) from None


def _beside(word: str, hint: str) -> str:
    return f'"{word} {hint.strip(chr(34))}"'
