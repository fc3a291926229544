"""Sizes and shapes: what makes spin curves of different objects one, what breaks it, and an estimator for any size."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.model.presets import preset
from plategait.model.similarity import KEPT, Kept, elongation, equivalent_radius, frequency_at, similar
from plategait.plots.style import (
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    RED,
    label_axes,
    legend_beside,
    new_figure,
    plain_logarithms,
)
from plategait.study.catalogue import Question
from plategait.study.claims import Answer, Claim, Number, number_of
from plategait.study.measured import Columns, Measured
from plategait.study.questions.outlines import SHAPES, cut_to
from plategait.study.questions.strangers import Strangers, met, over_objects, posterior_errors
from plategait.study.runs import Runs
from plategait.thesis.item import Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

FACTORS = (0.25, 0.5, 1.0, 2.5, 5.0)
"""Sizes over the cheese's radius of 40 mm: 10 to 200 mm."""
FREQUENCIES = (16.0, 18.0, 20.0, 22.0, 24.0, 26.0)
"""Of the plate for the cheese, Hz; others' go with the root of the size."""
CASES: tuple[tuple[Kept, ...], ...] = ((), *((kept,) for kept in KEPT))
"""What stays as it is while the object's size changes."""
ACCELERATIONS = (2.2, 2.8, 3.4, 4.0, 4.6, 5.2, 5.8, 6.5, 7.5, 9.0)
"""Γ at which shapes are run."""
LYING = (0.0, 60.0, 120.0)
"""How shapes lie at first, deg: their rates are averaged."""
ROUND = ("square", "ellipse 5:4")
CHEESE = preset("cheese").scenario.replace(duration=1.4, transient=0.5)


def sizes(runs: Runs, repeats: int = 2) -> Measured:
    """Spin curves in the order of `CASES`, `FACTORS`, `FREQUENCIES`."""
    at = [CHEESE.replace(**{"motion.frequency": f}) for f in FREQUENCIES]
    scenarios = [similar(s, factor, keep=keep) for keep in CASES for factor in FACTORS for s in at]
    return runs.measure(scenarios, repeats=repeats, half_step=True)


def reduced(columns: Columns) -> Array:
    """(cases, factors, frequencies) spin rates in the cheese's time, rad/s: what similar objects have alike."""
    spin = columns["spin_rate"].reshape(len(CASES), len(FACTORS), len(FREQUENCIES))
    times = np.array([[1.0 if "gravity" in keep else math.sqrt(factor) for factor in FACTORS] for keep in CASES])
    return spin * times[:, :, None]


def departure(columns: Columns, kept: Kept | None, per_stroke: bool = False) -> float:
    """R.m.s. difference of all sizes to the cheese, over its peak; with the rates over B_p/r where asked for."""
    case = CASES.index(() if kept is None else (kept,))
    spin = reduced(columns)
    curves = spin[case]
    if per_stroke:
        curves = curves * np.array(FACTORS)[:, None]
    reference = spin[0, FACTORS.index(1.0)]
    return float(np.sqrt(np.nanmean((curves - reference) ** 2)) / np.nanmax(reference))


def shapes(runs: Runs) -> Measured:
    """Spin curves in the order of `SHAPES`, `ACCELERATIONS`, each from `LYING`."""
    scenarios = []
    for name in SHAPES:
        cut = cut_to(CHEESE, name)
        scenarios += [
            cut.replace(**{"motion.frequency": frequency_at(cut, gamma), "start.angle": math.radians(lies)})
            for gamma in ACCELERATIONS
            for lies in LYING
        ]
    return runs.measure(scenarios, half_step=True).pooled(len(LYING))


