"""Progress of a part of the study as progress of the whole."""

from __future__ import annotations

from collections.abc import Callable

Progress = Callable[[float], object]
"""Takes the share that is done, 0 to 1."""


def part(progress: Progress | None, done: float, share: float) -> Progress | None:
    """Report of a part that begins when `done` of the whole is done, and is `share` of it."""
    return None if progress is None else lambda x: progress(done + share * x)
