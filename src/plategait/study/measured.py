"""What runs showed: a row of plain numbers for each start of each point, and columns of them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plategait.arrays import Array

Row = dict[str, float]
"""Numbers of one run by name, SI; NaN where there is nothing to measure."""
Columns = Mapping[str, Array]
"""Numbers of all points by name, (points,) each."""


@dataclass(frozen=True, eq=False)
class Measured:
    """What points showed: a row of numbers for each start of each point.

    Attributes
    ----------
    rows : tuple of tuples of dict
        By point, then by start.
    half : same, or None
        The same starts at half the time step.
    """

    rows: tuple[tuple[Row, ...], ...]
    half: tuple[tuple[Row, ...], ...] | None = None

    @cached_property
    def means(self) -> Columns:
        """Mean over the starts that have the number."""
        return _means(self.rows)

    @cached_property
    def half_means(self) -> Columns | None:
        """The same at half the time step."""
        return None if self.half is None else _means(self.half)

    @cached_property
    def by_start(self) -> list[Columns]:
        """Columns of each start by itself."""
        return [_means([(point[i],) for point in self.rows]) for i in range(len(self.rows[0]))]

    def column(self, name: str) -> Array:
        """(points, starts) a number of all runs."""
        return np.array([[row[name] for row in point] for point in self.rows])

    def part(self, points: Sequence[int] | slice) -> Measured:
        """Some of the points."""
        which = range(len(self.rows))[points] if isinstance(points, slice) else points
        half = None if self.half is None else tuple(self.half[i] for i in which)
        return Measured(tuple(self.rows[i] for i in which), half)

    def pooled(self, count: int) -> Measured:
        """Each so many points that follow each other as one, of which they are the starts."""

        def together(rows: tuple[tuple[Row, ...], ...]) -> tuple[tuple[Row, ...], ...]:
            return tuple(sum(rows[i : i + count], ()) for i in range(0, len(rows), count))

        return Measured(together(self.rows), None if self.half is None else together(self.half))


def _means(rows: Sequence[Sequence[Row]]) -> Columns:
    columns = {}
    for name in rows[0][0]:
        values = np.array([[row[name] for row in point] for point in rows])
        there = np.isfinite(values)
        total = np.where(there, values, 0.0).sum(axis=1)
        columns[name] = np.where(there.any(axis=1), total / np.maximum(there.sum(axis=1), 1), math.nan)
    return columns
