"""Torsion: whether an isotropic plate behaves otherwise than free torsion does, and whether refining converges."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.model.presets import preset
from plategait.model.scenario import Scenario
from plategait.plots.style import BLUE, GREEN, GREY, ORANGE, PURPLE, RED, SKY, label_axes, legend_below, new_figure
from plategait.study.catalogue import Question
from plategait.study.claims import Answer, Claim, Number, number_of
from plategait.study.measured import Columns, Measured
from plategait.study.questions.curves import run_offs
from plategait.study.runs import Runs
from plategait.thesis.item import Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

STIFFNESSES = (0.0, 0.1, 0.3, 1.0, 2.0)
"""k_t/k_b; 0 is the source's free torsion, 1 an isotropic plate of Poisson ratio zero."""
CASES = (*((k, 0.0) for k in STIFFNESSES), (0.0, 1.0), (1.0, 1.0))
"""k_t/k_b and c_t/c_b."""
FREE, ISOTROPIC, STIFFEST, DAMPED = 0, 3, 4, 5
FREQUENCIES = {3: (16.0, 18.0, 20.0, 22.0, 23.0, 24.0, 25.0, 26.0, 27.0, 28.0), 12: (10.0, 11.0, 12.0, 13.0, 14.0)}
"""Plate frequencies, Hz, by A_p in deg."""
PITCHES = (10e-3, 5e-3, 2.5e-3)
PITCH_FREQUENCIES = (18.0, 20.0, 22.0, 24.0)
RISING = math.radians(300)
"""Spin rate at which the rising side of two curves is compared, rad/s."""


def sheet_with(torsion: float, damping: float, **changes: float) -> Scenario:
    """The cheese with k_t and c_t so many times k_b and c_b."""
    cheese = preset("cheese").scenario
    sheet = cheese.sheet
    values = {"sheet.torsion_stiffness": torsion * sheet.bending_stiffness,
              "sheet.torsion_damping": damping * sheet.bending_damping}  # fmt: skip
    return cheese.replace(**(values | {name.replace("__", "."): value for name, value in changes.items()}))


def curves(runs: Runs, angle: int, repeats: int = 3, duration: float = 2.0) -> Measured:
    """Spin curves of all cases at one A_p in deg: points in the order of `CASES`, then of `FREQUENCIES`."""
    scenarios = [
        sheet_with(k, c, motion__frequency=f, motion__angle=math.radians(angle), duration=duration)
        for k, c in CASES
        for f in FREQUENCIES[angle]
    ]
    return runs.measure(scenarios, repeats=repeats, half_step=True)


def rates(columns: Columns, angle: int) -> Array:
    """(cases, frequencies) spin rates, rad/s."""
    return columns["spin_rate"].reshape(len(CASES), len(FREQUENCIES[angle]))


def peak_change(columns: Columns, angle: int, case: int) -> float:
    """Greatest spin rate of a case over that of free torsion, less 1."""
    spin = np.nanmax(rates(columns, angle), axis=1)
    return float(spin[case] / spin[FREE] - 1)


def common_change(columns: Columns, angle: int, case: int) -> float:
    """Root-mean-square difference to free torsion over the frequencies at which both spin, over the peak."""
    spin = rates(columns, angle)
    return float(np.sqrt(np.nanmean((spin[case] - spin[FREE]) ** 2)) / np.nanmax(spin[FREE]))


def rising_frequency(columns: Columns, case: int) -> float:
    """Plate frequency at which the rate rises through `RISING` at 3 deg, Hz."""
    spin = rates(columns, 3)[case]
    i = int(np.argmax(spin > RISING))
    low, high = FREQUENCIES[3][i - 1], FREQUENCIES[3][i]
    return low + (high - low) * float((RISING - spin[i - 1]) / (spin[i] - spin[i - 1]))


def run_off(columns: Columns, angle: int, case: int) -> float:
    """Frequency from which on runs of a case fail, Hz: see `run_offs`."""
    return float(run_offs(columns, FREQUENCIES[angle])[case])


def pitches(runs: Runs) -> Measured:
    """Points in the order of `PITCHES`, at each free torsion and then the isotropic plate at `PITCH_FREQUENCIES`."""
    scenarios = [
        sheet_with(k, 0.0, sheet__pitch=pitch, motion__frequency=f, duration=0.9, transient=0.4)
        for pitch in PITCHES
        for k in (0.0, 1.0)
        for f in PITCH_FREQUENCIES
    ]
    return runs.measure(scenarios, repeats=3, half_step=True)


