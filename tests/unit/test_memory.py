"""Memory that there still is, as the system, control groups and the process's own limit tell it."""

from __future__ import annotations

import math

from plategait import memory


def test_there_is_memory_and_it_is_told_in_words():
    assert 1e6 < memory.available_memory() < math.inf
    assert [memory.in_words(n) for n in (12, 1.5e3, 2e6, 3.14e9, 5e12)] == [
        "12 bytes", "1.5 kB", "2 MB", "3.14 GB", "5 TB",
    ]  # fmt: skip


def test_control_groups_and_the_system_bound_the_memory(monkeypatch):
    files = {
        "/proc/meminfo": "MemTotal: 9 kB\nMemAvailable:  5000000 kB\n",
        "/proc/self/cgroup": "0::/a/b\n",
        "/sys/fs/cgroup/a/memory.max": "4000000000\n",
        "/sys/fs/cgroup/a/memory.current": "3000000000\n",
        "/sys/fs/cgroup/a/memory.stat": "anon 1\ninactive_file 500000000\n",
        "/sys/fs/cgroup/a/b/memory.max": "max\n",
        "/sys/fs/cgroup/a/b/memory.current": "1\n",
    }
    monkeypatch.setattr(memory, "_read", lambda path: files.get(str(path), ""))
    assert memory.available_memory() == 1.5e9
    files["/proc/self/cgroup"] = "9:cpu,memory:/job\n3:pids:/job\n"
    files["/sys/fs/cgroup/memory/job/memory.limit_in_bytes"] = "3000000000\n"
    files["/sys/fs/cgroup/memory/job/memory.usage_in_bytes"] = "1000000000\n"
    assert memory.available_memory() == 2e9
    files["/proc/meminfo"] = "MemAvailable: 1000 kB\n"
    assert memory.available_memory() == 1_024_000
    files.clear()
    assert memory.available_memory() > 1e9, "nothing said, nothing bounded but by this process's own limit"
