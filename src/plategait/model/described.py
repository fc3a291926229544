"""What a model's docstring and signature say of its fields: name, unit, what to type, and what it is."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, Annotated, Any, get_args, get_origin

from plategait.units import Quantity

if TYPE_CHECKING:
    from pydantic.fields import FieldInfo

_MARK = "Parameters\n----------\n"


def documented(text: str, fields: dict[str, FieldInfo]) -> str:
    """Docstring with a section on the fields in NumPy style, behind its description and before the sections it has."""
    if _MARK in text or not fields:
        return text
    section = _MARK + "\n".join(_entry(name, field) for name, field in fields.items())
    raises = "\n\nRaises\n------\nInputError\n    When a field is missing, unknown or not as said; tells what to type."
    said, examples, rest = text.partition("\n\nExamples\n")
    return f"{said}\n\n{section}{raises}{examples}{rest}"


def signature_of(fields: dict[str, FieldInfo]) -> inspect.Signature:
    """Signature of a model in words that people read; those without a default come first."""
    ordered = sorted(fields.items(), key=lambda item: not item[1].is_required())
    return inspect.Signature([
        inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=_default(field), annotation=_kind(field))
        for name, field in ordered
    ])  # fmt: skip


def quantity_inside(annotation: Any) -> Quantity | None:
    """What the numbers measure that may be left out, or are listed."""
    if get_origin(annotation) is Annotated:
        return next((m for m in annotation.__metadata__ if isinstance(m, Quantity)), None)
    return next(filter(None, map(quantity_inside, get_args(annotation))), None)


def _quantity(field: FieldInfo) -> Quantity | None:
    own = next((m for m in field.metadata if isinstance(m, Quantity)), None)
    return own or quantity_inside(field.annotation)


def _entry(name: str, field: FieldInfo) -> str:
    """One field, as NumPy's docstrings have parameters."""
    quantity, said = _quantity(field), field.description or ("which kind it is" if name == "shape" else "")
    parts = [said or name]
    if quantity and quantity.unit:
        parts.append(f'in {quantity.unit}, or as text: "{quantity.example}"')
    if not field.is_required() and (default := _shown(_default(field), quantity)) and name != "shape":
        parts.append(f"{default} if left out")
    optional = "" if field.is_required() else ", optional"
    return f"{name} : {_kind(field)}{optional}\n    {'; '.join(parts)}."


def _default(field: FieldInfo) -> Any:
    if field.is_required():
        return inspect.Parameter.empty
    return field.get_default(call_default_factory=True) if field.default_factory is None else None


def _shown(value: Any, quantity: Quantity | None) -> str:
    """A default as people read it; empty where it is nothing."""
    if value is None or value in ((), {}):
        return ""
    if quantity and quantity.unit and isinstance(value, float):
        return f"{value:.6g} {quantity.unit}"
    return repr(value)


def _kind(field: FieldInfo) -> str:
    """Type of a field in a word or two."""
    if field.annotation is float or (field.annotation is not None and _is_number(field.annotation)):
        quantity = _quantity(field)
        return "float or str" if quantity and quantity.unit else "float"
    return _named(field.annotation)


def _is_number(annotation: Any) -> bool:
    if get_origin(annotation) is Annotated:
        return annotation.__args__[0] is float
    parts = [part for part in get_args(annotation) if part is not type(None)]
    return len(parts) == 1 and get_origin(annotation) is not tuple and _is_number(parts[0])


def _named(annotation: Any) -> str:
    """Name of a type; those of a union one after the other."""
    if annotation is type(None) or annotation is None:
        return "None"
    if isinstance(annotation, type) and not get_args(annotation):
        return annotation.__name__
    origin, parts = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        return _named(parts[0])
    if origin is tuple:
        return f"tuple of {_named(parts[0])}"
    if origin is dict:
        return "dict"
    if parts and all(isinstance(part, str) for part in parts):
        return "{" + ", ".join(repr(part) for part in parts) + "}"
    return " or ".join(_named(part) for part in parts) if parts else str(annotation)
