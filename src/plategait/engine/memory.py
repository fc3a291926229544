"""Memory: what runs will need and what there is, weighed before anything is allocated."""

from __future__ import annotations

import math
import os
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from plategait.engine.recording import Run
from plategait.engine.trajectories import table_bytes
from plategait.errors import InputError

# A batch is held to this much recording, and to no fewer runs than fill the lanes of a few blocks.
_LARGEST_RECORDING, _SMALLEST_BATCH = 256 << 20, 64
# Series in double precision, and the copies that measuring and writing them take; shapes likewise, in single precision.
_COPIES, _PICTURE_COPIES = 2, 3
_GB = 1e9


def batch_size(samples: int, sample_bytes: int) -> int:
    """Runs of so many samples that are advanced together."""
    return max(_SMALLEST_BATCH, _SMALLEST_BATCH * int(_LARGEST_RECORDING / (_SMALLEST_BATCH * sample_bytes * samples)))


def check_memory(runs: Sequence[Run], sample_bytes: int, channels: int) -> None:
    """Refuse runs whose recordings would not fit in memory.

    Parameters
    ----------
    runs : sequence of Run
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


def _recording_bytes(run: Run, channels: int) -> float:
    pictures = _PICTURE_COPIES * run.pictures * (12 * run.lattice.n_nodes + 56)
    return 8.0 * _COPIES * channels * run.samples + pictures + 96 * run.lattice.n_nodes


def _running_bytes(run: Run, sample_bytes: int) -> float:
    return sample_bytes * run.samples + 12.0 * run.lattice.n_nodes * (run.pictures + 8)


def available_memory() -> float:
    """Bytes that this process may still take: what the system, its control group and its own limits leave.

    Infinite where none of them says.
    """
    return max(0.0, min([*_left_by_system(), *_left_by_limits(), *_left_by_control_groups()], default=math.inf))


def _read(path: Path | str) -> str:
    try:
        return Path(path).read_text(encoding="ascii", errors="replace")
    except OSError:
        return ""


def _left_by_system() -> Iterator[float]:
    for line in _read("/proc/meminfo").splitlines():
        if line.startswith("MemAvailable:"):
            yield 1024.0 * int(line.split()[1])


def _left_by_limits() -> Iterator[float]:
    try:
        import resource
    except ImportError:  # not on Windows
        return
    limit, _ = resource.getrlimit(resource.RLIMIT_AS)
    pages = _read("/proc/self/statm").split()
    if limit != resource.RLIM_INFINITY and pages:
        yield float(limit - int(pages[0]) * os.sysconf("SC_PAGE_SIZE"))


def _left_by_control_groups() -> Iterator[float]:
    """Limit less use of each group that holds this process, of version 2 or 1; cached files count as free."""
    for line in _read("/proc/self/cgroup").splitlines():
        _, kind, path = line.split(":", 2)
        if kind == "":
            root, limit, used, cached = Path("/sys/fs/cgroup"), "memory.max", "memory.current", "inactive_file"
        elif "memory" in kind.split(","):
            root, limit, used = Path("/sys/fs/cgroup/memory"), "memory.limit_in_bytes", "memory.usage_in_bytes"
            cached = "total_inactive_file"
        else:
            continue
        inner = root / path.strip("/")
        for folder in (inner, *(above for above in inner.parents if above.is_relative_to(root))):
            numbers = [_read(folder / name).strip() for name in (limit, used)]
            if all(number.isdigit() for number in numbers):
                files = dict(pair.split() for pair in _read(folder / "memory.stat").splitlines())
                yield float(int(numbers[0]) - int(numbers[1]) + int(files.get(cached, 0)))
