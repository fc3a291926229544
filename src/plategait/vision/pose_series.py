"""The poses of a clip as series, and the spin rate that they give once parallax and outliers are out of them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array, Flags
from plategait.vision.departure import Departure
from plategait.vision.object.parallax import rim_parallax
from plategait.vision.object.pose import Pose
from plategait.vision.object.rim import RAYS
from plategait.vision.spin import Spin, outliers, spin_of, unwrapped

# Parallax smaller than this is not worth a note, deg.
NOTED_TURN = 0.5
# Turns from which on the lift of a rim marker and the object's turning are told apart.
WHOLE_TURN = 1.0


@dataclass(eq=False)
class PoseSeries:
    """An object's pose in each frame of a clip, as one method sees it.

    Attributes
    ----------
    time, x, y : (n,) arrays
        s, and the object's middle in plate coordinates, m; NaN where it was not seen.
    angle : (n,) array
        Orientation, rad; NaN where it was not seen.
    spacing : (n,) array
        Distance of the two markers, m; NaN without.
    reason : list of str
        Of each frame, why it is uncertain; empty where it is sure.
    rim : (n, RAYS) array
        Distances of the edge from the middle, m; NaN where it was not seen.
    """

    time: Array
    x: Array
    y: Array
    angle: Array
    spacing: Array
    reason: list[str]
    rim: Array

    @classmethod
    def of(cls, time: Array, poses: Sequence[Pose], repeated: Flags) -> PoseSeries:
        """Poses as arrays; frames that repeat a picture are not sure."""
        x, y, angle, spacing = (np.array([getattr(p, k) for p in poses]) for k in ("x", "y", "angle", "spacing"))
        reason = [p.reason or ("repeated picture" if again else "") for p, again in zip(poses, repeated, strict=True)]
        rim = np.array([np.full(RAYS, math.nan) if p.rim is None else p.rim for p in poses])
        return cls(time, x, y, angle, spacing, reason, rim)

    @property
    def seen(self) -> Array:
        """(n, 2) the object's middle in plate coordinates, m; NaN where it was not seen."""
        return np.stack([self.x, self.y], axis=1)

    @property
    def sure(self) -> Flags:
        """(n,) whether the orientation of a frame is sure."""
        return np.array([not r for r in self.reason]) & np.isfinite(self.angle)

    def leave(self, departure: Departure) -> None:
        """Use no frame after the object slipped or left."""
        for k in np.nonzero(self.time > departure.time)[0]:
            self.reason[k] = self.reason[k] or f"after it {departure.kind}"

    def spin(self, symmetry: int, fps: float, swing: float | None, eye: Array | None, notes: list[str]) -> Spin:
        """Spin rate; where there is one, the sure angles become one line, free of parallax, and outliers uncertain.

        Parameters
        ----------
        symmetry : int
            Turns of a full circle over this look the same.
        fps, swing : float
            Frames per second, and the plate's frequency, Hz, where known.
        eye : (n, 3) array, optional
            Of the camera in the plate's frame, m: where markers may be freed of parallax.
        notes : list of str
            Gets what there is to know.
        """
        spin = spin_of(self.time, self.angle, self.sure, symmetry=symmetry, fps=fps, plate_frequency=swing)
        if not math.isfinite(spin.rate):
            return spin
        part = self._unwrap(spin.rate, symmetry)
        if eye is not None and swing is not None:
            self._remove_parallax(eye, swing, notes)
        sure = self.sure
        for k in np.nonzero(sure)[0][outliers(self.time[sure], self.angle[sure], part, swing, fps)]:
            self.reason[k] = "out of line with the frames around it"
        freed = spin_of(self.time, self.angle, self.sure, symmetry=symmetry, fps=fps, plate_frequency=swing)
        turns = abs(freed.rate) * float(np.ptp(self.time[sure])) / (2 * math.pi)
        if not turns < WHOLE_TURN:
            return freed
        # Over a part of a turn a lift of the rim looks much like a turn: either rate may be right.
        doubt = abs(freed.rate - spin.rate)
        return replace(freed, low=freed.low - doubt, high=freed.high + doubt)

    def _unwrap(self, rate: float, symmetry: int) -> NDArray[np.intp]:
        """Join the sure angles over whole turns; gives the part that each belongs to."""
        sure = self.sure
        line, part = unwrapped(self.time[sure], symmetry * self.angle[sure], symmetry * rate)
        self.angle = self.angle.copy()
        self.angle[sure] = line / symmetry
        return part

    def _remove_parallax(self, eye: Array, swing: float, notes: list[str]) -> None:
        """Take out of the angles what bending lifts the rim marker by."""
        sure, place = self.sure, np.stack([self.x, self.y], axis=1)
        parallax = rim_parallax(self.time[sure], self.angle[sure], self.spacing[sure], place[sure], eye[sure], swing)
        if parallax is None:
            return
        self.angle[sure] -= parallax.turn
        most = math.degrees(float(np.abs(parallax.turn).max()))
        if most > NOTED_TURN:
            notes.append(f"angles are freed of the parallax of bending, up to {most:.1f} deg")
