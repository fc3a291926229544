"""Motions spread over a space, as shares of its ranges."""

from __future__ import annotations

import math
import warnings

import numpy as np
from scipy.stats import qmc

from plategait.arrays import Array
from plategait.optimize.space import Space


def spread(space: Space, count: int, seed: int) -> list[Array]:
    """Shares (d,) that fill a space evenly; where freedoms were asked for, every second leaves them all at rest.

    The optimum without the freedoms is one of the motions with them, so that they cannot be worse for being many.
    """
    with warnings.catch_warnings():
        # Other counts than powers of two are only a little less even.
        warnings.simplefilter("ignore", UserWarning)
        generator = qmc.Sobol(len(space.variables), seed=np.random.default_rng(seed))  # pyright: ignore[reportCallIssue]
        shares = generator.random(count)
    neutral = space.neutral
    has_plain = bool(np.isnan(neutral).any())
    at_rest = (np.arange(count) % 2 == 1)[:, None] & np.isfinite(neutral)[None] & has_plain
    return list(np.where(at_rest, neutral[None], shares))


def scattered(space: Space, count: int, seed: int) -> Array:
    """(count, d) shares that fill the ranges; in half of them each freedom changes nothing with a chance of a half."""
    d = len(space.variables)
    shares = qmc.Sobol(d, rng=np.random.default_rng(seed)).random_base2(math.ceil(math.log2(count)))[:count]
    generator = np.random.default_rng(seed)
    plain = ~np.isnan(space.neutral) & (generator.random((count, d)) < 0.5)
    plain[::2] = False
    return np.where(plain, space.neutral, shares)
