"""What a camera delivers: when, how noisily, what never, and the same in any company."""

from __future__ import annotations

import numpy as np
import pytest

import plategait as pg
from plategait.control.camera import PERFECT, Camera, Seen, Stream


def watched(camera: Camera, seeds: list[int], seconds: float, tick: float = 1 / 60) -> list[Seen]:
    """What is seen at each tick of sheets that wander: frame k shows x = k µm."""
    stream = Stream(camera, seeds)
    every, looks = np.arange(len(seeds)), []
    for now in np.arange(0, round(seconds / tick) + 1) * tick:
        while stream.due[0] <= now + 1e-9:
            frame = round(float(stream.due[0] * camera.rate))
            stream.take(every, np.tile([1e-6 * frame, 0.0, 0.5], (len(seeds), 1)))
        looks.append(stream.look(np.full(len(seeds), now)))
    return looks


def test_a_frame_arrives_when_its_delay_is_over():
    camera = Camera(position_noise=0, angle_noise=0, missed=0, delay="30 ms")
    looks = watched(camera, [0], 1.0)
    assert np.isnan(looks[0].poses).all()
    assert np.isnan(looks[1].taken).all()
    for k, look in enumerate(looks[2:], 2):
        newest = np.floor((k / 60 - 0.03) * 60 + 1e-9)  # by hand: the last frame taken 30 ms ago or before
        assert look.taken[0] == pytest.approx(newest / 60)
        assert look.poses[0] == pytest.approx([1e-6 * newest, 0, 0.5])
        assert look.new[0]


def test_a_slow_camera_shows_the_same_frame_again():
    looks = watched(Camera(rate="20 Hz", delay=0, missed=0), [3], 1.0)
    assert [bool(look.new[0]) for look in looks] == [k % 3 == 0 for k in range(61)]
    np.testing.assert_array_equal(looks[4].poses, looks[3].poses)


def test_noise_and_misses_are_as_told():
    camera = Camera(delay=0, rate=60)
    looks = watched(camera, list(range(40)), 10.0)
    new = np.array([look.new for look in looks])
    # 24,040 frames: the standard error of 5 % is 0.14 %, of a standard deviation 0.5 %.
    assert new.mean() == pytest.approx(0.95, abs=0.006)
    frames = np.round(60 * np.array([look.taken for look in looks])[new])
    off = np.array([look.poses for look in looks])[new] - np.column_stack([1e-6 * frames, 0 * frames, 0.5 + 0 * frames])
    np.testing.assert_allclose(off.std(axis=0), [0.5e-3, 0.5e-3, np.radians(1)], rtol=0.02)
    assert (np.abs(off.mean(axis=0)) < [2e-5, 2e-5, 5e-4]).all()


def test_the_noise_of_a_lane_is_its_own():
    camera = Camera(rate=300)
    together, alone = watched(camera, [5, 6, 7], 1.5), watched(camera, [6], 1.5)
    for ours, theirs in zip(together, alone, strict=True):
        np.testing.assert_array_equal(ours.poses[1], theirs.poses[0])
        np.testing.assert_array_equal(ours.taken[1], theirs.taken[0])
        assert ours.new[1] == theirs.new[0]
    assert not np.array_equal(together[-1].poses[0], together[-1].poses[2])


def test_a_dark_camera_sees_nothing():
    looks = watched(Camera(missed=0, delay=0, dark=((0.5, 1.0),)), [1], 1.5)
    taken = np.array([look.taken[0] for look in looks])
    assert not ((taken >= 0.5) & (taken < 1.0)).any()
    assert taken[45] == pytest.approx(29 / 60)
    assert taken[60] == pytest.approx(1.0)


def test_a_copy_goes_on_by_itself_and_a_reset_draws_other_noise():
    stream = Stream(Camera(delay=0, missed=0), [1, 2])
    lanes, poses, now = np.arange(2), np.zeros((2, 3)), np.zeros(2)
    stream.take(lanes, poses)
    first = stream.look(now).poses
    saved = stream.copy()
    stream.take(lanes, poses)
    later = stream.look(now + 1 / 60).poses
    saved.take(lanes, poses)
    np.testing.assert_array_equal(saved.look(now + 1 / 60).poses, later)
    stream.reset([0])
    assert stream.due.tolist() == pytest.approx([0, 2 / 60])
    stream.take(np.array([0]), poses[:1])
    assert not np.array_equal(stream.look(now).poses[0], first[0])
    stream.reset([0], [1])
    stream.take(np.array([0]), poses[:1])
    np.testing.assert_array_equal(stream.look(now).poses[0], first[0])


def test_a_perfect_camera_tells_what_is():
    stream = Stream(PERFECT, [0])
    stream.take(np.array([0]), np.array([[0.01, -0.02, 3.0]]))
    assert stream.look(np.zeros(1)).poses.tolist() == [[0.01, -0.02, 3.0]]


@pytest.mark.parametrize(
    ("field", "value"),
    [("rate", 0), ("missed", 1.0), ("delay", -0.1), ("position_noise", "3 deg"), ("dark", ((1.0, 0.5),))],
)
def test_what_a_camera_cannot_be(field: str, value: object):
    with pytest.raises(pg.InputError, match=rf"^{field}"):
        Camera(**{field: value})
