"""Memory: what runs will need and what there is, weighed before anything is allocated."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from plategait.engine.recording import RunRequest
from plategait.engine.trajectories import KNOT_BYTES, table_bytes
from plategait.errors import InputError
from plategait.memory import available_memory

# A batch is held to this much recording, and to no fewer runs than fill the lanes of a few blocks.
_LARGEST_RECORDING, _SMALLEST_BATCH = 256 << 20, 64
# Series in double precision, and the copies that measuring and writing them take; shapes likewise, in single precision.
_COPIES, _PICTURE_COPIES = 2, 3
_GB = 1e9
# A piece of a session that is smaller asks for nothing: looking takes longer than some pieces.
_ALWAYS_THERE = 32 << 20


def batch_size(samples: int, sample_bytes: int) -> int:
    """Runs of so many samples that are advanced together."""
    return max(_SMALLEST_BATCH, _SMALLEST_BATCH * int(_LARGEST_RECORDING / (_SMALLEST_BATCH * sample_bytes * samples)))


def check_memory(runs: Sequence[RunRequest], sample_bytes: int, channels: int) -> None:
    """Refuse runs whose recordings would not fit in memory.

    Parameters
    ----------
    runs : sequence of RunRequest
        All that are kept at once.
    sample_bytes : int
        Of a sample while runs are advanced.
    channels : int
        Numbers in a sample.

    Raises
    ------
    InputError
        When what they need is more than there is: it names the duration, or the runs where they are many, and what
        fits.
    """
    # The runs of an ensemble are alike.
    alike = {(id(r.scenario), r.snapshot_interval, id(r.held)): r for r in runs}
    count = Counter((id(r.scenario), r.snapshot_interval, id(r.held)) for r in runs)
    needed, there, n = table_bytes(alike.values()), available_memory(), len(runs)
    needed += sum(count[key] * _recording_bytes(r, channels) for key, r in alike.items())
    needed += max(
        (min(n, batch_size(r.samples, sample_bytes)) * _running_bytes(r, sample_bytes) for r in alike.values()),
        default=0.0,
    )
    if needed <= there:
        return
    share, longest = 0.5 * there / needed, max(r.scenario.duration for r in runs)
    rule = f"for the {there / _GB:.3g} GB of memory that there are, where {needed / _GB:.3g} GB are needed"
    if share * n >= 1 and n > 1:
        raise InputError("runs", f"{n} of up to {longest:g} s", f"few enough {rule}", f"{int(share * n)} at a time")
    samples, nodes = max(r.samples for r in alike.values()), max(r.lattice.n_nodes for r in alike.values())
    if samples < nodes:
        raise InputError("sheet.pitch", f"{nodes} nodes", f"coarse enough {rule}", "twice the pitch")
    raise InputError("duration", f"{longest:g} s", f"short enough {rule}", f'"{share * longest:.2g} s"')


def _recording_bytes(run: RunRequest, channels: int) -> float:
    pictures = _PICTURE_COPIES * run.pictures * (12 * run.lattice.n_nodes + 56)
    return 8.0 * _COPIES * channels * run.samples + pictures + 96 * run.lattice.n_nodes


def _running_bytes(run: RunRequest, sample_bytes: int) -> float:
    return sample_bytes * run.samples + 12.0 * run.lattice.n_nodes * (run.pictures + 16)


def check_room(samples: NDArray[np.int64], channels: int, precision: str, knots: float) -> None:
    """Refuse to advance a batch whose samples, or tables of sampled trajectories, would not fit in memory.

    Parameters
    ----------
    samples : (n,) int array
        That each run will take.
    channels : int
        Numbers in a sample.
    precision : {"float32", "float64"}
    knots : float
        That its trajectories need at most.

    Raises
    ------
    InputError
    """
    needed = float(np.dtype(precision).itemsize * channels * len(samples) * int(samples.max()))
    needed += KNOT_BYTES * knots
    if needed < _ALWAYS_THERE or needed <= (there := available_memory()):
        return
    raise InputError("duration", f"{needed / _GB:.3g} GB of samples", f"within the {there / _GB:.3g} GB that there are",
                     "to advance in shorter pieces")  # fmt: skip
