"""Tables coming in: CSV whose headings carry their units, from spreadsheets and instruments alike.

Columns may stand in any order, further ones are left alone, and any unit that measures the right thing is read; see
`plategait.files.headings` and, for the rows, `plategait.files.rows`. A comma may be the decimal sign where a semicolon
or tab parts the cells.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from plategait.errors import InputError, check_kind, printable
from plategait.files.headings import Column, find_columns
from plategait.files.rows import Row, read_rows

# Cells of numbers that nobody measured.
_MISSING = {"", "nan", "na", "n/a", "none", "null", "-", "--", "–", "—", "#n/a", "#nv"}
# "1,200" and "1.200" are 1200 to some and 1.2 to others.
_THOUSANDS = re.compile(r"[-+]?[1-9]\d{0,2}[.,]\d{3}")
_HUNDREDS = re.compile(r"[-+]?[1-9]\d{2,}")


@dataclass(frozen=True, eq=False)
class Table:
    """What a file held: numbers by column, text by column, and the line that each row stood on.

    Attributes
    ----------
    unread : mapping of str to tuple of str
        Cells of the columns that nobody asked for, by heading; those without a heading or without a cell left out.
    unitless : mapping of str to str
        Headings of columns taken in the unit wanted for want of one, though that is not SI's, by column.
    """

    path: Path
    numbers: Mapping[str, NDArray[np.float64]]
    text: Mapping[str, tuple[str, ...]]
    lines: NDArray[np.int64]
    unread: Mapping[str, tuple[str, ...]]
    unitless: Mapping[str, str]

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        """One column of numbers."""
        return self.numbers[name]

    def get(self, name: str, default: NDArray[np.float64]) -> NDArray[np.float64]:
        """One column of numbers, or a default where the file has none."""
        return self.numbers.get(name, default)

    def __contains__(self, name: str) -> bool:
        """Whether the file had this column of numbers."""
        return name in self.numbers

    def __len__(self) -> int:
        """Rows."""
        return len(self.lines)


def read_table(
    path: Path | str,
    columns: Mapping[str, Column],
    *,
    text: Mapping[str, Sequence[str]] | None = None,
    field: str,
    example: str,
    least_rows: int = 1,
    rising: str = "",
) -> Table:
    """Read the columns asked for from a CSV file.

    Parameters
    ----------
    columns : mapping of str to Column
        By name without unit.
    text : mapping of str to sequence of str
        Columns of text to read as well, where there are any, with the other names of each.
    field, example : str
        What an error calls the file, and a heading that works.
    least_rows : int
        Fewer are refused.
    rising : str
        Column that must rise from row to row, such as the time.

    Raises
    ------
    InputError
        When the file cannot be read, lacks a column, has one twice or in a wrong unit, has too few rows, more cells
        than headings, or holds what is no number; names the line.
    """
    check_kind(path, (str, Path), field, '"table.csv"')
    path = Path(path)
    rows, separator = read_rows(path, field, example)
    heading = rows[0][1] if rows else []
    found = find_columns(heading, columns, text or {}, file=path.name, field=field, example=example)
    if len(rows) - 1 < least_rows:
        needed = f"at least {least_rows} row{'s' * (least_rows > 1)} below the headings"
        raise InputError(field, f"{len(rows[1:])} rows in {path.name}", needed, example)
    _check_width(path.name, rows)
    if separator != ",":
        _check_decimal_sign(path.name, rows, [place for place, _ in found.numbers.values()])
    numbers = {
        name: _numbers(path.name, rows, place, factor, columns[name], separator)
        for name, (place, factor) in found.numbers.items()
    }
    words = {name: tuple(printable(cell, 40) for cell in _cells(rows, i)) for name, i in found.text.items()}
    further = [i for i, name in enumerate(heading) if name and i not in found.read]
    unread = {printable(heading[i], 40): cells for i in further if any(cells := tuple(_cells(rows, i)))}
    lines = np.array([line for line, _ in rows[1:]])
    if rising:
        late = np.flatnonzero(~(np.diff(numbers[rising]) > 0))
        if len(late):
            at = int(late[0]) + 1
            raise InputError(f"{path.name} line {lines[at]}, {rising}", float(numbers[rising][at]),
                             "above that of the row before it", "sorting the rows by it")  # fmt: skip
    return Table(path, numbers, words, lines, unread, found.unitless)


def _cells(rows: list[Row], place: int) -> list[str]:
    """One column below its heading; rows may end before it."""
    return [row[place] if place < len(row) else "" for _, row in rows[1:]]


def _check_width(file: str, rows: list[Row]) -> None:
    """Refuse cells beyond the last heading: a decimal comma among commas makes two cells of one."""
    width = max((i + 1 for i, name in enumerate(rows[0][1]) if name), default=0)
    for line, row in rows[1:]:
        if any(row[width:]):
            got, allowed = f"{len(row)} cells under {width} headings", "one cell for each heading"
            raise InputError(f"{file} line {line}", got, allowed, "a decimal point, or semicolons between the cells")


def _check_decimal_sign(file: str, rows: list[Row], places: Sequence[int]) -> None:
    """Refuse numbers whose comma or point may part thousands, where either may be the decimal sign."""
    allowed = "a number without a sign between thousands, and with the decimal sign of all others"
    first = ""
    for place in places:
        cells = _cells(rows, place)
        signed = [cell for cell in cells if "," in cell or "." in cell]
        doubtful = all(map(_THOUSANDS.fullmatch, signed)) and any(map(_HUNDREDS.fullmatch, cells))
        for (line, _), cell in zip(rows[1:], cells, strict=True):
            signs = {c for c in cell if c in ",."}
            first = first or "".join(signs)
            if signs and (doubtful or signs != {first}):
                raise InputError(f"{file} line {line}, {rows[0][1][place]}", cell, allowed, "1200 or 1,2, as is meant")


def _numbers(
    file: str, rows: list[Row], place: int, factor: float, column: Column, separator: str
) -> NDArray[np.float64]:
    """One column of numbers, in the unit wanted."""
    values = np.empty(len(rows) - 1)
    for i, cell in enumerate(_cells(rows, place)):
        if column.may_be_blank and cell.lower() in _MISSING:
            values[i] = math.nan
            continue
        try:
            # Word processors and web pages write a true minus.
            number = cell.replace("\N{MINUS SIGN}", "-")
            value = float(number.replace(",", ".") if separator != "," else number) * factor
        except ValueError:
            value = math.nan
        if not (value > column.above and value >= column.at_least and value < math.inf):
            heading = rows[0][1][place]
            hint = _instead(cell, column, heading)
            raise InputError(f"{file} line {rows[i + 1][0]}, {heading}", cell or "nothing", column.allowed, hint)
        values[i] = value
    return values


def _instead(cell: str, column: Column, heading: str) -> str:
    """What to write for a cell that is no number of its column."""
    if cell and not any(c.isdigit() for c in cell) and column.fits(cell.strip("[]() ")):
        return f"the unit in the heading: {heading} [{cell.strip('[]() ')}]"
    meant = cell.replace(",", "" if _THOUSANDS.fullmatch(cell) else ".")
    try:
        number = float(meant)
    except ValueError:
        return "1.0"
    if number == 0 and not column.required:
        return "an empty cell where it is not known"
    return meant if meant != cell and column.above < number < math.inf and number >= column.at_least else "1.0"
