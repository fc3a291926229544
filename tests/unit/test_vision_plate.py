"""Homographies, the plate seen straight, its outline and its fiducials, and lenses: each against what was put in."""

from __future__ import annotations

import math

import cv2
import numpy as np
import pytest
from drawn_clips import FIDUCIAL, SIDE, Clip, camera_of, homography_of, plate_drawing

from plategait.camera.camera import Calibration
from plategait.camera.fiducials import plate_target
from plategait.errors import InputError
from plategait.vision.frames import Frame, repeats
from plategait.vision.lens import scaled_matrix, undistorter
from plategait.vision.plate.fiducials import FiducialPlate
from plategait.vision.plate.outline import OUTLINE_CROPPED, OutlinePlate
from plategait.vision.plate.rectified import Grid
from plategait.vision.plate.swing import focal_of, poses
from plategait.vision.plate.view import ScalePlate, homography, project, rigid

CAMERA = camera_of(Clip())
CORNERS = np.array([[-0.05, -0.05], [0.05, -0.05], [0.05, 0.05], [-0.05, 0.05]])
# From middles of pixels of the plate's drawing to plate coordinates, m.
TO_PLATE = np.array([[2e-4, 0, 1e-4 - SIDE / 2], [0, -2e-4, SIDE / 2 - 1e-4], [0, 0, 1]])


