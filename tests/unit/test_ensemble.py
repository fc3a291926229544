"""One rule for what several starts show together, and that every user of it gives the same answer."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from plategait.campaign.figures import plot_campaign
from plategait.campaign.opened import open_sweep
from plategait.campaign.run import sweep
from plategait.curve.spin_curve import spin_curve
from plategait.model.presets import preset
from plategait.simulation.ensemble import Ensemble, fails, mean_of_unfailed, together
from plategait.simulation.observables import student_95
from plategait.simulation.observation import Observation
from plategait.simulation.result import Simulation
from plategait.simulation.run import simulate
from plategait.thesis.cases import Case
from plategait.thesis.runs import CaseRuns

NAN = math.nan


def shown(rates, gaits=None, failures=None, times=None, settled=None) -> Ensemble:
    """Ensemble of one point."""
    n = len(rates)
    rate = np.array([rates], dtype=float)
    return together(
        spin_rate=rate, spin_rate_sd=np.full((1, n), 0.5), spin_rate_low=rate - 1, spin_rate_high=rate + 1,
        settled=[settled or [True] * n], gait=[gaits or ["walking"] * n], failure=[failures or [""] * n],
        failure_time=[times or [NAN] * n],
    )  # fmt: skip


@pytest.mark.parametrize(
    ("failed", "runs", "expected"),
    [(0, 1, False), (1, 1, True), (1, 2, True), (1, 3, False), (2, 3, True), (1, 4, False), (2, 4, True)],
)
def test_a_point_fails_with_at_least_half_of_its_runs(failed, runs, expected):
    assert fails(failed, runs) == expected
    kinds = ["slipped"] * failed + [""] * (runs - failed)
    found = shown([1.0] * runs, failures=kinds)
    assert found.failed.tolist() == [expected]
    assert found.partly_failed.tolist() == [0 < failed < runs]
    assert (found.runs, found.failed_runs[0], found.counted_runs[0]) == (runs, failed, runs - failed)


def test_means_are_over_the_runs_that_did_not_fail_whatever_the_point_is_called():
    # Two of three failed, with rates of their own: none of them counts.
    found = shown([100.0, -50.0, 4.0], failures=["slipped", "slipped", ""])
    assert found.failed[0]
    assert (found.rate[0], found.spread[0], found.low[0], found.high[0]) == (4.0, 0.5, 3.0, 5.0)
    np.testing.assert_array_equal(mean_of_unfailed([[1, 2, NAN], [1, 2, 3]], [[0, 1, 0], [1, 1, 1]]), [1, NAN])


def test_where_all_failed_there_is_no_number():
    found = shown([3.0, 4.0], failures=["slipped", "folded"])
    for numbers in (found.rate, found.spread, found.low, found.high):
        assert np.isnan(numbers).all()
    assert found.gait == ("",)
    assert not found.settled[0]


def test_the_spread_is_over_as_many_runs_as_it_says():
    found = shown([1.0, 2.0, 4.0, 99.0, NAN], failures=["", "", "", "slipped", ""])
    assert found.counted_runs[0] == 3
    assert found.spread[0] == pytest.approx(np.std([1, 2, 4], ddof=1))
    half = student_95(2) * found.spread[0] / math.sqrt(3)
    assert (found.low[0], found.high[0]) == pytest.approx((7 / 3 - half, 7 / 3 + half))


@pytest.mark.parametrize(
    ("gaits", "failures", "expected"),
    [(["sliding", "running"], None, "running"), (["running", "walking", "sliding", "walking"], None, "walking"),
     (["sliding", "sliding", "walking", "walking"], None, "walking"), (["", "sliding", ""], None, "sliding"),
     (["running", "running", "sliding"], ["slipped", "slipped", ""], "sliding"), (["", ""], None, "")],
)  # fmt: skip
def test_the_gait_is_that_of_most_unfailed_runs_and_the_livelier_of_equals(gaits, failures, expected):
    assert shown([1.0] * len(gaits), gaits=gaits, failures=failures).gait == (expected,)


def test_the_commonest_failure_is_told_with_its_median_time_even_in_part():
    found = shown([1.0] * 5, failures=["folded", "slipped", "", "slipped", ""], times=[0.1, 0.2, NAN, 0.4, NAN])
    assert found.failure == ("slipped",)
    assert found.failure_time[0] == pytest.approx(0.3)
    assert shown([1.0]).failure == ("",)
    assert np.isnan(shown([1.0]).failure_time[0])


def test_a_point_has_settled_when_each_run_that_counts_has():
    assert shown([1.0] * 3, failures=["slipped", "", ""], settled=[False, True, True]).settled[0]
    assert not shown([1.0] * 3, settled=[False, True, True]).settled[0]
    assert not shown([1.0] * 2, failures=["slipped", ""], settled=[False, True]).settled[0]


# The same answer everywhere

SCENARIO = preset("cheese").scenario.replace(duration=0.6)
STARTS = 4
FREQUENCIES = (14.0, 18.0)


def half_failing() -> float:
    """Limit of slip that two of four starts keep at the first frequency, m."""
    result = simulate(SCENARIO.replace(**{"motion.frequency": FREQUENCIES[0]}), repeats=STARTS, seed=3)
    drifts = sorted(o["drift"] for o in result.observations)
    return 0.5 * (drifts[1] + drifts[2])


def test_simulate_curve_sweep_and_thesis_agree_on_half_failed_ensembles(tmp_path):
    scenario = SCENARIO.replace(slip_limit=half_failing())
    curve = spin_curve(scenario, FREQUENCIES, repeats=STARTS, seed=3)
    first = curve.simulations[0]
    assert (first.failed_runs, first.counted_runs, first.failed) == (2, 2, True)
    case = Case(3)
    for i, simulation in enumerate(curve.simulations):
        of_case = CaseRuns(case, (simulation.observations,) * len(case.frequencies), ()).curve
        for each in (curve, of_case):
            assert each.spin_rate_deg_s[i] == pytest.approx(math.degrees(simulation.spin_rate), nan_ok=True)
            assert each.gait[i] == simulation.gait
            assert each.failed[i] == simulation.failed
    plan = {
        "name": "halves", "scenario": "cheese", "repeats": STARTS,
        "set": {"duration": "0.6 s", "slip_limit": scenario.slip_limit},
        "grid": {"motion.frequency": ["14 Hz", "18 Hz"]},
    }  # fmt: skip
    stored = sweep(plan, tmp_path / "s.zarr").data
    # The store's starts have seeds of their own: its rows go through the same rule, run by run.
    found = open_sweep(tmp_path / "s.zarr").outcomes
    for i in range(len(FREQUENCIES)):
        row = stored.isel(point=i)
        simulation = as_simulation(row, curve.simulations[i])
        assert found.rate[i] == pytest.approx(simulation.spin_rate, nan_ok=True)
        assert (found.gait[i], found.failed[i]) == (simulation.gait, simulation.failed)
        assert found.failed_runs[i] == simulation.failed_runs
    summary = open_sweep(tmp_path / "s.zarr").summary()
    assert summary["partly_failed_points"] == int(found.partly_failed.sum())
    assert summary["open_ledgers"] == 0


@pytest.mark.parametrize("grid", [
    {"motion.frequency": ["14 Hz", "18 Hz", "22 Hz"]},
    {"motion.frequency": ["14 Hz", "18 Hz", "22 Hz"], "friction_angle": ["30 deg"]},
    {"motion.angle": [f"{a} deg" for a in range(1, 8)], "friction_angle": [f"{a} deg" for a in range(30, 37)]},
])  # fmt: skip
def test_a_campaign_s_picture_half_fills_the_marks_of_points_that_failed_in_part(tmp_path, grid):
    plan = {"name": "p", "scenario": "cheese", "set": {"duration": "0.05 s", "transient": "0 s"}, "grid": grid}
    opened = sweep(plan, tmp_path / "s.zarr")
    n = len(opened.points)
    opened.__dict__["outcomes"] = together(
        spin_rate=np.ones((n, 4)), spin_rate_sd=np.ones((n, 4)), spin_rate_low=np.ones((n, 4)),
        spin_rate_high=np.ones((n, 4)), settled=np.ones((n, 4), dtype=bool), gait=[["walking"] * 4] * n,
        failure=[["slipped", "slipped", "", ""], *[["slipped", "", "", ""]] * 1, *[[""] * 4] * (n - 2)],
        failure_time=np.ones((n, 4)),
    )  # fmt: skip
    figure = plot_campaign(opened)
    axes = figure.axes[0]
    marks = [line for line in axes.get_lines() if line.get_marker() == "^"]
    counts = {line.get_fillstyle(): len(line.get_xdata()) for line in marks}
    assert counts == {"left": 2, "full": n - 2}
    (crosses,) = (line for line in axes.get_lines() if line.get_marker() == "x")
    assert len(crosses.get_xdata()) == 1
    assert any("half-filled" in text.get_text() for text in figure.legends[0].get_texts())
    figure.draw_without_rendering()
    # No mark is cut by the edge of the axes, and a map has no colour where a point failed.
    inner = axes.get_window_extent()
    for line in marks:
        x, y = axes.transData.transform(line.get_xydata()).T
        assert (np.abs(x - (inner.x0 + inner.x1) / 2) < inner.width / 2 - 5).all()
        assert (y > inner.y0 + 5).all()
        assert (y < inner.y1 - 5).all() or len(grid) == 1


def as_simulation(row, like: Simulation) -> Simulation:
    """A store's row as the simulation that it is of."""

    def observation(j: int, o: Observation) -> Observation:
        run = row.isel(repeat=j)
        spin = replace(o.spin, rate=float(run["spin_rate"]), sd=float(run["spin_rate_sd"]))
        failure = replace(like.failure, kind=str(run["failure"].item())) if run["failure"].item() else None
        return replace(o, spin=spin, gait=str(run["gait"].item()), failure=failure)

    return replace(like, observations=tuple(observation(j, o) for j, o in enumerate(like.observations)))
