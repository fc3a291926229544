"""The estimator with toy engines in its loop, whose posteriors and best measurements are known in closed form."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.stats import cauchy, norm

from plategait.curve.protocol import measured_as
from plategait.estimate import forecast as forecast_module
from plategait.estimate import posterior as posterior_module
from plategait.estimate import prediction
from plategait.estimate import runs as runs_module
from plategait.estimate.candidates import alike, reach_of
from plategait.estimate.discrepancy import PRESUMED, own_scatter, presumed_discrepancy
from plategait.estimate.emulator import RateEmulator, fit_run_off
from plategait.estimate.forecast import MOST_MEASUREMENTS, Forecast, forecast_of, measurements_needed, programme
from plategait.estimate.goodness import goodness_of_fit
from plategait.estimate.handling import Handling
from plategait.estimate.identifiability import marginal_of
from plategait.estimate.likelihood import OUTLIER_SHARE, OUTLIER_SPREAD, Likelihood, scatter_of
from plategait.estimate.observations import Condition, Observations
from plategait.estimate.particles import Particles, explore, folded, stratified
from plategait.estimate.posterior import Effort, estimate_posterior
from plategait.estimate.readings import Readings
from plategait.estimate.result import Estimate, correlated
from plategait.estimate.runs import EngineRuns, run_engine
from plategait.estimate.unknowns import FRICTION_ANGLE, FRICTION_RATIO, unknowns
from plategait.model.presets import preset
from plategait.simulation.observables import Failure, SpinRate
from plategait.simulation.observation import Glance
from plategait.simulation.run import simulate

pytestmark = pytest.mark.linear_algebra

CHEESE = measured_as(preset("cheese").scenario)
CONDITIONS = tuple(Condition(0.05, 0.003, float(f)) for f in np.linspace(14, 25, 12))
# deg/s for each condition and each of two unknowns: steep enough that 2 deg/s of noise leave a hundredth of the prior.
SLOPES = np.random.default_rng(0).uniform(-100, 100, (len(CONDITIONS), 2))
SD = 2.0
TRUTH = np.array([0.4, 0.6])


def linear_rates(u) -> np.ndarray:
    """An engine whose rates are linear in the parameters."""
    return 300 + np.asarray(u) @ SLOPES.T


def linear_engine(
    unknowns, u, conditions, *, handling=None, observables=(), changed=None, seed=0, threads=None, progress=None
) -> EngineRuns:
    where = [round(c.frequency - 14) % len(CONDITIONS) for c in conditions]
    return EngineRuns(u, tuple(conditions), linear_rates(u)[:, where], np.zeros((len(u), len(conditions)), bool))


def observations(rate, sd=SD) -> Observations:
    n = len(CONDITIONS)
    return Observations(CONDITIONS, np.arange(n), np.asarray(rate), np.full(n, sd), np.zeros(n, bool))


def two_unknowns():
    return unknowns(CHEESE, fixed=("natural_frequency", "bending_damping", "plate_height"))


def sampled(rate, monkeypatch, sd=SD):
    monkeypatch.setattr(posterior_module, "run_engine", linear_engine)
    return estimate_posterior(observations(rate, sd), two_unknowns(), seed=1, effort=Effort(walkers=48))


# Likelihood


def test_the_likelihood_is_that_of_gaussian_noise_with_an_outlier_now_and_then():
    emulator = RateEmulator(((np.arange(len(CONDITIONS)), linear_rates),), np.zeros(len(CONDITIONS)))
    rate = linear_rates(TRUTH[None])[0] + np.random.default_rng(1).normal(0, SD, len(CONDITIONS))
    likelihood = Likelihood(observations(rate), emulator, {}, None)
    u = np.random.default_rng(2).random((20, 2))
    inlier = norm.pdf(rate, linear_rates(u), SD)
    outlier = cauchy.pdf(rate, linear_rates(u), OUTLIER_SPREAD * SD)
    density = (1 - OUTLIER_SHARE) * inlier + OUTLIER_SHARE * outlier
    np.testing.assert_allclose(likelihood(u), np.log(density).sum(axis=1), rtol=1e-12)


def test_an_error_of_the_emulator_widens_the_noise():
    error = np.full(len(CONDITIONS), 1.5)
    likelihood = Likelihood(observations(np.full(12, 300.0)), RateEmulator((), error), {}, None)
    np.testing.assert_allclose(likelihood.spread(np.full((1, 12), 300.0), np.zeros(1)), math.hypot(SD, 1.5))


def test_friction_that_scatters_widens_each_point_by_its_slope():
    u = np.random.default_rng(3).random((40, 2))
    scatter = scatter_of(u, linear_rates(u), np.ones(40, dtype=bool), 0, 0.05)
    np.testing.assert_allclose(scatter, 0.05 * np.abs(SLOPES[:, 0]), rtol=1e-9)
    emulator = RateEmulator(((np.arange(12), linear_rates),), np.zeros(12))
    likelihood = Likelihood(observations(np.full(12, 300.0)), emulator, {}, None, wander=scatter)
    spread = likelihood.spread(np.full((1, 12), 300.0), np.zeros(1))[0]
    np.testing.assert_allclose(spread, np.hypot(SD, 0.05 * np.abs(SLOPES[:, 0])), rtol=1e-9)


def test_a_posterior_told_of_the_scatter_is_as_wide_as_it_makes_it(monkeypatch):
    """Each point of a friction angle of its own, 3 deg about the object's: 3/60 of the prior."""
    rng, share = np.random.default_rng(7), 3 / 60
    points = np.tile(TRUTH, (12, 1)) + np.outer(share * rng.normal(size=12), [1, 0])
    rate = np.sum(points * SLOPES, axis=1) + 300 + rng.normal(0, SD, 12)
    monkeypatch.setattr(posterior_module, "run_engine", linear_engine)
    told = []
    for scatter in (0.0, math.radians(3)):
        data = replace(observations(rate), handling=Handling(friction_scatter=scatter))
        told.append(estimate_posterior(data, two_unknowns(), seed=1, effort=Effort(walkers=32)).u[:, 0])
    # Weighted least squares: the bound of points whose own scatter is the slope's.
    spread = np.hypot(SD, share * SLOPES[:, 0])[:, None]
    bound = math.sqrt(np.linalg.inv((SLOPES / spread).T @ (SLOPES / spread))[0, 0])
    # The likelihood of outliers takes a little more than the normal one.
    assert told[1].std() == pytest.approx(bound, rel=0.25)
    assert abs(np.median(told[1]) - TRUTH[0]) < 2.5 * told[1].std()
    assert told[0].std() < 0.7 * bound


