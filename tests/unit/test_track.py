"""Video to poses: opening files, the plate's motion, markers, texture, the spin rate and what frames cannot tell."""

from __future__ import annotations

import csv
import json
import math
from dataclasses import replace
from pathlib import Path

import av
import cv2
import numpy as np
import pytest
import typer
from drawn_clips import FIDUCIAL, SIDE, Clip, camera_of, draw, homography_of
from typer.testing import CliRunner

from plategait.cli.filmed import read_size
from plategait.cli.target import target
from plategait.cli.track import track
from plategait.errors import InputError
from plategait.vision.frames import Frame, open_video
from plategait.vision.object import parallax
from plategait.vision.object.pose import NO_POSE, Pose
from plategait.vision.plate.swing import aliases_of, plate_swing
from plategait.vision.plate.view import PlateView
from plategait.vision.preview import overlaid
from plategait.vision.setup import Setup
from plategait.vision.spin import apparent_frequency, spin_of
from plategait.vision.stamps import stamps_of
from plategait.vision.track import track as follow

FREQUENCY, SWING = 11.0, math.radians(4)
SETUP = Setup(plate_size=(SIDE, SIDE))


def angles(rate: float, time: np.ndarray, seed: int = 0, frequency: float = FREQUENCY) -> np.ndarray:
    """Angles modulo a turn, with a swing and half a degree of noise; rate in deg/s."""
    noise = np.radians(0.5) * np.random.default_rng(seed).normal(size=len(time))
    angle = np.radians(rate) * time + SWING * np.sin(2 * np.pi * frequency * time + 1) + noise
    return (angle + np.pi) % (2 * np.pi) - np.pi


@pytest.mark.linear_algebra
@pytest.mark.parametrize("fps", [30.0, 60.0, 120.0])
@pytest.mark.parametrize("rate", [0.0, 15.0, -56.6, 251.7, 750.0, -2500.0])
def test_spin_rate_with_two_fifths_of_the_frames_hidden(rate: float, fps: float) -> None:
    time = np.arange(0, 4, 1 / fps)
    sure = np.random.default_rng(int(fps)).random(len(time)) > 0.4
    angle = angles(rate, time)
    angle[~sure] = 17.0
    spin = spin_of(time, angle, sure, fps=fps, plate_frequency=FREQUENCY)
    # Half a degree of noise on 70 frames or more over 4 s: a standard error below 0.06 deg/s.
    assert math.degrees(spin.rate) == pytest.approx(rate, abs=0.2)
    assert spin.low <= spin.rate <= spin.high
    assert spin.settled
    assert [math.degrees(a) for a in spin.aliases] == pytest.approx([rate - 360 * fps, rate + 360 * fps], abs=1) or [
        math.degrees(a) for a in spin.aliases
    ] == pytest.approx([rate + 360 * fps, rate - 360 * fps], abs=1)


def test_interval_covers_the_truth_about_as_often_as_it_says() -> None:
    time = np.arange(0, 4, 1 / 30)
    hits = 0
    for seed in range(60):
        spin = spin_of(time, angles(100.0, time, seed), np.ones(len(time), bool), fps=30, plate_frequency=FREQUENCY)
        hits += spin.low <= math.radians(100) <= spin.high
    # 95 % of 60 is 57; fewer than 51 has a chance below 0.1 %.
    assert hits >= 51


@pytest.mark.linear_algebra
def test_outliers_do_not_move_the_rate() -> None:
    time = np.arange(0, 3, 1 / 60)
    angle = angles(120.0, time)
    wrong = np.random.default_rng(5).random(len(time)) < 0.1
    angle[wrong] += np.random.default_rng(6).uniform(-1, 1, wrong.sum())
    spin = spin_of(time, angle, np.ones(len(time), bool), fps=60, plate_frequency=FREQUENCY)
    # Least squares would be off by up to 6 deg/s here; the robust line by what the other frames allow.
    assert math.degrees(spin.rate) == pytest.approx(120.0, abs=1.2)


