"""The commands as a user types them; what only a process of its own can show is run as the installed command."""

from __future__ import annotations

import json
import math
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from plategait.cli import main
from plategait.curve.curve_file import COLUMNS, read_curve
from plategait.model.presets import PRESETS, preset
from plategait.model.scenario_file import read_scenario, write_scenario
from plategait.simulation.run import simulate

COMMAND = str(Path(sys.executable).with_name("plategait"))
SHORT = ("--duration", "0.2 s")


def plategait(*arguments: str, cwd: Path, check: int | None = None, **options) -> subprocess.CompletedProcess[str]:
    done = subprocess.run(
        [COMMAND, *arguments], cwd=cwd, capture_output=True, text=True, timeout=60, check=False, **options
    )
    assert "Traceback" not in done.stderr
    if check is not None:
        assert done.returncode == check, done.stderr
    return done


def plain_json(text: str):
    def refuse(constant: str):
        raise AssertionError(f"{constant} is no JSON")

    return json.loads(text, parse_constant=refuse)


def write_peak(path: Path, *, spoil: bool = False) -> None:
    frequency = np.arange(14.0, 29.0)
    rate = 300 / (1 + ((frequency - 21) / 3) ** 2)
    lines = [f"{f:g},{r:.6g},," for f, r in zip(frequency, rate, strict=True)]
    if spoil:
        lines.append("30,-900,,slipped")
    path.write_text("\n".join(["frequency_hz,spin_rate_deg_s,gait,failure", *lines]) + "\n")


# What works


def test_simulate_prints_a_table(tmp_path):
    done = plategait("simulate", "cheese", *SHORT, cwd=tmp_path, check=0)
    assert done.stderr == ""
    for word in ("spin rate", "gait", "failure", "drift", "time step", "24 Hz, 3 deg, 3 mm"):
        assert word in done.stdout
    assert list(tmp_path.iterdir()) == []


def test_simulate_prints_json_and_writes_a_file(called, tmp_path):
    done = called(
        "simulate", "pancake", *SHORT, "--repeats", "2", "--seed", "5", "--engine", "cpu64", "--json",
        "--out", "run.nc", cwd=tmp_path, check=0,
    )  # fmt: skip
    assert done.stderr == ""
    summary = plain_json(done.stdout)
    assert (summary["runs"], summary["seed"], summary["engine"], summary["failed"]) == (2, 5, "cpu64", False)
    assert summary["frequency_hz"] == 7
    assert [p.name for p in tmp_path.iterdir()] == ["run.nc"]
    import xarray

    with xarray.open_dataset(tmp_path / "run.nc") as data:
        assert data.sizes["run"] == 2


def test_options_reach_the_scenario(called, tmp_path):
    done = called(
        "simulate", "cheese", "--sheet", "dumpling-skin", "--natural-frequency", "20 pi rad/s", "--frequency", "15 Hz",
        "--angle", "4 deg", "--stroke", "2 mm", "--mu-s", "0.6", "--mu-k", "0.5", "--friction-law", "adams",
        "--duration", "0.2 s", "--dt", "2e-5 s", "--json", "--out", "run.nc", cwd=tmp_path, check=0,
    )  # fmt: skip
    summary = plain_json(done.stdout)
    assert (summary["dt_s"], summary["frequency_hz"]) == (2e-5, 15)
    assert summary["steps"] == 10_000
    import xarray

    with xarray.open_dataset(tmp_path / "run.nc") as data:
        (tmp_path / "run.toml").write_text(data.attrs["scenario"], encoding="utf-8")
    scenario = read_scenario(tmp_path / "run.toml")
    assert scenario.sheet.mass == preset("dumpling-skin").scenario.sheet.mass
    assert scenario.sheet.natural_frequency == pytest.approx(20 * np.pi, rel=1e-9)  # an eigensolver's round-off
    assert scenario.motion.angle == pytest.approx(np.radians(4))
    assert scenario.motion.stroke == pytest.approx(2e-3)
    assert (scenario.friction.static, scenario.friction.kinetic, scenario.friction.law) == (0.6, 0.5, "adams")


def test_a_failure_is_exit_status_1(tmp_path):
    # A plate like ice, tilted far.
    done = plategait(
        "simulate", "cheese", "--duration", "1 s", "--mu-s", "0", "--angle", "40 deg", "--frequency", "1 Hz", "--json",
        cwd=tmp_path, check=1,
    )  # fmt: skip
    summary = plain_json(done.stdout)
    assert summary["failed"] is True
    assert summary["failure"] == "slipped"
    assert 0 < summary["failure_time_s"] < 1