def test_a_relative_noise_that_is_not_told_is_the_last_unknown():
    emulator = RateEmulator(((np.arange(12), linear_rates),), np.zeros(12))
    likelihood = Likelihood(observations(linear_rates(TRUTH[None])[0], math.nan), emulator, {}, None)
    assert likelihood.noise_is_unknown
    parameters, noise = likelihood.split(np.array([[0.4, 0.6, 0.0], [0.4, 0.6, 1.0]]))
    assert parameters.shape == (2, 2)
    np.testing.assert_allclose(noise, [0.005, 0.3])  # the ends of its prior
    # Rates without noise are likelier the smaller it is taken.
    first, second = likelihood(np.array([[0.4, 0.6, 0.0], [0.4, 0.6, 1.0]]))
    assert first > second


# Emulator


def test_a_run_off_that_is_cubic_is_learnt_to_its_brackets():
    u = np.random.default_rng(0).random((120, 2))
    truth = 20 + 3 * u[:, 0] - 4 * u[:, 1] ** 3 + 2 * u[:, 0] ** 2 * u[:, 1]
    emulator = fit_run_off(u, truth - 0.01, truth + 0.01, np.ones(120, bool))
    assert emulator is not None
    assert emulator.degree == 3
    # A cubic is exact but for the ridge, which gives way to brackets this narrow.
    assert np.abs(emulator(u) - truth).max() < 0.02


# Particles


def test_particles_cover_a_narrow_normal():
    mean, sd = np.array([0.3, 0.7]), np.array([0.004, 0.02])
    particles = explore(lambda u: -0.5 * (((u - mean) / sd) ** 2).sum(axis=1), 2, np.random.default_rng(3))
    u = particles.resampled(1.0, 4000, np.random.default_rng(4))
    # Points of a generation spread about the best before it and are weighted by the likelihood alone, not by how dense
    # they lie: the centre is right, the spread up to a third too small.
    assert (np.abs(u.mean(axis=0) - mean) < 0.2 * sd).all()
    assert (u.std(axis=0) > 0.6 * sd).all()
    assert (u.std(axis=0) < 1.1 * sd).all()


