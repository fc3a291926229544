"""Pictures of tilts. They draw what was identified and compute nothing."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from plategait.plots.style import BLUE, GREEN, GREY, ORANGE, RED, new_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from plategait.identify.friction.result import FrictionResult, Trial

_COLOURS = (BLUE, ORANGE, GREEN, RED)
_BEFORE = 0.5  # s of rest shown before a slide


def plot_tilt(result: FrictionResult) -> Figure:
    """Position of the object over the angle of the plate, and over the time since it slipped, with the fits."""
    figure = new_figure(9.6, 4.2)
    panels: Any = figure.subplots(1, 2)
    for i, trial in enumerate(result.trials):
        colour = _COLOURS[i % len(_COLOURS)]
        _draw(panels[0], trial, np.degrees(trial.angle), colour)
        _draw(panels[1], trial, trial.time - _zero(trial), colour)
        if trial.slip_angle is not None:
            panels[0].axvline(math.degrees(trial.slip_angle.value), color=colour, lw=1, ls="--")
    if any(math.isfinite(t.slip_time) for t in result.trials):
        panels[1].axvline(0.0, color=GREY, lw=1, ls="--")
        longest = max(float(t.time[-1] - t.slip_time) for t in result.trials if math.isfinite(t.slip_time))
        panels[1].set_xlim(-_BEFORE, 1.05 * longest)
    for axes, x in zip(panels, ("angle of the plate (deg)", "time since it slipped (s)"), strict=True):
        axes.set_xlabel(x)
        axes.set_ylabel("position down the plate (mm)")
        axes.spines[["top", "right"]].set_visible(False)
    panels[0].legend(frameon=False, fontsize=8.5, loc="upper left")
    figure.suptitle(_title(result), x=0.01, ha="left", fontsize=11)
    return figure


def _zero(trial: Trial) -> float:
    return trial.slip_time if math.isfinite(trial.slip_time) else float(trial.time[0])


def _draw(axes: Axes, trial: Trial, x: np.ndarray, colour: str) -> None:
    axes.plot(x, 1e3 * trial.position, ".", color=colour, ms=4, alpha=0.6, label=trial.name)
    axes.plot(x, 1e3 * trial.fitted, color="black", lw=1)


def _title(result: FrictionResult) -> str:
    if result.static is None:
        return f"no slip up to {math.degrees(max(t.reached for t in result.trials)):.1f} deg"
    angle, parts = result.slip_angle, [f"$\\mu_s$ = {result.static.value:.3f}"]
    assert angle is not None
    parts.append(f"$\\alpha$ = {math.degrees(angle.value):.2f} deg")
    parts.append(f"$\\mu_k$ = {result.kinetic.value:.3f}" if result.kinetic else "$\\mu_k$ not determined")
    return ",  ".join(parts)
