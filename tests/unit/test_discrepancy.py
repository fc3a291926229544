"""Model error: what other models change is learnt from their runs, allowed for in any amount, and found again."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.stats import multivariate_normal

from plategait.curve.curve import Curve
from plategait.curve.protocol import measured_as
from plategait.errors import InputError
from plategait.estimate import discrepancy as discrepancy_module
from plategait.estimate.discrepancy import (
    ALTERNATIVES,
    OWN_RUN_OFF,
    OWN_SLIDING,
    OWN_WALKING,
    PRESUMED,
    Discrepancy,
    measure_discrepancy,
    presumed_discrepancy,
)
from plategait.estimate.emulator import RateEmulator
from plategait.estimate.likelihood import Likelihood
from plategait.estimate.observations import Condition, Observations
from plategait.estimate.result import estimate_parameters
from plategait.estimate.runs import EngineRuns
from plategait.model.presets import preset

pytestmark = pytest.mark.linear_algebra

CHEESE = measured_as(preset("cheese").scenario)
CONDITIONS = tuple(Condition(0.05, 0.003, f) for f in (14.0, 16.0, 18.0, 20.0, 22.0, 24.0))
AMPLITUDE = CONDITIONS[0].amplitude
SD = 3.0
# Of the rates, by the first alternative: a third at slow sliding, nothing when walking; and by the first parameter.
CHANGE = np.array([0.3, 0.2, 0.1, 0.0, 0.0, 0.0])
SLOPE = np.array([0.2, 0.1, 0.0, 0.0, 0.0, 0.1])


def rates(u) -> np.ndarray:
    return 100 + 80 * np.asarray(u)[:, :1] + 50 * np.asarray(u)[:, 1:] * np.linspace(-1, 1, 6)


def runs(u, change=0.0, failing_from=23.0) -> EngineRuns:
    failed = np.tile([c.frequency > failing_from for c in CONDITIONS], (len(u), 1))
    return EngineRuns(u, CONDITIONS, np.where(failed, math.nan, rates(u) * (1 + change)), failed)


U = np.random.default_rng(0).random((24, 2))


def measured(share=1.0, failing_from=23.0) -> Discrepancy:
    own = runs(U)
    first, second = ALTERNATIVES
    others = {first.applied: runs(U, CHANGE + SLOPE * U[:, :1], failing_from), second.applied: runs(U)}
    return measure_discrepancy(lambda change: others[change], own, share)


def test_a_change_and_its_slope_are_learnt():
    u = np.array([[0.2, 0.5], [0.8, 0.1]])
    changes = measured().changes(u)
    # Linear in the parameters: exact but for the slope's ridge, which takes 0.1 of 24 · 1/12 pairs.
    np.testing.assert_allclose(changes[:, 0, :5], (CHANGE + SLOPE * u[:, :1])[:, :5], atol=0.01)
    np.testing.assert_allclose(changes[:, 1], 0.0, atol=1e-9)
    np.testing.assert_allclose(measured(0.5).changes(u), 0.5 * changes)


def test_where_all_runs_failed_the_change_is_that_of_the_frequency_beside():
    changes = measured().changes(U)
    np.testing.assert_array_equal(changes[:, :, 5], changes[:, :, 4])


def test_how_far_the_run_off_may_be_off():
    # Brackets of 22 to 24 Hz; with the other model 20 to 22: 2 Hz lower, and what nothing explains beside.
    own = OWN_RUN_OFF * 23.0
    assert measured().run_off(AMPLITUDE) == pytest.approx(own)
    assert measured(failing_from=21.0).run_off(AMPLITUDE) == pytest.approx(math.hypot(2.0, own))
    assert measured(0.5, failing_from=21.0).run_off(AMPLITUDE) == pytest.approx(0.5 * math.hypot(2.0, own))


def test_before_any_other_model_is_run_a_scatter_is_presumed():
    found = presumed_discrepancy(runs(U), 0.5)
    own = np.array([OWN_SLIDING, *[OWN_WALKING] * 5])  # 14 Hz at 0.05 rad is slow sliding, 16 Hz no more
    np.testing.assert_allclose(found.own, 0.5 * np.hypot(own, PRESUMED))
    assert found.run_off(AMPLITUDE) == pytest.approx(0.5 * OWN_RUN_OFF * 23.0)
    # Without a shape there is no amount, and each rate is off by itself: a normal of both spreads.
    u = np.array([[0.4, 0.6]])
    rate, wide = rates(u)[0] + 3.0, math.hypot(SD, float(found.own[0]) * rates(u)[0, 0])
    deviation, amounts = likelihood(rate, found).deviations(u)
    assert deviation[0, 0] == pytest.approx(3.0 / wide)
    assert amounts.shape == (1, 0)


def likelihood(rate, discrepancy, sd=SD) -> Likelihood:
    data = Observations(CONDITIONS, np.arange(6), np.asarray(rate), np.full(6, sd), np.zeros(6, bool))
    return Likelihood(data, RateEmulator(((np.arange(6), rates),), np.zeros(6)), {}, None, discrepancy)


def test_the_likelihood_is_the_normal_of_a_model_that_is_off_by_any_amount():
    """Amounts integrated over in closed form: covariances of the noise, of each rate by itself, and of the changes."""
    found = measured()
    rate = rates(np.array([[0.4, 0.6]]))[0] + np.random.default_rng(1).normal(0, SD, 6)
    u = np.random.default_rng(2).normal([0.4, 0.6], 0.02, (40, 2))
    expected = []
    for one in u:
        mean = rates(one[None])[0]
        shapes = found.changes(one[None])[0] * mean
        covariance = np.diag(SD**2 + (found.own * mean) ** 2) + shapes.T @ shapes
        expected.append(multivariate_normal.logpdf(rate, mean, covariance))
    # But for the few in a hundred that an outlier's share takes off each point.
    difference = likelihood(rate, found)(u) - np.array(expected)
    assert np.ptp(difference) < 0.15
    assert abs(difference.mean()) < 0.3


@pytest.mark.parametrize("amount", [0.0, 1.0])
def test_the_amount_that_the_data_take_is_found(amount):
    u = np.array([[0.4, 0.6]])
    rate = rates(u)[0] * (1 + amount * (CHANGE + SLOPE * 0.4))
    _, amounts = likelihood(rate, measured(), sd=0.3).deviations(u)
    # The prior of one standard deviation and what each rate is off by itself hold it back by a few percent.
    assert amounts[0, 0] == pytest.approx(amount, abs=0.1)


def test_an_outlier_pulls_at_no_amount():
    u = np.array([[0.4, 0.6]])
    rate = rates(u)[0].copy()
    rate[0] *= 10
    _, amounts = likelihood(rate, measured()).deviations(u)
    assert abs(amounts[0, 0]) < 0.3


def test_each_alternative_is_another_model_of_the_same_object():
    for alternative in ALTERNATIVES:
        other = alternative.applied(CHEESE)
        assert other != CHEESE
        assert other.sheet.natural_frequency == pytest.approx(CHEESE.sheet.natural_frequency, rel=1e-6)
        assert other.sheet.mass == CHEESE.sheet.mass
        assert other.friction.angle == CHEESE.friction.angle


def test_what_no_alternative_explains_is_scatter(monkeypatch):
    generator = np.random.default_rng(3)
    jagged = runs(U, 0.2 * generator.normal(size=(24, 6)))
    found = measure_discrepancy(lambda _: jagged, runs(U), 1.0)
    # Two alternatives of 20 % each, learnt of 24 pairs: to their own 15 %.
    np.testing.assert_allclose(found.own, math.hypot(0.2, 0.2, OWN_WALKING), rtol=0.35)
    for name in ("OWN_SLIDING", "OWN_WALKING"):
        monkeypatch.setattr(discrepancy_module, name, 0.0)
    assert measure_discrepancy(lambda _: runs(U), runs(U), 1.0).own.max() < 1e-12


@pytest.mark.parametrize("share", [-0.1, 11])
def test_a_share_out_of_range_is_refused(share):
    f, unknown = np.array([14.0, 18.0, 22.0]), np.full(3, math.nan)
    with pytest.raises(InputError, match="model_error"):
        estimate_parameters(Curve("c", f, 10 * f, unknown, ("",) * 3, ("",) * 3), CHEESE, model_error=share)
