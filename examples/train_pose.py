"""Train a small policy with Stable-Baselines3 to lay a slice of cheese at a pose, and hold it against open loop.

``pip install "plategait[control]" stable-baselines3``, then ``python examples/train_pose.py``. Twenty times a second
the policy chooses one of five motions: hold, across the bar and turn, both ways. None goes along the bar by itself:
turning carries along what lies off the bar, and the policy has to find that out. A goal is reached within 5 mm and
10 deg, and held for half a second. Open loop goes to the bar, turns there, where turning carries nothing along, and
goes to the goal's side, each for as long as the mean speed of the motion asks for, and does not look.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from typing import Any

import numpy as np
from stable_baselines3 import PPO  # pyright: ignore[reportMissingImports]

import plategait as pg
from plategait.control.baselines import PoseVecEnv
from plategait.control.vector import PoseVectorEnv

HOLD, LEFT, RIGHT, TURN_LEFT, TURN_RIGHT = range(5)
Act = Callable[[PoseVectorEnv, np.ndarray], np.ndarray]


def menu() -> tuple[pg.PlateMotion, ...]:
    """Motions for the cheese on the source's robot; of each pair one is the mirror image of the other."""

    def motion(frequency: float, angle: float, stroke: float, phase: float, offset: float) -> pg.PlateMotion:
        shaking = ({"axis": "x", "amplitude": f"{stroke} mm", "phase": f"{phase} deg"},) if stroke else ()
        return pg.PlateMotion(frequency=frequency, angle=f"{angle} deg", stroke=0, waves=shaking, ramp="50 ms",
                              offset={"rx": f"{offset} deg"})  # fmt: skip

    across, turning = (27.4, 0, 2.0, 61.2, 8.1), (22.0, 3.2, 1.1, 0, 0)
    return (
        motion(24, 0, 0, 0, 0),
        motion(*across[:4], -across[4]), motion(*across),
        motion(*turning), motion(turning[0], -turning[1], *turning[2:]),
    )  # fmt: skip


RATE = 20
OPTIONS: dict[str, Any] = {
    "actions": menu(), "rate": RATE, "reach": "2 mm", "hold": "0.5 s", "time_limit": "10 s",
    "position_tolerance": "5 mm", "angle_tolerance": "5 deg",
}  # fmt: skip


def twists(lanes: int = 64, seconds: float = 0.5) -> np.ndarray:
    """(5, 3) mean velocity that each motion gives: along and across, m/s, and turning, rad/s."""
    env = PoseVectorEnv(lanes, **{**OPTIONS, "hold": "9 s"})
    found = []
    for action in range(len(menu())):
        before = after = env.reset(seed=1)[1]["pose"]
        for _ in range(round(RATE * seconds)):
            after = env.step(np.full(lanes, action))[4]["pose"]
        way = after - before
        way[:, 2] = (way[:, 2] + np.pi) % (2 * np.pi) - np.pi
        found.append(way.mean(axis=0) / seconds)
    return np.array(found)


def open_loop(speeds: np.ndarray) -> Act:
    """Across to the bar, turn, across to the goal; then hold."""

    def taken(way: float, plus: int, minus: int, part: int) -> list[int]:
        action = plus if way > 0 else minus
        return [action] * round(RATE * way / speeds[action, part])

    def act(env: PoseVectorEnv, observation: np.ndarray) -> np.ndarray:
        if not plans:
            # As it truly lies at first, so that nothing is lost to the camera.
            for pose, error in zip(env.task.plant.poses, env.task.error, strict=True):
                plans.append(taken(-pose[1], LEFT, RIGHT, 1) + taken(error[2], TURN_LEFT, TURN_RIGHT, 2)
                             + taken(pose[1] + error[1], LEFT, RIGHT, 1))  # fmt: skip
        return np.array([plan.pop(0) if plan else HOLD for plan in plans])

    plans: list[list[int]] = []
    return act


def learnt(model: PPO) -> Act:
    """What the policy thinks best."""
    return lambda env, observation: model.predict(observation, deterministic=True)[0]


def reached(act: Act, episodes: int, seed: int) -> tuple[float, float, float]:
    """Share of episodes that reach their goals, share that are lost, and the median time of the first, s."""
    env = PoseVectorEnv(episodes, autoreset_mode="NextStep", **OPTIONS)
    observation, _ = env.reset(seed=seed)
    done, lost, time_taken = np.zeros(episodes, bool), np.zeros(episodes, bool), np.full(episodes, np.nan)
    over = np.zeros(episodes, bool)
    for tick in range(1, 10 * RATE + 1):
        observation, _, terminated, truncated, infos = env.step(act(env, observation))
        now = ~over & (terminated | truncated)
        done |= now & infos["reached"]
        lost |= now & (infos["status"] != "")
        time_taken[now & infos["reached"]] = tick / RATE
        over |= now
    return float(done.mean()), float(lost.mean()), float(np.nanmedian(time_taken)) if done.any() else np.nan


def main() -> None:
    """Train, and say how often goals are reached with and without looking."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--steps", type=int, default=400_000)
    parser.add_argument("--episodes", type=int, default=200)
    parser.add_argument("--out", default="out/train_pose.zip")
    told = parser.parse_args()
    speeds = twists()
    print("mm/s, mm/s, deg/s:", np.round(speeds * [1e3, 1e3, 180 / np.pi]).tolist())
    begun = time.perf_counter()
    model = PPO(
        "MlpPolicy", PoseVecEnv(64, **OPTIONS), n_steps=64, batch_size=1024, n_epochs=6, gamma=0.98, learning_rate=1e-3,
        ent_coef=0.01, policy_kwargs={"net_arch": [128, 128]}, seed=0, device="cpu",
    )  # fmt: skip
    model.learn(told.steps)
    model.save(told.out)
    print(f"{told.steps} steps in {time.perf_counter() - begun:.0f} s")
    for name, act in (("open loop", open_loop(speeds)), ("learnt", learnt(model))):
        share, lost, median = reached(act, told.episodes, seed=1000)
        print(f"{name}: {100 * share:.0f} % reached, {100 * lost:.0f} % lost, median {median:.1f} s")


if __name__ == "__main__":
    main()