def radii_of(shape: str) -> dict[str, float]:
    """What may be called the radius of a shape, m: of a disk they are one."""
    sheet = cut_to(CHEESE, shape).sheet
    gyration, longer = equivalent_radius(sheet.lattice, sheet.pitch), elongation(sheet.lattice)
    # Of the ellipse with the same moments: gyration² is the mean square of its half axes.
    width = gyration * math.sqrt(2 / (1 + longer**2))
    return {"gyration": gyration, "area": math.sqrt(sheet.area / math.pi), "half width": width}


def shape_departure(columns: Columns, radius: str, which: tuple[str, ...] | None = None) -> float:
    """R.m.s. difference of shapes to the disk at equal Γ, made with one radius, over the disk's peak.

    Rates over √(g/r); those beyond the disk's range are left out.
    """
    curves = columns["spin_rate"].reshape(len(SHAPES), len(ACCELERATIONS))
    disk = radii_of("disk")[radius]
    there = np.isfinite(curves[0])
    off = []
    for name, spin in list(zip(SHAPES, curves, strict=True))[1:]:
        if which is not None and name not in which:
            continue
        radii = radii_of(name)
        gamma = np.array(ACCELERATIONS) * radii[radius] / radii["gyration"]
        rates = spin * math.sqrt(radii[radius] / disk)
        first, last = (np.array(ACCELERATIONS)[there][i] for i in (0, -1))
        use = np.isfinite(rates) & (gamma >= first) & (gamma <= last)
        off += list(rates[use] - np.interp(gamma[use], np.array(ACCELERATIONS)[there], curves[0][there]))
    return float(np.sqrt(np.mean(np.square(off))) / np.nanmax(curves[0]))


def size_claims(found: Measured) -> list[Claim]:
    """What is claimed of sizes."""

    def number(kept: Kept | None, per_stroke: bool = False) -> Number:
        return number_of(found, lambda c: departure(c, kept, per_stroke))

    alike, contact, friction, height, stroke, gravity = (number(kept) for kept in (None, *KEPT))
    per_stroke = number("stroke", True)
    ending = "changes the spin curves of 10 to 200 mm by less than 5 % of the peak, r.m.s."
    note = "r.m.s. over sizes and frequencies, over the cheese's peak"
    return [
        Claim("with all dimensionless groups alike, objects of 10 to 200 mm give one spin curve within 1 % of its peak",
              alike.value < 0.01, alike, note=note),
        Claim(f"a contact that stays as it is {ending}", contact.value < 0.05, contact),
        Claim(f"V that stays as it is {ending}", friction.value < 0.05, friction),
        Claim(f"a height of the plate that stays as it is {ending}", height.value < 0.05, height),
        Claim("B_p that stays as it is breaks similarity by more than 25 % of the peak, r.m.s.", stroke.value > 0.25,
              stroke),
        Claim("it does so in proportion: rates over B_p/r collapse within 15 % of the peak, r.m.s.",
              per_stroke.value < 0.15, per_stroke),
        Claim("gravity breaks it by more than 25 % of the peak, r.m.s., where no time is scaled", gravity.value > 0.25,
              gravity),
    ]  # fmt: skip


def shape_claims(found: Measured) -> list[Claim]:
    """What is claimed of shapes."""
    round_ones = number_of(found, lambda c: shape_departure(c, "gyration", ROUND))
    gyration, area, width = (
        number_of(found, lambda c, radius=radius: shape_departure(c, radius))
        for radius in ("gyration", "area", "half width")
    )
    return [
        Claim("a square and an ellipse 5:4 spin as the disk with their radius of gyration, within 5 % of its peak",
              round_ones.value < 0.05, round_ones),
        Claim("so do oblong ones, a leaf and a fish, within 10 %", gyration.value < 0.10, gyration,
              note=f"with the radius of a disk of equal area {100 * area.value:.0f} %"),
        Claim("with half their width for a radius all shapes are within 15 % of the disk's peak", width.value < 0.15,
              width, note="half the width of the ellipse with the same moments of area"),
    ]  # fmt: skip


