"""The door for numbers with units: text comes in, SI floats go on; SI floats go out as text.

A bare number is SI. Text carries its unit ("12 deg", "3 mm", "2.72e-3 N*mm/deg").
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from decimal import Decimal
from functools import lru_cache
from numbers import Integral, Real
from typing import Annotated, Any

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, core_schema

from plategait.errors import InputError

_DEG = math.pi / 180

COMMON_UNITS: dict[str, tuple[float, str]] = {
    "m": (1.0, "m"), "mm": (1e-3, "m"), "cm": (1e-2, "m"), "um": (1e-6, "m"),
    "s": (1.0, "s"), "ms": (1e-3, "s"),
    "kg": (1.0, "kg"), "g": (1e-3, "kg"), "mg": (1e-6, "kg"),
    "rad": (1.0, "rad"), "deg": (_DEG, "rad"),
    "Hz": (1.0, "Hz"), "hertz": (1.0, "Hz"), "mHz": (1e-3, "Hz"), "kHz": (1e3, "Hz"), "MHz": (1e6, "Hz"),
    "rad/s": (1.0, "rad/s"), "deg/s": (_DEG, "rad/s"), "rpm": (math.pi / 30, "rad/s"),
    "turn/s": (2 * math.pi, "rad/s"), "turn/min": (math.pi / 30, "rad/s"), "deg/min": (_DEG / 60, "rad/s"),
    "m/s": (1.0, "m/s"), "mm/s": (1e-3, "m/s"),
    "m/s^2": (1.0, "m/s^2"), "m/s**2": (1.0, "m/s^2"), "m/s²": (1.0, "m/s^2"), "m/s^3": (1.0, "m/s^3"),
    "rad/s^2": (1.0, "rad/s^2"), "deg/s^2": (_DEG, "rad/s^2"),
    "rad/s^3": (1.0, "rad/s^3"), "deg/s^3": (_DEG, "rad/s^3"),
    "N": (1.0, "N"), "kg*m^2": (1.0, "kg*m^2"), "g*mm^2": (1e-9, "kg*m^2"),
    "mm^2": (1e-6, "m^2"), "cm^2": (1e-4, "m^2"), "m^2": (1.0, "m^2"),
    "m^2/s^2": (1.0, "m^2/s^2"), "mm^2/s^2": (1e-6, "m^2/s^2"), "m*rad/s^2": (1.0, "m*rad/s^2"),
    "mm*deg/s^2": (1e-3 * _DEG, "m*rad/s^2"), "rad^2/s^2": (1.0, "rad^2/s^2"), "deg^2/s^2": (_DEG**2, "rad^2/s^2"),
    "J": (1.0, "J"), "W": (1.0, "W"), "mW": (1e-3, "W"),
    "Pa": (1.0, "Pa"), "kPa": (1e3, "Pa"), "MPa": (1e6, "Pa"), "GPa": (1e9, "Pa"), "N/mm^2": (1e6, "Pa"),
    "kg/m^3": (1.0, "kg/m^3"), "g/cm^3": (1e3, "kg/m^3"), "N*m": (1.0, "N*m"), "mN*m": (1e-3, "N*m"),
    "N/m": (1.0, "N/m"), "N/mm": (1e3, "N/m"),
    "N*s/m": (1.0, "N*s/m"), "N/(mm/s)": (1e3, "N*s/m"), "N*s/mm": (1e3, "N*s/m"),
    "N*m/rad": (1.0, "N*m/rad"), "N*mm/deg": (1e-3 / _DEG, "N*m/rad"), "N*mm/rad": (1e-3, "N*m/rad"),
    "N*m*s/rad": (1.0, "N*m*s/rad"), "N*mm/(deg/s)": (1e-3 / _DEG, "N*m*s/rad"),
    "N*mm*s/deg": (1e-3 / _DEG, "N*m*s/rad"),
}  # fmt: skip
"""Factor to SI and SI unit of the units that the source and its users write most.

