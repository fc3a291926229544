"""What a clip shows beside turning: edges, form and lift on made data, velocity, leaving, and their columns."""

from __future__ import annotations

import math
from pathlib import Path

import cv2
import numpy as np
import pytest

from plategait.curve.curve import Curve
from plategait.curve.curve_file import read_curve, write_curve
from plategait.estimate.size import seen_size, sized_by_film
from plategait.model.presets import preset
from plategait.vision.departure import departure_of
from plategait.vision.findings import outline_middle
from plategait.vision.object.form import fit_form
from plategait.vision.object.pose import Pose
from plategait.vision.object.rim import DIRECTIONS, RAYS, find_rim, learn_rim, marked_parts, marks_fit, spots_on_it
from plategait.vision.plate.rectified import Grid
from plategait.vision.velocity import local_velocity, velocity_of

GRID = Grid((433, 433), 2.5e-4, (-0.054, 0.054))
EVERYWHERE = np.ones(GRID.shape, np.uint8)
METAL, CHEESE, BLUE = (200, 128, 128), (190, 60, 150), (60, 180, 110)
TIME = np.arange(90) / 30


def picture(
    middle: tuple[float, float] = (0.004, -0.006), radius: float = 0.03, spot: float | None = None
) -> np.ndarray:
    """Disk on a plate, with soft edges, and a spot of another colour at a share of its radius to the right."""
    fine = np.full((4 * GRID.shape[0], 4 * GRID.shape[1], 3), METAL, np.uint8)
    for place, r, colour in ((middle, radius, CHEESE), ((middle[0] + (spot or 0) * radius, middle[1]), 3e-3, BLUE)):
        if colour == CHEESE or spot is not None:
            at = (GRID.pixels(np.array(place)) + 0.5) * 4 - 0.5
            cv2.circle(
                fine, np.round(at * 16).astype(int).tolist(), round(r / GRID.pitch * 64), colour, -1, cv2.LINE_AA, 4
            )
    return cv2.resize(fine, GRID.shape, interpolation=cv2.INTER_AREA)


