"""Estimates of many objects as one table: a row for each, the numbers that the gate withholds left empty."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Sequence
from typing import Any

from plategait.collection.collection import Outcome

FIRST = ("object", "answered", "explained", "failure", "complaints")
"""Columns before the parameters'."""
_PARTS = ("median", "sd", "low", "high")


def rows_of(outcomes: Sequence[Outcome]) -> list[dict[str, str]]:
    """A row for each object, by column; the columns of all are the same, in the same order.

    Of each parameter there are `NAME_UNIT`, `NAME_sd_UNIT`, `NAME_low_UNIT` and `NAME_high_UNIT`, empty where the data
    do not determine them.
    """
    made = [dict(_cells(outcome)) for outcome in outcomes]
    columns = dict.fromkeys(name for row in made for name in row)
    return [{name: row.get(name, "") for name in columns} for row in made]


def as_csv(outcomes: Sequence[Outcome]) -> str:
    """The table as CSV."""
    rows, text = rows_of(outcomes), io.StringIO()
    writer = csv.DictWriter(text, list(rows[0]) if rows else list(FIRST), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def _cells(outcome: Outcome) -> Iterator[tuple[str, str]]:
    summary = outcome.summary or {}
    explained = summary.get("explained")
    complaints = [*summary.get("complaints", []), *summary.get("refused", [])]
    yield "object", outcome.item.name
    yield "answered", "yes" if outcome.answered else "no"
    yield "explained", "" if explained is None else ("yes" if explained else "no")
    yield "failure", outcome.failure
    yield "complaints", "; ".join(complaints)
    for name, numbers in (summary.get("parameters", {}) | summary.get("stiffness", {})).items():
        for part in _PARTS:
            yield _heading(name, part, numbers["unit"] or ""), _number(numbers.get(part))


def _heading(name: str, part: str, unit: str) -> str:
    slug = unit.replace("π", "pi").replace("/s", "_s").replace("/", "_per_").replace("*", "_").replace(" ", "_")
    return "_".join(filter(None, [name, "" if part == "median" else part, slug.lower()]))


def _number(value: Any) -> str:
    return "" if value is None else f"{value:.6g}"
