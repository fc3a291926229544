"""What a page is made of: what a user named, told apart by what is in it, as plain data of bounded size."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any, Literal

from plategait.errors import InputError
from plategait.files.headings import possible_names
from plategait.files.input import UnreadableError, plain_bytes
from plategait.files.rows import read_rows
from plategait.files.toml import read_toml
from plategait.lab.object_payload import object_payload
from plategait.lab.poses_payload import poses_payload
from plategait.lab.run_payload import run_payload
from plategait.lab.scenario_json import plain_scenario
from plategait.lab.steering_payload import steering_payload
from plategait.lab.store_payload import store_payload
from plategait.model.presets import PRESETS, as_scenario
from plategait.model.scenario import Scenario

Kind = Literal["scenario", "run", "store", "poses", "object", "steering"]
WITH_SCENARIO: tuple[Kind, ...] = ("run", "store")
"""Kinds that bring their own scenario, which nothing is laid over."""
FIELD = "WHAT"
ALLOWED = "a preset, a scenario or an object (.toml), a run (.nc), a store (.zarr), poses or a steering (.csv)"
_HINT = "plategait lab cheese"
# Beginnings of HDF5 files, and as much of a file as tells which it is.
_HDF5 = b"\x89HDF\r\n\x1a\n"
_LARGEST_RUN = 4 << 30


def kind_of(what: str) -> Kind:
    """What a name or path stands for, by what is there and what is in it.

    Raises
    ------
    InputError
        When it is nothing that a page can show.
    """
    path = Path(what)
    if what in PRESETS:
        return "scenario"
    if os.path.isdir(path):
        return "store"
    if not os.path.lexists(path):
        as_scenario(what, FIELD)  # says which preset may be meant
    if _begins_as_hdf5(path):
        return "run"
    if path.suffix.lower() == ".zarr":
        return "store"
    return _kind_of_text(path)


def payload(what: str, scenario: Scenario | None) -> dict[str, Any]:
    """Plain data of what a user named.

    Parameters
    ----------
    what : str
        A preset, or a path (`kind_of`).
    scenario : Scenario, optional
        What is shown itself, or the object that poses, a steering or an estimate belong to; None for a run and a store,
        which have their own.

    Raises
    ------
    InputError
        When it cannot be read; names `WHAT`.
    """
    kind, path = kind_of(what), Path(what)
    if kind in WITH_SCENARIO:
        read = run_payload if kind == "run" else store_payload
        return {"kind": kind, "name": path.name} | read(path)
    assert scenario is not None
    told, notes = plain_scenario(scenario)
    if kind == "scenario":
        return {"kind": kind, "name": scenario.name, "scenario": told, "notes": notes}
    makers: dict[str, Callable[[Path, Scenario], dict[str, Any]]] = {
        "poses": poses_payload, "object": object_payload, "steering": steering_payload,
    }  # fmt: skip
    made = {"kind": kind, "name": path.name, "scenario": told} | makers[kind](path, scenario)
    return made | {"notes": [*notes, *made["notes"]]}


def _begins_as_hdf5(path: Path) -> bool:
    try:
        # As a plain file of any size that is no pipe or device; the beginning alone is read.
        if not os.path.isfile(path):
            plain_bytes(path, 0)
        with open(path, "rb") as file:
            return file.read(len(_HDF5)) == _HDF5
    except (UnreadableError, OSError, ValueError) as error:
        raise InputError(FIELD, f"{path} ({getattr(error, 'strerror', None) or error})", ALLOWED, _HINT) from None


def _kind_of_text(path: Path) -> Kind:
    """A scenario has a sheet with an outline, an object is some numbers of one; tables go by their headings."""
    if path.suffix.lower() == ".toml":
        data, _ = read_toml(path, FIELD, ALLOWED, _HINT)
        sheet = data.get("sheet")
        whole = "uncertainty" not in data and isinstance(sheet, dict) and "outline" in sheet
        return "scenario" if whole else "object"
    rows, _ = read_rows(path, FIELD, _HINT)
    names = {name for heading in (rows[0][1] if rows else []) for name in possible_names(heading)}
    if {"goal_x", "goal_y", "x", "y"} <= names:
        return "steering"
    if {"x", "y", "angle"} <= names:
        return "poses"
    raise InputError(FIELD, f"{path}, a file of another kind", ALLOWED, _HINT)
