"""What a clip's first frames teach, and what is said where they show no plate: each against frames made for it."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import av
import cv2
import numpy as np
import pytest
from drawn_clips import FIDUCIAL, SIDE, Clip, camera_of, draw, homography_of
from ray_caster import _note_turn

from plategait.arrays import Picture
from plategait.camera.fiducials import plate_target
from plategait.errors import InputError
from plategait.vision.frames import Frame, open_video
from plategait.vision.plate.fiducials import FiducialPlate
from plategait.vision.plate.precision import doubt
from plategait.vision.plate.sharpness import sharpness
from plategait.vision.plate.trouble import NothingSeenError
from plategait.vision.plate.view import PlateView, homography, project, rigid
from plategait.vision.pose_reader import learnt
from plategait.vision.setup import Setup
from plategait.vision.survey import surveyed
from plategait.vision.track import track

SETUP = Setup(plate_size=(SIDE, SIDE))
TARGET = plate_target(SIDE, SIDE, FIDUCIAL)
CAMERA = camera_of(Clip())
LEVEL = homography_of(CAMERA, 0.0, 0.0)


@pytest.fixture(scope="module")
def frames(tmp_path_factory: pytest.TempPathFactory) -> list[Frame]:
    path = tmp_path_factory.mktemp("clips") / "clip.mp4"
    draw(Clip(seconds=1.0), path)
    with open_video(path) as video:
        return [replace(f, luma=f.luma.copy(), chroma=(f.chroma[0].copy(), f.chroma[1].copy())) for f in video.frames()]


def smeared(luma: Picture, across: int, down: int) -> Picture:
    """As if it had moved by so many pixels while it was taken."""
    return cv2.blur(luma, (across, down)).astype(np.uint8, copy=False)


def changed(frames: list[Frame], change: Callable[[Picture], Picture]) -> list[Frame]:
    return [replace(f, luma=np.ascontiguousarray(change(f.luma))) for f in frames]


def covered(*numbers: int) -> Callable[[Picture], Picture]:
    """With some of the fiducials painted over."""

    def change(luma: Picture) -> Picture:
        out = luma.copy()
        for k in numbers:
            middle = TARGET.corners[k].mean(axis=0)
            patch = np.round(project(LEVEL, middle + 2.2 * (TARGET.corners[k] - middle))).astype(np.int32)
            cv2.fillConvexPoly(out, patch, (120,))
        return out

    return change


@pytest.mark.parametrize("sharp", [{3, 8}, {1, 2, 3, 6, 7}])
def test_a_plate_is_found_in_whichever_phases_of_its_swing_are_sharp(frames: list[Frame], sharp: set[int]) -> None:
    # A plate at 3, 27 or 33 Hz shows each phase at every tenth frame; never at 0, 10 and 20 here.
    blurred = [f if k % 10 in sharp else replace(f, luma=smeared(f.luma, 25, 9)) for k, f in enumerate(frames)]
    survey = surveyed(blurred, SETUP)
    sure = [k for k, view in enumerate(survey.views) if not view.reason]
    assert sure == [k for k in range(len(frames)) if k % 10 in sharp]
    assert {view.reason for view in survey.views if view.reason} <= {"fiducials blurred"}


@pytest.mark.parametrize("period", [7, 8, 10])
def test_a_fiducial_that_comes_out_at_one_phase_only_is_found(frames: list[Frame], period: int) -> None:
    finder = FiducialPlate(TARGET)
    bare, all_but_one = frames[0], changed(frames[:1], covered(2))[0]
    views = [finder.find(bare if k % period == period - 1 else all_but_one) for k in range(period * 25)]
    # One search in ten frames, each as likely as not to be at another phase: 25 periods hold about as many.
    assert 2 in (views[-1].read or {})


def test_a_fiducial_that_was_read_elsewhere_leaves_nothing_sure() -> None:
    finder = FiducialPlate(TARGET)
    read = {k: project(LEVEL, corners) for k, corners in enumerate(TARGET.corners)}
    assert finder.again(PlateView(None, "", read)).reason == ""
    # One corner 7 px off, of fiducials of 25 px: no homography of the four comes near it.
    strayed = {k: c.copy() for k, c in read.items()}
    strayed[1][2] += (7.0, -6.0)
    assert finder.again(PlateView(None, "", strayed)).reason == "fiducials do not fit together"
    # What only looked like one may go.
    assert finder.again(PlateView(None, "", {k: read[k] for k in (0, 2, 3)}, {1: strayed[1]})).reason == ""


def test_few_fiducials_are_sure_only_where_they_tell_the_middle() -> None:
    finder, noise = FiducialPlate(TARGET), np.random.default_rng(0)
    rough = {k: project(LEVEL, c) + 1.2 * noise.normal(size=(4, 2)) for k, c in enumerate(TARGET.corners)}
    assert finder.again(PlateView(None, "", {k: rough[k] for k in (0, 3)})).reason == "too few fiducials seen"
    read = {k: project(LEVEL, corners) + 0.3 * noise.normal(size=(4, 2)) for k, corners in enumerate(TARGET.corners)}
    assert finder.again(PlateView(None, "", {k: read[k] for k in (0, 1, 2)})).reason == ""
    finder.lens = CAMERA.matrix
    assert finder.again(PlateView(None, "", {k: read[k] for k in (0, 2)})).reason == ""


@pytest.mark.parametrize(("seen", "lens"), [((0, 3), None), ((0, 2), None), ((0, 3), CAMERA.matrix), ((0,), None)])
def test_doubt_is_the_scatter_of_fits_to_noisy_corners(seen: tuple[int, ...], lens: np.ndarray | None) -> None:
    plate = np.concatenate([TARGET.corners[k] for k in seen])
    pixels, noise = project(LEVEL, plate), np.random.default_rng(1)
    places = 0.7 * np.array([[-SIDE, -SIDE], [SIDE, -SIDE], [SIDE, SIDE], [-SIDE, SIDE]]) / 2
    told, off = [], []
    for _ in range(150):
        noisy = pixels + 0.4 * noise.normal(size=pixels.shape)
        H = homography(plate, noisy)
        assert H is not None
        if lens is not None:
            H = rigid(H, plate, noisy, lens)
        told.append(doubt(H, plate, noisy, (SIDE, SIDE), lens))
        off.append(project(np.linalg.inv(LEVEL), project(H, places)) - places)
    if len(seen) == 1:
        assert not np.isfinite(told).any()  # as many numbers as corners: nothing tells the noise
        return
    # The worst direction at the worst place, by its largest standard deviation. Told from a linear fit, with the noise
    # of few corners: within a third.
    spread = max(np.sqrt(np.linalg.eigvalsh(np.cov(np.array(off)[:, k].T)).max()) for k in range(4))
    assert np.median(told) == pytest.approx(spread, rel=0.35)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda luma: luma[:, ::-1], "mirrored"),
        (lambda luma: np.pad(luma[180:, 330:], ((0, 180), (0, 330)), mode="edge"), "cropped by the picture's edge"),
        (lambda luma: smeared(luma, 17, 1), "blurred over"),
        (lambda luma: smeared(luma, 1, 17), "blurred over"),
        (lambda luma: cv2.GaussianBlur(luma, (0, 0), 5), "blurred over"),
        (covered(0, 1, 2), "covered or unreadable"),
        (lambda luma: np.full_like(luma, 90), "nothing like a plate"),
        (lambda luma: np.where(np.arange(640) // 40 % 2, 50, 180).astype(np.uint8) + 0 * luma, "nothing like a plate"),
        (covered(0, 1, 2, 3), "nothing like a plate"),
    ],
)
def test_what_is_wrong_with_a_film_is_said(
    frames: list[Frame], change: Callable[[Picture], Picture], words: str
) -> None:
    with pytest.raises(NothingSeenError, match=words):
        surveyed(changed(frames[:20], change), replace(SETUP, plate="fiducials"))


def test_another_plate_than_the_one_told_is_refused_with_its_size(frames: list[Frame]) -> None:
    for size, fiducial in (((0.14, 0.14), FIDUCIAL), ((0.14, 0.1), None), ((0.1, 0.1), 0.012)):
        with pytest.raises(InputError, match="--plate-size") as error:
            surveyed(frames[:10], Setup(plate_size=size, fiducial=fiducial))
        if fiducial == FIDUCIAL:
            assert "about 100 x 100 mm" in str(error.value) or "about 101 x 101 mm" in str(error.value)
    # Two in a hundred is how well a small picture tells it, and how well people measure.
    surveyed(frames[:10], Setup(plate_size=(0.102, 0.102), fiducial=FIDUCIAL))


def test_a_plate_that_comes_into_view_late_is_found_and_earlier_frames_are_uncertain(frames: list[Frame]) -> None:
    blank = [replace(f, luma=np.full_like(f.luma, 90)) for f in frames] * 2 + frames[:3]
    reader, survey, passed = learnt(iter([*blank, *frames[3:]]), SETUP)
    assert reader.object.methods == ("markers",)
    assert (len(passed), len(survey.frames)) == (60, 30)
    assert not any(f.luma.size for f in passed)
    with pytest.raises(InputError, match="frames: 5"):
        learnt(iter(blank[:5]), SETUP)


def test_a_hand_over_the_markers_at_first_does_not_hide_them_for_good(frames: list[Frame]) -> None:
    def under_a_hand(frame: Frame, k: int) -> Frame:
        luma, chroma = frame.luma.copy(), [plane.copy() for plane in frame.chroma]
        middle = project(LEVEL, np.array([0.002 * (k % 5 - 2), 0.0]))
        for plane, level, scale in ((luma, 150, 1), (chroma[0], 105, 2), (chroma[1], 150, 2)):
            at = np.round(middle / scale).astype(int)
            cv2.ellipse(plane, (int(at[0]), int(at[1])), (110 // scale, 80 // scale), 20, 0, 360, (level,), -1)
        return replace(frame, luma=luma, chroma=(chroma[0], chroma[1]))

    hidden = [under_a_hand(f, k) for k, f in enumerate([*frames, *frames])]
    reader, survey, passed = learnt(iter([*hidden, *frames]), SETUP)
    assert reader.object.methods == ("markers",)
    assert len(passed) + len(survey.frames) == 90
    # One that has none is followed without them.
    reader, survey, passed = learnt(iter(hidden), SETUP)
    assert reader.object.methods == ("texture", "outline")


def test_a_sharp_edge_is_sharp_and_one_smeared_one_way_is_not() -> None:
    picture = np.full((120, 120), 60, np.uint8)
    cv2.circle(picture, (60, 60), 35, (200,), -1)
    # A step taken over by a window of three: a quarter to a half from pixel to pixel.
    assert 0.25 < sharpness(picture) < 0.5
    for across, down in ((9, 1), (1, 9)):
        assert sharpness(smeared(picture, across, down)) == pytest.approx(1 / 9, rel=0.3)
    assert np.isnan(sharpness(np.full((120, 120), 60, np.uint8)))


class Camera:
    """A camera that gives a drawn clip's pictures as fast as they are asked for, at most 100 in a second."""

    pictures: tuple[Picture, ...] = ()

    def __init__(self, index: int) -> None:
        self.left: Iterator[Picture] = iter(self.pictures)
        self.released = False

    def isOpened(self) -> bool:
        return True

    def get(self, code: int) -> float:
        return {cv2.CAP_PROP_FRAME_WIDTH: 640.0, cv2.CAP_PROP_FRAME_HEIGHT: 360.0}.get(code, 30.0)

    def read(self) -> tuple[bool, Picture | None]:
        time.sleep(0.01)
        picture = next(self.left, None)
        return picture is not None, picture

    def release(self) -> None:
        self.released = True


