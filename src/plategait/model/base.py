"""The base of everything that is simulated: frozen, validated, and plain about what is wrong."""

from __future__ import annotations

import difflib
import inspect
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, Self, get_args

from pydantic import BaseModel, ConfigDict, ValidationError
from pydantic_core import ErrorDetails

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.model.described import documented, quantity_inside, signature_of
from plategait.units import Quantity

if TYPE_CHECKING:
    from pydantic.fields import FieldInfo

    class _Fields:
        """A base that lets a type checker pass text with a unit where a field holds a float."""

        model_fields: ClassVar[dict[str, FieldInfo]]
        model_fields_set: set[str]
else:
    _Fields = BaseModel


@dataclass(frozen=True, eq=False)
class Kept:
    """An array that a model works out once: models compare what they keep, which arrays do not bear."""

    array: Array | None


# Elements of a list that a description shows of itself.
_MOST_SHOWN = 8


class _Many:
    """So many elements, in place of them."""

    def __init__(self, count: int) -> None:
        self.count = count

    def __repr__(self) -> str:
        """How many they are."""
        return f"({self.count} …)"


# What people call a field, which is spelt otherwise: the field, and what to type.
_MEANT: Mapping[str, Sequence[tuple[str, str]]] = {
    "diameter": (("radius", "radius, half of it"),),
    "height": (("width", "width"), ("thickness", "thickness")),
    "size": (("length", "length and width"), ("radius", "radius")),
    "points": (("corners", "corners"),),
    "vertices": (("corners", "corners"),),
    "weight": (("mass", "mass"),),
    "amplitude": (("angle", "angle for the rocking, stroke for the sliding"),),
    "position": (("x", "x and y"),),
    "mu": (("static", "static"),),
    "nu": (("poisson_ratio", "poisson_ratio"),),
    "rho": (("density", "density"),),
}

_TAGS: set[str] = set()
"""Shapes by which parts of a union are told apart: one of each model with a field `shape`."""


class Model(_Fields):
    """A frozen description. Bad input raises `InputError`, one line that says what to type."""

    also_read: ClassVar[tuple[str, ...]] = ()
    """Names that are no fields and may be given all the same, as a validator makes fields of them."""
    model_config: ClassVar[ConfigDict] = ConfigDict(frozen=True, extra="forbid", arbitrary_types_allowed=True)

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:
        """Say in its docstring what its fields are; take note of the shape that a new kind of outline goes by."""
        cls.__doc__ = documented(inspect.cleandoc(cls.__doc__ or ""), cls.model_fields)
        cls.__signature__ = signature_of(cls.model_fields)
        if "shape" in cls.model_fields:
            _TAGS.add(cls.model_fields["shape"].default)

    def __init__(self, *unnamed: object, **data: Any) -> None:
        if unnamed:
            raise _named_instead(type(self), unnamed[0])
        try:
            super().__init__(**data)
        except ValidationError as error:
            details = error.errors()
            # A misspelt name is the cause where the right one is missing.
            first = next((detail for detail in details if detail["type"] == "extra_forbidden"), details[0])
            raise _input_error(type(self), first) from None

    def __setattr__(self, name: str, value: object) -> None:
        """Refuse the change, as every model is frozen, and say how a changed copy is made."""
        try:
            super().__setattr__(name, value)
        except ValidationError:
            raise InputError(name, in_words(value), f"set in a copy, as a {type(self).__name__} is frozen",
                             f".replace({name}=…)") from None  # fmt: skip

    def __repr_args__(self) -> Any:
        """Fields for people: those of many numbers, such as a sampled trajectory, by how many they are."""
        for name, value in super().__repr_args__():  # type: ignore[misc]
            long = isinstance(value, tuple) and len(value) > _MOST_SHOWN
            yield name, _Many(len(value)) if long else value

    def replace(self, **changes: Any) -> Any:
        """Copy with some fields changed, validated anew.

        Dotted names reach inside: ``{"sheet.pitch": "5 mm"}``, ``{"motion.waves.0.phase": "90 deg"}``.
        """
        return type(self)(**self.fields_with(changes))

    def with_valid(self, **fields: Any) -> Self:
        """Copy with some fields replaced by what is known to be valid: nothing is checked, which takes no time."""
        own = {name: getattr(self, name) for name in type(self).model_fields}
        return type(self).model_construct(**own | fields)  # type: ignore[attr-defined]

    def fields_with(self, changes: Mapping[str, Any]) -> dict[str, Any]:
        """All fields with some changed, each part validated anew but not yet the whole; names as in `replace`."""
        fields = {name: getattr(self, name) for name in type(self).model_fields}
        own, inside = _by_part(changes)
        fields |= own
        for name, nested in inside.items():
            if name not in type(self).model_fields:
                raise unknown_field(type(self), name)
            fields[name] = _part_with(fields[name], nested, name, f"{name} = {_example(type(self), name)}")
        return fields

    def quantity(self, name: str) -> Quantity | None:
        """What a field measures here, if it is given, or the numbers listed in it; None where it is no number."""
        return quantity_of(type(self), name) or quantity_inside(type(self).model_fields[name].annotation)


