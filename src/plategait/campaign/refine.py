"""Further points where they tell most: around the peak, between gaits, and at the edge of failure."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from plategait.campaign.plan import Sweep
from plategait.campaign.points import Point
from plategait.errors import InputError
from plategait.simulation.ensemble import Ensemble

# Neighbours closer than this share of the curve's range are not parted any more.
FINEST = 2.0**-12


def refined_parameter(sweep: Sweep) -> str:
    """Parameter along which points are added: the plate's frequency, or the last number that is swept.

    Raises
    ------
    InputError
        When the sweep has no curves: it is a sample, or has other than one or two parameters.
    """
    numbers = [p.name for p in sweep.parameters if p.quantity is not None]
    curves = (bool(sweep.grid) and len(sweep.parameters) <= 2) or (bool(sweep.points) and len(sweep.parameters) == 1)
    if not curves or not numbers:
        got = "a sample" if sweep.sample else f"{len(sweep.parameters)} parameters"
        raise InputError("refine", got, "left out but for a sweep of one parameter or a grid of two", "0")
    return "motion.frequency" if "motion.frequency" in numbers else numbers[-1]


def curves(points: Sequence[Point], along: str) -> dict[tuple[object, ...], list[int]]:
    """Indices of the points of each curve, in order of the parameter along it."""
    members_by_key: dict[tuple[object, ...], list[int]] = {}
    for i, point in enumerate(points):
        key = tuple(value for name, value in point.items() if name != along)
        members_by_key.setdefault(key, []).append(i)
    return {key: sorted(members, key=lambda i: float(points[i][along])) for key, members in members_by_key.items()}


def propose(sweep: Sweep, points: Sequence[Point], outcomes: Ensemble) -> list[Point]:
    """Next points, most telling first; none when nothing is left to part.

    Depends on nothing but the points so far and what they showed, so that a campaign that is resumed goes the same way.
    """
    along = refined_parameter(sweep)
    wanted: list[tuple[float, int, float, Point]] = []
    for number, members in enumerate(curves(points, along).values()):
        x = np.array([float(points[i][along]) for i in members])
        if len(x) < 2 or x[-1] == x[0]:
            continue
        width = np.diff(x) / (x[-1] - x[0])
        for gap in _telling(members, outcomes):
            if width[gap] > FINEST:
                middle = float(0.5 * (x[gap] + x[gap + 1]))
                wanted.append((-float(width[gap]), number, middle, points[members[gap]] | {along: middle}))
    return [point for *_, point in sorted(wanted, key=lambda w: w[:3])]


def _telling(members: Sequence[int], outcomes: Ensemble) -> list[int]:
    """Gaps of a curve, by their left end, that part different outcomes or lie beside the peak."""
    kinds = [(bool(outcomes.failed[i]), "" if outcomes.failed[i] else outcomes.gait[i]) for i in members]
    gaps = {k for k in range(len(members) - 1) if kinds[k] != kinds[k + 1]}
    height = np.array([0.0 if outcomes.failed[i] else abs(outcomes.rate[i]) for i in members])
    height = np.where(np.isfinite(height), height, 0.0)
    if height.max() > 0:
        peak = int(height.argmax())
        gaps |= {k for k in (peak - 1, peak) if 0 <= k < len(members) - 1}
    return sorted(gaps)
