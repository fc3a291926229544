"""Trajectories as CSV: time, then position, speed and acceleration of each degree of freedom that moves."""

from __future__ import annotations

import io
import math
from pathlib import Path

import numpy as np

from plategait.errors import check_kind
from plategait.export.trajectory import Trajectory
from plategait.files.output import write_whole

SUFFIXES = (".csv",)
# Enough digits that differences between rows of a millisecond still tell accelerations.
_FORMAT = "%.12g"


def write_trajectory(trajectory: Trajectory, path: Path | str, field: str = "output") -> None:
    """Write a trajectory as CSV: `time_s`, then `x_mm`, `x_mm_s`, `x_mm_s2`, or `rx_deg`, `rx_deg_s`, `rx_deg_s2`, ….

    `motion.samples` reads such a file back: it takes the positions.

    Parameters
    ----------
    trajectory : Trajectory
    path : Path or str
        Of the file, which ends in .csv.
    field : str
        What errors call it.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    check_kind(trajectory, Trajectory, "trajectory", "trajectory(scenario.motion)")
    names, columns = ["time_s"], [trajectory.time]
    for axis in trajectory.axes:
        unit, scale = ("deg", math.degrees(1)) if axis.startswith("r") else ("mm", 1e3)
        names += [f"{axis}_{unit}", f"{axis}_{unit}_s", f"{axis}_{unit}_s2"]
        columns += list(scale * trajectory.of(axis))
    text = io.StringIO()
    np.savetxt(text, np.stack(columns, axis=1), fmt=_FORMAT, delimiter=",", header=",".join(names), comments="")
    write_whole(text.getvalue().encode(), path, SUFFIXES, field)