def quantity_of(model: type[Model], name: str) -> Quantity | None:
    """What a field measures; None where it is no number, or there is no such field."""
    metadata = model.model_fields[name].metadata if name in model.model_fields else []
    return next((m for m in metadata if isinstance(m, Quantity)), None)


def _by_part(changes: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, dict[str, Any]]]:
    """Changes of fields themselves, and of what is inside them, by field."""
    own: dict[str, Any] = {}
    inside: dict[str, dict[str, Any]] = {}
    for name, value in changes.items():
        head, dot, rest = name.partition(".")
        if dot:
            inside.setdefault(head, {})[rest] = value
        else:
            own[name] = value
    return own, inside


def _part_with(part: Any, changes: Mapping[str, Any], name: str, hint: str) -> Any:
    """Part of a model with some of what is inside it changed: fields of a model, elements of a list by their number."""
    try:
        if isinstance(part, Model):
            return part.replace(**changes)
        if isinstance(part, tuple) and part:
            return _elements_with(part, changes)
    except InputError as error:
        raise InputError(f"{name}.{error.field}", error.got, error.allowed, error.hint) from None
    rest, value = next(iter(changes.items()))
    raise InputError(f"{name}.{rest}", value, f"left out, as {name} has no fields here", hint)


def _elements_with(part: tuple[Any, ...], changes: Mapping[str, Any]) -> tuple[Any, ...]:
    elements = {str(i): element for i, element in enumerate(part)}
    own, inside = _by_part(changes)
    for number in (*own, *inside):
        if number not in elements:
            raise InputError(number, "nothing known by that number", f"from 0 to {len(part) - 1}", "0")
    elements |= own
    for number, nested in inside.items():
        elements[number] = _part_with(elements[number], nested, number, number)
    return tuple(elements.values())


def unknown_field(model: type[Model], name: str) -> InputError:
    """What to raise for a name that a model does not know, with the nearest that it does."""
    fields = [*model.model_fields, *model.also_read]
    inside = {dotted.rpartition(".")[2]: dotted for dotted in reversed(_names_inside(model))}
    close = (
        [hint for field, hint in _MEANT.get(name, ()) if field in fields]
        or ([inside[name]] if name in inside else [])
        or difflib.get_close_matches(name, fields, n=1)
        or [field for field in fields if f"_{name}_" in f"_{field}_" or (len(name) > 2 and field.startswith(name))]
        or [inside[found] for found in difflib.get_close_matches(name, inside, n=1, cutoff=0.8)]
        or difflib.get_close_matches(name, fields, n=1, cutoff=0.5)
    )  # fmt: skip
    hint = close[0] if close else "leaving it out"
    return InputError(name, "nothing known by that name", f"one of {', '.join(fields)}", hint)


def _names_inside(model: type[Model]) -> list[str]:
    """Dotted names of what the parts of a model know."""
    parts = [
        (field, part)
        for field, info in model.model_fields.items()
        for part in (info.annotation, *get_args(info.annotation))
        if isinstance(part, type) and issubclass(part, Model)
    ]
    return [f"{field}.{name}" for field, part in parts for name in (*part.model_fields, *part.also_read)]


