"""The diary of a search: what each batch of runs gave, so that a search goes on where it was killed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from plategait.arrays import Array
from plategait.campaign.journal import Journal, open_journal


class Diary:
    """Batches by the hash of what was asked for; in memory alone without a journal.

    A search asks for the same batches in the same order whenever it has the same seed: what it was told before it was
    killed is all that it needs to go on.
    """

    def __init__(self, journal: Journal | None = None) -> None:
        self._journal = journal or Journal()
        self._told = {entry["asked"]: np.array(entry["rows"], dtype=float) for entry in self._journal.entries}

    def told(self, asked: str) -> Array | None:
        """Rows of a batch, where it has been run."""
        return self._told.get(asked)

    def tell(self, asked: str, rows: Array) -> None:
        """Keep the rows of a batch."""
        self._told[asked] = rows
        self._journal.add({"asked": asked, "rows": rows.tolist()})


@contextmanager
def open_diary(store: Path | None, wanted: Mapping[str, Any]) -> Iterator[Diary]:
    """Diary of a search in a folder (`plategait.campaign.journal.open_journal`).

    Raises
    ------
    InputError
    """
    with open_journal(store, "search", wanted) as journal:
        yield Diary(journal)
