"""Headings of tables: which column each one names, and in which unit.

A heading is a name and a unit: `phi1_deg`, `force_N`, `time (ms)`, `spin rate [deg/s]`, `f / Hz`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from plategait.errors import InputError, printable
from plategait.units import parse

# Longer headings name no column.
LONGEST_HEADING = 100

# Of turning, as data sheets and spreadsheets write it; 1/s may count turns or radians.
_PER_MINUTE = re.compile(r"1\s*/\s*min|min\s*(?:\^?[-_]1|⁻¹)", re.IGNORECASE)
_BRACKETED = re.compile(r"(?P<name>.*?)\s*[\[(]\s*(?P<unit>[^\])]*?)\s*[\])]?\s*")
# Units as people write and speak them, each part of "degrees per second".
_SPOKEN = {
    "hz": "Hz", "n": "N", "mn": "mN", "degree": "deg", "degrees": "deg", "°": "deg", "radian": "rad", "radians": "rad",
    "sec": "s", "second": "s", "seconds": "s", "minute": "min", "minutes": "min", "u": "turn", "r": "turn",
    "rev": "turn", "revs": "turn", "revolution": "turn", "revolutions": "turn", "turns": "turn", "rps": "turn/s",
    "dps": "deg/s",
}  # fmt: skip


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
    also : tuple of str
        Other names that people give it, in small letters with `_` between the words.
    by_unit : bool
        Whether a heading that is nothing but a unit of it names it.
    """

    unit: str
    wanted: str = ""
    required: bool = True
    blank: bool = False
    above: float = -math.inf
    at_least: float = -math.inf
    also: tuple[str, ...] = ()
    by_unit: bool = False

    @property
    def allowed(self) -> str:
        """What a cell may hold, as the end of "must be …"."""
        limits = f" above {self.above:g}" * (self.above > -math.inf)
        limits += f" of at least {self.at_least:g}" * (self.at_least > -math.inf)
        return f"a number{limits}" + (", or empty" if self.may_be_blank else "")

    @property
    def may_be_blank(self) -> bool:
        """Whether its cells may be empty."""
        return self.blank or not self.required

    def factor(self, unit: str) -> float:
        """Factor from the unit of a heading to the one wanted; a heading without unit is in the one wanted.

        Raises
        ------
        ValueError
            When the unit measures something else.
        """
        wanted, spelt = self.wanted or self.unit, _spelt(unit)
        if spelt in ("", wanted):
            return 1.0
        return parse(f"1 {spelt}", self.unit) / (parse(f"1 {wanted}", self.unit) if wanted else 1.0)

    def fits(self, unit: str) -> bool:
        """Whether a heading in this unit can be of this column."""
        try:
            self.factor(unit)
        except ValueError:
            return False
        return True


@dataclass(frozen=True)
class Headings:
    """Which of a table's columns are read.

    Attributes
    ----------
    numbers : mapping of str to (int, float)
        Place of each column of numbers that the table has, and the factor to its wanted unit.
    text : mapping of str to int
        Place of each column of text that it has.
    unitless : mapping of str to str
        Headings of those that are in the unit wanted for want of one, though that is not SI's, by column.
    """

    numbers: Mapping[str, tuple[int, float]]
    text: Mapping[str, int]
    unitless: Mapping[str, str]

    @property
    def read(self) -> set[int]:
        """Places that are read."""
        return {place for place, _ in self.numbers.values()} | set(self.text.values())


def find_columns(
    headings: Sequence[str],
    columns: Mapping[str, Column],
    text: Mapping[str, Sequence[str]],
    *,
    file: str,
    field: str,
    example: str,
) -> Headings:
    """Find the columns that are wanted among a table's headings.

    Parameters
    ----------
    columns : mapping of str to Column
        By name without unit.
    text : mapping of str to sequence of str
        Other names of each column of text.

    Raises
    ------
    InputError
        When one is missing, twice there or in a wrong unit; names the `file`.
    """
    named = _unique([_meant(heading, columns, text) for heading in headings], columns)
    named = [way if way[0] else _by_unit(heading, columns, named) for heading, way in zip(headings, named, strict=True)]
    numbers, words, unitless = {}, {}, {}
    for name in (*columns, *text):
        column = columns.get(name)
        places = [i for i, way in enumerate(named) if way[0] == name]
        if len(places) > 1 or (not places and column and column.required):
            got, unknown = [headings[i] for i in places], ""
            if not got and any(way[0] for way in named):
                got = [printable(cell, 40) for cell in headings[:12]]
                strange = [printable(h, 40) for h, way in zip(headings, named, strict=True) if h and not way[0]][:12]
                unknown = f"; not understood: {', '.join(strange)}" if strange else ""
            # What has none of the columns is some other file, whose first line is nobody's business.
            said = ", ".join(got) or (f"{len(headings)} of no known name" if headings else "none")
            works = example if column and column.required else "leaving one of them out"
            raise InputError(field, f"columns {said} in {file}{unknown}", f"a table with one column {name}", works)
        if places and column:
            place, unit = places[0], named[places[0]][1]
            numbers[name] = place, _factor(name, column, headings[place], unit, field)
            if column.wanted and not unit:
                unitless[name] = headings[place]
        elif places:
            words[name] = places[0]
    return Headings(numbers, words, unitless)


