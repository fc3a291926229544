"""Recordings of tilts made from known numbers, as a camera would see them."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.identify.series import write_recording
from plategait.theory.rigid import GRAVITY


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
) -> tuple[Array, Array, Array]:
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
    end = _end_of_slide(alpha, rate, kinetic, creep, travel, 0.25 / fps) + 0.5
    time = np.arange(-rest + generator.uniform(0, 1 / fps), end, 1 / fps)
    position = np.minimum(slide_length(np.maximum(time, 0), alpha, rate, kinetic) + creep * time, travel)
    return (
        time - time[0],
        alpha + rate * time + angle_noise * generator.normal(size=len(time)),
        position + noise * generator.normal(size=len(time)),
    )


def _end_of_slide(alpha: float, rate: float, kinetic: float, creep: float, travel: float, step: float) -> float:
    """Time after the slip at which the object has slid some way, s, to a step."""
    # From t_s on the acceleration only grows: enough time for the whole slide.
    after = np.arange(0.0, 20.0, step)
    length = slide_length(after, alpha, rate, kinetic) + creep * after
    return float(after[min(int(np.searchsorted(length, travel)), len(after) - 1)])


def slide_length(since: Array, alpha: float, rate: float, kinetic: float) -> Array:
    """Length of a slide that begins at rest at the angle α on a plate turning at an even rate, m.

    s'' = g (sin θ - μ_k cos θ) with θ = α + Ω t, integrated twice.
    """
    theta, turned = alpha + rate * since, rate * since
    sine = math.sin(alpha) + turned * math.cos(alpha) - np.sin(theta)
    cosine = math.cos(alpha) - turned * math.sin(alpha) - np.cos(theta)
    return GRAVITY * (sine - kinetic * cosine) / rate**2


def write_tilt(path: Path | str, time: Array, angle: Array, position: Array) -> None:
    """Write a tilt as CSV, in s, deg and mm."""
    write_recording(path, ["time_s", "angle_deg", "position_mm"], [time, np.degrees(angle), 1e3 * position])
