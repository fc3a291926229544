"""Recordings of a bending strip made from known truth, as a camera would give them: to try a rig before it is built."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from plategait.arrays import Array
from plategait.identify.series import rounded, write_recording
from plategait.theory.two_links import (
    Angles,
    Joints,
    Strip,
    angles_of_markers,
    strip_angles,
)

_DEG = np.pi / 180
_EXPOSURES = 5  # moments averaged over within one exposure


@dataclass(frozen=True, eq=False)
class Cantilever:
    """A filmed strip.

    Parameters
    ----------
    time : (n,) array
        Middle of each exposure, s after the release.
    markers : (n, 3, 2) array
        x and y, upwards, of the markers at wall, joint and tip, m.
    """

    time: Array
    markers: Array

    @property
    def angles(self) -> Angles:
        """Joint angles that the markers show."""
        return Angles(self.time, *angles_of_markers(self.markers))

    def write_markers(self, path: Path | str) -> None:
        """Write the markers, in mm."""
        heading = ["time_s", *(f"{axis}{i}_mm" for i in range(3) for axis in "xy")]
        write_recording(path, heading, [self.time, *(1e3 * self.markers.reshape(-1, 6)).T])

    def write_angles(self, path: Path | str) -> None:
        """Write the joint angles, in degrees."""
        angles = self.angles
        write_recording(
            path, ["time_s", "phi1_deg", "phi2_deg"], [angles.time, angles.phi_1 / _DEG, angles.phi_2 / _DEG]
        )


def cantilever_recording(
    k_b: float,
    c_b: float,
    *,
    strip: Strip | None = None,
    k_1: float | None = None,
    c_1: float | None = None,
    rows: int = 97,
    fps: float = 480.0,
    jitter: float = 5e-5,
    pixel: float = 0.0,
    exposure: float = 1e-3,
    seed: int = 0,
) -> Cantilever:
    """Film a strip that is released from the horizontal, as in section 3.3.2.

    Parameters
    ----------
    k_b, c_b : float
        Joint 2, N m/rad and N m s/rad.
    strip : Strip, optional
        One link; that of section 3.3.2 by default.
    k_1, c_1 : float, optional
        Joint 1, at the wall; as joint 2 if left out.
    rows, fps : int, float
        Pictures, and pictures per second.
    jitter : float
        Standard deviation of each coordinate of a marker, m.
    pixel : float
        Coordinates are rounded to multiples of this, m; 0 leaves them.
    exposure : float
        Time over which a picture averages, s.
    seed : int
    """
    strip, joints = strip or Strip(), Joints(k_b, c_b, k_1, c_1)
    frames = np.arange(rows) / fps
    moments = (np.arange(_EXPOSURES) + 0.5) / _EXPOSURES * exposure
    phi = strip_angles(strip, joints, (frames[:, None] + moments).ravel())
    below = np.stack([phi[:, 0], phi[:, 0] + phi[:, 1]], axis=1)
    links = strip.length * np.stack([np.cos(below), -np.sin(below)], axis=2)
    places = np.concatenate([np.zeros((len(links), 1, 2)), np.cumsum(links, axis=1)], axis=1)
    markers = places.reshape(rows, _EXPOSURES, 3, 2).mean(axis=1)
    markers = markers + jitter * np.random.default_rng(seed).normal(size=markers.shape)
    return Cantilever(frames + exposure / 2, rounded(markers, pixel))