def possible_names(heading: str) -> list[str]:
    """Names that a heading may mean, the longest first, as they are compared: small letters, `_` between the words."""
    return [name for name, _ in _ways(heading) if name]


def _ways(heading: str) -> list[tuple[str, str]]:
    """Ways in which a heading may be a name and a unit; the longest name first."""
    if len(heading) > LONGEST_HEADING:
        return []
    if bracketed := _BRACKETED.fullmatch(heading):
        return [(_plain(bracketed["name"]), bracketed["unit"])]
    pieces = re.split(r"\s+(?:/|in)\s+|,\s*|[\s\-._]+", heading.strip())
    ways = [(_plain("_".join(pieces[:i])), "_".join(pieces[i:])) for i in range(len(pieces), 0, -1)]
    name, slash, unit = heading.partition("/")
    return [*ways, (_plain(name), unit)] if slash else ways


def _plain(name: str) -> str:
    return re.sub(r"[\s\-._]+", "_", name.strip().lower()).strip("_?:")


def _meant(heading: str, columns: Mapping[str, Column], text: Mapping[str, Sequence[str]]) -> tuple[str, str]:
    """Which column a heading is, and its unit; the longest name that fits, as `rate_sd` is no `rate`."""
    ways = _ways(heading)
    for name, also in text.items():
        if ways and ways[0][0] in (name, *also):
            return name, ""
    for said, unit in ways:
        # A column's own name in a wrong unit is an error; another word may as well be of something else.
        for name, column in columns.items():
            if said == name or (said in column.also and column.fits(unit)):
                return name, unit
    return "", ""


def _unique(named: list[tuple[str, str]], columns: Mapping[str, Column]) -> list[tuple[str, str]]:
    """The same without those in a wrong unit where another is in a right one: `frequency_sd` beside `frequency_hz`."""
    right = {name for name, unit in named if name in columns and columns[name].fits(unit)}
    return [("", "") if name in right and not columns[name].fits(unit) else (name, unit) for name, unit in named]


def _by_unit(heading: str, columns: Mapping[str, Column], named: Sequence[tuple[str, str]]) -> tuple[str, str]:
    """Column that a heading names by a unit alone, where no other heading names it."""
    bare = _BRACKETED.fullmatch(heading)
    unit = bare["unit"] if bare and not bare["name"] else heading
    taken = {name for name, _ in named}
    fitting = {n: c for n, c in columns.items() if unit and c.by_unit and n not in taken and c.fits(unit)}
    # Plate frequencies and turning are both said in Hz; who says no more means the first.
    exact = {n: c for n, c in fitting.items() if c.unit == _spelt(unit)} or fitting
    return (next(iter(exact)), unit) if len(exact) == 1 else ("", "")


def _factor(name: str, column: Column, heading: str, unit: str, field: str) -> float:
    try:
        return column.factor(unit)
    except ValueError:
        works = f"{name}_{(column.wanted or column.unit).replace('/', '_')}"
        allowed = f"{name} in a unit of {column.unit}" if column.unit else f"{name} without a unit"
        raise InputError(field, heading, allowed, works) from None


def _spelt(unit: str) -> str:
    """Unit in the words of `plategait.units`; in names there is no slash."""
    if _PER_MINUTE.fullmatch(unit.strip()):
        return "turn/min"
    parts = re.split(r"/|[_\s]per[_\s]|_", unit.strip())
    return "/".join(_SPOKEN.get(part.strip(" .").lower(), part.strip()) for part in parts)
