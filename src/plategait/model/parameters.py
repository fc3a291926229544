"""Any number or word of a scenario by its dotted name: what it measures, how it is read and set, and the shorthands.

Sweeps, measured fragments, options of the command line, unknowns of an estimate and the dissertation's cases change
scenarios through this module alone.

Shorthands stand for what several fields tell together: ``natural_frequency`` (k_b and k_t scaled, mass kept),
``friction_angle`` (μ_s, with μ_k/μ_s kept) and ``friction_ratio`` (μ_k over μ_s). A sheet of a material has
``sheet.young_modulus`` and ``sheet.density`` as well, and its ``sheet.thickness`` is the material's: joints, mass and
dampers follow. A natural frequency is that of the
sheet's own dish mode, unless `with_values` is told what the sheet's is called: the source calls Table 4.1's sheet 10π
(`plategait.model.presets.NOMINAL_NATURAL_FREQUENCY`), whose dish mode is 10.3π.
"""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal, get_origin

from plategait.errors import InputError
from plategait.model.base import Model
from plategait.model.remade import OF_A_MATERIAL, THICKNESS, material_of, remade
from plategait.model.scenario import Scenario
from plategait.units import ANGULAR_FREQUENCY, Quantity, show

Value = float | str

SHORTHANDS = {
    "natural_frequency": ANGULAR_FREQUENCY,
    "friction_angle": Quantity("rad", "deg", "36.87 deg", at_least=0),
    "friction_ratio": Quantity("", "", "0.53", at_least=0, at_most=1),
}
"""What each shorthand measures."""
# Fields that a shorthand would overwrite.
_INSTEAD_OF = {"friction_angle": "friction.static", "friction_ratio": "friction.kinetic"}


@dataclass(frozen=True)
class Parameter:
    """One number or word of a scenario.

    Attributes
    ----------
    name : str
        Dotted ("motion.frequency", "motion.waves.0.phase"), or a shorthand.
    quantity : Quantity or None
        What it measures; None for a word such as ``friction.law``.
    """

    name: str
    quantity: Quantity | None

    @property
    def unit(self) -> str:
        """SI unit, empty for a plain number or a word."""
        return self.quantity.unit if self.quantity else ""

    @property
    def example(self) -> str:
        """A value that works."""
        return f'"{self.quantity.example}"' if self.quantity else '"thesis"'

    def read(self, value: object) -> Value:
        """One value: a bare SI number, text with a unit, or a word."""
        if self.quantity is not None:
            return self.quantity.read(value, self.name)
        if not isinstance(value, str):
            raise InputError(self.name, value, "a word", self.example)
        return value

    def text_of(self, value: Value) -> str:
        """Text with the unit that people write; a natural frequency in π rad/s or Hz where it is round in that."""
        if self.quantity is None or isinstance(value, str):
            return str(value)
        if self.name == "natural_frequency":
            for unit, size in (("pi rad/s", math.pi), ("Hz", 2 * math.pi)):
                if abs(value / size - round(value / size, 2)) < 1e-8 * value / size:
                    return f"{round(value / size, 2):g} {unit}"
        return show(float(f"{value:.12g}"), self.quantity.unit, self.quantity.display)


def parameters_of(scenario: Scenario) -> dict[str, Parameter]:
    """Every number and word of a scenario, by its dotted name."""
    return {parameter.name: parameter for parameter in _inside(scenario, None, "")}


def find_parameter(name: str, scenario: Scenario | None = None) -> Parameter:
    """Parameter by its dotted name or shorthand.

    Parameters
    ----------
    scenario : Scenario, optional
        Whose; by default one that every scenario has, or any with a disk.

    Raises
    ------
    InputError
        For a name that the scenario has not, with the nearest that it has.
    """
    if name in SHORTHANDS:
        return Parameter(name, SHORTHANDS[name])
    if name in OF_A_MATERIAL and (scenario is None or material_of(scenario.sheet)):
        return Parameter(name, OF_A_MATERIAL[name])
    if name in OF_A_MATERIAL:
        raise InputError(name, "a sheet whose joints are those of no material", "left out for it",
                         "natural_frequency, or young_modulus in the sheet's own file")  # fmt: skip
    parameters = parameters_of(scenario or _plainest())
    if name in parameters:
        return parameters[name]
    names = [*SHORTHANDS, *parameters]
    alike = [n for n in names if n.rsplit(".", 1)[-1] == name.rsplit(".", 1)[-1]]
    close = difflib.get_close_matches(name, alike or names, n=1, cutoff=0.0 if alike else 0.4) or ["motion.frequency"]
    raise InputError(
        name, "nothing known by that name", "a number or word of the scenario, by its dotted name", close[0]
    )


