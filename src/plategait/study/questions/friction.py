"""Friction: what β and V do to spin curves, what tells α better than (5.7), and what α that wanders costs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from plategait import published
from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.estimate.result import estimate_parameters
from plategait.model.scenario import Scenario
from plategait.plots.style import BLUE, GREEN, GREY, ORANGE, RED, label_axes, legend_below, new_figure, plain_logarithms
from plategait.study.catalogue import Question
from plategait.study.claims import Answer, Claim, Number, number_of, numbers_of
from plategait.study.measured import Columns, Measured
from plategait.study.questions.curves import (
    CHEESE,
    FREQUENCIES,
    as_run,
    at_frequencies,
    curves_of,
    fits_of,
    rates_at,
    run_offs,
)
from plategait.study.runs import Runs
from plategait.thesis.item import Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

BETAS = (0.2, 0.35, 0.53, 0.7, 0.85, 1.0)
SPEEDS = (0.02, 0.06, 0.1, 0.2)
"""V, m/s; the presets take 60 mm/s, the source prints 100."""
OBJECTS = 24
"""Drawn, for what tells α."""
WANDER = 5.0
"""α of each point lies so many deg to either side at most."""
WANDERING = 8
"""Curves whose α wanders."""
SLOW = 15.0
SEED = 11
Forms = dict[str, tuple[tuple[str, ...], int]]
FORMS: Forms = {
    "(5.7), a line of b/f0": (("width",), 1),
    "a quadratic of b/f0": (("width",), 2),
    "a quadratic of b/f0 and β": (("width", "beta"), 2),
    "a line of the rate at 15 Hz": (("slow",), 1),
    "a line of the rate at 15 Hz, and β": (("slow", "beta"), 1),
    "a quadratic of both": (("slow", "beta"), 2),
    "a quadratic of the rates at 13 and 15 Hz, and β": (("slowest", "slow", "beta"), 2),
}
"""What α may be told from, and by what degree of polynomial."""
THESIS, WIDTH, LINE, BEST = (list(FORMS)[i] for i in (0, 1, 4, 6))


def cases() -> list[Scenario]:
    """The cheese with each β, then with each V."""
    friction = CHEESE.friction
    laws = [friction.with_ratio(beta) for beta in BETAS]
    laws += [friction.replace(transition_speed=speed) for speed in SPEEDS]
    return [CHEESE.replace(friction=law) for law in laws]


def laws(runs: Runs, repeats: int = 2) -> Measured:
    """Spin curves of `cases`."""
    return runs.measure(at_frequencies(cases()), repeats=repeats, half_step=True)


def objects(count: int = OBJECTS) -> list[Scenario]:
    """Objects as the source's: ω_n 3.5π to 33π, α 25 to 57 deg, and β 0.3 to 0.9, spread by a Latin hypercube."""
    from scipy.stats import qmc

    drawn = []
    for a, b, c in qmc.LatinHypercube(3, rng=SEED).random(count):
        sheet = CHEESE.sheet.with_natural_frequency(math.pi * 3.5 * (33 / 3.5) ** a)
        friction = CHEESE.friction.with_angle(math.radians(25 + 32 * b)).with_ratio(0.3 + 0.6 * c)
        drawn.append(CHEESE.replace(sheet=sheet, friction=friction))
    return drawn


def features(columns: Columns, scenarios: Sequence[Scenario]) -> dict[str, Array]:
    """What α may be told from, of each curve: b/f0, the roots of two slow rates (deg/s), β; NaN where there is none."""
    widths = [math.nan if fit is None else fit.half_width_hz / fit.f0_hz for fit in fits_of(columns)]
    return {
        "width": np.array(widths),
        "slow": np.sqrt(np.maximum(rates_at(columns, SLOW), 0.0)),
        "slowest": np.sqrt(np.maximum(rates_at(columns, FREQUENCIES[0]), 0.0)),
        "beta": np.array([s.friction.ratio for s in scenarios]),
    }


