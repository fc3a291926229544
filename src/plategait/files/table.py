"""Tables coming in: CSV whose headings carry their units, from spreadsheets and instruments alike.

A heading is a name and a unit: `phi1_deg`, `force_N`, `time (ms)`, `spin rate [deg/s]`. Columns may stand in any
order, further ones are left alone, and any unit that measures the right thing is read. Comma, semicolon or tab part
the cells; a comma may be the decimal sign where a semicolon or tab parts them.
"""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from plategait.errors import InputError, printable
from plategait.files.input import LARGEST_TABLE, read_text
from plategait.units import parse

_HEADING = re.compile(r"(?P<name>.*?)\s*[\[(]\s*(?P<unit>[^\])]*?)\s*[\])]?\s*")
# As units are written in names, where there is no slash.
_SPOKEN = {"hz": "Hz", "n": "N", "mn": "mN", "degree": "deg", "degrees": "deg", "seconds": "s", "sec": "s"}

# More rows than a minute at 10 kHz, more columns than any instrument has; longer headings name no column.
MOST_ROWS, MOST_COLUMNS, LONGEST_HEADING = 1_000_000, 1_000, 100


@dataclass(frozen=True)
class Column:
    """One column to read.

    Parameters
    ----------
    unit : str
        SI unit that it measures, empty for plain numbers.
    wanted : str
        Unit to give it in; SI by default.
    required : bool
        Whether the table must have it.
    blank : bool
        Whether its cells may be empty, which gives NaN; those of a column not required always may.
    above, at_least : float
        Limits, in the unit wanted.
    """

    unit: str
    wanted: str = ""
    required: bool = True
    blank: bool = False
    above: float = -math.inf
    at_least: float = -math.inf

    @property
    def allowed(self) -> str:
        """What a cell may hold, as the end of "must be …"."""
        limits = f" above {self.above:g}" * (self.above > -math.inf)
        limits += f" of at least {self.at_least:g}" * (self.at_least > -math.inf)
        return f"a number{limits}" + ("" if self.required and not self.blank else ", or empty")


