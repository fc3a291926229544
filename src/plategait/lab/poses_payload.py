"""Tracked poses (`plategait track --out poses.csv`, or any table of them)."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from plategait.files.headings import Column
from plategait.files.table import read_table
from plategait.lab.lean import every, lean

MOST_FRAMES = 6_000
_COLUMNS = {
    "time": Column("s", also=("t",)), "x": Column("m", blank=True), "y": Column("m", blank=True),
    "angle": Column("rad", blank=True), "sure": Column("", required=False),
}  # fmt: skip


def poses_payload(path: Path) -> dict[str, Any]:
    """Poses in SI, none where the object was not seen, and whether the tracker was sure of each.

    Raises
    ------
    InputError
        When the table cannot be read; names the line.
    """
    table = read_table(path, _COLUMNS, field="WHAT", example="time_s,x_mm,y_mm,angle_deg", rising="time")
    kept = every(len(table), MOST_FRAMES)
    seen = np.isfinite(table["angle"])
    sure = np.where(seen, table.get("sure", seen.astype(float)), 0.0) > 0
    note = [f"of the film {len(kept)} of {len(table)} frames are shown"] if len(kept) < len(table) else []
    series = {name: lean(table[name][kept]) for name in ("time", "x", "y", "angle")}
    return series | {"sure": sure[kept].tolist(), "notes": note}
