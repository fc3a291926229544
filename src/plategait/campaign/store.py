"""The store of a sweep: batches that count only once their check sum is written, last."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plategait.campaign import layout
from plategait.campaign.batch import Rows, Variable, variables
from plategait.campaign.identity import check_identity, identity
from plategait.campaign.lock import locked
from plategait.campaign.plan import Sweep
from plategait.campaign.points import Point, base_points, columns
from plategait.errors import InputError

# Points lost or to come that a message names.
_NAMED = 12


class Store:
    """A store on disk.

    Attributes
    ----------
    path : Path
    attributes : dict
    batch : int
        Points of a batch.
    n_points : int
        Points that it has room for.
    """

    def __init__(self, path: Path) -> None:
        root = layout.read_root(path)
        if root is None:
            raise InputError("store", f"{path} without a sound zarr.json: all points are lost", "a whole store",
                             "--repair, to run all of it again")  # fmt: skip
        self.path, self._root = path, root
        self._arrays: dict[str, Any] = {}

    @property
    def attributes(self) -> dict[str, Any]:
        """Attributes of the store."""
        return self._root["attributes"]

    @property
    def batch(self) -> int:
        """Points of a batch."""
        return int(self.attributes["batch"])

    @property
    def n_points(self) -> int:
        """Points that it has room for."""
        return int(self._metadata["status"]["shape"][0])

    @property
    def _metadata(self) -> dict[str, Any]:
        return self._root["consolidated_metadata"]["metadata"]

    @property
    def names(self) -> list[str]:
        """Arrays that are filled batch by batch, coordinates included."""
        return [name for name, metadata in self._metadata.items() if metadata["dimension_names"][0] == "point"]

    def _array(self, name: str) -> Any:
        """One zarr array."""
        if not self._arrays:
            import zarr

            with zarr.config.set({"array.write_empty_chunks": True}):  # a missing chunk is a lost one
                group = zarr.open_group(str(self.path), mode="r+", use_consolidated=True)
                self._arrays = dict(group.arrays())
        return self._arrays[name]

    def batches(self) -> list[range]:
        """Points of each batch."""
        starts = range(0, self.n_points, self.batch)
        return [range(start, min(start + self.batch, self.n_points)) for start in starts]

    def _chunk(self, name: str, batch: int) -> Path:
        inner = len(self._metadata[name]["shape"]) - 1
        return self.path / name / ".".join(["c", str(batch), *["0"] * inner])

    def _digest(self, batch: int) -> int:
        """Of the bytes of a batch's chunks; raises OSError when one is missing."""
        total = hashlib.blake2b(digest_size=8)
        for name in sorted(self.names):
            content = self._chunk(name, batch).read_bytes()
            total.update(f"{name} {len(content)} ".encode() + content)
        return int.from_bytes(total.digest(), "little") or 1

    def state(self) -> tuple[NDArray[np.bool_], list[int]]:
        """Which points have been run for sure, and which batches are damaged.

        A batch without a check sum is not damaged: it was in flight when the campaign ended.
        """
        done, damaged = np.zeros(self.n_points, dtype=bool), []
        for batch, span in enumerate(self.batches()):
            if not self._chunk(layout.CHECKSUM, batch).exists():
                continue
            try:
                whole = int(self._array(layout.CHECKSUM)[batch]) == self._digest(batch)
                if whole:
                    done[span.start : span.stop] = self._array("status")[span.start : span.stop] == 1
            except Exception:  # whatever zarr's codecs raise for a spoilt chunk
                whole = False
            if not whole:
                damaged.append(batch)
        return done, damaged

    def drop(self, batch: int) -> None:
        """Forget a batch: from now on it has not been run."""
        self._chunk(layout.CHECKSUM, batch).unlink(missing_ok=True)
        layout.sync([self.path / layout.CHECKSUM])
        for name in self.names:
            self._chunk(name, batch).unlink(missing_ok=True)

    def read(self, name: str, span: range) -> NDArray:
        """Rows of an array."""
        return self._array(name)[span.start : span.stop]

    def commit(self, batch: int, rows: Rows) -> None:
        """Write the first rows of a batch, then its check sum; it counts from then on, and not before."""
        start = batch * self.batch
        self.drop(batch)
        for name in self.names:
            self._array(name)[start : start + len(rows[name])] = rows[name]
        chunks = [self._chunk(name, batch) for name in self.names]
        layout.sync([*chunks, *(chunk.parent for chunk in chunks)])
        self._array(layout.CHECKSUM)[batch] = self._digest(batch)
        marker = self._chunk(layout.CHECKSUM, batch)
        layout.sync([marker, marker.parent])

    def grow(self, n_points: int, **attributes: Any) -> None:
        """Make room for points, and set attributes."""
        n_points = max(n_points, self.n_points)
        if n_points > self.n_points or any(self.attributes.get(k) != v for k, v in attributes.items()):
            layout.publish(self.path, self._root, n_points, self.batch, **attributes)
            self._arrays = {}

    def describe(self, batches: Sequence[int], points: Sequence[Point]) -> str:
        """Say which points lie in batches."""
        spans = [self.batches()[batch] for batch in batches]
        said = ", ".join(f"{s.start}–{s.stop - 1}" if len(s) > 1 else str(s.start) for s in spans[:_NAMED])
        more = f" and {len(spans) - _NAMED} more batches" if len(spans) > _NAMED else ""
        first = spans[0].start
        example = f", from {_point(points[first])}" if first < len(points) else ""
        return f"{sum(map(len, spans))} points lost ({said}{more}{example})"


