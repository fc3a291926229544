"""Files going out: refused before the work when they cannot be written, whole or not at all when they are."""

from __future__ import annotations

import errno
import os
import shlex
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from plategait.errors import InputError, check_kind

PICTURES = (".png", ".pdf", ".svg")
# What the system says where the place is at fault and not the program.
_NO_ROOM = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.EROFS}


def check_writable(path: Path | str, suffixes: Sequence[str], field: str = "output") -> Path:
    """Path that can be written, or an error before any work is lost.

    Raises
    ------
    InputError
        When the suffix is none of those given, the folder is missing, or the file or folder cannot be written.
    """
    check_kind(path, (str, Path), field, f'"result{suffixes[0]}"')
    got, path = str(path), Path(path)
    folder, stem = path.parent, Path(path.name.strip(".")).stem or "result"
    if path.suffix.lower() not in suffixes:
        works = folder / f"{stem}{suffixes[0]}"
        raise InputError(field, got, f"a file name ending in {' or '.join(suffixes)}", str(works))
    # `os.path` says no where `Path` raises for a name that no file can have.
    if not os.path.isdir(folder):
        below_a_file = any(os.path.isfile(above) for above in (folder, *folder.parents))
        hint = path.name if below_a_file else f"mkdir -p {shlex.quote(str(folder))}, or {path.name}"
        raise InputError(field, got, "a file in a folder that exists", hint)
    if os.path.isdir(path):
        raise InputError(field, got, "a file, not a folder", str(folder / f"{stem}-result{path.suffix}"))
    if not os.access(path if os.path.exists(path) else folder, os.W_OK) or not os.access(folder, os.W_OK):
        raise InputError(field, got, "a file that can be written", str(Path.home() / path.name))
    try:
        path.stat()
    except FileNotFoundError:
        pass
    except (OSError, ValueError):
        works = folder / f"result{path.suffix}"
        raise InputError(field, got, "a name that the file system takes", str(works)) from None
    return path


def check_outputs(*outputs: tuple[Path | None, Sequence[str], str]) -> None:
    """Refuse files that cannot be written before any work is done: (path or None, suffixes, option) of each.

    Raises
    ------
    InputError
        As `check_writable`.
    """
    for path, suffixes, option in outputs:
        if path is not None:
            check_writable(path, suffixes, option)


@contextmanager
def whole_file(path: Path | str, suffixes: Sequence[str], field: str = "output") -> Iterator[Path]:
    """Name of a temporary file beside `path` to write to; it takes the place of `path` only when all went well.

    Raises
    ------
    InputError
        As `check_writable`, or when there is no room left.
    """
    path = check_writable(path, suffixes, field)
    with _room(path, field):
        handle, name = tempfile.mkstemp(prefix=".plategait-", suffix=path.suffix, dir=path.parent)
        os.close(handle)
        temporary = Path(name)
        try:
            yield temporary
            _finish(temporary)
            temporary.replace(path)
        finally:
            temporary.unlink(missing_ok=True)


def write_whole(content: bytes | memoryview, path: Path | str, suffixes: Sequence[str], field: str = "output") -> None:
    """Write what a library has put together in memory, for those that cannot bear a disk that is full.

    Raises
    ------
    InputError
        As `whole_file`.
    """
    with whole_file(path, suffixes, field) as temporary:
        temporary.write_bytes(content)


def _finish(temporary: Path) -> None:
    """Wait until a file is on the disk, some of which find out only then that they are full; open it to others."""
    handle = os.open(temporary, os.O_RDWR)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
    mask = os.umask(0)
    os.umask(mask)
    temporary.chmod(0o666 & ~mask)


@contextmanager
def _room(path: Path, field: str) -> Iterator[None]:
    """Say in one line that a place has no room left."""
    try:
        yield
    except OSError as error:
        if error.errno not in _NO_ROOM:
            raise
        raise InputError(field, f"{path} ({error.strerror})", "a place with room to write",
                         f"another folder than {path.absolute().parent}") from error  # fmt: skip
