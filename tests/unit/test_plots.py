"""Figures say what was measured: markers by gait, failures shown apart, fits drawn."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from legible import assert_legible

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


def failed_in(axes) -> list:
    return [line for line in axes.get_lines() if line.get_gid() == "failed"]


def heights_of(axes, line) -> np.ndarray:
    """Where marks lie, as shares of the axes' height, 0 at its foot."""
    return axes.transAxes.inverted().transform(line.get_transform().transform(line.get_xydata()))[:, 1]


def test_failed_points_lie_in_a_band_below_every_rate():
    curve = a_curve()
    curve = replace(curve, failure=(*curve.failure[:13], "slipped", "turned over", "slipped"))
    figure = plots.plot_curve(curve)
    figure.draw_without_rendering()
    axes = figure.axes[0]
    slipped, turned = failed_in(axes)
    np.testing.assert_array_equal(slipped.get_xdata(), FREQUENCY[[13, 15]])
    np.testing.assert_array_equal(turned.get_xdata(), FREQUENCY[[14]])
    assert slipped.get_marker() != turned.get_marker()
    (zero,) = axes.transAxes.inverted().transform(axes.transData.transform([(20.0, 0.0)]))
    for line in (slipped, turned):
        assert heights_of(axes, line).max() < zero[1] - 0.02
    assert min(axes.get_yticks()) == 0, "no tick lies in the band"
    names = [text.get_text() for text in figure.legends[0].get_texts()]
    assert {"slipped", "turned over"} <= set(names)
    # Rates of points that failed are seen, and are seen to be left out.
    (left_out,) = (line for line in lines_with(axes, "x") if line.get_gid() != "failed")
    np.testing.assert_array_equal(left_out.get_xdata(), FREQUENCY[[13, 15]])
    assert "left out" in left_out.get_label()


def test_a_curve_tells_its_amplitudes_and_runs_and_what_the_bars_are():
    curve = replace(a_curve(), angle_deg=np.full(16, 3.0), stroke=np.full(16, 0.003), runs=np.full(16, 4.0),
                    failed_runs=np.array([0.0] * 13 + [4.0] * 3), name="a $5 sheet")  # fmt: skip
    figure = plots.plot_curve(curve)
    axes = figure.axes[0]
    said = axes.get_title(loc="left")
    for words in ("$A_p$ = 3 deg", "$B_p$ = 3 mm", "4 runs a point", "their sd", "$f_0$ = 24 Hz", "$R^2$"):
        assert words in said
    assert figure.get_suptitle() == "a $5 sheet"
    assert "Hz" in axes.get_xlabel()
    assert "deg/s" in axes.get_ylabel()
    of_several = replace(curve, angle_deg=np.linspace(3.0, 12.0, 16))
    assert "3 to 12 deg" in plots.plot_curve(of_several).axes[0].get_title(loc="left")


def test_rates_out_of_phase_and_long_names_are_seen_whole():
    name = "a measurement with a name that goes on and on, as files in laboratories have them, " * 4
    figure = plots.plot_curve(replace(a_curve(), name=name, fit=None, spin_rate_deg_s=-20 * FREQUENCY))
    axes = figure.axes[0]
    assert axes.get_ylim()[1] == 0
    assert_legible(figure)
    title = figure._suptitle.get_window_extent()  # type: ignore[attr-defined]
    assert title.x1 <= figure.bbox.x1
    assert title.y1 <= figure.bbox.y1


@pytest.mark.parametrize("peak", [15.0, 24.0, 29.0])
def test_no_words_lie_over_data(peak):
    rate = lorentzian(FREQUENCY, 500.0, peak, 2.0)
    curve = fit_curve(Curve("c", FREQUENCY, rate, np.full(16, 3.0), ("sliding",) * 16, ("",) * 15 + ("slipped",)))
    assert_legible(plots.plot_curve(curve))


def test_points_that_failed_in_part_are_half_filled():
    curve = a_curve()
    failed_runs = np.array([0.0] * 6 + [1.0] + [0.0] * 5 + [2.0] + [4.0] * 3)
    failure = tuple("slipped" if n else "" for n in failed_runs)
    partly = fit_curve(replace(curve, failure=failure, runs=np.full(16, 4.0), failed_runs=failed_runs))
    axes = plots.plot_curve(partly).axes[0]
    half = [line for line in axes.get_lines() if line.get_fillstyle() == "left" and len(line.get_xdata())]
    assert sorted((line.get_marker(), *line.get_xdata()) for line in half) == [("^", 20.0), ("o", 26.0)]
    # One of four that failed is used all the same; of the point that half of its runs left the fit knows nothing.
    (crosses,) = failed_in(axes)
    np.testing.assert_array_equal(crosses.get_xdata(), FREQUENCY[12:])
    assert partly.fitted[6]
    assert not partly.fitted[12]
    assert plots.PARTLY_FAILED in [text.get_text() for text in axes.figure.legends[0].get_texts()]
    assert not [line for line in plots.plot_curve(curve).axes[0].get_lines() if line.get_fillstyle() == "left"]


def test_the_fit_is_drawn_over_the_points_it_uses():
    axes = plots.plot_curve(a_curve()).axes[0]
    line = max(axes.get_lines(), key=lambda each: len(each.get_xdata()))
    assert line.get_xdata().max() == FREQUENCY[12]
    np.testing.assert_allclose(line.get_ydata(), lorentzian(line.get_xdata(), 500.0, 24.0, 4.0), rtol=1e-6)
    assert "$f_0$ = 24 Hz" in axes.get_title(loc="left")


def test_a_curve_without_a_fit_or_a_rate_still_has_a_plot():
    nothing = Curve("none", FREQUENCY, np.full(16, math.nan), np.full(16, math.nan), ("",) * 16, ("slipped",) * 16)
    (failed,) = failed_in(plots.plot_curve(fit_curve(nothing)).axes[0])
    assert len(failed.get_xdata()) == 16


def test_a_run_s_plot_marks_its_failure(tmp_path):
    scenario = preset("cheese").scenario.replace(duration=1.0)
    good = plots.plot_run(simulate(scenario))
    bad = simulate(scenario.replace(**{"motion.frequency": 29.0}))
    assert bad.failed
    figure = plots.plot_run(bad)
    assert_legible(figure)
    assert f"slipped at {bad.failure.time:.2f} s" in figure.axes[1].get_title(loc="left")
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


def test_as_many_modes_are_drawn_as_asked_in_mm_and_with_a_scale():
    sheet = preset("cheese").scenario.sheet
    for count in (1, 5):
        figure = plots.plot_modes(sheet, count)
        *panels, scale = (axes for axes in figure.axes if axes.get_visible())
        assert len(panels) == count
        assert panels[0].get_images()[0].get_extent() == pytest.approx([-40, 40, -40, 40])
        assert "mm" in panels[-1].get_xlabel()
        assert "deflection" in scale.get_ylabel()


def test_a_plot_that_cannot_be_written_is_refused(tmp_path):
    figure = plots.plot_modes(preset("cheese").scenario.sheet)
    for path in (tmp_path / "a.bmp", tmp_path / "missing" / "a.png"):
        with pytest.raises(InputError, match="plot"):
            save(figure, path)
    assert not list(tmp_path.iterdir())
