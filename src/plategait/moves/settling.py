"""How long an object takes to move as it will: from a plate that stands to nine tenths of its mean velocity."""

from __future__ import annotations

import math

import numpy as np

from plategait.simulation.observables import rotation
from plategait.simulation.result import Simulation

SHARE = 0.9
"""Of the mean velocity."""
STILL = 1e-3
"""Speed below which an object stays where it is, m/s."""
_LEAST_WINDOW = 0.1


def settling_time(run: Simulation) -> float:
    """Time at which a run first moves at nine tenths of its mean velocity, turning counted at the object's rim, s.

    Moves are averaged over whole plate periods, at least a tenth of a second. 0 where it stays, the end of the run
    where it never does.
    """
    channels, scenario, observed = run.recordings[0].channels, run.scenario, run.observations[0]
    time, period = channels["time"], scenario.motion.period
    reach = max(scenario.sheet.outline.size()) / 2
    window = period * max(1, math.ceil(_LEAST_WINDOW / period))
    way = np.array([observed["velocity_x"], observed["velocity_y"], reach * observed.spin.rate])
    if np.linalg.norm(way) < STILL:
        return 0.0
    if time[-1] <= window or not np.isfinite(way).all():
        return float(time[-1])
    angle = rotation(channels["spin_cross"], channels["spin_dot"])
    along = np.stack([channels["centre_x"], channels["centre_y"], reach * angle], axis=1) @ (way / np.linalg.norm(way))
    ends = time[time >= window]
    speed = (np.interp(ends, time, along) - np.interp(ends - window, time, along)) / window
    reached = speed >= SHARE * np.linalg.norm(way)
    return float(ends[reached.argmax()] - window / 2) if reached.any() else float(time[-1])
