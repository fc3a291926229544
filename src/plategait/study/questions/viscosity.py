"""Viscosity: the mark of c_b over four decades, and whether it can be read off a spin experiment."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.estimate.result import estimate_parameters
from plategait.model.inferred import DEPARTURES
from plategait.model.scenario import Scenario
from plategait.plots.style import BLUE, GREEN, GREY, ORANGE, RED, label_axes, new_figure
from plategait.study.catalogue import Question
from plategait.study.claims import Answer, Claim, Number, number_of
from plategait.study.measured import Columns, Measured
from plategait.study.questions.curves import CHEESE, FREQUENCIES, as_run, at_frequencies, curves_of, fits_of, run_offs
from plategait.study.questions.information import measure_variants, slopes_of
from plategait.study.runs import Runs
from plategait.thesis.item import Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_PRESETS = next(d.number for d in DEPARTURES if d.name == "sheet.bending_damping")
FACTORS = (0.03, 0.1, 0.3, 1.0, 3.0, _PRESETS, 10.0, 30.0, 100.0, 300.0)
"""c_b over that of Table 4.1; the presets take six times that."""
PARAMETERS = ("stiffness", "damping", "friction", "ratio")
"""Unknown at once, the mass weighed."""
READ_AT = FREQUENCIES[1:10]
"""Of the bound, Hz: what stays on the plate."""
BENDING_AT = 16.0
TRUTHS = (0.3, 3.0)
"""c_b over the presets' of objects whose c_b the posterior is asked for."""
SEED = 7


def with_damping(factor: float) -> Scenario:
    """The cheese with so many times the printed c_b."""
    return CHEESE.replace(**{"sheet.bending_damping": factor / _PRESETS * CHEESE.sheet.bending_damping})


def decades(runs: Runs, factors: Sequence[float] = FACTORS, repeats: int = 2) -> Measured:
    """Spin curves over c_b."""
    return runs.measure(at_frequencies([with_damping(k) for k in factors]), repeats=repeats, half_step=True)


def peaks(columns: Columns) -> Array:
    """(factors,) greatest spin rate, deg/s."""
    return np.degrees(np.nanmax(columns["spin_rate"].reshape(-1, len(FREQUENCIES)), axis=1))


def widths(columns: Columns) -> Array:
    """(factors,) b/f0."""
    return np.array([math.nan if fit is None else fit.half_width_hz / fit.f0_hz for fit in fits_of(columns)])


def bending(columns: Columns) -> Array:
    """(factors,) largest rms angle of the bending joints at 16 Hz, deg."""
    seen = columns["bending_amplitude"].reshape(-1, len(FREQUENCIES))
    return np.degrees(seen[:, FREQUENCIES.index(BENDING_AT)])


def power(columns: Columns) -> float:
    """Power of c_b with which the bending at 16 Hz goes, from three times the printed c_b on."""
    use = [i for i, k in enumerate(FACTORS) if k >= 3]
    return float(np.polyfit(np.log([FACTORS[i] for i in use]), np.log(bending(columns)[use]), 1)[0])


def bound(columns: Columns, readings: Sequence[str]) -> float:
    """Least standard deviation of ln c_b with stiffness, friction and β unknown too."""
    slopes = slopes_of(columns, len(READ_AT), readings, PARAMETERS)
    return float(slopes.bounds()[PARAMETERS.index("damping")])


