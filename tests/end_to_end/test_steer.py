"""`plategait steer` as a user types it. Motions are found once, in few runs, and kept for all tests."""

from __future__ import annotations

import json
import math
from pathlib import Path

import av
import numpy as np
import pytest

from plategait.control import film, menu, menu_file
from plategait.lab.payload import named
from plategait.model.course import course_of, gone_over, kinematics
from plategait.model.motion import PlateMotion
from plategait.model.scenario import Scenario

QUICK = ("--generations", "0", "--menu", "menu.json", "--json")


@pytest.fixture(scope="module")
def kept(tmp_path_factory) -> Path:
    """A menu from two thirds of the motions that are usual, and no generations of them."""
    path = tmp_path_factory.mktemp("steer") / "menu.json"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(menu, "_FIRST", 128)
        menu_file.kept_menu(path, menu.on_a_plate("cheese"), generations=0)
    return path


@pytest.fixture
def folder(kept, tmp_path) -> Path:
    (tmp_path / "menu.json").write_bytes(kept.read_bytes())
    return tmp_path


def test_steer_says_of_each_goal_how_near_the_object_came(called, folder):
    done = called("steer", *QUICK, "--to", "0 mm, 4 mm", "--to", "0 mm, 30 mm, 90 deg", "--hold", "0.2 s",
                  "--timeout", "0.5 s", "--out", "way.csv", "--plot", "way.png", "--trajectory", "plate.csv",
                  cwd=folder, check=1)  # fmt: skip
    told = json.loads(done.stdout)
    first, second = told["goals"]
    assert (first["angle_deg"], first["error_deg"]) == (None, None)
    # 30 mm and a quarter of a turn within half a second is more than the plate can do.
    assert not second["reached"]
    assert second["status"] == "not within the time"
    assert (second["y_mm"], second["angle_deg"]) == pytest.approx((30, 90))
    way = np.genfromtxt(folder / "way.csv", delimiter=",", names=True)
    assert told["duration_s"] == pytest.approx(float(way["time_s"][-1]), abs=1e-5)
    off = math.hypot(way["x_mm"][-1] - 0, way["y_mm"][-1] - 30)
    assert second["error_mm"] == pytest.approx(off, abs=1e-3)
    assert (folder / "way.png").stat().st_size > 10_000
    plate = np.genfromtxt(folder / "plate.csv", delimiter=",", names=True)
    assert told["duration_s"] < plate["time_s"][-1] < told["duration_s"] + 0.2
    speeds = [name for name in plate.dtype.names or () if name.endswith(("_mm_s", "_deg_s"))]
    # It begins and ends at rest.
    assert all(abs(plate[name][[0, -1]]).max() < 1e-9 < abs(plate[name]).max() for name in speeds)


def test_a_goal_where_the_object_lies_is_held(called, folder, monkeypatch):
    monkeypatch.setattr(film, "SIZE", (320, 180))
    (folder / "goals.csv").write_text("x_mm,y_mm,angle_deg\n5,-5,\n")
    done = called("steer", *QUICK, "--goals", "goals.csv", "--from", "5 mm, -5 mm, 20 deg", "--hold", "0.3 s",
                  "--plate-size", "200 mm", "--film", "way.mp4", "--trajectory", "plate.csv",
                  cwd=folder, check=0)  # fmt: skip
    told = json.loads(done.stdout)
    assert told["reached"] is True
    (goal,) = told["goals"]
    assert (goal["reached"], goal["time_s"], goal["pulses"]) == (True, 0.0, 0)
    assert told["start"] == pytest.approx({"x_mm": 5, "y_mm": -5, "angle_deg": 20}, abs=1e-6)
    with av.open(str(folder / "way.mp4")) as clip:
        # A frame for every other of the 60 ticks in a second.
        assert sum(1 for _ in clip.decode(video=0)) == pytest.approx(30 * told["duration_s"], abs=1)
    # The plate never moved, on neither of the axes that the machine has.
    plate = np.genfromtxt(folder / "plate.csv", delimiter=",", names=True)
    assert not plate["x_mm"].any()
    assert not plate["rx_deg"].any()


def test_the_camera_may_be_pixels_that_a_tracker_reads(called, folder):
    done = called("steer", *QUICK, "--to", "5 mm, -5 mm", "--from", "5 mm, -5 mm, 20 deg", "--hold", "0.3 s",
                  "--through-pixels", "--camera-rate", "20 Hz", "--out", "way.csv", cwd=folder, check=0)  # fmt: skip
    told = json.loads(done.stdout)
    assert (told["through_pixels"], told["camera"]["rate_hz"]) == (True, 20)
    way = np.genfromtxt(folder / "way.csv", delimiter=",", names=True)
    # A pixel is half a millimetre: what is seen is near to the truth, and never the truth.
    off = np.hypot(way["seen_x_mm"] - way["x_mm"], way["seen_y_mm"] - way["y_mm"])
    assert 1e-6 < off.min() <= off.max() < 0.8


