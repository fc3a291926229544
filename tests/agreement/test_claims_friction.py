"""The study of friction, small: β and V count in slow sliding, and slow rates with β tell α where b/f0 does not."""

from __future__ import annotations

import numpy as np

from plategait.study.questions import friction
from plategait.study.questions.curves import CHEESE, at_frequencies
from plategait.study.questions.friction import BEST, FORMS, THESIS, features, left_out, objects, rms
from plategait.study.runs import Runs

SHORT = CHEESE.replace(duration=1.0, transient=0.4)


def test_beta_counts_in_sliding_and_not_at_the_peak():
    laws = [SHORT.friction.with_ratio(beta) for beta in (0.2, 1.0)]
    scenarios = at_frequencies([SHORT.replace(friction=law) for law in laws], (16.0, 24.0))
    slow, peak = Runs().measure(scenarios).means["spin_rate"].reshape(2, 2).T
    # As claimed: more than half, and less than 15 %; +128 and −9 % are found.
    assert slow[1] / slow[0] > 1.5
    assert abs(peak[1] / peak[0] - 1) < 0.15


def test_slow_rates_tell_alpha_and_the_width_does_not(monkeypatch):
    monkeypatch.setitem(FORMS, BEST, (("slow", "beta"), 1))  # fourteen objects are few for a quadratic
    scenarios = [s.replace(duration=1.0, transient=0.4) for s in objects(14)]
    columns = Runs().measure(at_frequencies(scenarios)).means
    seen = features(columns, scenarios)
    told = {form: rms(left_out(seen, scenarios, form)) for form in (THESIS, BEST)}
    # As claimed 2 and 5 deg; 1.1 and 8 are found, of twice as many. A third by chance would be the objects' own 9.
    assert told[BEST] < 2.5
    assert told[THESIS] > 4


def test_the_wandering_is_as_wide_as_it_says():
    alphas = np.degrees([s.friction.angle for s in friction.wandering(2)])
    assert 3 < np.ptp(alphas) / 2 <= friction.WANDER
    assert len(set(alphas.round(6))) == len(alphas)
