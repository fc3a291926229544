"""`plategait lab` for each kind of input: what the page is given, told from the very files that commands write."""

from __future__ import annotations

import base64
import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from plategait.lab import page as lab_page
from plategait.lab.page import LARGEST_PAGE, PLACES, SHIPPED
from plategait.lab.payload import named
from plategait.lab.scenario_json import MOST_PIXELS, MOST_SAMPLES, plain_scenario
from plategait.model.fragment import read_fragment
from plategait.model.lattice import Lattice
from plategait.model.parameters import with_values
from plategait.model.presets import preset
from plategait.model.scenario import Scenario
from plategait.model.scenario_file import write_scenario

CHEESE = preset("cheese").scenario.replace(duration=0.6, transient=0.2)
HOSTILE = "</script><img src=x onerror=alert(1)><!--"
OBJECT = (
    '# of a slice\n[sheet]\nmass = "13 g"\n[friction]\nstatic = 0.6\n[uncertainty]\nconfidence = 0.9\n'
    '[uncertainty.sd]\n"sheet.mass" = "1 g"\n"friction.static" = 0.05\n'
    '[uncertainty.interval]\n"sheet.mass" = ["11 g", "15 g"]\n'
)
POSES = "time_s,x_mm,y_mm,angle_deg,sure,reason\n0,0,1,10,1,\n0.1,2,1,20,1,\n0.2,,,,0,no object\n0.3,3,1,40,0,unsure\n"
STEERING = (
    "time_s,x_mm,y_mm,angle_deg,seen_x_mm,seen_y_mm,seen_angle_deg,goal_x_mm,goal_y_mm,goal_angle_deg\n"
    "0,0,0,0,,,,10,5,90\n0.1,1,0,5,1,0,4,10,5,90\n0.2,1,0,5,1,0,4,0,5,\n0.3,1,0,5,1,0,4,0,5,\n"
)


@pytest.fixture(autouse=True)
def _stub(tmp_path_factory, monkeypatch):
    """What stands in for what is shipped."""
    folder = tmp_path_factory.mktemp("shipped")
    for name in SHIPPED:
        (folder / name).write_text("".join(PLACES) if name == "page.html" else "x")
    monkeypatch.setattr(lab_page, "shipped_folder", lambda: folder)


@pytest.fixture(scope="module")
def files(tmp_path_factory) -> Path:
    """A file of each kind, from the commands that write them where those are quick."""
    from plategait.campaign.run import sweep
    from plategait.simulation.dataset import write_dataset
    from plategait.simulation.run import simulate

    folder = tmp_path_factory.mktemp("files")
    write_dataset(simulate(CHEESE, repeats=2, snapshot_interval=0.02), folder / "run.nc")
    plan = 'scenario = "cheese"\n[set]\nduration = "0.3 s"\n[grid]\n"motion.frequency" = ["20 Hz", "24 Hz"]\n'
    (folder / "plan.toml").write_text(plan + 'natural_frequency = ["8 pi rad/s", "12 pi rad/s"]\n')
    sweep(folder / "plan.toml", folder / "store.zarr")
    (folder / "object.toml").write_text(OBJECT)
    (folder / "poses.csv").write_text(POSES)
    (folder / "way.csv").write_text(STEERING)
    (folder / "scenario.toml").write_text(write_scenario(CHEESE.replace(name=HOSTILE)))
    return folder


@pytest.fixture
def made(files, tmp_path, called):
    """What a command line gives the page."""

    def run(*arguments: str) -> dict:
        out = tmp_path / "page.html"
        done = called("lab", *arguments, "--no-open", "--out", str(out), cwd=files, check=0)
        assert re.fullmatch(rf"{out}: \w+ .*, \d\.\d\d MB\n", done.stdout)
        html = out.read_text(encoding="utf-8")
        assert len(html.encode()) < LARGEST_PAGE
        return json.loads(re.search(r'id="payload">(.*?)</script>', html)[1])  # type: ignore[index]

    return run


def set_in(scenario: dict, values: dict) -> Scenario:
    """Scenario with numbers set by dotted names, as the page sets them."""
    told = json.loads(json.dumps(scenario))
    for name, value in values.items():
        part = told
        *path, last = name.split(".")
        for step in path:
            part = part[int(step)] if isinstance(part, list) else part[step]
        part[last] = value
    return Scenario(**told)


