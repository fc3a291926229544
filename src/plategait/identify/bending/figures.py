"""Pictures of bending and compression recordings. They draw what was identified and compute nothing."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from plategait.identify.bending.result import PER_DEGREE, BendingResult
from plategait.identify.compression.result import CompressionResult
from plategait.identify.fit import known
from plategait.identify.shown import words
from plategait.plots.figures import BLUE, GREY, ORANGE


def plot_bending(result: BendingResult) -> Figure:
    """Angle φ2 over time with its reconstruction, as in Fig. 3.7, and what the reconstruction misses."""
    figure = Figure(figsize=(6.4, 5.2), layout="constrained")
    panels: Any = figure.subplots(2, 1, sharex=True, height_ratios=(3, 1))
    measured, fitted = np.degrees(result.phi_2), np.degrees(result.reconstruction)
    panels[0].plot(result.time, measured, ".", color=BLUE, ms=4, label="recorded")
    panels[0].plot(result.time, fitted, color="black", lw=1.2, label="reconstructed")
    panels[1].plot(result.time, measured - fitted, ".", color=BLUE, ms=3)
    panels[1].axhline(0.0, color=GREY, lw=1)
    panels[0].set_ylabel("angle $\\phi_2$ (deg)")
    panels[1].set_ylabel("missed (deg)")
    panels[1].set_xlabel("time (s)")
    panels[0].legend(frameon=False, fontsize=8.5)
    for axes in panels:
        axes.spines[["top", "right"]].set_visible(False)
    figure.suptitle(
        f"$k_b$ = {words(known(result.stiffness), '.3g', PER_DEGREE)} N mm/deg\n"
        f"$c_b$ = {words(known(result.damping), '.3g', PER_DEGREE)} N mm/(deg/s),  "
        f"missed {math.degrees(result.residual_rms):.2g} deg rms",
        x=0.01, ha="left", fontsize=10,
    )  # fmt: skip
    return figure


def plot_compression(result: CompressionResult) -> Figure:
    """Displacement and force over time, with the reconstructed force, as in Fig. 3.9."""
    figure = Figure(figsize=(6.4, 4.6), layout="constrained")
    axes = figure.add_subplot()
    other = axes.twinx()
    time = 1e3 * result.time
    axes.plot(time, 1e3 * result.displacement, "s", color=BLUE, ms=4, mfc="white", label="displacement")
    other.plot(time, result.force, "o", color=ORANGE, ms=4, label="force")
    other.plot(time, result.reconstruction, color="black", lw=1.2, label="force, reconstructed")
    axes.set_xlabel("time (ms)")
    axes.set_ylabel("displacement $s$ (mm)")
    other.set_ylabel("force $f_s$ (N)")
    for each in (axes, other):
        each.spines["top"].set_visible(False)
    figure.legend(frameon=False, fontsize=8.5, loc="upper left", bbox_to_anchor=(0.12, 0.86))
    figure.suptitle(
        f"$k_c$ = {words(known(result.stiffness), '.3g', 1e-3)} N/mm\n"
        f"$c_c$ = {words(known(result.damping), '.3g', 1e-3)} N/(mm/s)",
        x=0.01, ha="left", fontsize=10,
    )  # fmt: skip
    return figure