def _example(model: type[Model], name: str) -> str:
    """What to type for a field."""
    quantity = quantity_of(model, name)
    return f'"{quantity.example}"' if quantity else str((model.model_fields[name].examples or ["leaving it out"])[0])


def _named_instead(model: type[Model], got: object) -> InputError:
    """What to raise for a value without a name: fields have no order to rely on."""
    name = next((n for n, field in model.model_fields.items() if field.is_required()), next(iter(model.model_fields)))
    value = repr(got) if isinstance(got, (str, int, float)) else "…"
    return InputError(model.__name__, in_words(got), f"told its fields by name: {', '.join(model.model_fields)}",
                      f"{model.__name__}({name}={value})")  # fmt: skip


def in_words(got: object) -> object:
    """What was got, of a model only its kind: all that is in it would hide the rest of the line."""
    return f"a {type(got).__name__}" if isinstance(got, Model) else got


def _table(model: type[Model], name: str) -> tuple[str, str]:
    """What a part must be, and one that works, in a file and in Python."""
    kinds = _kinds(model.model_fields[name].annotation)
    if not kinds:
        return "a table of its fields", _example(model, name)
    example = _example(model, name)
    if not example.startswith(("{", "[")):
        field = next((n for n in kinds[0].model_fields if quantity_of(kinds[0], n)), "")
        example = f"{{ {field} = {_example(kinds[0], field)} }}" if field else example
    names = " or ".join(filter(None, [", ".join(kind.__name__ for kind in kinds[:-1]), kinds[-1].__name__]))
    return f"a table of its fields, or in Python a {names}", example


def _kinds(annotation: object) -> list[type[Model]]:
    """Models that a part may be, whatever they are wrapped in."""
    if isinstance(annotation, type) and issubclass(annotation, Model):
        return [annotation]
    return [kind for inner in get_args(annotation) for kind in _kinds(inner)]


# What pydantic calls a number or word of the wrong kind.
_IN_WORDS = {
    "int": "a whole number", "float": "a number", "bool": "true or false", "string": "text", "tuple": "a list",
    "list": "a list", "dict": "a table",
}  # fmt: skip


def _input_error(model: type[Model], detail: ErrorDetails) -> InputError:
    """Turn one finding of pydantic's into our one line."""
    inner = detail.get("ctx", {}).get("error")
    # The tags of a union of shapes are no part of a name that a user typed.
    path = [str(part) for i, part in enumerate(detail["loc"]) if i == 0 or part not in _TAGS]
    field = ".".join(path)
    if isinstance(inner, InputError):
        return InputError(".".join(filter(None, [field, inner.field])), inner.got, inner.allowed, inner.hint)
    kind, got = detail["type"], detail.get("input")
    got = in_words(got)
    if kind == "extra_forbidden":
        return unknown_field(model, field)
    if kind == "missing" and len(path) == 1:
        return InputError(field, "nothing", "given", f"{field} = {_example(model, field)}")
    if kind in ("union_tag_not_found", "union_tag_invalid"):
        shape = got.get("shape", "nothing") if isinstance(got, Mapping) else got
        close = difflib.get_close_matches(str(shape), _TAGS, n=1) or ["disk"]
        return InputError(f"{field}.shape", shape, f"one of {', '.join(sorted(_TAGS))}", f'"{close[0]}"')
    if kind == "literal_error":
        expected = str(detail["ctx"]["expected"])  # type: ignore[typeddict-item]
        return InputError(field, got, f"one of {expected}", expected.split(" or ")[0].split(",")[0])
    _, _, allowed = detail["msg"].partition("Input should be ")
    hint = _example(model, path[0])
    if kind.startswith("model_") and len(path) == 2 and isinstance(got, tuple):  # the fields of a model, one by one
        allowed, hint, field, got = "a list", f"{path[0]}=[…]", path[0], "one alone"
    elif kind.startswith("model_"):
        allowed, hint = _table(model, path[0])
    else:
        allowed = _IN_WORDS.get(kind.partition("_")[0], allowed)
        hint = "3" if allowed == "a whole number" and hint == "leaving it out" else hint
    return InputError(field, got, allowed or "of the right form", hint)