def test_a_preset_comes_as_it_is(made):
    told = made("cheese")
    assert (told["kind"], told["name"], told["notes"]) == ("scenario", "cheese", [])
    assert Scenario(**told["scenario"]) == preset("cheese").scenario


def test_options_are_laid_over_a_scenario(made):
    told = made("scenario.toml", "--frequency", "20 Hz", "--angle", "5 deg", "--sheet", "pancake", "--mu-s", "0.6")
    assert told["name"] == HOSTILE
    scenario = Scenario(**told["scenario"])
    assert scenario.motion.frequency == 20
    assert scenario.sheet == preset("pancake").scenario.sheet
    assert scenario.friction.static == 0.6


def test_a_run_comes_with_its_series_and_shapes(made, files):
    import xarray

    told = made("run.nc")
    assert told["kind"] == "run"
    assert Scenario(**told["scenario"]) == CHEESE
    with xarray.open_dataset(files / "run.nc", decode_times=False) as data:
        run = data.isel(run=0).load()
    assert told["time"] == pytest.approx(run["time"].values, rel=1e-5)
    assert told["channels"]["centre_x"] == pytest.approx(run["centre_x"].values, rel=1e-5, abs=1e-12)
    shapes = np.frombuffer(base64.b64decode(told["snapshots"]), "<f4").reshape(len(told["snapshot_time"]), -1, 3)
    assert np.array_equal(shapes, run["position"].values.astype("f4"))
    assert np.allclose(told["plate_pose"], run["plate_pose"].values, rtol=1e-5, atol=1e-12)
    assert told["gait"] == str(run["gait"].values)
    assert told["notes"] == ["the first of 2 runs is shown"]


def test_a_long_run_is_thinned_and_says_so(tmp_path, files):
    from plategait.simulation.dataset import write_dataset
    from plategait.simulation.run import simulate

    long = simulate(CHEESE.replace(duration=8.0), snapshot_interval=0.002)
    write_dataset(long, tmp_path / "long.nc")
    told = named(str(tmp_path / "long.nc")).payload()
    recording = long.recordings[0]
    assert len(json.dumps(told)) < 0.5 * LARGEST_PAGE
    assert [re.sub(r"\d+", "n", note) for note in told["notes"]] == [
        "of the series one sample in n is shown", "of the shapes n of n are shown",
    ]  # fmt: skip
    step = int(re.search(r"in (\d+)", told["notes"][0])[1])  # type: ignore[index]
    channels = told["channels"]
    assert channels["centre_x"] == pytest.approx(recording["centre_x"][::step], rel=1e-5, abs=1e-12)
    # What was lost and how long was flown until a time are the same whatever is left out.
    last = step * (len(told["time"]) - 1)
    assert sum(channels["friction_loss"]) == pytest.approx(recording["friction_loss"][: last + 1].sum(), rel=1e-4)
    flown = recording["flight"][1 : last + 1].mean()
    assert np.mean(channels["flight"][1:]) == pytest.approx(flown, rel=1e-4)
    assert told["snapshot_time"][-1] == pytest.approx(8.0, abs=0.1)


def test_a_store_comes_with_what_to_set_at_each_point(made, files):
    from plategait.campaign.opened import open_sweep

    told, store = made("store.zarr"), open_sweep(files / "store.zarr")
    assert [p["name"] for p in told["parameters"]] == ["motion.frequency", "natural_frequency"]
    assert told["parameters"][0]["values"] == [20, 24]
    assert len(told["points"]) == 4
    assert told["grid"]
    for point, at, rate in zip(told["points"], store.points, store.outcomes.rate, strict=True):
        assert point["at"] == list(at.values())
        assert set_in(told["scenario"], point["set"]) == store.plan.at(at)
        assert point["spin_rate"] == (pytest.approx(rate, rel=1e-5) if np.isfinite(rate) else None)
    assert {"drift", "rim_lift"} <= set(told["points"][0]["values"])


def test_a_large_grid_is_shown_coarser(files, tmp_path, monkeypatch):
    from plategait.lab import store_payload

    monkeypatch.setattr(store_payload, "MOST_POINTS", 3)
    told = named(str(files / "store.zarr")).payload()
    assert len(told["points"]) == 2
    assert told["notes"] == ["2 of the store's 4 points are shown"]


