"""Series of numbers short enough to travel in a page: six digits, finite ones, and no more than are seen."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray


def lean(values: ArrayLike) -> list[float | None]:
    """(n,) numbers with six digits, as single precision has; None where there is none."""
    return [
        float(f"{value:.6g}") if math.isfinite(value) else None for value in np.asarray(values, dtype=float).tolist()
    ]


def stride(count: int, most: int) -> int:
    """Every how many of so many are kept, for no more than `most`."""
    return max(1, -(-count // most))


def every(count: int, most: int) -> NDArray[np.int64]:
    """Places that are kept of so many, evenly apart from the first on, no more than `most`."""
    return np.arange(0, count, stride(count, most))
