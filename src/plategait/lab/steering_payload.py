"""A steering: where the object was, was seen and was to go, tick by tick, and where it is told what the plate did.

Of `plategait steer --out way.json`, which holds all of it, or of the table that `--out way.csv` writes.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.files.headings import Column
from plategait.files.input import LARGEST_TABLE, read_text
from plategait.files.table import read_table
from plategait.lab.lean import every, lean
from plategait.lab.scenario_json import plain_scenario, told_scenario
from plategait.model.motion import PlateMotion
from plategait.model.plain import plain_model

MOST_TICKS = 4_000
# Changes of the plate's motion, and motions, that a page has room for.
MOST_CHANGES, MOST_MOTIONS = 5_000, 500
FORMAT = "steering"
_POSE = {"x": "m", "y": "m", "angle": "rad"}
_OF = ("", "seen_", "goal_")
_ALLOWED, _HINT = "a steering that plategait wrote", 'plategait steer --to "0 mm, 20 mm" --out way.json'


def table_payload(path: Path) -> dict[str, Any]:
    """Ticks of a table in SI, and its goals in their order with the time from which each was aimed for.

    Raises
    ------
    InputError
        When the table cannot be read; names the line.
    """
    columns = {
        f"{of}{name}": Column(unit, blank=True, required=of != "seen_") for of in _OF for name, unit in _POSE.items()
    }
    table = read_table(path, {"time": Column("s")} | columns, field="WHAT", rising="time",
                       example="time_s,x_mm,y_mm,angle_deg,goal_x_mm,goal_y_mm,goal_angle_deg")  # fmt: skip
    return _ticks({name: table[name] for name in ("time", *columns) if name in table}) | {"motions": [], "told": []}


def whole_payload(path: Path) -> dict[str, Any]:
    """All of a steering, its scenario included, from JSON.

    Raises
    ------
    InputError
        When the file is none of ours, or damaged.
    """
    text = read_text(path, LARGEST_TABLE, "WHAT", _ALLOWED, _HINT)
    try:
        told = json.loads(text)
        if told["format"] != FORMAT:
            raise ValueError("another format")
        scenario, notes = plain_scenario(told_scenario(told["scenario"]))
        if any(isinstance(motion["samples"], str) for motion in told["motions"]):
            raise ValueError("a trajectory in another file")
        motions = [plain_model(PlateMotion(**motion)) for motion in told["motions"]]
        changes = [(float(c["time"]), int(c["motion"]), float(c["within"])) for c in told["told"]]
        sound = all(0 <= motion < len(motions) and within > 0 for _, motion, within in changes)
        columns = {name: np.array(values, dtype=float) for name, values in told["ticks"].items()}
        lengths = {len(values) for values in columns.values()}
        if not sound or len(lengths) != 1 or lengths == {0} or not {"time", *_POSE, "goal_x", "goal_y"} <= set(columns):
            raise ValueError("numbers that do not fit each other")
        path_points = [[float(x), float(y)] for x, y in told["path"] or []]
    except InputError:
        raise
    except (ValueError, LookupError, TypeError, AttributeError, RecursionError):
        raise InputError("WHAT", f"{path} (no whole steering)", _ALLOWED, _HINT) from None
    if len(changes) > MOST_CHANGES or len(motions) > MOST_MOTIONS:
        changes, motions = [], []
        notes.append("what the plate was told is too much for a page, and left out")
    ticks = _ticks(columns)
    ticks["notes"] = [*notes, *ticks["notes"]]
    step = every(len(path_points), 1000)
    return {**ticks, "scenario": scenario, "path": [path_points[i] for i in step], "motions": motions,
            "told": [{"time": t, "motion": m, "within": w} for t, m, w in changes]}  # fmt: skip


def _ticks(columns: Mapping[str, Array]) -> dict[str, Any]:
    time = columns["time"]
    kept = every(len(time), MOST_TICKS)
    aims = np.column_stack([columns.get(f"goal_{name}", np.full(len(time), np.nan)) for name in _POSE])
    # NaN is where any angle will do.
    same = np.all((aims[1:] == aims[:-1]) | (np.isnan(aims[1:]) & np.isnan(aims[:-1])), axis=1)
    begins = [0, *(np.flatnonzero(~same) + 1).tolist()] if len(time) else []
    goals = [dict(zip(_POSE, lean(aims[i]), strict=True)) | {"from": lean([time[i]])[0]} for i in begins]
    note = [f"of the steering {len(kept)} of {len(time)} ticks are shown"] if len(kept) < len(time) else []
    series = {name: lean(values[kept]) for name, values in columns.items()}
    return {"goals": goals, "goal": goals[-1] if goals else None, "ticks": series, "path": [], "notes": note}