def test_a_path_is_followed_as_far_as_the_time_allows(called, folder):
    done = called("steer", *QUICK, "--path", "figure-of-eight", "--timeout", "1.5 s", "--plot", "way.png",
                  "--out", "way.json", "--trajectory", "plate.csv", cwd=folder, check=1)  # fmt: skip
    path = json.loads(done.stdout)["path"]
    # By hand: 3.05 heights for one that is half as wide as it is high.
    assert path["length_mm"] == pytest.approx(122, abs=1)
    assert path["status"] == "not within the time"
    assert 0 < path["coverage"] < 0.9
    assert path["rms_mm"] <= path["greatest_mm"]
    the_plate_did_what_the_file_tells(folder)


def the_plate_did_what_the_file_tells(folder: Path) -> None:
    """What way.json says that the plate was told moves it as plate.csv says that it moved."""
    shown = named(str(folder / "way.json"))
    assert shown.own_scenario
    way = shown.payload()
    course = course_of(Scenario(**way["scenario"]).motion)
    motions = [PlateMotion(**motion) for motion in way["motions"]]
    plate = np.genfromtxt(folder / "plate.csv", delimiter=",", names=True)
    assert len(way["told"]) > 5
    for change, following in zip(way["told"], [*way["told"][1:], {"time": way["ticks"]["time"][-1]}], strict=True):
        course = gone_over(course, motions[change["motion"]], change["time"], change["within"])
        now = (plate["time_s"] >= change["time"]) & (plate["time_s"] < following["time"])
        position = kinematics(course, plate["time_s"][now]).position
        # As many digits as the table has.
        np.testing.assert_allclose(1e3 * position[0], plate["x_mm"][now], atol=1e-5)
        np.testing.assert_allclose(np.degrees(position[3]), plate["rx_deg"][now], atol=1e-5)
    assert len(way["path"]) > 50
    assert way["ticks"]["x"][0] == 0


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        (("--path", "TUM", "--height", "80 mm"), "so that the object stays on its plate; try one 51.5 % as large"),
        (("--path", "café"), "a word of A to Z"),
        (("--path", "L", "--within", "3 mm, 5 deg"), "a distance alone, along a path"),
        (("--path", "L", "--to", "0 mm, 0 mm"), "--to: got"),
        ((), "--to: got nothing, must be a pose"),
        (("--to", "90 mm, 0 mm"), "within 55 mm along the bar and 55 mm across it"),
        (("--to", "1 mm, 2 mm, 3 mm"), "--to: got '3 mm'"),
        (("--to", "0 mm, 0 mm", "--from", "0 mm, 99 mm"), "--from: got '(0, 99) mm'"),
        (("--to", "0 mm, 0 mm", "--method", "magic"), "one of blend, mppi, open-loop, one-pulse"),
        (("--to", "0 mm, 0 mm", "--camera-rate", "0 Hz"), "--camera-rate: got '0 Hz'"),
        (("--to", "0 mm, 0 mm", "--missed", "100%"), "--missed: got '100'"),
        (("--to", "0 mm, 0 mm", "--dark", "2:1 s"), "--dark: got"),
        (("--to", "0 mm, 0 mm", "--through-pixels", "--missed", "1%"), "--missed: got '1%', must be left out with"),
        (("--to", "0 mm, 0 mm", "--hold", "40 s"), '--timeout "70 s"'),
        (("--to", "0 mm, 0 mm", "--plate-size", "80 mm"), "--plate-size"),
        (("--to", "0 mm, 0 mm", "--menu", "menu.json", "--seed", "9"), "menu.json, whose seed differ"),
        (("--to", "0 mm, 0 mm", "--menu", "goals.csv"), "a menu that plategait steer --menu wrote"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused_with_what_to_type(typed, said, called, folder):
    (folder / "goals.csv").write_text("x_mm,y_mm\n1,2\n")
    done = called("steer", "cheese", "--generations", "0", *typed, cwd=folder, check=2)
    assert said in done.stderr
    assert done.stderr.count("\n") == 1


def test_a_menu_is_kept_as_it_was_found(kept):
    again = menu_file.kept_menu(kept, menu.on_a_plate("cheese"), generations=0)
    told = json.loads(kept.read_text())
    assert len(again) == len(told["motions"])
    assert again.motions[0].terms() == ()
    np.testing.assert_array_equal(again.response.rates, told["response"]["rates"])
    assert again.response.failed.dtype == bool