Anything else goes to pint, whose import takes a quarter of the second in which a first result is due.
"""
# The same in small letters, for "24 hz" and "3 MM"; not where two units differ by nothing else (mHz, MHz).
_SMALL = [unit.lower() for unit in COMMON_UNITS]
_IN_ANY_CASE = {unit.lower(): unit for unit in COMMON_UNITS if _SMALL.count(unit.lower()) == 1}

_NUMBER = re.compile(r"([-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d+)?)\s*(.*)", re.IGNORECASE)
# Names with whole powers, multiplied and divided: pint would take any expression, "12,5 mm" for 12 times 5 mm.
_POWER = r"(?:(?:\^|\*\*)-?\d|²)?"
_NAME = rf"\(*(?:[^\W\d_]+|°){_POWER}(?:\){_POWER})*"
_UNIT = re.compile(rf"{_NAME}(?:(?:\s*[*/·]\s*|\s+){_NAME})*")

# Measures of which nobody here has one whole SI unit: who types 1 or "1" for a stroke means 1 mm.
_IN_PARTS = {"m", "kg", "rad", "m/s", "rad/s"}

# Letters of a number with its unit: the longest names of units take a few dozen.
_LONGEST = 100
# Sizes, in SI, beyond which products and quotients of a few numbers leave floating point.
_SMALLEST, _LARGEST = 1e-30, 1e30


@lru_cache(maxsize=1)
def _registry() -> Any:
    import pint

    return pint.UnitRegistry()


@lru_cache(maxsize=256)
def _factor(unit: str, target: str) -> float:
    """Factor from `unit` to the SI unit `target`; raises ValueError when the two do not measure the same thing."""
    if not target or not _UNIT.fullmatch(unit):
        raise ValueError(f"{unit} is no unit of {target or 'a plain number'}")
    text = unit.replace("·", "*").replace("°", "deg").replace("µ", "u").replace("μ", "u")
    text, turns = re.sub(r"\s*([*/])\s*", r"\1", text), 1.0
    if target == "rad/s" and (times_pi := re.match(r"(?:pi|π)[* ]\s*", text)):
        text, turns = text[times_pi.end() :], math.pi
    if text in COMMON_UNITS:
        factor, si = COMMON_UNITS[text]
        if (si, target) == ("Hz", "rad/s"):
            return 2 * math.pi * factor * turns
        if si != target:
            raise ValueError(f"{unit} does not measure the same as {target}")
        return factor * turns
    as_meant = _IN_ANY_CASE.get(text.lower(), text)
    if target in ("Hz", "rad/s"):  # to pint a turn, a radian and a plain 1 are the same dimension
        if as_meant != text:
            return _factor(as_meant, target) * turns
        raise ValueError(f"{unit} may count turns or radians")
    try:
        quantity = _registry().parse_expression(text) * 1.0
        return float(quantity.to(target.replace("^", "**")).magnitude)
    except Exception as error:  # pint raises a family of its own, and Python's for text that is no unit at all
        if as_meant != text:
            return _factor(as_meant, target)
        raise ValueError(f"{unit} is no unit of {target}") from error


def parse(text: str, unit: str) -> float:
    """Read a number with a unit into SI.

    Parameters
    ----------
    text : str
        Such as "12 deg"; without a unit the number is SI.
    unit : str
        SI unit wanted, such as "rad".

    Raises
    ------
    ValueError
        When the text is no number or its unit measures something else.
    """
    if len(text) > _LONGEST:
        raise ValueError(f"{len(text)} letters are no number with a unit")
    match = _NUMBER.fullmatch(text.strip())
    if match is None:
        raise ValueError(f"{text!r} does not begin with a number")
    number, own_unit = match.groups()
    return float(number) * (_factor(own_unit, unit) if own_unit else 1.0)


def _has_unit(text: str) -> bool:
    """Whether a unit, or anything, stands behind the number."""
    number = _NUMBER.fullmatch(text.strip())
    return number is not None and bool(number[2])


def show(value: float, unit: str, display: str) -> str:
    """Write an SI value as text in the unit `display`, with digits enough to read it back the same to 1e-9."""
    return f"{value / _factor(display, unit) if display else value:.10g} {display}".strip()


@dataclass(frozen=True)
class Quantity:
    """What a field measures and allows; annotate a float with it.

    Parameters
    ----------
    unit : str
        SI unit, empty for a plain number.
    display : str
        Unit that people read and write it in.
    example : str
        A value that works, given when another does not.
    above, at_least, at_most : float
        Limits in SI.
    smallest : float
        Least size in SI of what must be above 0, as that is divided by.
    """

    unit: str
    display: str
    example: str
    above: float = -math.inf
    at_least: float = -math.inf
    at_most: float = math.inf
    smallest: float = _SMALLEST

    @property
    def allowed(self) -> str:
        """Allowed range, as the end of "must be …"."""
        kind = f"a number in {self.display}" if self.unit else "a number"
        kind += f" or another unit of {self.unit}" if self.unit != self.display else ""
        bounds = [f"above {show(self.above, self.unit, self.display)}"] if self.above > -math.inf else []
        bounds += [f"at least {show(self.at_least, self.unit, self.display)}"] if self.at_least > -math.inf else []
        bounds += [f"at most {show(self.at_most, self.unit, self.display)}"] if self.at_most < math.inf else []
        return " ".join([kind, " and ".join(bounds)]).strip()

    def read(self, value: object, field: str) -> float:
        """Read a bare SI number or text with a unit.

        Raises
        ------
        InputError
            For anything but a finite number of the right dimension within the limits.
        """
        number, got, allowed, hint = math.nan, value, self.allowed, f'"{self.example}"'
        try:
            if isinstance(value, str):
                number = parse(value, self.unit)
            elif isinstance(value, (Real, Decimal)) and not isinstance(value, bool):
                number = float(value)
        except OverflowError:
            got = "a number too large for floating point"
        except ValueError:
            pass
        if number > self.above and self.at_least <= number <= self.at_most:
            smallest = self.smallest if self.above == 0 else 0.0
            if not smallest <= abs(number) <= _LARGEST:
                size = f"{allowed}, from {smallest:g} to {_LARGEST:g}"
                raise InputError(field, got, " ".join(filter(None, [size, self.unit, "in size"])), hint)
            if not self._lacks_unit(value, number):
                return number
            allowed = f"{allowed}, with its unit from 1 {self.unit} on"
        if math.isfinite(number) and self._means_usual_unit(value):
            got, hint = f"{number:g} {self.unit}, as a bare number is SI", f'"{number:.10g} {self.display}"'
        elif isinstance(value, str) and (pointed := self._with_point(value)):
            hint = f'"{pointed}"'
        raise InputError(field, got, allowed, hint)

    def _lacks_unit(self, value: object, number: float) -> bool:
        """Whether this is text or a whole number without a unit, as large as nobody means in SI."""
        if self.unit not in _IN_PARTS or self.display == self.unit or abs(number) < 1:
            return False
        return isinstance(value, Integral) or (isinstance(value, str) and not _has_unit(value))

    def _with_point(self, text: str) -> str:
        """Text with a point for its decimal comma, where that makes it a number that is allowed; else none."""
        pointed = text.strip().replace(",", ".")
        if text.count(",") != 1:
            return ""
        try:
            self.read(pointed, "")
        except InputError:
            return ""
        return pointed

    def _means_usual_unit(self, value: object) -> bool:
        """Whether this is a bare number that is within the limits in the usual unit: the 3 of who means 3 deg."""
        if not self.unit or (isinstance(value, str) and _has_unit(value)):
            return False
        number = float(value) * _factor(self.display, self.unit)  # type: ignore[arg-type]
        return self.unit != self.display and number > self.above and self.at_least <= number <= self.at_most

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Let pydantic read the field through `read`."""

        return core_schema.no_info_plain_validator_function(
            lambda value: self.read(value, ""), serialization=core_schema.plain_serializer_function_ser_schema(float)
        )