def terms(form: str, features: dict[str, Array]) -> Array:
    """(n, t) terms of a form's polynomial."""
    names, degree = FORMS[form]
    x = [features[name] for name in names]
    columns = [np.ones(len(x[0])), *x]
    if degree == 2:
        columns += [x[i] * x[j] for i in range(len(x)) for j in range(i, len(x))]
    return np.stack(columns, axis=1)


def left_out(seen: dict[str, Array], scenarios: Sequence[Scenario], form: str) -> Array:
    """Error of α of each object by a form that was fitted to all others, deg; of those that have a Lorentz fit."""
    usable = np.all([np.isfinite(values) for values in seen.values()], axis=0)
    design = terms(form, seen)[usable]
    alpha = np.array([math.degrees(s.friction.angle) for s in scenarios])[usable]
    hat = design @ np.linalg.pinv(design)
    return (alpha - hat @ alpha) / (1 - np.diag(hat))


def rms(values: Array) -> float:
    """Root of the mean square."""
    return float(np.sqrt(np.mean(np.square(values))))


def told_by(form: str, known: dict[str, Array], scenarios: Sequence[Scenario], seen: dict[str, Array]) -> Array:
    """α by a form fitted to objects whose features are known, of other curves' features, deg."""
    usable = np.all([np.isfinite(values) for values in known.values()], axis=0)
    alpha = np.array([math.degrees(s.friction.angle) for s in scenarios])[usable]
    coefficients, *_ = np.linalg.lstsq(terms(form, known)[usable], alpha, rcond=None)
    return np.asarray(terms(form, seen) @ coefficients, dtype=np.float64)


def wandering(count: int = WANDERING) -> list[Scenario]:
    """Each point of so many curves with an α of its own, in the order of `at_frequencies`."""
    rng, middle = np.random.default_rng(SEED), math.degrees(CHEESE.friction.angle)
    points = at_frequencies([CHEESE] * count)
    alphas = middle + rng.uniform(-WANDER, WANDER, len(points))
    return [s.replace(friction=s.friction.with_angle(math.radians(a))) for s, a in zip(points, alphas, strict=True)]


def law_claims(found: Measured) -> list[Claim]:
    """What is claimed of β and V."""
    least, most, middle = 0, len(BETAS) - 1, BETAS.index(0.53)
    slow_v, fast_v = len(BETAS), len(BETAS) + len(SPEEDS) - 1

    def change(of: str, first: int, last: int) -> Number:
        return number_of(found, lambda c: _mark(c, of)[last] / _mark(c, of)[first] - 1)

    # What a change of b/f0 is worth in α by the source's own slope.
    slope = published.regression(3)["p2"].value
    width = number_of(found, lambda c: slope * (_mark(c, "width")[most] - _mark(c, "width")[least]))
    peak, slow = change("peak", least, most), change("slow", least, most)
    speed = number_of(found, lambda c: max(abs(_mark(c, "peak")[slow_v:fast_v] / _mark(c, "peak")[middle] - 1)))
    slow_speed = change("slowest", slow_v, fast_v)
    return [
        Claim("β from 0.2 to 1 changes the greatest spin rate by less than 15 %", abs(peak.value) < 0.15, peak),
        Claim("it raises the slow sliding at 16 Hz by more than half", slow.value > 0.5, slow),
        Claim("through b/f0 it passes for more than 10 deg of α by (5.7)", width.value > 10, width, "deg",
              note="by the published slope of 545 deg"),
        Claim("V from 20 to 100 mm/s changes the greatest spin rate by less than 3 %", speed.value < 0.03, speed),
        Claim("V from 20 to 200 mm/s raises the slow sliding at 13 Hz by more than half", slow_speed.value > 0.5,
              slow_speed),
    ]  # fmt: skip


def _mark(columns: Columns, of: str) -> Array:
    if of == "peak":
        return np.nanmax(columns["spin_rate"].reshape(-1, len(FREQUENCIES)), axis=1)
    if of == "width":
        return np.array([math.nan if f is None else f.half_width_hz / f.f0_hz for f in fits_of(columns)])
    return rates_at(columns, 16.0 if of == "slow" else FREQUENCIES[0])


