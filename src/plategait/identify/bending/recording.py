"""Recordings of a bending strip: the two joint angles, as columns or from three markers (section 3.3.2).

The markers sit at the wall, where the virtual joint is, and at the free tip.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from plategait.errors import InputError
from plategait.files.input import LARGEST_TABLE, UnreadableError, plain_bytes
from plategait.files.table import Column, read_table
from plategait.theory.two_links import LEAST_ROWS, Angles, angles_of_markers

_EXAMPLE = "headings time_s,phi1_deg,phi2_deg or time_s,x0_mm,y0_mm,x1_mm,y1_mm,x2_mm,y2_mm"
_PLACES = tuple(f"{axis}{i}" for i in range(3) for axis in "xy")


def read_angles(path: Path | str, *, y_down: bool = False) -> Angles:
    """Read a recording: time with phi1 and phi2, or with x0, y0 (wall), x1, y1 (joint), x2, y2 (tip).

    Parameters
    ----------
    path : Path or str
        CSV; headings carry units (see `read_table`). Markers may be in pixels: "x0_px".
    y_down : bool
        Whether the y of the markers counts downwards, as in pictures.

    Raises
    ------
    InputError
        When the file is not as said; see `read_table`.
    """
    heading = _first_line(path)
    field, time = "recording", {"time": Column("s")}
    if "x0" not in heading:
        if y_down:
            raise InputError("--y-down", "nothing it would change", "left out for joint angles, which have no y",
                             "a file with x0, y0 to x2, y2")  # fmt: skip
        angle = Column("rad")
        table = read_table(path, time | {"phi1": angle, "phi2": angle}, field=field, example=_EXAMPLE,
                           least_rows=LEAST_ROWS, rising="time")  # fmt: skip
        return Angles(table["time"], table["phi1"], table["phi2"])
    pixels = "x0_px" in heading
    names = [f"{place}_px" if pixels else place for place in _PLACES]
    places = dict.fromkeys(names, Column("" if pixels else "m"))
    table = read_table(path, time | places, field=field, example=_EXAMPLE, least_rows=LEAST_ROWS, rising="time")
    markers = np.stack([table[name] for name in names], axis=1).reshape(-1, 3, 2)
    phi_1, phi_2 = angles_of_markers(markers * (1, -1 if y_down else 1))
    return Angles(table["time"], phi_1, phi_2)


def _first_line(path: Path | str) -> str:
    """Headings; empty where the file cannot be read, which `read_table` then says."""
    try:
        return plain_bytes(path, LARGEST_TABLE).partition(b"\n")[0].decode("utf-8", errors="replace").lower()
    except UnreadableError:
        return ""
