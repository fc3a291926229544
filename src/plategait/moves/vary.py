"""Motions made of others: varied, crossed and mirrored, all as shares of the ranges of a space."""

from __future__ import annotations

import numpy as np
from numpy.random import Generator

from plategait.arrays import Array
from plategait.optimize.space import Space
from plategait.optimize.symmetry import turned

STEP, CROSS = 0.04, 0.2
"""Standard deviations of a child: about its parent, and along the line to another elite (iso+line variation)."""
MIRRORED, REVERTED = 0.2, 0.15
"""Chance that a child is a mirror image of its parent, and that one of its freedoms goes back to changing nothing."""


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
        made[chosen] = np.where(turned(space, mirror), 1 - parents[one][chosen], parents[one][chosen])
    return np.clip(made, 0.0, 1.0)
