"""Cameras against OpenCV's model, and printed marks against the detector that has to find them."""

from __future__ import annotations

import io
import json
import re
import sys

import cv2
import numpy as np
import pytest

from plategait.camera import fiducials
from plategait.camera.camera import Calibration, Camera, read_calibration, write_calibration
from plategait.camera.fiducials import plate_target, write_target_pdf
from plategait.cli.target import target as print_target
from plategait.errors import InputError

EYE = (0.25, -0.1, 0.4)
LENS = (-0.21, 0.06, 0.001, -0.002, -0.01)


def detect(picture: np.ndarray) -> dict[int, np.ndarray]:
    """Corners (4, 2) of the plate's markers by number."""
    parameters = cv2.aruco.DetectorParameters()
    parameters.cornerRefinementMethod = cv2.aruco.CORNER_REFINE_SUBPIX
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    corners, numbers, _ = cv2.aruco.ArucoDetector(dictionary, parameters).detectMarkers(picture)
    ids = [] if numbers is None else numbers.ravel().tolist()
    return {n: c.reshape(4, 2) for n, c in zip(ids, corners, strict=True)}


def test_points_fall_where_opencv_puts_them():
    camera = Camera.looking_at(EYE, (0.01, 0.0, 0.0), 1280, 720, 0.5, LENS)
    points = np.random.default_rng(0).uniform(-0.06, 0.06, (50, 3))
    turn, _ = cv2.Rodrigues(camera.rotation)
    expected, _ = cv2.projectPoints(points, turn, camera.translation, camera.matrix, camera.distortion)
    # The same formula in the same precision: rounding alone.
    np.testing.assert_allclose(camera.project(points), expected.reshape(-1, 2), atol=1e-8)


def test_the_target_is_in_the_middle_and_up_is_up():
    camera = Camera.looking_at(EYE, (0.01, 0.02, 0.0), 640, 480, 0.6)
    np.testing.assert_allclose(camera.project((0.01, 0.02, 0.0)), (319.5, 239.5), atol=1e-9)
    assert camera.project((0.01, 0.02, 0.01))[1] < 239.5
    np.testing.assert_allclose(camera.eye, EYE, atol=1e-12)
    assert np.linalg.det(camera.rotation) == pytest.approx(1)


def test_a_camera_straight_above_has_the_bar_to_the_right_and_keeps_the_sense_of_rotation():
    camera = Camera.looking_at((0, 0, 0.5))
    origin, x, y = camera.project([(0, 0, 0), (0.01, 0, 0), (0, 0.01, 0)])
    assert x[0] > origin[0]
    assert abs(x[1] - origin[1]) < 1e-9
    # Rows count downwards: y of the plate goes up in the picture.
    assert y[1] < origin[1]


def test_the_field_of_view_is_that_of_the_height():
    camera = Camera.looking_at((0, 0, 1), width=1000, height=500, field_of_view=2 * np.arctan(0.1))
    # At a distance of 1 m, 0.1 m is half the picture.
    assert camera.project((0, 0.1, 0))[1] == pytest.approx(-0.5)


def test_points_behind_the_camera_are_nowhere():
    camera = Camera.looking_at((0, 0, 0.5))
    assert np.isnan(camera.project((0, 0, 1.0))).all()


@pytest.mark.parametrize(
    ("field", "arguments"),
    [
        ("eye", {"eye": (0, 0, 0)}),
        ("field_of_view", {"eye": EYE, "field_of_view": 4.0}),
        ("width", {"eye": EYE, "width": 10}),
        ("distortion", {"eye": EYE, "distortion": [0.0] * 6}),
    ],
)
def test_no_camera_is_made_of_nonsense(field, arguments):
    with pytest.raises(InputError, match=field):
        Camera.looking_at(**arguments)


def test_a_calibration_comes_back_the_same(tmp_path):
    calibration = Camera.looking_at(EYE, distortion=LENS).calibration
    write_calibration(calibration, tmp_path / "lens.json")
    again = read_calibration(tmp_path / "lens.json")
    assert (again.width, again.height) == (1280, 720)
    np.testing.assert_array_equal(again.matrix, calibration.matrix)
    np.testing.assert_array_equal(again.distortion, calibration.distortion)


@pytest.mark.parametrize(
    "text",
    ["", "[1, 2]", '{"width": 640}', json.dumps({"width": 640, "height": 480, "matrix": [1], "distortion": []}),
     json.dumps({"width": "wide", "height": 480, "matrix": np.eye(3).tolist(), "distortion": []})],
)  # fmt: skip
def test_a_file_that_is_no_calibration_is_refused(tmp_path, text):
    (tmp_path / "lens.json").write_text(text)
    with pytest.raises(InputError, match=r"calibration|matrix"):
        read_calibration(tmp_path / "lens.json")


