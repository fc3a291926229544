"""Goals: poses that an object is to be brought to, and paths that it is to be carried along."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from plategait.arrays import Array
from plategait.control.menu import Menu
from plategait.control.pulse import Pulses
from plategait.control.reach import Reach
from plategait.control.room import MARGIN, room_of
from plategait.errors import InputError
from plategait.files.headings import Column
from plategait.files.table import read_table
from plategait.model.scenario import Scenario
from plategait.units import ANGLE, Quantity

WITHIN, WITHIN_ANGLE = 3e-3, math.radians(5)
"""How near to its goal an object counts as being there, m and rad."""
HOLD = 2.0
"""How long it is to stay there, s."""

_PLACE = Quantity("m", "mm", "30 mm", at_least=-10, at_most=10)


@dataclass(frozen=True)
class Goal:
    """A pose to come to.

    Attributes
    ----------
    x, y : float
        Along the bar and across it, m, from the middle of the plate.
    angle : float, optional
        rad, counter-clockwise from how the object's outline is drawn; any where there is none.
    """

    x: float
    y: float
    angle: float | None = None

    @property
    def pose(self) -> Array:
        """(3,) x, y and angle; NaN for any."""
        return np.array([self.x, self.y, math.nan if self.angle is None else self.angle])


def read_goal(typed: str, field: str = "to") -> Goal:
    """Goal of text: "30 mm, -10 mm, 90 deg", or a place alone.

    Raises
    ------
    InputError
        For what is not two lengths, and an angle at most.
    """
    parts = [part.strip() for part in typed.split(",")]
    if len(parts) not in (2, 3):
        raise InputError(field, typed, "two lengths, along the bar and across it, and an angle where it matters",
                         '"30 mm, -10 mm, 90 deg"')  # fmt: skip
    x, y = (_PLACE.read(part, field) for part in parts[:2])
    return Goal(x, y, ANGLE.read(parts[2], field) if len(parts) == 3 else None)


def read_goals(path: Path | str, field: str = "goals") -> list[Goal]:
    """Goals of a CSV file, one a row: columns x_mm, y_mm and, where it matters, angle_deg, or other units of them.

    Raises
    ------
    InputError
        When it cannot be read, or holds no goal.
    """
    columns = {"x": Column("m"), "y": Column("m"), "angle": Column("rad", required=False)}
    table = read_table(path, columns, field=field, example="x_mm,y_mm,angle_deg")
    angles = table.get("angle", np.full(len(table), math.nan))
    return [
        Goal(x, y, None if math.isnan(angle) else angle)
        for x, y, angle in zip(table["x"].tolist(), table["y"].tolist(), angles.tolist(), strict=True)
    ]


def check_goals(goals: Sequence[Goal], scenario: Scenario) -> None:
    """Refuse goals at which an object would not lie on its plate.

    Raises
    ------
    InputError
        With the first such goal, and where it may be.
    """
    for number, goal in enumerate(goals, start=1):
        check_place(goal, scenario, f"goals.{number}")


def check_place(goal: Goal, scenario: Scenario, field: str) -> None:
    """Refuse a goal, or a start, at which an object would not lie on its plate.

    Raises
    ------
    InputError
        With where it may be.
    """
    room = room_of(scenario) - MARGIN
    place = np.array([goal.x, goal.y])
    if not (np.isfinite(place).all() and (np.abs(place) <= room + 1e-9).all()):
        ends, nearest = np.floor(1e3 * room), np.trunc(1e3 * np.clip(np.nan_to_num(place), -room, room))
        raise InputError(field, f"({1e3 * goal.x:g}, {1e3 * goal.y:g}) mm",
                         f"within {ends[0]:.0f} mm along the bar and {ends[1]:.0f} mm across it, so that the object "
                         "stays on its plate",
                         f'"{nearest[0]:.0f} mm, {nearest[1]:.0f} mm"')  # fmt: skip


def check_reach(goals: Sequence[Goal], menu: Menu) -> None:
    """Refuse goals about which the motions of a menu do not carry the object every way.

    Raises
    ------
    InputError
        With the first such goal.
    """
    pulses = Pulses(menu.response)
    for number, goal in enumerate(goals, start=1):
        Reach(pulses.at(goal.pose[:2])[pulses.short], pulses.times[pulses.short], field=f"goals.{number}")


def random_goals(count: int, scenario: Scenario, seed: int, reach: float = 0.04) -> list[Goal]:
    """Goals within `reach` (m) of the middle of the plate each way, at any angle."""
    reach = float(min(reach, (room_of(scenario) - MARGIN).min()))
    shares = np.random.default_rng(seed).uniform(-1, 1, (count, 3)).tolist()
    return [Goal(reach * x, reach * y, math.pi * turn) for x, y, turn in shares]


def off(pose: Array, goal: Array) -> tuple[float, float]:
    """Distance from a goal, m, and angle from it in size, rad: 0 where any angle will do."""
    distance = math.hypot(pose[0] - goal[0], pose[1] - goal[1])
    turn = 0.0 if math.isnan(goal[2]) else abs(math.remainder(pose[2] - goal[2], 2 * math.pi))
    return distance, turn
