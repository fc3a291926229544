"""Figures that a paper could print. They draw what was measured and compute nothing."""

from __future__ import annotations

import math
import textwrap
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from plategait.plots.style import BLUE, GREEN, GREY, MARKERS, ORANGE, PARTLY_FAILED, RED, label_axes, mark, new_figure
from plategait.simulation import observables

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from plategait.curve.curve import Curve
    from plategait.model.sheet import Sheet
    from plategait.simulation.energy import EnergyLedger
    from plategait.simulation.result import Simulation

# Plate periods shown where single strides are to be seen.
STRIDES = 6


def plot_curve(curve: Curve) -> Figure:
    """Spin rate over plate frequency, gaits marked as in Figs. 4.4 and 5.2, failures shown, with the Lorentz fit.

    A half-filled mark is of a point at which some runs failed, a cross of one that the fit leaves out.
    """
    figure = new_figure(6.4, 4.2)
    axes = figure.add_subplot()
    f, rate, sd = curve.frequency_hz, curve.spin_rate_deg_s, curve.spin_rate_sd_deg_s
    failed, partly = curve.failed, curve.partly_failed
    if curve.fit is not None:
        grid = np.linspace(f.min(), f[curve.fitted].max(), 400)
        axes.plot(grid, curve.fit(grid), color="black", lw=1.2, zorder=1, label="Lorentz fit (5.5)")
    axes.text(
        0.02, 0.97, _fit_in_words(curve), transform=axes.transAxes, va="top", fontsize=8.5, linespacing=1.4,
        parse_math=curve.fit is not None,  # a reason may hold a dollar sign
    )  # fmt: skip
    for gait, (marker, colour) in MARKERS.items():
        for in_part in (False, True):
            # A failed point has a mark as well where some of its runs went on.
            chosen = np.array([g == gait for g in curve.gait]) & (partly == in_part) & (~failed | partly)
            chosen &= np.isfinite(rate)
            if chosen.any():
                bars = np.where(np.isfinite(sd), sd, 0.0)[chosen]
                label = (gait or "gait unknown") if not in_part else None
                axes.errorbar(f[chosen], rate[chosen], bars, fmt=marker, ecolor=colour, ms=6.5, mew=1.4, label=label,
                              **mark(colour, in_part))  # fmt: skip
    if partly.any():
        axes.plot([], [], "s", ms=6.5, mew=1.4, label=PARTLY_FAILED, **mark(GREY, True))
    if failed.any():
        heights = np.where(np.isfinite(rate), rate, 0.0)[failed]
        # Wider than a mark that it may lie on.
        axes.plot(f[failed], heights, "x", color=GREY, ms=10, mew=1.4, zorder=4, clip_on=False,
                  label="failed: left out of the fit")  # fmt: skip
    beyond = ~curve.fitted & ~failed & np.isfinite(rate)
    if beyond.any():
        axes.plot(
            f[beyond], rate[beyond], "x", color=GREY, ms=9, mew=1, label="beyond the run-off: left out of the fit"
        )
    label_axes(axes, "plate frequency $f_p$ (Hz)", "spin rate $\\omega_B$ (deg/s)")
    axes.set_title(curve.name, loc="left", fontsize=11)
    axes.set_ylim(bottom=min(0.0, float(np.nanmin(np.append(rate, 0.0)))))
    if axes.get_legend_handles_labels()[0]:
        axes.legend(frameon=False, fontsize=8.5, loc="lower right")
    return figure


def _fit_in_words(curve: Curve) -> str:
    fit = curve.fit
    if fit is None:
        return textwrap.fill(f"no Lorentz fit: {curve.no_fit}", 70) if curve.no_fit else ""

    def line(name: str, value: float, interval: tuple[float, float], unit: str) -> str:
        return f"{name} = {value:.4g} {unit}  [{interval[0]:.4g}, {interval[1]:.4g}]"

    return "\n".join(
        (
            line("$f_0$", fit.f0_hz, fit.f0_interval, "Hz"),
            line("$b$", fit.half_width_hz, fit.half_width_interval, "Hz"),
            line("$\\omega_{Br\\,max}$", fit.peak, fit.peak_interval, "deg/s"),
            f"$R^2$ = {fit.r2:.3f}",
        )
    )


def plot_run(simulation: Simulation) -> Figure:
    """One run: rotation and its slope, slip of the centre, which leg touches when, and where the energy went."""
    figure = new_figure(9.0, 6.2)
    panels: Any = figure.subplots(2, 2)
    recording, observation = simulation.recordings[0], simulation.observations[0]
    motion = simulation.scenario.motion
    figure.suptitle(
        f"{simulation.scenario.name}: {motion.frequency:g} Hz, $A_p$ = {math.degrees(motion.angle):.3g} deg, "
        f"$B_p$ = {1e3 * motion.stroke:.3g} mm" + _failed_in_words(simulation),
        x=0.01,
        ha="left",
        fontsize=11,
    )
    _draw_rotation(panels[0, 0], simulation)
    _draw_slip(panels[0, 1], simulation)
    _draw_legs(panels[1, 0], simulation)
    _draw_energy(panels[1, 1], observation.energy)
    for axes in panels[0]:
        axes.set_xlim(0, recording["time"][-1])
        if observation.failure is not None:
            axes.axvline(observation.failure.time, color=RED, lw=1, ls="--")
            axes.text(
                observation.failure.time,
                axes.get_ylim()[1],
                f" {observation.failure.kind}",
                color=RED,
                va="top",
                fontsize=8.5,
            )
    return figure


def _failed_in_words(simulation: Simulation) -> str:
    failed, runs = simulation.failed_runs, len(simulation.observations)
    return f"; {failed} of {runs} runs failed" if failed and runs > 1 else ""


