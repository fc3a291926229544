"""Outlines and the grid squares inside them."""

from __future__ import annotations

import math
from typing import get_args

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

from plategait.errors import InputError
from plategait.model.outline import MOST_CORNERS, Disk, Ellipse, Mask, Outline, Polygon, Rectangle, occupied_squares
from plategait.model.sheet import Sheet

DISK_ROWS = [4, 6, 8, 8, 8, 8, 6, 4]
TRIANGLE = ((0.0, 0.0), (0.06, 0.0), (0.0, 0.06))
L_SHAPE = ((0.0, 0.0), (0.06, 0.0), (0.06, 0.02), (0.02, 0.02), (0.02, 0.06), (0.0, 0.06))
LEAF = (".##.", "####", "####", ".#..")
SHAPES = {
    "disk": Disk(radius=0.04),
    "ellipse": Ellipse(length=0.08, width=0.05),
    "rectangle": Rectangle(length=0.07, width=0.05),
    "triangle": Polygon(corners=TRIANGLE),
    "L": Polygon(corners=L_SHAPE),
    "mask": Mask(width_of_picture=0.04, rows=LEAF),
}
AREAS = {
    "disk": math.pi * 0.04**2,
    "ellipse": math.pi * 0.08 * 0.05 / 4,
    "rectangle": 0.07 * 0.05,
    "triangle": 0.06**2 / 2,
    "L": 0.06**2 - 0.04**2,
    "mask": 11 * 0.01**2,
}
PERIMETERS = {
    "disk": 0.08 * math.pi,
    "ellipse": 2 * math.pi * 0.04,  # of the circle about it, which is longer
    "rectangle": 0.24,
    "triangle": 0.12 + 0.06 * math.sqrt(2),
    "L": 0.24,
    "mask": 16 * 0.01,
}


def test_every_outline_is_held_to_its_area():
    assert {type(outline) for outline in SHAPES.values()} == set(get_args(get_args(Outline)[0]))
    assert SHAPES.keys() == AREAS.keys() == PERIMETERS.keys()


@pytest.mark.parametrize("name", SHAPES)
def test_a_field_of_an_outline_is_named_as_it_was_typed(name):
    wanted = {"outline": SHAPES[name].fields_with({}) | {"colour": "red"}}
    with pytest.raises(InputError) as caught:
        Sheet(mass=0.01, bending_stiffness=1e-4, axial_stiffness=800.0, **wanted)
    assert caught.value.field == "outline.colour"


def rows_of(squares: np.ndarray) -> list[int]:
    return squares.sum(axis=0).tolist()


def test_the_reference_disk_has_its_rows():
    squares = occupied_squares(Disk(radius="40 mm"), 0.01)
    assert rows_of(squares) == DISK_ROWS
    assert squares.sum() == 52
    for turned in (squares.T, squares[::-1], squares[:, ::-1]):
        assert (turned == squares).all()


@pytest.mark.parametrize("scale", [1e-3, 0.1, 1.05, 3.7, 1e2])
def test_only_the_ratio_of_size_and_pitch_matters(scale):
    assert rows_of(occupied_squares(Disk(radius=0.04 * scale), 0.01 * scale)) == DISK_ROWS


def test_a_rectangle_is_full():
    squares = occupied_squares(Rectangle(length="60 mm", width="30 mm"), 0.01)
    assert squares.shape == (6, 3)
    assert squares.all()


def test_an_ellipse_is_a_stretched_disk():
    squares = occupied_squares(Ellipse(length="160 mm", width="80 mm"), 0.01)
    assert squares.shape == (16, 8)
    assert (squares == squares[::-1]).all()
    assert (squares == squares[:, ::-1]).all()
    assert rows_of(squares)[0] < rows_of(squares)[3] == 16


def test_a_polygon_keeps_its_notch():
    squares = occupied_squares(Polygon(corners=L_SHAPE), 0.01)
    expected = np.zeros((6, 6), dtype=bool)
    expected[:, :2] = expected[:2, :] = True
    assert (squares == expected).all()


