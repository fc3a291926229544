"""Futures: what becomes of an object that rests somewhere, motion by motion, as the engine itself tells it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array, Flags
from plategait.control.identify import flat
from plategait.control.response import TICK, stopped
from plategait.model.motion import PlateMotion
from plategait.model.scenario import Scenario
from plategait.simulation.session import Session

HORIZON = 30
"""Ticks that are looked ahead."""
_SETTLED = 0.03  # s


class Futures:
    """So many futures of an object at once, from one pose at rest.

    Parameters
    ----------
    scenario : Scenario
        The object as it is believed to be, on its plate, which stands.
    count : int
    threads : int, optional
        Cores to use; all by default.
    """

    def __init__(self, scenario: Scenario, count: int, threads: int | None = None) -> None:
        self._scenario, self._still = scenario, scenario.motion
        self._session = Session([scenario] * count, threads=threads, keep=_SETTLED)

    def __len__(self) -> int:
        """Return the number of futures."""
        return len(self._session)

    def ends(self, pose: Array, motions: Sequence[PlateMotion], ticks: NDArray[np.int64]) -> tuple[Array, Flags]:
        """Where each pulse brings the object.

        Parameters
        ----------
        pose : (3,) array
            x, y, m, and the angle, rad.
        motions : sequence of PlateMotion
        ticks : (n,) int array
            How long each goes on, before the plate stands again.

        Returns
        -------
        poses : (n, 3) array
            At rest, with angles that go on from the one given.
        sound : (n,) bool array
            Futures in which the sheet stays flat.
        """
        session = self._session
        x, y, angle = pose.tolist()
        start = self._scenario.start.with_valid(x=x, y=y, angle=angle)
        session.reset(None, self._scenario.with_valid(start=start))
        session.advance(None, _SETTLED)
        before, poses, turned, velocity = session.poses, session.poses, np.zeros(len(self)), np.zeros((len(self), 3))
        sound = np.ones(len(self), dtype=bool)
        told: list[PlateMotion | None] = list(motions)
        for k in range(HORIZON):
            stops = ticks == k
            session.advance([self._still if stop else motion for stop, motion in zip(stops, told, strict=True)], TICK)
            told = [None] * len(self)
            velocity = (session.poses - poses) / TICK
            velocity[:, 2] = (np.remainder(session.poses[:, 2] - poses[:, 2] + np.pi, 2 * np.pi) - np.pi) / TICK
            poses, turned = session.poses, turned + TICK * velocity[:, 2]
            sound &= flat(session)
        poses = np.column_stack([pose[:2] + poses[:, :2] - before[:, :2], pose[2] + turned])
        return stopped(np.concatenate([poses, velocity], axis=1)), sound
