"""A steering as plain data and as a table of its ticks, in the units that people use."""

from __future__ import annotations

import io
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from plategait.arrays import Array
from plategait.control.camera import Camera
from plategait.control.follow import Following
from plategait.control.goal import Goal
from plategait.control.steer import Arrival, Steering
from plategait.files.output import write_whole
from plategait.files.plain import plain
from plategait.model.scenario import Plate, Scenario

TABLES = (".csv",)
NOT_AIMED_FOR = "not aimed for"
_PEOPLES = np.array([1e3, 1e3, math.degrees(1)])


def steering_told(way: Steering, goals: Sequence[Goal]) -> dict[str, Any]:
    """Plain numbers for `--json`: goals, those included that were not aimed for any more, and the way to them."""
    missed = [None] * (len(goals) - len(way.arrivals))
    return {
        "goals": [_told(goal, arrival) for goal, arrival in zip(goals, [*way.arrivals, *missed], strict=True)],
        "reached": way.reached and not missed,
        **_way_told(way),
    }


def _told(goal: Goal, arrival: Arrival | None) -> dict[str, Any]:
    any_angle = goal.angle is None
    place = {
        "x_mm": 1e3 * goal.x, "y_mm": 1e3 * goal.y,
        "angle_deg": None if goal.angle is None else math.degrees(goal.angle),
    }  # fmt: skip
    if arrival is None:
        return place | {"reached": False, "time_s": None, "error_mm": None, "error_deg": None, "pulses": 0,
                        "status": NOT_AIMED_FOR}  # fmt: skip
    return place | {
        "reached": arrival.reached,
        "time_s": plain(arrival.time),
        "error_mm": plain(1e3 * arrival.error),
        "error_deg": None if any_angle else plain(math.degrees(arrival.angle_error)),
        "pulses": arrival.pulses,
        "status": arrival.status,
    }


def following_told(following: Following, within: float) -> dict[str, Any]:
    """Plain numbers for `--json`: how near an object stayed to its path, and how long it took."""
    way = following.way
    return {
        "path": {
            "length_mm": 1e3 * following.path.length,
            "reached": following.reached,
            "time_s": plain(way.arrivals[0].time),
            "rms_mm": plain(1e3 * following.rms),
            "greatest_mm": plain(1e3 * following.greatest),
            "coverage": following.coverage(within),
            "pulses": way.arrivals[0].pulses,
            "status": way.arrivals[0].status,
        },
        "reached": following.reached,
        **_way_told(way),
    }


def place_told(scenario: Scenario) -> dict[str, Any]:
    """What lies on which plate, as JSON has it."""
    plate = scenario.plate or Plate()
    return {"scenario": scenario.name, "plate_mm": [1e3 * plate.length, 1e3 * plate.width]}


def _way_told(way: Steering) -> dict[str, Any]:
    return {
        "duration_s": float(way.times[-1]) if len(way.times) else 0.0,
        "start": pose_told(way.poses[0]),
        "end": pose_told(way.poses[-1]),
    }


def camera_told(camera: Camera) -> dict[str, Any]:
    """What sees the object, as JSON has it."""
    return {
        "rate_hz": camera.rate, "position_noise_mm": 1e3 * camera.position_noise,
        "angle_noise_deg": math.degrees(camera.angle_noise), "delay_s": camera.delay, "missed": camera.missed,
        "dark_s": [list(span) for span in camera.dark],
    }  # fmt: skip


def pose_told(pose: Array) -> dict[str, float | None]:
    """A pose as JSON has it."""
    x, y, angle = (plain(float(value)) for value in pose * _PEOPLES)
    return {"x_mm": x, "y_mm": y, "angle_deg": angle}


def write_way(way: Steering, path: Path | str, field: str = "out") -> None:
    """Write the ticks of a steering as CSV: when, where the object was, where it was last seen, and where it was to go.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    poses = [("", way.poses), ("seen_", way.seen), ("goal_", way.aims)]
    names = ["time_s", *(f"{of}{what}" for of, _ in poses for what in ("x_mm", "y_mm", "angle_deg"))]
    table = np.column_stack([way.times, *(values * _PEOPLES for _, values in poses)])
    text = io.StringIO()
    np.savetxt(text, table, fmt="%.6g", delimiter=",", header=",".join(names), comments="")
    # Cells that nobody knows are empty.
    write_whole(text.getvalue().replace("nan", "").encode(), path, TABLES, field)
