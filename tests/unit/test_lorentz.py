"""The Lorentz fit of a spin curve: what it recovers, how sure it says it is, and what it refuses."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.stats import binom, norm

from plategait.curve.lorentz import first_guess, fit_lorentzian, lorentzian
from plategait.errors import InputError

pytestmark = pytest.mark.linear_algebra

FREQUENCY = np.arange(16.0, 31.0)
CUT_OFF = np.arange(7.0, 13.1, 0.5)  # A_p = 12 deg: the disk drifts off right after its peak
NAN, INF = float("nan"), float("inf")
TINY = 1e-12  # rounding of a handful of operations

peaks = st.floats(1e-3, 1e4).flatmap(lambda size: st.sampled_from([size, -size]))
centres = st.floats(16.6, 29.4)  # the highest rate is not at an end
half_widths = st.floats(4.0, 12.0)


def noisy(rng, frequency, peak, f0, half_width, share):
    """The line with normal noise of `share` of its peak."""
    return lorentzian(frequency, peak, f0, half_width) + share * abs(peak) * rng.normal(size=len(frequency))


def test_the_line_peaks_at_f0_and_is_half_as_high_a_half_width_away():
    # Powers of two: exact in floating point.
    np.testing.assert_array_equal(lorentzian([20.0, 24.0, 28.0], 512.0, 24.0, 4.0), [256.0, 512.0, 256.0])


@given(peak=peaks, f0=st.floats(14.0, 32.0), half_width=half_widths)
def test_the_first_guess_is_exact_on_an_exact_curve(peak, f0, half_width):
    guess = first_guess(FREQUENCY, lorentzian(FREQUENCY, peak, f0, half_width))
    # A linear 3 x 3 least-squares problem whose condition number stays under 1e6: 1e-16 * 1e6 with a margin of 100.
    np.testing.assert_allclose(guess, (peak, f0, half_width), rtol=1e-8)


def test_the_first_guess_falls_back_on_the_largest_rate():
    assert first_guess([10, 12, 14, 16, 18], [1.0, 0.5, 0.5, 0.5, 2.0]) == (2.0, 18.0, 2.0)


@settings(deadline=None)  # the first fit imports scipy.optimize
@given(peak=peaks, f0=centres, half_width=half_widths)
def test_recovers_the_parameters_of_an_exact_curve(peak, f0, half_width):
    fit = fit_lorentzian(FREQUENCY, lorentzian(FREQUENCY, peak, f0, half_width))
    # Levenberg-Marquardt stops where a step changes the sum of squares by less than 1e-8, its root by 1e-4 at most; the
    # steps converge quadratically, so that the last one leaves far less than the 1e-6 asked here.
    np.testing.assert_allclose((fit.peak, fit.f0_hz, fit.half_width_hz), (peak, f0, half_width), rtol=1e-6)
    assert fit.r2 == pytest.approx(1, abs=1e-10)
    np.testing.assert_allclose(fit(FREQUENCY), lorentzian(FREQUENCY, fit.peak, fit.f0_hz, fit.half_width_hz))


@settings(deadline=None, max_examples=20)
@given(scale=st.floats(1e-3, 1e3), seed=st.integers(0, 2**32 - 1))
def test_the_unit_of_the_rates_and_the_order_of_the_points_do_not_matter(scale, seed):
    rng = np.random.default_rng(seed)
    rate = noisy(rng, FREQUENCY, 600, 25, 5, 0.03)
    order = rng.permutation(len(FREQUENCY))
    one, other = fit_lorentzian(FREQUENCY, rate), fit_lorentzian(FREQUENCY[order], -scale * rate[order])
    assert other.peak == pytest.approx(-scale * one.peak, rel=1e-6)  # as above
    # Ends are sought to 1e-4 of their distance from the estimate, which is under a tenth of the values.
    np.testing.assert_allclose(other.f0_interval, one.f0_interval, rtol=1e-4)
    np.testing.assert_allclose(other.half_width_interval, one.half_width_interval, rtol=1e-4)
    np.testing.assert_allclose(np.sort(np.multiply(other.peak_interval, -1 / scale)), one.peak_interval, rtol=1e-4)


def test_agrees_with_lmfit():
    lmfit = pytest.importorskip("lmfit")
    rate = noisy(np.random.default_rng(5), CUT_OFF, 380, 12.8, 3.0, 0.02)
    fit = fit_lorentzian(CUT_OFF, rate, ends_in_failure=True)
    model = lmfit.Model(lorentzian, independent_vars=["frequency"])
    theirs = model.fit(rate, frequency=CUT_OFF, peak=350, f0=13, half_width=2)
    ends = theirs.conf_interval(sigmas=[0.95])
    for name, estimate, interval in (
        ("peak", fit.peak, fit.peak_interval),
        ("f0", fit.f0_hz, fit.f0_interval),
        ("half_width", fit.half_width_hz, fit.half_width_interval),
    ):
        low, _, high = (value for _, value in ends[name])
        # lmfit differentiates numerically and seeks the ends to about 1e-3 of the distance; a Student quantile of the
        # wrong degrees of freedom would move them by 1 % of it or more.
        within = 3e-3 * (high - low)
        assert estimate == pytest.approx(theirs.params[name].value, abs=within)
        assert interval == pytest.approx((low, high), abs=within)
    assert fit.r2 == pytest.approx(theirs.rsquared, abs=1e-6)
    assert (fit.interval_method, fit.scatter) == ("profile likelihood", "residual")


@pytest.mark.slow
@pytest.mark.parametrize("sd", [None, 6.0])
def test_intervals_cover_the_truth_as_often_as_they_say(sd):
    # Five points, 2 degrees of freedom: with a normal quantile for Student's t, 81 % would be covered and not 95.
    frequency, truth, rng = np.arange(18.0, 33.0, 3.5), (600.0, 25.0, 5.0), np.random.default_rng(11)
    n, covered = 100, np.zeros(3)
    for _ in range(n):
        fit = fit_lorentzian(frequency, noisy(rng, frequency, *truth, 0.01), sd=None if sd is None else np.full(5, sd))
        intervals = (fit.peak_interval, fit.f0_interval, fit.half_width_interval)
        covered += [low <= value <= high for (low, high), value in zip(intervals, truth, strict=True)]
    # The 99.9 % range of a binomial count, 87 to 100 of 100.
    low, high = binom.interval(0.999, n, 0.95)
    assert (covered >= low).all(), covered
    assert (covered <= high).all(), covered


@pytest.mark.parametrize("confidence", [0.68, 0.95])
def test_small_errors_of_known_size_propagate_linearly(confidence):
    truth, sd = np.array([600.0, 25.0, 5.0]), np.linspace(0.01, 0.03, len(FREQUENCY))
    rate = lorentzian(FREQUENCY, *truth) + sd * np.random.default_rng(0).normal(size=len(sd))
    fit = fit_lorentzian(FREQUENCY, rate, sd=sd, confidence=confidence)
    step = 1e-4 * np.eye(3)
    slopes = np.array([lorentzian(FREQUENCY, *(truth + h)) - lorentzian(FREQUENCY, *(truth - h)) for h in step]) / (
        2e-4 * sd
    )
    errors = np.sqrt(np.diag(np.linalg.inv(slopes @ slopes.T)))
    widths = 2 * norm.ppf((1 + confidence) / 2) * errors
    found = [high - low for low, high in (fit.peak_interval, fit.f0_interval, fit.half_width_interval)]
    # Errors of 5e-5 bend the profile by about that share; its ends are sought to 1e-4.
    np.testing.assert_allclose(found, widths, rtol=5e-4)
    assert fit.scatter == "given"


def test_more_confidence_is_a_wider_interval_about_the_estimate():
    rate = noisy(np.random.default_rng(2), FREQUENCY, 600, 25, 5, 0.05)
    lows, highs = zip(
        *(fit_lorentzian(FREQUENCY, rate, confidence=c).f0_interval for c in (0.5, 0.9, 0.99)), strict=True
    )
    assert list(lows) == sorted(lows, reverse=True)
    assert list(highs) == sorted(highs)


def test_points_with_a_large_sd_count_less():
    rate = lorentzian(FREQUENCY, 600, 25, 5)
    rate[3] += 200
    sd = np.where(np.arange(len(rate)) == 3, 1e4, 5.0)
    fit = fit_lorentzian(FREQUENCY, rate, sd=sd)
    assert abs(fit_lorentzian(FREQUENCY, rate).f0_hz - 25) > 0.1
    # The outlier weighs (5 / 1e4)² = 2.5e-7 of a point, so it moves f0 by about that share of those 0.1 Hz or more.
    assert fit.f0_hz == pytest.approx(25, abs=1e-5)
    assert fit.scatter == "given"


def test_r2_is_weighted_as_the_fit_is():
    sd = np.linspace(5.0, 60.0, len(FREQUENCY))
    rate = lorentzian(FREQUENCY, 600, 25, 5) + sd * np.random.default_rng(1).normal(size=len(sd))
    fit = fit_lorentzian(FREQUENCY, rate, sd=sd)
    mean = np.average(rate, weights=sd**-2)
    left, whole = (np.sum(((rate - line) / sd) ** 2) for line in (fit(FREQUENCY), mean))
    assert fit.r2 == pytest.approx(1 - left / whole, abs=TINY)


def test_an_sd_that_the_residuals_contradict_does_not_size_the_intervals():
    rate = noisy(np.random.default_rng(4), FREQUENCY, 600, 25, 5, 0.05)
    plain, bold = fit_lorentzian(FREQUENCY, rate), fit_lorentzian(FREQUENCY, rate, sd=np.full(len(rate), 0.1))
    assert bold.scatter == "residual"
    np.testing.assert_allclose(bold.f0_interval, plain.f0_interval, rtol=1e-4)  # ends are sought to 1e-4


def test_failed_runs_are_left_out():
    rate = noisy(np.random.default_rng(6), FREQUENCY, 600, 25, 5, 0.02)
    failed = np.where(FREQUENCY > 27, NAN, rate)
    kept = FREQUENCY <= 27
    fit = fit_lorentzian(FREQUENCY, failed, sd=np.where(kept, 10.0, NAN))
    assert fit == fit_lorentzian(FREQUENCY[kept], rate[kept], sd=np.full(kept.sum(), 10.0))
    assert fit.n_points == kept.sum()


def test_a_curve_cut_off_at_its_peak_is_fitted():
    rng, errors = np.random.default_rng(8), []
    for _ in range(20):
        # 3 % of the peak: R² of 0.99, as published (Table A.2).
        rate = noisy(rng, CUT_OFF, 380, 12.7, 3.0, 0.03)
        fit = fit_lorentzian(CUT_OFF, rate, ends_in_failure=True)
        errors.append((fit.f0_hz - 12.7, fit.peak - 380))
    # The spread is about 0.2 Hz and 12; the bounds are 4 of its standard errors over 20 curves, and a little bias.
    assert abs(np.mean(errors, axis=0))[0] < 0.2
    assert abs(np.mean(errors, axis=0))[1] < 12


def test_residuals_of_mere_rounding_give_a_covariance_interval():
    fit = fit_lorentzian(FREQUENCY, lorentzian(FREQUENCY, 600, 25, 5))
    assert fit.interval_method == "covariance"
    assert np.ptp(fit.f0_interval) < 1e-6  # rounding: 1e-16 of the rates, with a wide margin


@settings(deadline=None, max_examples=30)
@given(st.lists(st.floats(-1e3, 1e3), min_size=4, max_size=12), st.booleans())
def test_any_rates_give_a_peak_that_the_samples_saw_or_a_refusal(rates, ends_in_failure):
    frequency = 10.0 + np.arange(len(rates))
    try:
        fit = fit_lorentzian(frequency, rates, ends_in_failure=ends_in_failure)
    except InputError:
        return
    for value, (low, high) in (
        (fit.peak, fit.peak_interval),
        (fit.f0_hz, fit.f0_interval),
        (fit.half_width_hz, fit.half_width_interval),
    ):
        assert -INF < low <= value <= high < INF
    assert fit.half_width_interval[0] > 0
    assert 10 <= fit.f0_hz <= frequency[-1] + 0.5 * ends_in_failure
    assert np.sum(np.abs(frequency - fit.f0_hz) <= fit.half_width_hz) >= 3


GOOD = lorentzian([20, 22, 24, 26, 28], 600, 25, 5).tolist()


@pytest.mark.parametrize(
    ("field", "frequency", "rate", "options"),
    [
        ("rate", [20, 22, 24, 26, 28], GOOD[:4], {}),
        ("frequency", 20, 600, {}),
        ("frequency", [[20, 22], [24, 26]], [[1, 2], [3, 2]], {}),
        ("frequency", [20, 22, 24, 26, NAN], GOOD, {}),
        ("frequency", [20, 22, 24, 26, INF], GOOD, {}),
        ("frequency", [0, 22, 24, 26, 28], GOOD, {}),
        ("frequency", [-20, 22, 24, 26, 28], GOOD, {}),
        ("rate", [20, 22, 24, 26, 28], [*GOOD[:4], INF], {}),
        ("rate", [20, 22, 24, 26, 28], [*GOOD[:3], NAN, NAN], {}),
        ("rate", [20, 22, 24, 26, 28], [NAN] * 5, {}),
        ("rate", [], [], {}),
        ("rate", [20, 20, 22, 24, 24], GOOD, {}),
        ("rate", [20, 22, 24, 26, 28], [0] * 5, {}),
        ("rate", [20, 22, 24, 26, 28], [5] * 5, {}),
        ("sd", [20, 22, 24, 26, 28], GOOD, {"sd": [1, 1, 1]}),
        ("sd", [20, 22, 24, 26, 28], GOOD, {"sd": [1, 1, 1, 1, 0]}),
        ("sd", [20, 22, 24, 26, 28], GOOD, {"sd": [1, 1, 1, 1, NAN]}),
        ("sd", [20, 22, 24, 26, 28], GOOD, {"sd": [1, 1, 1, 1, INF]}),
        ("confidence", [20, 22, 24, 26, 28], GOOD, {"confidence": 0}),
        ("confidence", [20, 22, 24, 26, 28], GOOD, {"confidence": 95}),
        ("confidence", [20, 22, 24, 26, 28], GOOD, {"confidence": NAN}),
    ],
)
def test_bad_input_is_refused_by_name(field, frequency, rate, options):
    with pytest.raises(InputError) as refused:
        fit_lorentzian(frequency, rate, **options)
    assert refused.value.field == field


@pytest.mark.parametrize(
    ("rate", "got", "hint"),
    [
        (CUT_OFF - 6, "highest at the last", "beyond 13 Hz"),
        (20 - CUT_OFF, "highest at the first", "below 7 Hz"),
        (np.exp(0.6 * CUT_OFF), "highest at the last", "beyond 13 Hz"),
        (-np.exp(-0.6 * CUT_OFF), "highest at the first", "below 7 Hz"),
        (lorentzian(CUT_OFF, 380, 15.5, 2.2), "highest at the last", "beyond 13 Hz"),
        (lorentzian(CUT_OFF, 380, 4.5, 2.2), "highest at the first", "below 7 Hz"),
        (np.where(CUT_OFF == 10, 5.0, 0.0), "half width", "around 10 Hz"),
        (CUT_OFF + np.where(CUT_OFF == 12.5, 1.0, 0.0), "", "Hz"),
        (5 + np.sin(40 * CUT_OFF), "", ""),
    ],
)
def test_a_curve_that_shows_no_peak_is_refused_with_where_to_look(rate, got, hint):
    with pytest.raises(InputError, match="a curve that shows its peak") as refused:
        fit_lorentzian(CUT_OFF, rate)
    assert got in refused.value.got
    assert hint in refused.value.hint
