"""The study of the stroke, small: what it claims of B_p fails here if it fails there."""

from __future__ import annotations

import math

import numpy as np

from plategait.simulation.expectation import expect
from plategait.simulation.stride import stride_row
from plategait.study.questions.gait import at_gamma, cheese
from plategait.study.questions.stroke import CANDIDATES, PUBLISHED_PEAK, STROKES, with_stroke
from plategait.study.runs import Runs


def test_the_spin_goes_with_the_stroke_unless_the_plate_is_slippery():
    names = ("as it is", "lag 60 deg", "smooth law", "no contact damping", "α = 1 deg")
    base = at_gamma(cheese(3.0), 4.5)
    points = [CANDIDATES[name][1](with_stroke(base, stroke)) for name in names for stroke in STROKES]
    spin = np.abs(Runs().measure(points, measure=stride_row).means["spin_rate"]).reshape(len(names), -1)
    powers = np.polyfit(np.log(STROKES), np.log(spin).T, 1)[0]
    assert (powers[:-1] > 0.7).all()
    assert abs(powers[-1]) < 0.25
    # A plate on which B_p does not matter spins nothing as fast as the source's.
    assert spin[-1].max() < PUBLISHED_PEAK / 3
    # The rim comes to 0.82 of the plate's speed, less at the smallest stroke.
    told = [expect(with_stroke(base, stroke)) for stroke in STROKES]
    share = spin[0] / [each.top_spin if each else math.nan for each in told]
    assert ((share > 0.7) & (share < 0.9)).all()
