"""How much memory there still is, so that what needs more is refused before it begins."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator
from pathlib import Path


def in_words(size: float) -> str:
    """Bytes as people write them."""
    for unit in ("bytes", "kB", "MB", "GB"):
        if size < 1000:
            return f"{size:.3g} {unit}"
        size /= 1000
    return f"{size:.3g} TB"


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