def test_a_temperature_keeps_as_many_points_as_asked():
    particles = Particles(np.zeros((1000, 1)), np.linspace(-500, 0, 1000))
    weight = particles.weight(particles.temperature(100))
    assert weight.sum() ** 2 / np.sum(weight**2) >= 100
    assert Particles(np.zeros((1000, 1)), np.zeros(1000)).temperature(100) == 1


def test_a_latin_hypercube_has_one_point_in_each_stratum():
    u = stratified(20, 3, np.random.default_rng(0))
    for column in u.T:
        assert sorted((20 * column).astype(int)) == list(range(20))


def test_points_beyond_the_cube_are_mirrored():
    np.testing.assert_allclose(folded(np.array([-0.2, 0.3, 1.1, 2.4])), [0.2, 0.3, 0.9, 0.4])


# Posterior


def test_the_posterior_of_a_linear_engine_is_the_normal_of_least_squares(monkeypatch):
    rate = linear_rates(TRUTH[None])[0] + np.random.default_rng(5).normal(0, SD, len(CONDITIONS))
    posterior = sampled(rate, monkeypatch)
    covariance = SD**2 * np.linalg.inv(SLOPES.T @ SLOPES)
    mean = np.linalg.lstsq(SLOPES, rate - 300, rcond=None)[0]
    sd = np.sqrt(np.diag(covariance))
    # Some two thousand samples, of which neighbours are alike: a hundred or more that count. Three standard errors; the
    # outliers' share widens the normal by a few percent.
    np.testing.assert_allclose(posterior.u.mean(axis=0), mean, atol=0.3 * sd.max())
    np.testing.assert_allclose(posterior.u.std(axis=0), sd, rtol=0.25)
    assert len(posterior.runs.u) == sum(Effort().rounds(2))  # the emulators are exact after one later round


def test_data_that_the_engine_makes_are_explained(monkeypatch):
    rate = linear_rates(TRUTH[None])[0] + np.random.default_rng(6).normal(0, SD, len(CONDITIONS))
    goodness = goodness_of_fit(sampled(rate, monkeypatch))
    assert goodness.explained
    assert goodness.inliers == len(CONDITIONS)
    assert goodness.p > 0.01
    assert not goodness.outliers


def test_an_outlier_is_named(monkeypatch):
    rate = linear_rates(TRUTH[None])[0] + np.random.default_rng(7).normal(0, SD, len(CONDITIONS))
    rate[5] += 12 * SD
    goodness = goodness_of_fit(sampled(rate, monkeypatch))
    assert goodness.outliers == (CONDITIONS[5].frequency,)
    assert goodness.explained


def test_rates_that_no_parameters_give_are_not_explained(monkeypatch):
    free = np.linalg.svd(SLOPES)[0][:, 2:]  # what the parameters cannot make up for
    rate = linear_rates(TRUTH[None])[0] + 6 * SD * free.sum(axis=1)
    goodness = goodness_of_fit(sampled(rate, monkeypatch))
    assert not goodness.explained


def test_parameters_that_move_the_rates_alike_are_correlated(monkeypatch):
    together = np.linspace(50, 90, len(CONDITIONS))
    monkeypatch.setitem(globals(), "SLOPES", np.stack([together, together + np.linspace(-3, 3, 12)], axis=1))
    posterior = sampled(linear_rates(TRUTH[None])[0], monkeypatch)
    marginals = (marginal_of(FRICTION_ANGLE, posterior.u[:, 0]), marginal_of(FRICTION_RATIO, posterior.u[:, 1]))
    ((one, other, r),) = correlated(Estimate(posterior, marginals, goodness_of_fit(posterior), 0.9))
    assert {one, other} == {"friction_angle", "friction_ratio"}
    assert r < -0.9


BENDS = np.random.default_rng(8).uniform(-0.1, 0.1, (len(CONDITIONS), 2))


def bending_engine(
    unknowns, u, conditions, *, handling=None, observables=(), changed=None, seed=0, threads=None, progress=None
) -> EngineRuns:
    """Rates as those of the linear engine, and bending angles that are linear too."""
    assert list(observables) == ["bending_amplitude"]
    runs = linear_engine(unknowns, u, conditions)
    return EngineRuns(u, runs.conditions, runs.rates, runs.failed, {"bending_amplitude": 0.2 + np.asarray(u) @ BENDS.T})