def claims_of(found: Measured, information: Measured) -> list[Claim]:
    """What is claimed of c_b's mark, and of what rates and bending hold of it."""
    peak = number_of(found, lambda c: float(peaks(c).max() / peaks(c).min()))
    width = number_of(found, lambda c: float(np.nanmax(widths(c)) / np.nanmin(widths(c))))
    trend = number_of(found, lambda c: float(np.corrcoef(np.log(FACTORS), widths(c))[0, 1]))
    off = number_of(found, lambda c: float(np.ptp(run_offs(c))))
    fall = number_of(found, lambda c: float(bending(c)[0] / bending(c)[-2]))
    rates = number_of(information, lambda c: bound(c, ("spin_rate",)))
    both = number_of(information, lambda c: bound(c, ("spin_rate", "bending_amplitude")))
    alone = Number(1 / abs(number_of(found, power).value) * 0.05)
    return [
        Claim("four decades of c_b raise the greatest spin rate by less than half", peak.value < 1.5, peak,
              note="the greatest over the least"),
        Claim("b/f0 stays within 40 %", width.value < 1.4, width, note="the widest over the narrowest"),
        Claim("b/f0 widens steadily with c_b, as a resonance does", trend.value > 0.7, trend,
              note="correlation of b/f0 with ln c_b"),
        Claim("the run-off stays within 3 Hz", off.value < 3, off, "Hz"),
        Claim("the bending amplitude at 16 Hz falls by more than three times from 0.03 to 100 times the printed c_b",
              fall.value > 3, fall),
        Claim("rates to 2 % tell c_b within a factor of 1.5 where stiffness, μ_s and β are unknown too",
              rates.value < math.log(1.5), rates, note="Cramér–Rao bound on ln c_b, nine frequencies from 15 to 25 Hz"),
        Claim("with the bending amplitude to 5 % beside them within 20 %", both.value < 0.2, both,
              note=f"one reading of it, all else known: {100 * alone.value:.0f} %"),
    ]  # fmt: skip


def measured_curve(columns: Columns, read_bending: bool, seed: int) -> Curve:
    """Curve with 2 % of noise on the rates, and where asked for the bending amplitude with 5 %."""
    curve = curves_of(columns)[0]
    rng = np.random.default_rng([SEED, seed])
    rates = curve.spin_rate_deg_s * (1 + 0.02 * rng.normal(size=len(FREQUENCIES)))
    curve = replace(curve, spin_rate_deg_s=rates, spin_rate_sd_deg_s=0.02 * np.abs(rates))
    if not read_bending:
        return curve
    angles = columns["bending_amplitude"] * (1 + 0.05 * rng.normal(size=len(FREQUENCIES)))
    return replace(curve, values={"bending_amplitude": angles}, value_sds={"bending_amplitude": 0.05 * np.abs(angles)})


def posterior_of(curve: Curve) -> dict[str, Any]:
    """c_b over the presets' by the engine in the loop, all else unknown, the model taken as right."""
    found = estimate_parameters(curve, as_run(CHEESE), fixed=("plate_height",), model_error=0.0, seed=SEED)
    told = found["bending_damping"]
    return {"verdict": told.verdict, "low": told.low, "median": told.median, "high": told.high, "sd": told.sd}


def posteriors(runs: Runs, truths: Sequence[float] = TRUTHS) -> list[dict[str, Any]]:
    """What the posterior tells of each truth, from rates alone and with the bending."""
    found = runs.measure(at_frequencies([with_damping(truth * _PRESETS) for truth in truths]))
    told = []
    for i, truth in enumerate(truths):
        columns = found.part(slice(i * len(FREQUENCIES), (i + 1) * len(FREQUENCIES))).means
        for read in (False, True):
            curve = measured_curve(columns, read, i)
            what = {"posterior of viscosity": truth, "bending": read, "rates": curve.spin_rate_deg_s.tolist()}
            told.append({"truth": truth, "bending": read}
                        | runs.once(what, lambda curve=curve: posterior_of(curve), 300.0))  # fmt: skip
    return told


def posterior_claims(told: Sequence[dict[str, Any]]) -> list[Claim]:
    """What is claimed of the posterior's c_b."""
    spread = {read: float(np.mean([math.log(t["high"] / t["low"]) / (2 * 1.645) for t in told if t["bending"] == read]))
              for read in (False, True)}  # fmt: skip
    held = [t["low"] <= t["truth"] <= t["high"] for t in told if t["bending"]]
    medians = ", ".join(f"{t['median']:.2g} of {t['truth']:g}" for t in told if t["bending"])
    return [
        Claim("the posterior's c_b from rates and bending holds the truth in its 90 % interval", all(held),
              Number(float(np.mean(held))), note=f"medians over the presets' c_b: {medians}"),
        Claim("and is narrower than from rates alone by half", spread[True] < 0.5 * spread[False],
              Number(spread[True] / spread[False]),
              note=f"standard deviations of ln c_b: {spread[False]:.2f} and {spread[True]:.2f}"),
    ]  # fmt: skip


