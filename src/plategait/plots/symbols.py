"""Symbols as the source prints them, and the units that people read beside them."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.model.measured import Measured, as_text
from plategait.model.parameters import Parameter
from plategait.units import parse

if TYPE_CHECKING:
    from plategait.model.motion import PlateMotion

FREQUENCY = "plate frequency $f_p$ (Hz)"
SPIN_RATE = "spin rate $\\omega_B$ (deg/s)"
ACCELERATION = "$A_p\\,\\omega_p^2$ ($10^4$ deg/s²)"

# Parameters by what people call them, and their symbol.
SYMBOLS = {
    "motion.frequency": ("plate frequency", "$f_p$"),
    "motion.angle": ("angular amplitude", "$A_p$"),
    "motion.stroke": ("linear amplitude", "$B_p$"),
    "natural_frequency": ("natural frequency", "$\\omega_n$"),
    "friction_angle": ("friction angle", "$\\alpha$"),
    "friction_ratio": ("friction ratio", "$\\mu_k/\\mu_s$"),
    "friction.static": ("static friction", "$\\mu_s$"),
    "friction.kinetic": ("kinetic friction", "$\\mu_k$"),
    "sheet.bending_stiffness": ("bending stiffness", "$k_b$"),
    "sheet.bending_damping": ("bending damping", "$c_b$"),
    "sheet.axial_stiffness": ("axial stiffness", "$k_c$"),
}
_TYPESET = {
    "ω_Br max": "$\\omega_{Br\\,max}$", "ω_n": "$\\omega_n$", "α": "$\\alpha$", "b/f0": "$b/f_0$",
    "A_p": "$A_p$", "B_p": "$B_p$",
}  # fmt: skip
_PI = "π rad/s"
_UNITS_OF_PI = {_PI: math.pi, "Hz": 2 * math.pi, "rad/s": 1.0}


def unit_read(parameter: Parameter, values: Iterable[float] = ()) -> tuple[float, str]:
    """Unit in which values (SI) of a parameter are read: what 1 of it is in SI, and its name.

    A natural frequency is read in that of π rad/s, Hz and rad/s in which the values are round, as they were typed.
    """
    if parameter.quantity is None or not parameter.unit:
        return 1.0, ""
    if parameter.name == "natural_frequency":
        values = list(values)
        typed = [name for name, size in _UNITS_OF_PI.items() if all(_round(value / size) for value in values)]
        return _UNITS_OF_PI[unit := (typed or [_PI])[0]], unit
    return parse(f"1 {parameter.quantity.display}", parameter.unit), parameter.quantity.display


def label_of(parameter: Parameter, unit: str) -> str:
    """Axis label of a parameter: its name, its symbol and its unit."""
    name = " ".join(SYMBOLS.get(parameter.name, (parameter.name,)))
    return f"{name} ({_in_print(unit)})" if unit else name


def value_with(parameter: Parameter, value: float | str) -> str:
    """A value of a parameter with its symbol and unit, as mathtext: ω_n = 10π rad/s."""
    symbol = SYMBOLS.get(parameter.name, ("", parameter.name))[1]
    if parameter.quantity is None or isinstance(value, str):
        return f"{symbol}: {value}"
    size, unit = unit_read(parameter, [value])
    number = f"{value / size:.6g}"
    return f"{symbol} = {number}{unit}" if unit == _PI else f"{symbol} = {number} {_in_print(unit)}".rstrip()


def motion_in_words(motion: PlateMotion, without: Collection[str] = ()) -> str:
    """Frequency and amplitudes of a motion, as mathtext.

    Parameters
    ----------
    without : collection of str
        Parameters left out, by their dotted names: what the axes show.
    """
    told = {"motion.frequency": f"{motion.frequency:.4g} Hz", "motion.angle": f"{math.degrees(motion.angle):.4g} deg",
            "motion.stroke": f"{1e3 * motion.stroke:.4g} mm"}  # fmt: skip
    parts = [f"{SYMBOLS[name][1]} = {value}" for name, value in told.items() if name not in without]
    if motion.waves:
        parts.append(f"{len(motion.waves)} further sine{'s' if len(motion.waves) > 1 else ''}")
    if motion.samples is not None:
        parts.append("a sampled trajectory")
    return ", ".join(parts)


def typeset(words: str) -> str:
    """Words with their symbols as mathtext: "A_p = 3 deg" with its A and p as in print."""
    for plain, symbol in _TYPESET.items():
        words = words.replace(plain, symbol)
    return words


def told(symbol: str, measured: Measured | None, factor: float, unit: str) -> str:
    """A measured value with its symbol, interval and unit, or that it was not determined."""
    if measured is None:
        return f"{symbol} {as_text(None)}"
    return f"{symbol} = {as_text(measured, '.3g', factor)} {unit}"


def span(values: Array, unit: str) -> str:
    """What values reach from and to, or the one that they all are."""
    values = values[np.isfinite(values)]
    low, high = f"{values.min():.4g}", f"{values.max():.4g}"
    return f"{low} {unit}".rstrip() if low == high else f"{low} to {high} {unit}".rstrip()


def _in_print(unit: str) -> str:
    return unit.replace("^2", "²").replace("^3", "³").replace("*", " ")


def _round(value: float) -> bool:
    return abs(value - float(f"{value:.4g}")) <= 1e-6 * abs(value)
