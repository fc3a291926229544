"""Known truths recovered from simulated curves, with the engine in the loop; `benchmarks/recovery.py` does many."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plategait.curve.curve import Curve
from plategait.curve.protocol import measured_as
from plategait.curve.spin_curve import spin_curve
from plategait.estimate.goodness import goodness_of_fit
from plategait.estimate.planning import next_measurement
from plategait.estimate.prediction import predict
from plategait.estimate.result import estimate_parameters
from plategait.estimate.unknowns import unknowns
from plategait.model.presets import preset
from plategait.simulation.run import simulate

BASE = measured_as(preset("cheese").scenario)
OBJECT = unknowns(BASE, fixed=("bending_damping", "plate_height"))
FREQUENCIES = (13.5, 14.5, 15.5, 17.0, 19.0, 21.0, 23.0, 24.5, 25.5, 26.5)


def measured(truth, noise: float, seed: int, frequencies=FREQUENCIES) -> Curve:
    """Curve of an object (ω_n in π rad/s, α in deg, β), with relative noise told in the file."""
    scenario = OBJECT.scenario(np.multiply(truth, (math.pi, math.radians(1), 1.0)))
    curve = spin_curve(scenario, frequencies)
    generator = np.random.default_rng(seed)
    rate = curve.spin_rate_deg_s * (1 + noise * generator.normal(size=len(frequencies)))
    return Curve("measured", curve.frequency_hz, rate, noise * np.abs(rate), ("",) * len(rate), curve.failure)


@pytest.fixture(scope="module")
def truth():
    return 9.0, 40.0, 0.6


@pytest.fixture(scope="module")
def estimate(truth):
    return estimate_parameters(measured(truth, 0.01, 1), BASE, model_error=0, seed=1)


def test_a_precise_curve_gives_the_object_back(estimate, truth):
    # One percent of noise, c_b and the plate's height unknown. The intervals are the estimator's own claim: the truth
    # lies within three of its standard deviations, and those are small enough to be of use.
    for name, value, largest in (("natural_frequency", truth[0], 2.0), ("friction_angle", truth[1], 1.5),
                                 ("friction_ratio", truth[2], 0.06)):  # fmt: skip
        marginal = estimate[name]
        assert marginal.verdict == "determined"
        scale = marginal.parameter.scale
        assert abs(marginal.median / scale - value) < 3 * marginal.sd / scale
        assert marginal.sd / scale < largest
    assert estimate.goodness.explained
    assert estimate.answered


def test_its_fragment_simulates_what_was_measured(estimate, truth):
    scenario = OBJECT.scenario(np.multiply(truth, (math.pi, math.radians(1), 1.0)))
    fragment = estimate.to_fragment()
    for frequency in (15.0, 22.0):
        change = {"motion.frequency": frequency}
        true = simulate(scenario.replace(**change)).spin_rate
        # Rates known to 1 % each give the curve back to 2 %.
        assert simulate(fragment.apply(BASE).replace(**change)).spin_rate == pytest.approx(true, rel=0.02)


def test_predictions_run_through_the_data(estimate):
    (prediction,) = predict(estimate.posterior)
    data = estimate.posterior.data
    inside, stays = data.rated & (data.frequency < 24), prediction.frequency < 25
    # A draw on a plate that starts at once may run off earlier than the rest; it has no rate from there on.
    middle = np.nanmedian(prediction.rates[:, stays], axis=0)
    at = np.interp(data.frequency[inside], prediction.frequency[stays], middle)
    # The grid's spacing costs about a percent where the curve bends most; the noise is 1 %.
    np.testing.assert_allclose(at, data.rate[inside], rtol=0.05)


def test_the_next_measurement_tells_more(estimate):
    plan = next_measurement(estimate.posterior, wanted={"natural_frequency": 0.1 * math.pi})
    assert 10 < plan.condition.frequency <= FREQUENCIES[-1]
    # What is expected after more measurements falls on.
    left = [sd["natural_frequency"] for _, sd in plan.programme]
    assert left == sorted(left, reverse=True)
    assert plan.sd_after["natural_frequency"] < plan.sd_now["natural_frequency"]
    assert plan.needed is not None
    assert plan.needed[0] <= plan.needed[1] <= plan.needed[2]


def estimate_of_slow_sliding(truth):
    return estimate_parameters(measured(truth, 0.05, 3, (12.0, 13.0, 14.0)), BASE, friction_ratio=0.6,
                               model_error=0, seed=5)  # fmt: skip


@pytest.fixture(scope="module")
def slow(truth):
    return estimate_of_slow_sliding(truth)


def test_slow_sliding_alone_determines_no_stiffness(slow):
    """Below 15 Hz a sheet slides flat on the plate whatever its stiffness: the gate holds the number back."""
    assert slow["natural_frequency"].verdict != "determined"
    assert slow.summary()["parameters"]["natural_frequency"]["median"] is None


def test_the_same_seed_gives_the_same_samples(slow, truth):
    np.testing.assert_array_equal(estimate_of_slow_sliding(truth).posterior.full, slow.posterior.full)


def test_an_outlier_is_named_and_does_no_harm(truth):
    # Six rates are enough for two unknowns, and cost half of what ten do.
    curve = measured(truth, 0.02, 4, FREQUENCIES[1:7])
    spoiled = curve.spin_rate_deg_s.copy()
    spoiled[3] *= 1.6
    estimate = estimate_parameters(
        Curve("s", curve.frequency_hz, spoiled, curve.spin_rate_sd_deg_s, curve.gait, curve.failure), BASE,
        friction_ratio=truth[2], model_error=0, fixed=("bending_damping", "plate_height"),
    )  # fmt: skip
    assert estimate.goodness.outliers == (FREQUENCIES[4],)
    marginal = estimate["friction_angle"]
    assert abs(math.degrees(marginal.median) - truth[1]) < 3 * math.degrees(marginal.sd) + 0.5


def test_a_curve_that_no_object_makes_is_called_so():
    """Rates that fall where every sheet's rise."""
    f = np.array(FREQUENCIES[:8:2])
    rate = np.linspace(500, 60, 4)
    estimate = estimate_parameters(Curve("s", f, rate, 0.05 * rate, ("",) * 4, ("",) * 4), BASE, friction_ratio=0.6)
    assert not goodness_of_fit(estimate.posterior).explained
    assert not estimate.answered
