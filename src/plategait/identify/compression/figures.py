"""Picture of a pressed link and what was fitted to it."""

from __future__ import annotations

from matplotlib.figure import Figure

from plategait.identify.compression.result import CompressionResult
from plategait.identify.fit import if_determined
from plategait.plots.style import BLUE, ORANGE, label_axes, legend_below, new_figure
from plategait.plots.symbols import told


def plot_compression(result: CompressionResult) -> Figure:
    """Displacement and force over time, with the reconstructed force, as in Fig. 3.9."""
    figure = new_figure(6.4, 4.6)
    axes = figure.add_subplot()
    other = axes.twinx()
    time = 1e3 * result.time
    axes.plot(time, 1e3 * result.displacement, "s", color=BLUE, ms=4, mfc="white", label="displacement")
    other.plot(time, result.force, "o", color=ORANGE, ms=4, label="force")
    other.plot(time, result.reconstruction, color="black", lw=1.2, label="force, reconstructed")
    label_axes(axes, "time (ms)", "displacement $s$ (mm)")
    label_axes(other, "", "force $f_s$ (N)")
    other.spines["right"].set_visible(True)
    legend_below(figure)
    figure.suptitle(
        f"{told('$k_c$', if_determined(result.stiffness), 1e-3, 'N/mm')}\n"
        f"{told('$c_c$', if_determined(result.damping), 1e-3, 'N/(mm/s)')}",
        x=0.01, ha="left", fontsize=10,
    )  # fmt: skip
    return figure
