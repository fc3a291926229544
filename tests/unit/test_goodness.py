"""The check on the fit: how often it is wrong on sound data, and what it sees, where the posterior is known exactly."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from legible import assert_legible

from plategait.curve.curve import Curve
from plategait.curve.protocol import measured_as
from plategait.estimate.emulator import RateEmulator, RunOffEmulator
from plategait.estimate.figures import plot_estimate
from plategait.estimate.goodness import SIGNIFICANCE, Goodness, goodness_of_fit
from plategait.estimate.identifiability import marginal_of
from plategait.estimate.likelihood import Likelihood
from plategait.estimate.observations import Condition, Observations, observe_curves
from plategait.estimate.posterior import Posterior
from plategait.estimate.prediction import Prediction
from plategait.estimate.result import Estimate
from plategait.estimate.runs import EngineRuns
from plategait.estimate.unknowns import unknowns
from plategait.files.toml import read_toml
from plategait.model.fragment import read_fragment, write_fragment
from plategait.model.presets import preset

pytestmark = pytest.mark.linear_algebra

CHEESE = measured_as(preset("cheese").scenario)
CONDITIONS = tuple(Condition(0.05, 0.003, float(f)) for f in np.linspace(14, 25, 12))
AMPLITUDE = CONDITIONS[0].amplitude
# Rates of 300 deg/s that two unknowns bend as a slope and a bow over the frequency.
BEND = np.stack([np.linspace(-60, 60, 12), 60 * np.linspace(-1, 1, 12) ** 2 - 20], axis=1)
TRUTH = np.array([0.4, 0.6])
SETS = 100


def rates(u) -> np.ndarray:
    return 300 + np.asarray(u) @ BEND.T


EMULATOR = RateEmulator(((np.arange(12), rates),), np.zeros(12))


def observations(rate, sd=math.nan, failed=None) -> Observations:
    return Observations(CONDITIONS, np.arange(12), np.asarray(rate), np.full(12, sd),
                        np.zeros(12, bool) if failed is None else failed)  # fmt: skip


def posterior(data: Observations, noise=None, run_offs=None) -> Posterior:
    """Samples of the posterior of a linear model, by importance from the normal about least squares."""
    likelihood = Likelihood(data, EMULATOR, run_offs or {}, noise)
    generator = np.random.default_rng(3)
    sound = np.abs(data.rate - np.median(data.rate)) < 200
    bend = BEND[data.which[sound]]
    centre, *_ = np.linalg.lstsq(bend, data.rate[sound] - 300, rcond=None)
    sd = np.std(data.rate[sound] - 300 - bend @ centre) + 1.0
    u = generator.multivariate_normal(centre, 2 * sd**2 * np.linalg.inv(BEND.T @ BEND), 5_000)
    proposal = -0.25 * np.sum(((u - centre) @ BEND.T) ** 2, axis=1) / sd**2
    full = u
    if likelihood.noise_is_unknown:
        full = np.column_stack([u, generator.random(len(u))])
    weight = likelihood(full) - proposal
    weight = np.exp(weight - weight.max())
    full = full[generator.choice(len(u), 500, p=weight / weight.sum())]
    parameters, sampled = likelihood.split(full)
    runs = EngineRuns(u[:1], CONDITIONS, rates(u[:1]), np.zeros((1, 12), bool))
    sought = unknowns(CHEESE, fixed=("natural_frequency", "bending_damping", "plate_height"))
    return Posterior(sought, data, parameters, sampled, likelihood, runs, full)


def noisy(seed: int, noise=0.05) -> np.ndarray:
    return rates(TRUTH) * (1 + noise * np.random.default_rng(seed).normal(size=12))


@pytest.mark.parametrize("told", [0.05, None])
def test_sound_data_raise_no_more_alarms_than_chance(told):
    checks = [goodness_of_fit(posterior(observations(noisy(seed)), told)) for seed in range(SETS)]
    # Two tests at 1 % each: two of a hundred, and at most six in 99 of a hundred series.
    assert sum(not c.explained for c in checks) <= 6
    # And the probabilities spread as probabilities do, a little towards the middle as the data are used twice.
    if told:
        assert 0.25 < np.mean([c.p < 0.5 for c in checks]) < 0.75
        assert np.mean([c.p < 0.1 for c in checks]) < 0.15


def test_a_noise_that_is_not_told_is_held_against_itself():
    """The luckiest sample has almost no noise; the posterior's others say how much there is."""
    check = goodness_of_fit(posterior(observations(noisy(1))))
    assert check.explained
    assert check.chi2 == pytest.approx(check.inliers, abs=5)  # χ² of twelve: 12 ± 4.9, the noise taken as it is
    assert check.noise == pytest.approx(0.05, rel=0.5)


def test_noise_above_what_was_told_is_seen():
    checks = [goodness_of_fit(posterior(observations(noisy(seed, 0.15)), 0.05)) for seed in range(40)]
    # χ² is nine times as large, but up to three of the twelve pass for outliers: most are seen, not all.
    assert sum(not c.explained for c in checks) > 20


