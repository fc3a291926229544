"""Results show themselves in a few lines, without arrays, and draw themselves when asked."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from types import SimpleNamespace

import numpy as np
import pytest
from legible import assert_legible

import plategait as pg
from plategait.control.follow import Following, along
from plategait.control.goal import Goal
from plategait.control.pair_figures import plot_pair
from plategait.control.pair_reach import PairReach
from plategait.control.path import Path
from plategait.control.steer import Arrival, Steering
from plategait.shown import MOST_LINES, Shown, in_short
from plategait.vision.spin import Spin
from plategait.vision.track import Track


@pytest.fixture(scope="module")
def simulation() -> pg.Simulation:
    scenario = pg.preset("cheese").scenario.replace(duration="0.4 s")
    return pg.simulate(scenario, repeats=2)


@pytest.fixture(scope="module")
def curve() -> pg.Curve:
    return pg.spin_curve(pg.preset("cheese").scenario.replace(duration="0.3 s"), [18, 20, 22, 24])


def results(simulation: pg.Simulation, curve: pg.Curve) -> list[object]:
    sheet = simulation.scenario.sheet
    return [
        simulation, simulation.recordings[0], simulation.observations[0], curve, sheet.free_modes,
        sheet.free_modes.natural, pg.preset("cheese"),
        pg.needs(simulation.scenario.motion, pg.machine_of("source-robot")),
    ]  # fmt: skip


def test_a_result_takes_a_few_lines(simulation, curve):
    for result in results(simulation, curve):
        lines = repr(result).splitlines()
        assert len(lines) <= MOST_LINES + 1, result
        assert max(map(len, lines)) <= 100, result


def test_what_a_person_asks_first_is_there(simulation, curve):
    assert f"{np.degrees(simulation.spin_rate):.1f} deg/s" in repr(simulation)
    assert simulation.gait in repr(simulation)
    assert "2 of 0.4 s" in repr(simulation)
    assert "4 from 18 to 24 Hz" in repr(curve)


def test_a_notebook_gets_a_table_and_a_picture(simulation, curve):
    for result in (simulation, curve):
        html = result._repr_html_()
        assert html.startswith("<table><caption>")
        assert "data:image/png;base64," in html
        assert len(html) < 300_000


def test_names_stay_text_in_a_notebook(simulation):
    hostile = simulation.scenario.replace(name="<script>alert(1)</script>")
    shown = pg.Simulation(hostile, simulation.recordings, simulation.observations, "cpu", 0, 0.1)
    assert "<script>" not in shown._repr_html_()


def test_a_result_draws_itself(simulation, curve):
    for result in (simulation, curve):
        assert result.plot().axes


def test_a_way_to_goals_draws_itself():
    time = np.linspace(0.0, 2.0, 60)
    poses = np.stack([0.02 * time, 0.01 * time, time], axis=1)
    goals = [Goal(0.02, 0.01, 1.0), Goal(0.06, 0.02)]
    aims = np.where(time[:, None] < 1, goals[0].pose, goals[1].pose)
    arrivals = (
        Arrival(goals[0], True, 1.0, 0.001, 0.02, 3, ""),
        Arrival(goals[1], False, math.nan, 0.02, 0.1, 4, "out of time"),
    )
    figure = Steering(arrivals, time, poses, poses, aims, ()).plot()
    assert_legible(figure)
    names = [text.get_text() for text in figure.legends[0].get_texts()]
    assert {"goal, reached", "goal, not reached"} <= set(names)
    assert "3 mm and 5 deg" in figure.get_suptitle()


def a_way(to: Goal, reached: bool) -> Steering:
    time = np.linspace(0.0, 2.0, 60)
    poses = np.outer(time / 2, [to.x, to.y, 1.0]) + 0.001 * np.sin(40 * time)[:, None]
    arrival = Arrival(to, reached, 1.5, 0.001, 0.02, 3, "" if reached else "out of time")
    return Steering((arrival,), time, poses, poses, np.tile(to.pose, (60, 1)), ())


def test_a_way_along_a_path_draws_itself_and_tells_how_near_it_stayed():
    points = np.linspace((0.0, 0.0), (0.02, 0.01), 50)
    path, way = Path(points, np.arange(50) >= 10), a_way(Goal(0.02, 0.01), True)
    followed = Following(path, way, *along(points, way.poses[:, :2]))
    figure = followed.plot()
    assert_legible(figure)
    assert {"path", "start"} <= {text.get_text() for text in figure.legends[0].get_texts()}
    assert "mm r.m.s." in repr(followed)
    assert "reached" in repr(followed)


def test_two_sheets_on_one_plate_are_told_by_their_dash_and_their_goals_by_their_mark():
    places = np.linspace(-0.04, 0.04, 5)
    times = np.full((5, 5, 12), 3.0)
    times[0, 0] = np.inf
    scenario = pg.preset("cheese").scenario
    ways = a_way(Goal(0.02, 0.01), True), a_way(Goal(-0.05, -0.03), False)
    figure = plot_pair(PairReach(places, np.full((5, 5), 6), times), ways, scenario)
    assert_legible(figure)
    drawn = [line for line in figure.axes[1].get_lines() if str(line.get_label()).startswith("way of")]
    assert len({line.get_linestyle() for line in drawn}) == 2
    names = {text.get_text() for text in figure.legends[0].get_texts()}
    assert {"goal, reached", "goal, not reached"} <= names


def test_a_clip_draws_itself():
    time, sure = np.arange(60) / 30, np.arange(60) % 7 != 0
    spin = Spin(math.radians(250), math.radians(240), math.radians(260), True, 0.1)
    found = SimpleNamespace(departure=SimpleNamespace(drift=0.004, kind="slipped"))
    x, y, angle = 0.001 * time, -0.002 * time, spin.rate * time + 1
    clip = Track("a_$b.mp4", time, x, y, angle, sure, sure, ("",) * 60, "markers", 1, 30.0, SimpleNamespace(), 12.0,
                 spin, found)  # type: ignore[arg-type]  # fmt: skip
    figure = clip.plot()
    assert_legible(figure)
    said = " ".join([figure.get_suptitle(), *(axes.get_title(loc="left") for axes in figure.axes)])
    for words in ("51 of 60 frames sure", "12 Hz", "250.0 deg/s [240.0, 260.0]", "slipped, drift 4 mm"):
        assert words in said
    line = max(figure.axes[0].get_lines(), key=lambda each: each.get_linestyle() == "--")
    assert np.ptp(line.get_ydata()) / np.ptp(line.get_xdata()) == pytest.approx(250)
    assert "data:image/png" in clip._repr_html_()
    without = replace(clip, spin=Spin(math.nan, math.nan, math.nan, False, math.nan, reason="too few sure frames"))
    assert "too few" in without.plot().axes[0].get_title(loc="left")


def test_a_notebook_shows_a_figure_without_pyplot(curve):
    # Its own formatter is there only once pyplot was imported.
    assert curve.plot()._repr_png_().startswith(b"\x89PNG")


def test_what_nobody_draws_says_so(simulation):
    with pytest.raises(AttributeError, match="Recording has no picture"):
        simulation.recordings[0].plot()


def test_long_values_are_told_by_their_size():
    assert in_short(np.zeros((3, 4))) == "float64 array (3, 4)"
    assert in_short(tuple(range(100))) == "100 × int"
    assert in_short({str(k): k for k in range(99)}) == "99 by name"
    assert len(in_short("x" * 500)) <= 70


def test_many_fields_are_cut():
    names = [f"field_{k}" for k in range(40)]
    many = dataclass(frozen=True, repr=False)(type("Many", (Shown,), {"__annotations__": dict.fromkeys(names, "int")}))
    assert re.search(r"… +30 more$", repr(many(*range(40))))  # type: ignore[call-arg]


def test_a_scenario_with_a_long_trajectory_stays_short():
    samples = pg.Samples(time=tuple(np.arange(5000) / 100), x=tuple(np.zeros(5000)))
    scenario = pg.preset("cheese").scenario.replace(**{"motion.samples": samples})
    assert "time=(5000 …)" in repr(scenario)
    assert len(repr(scenario)) < 2500
