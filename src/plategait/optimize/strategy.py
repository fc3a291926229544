"""The evolution strategy that searches share: CMA-ES with random numbers of its own."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError


def evolution_strategy(
    mean: Array, step: float, low: Sequence[float], high: Sequence[float], population: int, seed: int, field: str
) -> Any:
    """CMA-ES within bounds, which depends on its seed alone.

    Parameters
    ----------
    mean : (d,) array
        Where it starts, inside the bounds.
    step : float
        How far the first generation goes from there.
    low, high : sequence of float
        Bounds of each unknown.
    population : int
        Of a generation.
    seed : int
    field : str
        What an error calls the search.

    Raises
    ------
    InputError
        When the package `cma` is not installed.
    """
    try:
        import cma
    except ImportError:
        raise InputError(
            field, "no package cma", "an installation with it", 'pip install "plategait[optimize]"'
        ) from None
    rng = np.random.default_rng(seed)
    options = {
        "bounds": [list(low), list(high)],
        "popsize": population,
        "randn": lambda *shape: rng.standard_normal(shape),
        "seed": np.nan,
        "verbose": -9,
    }
    return cma.CMAEvolutionStrategy(mean, step, options)
