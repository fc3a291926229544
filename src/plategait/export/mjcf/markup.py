"""Elements of MJCF: attributes from numbers and words."""

from __future__ import annotations

from collections.abc import Iterable
from xml.etree import ElementTree as ET

Value = str | bool | int | float | Iterable[float]


def add(parent: ET.Element, tag: str, **attributes: Value) -> ET.Element:
    """Add an element; a trailing `_` of a name is left out."""
    return ET.SubElement(parent, tag, {name.rstrip("_"): _text(value) for name, value in attributes.items()})


def _text(value: Value) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return f"{value:.12g}"
    return " ".join(f"{v:.12g}" for v in value)
