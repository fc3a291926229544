"""Ranges of frequencies as people type them."""

from __future__ import annotations

import math

from plategait.errors import InputError
from plategait.units import FREQUENCY


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