def _draw_rotation(axes: Axes, simulation: Simulation) -> None:
    for i, recording in enumerate(simulation.recordings):
        angle = np.degrees(observables.rotation(recording["spin_cross"], recording["spin_dot"]))
        axes.plot(recording["time"], angle, color=BLUE, lw=1.2 if i == 0 else 0.5, alpha=1 if i == 0 else 0.5)
    spin, recording = simulation.observations[0].spin, simulation.recordings[0]
    if math.isfinite(spin.rate):
        failure = simulation.observations[0].failure
        start, end = simulation.scenario.measured_from, failure.sound_until if failure else recording["time"][-1]
        angle = np.degrees(observables.rotation(recording["spin_cross"], recording["spin_dot"]))
        window = np.array([start, end])
        middle = np.interp(window.mean(), recording["time"], angle)
        slope = math.degrees(spin.rate)
        label = f"{slope:.1f} deg/s [{math.degrees(spin.low):.1f}, {math.degrees(spin.high):.1f}]"
        label += "" if spin.settled else ", not settled"
        axes.plot(window, middle + slope * (window - window.mean()), color="black", lw=1, ls="--", label=label)
        axes.legend(frameon=False, fontsize=8.5, loc="upper left")
    label_axes(axes, "time (s)", "rotation (deg)")


def _draw_slip(axes: Axes, simulation: Simulation) -> None:
    limit = 1e3 * simulation.scenario.slip_limit
    furthest = limit
    for recording in simulation.recordings:
        slipped = observables.slip(
            recording["time"], recording["centre_x"], recording["centre_y"], simulation.scenario.motion.period
        )
        axes.plot(recording["time"], 1e3 * slipped, color=BLUE, lw=1)
        furthest = max(furthest, float(np.nanmax(1e3 * slipped)))
    axes.axhline(limit, color=GREY, lw=1, ls=":")
    axes.text(
        0.01, limit, f"limit {limit:g} mm", color=GREY, va="bottom", fontsize=8.5, transform=axes.get_yaxis_transform()
    )
    axes.set_ylim(0, 1.3 * furthest)
    label_axes(axes, "time (s)", "slip of the centre (mm)")


def _draw_legs(axes: Axes, simulation: Simulation) -> None:
    recording, period = simulation.recordings[0], simulation.scenario.motion.period
    failure = simulation.observations[0].failure
    end = failure.sound_until if failure else recording["time"][-1]
    last = (recording["time"] > end - STRIDES * period) & (recording["time"] <= end)
    time = 1e3 * recording["time"][last]
    for row, (channel, label, colour) in enumerate(
        (("flight", "nothing touches", RED), ("right_contact", "right leg", GREEN), ("left_contact", "left leg", BLUE))
    ):
        axes.fill_between(time, row, row + 0.8 * recording[channel][last], step="pre", color=colour, lw=0)
        axes.text(-0.01, row + 0.4, label, transform=axes.get_yaxis_transform(), ha="right", va="center", fontsize=8.5)
    axes.set_yticks([])
    axes.set_ylim(-0.1, 3)
    label_axes(axes, "time (ms)", "")
    axes.spines["left"].set_visible(False)
    gait = simulation.observations[0].gait or "nothing measured"
    axes.set_title(f"share of the time in contact: {gait}", loc="left", fontsize=9.5)


def _draw_energy(axes: Axes, energy: EnergyLedger) -> None:
    rows = [
        ("work of the plate", energy.plate_work, BLUE),
        ("lost to friction", energy.friction_loss, ORANGE),
        ("lost in the contact", energy.contact_loss, ORANGE),
        ("lost in the joints", energy.joint_loss, ORANGE),
        ("stored", energy.kinetic + energy.gravity + energy.elastic + energy.contact_stored, GREEN),
        ("unaccounted for", energy.residual, RED),
    ]
    values = [1e3 * value for _, value, _ in rows]
    axes.barh(range(len(rows)), values, color=[colour for *_, colour in rows], height=0.6)
    axes.set_yticks(range(len(rows)), [name for name, *_ in rows], fontsize=8.5)
    axes.invert_yaxis()
    for i, value in enumerate(values):
        axes.text(value, i, f" {value:.3g}", va="center", fontsize=8.5)
    axes.margins(x=0.15)
    label_axes(axes, "energy over the run (mJ)", "")
    if not energy.closes:
        axes.set_title(f"does not balance: out by {energy.imbalance:.2g} of the energy given", loc="left", fontsize=9.5,
                       color=RED)  # fmt: skip


def plot_modes(sheet: Sheet, count: int = 6) -> Figure:
    """Free-vibration modes of a sheet as maps of deflection, the first `count` of them."""
    modes = sheet.free_modes.modes[:count]
    columns = min(3, max(1, len(modes)))
    rows = max(1, math.ceil(len(modes) / columns))
    figure = new_figure(2.7 * columns, 2.9 * rows)
    lattice = sheet.lattice
    figure.suptitle(f"{sheet.name}: free-vibration modes", x=0.01, ha="left", fontsize=11)
    for axes, mode in zip(np.atleast_1d(figure.subplots(rows, columns, squeeze=False).ravel()), modes, strict=False):
        field = np.full(lattice.occupied.shape, np.nan)
        field[lattice.squares[:, 0], lattice.squares[:, 1]] = mode.shape
        axes.imshow(field.T, origin="lower", cmap="RdBu_r", vmin=-1, vmax=1, interpolation="nearest")
        axes.set_title(
            f"{mode.name or 'unnamed'}\n{mode.frequency:.2f} Hz = {mode.omega / math.pi:.2f}π rad/s", fontsize=9
        )
    for axes in figure.axes:
        axes.axis("off")
    return figure
