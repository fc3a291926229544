"""Engines by name, and the contract that all of them keep."""

from __future__ import annotations

from typing import get_args

import numpy as np
import pytest

from plategait.campaign.plan import Sweep
from plategait.engine import engines
from plategait.engine.channels import CHANNELS
from plategait.engine.engines import ENGINES, Engine, EngineEntry
from plategait.engine.recording import RunRequest
from plategait.errors import InputError
from plategait.model.presets import preset
from plategait.simulation.run import simulate

SHORT = preset("cheese").scenario.replace(duration=0.03)
RUNS = [
    RunRequest(SHORT, offset=(1e-4, 0.0, 0.1), snapshot_interval=0.01),
    RunRequest(SHORT.replace(**{"motion.frequency": 40.0})),
]


def test_every_name_has_a_row():
    assert get_args(Engine) == tuple(ENGINES)


@pytest.mark.parametrize("name", ENGINES)
def test_an_engine_keeps_the_contract(name):
    told: list[float] = []
    recordings = ENGINES[name].run(RUNS, threads=1, progress=told.append)
    assert len(recordings) == len(RUNS)
    for run, recording in zip(RUNS, recordings, strict=True):
        assert set(recording.channels) == set(CHANNELS)
        assert all(series.shape == (run.samples,) for series in recording.channels.values())
        assert recording.snapshots.shape == (run.pictures, 52, 3)
        assert recording.plate_pose.shape == (run.pictures, 6)
        np.testing.assert_allclose(recording["time"], np.arange(run.samples) * run.stride * run.scenario.dt)
        np.testing.assert_allclose(recording.dt * recording.steps, run.scenario.duration)
        assert not recording.diverged
    assert told
    assert told == sorted(told)
    assert told[0] >= 0
    assert told[-1] <= 1


@pytest.mark.parametrize("name", ENGINES)
def test_what_progress_raises_stops_an_engine(name):
    def stop(fraction: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        ENGINES[name].run([RunRequest(SHORT.replace(duration=1000.0))], progress=stop)


@pytest.mark.slow
@pytest.mark.parametrize("name", ENGINES)
def test_engines_begin_alike(name):
    # One start and one plate for all: single precision to 1e-6 of the sheet's size.
    for run, ours in zip(RUNS, ENGINES[name].run(RUNS), strict=True):
        (theirs,) = ENGINES["cpu64"].run([run])
        for channel in ("centre_x", "centre_y", "centre_z", "spin_cross", "spin_dot", "area_z", "height_low", "time"):
            assert ours[channel][0] == pytest.approx(theirs[channel][0], rel=1e-5, abs=1e-7)
        for axis in ("x", "y", "z", "rx", "ry", "rz"):
            np.testing.assert_allclose(ours[f"plate_{axis}"], theirs[f"plate_{axis}"], atol=1e-7)


def test_a_row_is_all_that_an_engine_needs(monkeypatch):
    row = EngineEntry("the core under another name", "float32", ENGINES["cpu"].load)
    monkeypatch.setattr(engines, "ENGINES", {**ENGINES, "other": row})
    there, here = simulate(SHORT, engine="other"), simulate(SHORT)  # type: ignore[arg-type]
    assert there.engine == "other"
    np.testing.assert_array_equal(there.recordings[0]["spin_cross"], here.recordings[0]["spin_cross"])


def test_no_engine_is_refused_with_those_there_are():
    for name in ("gpu", None, 3, ["cpu"]):
        with pytest.raises(InputError, match=r"engine.*one of cpu, cpu64, tiles"):
            simulate(SHORT, engine=name)  # type: ignore[arg-type]
    with pytest.raises(InputError, match=r"engine.*'tiles'"):
        Sweep(scenario="cheese", grid={"motion.frequency": [20.0]}, engine="gpu")  # type: ignore[arg-type]


def test_tiles_can_be_swept():
    sweep = Sweep(scenario="cheese", grid={"motion.frequency": [20.0]}, engine="tiles")  # type: ignore[arg-type]
    assert sweep.engine == "tiles"
