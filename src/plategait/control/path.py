"""Paths that an object is carried along: a figure of eight, the letters of a word, or a curve from a file."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path as FilePath

import numpy as np

from plategait.arrays import Array, Flags
from plategait.control.letters import strokes_of
from plategait.control.room import MARGIN, room_of
from plategait.errors import InputError
from plategait.files.headings import Column
from plategait.files.table import read_table
from plategait.model.scenario import Scenario

FIGURE_OF_EIGHT = "figure of eight"
HEIGHT = 0.04
"""Of a figure of eight, and of letters, m."""
STEP = 5e-4
"""Between the points that a path is told by, m."""
_LONGEST = 20.0


@dataclass(frozen=True, eq=False)
class Path:
    """A curve on the plate, by points that are evenly spaced along its strokes.

    Attributes
    ----------
    points : (n, 2) array
        m, from the middle of the plate.
    drawn : (n,) bool array
        Points of the strokes; those between belong to ways from one stroke to the next, on which nothing counts.
    """

    points: Array
    drawn: Flags

    @property
    def arc(self) -> Array:
        """(n,) how far along it each point lies, m."""
        return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(self.points, axis=0), axis=1))])

    @property
    def length(self) -> float:
        """Of its strokes together, m."""
        steps = np.diff(self.arc)
        return float(steps[self.drawn[1:] & self.drawn[:-1]].sum())

    @property
    def ends(self) -> list[tuple[int, int]]:
        """First point of each stroke, and the one after its last."""
        changes = np.flatnonzero(np.diff(np.concatenate([[False], self.drawn, [False]]).astype(int)))
        return [(int(begin), int(end)) for begin, end in changes.reshape(-1, 2)]

    @property
    def strokes(self) -> list[Array]:
        """Points of each stroke."""
        return [self.points[begin:end] for begin, end in self.ends]

    def begun_at(self, place: Array) -> Path:
        """The same path with the way to its beginning before it."""
        way = _evenly(np.array([place, self.points[0]]))[:-1]
        return Path(np.concatenate([way, self.points]), np.concatenate([np.zeros(len(way), dtype=bool), self.drawn]))


def path_of(strokes: Sequence[Array], field: str = "path") -> Path:
    """Path along strokes (n, 2), m, one after the other, by straight ways between them.

    Raises
    ------
    InputError
        For what is no curve, or longer than anyone has patience for.
    """
    corners = [np.asarray(stroke, dtype=float) for stroke in strokes]
    length = sum(float(np.linalg.norm(np.diff(stroke, axis=0), axis=1).sum()) for stroke in corners)
    if not STEP < length < _LONGEST:
        raise InputError(field, f"a path of {1e3 * length:.3g} mm", f"above {1e3 * STEP:g} mm and below {_LONGEST:g} m",
                         f'"{FIGURE_OF_EIGHT}"')  # fmt: skip
    points, drawn = [], []
    for number, stroke in enumerate(corners):
        if number and not np.array_equal(stroke[0], corners[number - 1][-1]):
            way = _evenly(np.array([corners[number - 1][-1], stroke[0]]))[1:-1]
            points.append(way)
            drawn.append(np.zeros(len(way), dtype=bool))
        own = _evenly(stroke)
        points.append(own)
        drawn.append(np.ones(len(own), dtype=bool))
    return Path(np.concatenate(points), np.concatenate(drawn))


def _evenly(corners: Array) -> Array:
    """Points at most `STEP` apart along straight lines between corners, which are kept."""
    lengths = np.linalg.norm(np.diff(corners, axis=0), axis=1)
    pieces = [
        np.linspace(begin, end, max(math.ceil(length / STEP - 1e-9), 1), endpoint=False)
        for begin, end, length in zip(corners[:-1], corners[1:], lengths, strict=True)
    ]
    return np.concatenate([*pieces, corners[-1:]])


def figure_of_eight(height: float = HEIGHT) -> Path:
    """Gerono's lemniscate, upright, half as wide as it is high; it begins where it crosses itself."""
    turn = np.linspace(0, 2 * math.pi, max(64, math.ceil(4 * height / STEP)))
    return path_of([np.column_stack([height / 4 * np.sin(2 * turn), height / 2 * np.sin(turn)])])


def word_path(word: str, height: float = HEIGHT, field: str = "path") -> Path:
    """Path of the letters of a word, m high."""
    return path_of(strokes_of(word, height, field), field)


def read_path(path: FilePath | str, field: str = "path") -> Path:
    """Path of a CSV file: columns x_mm and y_mm, and, where there are several strokes, the number of each in `stroke`.

    Raises
    ------
    InputError
        When it cannot be read, or is no curve.
    """
    columns = {"x": Column("m"), "y": Column("m"), "stroke": Column("", required=False)}
    table = read_table(path, columns, field=field, example="x_mm,y_mm", least_rows=2)
    points = np.column_stack([table["x"], table["y"]])
    number = np.nan_to_num(table.get("stroke", np.zeros(len(points))))
    return path_of(np.split(points, np.flatnonzero(np.diff(number)) + 1), field)


def check_path(path: Path, scenario: Scenario, field: str = "path") -> None:
    """Refuse a path on which an object would not stay on its plate.

    Raises
    ------
    InputError
        With how far it may go, and how much smaller it would have to be.
    """
    room = room_of(scenario) - MARGIN
    reached = np.abs(path.points).max(axis=0)
    if (reached > room + 1e-9).any():
        ends = np.floor(1e3 * room)
        got = f"up to {1e3 * reached[0]:.1f} mm along the bar and {1e3 * reached[1]:.1f} mm across it"
        raise InputError(field, got,
                         f"within {ends[0]:.0f} mm and {ends[1]:.0f} mm, so that the object stays on its plate",
                         f"one {math.floor(1e3 * (room / np.maximum(reached, 1e-9)).min()) / 10:g} % as large, "
                         "or a larger --plate-size")  # fmt: skip
