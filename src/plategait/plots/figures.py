"""Figures that a paper could print. They draw what was measured and compute nothing."""

from __future__ import annotations

import math
import textwrap
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from plategait.arrays import Flags
from plategait.plots.failures import Failures, draw_failures, failure_handles
from plategait.plots.style import (
    BLUE,
    GREEN,
    GREY,
    MARKERS,
    ORANGE,
    PARTLY_FAILED,
    RED,
    SMALL,
    head,
    label_axes,
    legend_below,
    mark,
    new_figure,
    plain_text,
)  # fmt: skip
from plategait.plots.symbols import FREQUENCY, SPIN_RATE, motion_in_words, span
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

    Its head tells the amplitudes, how many runs a point is made of, and the fit. A half-filled mark is of a point at
    which some runs failed. What failed lies in a band under the axes, by what went wrong, and is left out of the fit;
    a cross among the rates is of a point that has a rate and is left out too.
    """
    figure = new_figure(6.4, 4.6)
    axes = figure.add_subplot()
    f, rate = curve.frequency_hz, curve.spin_rate_deg_s
    failed, partly = curve.failed, curve.partly_failed
    if curve.fit is not None:
        grid = np.linspace(f.min(), f[curve.fitted].max(), 400)
        axes.plot(grid, curve.fit(grid), color="black", lw=1.2, zorder=1, label="Lorentz fit (5.5)")
    for gait in MARKERS:
        for in_part in (False, True):
            # A failed point has a mark as well where some of its runs went on.
            chosen = np.array([g == gait for g in curve.gait]) & (partly == in_part) & (~failed | partly)
            _draw_rates(axes, curve, chosen & np.isfinite(rate), gait, in_part)
    if partly.any():
        axes.plot([], [], "s", ms=6.5, mew=1.4, label=PARTLY_FAILED, **mark(GREY, True))
    left_out = ~curve.fitted & ((failed & ~partly) | ~failed) & np.isfinite(rate)
    if left_out.any():
        axes.plot(f[left_out], rate[left_out], "x", color=GREY, ms=9, mew=1.2, zorder=4, label="left out of the fit")
    label_axes(axes, FREQUENCY, SPIN_RATE)
    # Only a spin rate out of phase is below zero.
    low, high = float(np.nanmin(np.append(rate, 0.0))), float(np.nanmax(np.append(rate, 0.0)))
    axes.set_ylim(bottom=min(0.0, 1.05 * low))
    if high <= 0 > low:
        axes.set_ylim(top=0.0)
    kinds = [kind for kind, fails in zip(curve.failure, failed, strict=True) if fails]
    draw_failures(axes, [Failures(f[failed], kinds)])
    head(axes, curve.name, [line for line in (_conditions(curve), *_fit_in_words(curve)) if line])
    legend_below(figure, [*axes.get_legend_handles_labels()[0], *failure_handles(kinds)])
    return figure


def _draw_rates(axes: Axes, curve: Curve, chosen: Flags, gait: str, in_part: bool) -> None:
    if not chosen.any():
        return
    marker, colour = MARKERS[gait]
    sd = curve.spin_rate_sd_deg_s[chosen]
    axes.errorbar(curve.frequency_hz[chosen], curve.spin_rate_deg_s[chosen], np.where(np.isfinite(sd), sd, 0.0),
                  fmt="none", ecolor=colour, elinewidth=1.2)  # fmt: skip
    axes.plot(curve.frequency_hz[chosen], curve.spin_rate_deg_s[chosen], marker, ms=6.5, mew=1.4,
              label=None if in_part else gait or "gait unknown", **mark(colour, in_part))  # fmt: skip


def _conditions(curve: Curve) -> str:
    """Amplitudes of the plate, and what each point is made of, so far as they are known."""
    motions = [simulation.scenario.motion for simulation in curve.simulations]
    angle = np.degrees([motion.angle for motion in motions]) if motions else curve.angle_deg
    stroke = np.array([motion.stroke for motion in motions]) if motions else curve.stroke
    parts = [
        f"{symbol} = {span(scale * values, unit)}"
        for symbol, values, scale, unit in (("$A_p$", angle, 1.0, "deg"), ("$B_p$", stroke, 1e3, "mm"))
        if values is not None and np.isfinite(values).any()
    ]
    if curve.runs is not None and np.isfinite(curve.runs).any():
        runs = span(curve.runs, "")
        bars = runs != "1" and np.isfinite(curve.spin_rate_sd_deg_s).any()
        parts.append(f"{runs} run{'' if runs == '1' else 's'} a point" + (", bars: their sd" if bars else ""))
    return ", ".join(parts)


def _fit_in_words(curve: Curve) -> tuple[str, ...]:
    fit = curve.fit
    if fit is None:
        return tuple(textwrap.wrap(f"no Lorentz fit: {plain_text(curve.no_fit)}", 95)) if curve.no_fit else ()

    def told(name: str, value: float, interval: tuple[float, float], unit: str) -> str:
        return f"{name} = {value:.4g} {unit} [{interval[0]:.4g}, {interval[1]:.4g}]"

    where = told("$f_0$", fit.f0_hz, fit.f0_interval, "Hz")
    width = told("$b$", fit.half_width_hz, fit.half_width_interval, "Hz")
    peak = told("$\\omega_{Br\\,max}$", fit.peak, fit.peak_interval, "deg/s")
    return f"{where}, {width}", f"{peak}, $R^2$ = {fit.r2:.3f}"


def plot_run(simulation: Simulation) -> Figure:
    """One run: rotation and its slope, slip of the centre, which leg touches when, and where the energy went."""
    figure = new_figure(9.0, 6.4)
    panels: Any = figure.subplots(2, 2)
    observation, runs = simulation.observations[0], len(simulation.observations)
    name = plain_text(simulation.scenario.name)
    several = f"; {runs} runs, the first of them in bold and below" if runs > 1 else ""
    figure.suptitle(
        f"{name}: {motion_in_words(simulation.scenario.motion)}{several}{_failed_in_words(simulation)}",
        x=0.01, ha="left", fontsize=10.5,
    )  # fmt: skip
    _draw_rotation(panels[0, 0], simulation)
    _draw_slip(panels[0, 1], simulation)
    _draw_legs(panels[1, 0], simulation)
    _draw_energy(panels[1, 1], observation.energy)
    return figure


def _failed_in_words(simulation: Simulation) -> str:
    failed, runs = simulation.failed_runs, len(simulation.observations)
    return f"; {failed} of {runs} failed" if failed and runs > 1 else ""


def _mark_failure(axes: Axes, simulation: Simulation) -> str:
    """A line at the first run's failure, and words for it."""
    axes.set_xlim(0, simulation.recordings[0]["time"][-1])
    failure = simulation.observations[0].failure
    if failure is None:
        return ""
    axes.axvline(failure.time, color=RED, lw=1.2, ls="--")
    return f"{failure.kind} at {failure.time:.2f} s (dashed)"


