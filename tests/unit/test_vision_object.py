"""Blobs, markers, textures and outlines on pictures of the plate from above: what was drawn there is what is read."""

from __future__ import annotations

import math

import cv2
import numpy as np
import pytest

from plategait.vision.object.blobs import blobs_in
from plategait.vision.object.markers import MarkerTracker, learn_markers, pairs_in
from plategait.vision.object.texture import ANGLES, PolarTemplate, TextureTracker, learn_object
from plategait.vision.plate.rectified import Grid

# A plate of 100 mm in pixels of 0.25 mm.
GRID = Grid((433, 433), 2.5e-4, (-0.054, 0.054))
EVERYWHERE = np.ones(GRID.shape, np.uint8)
METAL, CHEESE, BLUE = (200, 128, 128), (190, 60, 150), (60, 180, 110)
FINER = 4


def rectangle(angle: float, middle: tuple[float, float], size: tuple[float, float]) -> np.ndarray:
    """Corners, m, of a rectangle turned about its middle."""
    turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    return np.array(middle) + np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * size / 2 @ turn.T


def filled(image: np.ndarray, polygons: list[tuple[np.ndarray, tuple[int, ...]]]) -> np.ndarray:
    """Picture with polygons on it, m, whose edges cover pixels in part."""
    fine = cv2.resize(image, None, fx=FINER, fy=FINER, interpolation=cv2.INTER_NEAREST)
    for polygon, colour in polygons:
        corners = np.round(((GRID.pixels(polygon) + 0.5) * FINER - 0.5) * 16).astype(np.int32)
        cv2.fillPoly(fine, [corners], colour, cv2.LINE_AA, 4)
    return cv2.resize(fine, None, fx=1 / FINER, fy=1 / FINER, interpolation=cv2.INTER_AREA)


def disk(middle: tuple[float, float], radius: float = 0.03) -> np.ndarray:
    turn = np.linspace(0, math.tau, 120, endpoint=False)
    return np.array(middle) + radius * np.column_stack([np.cos(turn), np.sin(turn)])


def marked(angle: float, middle: tuple[float, float] = (0.004, -0.006), rim: bool = True) -> np.ndarray:
    """Cheese with its two markers."""
    plate = np.full((*GRID.shape, 3), METAL, np.uint8)
    along = np.array([math.cos(angle), math.sin(angle)])
    polygons = [(disk(middle), CHEESE), (rectangle(angle, middle, (0.012, 0.006)), BLUE)]
    if rim:
        polygons.append((rectangle(angle, tuple(middle + 0.024 * along), (0.006, 0.006)), BLUE))
    return filled(plate, polygons)


def apart(a: float, b: float, circle: float = math.tau) -> float:
    """Degrees from one direction to another."""
    return abs(math.degrees(math.remainder(a - b, circle)))


@pytest.mark.parametrize("angle", [0.0, 0.4, 1.3, -0.7])
def test_a_blob_has_the_place_size_and_direction_of_its_rectangle(angle: float) -> None:
    polygon = rectangle(angle, (0.011, -0.007), (0.012, 0.006))
    likeness = filled(np.zeros((*GRID.shape, 1), np.uint8), [(polygon, (128,))]).reshape(GRID.shape)
    [blob] = blobs_in((likeness > 64).astype(np.uint8), GRID, likeness)
    # Weighted by how far pixels are covered: to half a pixel of the finer drawing, which on both sides of
    # 6 mm is 1 % and of 12 mm half of that.
    np.testing.assert_allclose(blob.middle, (0.011, -0.007), atol=3.2e-5)
    assert blob.area == pytest.approx(0.012 * 0.006, rel=0.03)
    assert blob.aspect == pytest.approx(2, rel=0.03)
    assert apart(blob.axis, angle, math.pi) < 0.5
    assert blob.fill > 0.95


def test_blobs_too_small_or_too_large_for_a_marker_and_holes_are_none() -> None:
    binary = filled(
        np.zeros((*GRID.shape, 1), np.uint8),
        [(rectangle(0, (-0.03, 0), (0.001, 0.001)), (1,)), (rectangle(0, (0, 0), (0.03, 0.03)), (1,)),
         (rectangle(0, (0, 0), (0.01, 0.01)), (0,)), (rectangle(0, (0.035, 0), (0.008, 0.008)), (1,))],
    )  # fmt: skip
    [blob] = blobs_in(binary.reshape(GRID.shape), GRID)
    np.testing.assert_allclose(blob.middle, (0.035, 0), atol=2e-4)


def test_two_markers_in_a_line_are_the_likeliest_pair() -> None:
    angle = 0.9
    pair = pairs_in(marked(angle), GRID, EVERYWHERE)[0]
    along = np.array([math.cos(angle), math.sin(angle)])
    np.testing.assert_allclose(pair.rim - pair.centre, 0.024 * along, atol=1.5e-4)
    assert pair.long
    np.testing.assert_allclose(pair.marker, BLUE, atol=4)
    assert learn_markers([np.full((*GRID.shape, 3), METAL, np.uint8)] * 4, GRID, EVERYWHERE) is None


