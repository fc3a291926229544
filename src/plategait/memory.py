"""How much memory there still is, so that what needs more is refused before it begins."""

from __future__ import annotations

import math
from pathlib import Path

_GROUP = Path("/sys/fs/cgroup")


def available_memory() -> float:
    """Bytes that this process may still take: of the machine, its group and its own limit; infinite if unknown."""
    return min(_of_machine(), _of_group(), _of_process())


def in_words(size: float) -> str:
    """Bytes as people write them."""
    for unit in ("bytes", "kB", "MB", "GB"):
        if size < 1000:
            return f"{size:.3g} {unit}"
        size /= 1000
    return f"{size:.3g} TB"


def _of_machine() -> float:
    return _numbers(Path("/proc/meminfo")).get("MemAvailable:", math.inf) * 1024


def _of_group() -> float:
    """What a container has left; files that the system only keeps at hand do not count as taken."""
    limit, used = (_number(_GROUP / f"memory.{name}") for name in ("max", "current"))
    return max(0.0, limit - used + _numbers(_GROUP / "memory.stat").get("inactive_file", 0.0))


def _of_process() -> float:
    try:
        import resource

        limit, _ = resource.getrlimit(resource.RLIMIT_AS)
        pages = float(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
    except (ImportError, OSError):
        return math.inf
    return math.inf if limit == resource.RLIM_INFINITY else max(0.0, limit - pages * resource.getpagesize())


def _number(path: Path) -> float:
    """Limits are numbers, or "max"; infinite where there is no such file. A use without a limit counts nothing."""
    try:
        return float(path.read_text(encoding="ascii"))
    except (OSError, ValueError):
        return math.inf if path.name.endswith("max") else 0.0


def _numbers(path: Path) -> dict[str, float]:
    """First number of each line by the word before it."""
    try:
        lines = [line.split() for line in path.read_text(encoding="ascii").splitlines()]
    except OSError:
        return {}
    return {words[0]: float(words[1]) for words in lines if len(words) > 1 and words[1].isdigit()}