@pytest.mark.parametrize("name", ["triangle", "L"])
@pytest.mark.parametrize("pitch", [0.01, 0.006, 0.005, 0.002])
def test_the_sense_and_first_corner_of_a_polygon_do_not_matter(name, pitch):
    corners = SHAPES[name].corners
    expected = occupied_squares(Polygon(corners=corners), pitch)
    for same in (corners[::-1], corners[1:] + corners[:1], corners[2:] + corners[:2]):
        assert (occupied_squares(Polygon(corners=same), pitch) == expected).all()


@pytest.mark.parametrize("pitch", [0.01, 0.005, 0.002])
def test_a_polygon_alike_in_x_and_y_stays_so(pitch):
    # Middles of squares lie on the slanted edge; they must all fall to the same side of it.
    squares = occupied_squares(Polygon(corners=TRIANGLE), pitch)
    assert (squares == squares.T).all()
    n = round(0.06 / pitch)
    assert squares.sum() in (n * (n - 1) // 2, n * (n + 1) // 2)


def test_a_polygon_may_lie_anywhere():
    moved = tuple((x + 0.37, y - 1.21) for x, y in L_SHAPE)
    assert (occupied_squares(Polygon(corners=moved), 0.004) == occupied_squares(SHAPES["L"], 0.004)).all()


def test_a_polygon_that_touches_itself_in_a_point_is_two_pieces():
    bow_tie = Polygon(corners=((0, 0), (0.08, 0.08), (0.08, 0), (0, 0.08)))
    with pytest.raises(InputError, match="2 separate pieces") as caught:
        occupied_squares(bow_tie, 0.01)
    assert caught.value.field == "outline"


def test_a_polygon_that_runs_along_itself_is_one_piece():
    # A square with a hole, drawn in one stroke: there and back along a cut of no width.
    corners = ((0, 0), (0.06, 0), (0.06, 0.06), (0, 0.06), (0, 0),
               (0.02, 0.02), (0.02, 0.04), (0.04, 0.04), (0.04, 0.02), (0.02, 0.02))  # fmt: skip
    squares = occupied_squares(Polygon(corners=corners), 0.01)
    expected = np.ones((6, 6), dtype=bool)
    expected[2:4, 2:4] = False
    assert (squares == expected).all()


def test_a_mask_from_rows_is_what_it_looks_like():
    mask = Mask(width_of_picture="40 mm", rows=LEAF)
    assert mask.size() == pytest.approx((0.04, 0.04), rel=1e-14)
    squares = occupied_squares(mask, 0.01)
    assert ["".join("#" if s else "." for s in row) for row in squares.T[::-1]] == list(LEAF)


def test_the_ground_around_a_mask_is_cut_off():
    bare, framed = ("##.", "###"), (".....", "..##.", "..###", ".....")
    a = Mask(width_of_picture="30 mm", rows=bare)
    b = Mask(width_of_picture="50 mm", rows=framed)
    assert b.size() == pytest.approx(a.size(), rel=1e-14)
    assert (occupied_squares(a, 0.005) == occupied_squares(b, 0.005)).all()


def picture(tmp_path, kind: str):
    """A leaf of 30 × 20 pixels in a picture of 60 × 40, with a stem of 10 pixels at its upper right."""
    leaf = np.zeros((40, 60), dtype=bool)
    leaf[10:30, 15:45] = True
    leaf[5:10, 40:42] = True
    if kind == "transparent":  # white on nothing: only the transparency tells
        pixels = np.where(leaf[..., None], 255, 0).repeat(4, axis=2).astype(np.uint8)
        image = Image.fromarray(pixels, "RGBA")
    else:
        image = Image.fromarray(np.where(leaf, 0, 255).astype(np.uint8))
        image = image.convert({"gray": "L", "one bit": "1", "palette": "P", "colour": "RGB"}[kind])
    path = tmp_path / f"{kind}.png"
    image.save(path)
    return path


@pytest.mark.parametrize("kind", ["gray", "one bit", "palette", "colour", "transparent"])
def test_a_mask_from_a_picture(tmp_path, kind):
    mask = Mask(width_of_picture="60 mm", image=str(picture(tmp_path, kind)))
    assert mask.size() == pytest.approx((0.03, 0.025), rel=1e-14)
    squares = occupied_squares(mask, 0.001)
    assert squares.shape == (30, 25)
    assert squares.sum() == 30 * 20 + 2 * 5
    assert squares[25:27, 20:].all(), "the top row of the picture is the far side of the sheet"


@pytest.mark.parametrize("spoil", ["text", "half", "empty", "missing", "folder"])
def test_a_picture_that_cannot_be_read_is_refused(tmp_path, spoil):
    path = picture(tmp_path, "gray")
    if spoil == "text":
        path.write_text("no picture")
    elif spoil == "half":
        path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    elif spoil == "empty":
        path.write_bytes(b"")
    elif spoil == "missing":
        path.unlink()
    else:
        path = tmp_path
    with pytest.raises(InputError, match="a picture file that can be read") as caught:
        Mask(width_of_picture="60 mm", image=path)
    assert caught.value.field == "image"


def test_a_picture_beyond_the_reader_is_refused(tmp_path, monkeypatch):
    path = picture(tmp_path, "gray")
    monkeypatch.setattr(Image, "MAX_IMAGE_PIXELS", 100)  # Pillow refuses pictures twice as large
    with pytest.raises(InputError) as caught:
        Mask(width_of_picture="60 mm", image=path)
    assert caught.value.field == "image"


@pytest.mark.parametrize(
    "fields",
    [{"rows": ("..", "..")}, {"rows": ("",)}, {"rows": ("##", "###")}, {}, {"rows": 5}, {"rows": "##"}, {"image": 5},
     {"rows": ("##",), "image": "leaf.png"}],
    ids=["nothing dark", "empty row", "ragged", "neither", "number", "bare text", "image a number", "both"],
)  # fmt: skip
def test_a_mask_of_the_wrong_kind_is_refused(fields):
    with pytest.raises(InputError) as caught:
        Mask(width_of_picture="60 mm", **fields)
    assert caught.value.field in ("rows", "image")
    assert "Value error" not in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_white_picture_is_refused(tmp_path):
    Image.new("L", (8, 8), 255).save(tmp_path / "white.png")
    with pytest.raises(InputError, match="a dark object on a light ground"):
        Mask(width_of_picture="60 mm", image=tmp_path / "white.png")


@settings(deadline=None)
@given(name=st.sampled_from(sorted(SHAPES)), pitch=st.floats(2e-4, 4e-3))
def test_the_area_converges_to_the_outline(name, pitch):
    squares = occupied_squares(SHAPES[name], pitch)
    # Only squares that the edge crosses can count wrong. They lie within half a diagonal of it on either side, and the
    # grid's own extent may miss the outline's by half a pitch all around.
    band = PERIMETERS[name] * pitch * (math.sqrt(2) + 0.5) + 8 * pitch**2
    assert squares.sum() * pitch**2 == pytest.approx(AREAS[name], abs=band)


@settings(deadline=None)
@given(radius=st.floats(1e-3, 1.0), across=st.floats(1.2, 60))
def test_a_disk_of_any_size_is_alike_all_around(radius, across):
    squares = occupied_squares(Disk(radius=radius), 2 * radius / across)
    for turned in (squares.T, squares[::-1], squares[:, ::-1]):
        assert (turned == squares).all()


@settings(deadline=None)
@given(x=st.lists(st.floats(-0.05, 0.05), min_size=3, max_size=7), data=st.data(), pitch=st.sampled_from([0.01, 0.003]))
def test_any_polygon_gives_one_piece_or_an_input_error(x, data, pitch):
    y = data.draw(st.lists(st.floats(-0.05, 0.05), min_size=len(x), max_size=len(x)))
    try:
        squares = occupied_squares(Polygon(corners=tuple(zip(x, y, strict=True))), pitch)
    except InputError as error:
        assert error.field in ("corners", "outline", "pitch")  # noqa: PT017 - either outcome is right
    else:
        assert squares.any()


def test_too_coarse_a_pitch_is_refused_with_one_that_works():
    # The middle of the bounding box lies outside the L.
    with pytest.raises(InputError, match="fine enough") as caught:
        occupied_squares(SHAPES["L"], 0.05)
    assert caught.value.field == "pitch"
    assert occupied_squares(SHAPES["L"], Disk(radius=caught.value.hint.strip('"')).radius).any()


@pytest.mark.parametrize("pitch", [1e-9, 1e-5, 1e-4, 1e-320])
def test_too_fine_a_pitch_is_refused_with_one_that_works(pitch):
    with pytest.raises(InputError, match="coarse enough") as caught:
        occupied_squares(Disk(radius=0.04), pitch)
    assert caught.value.field == "pitch"
    assert occupied_squares(Disk(radius=0.04), Disk(radius=caught.value.hint.strip('"')).radius).sum() > 1000


def test_more_corners_than_are_drawn_are_refused():
    turns = np.arange(MOST_CORNERS + 1) * 2 * math.pi / (MOST_CORNERS + 1)
    corners = tuple((0.04 * math.cos(t), 0.04 * math.sin(t)) for t in turns)
    with pytest.raises(InputError, match="at most 1000") as caught:
        Polygon(corners=corners)
    assert caught.value.field == "corners"
    assert Polygon(corners=corners[1:]).size()[0] == pytest.approx(0.08, rel=1e-4)


def test_separate_pieces_are_refused():
    for rows in (("#.#",), ("##..", "##..", "..##", "..##")):
        with pytest.raises(InputError, match="2 separate pieces") as caught:
            occupied_squares(Mask(width_of_picture=0.01 * len(rows[0]), rows=rows), 0.01)
        assert caught.value.field == "outline"


def test_the_finer_pitch_suggested_for_pieces_is_finer():
    # A thin slanted strip falls apart on a coarse grid only.
    strip = Polygon(corners=((0, 0), (0.008, 0), (0.08, 0.08), (0.072, 0.08)))
    with pytest.raises(InputError) as caught:
        occupied_squares(strip, 0.0099)
    suggested = float(caught.value.hint.split('"')[1].removesuffix(" mm")) / 1e3
    assert suggested < 0.0099 * 0.999


@pytest.mark.parametrize(
    "corners",
    [((0, 0), (0.1, 0.1)), ((0, 0), (0.1, 0), (0.2, 0)), ((0, 0), (0.04, 0.04), (0.08, 0.08)), ((0.1, 0.1),) * 3, ()],
    ids=["two", "on the axis", "on a slant", "one point", "none"],
)
def test_a_polygon_without_area_is_refused(corners):
    with pytest.raises(InputError, match="span an area") as caught:
        Polygon(corners=corners)
    assert caught.value.field == "corners"


@pytest.mark.parametrize("corners", ["abc", 5, ((0, 0, 0), (1, 0, 0), (0, 1, 0)), ((0, 0), (1, math.nan), (1, 1))])
def test_corners_of_the_wrong_kind_are_refused(corners):
    with pytest.raises(InputError) as caught:
        Polygon(corners=corners)
    assert caught.value.field.startswith("corners")
    assert "must be Tuple" not in str(caught.value)


@pytest.mark.parametrize("make", [lambda r: Disk(radius=r), lambda r: Ellipse(length=r, width=1), lambda r: Rectangle(
    length=1, width=r)])  # fmt: skip
@pytest.mark.parametrize("bad", [0, -1, math.nan, math.inf, None, "3 deg", True])
def test_sizes_must_be_positive_lengths(make, bad):
    with pytest.raises(InputError):
        make(bad)


def test_contains_takes_the_corners_as_the_polygon_says():
    inside = SHAPES["triangle"].contains(np.array([-0.02, 0.02]), np.array([-0.02, 0.02]))
    assert inside.tolist() == [True, False]
