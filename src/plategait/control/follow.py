"""Following a path: an object carried along it, and how near to it it stayed."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array, Flags
from plategait.control.camera import Seen
from plategait.control.contour import ContourController
from plategait.control.goal import WITHIN, Goal
from plategait.control.menu import Menu
from plategait.control.path import Path, check_path
from plategait.control.plant import Plant
from plategait.control.pulse import Pulses
from plategait.control.steer import Steering, steer
from plategait.shown import Shown

# Moves of an object below which it counts as lying still, m, and how often a path may take the time it is expected to.
_STILL = 2e-4
_TIMES, _LEAST = 4.0, 30.0


@dataclass(frozen=True, eq=False, repr=False)
class Following(Shown):
    """An object's way along a path.

    Attributes
    ----------
    path : Path
        With the way from where the object lay to its beginning.
    way : Steering
        Its one goal is the end of the path.
    errors : (n,) array
        How far from each point of the path the object was when it came by, as root mean square where it lingered, m;
        NaN for those that it did not come to.
    nearest, farthest : (n,) arrays
        The least and the greatest of it.
    """

    path: Path
    way: Steering
    errors: Array
    nearest: Array
    farthest: Array

    def told(self) -> list[tuple[str, str]]:
        """How near to its path it stayed."""
        end = "reached" if self.reached else self.way.arrivals[-1].status or "not reached"
        off = f"{1e3 * self.rms:.2g} mm r.m.s., {1e3 * self.greatest:.2g} mm at most"
        near = f"{100 * self.coverage():.0f} % within {1e3 * WITHIN:g} mm"
        return [("end of the path", end), ("off the path", f"{off}, {near}"), ("time", f"{self.way.times[-1]:.3g} s")]

    @property
    def reached(self) -> bool:
        """Whether the object came to the end of the path."""
        return self.way.reached

    @property
    def rms(self) -> float:
        """Root mean square of the cross-track error along the strokes, m."""
        drawn = self.errors[self.path.drawn & np.isfinite(self.errors)]
        return float(np.sqrt(np.mean(drawn**2))) if len(drawn) else math.nan

    @property
    def greatest(self) -> float:
        """Greatest cross-track error on the strokes, m."""
        drawn = self.farthest[self.path.drawn & np.isfinite(self.farthest)]
        return float(drawn.max()) if len(drawn) else math.nan

    def coverage(self, within: float = WITHIN) -> float:
        """Share of the strokes that the object came as near to as this, m."""
        with np.errstate(invalid="ignore"):
            return float((self.nearest[self.path.drawn] <= within).mean())


def follow(
    plant: Plant,
    path: Path,
    menu: Menu,
    *,
    learns: bool = True,
    within: float = WITHIN,
    timeout: float | None = None,
    each_tick: Callable[[Plant, float], object] | None = None,
    look: Callable[[Plant], Seen] | None = None,
    progress: Callable[[float], object] | None = None,
) -> Following:
    """Carry the sheet of a plant along a path, at any angle: first to its beginning, then without a stop to its end.

    Parameters
    ----------
    plant : Plant
        Of one lane.
    path : Path
    menu, learns, each_tick, look
        As of `steer`.
    within : float
        How near to the end of the path counts as there, m.
    timeout : float, optional
        Time after which it is given up, s; four times what it is expected to take, and 30 s at least, by default.
    progress : callable, optional
        Called with the share of the path that is done.

    Raises
    ------
    InputError
        For a path off the plate, or along which no motions carry the object.
    """
    check_path(path, menu.scenario)
    whole = path.begun_at(plant.poses[0, :2])
    made: list[ContourController] = []

    def controller(pulses: Pulses) -> ContourController:
        made.append(ContourController(menu, pulses, whole))
        return made[0]

    def each(plant: Plant, time: float) -> None:
        if progress is not None:
            progress(made[0].progress)
        if each_tick is not None:
            each_tick(plant, time)

    expected = ContourController(menu, Pulses(menu.response), whole).expected_time
    (way,) = steer(
        plant, [[Goal(*path.points[-1].tolist())]], menu, learns=learns, hold=0.0, within=(within, math.pi),
        timeout=max(_TIMES * expected, _LEAST) if timeout is None else timeout, each_tick=each, look=look,
        controller=controller,
    )  # fmt: skip
    return Following(whole, way, *along(whole.points, way.poses[:, :2], way.reached))


def along(points: Array, trace: Array, to_the_end: bool = True) -> tuple[Array, Array, Array]:
    """How far from each point of a path a trace was when it came by: in the mean, at its nearest and at its farthest.

    Both are gone through once, from their beginnings on, neither of them back: the pairing of points with the least
    sum of squared distances (dynamic time warping), so that what is skipped counts by how far off it was passed.

    Parameters
    ----------
    points : (n, 2) array
    trace : (m, 2) array
    to_the_end : bool
        Whether the trace ends where the path does; else it is paired as far as it fits best.

    Returns
    -------
    three (n,) arrays
        Root mean square, least and greatest distance of the points of the trace that belong to each; NaN where none do.
    """
    moving = _moves(trace)
    trace = trace[moving]
    squares = ((trace[:, None] - points) ** 2).sum(axis=-1)
    n = len(points)
    sums = np.cumsum(squares, axis=1)
    came_by: list[Flags] = []
    least = sums[0]
    came_by.append(np.zeros(n, dtype=bool))
    above_at: list[Flags] = [np.zeros(n, dtype=bool)]
    for k in range(1, len(trace)):
        # From the point of the trace before: from the same point of the path, or from the one before it.
        before = np.concatenate([[np.inf], least[:-1]])
        straight = least <= before
        entered = np.minimum(least, before)
        shifted = np.concatenate([[0.0], sums[k, :-1]])
        least = sums[k] + np.minimum.accumulate(entered - shifted)
        # Whether it is cheaper to come along the path at this point of the trace.
        came_by.append(np.concatenate([[False], least[:-1] < entered[1:]]))
        above_at.append(straight)
    ends = np.arange(1, n + 1)
    j = n - 1 if to_the_end else int((least / (ends + len(trace))).argmin())
    first_row_only = len(trace) == 1
    total, count = np.zeros(n), np.zeros(n)
    nearest, farthest = np.full(n, np.nan), np.full(n, np.nan)
    k = len(trace) - 1
    while True:
        total[j] += squares[k, j]
        count[j] += 1
        nearest[j] = np.fmin(nearest[j], squares[k, j])
        farthest[j] = np.fmax(farthest[j], squares[k, j])
        if k == 0 and j == 0:
            break
        if k == 0 or first_row_only or (j > 0 and came_by[k][j]):
            j -= 1
        elif j == 0 or above_at[k][j]:
            k -= 1
        else:
            k, j = k - 1, j - 1
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.sqrt(total / count), np.sqrt(nearest), np.sqrt(farthest)


def _moves(trace: Array) -> list[int]:
    """Points of a trace that are not where the last one was."""
    kept = [0]
    for k in range(1, len(trace)):
        if math.dist(trace[k], trace[kept[-1]]) > _STILL:
            kept.append(k)
    return kept
