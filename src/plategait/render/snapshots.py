"""The snapshots of a recording, and the shapes between them."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from plategait.arrays import Array, Flags
from plategait.engine.recording import Recording
from plategait.errors import InputError
from plategait.model.scenario import Scenario
from plategait.simulation.observables import Failure

# Fewest snapshots in a plate period that can be drawn between.
SNAPSHOTS_PER_PERIOD = 8


@dataclass(frozen=True, eq=False)
class Snapshots:
    """The snapshots of a recording that are finite, and what lies between them.

    Attributes
    ----------
    time : (n,) array
        s.
    nodes : (n, n_nodes, 3) array
        In the world frame, m.
    pose : (n, 6) array
        Of the plate, m and rad.
    """

    time: Array
    nodes: Array
    pose: Array

    @classmethod
    def of(cls, scenario: Scenario, recording: Recording, frame_interval: float) -> Snapshots:
        """Take the snapshots up to where the motion ceased to be finite.

        Raises
        ------
        InputError
            Where there are none, or fewer than one in a frame interval, s, or eight in a plate period.
        """
        finite: Flags = np.isfinite(recording.snapshots.sum(axis=(1, 2)))
        last = len(finite) if finite.all() else int(np.argmin(finite))
        period, time = scenario.motion.period, recording.snapshot_time[:last]
        advice = f"simulate(scenario, snapshot_interval={period / 24:.2g})"
        if last == 0:
            raise InputError("recording", "nothing to draw, no snapshots", "a recording with snapshots", advice)
        coarsest = max(period / SNAPSHOTS_PER_PERIOD, frame_interval)
        if last > 1 and (interval := float(np.diff(time).max())) > coarsest * 1.01:
            raise InputError(
                "recording", f"a snapshot every {interval:.2g} s", f"one with a snapshot every {coarsest:.2g} s", advice
            )
        return cls(time, recording.snapshots[:last].astype(float), recording.plate_pose[:last])

    def end(self, failure: Failure | None, until: float | None, fall: float = 0.0) -> float:
        """Time to stop at, s: as asked, or the failure (`fall` after it left the plate), or the last snapshot."""
        if until is None:
            until = math.inf if failure is None else failure.time + (fall if failure.kind == "left the plate" else 0.0)
        elif not until > self.time[0]:
            raise InputError("until", until, "a time after the first snapshot, s", f"{self.time[-1]:g}")
        return min(float(self.time[-1]), until)

    def at(self, time: ArrayLike) -> tuple[Array, Array]:
        """Nodes and plate pose at a time, or at several."""
        place = np.interp(np.asarray(time, dtype=float), self.time, np.arange(len(self.time)))
        before = np.minimum(place.astype(int), max(0, len(self.time) - 2))
        after, share = np.minimum(before + 1, len(self.time) - 1), place - before
        nodes = self.nodes[before] + share[..., None, None] * (self.nodes[after] - self.nodes[before])
        return nodes, self.pose[before] + share[..., None] * (self.pose[after] - self.pose[before])
