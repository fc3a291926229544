"""Fig. 4.7: the best acceleration of each object."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from plategait import published
from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.thesis import draw
from plategait.thesis.cases import GAIT_ANGLES, STIFFNESSES, Case
from plategait.thesis.item import Cell, Check, Comparison, Item, Spec, Table
from plategait.thesis.runs import CaseRuns, Results

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# Share of the best rate within which an acceleration counts as optimal: the tops are flat.
_FLAT = 0.9
# Amplitudes that the source excepts from its finding, by ω_n (section 4.5), and 1 deg, which it does not name there:
# soft sheets go on to a second rise at that amplitude.
_EXCEPTED = {1: STIFFNESSES, 24: STIFFNESSES, 12: (23.0, 33.0, 320.0)}


def stiffness_cases() -> list[Case]:
    """Cases of Fig. 4.7."""
    return [Case(angle, omega) for omega in STIFFNESSES for angle in GAIT_ANGLES]


def flat_top(curve: Curve, acceleration: Array) -> tuple[float, float]:
    """Accelerations between which the rate is within a tenth of its best, in their unit; NaN where nothing stays."""
    rate = np.where(curve.fitted, curve.spin_rate_deg_s, -math.inf)
    if not np.isfinite(rate).any():
        return math.nan, math.nan
    top = acceleration[rate >= _FLAT * rate.max()]
    return float(top.min()), float(top.max())


def best_at_all(omega_pi: float, tops: Iterable[tuple[float, tuple[float, float]]]) -> tuple[float, float]:
    """Accelerations best at every amplitude: from the first to the second, none where that is less.

    Parameters
    ----------
    omega_pi : float
        ω_n of the object, π rad/s: it says which amplitudes the source leaves out.
    tops : iterable of (amplitude in deg, flat top)
    """
    counted = [top for angle, top in tops if math.isfinite(top[0]) and omega_pi not in _EXCEPTED.get(int(angle), ())]
    if not counted:
        return math.nan, math.nan
    return max(low for low, _ in counted), min(high for _, high in counted)


@dataclass(frozen=True, eq=False)
class _Panel:
    """One object of Fig. 4.7 and its runs by amplitude."""

    letter: str
    omega_pi: float
    runs: tuple[CaseRuns, ...]

    @property
    def name(self) -> str:
        """Panel and ω_n."""
        return f"({self.letter}) {self.omega_pi:g}π"

    @property
    def optimum(self) -> tuple[float, float]:
        """Accelerations best at every amplitude, 10⁴ deg/s²: from the first to the second, none where that is less."""
        tops = ((runs.case.angle_deg, flat_top(runs.curve, runs.acceleration)) for runs in self.runs)
        return best_at_all(self.omega_pi, tops)

    @property
    def fastest_gait(self) -> str:
        """Gait at the highest rate of all amplitudes."""
        fastest = max((runs for runs in self.runs if runs.best >= 0), key=lambda runs: runs.best_rate, default=None)
        return fastest.curve.gait[fastest.best] if fastest else ""


def _panels(results: Results) -> list[_Panel]:
    return [
        _Panel(letter, omega, tuple(results[Case(angle, omega)] for angle in GAIT_ANGLES))
        for letter, omega in zip("abcdefgh", STIFFNESSES, strict=True)
    ]


_ACCELERATION_COLUMNS = (
    "ω_n (π rad/s)",
    "A_p (deg)",
    "best A_p ω_p² (10⁴ deg/s²)",
    "top from",
    "top to",
    "ω_B (deg/s)",
    "sd (deg/s)",
    "gait",
)


def fig_4_7(spec: Spec, results: Results) -> Item:
    """One best acceleration for each object, whatever the amplitude."""
    panels = _panels(results)
    return spec.item(
        figures=[(spec.name, _draw_accelerations(panels))],
        tables=[Table(spec.name, _ACCELERATION_COLUMNS, _acceleration_rows(panels))],
        comparisons=[
            Comparison(
                "(d) best acceleration, 3 deg (10⁴ deg/s²)",
                published.single("best_acceleration"),
                _best_acceleration(results[Case(3, 10.0)]),
                0.15,
            )
        ],
        checks=optimum_checks(results),
        notes=[
            "As in the source, 24 deg and, for the stiff objects, 12 deg are left out of the finding. Its "
            "amplitudes beyond 12 and 24 deg are not printed; 1, 3 and 6 are those of Fig. 5.2(a). At 1 deg, left "
            "out too, soft sheets dip at 8 and rise again beyond 9 ×10⁴ deg/s²."
        ],
    )


def _best_acceleration(runs: CaseRuns) -> float:
    return float(runs.acceleration[runs.best]) if runs.best >= 0 else math.nan


def _acceleration_rows(panels: list[_Panel]) -> tuple[tuple[Cell, ...], ...]:
    return tuple(
        (
            panel.omega_pi,
            angle,
            _best_acceleration(runs),
            *flat_top(runs.curve, runs.acceleration),
            runs.best_rate,
            runs.best_sd,
            runs.curve.gait[runs.best] if runs.best >= 0 else "",
        )
        for panel in panels
        for angle, runs in zip(GAIT_ANGLES, panel.runs, strict=True)
    )


def _draw_accelerations(panels: list[_Panel]) -> Figure:
    figure, all_axes = draw.panels(4, 2, width=4.3, height=3.2)
    for axes, panel in zip(all_axes, panels, strict=True):
        _draw_panel(axes, panel)
    return figure


def _draw_panel(axes: Axes, panel: _Panel) -> None:
    """Rates of one object over the acceleration, and the accelerations best at every amplitude."""
    failures = [
        draw.curve(axes, runs, runs.acceleration, draw.COLOURS[i], f"{runs.case.angle_deg:g} deg")
        for i, runs in enumerate(panel.runs)
    ]
    low, high = panel.optimum
    if low <= high:
        axes.axvspan(low, high, color=draw.COLOURS[6], alpha=0.25, lw=0)
    title = f"({panel.letter}) $\\omega_n$ = {panel.omega_pi:g}π rad/s, fastest {panel.fastest_gait}"
    draw.plain(axes, draw.ACCELERATION, draw.RATE, title)
    draw.finish(axes, failures, title="$A_p$", title_fontsize=7, fontsize=6.5)


def optimum_checks(results: Results) -> tuple[Check, ...]:
    """Whether each object has one acceleration that is best at every amplitude."""
    return tuple(map(_judge_optimum, _panels(results)))


def _judge_optimum(panel: _Panel) -> Check:
    low, high = panel.optimum
    measured = f"{low:.1f} to {high:.1f}" if low <= high else f"none: apart by {low - high:.1f}"
    return Check(
        f"{panel.name}: one acceleration best at every amplitude",
        "within 10 % of each best",
        measured + " ×10⁴ deg/s²",
        low <= high,
    )
