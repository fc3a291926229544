"""What a session costs: 64 runs in one long batch, in pieces of 1/60 s, and with every motion changed in each piece."""

from __future__ import annotations

import time
from collections.abc import Sequence

from plategait.model.motion import PlateMotion
from plategait.model.scenario import Scenario
from plategait.simulation.session import Session

PIECE = 1 / 60
TARGET = 0.8  # of one long batch's throughput, in pieces with the motions going on


def in_pieces(scenarios: Sequence[Scenario], pieces: int, duration: float, change: float = 1.0) -> float:
    """Simulated seconds per second of wall time; each amplitude is changed by a factor and back from piece to piece."""
    ours = [scenario.motion for scenario in scenarios]
    others: list[PlateMotion] = [motion.replace(angle=change * motion.angle) for motion in ours]
    session = Session(scenarios)
    begun = time.perf_counter()
    for i in range(pieces):
        session.advance(others if i % 2 else ours, duration)
    return len(scenarios) * pieces * duration / (time.perf_counter() - begun)


def ways(scenarios: Sequence[Scenario], seconds: float = 4.0) -> dict[str, float]:
    """Throughput of each way, taken once."""
    pieces = round(seconds / PIECE)
    return {
        "one long batch": in_pieces(scenarios, 1, seconds),
        "pieces of 1/60 s": in_pieces(scenarios, pieces, PIECE),
        "pieces of 1/60 s, every motion changed in each": in_pieces(scenarios, pieces, PIECE, 1.2),
    }
