"""Recordings of a pressed link made from known truth, to try a rig before it is built."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from plategait.arrays import Array
from plategait.identify.series import rounded, write_recording


@dataclass(frozen=True, eq=False)
class Press:
    """A pressed link: time (s), displacement (m) and force (N), each (n,)."""

    time: Array
    displacement: Array
    force: Array

    def write(self, path: Path | str) -> None:
        """Write it, in mm and N."""
        write_recording(
            path, ["time_s", "displacement_mm", "force_N"], [self.time, 1e3 * self.displacement, self.force]
        )


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
    return Press(time, rounded(s + touch, encoder), force)
