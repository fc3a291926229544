"""What a page is made of: what a user named, told apart by what is in it, as plain data of bounded size."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
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
from plategait.lab.steering_payload import table_payload, whole_payload
from plategait.lab.store_payload import store_payload
from plategait.model.presets import PRESETS, as_scenario
from plategait.model.scenario import Scenario

Kind = Literal["scenario", "run", "store", "poses", "object", "steering"]
FIELD = "WHAT"
ALLOWED = "a preset, a scenario or an object (.toml), a run (.nc), a store (.zarr), poses or a steering (.csv, .json)"
_HINT = "plategait lab cheese"
# Beginning of HDF5 files.
_HDF5 = b"\x89HDF\r\n\x1a\n"


@dataclass(frozen=True)
class Named:
    """What a user named.

    Attributes
    ----------
    kind : str
    name : str
        Of the preset, or the path.
    own_scenario : bool
        Whether it brings its scenario, which nothing is laid over.
    """

    kind: Kind
    name: str
    own_scenario: bool = False

    def payload(self, scenario: Scenario | None = None) -> dict[str, Any]:
        """Plain data of it.

        Parameters
        ----------
        scenario : Scenario, optional
            What is shown itself, or the object that poses, a steering or an estimate belong to; None for what brings
            its own.

        Raises
        ------
        InputError
            When it cannot be read; names `WHAT`.
        """
        path = Path(self.name)
        if self.own_scenario:
            read: dict[str, Callable[[Path], dict[str, Any]]] = {
                "run": run_payload, "store": store_payload, "steering": whole_payload,
            }  # fmt: skip
            return {"kind": self.kind, "name": path.name} | read[self.kind](path)
        assert scenario is not None
        told, notes = plain_scenario(scenario)
        if self.kind == "scenario":
            return {"kind": self.kind, "name": scenario.name, "scenario": told, "notes": notes}
        made = (
            object_payload(path, scenario)
            if self.kind == "object"
            else {"scenario": told} | (poses_payload if self.kind == "poses" else table_payload)(path)
        )
        return {"kind": self.kind, "name": path.name} | made | {"notes": [*notes, *made["notes"]]}


def named(what: str) -> Named:
    """What a name or path stands for, by what is there and what is in it.

    Raises
    ------
    InputError
        When it is nothing that a page can show.
    """
    path = Path(what)
    if what in PRESETS:
        return Named("scenario", what)
    if os.path.isdir(path):
        return Named("store", what, own_scenario=True)
    if not os.path.lexists(path):
        as_scenario(what, FIELD)  # says which preset may be meant
    beginning = _beginning(path)
    if beginning.startswith(_HDF5):
        return Named("run", what, own_scenario=True)
    if path.suffix.lower() == ".zarr":
        return Named("store", what, own_scenario=True)
    if beginning.lstrip().startswith(b"{"):
        return Named("steering", what, own_scenario=True)
    return Named(_kind_of_text(path), what)


def _beginning(path: Path) -> bytes:
    try:
        # As a plain file of any size, which a pipe or device is not; the beginning alone is read.
        if not os.path.isfile(path):
            plain_bytes(path, 0)
        with open(path, "rb") as file:
            return file.read(64)
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
