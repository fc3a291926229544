"""Pictures of free vibrations. They draw what was identified and compute nothing but a spectrum."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from plategait.plots.style import BLUE, GREY, RED, label_axes, legend_below, new_figure, plain_logarithms, plain_text

if TYPE_CHECKING:
    from plategait.identify.modes.result import RingResult

_SHOWN = {"deflection": (1e3, "deflection (mm)"), "angle": (math.degrees(1), "angle (deg)"), "signal": (1.0, "signal")}


def plot_ring(result: RingResult) -> Figure:
    """Signal with the fit, what the fit leaves, and the spectra of both."""
    figure = new_figure(9.6, 4.8)
    grid = figure.add_gridspec(2, 2, width_ratios=(3, 2), height_ratios=(3, 1))
    above: Any = figure.add_subplot(grid[0, 0])
    below: Any = figure.add_subplot(grid[1, 0], sharex=above)
    spectrum: Any = figure.add_subplot(grid[:, 1])
    factor, label = _SHOWN[result.kind]
    time, left = result.time, result.signal - result.fitted
    above.plot(time, factor * result.signal, ".", color=BLUE, ms=3, label="recorded")
    above.plot(time, factor * result.fitted, color="black", lw=1, label="fit")
    label_axes(above, "", label)
    below.plot(time, factor * left, color=GREY, lw=0.8)
    label_axes(
        below, "time (s)", "residual" + label.removeprefix("deflection").removeprefix("angle").removeprefix("signal")
    )
    frequency = np.fft.rfftfreq(len(time), (time[-1] - time[0]) / (len(time) - 1))[1:]
    for values, colour, name in ((result.signal, BLUE, "recorded, its spectrum"), (left, GREY, "residual")):
        size = 2 * np.abs(np.fft.rfft(factor * (values - values.mean())))[1:] / len(time)
        spectrum.semilogy(frequency, np.maximum(size, 1e-12 * factor), color=colour, lw=1, label=name)
    for mode in result.modes:
        if mode.rings:
            spectrum.axvline(mode.frequency, color=RED, lw=1, ls="--", label="mode that rings")
    label_axes(spectrum, "frequency (Hz)", f"amplitude of {label}")
    plain_logarithms(spectrum.yaxis)
    legend_below(figure)
    figure.suptitle(_title(result), x=0.01, ha="left", fontsize=11)
    return figure


def _title(result: RingResult) -> str:
    mode = result.mode
    if mode is None:
        return f"{plain_text(result.name)}: nothing rings"
    return (
        f"{plain_text(result.name)}: {mode.frequency:.3f} Hz, $\\omega_n$ = {mode.omega.value / math.pi:.3f}π rad/s, "
        f"$\\zeta$ = {mode.damping_ratio.value:.3f}"
    )
