"""The published numbers against each other, and the regenerated ones against what is asked of them."""

from __future__ import annotations

import json

import numpy as np
import pytest

from plategait import published
from plategait.estimate import training
from plategait.estimate.shipped import shipped
from plategait.thesis import reproduce
from plategait.thesis.fits import published_fits
from plategait.thesis.regressions import regress
from plategait.thesis.report import write_report
from plategait.thesis.study import NAMES


@pytest.mark.parametrize("angle", published.AMPLITUDES)
def test_the_published_estimates_give_the_published_regressions_back(angle):
    printed, fits = published.regression(angle), published_fits(angle)
    for line, slope, intercept, r2 in ((fits.of_omega, "p1", "q1", "r2_f0"), (fits.of_alpha, "p2", "q2", "r2_ratio")):
        assert line.slope == pytest.approx(printed[slope].value, rel=5e-3)
        assert line.intercept == pytest.approx(printed[intercept].value, rel=5e-3)
        assert line.r2 == pytest.approx(printed[r2].value, abs=6e-3)
    assert regress(fits.half_width_hz, fits.alpha_deg).r2 == pytest.approx(printed["r2_width"].value, abs=6e-3)


@pytest.mark.parametrize("angle", published.AMPLITUDES)
def test_the_published_estimates_give_the_published_tests_back(angle):
    printed = published.regression(angle)
    curves = [c for c in published.curves() if c.angle_deg == angle]
    line = regress([c.alpha_deg for c in curves], [c.alpha_estimate_deg for c in curves])
    assert line.freedom == printed["freedom"].value
    # The tables are rounded, and one of their estimates is off by 0.02 deg; at 3 deg t comes out 4 % higher.
    assert line.t_slope()[0] == pytest.approx(printed["t_slope"].value, rel=0.04)
    assert line.t_intercept()[0] == pytest.approx(printed["t_intercept"].value, rel=0.07)
    assert line.t_slope(1.0)[0] == pytest.approx(printed["t_unit_slope"].value, rel=0.12)
    omega = regress([c.omega_pi for c in curves], [c.omega_estimate_pi for c in curves])
    assert omega.slope == pytest.approx(printed["slope_omega"].value, abs=6e-3)
    assert omega.intercept == pytest.approx(printed["intercept_omega"].value, abs=6e-3)


def test_the_printed_errors_are_those_of_the_estimates_but_for_one_slip():
    off = []
    for c in published.curves():
        assert abs(c.omega_estimate_pi - c.omega_pi) == pytest.approx(c.omega_error_pi, abs=5e-3)
        if abs(abs(c.alpha_estimate_deg - c.alpha_deg) - c.alpha_error_deg) > 5e-3:
            off.append((c.table, c.alpha_deg))
    assert off == [("5.4", 36.87)]
    for table, (omega, alpha) in published.numbers()["average_errors"].items():
        rows = [c for c in published.curves() if c.table == table]
        assert np.mean([c.omega_error_pi for c in rows]) == pytest.approx(omega, abs=6e-3)
        assert np.mean([c.alpha_error_deg for c in rows]) == pytest.approx(alpha, abs=6e-3)


def test_appendix_a_covers_every_curve():
    assert [sum(c.r2_table == t for c in published.curves()) for t in ("A.1", "A.2")] == [24, 20]
    assert all(0.97 <= c.r2 <= 0.99 for c in published.curves())


def test_the_bending_frequencies_of_table_5_9_are_half_of_omega():
    for _, omega, f_n, peak, f_b in published.numbers()["rotation"]["rows"]:
        assert f_n == pytest.approx(omega / 2)
        assert f_b == pytest.approx(peak / 360, abs=6e-3)


@pytest.fixture(scope="module")
def study():
    # Some 30 s: every item, from 5000 runs. Two starts of each instead of the report's four give the same verdicts in
    # half the time.
    return reproduce(seed=1, repeats=1)


def test_every_item_has_a_verdict_and_the_report_is_whole(study, tmp_path):
    assert tuple(item.name for item in study.items) == NAMES
    assert all(item.verdict for item in study.items)
    page = write_report(study, tmp_path).read_text(encoding="utf-8")
    assert all(f'id="{name}"' in page for name in NAMES)
    assert page.count("data:image/png;base64,") == sum(len(item.figures) for item in study.items)
    summary = json.loads(json.dumps(study.summary(), allow_nan=False))
    assert [item["name"] for item in summary["items"]] == list(NAMES)


@pytest.mark.parametrize("what", ["every curve has a fit", "median |Δf0|", "median |Δ(b/f0)|",
                                  "R² of ω_n on f0, A_p = 3 deg", "R² of α on b/f0, A_p = 12 deg"])  # fmt: skip
def test_targets_that_are_met_stay_met(study, what):
    check = next(c for c in study["targets"].checks if c.what == what)
    assert check.holds, check.measured


def test_all_peaks_of_table_5_9_are_within_15_per_cent(study):
    assert not [c.quantity for c in study["table5.9"].comparisons if not c.holds]


def test_what_is_known_to_differ_is_reported_so(study):
    # Reported as it is, not bent: should one of these come right, the report's notes must change with it.
    assert not study["fig5.9"].reproduced
    assert not study["fig4.8"].reproduced


# Objects of which the starts agree to 2e-4 in f0 and to 4e-4 in b/f0: chaos moves little more by another processor's
# rounding, and any change of physics that is worth a new training moves more.
@pytest.mark.parametrize(("angle", "omega_pi", "alpha_deg"), [(3, 33, 33.02), (12, 3.5, 24.23)])
def test_the_training_fits_are_those_of_this_engine(angle, omega_pi, alpha_deg):
    (curve,) = (c for c in published.curves() if (c.angle_deg, c.omega_pi, c.alpha_deg) == (angle, omega_pi, alpha_deg))
    (shipped,) = (
        f for f in training.shipped_fits() if (f.angle_deg, f.omega_pi, f.alpha_deg) == (angle, omega_pi, alpha_deg)
    )
    fresh = training.simulated_fit(curve)
    assert fresh is not None
    outdated = "the engine has changed since the linear method was trained: run python -m plategait.estimate.training"
    assert fresh.f0_hz == pytest.approx(shipped.f0_hz, rel=2e-3), outdated
    assert fresh.b_over_f0 == pytest.approx(shipped.b_over_f0, rel=5e-3), outdated


@pytest.mark.linear_algebra
def test_the_shipped_coefficients_are_those_of_the_training_fits():
    fits = training.shipped_fits()
    assert len(fits) == len(published.curves())
    assert training.fits_as_csv(fits) == shipped("fits.csv")
    assert training.coefficients_as_toml(fits) == shipped("coefficients.toml")
