"""Fig. 4.8: the best friction angle of each gait."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from plategait import published
from plategait.simulation.observables import GAITS
from plategait.thesis import draw
from plategait.thesis.cases import FRICTION_ANGLES, REFERENCE_ALPHA, Case
from plategait.thesis.item import Check, Comparison, Item, Spec, Table, verdict
from plategait.thesis.runs import CaseRuns, Results

_RATE = "spin rate $\\omega_B$ (deg/s)"
_ACCELERATION = "$A_p \\omega_p^2$ ($10^4$ deg/s²)"


def friction_cases() -> list[Case]:
    """Cases of Fig. 4.8."""
    return [Case(3, 10.0, alpha) for alpha in sorted({*FRICTION_ANGLES, REFERENCE_ALPHA})]


def best_friction(alphas: NDArray[np.float64], rates: NDArray[np.float64]) -> float:
    """Friction angle of the highest rate, by a parabola through it and its neighbours, deg; NaN for none."""
    if not np.isfinite(rates).any():
        return math.nan
    top = int(np.nanargmax(rates))
    near = slice(max(top - 1, 0), top + 2)
    if not np.isfinite(rates[near]).all() or len(rates[near]) < 3:
        return float(alphas[top])
    curvature, slope, _ = np.polyfit(alphas[near], rates[near], 2)
    return float(-slope / (2 * curvature)) if curvature < 0 else float(alphas[top])


def fig_4_8(spec: Spec, results: Results) -> Item:
    """Rate over acceleration and friction angle, and the best friction angle of each gait."""
    from matplotlib import colormaps

    cases = friction_cases()
    alphas = np.array([c.alpha_deg for c in cases])
    acceleration = results[cases[0]].acceleration
    rate = np.array([np.where(_stays(results[c]), results[c].curve.spin_rate_deg_s, np.nan) for c in cases])
    gaits = np.array([results[c].curve.gait for c in cases])
    figure, (left, right) = draw.panels(2)
    shade = colormaps["viridis"]
    for i, case in enumerate(cases):
        draw.curve(left, results[case], acceleration, shade(i / len(cases)), f"{case.alpha_deg:g}")
    left.legend(frameon=False, fontsize=6.5, title="α (deg)", title_fontsize=7, ncols=2)
    draw.plain(left, _ACCELERATION, _RATE, "(a)")
    shares = right.contour(acceleration, alphas, rate / np.nanmax(rate), levels=np.arange(0.1, 1.0, 0.1))
    right.clabel(shares, fontsize=7)
    # Where few sheets stay, the best of them says nothing.
    enough = np.isfinite(rate).mean(axis=0) >= 0.5
    best = np.array([best_friction(alphas, column) for column in rate.T])
    best[~enough] = np.nan
    right.plot(acceleration, best, "o-", color="black", ms=3, label="best α")
    right.legend(frameon=False, fontsize=8)
    draw.plain(right, _ACCELERATION, "friction angle α (deg)", "(b) ω_B over its best")
    reference = list(alphas).index(REFERENCE_ALPHA)
    comparisons: list[Comparison] = []
    notes: list[str] = []
    for gait in GAITS:
        here = (gaits[reference] == gait) & np.isfinite(best) & (np.nan_to_num(rate[reference]) > 20)
        number = published.single(f"friction_{gait}")
        if not here.any():
            notes.append(f"At A_p = 3 deg and 10π no sheet stays on the plate while {gait}: it runs off first.")
        measured = float(np.nanmedian(best[here])) if here.any() else math.nan
        spread = float(np.nanstd(best[here])) if here.any() else math.nan
        comparisons.append(
            Comparison(f"best α while {gait} (deg)", number, measured, 10.0, absolute=True, spread=spread)
        )
    top = int(np.nanargmax(best))
    begin, most, end = float(best[0]), float(best[top]), float(np.nanmedian(best[top + 1 :]))
    checks = (
        Check(
            "best α first rises, then falls, as A_p ω_p² grows",
            "40, 60, 30 deg",
            f"{begin:.0f}, {most:.0f}, {end:.0f} deg",
            end < begin < most,
        ),
    )
    notes.append(
        "The same three regimes appear, in the same order, but one gait early: with 3 deg of tilt our sheet bends a "
        "good deal before a leg leaves the plate, so that what the source sees while walking we see while sliding, and "
        "what it sees while running, while walking."
    )
    rows = tuple(
        (float(a), float(x), float(r), str(g))
        for a, row, row_gaits in zip(alphas, rate, gaits, strict=True)
        for x, r, g in zip(acceleration, row, row_gaits, strict=True)
    )
    return Item(
        spec.name,
        spec.title,
        verdict(comparisons, checks),
        (("fig4.8", figure),),
        (Table("fig4.8", ("α (deg)", "A_p ω_p² (10⁴ deg/s²)", "ω_B (deg/s)", "gait"), rows),),
        tuple(comparisons),
        checks,
        (*notes, "The spread is over the accelerations of the gait."),
    )


def _stays(runs: CaseRuns) -> NDArray[np.bool_]:
    return runs.curve.fitted
