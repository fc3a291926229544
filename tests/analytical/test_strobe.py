"""Strides as a map: coordinates of known shapes, pushes that change one of them, multipliers of a linear map."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest

from plategait.model.presets import preset
from plategait.simulation.strobe import (
    COORDINATES,
    advance,
    apart,
    at_rest,
    coordinates,
    leading_pair,
    partings,
    pushed,
    stroboscopic,
)
from plategait.study.questions.strides import alternation, winding

SCENARIO = stroboscopic(preset("cheese").scenario.replace(**{"motion.frequency": 18.0}))


@pytest.mark.parametrize("name", COORDINATES)
def test_a_push_changes_one_coordinate(name):
    state = at_rest(SCENARIO)
    change = np.zeros(len(COORDINATES))
    change[COORDINATES.index(name)] = 0.02
    told = apart(coordinates(SCENARIO, state), coordinates(SCENARIO, pushed(SCENARIO, state, change)))
    # What is bent about the middle lifts its mean too; no other coordinate moves.
    assert told == pytest.approx(change, abs=1e-12)


@pytest.mark.parametrize("pair", [(0.6 + 0.7j, 0.6 - 0.7j), (-0.9, 0.5), (1.2, -0.4)])
def test_the_leading_pair_of_a_linear_map_is_found(pair):
    generator = np.random.default_rng(4)
    frame = generator.standard_normal((6, 6))
    inner = np.diag([0.0, 0.0, 0.2, 0.1, 0.05, 0.0])
    one, other = (complex(value) for value in pair)
    inner[:2, :2] = [[one.real, -one.imag], [one.imag, other.real]]
    linear = frame @ inner @ np.linalg.inv(frame)
    push, pushes, grown = generator.standard_normal(6), [], []
    for _ in range(24):
        pushes.append(push / np.linalg.norm(push))
        push = linear @ pushes[-1]
        grown.append(push)
    found = leading_pair(np.array(pushes)[None, 8:], np.array(grown)[None, 8:])
    assert sorted(found, key=cmath.phase) == pytest.approx(sorted(pair, key=lambda z: cmath.phase(z)), abs=1e-3)


def test_periods_add_up_and_twins_of_a_sliding_sheet_close_up():
    state = advance([SCENARIO], [at_rest(SCENARIO)], 12)
    twice, again = advance([SCENARIO], state, 2), advance([SCENARIO], advance([SCENARIO], state))
    assert twice[0][0] == pytest.approx(again[0][0], abs=1e-12)
    near, far = (partings([SCENARIO], state, size, periods=16, series=1)[0] for size in (3e-3, 6e-3))
    # A sheet that slides is as linear as friction lets it be: both distances tell the same.
    assert near.growth < -0.4
    assert near.growth == pytest.approx(far.growth, abs=0.1)
    # With one leading multiplier, growth is its logarithm.
    assert np.log(abs(near.multipliers[0])) == pytest.approx(near.growth, abs=0.1)


def test_every_other_stride_and_circles_are_told():
    n = np.arange(48)
    noise = 0.01 * np.random.default_rng(0).standard_normal((48, 3))
    doubled = noise + ((-1.0) ** n)[:, None] * np.array([1.0, 0.5, 0.0])
    circling = noise + np.column_stack([np.cos(math.tau * n / 3.6), np.sin(math.tau * n / 3.6), 0 * n])
    assert alternation(doubled) > 0.99
    assert alternation(circling) < 0.1
    assert winding(doubled) == pytest.approx(2.0, abs=0.02)
    assert winding(circling) == pytest.approx(3.6, abs=0.02)