def form_claims(found: Measured, scenarios: Sequence[Scenario]) -> list[Claim]:
    """What is claimed of what tells α."""

    def errors_of(columns: Columns) -> dict[str, float]:
        seen = features(columns, scenarios)
        return {form: rms(left_out(seen, scenarios, form)) for form in FORMS}

    errors = numbers_of(found, errors_of)
    used = len(left_out(features(found.means, scenarios), scenarios, THESIS))
    note = f"each of {used} objects of {len(scenarios)} that have a Lorentz fit, by a fit to the others"
    gain = Number(errors[WIDTH].value / errors[THESIS].value)
    return [
        Claim("(5.7) refitted, a line of b/f0, tells α of objects of unlike β within 5 deg r.m.s.",
              errors[THESIS].value < 5, errors[THESIS], "deg", note=note),
        Claim("a quadratic of b/f0 at least halves that error", gain.value < 0.5, gain),
        Claim("a quadratic of the rates at 13 and 15 Hz and of β tells it within 2 deg r.m.s.", errors[BEST].value < 2,
              errors[BEST], "deg"),
    ]  # fmt: skip


def wander_claims(found: Measured, still: Measured, forms: Measured, scenarios: Sequence[Scenario]) -> list[Claim]:
    """What is claimed of α that wanders."""
    truth = math.degrees(CHEESE.friction.angle)

    known = features(forms.means, scenarios)

    def scatter(columns: Columns) -> dict[str, float]:
        seen = features(columns, [CHEESE] * (len(columns["failed"]) // len(FREQUENCIES)))
        return {form: float(np.nanstd(told_by(form, known, scenarios, seen), ddof=1)) for form in (BEST, THESIS)}

    scatters = numbers_of(found, scatter)
    best, line = scatters[BEST], scatters[THESIS]
    off = float(told_by(BEST, known, scenarios, features(still.means, [CHEESE]))[0]) - truth
    return [
        Claim(f"α that wanders by ±{WANDER:g} deg from point to point scatters α told by the slow rates by less than 3 "
              "deg", best.value < 3, best, "deg",
              note=f"s.d. over {WANDERING} curves; where α keeps still the form is {off:+.1f} deg off"),
        Claim("and α by (5.7) by less, as b/f0 hardly knows α", line.value < best.value, line, "deg"),
    ]  # fmt: skip


def posterior_of(curve: Curve, scatter: float) -> dict[str, float | bool]:
    """What the engine in the loop says of α of a curve, deg, β known, told how far α scatters, rad."""
    told = estimate_parameters(curve, as_run(CHEESE), friction_ratio=CHEESE.friction.ratio,
                               friction_scatter=scatter, seed=SEED)  # fmt: skip
    alpha = told["friction_angle"]
    return {
        "scatter": math.degrees(scatter), "alpha": math.degrees(alpha.median), "sd": math.degrees(alpha.sd),
        "holds": bool(alpha.low <= CHEESE.friction.angle <= alpha.high), "explained": bool(told.goodness.explained),
    }  # fmt: skip


def posteriors(runs: Runs, curves: Sequence[Curve]) -> list[dict[str, float | bool]]:
    """The same of several curves, first told nothing of the scatter and then what it is, each done once."""
    return [
        runs.once({"posterior of friction": curve.spin_rate_deg_s.tolist(), "scatter": scatter, "seed": SEED},
                  lambda curve=curve, scatter=scatter: posterior_of(curve, scatter), 300.0)
        for scatter in (0.0, math.radians(WANDER) / math.sqrt(3))
        for curve in curves
    ]  # fmt: skip


def posterior_claims(told: Sequence[dict[str, float | bool]]) -> list[Claim]:
    """What is claimed of the posterior's α."""
    truth = math.degrees(CHEESE.friction.angle)
    blind, aware = ([t for t in told if bool(t["scatter"]) == knows] for knows in (False, True))
    error = rms(np.array([t["alpha"] - truth for t in blind]))
    held = [sum(bool(t["holds"]) for t in some) / len(some) for some in (blind, aware)]
    sds = [float(np.mean([t["sd"] for t in some])) for some in (blind, aware)]
    off = rms(np.array([t["alpha"] - truth for t in aware]))
    return [
        Claim("the posterior's α of such curves is within 3 deg r.m.s.", error < 3, Number(error), "deg",
              note=f"{len(blind)} curves, {sum(bool(t['explained']) for t in blind)} of them explained"),
        Claim("and its 90 % intervals hold the middle α", held[0] == 1.0, Number(held[0]),
              note=f"sd told {sds[0]:.1f} deg"),
        Claim("told that α scatters, they do", held[1] == 1.0, Number(held[1]),
              note=f"sd told {sds[1]:.1f} deg, r.m.s. error {off:.1f} deg"),
    ]  # fmt: skip


def answer(runs: Runs, question: Question) -> Answer:
    """Answer the question."""
    found, scenarios = laws(runs), objects()
    forms = runs.measure(at_frequencies(scenarios), repeats=2, half_step=True)
    wander = runs.measure(wandering(), repeats=2, half_step=True)
    still = found.part(slice(BETAS.index(0.53) * len(FREQUENCIES), (BETAS.index(0.53) + 1) * len(FREQUENCIES)))
    told = posteriors(runs, curves_of(wander.means)[:3])
    claims = (*law_claims(found), *form_claims(forms, scenarios), *wander_claims(wander, still, forms, scenarios),
              *posterior_claims(told))  # fmt: skip
    values = [claim.number.value for claim in claims]
    verdict = (
        f"Dynamic friction counts where the sheet slides, not where it walks: β from 0.2 to 1 changes the peak by "
        f"{100 * values[0]:.0f} % and the sliding at 16 Hz by {100 * values[1]:+.0f} %, and through b/f0 it passes for "
        f"{values[2]:.0f} deg of α. No polynomial of b/f0 tells α once β is free ({values[5]:.0f} deg); the slow rates "
        f"with β do, to {values[7]:.1f} deg. α that wanders by ±5 deg costs {values[8]:.1f} deg there, and the "
        f"posterior {values[10]:.1f} deg, of which it knows nothing unless told."
    )
    notes = ("V and β act where the rim slips slowly; α wanders here from point to point, as each is laid and measured "
             "anew. Within a run the engine's friction stays.", _closed_form(forms, scenarios))  # fmt: skip
    tables = (_law_table(found), _form_table(forms, scenarios), _posterior_table(told))
    figure = draw(found, forms, scenarios, told)
    return Answer(question.name, question.asks, verdict, claims, tables, (("friction", figure),), notes)


def _closed_form(forms: Measured, scenarios: Sequence[Scenario]) -> str:
    """The line that takes the place of (5.7), in words."""
    known = features(forms.means, scenarios)
    alpha = np.array([math.degrees(s.friction.angle) for s in scenarios])
    q, p, s = np.linalg.lstsq(terms(LINE, known), alpha, rcond=None)[0]
    return (f"In the place of (5.7), at A_p = 3 deg, B_p = 3 mm and 40 mm: α/deg = {q:.2f} + {p:.3f} √(ω_B/(deg/s)) at "
            f"{SLOW:g} Hz {s:+.2f} β.")  # fmt: skip


def _law_table(found: Measured) -> Table:
    c, fits = found.means, fits_of(found.means)
    rows = []
    for i, (scenario, fit) in enumerate(zip(cases(), fits, strict=True)):
        f0, width = (math.nan, math.nan) if fit is None else (fit.f0_hz, fit.half_width_hz / fit.f0_hz)
        rows.append((scenario.friction.ratio, 1e3 * scenario.friction.transition_speed, f0, width,
                     math.degrees(_mark(c, "peak")[i]), float(_mark(c, "slowest")[i]), float(_mark(c, "slow")[i]),
                     float(run_offs(c)[i])))  # fmt: skip
    columns = ("β", "V, mm/s", "f0, Hz", "b/f0", "peak, deg/s", "at 13 Hz, deg/s", "at 16 Hz, deg/s", "run-off, Hz")
    return Table("friction-laws", columns, tuple(rows))


def _form_table(forms: Measured, scenarios: Sequence[Scenario]) -> Table:
    seen = features(forms.means, scenarios)
    halved = None if forms.half_means is None else features(forms.half_means, scenarios)
    rows = []
    for form in FORMS:
        off = left_out(seen, scenarios, form)
        half = math.nan if halved is None else rms(left_out(halved, scenarios, form))
        rows.append((form, rms(off), float(np.median(np.abs(off))), half))
    columns = ("α told by", "r.m.s. error, deg", "median, deg", "r.m.s. at half the step")
    return Table("friction-forms", columns, tuple(rows))


def _posterior_table(told: Sequence[dict[str, float | bool]]) -> Table:
    rows = [(float(t["scatter"]), float(t["alpha"]), float(t["sd"]), "yes" if t["holds"] else "no",
             "yes" if t["explained"] else "no") for t in told]  # fmt: skip
    columns = ("scatter that is told, deg", "α, deg", "sd, deg", "90 % holds the truth", "explained")
    return Table("friction-posterior", columns, tuple(rows))


def draw(
    found: Measured, forms: Measured, scenarios: Sequence[Scenario], told: Sequence[dict[str, float | bool]]
) -> Figure:
    """Curves by β and V; α by the best and the source's form over the truth."""
    figure = new_figure(11, 3.6)
    axes: list[Axes] = list(figure.subplots(1, 3))
    curves = np.degrees(found.means["spin_rate"]).reshape(-1, len(FREQUENCIES))
    for beta, rates, shade in zip(BETAS, curves, np.linspace(0.9, 0.1, len(BETAS)), strict=False):
        axes[0].plot(FREQUENCIES, rates, "o-", ms=3, lw=1.2, color=(1 - shade, 0.3, shade), label=f"β = {beta:g}")
    for speed, rates, colour in zip(SPEEDS, curves[len(BETAS) :], (BLUE, GREEN, ORANGE, RED), strict=True):
        axes[1].plot(FREQUENCIES, rates, "o-", ms=3, lw=1.2, color=colour, label=f"V = {1e3 * speed:g} mm/s")
    for axis, title in zip(axes, ("dynamic friction", "V", "α, each object told by the others"), strict=True):
        axis.set_title(title, fontsize=10)
    for axis in axes[:2]:
        axis.set_yscale("log")
        plain_logarithms(axis.yaxis)
        label_axes(axis, "plate frequency, Hz", "spin rate, deg/s")
        axis.legend(frameon=False, fontsize=8)
    seen = features(forms.means, scenarios)
    usable = np.all([np.isfinite(values) for values in seen.values()], axis=0)
    alpha = np.array([math.degrees(s.friction.angle) for s in scenarios])[usable]
    for form, colour, label in ((THESIS, GREY, "by b/f0, (5.7)"), (BEST, BLUE, "by two slow rates and β")):
        axes[2].plot(alpha, alpha - left_out(seen, scenarios, form), "o", color=colour, ms=4, label=label)
    truth = math.degrees(CHEESE.friction.angle)
    for knows, colour, label in ((False, RED, "posterior, α wanders ±5 deg"), (True, GREEN, "told so")):
        some = [t for t in told if bool(t["scatter"]) == knows]
        axes[2].errorbar([truth + 0.6 * i + 0.3 * knows for i in range(len(some))], [float(t["alpha"]) for t in some],
                         [1.645 * float(t["sd"]) for t in some], fmt="s", color=colour, ms=4, lw=1,
                         label=label)  # fmt: skip
    axes[2].plot([25, 57], [25, 57], color=GREY, lw=1)
    label_axes(axes[2], "true α, deg", "told, deg")
    legend_below(figure, axes[2].get_legend_handles_labels()[0])
    return figure
