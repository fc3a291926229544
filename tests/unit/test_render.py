"""Films and strips: real files, in which what moves is seen to move."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import av
import numpy as np
import pytest
from PIL import Image

from plategait.errors import InputError
from plategait.model.outline import Mask, Rectangle
from plategait.model.presets import preset
from plategait.render import film, filmstrip
from plategait.render.painter import Painter
from plategait.simulation.observables import Failure
from plategait.simulation.run import simulate

SCENARIO = preset("cheese").scenario.replace(**{"motion.frequency": 12.0, "motion.angle": 0.2, "duration": 0.5})
SIZE = (320, 180)
FLAT_POSE = np.zeros(6)


@pytest.fixture(scope="module")
def simulation():
    return simulate(SCENARIO, snapshot_interval=2e-3)


def nodes_at(height: float = 0.0, turn: float = 0.0) -> np.ndarray:
    """Nodes of the flat sheet, lifted and turned."""
    x, y = SCENARIO.sheet.lattice.rest.T * SCENARIO.sheet.pitch
    return np.column_stack(
        [np.cos(turn) * x - np.sin(turn) * y, np.sin(turn) * x + np.cos(turn) * y, np.full(len(x), height)]
    )


def picture(nodes: np.ndarray) -> np.ndarray:
    return np.asarray(Painter(SCENARIO, FLAT_POSE[None], SIZE).picture(nodes, FLAT_POSE), dtype=int)


def middle_of(pixels: np.ndarray, colour: tuple[int, int, int]) -> np.ndarray:
    """Mean column and row of the pixels near a colour."""
    rows, columns = np.nonzero(np.abs(pixels - colour).max(axis=2) < 40)
    assert len(rows) > 5
    return np.array([columns.mean(), rows.mean()])


def test_the_film_is_h264_of_the_length_and_size_asked_for(simulation, tmp_path):
    path = film(simulation, tmp_path / "run.mp4", size=SIZE, seconds=0.5, fps=20)
    with av.open(str(path)) as container:
        stream = container.streams.video[0]
        assert stream.codec_context.name == "h264"
        assert stream.codec_context.pix_fmt == "yuv420p"
        frames = [frame.to_ndarray(format="rgb24").astype(int) for frame in container.decode(video=0)]
    assert len(frames) == 10
    assert frames[0].shape == (SIZE[1], SIZE[0], 3)
    # The plate tilts by up to 12 deg: successive frames differ over a good part of the picture.
    assert min(np.mean(np.abs(a - b).max(axis=2) > 20) for a, b in pairwise(frames)) > 0.01
    assert [p.name for p in tmp_path.iterdir()] == ["run.mp4"]


def test_the_markers_turn_with_the_sheet():
    # The rim marker lies towards +x at first, nearest to the camera and lowest. Half a turn takes it up.
    marker = (24, 66, 116)
    ahead, behind = (middle_of(picture(nodes_at(turn=turn)), marker) for turn in (0.0, np.pi))
    assert behind[1] < ahead[1] - 8
    left, right = (middle_of(picture(nodes_at(turn=turn)), marker) for turn in (-np.pi / 2, np.pi / 2))
    assert abs(left[0] - right[0]) > 15


def test_a_lifted_sheet_is_drawn_higher():
    sheet = (250, 196, 72)
    low, high = (middle_of(picture(nodes_at(height=h)), sheet) for h in (0.0, 0.02))
    assert high[1] < low[1] - 5


def test_the_plate_is_drawn_about_its_axis_below_the_surface():
    # Turned about an axis 50 mm below, the plate's middle moves sideways, and so does its picture.
    deep = SCENARIO.replace(**{"motion.height": 0.05})
    pose = np.array([0, 0, 0, 0.2, 0, 0.0])
    shifted = [
        np.asarray(Painter(s, FLAT_POSE[None], SIZE).picture(nodes_at(-1.0), pose), dtype=int) for s in (SCENARIO, deep)
    ]
    assert np.abs(shifted[0] - shifted[1]).max() > 30


def test_the_strip_has_its_panels(simulation, tmp_path):
    for panels in (4, 8):
        with Image.open(filmstrip(simulation, tmp_path / f"{panels}.png", panels=panels)) as strip:
            assert strip.width > 1900
            assert strip.height > 330 * (panels // 4)


@pytest.mark.parametrize(
    "outline",
    [
        Rectangle(length=0.09, width=0.04),
        Mask(width_of_picture=0.08, rows=("####....", "########", "########", "..####..")),
    ],
)
def test_other_outlines_are_drawn(outline, tmp_path):
    scenario = SCENARIO.replace(**{"sheet.outline": outline, "sheet.mass": 0.008, "duration": 0.2})
    simulation = simulate(scenario, snapshot_interval=2e-3)
    with Image.open(filmstrip(simulation, tmp_path / "s.png", panels=4)) as strip:
        assert (np.abs(np.asarray(strip, dtype=int) - (250, 196, 72)).max(axis=2) < 40).sum() > 5000


def test_a_run_that_diverged_is_drawn_up_to_there(simulation, tmp_path):
    shapes = simulation.recordings[0].snapshots.copy()
    shapes[len(shapes) * 3 // 4 :] = np.nan
    diverged = replace(simulation, recordings=(replace(simulation.recordings[0], snapshots=shapes),))
    with Image.open(filmstrip(diverged, tmp_path / "s.png", panels=4)) as strip:
        assert strip.width > 1900


def test_the_film_ends_where_the_run_was_observed_to_fail(simulation, tmp_path):
    # What the simulation says counts, not what could be read off the recording anew.
    observation = replace(simulation.observations[0], failure=Failure("slipped", 0.3))
    failed = replace(simulation, observations=(observation,))
    for observed, seconds in ((failed, 0.3), (simulation, 0.5)):
        path = film(observed, tmp_path / "run.mp4", size=SIZE, fps=20, slow_motion=1)
        with av.open(str(path)) as container:
            assert sum(1 for _ in container.decode(video=0)) == round(20 * seconds)


def test_what_cannot_be_filmed_is_refused_and_leaves_nothing(simulation, tmp_path):
    without = simulate(SCENARIO)
    with pytest.raises(InputError, match="snapshot_interval"):
        film(without, tmp_path / "a.mp4")
    for path in (tmp_path / "a.avi", tmp_path / "missing" / "a.mp4"):
        with pytest.raises(InputError):
            film(simulation, path)
    with pytest.raises(InputError, match="size"):
        film(simulation, tmp_path / "a.mp4", size=(321, 180))
    with pytest.raises(InputError, match="panels"):
        filmstrip(simulation, tmp_path / "a.png", panels=0)
    assert not list(tmp_path.iterdir())
