"""Recordings of the source's cheese as a bench would give them, one of each kind, from Table 4.1's values."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from plategait.identify.bending.synthetic import cantilever_recording
from plategait.identify.compression.synthetic import press_recording
from plategait.identify.friction.synthetic import tilt_recording, write_tilt
from plategait.identify.modes.synthetic import ring_recording, write_ring
from plategait.units import parse

K_B, C_B = parse("2.72e-3 N*mm/deg", "N*m/rad"), parse("4.23e-6 N*mm/(deg/s)", "N*m*s/rad")
K_S, C_S = parse("12.64 N/mm", "N/m"), parse("7.9e-3 N/(mm/s)", "N*s/m")
MU_S, MU_K = 0.75, 0.40
# ω_n of a slice of cheese by the source, as a frequency, and a damping ratio usual for food.
RING_HZ, RING_RATIO = 5.0, 0.05


def write_bending(path: Path, seed: int) -> None:
    """Markers of a strip that is let go, filmed at 480 fps (section 3.3.2)."""
    cantilever_recording(K_B, C_B, seed=seed).write_markers(path)


def write_compression(path: Path, seed: int) -> None:
    """Displacement and force of a press, 1 kHz, ten rows (section 3.3.2)."""
    press_recording(K_S, C_S, seed=seed).write(path)


def write_friction(path: Path, seed: int) -> None:
    """A plate that is slowly tilted until the cheese slides (section 5.6.2)."""
    write_tilt(path, *tilt_recording(MU_S, MU_K, seed=seed))


def write_modes(path: Path, seed: int) -> None:
    """The rim of a hanging slice after it was plucked."""
    write_ring(path, *ring_recording((RING_HZ,), (RING_RATIO,), seed=seed))


WRITERS: dict[str, Callable[[Path, int], None]] = {
    "bending": write_bending,
    "compression": write_compression,
    "friction": write_friction,
    "modes": write_modes,
}
