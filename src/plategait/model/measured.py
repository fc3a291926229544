"""A measured value with its uncertainty, for files, programs and people."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

CONFIDENCE = 0.95
"""Of the intervals."""


@dataclass(frozen=True)
class Measured:
    """One measured parameter, SI.

    Attributes
    ----------
    value : float
    sd : float
        Standard deviation.
    low, high : float
        Ends of its interval.
    """

    value: float
    sd: float
    low: float
    high: float


def as_json(measured: Measured | None, factor: float = 1.0) -> dict[str, Any] | None:
    """Value, sd and interval times `factor`, for JSON; None where it is not determined."""
    if measured is None:
        return None
    m = measured
    return {"value": m.value * factor, "sd": m.sd * factor, "interval": [m.low * factor, m.high * factor]}


def as_text(measured: Measured | None, form: str = ".4g", factor: float = 1.0) -> str:
    """Value and interval times `factor`, for a table."""
    if measured is None:
        return "not determined"
    value, low, high = (format(v * factor, form) for v in (measured.value, measured.low, measured.high))
    return f"{value} ({low} to {high})"