def test_an_edge_is_found_all_around_finer_than_a_pixel() -> None:
    middle = np.array([0.004, -0.006])
    rim = learn_rim([picture()] * 4, GRID, EVERYWHERE, [middle] * 4)
    assert rim is not None
    begin = middle + np.array([2e-3, 0])
    seen = find_rim(rim, picture(spot=0.85), GRID, EVERYWHERE, begin)
    # A spot beside the edge leaves its colour on one side of it: its own rays are a pixel off at most.
    off = begin + seen[:, None] * np.stack([np.cos(DIRECTIONS), np.sin(DIRECTIONS)], axis=-1) - middle
    error = np.linalg.norm(off, axis=1) - 0.03
    assert np.median(np.abs(error)) < 0.1 * GRID.pitch
    assert np.abs(error).max() < GRID.pitch
    where, area = outline_middle(begin[None], seen[None])
    np.testing.assert_allclose(where[0], middle, atol=0.2 * GRID.pitch)
    assert area[0] == pytest.approx(math.pi * 0.03**2, rel=0.005)
    hidden = EVERYWHERE.copy()
    hidden[:, : GRID.shape[1] // 2] = 0
    assert np.isnan(find_rim(rim, picture(), GRID, hidden, middle)).mean() == pytest.approx(0.4, abs=0.12)


def test_an_object_of_the_plates_colour_has_no_edge() -> None:
    plain = np.full((*GRID.shape, 3), METAL, np.uint8)
    assert learn_rim([plain] * 4, GRID, EVERYWHERE, [None] * 4) is None


@pytest.mark.parametrize(
    ("offset", "spacing", "fits"), [(0.002, 0.024, True), (0.015, 0.02, False), (0.0, 0.008, False)]
)
def test_marks_lie_in_the_middle_and_near_the_rim(offset: float, spacing: float, fits: bool) -> None:
    pose = Pose(0.004 + offset, -0.006, 0.0, "", spacing)
    parts = marked_parts([picture()] * 3, [pose] * 3, GRID, EVERYWHERE)
    assert marks_fit(parts, [pose] * 3, GRID) is fits


def test_spots_are_counted_on_the_object_alone() -> None:
    pose = Pose(0.004, -0.006, 0.0, "", 0.024)
    parts = marked_parts([picture()] * 3, [pose] * 3, GRID, EVERYWHERE)
    on_it, beside_it = [[0.004, -0.006], [0.02, -0.006], [0.004, 0.01]], [[0.046, -0.006], [0.004, 0.04], [9.0, 9.0]]
    for spots, count in ((on_it, 3), (beside_it, 0), (on_it + beside_it, 3), ([], 0)):
        places = [np.array(spots).reshape(-1, 2)] * 3
        assert spots_on_it(parts, places, GRID) == count


def seen_rims(lift: float, thickness: float = 2e-3, radius: float = 0.03) -> tuple[np.ndarray, ...]:
    """Edges of an oval sheet that turns and lifts both sides in turns, exactly as they fall on the plate's plane."""
    angle = 2.0 * TIME
    eye = np.tile([0.12, -0.11, 0.27], (len(TIME), 1))
    psi = np.linspace(0, 2 * math.pi, 2880, endpoint=False)
    phase = 2 * math.pi * 11 * TIME
    mark = eye[:, :2] + (0.001 - eye[:, :2]) * (0.27 / (0.27 - thickness))
    rims = np.empty((len(TIME), RAYS))
    for i in range(len(TIME)):
        h = lift * np.sin(psi) ** 2 * (1 + np.sin(phase[i]) * np.sign(np.sin(psi))) / 2
        flat = radius * (1 + 0.04 * np.cos(2 * (psi - angle[i]))) - 2 * h**2 / (3 * radius)
        at = 0.001 + flat[:, None] * np.stack([np.cos(psi), np.sin(psi)], axis=-1)
        edges = [eye[i, :2] + (at - eye[i, :2]) * (0.27 / (0.27 - z))[:, None] - mark[i] for z in (h, h + thickness)]
        # What is seen against the plate is the hull of both edges: the farther one in each direction.
        far = [np.interp(DIRECTIONS, *_sorted(e), period=2 * math.pi) for e in edges]
        rims[i] = np.maximum(*far)
    return angle, mark, rims, eye, phase


def _sorted(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    direction = np.arctan2(points[:, 1], points[:, 0]) % (2 * math.pi)
    order = np.argsort(direction)
    return direction[order], np.hypot(*points.T)[order]


@pytest.mark.linear_algebra
@pytest.mark.parametrize("lift", [0.0, 6e-3])
def test_form_thickness_and_lift_are_parted(lift: float) -> None:
    angle, mark, rims, eye, phase = seen_rims(lift)
    noise = 1e-4 * np.random.default_rng(0).normal(size=rims.shape)
    form = fit_form(angle, mark, rims + noise, eye, phase, 2.5e-4, marked=True)
    assert form is not None
    # Data that the model is made for, but for the sign function's harmonics: a tenth of the lift.
    assert form.radius == pytest.approx(0.03 * math.sqrt(1 + 0.04**2 / 2), abs=2e-4)
    assert abs(form.radius - 0.03) < 2 * form.radius_sd
    assert np.ptp(form.outline) == pytest.approx(2 * 0.04 * 0.03, rel=0.2)
    assert form.thickness == pytest.approx(2e-3, abs=1e-3)
    assert form.rim_lift == pytest.approx(lift, abs=0.7e-3)
    assert abs(form.rim_lift - lift) < 2 * form.rim_lift_sd
    for reason, other in (
        ("frequency", {"phase": None}),
        ("part of the plate's swing", {"phase": 0.3 * np.sin(phase)}),
        ("mark", {"marked": False}),
        ("place is unknown", {"eye": None}),
        ("straight", {"eye": eye * (0.1, 0.1, 1)}),
    ):
        given = {"eye": eye, "phase": phase, "marked": True} | other
        told = fit_form(angle, mark, rims, given["eye"], given["phase"], 2.5e-4, marked=given["marked"])
        assert told is not None
        assert math.isnan(told.rim_lift)
        assert reason in told.lift_unknown
    assert fit_form(angle[:8], mark[:8], rims[:8], eye[:8], phase[:8], 2.5e-4, marked=True) is None


def test_a_velocity_is_that_of_the_middle_without_the_swing() -> None:
    noise = 1e-4 * np.random.default_rng(1).normal(size=(90, 2))
    swing = 1e-3 * np.sin(2 * math.pi * 11 * TIME)
    place = np.stack([3e-3 * TIME + swing, -2e-3 * TIME], axis=1) + noise
    v = velocity_of(TIME, place, 11.0, 30.0)
    # Noise of 0.1 mm over 90 frames in 3 s: 0.01 mm/s, and t of eight blocks of it.
    assert v.x == pytest.approx(3e-3, abs=1e-4)
    assert abs(v.x - 3e-3) < v.x_half < 1e-3
    assert abs(v.y + 2e-3) < v.y_half < 1e-3
    assert math.isnan(velocity_of(TIME[:5], place[:5], 11.0, 30.0).x)
    slope, half = local_velocity(TIME, place[:, 1])
    assert np.nanmean(slope) == pytest.approx(-2e-3, rel=0.2)
    assert np.isnan(slope[:3]).any()
    assert np.nanmedian(half) < 1e-3


@pytest.mark.parametrize(
    ("name", "kind"),
    [("stays", ""), ("wanders", ""), ("slips", "slipped"), ("slides off", "left the plate"), ("is hidden", ""),
     ("is lost while it moves away", "left the plate")],
)  # fmt: skip
def test_what_becomes_of_an_object(name: str, kind: str) -> None:
    away = {
        "stays": 0 * TIME, "wanders": 5e-3 * TIME, "slips": 0.03 * np.clip(TIME - 1, 0, 1),
        "slides off": 0.05 * np.clip(TIME - 1, 0, None), "is hidden": 0 * TIME,
        "is lost while it moves away": 0.04 * np.clip(TIME - 1, 0, None),
    }[name]  # fmt: skip
    place = np.stack([away, 0.002 * np.sin(20 * TIME)], axis=1)
    place[40] += 0.05  # a single wrong one
    last = {"slides off": 0.03, "is lost while it moves away": 0.016}.get(name, math.inf)
    place[away > last] = math.nan
    if name == "is hidden":
        place[45:] = math.nan
    found = departure_of(TIME, place, 0.03, (0.1, 0.1))
    assert found.kind == kind
    if kind:
        # It has slipped by 20 mm, or is last seen, then; places are averaged over 0.15 s.
        assert found.time == pytest.approx(float(TIME[np.argmax(away > min(0.02, last))]), abs=0.1)
    else:
        assert math.isnan(found.time)


def filmed(radius: float, sd: float = 2e-4) -> Curve:
    n = 3
    return Curve(
        "film", np.array([14.0, 20.0, 25.0]), np.array([20.0, 60.0, 40.0]), np.full(n, 1.0), ("",) * n, ("",) * n,
        values={"rim_lift": np.array([1e-3, math.nan, 2e-3]), "velocity_x": np.zeros(n)},
        value_sds={"rim_lift": np.array([1e-4, math.nan, 2e-4])},
        of_object={"radius": radius + np.array([0, 1e-4, -1e-4]), "radius_sd": np.full(n, sd),
                   "area": np.full(n, math.pi * radius**2), "area_sd": np.full(n, 1e-5)},
    )  # fmt: skip


def test_what_a_film_shows_comes_back_from_its_curve(tmp_path: Path) -> None:
    curve = filmed(0.038)
    write_curve(curve, tmp_path / "curve.csv")
    heading = (tmp_path / "curve.csv").read_text().splitlines()[0]
    for column in ("rim_lift_mm", "rim_lift_sd_mm", "velocity_x_mm_s", "radius_mm", "radius_sd_mm", "area_mm^2"):
        assert column in heading.split(",")
    again = read_curve(tmp_path / "curve.csv")
    for kind in ("values", "value_sds", "of_object"):
        for name, values in getattr(curve, kind).items():
            np.testing.assert_allclose(getattr(again, kind)[name], values, rtol=1e-9)
    assert again.notes == ()


def test_an_estimate_takes_the_radius_from_the_film_unless_told() -> None:
    base = preset("cheese").scenario
    seen = seen_size([filmed(0.036)])
    assert seen is not None
    assert seen.radius == pytest.approx(0.036)
    assert seen.sd == pytest.approx(2e-4, rel=0.01)
    other, curves = sized_by_film(base, [filmed(0.036)], told=False)
    assert other.sheet.outline.size()[0] == pytest.approx(0.072)
    assert other.sheet.pitch == pytest.approx(base.sheet.pitch * 0.9)
    assert "36.00" in curves[0].notes[-1]
    assert "--radius" in curves[0].notes[-1]
    # One that is told stands, and so does one that the film agrees with.
    same, curves = sized_by_film(base, [filmed(0.036)], told=True)
    assert same is base
    assert curves[0].notes[-1].startswith("warning")
    same, curves = sized_by_film(base, [filmed(0.0402)], told=False)
    assert same is base
    assert "agrees" in curves[0].notes[-1]
    _, curves = sized_by_film(base, [filmed(0.036), filmed(0.039)], told=False)
    assert any("one object" in note for note in curves[0].notes)
    nothing = Curve("bare", np.array([14.0]), np.array([20.0]), np.array([1.0]), ("",), ("",))
    assert sized_by_film(base, [nothing], told=False) == (base, [nothing])