def estimator_claims(found: Strangers) -> list[Claim]:
    """What is claimed of the estimator for any size."""
    omega, alpha, held = (found.number(name) for name in ("omega", "alpha", "held"))
    over = "interval over the objects that might have been drawn"
    return [
        Claim("on objects of any size that it has not seen, the any-size method's median error of ω_n is below 40 %",
              omega.value < 0.40, omega, note=f"{found.count} objects, rates to 2 %; r.m.s. of the logarithm "
              f"{found.number('omega_rms').value:.2f}; {over}", interval=found.interval("omega")),
        Claim("and of α below 4 deg", alpha.value < 4.0, alpha, "deg",
              note=f"r.m.s. {found.number('alpha_rms').value:.1f} deg; {over}", interval=found.interval("alpha")),
        Claim("its 90 % intervals hold at least 80 % of the truths", held.value >= 0.8, held, note=over,
              interval=found.interval("held")),
    ]  # fmt: skip


def posterior_claim(errors: dict[str, list[float]]) -> Claim:
    """Whether the engine in the loop does better on the same curves."""
    names = ("posterior_alpha", "any_alpha", "posterior_omega", "any_omega")
    rows = np.array([errors[name] for name in names]).T
    theirs, ours, *omega = np.median(rows, axis=0)

    def ratio(rows: Array) -> float:
        return float(np.median(rows[:, 0]) / np.median(rows[:, 1]))

    return Claim(
        "the posterior's α is nearer than the any-size method's on the same curves", bool(theirs < ours),
        Number(ratio(rows)),
        note=f"{len(rows)} objects: median errors of α {theirs:.1f} and {ours:.1f} deg, of ω_n {100 * omega[0]:.0f} "
             f"and {100 * omega[1]:.0f} %; interval over the objects that might have been drawn",
        interval=over_objects(rows, ratio),
    )  # fmt: skip


def answer(runs: Runs, question: Question) -> Answer:
    """Answer the question."""
    found, cut = sizes(runs), shapes(runs)
    strangers = met(runs)
    errors = posterior_errors(runs)
    claims = (*size_claims(found), *shape_claims(cut), *estimator_claims(strangers), posterior_claim(errors))
    values = [claim.number.value for claim in claims]
    verdict = (
        f"Size needs no parameter of its own: with Γ, B_p/r, ω_n √(r/g), A_p, α and β alike, objects of 10 to 200 mm "
        f"spin alike to {100 * values[0]:.2g} % of the peak, and of what stays with the plate only B_p matters. Shape "
        f"does: as long as wide is a disk of the same radius of gyration ({100 * values[7]:.1f} %), an oblong one is "
        f"not ({100 * values[8]:.0f} %), and half its width tells more ({100 * values[9]:.0f} %). Regressed on these "
        f"groups, a curve gives α to {values[11]:.1f} deg and ω_n to {100 * values[10]:.0f} % for any size (medians)."
    )
    tables = (_size_table(found), _shape_table(cut), strangers.table(), _posterior_table(errors))
    return Answer(question.name, question.asks, verdict, claims, tables, (("sizes", draw(found, cut, strangers)),))


def _size_table(found: Measured) -> Table:
    rows = []
    spin, failed = np.degrees(reduced(found.means)), found.means["failed"].reshape(len(CASES), len(FACTORS), -1)
    for i, keep in enumerate(CASES):
        for j, factor in enumerate(FACTORS):
            rows += [(" ".join(keep) or "nothing", 40 * factor, f, float(spin[i, j, k]), float(failed[i, j, k]))
                     for k, f in enumerate(FREQUENCIES)]  # fmt: skip
    columns = ("stays as it is", "radius, mm", "frequency in the cheese's time, Hz", "spin rate in its time, deg/s",
               "failed")  # fmt: skip
    return Table("sizes-similarity", columns, tuple(rows))


