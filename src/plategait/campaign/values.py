"""How a sweep is told the values of a parameter: a list, a range, or ends and a count."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from plategait.errors import InputError
from plategait.model.parameters import Parameter, Value

MOST_VALUES = 1_000_000


def read_values(parameter: Parameter, written: object) -> tuple[Value, ...]:
    """Read a list of values, a range "12:30:1 Hz", or ``{from = "12 Hz", to = "30 Hz", count = 19}``.

    Raises
    ------
    InputError
        For anything else, or a value that the parameter cannot have.
    """
    if isinstance(written, str) and parameter.quantity is not None and written.count(":") == 2:
        written = _range(parameter, written)
    elif isinstance(written, Mapping):
        written = _spread(parameter, written)
    if isinstance(written, (str, bytes)) or not hasattr(written, "__iter__"):
        raise InputError(parameter.name, written, "a list of values, or a range", f"[{parameter.example}]")
    values = tuple(parameter.read(v.item() if hasattr(v, "item") else v) for v in written)  # type: ignore[union-attr]
    if not values:
        raise InputError(parameter.name, "nothing in the list", "at least one value", f"[{parameter.example}]")
    return values


def _range(parameter: Parameter, text: str) -> list[str]:
    pieces = [piece.strip() for piece in text.split(":")]
    unit = pieces[-1].lstrip("0123456789.eE+- ")
    first = step = count = 0.0
    try:
        first, last, step = (float(piece.removesuffix(unit)) for piece in pieces)
        count = (last - first) / step + 1
    except (ValueError, ZeroDivisionError):
        count = 0.0
    if not 1 <= count <= MOST_VALUES:
        hint = f'"10:20:1 {parameter.quantity.display if parameter.quantity else ""}"'
        raise InputError(parameter.name, text, "first:last:step with one unit at the end, last not below first", hint)
    return [f"{first + i * step:.12g} {unit}".strip() for i in range(int(count + 1e-6))]


def _spread(parameter: Parameter, written: Mapping[str, Any]) -> list[float]:
    import numpy as np

    quantity, name = parameter.quantity, parameter.name
    hint = f"{{ from = {parameter.example}, to = {parameter.example}, count = 10 }}"
    if set(written) != {"from", "to", "count"} or quantity is None:
        if {"from", "to"} <= set(written):
            hint = f'{{ from = "{written["from"]}", to = "{written["to"]}", count = 10 }}'
        raise InputError(name, f"a table of {', '.join(written) or 'nothing'}", "from, to and count", hint)
    count = written["count"]
    if isinstance(count, bool) or not isinstance(count, int) or not 1 <= count <= MOST_VALUES:
        raise InputError(f"{name}.count", count, "a whole number above 0", "10")
    first, last = (quantity.read(written[end], f"{name}.{end}") for end in ("from", "to"))
    return [float(v) for v in np.linspace(first, last, count)]
