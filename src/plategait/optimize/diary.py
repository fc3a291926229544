"""The diary of a search: what each batch of runs gave, a line each, so that a search goes on where it was killed."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from plategait.arrays import Array
from plategait.campaign.identity import maker
from plategait.campaign.lock import locked
from plategait.campaign.seal import hash_of
from plategait.errors import InputError

NAME = "runs.jsonl"
_OURS = {NAME, ".lock"}


class Diary:
    """Batches by the hash of what was asked for; in memory alone where there is no file.

    A search asks for the same batches in the same order whenever it has the same seed: what it was told before it was
    killed is all that it needs to go on.

    Parameters
    ----------
    path : Path, optional
        File to which each batch is added, on the disk before anything follows from it.
    """

    def __init__(self, path: Path | None = None) -> None:
        self._path, self._told = path, {} if path is None else _read(path)

    def told(self, asked: str) -> Array | None:
        """Rows of a batch, where it has been run."""
        return self._told.get(asked)

    def tell(self, asked: str, rows: Array) -> None:
        """Keep the rows of a batch."""
        self._told[asked] = rows
        if self._path is not None:
            _append(self._path, {"asked": asked, "rows": rows.tolist()})


@contextmanager
def open_diary(store: Path | None, wanted: Mapping[str, Any]) -> Iterator[Diary]:
    """Diary of a search in a folder, which is made where there is none and held for this process.

    Parameters
    ----------
    store : Path, optional
        None keeps it in memory.
    wanted : mapping
        What decides the search, as JSON can hold it: only the very same search goes on.

    Raises
    ------
    InputError
        When the folder is no search's, another search's, held by another process, or cannot be written to.
    """
    if store is None:
        yield Diary()
        return
    another = str(store.with_name(f"{store.name}-2"))
    try:
        store.mkdir(exist_ok=True)
    except OSError as error:
        raise InputError("store", f"{store} ({error.strerror})", "a folder that can be written", "optimum") from None
    if {entry.name for entry in store.iterdir()} - _OURS:
        raise InputError("store", f"the folder {store} with other files in it", "a search's, or a new name", another)
    path, heading = store / NAME, {"made by": maker(), "search": hash_of(wanted)}
    with locked(store):
        lines = _lines(path)
        if not lines:
            path.write_bytes(b"")
            _append(path, heading)
        elif lines[0] != heading:
            same = lines[0].get("search") == heading["search"]
            what = "by another plategait or kind of machine" if same else "of another search"
            raise InputError("store", f"{store} {what}", "of this very search", f"--store {another}")
        yield Diary(path)


def _append(path: Path, content: Mapping[str, Any]) -> None:
    """Add a line, whole and on the disk when this returns."""
    text = json.dumps(content)
    with open(path, "ab") as file:
        file.write(f"{_sum(text)} {text}\n".encode())
        file.flush()
        os.fsync(file.fileno())


def _sum(text: str) -> str:
    return hashlib.blake2b(text.encode(), digest_size=8).hexdigest()


def _lines(path: Path) -> list[dict[str, Any]]:
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
        raise InputError("store", f"{path}, which is no search's or is damaged in its first line", "a search's",
                         "another --store")  # fmt: skip
    if whole < len(content):
        os.truncate(path, whole)
    return lines


def _read(path: Path) -> dict[str, Array]:
    return {line["asked"]: np.array(line["rows"], dtype=float) for line in _lines(path)[1:]}