def test_readings_count_as_much_as_their_spread_says(monkeypatch):
    """The posterior of rates and readings is that of least squares over both, each by its own spread."""
    generator, n, sd = np.random.default_rng(9), len(CONDITIONS), 5e-4
    rate = linear_rates(TRUTH[None])[0] + generator.normal(0, SD, n)
    bend = 0.2 + BENDS @ TRUTH + generator.normal(0, sd, n)
    read = Readings("bending_amplitude", np.arange(n), bend, np.full(n, sd))
    monkeypatch.setattr(posterior_module, "run_engine", bending_engine)
    data = replace(observations(rate), readings=(read,))
    posterior = estimate_posterior(data, two_unknowns(), seed=1, effort=Effort(walkers=48))
    rows = np.concatenate([SLOPES / SD, BENDS / sd])
    covariance = np.linalg.inv(rows.T @ rows)
    mean = covariance @ rows.T @ np.concatenate([(rate - 300) / SD, (bend - 0.2) / sd])
    wanted = np.sqrt(np.diag(covariance))
    # As for the rates alone above; these readings are sharper than the rates.
    assert wanted.max() < 0.7 * np.sqrt(np.diag(SD**2 * np.linalg.inv(SLOPES.T @ SLOPES))).max()
    np.testing.assert_allclose(posterior.u.mean(axis=0), mean, atol=0.3 * wanted.max())
    np.testing.assert_allclose(posterior.u.std(axis=0), wanted, rtol=0.25)
    goodness = goodness_of_fit(posterior)
    assert goodness.explained
    assert goodness.inliers == 2 * n


def test_a_reading_that_cannot_be_is_named_with_what_it_is_of(monkeypatch):
    n, sd = len(CONDITIONS), 5e-4
    bend = 0.2 + BENDS @ TRUTH
    bend[3] += 40 * sd
    read = Readings("bending_amplitude", np.arange(n), bend, np.full(n, sd))
    monkeypatch.setattr(posterior_module, "run_engine", bending_engine)
    data = replace(observations(linear_rates(TRUTH[None])[0]), readings=(read,))
    goodness = goodness_of_fit(estimate_posterior(data, two_unknowns(), seed=1, effort=Effort(walkers=48)))
    assert goodness.outlying_readings == ("bending amplitude at 17 Hz",)
    assert not goodness.outliers  # the rate there is sound


def test_a_walker_that_begins_on_a_place_of_no_weight_does_not_stay_there():
    """Two peaks as narrow as films make them, one of them e^-100 as high: all samples are of the other."""

    def peaks(u):
        high, low = (-0.5 * np.sum(((u - at) / 0.002) ** 2, axis=1) for at in (0.5, 0.1))
        return np.logaddexp(high, low - 100)

    generator = np.random.default_rng(0)
    at = np.concatenate([generator.normal(0.5, 0.002, (200, 2)), generator.normal(0.1, 0.002, (200, 2))])
    # Particles that do not tell the two apart: half of the walkers begin on either.
    latest = SimpleNamespace(particles=Particles(at, np.zeros(400)), likelihood=peaks)
    samples = posterior_module._sample(latest, Effort(), generator)
    assert np.abs(samples - 0.5).max() < 8 * 0.002
    np.testing.assert_allclose(samples.std(axis=0), 0.002, rtol=0.15)


# Engine


def test_the_engine_runs_every_parameter_set_under_every_condition():
    short = unknowns(CHEESE.replace(duration=0.5, transient=0.2), fixed=("bending_damping", "plate_height"))
    u = np.array([[0.3, 0.5, 0.4], [0.6, 0.4, 0.5]])
    conditions = (Condition(0.05, 0.003, 12.0), Condition(0.05, 0.003, 16.0))
    runs = run_engine(short, u, conditions, observables=["rim_lift"])
    for i, values in enumerate(short.values(u)):
        for j, condition in enumerate(conditions):
            scenario = short.scenario(values)
            alone = simulate(scenario.replace(motion=condition.motion(scenario.motion)))
            assert runs.rates[i, j] == math.degrees(alone.spin_rate)
            assert runs.values["rim_lift"][i, j] == alone.value("rim_lift")


