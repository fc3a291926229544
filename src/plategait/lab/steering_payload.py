"""A steering (`plategait steer --out way.csv`): where the object was, was seen and was to go, tick by tick."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from plategait.files.headings import Column
from plategait.files.table import read_table
from plategait.lab.lean import every, lean
from plategait.model.scenario import Scenario

MOST_TICKS = 4_000
_POSE = {"x": "m", "y": "m", "angle": "rad"}
_OF = ("", "seen_", "goal_")


def steering_payload(path: Path, scenario: Scenario) -> dict[str, Any]:
    """Ticks of a steering in SI, and its goals in their order with the tick from which each was aimed for.

    Raises
    ------
    InputError
        When the table cannot be read; names the line.
    """
    del scenario
    columns = {
        f"{of}{name}": Column(unit, blank=True, required=of != "seen_") for of in _OF for name, unit in _POSE.items()
    }
    table = read_table(path, {"time": Column("s")} | columns, field="WHAT", rising="time",
                       example="time_s,x_mm,y_mm,angle_deg,goal_x_mm,goal_y_mm,goal_angle_deg")  # fmt: skip
    kept = every(len(table), MOST_TICKS)
    aims = np.column_stack([table[f"goal_{name}"] for name in _POSE])
    # NaN is where any angle will do.
    same = np.all((aims[1:] == aims[:-1]) | (np.isnan(aims[1:]) & np.isnan(aims[:-1])), axis=1)
    begins = [0, *(np.flatnonzero(~same) + 1).tolist()]
    goals = [dict(zip(_POSE, lean(aims[i]), strict=True)) | {"from": lean([table["time"][i]])[0]} for i in begins]
    series = {name: lean(table[name][kept]) for name in ("time", *columns) if name in table}
    note = [f"of the steering {len(kept)} of {len(table)} ticks are shown"] if len(kept) < len(table) else []
    return {"goals": goals, "goal": goals[-1], "ticks": series, "notes": note}
