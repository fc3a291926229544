"""Files going out: refused before the work when they cannot be written, whole or not at all when they are."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from plategait.errors import InputError


def check_writable(path: Path | str, suffixes: Sequence[str], field: str = "output") -> Path:
    """Path that can be written, or an error before any work is lost.

    Raises
    ------
    InputError
        When the suffix is none of those given, the folder is missing, or the file or folder cannot be written.
    """
    path = Path(path)
    if path.suffix.lower() not in suffixes:
        raise InputError(
            field, str(path), f"a file name ending in {' or '.join(suffixes)}", str(path.with_suffix(suffixes[0]))
        )
    folder = path.parent
    if path.is_dir() or not folder.is_dir():
        raise InputError(field, str(path), "a file in a folder that exists", f"mkdir -p {folder}, or {path.name}")
    if not os.access(path if path.exists() else folder, os.W_OK) or not os.access(folder, os.W_OK):
        raise InputError(field, str(path), "a file that can be written", str(Path.home() / path.name))
    return path


@contextmanager
def whole_file(path: Path | str, suffixes: Sequence[str], field: str = "output") -> Iterator[Path]:
    """Name of a temporary file beside `path` to write to; it takes the place of `path` only when all went well.

    Raises
    ------
    InputError
        As `check_writable`.
    """
    path = check_writable(path, suffixes, field)
    handle, name = tempfile.mkstemp(prefix=f".{path.stem}-", suffix=path.suffix, dir=path.parent)
    os.close(handle)
    temporary = Path(name)
    try:
        yield temporary
        mask = os.umask(0)
        os.umask(mask)
        temporary.chmod(0o666 & ~mask)
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)
