"""The study of the source's unknowns: its parts against closed forms, its whole on a toy that stands for the engine."""

import math
from functools import partial

import numpy as np
import pytest

from plategait import InputError, published
from plategait.campaign.plan import Sweep
from plategait.campaign.run import sweep
from plategait.curve.curve import Curve
from plategait.study import findings, polish, search, source
from plategait.study.aims import AT_REFERENCE, HAS_FIT, KIND, OF_CURVE, PEAKS, residuals
from plategait.study.evaluation import (
    FITS_FROM,
    Evaluation,
    base,
    evaluate,
    out_of_order,
    printed_values,
    short_of_running,
)
from plategait.study.findings import Findings
from plategait.study.inference import backward, smallest, step_with
from plategait.study.surrogate import learn
from plategait.study.unknowns import LAWS, NAMES, UNKNOWNS, Choice, choice_at, deviations_of, parameters

CURVES = published.curves()
PUBLISHED = np.array([[c.f0_hz, c.b_over_f0, PEAKS[c.angle_deg, c.omega_pi]] for c in CURVES])

IN_ORDER = np.zeros((1, 5))
AS_PUBLISHED = Findings(np.zeros(8), np.array([40.0, 60.0, 30.0]), 0.0, 0.0)


def test_a_choice_and_its_deviations_are_each_other_s_inverse():
    z = np.random.default_rng(0).uniform(0, 2, len(UNKNOWNS))
    np.testing.assert_allclose(deviations_of(choice_at(z)), z, rtol=1e-12)  # round-off
    np.testing.assert_allclose(deviations_of(Choice({})), 0, atol=1e-15)


def test_the_prior_s_quantiles_are_those_of_a_normal_or_of_its_upper_half():
    shares = np.array([0.1587, 0.5, 0.8413])
    two_sided, one_sided = (next(u for u in UNKNOWNS if u.one_sided is side) for side in (False, True))
    np.testing.assert_allclose(two_sided.quantile(shares), [-1, 0, 1], atol=1e-3)
    np.testing.assert_allclose(one_sided.quantile(np.array([0.0, 0.6827])), [0, 1], atol=1e-3)


def test_as_printed_sets_what_is_printed():
    printed = printed_values()
    settled = parameters(Choice({}), printed, published.NOMINAL_NATURAL_FREQUENCY)
    assert {name: settled[name] for name in printed} == printed
    assert settled["sheet.torsion_stiffness"] == settled["motion.height"] == 0
    stiffer = parameters(Choice({"k_c exponent": 1.0}), printed, 2 * published.NOMINAL_NATURAL_FREQUENCY)
    assert stiffer["sheet.axial_stiffness"] == 2 * printed["sheet.axial_stiffness"]
    assert stiffer["sheet.bending_stiffness"] == 4 * printed["sheet.bending_stiffness"]


def test_a_quadratic_is_learnt_to_the_last_digit():
    rng = np.random.default_rng(1)
    x = rng.normal(size=(60, 3))
    y = 1 + x @ [1, -2, 0.5] + 3 * x[:, 0] * x[:, 1] - x[:, 2] ** 2
    surrogate = learn(x, y[:, None])
    new = rng.normal(size=(5, 3))
    wanted = 1 + new @ [1, -2, 0.5] + 3 * new[:, 0] * new[:, 1] - new[:, 2] ** 2
    # The smallest penalty, 0.01 beside 60 evaluations, shrinks coefficients by that over their number.
    np.testing.assert_allclose(surrogate(new)[:, 0], wanted, atol=5e-3)
    assert surrogate.error[0] < 5e-3


def test_the_error_is_that_of_evaluations_that_were_left_out():
    rng = np.random.default_rng(2)
    x = rng.normal(size=(40, 2))
    y = x[:, 0] + rng.normal(0, 0.3, 40)
    error = learn(x, y[:, None]).error[0]
    left_out = [learn(np.delete(x, i, 0), np.delete(y, i)[:, None])(x[i : i + 1])[0, 0] - y[i] for i in range(40)]
    # The penalty is chosen anew each time, and the mean that is taken off first: a few percent.
    assert error == pytest.approx(float(np.sqrt(np.mean(np.square(left_out)))), rel=0.1)


def test_what_few_evaluations_have_is_not_learnt():
    x = np.random.default_rng(3).normal(size=(20, 2))
    y = np.where(np.arange(20) < 5, 1.0, math.nan)
    assert learn(x, y[:, None]).error[0] == math.inf


def test_the_published_fits_meet_their_own_aims():
    aims = residuals(PUBLISHED[None], np.array([350.0]), IN_ORDER)
    assert aims.values.shape == (1, len(KIND))
    assert np.abs(aims.values[0, OF_CURVE]).max() < 1e-9
    # The regressions were printed to a few digits.
    for kind in ("R² of ω_n", "R² of α", "line", "12 Hz"):
        assert np.abs(aims.values[0, kind == KIND]).max() < 0.2, kind
    assert AT_REFERENCE.sum() == 2 * sum(c.alpha_deg == published.REFERENCE_ALPHA for c in CURVES)


