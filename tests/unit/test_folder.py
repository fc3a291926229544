"""Clips of a folder: which plate frequency each has."""

from __future__ import annotations

from pathlib import Path

import pytest

from plategait.errors import InputError
from plategait.vision.folder import clips_in, curve_of_clips, frequency_in_name, read_frequencies


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
