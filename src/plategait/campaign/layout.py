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
from numpy.typing import NDArray

from plategait.campaign.batch import Variable
from plategait.campaign.identity import FORMAT
from plategait.campaign.lock import NAME as LOCK
from plategait.campaign.points import Point, columns
from plategait.campaign.seal import SEAL, is_sealed, sealed
from plategait.errors import InputError
from plategait.files.input import UnreadableError, plain_bytes
from plategait.model.parameters import Parameter

ROOT, CHECKSUM = "zarr.json", "checksum"
# Of the metadata, bytes: plans of millions of values are in them.
LARGEST_ROOT = 256 << 20
# Codecs that arrays are written with; some others run what they read.
CODECS = {"bytes", "vlen-utf8", "zstd", "crc32c"}
_NEW = ".new"
FILL: dict[str, Any] = {
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
        remove(path / entry)
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
        _fill(group, "time", times(samples, interval))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # zarr warns that not every reader knows metadata in one place
        zarr.consolidate_metadata(str(new), zarr_format=3)
    write_whole(new / ROOT, json.dumps(sealed(json.loads((new / ROOT).read_text(encoding="utf-8"))), indent=2))
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
        attributes=attributes, fill_value=FILL[array.kind], compressors=[ZstdCodec(level=3), Crc32cCodec()],
        chunk_key_encoding={"name": "default", "separator": "."},
    )  # fmt: skip


def _fill(group: Any, name: str, values: Any) -> None:
    group[name][...] = values


def times(samples: int, interval: float) -> NDArray[np.float64]:
    """Times of the recorded series, s."""
    return np.arange(samples, dtype=np.float64) * np.float64(interval)


def read_root(path: Path) -> dict[str, Any] | None:
    """Metadata of a store; None where they are missing, or not as they were written.

    Raises
    ------
    InputError
        When they are of another format.
    """
    try:
        root = json.loads(plain_bytes(path / ROOT, LARGEST_ROOT, links=False))
        attributes = root["attributes"]
        kind, maker = attributes["store_format"], attributes["plategait_version"]
        if kind == FORMAT or SEAL in attributes:
            sound = SEAL in attributes and is_sealed(root)
            if kind == FORMAT or not sound:
                return root if sound else None
    except (UnreadableError, ValueError, LookupError, TypeError, AttributeError, RecursionError):
        return None
    raise InputError("store", f"{path} of store format {kind}, by plategait {maker}", f"of format {FORMAT}",
                     "that plategait, or another --store")  # fmt: skip


def remove(path: Path) -> None:
    """Remove what stands at a path, if anything; of a link the link."""
    shutil.rmtree(path) if path.is_dir() and not path.is_symlink() else path.unlink(missing_ok=True)


def publish(path: Path, root: dict[str, Any], n_points: int, batch: int, **attributes: Any) -> None:
    """Make the arrays as long as that and set attributes of the store, at once for every reader."""
    for name, metadata in root["consolidated_metadata"]["metadata"].items():
        if metadata["dimension_names"][0] in ("point", "batch"):
            length = n_points if metadata["dimension_names"][0] == "point" else math.ceil(n_points / batch)
            metadata["shape"][0] = length
            write_whole(path / name / ROOT, json.dumps(metadata, indent=2))
    root["attributes"] = sealed(root | {"attributes": root["attributes"] | attributes})["attributes"]
    write_whole(path / ROOT, json.dumps(root, indent=2))


def write_whole(path: Path, text: str) -> None:
    """Replace a file whole, on the disk when this returns."""
    temporary = path.with_name(f"{path.name}.partial")
    remove(temporary)
    with open(temporary, "x", encoding="utf-8") as file:
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
