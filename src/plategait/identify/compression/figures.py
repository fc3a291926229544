"""Picture of a pressed link and what was fitted to it."""

from __future__ import annotations

from matplotlib.figure import Figure

from plategait.identify.compression.result import CompressionResult
from plategait.identify.fit import if_determined
from plategait.model.measured import as_text
from plategait.plots.style import BLUE, ORANGE, new_figure


def plot_compression(result: CompressionResult) -> Figure:
    """Displacement and force over time, with the reconstructed force, as in Fig. 3.9."""
    figure = new_figure(6.4, 4.6)
    axes = figure.add_subplot()
    other = axes.twinx()
    time = 1e3 * result.time
    axes.plot(time, 1e3 * result.displacement, "s", color=BLUE, ms=4, mfc="white", label="displacement")
    other.plot(time, result.force, "o", color=ORANGE, ms=4, label="force")
    other.plot(time, result.reconstruction, color="black", lw=1.2, label="force, reconstructed")
    axes.set_xlabel("time (ms)")
    axes.set_ylabel("displacement $s$ (mm)")
    other.set_ylabel("force $f_s$ (N)")
    for side in (axes, other):
        side.spines["top"].set_visible(False)
    figure.legend(frameon=False, fontsize=8.5, loc="upper left", bbox_to_anchor=(0.12, 0.86))
    figure.suptitle(
        f"$k_c$ = {as_text(if_determined(result.stiffness), '.3g', 1e-3)} N/mm\n"
        f"$c_c$ = {as_text(if_determined(result.damping), '.3g', 1e-3)} N/(mm/s)",
        x=0.01, ha="left", fontsize=10,
    )  # fmt: skip
    return figure
