from __future__ import annotations

import math
import re
from types import SimpleNamespace

import numpy as np
import pytest
from legible import assert_legible

from plategait.curve.curve import RUN_OFF, Curve
from plategait.curve.lorentz import fit_lorentzian, lorentzian
from plategait.curve.quick_lorentz import fit_shape
from plategait.errors import InputError
from plategait.published import Number
from plategait.thesis import draw
from plategait.thesis.cases import VARIANTS, Case, damping_variant, fitted_cases, reference_cases
from plategait.thesis.item import Check, Comparison, verdict
from plategait.thesis.items.friction import best_friction
from plategait.thesis.page import prepare_folder
from plategait.thesis.regressions import regress, two_sided_p
from plategait.thesis.report import write_report
from plategait.thesis.runs import run_cases
from plategait.thesis.study import NAMES, reproduce


def test_a_regression_agrees_with_scipy():
    from scipy.stats import linregress

    generator = np.random.default_rng(3)
    x = generator.uniform(0, 10, 25)
    y = 2 * x - 1 + generator.normal(0, 1, 25)
    ours, theirs = regress(x, y), linregress(x, y)
    assert ours.slope == pytest.approx(theirs.slope)
    assert ours.intercept == pytest.approx(theirs.intercept)
    assert ours.r2 == pytest.approx(theirs.rvalue**2)
    assert ours.slope_error == pytest.approx(theirs.stderr)
    assert ours.intercept_error == pytest.approx(theirs.intercept_stderr)
    assert ours.t_slope()[1] == pytest.approx(theirs.pvalue)


def test_the_band_of_a_regression_holds_the_true_line_as_often_as_it_says():
    generator = np.random.default_rng(5)
    x, held = np.linspace(0, 1, 12), []
    for _ in range(600):
        low, high = regress(x, 3 * x + generator.normal(0, 0.5, 12)).band(0.8)
        held.append(low <= 2.4 <= high)
    assert np.mean(held) == pytest.approx(0.95, abs=0.03)


def test_a_regression_leaves_out_what_is_not_known_and_refuses_too_few_points():
    assert regress([0, 1, 2, 3], [0, 1, 2, math.nan]).freedom == 1
    with pytest.raises(InputError, match="points"):
        regress([0, 1], [0, 1])


def test_what_failed_on_a_curve_lies_in_a_band_under_its_panel_and_legends_stand_beside():
    case = Case(12)
    failed = np.arange(len(case.frequencies)) >= 6
    curve = Curve("c", np.array(case.frequencies), np.where(failed, np.nan, 100.0), np.full(len(failed), 2.0),
                  tuple("walking" for _ in failed), tuple("folded" if each else "" for each in failed))  # fmt: skip
    runs = SimpleNamespace(curve=curve, fit=None, case=case)
    figure, (axes,) = draw.panels(1)
    x = np.linspace(1.0, 2.0, len(failed))
    failures = draw.curve(axes, runs, x, draw.COLOURS[1], "$A_p$ = 12 deg")  # type: ignore[arg-type]
    np.testing.assert_array_equal(failures.x, x[failed])
    draw.plain(axes, "$x$", draw.RATE)
    draw.finish(axes, [failures])
    assert_legible(figure)
    (band,) = (line for line in axes.get_lines() if line.get_gid() == "failed")
    assert len(band.get_xdata()) == failed.sum()
    assert "folded" in [text.get_text() for text in axes.get_legend().get_texts()]
    assert axes.get_lines()[0].get_linestyle() == "--", "told by its dash too"


def test_two_sided_p():
    assert two_sided_p(2.0739, 22) == pytest.approx(0.05, abs=1e-4)


def test_the_fast_fit_finds_the_minimum_of_the_full_one():
    generator = np.random.default_rng(1)
    f = np.arange(13.0, 29.0)
    for _ in range(20):
        y = lorentzian(f, 600, generator.uniform(22, 27), generator.uniform(4, 6)) + generator.normal(0, 20, len(f))
        fast, full = fit_shape(f, y), fit_lorentzian(f, y, ends_in_failure=True)
        assert fast is not None
        assert (fast.f0_hz, fast.half_width_hz, fast.peak) == pytest.approx(
            (full.f0_hz, full.half_width_hz, full.peak), rel=1e-4
        )
        assert fast.r2 == pytest.approx(full.r2, abs=1e-6)


