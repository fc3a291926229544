"""The task as Stable-Baselines3 has vectorised environments. It is imported only here, and is no part of any extra."""

from __future__ import annotations

from typing import Any

import numpy as np
from gymnasium.vector import AutoresetMode  # pyright: ignore[reportMissingImports]
from numpy.typing import NDArray
from stable_baselines3.common.vec_env.base_vec_env import VecEnv, VecEnvIndices  # pyright: ignore[reportMissingImports]

from plategait.control.vector import PoseVectorEnv
from plategait.errors import InputError


class PoseVecEnv(VecEnv):
    """``PPO("MlpPolicy", PoseVecEnv(64))``: lanes of one session, each followed by its next episode at once.

    Parameters
    ----------
    num_envs : int
    **options
        As of `PoseVectorEnv`, but for the way in which episodes follow each other.

    Raises
    ------
    InputError
        As of `PoseVectorEnv`.
    """

    def __init__(self, num_envs: int, **options: Any) -> None:
        if "autoreset_mode" in options:
            got = options["autoreset_mode"]
            raise InputError("autoreset_mode", got, "left out, as there is but one", f"PoseVecEnv({num_envs})")
        self.env = PoseVectorEnv(num_envs, autoreset_mode=AutoresetMode.SAME_STEP, **options)
        self.render_mode = self.env.render_mode
        self._actions: NDArray[Any] | None = None
        super().__init__(num_envs, self.env.single_observation_space, self.env.single_action_space)

    def reset(self) -> NDArray[np.float32]:
        """Begin episodes of all lanes, with the seeds of `seed` and the options of `set_options`, if there are any."""
        seeds = self._seeds if any(seed is not None for seed in self._seeds) else None
        told = [options for options in self._options if options]
        options = {name: np.array([each[name] for each in self._options]) for name in told[0]} if told else None
        observation, infos = self.env.reset(seed=seeds, options=options)
        self.reset_infos = [self._of_lane(infos, lane) for lane in range(self.num_envs)]
        self._reset_seeds()
        self._reset_options()
        return observation

    def step_async(self, actions: NDArray[Any]) -> None:
        """Say what is done next."""
        self._actions = actions

    def step_wait(self) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.bool_], list[dict[str, Any]]]:
        """Go on for a tick: observations, rewards, which episodes were over, and a dict for each lane."""
        assert self._actions is not None
        observation, reward, terminated, truncated, infos = self.env.step(self._actions)
        over = terminated | truncated
        told: list[dict[str, Any]] = []
        for lane in range(self.num_envs):
            last = over[lane]
            own = self._of_lane(infos["final_info"] if last else infos, lane)
            own["TimeLimit.truncated"] = bool(truncated[lane] and not terminated[lane])
            if last:
                own["terminal_observation"] = infos["final_obs"][lane]
            told.append(own)
        return observation, reward.astype(np.float32), over, told

    @staticmethod
    def _of_lane(infos: dict[str, Any], lane: int) -> dict[str, Any]:
        """What is true of one lane: how long it has been at its goal, whether that was long enough, what went wrong."""
        return {name: infos[name][lane] for name in ("held", "reached", "status")}

    def close(self) -> None:
        """End the environment."""
        self.env.close()

    def get_images(self) -> list[Any]:
        """Picture of each lane."""
        return list(self.env.render() or [])

    def get_attr(self, attr_name: str, indices: VecEnvIndices = None) -> list[Any]:
        """An attribute, which all lanes share."""
        return [getattr(self.env, attr_name)] * len(list(self._get_indices(indices)))

    def set_attr(self, attr_name: str, value: Any, indices: VecEnvIndices = None) -> None:
        """Refuse another value: lanes share what they are."""
        raise InputError(attr_name, str(value), "told when the environment is made", f"PoseVecEnv({self.num_envs}, …)")

    def env_method(self, method_name: str, *args: Any, indices: VecEnvIndices = None, **kwargs: Any) -> list[Any]:
        """Refuse a method of a lane by itself."""
        raise InputError(method_name, "of a lane", "called on the whole, as env.env", f"env.env.{method_name}")

    def env_is_wrapped(self, wrapper_class: type, indices: VecEnvIndices = None) -> list[bool]:
        """No lane is wrapped."""
        return [False] * len(list(self._get_indices(indices)))
