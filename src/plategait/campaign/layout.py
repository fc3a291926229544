"""How a store lies on disk: a zarr v3 group, one array for each variable, chunk = batch along ``point``.

Its root `zarr.json` holds the metadata of every array and takes effect at once, as it is replaced whole: a reader sees
the store before or after a change, never in between.
"""

from __future__ import annotations

import json
import math
import os
import shutil
import warnings
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from plategait.campaign.batch import Variable
from plategait.campaign.lock import NAME as LOCK
from plategait.campaign.parameters import Parameter
from plategait.campaign.points import Point, columns

ROOT, CHECKSUM = "zarr.json", "checksum"
_NEW = ".new"
_FILL: dict[str, Any] = {
    "float64": math.nan, "float32": math.nan, "int64": 0, "int8": 0, "bool": False, "string": "", "uint64": 0,
}  # fmt: skip


def coordinates(parameters: Sequence[Parameter], point: Point) -> tuple[Variable, ...]:
    """Arrays of the swept parameters."""
    return tuple(
        Variable(p.name, "string" if isinstance(point[p.name], str) else "float64", p.name, p.unit, by_run=False)
        for p in parameters
    )


def is_ours(path: Path, arrays: Sequence[Variable]) -> bool:
    """Whether a folder holds no more than a store whose making was interrupted, or nothing."""
    there = set(os.listdir(path))
    return not there or (LOCK in there and there <= {LOCK, _NEW, ROOT, CHECKSUM, "time", *(a.name for a in arrays)})


def create(
    path: Path,
    arrays: Sequence[Variable],
    points: Sequence[Point],
    repeats: int,
    batch: int,
    interval: float,
    attributes: Mapping[str, Any],
) -> None:
    """Lay out an empty store in a folder, where there was none or one to be thrown away; its root comes last."""
    import zarr

    for entry in set(os.listdir(path)) - {LOCK}:
        shutil.rmtree(path / entry) if (path / entry).is_dir() else os.unlink(path / entry)
    new = path / _NEW
    group = zarr.create_group(str(new), zarr_format=3, attributes=dict(attributes))
    for array in arrays:
        shape = (len(points), *((repeats,) if array.by_run else ()), *array.inner.values())
        dimensions = ("point", *(("repeat",) if array.by_run else ()), *array.inner)
        _array(group, array, shape, (batch, *shape[1:]), dimensions)
    count = math.ceil(len(points) / batch)
    _array(group, Variable(CHECKSUM, "uint64", "of a batch's chunks; 0 until it is whole"), (count,), (1,), ("batch",))
    for name, values in columns([n for n in points[0]], points).items():
        _fill(group, name, values)
    samples = next((a.inner["time"] for a in arrays if "time" in a.inner), 0)
    if samples:
        _array(group, Variable("time", "float64", "time", "s"), (samples,), (samples,), ("time",))
        _fill(group, "time", np.arange(samples) * interval)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # zarr warns that not every reader knows metadata in one place
        zarr.consolidate_metadata(str(new), zarr_format=3)
    for entry in sorted(os.listdir(new), key=lambda name: name == ROOT):
        os.replace(new / entry, path / entry)
    new.rmdir()
    sync([path, *(path / a.name for a in arrays)])


def _array(group: Any, array: Variable, shape: tuple[int, ...], chunks: tuple[int, ...], dims: Sequence[str]) -> None:
    from zarr.codecs import Crc32cCodec, ZstdCodec

    attributes = {"long_name": array.long_name} | ({"units": array.unit} if array.unit else {})
    # Whoever reads a spoilt chunk gets an error, by the check sum in it.
    group.create_array(
        array.name, shape=shape, dtype=array.kind, chunks=tuple(max(1, c) for c in chunks), dimension_names=tuple(dims),
        attributes=attributes, fill_value=_FILL[array.kind], compressors=[ZstdCodec(level=3), Crc32cCodec()],
        chunk_key_encoding={"name": "default", "separator": "."},
    )  # fmt: skip


def _fill(group: Any, name: str, values: Any) -> None:
    group[name][...] = values


def read_root(path: Path) -> dict[str, Any] | None:
    """Metadata of a store; None where they are missing or spoilt."""
    try:
        root = json.loads((path / ROOT).read_text(encoding="utf-8"))
        return root if root["consolidated_metadata"]["metadata"] and root["attributes"]["fingerprint"] else None
    except (OSError, ValueError, KeyError, TypeError):
        return None


def publish(path: Path, root: dict[str, Any], n_points: int, batch: int, **attributes: Any) -> None:
    """Make the arrays as long as that and set attributes of the store, at once for every reader."""
    for name, metadata in root["consolidated_metadata"]["metadata"].items():
        if metadata["dimension_names"][0] in ("point", "batch"):
            length = n_points if metadata["dimension_names"][0] == "point" else math.ceil(n_points / batch)
            metadata["shape"][0] = length
            write_whole(path / name / ROOT, json.dumps(metadata, indent=2))
    root["attributes"] |= attributes
    write_whole(path / ROOT, json.dumps(root, indent=2))


def write_whole(path: Path, text: str) -> None:
    """Replace a file whole, on the disk when this returns."""
    temporary = path.with_name(f"{path.name}.partial")
    with open(temporary, "w", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    os.replace(temporary, path)
    sync([path.parent])


def sync(paths: Sequence[Path]) -> None:
    """Wait until files and folders are on the disk."""
    for path in paths:
        if os.name == "nt" and path.is_dir():
            continue
        handle = os.open(path, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
