"""One writer at a time. The system lets go of the lock when its process ends, however it ends."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from plategait.errors import InputError

NAME = ".lock"


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Hold a folder for writing.

    Raises
    ------
    InputError
        When another process holds it, or it cannot be written to.
    """
    try:
        handle = os.open(folder / NAME, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o666)
    except OSError as error:
        raise InputError("store", f"{folder / NAME} ({error.strerror})", "a file that can be written",
                         "another --store") from None  # fmt: skip
    try:
        try:
            _take(handle)
        except OSError:
            raise InputError("store", str(folder), "a store that no other process is writing",
                             "again when that has ended, or another --store") from None  # fmt: skip
        yield
    finally:
        os.close(handle)


def _take(handle: int) -> None:
    try:
        import fcntl
    except ImportError:  # Windows
        import msvcrt

        msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined]
        return
    fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
