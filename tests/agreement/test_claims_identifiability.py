"""The study of identifiability, small: the mass is not told, the bending helps, profiles are as wide as the bounds."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from plategait.study.questions import profiles
from plategait.study.questions.curves import CHEESE
from plategait.study.questions.identifiability import HEAVIER, excess, shortest_list, weakest
from plategait.study.questions.information import PARAMETERS, Slopes, changed, measure_variants, slopes_of
from plategait.study.questions.profiles import GRID, quadratic_terms
from plategait.study.runs import Runs

BASE = CHEESE.replace(duration=0.9, transient=0.4, slip_limit=0.02)
AT = [{"motion.frequency": f} for f in (15.0, 18.0, 22.0, 24.0)]


def test_mass_stiffness_and_viscosity_in_proportion_change_no_rate():
    heavier = changed(BASE, dict.fromkeys(PARAMETERS[:3], np.log(HEAVIER)))
    seen = Runs().measure([s.replace(**motion) for s in (BASE, heavier) for motion in AT]).means["spin_rate"]
    one, other = seen.reshape(2, -1)
    # As claimed: 2 % r.m.s., 1 % found.
    assert np.sqrt(np.mean((other / one - 1) ** 2)) < 0.02
    stiffer = changed(BASE, {"stiffness": 1.0}).replace(**AT[1])
    assert abs(Runs().measure([stiffer]).means["spin_rate"][0] / one[1] - 1) > 0.04


def test_the_weakest_combination_is_those_three_and_the_bending_helps():
    found = measure_variants(Runs(), BASE, AT, repeats=1, half_step=False).means
    rates, both = (slopes_of(found, len(AT), r) for r in (("spin_rate",), ("spin_rate", "bending_amplitude")))
    direction = weakest(both)[1]
    # 0.98 is found of many motions.
    assert abs(direction[:3].sum()) / np.sqrt(3) > 0.9
    assert both.bounds(0.01)[1:].max() < 0.7 * rates.bounds(0.01)[1:].max()


@pytest.mark.parametrize("seed", range(4))
def test_the_shortest_list_is_as_short_as_any(seed):
    values = np.random.default_rng(seed).normal(size=(9, 5))
    slopes = Slopes(values, np.full(9, 0.06), tuple((i, "spin_rate") for i in range(9)))
    chosen = shortest_list(slopes)
    assert excess(slopes, chosen) == 0
    shorter = combinations(range(9), len(chosen) - 1)
    assert all(excess(slopes, rows) > 0 for rows in shorter)


def test_profiles_of_a_linear_model_are_the_bounds(monkeypatch):
    """Readings whose logarithms are linear: the profile is a parabola of the bound's width."""
    jacobian = np.array([[1.0, 0.3, 0, 0], [0.2, 1.0, 0, 0], [0, 0, 1.0, 0.4], [0, 0, 0.1, 1.0], [0.5, 0.5, 0.5, 0]])
    coefficients = np.zeros((15, 5))
    coefficients[1:5] = jacobian.T
    noise = np.full(5, 0.1)
    assert quadratic_terms(np.zeros((1, 4))).shape == (1, 15)
    values = np.array([profiles._profile(coefficients, np.zeros(5), noise, i) for i in range(4)])
    found = profiles.Profiles(values, np.zeros(5))
    bounds = np.sqrt(np.diag(np.linalg.inv(jacobian.T @ jacobian / 0.01)))
    assert found.closed
    # The grid of 0.025 is followed linearly: a share of its step.
    assert found.sds == pytest.approx(bounds, rel=0.05)
    assert values[:, len(GRID) // 2] == pytest.approx(0.0, abs=1e-9)