@pytest.mark.linear_algebra
def test_what_frames_cannot_tell_is_no_rate() -> None:
    time = np.arange(0, 2, 1 / 30)
    every = np.ones(len(time), bool)
    few = np.zeros(len(time), bool)
    few[:8] = True
    scattered = np.random.default_rng(1).uniform(-np.pi, np.pi, len(time))
    cases = {
        "frames are sure": spin_of(time, angles(100, time), few),
        "too differently": spin_of(time, scattered, every),
        "either way": spin_of(time, angles(5200, time), every),
    }
    for words, spin in cases.items():
        assert math.isnan(spin.rate)
        assert math.isnan(spin.high)
        assert words in spin.reason


def test_a_symmetric_object_is_known_to_a_part_of_a_turn() -> None:
    time = np.arange(0, 3, 1 / 30)
    angle = angles(300.0, time) % (np.pi / 2)
    spin = spin_of(time, angle, np.ones(len(time), bool), symmetry=4, fps=30, plate_frequency=FREQUENCY)
    assert math.degrees(spin.rate) == pytest.approx(300.0, abs=0.5)
    assert min(abs(math.degrees(a) - 300) for a in spin.aliases) == pytest.approx(90 * 30, abs=1)
    # Faster than half of a quarter turn per frame it may turn either way.
    fast = spin_of(time, angles(1300.0, time) % (np.pi / 2), np.ones(len(time), bool), symmetry=4, fps=30)
    assert math.isnan(fast.rate)


def test_a_swing_near_the_frame_rate_widens_the_interval() -> None:
    time = np.arange(0, 3, 1 / 30)
    # At 29.9 Hz the swing is seen at 0.1 Hz: within 3 s it looks like a slow turn.
    spin = spin_of(
        time, angles(50.0, time, frequency=29.9), np.ones(len(time), bool), fps=30, plate_frequency=29.9
    )  # fmt: skip
    assert abs(math.degrees(spin.rate) - 50) > 0.3
    assert spin.low <= math.radians(50) <= spin.high
    assert any("near a multiple of the frame rate" in note for note in spin.notes)
    assert apparent_frequency(29.9, 30) == pytest.approx(0.1)
    assert apparent_frequency(24, 30) == 6
    assert apparent_frequency(45, 30) == 15


def test_uneven_frames_tell_rates_apart_that_even_ones_do_not() -> None:
    even = np.arange(60) / 30
    uneven = np.cumsum(np.random.default_rng(2).uniform(0.02, 0.05, 60))
    assert len(spin_of(even, angles(100, even), np.ones(60, bool)).aliases) == 2
    assert spin_of(uneven, angles(100, uneven), np.ones(60, bool)).aliases == ()


@pytest.mark.linear_algebra
def test_parallax_of_a_lifted_marker_is_taken_out() -> None:
    time, length, f = np.arange(120) / 30, 0.03, 7.0
    true = np.radians(200) * time
    eye = np.tile([0.16, -0.03, 0.27], (len(time), 1))
    # Both sides of the object bend up in turns, most across the bar.
    lift = 0.008 * np.sin(true) ** 2 * (1 + np.sign(np.sin(true)) * np.sin(2 * np.pi * f * time)) / 2
    at = length * np.sqrt(1 - (lift / length) ** 2)[:, None] * np.stack([np.cos(true), np.sin(true)], axis=1)
    # Exactly as a point at that height falls on the plate's plane, seen from the eye.
    apparent = eye[:, :2] + (at - eye[:, :2]) * (eye[:, 2] / (eye[:, 2] - lift))[:, None]
    noise = np.random.default_rng(3).normal(size=(2, len(time)))
    angle = np.unwrap(np.arctan2(apparent[:, 1], apparent[:, 0])) + np.radians(0.2) * noise[0]
    spacing = np.hypot(*apparent.T) + 1e-4 * noise[1]
    fit = parallax.rim_parallax(time, angle, spacing, np.zeros((len(time), 2)), eye, f)
    assert fit is not None
    before, after = (np.degrees(np.std(a - true)) for a in (angle, angle - fit.turn))
    assert before > 2.5
    # The sign function has all harmonics of the turn; those left out hold some 0.3 deg, the noise 0.2 deg.
    assert after < 0.5
    # Of a few frames, or of an object that hardly turns, nothing can be said.
    assert parallax.rim_parallax(time[:15], angle[:15], spacing[:15], np.zeros((15, 2)), eye[:15], f) is None
    assert parallax.rim_parallax(time, angle / 100, spacing, np.zeros((120, 2)), eye, f) is None


