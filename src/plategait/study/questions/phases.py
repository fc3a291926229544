"""Phase and period of the two motions: which of them turn the object, and which carry it."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.model.motion import Wave
from plategait.model.presets import preset
from plategait.model.scenario import Scenario
from plategait.plots.style import BLUE, GREEN, GREY, ORANGE, RED, label_axes, legend_below, new_figure
from plategait.study.catalogue import Question
from plategait.study.claims import Answer, Claim, number_of
from plategait.study.measured import Columns, Measured
from plategait.study.runs import Runs
from plategait.thesis.item import Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

RATIOS = (0.5, 1.0, 1.5, 2.0, 2.5, 3.0)
"""Frequency of shaking over that of rocking."""
PHASES = tuple(range(0, 360, 30))
"""Of shaking when rocking begins, deg; 0 is the source's motion."""
FREQUENCY, ANGLE, STROKE = 18.0, math.radians(3), 0.003
"""Of rocking, Hz; its amplitude, rad; and that of shaking at ratio 1, m: at others the plate moves as fast."""
FREQUENCIES = (14.0, 16.0, FREQUENCY, 20.0, 22.0, 24.0)
"""At which the phase is looked at with ratio 1, Hz."""
BEATING = 1.05
"""A ratio at which the phase goes round."""
TURN = RATIOS.index(1.0)
STILL = 0.05
"""What counts as none, as a share of the greatest at any ratio."""


def moved(ratio: float, phase: float, frequency: float = FREQUENCY, duration: float = 2.0) -> Scenario:
    """The cheese under rocking at a frequency, and shaking at `ratio` of it, `phase` deg ahead."""
    shaking = Wave(axis="x", amplitude=STROKE / ratio, ratio=ratio, phase=math.radians(phase))
    changes = {"motion.frequency": frequency, "motion.angle": ANGLE, "motion.stroke": 0.0, "motion.waves": (shaking,),
               "slip_limit": 10.0, "duration": duration}  # fmt: skip
    return preset("cheese").scenario.replace(**changes)


def measure_map(runs: Runs) -> Measured:
    """Points in the order of `RATIOS`, then of `PHASES`."""
    return runs.measure([moved(r, p) for r in RATIOS for p in PHASES], repeats=3, half_step=True)


def by_frequency(runs: Runs) -> Measured:
    """Ratio 1: points in the order of `FREQUENCIES`, then of `PHASES`."""
    return runs.measure([moved(1.0, p, f) for f in FREQUENCIES for p in PHASES], repeats=3, half_step=True)


def beating(runs: Runs) -> Measured:
    """A ratio off 1, over eight whole turns of the phase: the rate is a line's slope, which three still tilt."""
    beat = 1 / (FREQUENCY * (BEATING - 1))
    scenario = moved(BEATING, 0.0).replace(transient=0.5, duration=0.5 + 8 * beat)
    return runs.measure([scenario], repeats=2, half_step=True)


def on_the_map(columns: Columns, name: str) -> Array:
    """(ratios, phases) of a number."""
    return columns[name].reshape(len(RATIOS), len(PHASES))


def greatest(columns: Columns, name: str, *ratios: float) -> float:
    """Greatest of a velocity over the phases at some ratios, either way."""
    return float(np.nanmax(np.abs(on_the_map(columns, name)[[RATIOS.index(ratio) for ratio in ratios]])))


def share(columns: Columns, name: str, *ratios: float) -> float:
    """The same over the greatest at any ratio."""
    return greatest(columns, name, *ratios) / greatest(columns, name, *RATIOS)


def spins(columns: Columns) -> Array:
    """(frequencies, phases) spin rates at ratio 1."""
    return columns["spin_rate"].reshape(-1, len(PHASES))


def first_harmonic(spin: Array) -> complex:
    """c of the fit Re c exp(-iψ) to spin rates over the phase ψ."""
    return complex(2 * np.mean(spin * np.exp(1j * np.radians(PHASES))))


def best_phase(spin: Array) -> float:
    """Phase of the greatest spin rate by the fit, deg from -180 to 180."""
    return math.degrees(float(np.angle(first_harmonic(spin))))


