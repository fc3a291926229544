"""Campaigns in one process: plans, stores, damage, locks, refinement, a Dask cluster."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import pytest
import xarray

from plategait.campaign.identity import fingerprint_of
from plategait.campaign.lock import locked
from plategait.campaign.opened import open_sweep
from plategait.campaign.plan import Sweep
from plategait.campaign.points import base_points
from plategait.campaign.run import sweep
from plategait.campaign.seal import sealed
from plategait.errors import InputError

PLAN = {
    "name": "small",
    "scenario": "cheese",
    "batch": 3,
    "set": {"duration": "0.4 s"},
    "grid": {"motion.frequency": ["14 Hz", "18 Hz", "22 Hz", "26 Hz"], "friction_angle": ["30 deg", "40 deg"]},
}


def assert_same(one: Path, two: Path) -> None:
    with xarray.open_zarr(one, chunks=None) as a, xarray.open_zarr(two, chunks=None) as b:
        assert set(a.variables) == set(b.variables)
        for name in a.variables:
            np.testing.assert_array_equal(a[name].values, b[name].values, err_msg=str(name))


@pytest.fixture(scope="module")
def store(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("store") / "s.zarr"
    assert sweep(PLAN, path).complete
    return path


def test_a_grid_is_every_combination_and_friction_keeps_its_ratio():
    plan = Sweep(**PLAN)
    points = base_points(plan)
    assert len(points) == 8
    scenario = plan.at(points[-1])
    assert scenario.motion.frequency == 26
    assert scenario.friction.static == pytest.approx(np.tan(np.radians(40)), rel=1e-12)
    assert scenario.friction.ratio == pytest.approx(0.4 / 0.75, rel=1e-12)


@pytest.mark.parametrize("method", ["sobol", "latin-hypercube"])
def test_a_sample_fills_its_box_and_is_the_same_for_a_seed(method):
    def points(seed: int) -> np.ndarray:
        ranges = {"motion.frequency": ["12 Hz", "30 Hz"], "motion.angle": ["2 deg", "12 deg"]}
        sample = {"count": 64, "method": method, "ranges": ranges}
        given = {k: v for k, v in PLAN.items() if k != "grid"}
        return np.array([list(p.values()) for p in base_points(Sweep(**given, seed=seed, sample=sample))])

    drawn = points(1)
    assert drawn.shape == (64, 2)
    assert ((drawn >= [12, np.radians(2)]) & (drawn <= [30, np.radians(12)])).all()
    # Space-filling: every eighth of either axis is visited.
    for column, low, high in zip(drawn.T, (12, np.radians(2)), (30, np.radians(12)), strict=True):
        assert set(np.floor(8 * (column - low) / (high - low)).clip(0, 7)) == set(range(8))
    np.testing.assert_array_equal(drawn, points(1))
    assert not np.array_equal(drawn, points(2))


def test_going_on_in_a_finished_store_changes_nothing(store, tmp_path):
    copy = tmp_path / "s.zarr"
    shutil.copytree(store, copy)
    stamps = {p: p.stat().st_mtime_ns for p in copy.rglob("*") if p.is_file() and p.name != ".lock"}
    assert sweep(PLAN, copy).complete
    assert stamps == {p: p.stat().st_mtime_ns for p in stamps}


def test_an_interrupted_campaign_goes_on_to_the_same_bits(store, tmp_path):
    class StopError(Exception):
        pass

    def stop(fraction: float) -> None:
        if fraction > 0.5:
            raise StopError

    path = tmp_path / "s.zarr"
    with pytest.raises(StopError):
        sweep(PLAN, path, progress=stop)
    assert 0 < open_sweep(path).done.sum() < 8
    assert sweep(PLAN, path).complete
    assert_same(path, store)


def test_a_store_of_something_else_is_refused_and_kept(store, tmp_path):
    copy = tmp_path / "s.zarr"
    shutil.copytree(store, copy)
    for other in ({**PLAN, "seed": 1}, {**PLAN, "engine": "cpu64"}, {**PLAN, "set": {"duration": "0.5 s"}}):
        with pytest.raises(InputError, match="store"):
            sweep(other, copy)
    root = copy / "zarr.json"
    data = json.loads(root.read_text())
    data["attributes"]["plategait_version"] = "0.0.0"
    data["attributes"]["fingerprint"] = fingerprint_of(data["attributes"])
    root.write_text(json.dumps(sealed(data)))
    with pytest.raises(InputError, match=r"plategait_version 0\.0\.0"):
        sweep(PLAN, copy)


@pytest.mark.parametrize("harm", ["flip a bit", "truncate", "remove"])
def test_damage_is_named_never_read_and_repaired_on_request(store, tmp_path, harm):
    copy = tmp_path / "s.zarr"
    shutil.copytree(store, copy)
    chunk = sorted(p for p in (copy / "spin_rate").iterdir() if p.name != "zarr.json")[1]
    content = bytearray(chunk.read_bytes())
    if harm == "flip a bit":
        content[len(content) // 2] ^= 1
        chunk.write_bytes(content)
    elif harm == "truncate":
        chunk.write_bytes(content[:5])
    else:
        chunk.unlink()
    for attempt in (lambda: sweep(PLAN, copy), lambda: open_sweep(copy)):
        with pytest.raises(InputError, match=r"3 points lost \(3–5"):
            attempt()
    partly = open_sweep(copy, damaged=True)
    assert partly.damaged == (3, 4, 5)
    assert partly.data.sizes["point"] == 5
    assert sweep(PLAN, copy, repair=True).complete
    assert_same(copy, store)


def test_two_writers_are_one_too_many(store, tmp_path):
    copy = tmp_path / "s.zarr"
    shutil.copytree(store, copy)
    with locked(copy), pytest.raises(InputError, match="no other process"):
        sweep(PLAN, copy)
    assert sweep(PLAN, copy).complete


def test_a_lost_root_is_no_excuse_to_start_anew(store, tmp_path):
    copy = tmp_path / "s.zarr"
    shutil.copytree(store, copy)
    (copy / "zarr.json").write_text("{")
    with pytest.raises(InputError, match=r"zarr\.json"):
        sweep(PLAN, copy)
    assert sweep(PLAN, copy, repair=True).complete
    assert_same(copy, store)


def test_trajectories_come_thinned_as_asked(tmp_path):
    record = {"channels": ["rotation", "centre_x"], "interval": "20 ms", "snapshots": "100 ms"}
    campaign = sweep({**PLAN, "record": record, "grid": {"motion.frequency": ["20 Hz"]}}, tmp_path / "t.zarr")
    data = campaign.data
    assert data["series_rotation"].sizes["time"] == 21
    assert np.diff(data["time"].values) == pytest.approx(0.02, rel=1e-9)
    assert data["position"].shape[-2:] == (52, 3)
    turned = data["series_rotation"].values[0, 0]
    # A run's last sample comes up to a sample interval before its end: what is asked for after it is not known.
    assert np.isfinite(turned[:-1]).all()
    assert turned[-2] > 0.1


@pytest.mark.slow
def test_refinement_goes_where_it_matters_and_resumes(tmp_path):
    plan = {**PLAN, "set": {"duration": "1 s"}, "grid": {"motion.frequency": "12:32:4 Hz"}}
    once = sweep(plan, tmp_path / "a.zarr", refine=8)
    added = once.data["motion.frequency"].values[once.n_base :]
    assert len(added) == 8
    coarse = set(np.arange(12.0, 33.0, 4.0))
    assert not coarse & set(added)
    # Around the peak and the failure edge, not along the idle start of the curve.
    assert (added > 16).mean() > 0.7
    sweep(plan, tmp_path / "b.zarr")
    sweep(plan, tmp_path / "b.zarr", refine=8)
    np.testing.assert_array_equal(
        open_sweep(tmp_path / "b.zarr").data["motion.frequency"].values, once.data["motion.frequency"].values
    )
    assert_same(tmp_path / "a.zarr", tmp_path / "b.zarr")


@pytest.mark.slow
def test_a_dask_cluster_gives_the_same_bits(store, tmp_path):
    distributed = pytest.importorskip("distributed")
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=False, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        assert sweep(PLAN, tmp_path / "d.zarr", dask=client).complete
    assert_same(tmp_path / "d.zarr", store)


@pytest.mark.slow
def test_a_lost_worker_costs_a_retry(store, tmp_path):
    distributed = pytest.importorskip("distributed")
    cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None)
    with cluster, distributed.Client(cluster) as client:
        killed = []

        def kill_one(fraction: float) -> None:
            workers = list(cluster.workers.values())  # none while one that was lost comes back
            if not killed and fraction > 0 and workers:
                killed.append(True)
                workers[0].process.process._process.kill()

        assert sweep(PLAN, tmp_path / "d.zarr", dask=client, progress=kill_one).complete
        assert killed
    assert_same(tmp_path / "d.zarr", store)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"grid": {}}, "grid"),
        ({"grid": {"sheet.colour": [1]}}, "sheet.colour"),
        ({"grid": {"motion.frequency": ["12 mm"]}}, "motion.frequency"),
        ({"repeats": 0}, "repeats"),
        ({"engine": "gpu"}, "engine"),
        ({"record": {"channels": ["colour"]}}, "channels"),
        ({"sample": {"count": 4, "method": "sobol", "ranges": {"gravity": [9, 10]}}}, "sample"),
    ],
)
def test_a_bad_plan_is_refused(changes, said, tmp_path):
    with pytest.raises(InputError) as caught:
        sweep({**PLAN, **changes}, tmp_path / "s.zarr")
    assert said in str(caught.value)
    assert not (tmp_path / "s.zarr").exists()
