"""Pictures of tilts. They draw what was identified and compute nothing."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from plategait.plots.style import GREY, LINES, label_axes, legend_below, new_figure, plain_text

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from plategait.identify.friction.result import FrictionResult, Trial

_MARKS = "os^Dv<"
_BEFORE = 0.5  # s of rest shown before a slide


def plot_tilt(result: FrictionResult) -> Figure:
    """Position of the object over the angle of the plate, and over the time since it slipped, with the fits."""
    figure = new_figure(9.6, 4.2)
    panels: Any = figure.subplots(1, 2)
    for i, trial in enumerate(result.trials):
        colour, marker = LINES[i % len(LINES)][0], _MARKS[i % len(_MARKS)]
        _draw(panels[0], trial, np.degrees(trial.angle), colour, marker)
        _draw(panels[1], trial, trial.time - _zero(trial), colour, marker)
        if trial.slip_angle is not None:
            panels[0].axvline(math.degrees(trial.slip_angle.value), color=colour, lw=1, ls="--")
    if any(math.isfinite(t.slip_time) for t in result.trials):
        panels[1].axvline(0.0, color=GREY, lw=1, ls="--")
        longest = max(float(t.time[-1] - t.slip_time) for t in result.trials if math.isfinite(t.slip_time))
        panels[1].set_xlim(-_BEFORE, 1.05 * longest)
    for axes, x in zip(panels, ("angle of the plate (deg)", "time since it slipped (s)"), strict=True):
        label_axes(axes, x, "position down the plate (mm)")
    legend_below(figure)
    figure.suptitle(_title(result), x=0.01, ha="left", fontsize=11)
    return figure


def _zero(trial: Trial) -> float:
    return trial.slip_time if math.isfinite(trial.slip_time) else float(trial.time[0])


def _draw(axes: Axes, trial: Trial, x: np.ndarray, colour: str, marker: str) -> None:
    axes.plot(x, 1e3 * trial.position, marker, color=colour, mfc="none", ms=4, alpha=0.7,
              label=plain_text(trial.name))  # fmt: skip
    axes.plot(x, 1e3 * trial.fitted, color="black", lw=1, label="fit")


def _title(result: FrictionResult) -> str:
    if result.static is None:
        return f"no slip up to {math.degrees(max(t.reached for t in result.trials)):.1f} deg"
    angle, parts = result.slip_angle, [f"$\\mu_s$ = {result.static.value:.3f}"]
    assert angle is not None
    parts.append(f"$\\alpha$ = {math.degrees(angle.value):.2f} deg")
    parts.append(f"$\\mu_k$ = {result.kinetic.value:.3f}" if result.kinetic else "$\\mu_k$ not determined")
    return ",  ".join(parts)