def gain(spin: Array) -> float:
    """Greatest spin rate over that in phase, less 1."""
    return float(np.abs(spin).max() / abs(spin[0])) - 1


def unlike_a_cosine(spin: Array) -> float:
    """Root-mean-square residual of the fit over the greatest spin rate."""
    fit = (first_harmonic(spin) * np.exp(-1j * np.radians(PHASES))).real
    return float(np.sqrt(np.mean((spin - fit) ** 2)) / np.abs(spin).max())


def unlike_its_mirror(spin: Array) -> float:
    """Greatest |ω(ψ) + ω(ψ + 180 deg)| over the greatest |ω|."""
    return float(np.abs(spin + np.roll(spin, len(PHASES) // 2)).max() / np.abs(spin).max())


def claims_of(found: Measured, over: Measured | None = None, beats: Measured | None = None) -> tuple[Claim, ...]:
    """What is claimed of the map, and where they were run of the frequencies and of beating."""

    def below(
        text: str, measured: Measured, function: Callable[[Columns], float], most: float, note: str = ""
    ) -> Claim:
        number = number_of(measured, function)
        return Claim(text, number.value < most, number, note=note)

    claims = [
        below("at ratios 1 and 3 it is carried nowhere: its velocity along the bar is below 5 % of that at ratio 2",
              found, lambda c: share(c, "velocity_x", 1.0, 3.0), STILL),
        below("at ratio 2 it does not turn: below 5 % of the spin rate at ratio 1",
              found, lambda c: share(c, "spin_rate", 2.0), STILL),
        below("at ratios 1/2, 3/2 and 5/2 it neither turns nor goes along the bar: both below 5 %",
              found, lambda c: max(share(c, name, 0.5, 1.5, 2.5) for name in ("spin_rate", "velocity_x")), STILL,
              "of a sliding object: one that walks has strides of its own, see the notes"),
        below("across the bar it goes at ratios 1/2, 3/2 and 5/2 alone: below 5 % at the others",
              found, lambda c: share(c, "velocity_y", 1.0, 2.0, 3.0), STILL),
        below("no phase or ratio carries it across the bar a tenth as fast as along it",
              found, lambda c: greatest(c, "velocity_y", *RATIOS) / greatest(c, "velocity_x", *RATIOS), 0.1),
        below("at ratio 3 it turns at most half as fast as at ratio 1",
              found, lambda c: share(c, "spin_rate", 3.0), 0.5),
        below("half a turn of the phase turns the spin about: the two differ by less than 3 %",
              found, lambda c: unlike_its_mirror(on_the_map(c, "spin_rate")[TURN]), 0.03),
        below("at ratio 1 the spin rate goes as the cosine of the phase: residual below 10 % of the greatest, r.m.s.",
              found, lambda c: unlike_a_cosine(on_the_map(c, "spin_rate")[TURN]), 0.1),
    ]  # fmt: skip
    if over is not None:
        claims += [_gain_claim(over, FREQUENCIES.index(18.0), True), _gain_claim(over, FREQUENCIES.index(22.0), False)]
    if beats is not None:
        most = greatest(found.means, "spin_rate", 1.0)
        claims.append(below("with a period 5 % off it does not turn in the mean: below 5 % of the greatest",
                            beats, lambda c: abs(float(c["spin_rate"][0])) / most, STILL))  # fmt: skip
    return tuple(claims)


def _gain_claim(over: Measured, which: int, much: bool) -> Claim:
    number = number_of(over, lambda c: gain(spins(c)[which]))
    f = FREQUENCIES[which]
    if much:
        return Claim(f"at {f:g} Hz the best phase turns the object at least 1.3 times as fast as the source's",
                     number.value > 0.3, number, note="greatest over that in phase, less 1")  # fmt: skip
    return Claim(f"at {f:g} Hz, near the peak, it gains less than 10 %", number.value < 0.1, number)


def answer(runs: Runs, question: Question) -> Answer:
    """Answer the question."""
    found, over, beats = measure_map(runs), by_frequency(runs), beating(runs)
    claims = claims_of(found, over, beats)
    phases = [best_phase(spin) for spin in spins(over.means)]
    rates = {name: greatest(found.means, name, *RATIOS) for name, _ in _SHOWN}
    verdict = (
        "The ratio decides what becomes of the object, the phase how much of it and which way: shaking at the "
        f"frequency of rocking or three times it turns ({math.degrees(rates['spin_rate']):.0f} deg/s), twice it "
        f"carries along the bar ({1e3 * rates['velocity_x']:.0f} mm/s), half-integers carry across it "
        f"({1e3 * rates['velocity_y']:.0f} mm/s); the best phase falls from {phases[0]:.0f} deg at "
        f"{FREQUENCIES[0]:g} Hz to {phases[-1]:.0f} deg at {FREQUENCIES[-1]:g} Hz, so that the source's phase is "
        "nearly the best at the peak and far from it below."
    )
    notes = (
        "Why the ratio decides: rocking looks the same half a period later in the mirror across the bar, shaking half "
        "a period of its own later in the mirror along it. At odd ratios both together are half a turn of the picture, "
        "which leaves a spin and no velocity; at even ones the first mirror alone remains, which leaves a velocity "
        "along the bar; at half-integers the second, which leaves one across it. No law of contact or friction comes "
        "into this.",
        "It holds for a motion that repeats with the plate. A sheet that walks has strides of two periods of rocking: "
        "at 22 Hz and ratio 1/2 it locks to the shaking at some phases, and turns and goes along the bar, one way or "
        "the other as it happened to begin.",
    )
    return Answer(question.name, question.asks, verdict, claims, (_map_table(found), _phase_table(over)),
                  (("phases", draw(found, over)),), notes)  # fmt: skip


def _map_table(found: Measured) -> Table:
    columns = found.means
    rows = [(ratio, float(phase), *(float(factor * on_the_map(columns, name)[i, j]) for name, factor in _SHOWN))
            for i, ratio in enumerate(RATIOS) for j, phase in enumerate(PHASES)]  # fmt: skip
    names = ("ratio", "phase, deg", "spin rate, deg/s", "along the bar, mm/s", "across the bar, mm/s")
    return Table("phases-map", names, tuple(rows))


def _phase_table(over: Measured) -> Table:
    rows = []
    for i, f in enumerate(FREQUENCIES):
        phase, more = (number_of(over, lambda c, g=g, i=i: g(spins(c)[i])) for g in (best_phase, gain))
        rows.append((f, phase.value, phase.ensemble_error, phase.step_error, more.value, more.ensemble_error))
    names = ("f, Hz", "best phase, deg", "± (starts)", "half step", "gain over the source's phase", "± (starts)")
    return Table("phases-best", names, tuple(rows))


_SHOWN = (("spin_rate", math.degrees(1)), ("velocity_x", 1e3), ("velocity_y", 1e3))


def draw(found: Measured, over: Measured) -> Figure:
    """The three velocities over the phase for each ratio, and the best phase over the frequency."""
    figure = new_figure(11, 6.2)
    axes: list[Axes] = list(figure.subplots(2, 2).flat)
    titles = ("spin rate, deg/s", "velocity along the bar, mm/s", "velocity across the bar, mm/s")
    styles = zip(RATIOS, (BLUE, RED, GREEN, ORANGE, GREY, "black"), "sov^Dx", strict=True)
    for i, (ratio, colour, mark) in enumerate(styles):
        for axis, (name, factor) in zip(axes, _SHOWN, strict=False):
            axis.plot(PHASES, factor * on_the_map(found.means, name)[i], mark + "-", color=colour, ms=4, lw=1.1,
                      label=f"ratio {ratio:g}")  # fmt: skip
    for axis, title in zip(axes, titles, strict=False):
        label_axes(axis, "phase of shaking, deg", title)
        axis.set_xticks(range(0, 361, 90))
    mean = spins(over.means)
    axes[3].plot(FREQUENCIES, [best_phase(spin) for spin in mean], "o-", color=RED)
    label_axes(axes[3], "plate frequency, Hz", "best phase at ratio 1, deg")
    twin = axes[3].twinx()
    twin.plot(FREQUENCIES, [100 * gain(spin) for spin in mean], "s--", color=BLUE)
    label_axes(twin, "plate frequency, Hz", "gain over the source's (dashed), %")
    legend_below(figure, columns=6)
    return figure
