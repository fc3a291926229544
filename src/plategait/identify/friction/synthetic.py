"""Tilt and free-vibration recordings made from known numbers, as a camera would see them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from plategait.errors import InputError
from plategait.files.output import whole_file
from plategait.theory.rigid import GRAVITY

_Array = NDArray[np.float64]


def tilt_recording(
    static: float,
    kinetic: float,
    *,
    rate: float = math.radians(2),
    fps: float = 60.0,
    noise: float = 3e-4,
    angle_noise: float = math.radians(0.05),
    rest: float = 4.0,
    travel: float = 0.15,
    creep: float = 0.0,
    seed: int = 0,
) -> tuple[_Array, _Array, _Array]:
    """Record an object on a plate that turns at an even rate until it has slid some way.

    Parameters
    ----------
    static, kinetic : float
        μ_s and μ_k, μ_k at most μ_s.
    rate : float
        Of the plate, rad/s, above 0.
    fps, noise, angle_noise : float
        Frames per second, and the sds of positions (m) and angles (rad).
    rest : float
        Time recorded before the slip, s; less than none where it is to begin in the slide.
    travel : float
        Length of the slide until the object is stopped, m. It is recorded for half a second more.
    creep : float
        Speed before the slip, m/s.
    seed : int
        Of the noise, and of where the slip falls between two frames.

    Returns
    -------
    time, angle, position : (n,) arrays
        s, rad and m.
    """
    if not 0 <= kinetic <= static or min(rate, fps, travel) <= 0:
        raise InputError(
            "kinetic, static", (kinetic, static), "at least 0 and rising, on a plate that turns", "0.4, 0.75"
        )
    generator = np.random.default_rng(seed)
    alpha = math.atan(static)
    # From t_s on the acceleration only grows: enough time for the whole slide.
    after = np.arange(0.0, 20.0, 0.25 / fps)
    slid = slide_length(after, alpha, rate, kinetic) + creep * after
    end = float(after[min(int(np.searchsorted(slid, travel)), len(after) - 1)]) + 0.5
    time = np.arange(-rest + generator.uniform(0, 1 / fps), end, 1 / fps)
    angle = alpha + rate * time
    position = np.minimum(slide_length(np.maximum(time, 0), alpha, rate, kinetic) + creep * time, travel)
    return (
        time - time[0],
        angle + angle_noise * generator.normal(size=len(time)),
        position + noise * generator.normal(size=len(time)),
    )


def slide_length(since: _Array, alpha: float, rate: float, kinetic: float) -> _Array:
    """Length of a slide that begins at rest at the angle α on a plate turning at an even rate, m.

    s'' = g (sin θ - μ_k cos θ) with θ = α + Ω t, integrated twice.
    """
    theta, turned = alpha + rate * since, rate * since
    sine = math.sin(alpha) + turned * math.cos(alpha) - np.sin(theta)
    cosine = math.cos(alpha) - turned * math.sin(alpha) - np.cos(theta)
    return GRAVITY * (sine - kinetic * cosine) / rate**2


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
) -> tuple[_Array, _Array]:
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


def write_tilt(path: Path | str, time: _Array, angle: _Array, position: _Array) -> None:
    """Write a tilt as CSV, in s, deg and mm."""
    _write(path, "time_s,angle_deg,position_mm", np.stack([time, np.degrees(angle), 1e3 * position], axis=1))


def write_ring(path: Path | str, time: _Array, deflection: _Array) -> None:
    """Write a ring as CSV, in s and mm."""
    _write(path, "time_s,deflection_mm", np.stack([time, 1e3 * deflection], axis=1))


def _write(path: Path | str, heading: str, rows: _Array) -> None:
    with whole_file(path, (".csv",)) as temporary:
        np.savetxt(temporary, rows, fmt="%.9g", delimiter=",", header=heading, comments="")