def test_rates_beyond_the_first_failure_of_an_amplitude_do_not_count(monkeypatch):
    conditions = [Condition(a, 0.003, f) for a in (0.05, 0.2) for f in (12.0, 16.0, 20.0)]
    fails = {(0.05, 16.0)}  # and stays at 20 Hz again, an island

    def seen(scenario, _recording, _names):
        motion = scenario.motion
        failure = Failure("slipped", 1.0) if (motion.angle, motion.frequency) in fails else None
        return Glance(SpinRate(1.0, 0.9, 1.1, True), failure, {})

    monkeypatch.setattr(runs_module, "engine", lambda _: SimpleNamespace(run=lambda runs, **_: runs))
    monkeypatch.setattr(runs_module, "glance", seen)
    runs = run_engine(two_unknowns(), np.full((1, 2), 0.5), conditions)
    np.testing.assert_array_equal(np.isfinite(runs.rates[0]), [True, False, False, True, True, True])
    low, high = runs.brackets(conditions[0].amplitude)
    assert (low[0], high[0]) == (12, 16)
    assert math.isinf(runs.brackets(conditions[-1].amplitude)[1][0])


def test_predictions_span_a_little_more_than_was_measured(monkeypatch):
    monkeypatch.setattr(prediction, "run_engine", linear_engine)
    posterior = sampled(linear_rates(TRUTH[None])[0], monkeypatch)
    done: list[float] = []
    (curve,) = prediction.predict(posterior, progress=done.append)
    assert (curve.frequency[0], curve.frequency[-1]) == pytest.approx((0.95 * 14, 1.05 * 25))
    assert curve.rates.shape == (prediction.DRAWS, prediction.POINTS)


def test_motions_that_make_no_curve_are_predicted_as_they_were_measured(monkeypatch):
    def engine(unknowns, u, conditions, *, handling=None, observables=(), seed=0, threads=None, progress=None):
        return EngineRuns(
            u, tuple(conditions), np.ones((len(u), len(conditions))), np.zeros((len(u), len(conditions)), bool)
        )

    monkeypatch.setattr(prediction, "run_engine", engine)
    posterior = sampled(linear_rates(TRUTH[None])[0], monkeypatch)
    alone = (Condition(0.1, 0.003, 15.0), Condition(0.1, 0.003, 16.0, phase=1.0))
    data = replace(posterior.data, conditions=(*CONDITIONS, *alone))
    curve, mixed = prediction.predict(replace(posterior, data=data))
    assert curve.amplitude == CONDITIONS[0].amplitude
    assert mixed.amplitude is None
    assert mixed.conditions == alone


# Planning


def forecast(slopes, sd, n=4000) -> Forecast:
    """Candidates whose rates are linear in one parameter of standard deviation 1, and at which nothing runs off."""
    values = norm.ppf((np.arange(n) + 0.5) / n)[:, None]
    conditions = tuple(Condition(0.05, 0.003, 10.0 + i) for i in range(len(slopes)))
    outcome = (values * np.array(slopes))[:, :, None]
    return Forecast(conditions, values, outcome, np.full_like(outcome, sd), np.ones((n, len(slopes))))


def test_the_variance_left_after_a_measurement_is_that_of_a_normal():
    toy = forecast([0.0, 1.0, 3.0], 2.0)
    prior = toy.variances(toy.even)[0]
    left = toy.expected_variances(toy.even)[:, 0]
    # A straight line through a normal: 1/(1/s² + k²/σ²), of the samples' own variance.
    np.testing.assert_allclose(left, [1 / (1 / prior + k**2 / 4) for k in (0, 1, 3)], rtol=1e-9)
    assert np.argmin(left) == 2  # the steepest tells most


def test_a_reading_beside_the_rate_tells_as_a_second_rate_would():
    toy = forecast([0.5, 2.0], 1.0)
    both = Forecast(
        toy.conditions[:1], toy.values, toy.outcome.transpose(0, 2, 1), np.ones((4000, 1, 2)), np.ones((4000, 1))
    )
    prior = both.variances(both.even)[0]
    # One measurement that reads two lines of slopes k at noise 1: 1/(1/s² + Σk²).
    assert both.expected_variances(both.even)[0, 0] == pytest.approx(1 / (1 / prior + 0.5**2 + 2.0**2), rel=1e-9)


def test_a_run_off_tells_without_a_rate():
    """Whether the object stays halves the range: a half normal has the variance 1 - 2/π."""
    toy = forecast([0.0], 1.0)
    split = Forecast(toy.conditions, toy.values, toy.outcome, toy.sd, (toy.values > 0).astype(float))
    assert split.expected_variances(split.even)[0, 0] == pytest.approx(1 - 2 / math.pi, abs=2e-3)