def test_an_object_comes_as_a_cloud_that_is_the_same_each_time(made, files):
    told = made("object.toml", "--angle", "5 deg")
    assert told == made("object.toml", "--angle", "5 deg")
    base = preset("cheese").scenario.replace(**{"motion.angle": "5 deg"})
    fragment = read_fragment(files / "object.toml")
    assert Scenario(**told["scenario"]) == fragment.apply(base)
    assert told["source"] == "of a slice"
    mass = {"value": 0.013, "sd": 0.001, "low": 0.011, "high": 0.015}
    assert {name: told["parameters"][0][name] for name in mass} == pytest.approx(mass, rel=1e-12)
    sheets = [set_in(told["scenario"], sample["set"]) for sample in told["samples"]]
    assert len(sheets) == 24
    masses = np.array([sheet.sheet.mass for sheet in sheets])
    # Of 24 draws, the spread is within a half with a chance of 1 in 10^3; the seed is fixed.
    assert masses.std() == pytest.approx(0.001, rel=0.5)
    assert masses.mean() == pytest.approx(0.013, abs=4 * 0.001 / 24**0.5)
    drawn = fragment.draw(base, np.random.default_rng(0))
    assert sheets[0] == drawn


def test_an_object_without_uncertainty_has_no_cloud(made, files):
    (files / "exact.toml").write_text('[sheet]\nmass = "12 g"\n')
    told = made("exact.toml")
    assert told["samples"] == []
    assert "no uncertainty" in told["notes"][0]


def test_poses_come_in_si_with_gaps(made):
    told = made("poses.csv", "--scenario", "pancake", "--with", "object.toml")
    assert told["time"] == [0, 0.1, 0.2, 0.3]
    assert told["x"] == [0, 0.002, None, 0.003]
    assert told["angle"][1] == pytest.approx(np.radians(20), rel=1e-5)
    assert told["sure"] == [True, True, False, False]
    scenario = Scenario(**told["scenario"])
    assert scenario.sheet.mass == pytest.approx(0.013, rel=1e-12)
    assert scenario.sheet.outline == preset("pancake").scenario.sheet.outline


def test_poses_of_the_tracker_are_read(tmp_path):
    """As `plategait track --out` writes them."""
    from plategait.render.clip.clip import film, usual_camera
    from plategait.simulation.run import simulate
    from plategait.vision.preview import write_poses
    from plategait.vision.track import track

    run = simulate(CHEESE, snapshot_interval=CHEESE.motion.period / 24)
    film(run, tmp_path / "clip.mp4", usual_camera(CHEESE, 480, 270), 30.0, seconds=0.35)
    seen = track(tmp_path / "clip.mp4")
    write_poses(seen, tmp_path / "poses.csv")
    told = named(str(tmp_path / "poses.csv")).payload(CHEESE)
    assert told["kind"] == "poses"
    assert told["sure"] == seen.sure.tolist()
    known = np.isfinite(seen.angle)
    assert np.array(told["angle"], dtype=float)[known] == pytest.approx(seen.angle[known], rel=1e-5)
    assert np.array(told["x"], dtype=float)[known] == pytest.approx(seen.x[known], rel=1e-4, abs=1e-9)


def test_a_steering_comes_with_its_goals(made):
    told = made("way.csv")
    assert told["goals"] == [
        {"x": 0.01, "y": 0.005, "angle": pytest.approx(np.pi / 2, rel=1e-5), "from": 0.0},
        {"x": 0.0, "y": 0.005, "angle": None, "from": 0.2},
    ]
    assert told["ticks"]["x"] == [0, 0.001, 0.001, 0.001]
    assert told["ticks"]["seen_x"] == [None, 0.001, 0.001, 0.001]


WAY = {
    "format": "steering", "scenario": write_scenario(CHEESE), "goals": [], "path": None,
    "motions": [{"angle": 0.1, "samples": None}], "told": [{"time": 0.1, "motion": 0, "within": 0.05}],
    "ticks": {name: [0.0, 0.1] for name in ("time", "x", "y", "angle", "goal_x", "goal_y", "goal_angle")},
}  # fmt: skip