@pytest.mark.linear_algebra
def test_the_plate_tells_its_tilt_its_frequency_and_the_lens() -> None:
    clip = Clip(tilt=10.0)
    camera, time = camera_of(clip), np.arange(90) / 30
    noise = np.random.default_rng(4)
    corners = np.array([[-0.05, -0.05], [0.05, -0.05], [0.05, 0.05], [-0.05, 0.05], [0, 0.05], [0, -0.05]])
    views = []
    for t in time:
        phase = 2 * math.pi * 24 * t
        H = homography_of(camera, math.radians(10) * math.sin(phase), 3e-3 * math.sin(phase))
        p = np.column_stack([corners, np.ones(len(corners))]) @ H.T
        pixels = p[:, :2] / p[:, 2:] + 0.1 * noise.normal(size=(len(corners), 2))
        views.append(cv2.findHomography(corners, pixels)[0])
    moved = plate_swing(stamps_of(time), np.array(views), (0.1, 0.1), (camera.matrix[0, 2], camera.matrix[1, 2]))
    # A tenth of a pixel on 150 px wide views: about 3 % of the lens, and less of the tilt over 90 frames.
    assert moved.focal == pytest.approx(camera.matrix[0, 0], rel=0.03)
    assert math.degrees(moved.tilt) == pytest.approx(10, abs=0.5)
    # 30 frames per second show 24 Hz as 6 Hz, as they would 36, 54 and 66 Hz.
    assert moved.frequency == pytest.approx(6, abs=0.02)
    assert not moved.certain
    np.testing.assert_allclose(moved.aliases, [24, 36, 54, 66], atol=0.05)
    assert moved.eye is not None
    assert np.abs(np.median(moved.eye, axis=0) - camera.eye).max() < 0.02
    # Frames that come unevenly show the true frequency.
    uneven = time + np.random.default_rng(7).uniform(0, 0.01, len(time))
    again = [homography_of(camera, math.radians(10) * math.sin(2 * math.pi * 24 * t), 0.0) for t in uneven]
    told = plate_swing(stamps_of(uneven), np.array(again), (0.1, 0.1), (319.5, 179.5))
    assert told.frequency == pytest.approx(24, abs=0.05)
    assert told.certain
    # A hand that sways at 3 Hz, and further than the plate does, is not taken for it.
    hand = np.array([[[1, 0, 30 * math.sin(19 * t)], [0, 1, 25 * math.cos(19 * t)], [0, 0, 1]] for t in uneven])
    held = plate_swing(stamps_of(uneven), hand @ np.array(again), (0.1, 0.1), (319.5, 179.5))
    assert held.frequency == pytest.approx(24, abs=0.05)
    still = plate_swing(stamps_of(uneven), hand @ np.array([again[0]] * 90), (0.1, 0.1), (319.5, 179.5))
    assert still.sways
    assert not still.certain
    # Nor does slow sway that is larger still hide it.
    sway = np.array([[[1, 0, 60 * math.sin(0.9 * t)], [0, 1, 40 * math.cos(1.3 * t)], [0, 0, 1]] for t in uneven])
    held = plate_swing(stamps_of(uneven), sway @ np.array(again), (0.1, 0.1), (319.5, 179.5))
    assert held.frequency == pytest.approx(24, abs=0.05)


@pytest.mark.parametrize("fps", [29.97, 30.0, 60.0, 120.0])
def test_stamps_of_milliseconds_are_rounded_not_uneven(fps: float) -> None:
    taken = np.delete(np.arange(200) / fps, [20, 21, 90])
    for time in (taken, np.round(1e3 * taken) / 1e3, np.floor(1e3 * taken) / 1e3):
        stamps = stamps_of(time)
        # A millisecond over 200 frames: a part in a thousand at 120 frames per second, and less below.
        assert stamps.fps == pytest.approx(fps, rel=1e-3)
        assert stamps.even
        assert stamps.missing == 3
        assert not stamps.varies
        # Put where they were taken: a fitted line knows that better than a tick.
        assert np.abs(np.diff(stamps.time) - np.diff(taken)).max() < 2e-5
    uneven = np.round(1e3 * np.cumsum(np.random.default_rng(3).uniform(0.02, 0.05, 90))) / 1e3
    shaken = stamps_of(uneven - uneven[0])
    assert not shaken.even
    assert shaken.varies
    np.testing.assert_array_equal(shaken.time, uneven - uneven[0])
    assert math.isnan(stamps_of(np.zeros(1)).fps)


