"""Pictures of a search: where the fast motions lie, the ridge of section 4.4, and what speed costs."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from plategait.optimize.goal import COSTS
from plategait.optimize.optimum import Optimum, front
from plategait.optimize.report import angular_acceleration, in_peoples, known_costs
from plategait.plots.style import (
    BLUE,
    GREY,
    ORANGE,
    RED,
    label_axes,
    legend_below,
    new_figure,
    plain_logarithms,
    plain_text,
)
from plategait.plots.symbols import ACCELERATION, FREQUENCY, SPIN_RATE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from plategait.optimize.trials import Trial

_LABELS = {
    "acceleration": "acceleration under the object's rim (m/s²)", "torque": "torque (N·m)", "power": "power (W)",
    "bending": "bending of the object (deg)",
}  # fmt: skip
_STAR: dict[str, Any] = {"marker": "*", "ms": 15, "mfc": ORANGE, "mec": "black", "ls": "none", "label": "optimum"}


def plot_optimum(optimum: Optimum) -> Figure:
    """Every motion that was tried: in the plane of frequency and amplitude, over A_p ω_p², and over what it costs."""
    other = optimum.goal.cost if optimum.goal.cost != "bending" else "acceleration"
    costs = [name for name in ("bending", other) if name in known_costs(optimum.trial)] or ["bending"]
    panels = 2 + len(costs)
    figure = new_figure(4.6 * min(panels, 2), 3.8 * math.ceil(panels / 2))
    axes = figure.subplots(math.ceil(panels / 2), 2, squeeze=False).ravel()
    _draw_plane(axes[0], optimum, figure)
    _draw_ridge(axes[1], optimum)
    for each, cost in zip(axes[2:], costs, strict=False):
        _draw_front(each, optimum, cost)
    for unused in axes[panels:]:
        unused.set_visible(False)
    trial = optimum.trial
    rate = f"{math.degrees(trial.spin_rate):.0f} deg/s" if trial.counted else "every run fails"
    legend_below(figure, columns=5)
    figure.suptitle(
        plain_text(f"{optimum.scenario.name} on {optimum.machine.name}, {optimum.goal.words}: {rate} ")
        + f"at $f_p$ = {trial.motion.frequency:.1f} Hz", fontsize=10, x=0.01, ha="left",
    )  # fmt: skip
    return figure


def _stays(optimum: Optimum) -> list[Trial]:
    return [trial for trial in optimum.trials if not trial.failed and trial.counted]


def _rate(trials: list[Trial]) -> list[float]:
    return [abs(math.degrees(trial.spin_rate)) for trial in trials]


def _amplitude(trial: Trial, rocks: bool) -> float:
    return abs(math.degrees(trial.motion.angle)) if rocks else 1e3 * trial.motion.stroke


def _draw_plane(axes: Axes, optimum: Optimum, figure: Figure) -> None:
    rocks = optimum.trial.motion.angle != 0
    stays, failed = _stays(optimum), [trial for trial in optimum.trials if trial.failed]
    axes.plot([t.motion.frequency for t in failed], [_amplitude(t, rocks) for t in failed], "x", color=GREY, ms=3.5,
              mew=0.8, label="a run failed")  # fmt: skip
    marks = axes.scatter([t.motion.frequency for t in stays], [_amplitude(t, rocks) for t in stays], c=_rate(stays),
                         s=14, cmap="viridis")  # fmt: skip
    best = optimum.trial
    low, high = min(t.motion.frequency for t in optimum.trials), max(t.motion.frequency for t in optimum.trials)
    frequency = np.geomspace(low, max(high, 1.001 * low), 50)
    if rocks:
        along = angular_acceleration(best.motion) / (2 * math.pi * frequency) ** 2
        axes.plot(frequency, along, color=RED, lw=1, ls="--", label="$A_p\\,\\omega_p^2$ of the optimum")
    axes.plot([best.motion.frequency], [_amplitude(best, rocks)], **_STAR)
    values = [_amplitude(t, rocks) for t in optimum.trials if _amplitude(t, rocks) > 0]
    axes.set_xscale("log")
    axes.set_yscale("log")
    if values:
        axes.set_ylim(0.9 * min(values), 1.1 * max(values))
    ticks = [f for f in (1, 2, 5, 10, 15, 20, 30, 40, 60, 100) if low <= f <= high]
    axes.set_xticks(ticks, [str(f) for f in ticks])
    axes.minorticks_off()
    plain_logarithms(axes.yaxis)
    label_axes(axes, FREQUENCY, "$A_p$ (deg)" if rocks else "$B_p$ (mm)")
    if stays:
        figure.colorbar(marks, ax=axes, label=SPIN_RATE)


def _draw_ridge(axes: Axes, optimum: Optimum) -> None:
    stays, best = _stays(optimum), optimum.trial
    axes.plot([1e-4 * angular_acceleration(t.motion) for t in stays], _rate(stays), "o", color=BLUE, ms=3.5, mew=0)
    axes.plot([1e-4 * angular_acceleration(best.motion)], _rate([best]), **_STAR)
    label_axes(axes, ACCELERATION, SPIN_RATE)
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)


def _draw_front(axes: Axes, optimum: Optimum, cost: str) -> None:
    quantity = COSTS[cost]  # type: ignore[index]

    def values(trials: list[Trial]) -> list[float]:
        return [in_peoples(t.cost(cost), quantity) for t in trials]  # type: ignore[arg-type]

    stays, best = _stays(optimum), front(optimum.trials, cost)
    axes.plot(values(stays), _rate(stays), "o", color=GREY, ms=3, mew=0, alpha=0.6)
    axes.plot(values(best), _rate(best), color=BLUE, lw=1.4, marker="o", ms=3.5, label="none is faster for less")
    axes.plot(values([optimum.trial]), _rate([optimum.trial]), **_STAR)
    label_axes(axes, _LABELS[cost], SPIN_RATE)
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