@contextmanager
def open_to_write(path: Path, sweep: Sweep, batch: int, repair: bool) -> Iterator[tuple[Store, list[Point]]]:
    """Store of a sweep and its base points, held for this process; laid out where there is none.

    Raises
    ------
    InputError
        When it cannot be written, is another sweep's, is held by another process, or is damaged and not to be repaired.
    """
    check_path(path)
    points = base_points(sweep)
    wanted = identity(sweep, points)
    try:
        path.mkdir(exist_ok=True)
    except OSError as error:
        raise InputError("store", f"{path} ({error.strerror})", "a folder that can be written", "sweep.zarr") from None
    if not os.access(path, os.W_OK):
        raise InputError("store", str(path), "a folder that can be written", f"another --store than {path.name}")
    root = layout.read_root(path)
    arrays = (*layout.coordinates(sweep.parameters, points[0]), *variables(sweep, points)) if root is None else ()
    if root is None and not layout.is_ours(path, arrays):
        hint = str(path.with_name(f"{path.stem}-2.zarr"))
        raise InputError("store", f"the folder {path} with other files in it", "a store, or a new name", hint)
    with locked(path):
        root = layout.read_root(path)
        if root is None:
            if (path / layout.ROOT).exists() and not repair:
                Store(path)
            _lay_out(path, sweep, arrays or variables(sweep, points), points, batch, wanted)
        store = Store(path)
        check_identity(path, store.attributes, wanted)
        for left in path.rglob("*.partial"):
            left.unlink(missing_ok=True)
        _, damaged = store.state()
        if damaged and not repair:
            raise InputError(
                "store", f"{path} with {store.describe(damaged, points)}", "whole", "--repair, to run these again"
            )
        for lost in damaged:
            store.drop(lost)
        yield store, points


def _lay_out(
    path: Path, sweep: Sweep, arrays: Sequence[Variable], points: Sequence[Point], batch: int, wanted: dict[str, Any]
) -> None:
    attributes = wanted | {
        "title": sweep.name,
        "sweep": sweep.to_json(),
        "coordinates": " ".join(p.name for p in sweep.parameters),
        "grid_shape": [len(values) for values in sweep.grid.values()],
        "base_points": len(points),
        "batch": batch,
        "refine": 0,
        "seed": sweep.seed,
    }
    layout.create(path, arrays, points, sweep.repeats, batch, sweep.record.interval, attributes)


def check_path(path: Path) -> None:
    """Refuse a path at which no store can be.

    Raises
    ------
    InputError
        For a file, or a folder that is missing.
    """
    if path.suffix != ".zarr":
        raise InputError("store", str(path), "a name ending in .zarr", f"{path.stem or 'sweep'}.zarr")
    if os.path.isfile(path):
        raise InputError(
            "store", f"the file {path}", "a folder, or a new name", str(path.with_name(f"{path.stem}-2.zarr"))
        )
    if not os.path.isdir(path.parent):
        raise InputError("store", str(path), "in a folder that exists", path.name)


def with_coordinates(rows: Rows, points: Sequence[Point]) -> Rows:
    """Rows with the columns of their points."""
    return rows | columns(list(points[0]), points)


def _point(point: Point) -> str:
    return ", ".join(
        f"{name} = {value:g}" if isinstance(value, float) else f"{name} = {value}" for name, value in point.items()
    )