def test_a_curve_without_a_fit_counts_and_spoils_no_other():
    fits = PUBLISHED.copy()
    fits[3] = math.nan
    aims = residuals(fits[None], np.array([math.nan]), IN_ORDER)
    assert np.isfinite(aims.values).all()
    # Three deviations of f0 and three of b/f0.
    np.testing.assert_allclose(aims.values[0, HAS_FIT] ** 2, 18 * (np.arange(len(CURVES)) == 3), rtol=1e-12)
    assert np.abs(aims.values[0, OF_CURVE]).max() < 1e-9


# A toy in place of the engine: every f0 goes with k_t/k_b, every width with c_b, and the truth is a known choice

TRUTH = {"k_t/k_b": 0.3, "c_b factor": 4.0}


def toy(choices, folder, name, starts=0, **options) -> tuple[Evaluation, ...]:
    fits = np.empty((len(choices), len(FITS_FROM), len(CURVES), 3))
    for i, choice in enumerate(choices):
        torsion = (choice["k_t/k_b"] - TRUTH["k_t/k_b"]) / 3
        damping = 0.2 * math.log(choice["c_b factor"] / TRUTH["c_b factor"])
        fits[i] = PUBLISHED * np.exp([torsion, damping, 0.0])
        fits[i] *= 1 + 0.1 * (choice.law == LAWS[1])
    at_12, gaits = np.full(len(choices), 350.0), np.zeros((len(choices), 5))
    return (Evaluation(tuple(choices), fits, at_12, gaits),) * (1 + starts)


