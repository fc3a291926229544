"""Time series of a run on a common time axis, thinned as asked."""

from __future__ import annotations

import difflib
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from plategait import observables
from plategait.engine.recording import Recording
from plategait.errors import InputError

# What is counted since the last sample: amounts add up, shares of the time average.
AMOUNTS = ("joint_loss", "contact_work", "friction_loss", "plate_work")
SHARES = ("left_contact", "right_contact", "flight", "contact")


def known_channels() -> dict[str, tuple[str, str]]:
    """Long name and unit of what can be recorded."""
    from plategait.dataset import _LONG_NAMES

    return {"rotation": ("rotation about the plate's normal", "rad"), **_LONG_NAMES}


def check_channels(names: Sequence[str]) -> None:
    """Refuse names of no channel."""
    known = known_channels()
    for name in names:
        if name not in known:
            close = difflib.get_close_matches(name, known, n=1) or ["rotation"]
            raise InputError("record.channels", name, f"of {', '.join(known)}", f'"{close[0]}"')


def sample_count(duration: float, interval: float) -> int:
    """Samples from the start to the end, both included."""
    return math.floor(duration / interval * (1 + 1e-9)) + 1


def thinned(recording: Recording, name: str, interval: float, count: int) -> NDArray[np.float64]:
    """(count,) values every `interval`, NaN beyond the end of the run.

    What is a state is interpolated. Amounts since the last sample are summed over the interval and shares of the time
    averaged over it, so that no work and no contact is lost between two samples.
    """
    time, at = recording["time"], np.arange(count) * interval
    if name == "rotation":
        series = observables.rotation(recording["spin_cross"], recording["spin_dot"])
    else:
        series = recording[name]
    beyond = at > time[-1] * (1 + 1e-9)
    if name in AMOUNTS or name in SHARES:
        steps = np.diff(time, prepend=0.0) if name in SHARES else np.ones(len(time))
        total = np.interp(at, time, np.cumsum(series * steps))
        values = np.diff(total, prepend=total[0]) / (interval if name in SHARES else 1.0)
        if name in SHARES:
            values[0] = series[0]
    else:
        values = np.interp(at, time, series)
    values[beyond] = math.nan
    return values


def snapshots(recording: Recording, interval: float, count: int) -> tuple[NDArray[np.float64], NDArray[np.float32]]:
    """(count,) times and (count, n_nodes, 3) shapes nearest to every `interval`, NaN beyond the end of the run."""
    at = np.arange(count) * interval
    have = recording.snapshot_time
    nearest = np.abs(have[:, None] - at[None, :]).argmin(axis=0)
    times, shapes = have[nearest].copy(), recording.snapshots[nearest].copy()
    beyond = at > recording["time"][-1] * (1 + 1e-9)
    times[beyond], shapes[beyond] = math.nan, math.nan
    return times, shapes