def _shape_table(cut: Measured) -> Table:
    rows, columns = [], cut.means
    for i, name in enumerate(SHAPES):
        radii = radii_of(name)
        for j, gamma in enumerate(ACCELERATIONS):
            k = i * len(ACCELERATIONS) + j
            rows.append((name, *(1e3 * radius for radius in radii.values()), gamma,
                         math.degrees(columns["spin_rate"][k]), float(columns["failed"][k])))  # fmt: skip
    names = ("shape", "radius by gyration, mm", "by area, mm", "half width, mm", "Γ by gyration", "spin rate, deg/s",
             "failed")  # fmt: skip
    return Table("sizes-shapes", names, tuple(rows))


def _posterior_table(errors: dict[str, list[float]]) -> Table:
    rows = zip(*(errors[name] for name in ("radius", "any_omega", "posterior_omega", "any_alpha", "posterior_alpha")),
               strict=True)  # fmt: skip
    columns = ("radius, mm", "error of ω_n, any-size", "posterior", "error of α, any-size, deg", "posterior, deg")
    return Table("sizes-posterior", columns, tuple(tuple(row) for row in rows))


def draw(found: Measured, cut: Measured, strangers: Strangers) -> Figure:
    """Curves of all sizes; what breaks similarity; shapes by their half width; the estimator on strangers."""
    figure = new_figure(11, 6.4)
    axes: list[list[Axes]] = figure.subplots(2, 2).tolist()
    spin = np.degrees(reduced(found.means))
    colours = (RED, ORANGE, BLUE, GREEN, GREY)
    for factor, rates, colour in zip(FACTORS, spin[0], colours, strict=True):
        axes[0][0].plot(FREQUENCIES, rates, "o-", color=colour, ms=4, lw=1, label=f"{40 * factor:g} mm")
    for i, line in ((CASES.index(("stroke",)), "--"), (CASES.index(("contact",)), ":")):
        for rates, colour in zip(spin[i], colours, strict=True):
            axes[0][0].plot(FREQUENCIES, rates, line, color=colour, lw=1)
    axes[0][0].set_ylim(0, 700)
    axes[0][0].set_title("sizes; dashed: B_p stays, dotted: the contact stays", fontsize=10)
    label_axes(axes[0][0], "plate frequency · √(r / 40 mm), Hz", "spin rate · √(r / 40 mm), deg/s")
    legend_beside(axes[0][0])
    _draw_bars(axes[0][1], found)
    _draw_shapes(axes[1][0], cut)
    strangers.draw(axes[1][1])
    return figure


def _draw_shapes(axis: Axes, cut: Measured) -> None:
    curves = np.degrees(cut.means["spin_rate"]).reshape(len(SHAPES), -1)
    disk = radii_of("disk")["half width"]
    for n, (name, rates) in enumerate(zip(SHAPES, curves, strict=True)):
        radii = radii_of(name)
        gamma, scale = np.array(ACCELERATIONS) * radii["half width"] / radii["gyration"], radii["half width"] / disk
        style = {"color": "black", "lw": 2} if name == "disk" else {"color": f"C{n}", "lw": 1, "marker": "o", "ms": 3}
        axis.plot(gamma, rates * math.sqrt(scale), label=name, **style)
    axis.set_title("shapes, with half their width for r", fontsize=10)
    label_axes(axis, "Γ = r A_p ω_p²/g", "spin rate · √(r / 40 mm), deg/s")
    legend_beside(axis)


def _draw_bars(axis: Axes, found: Measured) -> None:
    values = [100 * departure(found.means, kept) for kept in (None, *KEPT)]
    axis.barh(["nothing", "contact", "V", "height", "B_p", "gravity"], values, color=BLUE)
    axis.set_xscale("log")
    plain_logarithms(axis.xaxis)
    axis.invert_yaxis()
    axis.set_title("what stays as it is while the size changes", fontsize=10)
    label_axes(axis, "departure from the cheese's curve, % of its peak", "")