@pytest.fixture(scope="module")
def found(tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(search, "evaluate", toy)
        return search.search(tmp_path_factory.mktemp("toy"), 0, first=96, generations=6)


def test_the_search_finds_the_departures_that_the_toy_was_made_with(found):
    # Half of the unknowns: each costs as many fits as there are.
    among = (*TRUTH, *[name for name in NAMES if name not in TRUTH][::3])
    steps = backward(found, LAWS[0], among)
    assert [len(step.free) for step in steps] == list(range(len(among) + 1))
    chosen = smallest(steps)
    assert set(chosen.free) == set(TRUTH)
    for name, value in TRUTH.items():
        # The prior draws a little towards what is printed.
        assert chosen.choice[name] == pytest.approx(value, rel=0.15)
    assert chosen.misfit < 0.1 * steps[0].misfit
    assert step_with(found, chosen.free, LAWS[1]).misfit > chosen.misfit


def test_the_posterior_tells_what_the_toy_leaves_open(found, monkeypatch):
    monkeypatch.setattr(search, "STEPS", 150)
    monkeypatch.setattr(search, "BURNT", 75)
    samples = search.posterior(found, LAWS[0], seed=1)
    sd = dict(zip(NAMES, samples.std(axis=0), strict=True))
    assert sd["k_t/k_b"] < 0.2 < 0.6 < sd["ramp"]
    assert (samples[:, [u.one_sided for u in UNKNOWNS]] >= 0).all()
    again = search.posterior(found, LAWS[0], seed=1)
    np.testing.assert_array_equal(samples, again)


def test_the_whole_study_says_what_holds_out_of_sample(tmp_path, monkeypatch):
    for module in (search, polish, source):
        monkeypatch.setattr(module, "evaluate", toy)
    monkeypatch.setattr(source, "find", lambda choices, *_, **__: (AS_PUBLISHED,) * len(choices))
    monkeypatch.setattr(search, "STEPS", 60)
    monkeypatch.setattr(search, "BURNT", 30)
    monkeypatch.setattr(source, "polish", partial(polish.polish, rounds=1))
    study = source.study_source(tmp_path, seeds=2, first=64, generations=4)
    assert set(study.chosen.free) == set(TRUTH)
    assert len(study.by_seed) == 2
    for each in study.out_of_sample:
        assert each.median_f0 < 0.015
        assert each.missing == 0
    printed, chosen = (next(t for t in study.told if t.name == name) for name in ("as printed", "found on all curves"))
    assert chosen.loss[0] < 0.1 * printed.loss[0]
    assert study.summary()["unknowns"]["k_t/k_b"]["determined"]
    assert not study.summary()["unknowns"]["ramp"]["determined"]


def test_the_strategy_goes_down_and_the_same_way_again(found, tmp_path, monkeypatch):
    loss = search.losses(found.evaluation)
    assert loss[96:].min() < 0.2 * loss[:96].min()
    monkeypatch.setattr(search, "evaluate", toy)
    again = search.search(tmp_path, 0, first=96, generations=2).evaluation.choices
    assert again == found.evaluation.choices[: len(again)]


def test_numbers_out_of_range_are_refused(tmp_path):
    with pytest.raises(InputError, match="seeds"):
        source.study_source(tmp_path, seeds=0)
    with pytest.raises(InputError, match="evaluations"):
        source.study_source(tmp_path, first=10)


def test_the_preset_s_curves_are_those_of_the_thesis(tmp_path, monkeypatch):
    """The same curves by another way, a campaign's: Table 4.1's sheet at both amplitudes."""
    from plategait.thesis.cases import Case
    from plategait.thesis.runs import run_cases, value_of

    some = tuple(c for c in CURVES if c.omega_pi == 10.0 and c.alpha_deg == published.REFERENCE_ALPHA)
    cases = [Case(c.angle_deg, 10.0, c.alpha_deg) for c in some]
    results = run_cases(cases, repeats=1, seed=0)
    monkeypatch.setattr(published, "curves", lambda: some)
    (made,) = evaluate([source.ONE_AT_A_TIME], tmp_path, "today")
    assert len(some) == made.fits.shape[2] == 2
    for i, case in enumerate(cases):
        # Round-off in k_b; the thesis's curves at 3 deg end 0.5 Hz earlier.
        assert made.fits[0, 0, i, 0] == pytest.approx(value_of(results[case].fit, "f0_hz"), rel=0.01)


def with_gaits(gaits: str, failed: int = 1) -> Curve:
    """A curve whose points slide, walk and run as the letters say, and that then fails."""
    names = {"s": "sliding", "w": "walking", "r": "running"}
    n = len(gaits) + failed
    return Curve(
        name="gaits",
        frequency_hz=np.arange(9.0, 9.0 + n),
        spin_rate_deg_s=np.arange(1.0, n + 1.0),
        spin_rate_sd_deg_s=np.ones(n),
        gait=(*(names[g] for g in gaits), *[""] * failed),
        failure=("",) * len(gaits) + ("slipped",) * failed,
    )


@pytest.mark.parametrize(
    ("gaits", "wanted", "short"), [("sswwrr", 0, 0), ("sswrw", 1, 3), ("ssww", 3, 3), ("ssrs", 5, 6)]
)
def test_gaits_out_of_order_and_absent_are_counted(gaits, wanted, short):
    assert out_of_order(with_gaits(gaits)) == wanted
    # The fastest point is the last before the failure.
    assert short_of_running(with_gaits(gaits)) == short


def test_a_store_tells_each_start_apart(tmp_path):
    plan = Sweep(scenario=base(), points={"motion.frequency": [14.0, 24.0]}, repeats=3)
    opened = sweep(plan, tmp_path / "starts.zarr")
    apart = np.stack([opened.from_start(k).rate for k in range(3)], axis=1)
    assert len(set(apart[1])) == 3
    np.testing.assert_allclose(apart.mean(axis=1), opened.outcomes.rate, rtol=1e-12)  # round-off


def test_findings_as_published_cost_nothing_and_missing_ones_three_deviations_each():
    assert AS_PUBLISHED.loss() == 0
    missing = Findings(np.full(8, math.nan), np.full(3, math.nan), math.nan, math.nan)
    assert missing.loss() == 9 * (8 + 3 + 1 + 1)
    assert missing.summary()["best_friction_deg"] == {"sliding": None, "walking": None, "running": None}


def test_findings_are_read_off_curves_of_a_known_law():
    """Rates that peak at 8e4 deg/s² and α = 40 deg and go as B_p^0.5, with b/f0 a fifth larger at the most damping."""

    def made(line: findings._Line) -> Curve:
        case, f = line.case, np.array(line.frequencies)
        acceleration = case.angle_deg * (math.tau * f) ** 2 / 1e4
        width = 4 * findings.damping_factor(case.variant) ** (math.log(1.2) / math.log(8))
        over_frequency, over_acceleration = 1 / (1 + ((f - 24) / width) ** 2), 1 / (1 + (acceleration / 8 - 1) ** 2)
        rate = 400 * math.exp(-(((case.alpha_deg - 40) / 30) ** 2)) * (line.stroke / findings.STROKE) ** 0.5
        rate = rate * (over_frequency if case.variant else over_acceleration)
        gait = np.select([acceleration < 6, acceleration < 8], ["sliding", "walking"], "running")
        return Curve(name="", frequency_hz=f, spin_rate_deg_s=rate, spin_rate_sd_deg_s=np.ones(len(f)),
                     gait=tuple(gait.tolist()), failure=("",) * len(f))  # fmt: skip

    found = findings._findings({line: made(line) for line in findings._lines()})
    np.testing.assert_array_equal(found.acceleration_gap, 0)
    # The parabola through three of eleven angles is not the Gaussian.
    np.testing.assert_allclose(found.friction_deg, 40, atol=1.0)
    assert found.stroke_exponent == pytest.approx(0.5, rel=1e-9)
    # Those of η = 1 are the reference curves, of another width: only the ends count.
    assert found.damping_change == pytest.approx(0.2, rel=1e-3)
