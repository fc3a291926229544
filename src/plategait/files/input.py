"""Files coming in: plain files of bounded size, read once. Nothing is waited for, and nothing read is repeated."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from plategait.errors import InputError, check_kind

# What is larger is no file of ours, or one that nobody reads in a minute. Bytes.
LARGEST_TOML = 8 << 20
LARGEST_TABLE = 32 << 20
LARGEST_PICTURE = 64 << 20
LARGEST_JSON = 1 << 20

_KINDS = {
    stat.S_IFDIR: "a folder", stat.S_IFIFO: "a pipe", stat.S_IFCHR: "a device", stat.S_IFBLK: "a device",
    stat.S_IFSOCK: "a socket", stat.S_IFLNK: "a link",
}  # fmt: skip
# A pipe that nobody writes to is opened at once, a terminal takes no control.
_AT_ONCE = sum(getattr(os, name, 0) for name in ("O_NONBLOCK", "O_NOCTTY", "O_CLOEXEC", "O_BINARY"))


# What files that are no text begin with, and what they are.
_BEGINNINGS = (
    (b"PK\x03\x04", "a workbook or another zip archive"), (b"\xd0\xcf\x11\xe0", "a workbook of an old Excel"),
    (b"\x89PNG", "a picture"), (b"\xff\xd8\xff", "a picture"), (b"%PDF", "a PDF"), (b"\x89HDF", "HDF5, such as netCDF"),
)  # fmt: skip


def kind_of(content: bytes) -> str:
    """What a file is that is no text, as far as its first bytes tell."""
    return next((kind for begins, kind in _BEGINNINGS if content.startswith(begins)), "no text in UTF-8")


class UnreadableError(Exception):
    """A file that is not read, and why."""


def plain_bytes(path: Path | str, most: int, *, links: bool = True) -> bytes:
    """Contents of a plain file.

    Parameters
    ----------
    most : int
        Bytes; a larger file is not read.
    links : bool
        Whether the last part of the path may be a symbolic link.

    Raises
    ------
    UnreadableError
        Says why, in a few words: it is missing, a pipe, a device or a folder, too large, or may not be read.
    """
    try:
        # A look before the opening, which may do something to a device.
        _check(os.stat(path, follow_symlinks=links), most)
        with open(os.open(path, os.O_RDONLY | _AT_ONCE | (0 if links else getattr(os, "O_NOFOLLOW", 0))), "rb") as file:
            _check(os.fstat(file.fileno()), most)
            content = file.read(most + 1) or b""
    except FileNotFoundError:
        raise UnreadableError("no such file") from None
    except (OSError, ValueError) as error:
        raise UnreadableError(getattr(error, "strerror", None) or "no name of a file") from None
    if len(content) > most:  # files of the system say that they are empty
        raise UnreadableError(_too_large(most))
    return content


def read_bytes(path: Path | str, most: int, field: str, allowed: str, hint: str) -> bytes:
    """Contents of a plain file of at most so many bytes.

    Raises
    ------
    InputError
        When it is none, or cannot be read; names `field`, and what is `allowed` and the `hint`.
    """
    check_kind(path, (str, Path), field, hint)
    try:
        return plain_bytes(path, most)
    except UnreadableError as error:
        raise InputError(field, f"{path} ({error})", allowed, hint) from None


def read_text(path: Path | str, most: int, field: str, allowed: str, hint: str) -> str:
    """Text of a plain file in UTF-8, with or without a byte order mark; line ends as they are.

    Raises
    ------
    InputError
        As `read_bytes`.
    """
    content = read_bytes(path, most, field, allowed, hint)
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(field, f"{path} ({kind_of(content)})", allowed, hint) from None


def _check(status: os.stat_result, most: int) -> None:
    if not stat.S_ISREG(status.st_mode):
        raise UnreadableError(_KINDS.get(stat.S_IFMT(status.st_mode), "no plain file"))
    if status.st_size > most:
        raise UnreadableError(_too_large(most))


def _too_large(most: int) -> str:
    return f"larger than {most / (1 << 20):.0f} MiB"
