"""Free-vibration recordings made from known numbers, as a camera would see them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from plategait.arrays import Array
from plategait.identify.series import write_recording


def ring_recording(
    frequencies: Sequence[float],
    damping_ratios: Sequence[float],
    *,
    amplitudes: Sequence[float] = (5e-3,),
    rate: float = 400.0,
    duration: float = 2.0,
    noise: float = 5e-5,
    offset: float = 0.01,
    drift: float = 0.0,
    seed: int = 0,
) -> tuple[Array, Array]:
    """Record a strip or sheet that rings freely after it was let go.

    Parameters
    ----------
    frequencies, damping_ratios, amplitudes : sequences of float
        Undamped natural frequencies (Hz), ζ in [0, 1) and amplitudes (m) of the modes.
    rate, duration : float
        Rows per second, and s.
    noise, offset, drift : float
        Sd of a row (m), static deflection (m), and how fast that settles (m/s).
    seed : int
        Of the noise and the phases.

    Returns
    -------
    time, deflection : (n,) arrays
        s and m.
    """
    generator = np.random.default_rng(seed)
    time = np.arange(0.0, duration, 1 / rate)
    signal = offset + drift * time
    for f, zeta, amplitude in zip(frequencies, damping_ratios, amplitudes, strict=True):
        omega, phase = 2 * math.pi * f, generator.uniform(-0.5, 0.5)
        signal += amplitude * np.exp(-zeta * omega * time) * np.cos(omega * math.sqrt(1 - zeta**2) * time + phase)
    return time, signal + noise * generator.normal(size=len(time))


def write_ring(path: Path | str, time: Array, deflection: Array) -> None:
    """Write a ring as CSV, in s and mm."""
    write_recording(path, ["time_s", "deflection_mm"], [time, 1e3 * deflection])
