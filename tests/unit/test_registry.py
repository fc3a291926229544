"""Observables by name: what may be one, and what several runs show together."""

import math
from importlib.metadata import EntryPoint

import numpy as np
import pytest

from plategait import InputError, Observable, add_observable, preset, simulate
from plategait.simulation import registry
from plategait.simulation.registry import all_observables, find_observable


@pytest.fixture(autouse=True)
def nothing_added(monkeypatch):
    monkeypatch.setattr(registry, "_added", {})


def area(window: registry.Window) -> float:
    return float(window.channels["area_z"][window.inside].mean())


AREA = Observable("flat_area", "1", "mean area seen from above over the area at rest", area, "area from above", "%")


@pytest.mark.parametrize("name", ["", "Flat", "flat area", "2nd", "contact", "gait", "drift"])
def test_a_name_that_could_not_be_a_column_or_is_taken_is_refused(name):
    with pytest.raises(InputError, match="observable"):
        add_observable(Observable(name, "1", "an area", area))


def test_units_must_measure_the_same():
    with pytest.raises(InputError, match=r"mm"):
        Observable("area", "rad", "an area", area, display="mm")
    with pytest.raises(InputError, match="function of a Window"):
        Observable("area", "1", "an area", 3)  # type: ignore[arg-type]


def test_an_added_one_is_measured_and_may_be_added_again():
    add_observable(AREA)
    add_observable(AREA)
    run = simulate(preset("cheese").scenario.replace(**{"motion.frequency": 14.0}), repeats=2)
    # A sheet that stays flat to a few degrees.
    assert 0.9 < run.value("flat_area") <= 1
    assert run.summary()["flat_area"] == run.value("flat_area")
    assert run.observations[0]["flat_area"] != run.observations[1]["flat_area"]


def test_one_that_cannot_be_measured_is_named():
    add_observable(Observable("ratio", "1", "nothing", lambda window: 1 / 0))
    with pytest.raises(InputError, match="observable ratio: got 'ZeroDivisionError"):
        simulate("cheese")


def test_over_runs():
    values, failed = [[1.0, -3.0, 2.0], [1.0, math.nan, 5.0]], [[False, True, False], [False, False, True]]
    mean = Observable("a", "1", "a", area)
    worst = Observable("b", "1", "b", area, over_runs="worst")
    assert mean.over(values, failed).tolist() == [1.5, 1.0]
    np.testing.assert_array_equal(worst.over(values, failed), [-3.0, math.nan])


def test_headings_tell_the_unit_that_people_read():
    assert [o.heading for o in all_observables().values() if o.label] == [
        "drift_mm", "velocity_x_mm_s", "velocity_y_mm_s", "contact_fraction",
        "flight_fraction", "bending_amplitude_deg", "rim_lift_mm", "plate_power_mW",
    ]  # fmt: skip
    assert find_observable("plate_power").key == "plate_power_mw"
    assert find_observable("plate_power").sd_heading == "plate_power_sd_mW"
    assert find_observable("contact_fraction").sd_heading == "contact_fraction_sd"
    assert find_observable("drift").scale == 1000.0
    with pytest.raises(InputError, match="try bending_amplitude"):
        find_observable("bending_amplitudes")


def test_a_plug_in_that_is_none_is_told_each_time(monkeypatch):
    wrong = EntryPoint("wrong", "math:pi", registry.GROUP)
    monkeypatch.setattr("importlib.metadata.entry_points", lambda group: [wrong])
    registry._installed.cache_clear()
    try:
        for _ in range(2):
            with pytest.raises(InputError, match="wrong: got 'math:pi', must be an Observable"):
                all_observables()
    finally:
        registry._installed.cache_clear()
