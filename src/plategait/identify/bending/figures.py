"""Picture of a bending recording and what was fitted to it. It draws what was identified and computes nothing."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from plategait.identify.bending.result import PER_DEGREE, BendingResult
from plategait.identify.fit import if_determined
from plategait.plots.style import BLUE, GREY, label_axes, legend_below, new_figure
from plategait.plots.symbols import told


def plot_bending(result: BendingResult) -> Figure:
    """Angle φ2 over time with its reconstruction, as in Fig. 3.7, and what the reconstruction misses."""
    figure = new_figure(6.4, 5.2)
    panels: Any = figure.subplots(2, 1, sharex=True, height_ratios=(3, 1))
    measured, fitted = np.degrees(result.phi_2), np.degrees(result.reconstruction)
    panels[0].plot(result.time, measured, ".", color=BLUE, ms=4, label="recorded")
    panels[0].plot(result.time, fitted, color="black", lw=1.2, label="reconstructed")
    panels[1].plot(result.time, measured - fitted, ".", color=BLUE, ms=3)
    panels[1].axhline(0.0, color=GREY, lw=1)
    label_axes(panels[0], "", "angle $\\phi_2$ (deg)")
    label_axes(panels[1], "time (s)", "missed (deg)")
    legend_below(figure)
    figure.suptitle(
        f"{told('$k_b$', if_determined(result.stiffness), PER_DEGREE, 'N mm/deg')}\n"
        f"{told('$c_b$', if_determined(result.damping), PER_DEGREE, 'N mm/(deg/s)')},  "
        f"missed {math.degrees(result.residual_rms):.2g} deg r.m.s.",
        x=0.01, ha="left", fontsize=10,
    )  # fmt: skip
    return figure
