"""Menus kept in files, as finding one takes longer than steering by it."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from plategait.control.menu import ACCELERATION, GENERATIONS, Menu, drive_of, menu_of
from plategait.control.response import Field, Response
from plategait.control.room import on_a_plate
from plategait.errors import InputError
from plategait.files.input import read_text
from plategait.files.output import check_writable, write_whole
from plategait.model.machine import Machine, machine_of
from plategait.model.motion import PlateMotion
from plategait.model.scenario import Scenario
from plategait.moves.report import motion_fields

SUFFIXES = (".json",)
_ARRAYS = ("rates", "lags", "spread", "failed")
_MOST_BYTES = 64 << 20
_ALLOWED = "a menu that plategait steer --menu wrote"


def kept_menu(
    path: Path | str | None,
    scenario: Scenario,
    machine: Machine | Path | str = "source-robot",
    *,
    generations: int = GENERATIONS,
    seed: int = 0,
    progress: Callable[[float], object] | None = None,
    field: str = "menu",
) -> Menu:
    """Menu of a file; where there is no such file yet it is found, and written there.

    Parameters
    ----------
    path : Path or str, optional
        Of the file, .json; without one the menu is found and not kept.
    scenario, machine, generations, seed, progress
        As of `menu_of`.
    field : str
        What errors call the path.

    Raises
    ------
    InputError
        For a file that is no menu, or that of another object, machine or search; as `menu_of`.
    """
    shaker = machine_of(machine)
    asked = _identity(scenario, shaker, generations, seed)
    if path is not None and Path(path).is_file():
        return _read(Path(path), asked, scenario, shaker, field)
    if path is not None:
        check_writable(path, SUFFIXES, field)
    menu = menu_of(scenario, shaker, generations=generations, seed=seed, progress=progress)
    if path is not None:
        told = {
            "kept for": asked,
            "reach_m": menu.reach,
            "actions": menu.actions.tolist(),
            "motions": [motion_fields(motion) for motion in menu.motions],
            "field": {"powers": menu.response.field.powers, "reach_m": menu.response.field.reach},
            "response": {name: getattr(menu.response, name).tolist() for name in _ARRAYS},
        }
        write_whole(json.dumps(told, indent=1, ensure_ascii=False).encode(), path, SUFFIXES, field)
    return menu


def _identity(scenario: Scenario, machine: Machine, generations: int, seed: int) -> dict[str, Any]:
    """What a menu depends on."""
    placed = on_a_plate(scenario)
    parts = ("sheet", "plate", "motion", "contact", "friction", "gravity")
    told = {name: repr(getattr(placed, name)) for name in parts}
    return told | {"machine": repr(machine), "generations": generations, "seed": seed,
                   "acceleration": ACCELERATION}  # fmt: skip


def _read(path: Path, asked: dict[str, Any], scenario: Scenario, machine: Machine, field: str) -> Menu:
    try:
        told = json.loads(read_text(path, _MOST_BYTES, field, _ALLOWED, "menu.json"))
        kept = dict(told["kept for"])
        motions = tuple(PlateMotion(**fields_) for fields_ in told["motions"])
        arrays = {name: np.array(told["response"][name], dtype=bool if name == "failed" else float) for name in _ARRAYS}
        powers = tuple((int(i), int(j)) for i, j in told["field"]["powers"])
        response = Response(**arrays, field=Field(powers, float(told["field"]["reach_m"])))
        reach, actions = float(told["reach_m"]), np.array(told["actions"], dtype=float)
        shapes = [np.shape(array)[0] for array in (actions, *arrays.values())]
    except (ValueError, TypeError, KeyError, AttributeError, IndexError):
        raise InputError(field, str(path), _ALLOWED, f"another name, such as {path.stem}-new.json") from None
    if kept != asked or set(shapes) != {len(motions)}:
        other = [name for name in asked if kept.get(name) != asked[name]]
        raise InputError(field, f"{path}, whose {' and '.join(other) or 'contents'} differ",
                         "that of the same object, plate, machine and search",
                         f"another name, such as {path.stem}-new.json")  # fmt: skip
    placed = on_a_plate(scenario)
    return Menu(placed, drive_of(placed, machine), motions, actions, response, reach)