# A bare number is SI. Whoever types 40 for 40 mm, 3 for 3 deg or 13.6 for 13.6 g is told, because no sheet or plate is
# as large or as heavy, and no plate tilts further or shakes wider; nor is a thin object thicker than 100 mm.
Length = Annotated[float, Quantity("m", "mm", "10 mm", above=0, at_most=10)]
Thickness = Annotated[float, Quantity("m", "mm", "1 mm", above=0, at_most=0.1)]
Offset = Annotated[float, Quantity("m", "mm", "0 mm", at_least=-10, at_most=10)]
Depth = Annotated[float, Quantity("m", "mm", "0.1 mm", at_least=0)]
Area = Annotated[float, Quantity("m^2", "mm^2", "100 mm^2", above=0)]
Mass = Annotated[float, Quantity("kg", "g", "13.6 g", above=0, at_most=10)]
Angle = Annotated[float, Quantity("rad", "deg", "12 deg")]
Duration = Annotated[float, Quantity("s", "s", "4 s", above=0)]
Delay = Annotated[float, Quantity("s", "s", "0.1 s", at_least=0)]
Frequency = Annotated[float, Quantity("Hz", "Hz", "24 Hz", above=0, smallest=0)]  # a plate may as well stand still
Speed = Annotated[float, Quantity("m/s", "mm/s", "100 mm/s", above=0)]
Acceleration = Annotated[float, Quantity("m/s^2", "m/s^2", "9.81 m/s^2", at_least=0)]
AxialStiffness = Annotated[float, Quantity("N/m", "N/mm", "0.79 N/mm", above=0)]
AxialDamping = Annotated[float, Quantity("N*s/m", "N/(mm/s)", "4.9e-4 N/(mm/s)", at_least=0)]
BendingStiffness = Annotated[float, Quantity("N*m/rad", "N*mm/deg", "2.72e-3 N*mm/deg", at_least=0)]
BendingDamping = Annotated[float, Quantity("N*m*s/rad", "N*mm/(deg/s)", "4.23e-6 N*mm/(deg/s)", at_least=0)]
YoungModulus = Annotated[float, Quantity("Pa", "MPa", "0.5 MPa", at_least=100.0, at_most=2e12)]
Density = Annotated[float, Quantity("kg/m^3", "kg/m^3", "1100 kg/m^3", at_least=5.0, at_most=25e3)]
PoissonRatio = Annotated[float, Quantity("", "", "0.3", above=-1.0, at_most=0.5)]
LossFactor = Annotated[float, Quantity("", "", "0.1", at_least=0, at_most=2)]
Coefficient = Annotated[float, Quantity("", "", "0.75", at_least=0)]
Ratio = Annotated[float, Quantity("", "", "1", above=0)]

ANGULAR_FREQUENCY = Quantity("rad/s", "rad/s", "10 pi rad/s", above=0)
DAMPING = Quantity("", "", "0.05", at_least=0, at_most=1)
ANGLE = Quantity("rad", "deg", "12 deg")
STROKE = Quantity("m", "mm", "3 mm")
PLATE_ANGLE = Quantity("rad", "deg", "3 deg", at_least=-math.pi / 2, at_most=math.pi / 2)
PLATE_STROKE = Quantity("m", "mm", "3 mm", at_least=-1.0, at_most=1.0)
FREQUENCY = Quantity("Hz", "Hz", "24 Hz", above=0)
