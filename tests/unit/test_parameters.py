"""A scenario's numbers by name: found, read, set and read back; the shorthands; lists."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plategait.campaign.opened import open_sweep
from plategait.campaign.run import sweep
from plategait.errors import InputError
from plategait.model.motion import AXES, Wave
from plategait.model.parameters import SHORTHANDS, find_parameter, kinetic_follows, parameters_of, value_of, with_values
from plategait.model.presets import NOMINAL_NATURAL_FREQUENCY, preset
from plategait.model.scenario import Plate, Scenario
from plategait.units import show

CHEESE = preset("cheese").scenario
WAVES = [{"axis": "z", "amplitude": "1 mm"}, {"axis": "ry", "amplitude": "2 deg", "ratio": 2, "phase": "30 deg"}]
EVERYTHING = CHEESE.replace(
    **{"motion.waves": WAVES, "plate": Plate(), "transient": 1.0, "time_step": 1e-5,
       "sheet.outline": {"shape": "polygon", "corners": [[0, 0], [0.06, 0], [0.06, 0.06], [0, 0.06]]}}
)  # fmt: skip
NUMBERS = [name for name, parameter in parameters_of(EVERYTHING).items() if parameter.quantity]


@pytest.mark.parametrize("typed", ["10 pi rad/s", "3.5 pi rad/s", "5 Hz", "31 rad/s"])
def test_a_natural_frequency_is_told_as_it_was_typed(typed):
    parameter = find_parameter("natural_frequency")
    value = parameter.read(typed)
    assert parameter.text_of(value) == ("10 pi rad/s" if typed == "5 Hz" else typed)  # which are the same
    assert parameter.read(parameter.text_of(value)) == pytest.approx(value)


def floats_of(value: object, name: str = "") -> list[str]:
    """Every float inside a model, by dotted name, without asking what it measures."""
    if isinstance(value, float):
        return [name]
    if isinstance(value, tuple):
        inner = [(str(i), v) for i, v in enumerate(value)]
    else:
        inner = [(f, getattr(value, f)) for f in getattr(type(value), "model_fields", {})]
    return [n for part, v in inner for n in floats_of(v, f"{name}.{part}".lstrip("."))]


def test_every_number_of_a_scenario_is_found():
    assert sorted(NUMBERS) == sorted(floats_of(EVERYTHING))
    assert "sheet.outline.corners.1.0" in NUMBERS


@pytest.mark.slow
@settings(max_examples=100, deadline=None)
@given(st.sampled_from(NUMBERS), st.floats(0.9, 1.0))
def test_every_number_is_read_set_and_read_back(name, share):
    parameter = find_parameter(name, EVERYTHING)
    assert parameter.quantity is not None
    # So little less that nothing reaches a limit; what is 0 becomes so small that nothing else changes.
    wanted = share * (value_of(EVERYTHING, name) or 1e-9)
    value = parameter.read(show(wanted, parameter.unit, parameter.quantity.display))
    assert value == pytest.approx(wanted, rel=1e-9)  # text has ten digits
    made = with_values(EVERYTHING, {name: value})
    assert value_of(made, name) == value
    others = [other for other in NUMBERS if other != name]
    assert [value_of(made, n) for n in others] == [value_of(EVERYTHING, n) for n in others]


@pytest.mark.parametrize(
    ("name", "unit"),
    [("motion.waves.0.amplitude", "m"), ("motion.waves.1.amplitude", "rad"), ("motion.waves.1.phase", "rad"),
     ("sheet.outline.corners.2.1", "m"), ("time_step", "s"), ("friction_angle", "rad"), ("friction.law", "")],
)  # fmt: skip
def test_what_a_parameter_measures(name, unit):
    assert find_parameter(name, EVERYTHING).unit == unit


@pytest.mark.parametrize(
    ("name", "nearest"),
    [("freqency", "frequency"), ("motion.waves.2.phase", "motion.waves."), ("sheet.radius", "sheet.outline.radius"),
     ("motion.waves.phase", "motion.waves."), ("natural_freqency", "natural_frequency"), ("sheet.name", "sheet.")],
)  # fmt: skip
def test_an_unknown_name_gets_the_nearest(name, nearest):
    scenario = CHEESE.replace(**{"motion.waves": WAVES})
    for attempt in (find_parameter, lambda n, s: value_of(s, n)):
        with pytest.raises(InputError) as caught:
            attempt(name, scenario)
        assert nearest in caught.value.hint
        assert caught.value.field == name


@pytest.mark.parametrize(
    ("name", "value", "field"),
    [("motion.waves.2.phase", 0.1, "motion.waves.2"), ("motion.waves.x.phase", 0.1, "motion.waves.x"),
     ("motion.waves.1.phase", "3 mm", "motion.waves.1.phase"), ("motion.waves.0.amplitude", "3 deg", "amplitude"),
     ("motion.waves.1.ratio.0", 1.0, "motion.waves.1.ratio.0"), ("motion.waves.0.colour", 1.0, "colour")],
)  # fmt: skip
def test_what_cannot_be_set_in_a_list_is_named(name, value, field):
    with pytest.raises(InputError) as caught:
        with_values(EVERYTHING, {name: value})
    assert caught.value.field.startswith("motion.waves.")
    assert caught.value.field.endswith(field)


def test_nothing_is_inside_an_empty_list():
    with pytest.raises(InputError, match="no fields here"):
        CHEESE.replace(**{"motion.waves.0.phase": 1.0})


def test_shorthands_set_what_they_stand_for():
    made = with_values(CHEESE, {"natural_frequency": 20 * math.pi, "friction_angle": 0.5, "friction_ratio": 0.25})
    for name, wanted in (("natural_frequency", 20 * math.pi), ("friction_angle", 0.5), ("friction_ratio", 0.25)):
        assert value_of(made, name) == pytest.approx(wanted, rel=1e-9)  # an eigensolver's round-off
    kept = with_values(CHEESE, {"friction_angle": 0.5})
    assert kept.friction.ratio == pytest.approx(CHEESE.friction.ratio, rel=1e-15)


def test_a_nominal_frequency_scales_as_the_source_does():
    made = with_values(CHEESE, {"natural_frequency": 20 * math.pi}, NOMINAL_NATURAL_FREQUENCY)
    assert made.sheet.bending_stiffness == pytest.approx(4 * CHEESE.sheet.bending_stiffness, rel=1e-15)


def test_values_count_together_and_not_one_after_the_other():
    """A time step that the stiff sheet does not allow, with the frequency that makes it soft."""
    stiff = with_values(CHEESE, {"natural_frequency": 320 * math.pi})
    told = {"time_step": 1.3 * stiff.sheet.stable_time_step}
    with pytest.raises(InputError, match="time_step"):
        with_values(stiff, told)
    assert with_values(stiff, told | {"natural_frequency": 10 * math.pi}).dt == told["time_step"]


def test_kinetic_friction_follows_the_static_one_only_where_it_is_meant_to():
    assert with_values(CHEESE, {"friction.static": 0.5}).friction.kinetic == CHEESE.friction.kinetic
    followed = kinetic_follows({"friction.static": 0.5}, CHEESE)
    assert with_values(CHEESE, followed).friction.ratio == pytest.approx(CHEESE.friction.ratio, rel=1e-15)
    told = {"friction.static": 0.5, "friction.kinetic": 0.1}
    assert kinetic_follows(told, CHEESE) == told
    assert kinetic_follows({"duration": 1.0}, CHEESE) == {"duration": 1.0}


@pytest.mark.parametrize("pair", [("friction_angle", "friction.static"), ("friction_ratio", "friction.kinetic")])
def test_a_shorthand_beside_what_it_would_overwrite_is_refused(pair):
    with pytest.raises(InputError, match="left out"):
        with_values(CHEESE, dict.fromkeys(pair, 0.3))


def test_the_plainest_scenario_has_what_every_scenario_has():
    for name in SHORTHANDS:
        assert find_parameter(name).name == name
    assert find_parameter("sheet.bending_stiffness") == find_parameter("sheet.bending_stiffness", CHEESE)


def test_a_phase_is_swept(tmp_path):
    """A lift in phase and one against it change the spin; the store holds the phases in rad."""
    scenario: Scenario = CHEESE.replace(**{"motion.waves": WAVES[:1], "duration": 0.4})
    plan = {"scenario": scenario, "grid": {"motion.waves.0.phase": "0:270:90 deg"}}
    assert sweep(plan, tmp_path / "s.zarr").complete
    found = open_sweep(tmp_path / "s.zarr")
    phases = found.data["motion.waves.0.phase"]
    np.testing.assert_allclose(phases.values, np.radians([0, 90, 180, 270]), rtol=1e-15)
    assert phases.attrs["units"] == "rad"
    assert len(set(found.data["spin_rate"].values.ravel().tolist())) == 4


def test_the_in_plane_shear_stiffness_is_swept(tmp_path):
    """A plain number by its dotted name; each ratio is another sheet, and 1 is the sheet that does not name it."""
    scenario: Scenario = CHEESE.replace(duration=0.4)
    plan = {"scenario": scenario, "grid": {"sheet.shear_ratio": [1, 4, 8]}}
    assert sweep(plan, tmp_path / "s.zarr").complete
    found = open_sweep(tmp_path / "s.zarr")
    assert found.data["sheet.shear_ratio"].values.tolist() == [1, 4, 8]
    rates = found.data["spin_rate"].values.ravel().tolist()
    assert len(set(rates)) == 3
    unnamed = {**plan, "grid": {"motion.frequency": [scenario.motion.frequency]}}
    assert sweep(unnamed, tmp_path / "u.zarr").complete
    assert open_sweep(tmp_path / "u.zarr").data["spin_rate"].values.ravel().tolist() == rates[:1]


def test_everything_about_a_motion_is_a_parameter():
    motion = EVERYTHING.motion.replace(waves=(Wave(axis="rx", amplitude=0.1),))
    names = parameters_of(EVERYTHING.replace(motion=motion))
    wanted = {"frequency", "angle", "stroke", "height", "ramp", *(f"offset.{axis}" for axis in AXES)}
    wanted |= {f"waves.0.{name}" for name in ("axis", "amplitude", "ratio", "phase")}
    assert {name.removeprefix("motion.") for name in names if name.startswith("motion.")} == wanted
    made = with_values(EVERYTHING, {"motion.offset.rx": "2 deg", "motion.waves.1.phase": "90 deg"})
    assert made.motion.offset.pose[3] == pytest.approx(math.radians(2))
    assert made.motion.waves[1].phase == pytest.approx(math.pi / 2)