def test_rates_in_stretches_are_seen():
    """One and a half periods of a sine that no unknown gives, each point measured thrice."""
    which = np.repeat(np.arange(12), 3)
    wave = 1 + 0.06 * np.sin(np.linspace(0, 3 * math.pi, 12))
    data = Observations(CONDITIONS, which, (rates(TRUTH) * wave)[which], np.full(36, math.nan), np.zeros(36, bool))
    check = goodness_of_fit(posterior(data))
    assert check.p_runs < SIGNIFICANCE
    assert any("stretches" in text for text in check.complaints)


@pytest.mark.parametrize("slip", [10.0, 0.1, -1.0])
def test_a_slipped_point_or_a_lost_sign_is_named_and_leaves_the_noise_as_it_is(slip):
    rate = noisy(2, 0.03)
    clean = goodness_of_fit(posterior(observations(rate)))
    rate[4] *= slip
    check = goodness_of_fit(posterior(observations(rate)))
    assert check.outliers == (CONDITIONS[4].frequency,)
    assert check.explained
    # One point fewer of twelve moves the noise by its own error, a fifth; what is left out counts for nothing.
    assert check.noise < 1.25 * clean.noise


def test_one_slipped_decimal_does_not_turn_the_others_round():
    rate = np.array([70.0, 200, 450, -9000])
    curve = Curve("c", np.array([14.0, 18, 22, 23]), rate, np.full(4, math.nan), ("",) * 4, ("",) * 4)
    assert observe_curves([curve], [CHEESE.motion]).rate.tolist() == rate.tolist()


@pytest.mark.parametrize(("centre", "said"), [(26.0, ""), (22.0, "stayed at 24 Hz"), (30.0, "ran off at 25 Hz")])
def test_the_run_off_is_told_as_it_was_seen(centre, said):
    rate = noisy(3)
    failed = np.arange(12) == 11
    rate[11] = math.nan
    data = observations(rate, failed=failed) if said else observations(noisy(3))
    good = observations(noisy(3))
    run_off = RunOffEmulator(np.array([centre]), 0, 0.3)
    check = goodness_of_fit(_with(posterior(good), data, run_off))
    assert [said in text for text in check.run_offs] == ([True] if said else [])


def _with(sampled: Posterior, data: Observations, run_off: RunOffEmulator) -> Posterior:
    """Same samples beside other data, with a run-off."""
    likelihood = Likelihood(data, EMULATOR, {AMPLITUDE: run_off}, None)
    return Posterior(sampled.unknowns, data, sampled.u, sampled.noise, likelihood, sampled.runs, sampled.full)


def test_a_file_of_unexplained_data_says_so(tmp_path):
    sampled = posterior(observations(noisy(4)), 0.05)
    bad = Goodness(90.0, 12, 1e-9, 0.5, 0, 12, (), ("it ran off at 25 Hz, where whatever fits the rates stays",), 0.05)
    marginals = tuple(marginal_of(p, sampled.u[:, i]) for i, p in enumerate(sampled.unknowns.parameters))
    write_fragment(Estimate(sampled, marginals, bad, 0.9).to_fragment(), tmp_path / "bad.toml")
    first = (tmp_path / "bad.toml").read_text(encoding="utf-8").splitlines()[0]
    assert "NOT TO BE RELIED ON" in first
    assert "ran off at 25 Hz" in first
    assert "NOT TO BE RELIED ON" in read_fragment(tmp_path / "bad.toml").source
    read_toml(tmp_path / "bad.toml", "--with", "a fragment", "")  # and still is one
    write_fragment(Estimate(sampled, marginals, goodness_of_fit(sampled), 0.9).to_fragment(), tmp_path / "good.toml")
    assert "RELIED" not in (tmp_path / "good.toml").read_text(encoding="utf-8")


def test_its_picture_sets_run_offs_apart_and_an_outlier_by_its_mark():
    failed = np.arange(12) == 11
    rate = noisy(3)
    rate[11] = math.nan
    data = observations(rate, failed=failed)
    sampled = posterior(observations(noisy(3)))
    shown = Posterior(sampled.unknowns, data, sampled.u, sampled.noise, sampled.likelihood, sampled.runs, sampled.full)
    outlier = float(data.frequency[5])
    bad = Goodness(90.0, 12, 1e-9, 0.5, 1, 11, (outlier,), ("costs $5 or $6",), 0.05)
    marginals = tuple(marginal_of(p, sampled.u[:, i]) for i, p in enumerate(sampled.unknowns.parameters))
    frequency = np.linspace(13.0, 26.0, 20)
    rates_there = np.tile(20 * frequency, (30, 1))
    conditions = tuple(replace(data.conditions[0], frequency=float(f)) for f in frequency)
    predicted = Prediction(AMPLITUDE, conditions, rates_there, np.zeros((30, 20), bool))
    figure = plot_estimate(Estimate(shown, marginals, bad, 0.9), [predicted])
    assert_legible(figure)
    axes = figure.axes[0]
    (band,) = (line for line in axes.get_lines() if line.get_gid() == "failed")
    np.testing.assert_array_equal(band.get_xdata(), data.frequency[failed])
    assert "$A_p$" in axes.get_title(loc="left")
    assert outlier in [line.get_xdata()[0] for line in axes.get_lines() if line.get_marker() == "D"]
    assert {"ran off", "measured", "probably an outlier"} <= {text.get_text() for text in figure.legends[0].get_texts()}
    assert r"\$5 or \$6" in figure.get_suptitle()
