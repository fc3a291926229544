"""Ranges as people type them."""

from __future__ import annotations

import math

from plategait.errors import InputError
from plategait.units import FREQUENCY, Quantity


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
    raise InputError("frequency", text, "first:last:step with a unit, last not below first", '"12:30:1Hz"')


def parse_range(text: str, quantity: Quantity, field: str) -> tuple[float, float]:
    """Read "10:30 Hz" (from:to), or one value for both ends, into SI.

    Raises
    ------
    InputError
        When it says anything else.
    """
    pieces = [piece.strip() for piece in text.split(":")]
    unit = pieces[-1].lstrip("0123456789.eE+- ")
    if len(pieces) > 2:
        raise InputError(field, text, "from:to with a unit, or one value", f'"{quantity.example}"')
    low, high = (quantity.read(p if p[-1:].isalpha() else f"{p} {unit}".strip(), field) for p in (pieces * 2)[:2])
    return low, high
