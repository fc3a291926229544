"""Motions made of others: spread, varied, crossed and mirrored, all as shares of the ranges of a space."""

from __future__ import annotations

import math

import numpy as np
from numpy.random import Generator
from scipy.stats import qmc

from plategait.arrays import Array, Flags
from plategait.optimize.space import Space

STEP, CROSS = 0.04, 0.2
"""Standard deviations of a child: about its parent, and along the line to another elite (iso+line variation)."""
MIRRORED, REVERTED = 0.2, 0.15
"""Chance that a child is a mirror image of its parent, and that one of its freedoms goes back to changing nothing."""

# What changes its sign in a mirror. Across the bar (y to −y): y, and what turns about x and z. Along it (x to −x): x,
# what turns about y and z, and half a period later all that goes with the plate's frequency but not with twice that.
_TURNED = (("y", "rx", "offset", "rz", "sense"), ("x", "y", "z", "sense"))


def spread(space: Space, count: int, seed: int) -> Array:
    """(count, d) shares that fill the ranges; in half of them each freedom changes nothing with a chance of a half."""
    d = len(space.variables)
    shares = qmc.Sobol(d, rng=np.random.default_rng(seed)).random_base2(math.ceil(math.log2(count)))[:count]
    generator = np.random.default_rng(seed)
    plain = ~np.isnan(space.neutral) & (generator.random((count, d)) < 0.5)
    plain[::2] = False
    return np.where(plain, space.neutral, shares)


def children(space: Space, parents: Array, count: int, generator: Generator) -> Array:
    """(count, d) shares of children of elites (n, d), each elite as likely as any other."""
    n, d = parents.shape
    one, other = generator.integers(n, size=(2, count))
    line = CROSS * generator.standard_normal((count, 1)) * (parents[other] - parents[one])
    made = parents[one] + STEP * generator.standard_normal((count, d)) + line
    steps = np.array([bool(v.steps) for v in space.variables])
    made[:, steps] = parents[one][:, steps]
    neutral = space.neutral
    reverted = (generator.random((count, d)) < 1 / d) & (generator.random((count, 1)) < REVERTED) & ~np.isnan(neutral)
    made = np.where(reverted, neutral, made)
    images = generator.random(count)
    for mirror, chance in ((0, MIRRORED / 2), (1, MIRRORED)):
        chosen = (images < chance) & (images >= chance - MIRRORED / 2)
        made[chosen] = np.where(_turned(space, mirror), 1 - parents[one][chosen], parents[one][chosen])
    return np.clip(made, 0.0, 1.0)


def mirrored(space: Space, shares: Array) -> Array:
    """(2, n, d) mirror images of motions (n, d): across the bar, and along it."""
    return np.array([np.where(_turned(space, mirror), 1 - shares, shares) for mirror in (0, 1)])


def _turned(space: Space, mirror: int) -> Flags:
    """(d,) variables that change their sign in a mirror."""
    return np.array([v.name.split()[0] in _TURNED[mirror] for v in space.variables])
