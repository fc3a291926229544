"""Mirror images of motions: where one of them carries an object is known before it is run.

What a motion that is its own image forbids, `plategait.model.symmetry` tells.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from plategait.arrays import Array, Flags
from plategait.optimize.goal import Goal
from plategait.optimize.space import Space
from plategait.optimize.trials import Trial

# What changes its sign in a mirror. Across the bar (y to −y): y, and what turns about x and z. Along it (x to −x): x,
# what turns about y and z, and half a period later all that goes with the plate's frequency but not with twice that.
_TURNED = (("y", "rx", "offset", "rz", "sense"), ("x", "y", "z", "sense"))
# And what the velocity along, across and turning does in each.
_SIGNS = ((1.0, -1.0, -1.0), (-1.0, 1.0, -1.0))


def mirrored(space: Space, shares: Array) -> Array:
    """(2, n, d) mirror images of motions (n, d): across the bar, and along it."""
    return np.array([np.where(turned(space, mirror), 1 - shares, shares) for mirror in (0, 1)])


def turned(space: Space, mirror: int) -> Flags:
    """(d,) variables that change their sign in a mirror: 0 across the bar, 1 along it."""
    return changes_sign([v.name for v in space.variables], mirror)


def changes_sign(names: Sequence[str], mirror: int) -> Flags:
    """(d,) numbers of a motion, by name, that change their sign in a mirror: 0 across the bar, 1 along it.

    An amplitude of the rocking that has a sign goes as the `sense` of one that has none.
    """
    return np.array([name.split()[0] in _TURNED[mirror] for name in names])


def nearest_images(space: Space, goal: Goal, trials: Sequence[Trial], count: int) -> list[Array]:
    """Shares (d,) from which to set out for a goal: of the trials that stay the nearest, each in its best image.

    Parameters
    ----------
    space : Space
    goal : Goal
    trials : sequence of Trial
    count : int
        How many at most; the middle of the ranges where nothing stays.
    """
    best: list[tuple[float, int, Array]] = []
    for number, trial in enumerate(trials):
        if trial.failed or not trial.counted:
            continue
        images = [(trial.twist, trial.shares)]
        for mirror in (0, 1):
            images += [(twist * _SIGNS[mirror], mirrored(space, shares)[mirror]) for twist, shares in images]
        deviation, shares = min(((goal.deviation(twist), shares) for twist, shares in images), key=lambda pair: pair[0])
        best.append((deviation, number, shares))
    best.sort(key=lambda each: each[:2])
    return [shares for _, _, shares in best[:count]] or [np.full(len(space.variables), 0.5)]
