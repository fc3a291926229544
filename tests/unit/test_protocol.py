"""How a spin curve is measured."""

from __future__ import annotations

import pytest

from plategait.curve.protocol import REGENERATED, USUAL, Protocol, measured_as
from plategait.model.presets import preset
from plategait.thesis.cases import Case

CHEESE = preset("cheese").scenario


@pytest.mark.parametrize("protocol", [USUAL, REGENERATED, Protocol(3.0, 1.0, 0.005)])
def test_a_scenario_is_run_as_the_protocol_says_and_is_otherwise_itself(protocol):
    measured = measured_as(CHEESE, protocol)
    assert Protocol(measured.duration, measured.transient, measured.slip_limit) == protocol
    own = {"duration": CHEESE.duration, "transient": CHEESE.transient, "slip_limit": CHEESE.slip_limit}
    assert measured.replace(**own) == CHEESE


def test_half_of_a_short_run_is_measured():
    assert measured_as(CHEESE, Protocol(duration=0.8)).transient == 0.4


def test_the_dissertation_is_regenerated_by_its_protocol():
    scenario = Case(3, 10.0).scenario
    assert measured_as(scenario, REGENERATED) == scenario