def test_a_calibration_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(InputError, match="calibration"):
        read_calibration(tmp_path / "none.json")


def test_far_outside_the_picture_distortion_does_not_fold_back():
    # A barrel whose own polynomial would turn back at a ray of 1.15, and reach the picture again at 2.
    calibration = Calibration(640, 480, np.array([[500, 0, 320], [0, 500, 240], [0, 0, 1.0]]), np.array([-0.25]))
    rays = np.column_stack([np.linspace(0, 8, 400), np.zeros(400)])
    columns = calibration.pixels(rays)[:, 0]
    assert columns[rays[:, 0] > 0.9].min() > 640


def test_markers_lie_at_the_corners_in_a_detectors_order():
    target = plate_target(0.12, 0.10, 0.018)
    assert target.corners.shape == (4, 4, 2)
    # A white margin of a sixth, 3 mm, to the edges at the corner.
    np.testing.assert_allclose(target.corners[0, 0], (-0.057, 0.047))
    np.testing.assert_allclose(target.corners[2, 2], (0.057, -0.047))
    sides = np.linalg.norm(np.diff(target.corners[:, [0, 1, 2, 3, 0]], axis=1), axis=2)
    np.testing.assert_allclose(sides, 0.018)


@pytest.mark.parametrize("arguments", [(0.05, 0.05, 0.02), (0.0, 0.1), (0.1, float("nan")), (0.1, 0.1, -0.01)])
def test_markers_that_do_not_fit_are_refused(arguments):
    with pytest.raises(InputError, match=r"plate|marker"):
        plate_target(*arguments)


@pytest.mark.parametrize("size", [0.03, 0.1, 0.2])
def test_words_of_the_target_can_be_read_and_keep_off_the_plate(size):
    for page, half in ((fiducials._plate_page(plate_target(size, size, size / 6)), 500 * size),
                       (fiducials._object_page(), 0.0)):  # fmt: skip
        page.draw_without_rendering()
        (axes,) = page.axes
        words = [text for text in axes.texts if text.get_text()]
        assert min(text.get_fontsize() for text in words) >= 9
        boxes = [text.get_window_extent().transformed(axes.transData.inverted()) for text in words]
        # What printers leave white, mm.
        assert max(max(abs(box.x0), abs(box.x1)) for box in boxes) < page.get_figwidth() * 25.4 / 2 - 12
        assert all(box.y0 > half or box.y1 < -half for box in boxes if half)
        assert not [1 for i, box in enumerate(boxes) for other in boxes[:i] if box.overlaps(other)]


def test_the_printed_page_is_found_by_the_detector_at_true_scale():
    target = plate_target(0.12, 0.12, 0.02)
    page, picture = fiducials._plate_page(target), io.BytesIO()
    page.savefig(picture, format="png", dpi=254)
    gray = cv2.imdecode(np.frombuffer(picture.getvalue(), np.uint8), cv2.IMREAD_GRAYSCALE)
    detected = detect(gray)
    assert sorted(detected) == [0, 1, 2, 3]
    middle = np.array([gray.shape[1] - 1, gray.shape[0] - 1]) / 2
    pixels = np.array([detected[k] for k in range(4)])
    # 10 px for 1 mm; 0.1 mm is as well as the page can be cut.
    np.testing.assert_allclose((pixels - middle) * (1e-4, -1e-4), target.corners, atol=1e-4)


def test_the_target_needs_no_opencv(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "cv2", None)
    print_target(tmp_path / "t.pdf")
    assert (tmp_path / "t.pdf").stat().st_size > 5000


def test_the_target_is_a_pdf_of_two_pages_on_a4(tmp_path):
    path = write_target_pdf(plate_target(0.12, 0.12), tmp_path / "target.pdf")
    boxes = re.findall(rb"/MediaBox \[ 0 0 ([\d.]+) ([\d.]+) \]", path.read_bytes())
    assert len(boxes) == 2
    # 210 mm x 297 mm in points.
    np.testing.assert_allclose(np.array(boxes[0], dtype=float), (595.28, 841.89), atol=0.1)


def test_a_plate_that_fits_no_page_is_refused(tmp_path):
    with pytest.raises(InputError, match="plate"):
        write_target_pdf(plate_target(0.8, 0.8), tmp_path / "target.pdf")
    assert not list(tmp_path.iterdir())
