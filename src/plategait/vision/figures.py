"""The picture of a clip: how the object turned, frame by frame, and its way over the plate."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from plategait.plots.style import BLUE, GREEN, GREY, RED, label_axes, legend_below, new_figure, plain_text
from plategait.vision.track import Track

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def plot_track(track: Track) -> Figure:
    """Orientation over time with the spin rate that it gives, frames that are not sure apart, and the object's way."""
    figure = new_figure(9.6, 4.6)
    left, right = figure.subplots(1, 2, width_ratios=(1.5, 1))
    _draw_turning(left, track)
    _draw_way(right, track)
    legend_below(figure, columns=6)
    plate = f", plate at $f_p$ = {track.plate_frequency:.4g} Hz" if math.isfinite(track.plate_frequency) else ""
    sure = f"{int(track.sure.sum())} of {len(track.time)} frames sure"
    figure.suptitle(f"{plain_text(track.name)}, followed by {track.method}: {sure}{plate}", x=0.01, ha="left",
                    fontsize=10.5)  # fmt: skip
    return figure


def _draw_turning(axes: Axes, track: Track) -> None:
    sure, angle, spin = track.sure, np.degrees(track.angle), track.spin
    unsure = ~sure & np.isfinite(angle)
    axes.plot(track.time[unsure], angle[unsure], "x", color=GREY, ms=4, mew=0.9, label="not sure: left out")
    axes.plot(track.time[sure], angle[sure], ".", color=BLUE, ms=4, label="sure")
    if math.isfinite(spin.rate) and sure.any():
        time, slope = track.time[sure], math.degrees(spin.rate)
        ends = np.array([time[0], time[-1]])
        middle = float(np.median(angle[sure] - slope * time))
        axes.plot(ends, middle + slope * ends, color="black", lw=1, ls="--", label="spin rate")
        words = f"$\\omega_B$ = {slope:.1f} deg/s [{math.degrees(spin.low):.1f}, {math.degrees(spin.high):.1f}]"
        words += "" if spin.settled else ", not settled"
    else:
        words = plain_text(spin.reason or "no spin rate")
    label_axes(axes, "time (s)", "orientation (deg)")
    axes.set_title(words, loc="left", fontsize=9.5)


def _draw_way(axes: Axes, track: Track) -> None:
    placed = track.placed & np.isfinite(track.x) & np.isfinite(track.y)
    x, y = 1e3 * track.x[placed], 1e3 * track.y[placed]
    axes.plot(x, y, ".", color=BLUE, ms=4, alpha=0.6, label="its middle")
    if len(x):
        axes.plot(x[0], y[0], "o", color=GREEN, ms=6, label="where it was seen first")
        axes.plot(x[-1], y[-1], "X" if track.failure else "D", color=RED, ms=6, label="where last")
    axes.set_aspect("equal", adjustable="datalim")
    label_axes(axes, "$x$ along the bar (mm)", "$y$ across it (mm)")
    axes.set_title(", ".join(filter(None, (track.failure, f"drift {1e3 * track.drift:.3g} mm"))), loc="left",
                   fontsize=9.5)  # fmt: skip
