"""The store of a sweep: batches that count only once their check sum is written, last."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plategait.campaign import layout
from plategait.campaign.batch import Rows
from plategait.campaign.integrity import plan_of, strange_arrays
from plategait.campaign.points import Point, columns
from plategait.errors import InputError
from plategait.files.input import UnreadableError, plain_bytes

# Points lost or to come that a message names.
_NAMED = 12
# Bytes of a chunk; a larger one is none of ours.
_LARGEST_CHUNK = 1 << 34


class Store:
    """A store on disk.

    Attributes
    ----------
    path : Path
    plan : Sweep
    attributes : dict
    batch : int
        Points of a batch.
    n_points : int
        Points that it has room for.
    """

    def __init__(self, path: Path) -> None:
        root = layout.read_root(path)
        if root is None:
            raise InputError("store", f"{path} with its zarr.json missing, damaged or edited: all points are lost",
                             "a whole store", "--repair, to run all of it again")  # fmt: skip
        self.plan = plan_of(path, root)
        self.path, self._root = path, root
        self._arrays: dict[str, Any] = {}
        self._place = _place(path)

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
        """Of the bytes of a batch's chunks; raises UnreadableError when one is missing or no plain file."""
        total = hashlib.blake2b(digest_size=8)
        for name in sorted(self.names):
            content = plain_bytes(self._chunk(name, batch), _LARGEST_CHUNK, links=False)
            total.update(f"{name} {len(content)} ".encode() + content)
        return int.from_bytes(total.digest(), "little") or 1

    def damaged_metadata(self) -> list[str]:
        """What is damaged beside the points, and can be made anew from what is not."""
        strange = [f"the zarr.json of {name}" for name in strange_arrays(self.path, self._root)]
        return strange + ["the times of its series"] * (not self._times_are_whole())

    def mend_metadata(self) -> None:
        """Write anew whatever `damaged_metadata` tells."""
        for name, metadata in self._metadata.items():
            (self.path / name).mkdir(exist_ok=True)
            layout.remove(self.path / name / layout.ROOT)
            layout.write_whole(self.path / name / layout.ROOT, json.dumps(metadata, indent=2))
        if not self._times_are_whole():
            layout.remove(self.path / "time" / "c.0")
            self._array("time")[...] = self._times()

    def _times(self) -> NDArray[np.float64]:
        return layout.times(self._metadata["time"]["shape"][0], self.plan.record.interval)

    def _times_are_whole(self) -> bool:
        if "time" not in self._metadata:
            return True
        try:
            plain_bytes(self.path / "time" / "c.0", _LARGEST_CHUNK, links=False)
            return bool(np.array_equal(self._array("time")[...], self._times()))
        except Exception:  # whatever zarr's codecs raise for a spoilt chunk
            return False

    def state(self) -> tuple[NDArray[np.bool_], list[int]]:
        """Which points have been run for sure, and which batches are damaged.

        A batch without a check sum is not damaged: it was in flight when the campaign ended.
        """
        done, damaged = np.zeros(self.n_points, dtype=bool), []
        for batch, span in enumerate(self.batches()):
            chunk = self._chunk(layout.CHECKSUM, batch)
            if not os.path.lexists(chunk):
                continue
            try:
                plain_bytes(chunk, _LARGEST_CHUNK, links=False)
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
        with self._in_its_place():
            layout.remove(self._chunk(layout.CHECKSUM, batch))
            layout.sync([self.path / layout.CHECKSUM])
            for name in self.names:
                layout.remove(self._chunk(name, batch))

    def read(self, name: str, span: range) -> NDArray:
        """Rows of an array."""
        return self._array(name)[span.start : span.stop]

    def commit(self, batch: int, rows: Rows) -> None:
        """Write the first rows of a batch, then its check sum; it counts from then on, and not before."""
        start = batch * self.batch
        self.drop(batch)
        with self._in_its_place():
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
            with self._in_its_place():
                layout.publish(self.path, self._root, n_points, self.batch, **attributes)
            self._arrays = {}

    @contextmanager
    def _in_its_place(self) -> Iterator[None]:
        """Write only while the folder is the one that was opened, and say in one line when it is not or is full."""
        hint = "the same command again, with --store where it is now"
        if _place(self.path) != self._place:
            raise InputError("store", f"{self.path}, which was moved or deleted while it was written",
                             "left where it is", hint)  # fmt: skip
        try:
            yield
        except (OSError, UnreadableError) as error:
            said = getattr(error, "strerror", None) or error
            got = f"{self.path} ({said})" if _place(self.path) == self._place else f"{self.path}, which was moved"
            raise InputError("store", got, "a folder that stays and can be written to", hint) from error

    def describe(self, batches: Sequence[int], points: Sequence[Point]) -> str:
        """Say which points lie in batches."""
        spans = [self.batches()[batch] for batch in batches]
        said = ", ".join(f"{s.start}–{s.stop - 1}" if len(s) > 1 else str(s.start) for s in spans[:_NAMED])
        more = f" and {len(spans) - _NAMED} more batches" if len(spans) > _NAMED else ""
        first = spans[0].start
        example = f", from {_point(points[first])}" if first < len(points) else ""
        return f"{sum(map(len, spans))} points lost ({said}{more}{example})"


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


def _place(path: Path) -> tuple[int, int] | None:
    """Which folder stands at a path; None where it is no store any more."""
    try:
        (path / layout.ROOT).stat(follow_symlinks=False)
        status = path.stat()
    except OSError:
        return None
    return status.st_dev, status.st_ino


def _point(point: Point) -> str:
    return ", ".join(
        f"{name} = {value:g}" if isinstance(value, float) else f"{name} = {value}" for name, value in point.items()
    )
