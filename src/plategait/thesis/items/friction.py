"""Fig. 4.8: the best friction angle of each gait."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from plategait import published
from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.plots.style import legend_beside
from plategait.simulation.observables import GAITS
from plategait.thesis import draw
from plategait.thesis.cases import FRICTION_ANGLES, REFERENCE_ALPHA, Case
from plategait.thesis.item import Cell, Check, Comparison, Item, Spec, Table
from plategait.thesis.runs import CaseRuns, Results

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


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


@dataclass(frozen=True, eq=False)
class FrictionMap:
    """Spin rate over acceleration and friction angle.

    Attributes
    ----------
    alphas : (a,) array
        Friction angles, deg, that of the reference sheet among them.
    acceleration : (x,) array
        A_p ω_p², 10⁴ deg/s².
    curves : tuple of Curve
        Over the acceleration, by friction angle.
    """

    alphas: Array
    acceleration: Array
    curves: tuple[Curve, ...]

    @cached_property
    def rate(self) -> Array:
        """Spin rates (a, x), deg/s; NaN from the run-off on."""
        return np.array([np.where(c.fitted, c.spin_rate_deg_s, np.nan) for c in self.curves])

    @cached_property
    def gait(self) -> NDArray[np.str_]:
        """Gaits (a, x)."""
        return np.array([c.gait for c in self.curves])

    @cached_property
    def best(self) -> Array:
        """Best friction angle (x,) at each acceleration, deg; NaN where too few sheets stay to tell."""
        enough = np.isfinite(self.rate).mean(axis=0) >= 0.5
        best = np.array([best_friction(self.alphas, column) for column in self.rate.T])
        best[~enough] = np.nan
        return best

    def best_in(self, gait: str) -> Array:
        """Best friction angles at the accelerations at which the reference sheet shows a gait."""
        reference = list(self.alphas).index(REFERENCE_ALPHA)
        at_gait = (self.gait[reference] == gait) & np.isfinite(self.best)
        return self.best[at_gait & (np.nan_to_num(self.rate[reference]) > 20)]


def _friction_map(results: Results) -> FrictionMap:
    runs = tuple(results[case] for case in friction_cases())
    alphas = np.array([r.case.alpha_deg for r in runs])
    return FrictionMap(alphas, runs[0].acceleration, tuple(r.curve for r in runs))


def fig_4_8(spec: Spec, results: Results) -> Item:
    """Rate over acceleration and friction angle, and the best friction angle of each gait."""
    friction = _friction_map(results)
    columns = ("α (deg)", "A_p ω_p² (10⁴ deg/s²)", "ω_B (deg/s)", "gait")
    return spec.item(
        figures=[(spec.name, _draw_map(friction, [results[case] for case in friction_cases()]))],
        tables=[Table(spec.name, columns, _map_rows(friction))],
        comparisons=gait_comparisons(results),
        checks=[_judge_order(friction)],
        notes=[
            *(
                f"At A_p = 3 deg and 10π no sheet stays on the plate while {gait}: it runs off first."
                for gait in GAITS
                if not friction.best_in(gait).size
            ),
            "The same three regimes appear, in the same order, but one gait early: with 3 deg of tilt our sheet bends "
            "a good deal before a leg leaves the plate, so that what the source sees while walking we see while "
            "sliding, and what it sees while running, while walking.",
            "The spread is over the accelerations of the gait.",
        ],
    )


def _map_rows(friction: FrictionMap) -> tuple[tuple[Cell, ...], ...]:
    return tuple(
        (float(alpha), float(x), float(rate), str(gait))
        for alpha, rates, gaits in zip(friction.alphas, friction.rate, friction.gait, strict=True)
        for x, rate, gait in zip(friction.acceleration, rates, gaits, strict=True)
    )


def _draw_map(friction: FrictionMap, runs: Sequence[CaseRuns]) -> Figure:
    figure, (left, right) = draw.panels(2)
    _draw_curves(left, friction, runs)
    _draw_contours(right, friction)
    return figure


def _draw_curves(axes: Axes, friction: FrictionMap, runs: Sequence[CaseRuns]) -> None:
    from matplotlib import colormaps

    shade = colormaps["viridis"]
    for i, of_angle in enumerate(runs):
        draw.curve(axes, of_angle, friction.acceleration, shade(i / len(runs)), f"{of_angle.case.alpha_deg:g}")
    draw.plain(axes, draw.ACCELERATION, draw.RATE, "(a)")
    draw.finish(axes, fontsize=6.5, title="$\\alpha$ (deg)", title_fontsize=7)


def _draw_contours(axes: Axes, friction: FrictionMap) -> None:
    share = friction.rate / np.nanmax(friction.rate)
    axes.clabel(
        axes.contour(friction.acceleration, friction.alphas, share, levels=np.arange(0.1, 1.0, 0.1)), fontsize=7
    )
    axes.plot(friction.acceleration, friction.best, "o-", color="black", ms=3, label="best $\\alpha$")
    draw.plain(axes, draw.ACCELERATION, "friction angle $\\alpha$ (deg)", "(b) $\\omega_B$ over its best")
    legend_beside(axes)


def gait_comparisons(results: Results) -> tuple[Comparison, ...]:
    """Best friction angle of each gait beside the published one; its spread is over the accelerations."""
    friction = _friction_map(results)
    return tuple(_compare(gait, friction.best_in(gait)) for gait in GAITS)


def _compare(gait: str, best: Array) -> Comparison:
    return Comparison(
        f"best α while {gait} (deg)",
        published.single(f"friction_{gait}"),
        float(np.nanmedian(best)) if best.size else math.nan,
        10.0,
        absolute=True,
        spread=float(np.nanstd(best)) if best.size else math.nan,
    )


def _judge_order(friction: FrictionMap) -> Check:
    best, top = friction.best, int(np.nanargmax(friction.best))
    first, highest, last = float(best[0]), float(best[top]), float(np.nanmedian(best[top + 1 :]))
    return Check(
        "best α first rises, then falls, as A_p ω_p² grows",
        "40, 60, 30 deg",
        f"{first:.0f}, {highest:.0f}, {last:.0f} deg",
        last < first < highest,
    )
