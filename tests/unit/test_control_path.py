"""Paths: figures, words and files as evenly spaced points; how near a trace comes to one; pulses along one."""

import math

import numpy as np
import pytest

from plategait.control.camera import PERFECT
from plategait.control.contour import ContourController
from plategait.control.drive import Drive
from plategait.control.follow import along, follow
from plategait.control.letters import strokes_of
from plategait.control.menu import Menu, drive_of
from plategait.control.path import STEP, check_path, figure_of_eight, path_of, read_path, word_path
from plategait.control.plant import Plant
from plategait.control.pulse import Pulses
from plategait.control.response import Field, Response
from plategait.control.room import on_a_plate
from plategait.errors import InputError
from plategait.model.machine import machine_of


def test_figure_of_eight_is_as_high_as_asked_and_crosses_itself():
    path = figure_of_eight(0.04)
    assert np.ptp(path.points, axis=0) == pytest.approx([0.02, 0.04], rel=1e-3)
    np.testing.assert_allclose(path.points[0], path.points[-1], atol=1e-12)
    np.testing.assert_allclose(path.points[len(path.points) // 2], 0, atol=STEP)
    assert np.linalg.norm(np.diff(path.points, axis=0), axis=1).max() <= STEP * (1 + 1e-9)


def test_words_are_strokes_of_their_letters_about_the_middle():
    strokes = strokes_of("Hi", 0.12)
    assert [len(stroke) for stroke in strokes] == [2, 2, 2, 2]
    every = np.concatenate(strokes)
    np.testing.assert_allclose(every.min(axis=0), -every.max(axis=0), atol=1e-12)
    path = word_path("L", 0.03)
    # Down by its height, and two thirds of that to the right.
    assert path.length == pytest.approx(0.05)
    assert path.drawn.all()
    assert word_path("H", 0.03).length == pytest.approx(0.08)
    assert len(word_path("H", 0.03).strokes) == 3
    with pytest.raises(InputError, match="A to Z"):
        word_path("Ü")


def test_every_letter_fits_its_box():
    for letter in "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-":
        every = np.concatenate(strokes_of(letter, 1.0))
        assert np.ptp(every, axis=0).max() <= 1.0
        assert np.ptp(every[:, 0]) <= 2 / 3 + 1e-12


def test_paths_of_files_have_the_strokes_that_they_tell(tmp_path):
    file = tmp_path / "path.csv"
    file.write_text("x_mm,y_mm,stroke\n0,0,1\n10,0,1\n10,10,2\n20,10,2\n")
    path = read_path(file)
    assert [len(stroke) for stroke in path.strokes] == [21, 21]
    assert path.length == pytest.approx(0.02)
    begun = path.begun_at(np.array([0.0, -0.01]))
    np.testing.assert_allclose(begun.points[0], [0.0, -0.01])
    assert begun.length == pytest.approx(0.02)
    with pytest.raises(InputError, match="as large"):
        check_path(path_of([np.array([[0, 0], [0.09, 0]])]), on_a_plate("cheese"))


def test_a_trace_beside_a_path_is_as_far_off_as_it_is():
    line = path_of([np.array([[0.0, 0.0], [0.05, 0.0]])])
    trace = np.column_stack([np.arange(0.0, 0.0501, 1e-3), np.full(51, 2e-3)])
    errors, nearest, farthest = along(line.points, trace)
    # Half a step of the trace and of the path beside 2 mm: 0.2 % at most, twice at the ends.
    np.testing.assert_allclose(np.concatenate([errors, nearest]), 2e-3, rtol=0.05)
    assert farthest.max() < 2.2e-3


def test_what_a_trace_skips_counts():
    eight = figure_of_eight(0.04)
    half = eight.points[: len(eight.points) // 2]
    errors, nearest, _ = along(eight.points, np.concatenate([half, eight.points[-1:]]))
    # It came by the crossing, where the other half begins and ends, but never near the middle of that half.
    assert errors[: len(half)].max() < 1e-3
    assert nearest.max() > 0.015
    errors, _, _ = along(eight.points, half, to_the_end=False)
    assert np.isfinite(errors).mean() == pytest.approx(0.5, abs=0.02)


def straight_menu(speeds: np.ndarray) -> Menu:
    """Motions that carry an object at constant speeds (m, 3), the first of them none."""
    cheese, field = on_a_plate("cheese"), Field()
    drive: Drive = drive_of(cheese, machine_of("source-robot"))
    rates = np.zeros((len(speeds), 3, len(field)))
    rates[:, :, 0] = speeds
    response = Response(rates, np.full((len(speeds), 3), 0.02), np.full((len(speeds), 3), 2e-4),
                        np.zeros(len(speeds), dtype=bool), field)  # fmt: skip
    return Menu(cheese, drive, (drive.base,) * len(speeds), np.zeros((len(speeds), len(drive))), response, 0.05)


def test_pulses_keep_to_the_path_and_skip_nothing():
    ways = np.array([[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1], [1, 1], [-1, 1], [1, -1], [-1, -1]])
    menu = straight_menu(np.column_stack([0.05 * ways, np.zeros(len(ways))]))
    pulses = Pulses(menu.response)
    eight = figure_of_eight(0.04)
    controller = ContourController(menu, pulses, eight)
    pose, trace = np.zeros(3), [np.zeros(2)]
    for _ in range(200):
        pulse, end = controller.plan(np.array([*pose, 0.0, 0.0, 0.0]))
        if controller.finished:
            break
        assert pulse > 0
        pose = end
        trace.append(pose[:2])
    assert controller.finished
    dense = path_of([np.array(trace)]).points
    errors, nearest, _ = along(eight.points, dense)
    # Moves of 3 mm and more that go straight keep within a millimetre or two of bends with a radius of 5 mm.
    assert math.sqrt(float((errors**2).mean())) < 1.5e-3
    assert nearest.max() < 3e-3


def test_a_path_that_no_motions_lead_along_is_refused():
    menu = straight_menu(np.array([[0, 0, 0], [0.05, 0, 0], [0, 0.05, 0], [0.05, 0.05, 0]]))
    plant = Plant([menu.scenario], camera=PERFECT)
    with pytest.raises(InputError, match="carry the object every way"):
        follow(plant, figure_of_eight(0.02), menu)
