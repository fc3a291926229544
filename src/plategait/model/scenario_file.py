"""Scenarios from and to commented TOML files."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from plategait.errors import check_kind
from plategait.files.output import write_whole
from plategait.files.toml import read_toml
from plategait.model.base import Model, quantity_of
from plategait.model.scenario import Scenario
from plategait.units import Quantity, show


def read_scenario(path: Path | str, field: str = "scenario") -> Scenario:
    """Read a scenario from a TOML file, which errors call `field`.

    Parameters
    ----------
    path : Path or str
        TOML file; numbers as text with units, or bare in SI.
    field : str, optional
        What errors call it.

    Raises
    ------
    InputError
        When the file cannot be read, is no TOML, or a field is not as it must be.
    """
    hint = "plategait scenario --print cheese > cheese.toml"
    data, _ = read_toml(path, field, "a scenario file or a preset's name", hint)
    return Scenario(**_resolve_files(data, Path(path).parent))


def _resolve_files(data: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Names of files in a scenario count from the folder it is in."""
    resolved: dict[str, Any] = {}
    for key, value in data.items():
        if isinstance(value, dict):
            resolved[key] = _resolve_files(value, folder)
        elif key in ("image", "samples") and isinstance(value, str):
            resolved[key] = str(folder / value)
        else:
            resolved[key] = value
    return resolved


def write_scenario(scenario: Scenario, path: Path | str | None = None, notes: Mapping[str, str] | None = None) -> str:
    """Write a scenario as commented TOML that `read_scenario` reads back the same; return the text.

    Parameters
    ----------
    scenario : Scenario
        What to write.
    path : Path or str, optional
        File that ends in .toml, written whole or not at all; without one the text is returned alone.
    notes : mapping of str to str, optional
        Remarks by dotted field name ("sheet.mass"), added to the comments.

    Raises
    ------
    InputError
        For what is no scenario, or when the file cannot be written.
    """
    check_kind(scenario, Scenario, "scenario", 'preset("cheese").scenario')
    check_kind(notes, (Mapping, type(None)), "notes", '{"sheet.mass": "weighed"}')
    text = "\n".join(_table(scenario, "", notes or {})).strip() + "\n"
    if path is not None:
        check_kind(path, (str, Path), "path", '"mine.toml"')
        write_whole(text.encode(), path, (".toml",), "path")
    return text


def _table(model: Model, prefix: str, notes: Mapping[str, str]) -> list[str]:
    lines: list[str] = []
    nested: list[str] = []
    for name, field in type(model).model_fields.items():
        value = getattr(model, name)
        dotted = f"{prefix}{name}"
        remark = "; ".join(filter(None, [field.description, notes.get(dotted)]))
        if name == "offset" and value == field.get_default(call_default_factory=True):
            continue
        if isinstance(value, Model) and name != "samples":
            nested += ["", f"# {remark}" if remark else "", f"[{dotted}]", *_table(value, f"{dotted}.", notes)]
            continue
        if value is None or value == ():
            if not field.is_required() and name in ("plate", "transient", "time_step"):
                lines.append(f"# {name} is left out: {remark}")
            continue
        quantity = quantity_of(type(model), name)
        lines.append(f"{name} = {_literal(value, quantity)}" + (f"  # {remark}" if remark else ""))
    return [*lines, *nested]


def _literal(value: object, quantity: Quantity | None) -> str:
    """One value as TOML."""
    if quantity is not None and isinstance(value, float) and quantity.unit:
        text = show(value, quantity.unit, quantity.display)
        # Text must come back as the very same number: a run from the file gives the run's bits.
        return f'"{text}"' if quantity.read(text, "") == value else repr(value)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else str(value)
    if isinstance(value, (tuple, list)):
        return "[" + ", ".join(_literal(item, None) for item in value) + "]"
    if isinstance(value, Model):
        items = ((name, getattr(value, name)) for name in type(value).model_fields)
        return (
            "{ "
            + ", ".join(f"{name} = {_literal(item, None)}" for name, item in items if item not in (None, ()))
            + " }"
        )
    # JSON's escapes are TOML's too, save that TOML has no bare DEL.
    return json.dumps(str(value), ensure_ascii=False).replace("\x7f", "\\u007F")
