"""Pieces of one run's recording, put together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from plategait.arrays import Array
from plategait.engine.channels import CHANNELS
from plategait.engine.recording import Recording


def joined(pieces: Sequence[Recording], channels: Mapping[str, Array] | None = None) -> Recording:
    """One recording of pieces that follow each other.

    What adds up counts from its first sample on: what happened before that is not part of it.

    Parameters
    ----------
    pieces : sequence of Recording
        One at least.
    channels : mapping, optional
        To take instead of the pieces' own.
    """
    whole = dict(channels) if channels else {n: np.concatenate([p[n] for p in pieces]) for n in CHANNELS}
    for name, channel in CHANNELS.items():
        if channel.kind == "amount":
            whole[name] = np.concatenate([np.zeros(1), whole[name][1:]])
    return replace(
        pieces[-1],
        channels=whole,
        snapshot_time=np.concatenate([p.snapshot_time for p in pieces]),
        snapshots=np.concatenate([p.snapshots for p in pieces]),
        plate_pose=np.concatenate([p.plate_pose for p in pieces]),
        steps=sum(p.steps for p in pieces),
        diverged=any(p.diverged for p in pieces),
    )
