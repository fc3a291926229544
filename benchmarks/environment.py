"""What the vectorised environment costs: 64 lanes at 60 Hz, beside the bare engine and Gymnasium's count."""

from __future__ import annotations

import time
from typing import Any, cast

import numpy as np
from gymnasium.utils.performance import benchmark_vector_step

from plategait.control.drive import Drive
from plategait.control.vector import PoseVectorEnv
from plategait.simulation.session import Session

LANES = 64
TARGET = 0.6  # of the bare engine's throughput


def bare(env: PoseVectorEnv, seconds: float) -> float:
    """Environment steps a second if the engine were all: the same sheets in one long batch, a motion for each plate."""
    scenarios = [env.options.scenario(lane, np.zeros(3), (0.5,) * 4) for lane in range(LANES)]
    drive = cast(Drive, env.task.drive)
    motions = drive.motions(np.random.default_rng(1).uniform(-1, 1, (LANES, len(drive))),
                            [scenario.motion.height for scenario in scenarios])  # fmt: skip
    session = Session([s.with_valid(motion=motion) for s, motion in zip(scenarios, motions, strict=True)])
    begun = time.perf_counter()
    session.advance(None, seconds)
    return LANES * seconds * env.options.rate / (time.perf_counter() - begun)


def stepped(env: PoseVectorEnv, seconds: float) -> float:
    """Environment steps a second, with every motion changed in every step."""
    env.action_space.seed(1)
    env.reset(seed=1)
    actions = [env.action_space.sample() for _ in range(round(seconds * env.options.rate))]
    begun = time.perf_counter()
    for action in actions:
        env.step(action)
    return LANES * len(actions) / (time.perf_counter() - begun)


def ways(seconds: float = 2.0) -> dict[str, float]:
    """Environment steps a second of each way, taken once."""
    env = PoseVectorEnv(LANES)
    return {
        "the bare engine: one long batch": bare(env, seconds),
        "vectorised environment, every action another": stepped(env, seconds),
        "the same by Gymnasium's benchmark_vector_step": float(benchmark_vector_step(cast(Any, env), 1, seed=1)),
    }
