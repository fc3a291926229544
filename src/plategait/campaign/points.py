"""The points of a sweep, in order: a column of values for each parameter."""

from __future__ import annotations

import itertools
import math
import warnings
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plategait.campaign.plan import Sweep
from plategait.campaign.values import MOST_VALUES
from plategait.errors import InputError
from plategait.model.parameters import Value

Point = dict[str, Value]


def base_points(sweep: Sweep) -> list[Point]:
    """Points that the plan names; the last parameter of a grid varies fastest.

    Raises
    ------
    InputError
        When there are too many, or the scenario at one of them is not as it must be.
    """
    if sweep.sample is not None:
        return _sampled(sweep)
    lists = sweep.grid or sweep.points
    if sweep.grid and math.prod(grid_shape(sweep)) > 10 * MOST_VALUES:
        raise InputError("grid", f"{math.prod(grid_shape(sweep))} points", "at most ten million", "a sample")
    rows = itertools.product(*lists.values()) if sweep.grid else zip(*lists.values(), strict=True)
    return [dict(zip(lists, row, strict=True)) for row in rows]


def grid_shape(sweep: Sweep) -> tuple[int, ...]:
    """Lengths of a grid's lists; empty for what is no grid."""
    return tuple(len(values) for values in sweep.grid.values())


def point_count(sweep: Sweep) -> int:
    """Points that the plan names."""
    if sweep.sample is not None:
        return sweep.sample.count
    return math.prod(grid_shape(sweep)) if sweep.grid else len(next(iter(sweep.points.values())))


def described(sweep: Sweep) -> dict[str, Any]:
    """Attributes of a store that say what is in it, all of which follow from the plan."""
    return {
        "title": sweep.name,
        "coordinates": " ".join(p.name for p in sweep.parameters),
        "grid_shape": list(grid_shape(sweep)),
        "base_points": point_count(sweep),
        "seed": sweep.seed,
    }


def _sampled(sweep: Sweep) -> list[Point]:
    from scipy.stats import qmc

    assert sweep.sample is not None
    ranges = sweep.sample_ranges()
    kind = qmc.Sobol if sweep.sample.method == "sobol" else qmc.LatinHypercube
    generator = np.random.default_rng(sweep.seed)
    with warnings.catch_warnings():
        # Other counts than powers of two are only a little less even.
        warnings.simplefilter("ignore", UserWarning)
        unit = kind(len(ranges), seed=generator).random(sweep.sample.count)  # pyright: ignore[reportCallIssue]
    low, high = np.array(list(ranges.values())).T
    return [dict(zip(ranges, map(float, row), strict=True)) for row in low + unit * (high - low)]


def columns(names: Sequence[str], points: Sequence[Mapping[str, Value]]) -> dict[str, NDArray]:
    """Points as one array for each parameter: numbers, or words."""
    return {name: np.array([point[name] for point in points]) for name in names}


def seed_of(seed: int, index: int) -> int:
    """Seed of a point's starts, from the sweep's seed and the point's place alone."""
    return int(np.random.SeedSequence((seed, index)).generate_state(1, np.uint64)[0])