def answer(runs: Runs, question: Question) -> Answer:
    """Answer the question."""
    found = decades(runs)
    motions = [{"motion.frequency": f} for f in READ_AT]
    information = measure_variants(runs, CHEESE, motions, PARAMETERS)
    told = posteriors(runs)
    claims = (*claims_of(found, information), *posterior_claims(told))
    v = [claim.number.value for claim in claims]
    verdict = (
        f"Four decades of c_b raise the peak by {100 * (v[0] - 1):.0f} % and move b/f0 within {100 * (v[1] - 1):.0f} % "
        f"and the run-off within {v[3]:.1f} Hz, so the resonance-like peak is none that viscosity damps; what it marks "
        f"is how far the sheet bends. c_b can be read off a spin experiment: rates alone give it to "
        f"{100 * v[5]:.0f} %, with the bending amplitude to {100 * v[6]:.0f} %."
    )
    return Answer(question.name, question.asks, verdict, claims, (_table(found), _posterior_table(told)),
                  (("viscosity", draw(found, told)),))  # fmt: skip


def _table(found: Measured) -> Table:
    c = found.means
    spin = np.degrees(c["spin_rate"]).reshape(-1, len(FREQUENCIES))
    rows = [(k, float(spin[i, FREQUENCIES.index(16.0)]), float(peaks(c)[i]), float(widths(c)[i]), float(run_offs(c)[i]),
             float(bending(c)[i])) for i, k in enumerate(FACTORS)]  # fmt: skip
    columns = ("c_b over Table 4.1's", "at 16 Hz, deg/s", "peak, deg/s", "b/f0", "run-off, Hz", "bending at 16 Hz, deg")
    return Table("viscosity-marks", columns, tuple(rows))


def _posterior_table(told: Sequence[dict[str, Any]]) -> Table:
    rows = [(t["truth"], "rates and bending" if t["bending"] else "rates", t["verdict"], t["low"], t["median"],
             t["high"]) for t in told]  # fmt: skip
    return Table("viscosity-posterior", ("c_b over the presets'", "from", "verdict", "5 %", "median", "95 %"),
                 tuple(rows))  # fmt: skip


def draw(found: Measured, told: Sequence[dict[str, Any]]) -> Figure:
    """Curves over c_b; marks over c_b, each over its value at the presets' c_b; what the posterior tells."""
    figure = new_figure(11, 3.6)
    axes: list[Axes] = list(figure.subplots(1, 3))
    spin, shown = np.degrees(found.means["spin_rate"]).reshape(-1, len(FREQUENCIES)), (0, 3, 5, 7, 9)
    for i, colour in zip(shown, (GREY, BLUE, GREEN, ORANGE, RED), strict=True):
        axes[0].plot(FREQUENCIES, spin[i], "o-", ms=3, lw=1.2, color=colour, label=f"{FACTORS[i]:g} c_b")
    label_axes(axes[0], "plate frequency, Hz", "spin rate, deg/s")
    axes[0].set_title("c_b over that of Table 4.1", fontsize=10)
    axes[0].legend(frameon=False, fontsize=8)
    c, here = found.means, FACTORS.index(_PRESETS)
    for values, colour, label in (
        (peaks(c), BLUE, "greatest spin rate"),
        (widths(c), GREEN, "b/f0"),
        (run_offs(c), GREY, "run-off"),
        (bending(c), RED, "bending amplitude at 16 Hz"),
    ):
        axes[1].plot(FACTORS, values / values[here], "o-", ms=4, lw=1.2, color=colour, label=label)
    axes[1].set_xscale("log")
    axes[1].set_yscale("log")
    label_axes(axes[1], "c_b over that of Table 4.1", "over the presets'")
    axes[1].set_title("its marks", fontsize=10)
    axes[1].legend(frameon=False, fontsize=8)
    for t in told:
        x = t["truth"] * (1.08 if t["bending"] else 0.92)
        error = [[t["median"] - t["low"]], [t["high"] - t["median"]]]
        axes[2].errorbar([x], [t["median"]], error, fmt="o", color=RED if t["bending"] else GREY, ms=5,
                         label=("rates and bending" if t["bending"] else "rates alone") if t is told[0] or t is told[1]
                         else None)  # fmt: skip
    axes[2].plot([0.1, 10], [0.1, 10], color=GREY, lw=1)
    axes[2].set_xscale("log")
    axes[2].set_yscale("log")
    label_axes(axes[2], "true c_b over the presets'", "told, 90 %")
    axes[2].set_title("the posterior, all else unknown", fontsize=10)
    axes[2].legend(frameon=False, fontsize=8)
    return figure