def test_frequencies_that_even_frames_do_not_tell_apart() -> None:
    np.testing.assert_allclose(aliases_of(10.0, 30.0), [20, 40, 50, 70, 80])
    np.testing.assert_allclose(aliases_of(20.0, 60.0), [40, 80])
    # A plate does not shake at 100 Hz: at 120 frames per second 20 Hz is what is seen.
    assert aliases_of(20.0, 120.0) == ()


@pytest.fixture(scope="module")
def clip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("clips") / "clip.mp4"
    draw(Clip(seconds=1.0, repeat=(7, 19), dropped=(12,)), path)
    return path


def test_frames_keep_their_own_times_and_show_repeats(clip: Path) -> None:
    with open_video(clip) as video:
        frames = list(video.frames())
    assert (video.width, video.height) == (640, 360)
    time = np.array([f.time for f in frames])
    # Frame 12 of 30 is missing: its gap is twice as long. Times are kept to 1/90000 s.
    assert len(frames) == 29
    assert np.diff(time) == pytest.approx(np.where(np.arange(28) == 11, 2 / 30, 1 / 30), abs=2e-5)
    changes = np.array([f.change for f in frames])
    assert set(np.nonzero(changes < 0.015 * np.median(changes))[0]) == {7, 19}
    assert frames[0].bgr().shape == (360, 640, 3)
    # A camera that took 120 frames per second and stored them to be played at 30.
    with open_video(clip, fps=120) as video:
        slow = [f.time for f in video.frames()]
    assert slow[-1] == pytest.approx(time[-1] * 30 / 120, rel=0.05)
    with open_video(clip, seconds=0.5) as video:
        assert max(f.time for f in video.frames()) <= 0.5


def sound(path: Path) -> None:
    with av.open(str(path), "w") as container:
        stream = container.add_stream("pcm_s16le", rate=8000)
        frame = av.AudioFrame.from_ndarray(np.zeros((1, 800), np.int16), layout="mono")
        frame.sample_rate = 8000
        container.mux(stream.encode(frame))
        container.mux(stream.encode(None))


def test_what_is_no_video_is_said_in_a_line(tmp_path: Path, clip: Path) -> None:
    (tmp_path / "text.mp4").write_text("no film\n" * 100)
    (tmp_path / "empty.mp4").touch()
    (tmp_path / "cut.mp4").write_bytes(clip.read_bytes()[:3000])
    sound(tmp_path / "sound.wav")
    for name in ("text.mp4", "empty.mp4", "cut.mp4", "missing.mp4", "sound.wav"):
        with pytest.raises(InputError, match=r"^video: .*; try ") as error, open_video(tmp_path / name) as video:
            list(video.frames())
        assert "\n" not in str(error.value)
    with pytest.raises(InputError, match="sound only"), open_video(tmp_path / "sound.wav"):
        pass
    with pytest.raises(InputError, match="--fps"), open_video(clip, fps=0):
        pass
    with pytest.raises(InputError, match="camera"), open_video("97"):
        pass