def test_a_whole_steering_comes_with_what_the_plate_was_told(made, files):
    (files / "way.json").write_text(json.dumps(WAY))
    told = made("way.json")
    assert Scenario(**told["scenario"]) == CHEESE
    assert told["told"] == WAY["told"]
    assert told["motions"][0]["angle"] == 0.1
    assert told["motions"][0]["frequency"] == 24


@pytest.mark.parametrize(
    "damage",
    [
        {"format": "menu"}, {"scenario": "["}, {"scenario": "name = 3"}, {"motions": [{}]}, {"motions": 3},
        {"motions": [{"samples": "/etc/passwd"}]}, {"told": [{"time": 0, "motion": 1, "within": 1}]},
        {"told": [{"time": 0, "motion": 0, "within": 0}]}, {"told": [{"time": "x", "motion": 0, "within": 1}]},
        {"ticks": {}}, {"ticks": {"time": [0.0]}}, {"ticks": WAY["ticks"] | {"x": [1.0]}}, {"path": [[1]]},
        {"scenario": WAY["scenario"].replace("[motion]", '[motion]\nsamples = "/etc/passwd"')},
    ],
    ids=str,
)  # fmt: skip
def test_a_damaged_steering_is_refused(damage, tmp_path, called):
    (tmp_path / "way.json").write_text(json.dumps(WAY | damage))
    done = called("lab", "way.json", "--no-open", cwd=tmp_path, check=2)
    assert len(done.stderr.splitlines()) == 1
    assert not (tmp_path / "lab.html").exists()


def test_kinds_are_told_by_what_is_in_files_and_not_by_names(files, tmp_path, called):
    (tmp_path / "scenario").write_bytes((files / "run.nc").read_bytes())
    (tmp_path / "table.txt").write_text(STEERING.replace(",", ";"))
    (tmp_path / "cheese.toml").write_text(OBJECT)
    for name, kind in (("scenario", "run"), ("table.txt", "steering"), ("cheese.toml", "object")):
        told = called("lab", name, "--no-open", cwd=tmp_path, check=0).stdout
        assert told.startswith(f"lab.html: {kind} {name}, ")


def test_a_picture_becomes_rows_of_the_same_sheet(tmp_path):
    from PIL import Image

    side = int(2 * MOST_PIXELS**0.5)
    y, x = np.mgrid[:side, :side] - side / 2
    leaf = (np.hypot(x / 0.9, y / 0.5) < side / 2.2) & ~(np.hypot(x - side / 5, y) < side / 30)
    Image.fromarray(np.where(leaf, 0, 255).astype("u1")).save(tmp_path / "leaf.png")
    mask = {"shape": "mask", "width_of_picture": "90 mm", "image": str(tmp_path / "leaf.png")}
    scenario = preset("cheese").scenario.replace(**{"sheet.outline": mask, "sheet.pitch": "5 mm"})
    plain, notes = plain_scenario(scenario)
    text = json.dumps(plain)
    assert "leaf" not in text
    assert str(tmp_path) not in text
    assert len(text) < 1.2 * MOST_PIXELS
    assert "the picture is shown in" in notes[0]
    told, own = Scenario(**plain).sheet.lattice, scenario.sheet.lattice
    assert isinstance(told, Lattice)
    assert np.array_equal(told.occupied, own.occupied)


def test_a_long_trajectory_is_thinned_and_says_so():
    time = tuple(np.arange(3 * MOST_SAMPLES) * 1e-3)
    samples = {"time": time, "x": tuple(1e-3 * np.sin(np.array(time)))}
    scenario = with_values(preset("cheese").scenario, {"motion.samples": samples})
    plain, notes = plain_scenario(scenario)
    assert len(plain["motion"]["samples"]["time"]) <= MOST_SAMPLES + 1
    assert plain["motion"]["samples"]["time"][-1] == time[-1]
    assert notes == [f"of the plate's trajectory one sample in 3 is shown, of {len(time)}"]
    Scenario(**plain)


