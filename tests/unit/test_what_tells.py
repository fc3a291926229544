"""Functions take a preset's name, a file or a range where a scenario, a curve or frequencies are meant, or say so."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import plategait as pg
from plategait.curve.curve import Curve
from plategait.curve.curve_file import as_curve, write_curve
from plategait.curve.spin_curve import fit_curve
from plategait.errors import InputError
from plategait.model.presets import as_scenario
from plategait.model.scenario_file import write_scenario
from plategait.simulation.run import RunOptions, simulate_all

CHEESE = pg.preset("cheese").scenario
SHORT = CHEESE.replace(duration="0.1 s")


@pytest.fixture
def file(tmp_path) -> Path:
    (tmp_path / "short.toml").write_text(write_scenario(SHORT))
    return tmp_path / "short.toml"


@pytest.fixture
def curve_file(tmp_path) -> Path:
    f = np.array([14.0, 20.0, 25.0])
    measured = Curve("c", f, 520 / (1 + ((f - 25) / 5.2) ** 2), np.full(3, np.nan), ("",) * 3, ("",) * 3)
    write_curve(measured, tmp_path / "c.csv")
    return tmp_path / "c.csv"


def refused(call: Any, *given: Any, **named: Any) -> InputError:
    with pytest.raises(InputError) as caught:
        call(*given, **named)
    return caught.value


def test_what_tells_a_scenario(file):
    assert as_scenario("cheese") == as_scenario(pg.preset("cheese")) == as_scenario(CHEESE) == CHEESE
    assert as_scenario(file) == as_scenario(str(file)) == SHORT


@pytest.mark.parametrize("given", [None, 3, "chese", "Cheese", "", b"cheese", ["cheese"], {"name": "cheese"}])
def test_what_tells_none_is_refused_with_the_nearest_preset(given):
    error = refused(pg.simulate, given)
    assert error.field in ("scenario", "scenarios")
    assert "cheese" in error.hint
    assert "pancake" in error.allowed


def test_a_run_of_a_name_is_that_of_the_preset(file):
    by_file = pg.simulate(str(file), seed=3, repeats=2)
    assert by_file.scenario == SHORT
    assert [s.scenario for s in simulate_all([SHORT, file])] == [SHORT, SHORT]


def test_one_scenario_is_no_list_of_them():
    for given in ("cheese", CHEESE, pg.preset("cheese"), 3):
        assert refused(simulate_all, given).allowed == "a list of scenarios"
    assert refused(simulate_all, []).field == "scenarios"


def test_a_range_tells_frequencies():
    by_range = pg.spin_curve(SHORT, "20:24:2Hz")
    assert by_range.frequency_hz.tolist() == [20, 22, 24]
    assert pg.spin_curve(SHORT, ["20 Hz", 22, "24 hz"]).frequency_hz.tolist() == [20, 22, 24]
    assert refused(pg.spin_curve, SHORT, 24).field == "frequencies"
    assert refused(pg.spin_curve, SHORT, ["fast"]).field == "frequencies"
    assert "12:30:1Hz" in refused(pg.spin_curve, SHORT, "12-30").hint


def test_a_file_tells_a_curve(curve_file):
    assert fit_curve(str(curve_file)).no_fit == fit_curve(as_curve(curve_file)).no_fit
    assert "curve.csv" in refused(fit_curve, 3).hint
    assert refused(pg.estimate_parameters, "nofile.csv", "cheese").field == "curve"
    assert refused(pg.estimate_parameters, str(curve_file), "chese").hint == "cheese"


def test_an_estimate_of_files_is_that_of_what_they_hold(curve_file, monkeypatch):
    # What the posterior is sought of says it all: the same data, unknowns and seed give the same samples.
    sought = []

    def noted(*given, **named):
        sought.append((given, named))
        raise StopIteration

    monkeypatch.setattr("plategait.estimate.result.estimate_posterior", noted)
    known = {"noise": 0.05, "friction_ratio": 0.53, "fixed": "natural_frequency", "model_error": 0}
    for curves, scenario in ((str(curve_file), "cheese"), ([pg.read_curve(curve_file)], CHEESE)):
        with pytest.raises(StopIteration):
            pg.estimate_parameters(curves, scenario, **known)
    ((by_name, unknowns), named), ((by_value, others), also) = sought
    assert named == also
    assert unknowns == others
    for name in ("conditions", "notes", "readings", "handling"):
        assert getattr(by_name, name) == getattr(by_value, name)
    for name in ("which", "rate", "sd", "failed"):
        np.testing.assert_array_equal(getattr(by_name, name), getattr(by_value, name))


@pytest.mark.parametrize(
    ("named", "field"),
    [({"confidence": "high"}, "confidence"), ({"noise": "loud"}, "noise"), ({"free": "colour"}, "free"),
     ({"motions": []}, "motions")],
)  # fmt: skip
def test_options_of_an_estimate_are_checked_by_name(named, field, curve_file):
    assert refused(pg.estimate_parameters, curve_file, "cheese", **named).field == field


@pytest.mark.parametrize(("typed", "meant"), [("repeat", "repeats"), ("Seed", "seed"), ("snapshots", "snapshot")])
def test_a_misspelt_option_is_named_with_the_nearest(typed, meant):
    for call in (pg.simulate, lambda s, **named: pg.spin_curve(s, "20:24:2Hz", **named)):
        error = refused(call, SHORT, **{typed: 1})
        assert error.field == typed
        assert error.hint.startswith(meant)
        assert all(name in error.allowed for name in RunOptions.__annotations__)


def test_what_belongs_to_the_scenario_is_no_option():
    assert "scenario.replace" in refused(pg.simulate, "cheese", gravity=1.6).hint


def test_times_between_shapes_may_have_a_unit():
    by_text, by_number = (pg.simulate(SHORT, snapshot_interval=every) for every in ("20 ms", 0.02))
    assert by_text.recordings[0].snapshots.tolist() == by_number.recordings[0].snapshots.tolist()
    for given in ("fast", -1, float("nan")):
        assert refused(pg.simulate, SHORT, snapshot_interval=given).field == "snapshot_interval"