def value_of(scenario: Scenario, name: str) -> Any:
    """SI number or word that a scenario has by a name; None where it is left out, such as ``time_step``.

    Raises
    ------
    InputError
        For a name that the scenario has not, or a natural frequency that the sheet has not.
    """
    find_parameter(name, scenario)
    if name == "natural_frequency":
        return scenario.sheet.natural_frequency
    if name in SHORTHANDS:
        return scenario.friction.angle if name == "friction_angle" else scenario.friction.ratio
    if name in OF_A_MATERIAL:
        return getattr(material_of(scenario.sheet), name.rpartition(".")[2])
    value: Any = scenario
    for part in name.split("."):
        value = value[int(part)] if isinstance(value, tuple) else getattr(value, part)
    return value


def with_values(scenario: Scenario, values: Mapping[str, Any], nominal: float | None = None) -> Scenario:
    """Scenario with parameters set, validated once with all of them.

    Parameters
    ----------
    values : mapping
        SI numbers, text with units and words by name; also whole parts ("sheet") and None for what may be left out.
        The shorthands are applied last.
    nominal : float, optional
        What the sheet's own natural frequency is taken to be, rad/s (`Sheet.with_natural_frequency`); by default that
        of its dish mode.

    Raises
    ------
    InputError
        When a value is not as it must be, or a shorthand stands beside the field that it sets.
    """
    for shorthand, field in _INSTEAD_OF.items():
        if shorthand in values and field in values:
            raise InputError(field, f"set beside {shorthand}", f"left out where {shorthand} is given", shorthand)
    if not values:
        return scenario
    made = _of_the_material(scenario, values)
    if made:
        scenario = scenario.with_valid(sheet=remade(scenario.sheet, made))
        values = {name: value for name, value in values.items() if name not in made}
    parts = scenario.fields_with({name: value for name, value in values.items() if name not in SHORTHANDS})
    if "natural_frequency" in values:
        parts["sheet"] = parts["sheet"].with_natural_frequency(values["natural_frequency"], nominal)
    if "friction_angle" in values:
        parts["friction"] = parts["friction"].with_angle(values["friction_angle"])
    if "friction_ratio" in values:
        parts["friction"] = parts["friction"].with_ratio(values["friction_ratio"])
    return Scenario(**parts)


def _of_the_material(scenario: Scenario, values: Mapping[str, Any]) -> dict[str, float]:
    """What is told of the sheet's material, SI: a thickness too, where the sheet is of one."""
    names = [name for name in values if name in OF_A_MATERIAL]
    if THICKNESS in values and "sheet" not in values and (names or material_of(scenario.sheet)):
        names.append(THICKNESS)
    if names and "natural_frequency" in values:
        raise InputError(names[0], values[names[0]], "left out beside natural_frequency", "one of the two")
    return {name: float(find_parameter(name, scenario).read(values[name])) for name in names}


def kinetic_follows(values: Mapping[str, Any], scenario: Scenario) -> dict[str, Any]:
    """Values with μ_k at the scenario's own ratio to μ_s, where μ_s is told alone: how a measured μ_s is meant."""
    if "friction.static" not in values or "friction.kinetic" in values:
        return dict(values)
    return {**values, "friction.kinetic": values["friction.static"] * scenario.friction.ratio}


def _inside(value: object, quantity: Quantity | None, name: str) -> Iterator[Parameter]:
    """Every number and word inside part of a scenario; of a list those that measure something, by their place."""
    if isinstance(value, Model):
        for field, info in type(value).model_fields.items():
            dotted = f"{name}.{field}" if name else field
            if get_origin(info.annotation) is Literal and field != "shape":
                yield Parameter(dotted, None)
            else:
                yield from _inside(getattr(value, field), value.quantity(field), dotted)
    elif isinstance(value, tuple):
        # A sampled trajectory has many numbers and no parameter.
        for i, element in enumerate(value if quantity or isinstance(next(iter(value), None), Model) else ()):
            yield from _inside(element, quantity, f"{name}.{i}")
    elif quantity is not None:
        yield Parameter(name, quantity)


@cache
def _plainest() -> Scenario:
    """What stands in where a name is read before there is a scenario."""
    outline = {"shape": "disk", "radius": "40 mm"}
    sheet = {"outline": outline, "mass": "13.6 g", "bending_stiffness": "2.72e-3 N*mm/deg", "axial_stiffness": 790.0}
    return Scenario(sheet=sheet)