@dataclass(frozen=True, eq=False)
class Table:
    """What a file held: numbers by column, text by column, and the line that each row stood on."""

    path: Path
    numbers: Mapping[str, NDArray[np.float64]]
    text: Mapping[str, tuple[str, ...]]
    lines: NDArray[np.int64]

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
    text: Sequence[str] = (),
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
    text : sequence of str
        Columns of text to read as well, where there are any.
    field, example : str
        What an error calls the file, and a heading that works.
    least_rows : int
        Fewer are refused.
    rising : str
        Column that must rise from row to row, such as the time.

    Raises
    ------
    InputError
        When the file cannot be read, lacks a column, has one twice or in a wrong unit, has too few rows, or holds what
        is no number; names the line.
    """
    path = Path(path)
    rows, separator = read_rows(path, field, example)
    heading = [cell.strip() for cell in rows[0][1]] if rows else []
    named = [_named(cell, columns) for cell in heading]
    where = {name: _find(name, column, heading, named, path, field, example) for name, column in columns.items()}
    if len(rows) - 1 < least_rows:
        needed = f"at least {least_rows} row{'s' * (least_rows > 1)} below the headings"
        raise InputError(field, f"{len(rows[1:])} rows in {path.name}", needed, example)
    numbers = {
        name: _numbers(path.name, rows, place, factor, columns[name], separator)
        for name, (place, factor) in where.items()
        if place >= 0
    }
    words = {name: _words(rows, heading, name) for name in text}
    lines = np.array([line for line, _ in rows[1:]])
    if rising:
        late = np.flatnonzero(~(np.diff(numbers[rising]) > 0))
        if len(late):
            at = int(late[0]) + 1
            raise InputError(f"{path.name} line {lines[at]}, {rising}", float(numbers[rising][at]),
                             "above that of the row before it", "sorting the rows by it")  # fmt: skip
    return Table(path, numbers, words, lines)


def read_rows(path: Path | str, field: str, example: str) -> tuple[list[tuple[int, list[str]]], str]:
    """Rows of a CSV file that hold anything, each with the line it ends on, and what parts their cells.

    Raises
    ------
    InputError
        When the file cannot be read, or has too many rows or columns.
    """
    text = read_text(path, LARGEST_TABLE, field, "a CSV file that can be read", example)
    separator = _separator(text.partition("\n")[0])
    reader, rows = csv.reader(io.StringIO(text, newline=""), delimiter=separator), []
    try:
        for row in reader:
            if any(map(str.strip, row)):
                rows.append((reader.line_num, row))
            if len(rows) > MOST_ROWS or len(rows[0][1] if rows else ()) > MOST_COLUMNS:
                got = f"{path} (more than {MOST_ROWS} rows or {MOST_COLUMNS} columns)"
                raise InputError(field, got, "a smaller table", "leaving out what is not needed")
    except csv.Error:
        raise InputError(field, f"{path} (no table)", "a CSV file that can be read", example) from None
    return rows, separator


def _separator(first: str) -> str:
    """What parts the cells: the one of tab, semicolon and comma that the headings have."""
    return next((s for s in "\t;" if s in first), ",")


def _split(heading: str) -> list[tuple[str, str]]:
    """Ways in which a heading may be a name and a unit."""
    if len(heading) > LONGEST_HEADING:
        return []
    bracketed = _HEADING.fullmatch(heading)
    if bracketed:
        return [(_plain(bracketed["name"]), bracketed["unit"])]
    pieces = re.split(r"[\s\-._]+", heading.strip())
    return [(_plain("_".join(pieces[:i])), "_".join(pieces[i:])) for i in range(len(pieces), 0, -1)]


def _plain(name: str) -> str:
    return re.sub(r"[\s\-.]+", "_", name.strip().lower())


def _named(heading: str, columns: Mapping[str, Column]) -> tuple[str, str]:
    """Which column a heading is, and its unit; the longest name that fits, as `rate_sd` is no `rate`."""
    ways = [way for way in _split(heading) if way[0] in columns]
    return max(ways, key=lambda way: len(way[0]), default=("", ""))


def _find(
    name: str, column: Column, heading: list[str], named: list[tuple[str, str]], path: Path, field: str, example: str
) -> tuple[int, float]:
    """Place of a column and the factor to its wanted unit; place -1 where an optional one is missing."""
    places = [(i, unit) for i, (column_name, unit) in enumerate(named) if column_name == name]
    if len(places) == 1:
        place, unit = places[0]
        try:
            return place, _factor(unit, column)
        except ValueError:
            works = f"{name}_{(column.wanted or column.unit).replace('/', '_')}"
            allowed = f"{name} in a unit of {column.unit}" if column.unit else f"{name} without a unit"
            raise InputError(field, heading[place], allowed, works) from None
    if not column.required and not places:
        return -1, 1.0
    got = [heading[i] for i, _ in places]
    if not got and any(column_name for column_name, _ in named):
        got = [printable(cell, 40) for cell in heading[:12]]
    # What has none of the columns is some other file, whose first line is nobody's business.
    said = ", ".join(got) or (f"{len(heading)} of no known name" if heading else "none")
    raise InputError(field, f"columns {said} in {path.name}", f"a table with one column {name}", example)


def _factor(unit: str, column: Column) -> float:
    """Factor from the unit of a heading to the one wanted; a heading without unit is in the one wanted."""
    wanted = column.wanted or column.unit
    spelt = _SPOKEN.get(unit.lower(), unit)
    if "_" in spelt:
        over, _, under = spelt.partition("_")
        spelt = f"{over}/{under.removeprefix('per_')}"
    if spelt in ("", wanted):
        return 1.0
    return parse(f"1 {spelt}", column.unit) / (parse(f"1 {wanted}", column.unit) if wanted else 1.0)


def _numbers(
    file: str, rows: list[tuple[int, list[str]]], place: int, factor: float, column: Column, separator: str
) -> NDArray[np.float64]:
    """One column of numbers, in the unit wanted."""
    values, heading = np.empty(len(rows) - 1), rows[0][1][place].strip()
    for i, (line, row) in enumerate(rows[1:]):
        cell = row[place].strip() if place < len(row) else ""
        if not cell and (column.blank or not column.required):
            values[i] = math.nan
            continue
        try:
            value = float(cell.replace(",", ".") if separator != "," else cell) * factor
        except ValueError:
            value = math.nan
        if not (value > column.above and value >= column.at_least and value < math.inf):
            raise InputError(f"{file} line {line}, {heading}", cell or "nothing", column.allowed, "1.0")
        values[i] = value
    return values


def _words(rows: list[tuple[int, list[str]]], heading: list[str], name: str) -> tuple[str, ...]:
    """One column of text; empty where the file has none."""
    place = heading.index(name) if name in heading else -1
    return tuple(printable(row[place].strip(), 40) if 0 <= place < len(row) else "" for _, row in rows[1:])