def test_a_programme_is_each_time_the_best_after_those_before():
    """Two parameters, each told by one candidate, and one that tells both a little: the sharp ones in turn."""
    generator = np.random.default_rng(0)
    values = generator.normal(size=(4000, 2))
    slopes = np.array([[3.0, 0.0], [0.0, 2.0], [1.0, 1.0]])
    outcome = (values @ slopes.T)[:, :, None]
    conditions = tuple(Condition(0.05, 0.003, 10.0 + i) for i in range(3))
    toy = Forecast(conditions, values, outcome, np.ones_like(outcome), np.ones((4000, 3)))
    steps = programme(toy, np.ones(2), 3)
    assert [i for i, _ in steps] == [0, 1, 1]  # then 1/(1 + 9) is left of one, and 1/(1 + 4) of the other
    np.testing.assert_allclose(steps[1][1], [1 / 10, 1 / 5], rtol=0.05)  # of 4000 draws
    # Were it to run off there for all but a tenth of the samples, the first would tell little.
    off = Forecast(conditions, values, outcome, np.ones_like(outcome), np.tile([0.1, 1.0, 1.0], (4000, 1)))
    assert programme(off, np.ones(2), 1)[0][0] == 1


def test_a_motion_that_tells_nothing_the_second_time_is_proposed_once():
    toy = replace(forecast([0.5, 2.0, 1.0], 1.0), once=True)
    assert [i for i, _ in programme(toy, np.ones(1), 6)] == [1, 2, 0]
    # All three leave 1/(1 + 4 + 1 + 1/4): no more can be had, however many are made.
    assert measurements_needed(toy, np.ones(1), np.array([0.1]), seed=0) == (MOST_MEASUREMENTS,) * 3


def test_what_the_model_may_be_off_is_noise_of_what_is_expected(monkeypatch):
    """Measured motions are proposed again only where the model is right; else new ones, each read the less well."""
    monkeypatch.setattr(forecast_module, "run_engine", linear_engine)
    monkeypatch.setattr(forecast_module, "SAMPLES", 200)
    posterior = sampled(linear_rates(TRUTH[None])[0], monkeypatch)
    base = posterior.unknowns.base.motion
    reach = reach_of(posterior.data.conditions, base, frequency=(10.0, 30.0))
    measured = posterior.data.conditions[1]
    reach = replace(reach, angle=((measured.angle, measured.angle),))
    right = forecast_of(posterior, reach)
    discrepancy = presumed_discrepancy(posterior.runs, 1.0)
    likelihood = replace(posterior.likelihood, discrepancy=discrepancy)
    off = forecast_of(replace(posterior, likelihood=likelihood), reach)
    assert (right.once, off.once) == (False, True)
    assert not any(alike(c, m) for c in off.conditions for m in posterior.data.conditions)
    # Of a motion like those measured: the mean square of what is presumed at each.
    off_by = math.sqrt(np.mean([PRESUMED**2 + own_scatter(c) ** 2 for c in posterior.data.conditions]))
    shared = [(right.conditions.index(c), i) for i, c in enumerate(off.conditions) if c in right.conditions]
    for i, j in shared:
        expected = np.hypot(right.sd[:, i], off_by * right.outcome[:, i])
        np.testing.assert_allclose(off.sd[:, j], expected)


def test_motions_are_alike_that_nobody_can_set_apart():
    one = Condition(0.05, 0.003, 16.78, height=-2.1e-3, phase=math.pi / 2)
    assert alike(one, replace(one, height=-2.1e-3 + 1e-8, duration=3.0))
    for name, change in (("angle", 2e-3), ("stroke", 1e-4), ("height", 1e-4), ("phase", 0.02), ("frequency", 0.05)):
        assert not alike(one, replace(one, **{name: getattr(one, name) + change}))


def test_as_many_measurements_are_needed_as_the_noise_asks_for():
    toy = forecast([0.5, 1.0], 1.0)
    scale = np.array([0.1])
    assert measurements_needed(toy, scale, np.array([2.0]), seed=0) == (0, 0, 0)
    # n measurements of noise 1 at slope 1 leave 1/(1 + n): 0.4² takes 5.25, so 6. Each future's own spread wavers.
    least, median, most = measurements_needed(toy, scale, np.array([0.4]), seed=0)
    assert least <= 6 <= most
    assert abs(median - 6) <= 1
    assert measurements_needed(toy, scale, np.array([1e-6]), seed=0) == (MOST_MEASUREMENTS,) * 3
