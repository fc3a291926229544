"""A measured value as programs and people read it."""

from __future__ import annotations

from typing import Any

from plategait.model.fragment import Measured


def numbers(measured: Measured | None, factor: float = 1.0) -> dict[str, Any] | None:
    """Value, sd and interval times `factor`, for JSON; None where it is not determined."""
    if measured is None:
        return None
    m = measured
    return {"value": m.value * factor, "sd": m.sd * factor, "interval": [m.low * factor, m.high * factor]}


def words(measured: Measured | None, form: str = ".4g", factor: float = 1.0) -> str:
    """Value and interval times `factor`, for a table."""
    if measured is None:
        return "not determined"
    value, low, high = (format(v * factor, form) for v in (measured.value, measured.low, measured.high))
    return f"{value} ({low} to {high})"
