"""MuJoCo as an integrator of our forces: another program's time steps, and the same motion."""

from __future__ import annotations

import shutil

import numpy as np
import pytest

from plategait.engine import cpu
from plategait.engine.recording import RunRequest
from plategait.model.presets import preset

pytest.importorskip("mujoco.batch")


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("g++") is None, reason="compiles the forces")
def test_mujoco_integrates_our_forces_to_our_motion(tmp_path):
    from benchmarks.peers.integrator import integrate

    cheese = preset("cheese").scenario.replace(**{"duration": 0.2, "transient": 0.0, "motion.frequency": 20.0})
    scenarios = [cheese.replace(**{"motion.angle": angle}) for angle in ("3 deg", "-5 deg")]
    _, ends = integrate(scenarios, 0.2, tmp_path)
    requests = [RunRequest(scenario, snapshot_interval=scenario.dt) for scenario in scenarios]
    recordings = cpu.run(requests, precision="float64")
    assert [recording.snapshot_time[-1] for recording in recordings] == pytest.approx([0.2, 0.2])
    ours = [recording.snapshots[-1] for recording in recordings]
    # The snapshots are in single precision, 4 nm at 60 mm; the nodes have moved by millimetres.
    assert np.abs(ends - ours).max() < 1e-7
