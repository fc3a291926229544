"""What a sweep may vary: any number or word of a scenario by its dotted name, and two shorthands."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any, Literal, get_args, get_origin

from plategait.errors import InputError
from plategait.model import Model
from plategait.scenario import Scenario
from plategait.units import ANGULAR_FREQUENCY, Quantity, show

Value = float | str

_FRICTION_ANGLE = Quantity("rad", "deg", "36.87 deg", at_least=0)
# Shorthands: each changes more than one field.
SHORTHANDS = {"natural_frequency": ANGULAR_FREQUENCY, "friction_angle": _FRICTION_ANGLE}
MOST_VALUES = 1_000_000


@dataclass(frozen=True)
class Parameter:
    """One thing that a sweep varies.

    Attributes
    ----------
    name : str
        Dotted ("motion.frequency"), or a shorthand.
    quantity : Quantity or None
        What it measures; None for a word such as ``friction.law``.
    """

    name: str
    quantity: Quantity | None

    @property
    def unit(self) -> str:
        """SI unit, empty for a plain number or a word."""
        return self.quantity.unit if self.quantity else ""

    def read(self, value: object) -> Value:
        """One value: a bare SI number, text with a unit, or a word."""
        if self.quantity is not None:
            return self.quantity.read(value, self.name)
        if not isinstance(value, str):
            raise InputError(self.name, value, "a word", '"thesis"')
        return value

    def read_values(self, given: object) -> tuple[Value, ...]:
        """Read a list of values, a range "12:30:1 Hz", or ``{from = "12 Hz", to = "30 Hz", count = 19}``."""
        if isinstance(given, str) and self.quantity is not None and given.count(":") == 2:
            given = self._range(given)
        elif isinstance(given, Mapping):
            given = self._spread(given)
        if isinstance(given, (str, bytes)) or not hasattr(given, "__iter__"):
            raise InputError(self.name, given, "a list of values, or a range", f"[{self.example}]")
        values = tuple(self.read(v.item() if hasattr(v, "item") else v) for v in given)  # type: ignore[union-attr]
        if not values:
            raise InputError(self.name, "nothing in the list", "at least one value", f"[{self.example}]")
        return values

    @property
    def example(self) -> str:
        """A value that works."""
        return f'"{self.quantity.example}"' if self.quantity else '"thesis"'

    def shown(self, value: Value) -> str:
        """Text with the unit that people write."""
        if self.quantity is None or isinstance(value, str):
            return str(value)
        return show(float(f"{value:.12g}"), self.quantity.unit, self.quantity.display)

    def _range(self, text: str) -> list[str]:
        pieces = [piece.strip() for piece in text.split(":")]
        unit = pieces[-1].lstrip("0123456789.eE+- ")
        first = step = count = 0.0
        try:
            first, last, step = (float(piece.removesuffix(unit)) for piece in pieces)
            count = (last - first) / step + 1
        except (ValueError, ZeroDivisionError):
            count = 0.0
        if not 1 <= count <= MOST_VALUES:
            hint = f'"10:20:1 {self.quantity.display if self.quantity else ""}"'
            raise InputError(self.name, text, "first:last:step with one unit at the end, last not below first", hint)
        return [f"{first + i * step:.12g} {unit}".strip() for i in range(int(count + 1e-6))]

    def _spread(self, given: Mapping[str, Any]) -> list[float]:
        import numpy as np

        hint = f"{{ from = {self.example}, to = {self.example}, count = 10 }}"
        if set(given) != {"from", "to", "count"} or self.quantity is None:
            raise InputError(self.name, dict(given), "from, to and count", hint)
        count = given["count"]
        if isinstance(count, bool) or not isinstance(count, int) or not 1 <= count <= MOST_VALUES:
            raise InputError(f"{self.name}.count", count, "a whole number above 0", "10")
        first, last = (self.quantity.read(given[end], f"{self.name}.{end}") for end in ("from", "to"))
        return [float(v) for v in np.linspace(first, last, count)]


def find_parameter(scenario: Scenario, name: str) -> Parameter:
    """Parameter of a scenario by its dotted name or shorthand.

    Raises
    ------
    InputError
        For a name that the scenario has not, with the nearest that it has.
    """
    if name in SHORTHANDS:
        return Parameter(name, SHORTHANDS[name])
    known = _leaves(scenario, "")
    if name in known:
        return Parameter(name, known[name])
    names = [*SHORTHANDS, *known]
    alike = [n for n in names if n.rsplit(".", 1)[-1] == name.rsplit(".", 1)[-1]]
    close = alike or difflib.get_close_matches(name, names, n=1, cutoff=0.4) or ["motion.frequency"]
    raise InputError(
        name, "nothing that can be swept", "a number or word of the scenario, by its dotted name", close[0]
    )


def apply(scenario: Scenario, values: Mapping[str, Value], nominal: float | None = None) -> Scenario:
    """Scenario with parameters set.

    Parameters
    ----------
    values : mapping
        SI numbers and words by name. The shorthands are applied last.
    nominal : float, optional
        What the sheet's own natural frequency is taken to be, rad/s (`Sheet.with_natural_frequency`).
    """
    fields = {name: value for name, value in values.items() if name not in SHORTHANDS}
    changed: Scenario = scenario.replace(**fields) if fields else scenario
    if "natural_frequency" in values:
        sheet = changed.sheet.with_natural_frequency(values["natural_frequency"], nominal)
        changed = changed.replace(sheet=sheet)
    if "friction_angle" in values:
        changed = changed.replace(friction=changed.friction.with_angle(values["friction_angle"]))
    return changed


def _leaves(model: Model, prefix: str) -> dict[str, Quantity | None]:
    """Every number and word inside a model by its dotted name."""
    found: dict[str, Quantity | None] = {}
    for name, field in type(model).model_fields.items():
        value = getattr(model, name)
        quantity = next((m for m in field.metadata if isinstance(m, Quantity)), None) or _quantity(field.annotation)
        if isinstance(value, Model):
            found |= _leaves(value, f"{prefix}{name}.")
        elif quantity is not None or (get_origin(field.annotation) is Literal and name != "shape"):
            found[f"{prefix}{name}"] = quantity
    return found


def _quantity(annotation: Any) -> Quantity | None:
    """What an optional field measures."""
    for part in get_args(annotation):
        if get_origin(part) is Annotated:
            return next((m for m in part.__metadata__ if isinstance(m, Quantity)), None)
    return None