def _draw_rotation(axes: Axes, simulation: Simulation) -> None:
    spin = simulation.observations[0].spin
    for i, recording in enumerate(simulation.recordings):
        angle = np.degrees(observables.rotation(recording["spin_cross"], recording["spin_dot"]))
        axes.plot(recording["time"], angle, color=BLUE, lw=1.5 if i == 0 else 0.7, alpha=1 if i == 0 else 0.5)
    words = _mark_failure(axes, simulation)
    if math.isfinite(spin.rate):
        recording, failure = simulation.recordings[0], simulation.observations[0].failure
        start, end = simulation.scenario.measured_from, failure.sound_until if failure else recording["time"][-1]
        angle = np.degrees(observables.rotation(recording["spin_cross"], recording["spin_dot"]))
        window = np.array([start, end])
        middle = np.interp(window.mean(), recording["time"], angle)
        slope = math.degrees(spin.rate)
        axes.plot(window, middle + slope * (window - window.mean()), color="black", lw=1, ls="--")
        words = f"{words}\n" if words else ""
        words += f"$\\omega_B$ = {slope:.1f} deg/s [{math.degrees(spin.low):.1f}, {math.degrees(spin.high):.1f}]"
        words += "" if spin.settled else ", not settled"
    label_axes(axes, "time (s)", "rotation (deg)")
    axes.set_title(words, loc="left", fontsize=9.5)


