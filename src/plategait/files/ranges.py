"""Ranges as people type them."""

from __future__ import annotations

import math
import re

from plategait.errors import InputError
from plategait.units import FREQUENCY, Quantity

_NOTHING = re.compile(r"0*\.?0*\s*[a-zA-Z]*")
# Two numbers with something between, as people write from and to, and perhaps a unit.
_ENDS = re.compile(r"(\d+\.?\d*)\s*[a-zA-Z/]*\s*(?:-|–|:|to|bis|\.\.\.?)\s*(\d+\.?\d*)\s*([a-zA-Z/]*)")


def _meant(text: str, *, step: bool) -> str:
    """A range as it is written, of whatever two numbers somebody typed."""
    ends = _ENDS.fullmatch(text.strip())
    if ends is None or not 0 < float(ends[1]) < float(ends[2]):
        return '"12:30:1Hz"' if step else '"10:30 Hz"'
    unit = ends[3] or "Hz"
    return f'"{ends[1]}:{ends[2]}:1{unit}"' if step else f'"{ends[1]}:{ends[2]} {unit}"'


def parse_frequencies(text: str) -> list[float]:
    """Read "12:30:1Hz" (first:last:step, both ends included), or "12, 14.5, 20 Hz", into Hz.

    Raises
    ------
    InputError
        When it says anything else.
    """
    separator = ":" if ":" in text else ","
    pieces = [piece.strip() for piece in text.split(separator)]
    unit = pieces[-1].lstrip("0123456789.eE+- ")
    try:
        # A piece without a unit takes that of the last.
        numbers = [FREQUENCY.read(p if p[-1:].isalpha() else f"{p} {unit}".strip(), "frequency") for p in pieces]
    except InputError:
        numbers = []
    if separator == "," and numbers:
        return numbers
    if len(numbers) == 3 and numbers[1] >= numbers[0]:
        first, last, step = numbers
        count = (last - first) / step + 1
        if count < 1e5:
            return [float(f"{first + i * step:.12g}") for i in range(math.floor(count + 1e-6))]
    if separator == ":" and _NOTHING.fullmatch(pieces[0]):
        raise InputError("frequency", text, "first:last:step with a unit, first above 0", '"1:30:1Hz"')
    raise InputError("frequency", text, "first:last:step with a unit, last not below first", _meant(text, step=True))


def parse_range(text: str, quantity: Quantity, field: str) -> tuple[float, float]:
    """Read "10:30 Hz" (from:to), or one value for both ends, into SI.

    Raises
    ------
    InputError
        When it says anything else.
    """
    pieces = [piece.strip() for piece in text.split(":")]
    unit = pieces[-1].lstrip("0123456789.eE+- ")
    if len(pieces) > 2 or (len(pieces) == 1 and _ENDS.fullmatch(text.strip())):
        hint = _meant(text, step=False) if _ENDS.fullmatch(text.strip()) else f'"{quantity.example}"'
        raise InputError(field, text, "from:to with a unit, or one value", hint)
    low, high = (quantity.read(p if p[-1:].isalpha() else f"{p} {unit}".strip(), field) for p in (pieces * 2)[:2])
    return low, high
