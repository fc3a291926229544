"""Strides: fixed points of the map from one plate period to the next, and how they lose their hold."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.campaign.seal import hash_of
from plategait.model.plain import plain_model
from plategait.model.scenario import Scenario
from plategait.plots.style import BLUE, GREY, RED, label_axes, legend_below, new_figure
from plategait.simulation.run import starts
from plategait.simulation.strobe import (
    COORDINATES,
    SHAPE,
    State,
    advance,
    at_rest,
    coordinates,
    partings,
    stroboscopic,
)
from plategait.study.catalogue import Question
from plategait.study.claims import Answer, Claim, number_of
from plategait.study.measured import Columns, Measured, Row
from plategait.study.questions.gait import at_gamma, body
from plategait.study.runs import SEED, Runs
from plategait.thesis.item import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

GAMMAS = {
    ("soft", 3.0): (3.0, 3.5, 4.0, 4.25, 4.5, 4.75, 5.0, 5.25, 5.5, 5.75, 6.0, 6.5),
    ("soft", 12.0): (3.0, 3.5, 4.0, 4.5, 4.75, 5.0, 5.25, 5.5, 5.75, 6.0, 6.25, 6.5),
    ("rigid", 3.0): (2.0, 2.5, 3.0, 3.25, 3.5, 3.75, 4.0, 4.5),
}
"""Γ at which twins are followed, by body and A_p in deg."""
FINE = tuple(np.arange(2.0, 7.01, 0.125).tolist())
"""Γ of the bifurcation diagrams."""
SIZES = (3e-3, 1e-2)
"""Distances of twins, over the radius: 0.12 and 0.4 mm."""
SETTLING, SEEN = 60, 48
"""Strides that are left out, and that are looked at."""
_SERIES, _PERIODS = 2, 36
_RISE = COORDINATES.index("z'")


def alternation(shapes: Array) -> float:
    """Share of the scatter of shapes, (strides, m), that is a difference between every other: 1 if doubled."""
    turns = (-1.0) ** np.arange(len(shapes))
    about = shapes - shapes.mean(axis=0)
    scatter = math.sqrt(float((about**2).sum()) / len(shapes))
    return float(np.linalg.norm((about * turns[:, None]).mean(axis=0))) / scatter if scatter > 0 else 0.0


def winding(shapes: Array) -> float:
    """Strides in which the shapes circle about their mean once, by the strongest frequency of their first component."""
    about = shapes - shapes.mean(axis=0)
    first = about @ np.linalg.svd(about, full_matrices=False)[2][0]
    power = np.abs(np.fft.rfft(first * np.hanning(len(first)), 16 * len(first)))
    # Slower than six strides is a sheet that drifts.
    low = 16 * len(first) // 6
    return 16 * len(first) / float(low + np.argmax(power[low:]))


def sections(scenarios: list[Scenario], states: list[State]) -> list[tuple[list[Array], State]]:
    """Coordinates of the strides that are looked at, after those that are left out, and the last state."""
    now = advance(scenarios, states, SETTLING)
    seen: list[list[Array]] = [[] for _ in scenarios]
    for _ in range(SEEN):
        now = advance(scenarios, now)
        for each, scenario, state in zip(seen, scenarios, now, strict=True):
            each.append(coordinates(scenario, state))
    return list(zip(seen, now, strict=True))


def rows_of(scenarios: list[Scenario], states: list[State]) -> list[Row]:
    """What strides are: scatter of their shapes, what of it alternates, winding, place, growth and multipliers."""
    found = sections(scenarios, states)
    at = [state for _, state in found]
    parted = [partings(scenarios, at, size, periods=_PERIODS, series=_SERIES) for size in SIZES]
    rows = []
    for i, (seen, _) in enumerate(found):
        shapes = np.array(seen)[:, SHAPE]
        row = {
            "scatter": math.sqrt(float(((shapes - shapes.mean(axis=0)) ** 2).sum()) / len(shapes)),
            "alternation": alternation(shapes), "winding": winding(shapes),
            "aside": abs(float(np.mean([place[1] for place in seen[-8:]]))),
        }  # fmt: skip
        for name, each in zip(("near", "far"), parted, strict=True):
            first, second = each[i].multipliers
            row |= {f"growth_{name}": each[i].growth, f"first_{name}": float(first.real),
                    f"second_{name}": float(second.real), f"turning_{name}": abs(float(first.imag))}  # fmt: skip
        rows.append(row)
    return rows


def followed(runs: Runs, key: tuple[str, float], gammas: tuple[float, ...], repeats: int = 2) -> Measured:
    """Strides of one body at several Γ, from several starts, and again at half the time step."""
    nominal = [stroboscopic(at_gamma(body(*key), g)) for g in gammas]
    whole = [_once(runs, nominal, i) for i in range(repeats)]
    half = [_once(runs, [s.replace(time_step=s.dt / 2) for s in nominal], i) for i in range(repeats)]
    return Measured(tuple(zip(*whole, strict=True)), tuple(zip(*half, strict=True)))


def _once(runs: Runs, scenarios: list[Scenario], start: int) -> list[Row]:
    x, y, angle = starts(start + 1, SEED)[start]
    what = {"strides": [hash_of(plain_model(s)) for s in scenarios], "start": start, "sizes": SIZES,
            "counts": [SETTLING, SEEN, _PERIODS, _SERIES]}  # fmt: skip
    states = [at_rest(s.replace(**{"start.x": x, "start.y": y, "start.angle": angle})) for s in scenarios]
    time = sum(s.motion.period for s in scenarios) * (SETTLING + SEEN + 2 * _PERIODS * (1 + _SERIES))
    return runs.once(what, lambda: {"rows": rows_of(scenarios, states)}, time)["rows"]


def diagram(runs: Runs, key: tuple[str, float]) -> Array:
    """(Γ, strides) vertical velocity of the middle as the plate passes through its own, over r ω."""
    scenarios = [stroboscopic(at_gamma(body(*key), g)) for g in FINE]
    what = {"diagram": [hash_of(plain_model(s)) for s in scenarios], "counts": [SETTLING, SEEN]}

    def work() -> dict[str, list[list[float]]]:
        found = sections(scenarios, [at_rest(s) for s in scenarios])
        return {"rise": [[float(place[_RISE]) for place in seen] for seen, _ in found]}

    return np.array(runs.once(what, work, sum(s.motion.period for s in scenarios) * (SETTLING + SEEN))["rise"])


def answer(runs: Runs, question: Question) -> Answer:
    """Answer the question."""
    found = {key: followed(runs, key, gammas) for key, gammas in GAMMAS.items()}
    claims = (*flat_claims(found["soft", 3.0]), *wide_claims(found["soft", 12.0]), *rigid_claims(found["rigid", 3.0]))
    flip = next(claim for claim in claims if "-1" in claim.claim)
    verdict = (
        "No multiplier leaves the unit circle where sliding goes over into walking, at 3 deg or at 12: legs only begin "
        f"to graze. The cheese runs off at 3 deg by a period doubling (multiplier {flip.number.value:.2f} at Γ = 5.5), "
        "after which it steps aside; at 12 deg its walk becomes a torus first. A rigid disk is a ball: it bounces "
        "chaotically from Γ = 3.75 on, without doubling its period before."
    )
    rises = {key: diagram(runs, key) for key in GAMMAS}
    return Answer(question.name, question.asks, verdict, claims, (_table(found),), (("strides", draw(found, rises)),),
                  _NOTES)  # fmt: skip


_NOTES = (
    "A stride is seen once each plate period, as the plate passes through its middle, by 18 coordinates: where the "
    "sheet lies and how it is turned, their rates, and a parabola each through its heights and vertical velocities. "
    "Place and turn are left out of what twins part by: their multipliers are 1, as an endless plate does not know of "
    "them.",
    "Multipliers are those of twins 0.12 mm (and, for convergence, 0.4 mm) apart, the two leading ones by least "
    "squares over 2 × 31 strides. Below 0.04 mm the bends of contact and friction decide how twins part, above 0.4 mm "
    "the shape of the attractor.",
    "The lattice turns by some 20 deg with each stride, so that no two strides are quite alike: that is the scatter "
    "which is left at low Γ, 0.002 of the radius at 3 deg and 0.013 at 12.",
)


def _at(key: tuple[str, float], name: str, *gammas: float) -> Callable[[Columns], Array]:
    which = [GAMMAS[key].index(g) for g in gammas]
    return lambda columns: columns[name][which]


def flat_claims(measured: Measured) -> list[Claim]:
    """How the strides of the cheese at 3 deg lose their hold."""
    key = ("soft", 3.0)

    def onset(columns: Columns) -> float:
        low = np.minimum(columns["second_near"], columns["first_near"])
        a, b = (low[GAMMAS[key].index(g)] for g in (5.0, 5.5))
        return float(5.5 + 0.5 * (-1 - b) / (b - a))

    def largest(columns: Columns) -> float:
        return float(np.max(np.abs(_at(key, "first_near", 3.5, 4.0, 4.5, 4.75)(columns))))

    def agreement(columns: Columns) -> float:
        near, far = (_at(key, f"first_{size}", 3.0, 3.5, 4.0, 5.25, 5.5)(columns) for size in ("near", "far"))
        return float(np.max(np.abs(near - far)))

    graze, double = (
        number_of(measured, largest),
        number_of(measured, lambda c: float(_at(key, "first_near", 5.5)(c)[0])),
    )
    when = number_of(measured, onset)
    turns = number_of(measured, lambda c: float(_at(key, "alternation", 6.0)(c)[0]))
    aside = number_of(measured, lambda c: float(40 * _at(key, "aside", 6.0)(c)[0]))
    same = number_of(measured, agreement)
    return [
        Claim("at 3 deg all multipliers stay within 0.8 where sliding goes over into walking", graze.value <= 0.8,
              graze, note="largest at Γ from 3.5 to 4.75: legs graze"),
        Claim("at 3 deg -1 leaves the unit circle at run-off: the leading multiplier at Γ = 5.5 is below -0.75",
              double.value <= -0.75, double),
        Claim("extrapolated, it does so between Γ = 5.4 and 6", 5.4 <= when.value <= 6, when,
              note="from Γ = 5 and 5.5"),
        Claim("beyond, every other stride is alike: 0.8 of the scatter at Γ = 6 alternates", turns.value >= 0.8, turns),
        Claim("the doubled stride has stepped 5 mm aside or more", aside.value >= 5, aside, "mm",
              "after 108 strides at Γ = 6; the source's slip limit is 10 mm"),
        Claim("multipliers of twins 0.12 and 0.4 mm apart agree within 0.2", same.value <= 0.2, same),
    ]  # fmt: skip


def wide_claims(measured: Measured) -> list[Claim]:
    """How the walk at 12 deg loses its hold."""
    key = ("soft", 12.0)
    wider = number_of(measured, lambda c: float(np.divide(*_at(key, "scatter", 5.0, 4.0)(c))))
    around = number_of(measured, lambda c: float(_at(key, "winding", 5.0)(c)[0]))
    near = number_of(measured, lambda c: float(_at(key, "growth_near", 5.5)(c)[0]))
    far = number_of(measured, lambda c: float(_at(key, "growth_far", 5.5)(c)[0]))
    turns = number_of(measured, lambda c: float(_at(key, "alternation", 6.25)(c)[0]))
    begins = number_of(measured, lambda c: float(_at(key, "growth_near", 4.0)(c)[0]))
    return [
        Claim("at 12 deg sliding goes over into walking without a loss of hold: twins close up at Γ = 4",
              begins.value < -0.5, begins, "per stride", "Lyapunov exponent at 0.12 mm"),
        Claim("at 12 deg the walk begins to circle about its stride between Γ = 4 and 5: a torus", wider.value >= 3,
              wider, note="scatter at 5 over that at 4"),
        Claim("it does so in no whole number of strides", 3.5 <= around.value <= 3.9, around, "strides", "Γ = 5"),
        Claim("there twins 0.12 mm apart part, at half the time step too",
              near.value > 0 and near.value + near.step_error > 0, near, "per stride", "Γ = 5.5"),
        Claim("twins 0.4 mm apart close up: what chaos there is stays that small", far.value < 0, far, "per stride",
              "Γ = 5.5"),
        Claim("at Γ = 6.25 every other stride is alike", turns.value >= 0.8, turns),
    ]  # fmt: skip


def rigid_claims(measured: Measured) -> list[Claim]:
    """What a rigid disk does at the same Γ."""
    key = ("rigid", 3.0)
    before = number_of(measured, lambda c: float(np.max(_at(key, "growth_near", 2.0, 2.5, 3.0)(c))))
    chaos = number_of(measured, lambda c: float(np.min(_at(key, "growth_far", 3.75, 4.0, 4.5)(c))))
    turns = number_of(measured, lambda c: float(np.max(_at(key, "alternation", 3.0, 3.25, 3.5, 3.75)(c))))
    return [
        Claim("a rigid disk steps in turn and holds its stride up to Γ = 3", before.value < -0.2, before, "per stride",
              "largest Lyapunov exponent, at 0.12 mm"),
        Claim("from Γ = 3.75 on it bounces chaotically", chaos.value > 0.5, chaos, "per stride",
              "least Lyapunov exponent, at 0.4 mm"),
        Claim("before, it doubles its period as a ball does at 3.30 and 3.72", turns.value >= 0.8, turns,
              note="most of the scatter that alternates, Γ = 3 to 3.75"),
    ]  # fmt: skip


def _table(found: dict[tuple[str, float], Measured]) -> Table:
    names = ("scatter", "alternation", "winding", "aside", "growth_near", "first_near", "turning_near", "second_near",
             "growth_far", "first_far", "second_far")  # fmt: skip
    rows = [
        (name, angle, gamma, *(float(measured.means[which][i]) for which in names))
        for (name, angle), measured in found.items()
        for i, gamma in enumerate(GAMMAS[name, angle])
    ]
    columns = (
        "body",
        "A_p, deg",
        "Γ",
        "scatter, r",
        "alternates",
        "winding, strides",
        "aside, r",
        "growth at 0.12 mm",
        "multiplier",
        "its imaginary part",
        "second",
        "growth at 0.4 mm",
        "multiplier there",
        "second there",
    )
    return Table("strides", columns, tuple(rows))


def draw(found: dict[tuple[str, float], Measured], rises: dict[tuple[str, float], Array]) -> Figure:
    """Bifurcation diagrams, and below them the growth of twins and their multipliers over Γ."""
    figure = new_figure(11, 6.6)
    axes = figure.subplots(3, len(found), sharex=True)
    for column, (key, measured) in enumerate(found.items()):
        top, middle, low = axes[:, column]
        for gamma, values in zip(FINE, rises[key], strict=True):
            top.plot(np.full(len(values), gamma), values, ".", ms=1.5, color="k")
        spread = np.nanquantile(rises[key], [0.02, 0.98])
        top.set_ylim(spread[0] - 0.1 * np.ptp(spread), spread[1] + 0.1 * np.ptp(spread))
        top.set_title(f"{key[0]} disk, A_p = {key[1]:g} deg", fontsize=10)
        gammas = GAMMAS[key]
        for name, colour, label in (("near", BLUE, "0.12 mm apart"), ("far", RED, "0.4 mm apart")):
            middle.plot(gammas, measured.means[f"growth_{name}"], "o-", ms=3.5, lw=1.2, color=colour, label=label)
        middle.axhline(0, lw=0.8, color=GREY)
        for name, marker in (("first_near", "o"), ("second_near", "^")):
            low.plot(gammas, measured.means[name], marker, ms=4, color=BLUE, label=f"{name.split('_')[0]} multiplier")
        for level in (-1, 1):
            low.axhline(level, lw=0.8, color=GREY)
        label_axes(top, "", "rise of the middle, r ω" if not column else "")
        label_axes(middle, "", "growth per stride" if not column else "")
        label_axes(low, "Γ", "multiplier (real part)" if not column else "")
    legend_below(figure)
    return figure