def _draw_slip(axes: Axes, simulation: Simulation) -> None:
    limit, period = 1e3 * simulation.scenario.slip_limit, simulation.scenario.motion.period
    furthest = limit
    for i, recording in enumerate(simulation.recordings):
        time = recording["time"]
        slipped = 1e3 * observables.slip(time, recording["centre_x"], recording["centre_y"], period)
        # Within half a period of the end the centre's swing is not averaged out.
        shown = time <= max(time[-1] - period / 2, time[0])
        axes.plot(time[shown], slipped[shown], color=BLUE, lw=1.5 if i == 0 else 0.7, alpha=1 if i == 0 else 0.5)
        furthest = max(furthest, float(np.nanmax(slipped)))
    axes.axhline(limit, color=GREY, lw=1, ls=":")
    axes.set_ylim(0, 1.15 * furthest)
    words = _mark_failure(axes, simulation)
    label_axes(axes, "time (s)", "slip of the centre (mm)")
    axes.set_title(", ".join(filter(None, (words, f"limit {limit:g} mm (dotted)"))), loc="left", fontsize=9.5)


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
    gait, periods = (
        simulation.observations[0].gait,
        f"the last {STRIDES} periods" + (" before it failed" if failure else ""),
    )
    axes.set_title(f"contact in {periods}" + (f": {gait}" if gait else ""), loc="left", fontsize=9.5)


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
        axes.text(max(value, 0.0), i, f" {value:.3g}".replace("-", "−"), va="center", fontsize=SMALL)
    axes.margins(x=0.15)
    label_axes(axes, "energy over the run (mJ)", "")
    if not energy.closes:
        axes.set_title(f"does not balance: out by {energy.imbalance:.2g} of the energy given", loc="left", fontsize=9.5,
                       color=RED)  # fmt: skip


def plot_modes(sheet: Sheet, count: int = 6) -> Figure:
    """Free-vibration modes of a sheet as maps of deflection over its greatest, the first `count` of them, in mm."""
    modes = sheet.free_modes.modes[:count]
    columns = min(4, max(1, len(modes)))
    rows = max(1, math.ceil(len(modes) / columns))
    lattice = sheet.lattice
    slender = min(2.0, max(0.35, lattice.occupied.shape[1] / lattice.occupied.shape[0]))
    figure = new_figure(2.4 * columns + 1.0, (1.9 * slender + 0.7) * rows + 0.6)
    figure.suptitle(plain_text(f"{sheet.name}: free-vibration modes"), x=0.01, ha="left", fontsize=11)
    panels = figure.subplots(rows, columns, squeeze=False, sharex=True, sharey=True)
    half = 500 * sheet.pitch * np.array(lattice.occupied.shape)
    image = None
    for axes, mode in zip(panels.ravel(), modes, strict=False):
        field = np.full(lattice.occupied.shape, np.nan)
        field[lattice.squares[:, 0], lattice.squares[:, 1]] = mode.shape
        image = axes.imshow(field.T, origin="lower", cmap="RdBu_r", vmin=-1, vmax=1, interpolation="nearest",
                            extent=(-half[0], half[0], -half[1], half[1]))  # fmt: skip
        frequency = f"{mode.frequency:.2f} Hz, $\\omega$ = {mode.omega / math.pi:.2f}π rad/s"
        axes.set_title(f"{mode.name or 'unnamed'}\n{frequency}", fontsize=9)
        axes.spines[["top", "right"]].set_visible(False)
    for axes in panels.ravel()[len(modes) :]:
        axes.set_visible(False)
    for i, axes in enumerate(panels.ravel()[: len(modes)]):
        axes.tick_params(labelbottom=i + columns >= len(modes), labelleft=i % columns == 0)
        axes.set_xlabel("$x$ (mm)" if i + columns >= len(modes) else "")
        axes.set_ylabel("$y$ (mm)" if i % columns == 0 else "")
    if image is not None:
        figure.colorbar(image, ax=panels, label="deflection over its greatest", shrink=0.8, aspect=30)
    return figure
