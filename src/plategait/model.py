"""The base of everything that is simulated: frozen, validated, and plain about what is wrong."""

from __future__ import annotations

import difflib
from typing import TYPE_CHECKING, Any, ClassVar

from pydantic import BaseModel, ConfigDict, ValidationError
from pydantic_core import ErrorDetails

from plategait.errors import InputError

if TYPE_CHECKING:
    from pydantic.fields import FieldInfo

    class _Fields:
        """A base that lets a type checker pass text with a unit where a field holds a float."""

        model_fields: ClassVar[dict[str, FieldInfo]]
else:
    _Fields = BaseModel


class Model(_Fields):
    """A frozen description. Bad input raises `InputError`, one line that says what to type."""

    model_config: ClassVar[ConfigDict] = ConfigDict(frozen=True, extra="forbid", arbitrary_types_allowed=True)

    def __init__(self, **data: Any) -> None:
        try:
            super().__init__(**data)
        except ValidationError as error:
            raise _input_error(type(self), error.errors()[0]) from None

    def replace(self, **changes: Any) -> Any:
        """Copy with some fields changed, validated anew. Dotted names reach inside: ``{"sheet.pitch": "5 mm"}``."""
        here: dict[str, Any] = {}
        inside: dict[str, dict[str, Any]] = {}
        for name, value in changes.items():
            head, _, rest = name.partition(".")
            if not rest:
                here[head] = value
            elif isinstance(getattr(self, head, None), Model):
                inside.setdefault(head, {})[rest] = value
            else:
                raise _unknown_field(type(self), head)
        for name, nested in inside.items():
            try:
                here[name] = getattr(self, name).replace(**nested)
            except InputError as error:
                raise InputError(f"{name}.{error.field}", error.got, error.allowed, error.hint) from None
        kept = {name: getattr(self, name) for name in type(self).model_fields}
        return type(self)(**{**kept, **here})


def _unknown_field(model: type[Model], name: str) -> InputError:
    known = list(model.model_fields)
    close = difflib.get_close_matches(name, known, n=1)
    return InputError(name, "nothing known by that name", f"one of {', '.join(known)}", close[0] if close else known[0])


def _input_error(model: type[Model], detail: ErrorDetails) -> InputError:
    """Turn pydantic's first finding into our one line."""
    inner = detail.get("ctx", {}).get("error")
    # The tags of a union of shapes are no part of a name that a user typed.
    path = [str(part) for part in detail["loc"] if not (isinstance(part, str) and part in _TAGS)]
    field = ".".join(path)
    if isinstance(inner, InputError):
        return InputError(".".join(filter(None, [field, inner.field])), inner.got, inner.allowed, inner.hint)
    kind, got = detail["type"], detail.get("input")
    if kind == "extra_forbidden" and len(path) == 1:
        return _unknown_field(model, field)
    if kind == "missing":
        return InputError(field, "nothing", "given", f'{path[-1]} = "…"')
    if kind == "quantity":
        context = detail.get("ctx", {})
        return InputError(field, got, context["allowed"], context["hint"])
    if kind in ("union_tag_not_found", "union_tag_invalid"):
        return InputError(f"{field}.shape", got, f"one of {', '.join(sorted(_TAGS))}", '"disk"')
    if kind == "literal_error":
        expected = str(detail["ctx"]["expected"])  # type: ignore[typeddict-item]
        return InputError(field, got, f"one of {expected}", expected.split(" or ")[0].split(",")[0])
    message = detail["msg"].removeprefix("Input should be ")
    return InputError(field or model.__name__.lower(), got, message, "a value of that kind")


_TAGS = {"disk", "ellipse", "rectangle", "polygon", "mask"}
