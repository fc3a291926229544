"""The task as a Gymnasium environment. Importing this registers ``plategait/Pose-v0``."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import gymnasium  # pyright: ignore[reportMissingImports]
import numpy as np
from gymnasium import spaces  # pyright: ignore[reportMissingImports]
from numpy.typing import NDArray

from plategait.arrays import Array, Picture
from plategait.control.options import PoseOptions
from plategait.control.scene import SIZE, Scene
from plategait.control.task import PoseTask
from plategait.errors import InputError

Observation = NDArray[np.float32]
Action = NDArray[np.float32] | np.int64

ID = "plategait/Pose-v0"
METADATA: Mapping[str, Any] = {"render_modes": ["rgb_array"], "render_fps": 60}


def spaces_of(task: PoseTask) -> tuple[spaces.Space[Any], spaces.Space[Any]]:
    """Spaces of one lane's observations and actions."""
    low, high = task.bounds
    observations = spaces.Box(low.astype(np.float32), high.astype(np.float32), dtype=np.float32)
    if task.drive is None:
        return observations, spaces.Discrete(len(task.choices))
    return observations, spaces.Box(-1.0, 1.0, (len(task.drive),), dtype=np.float32)


def told_in(options: Mapping[str, Any] | None) -> dict[str, Array]:
    """What `reset` is told of an episode.

    Raises
    ------
    InputError
        For what is not known, or no pose.
    """
    told: dict[str, Array] = {}
    for name, value in (options or {}).items():
        if name not in ("start", "goal"):
            raise InputError(f"options.{name}", "nothing known by that name", "start or goal", "goal")
        pose = np.asarray(value, dtype=float)
        if pose.ndim not in (1, 2) or pose.shape[-1] != 3 or not np.isfinite(pose).all():
            raise InputError(f"options.{name}", str(value), "x and y, m, and an angle, rad", "(0.02, 0.0, 1.57)")
        told[name] = pose
    return told


def check_render_mode(render_mode: str | None) -> str | None:
    """Refuse a way of drawing that there is not."""
    if render_mode not in (None, *METADATA["render_modes"]):
        raise InputError("render_mode", render_mode, 'None or "rgb_array"', '"rgb_array"')
    return render_mode


class PoseEnv(gymnasium.Env[Observation, Action]):
    """Bring a sheet to a place and an angle on a shaking plate, and hold it there (docs/control.md).

    Parameters
    ----------
    render_mode : {"rgb_array"}, optional
    size : (width, height)
        Of pictures, px.
    **options
        As of `PoseOptions`, one object.

    Raises
    ------
    InputError
        For an option that there is not, or a value that is not allowed.
    """

    metadata: dict[str, Any] = dict(METADATA)  # noqa: RUF012, as Gymnasium has it

    def __init__(self, render_mode: str | None = None, size: tuple[int, int] = SIZE, **options: Any) -> None:
        self.render_mode, self._size = check_render_mode(render_mode), size
        self.options = PoseOptions(**options)
        if (count := len(self.options.objects)) > 1:
            raise InputError("objects", f"{count} objects", "one, as a single environment keeps its own",
                             f'gymnasium.make_vec("{ID}", num_envs={count}, objects=…)')  # fmt: skip
        self.task = PoseTask(self.options, 1)
        self.metadata = {**METADATA, "render_fps": self.options.rate}
        self.observation_space, self.action_space = spaces_of(self.task)
        self._scene: Scene | None = None

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Lay the sheet somewhere, and tell where it is to go.

        Parameters
        ----------
        seed : int, optional
            Of this and later episodes.
        options : dict, optional
            ``start`` and ``goal``: x, y, m, and the angle, rad; drawn where left out.
        """
        super().reset(seed=seed)
        self.task.begin({0: self.np_random}, told_in(options))
        return self.task.observation[0], self._info()

    def step(self, action: Action) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Go on for a tick of 1/rate s."""
        outcome = self.task.step(np.asarray(action)[None])
        return (
            self.task.observation[0], float(outcome.reward[0]), bool(outcome.terminated[0]), bool(outcome.truncated[0]),
            self._info(),
        )  # fmt: skip

    def _info(self) -> dict[str, Any]:
        return {name: values[0].copy() if values.ndim > 1 else values[0].item() if values.dtype != object else values[0]
                for name, values in self.task.info.items()}  # fmt: skip

    def render(self) -> Picture | None:  # type: ignore[override]
        """Picture of the sheet on its plate, with the goal marked: (height, width, 3) bytes."""
        if self.render_mode is None:
            gymnasium.logger.warn("render() shows nothing without render_mode='rgb_array'")
            return None
        if self._scene is None:
            self._scene = Scene(self._size)
        return self._scene.picture(self.task, 0)


if ID not in gymnasium.registry:
    gymnasium.register(
        id=ID,
        entry_point="plategait.control.environment:PoseEnv",
        vector_entry_point="plategait.control.vector:PoseVectorEnv",
    )