def test_a_failure_in_part_shows_everywhere(called, tmp_path):
    # The limit of slip that two of these four starts keep.
    base = preset("cheese").scenario.replace(duration=0.6)
    drifts = sorted(o["drift"] for o in simulate(base, repeats=4, seed=3).observations)
    (tmp_path / "s.toml").write_text(write_scenario(base.replace(slip_limit=0.5 * (drifts[1] + drifts[2]))))
    four = ("s.toml", "--repeats", "4", "--seed", "3")
    table = called("simulate", *four, cwd=tmp_path, check=1).stdout
    assert "2 of 4 slipped by more than" in table
    assert "over 2 of 4 runs" in table
    summary = plain_json(called("simulate", *four, "--json", cwd=tmp_path, check=1).stdout)
    assert (summary["runs"], summary["failed_runs"], summary["counted_runs"]) == (4, 2, 2)
    assert (summary["failed"], summary["failure"], summary["failures"]) == (True, "slipped", {"slipped": 2})
    curve = called("curve", *four, "--frequency", "24, 25 Hz", "--out", "c.csv", cwd=tmp_path, check=1).stdout
    assert "2 of 4 failed: slipped" in curve
    back = read_curve(tmp_path / "c.csv")
    assert back.failed_runs is not None
    assert back.failed_runs[0] == 2
    assert back.partly_failed[0]


def test_nothing_is_said_of_contact_and_flight_where_nothing_was_measured(called, tmp_path):
    done = called("simulate", "cheese", "--duration", "1e-3 s", cwd=tmp_path, check=0)
    for name in (
        "spin rate",
        "95 % interval",
        "nodes in contact",
        "time in flight",
        "plate power",
        "bending amplitude",
    ):
        (shown,) = (line for line in done.stdout.splitlines() if name in line)
        assert shown.replace(name, "").strip() == "–", shown
    assert "– to –" not in done.stdout


def test_a_failure_is_printed_with_its_time(called, tmp_path):
    done = called(
        "simulate", "cheese", "--duration", "1 s", "--mu-s", "0", "--angle", "40 deg", "--frequency", "1 Hz",
        cwd=tmp_path, check=1,
    )  # fmt: skip
    assert "slipped by more than 10 mm at 0." in done.stdout


def test_a_run_too_short_to_measure_prints_dashes(called, tmp_path):
    done = called("simulate", "cheese", "--duration", "1e-3 s", cwd=tmp_path, check=0)
    assert "nan" not in done.stdout.lower()
    assert "–" in done.stdout


def test_curve_writes_what_fit_reads(tmp_path):
    done = plategait(
        "curve", "cheese", "--frequency", "14:26:3Hz", "--duration", "0.5 s", "--out", "c.csv", "--json", cwd=tmp_path
    )
    assert done.returncode in (0, 1)
    summary = plain_json(done.stdout)
    assert (summary["f0_hz"] is None) == (done.returncode == 1)
    assert [p["frequency_hz"] for p in summary["points"]] == [14, 17, 20, 23, 26]
    curve = read_curve(tmp_path / "c.csv")
    assert (tmp_path / "c.csv").read_text().splitlines()[0].startswith(",".join(COLUMNS) + ",drift_mm,")
    assert 1e3 * curve.values["drift"][0] == pytest.approx(summary["points"][0]["drift_mm"], rel=1e-9)
    for i, point in enumerate(summary["points"]):
        if point["spin_rate_deg_s"] is not None:
            assert curve.spin_rate_deg_s[i] == pytest.approx(point["spin_rate_deg_s"], rel=1e-9)
    again = plategait("fit", "c.csv", "--json", cwd=tmp_path, check=done.returncode)
    refit = plain_json(again.stdout)
    if refit["f0_hz"] is not None:
        assert refit["f0_hz"] == pytest.approx(summary["f0_hz"], rel=1e-6)  # ten digits in the file
    assert sorted(p.name for p in tmp_path.iterdir()) == ["c.csv"]


def test_curve_prints_a_table_and_why_there_is_no_fit(called, tmp_path):
    done = called("curve", "cheese", "--frequency", "20, 24 Hz", *SHORT, cwd=tmp_path, check=1)
    assert "no Lorentz fit" in done.stdout
    assert done.stderr == ""


