"""When a clip's frames were taken: its frame rate, missing frames, and stamps that a file has rounded.

Files keep times in ticks, some of a millisecond: 30 frames per second are then 33, 33 and 34 ms apart. That is rounding
and not an uneven camera, and the rate is the mean over all frames, those that are missing included, not the usual
interval.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array

# Ticks that files round stamps to, s, and how near to their multiples rounded stamps lie, ticks.
TICKS, ON_A_TICK = (0.01, 0.001), 0.02
# Even stamps that were rounded lie within this share of a tick of where they would be.
ROUNDED = 0.75
# Scatter about even times, as a share of the interval, above which frames come unevenly.
UNEVEN = 0.02
# Scatter of the intervals, as a share of one, that is worth a note.
VARYING = 0.1
# An interval this many times the usual one holds frames that are missing.
MISSING = 1.5


@dataclass(frozen=True, eq=False)
class Stamps:
    """When the frames of a clip were taken.

    Attributes
    ----------
    time : (n,) array
        s from the first frame: as the file has it, but where it only rounded even times.
    fps : float
        Frames per second, missing ones counted; NaN for a single frame.
    even : bool
        Whether frames come at one rate: then a swing of the plate looks like others of its aliases.
    missing : int
        Frames that are missing by the gaps.
    varies : bool
        Whether the frame rate varies visibly.
    """

    time: Array
    fps: float
    even: bool
    missing: int
    varies: bool

    @property
    def notes(self) -> list[str]:
        """What to know of them."""
        said = [f"frames missing by their times: {self.missing}"] if self.missing else []
        return [*said, "the frame rate varies"] if self.varies else said


def stamps_of(time: Array) -> Stamps:
    """Frame rate and evenness of frames by their times (n,), s."""
    intervals = np.diff(time)
    if len(intervals) == 0:
        return Stamps(time, math.nan, True, 0, False)
    usual = float(np.median(intervals))
    frames = np.ones(len(intervals))
    for _ in range(3):  # a better interval counts long gaps better
        frames = np.maximum(np.round(intervals / usual), 1)
        usual = float(intervals.sum() / frames.sum())
    near = intervals < MISSING * usual
    number = np.concatenate([[0.0], np.cumsum(frames)])
    slope, start = np.polyfit(number, time, 1)
    off = time - (start + slope * number)
    rounded = any(_on_ticks(time, tick) and float(np.abs(off).max()) <= ROUNDED * tick for tick in TICKS)
    even = rounded or float(np.std(off)) <= UNEVEN * usual
    varies = not rounded and bool(near.any()) and float(np.std(intervals[near])) > VARYING * usual
    taken = slope * number if rounded else time
    return Stamps(taken, 1 / usual, even, int(frames.sum()) - len(frames), varies)


def _on_ticks(time: Array, tick: float) -> bool:
    """Whether all times are whole numbers of ticks."""
    ticks = time / tick
    return bool(np.all(np.abs(ticks - np.round(ticks)) <= ON_A_TICK))
