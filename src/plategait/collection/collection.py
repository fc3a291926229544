"""Estimates of many objects: on this machine one by one, or each on a worker of a Dask cluster. Both give the same."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from plategait.campaign.cluster import connected, hand_out
from plategait.campaign.journal import open_journal
from plategait.collection.objects import Item, read_items
from plategait.collection.one import Asked, estimated


@dataclass(frozen=True, eq=False)
class Outcome:
    """What became of one object.

    Attributes
    ----------
    item : Item
    summary : dict, optional
        Plain numbers of its estimate; None where there is none.
    fragment : str
        Scenario fragment for `--with`, as TOML; empty where nothing is determined.
    failure : str
        Why there is no estimate; empty where there is one.
    """

    item: Item
    summary: dict[str, Any] | None
    fragment: str
    failure: str

    @property
    def answered(self) -> bool:
        """Whether the curves are explained and determine something."""
        return bool(self.summary and self.summary["answered"])

    @property
    def plain(self) -> dict[str, Any]:
        """For `--json`: the object, its failure or None, and what an estimate of it alone gives."""
        told = {"object": self.item.name, "files": [str(file) for file in self.item.files]}
        return told | {"failure": self.failure or None} | (self.summary or {"answered": False})


def estimate_all(
    paths: Sequence[Path | str],
    asked: Asked,
    *,
    store: Path | str | None = None,
    dask: object = None,
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> tuple[Outcome, ...]:
    """Estimate many objects alike.

    Parameters
    ----------
    paths : sequence of Path
        An object each: the file of its curve, or a folder with several curves of it.
    asked : Asked
        How each of them is estimated.
    store : path, optional
        Folder that keeps each estimate: killed at any moment, the same call goes on with the objects that are left, and
        further objects can be added later.
    dask : str or distributed.Client, optional
        Cluster to run on, an object to a worker: its address, scheduler file or client. This machine by default.
    threads : int, optional
        Cores to use here; all by default.
    progress : callable, optional
        Called with the fraction done.

    Returns
    -------
    outcomes : tuple of Outcome
        In the order of the paths; an object that cannot be estimated says why and costs the others nothing.

    Raises
    ------
    InputError
        For a path told twice, a store of other estimates, or no cluster that answers.
    """
    items = read_items([Path(path) for path in paths])
    with open_journal(None if store is None else Path(store), "collection", asked.identity) as journal:
        kept = {entry["content"]: entry["made"] for entry in journal.entries}
        left = [item for item in items if not item.trouble and item.content not in kept]
        counted = _Counted(progress, len(items), len(items) - len(left))
        with connected(dask if left else None) as client:
            for item, made in _made(left, asked, client, threads, counted.within):
                kept[item.content] = made
                if not made.get("fault"):
                    journal.add({"content": item.content, "made": made})
                counted.one()
    return tuple(_outcome(item, {"failure": item.trouble} if item.trouble else kept[item.content]) for item in items)


class _Counted:
    """How many of the objects are done."""

    def __init__(self, progress: Callable[[float], object] | None, total: int, done: int) -> None:
        self._progress, self._total, self._done = progress, total, done

    def within(self, part: float) -> None:
        """Report how much of the next object is done."""
        if self._progress is not None:
            self._progress((self._done + part) / self._total)

    def one(self) -> None:
        """Count one that is done, and report."""
        self._done += 1
        self.within(0.0)


def _made(
    items: Sequence[Item], asked: Asked, client: Any, threads: int | None, progress: Callable[[float], object]
) -> Iterator[tuple[Item, dict[str, Any]]]:
    """Estimates of objects as they end."""
    if client is not None:
        yield from hand_out(client, _on_a_core, items, asked)
        return
    for item in items:
        yield item, estimated(item, asked, threads, progress)


def _on_a_core(item: Item, asked: Asked) -> dict[str, Any]:
    return estimated(item, asked, threads=1)


def _outcome(item: Item, made: dict[str, Any]) -> Outcome:
    return Outcome(item, made.get("summary"), made.get("fragment", ""), made.get("failure", ""))
