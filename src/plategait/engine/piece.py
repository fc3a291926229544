"""What runs recorded in one advance: arrays for all of them, a recording for whoever asks for one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array, Flags
from plategait.engine.channels import CHANNELS
from plategait.engine.recording import Recording
from plategait.model.motion import AXES

Counts = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Piece:
    """What n runs recorded in one advance.

    Attributes
    ----------
    samples : (n, most, n_channels) array
        In the order of `CHANNELS`.
    written, first : (n,) int arrays
        How many of them there are, and how many the run had before.
    snapshots : (n, most, n_nodes, 3) array
    thinning, pictured : (n,) int arrays
        Samples between snapshots, 0 for none; how many snapshots there are.
    since_sample, since_time, interval : (n,) arrays
        Sample `i` was taken at ``since_time + (i - since_sample) * interval``, s.
    x, v : (n, n_nodes, 3) arrays
        At the end, m and m/s.
    dt : (n,) array
        s.
    steps : (n,) int array
        Taken.
    stopped : (n,) bool array
        Runs that came to an end because they diverged.
    """

    samples: NDArray[np.floating]
    written: Counts
    first: Counts
    snapshots: NDArray[np.float32]
    thinning: Counts
    pictured: Counts
    since_sample: Counts
    since_time: Array
    interval: Array
    x: Array
    v: Array
    dt: Array
    steps: Counts
    stopped: Flags

    def time(self, j: int) -> Array:
        """Times of a run's samples, s, counted in steps: the core's precision does not reach a long run's end."""
        since = np.arange(self.written[j], dtype=np.float64) + float(self.first[j] - self.since_sample[j])
        return float(self.since_time[j]) + since * float(self.interval[j])

    def recording(self, j: int) -> Recording:
        """Recording of a run."""
        series = self.samples[j, : self.written[j]].astype(np.float64)
        channels = {name: series[:, c] for c, name in enumerate(CHANNELS)}
        channels["time"] = self.time(j)
        pose = np.stack([channels[f"plate_{axis}"] for axis in AXES], axis=1)
        step = max(1, int(self.thinning[j]))
        every = slice(int(-self.first[j] % step), None, step)
        pictured = int(self.pictured[j])
        diverged = self.stopped[j] or not (np.isfinite(series).all() and np.isfinite(self.x[j]).all())
        return Recording(
            channels=channels, snapshot_time=channels["time"][every][:pictured], snapshots=self.snapshots[j, :pictured],
            plate_pose=pose[every][:pictured], positions=self.x[j].copy(), velocities=self.v[j].copy(),
            dt=float(self.dt[j]), steps=int(self.steps[j]), diverged=bool(diverged),
        )  # fmt: skip