def test_fit_finds_the_peak_and_leaves_failures_out(called, tmp_path):
    write_peak(tmp_path / "c.csv", spoil=True)
    found = plain_json(called("fit", "c.csv", "--json", cwd=tmp_path, check=0).stdout)
    assert found["f0_hz"] == pytest.approx(21, rel=1e-3)  # rates of six digits
    assert found["peak_deg_s"] == pytest.approx(300, rel=1e-3)
    table = called("fit", "c.csv", cwd=tmp_path, check=0)
    assert "21.00 Hz" in table.stdout
    assert "15 points" in table.stdout


def test_fit_without_a_peak_is_exit_status_1(called, tmp_path):
    (tmp_path / "c.csv").write_text("frequency_hz,spin_rate_deg_s\n12,1\n13,2\n")
    done = called("fit", "c.csv", "--json", cwd=tmp_path, check=1)
    found = plain_json(done.stdout)
    assert found["f0_hz"] is None
    assert found["no_fit"]


def test_modes_prints_the_dish(called, tmp_path):
    found = plain_json(called("modes", "cheese", "--count", "12", "--json", cwd=tmp_path, check=0).stdout)
    assert len(found["modes"]) == 12
    dish = next(m for m in found["modes"] if m["name"] == "dish")
    assert dish["omega_rad_s"] == pytest.approx(preset("cheese").scenario.sheet.natural_frequency, rel=1e-9)
    scaled = called("modes", "cheese", "--natural-frequency", "7 Hz", "--json", cwd=tmp_path, check=0)
    dish = next(m for m in plain_json(scaled.stdout)["modes"] if m["name"] == "dish")
    assert dish["frequency_hz"] == pytest.approx(7, rel=1e-9)
    assert "dish" in called("modes", cwd=tmp_path, check=0).stdout


@pytest.mark.parametrize("name", PRESETS)
def test_a_printed_preset_runs_as_the_preset(name, called, tmp_path):
    printed = called("scenario", "--print", name, cwd=tmp_path, check=0).stdout
    assert printed.startswith("# ")
    (tmp_path / "mine.toml").write_text(printed, encoding="utf-8")
    assert read_scenario(tmp_path / "mine.toml") == preset(name).scenario
    done = called("simulate", "mine.toml", "--duration", "0.3 s", "--json", cwd=tmp_path, check=0)
    by_file, by_name = plain_json(done.stdout), simulate(preset(name).scenario.replace(duration=0.3)).summary()
    for clock in ("wall_s", "simulated_s_per_wall_s"):
        by_file.pop(clock), by_name.pop(clock)
    by_file.pop("expected")  # what the command adds of the gait
    assert by_file == by_name


def test_scenario_lists_and_checks(called, tmp_path):
    listed = called("scenario", cwd=tmp_path, check=0).stdout
    assert all(name in listed for name in PRESETS)
    assert set(plain_json(called("scenario", "--json", cwd=tmp_path, check=0).stdout)) == set(PRESETS)
    (tmp_path / "mine.toml").write_text(called("scenario", "--print", "cheese", cwd=tmp_path, check=0).stdout)
    assert "52 nodes" in called("scenario", "mine.toml", cwd=tmp_path, check=0).stdout
    assert plain_json(called("scenario", "mine.toml", "--json", cwd=tmp_path, check=0).stdout)["nodes"] == 52


def test_help_is_no_error(tmp_path):
    for arguments in (("--help",), ("simulate", "--help")):
        assert "Usage" in plategait(*arguments, cwd=tmp_path, check=0).stdout


@pytest.mark.parametrize("name", ["a[/b]", "a[red]b", "[bold]"])
def test_brackets_in_a_name_are_just_brackets(name, called, tmp_path):
    text = called("scenario", "--print", "cheese", cwd=tmp_path, check=0).stdout.replace(
        'name = "cheese"', f'name = "{name}"'
    )
    (tmp_path / "mine.toml").write_text(text)
    for arguments in (("modes", "mine.toml"), ("simulate", "mine.toml", "--duration", "0.05 s")):
        assert name in called(*arguments, cwd=tmp_path, check=0).stdout


# What does not