def rates_by_pitch(columns: Columns) -> Array:
    """(pitches, 2, frequencies) spin rates of free torsion and of the isotropic plate, rad/s."""
    return columns["spin_rate"].reshape(len(PITCHES), 2, len(PITCH_FREQUENCIES))


def pitch_change(columns: Columns, finer: int, isotropic: bool) -> float:
    """Root-mean-square difference of the spin rates at `PITCHES[finer]` and the pitch before, over their mean."""
    coarse, fine = rates_by_pitch(columns)[finer - 1 : finer + 1, int(isotropic)]
    return float(np.sqrt(np.nanmean((coarse - fine) ** 2)) / np.nanmean(fine))


def order_claim(found: Measured, isotropic: bool) -> Claim:
    """Whether the spin rates converge at first order: each halving of the pitch changes them half as much."""
    changes = [pitch_change(found.means, i, isotropic) for i in (1, 2)]
    ratio = number_of(found, lambda c: pitch_change(c, 2, isotropic) / pitch_change(c, 1, isotropic))
    name = "k_t = k_b" if isotropic else "free torsion"
    return Claim(
        f"with {name}, halving the pitch from 5 to 2.5 mm changes the spin rates at most 0.6 times as much as from 10 "
        "to 5 mm",
        ratio.value <= 0.6, ratio,
        note=f"{100 * changes[0]:.2g} % and {100 * changes[1]:.2g} %, r.m.s. from 18 to 24 Hz",
    )  # fmt: skip


def answer(runs: Runs, question: Question) -> Answer:
    """Answer the question."""
    flat, wide = curves(runs, 3), curves(runs, 12)
    found = pitches(runs)
    claims = claims_of(flat, wide, found)
    dish = _dish_rise()
    change, stiffest = claims[0].number, claims[1].number
    verdict = (
        f"Torsion hardly matters: the isotropic plate's greatest spin rate is {100 * change.value:+.0f} % of free "
        f"torsion's at 3 deg and twice that torsion makes {100 * stiffest.value:+.0f} %, although k_t = k_b raises "
        f"the dish mode by {100 * dish:.0f} %; the rising side stays, and so does a stiffness that is read off it. "
        f"Refining the pitch {_converges(claims[-2:])}, with torsion or without."
    )
    notes = (
        "k_t is the torsion joint's stiffness, k_t = k_b an isotropic plate of Poisson ratio zero. In strides the "
        "sheet bends about lines across the bar, which twists nothing; twist comes in only where one edge is lifted "
        "aslant.",
        "The pitch is compared over 0.5 s after 0.4 s.",
    )
    return Answer(question.name, question.asks, verdict, claims, (_curves_table(flat, wide), _pitch_table(found)),
                  (("torsion", draw(flat, wide, found)),), notes)  # fmt: skip


def _converges(orders: tuple[Claim, ...]) -> str:
    if all(claim.holds for claim in orders):
        return "converges"
    finest = max(pitch.number.value for pitch in orders)
    return "converges slowly" if finest < 1 else "does not converge down to 2.5 mm"


def _dish_rise() -> float:
    return sheet_with(1.0, 0.0).sheet.natural_frequency / sheet_with(0.0, 0.0).sheet.natural_frequency - 1