REFUSED = [
    (("nofile",), "WHAT: got 'nofile' … try cheese"),
    (("nofile.nc",), "nofile.nc (no such file)"),
    (("nofile.zarr",), "nofile.zarr"),
    (("bad.nc",), "bad.nc … a run that plategait wrote"),
    (("half.nc",), "half.nc … a run that plategait wrote"),
    (("other.nc",), "other.nc, a data file of another kind"),
    (("peak.csv",), "peak.csv, a file of another kind … a steering (.csv, .json)"),
    (("page.html",), "page.html, a file of another kind"),
    (("empty",), "empty, a file of another kind"),
    (("plan.toml",), "scenario … a table of parameters"),
    (("bad.csv",), "bad.csv line 3, x_mm … 'here' … a number"),
    (("late.csv",), "late.csv line 3, time … above that of the row before it"),
    (("/dev/zero",), "/dev/zero (a device)"),
    (("wrong.toml",), "sheet.mas … sheet.mass"),
    (("x" * 5000,), "WHAT … try cheese"),
    (("cheese", "--scenario", "pancake"), "--scenario … left out … plategait lab pancake"),
    (("run.nc", "--angle", "3 deg"), "--angle … left out for a run … try plategait lab run.nc"),
    (("store.zarr", "--scenario", "cheese"), "--scenario … left out for a store"),
    (("object.toml", "--scenario", "nofile"), "nofile … try cheese"),
    (("cheese", "--angle", "3"), '--angle … try "3 deg"'),
    (("cheese", "--out", "lab.htm"), "--out … ending in .html … lab.html"),
    (("cheese", "--out", "nofolder/lab.html"), "--out … a folder that exists"),
]


@pytest.mark.parametrize(("arguments", "said"), REFUSED, ids=lambda a: " ".join(a)[:40] if isinstance(a, tuple) else "")
def test_what_cannot_be_shown_is_refused_in_a_line_and_nothing_is_written(files, tmp_path, called, arguments, said):
    import h5netcdf

    for file in files.iterdir():
        (tmp_path / file.name).symlink_to(file)
    (tmp_path / "bad.nc").write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(100))
    (tmp_path / "half.nc").write_bytes((files / "run.nc").read_bytes()[:20000])
    with h5netcdf.File(tmp_path / "other.nc", "w") as other:
        other.dimensions = {"x": 3}
    (tmp_path / "peak.csv").write_text("frequency_hz,spin_rate_deg_s\n14,90\n")
    (tmp_path / "page.html").write_text("<html></html>")
    (tmp_path / "empty").write_text("")
    (tmp_path / "bad.csv").write_text("time_s,x_mm,y_mm,angle_deg\n0,1,1,1\n1,here,1,1\n")
    (tmp_path / "late.csv").write_text("time_s,x_mm,y_mm,angle_deg\n1,1,1,1\n1,2,1,1\n")
    (tmp_path / "wrong.toml").write_text('[sheet]\nmas = "3 g"\n')
    before = set(tmp_path.iterdir())
    done = called("lab", *arguments, "--no-open", cwd=tmp_path, check=2)
    assert re.search(".*".join(map(re.escape, said.split(" … "))), done.stderr), done.stderr
    assert len(done.stderr.splitlines()) == 1
    assert set(tmp_path.iterdir()) == before


def test_a_page_that_is_there_stays_where_a_new_one_cannot_be_made(files, tmp_path, called):
    (tmp_path / "lab.html").write_text("mine")
    called("lab", "nofile", cwd=tmp_path, check=2)
    assert (tmp_path / "lab.html").read_text() == "mine"


def test_the_page_is_opened_as_a_file_unless_told_otherwise(tmp_path, called, monkeypatch):
    import webbrowser

    opened: list[str] = []
    monkeypatch.setattr(webbrowser, "open", lambda url: opened.append(url) or True)
    called("lab", "--no-open", cwd=tmp_path, check=0)
    assert opened == []
    called("lab", cwd=tmp_path, check=0)
    assert opened == [(tmp_path / "lab.html").as_uri()]
    monkeypatch.setattr(webbrowser, "open", lambda url: False)
    assert "no browser to open it in" in called("lab", cwd=tmp_path, check=0).stdout


def test_the_installed_command_writes_the_shipped_page(tmp_path):
    from importlib.resources import files as resources

    if not (resources("plategait.lab") / "shipped" / "built_from.json").is_file():
        pytest.skip("the page is not built here: make lab")
    command = [str(Path(sys.executable).with_name("plategait")), "lab", "pancake", "--no-open"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout.startswith("lab.html: scenario pancake, ")
    assert (tmp_path / "lab.html").stat().st_size < LARGEST_PAGE