HUGE = "x" * 300 + ".nc"
BAD = {
    "unknown preset": (("simulate", "chees"), "scenario"),
    "missing file": (("simulate", "missing.toml"), "missing.toml"),
    "folder": (("simulate", "."), "scenario"),
    "broken file": (("simulate", "broken.toml"), "broken.toml"),
    "unknown key": (("simulate", "unknown.toml"), "frequenzy"),
    "sheet": (("simulate", "--sheet", "nosuch"), "--sheet"),
    "natural frequency": (("simulate", "--natural-frequency", "5 mm"), "--natural-frequency"),
    "huge natural frequency": (("modes", "--natural-frequency", "1e200 Hz"), "natural-frequency"),
    "frequency": (("simulate", "--frequency", "-5 Hz"), "--frequency"),
    "no frequency": (("simulate", "--frequency", ""), "--frequency"),
    "angle": (("simulate", "--angle", "3 mm"), "--angle"),
    "stroke": (("simulate", "--stroke", "nan"), "--stroke"),
    "comma": (("simulate", "--stroke", "2,5 mm"), "--stroke"),
    "mu_s": (("simulate", "--mu-s", "-1"), "--mu-s"),
    "mu_k": (("simulate", "--mu-k", "x"), "--mu-k"),
    "mu_k above mu_s": (("simulate", "--mu-k", "0.9"), "--mu-k"),
    "law": (("simulate", "--friction-law", "coulomb"), "law"),
    "duration": (("simulate", "--duration", "0"), "--duration"),
    "long duration": (("simulate", "--duration", "1e12"), "duration"),
    "dt": (("simulate", "--dt", "1 mm"), "--dt"),
    "large dt": (("simulate", "--dt", "1 s"), "--dt"),
    "small dt": (("simulate", "--dt", "1e-12 s"), "--dt"),
    "repeats": (("simulate", "--repeats", "0"), "repeats"),
    "repeats text": (("simulate", "--repeats", "many"), "--repeats"),
    "seed": (("simulate", "--repeats", "2", "--seed", "-1"), "--seed"),
    "seed text": (("simulate", "--seed", "x"), "--seed"),
    "engine": (("simulate", "--engine", "gpu"), "engine"),
    "suffix": (("simulate", "--out", "run.csv"), "--out"),
    "no folder": (("simulate", "--out", "missing/run.nc"), "--out"),
    "out a folder": (("simulate", "--out", "."), "--out"),
    "out nothing": (("simulate", "--out", ""), "--out"),
    "out too long": (("simulate", "--out", HUGE), "--out"),
    "no value": (("simulate", "--frequency"), "--frequency"),
    "unknown option": (("simulate", "--frequenzy", "3"), "--frequenzy"),
    "extra argument": (("simulate", "cheese", "pancake"), "pancake"),
    "unknown command": (("simulat",), "simulat"),
    "curve frequency": (("curve", "--frequency", "30:12:1Hz"), "frequency"),
    "curve suffix": (("curve", "--out", "c.nc"), "--out"),
    "fit nothing": (("fit",), "CURVE"),
    "fit missing": (("fit", "missing.csv"), "missing.csv"),
    "fit text": (("fit", "text.csv"), "line 3"),
    "modes count": (("modes", "--count", "0"), "--count"),
    "modes count text": (("modes", "--count", "x"), "--count"),
    "modes of a strip": (("modes", "cheese", "--natural-frequency", "0"), "--natural-frequency"),
    "print": (("scenario", "--print", "nosuch"), "nosuch"),
    "check": (("scenario", "broken.toml"), "broken.toml"),
}


@pytest.fixture
def folder(tmp_path, monkeypatch) -> Path:
    """Folder with files that are wrong."""
    (tmp_path / "broken.toml").write_text("name = \n")
    (tmp_path / "unknown.toml").write_text(
        "[motion]\nfrequenzy = 3\n[sheet]\nmass = 0.01\naxial_stiffness = 1\nbending_stiffness = 1\n"
        "outline = {shape = 'disk', radius = 0.04}\n"
    )
    (tmp_path / "text.csv").write_text("frequency_hz,spin_rate_deg_s\n12,1\n13,x\n")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("name", BAD)
def test_bad_input_is_one_line_and_exit_status_2(name, folder, monkeypatch, capsys):
    # The installed command is nothing but this call; a process for each would take a minute.
    arguments, named = BAD[name]
    before = sorted(folder.iterdir())
    monkeypatch.setattr(sys, "argv", [COMMAND, *arguments])
    with pytest.raises(SystemExit) as exit_status:
        main()
    out, err = capsys.readouterr()
    assert exit_status.value.code == 2, err
    assert out == ""
    assert len(err.splitlines()) == 1, err
    assert named in err
    assert sorted(folder.iterdir()) == before


