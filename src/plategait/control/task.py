"""The task: bring a sheet to a pose on a shaking plate and hold it there. What is seen, what counts, when it ends."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plategait.arrays import Array, Flags
from plategait.control.drive import Drive
from plategait.control.options import PoseOptions
from plategait.control.plant import Plant
from plategait.errors import InputError
from plategait.model.motion import PlateMotion

# What is 1 in an observation, m and s, and where it is cut off.
POSITION_UNIT, AGE_UNIT = 0.1, 0.1
_FARTHEST, _OLDEST = 3.0, 10.0
# Distances that cost as much as each other, m and rad.
COST_POSITION, COST_ANGLE = 0.01, math.radians(20)
# Rewards: for each second at the goal, for having stayed there, for a sheet that is lost.
PER_SECOND, DONE, LOST = 1.0, 5.0, -10.0
# Numbers of an observation before those of the action.
SEEN = ("x to go", "y to go", "cos of angle to go", "sin of angle to go", "x", "y", "cos of angle", "sin of angle",
        "age of frame", "any frame")  # fmt: skip


@dataclass(frozen=True, eq=False)
class Outcome:
    """What a tick brought to n lanes: (n,) rewards, and which came to an end, or were cut off by the time."""

    reward: Array
    terminated: Flags
    truncated: Flags


class PoseTask:
    """Sheets that are to be brought to poses, each on its own plate.

    Parameters
    ----------
    options : PoseOptions
    n : int
        How many lanes.
    """

    def __init__(self, options: PoseOptions, n: int) -> None:
        self.options = options
        nowhere, middle = np.zeros(3), (0.5,) * 4
        scenarios = [options.scenario(i, nowhere, middle) for i in range(n)]
        self.plant = Plant(
            scenarios, machine=options.machine, camera=options.camera, tick=1 / options.rate, threads=options.threads
        )
        self.drive: Drive | None = None
        self.choices: tuple[PlateMotion, ...] = ()
        if options.actions == "drive":
            self.drive = Drive(
                options.machine, free=options.free, ramp=options.ramp, acceleration=options.acceleration
            )  # fmt: skip
            self._idle = self.drive.rest
        else:
            self.choices = options.actions
            self._idle = np.zeros(len(self.choices))
        self._raised: dict[tuple[int, float], PlateMotion] = {}
        self._heights = [s.motion.height for s in scenarios]
        self.goal = np.zeros((n, 3))
        self._last = np.tile(self._idle, (n, 1))
        self._there, self._cost = np.zeros(n, dtype=np.int64), np.zeros(n)
        self._hold_ticks = max(1, math.ceil(options.hold * options.rate - 1e-9))
        self._limit_ticks = max(1, math.ceil(options.time_limit * options.rate - 1e-9))
        self._ticks = np.zeros(n, dtype=np.int64)

    @property
    def bounds(self) -> tuple[Array, Array]:
        """(k,) lowest and highest of each number of an observation."""
        low = [-_FARTHEST, -_FARTHEST, -1, -1, -_FARTHEST, -_FARTHEST, -1, -1, 0, 0]
        high = [_FARTHEST, _FARTHEST, 1, 1, _FARTHEST, _FARTHEST, 1, 1, _OLDEST, 1]
        least = -1.0 if self.drive is not None else 0.0
        k = len(self._idle)
        return np.array([*low, *[least] * k]), np.array([*high, *[1.0] * k])

    def begin(self, generators: Mapping[int, np.random.Generator], told: Mapping[str, Array] | None = None) -> None:
        """Begin episodes of some lanes, drawn by a generator each.

        Parameters
        ----------
        generators : mapping of int to Generator
            By lane.
        told : mapping of str to (3,) or (n, 3) array, optional
            ``start`` and ``goal`` where they are not to be drawn: x, y, m, and the angle, rad.
        """
        lanes, scenarios, seeds = list(generators), [], []
        told = {} if told is None else told
        self.goal = self.goal.copy()
        for lane, generator in generators.items():
            drawn, shares = generator.uniform(-1.0, 1.0, (2, 3)), generator.random(4).tolist()
            seeds.append(int(generator.integers(2**31)))
            drawn *= (*self.options.reach, math.pi)
            poses = {"start": drawn[0], "goal": drawn[1], **told}
            start, self.goal[lane] = (np.broadcast_to(poses[name], self.goal.shape)[lane] for name in ("start", "goal"))
            scenario = self.options.scenario(lane, start, shares)
            self._heights[lane] = scenario.motion.height
            scenarios.append(scenario)
        self.plant.reset(lanes, scenarios, seeds)
        self._there[lanes] = self._ticks[lanes] = 0
        self._last[lanes] = self._idle
        self._cost[lanes] = self._cost_now()[lanes]

    def step(self, actions: ArrayLike) -> Outcome:
        """Go on for a tick.

        Parameters
        ----------
        actions : (n, d) array, or (n,) ints
            Numbers for the drive, or which of the motions to choose from.

        Raises
        ------
        InputError
            For actions that are none.
        """
        given = np.asarray(actions)
        if self.drive is not None:
            motions = self.drive.motions(given, self._heights)
            self._last = np.clip(given, -1.0, 1.0).astype(float)
        else:
            if given.shape != (len(self.plant),) or not ((given >= 0) & (given < len(self.choices))).all():
                raise InputError("actions", str(given.tolist()), f"{len(self.plant)} whole numbers from 0 to "
                                 f"{len(self.choices) - 1}", "0")  # fmt: skip
            motions = [self._raised_to(int(k), height) for k, height in zip(given, self._heights, strict=True)]
            self._last = np.eye(len(self.choices))[given.astype(np.int64)]
        self.plant.step(motions)
        self._ticks += 1
        cost = self._cost_now()
        there = self.there
        self._there = np.where(there, self._there + 1, 0)
        done, lost = self._there >= self._hold_ticks, self.plant.failed
        done &= ~lost
        reward = (self._cost - cost) + PER_SECOND / self.options.rate * there + DONE * done + LOST * lost
        self._cost = cost
        terminated = done | lost
        return Outcome(reward, terminated, ~terminated & (self._ticks >= self._limit_ticks))

    def _raised_to(self, k: int, height: float) -> PlateMotion:
        """One of the motions to choose from, for a plate of a height."""
        key = (k, height)
        if key not in self._raised:
            if len(self._raised) > 4096:
                self._raised.clear()
            self._raised[key] = self.choices[k].with_valid(height=height)
        return self._raised[key]

    @property
    def error(self) -> Array:
        """(n, 3) way to go from where the sheets truly lie: x, y, m, and the angle, rad, in ±π."""
        return _way(self.plant.poses, self.goal)

    @property
    def there(self) -> Flags:
        """(n,) sheets that lie at their goals."""
        error = self.error
        near = np.hypot(error[:, 0], error[:, 1]) <= self.options.position_tolerance
        return near & (np.abs(error[:, 2]) <= self.options.angle_tolerance)

    def _cost_now(self) -> Array:
        """(n,) distance from the goals; of what has diverged, as it was."""
        error = self.error
        cost = np.hypot(error[:, 0], error[:, 1]) / COST_POSITION + np.abs(error[:, 2]) / COST_ANGLE
        return np.where(np.isfinite(cost), cost, self._cost)

    @property
    def observation(self) -> NDArray[np.float32]:
        """(n, k) what an agent is told, in the order of `SEEN`, with the last action after it."""
        seen = self.plant.seen
        none = np.isnan(seen.taken)
        to_go = _way(seen.poses, self.goal)
        columns = [
            to_go[:, 0] / POSITION_UNIT, to_go[:, 1] / POSITION_UNIT, np.cos(to_go[:, 2]), np.sin(to_go[:, 2]),
            seen.poses[:, 0] / POSITION_UNIT, seen.poses[:, 1] / POSITION_UNIT,
            np.cos(seen.poses[:, 2]), np.sin(seen.poses[:, 2]), (self.plant.time - seen.taken) / AGE_UNIT, ~none,
        ]  # fmt: skip
        told = np.where(none[:, None], 0.0, np.stack(columns, axis=1))
        low, high = self.bounds
        return np.clip(np.concatenate([told, self._last], axis=1), low, high).astype(np.float32)

    @property
    def info(self) -> dict[str, NDArray[Any]]:
        """What is true of each lane: `pose`, `goal` (n, 3), m, rad; `held`, s at the goal; `reached`; `status`."""
        held = self._there / self.options.rate
        status = np.array(self.plant.status, dtype=object)
        reached = (self._there >= self._hold_ticks) & ~self.plant.failed
        return {"pose": self.plant.poses.copy(), "goal": self.goal.copy(), "held": held, "reached": reached,
                "status": status}  # fmt: skip


def _way(poses: Array, goals: Array) -> Array:
    way = goals - poses
    turn = way[:, 2]
    way[:, 2] = turn - 2 * math.pi * np.round(turn / (2 * math.pi))
    return way
