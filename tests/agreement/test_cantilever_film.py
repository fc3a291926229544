"""From a high-speed film of a sagging strip to the joint that it was made with, through a real file."""

from __future__ import annotations

import math

import cv2
import numpy as np
import pytest

from plategait.camera.writer import film_file
from plategait.errors import InputError
from plategait.identify.bending.recording import read_angles
from plategait.identify.bending.result import identify_bending
from plategait.render.clip.strip import StripFilm, film_cantilever
from plategait.vision.strip import StripTrack, track_cantilever

# Table 4.1's joint, N m/rad; the damping is ten times its, so that a short film holds most of the decay.
PER_DEGREE = 1e-3 * 180 / math.pi
STIFFNESS, DAMPING = 2.72e-3 * PER_DEGREE, 4.23e-5 * PER_DEGREE
SIZE = (512, 384)


def errors(truth: StripFilm, track: StripTrack) -> np.ndarray:
    """(n, 3, 2) px; y of the truth counts downwards."""
    return track.pixels - (truth.pixels * (1, -1) + (0, SIZE[1] - 1))


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    """A film as a high-speed camera stores it, 480 frames per second played at 30; the strip points to the left."""
    path = tmp_path_factory.mktemp("strip") / "strip.mp4"
    return path, film_cantilever(STIFFNESS, DAMPING, path, plays_at=30, left=True, size=SIZE)


def test_markers_are_followed_to_a_fraction_of_a_pixel(good):
    path, truth = good
    track = track_cantilever(path, fps=480)
    assert track.sure.all()
    assert track.notes == ()
    np.testing.assert_allclose(track.time, truth.time, atol=1e-4)
    # Colour has half the picture's resolution: a third of its pixel, 0.7 px, at worst, and 0.2 px in the mean square.
    assert np.abs(errors(truth, track)).max() < 0.7
    assert np.sqrt((errors(truth, track) ** 2).mean()) < 0.2


def test_the_joint_is_recovered_from_the_film(good, tmp_path):
    track_cantilever(good[0], fps=480, link_length=0.01).write(tmp_path / "strip.csv")
    joint = identify_bending(read_angles(tmp_path / "strip.csv"))
    # The codec moves markers by 0.1 px, for many frames alike: 0.07 deg of the 6.7 deg that phi2 swings. Films with
    # three other seeds give -1.2 to 0.1 % and -2.9 to 0.9 %.
    assert joint.stiffness.value == pytest.approx(STIFFNESS, rel=0.02)
    assert joint.damping.value == pytest.approx(DAMPING, rel=0.05)


def test_a_poor_film_says_that_it_is_poor(tmp_path):
    path = tmp_path / "poor.mp4"
    truth = film_cantilever(STIFFNESS, DAMPING, path, noise=9, gradient=0.6, crf=33, size=(320, 240), exposure=0.8)
    track = track_cantilever(path)
    assert track.sure.mean() > 0.8
    assert any("scatter" in note for note in track.notes)
    off = track.pixels - (truth.pixels * (1, -1) + (0, 239))
    # At this compression colour moves in blocks of 16 px: markers of 18 px are followed to a twentieth of their width.
    assert np.sqrt(np.nanmean(off**2)) < 0.9
    # 0.3 px of 80 px, of a swing of 6.7 deg: 3 % where errors were independent; four seeds give 1 to 9 %.
    assert identify_bending(track.angles).stiffness.value == pytest.approx(STIFFNESS, rel=0.15)


def test_the_scale_comes_from_the_links(good):
    track = track_cantilever(good[0], fps=480, link_length=0.01)
    # 20 mm fill half of the width; measured to 0.2 px of 256.
    assert track.scale == pytest.approx(0.02 / (SIZE[0] / 2), rel=0.01)


def strip_pictures(n: int, *, hide: slice = slice(0), extra: bool = False) -> list[np.ndarray]:
    """Three red spots of which the last moves; the middle one is hidden in some, and there may be a fourth."""
    pictures = []
    for k in range(n):
        picture = np.full((SIZE[1], SIZE[0], 3), 90, np.uint8)
        places = [(100, 150), (220, 150 + k // 2), (340, 150 + 2 * k)]
        for number, place in enumerate(places):
            if not (number == 1 and k in range(n)[hide]):
                cv2.circle(picture, place, 12, (30, 30, 200), -1)
        if extra:
            cv2.circle(picture, (450, 330), 12, (30, 30, 200), -1)
        pictures.append(picture)
    return pictures


def write(path, pictures):
    with film_file(path, SIZE, 100, 18) as file:
        for k, picture in enumerate(pictures):
            file.add(picture, k / 100)
    return path


def test_frames_without_all_markers_are_left_out_and_said_so(tmp_path):
    track = track_cantilever(write(tmp_path / "gaps.mp4", strip_pictures(30, hide=slice(10, 16))))
    np.testing.assert_array_equal(np.nonzero(~track.sure)[0], np.arange(10, 16))
    assert np.isnan(track.pixels[10:16]).all()
    assert any("6 of 30" in note for note in track.notes)
    track.write(tmp_path / "gaps.csv")
    assert len(read_angles(tmp_path / "gaps.csv").time) == 24


def test_the_end_that_stays_is_the_wall(tmp_path):
    track = track_cantilever(write(tmp_path / "plain.mp4", strip_pictures(20)))
    # The marker that was drawn at (100, 150), 383 - 150 px above the lower edge.
    np.testing.assert_allclose(track.pixels[:, 0], np.tile((100, 233), (20, 1)), atol=0.5)


@pytest.mark.parametrize("case", ["none", "two", "four", "short"])
def test_a_film_that_does_not_show_three_markers_is_refused(tmp_path, case):
    pictures = {
        "none": [np.full((SIZE[1], SIZE[0], 3), 90, np.uint8)] * 20,
        "two": strip_pictures(20, hide=slice(0, 20)),
        "four": strip_pictures(20, extra=True),
        "short": strip_pictures(5),
    }[case]
    with pytest.raises(InputError, match="three red markers"):
        track_cantilever(write(tmp_path / "bad.mp4", pictures))


def test_what_is_no_film_is_refused(tmp_path):
    (tmp_path / "text.mp4").write_text("no film")
    for path in (tmp_path / "text.mp4", tmp_path / "none.mp4"):
        with pytest.raises(InputError, match="video"):
            track_cantilever(path)
    with pytest.raises(InputError, match="link-length"):
        track_cantilever(tmp_path / "text.mp4", link_length=-1)