def test_a_live_cameras_first_frames_are_used(frames: list[Frame], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Camera, "pictures", tuple(f.bgr() for f in frames) * 3)
    monkeypatch.setattr(cv2, "VideoCapture", Camera)
    seen: list[float] = []
    result = track("0", SETUP, follow=lambda frame, view, pose: seen.append(frame.time))
    assert len(result.time) == len(seen) == 90
    # Taken when they came, while the first sixty were learnt from; the clip jumps back twice.
    assert np.diff(result.time).max() < 0.2
    assert result.sure.sum() == 0 or result.sure.sum() > 80
    with open_video("0", seconds=0.3) as video:
        assert 5 < sum(1 for _ in video.frames()) < 40


def test_a_film_taken_upright_is_upright(tmp_path: Path) -> None:
    picture = np.zeros((96, 64, 3), np.uint8)
    picture[:48, :32] = (250, 30, 30)
    with av.open(str(tmp_path / "upright.mp4"), "w") as container:
        stream = container.add_stream("libx264", rate=30)
        stream.width, stream.height, stream.pix_fmt = 96, 64, "yuv420p"
        for _ in range(3):
            lying = av.VideoFrame.from_ndarray(np.ascontiguousarray(np.rot90(picture)), format="rgb24")
            container.mux(stream.encode(lying))
        container.mux(stream.encode(None))
    _note_turn(tmp_path / "upright.mp4")
    with open_video(tmp_path / "upright.mp4") as video:
        shown = next(iter(video.frames())).bgr()
        assert (video.width, video.height) == (64, 96)
    assert shown.shape == picture.shape
    assert shown[10, 10, 2] > 200
    assert shown[80, 50].max() < 40
