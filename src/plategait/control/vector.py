"""The task as a vectorised Gymnasium environment: all lanes in one session."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import gymnasium  # pyright: ignore[reportMissingImports]
import numpy as np
from gymnasium.utils import seeding  # pyright: ignore[reportMissingImports]
from gymnasium.vector import AutoresetMode, VectorEnv  # pyright: ignore[reportMissingImports]
from gymnasium.vector.utils import batch_space  # pyright: ignore[reportMissingImports]
from numpy.typing import NDArray

from plategait.arrays import Array, Flags, Picture
from plategait.control.environment import METADATA, Observation, check_render_mode, spaces_of, told_in
from plategait.control.options import PoseOptions
from plategait.control.scene import SIZE, Scene
from plategait.control.task import PoseTask
from plategait.errors import InputError

Step = tuple[Observation, NDArray[Any], NDArray[Any], NDArray[Any], dict[str, Any]]


class PoseVectorEnv(VectorEnv[Observation, NDArray[Any], NDArray[Any]]):
    """Sheets that are to be brought to poses, side by side: lane i is the same bits as a single environment.

    ``gymnasium.make_vec("plategait/Pose-v0", num_envs=64)`` makes one. With a seed, lane i does what a single
    environment does with seed + i and the lane's object.

    Parameters
    ----------
    num_envs : int
    autoreset_mode : AutoresetMode or its value
        When an episode that is over is followed by the next: with the next step, in the same one, or never by itself.
    render_mode, size, **options
        As of `PoseEnv`; several objects are shared out, lane i keeps ``objects[i % len(objects)]``.

    Raises
    ------
    InputError
        As of `PoseEnv`.
    """

    def __init__(
        self,
        num_envs: int = 1,
        *,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        render_mode: str | None = None,
        size: tuple[int, int] = SIZE,
        **options: Any,
    ) -> None:
        if num_envs < 1:
            raise InputError("num_envs", num_envs, "1 or more", "64")
        modes = [mode.value for mode in AutoresetMode]
        if not isinstance(autoreset_mode, AutoresetMode) and autoreset_mode not in modes:
            raise InputError("autoreset_mode", autoreset_mode, f"one of {', '.join(modes)}", modes[0])
        self.num_envs, self.mode = num_envs, AutoresetMode(autoreset_mode)
        self.render_mode, self._size = check_render_mode(render_mode), size
        self.options = PoseOptions(**options)
        self.task = PoseTask(self.options, num_envs)
        self.metadata = {**METADATA, "render_fps": self.options.rate, "autoreset_mode": self.mode}
        self.single_observation_space, self.single_action_space = spaces_of(self.task)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._generators: list[np.random.Generator | None] = [None] * num_envs
        self._over = np.zeros(num_envs, dtype=bool)
        self._scene: Scene | None = None

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Begin episodes.

        Parameters
        ----------
        seed : int, or one for each lane, optional
            Lane i begins with seed + i.
        options : dict, optional
            ``start`` and ``goal`` as of `PoseEnv`, (3,) or (num_envs, 3); ``reset_mask``, (num_envs,) flags of the
            lanes that begin anew, the others stay where they are.
        """
        told = dict(options or {})
        mask = told.pop("reset_mask", None)
        if mask is not None and not _is_mask(mask, self.num_envs):
            what = f"a bool array of {self.num_envs} flags, one of them true"
            raise InputError("options.reset_mask", str(mask), what, "np.ones(num_envs, dtype=bool)")
        seeds = list(seed) if isinstance(seed, Sequence) else [None if seed is None else int(seed) + i
                                                               for i in range(self.num_envs)]  # fmt: skip
        if len(seeds) != self.num_envs:
            raise InputError("seed", f"{len(seeds)} seeds", f"one, or one for each of {self.num_envs} lanes", "1")
        lanes = np.flatnonzero(np.ones(self.num_envs, dtype=bool) if mask is None else mask)
        for lane in lanes:
            if seeds[lane] is not None or self._generators[lane] is None:
                self._generators[lane] = seeding.np_random(seeds[lane])[0]
        self._begin(lanes, told_in(told))
        self._over = self._over.copy()
        self._over[lanes] = False
        return self.task.observation, self._infos(np.isin(np.arange(self.num_envs), lanes))

    def _begin(self, lanes: NDArray[np.intp], told: dict[str, Array] | None = None) -> None:
        generators = {int(lane): generator for lane in lanes if (generator := self._generators[lane]) is not None}
        self.task.begin(generators, told)

    def step(self, actions: NDArray[Any]) -> Step:
        """Go on for a tick of 1/rate s.

        Raises
        ------
        gymnasium.error.ResetNeeded
            Before the first `reset`, or for an episode that is over where none follows by itself.
        """
        if None in self._generators:
            raise gymnasium.error.ResetNeeded("reset() begins the first episodes")
        if self.mode is AutoresetMode.DISABLED and self._over.any():
            raise gymnasium.error.ResetNeeded(
                f"episodes of lanes {np.flatnonzero(self._over).tolist()} are over: reset(options={{'reset_mask': …}})"
            )
        outcome = self.task.step(actions)
        reward, terminated, truncated = outcome.reward, outcome.terminated, outcome.truncated
        everyone = np.ones(self.num_envs, dtype=bool)
        infos: dict[str, Any] = {}
        if self.mode is AutoresetMode.NEXT_STEP and self._over.any():
            # They were advanced with the others for nothing, and begin now.
            self._begin(np.flatnonzero(self._over))
            reward = np.where(self._over, 0.0, reward)
            terminated, truncated = terminated & ~self._over, truncated & ~self._over
        over = terminated | truncated
        if self.mode is AutoresetMode.SAME_STEP and over.any():
            infos = self._final(over)
            self._begin(np.flatnonzero(over))
        self._over = over
        return self.task.observation, reward, terminated, truncated, infos | self._infos(everyone)

    def _final(self, over: Flags) -> dict[str, Any]:
        """What lanes showed when their episodes were over, as Gymnasium's own vector environments tell it."""
        observation, last = self.task.observation, self._infos(over)
        final = np.full(self.num_envs, None, dtype=object)
        for lane in np.flatnonzero(over):
            final[lane] = observation[lane].copy()
        return {"final_obs": final, "_final_obs": over.copy(), "final_info": last, "_final_info": over.copy()}

    def _infos(self, lanes: Flags) -> dict[str, Any]:
        """What is true of some lanes, with a mask beside each name."""
        infos: dict[str, Any] = {}
        for name, values in self.task.info.items():
            if not lanes.all():
                values = values.copy()
                values[~lanes] = None if values.dtype == object else 0
            infos[name], infos[f"_{name}"] = values, lanes.copy()
        return infos

    def render(self) -> tuple[Picture, ...] | None:  # type: ignore[override]
        """Picture of each lane."""
        if self.render_mode is None:
            gymnasium.logger.warn("render() shows nothing without render_mode='rgb_array'")
            return None
        if self._scene is None:
            self._scene = Scene(self._size)
        return tuple(self._scene.picture(self.task, lane) for lane in range(self.num_envs))


def _is_mask(mask: Any, n: int) -> bool:
    return isinstance(mask, np.ndarray) and mask.shape == (n,) and mask.dtype == np.bool_ and bool(mask.any())
