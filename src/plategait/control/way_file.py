"""A steering as one JSON file: what lay on which plate, what the plate was told, tick by tick where the object was.

`plategait lab` shows it, and plays what the plate was told to the sheet again.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from plategait.arrays import Array
from plategait.control.follow import Following
from plategait.control.goal import Goal
from plategait.control.plant import at_rest
from plategait.control.steer import Steering
from plategait.files.output import write_whole
from plategait.files.plain import plain
from plategait.model.course import course_of, gone_over
from plategait.model.machine import machine_of
from plategait.model.motion import PlateMotion
from plategait.model.needs import join_duration
from plategait.model.plain import plain_model
from plategait.model.scenario import Scenario
from plategait.model.scenario_file import write_scenario
from plategait.version import __version__

WAYS = (".json",)
FORMAT = "steering"


def write_way_whole(
    done: Steering | Following,
    goals: Sequence[Goal],
    true: Scenario,
    machine: str,
    path: Path | str,
    field: str = "out",
) -> None:
    """Write a steering, or a path followed, as JSON in SI.

    ``motions`` are those that the plate was told, each once; ``told`` says when which of them (`motion`), and within
    how many seconds the plate went over to it.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    way = done if isinstance(done, Steering) else done.way
    motions, told = told_to(way, at_rest(true), machine)
    numbers: dict[str, Any] = {
        "format": FORMAT, "plategait_version": __version__, "scenario": write_scenario(at_rest(true)),
        "machine": machine,
        "goals": [{"x": g.x, "y": g.y, "angle": g.angle, "reached": i < len(way.arrivals) and way.arrivals[i].reached}
                  for i, g in enumerate(goals)],
        "path": None if isinstance(done, Steering) else done.path.points.tolist(),
        "motions": [plain_model(motion) for motion in motions],
        "told": told,
        "ticks": {"time": way.times.tolist()} | _poses("", way.poses) | _poses("seen_", way.seen)
                 | _poses("goal_", way.aims),
    }  # fmt: skip
    write_whole(json.dumps(numbers, allow_nan=False).encode(), path, WAYS, field)


def told_to(way: Steering, resting: Scenario, machine: str) -> tuple[list[PlateMotion], list[dict[str, float]]]:
    """Motions that a plate was told, each once; and at which whole step which, with the time to go over to it."""
    shaker, course = machine_of(machine), course_of(resting.motion)
    motions: list[PlateMotion] = []
    told: list[dict[str, float]] = []
    for tick, motion in way.motions:
        time = round(tick / resting.dt) * resting.dt
        if motion == course[-1].motion:
            continue
        within = join_duration(course, motion, time, shaker, "motion")
        course = gone_over(course, motion, time, within)
        if motion not in motions:
            motions.append(motion)
        told.append({"time": time, "motion": motions.index(motion), "within": within})
    return motions, told


def _poses(of: str, poses: Array) -> dict[str, list[float | None]]:
    columns = np.asarray(poses, dtype=float).reshape(-1, 3).T
    return {f"{of}{name}": plain(column.tolist()) for name, column in zip(("x", "y", "angle"), columns, strict=True)}