def test_markers_are_followed_and_what_hides_one_is_said() -> None:
    angles = np.linspace(0, 2, 8)
    appearance = learn_markers([marked(a) for a in angles], GRID, EVERYWHERE)
    assert appearance is not None
    assert appearance.spacing == pytest.approx(0.024, rel=0.01)
    assert appearance.others == 0
    tracker = MarkerTracker(appearance)
    for angle in angles:
        pose = tracker.find(marked(angle), GRID, EVERYWHERE)
        assert pose.reason == ""
        assert apart(pose.angle, angle) < 0.3
        np.testing.assert_allclose((pose.x, pose.y), (0.004, -0.006), atol=5e-5)
    assert tracker.find(marked(2.0, rim=False), GRID, EVERYWHERE).reason == "rim marker not seen"
    half = filled(marked(2.0), [(rectangle(2.0, (0.004, -0.003), (0.014, 0.006)), CHEESE)])
    assert tracker.find(half, GRID, EVERYWHERE).reason != ""
    assert tracker.find(np.full((*GRID.shape, 3), METAL, np.uint8), GRID, EVERYWHERE).reason == "centre marker not seen"


@pytest.mark.parametrize("angle", [0.1, 2.0, -1.2])
def test_a_template_tells_by_how_much_rows_are_turned(angle: float) -> None:
    turn = math.tau * np.arange(ANGLES) / ANGLES
    waves = np.random.default_rng(0).normal(size=(3, 12))

    def rows(by: float) -> np.ndarray:
        return sum(a * np.cos(k * (turn[:, None] - by) + b) for k, (a, b) in enumerate(waves[:2].T, 1)) * waves[2]

    template = PolarTemplate("texture")
    template.angle(rows(0.0))
    measured, correlation, lead = template.angle(rows(angle))
    # Between its samples of 0.7 deg a parabola through a curve that is not one: a few hundredths of one.
    assert apart(measured, angle) < 0.05
    assert correlation == pytest.approx(1, abs=1e-3)
    assert lead > 0.1
    assert template.symmetry() == 1


@pytest.mark.parametrize("fold", [2, 3, 5])
def test_a_template_knows_its_symmetry(fold: int) -> None:
    turn = math.tau * np.arange(ANGLES) / ANGLES
    template = PolarTemplate("outline")
    template.angle((np.cos(fold * turn) + 0.3 * np.sin(2 * fold * turn))[:, None])
    assert template.symmetry() == fold


def speckled(angle: float, corners: int = 0) -> np.ndarray:
    """An object without markers: its own grain, or with corners."""
    plate = np.full((*GRID.shape, 3), METAL, np.uint8)
    turns = math.tau * np.arange(corners or 120) / (corners or 120) + angle
    shape = filled(plate, [(0.03 * np.column_stack([np.cos(turns), np.sin(turns)]), CHEESE)])
    grain = cv2.GaussianBlur(np.random.default_rng(3).normal(size=GRID.shape), (0, 0), 5)
    middle = ((GRID.shape[1] - 1) / 2, (GRID.shape[0] - 1) / 2)
    turned = cv2.warpAffine(grain / grain.std(), cv2.getRotationMatrix2D(middle, math.degrees(angle), 1), GRID.shape)
    on = shape[..., 1] < 94
    shape[on, 0] = np.clip(shape[on, 0] + 15 * turned[on], 0, 255)
    return shape


def test_an_object_is_followed_by_its_texture_and_by_its_outline() -> None:
    for corners, method in ((0, 0), (5, 1)):
        turns = (0.0, 0.2, 0.5, 0.9)
        pictures = [speckled(a, corners) for a in turns]
        appearance = learn_object(pictures, GRID, EVERYWHERE)
        assert appearance is not None
        if not corners:
            assert appearance.radius == pytest.approx(0.03, rel=0.03)
        tracker = TextureTracker(appearance)
        poses = [tracker.find(p, GRID, EVERYWHERE)[method] for p in pictures]
        assert [p.reason for p in poses] == [""] * 4
        # Unrolled about a middle known to a tenth of a pixel, in steps of 0.7 deg; a pentagon is one to a fifth turn.
        circle = math.tau / 5 if corners else math.tau
        assert max(apart(p.angle - poses[0].angle, a, circle) for p, a in zip(poses, turns, strict=True)) < 0.5
        if corners:
            assert tracker.outline.symmetry() == corners
        else:
            assert tracker.find(pictures[0], GRID, EVERYWHERE)[1].reason == "round outline"


def test_a_bare_plate_shows_no_object() -> None:
    assert learn_object([np.full((*GRID.shape, 3), METAL, np.uint8)] * 4, GRID, EVERYWHERE) is None
