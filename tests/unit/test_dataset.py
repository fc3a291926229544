"""Datasets: how large they will be, and that what does not fit is refused before the run."""

from __future__ import annotations

import numpy as np
import pytest

from plategait.engine.recording import RunRequest
from plategait.errors import InputError
from plategait.model.presets import preset
from plategait.simulation import dataset
from plategait.simulation.dataset import dataset_of
from plategait.simulation.run import FILM_INTERVAL, simulate

SHORT = preset("cheese").scenario.replace(duration="0.3 s")


@pytest.mark.parametrize("interval", [0.0, FILM_INTERVAL, 0.05])
def test_the_size_is_known_before_the_run(interval, tmp_path):
    simulation = simulate(SHORT, repeats=2, snapshot_interval=interval)
    data = dataset_of(simulation)
    told = 2 * dataset.dataset_bytes(RunRequest(SHORT, snapshot_interval=interval))
    # Beside the arrays that are told there are coordinates, of a few numbers for each sample.
    assert told <= data.nbytes <= 1.1 * told
    dataset.write_dataset(simulation, tmp_path / "run.nc")
    # And text and HDF5's own.
    assert told <= (tmp_path / "run.nc").stat().st_size <= 1.1 * told + 200_000


def test_shapes_are_kept_in_the_precision_that_they_have():
    assert dataset_of(simulate(SHORT, snapshot_interval=FILM_INTERVAL))["position"].dtype == np.float32


@pytest.mark.parametrize(("what", "free"), [("memory", 1e6), ("disk", 1e5)])
def test_what_does_not_fit_is_refused_with_a_duration_that_does(what, free, tmp_path, monkeypatch):
    run = RunRequest(SHORT, snapshot_interval=FILM_INTERVAL)
    if what == "memory":
        monkeypatch.setattr(dataset, "available_memory", lambda: free)
    else:
        monkeypatch.setattr(dataset.shutil, "disk_usage", lambda folder: type("Usage", (), {"free": free}))
    with pytest.raises(InputError, match=f"of {what}") as caught:
        dataset.check_room(run, 5, tmp_path / "run.nc")
    shorter = caught.value.hint.split('"')[1]
    dataset.check_room(
        RunRequest(SHORT.replace(duration=shorter), snapshot_interval=FILM_INTERVAL), 5, tmp_path / "run.nc"
    )
