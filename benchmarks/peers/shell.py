"""MuJoCo's own shell of the same sheets, with its own contact, at the largest step that it is good at."""

from __future__ import annotations

import importlib
import math
import time
from collections.abc import Sequence
from itertools import takewhile
from typing import Any

import numpy as np

from plategait.export.mjcf.scene import mjcf
from plategait.model.scenario import Scenario

mujoco, peer = importlib.import_module("mujoco"), importlib.import_module("mujoco.batch")

STEPS = (2.5e-4, 5e-4, 1e-3, 2e-3)
SMALL_STEP = 1e-4
# A step is good while a sheet turns as far as at the small step, within this share, in this time (s), at it and below.
GOOD, TURN_FOR = 0.15, 0.3


def _batch(scenarios: Sequence[Scenario], step: float, threads: int) -> Any:
    models = [mujoco.MjModel.from_xml_string(mjcf(scenario, "shell", step)) for scenario in scenarios]
    batch = peer.Batch(models[0], len(models), threads)
    batch.set_models(models)
    batch.bind("qpos")[:] = [model.key_qpos[0] for model in models]
    batch.bind("qvel")[:] = [model.key_qvel[0] for model in models]
    return batch


def _turned(scenario: Scenario, step: float) -> float:
    """How far a sheet turns, rad; NaN where MuJoCo gave up."""
    n = scenario.sheet.lattice.n_nodes
    batch = _batch([scenario], step, 1)
    try:
        batch.step(nstep=round(TURN_FOR / step))
    except (peer.SimulationError, mujoco.FatalError):
        return math.nan
    rest = scenario.sheet.lattice.rest
    now = batch.bind("qpos")[0, -3 * n :].reshape(n, 3)[:, :2] + scenario.sheet.pitch * rest
    now = now - now.mean(axis=0)
    return math.atan2((rest[:, 0] * now[:, 1] - rest[:, 1] * now[:, 0]).sum(), (rest * now).sum())


def largest_good_step(scenario: Scenario) -> tuple[float, dict[float, float]]:
    """Largest step at which a sheet turns as at the small one, s, and by which factor it turns further at each."""
    small = _turned(scenario, SMALL_STEP)
    factors = {step: _turned(scenario, step) / small for step in STEPS}
    good = takewhile(lambda step: abs(factors[step] - 1) < GOOD, STEPS)
    return max(good, default=SMALL_STEP), factors


def run_shells(scenarios: Sequence[Scenario], duration: float, step: float, threads: int = 0) -> float:
    """Simulated seconds per second of a batch of shells that all differ."""
    batch = _batch(scenarios, step, threads)
    steps = round(duration / step)
    begun = time.perf_counter()
    batch.step(nstep=steps)
    wall = time.perf_counter() - begun
    assert np.isfinite(batch.bind("qpos")).all()
    return len(scenarios) * steps * step / wall
