"""Peaks that are there are found, and none is found where there is none: curves made up by strangers."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from plategait.curve.curve import Curve
from plategait.curve.lorentz import LorentzFit, fit_lorentzian, lorentzian
from plategait.curve.peak import anywhere, unseen_peak, unseen_top
from plategait.curve.quick_lorentz import fit_shape
from plategait.curve.spin_curve import fit_curve
from plategait.errors import InputError
from plategait.plots.figures import plot_curve

pytestmark = pytest.mark.linear_algebra

# Eight points that rise to 84 deg/s: the line that fits them best peaks at 337 deg/s between the last two.
RISING = np.arange(5.0, 13.0)
SPIKE = lorentzian(RISING, 337.0, 11.6, 0.23)

seeds = st.integers(0, 2**32 - 1)
steps = st.floats(0.2, 3.0)
sizes = st.floats(1e-2, 1e4).flatmap(lambda size: st.sampled_from([size, -size]))
many = settings(deadline=None, max_examples=60)


def accepted(frequency, rate, ends_in_failure=False) -> LorentzFit | None:
    try:
        return fit_lorentzian(frequency, rate, ends_in_failure=ends_in_failure)
    except InputError as refused:
        if refused.allowed != "a curve that shows its peak":
            raise
        return None


@many
@given(
    size=sizes, step=steps, width=st.floats(1.6, 8.0), left=st.floats(1.2, 3.0), right=st.floats(1.2, 3.0),
    share=st.floats(0.0, 0.03), shift=st.floats(0.0, 1.0), seed=seeds,
)  # fmt: skip
def test_a_true_peak_that_is_well_sampled_is_found(size, step, width, left, right, share, shift, seed):
    # Half widths of 1.6 steps and more, flanks of 1.2 half widths and more, noise up to 3 % of the peak.
    below, above = math.ceil(left * width + 2), math.ceil(right * width + 2)
    frequency = 10.0 + step * (np.arange(below + above) + 1)
    f0, half_width = frequency[below] - shift * step, width * step
    noise = np.random.default_rng(seed).normal(0, share * abs(size), len(frequency))
    rate = lorentzian(frequency, size, f0, half_width) + noise
    fit = accepted(frequency, rate)
    assert fit is not None
    # Six standard deviations of the noise, for which one half width is worst off: 3 % of it over √3 points.
    assert fit.f0_hz == pytest.approx(f0, abs=(6 * share + 1e-4) * half_width)
    fast = fit_shape(frequency, rate * np.sign(size))
    assert fast is not None
    assert fast.f0_hz == pytest.approx(fit.f0_hz, abs=1e-3 * half_width)


@many
@given(size=sizes, step=steps, rises=st.lists(st.floats(0.0, 1.0), min_size=4, max_size=15), falling=st.booleans())
def test_what_only_rises_or_only_falls_has_no_peak(size, step, rises, falling):
    rate = size * (0.1 + np.cumsum(rises))
    assume(rate[0] != rate[-1])
    frequency = 10.0 + step * np.arange(len(rate))
    if falling:
        rate = rate[::-1]
    assert accepted(frequency, rate) is None
    assert fit_shape(frequency, np.abs(rate)) is None
    assert unseen_top(frequency, rate)
    # An object that ran off excuses a curve that rises, not one that falls.
    assert not falling or accepted(frequency, rate, ends_in_failure=True) is None


@pytest.mark.slow
@settings(deadline=None, max_examples=25)
@given(
    size=sizes, heights=st.lists(st.floats(0.0, 0.1), min_size=4, max_size=15), gaps=st.lists(steps, min_size=16),
    place=st.floats(0.0, 1.0), failure=st.booleans(),
)  # fmt: skip
def test_a_single_high_point_is_no_peak(size, heights, gaps, place, failure):
    rate = size * np.array(heights)
    frequency = 10.0 + np.cumsum(gaps[: len(rate)])
    rate[int(place * (len(rate) - 1))] = size
    assert accepted(frequency, rate, failure) is None
    assert fit_shape(frequency, np.abs(rate), ends_in_failure=failure) is None


@pytest.mark.slow
@pytest.mark.parametrize("failure", [False, True])
def test_noise_on_a_level_is_hardly_ever_a_peak(failure):
    # The test that a level does as well is one of 1 %; of peaks anywhere, some more pass it.
    rng = np.random.default_rng(3)
    found = [accepted(np.arange(12.0, 27.0), 100 + rng.normal(0, 5, 15), failure) for _ in range(60)]
    assert sum(fit is not None for fit in found) <= 2
    assert accepted(np.arange(12.0, 27.0), 100 + 1e-3 * np.sin(np.arange(15.0) ** 2), failure) is None


@pytest.mark.parametrize("failure", [False, True])
def test_a_spike_between_two_samples_is_no_peak(failure):
    noise = np.random.default_rng(0).normal(0, 1, 8)
    for rate in (SPIKE, SPIKE + noise, np.sort(SPIKE + noise)):
        assert accepted(RISING, rate, failure) is None
        assert fit_shape(RISING, rate, ends_in_failure=failure) is None
    assert "half width 0.23 Hz at 11.6 Hz with none" in str(
        unseen_peak(RISING, SPIKE, 11.6, 0.23, ends_in_failure=True)
    )


@pytest.mark.parametrize("failure", [False, True])
@pytest.mark.parametrize("step", [0.5, 1.0, 2.0])
def test_a_peak_beyond_the_data_is_not_found(failure, step):
    frequency = np.arange(10.0, 20.1, step)
    for f0 in (21.2, 24.0, 9.0):
        assert accepted(frequency, lorentzian(frequency, 500.0, f0, 4.0), failure) is None


def test_a_curve_may_end_at_its_peak_where_the_object_ran_off():
    frequency = np.arange(9.0, 13.1, 0.5)
    for f0 in (12.8, 13.2):  # half an interval beyond the last sample at most
        rate = lorentzian(frequency, 350.0, f0, 3.0)
        assert accepted(frequency, rate) is None or f0 < 13
        fit = accepted(frequency, rate, ends_in_failure=True)
        assert fit is not None
        assert fit.f0_hz == pytest.approx(f0, rel=1e-6)


@settings(deadline=None, max_examples=40)
@given(seed=seeds, width=st.floats(0.3, 30.0), f0=st.floats(8.0, 24.0), share=st.floats(0.0, 0.3))
def test_what_is_found_is_bounded_by_the_data(seed, width, f0, share):
    frequency = np.arange(10.0, 21.0)
    rate = lorentzian(frequency, 500.0, f0, width) + np.random.default_rng(seed).normal(0, 500 * share, 11)
    fit = accepted(frequency, rate)
    if fit is not None:
        assert np.isfinite([*fit.peak_interval, *fit.half_width_interval]).all()
        assert fit.half_width_interval[0] > 0
        assert 9.5 <= fit.f0_interval[0] <= fit.f0_interval[1] <= 20.5
        assert 10 <= fit.f0_hz <= 20


def test_a_refused_peak_is_said_everywhere():
    failure = ("",) * 8 + ("slipped",) * 3
    frequency, rate = np.append(RISING, [13, 14, 15]), np.append(SPIKE, [math.nan] * 3)
    curve = fit_curve(Curve("rising", frequency, rate, np.full(11, math.nan), ("",) * 11, failure))
    assert curve.fit is None
    assert "half width" in curve.no_fit
    summary = json.loads(json.dumps(curve.summary(), allow_nan=False))
    assert {summary[key] for key in ("f0_hz", "half_width_hz", "peak_deg_s", "r2", "f0_hz_interval")} == {None}
    assert summary["no_fit"] == curve.no_fit
    words = plot_curve(curve).axes[0].get_title(loc="left").replace("\n", " ")
    assert "no Lorentz fit" in words
    assert "adding frequencies" in words
    assert not any("Lorentz fit (5.5)" in str(line.get_label()) for line in plot_curve(curve).axes[0].get_lines())


@pytest.mark.parametrize(
    ("low", "high", "said"),
    [
        (20.04, 31.0, "anywhere from 20.04 to 31 Hz"),
        (20.04, math.inf, "anywhere from 20.04 Hz on"),
        (-math.inf, 31.0, "anywhere up to 31 Hz"),
        (-math.inf, math.inf, "at any frequency"),
    ],
)
def test_an_end_that_nothing_bounds_goes_without_words(low, high, said):
    assert anywhere(low, high, digits=4) == said
