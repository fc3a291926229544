"""An observable of somebody else's package: one file, and it is in table, JSON, CSV, data file, store and picture."""

import csv
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
import xarray

OURS = '''
"""How far the sheet's highest node rises."""

from plategait import Observable


def rise(window):
    height = window.channels["height_high"][window.inside]
    return float(height.max()) if len(height) else float("nan")


observable = Observable("rise", "m", "highest node over the plate", rise, label="highest rise", display="mm")
'''
PLAN = """
scenario = "cheese"
set.duration = "0.5 s"
grid."motion.frequency" = ["14 Hz", "18 Hz"]
"""


@pytest.fixture(scope="module")
def installed(tmp_path_factory) -> dict[str, str]:
    """Environment in which a package with an entry point is installed, as pip would do it."""
    folder = tmp_path_factory.mktemp("site")
    (folder / "rises.py").write_text(OURS)
    about = folder / "rises-1.0.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: rises\nVersion: 1.0\n")
    (about / "entry_points.txt").write_text("[plategait.observables]\nrise = rises:observable\n")
    return os.environ | {"PYTHONPATH": str(folder)}


def plategait(environment: dict[str, str], folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "plategait", *arguments]
    return subprocess.run(command, env=environment, cwd=folder, capture_output=True, text=True, check=False)


def test_an_observable_of_another_package_is_everywhere(installed, tmp_path):
    one = ("simulate", "cheese", "--frequency", "14 Hz", "--duration", "0.5 s", "--out", "run.nc")
    table = plategait(installed, tmp_path, *one)
    assert "highest rise" in table.stdout, table.stderr
    numbers = json.loads(plategait(installed, tmp_path, *one, "--json").stdout)
    assert 0 < numbers["rise_mm"] < 50
    with xarray.open_dataset(tmp_path / "run.nc") as data:
        assert 1e3 * float(data["rise"][0]) == pytest.approx(numbers["rise_mm"])
        assert data["rise"].attrs == {"long_name": "highest node over the plate", "units": "m"}

    plategait(installed, tmp_path, "curve", "cheese", "--frequency", "14 Hz, 18 Hz", "--duration", "0.5 s",
              "--out", "curve.csv")  # fmt: skip
    with open(tmp_path / "curve.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert float(rows[0]["rise_mm"]) == pytest.approx(numbers["rise_mm"])

    (tmp_path / "plan.toml").write_text(PLAN)
    done = plategait(installed, tmp_path, "sweep", "plan.toml")
    assert done.returncode == 0, done.stderr
    drawn = plategait(installed, tmp_path, "plot", "plan.zarr", "--show", "rise", "--out", "rise.svg")
    assert drawn.returncode == 0, drawn.stderr
    assert (tmp_path / "rise.svg").stat().st_size > 1000


def test_without_the_package_a_store_is_read_and_drawn_and_not_mixed_with_others(installed, tmp_path):
    (tmp_path / "plan.toml").write_text(PLAN)
    assert plategait(installed, tmp_path, "sweep", "plan.toml").returncode == 0
    plain = dict(os.environ)
    assert plategait(plain, tmp_path, "plot", "plan.zarr", "--show", "rise", "--out", "rise.png").returncode == 0
    other = plategait(plain, tmp_path, "sweep", "plan.toml")
    assert other.returncode == 2
    assert "observables" in other.stderr


def test_a_plug_in_that_is_none_is_named(tmp_path):
    (tmp_path / "wrong.py").write_text("observable = 3\n")
    about = tmp_path / "wrong-1.0.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: wrong\nVersion: 1.0\n")
    (about / "entry_points.txt").write_text("[plategait.observables]\nwrong = wrong:observable\n")
    environment = os.environ | {"PYTHONPATH": str(tmp_path)}
    refused = plategait(environment, tmp_path, "simulate", "cheese", "--duration", "0.5 s")
    assert refused.returncode == 2
    assert refused.stderr.startswith("plategait: plategait.observables wrong: got 'wrong:observable'")
