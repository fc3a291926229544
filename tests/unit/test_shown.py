"""Results show themselves in a few lines, without arrays, and draw themselves when asked."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
import pytest

import plategait as pg
from plategait.shown import MOST_LINES, Shown, in_short


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
