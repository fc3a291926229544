"""Figs. 4.4 and 4.6: spin rate and gait over the plate's frequency."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from plategait import published
from plategait.arrays import Array
from plategait.simulation.observables import GAITS
from plategait.thesis import draw
from plategait.thesis.cases import GAIT_ANGLES, Case
from plategait.thesis.item import Cell, Check, Comparison, Item, Spec, Table
from plategait.thesis.runs import CaseRuns, Results

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def fig_4_4(spec: Spec, results: Results) -> Item:
    """Rate and gait over the plate's frequency at A_p = 12 deg."""
    case = Case(12)
    runs = results[case]
    ratio = np.array(case.frequencies) / 5.0
    gait = runs.curve.gait[runs.best]
    columns = ("f_p (Hz)", "ω_p/ω_n", "ω_B (deg/s)", "sd (deg/s)", "gait", "failure")
    return spec.item(
        figures=[(spec.name, _draw_gaits(runs, ratio))],
        tables=[Table(spec.name, columns, _gait_rows(runs, ratio))],
        comparisons=[_best_ratio(results, case, ratio), _rate_at_12_hz(results, case)],
        checks=[gait_order(runs), Check("fastest while running", "running", gait, gait == "running")],
    )


def _gait_rows(runs: CaseRuns, ratio: Array) -> tuple[tuple[Cell, ...], ...]:
    return tuple(
        zip(
            runs.case.frequencies,
            ratio.tolist(),
            runs.curve.spin_rate_deg_s.tolist(),
            runs.curve.spin_rate_sd_deg_s.tolist(),
            runs.curve.gait,
            runs.curve.failure_in_words,
            strict=True,
        )
    )


def _draw_gaits(runs: CaseRuns, ratio: Array) -> Figure:
    figure, (axes,) = draw.panels(1, width=6)
    failures = [draw.curve(axes, runs, ratio, draw.COLOURS[0], "ours")]
    axes.axvline(published.single("best_ratio").value, color=draw.COLOURS[6], ls=":", label="published best")
    axes.plot(2.4, published.single("rate_12hz").value, **draw.PUBLISHED)
    draw.gait_legend(axes)
    draw.plain(axes, "$\\omega_p/\\omega_n$", draw.RATE)
    draw.finish(axes, failures)
    return figure


def _best_ratio(results: Results, case: Case, ratio: Array) -> Comparison:
    runs = results[case]
    return Comparison(
        "best ω_p/ω_n",
        published.single("best_ratio"),
        float(ratio[runs.best]),
        0.1,
        spread=runs.member_spread("f0_hz") / 5,
        half_step=results.effect(case, "half step", "f0_hz") / 5,
    )


def _rate_at_12_hz(results: Results, case: Case) -> Comparison:
    curve, at = results[case].curve, case.frequencies.index(12.0)
    return Comparison(
        "rate at 12 Hz (deg/s)",
        published.single("rate_12hz"),
        float(curve.spin_rate_deg_s[at]),
        0.15,
        spread=float(curve.spin_rate_sd_deg_s[at]),
        half_step=_rate_effect(results, case, 12.0),
    )


def _rate_effect(results: Results, case: Case, frequency: float) -> float:
    """Change of the rate at one frequency when the step is halved, deg/s, from the same starts."""
    other = results.runs.get(case.but("half step"))
    if other is None or frequency not in other.case.frequencies:
        return math.nan
    base = results[case].first_starts(len(other.observations[0]))
    rates = (r.curve.spin_rate_deg_s[r.case.frequencies.index(frequency)] for r in (other, base))
    halved, whole = rates
    return float(halved - whole)


def gait_order(runs: CaseRuns) -> Check:
    """Whether sliding, walking, running and failure follow in this order below the run-off."""
    steps = [GAITS.index(g) for g, fitted in zip(runs.curve.gait, runs.curve.fitted, strict=True) if fitted and g]
    order = all(a <= b for a, b in pairwise(steps))
    sequence = " → ".join(GAITS[i] for i in sorted(set(steps)))
    failed = bool(runs.curve.failed.any())
    return Check(
        "gaits in order as the frequency rises",
        "sliding → walking → running → failed",
        sequence + (" → failed" if failed else "") + ("" if order else ", out of order"),
        order and set(steps) == {0, 1, 2} and failed,
    )


def fig_4_6(spec: Spec, results: Results) -> Item:
    """Rate over frequency, by amplitude."""
    curves = [results[Case(angle)] for angle in GAIT_ANGLES]
    best = [runs.best_rate for runs in curves]
    rows = tuple(zip(GAIT_ANGLES, best, (runs.best_sd for runs in curves), strict=True))
    return spec.item(
        figures=[(spec.name, _draw_amplitudes(curves))],
        tables=[Table(spec.name, ("A_p (deg)", "best ω_B (deg/s)", "sd (deg/s)"), rows)],
        checks=[
            Check(
                "a smaller amplitude reaches a higher rate, at a higher frequency",
                "best rate falls as A_p rises",
                ", ".join(f"{a} deg: {b:.0f}" for a, b in zip(GAIT_ANGLES, best, strict=True)) + " deg/s",
                bool(np.all(np.diff(best) < 0)),
            )
        ],
    )


def _draw_amplitudes(curves: list[CaseRuns]) -> Figure:
    figure, (axes,) = draw.panels(1, width=6)
    failures = []
    for i, runs in enumerate(curves):
        ratio = np.array(runs.case.frequencies) / 5.0
        name = f"$A_p$ = {runs.case.angle_deg:g} deg"
        failures.append(draw.curve(axes, runs, ratio, draw.COLOURS[i], name))
    draw.gait_legend(axes)
    draw.plain(axes, "$\\omega_p/\\omega_n$", draw.RATE)
    draw.finish(axes, failures)
    return figure
