"""Recordings made from known truth, as a camera and a load cell would give them: to try a rig before it is built."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from plategait.files.output import whole_file
from plategait.identify.bending.recording import Angles, angles_of_markers
from plategait.theory.two_links import Joints, Strip, between, fastest_rates, integrate, two_link_rate

Array = NDArray[np.float64]

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
        _write(path, heading, [self.time, *(1e3 * self.markers.reshape(-1, 6)).T])

    def write_angles(self, path: Path | str) -> None:
        """Write the joint angles, in degrees."""
        angles = self.angles
        _write(path, ["time_s", "phi1_deg", "phi2_deg"], [angles.time, angles.phi_1 / _DEG, angles.phi_2 / _DEG])


@dataclass(frozen=True, eq=False)
class Press:
    """A pressed link: time (s), displacement (m) and force (N), each (n,)."""

    time: Array
    displacement: Array
    force: Array

    def write(self, path: Path | str) -> None:
        """Write it, in mm and N."""
        _write(path, ["time_s", "displacement_mm", "force_N"], [self.time, 1e3 * self.displacement, self.force])


def strip_angles(
    strip: Strip, joints: Joints, time: Array, start: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
) -> Array:
    """Angles (n, 2) of the two links at `time` (from 0, s) after a release from `start` (φ1, φ2, φ1', φ2')."""
    # Errors of 1e-7 of the motion, far under any camera's; of what has decayed after a row or two, a little more.
    omega, decay = fastest_rates(strip, joints)
    step = min(0.05 / omega, 0.5 / max(decay, omega))
    steps = max(int(np.ceil(time[-1] / step)), 1)
    states = integrate(two_link_rate(strip, joints), np.array(start)[:, None], time[-1] / steps, steps)
    return between(states, time[-1] / steps, time)[:, :, 0]


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
    seen = places.reshape(rows, _EXPOSURES, 3, 2).mean(axis=1)
    seen = seen + jitter * np.random.default_rng(seed).normal(size=seen.shape)
    return Cantilever(frames + exposure / 2, _rounded(seen, pixel))


def press_recording(
    k_s: float,
    c_s: float,
    *,
    depth: float = 1e-4,
    duration: float = 0.01,
    rows: int = 10,
    encoder: float = 1e-6,
    force_noise: float = 0.01,
    touch: float = 0.0,
    preload: float = 0.0,
    seed: int = 0,
) -> Press:
    """Press a link as in section 3.3.2: the jaw closes along half a cosine.

    Parameters
    ----------
    k_s, c_s : float
        Of the upper surface, N/m and N s/m.
    depth, duration : float
        Closed to at the end, m, and after this time, s.
    rows : int
        Samples, the first at the start.
    encoder : float
        Displacement is rounded to multiples of this, m; 0 leaves it.
    force_noise : float
        Standard deviation of the load cell, N.
    touch, preload : float
        Encoder's reading (m) and load cell's (N) where the jaw just touches.
    seed : int
    """
    time = np.linspace(0, duration, rows)
    s = depth * 0.5 * (1 - np.cos(np.pi * time / duration))
    speed = depth * 0.5 * np.pi / duration * np.sin(np.pi * time / duration)
    force = c_s * speed + k_s * s + preload + force_noise * np.random.default_rng(seed).normal(size=rows)
    return Press(time, _rounded(s + touch, encoder), force)


def _rounded(values: Array, step: float) -> Array:
    return np.round(values / step) * step if step else values


def _write(path: Path | str, heading: list[str], columns: list[Array]) -> None:
    with whole_file(path, (".csv",), "recording") as temporary:
        np.savetxt(
            temporary, np.column_stack(columns), fmt="%.10g", delimiter=",", header=",".join(heading), comments=""
        )