def claims_of(flat: Measured, wide: Measured, found: Measured | None = None) -> tuple[Claim, ...]:
    """What is claimed of curves at 3 deg, at 12 deg, and of the pitches where they were run."""

    def claim(text: str, number: Number, most: float, unit: str = "1", note: str = "") -> Claim:
        return Claim(text, abs(number.value) <= most, number, unit, note)

    shift = number_of(flat, lambda c: rising_frequency(c, ISOTROPIC) - rising_frequency(c, FREE))
    off = number_of(flat, lambda c: run_off(c, 3, ISOTROPIC) - run_off(c, 3, FREE))
    claims = [
        claim("k_t = k_b changes the greatest spin rate at 3 deg by less than 8 %",
              number_of(flat, lambda c: peak_change(c, 3, ISOTROPIC)), 0.08),
        claim("k_t = 2 k_b changes the greatest spin rate at 3 deg by less than 10 %",
              number_of(flat, lambda c: peak_change(c, 3, STIFFEST)), 0.10),
        claim("k_t = k_b changes the spin rates at 3 deg by less than 5 % of the peak, r.m.s.",
              number_of(flat, lambda c: common_change(c, 3, ISOTROPIC)), 0.05),
        claim("k_t = k_b changes the spin rates at 12 deg by less than 5 % of the peak, r.m.s.",
              number_of(wide, lambda c: common_change(c, 12, ISOTROPIC)), 0.05),
        claim("the rising side at 3 deg stays within 0.3 Hz although k_t = k_b raises the dish mode by 12 %",
              shift, 0.3, "Hz", "frequency of 300 deg/s"),
        claim("run-off at 3 deg stays within 1 Hz", off, 1.0, "Hz", "width over which starts fail"),
        claim("damping torsion as bending changes the greatest spin rate at 3 deg by less than 5 %",
              number_of(flat, lambda c: peak_change(c, 3, DAMPED)), 0.05),
    ]  # fmt: skip
    if found is not None:
        claims += [order_claim(found, isotropic) for isotropic in (False, True)]
    return tuple(claims)


def _curves_table(flat: Measured, wide: Measured) -> Table:
    rows = []
    for angle, measured in ((3, flat), (12, wide)):
        columns, gaits = measured.means, ("sliding", "walking", "running")
        for i, (case, f) in enumerate((case, f) for case in CASES for f in FREQUENCIES[angle]):
            gait = columns["gait"][i]
            rows.append((*case, angle, f, math.degrees(columns["spin_rate"][i]), float(1e3 * columns["rim_lift"][i]),
                         gaits[round(gait)] if math.isfinite(gait) else "", float(columns["failed"][i])))  # fmt: skip
    names = ("k_t/k_b", "c_t/c_b", "A_p, deg", "f, Hz", "spin rate, deg/s", "lift of the rim, mm", "gait", "failed")
    return Table("torsion-curves", names, tuple(rows))


def _pitch_table(found: Measured) -> Table:
    rows = []
    means = rates_by_pitch(found.means)
    halved = np.full_like(means, math.nan) if found.half_means is None else rates_by_pitch(found.half_means)
    for i, pitch in enumerate(PITCHES):
        for torsion in (0, 1):
            for j, f in enumerate(PITCH_FREQUENCIES):
                at = i, torsion, j
                rows.append((1e3 * pitch, float(torsion), f, math.degrees(means[at]), math.degrees(halved[at])))
    columns = ("pitch, mm", "k_t/k_b", "f, Hz", "spin rate, deg/s", "at half the step, deg/s")
    return Table("torsion-pitch", columns, tuple(rows))


def draw(flat: Measured, wide: Measured, found: Measured) -> Figure:
    """Spin curves by torsion at both A_p, and by pitch."""
    figure = new_figure(11, 4.0)
    axes: list[Axes] = list(figure.subplots(1, 3))
    for axis, angle, measured in zip(axes, (3, 12), (flat, wide), strict=False):
        spin = np.degrees(rates(measured.means, angle))
        for case, colour in zip((0, 2, 3, 4, 5), (BLUE, GREEN, ORANGE, RED, GREY), strict=True):
            k, c = CASES[case]
            label = (f"k_t = {k:g} k_b" if k else "free torsion") + (", c_t = c_b" if c else "")
            axis.plot(FREQUENCIES[angle], spin[case], "o-", color=colour, ms=4, lw=1.2, label=label)
        label_axes(axis, "plate frequency, Hz", "spin rate, deg/s")
        axis.set_title(f"A_p = {angle} deg", fontsize=10)
    for pitch, spin, colour in zip(
        PITCHES, np.degrees(rates_by_pitch(found.means)), (SKY, PURPLE, "black"), strict=True
    ):
        for values, line, name in zip(spin, ("-", "--"), ("free", "k_t = k_b"), strict=True):
            label = f"{1e3 * pitch:g} mm, {name}"
            axes[2].plot(PITCH_FREQUENCIES, values, "o" + line, color=colour, ms=4, lw=1.2, label=label)
    label_axes(axes[2], "plate frequency, Hz", "spin rate, deg/s")
    axes[2].set_title("by pitch, A_p = 3 deg", fontsize=10)
    legend_below(figure, columns=6)
    return figure
