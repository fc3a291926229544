"""A journal: what work gave, a sealed line each, so that it goes on where it was killed."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from plategait.campaign.identity import maker
from plategait.campaign.lock import locked
from plategait.campaign.seal import hash_of
from plategait.errors import InputError

NAME = "runs.jsonl"
_OURS = {NAME, ".lock"}


class Journal:
    """Entries in the order in which they were added; in memory alone where there is no file.

    Parameters
    ----------
    path : Path, optional
        File to which each entry is added, on the disk before anything follows from it.
    entries : iterable of dict
        What it holds already.
    """

    def __init__(self, path: Path | None = None, entries: list[dict[str, Any]] | None = None) -> None:
        self._path, self.entries = path, entries or []

    def add(self, entry: dict[str, Any]) -> None:
        """Keep an entry: what JSON can hold."""
        self.entries.append(entry)
        if self._path is not None:
            _append(self._path, entry)


@contextmanager
def open_journal(store: Path | None, kind: str, wanted: Mapping[str, Any]) -> Iterator[Journal]:
    """Journal of some work in a folder, which is made where there is none and held for this process.

    Parameters
    ----------
    store : Path, optional
        None keeps it in memory.
    kind : str
        What the work is: "search".
    wanted : mapping
        What decides the work, as JSON can hold it: only the very same goes on.

    Raises
    ------
    InputError
        When the folder is of no such work, of another, held by another process, or cannot be written to.
    """
    if store is None:
        yield Journal()
        return
    another = str(store.with_name(f"{store.name}-2"))
    try:
        store.mkdir(exist_ok=True)
    except OSError as error:
        raise InputError("store", f"{store} ({error.strerror})", "a folder that can be written", "runs") from None
    if {entry.name for entry in store.iterdir()} - _OURS:
        raise InputError("store", f"the folder {store} with other files in it", f"a {kind}'s, or a new name", another)
    path, heading = store / NAME, {"made by": maker(), kind: hash_of(wanted)}
    with locked(store):
        lines = _lines(path, kind)
        if not lines:
            path.write_bytes(b"")
            _append(path, heading)
        elif lines[0] != heading:
            same = lines[0].get(kind) == heading[kind]
            what = "by another plategait or kind of machine" if same else f"of another {kind}"
            raise InputError("store", f"{store} {what}", f"of this very {kind}", f"--store {another}")
        yield Journal(path, lines[1:])


def _append(path: Path, content: Mapping[str, Any]) -> None:
    """Add a line, whole and on the disk when this returns."""
    text = json.dumps(content)
    with open(path, "ab") as file:
        file.write(f"{_sum(text)} {text}\n".encode())
        file.flush()
        os.fsync(file.fileno())


def _sum(text: str) -> str:
    return hashlib.blake2b(text.encode(), digest_size=8).hexdigest()


def _lines(path: Path, kind: str) -> list[dict[str, Any]]:
    """Lines that are whole; what a kill or a fault spoilt is cut off with all after it, and is run again."""
    if not path.is_file():
        return []
    content, lines, whole = path.read_bytes(), [], 0
    for line in content.splitlines(keepends=True):
        head, _, text = line.decode(errors="replace").partition(" ")
        if not line.endswith(b"\n") or head != _sum(text[:-1]):
            break
        lines.append(json.loads(text))
        whole += len(line)
    if not whole and b"\n" in content:
        raise InputError("store", f"{path}, which is no {kind}'s or is damaged in its first line", f"a {kind}'s",
                         "another --store")  # fmt: skip
    if whole < len(content):
        os.truncate(path, whole)
    return lines