@pytest.mark.parametrize("name", ["unknown preset", "fit text"])
def test_bad_input_to_the_installed_command(name, folder):
    arguments, named = BAD[name]
    done = plategait(*arguments, cwd=folder, check=2)
    assert done.stdout == ""
    assert len(done.stderr.splitlines()) == 1, done.stderr
    assert named in done.stderr


# Interruption, pipes and full disks


def wait_until_it_runs(process: subprocess.Popen) -> None:
    """Wait until the native core is loaded, and a moment more."""
    maps = Path(f"/proc/{process.pid}/maps")
    for _ in range(200):
        time.sleep(0.05)
        if not maps.exists() or "_native" in maps.read_text():
            break
    time.sleep(0.7)


@pytest.mark.skipif(os.name == "nt", reason="needs POSIX signals")
@pytest.mark.parametrize(
    "arguments",
    [("simulate", "--out", "run.nc", "--json"), ("curve", "--frequency", "12:14:1Hz", "--out", "c.csv")],
    ids=["simulate", "curve"],
)
def test_ctrl_c_is_exit_status_130_and_leaves_nothing(arguments, tmp_path):
    # A suite that runs in the background passes its deaf ear for Ctrl-C on.
    process = subprocess.Popen(
        [COMMAND, *arguments, "--duration", "1500 s"],
        cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )  # fmt: skip
    try:
        wait_until_it_runs(process)
        assert process.poll() is None, "still at work"
        begun = time.monotonic()
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=20)
        took = time.monotonic() - begun
    finally:
        process.kill()
    assert process.returncode == 130
    assert took < 3  # a twentieth of a second, and a busy machine
    assert out == ""
    assert "Traceback" not in err
    assert err.splitlines() == ["plategait: interrupted, nothing written"]
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(os.name == "nt", reason="needs POSIX pipes")
def test_a_reader_that_goes_away_is_no_traceback(tmp_path):
    done = subprocess.run(
        ["sh", "-c", f"'{COMMAND}' modes --count 40 --json | head -n 1 >/dev/null; '{COMMAND}' scenario | true"],
        cwd=tmp_path, capture_output=True, text=True, timeout=60, check=False,
    )  # fmt: skip
    assert done.stderr == ""


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_a_full_disk_is_one_line(tmp_path):
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [COMMAND, "scenario", "--print", "cheese"],
            cwd=tmp_path, stdout=full, stderr=subprocess.PIPE, text=True, timeout=60, check=False,
        )  # fmt: skip
    assert done.returncode != 0
    assert "Traceback" not in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_what_a_motion_needs_of_a_machine(called, tmp_path):
    (tmp_path / "shaker.toml").write_text(
        'name = "mine"\nx = { stroke = "5 mm", acceleration = "60 m/s^2" }\n'
        'rx = { angle = "4 deg", torque = "50 N*mm" }\n'
        'plate_mass = "100 g"\ninertia_x = "1e-4 kg*m^2"\ninertia_y = "1e-4 kg*m^2"\ninertia_z = "2e-4 kg*m^2"\n'
    )
    asked = ("needs", "cheese", "--machine", "shaker.toml", "--angle", "3 deg", "--stroke", "3 mm")
    told = plain_json(called(*asked, "--frequency", "10 Hz", "--json", cwd=tmp_path, check=0).stdout)
    assert told["within"]
    assert told["beyond"] == []
    omega = 2 * math.pi * 10
    # The smooth start takes a little more than the sine.
    assert 0.999 < told["needs"]["x"]["acceleration_m_s2"] / (3e-3 * omega**2) < 1.2
    assert 0.999 < told["needs"]["rx"]["torque_n_m"] / (1e-4 * math.radians(3) * omega**2) < 1.2
    assert told["needs"]["x"]["position_mm"] == pytest.approx(3, rel=1e-3)
    fast = called(*asked, "--frequency", "30 Hz", cwd=tmp_path, check=1)
    assert "acceleration on x, above" in fast.stdout.replace("\n", " ")
    assert "within the machine's limits" in called("needs", cwd=tmp_path, check=0).stdout
    for name, text in {"none.toml": None, "axis.toml": "w = 3\n", "mass.toml": 'rx = { torque = "1 N*m" }\n',
                       "zero.toml": 'x = { stroke = "0 mm" }\n'}.items():  # fmt: skip
        if text:
            (tmp_path / name).write_text(text)
        refused = called("needs", "--machine", name, cwd=tmp_path, check=2)
        assert len(refused.stderr.splitlines()) == 1