@pytest.mark.slow
def test_a_file_cut_short_and_an_object_that_leaves_are_noted(tmp_path: Path) -> None:
    whole = tmp_path / "whole.mkv"
    draw(Clip(), whole)
    (tmp_path / "half.mkv").write_bytes(whole.read_bytes()[: whole.stat().st_size // 2])
    cut = follow(tmp_path / "half.mkv", SETUP)
    assert any(note.startswith("cut short") for note in cut.notes)
    assert math.degrees(cut.spin.rate) == pytest.approx(250, rel=0.005)
    # It leaves the plate at 60 mm/s: its rim marker is beyond the edge after 0.4 s at the soonest.
    draw(Clip(rate=120.0, drift=0.06), whole)
    gone = follow(whole, SETUP)
    assert gone.failure == "left the plate"
    # It has slipped by 20 mm after a third of a second; places are averaged over 0.15 s, at its start too.
    assert gone.findings.departure.time == pytest.approx(0.02 / 0.06, abs=0.15)
    assert 0.2 < gone.sure.mean() < 0.6
    assert not gone.sure[gone.time > 1.2].any()
    assert math.degrees(gone.spin.rate) == pytest.approx(120, rel=0.02)


def test_what_is_seen_of_the_plate_overrules_what_is_said_of_it(clip: Path) -> None:
    wrong = follow(clip, replace(SETUP, plate_frequency=17.0))
    assert any("17 Hz" in note and "13 Hz here, but is seen at" in note for note in wrong.notes)
    # A hundredth of the resolution of a second.
    assert wrong.plate.frequency == pytest.approx(11, abs=0.02)
    assert math.degrees(wrong.spin.rate) == pytest.approx(250, rel=0.005)
    with pytest.raises(InputError, match="--plate-size"):
        follow(clip, replace(SETUP, fiducial=0.02))


def app() -> typer.Typer:
    commands = typer.Typer()
    commands.command()(track)
    commands.command()(target)
    return commands


@pytest.mark.slow
def test_the_command_writes_poses_and_a_preview(clip: Path, tmp_path: Path) -> None:
    poses, film = tmp_path / "poses.csv", tmp_path / "seen.mp4"
    result = CliRunner().invoke(
        app(), ["track", str(clip), "--plate-size", "100 mm x 100 mm", "--frequency", "11 Hz", "--out", str(poses),
                "--preview", str(film), "--json"],
    )  # fmt: skip
    assert result.exit_code == 0, result.output
    said = json.loads(result.stdout)
    # The clip turns at 250 deg/s; the drawing is exact, and a second of it gives the rate to about 0.1 %.
    assert said["spin_rate_deg_s"] == pytest.approx(250, rel=0.005)
    assert said["method"] == "markers"
    assert said["uncertain"] == {"repeated picture": 2}
    rows = list(csv.DictReader(poses.open()))
    assert len(rows) == said["frames"] == 29
    assert [k for k, row in enumerate(rows) if row["sure"] == "0"] == [7, 19]
    turned = [float(row["angle_deg"]) for row in rows if row["sure"] == "1"]
    assert turned[-1] - turned[0] == pytest.approx(250 * 29 / 30, abs=5)
    with open_video(film) as video:
        assert sum(1 for _ in video.frames()) == 29
    printed = CliRunner().invoke(app(), ["track", str(clip)])
    assert "spin rate" in printed.output


def test_words_on_a_preview_stand_on_paper_of_their_own() -> None:
    dark = Frame(0, 1.5, np.full((240, 320), 16, np.uint8), (np.full((120, 160), 128, np.uint8),) * 2)
    for pose in (NO_POSE, Pose(0.0, 0.0, 0.1)):
        foot = overlaid(dark, PlateView(None), pose, (0.1, 0.1))[-12:, :40].mean(axis=2)
        # Ink on paper: most of it bright, some of it dark.
        assert 0.4 < (foot > 200).mean() < 0.98


def test_bad_input_leaves_nothing_behind(clip: Path, tmp_path: Path) -> None:
    blank = tmp_path / "blank.mp4"
    draw(Clip(seconds=0.4, fiducials=False), blank)
    for arguments, words in (
        ([str(clip), "--plate-size", "wide"], "--plate-size"),
        ([str(clip), "--object", "smell"], "--object"),
        ([str(clip), "--plate", "scale"], "--scale"),
        ([str(blank), "--plate", "fiducials"], "nothing like a plate"),
        ([str(clip), "--calibration", str(tmp_path / "none.json")], "calibration"),
    ):
        out = tmp_path / "seen.mp4"
        result = CliRunner().invoke(app(), ["track", *arguments, "--preview", str(out)])
        assert isinstance(result.exception, InputError), arguments
        assert words in str(result.exception)
        assert not out.exists()
        assert not list(tmp_path.glob(".plategait*"))


def test_plate_sizes_are_read_with_and_without_units() -> None:
    assert read_size("100 mm") == pytest.approx((0.1, 0.1))
    assert read_size("120 x 80 mm") == pytest.approx((0.12, 0.08))
    assert read_size("10cm x 8cm") == pytest.approx((0.1, 0.08))
    with pytest.raises(InputError, match="--plate-size"):
        read_size("1 x 2 x 3 mm")
    assert pytest.approx(SIDE / 6) == FIDUCIAL
