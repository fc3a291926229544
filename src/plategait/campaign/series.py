"""Time series of a run on a common time axis, thinned as asked."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from plategait.engine.channels import ROTATION, SERIES
from plategait.engine.recording import Recording
from plategait.simulation import observables


def sample_count(duration: float, interval: float) -> int:
    """Samples from the start to the end, both included."""
    return math.floor(duration / interval * (1 + 1e-9)) + 1


def thinned(recording: Recording, name: str, interval: float, count: int) -> NDArray[np.float64]:
    """(count,) values every `interval`, NaN beyond the end of the run.

    What is a state is interpolated. Amounts since the last sample are summed over the interval and shares of the time
    averaged over it, so that no work and no contact is lost between two samples.
    """
    time, at = recording["time"], np.arange(count) * interval
    if name == ROTATION.name:
        series = observables.rotation(recording["spin_cross"], recording["spin_dot"])
    else:
        series = recording[name]
    beyond = at > time[-1] * (1 + 1e-9)
    kind = SERIES[name].kind
    if kind == "state":
        values = np.interp(at, time, series)
    else:
        steps = np.diff(time, prepend=0.0) if kind == "share" else np.ones(len(time))
        total = np.interp(at, time, np.cumsum(series * steps))
        values = np.diff(total, prepend=total[0]) / (interval if kind == "share" else 1.0)
        if kind == "share":
            values[0] = series[0]
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
