"""What a tracking camera delivers of sheets on their plates: poses with noise, late, and some of them never."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, field_validator

from plategait.arrays import Array, Flags
from plategait.errors import InputError
from plategait.model.base import Model
from plategait.units import Delay, Quantity

_RATE = Quantity("Hz", "Hz", "60 Hz", above=0, at_most=1e5)
_NOISE = Quantity("m", "mm", "0.5 mm", at_least=0, at_most=1)
_ANGLE_NOISE = Quantity("rad", "deg", "1 deg", at_least=0, at_most=math.pi)
# A camera that misses nearly all frames is none.
_SHARE = Quantity("", "", "0.05", at_least=0, at_most=0.99)
# Frames whose noise is drawn at once, and what each draws: three numbers of noise, and whether it is missed.
_BLOCK, _DRAWS = 256, 4
# Two times this near to each other are one, s.
NEARLY = 1e-9


class Camera(Model):
    """A camera above the plate, and what reads the pose off its pictures.

    Frame k is taken k/rate after a sheet was laid down, and arrives `delay` later.
    """

    rate: Annotated[float, _RATE] = Field(default=60.0, description="frames per second")
    position_noise: Annotated[float, _NOISE] = Field(default=0.5e-3, description="standard deviation along x and y")
    angle_noise: Annotated[float, _ANGLE_NOISE] = Field(
        default=math.radians(1), description="standard deviation of the angle"
    )
    delay: Delay = Field(default=0.03, description="from a frame until its pose is known")
    missed: Annotated[float, _SHARE] = Field(default=0.05, description="chance of each frame to be missed")
    dark: tuple[tuple[float, float], ...] = Field(
        default=(), description="times from and to which it sees nothing, s", examples=["[[1.0, 1.5]]"]
    )

    @field_validator("dark")
    @classmethod
    def _from_to(cls, value: tuple[tuple[float, float], ...]) -> tuple[tuple[float, float], ...]:
        for begin, end in value:
            if not 0 <= begin < end < math.inf:
                raise InputError("", f"from {begin:g} s to {end:g} s", "from a time to a later one", "[[1.0, 1.5]]")
        return value


PERFECT = Camera(position_noise=0.0, angle_noise=0.0, delay=0.0, missed=0.0)
"""A camera that tells where a sheet lies now."""
PIXELS = Camera(rate=30.0, position_noise=0.3e-3, angle_noise=math.radians(0.3), missed=0.0)
"""What a controller is to know of poses that are read in pixels (`plategait.control.pixels`): what they scatter by."""


@dataclass(frozen=True, eq=False)
class Seen:
    """What has arrived of n sheets by now.

    Attributes
    ----------
    poses : (n, 3) array
        As the newest frame that arrived shows them: x, y, m, and the angle, rad, in ±π; NaN before the first.
    taken : (n,) array
        When that frame was taken, s since the sheet was laid down; NaN before the first.
    new : (n,) bool array
        Whether it arrived since one looked before.
    """

    poses: Array
    taken: Array
    new: Flags


class Stream:
    """What one camera for each of n sheets delivers.

    The noise of a frame depends on its sheet's seed, how often the sheet was laid down, and the frame's number alone.

    Parameters
    ----------
    camera : Camera
    seeds : sequence of int
        One for each sheet, 0 or more.
    """

    def __init__(self, camera: Camera, seeds: Sequence[int]) -> None:
        n = len(seeds)
        self.camera = camera
        self._keys = [(int(seed), 0) for seed in seeds]
        # Frames on their way, and the newest that arrived, in a ring: one that is pushed out is older than one that
        # has arrived.
        self._room = math.floor(camera.delay * camera.rate) + 2
        self._poses, self._taken = np.full((n, self._room, 3), np.nan), np.full((n, self._room), -np.inf)
        self._stored, self._next = np.zeros(n, dtype=np.int64), np.zeros(n, dtype=np.int64)
        self._known = np.full(n, -np.inf)
        self._blocks: list[Array] = [np.zeros((0, _DRAWS))] * n
        self._noise = np.array([camera.position_noise, camera.position_noise, camera.angle_noise])

    def copy(self) -> Stream:
        """The same frames on their way, to go on with by themselves."""
        other = Stream.__new__(Stream)
        other.__dict__.update(self.__dict__)
        other._keys, other._blocks = list(self._keys), list(self._blocks)
        for name in ("_poses", "_taken", "_stored", "_next", "_known"):
            setattr(other, name, getattr(self, name).copy())
        return other

    def reset(self, lanes: Sequence[int], seeds: Sequence[int] | None = None) -> None:
        """Sheets are laid down anew: nothing has been seen of them. With other seeds, where they are given."""
        for k, i in enumerate(lanes):
            seed, count = self._keys[i]
            self._keys[i] = (seed, count + 1) if seeds is None else (int(seeds[k]), 0)
        where = np.asarray(lanes, dtype=np.int64)
        self._poses[where], self._taken[where], self._known[where] = np.nan, -np.inf, -np.inf
        self._stored[where], self._next[where] = 0, 0

    @property
    def due(self) -> Array:
        """(n,) when the next frame of each sheet is taken, s since it was laid down."""
        return self._next / self.camera.rate

    def take(self, lanes: NDArray[np.int64], poses: Array) -> None:
        """Take the next frame of some sheets.

        Parameters
        ----------
        lanes : (m,) int array
        poses : (m, 3) array
            Where they lie: x, y, m, and the angle, rad. What is not finite is not seen.
        """
        draws = np.array([self._drawn(int(i)) for i in lanes]).reshape(-1, _DRAWS)
        time = self.due[lanes]
        seen = (draws[:, 3] >= self.camera.missed) & np.isfinite(poses).all(axis=1)
        for begin, end in self.camera.dark:
            seen &= (time < begin) | (time >= end)
        shown = poses + self._noise * draws[:, :3]
        shown[:, 2] = np.arctan2(np.sin(shown[:, 2]), np.cos(shown[:, 2])) if self._noise[2] else poses[:, 2]
        self._next[lanes] += 1
        which = lanes[seen]
        slot = self._stored[which] % self._room
        self._poses[which, slot], self._taken[which, slot] = shown[seen], time[seen]
        self._stored[which] += 1

    def _drawn(self, lane: int) -> Array:
        """(4,) three normal numbers and one from 0 to 1, of a sheet's next frame."""
        block, k = divmod(int(self._next[lane]), _BLOCK)
        if k == 0:
            draw = np.random.default_rng([*self._keys[lane], block])
            self._blocks[lane] = np.column_stack([draw.standard_normal((_BLOCK, 3)), draw.random(_BLOCK)])
        return self._blocks[lane][k]

    def look(self, time: Array) -> Seen:
        """What has arrived by now: (n,) s since each sheet was laid down."""
        arrived = self._taken + self.camera.delay <= time[:, None] + NEARLY
        taken = np.where(arrived, self._taken, -np.inf)
        newest = taken.argmax(axis=1)
        every = np.arange(len(newest))
        latest = taken[every, newest]
        new = latest > self._known
        self._known = np.maximum(self._known, latest)
        none = np.isneginf(latest)
        return Seen(
            poses=np.where(none[:, None], np.nan, self._poses[every, newest]),
            taken=np.where(none, np.nan, latest), new=new,
        )  # fmt: skip
