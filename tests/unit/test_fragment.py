"""Measured parameters with their uncertainty: to and from files, laid over scenarios, drawn from."""

from __future__ import annotations

import numpy as np
import pytest

from plategait.errors import InputError
from plategait.model.fragment import Fragment, fragment_text, overlay, read_fragment, write_fragment
from plategait.model.measured import Measured
from plategait.model.presets import preset

BENT = Measured(1.5e-4, 1.5e-5, 1.2e-4, 1.8e-4)
DAMPED = Measured(2.4e-7, 2.4e-8, 2e-7, 2.9e-7)
ROUGH = Measured(0.5, 0.02, 0.46, 0.54)
FRAGMENT = Fragment(
    {"sheet.bending_stiffness": BENT, "sheet.bending_damping": DAMPED, "friction.static": ROUGH},
    np.array([[1.0, 0.8, 0.0], [0.8, 1.0, 0.0], [0.0, 0.0, 1.0]]),
    source="made up",
)


def test_a_fragment_comes_back_from_its_file(tmp_path):
    write_fragment(FRAGMENT, tmp_path / "f.toml")
    back = read_fragment(tmp_path / "f.toml")
    for name, m in FRAGMENT.parameters.items():
        # Ten digits are written.
        assert back.parameters[name].value == pytest.approx(m.value, rel=1e-9)
        assert back.parameters[name].sd == pytest.approx(m.sd, rel=1e-9)
        assert (back.parameters[name].low, back.parameters[name].high) == pytest.approx((m.low, m.high), rel=1e-9)
    assert back.correlation == pytest.approx(FRAGMENT.correlation)
    assert back.source == "made up"


def test_it_is_laid_over_a_scenario_and_friction_keeps_its_ratio():
    cheese = preset("cheese").scenario
    laid = overlay(cheese, [FRAGMENT])
    assert laid.sheet.bending_stiffness == BENT.value
    assert laid.friction.static == 0.5
    assert laid.friction.ratio == pytest.approx(cheese.friction.ratio)
    assert laid.sheet.mass == cheese.sheet.mass


def test_draws_have_the_spread_and_correlation_that_were_kept():
    generator, cheese = np.random.default_rng(1), preset("cheese").scenario
    drawn = [FRAGMENT.draw(cheese, generator) for _ in range(1000)]
    k = np.log([s.sheet.bending_stiffness for s in drawn])
    c = np.log([s.sheet.bending_damping for s in drawn])
    mu = np.log([s.friction.static for s in drawn])
    # A thousand draws know a standard deviation to 2 % and a correlation of 0.8 to 0.01; three of those.
    assert np.std(k) == pytest.approx(np.log1p(0.1), rel=0.07)
    assert np.std(mu) == pytest.approx(np.log1p(0.04), rel=0.07)
    assert np.corrcoef(k, c)[0, 1] == pytest.approx(0.8, abs=0.04)


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("", "a file with parameters"),
        ("[sheet]\nweight = 3\n", "sheet.weight"),
        ("[shoe]\nsize = 3\n", "shoe.size"),
        ('[sheet]\nbending_stiffness = "3 N"\n', "sheet.bending_stiffness"),
        ('[sheet]\nbending_stiffness = "-1 N*mm/deg"\n', "sheet.bending_stiffness"),
        ("[sheet\n", "TOML"),
        ("sheet = 3\n", "sheet"),
        (fragment_text(FRAGMENT).replace("correlation = [[1,", "correlation = [[2,"), "correlation"),
    ],
)
def test_what_is_wrong_with_a_file_is_named(tmp_path, text, named):
    path = tmp_path / "f.toml"
    path.write_text(text)
    with pytest.raises(InputError, match=named):
        read_fragment(path)


def test_values_by_hand_are_taken_as_exact(tmp_path):
    path = tmp_path / "f.toml"
    path.write_text('[sheet]\nmass = "10 g"\n')
    fragment = read_fragment(path)
    assert fragment.parameters["sheet.mass"] == Measured(0.01, 0.0, 0.01, 0.01)
    assert fragment.draw(preset("cheese").scenario, np.random.default_rng(0)).sheet.mass == 0.01
