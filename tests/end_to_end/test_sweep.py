"""Campaigns from the command line: killed, resumed, refused, drawn."""

from __future__ import annotations

import json
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
import xarray

import plategait as pg

COMMAND = str(Path(sys.executable).with_name("plategait"))

PLAN = """
name = "kill me"
scenario = "cheese"
repeats = 2
batch = 2

[set]
duration = "1.5 s"

[grid]
motion.frequency = "12:30:1 Hz"
motion.angle = ["3 deg", "6 deg"]
"""


def command(*arguments: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([COMMAND, *arguments], cwd=cwd, capture_output=True, text=True, timeout=300, check=False)


def contents(store: Path) -> dict[str, np.ndarray]:
    """Every array of a store."""
    with xarray.open_zarr(store, chunks=None) as data:
        return {str(name): values.values for name, values in data.variables.items()}


def assert_same(one: Path, two: Path) -> None:
    a, b = contents(one), contents(two)
    assert set(a) == set(b)
    for name, values in a.items():
        assert values.dtype == b[name].dtype
        np.testing.assert_array_equal(values, b[name], err_msg=name)


@pytest.fixture(scope="module")
def whole(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("whole")
    (folder / "s.toml").write_text(PLAN)
    done = command("sweep", "s.toml", "--json", cwd=folder)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["complete"]
    return folder / "s.zarr"


def test_a_campaign_killed_eight_times_ends_with_the_same_bits(whole, tmp_path):
    (tmp_path / "s.toml").write_text(PLAN)
    wait = random.Random(11)
    kills = 0
    for _ in range(8):
        running = subprocess.Popen(
            [COMMAND, "sweep", "s.toml"], cwd=tmp_path, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        # Commands take half a second to start: the kills fall from before the first batch to well into the work.
        time.sleep(wait.uniform(0.3, 1.2))
        kills += running.poll() is None
        running.send_signal(signal.SIGKILL)
        running.wait()
    assert kills >= 4, "most were killed while they ran"
    assert command("sweep", "s.toml", cwd=tmp_path).returncode == 0
    assert_same(tmp_path / "s.zarr", whole)


def test_a_store_opens_with_one_line(whole):
    data = xarray.open_zarr(whole)
    assert data.sizes["point"] == 38
    assert data.sizes["repeat"] == 2
    assert data["spin_rate"].attrs["units"] == "rad/s"
    assert data["motion.angle"].values.max() == pytest.approx(np.radians(6), rel=1e-12)
    # And holds what the same runs give on their own.
    grid = pg.open_sweep(whole).as_grid()
    scenario = pg.preset("cheese").scenario.replace(
        **{"duration": "1.5 s", "motion.frequency": 20.0, "motion.angle": "3 deg"}
    )
    alone = pg.simulate(scenario).spin_rate
    here = grid["spin_rate"].sel({"motion.frequency": 20.0}).isel({"motion.angle": 0, "repeat": 0})
    assert float(here) == alone


def test_status_and_plot(called, whole, tmp_path):
    status = called("sweep", "--status", str(whole), "--json", cwd=tmp_path, check=0)
    assert json.loads(status.stdout)["points_done"] == 38
    called("plot", str(whole), "--out", "map.png", cwd=tmp_path, check=0)
    assert (tmp_path / "map.png").stat().st_size > 10_000


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("motion.frequency", "motion.frequenzy", "motion.frequency"),
        ('"12:30:1 Hz"', '"12:30:1 mm"', "Hz"),
        ('"12:30:1 Hz"', "[]", "motion.frequency"),
        ('"cheese"', '"chese"', "scenario"),
        ("repeats = 2", "repeats = 0", "repeats"),
        ("[grid]", "[gird]", "grid"),
    ],
)
def test_a_bad_plan_is_one_line(called, tmp_path, old, new, said):
    (tmp_path / "s.toml").write_text(PLAN.replace(old, new))
    done = called("sweep", "s.toml", cwd=tmp_path, check=2)
    assert len(done.stderr.strip().splitlines()) == 1, done.stderr
    assert said in done.stderr
    assert not (tmp_path / "s.zarr").exists()


def test_a_store_that_is_a_file_is_refused_and_kept(tmp_path):
    (tmp_path / "s.toml").write_text(PLAN)
    (tmp_path / "s.zarr").write_text("precious")
    done = command("sweep", "s.toml", cwd=tmp_path)
    assert done.returncode == 2
    assert (tmp_path / "s.zarr").read_text() == "precious"
