"""What is said against a fitted peak that was not seen, and nothing against one that was."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from plategait.curve.curve import Curve
from plategait.curve.doubts import doubts
from plategait.curve.lorentz import lorentzian
from plategait.curve.spin_curve import fit_curve

F = np.arange(14.0, 31.0)


def curve(rate: np.ndarray, failed: np.ndarray | None = None) -> Curve:
    failure = ["slipped" if f else "" for f in (np.zeros(len(F), bool) if failed is None else failed)]
    return fit_curve(Curve("toy", F, rate, np.full(len(F), np.nan), ("",) * len(F), tuple(failure)))


def test_a_peak_that_was_seen_is_not_doubted():
    seen = curve(lorentzian(F, 520, 24, 5))
    assert seen.fit
    assert doubts(seen) == ()
    assert seen.fastest == (24.0, 520.0)


def test_a_curve_that_rises_to_the_run_off_shows_no_peak():
    risen = curve(lorentzian(F, 600, 25.3, 5), F > 25.5)
    assert risen.fit
    (only,) = doubts(risen)
    assert "still rises at 25 Hz" in only
    assert doubts(replace(risen, fit=None)) == ()


def test_a_line_above_all_that_was_measured_is_doubted():
    seen = curve(lorentzian(F, 520, 24, 5))
    assert seen.fit
    (only,) = doubts(replace(seen, fit=replace(seen.fit, peak=560.0)))
    assert "peaks at 560 deg/s, higher than anything measured (520 deg/s)" in only


def test_what_is_faster_beyond_failures_is_told():
    rate = lorentzian(F, 500, 22, 4)
    rate[-1] = 900
    beyond = curve(rate, (F > 25) & (F < 30))
    assert beyond.fit
    assert any("900 deg/s at 30 Hz" in doubt for doubt in doubts(beyond))
    assert beyond.fastest == (30.0, 900.0)


def test_another_shape_is_told_by_the_point_that_is_missed_most():
    rate = lorentzian(F, 500, 22, 4)
    rate[F == 19] *= 0.5
    off = curve(rate)
    assert off.fit
    assert any("misses the point at 19 Hz" in doubt for doubt in doubts(off))


def test_the_other_sense_of_rotation_is_the_same():
    there, back = (curve(sign * lorentzian(F, 600, 25.3, 5), F > 25.5) for sign in (1, -1))
    assert doubts(there) == doubts(back) != ()