def seen(luma: np.ndarray) -> Frame:
    """A frame in grey."""
    grey = np.full((luma.shape[0] // 2, luma.shape[1] // 2), 128, np.uint8)
    return Frame(0, 0.0, luma, (grey, grey))


def picture(H: np.ndarray, clip: Clip = Clip()) -> np.ndarray:  # noqa: B008
    """Brightness of the plate under a homography before a dark background."""
    fine = np.diag([2.0, 2.0, 1.0]) @ np.array([[1, 0, 0.25], [0, 1, 0.25], [0, 0, 1]])
    drawn = cv2.warpPerspective(plate_drawing(clip), fine @ H @ TO_PLATE, (1280, 720), borderValue=(55, 60, 70))
    return cv2.cvtColor(cv2.resize(drawn, (640, 360), interpolation=cv2.INTER_AREA), cv2.COLOR_BGR2GRAY)


def test_a_homography_comes_back_from_the_points_that_it_moved() -> None:
    H = homography_of(CAMERA, 0.1, 2e-3)
    fitted = homography(CORNERS, project(H, CORNERS))
    assert fitted is not None
    points = np.random.default_rng(0).uniform(-0.05, 0.05, (20, 2))
    # Four points determine it: rounding alone.
    np.testing.assert_allclose(project(fitted, points), project(H, points), atol=1e-6)
    in_a_line = np.column_stack([np.linspace(-0.05, 0.05, 4), np.zeros(4)])
    assert homography(in_a_line, project(H, in_a_line)) is None


def test_a_rigid_plate_before_a_known_lens_needs_less_to_be_seen() -> None:
    H, noise = homography_of(CAMERA, 0.1, 2e-3), np.random.default_rng(1)
    near = CORNERS * 0.15  # a seventh of the plate: its far corners are extrapolated
    errors = []
    for _ in range(20):
        pixels = project(H, near) + 0.1 * noise.normal(size=(4, 2))
        loose = homography(near, pixels)
        assert loose is not None
        fits = (loose, rigid(loose, near, pixels, CAMERA.matrix))
        errors.append([np.abs(project(fit, CORNERS) - project(H, CORNERS)).max() for fit in fits])
    loose, held = np.median(errors, axis=0)
    assert held < 0.6 * loose


def test_poses_of_views_are_those_of_the_plate() -> None:
    tilts = np.radians([-8.0, 0.0, 12.0])
    middle = np.array([[1, 0, CAMERA.matrix[0, 2]], [0, 1, CAMERA.matrix[1, 2]], [0, 0, 1]])
    views = np.linalg.inv(middle) @ np.array([homography_of(CAMERA, t, 1e-3) for t in tilts])
    R, t = poses(views, CAMERA.matrix[0, 0])
    for tilt, rotation, place in zip(tilts, R, t, strict=True):
        about_x = np.array([[1, 0, 0], [0, math.cos(tilt), -math.sin(tilt)], [0, math.sin(tilt), math.cos(tilt)]])
        np.testing.assert_allclose(rotation, CAMERA.rotation @ about_x, atol=1e-9)
        np.testing.assert_allclose(place, CAMERA.rotation @ (1e-3, 0, 0) + CAMERA.translation, atol=1e-9)
    # Exact views of a plate that tilts tell the focal length; those of one from straight above do not.
    assert focal_of(views, CAMERA.width) == pytest.approx(CAMERA.matrix[0, 0], rel=1e-6)
    above = camera_of(Clip(overhead=True))
    level = np.linalg.inv(middle) @ np.array([homography_of(above, 0.0, 0.0)] * 3)
    assert focal_of(level, above.width) is None


def test_a_grids_pixels_and_the_plate_are_one_to_one() -> None:
    grid = Grid.over((0.12, 0.08), homography_of(CAMERA, 0.0, 0.0))
    assert grid.shape[1] > grid.shape[0]
    points = np.random.default_rng(2).uniform(-0.05, 0.05, (10, 2))
    np.testing.assert_allclose(grid.plate(grid.pixels(points)), points, atol=1e-12)
    np.testing.assert_allclose(project(grid.to_plate, grid.pixels(points)), points, atol=1e-12)
    # y goes up, rows go down; the middle of the plate is that of the grid.
    assert grid.pixels(np.array([0.0, 0.01]))[1] < grid.pixels(np.array([0.0, 0.0]))[1]
    np.testing.assert_allclose(grid.pixels(np.zeros(2)), (np.array(grid.shape[::-1]) - 1) / 2, atol=1e-9)
    part, (rows, columns) = grid.part(np.array([0.03, -0.01]), 0.01)
    assert part.shape == (rows.stop - rows.start, columns.stop - columns.start)
    np.testing.assert_allclose(part.plate(np.zeros(2)), grid.plate(np.array([columns.start, rows.start])), atol=1e-12)
    mask = grid.mask([np.array([[0.02, 0.02], [0.04, 0.02], [0.04, 0.03], [0.02, 0.03]])])
    inside, outside = (np.round(grid.pixels(np.array(p))).astype(int) for p in ((0.03, 0.025), (0.03, 0.0)))
    assert (mask[inside[1], inside[0]], mask[outside[1], outside[0]]) == (0, 1)


def test_a_warped_picture_shows_the_plate_straight_and_in_its_colours() -> None:
    H = homography_of(CAMERA, math.radians(9), 2e-3)
    luma = np.full((360, 640), 60, np.uint8)
    u, v = np.full((180, 320), 128, np.uint8), np.full((180, 320), 128, np.uint8)
    spot = np.array([0.02, -0.015])
    column, row = project(H, spot)
    cv2.circle(luma, (round(column), round(row)), 8, (200,), -1)
    cv2.circle(u, (round(column / 2 - 0.25), round(row / 2 - 0.25)), 4, (220,), -1)
    grid = Grid.over((SIDE, SIDE), H)
    warped = grid.warp(Frame(0, 0.0, luma, (u, v)), H)
    assert warped.shape == (*grid.shape, 3)
    for plane, level in ((0, 130), (1, 170)):
        rows, columns = np.nonzero(warped[..., plane] > level)
        # A spot rounded to a pixel of luma, 0.35 mm, or of colour, twice that, shows within one of them.
        where = grid.plate(np.array([columns.mean(), rows.mean()]))
        assert np.abs(where - spot).max() < 0.35e-3 * (plane + 1)
    assert (warped[..., 2] == 128).all()


@pytest.mark.parametrize("by", ["fiducials", "outline"])
def test_the_plate_is_where_it_was_drawn(by: str) -> None:
    clip = Clip(fiducials=by == "fiducials")
    target = plate_target(SIDE, SIDE, FIDUCIAL)
    finder = FiducialPlate(target) if by == "fiducials" else OutlinePlate((SIDE, SIDE))
    for tilt in np.radians([-10.0, -4.0, 3.0, 8.0]):
        H = homography_of(CAMERA, tilt, 1e-3)
        view = finder.find(seen(picture(H, clip)))
        assert view.reason == ""
        assert view.homography is not None
        quad, drawn = project(view.homography, CORNERS), project(H, CORNERS)
        # Corners of fiducials are refined to a fraction of a pixel, and lines along edges to as much; where two of them
        # meet at a slant their errors add up.
        offset = min(np.abs(np.roll(quad, k, axis=0) - drawn).max() for k in range(4))
        assert offset < (0.3 if by == "fiducials" else 0.5)


WOOD, OAK_GREY, CHEESE = (150, 105, 62), (112, 112, 112), (242, 200, 84)


@pytest.mark.parametrize(
    ("plate", "table", "cue"),
    [
        pytest.param(WOOD, OAK_GREY, "other colour", id="brown wood on a table as bright"),
        pytest.param((236, 236, 233), (120, 122, 119), "light", id="white on grey"),
        pytest.param((40, 42, 45), (150, 148, 146), "dark", id="dark on light"),
        pytest.param((45, 46, 50), (100, 98, 96), "darkest", id="dark on grey, under a bright object"),
        pytest.param((118, 118, 118), (110, 110, 110), None, id="grey with an edge of shade on grey"),
    ],
)
def test_a_plate_is_known_by_its_brightness_its_colour_or_its_edges(
    plate: tuple[int, ...], table: tuple[int, ...], cue: str | None
) -> None:
    finder, noise = OutlinePlate((SIDE, SIDE)), np.random.default_rng(5)
    for tilt in np.radians([-6.0, 0.0, 5.0]):
        H = homography_of(CAMERA, tilt, 1e-3)
        rgb = np.full((720, 1280, 3), table, np.uint8)
        fine = np.array([[2, 0, 0.5], [0, 2, 0.5], [0, 0, 1.0]]) @ H
        outline = np.round(16 * project(fine, CORNERS)).astype(np.int32)
        cv2.fillConvexPoly(rgb, outline, plate, cv2.LINE_AA, 4)
        if cue is None:
            cv2.polylines(rgb, [outline], True, (70, 70, 70), 4, cv2.LINE_AA, 4)
        turns = np.linspace(0, 2 * np.pi, 60)
        around = project(fine, 0.03 * np.stack([np.cos(turns), np.sin(turns)], axis=1))
        cv2.fillPoly(rgb, [np.round(16 * around).astype(np.int32)], CHEESE, cv2.LINE_AA, 4)
        rgb = cv2.resize(rgb, (640, 360), interpolation=cv2.INTER_AREA) + 2 * noise.standard_normal((360, 640, 3))
        yuv = cv2.cvtColor(np.clip(rgb, 0, 255).astype(np.uint8), cv2.COLOR_RGB2YUV_I420)
        chroma = yuv[360:].reshape(2, 180, 320)
        view = finder.find(Frame(0, 0.0, yuv[:360], (chroma[0], chroma[1])))
        assert view.homography is not None
        assert view.read is not None
        drawn = project(H, CORNERS)
        # Colours are at half the size; an edge of shade is two pixels wide, and has two sides.
        offset = min(np.abs(np.roll(view.read[0], k, axis=0) - drawn).max() for k in range(4))
        assert offset < {None: 2.5, "other colour": 1.2}.get(cue, 0.7)


def test_a_plate_that_the_picture_cuts_off_is_no_plate() -> None:
    shifted = np.array([[1, 0, 260], [0, 1, 0], [0, 0, 1]]) @ homography_of(CAMERA, 0.0, 0.0)
    view = OutlinePlate((SIDE, SIDE)).find(seen(picture(shifted, Clip(fiducials=False))))
    assert view.homography is None
    assert view.reason == OUTLINE_CROPPED


def test_fiducials_that_are_covered_make_a_view_uncertain() -> None:
    finder, H = FiducialPlate(plate_target(SIDE, SIDE, FIDUCIAL)), homography_of(CAMERA, 0.0, 0.0)
    whole = picture(H)
    assert finder.find(seen(whole)).reason == ""
    covered = whole.copy()
    for corners in finder.target.corners[:3]:
        cv2.fillConvexPoly(
            covered, np.round(project(H, 1.5 * corners - 0.5 * corners.mean(axis=0))).astype(int), (200,)
        )
    assert finder.find(seen(covered)).reason == "a single fiducial seen"
    assert finder.find(seen(np.full_like(whole, 90))).homography is None


def test_a_known_scale_puts_the_origin_in_the_middle() -> None:
    view = ScalePlate(2e-4, (640, 360), (0.1, 0.1)).find(seen(np.zeros((360, 640), np.uint8)))
    assert view.homography is not None
    np.testing.assert_allclose(project(view.homography, np.array([[0, 0], [0.01, 0.02]])), [[320, 180], [370, 80]])


def test_a_calibration_holds_for_pictures_of_another_size() -> None:
    lens = Calibration(1280, 720, np.array([[900, 0, 639.5], [0, 900, 359.5], [0, 0, 1.0]]), np.zeros(1))
    half = scaled_matrix(lens, 640)
    # The middle of the picture stays its middle, and the focal length is half.
    np.testing.assert_allclose(half, [[450, 0, 319.5], [0, 450, 179.5], [0, 0, 1]])


def test_a_straight_line_before_a_barrel_lens_is_straight_again() -> None:
    lens = Calibration(640, 360, np.array([[500, 0, 319.5], [0, 500, 179.5], [0, 0, 1.0]]), np.array([-0.2]))
    row = np.linspace(-0.6, 0.6, 200)
    ends = lens.pixels(np.column_stack([row, np.full(200, -0.25)]))
    luma = np.zeros((360, 640), np.uint8)
    cv2.polylines(luma, [np.round(ends * 16).astype(np.int32)], False, (255,), 3, cv2.LINE_AA, 4)
    grey = np.full((180, 320), 128, np.uint8)
    straight = undistorter(lens, 640, 360)(Frame(0, 0.0, luma, (grey, grey))).luma.astype(float)
    for image, bend in ((luma.astype(float), (3, 40)), (straight, (0, 0.5))):
        columns = np.arange(60, 580, 40)
        middles = (image[:, columns] * np.arange(360)[:, None]).sum(axis=0) / image[:, columns].sum(axis=0)
        assert bend[0] <= np.ptp(middles) <= bend[1]
    assert undistorter(None, 640, 360)(frame := Frame(0, 0.0, luma, (grey, grey))) is frame
    with pytest.raises(InputError, match="--calibration"):
        undistorter(lens, 640, 480)


def test_pictures_that_hardly_change_repeat_the_one_before() -> None:
    np.testing.assert_array_equal(repeats(np.array([1.0, 0.3, 0.001, 0.28, 0.31])), [0, 0, 1, 0, 0])
