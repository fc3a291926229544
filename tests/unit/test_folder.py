"""Clips of a folder: which plate frequency each has."""

from __future__ import annotations

import math
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from plategait.errors import InputError
from plategait.vision.departure import Departure
from plategait.vision.findings import Findings
from plategait.vision.folder import clips_in, curve_of_clips, frequency_in_name, read_frequencies, track_folder
from plategait.vision.plate.swing import UNSEEN, PlateSwing
from plategait.vision.setup import Setup
from plategait.vision.spin import Spin
from plategait.vision.velocity import Velocity


@pytest.mark.parametrize(
    ("name", "expected"),
    [("24Hz.mp4", 24.0), ("cheese 12.5 hz.mov", 12.5), ("run_3_24p5Hz_b.avi", 24.5), ("24,5_Hz.mp4", 24.5),
     ("GOPR0012.mp4", None), ("240fps.mp4", None), ("a_24Hz_24Hz.mp4", 24.0)],
)  # fmt: skip
def test_frequencies_in_names(name, expected):
    assert frequency_in_name(Path(name)) == expected


def test_a_name_with_two_is_refused():
    with pytest.raises(InputError, match="12 and 24"):
        frequency_in_name(Path("12Hz_24Hz.mp4"))


def test_a_table_of_frequencies(tmp_path):
    path = tmp_path / "f.csv"
    path.write_text("clip,frequency_hz\nIMG_1.mov,14\nIMG_2,15.5\n")
    assert read_frequencies(path) == {"IMG_1": 14.0, "IMG_2": 15.5}
    for bad in ("clip,hz\na,1\n", "clip,frequency_hz\na,fast\n", "clip,frequency_hz\na,-1\n", ""):
        path.write_text(bad)
        with pytest.raises(InputError):
            read_frequencies(path)


def test_folders_without_clips_are_refused(tmp_path):
    with pytest.raises(InputError, match="folder"):
        clips_in(tmp_path / "none")
    (tmp_path / "notes.txt").write_text("x")
    with pytest.raises(InputError, match="clip"):
        clips_in(tmp_path)
    with pytest.raises(InputError, match="unknown plate frequency"):
        curve_of_clips([], "c")


def test_each_clip_has_its_frequency_and_a_bad_one_costs_no_other(tmp_path, monkeypatch):
    for name in ("14Hz.mp4", "IMG_1.mov", "IMG_2.mov", "IMG_3.mov", "18Hz.mp4"):
        (tmp_path / name).touch()
    asked = {}

    findings = Findings(np.zeros((1, 2)), np.zeros(1), None, "nothing seen", Velocity(1e-3, 2e-3, 196e-6, 392e-6),
                        Departure("", math.nan, 0.001))  # fmt: skip

    def track(path, setup, progress):
        asked[path.name] = setup.plate_frequency
        progress(0.5)
        if path.name == "18Hz.mp4":
            raise InputError("video", "nothing like a plate", "a plate", "a plate")
        rate = Spin(1.0, 0.9, 1.1, True, 0.1)
        seen = {"IMG_2": PlateSwing(16.0, 0.1, None, 900.0), "IMG_3": PlateSwing(10.0, 0.1, None, 900.0, (20.0, 40.0))}
        plate = seen.get(path.stem, UNSEEN)
        frequency = setup.plate_frequency or (plate.frequency if plate.certain else math.nan)
        seen_of_it = {"spin": rate, "failure": "", "findings": findings, "true_to_scale": True, "time": [0.0, 2.0]}
        return SimpleNamespace(plate_frequency=frequency, plate=plate, **seen_of_it)

    monkeypatch.setattr("plategait.vision.folder.track", track)
    done = []
    clips = track_folder(tmp_path, Setup(), frequencies={"IMG_1": 15.0}, progress=done.append)
    assert asked == {"14Hz.mp4": 14.0, "18Hz.mp4": 18.0, "IMG_1.mov": 15.0, "IMG_2.mov": None, "IMG_3.mov": None}
    assert [(c.frequency, c.source) for c in clips[:4]] == [
        (14.0, "given"), (18.0, "given"), (15.0, "given"), (16.0, "measured"),
    ]  # fmt: skip
    assert done == [0.1, 0.3, 0.5, 0.7, 0.9]
    # What was only seen, and may be another, is no frequency of a curve.
    assert math.isnan(clips[4].frequency)
    assert "any of 10, 20, 40 Hz" in clips[4].trouble
    assert "nothing like a plate" in clips[1].trouble
    curve = curve_of_clips(clips, "folder")
    assert curve.frequency_hz.tolist() == [14.0, 15.0, 16.0, 18.0]
    assert curve.spin_rate_deg_s[:3] == pytest.approx(math.degrees(1.0))
    assert math.isnan(curve.spin_rate_deg_s[3])
    assert curve.values["velocity_x"][0] == pytest.approx(1e-3)
    assert curve.value_sds["velocity_y"][0] == pytest.approx(2e-4)
    assert "radius" not in curve.of_object
    # The interval is that of 95 %: 1.96 standard deviations each way.
    assert curve.spin_rate_sd_deg_s[0] == pytest.approx(math.degrees(0.1) / 1.96)
