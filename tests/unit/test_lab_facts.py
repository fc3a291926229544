"""What the page knows is what the models say: fields, limits, units, presets."""

from __future__ import annotations

import json
import math

import pytest

from plategait.errors import InputError
from plategait.lab.facts import facts, fields
from plategait.lab.scenario_json import flat, plain_scenario
from plategait.model.motion import Wave
from plategait.model.parameters import find_parameter, parameters_of
from plategait.model.presets import PRESETS, preset
from plategait.model.scenario import Scenario
from plategait.units import parse

FACTS = facts()
FIELDS = list(fields())
NUMBERS = [field for field in FIELDS if field["kind"] == "number"]
OUTLINES = {
    "disk": {"shape": "disk", "radius": "40 mm"},
    "ellipse": {"shape": "ellipse", "length": "80 mm", "width": "60 mm"},
    "rectangle": {"shape": "rectangle", "length": "80 mm", "width": "60 mm"},
    "mask": {"shape": "mask", "width_of_picture": "40 mm", "rows": ["####"] * 4},
}


def scenario_with(shape: str) -> Scenario:
    """A scenario that has every part that may be left out."""
    waves = (Wave(axis="z", amplitude="1 mm"), Wave(axis="ry", amplitude="1 deg"))
    cheese = preset("cheese").scenario
    return cheese.replace(
        **{"sheet.outline": OUTLINES[shape], "motion.waves": waves, "plate": {"length": "1 m", "width": "1 m"},
           "transient": 1.0, "time_step": 5e-5}
    )  # fmt: skip


@pytest.mark.parametrize("shape", OUTLINES)
def test_every_number_of_a_scenario_is_a_field(shape):
    scenario = scenario_with(shape)
    plain = plain_scenario(scenario)[0]
    for name, parameter in parameters_of(scenario).items():
        starred = ".".join("*" if part.isdigit() else part for part in name.split("."))
        beside = (
            None if not starred.endswith(".amplitude") else plain["motion"]["waves"][int(name.split(".")[2])]["axis"]
        )
        of = [f for f in FIELDS if f["name"] == starred and (f["on"] is None or {shape, beside} & set(f["on"]))]
        assert len(of) == 1, name
        assert of[0]["unit"] == parameter.unit
        if parameter.quantity is not None:
            assert of[0]["example"] == parameter.quantity.example


def test_fields_are_told_apart_by_what_is_beside_them():
    told = [(f["name"], tuple(f["on"] or ())) for f in FIELDS]
    assert len(told) == len(set(told))
    assert all(f["description"] for f in FIELDS if not f["name"].endswith("shape"))


@pytest.mark.parametrize("field", NUMBERS, ids=lambda f: f"{f['name']} {f['on'] or ''}")
def test_factors_and_limits_are_those_of_the_model(field):
    assert math.isfinite(parse(field["example"], field["unit"]))
    if field["display"]:
        assert field["factor"] == pytest.approx(parse(f"1 {field['display']}", field["unit"]), rel=1e-15)
    limits = [field["above"], field["at_least"], field["at_most"]]
    assert all(limit is None or abs(limit) < 1e9 for limit in limits)
    if "*" in field["name"] or field["on"] or field["part"]:
        return
    quantity = find_parameter(field["name"], scenario_with("disk")).quantity
    assert quantity is not None
    for limit, beyond in ((field["above"], 0.0), (field["at_least"], -1e-3), (field["at_most"], 1e-3)):
        if limit is not None:
            with pytest.raises(InputError):
                quantity.read(limit + beyond, "x")


def test_defaults_are_those_of_the_model():
    plain = flat(plain_scenario(Scenario(sheet=preset("cheese").scenario.sheet))[0])
    for field in NUMBERS:
        if field["name"] in plain and not field["name"].startswith("sheet."):
            assert plain[field["name"]] == field["default"], field["name"]


@pytest.mark.parametrize("name", PRESETS)
def test_presets_are_those_of_the_package(name):
    told = FACTS["presets"][name]
    assert Scenario(**told["scenario"]) == preset(name).scenario
    known = {field["name"] for field in FIELDS}
    assert set(told["published"]) | set(told["inferred"]) <= known
    assert told["summary"] == preset(name).summary


def test_facts_are_plain_data_of_moderate_size():
    text = json.dumps(FACTS, allow_nan=False)
    assert json.loads(text) == FACTS
    assert len(text) < 60_000


def test_units_and_words_are_there():
    assert FACTS["units"]["mm"] == [1e-3, "m"]
    assert FACTS["gaits"] == ["sliding", "walking", "running"]
    assert {"slipped", "diverged"} < set(FACTS["failures"])
    assert [c["name"] for c in FACTS["channels"]][:2] == ["time", "centre_x"]
    assert FACTS["protocol"] == {"duration": 2.0, "transient": 0.6, "slip_limit": 0.02}
