"""Figures say what was measured: markers by gait, failures shown apart, fits drawn."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from plategait.curve.curve import Curve
from plategait.curve.lorentz import lorentzian
from plategait.curve.spin_curve import fit_curve
from plategait.errors import InputError
from plategait.files.output import PICTURES
from plategait.model.presets import preset
from plategait.plots import figures as plots
from plategait.plots.style import save
from plategait.simulation.run import simulate

FREQUENCY = np.arange(14.0, 30.0)


def a_curve() -> Curve:
    """A Lorentzian that slides, walks, runs and then fails."""
    gait = ["sliding"] * 5 + ["walking"] * 4 + ["running"] * 4 + [""] * 3
    failure = [""] * 13 + ["slipped"] * 3
    rate = lorentzian(FREQUENCY, 500.0, 24.0, 4.0)
    rate[14] = math.nan
    return fit_curve(Curve("cheese", FREQUENCY, rate, np.full(16, 3.0), tuple(gait), tuple(failure)))


def lines_with(axes, marker) -> list:
    return [line for line in axes.get_lines() if line.get_marker() == marker]


def test_gaits_have_the_markers_of_the_source():
    axes = plots.plot_curve(a_curve()).axes[0]
    for marker, count in (("s", 5), ("^", 4), ("o", 4)):
        (line,) = lines_with(axes, marker)
        assert len(line.get_xdata()) == count


def test_failed_runs_are_shown_apart():
    axes = plots.plot_curve(a_curve()).axes[0]
    (failed,) = lines_with(axes, "x")
    np.testing.assert_array_equal(failed.get_xdata(), FREQUENCY[13:])
    assert failed.get_ydata()[1] == 0, "where nothing was measured the cross lies on the axis"
    assert "left out" in failed.get_label()


def test_points_that_failed_in_part_are_half_filled():
    curve = a_curve()
    failed_runs = np.array([0.0] * 6 + [1.0] + [0.0] * 5 + [2.0] + [4.0] * 3)
    failure = tuple("slipped" if n else "" for n in failed_runs)
    partly = fit_curve(replace(curve, failure=failure, runs=np.full(16, 4.0), failed_runs=failed_runs))
    axes = plots.plot_curve(partly).axes[0]
    half = [line for line in axes.get_lines() if line.get_fillstyle() == "left" and len(line.get_xdata())]
    assert sorted((line.get_marker(), *line.get_xdata()) for line in half) == [("^", 20.0), ("o", 26.0)]
    # One of four that failed is used all the same; of the point that half of its runs left the fit knows nothing.
    (crosses,) = lines_with(axes, "x")
    np.testing.assert_array_equal(crosses.get_xdata(), FREQUENCY[12:])
    assert partly.fitted[6]
    assert not partly.fitted[12]
    assert plots.PARTLY_FAILED in [text.get_text() for text in axes.get_legend().get_texts()]
    assert not [line for line in plots.plot_curve(curve).axes[0].get_lines() if line.get_fillstyle() == "left"]


def test_the_fit_is_drawn_over_the_points_it_uses():
    axes = plots.plot_curve(a_curve()).axes[0]
    line = max(axes.get_lines(), key=lambda each: len(each.get_xdata()))
    assert line.get_xdata().max() == FREQUENCY[12]
    np.testing.assert_allclose(line.get_ydata(), lorentzian(line.get_xdata(), 500.0, 24.0, 4.0), rtol=1e-6)
    assert any("24" in text.get_text() for text in axes.texts)


def test_a_curve_without_a_fit_or_a_rate_still_has_a_plot():
    nothing = Curve("none", FREQUENCY, np.full(16, math.nan), np.full(16, math.nan), ("",) * 16, ("slipped",) * 16)
    axes = plots.plot_curve(fit_curve(nothing)).axes[0]
    (failed,) = lines_with(axes, "x")
    assert len(failed.get_xdata()) == 16


def test_a_run_s_plot_marks_its_failure(tmp_path):
    scenario = preset("cheese").scenario.replace(duration=1.0)
    good = plots.plot_run(simulate(scenario))
    bad = simulate(scenario.replace(**{"motion.frequency": 29.0}))
    assert bad.failed
    figure = plots.plot_run(bad)
    dashed = [line for line in figure.axes[0].get_lines() if len(set(line.get_xdata())) == 1]
    assert dashed[0].get_xdata()[0] == bad.failure.time
    assert not [line for line in good.axes[0].get_lines() if len(set(line.get_xdata())) == 1]
    for suffix in PICTURES:
        save(figure, tmp_path / f"run{suffix}")
        assert (tmp_path / f"run{suffix}").stat().st_size > 5000


def test_a_plot_of_modes_names_them():
    figure = plots.plot_modes(preset("cheese").scenario.sheet)
    titles = " ".join(axes.get_title() for axes in figure.axes)
    assert "saddle" in titles
    assert "dish" in titles
    assert "10.32π" in titles


def test_a_plot_that_cannot_be_written_is_refused(tmp_path):
    figure = plots.plot_modes(preset("cheese").scenario.sheet)
    for path in (tmp_path / "a.bmp", tmp_path / "missing" / "a.png"):
        with pytest.raises(InputError, match="plot"):
            save(figure, path)
    assert not list(tmp_path.iterdir())
