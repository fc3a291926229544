"""The study of gaits, small: what it claims of soft and rigid sheets fails here if it fails there."""

from __future__ import annotations

import math

import numpy as np

from plategait.simulation.expectation import expect
from plategait.simulation.stride import stride_row
from plategait.study.questions.gait import at_gamma, body, cheese, crossing, strangers
from plategait.study.runs import Runs


def test_where_legs_lift_follows_gamma_and_softness():
    gammas, sheets = np.arange(1.75, 7.1, 0.5), strangers(8, seed=5)
    points = [at_gamma(sheet, g) for sheet in sheets for g in gammas]
    duty = Runs().measure(points, measure=stride_row).means["duty"].reshape(len(sheets), -1)
    found = np.array([crossing(gammas, row, 0.99) for row in duty])
    told = [expect(at_gamma(s, g if math.isfinite(g) else 5.0)) for s, g in zip(sheets, found, strict=True)]
    law = np.array([each.sliding_ends if each else math.nan for each in told])
    assert np.isfinite(found).sum() >= 6
    # As claimed, 25 %; the grid is twice as coarse as the study's.
    assert np.nanstd(np.log(found / law)) < 0.25


def test_rigid_bodies_step_as_a_biped_does_and_only_the_soft_one_gains():
    bodies = ("soft", "rigid", "three legs")
    points = [at_gamma(body(name, 3.0), g) for name in bodies for g in (1.75, 3.0)]
    points.append(at_gamma(cheese(12.0), 5.0))
    seen = Runs().measure(points, measure=stride_row).means
    duty, turn, phase = (seen[name][:6].reshape(3, 2) for name in ("duty", "turn", "leg_phase"))
    # The rigid limit is 2.36: at 1.75 all touch, at 3 the rigid lift their halves and the soft one does not.
    assert (duty[:2, 0] > 0.99).all()
    assert duty[0, 1] > 0.99 > duty[1:, 1].max()
    assert np.abs(phase[1:, 1] - 0.5).max() < 0.15
    assert turn[0, 1] > 2 * turn[1, 1]
    assert turn[1, 1] < 1.25 * turn[1, 0]
    # Walking at 12 deg: a pendulum's exchange, 0.6 is found.
    assert 0.5 < seen["pendulum"][6] < 0.8