@pytest.mark.parametrize("rate", [[0.0] * 8, [1.0, 2, 3, 4, 5, 6, 7, 8], [8.0, 7, 6, 5, 4, 3, 2, 1]])
def test_the_fast_fit_finds_no_peak_where_there_is_none_to_see(rate):
    assert fit_shape(np.arange(13.0, 21.0), rate) is None


def test_cases_are_those_of_the_source():
    assert len(fitted_cases()) == len(set(fitted_cases())) == 44
    assert len(reference_cases()) == 8
    cheese = Case(3, 10.0).scenario
    assert cheese.sheet.bending_stiffness * math.pi / 180 * 1e3 == pytest.approx(2.72e-3, rel=1e-6)
    assert cheese.friction.static == pytest.approx(0.75, abs=1e-3)
    assert cheese.friction.ratio == pytest.approx(0.53)
    stiff = Case(12, 20.0).scenario.sheet
    assert stiff.bending_stiffness == pytest.approx(4 * cheese.sheet.bending_stiffness)
    assert stiff.mass == cheese.sheet.mass


@pytest.mark.parametrize("variant", [*VARIANTS, damping_variant(0.5)])
def test_every_variant_changes_the_scenario(variant):
    base = Case(12, 3.5)
    assert base.but(variant).scenario.replace(name="same") != base.scenario.replace(name="same")


def test_damping_of_one_is_the_base_itself():
    assert Case(3).but(damping_variant(1.0)) == Case(3)


def test_the_best_friction_angle_is_the_vertex_of_a_parabola():
    alphas = np.array([10.0, 20, 30, 40, 50])
    assert best_friction(alphas, 100 - (alphas - 33) ** 2) == pytest.approx(33)
    assert best_friction(alphas, alphas) == 50
    assert math.isnan(best_friction(alphas, np.full(5, math.nan)))


def test_a_verdict_says_what_does_not_hold():
    good = Comparison("p1", Number(5.3, "section 5.6.1"), 5.4, 0.1)
    bad = Comparison("q1", Number(-100.0, "section 5.6.1"), -150.0, 0.1)
    unknown = Comparison("f0", Number(24.0, "Table 5.1"), math.nan, 0.1)
    assert (good.holds, bad.holds, unknown.holds) == (True, False, False)
    assert bad.deviation == pytest.approx(-0.5)
    assert verdict([good]) == "Reproduced."
    assert verdict([good, bad]) == "Partly reproduced: 1 of 2 hold (not: q1)."
    assert verdict([bad], [Check("x", "y", "z", False)]) == "Not reproduced."


def test_runs_are_shared_and_ensembles_have_a_spread():
    case = Case(2, preset="pancake")
    results = run_cases([case, case], repeats=2, seed=0)
    assert list(results.runs) == [case]
    assert len(results[case].observations[0]) == 2
    assert results.simulated == pytest.approx(2 * 1.6, rel=0.01)
    assert RUN_OFF == 3


def test_an_unknown_name_is_refused_with_the_nearest_one():
    with pytest.raises(InputError, match=re.escape("try fig5.7")):
        reproduce(["fig57"])


def test_a_folder_that_cannot_be_made_is_refused_before_the_work(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="--out"):
        prepare_folder(tmp_path / "file" / "below")


def test_a_cheap_report_is_whole(tmp_path):
    study = reproduce(["fig2.6", "Table4.1", "fig5.3"], repeats=1)
    page = write_report(study, tmp_path / "out").read_text(encoding="utf-8")
    assert [item.name for item in study.items] == ["fig2.6", "table4.1", "fig5.3"]
    assert page.count("data:image/png;base64,") == 2
    assert "http" not in page.replace("http-equiv", "")
    assert "36.87 deg: the text gives f0 = 28.2 Hz" in page
    assert sorted(p.name for p in (tmp_path / "out").iterdir()) == [
        "fig2.6.csv", "fig2.6.png", "fig5.3.png", "report.html", "table4.1-comparison.csv", "table4.1.csv",
    ]  # fmt: skip
    assert all(item["verdict"] for item in study.summary()["items"])


def test_names_are_unique():
    assert len(NAMES) == len(set(NAMES))
