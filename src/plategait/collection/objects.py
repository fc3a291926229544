"""Objects to estimate: each the curves in a file or a folder, or why they cannot be read."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from plategait.campaign.seal import hash_of
from plategait.curve.curve import Curve
from plategait.curve.curve_file import read_curve
from plategait.errors import InputError


@dataclass(frozen=True, eq=False)
class Item:
    """One object of a collection.

    Attributes
    ----------
    name : str
        The file's or folder's own, or the whole path where two are called the same.
    files : tuple of Path
    curves : tuple of Curve
    content : str
        Hash of what the files hold, and of what they are called.
    trouble : str
        Why its curves cannot be read; empty where they can.
    """

    name: str
    files: tuple[Path, ...]
    curves: tuple[Curve, ...] = ()
    content: str = ""
    trouble: str = ""


def read_items(paths: Sequence[Path]) -> tuple[Item, ...]:
    """Objects of paths, in their order: a file each, or a folder with several curves (`*.csv`) of one.

    Raises
    ------
    InputError
        For a path told twice. What cannot be read is an item that says so: the others are read all the same.
    """
    for i, path in enumerate(paths):
        if path in paths[:i]:
            raise InputError("OBJECT", path, "told once", "leaving one of them out")
    stems = [path.name if path.is_dir() else path.stem for path in paths]
    names = [stem if stems.count(stem) == 1 else str(path) for stem, path in zip(stems, paths, strict=True)]
    return tuple(_item(name, path) for name, path in zip(names, paths, strict=True))


def _item(name: str, path: Path) -> Item:
    files = tuple(sorted(path.glob("*.csv"))) if path.is_dir() else (path,)
    try:
        if not files:
            raise InputError("OBJECT", f"the folder {path} without a curve", "one with .csv files", "a curve's file")
        curves = tuple(read_curve(file) for file in files)
        content = hash_of([[file.name, hashlib.sha256(file.read_bytes()).hexdigest()] for file in files])
        return Item(name, files, curves, content)
    except InputError as error:
        return Item(name, files, trouble=str(error))
