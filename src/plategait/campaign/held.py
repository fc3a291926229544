"""A store held for writing: laid out where there is none, checked, and mended where that was asked for."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from plategait.campaign import layout
from plategait.campaign.batch import Variable, variables
from plategait.campaign.identity import check_identity, identity
from plategait.campaign.lock import locked
from plategait.campaign.plan import Sweep
from plategait.campaign.points import Point, base_points, described
from plategait.campaign.store import Store, check_path
from plategait.errors import InputError


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
            # Without it, and before any batch was finished, its making was interrupted.
            begun = os.path.lexists(path / layout.ROOT) or any((path / layout.CHECKSUM).glob("c.*"))
            if begun and not repair:
                Store(path)
            _lay_out(path, sweep, arrays or variables(sweep, points), points, batch, wanted)
        store = Store(path)
        check_identity(path, store.attributes, wanted)
        for left in path.rglob("*.partial"):
            left.unlink(missing_ok=True)
        strange = store.damaged_metadata()
        if strange and not repair:
            raise InputError("store", f"{path} with damage in {strange[0]}", "whole", "--repair, to write it anew")
        if strange:
            store.mend_metadata()
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
    attributes = wanted | described(sweep) | {"batch": batch, "refine": 0}
    layout.create(path, arrays, points, sweep.repeats, batch, sweep.record.interval, attributes)
