"""Identifiability: which of mass, elasticity, viscosity and friction a spin experiment tells, and from what."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.model.scenario import Scenario
from plategait.study.catalogue import Question
from plategait.study.claims import Answer, Claim, Number, number_of
from plategait.study.measured import Columns, Measured
from plategait.study.questions.curves import CHEESE
from plategait.study.questions.identifiability_figures import draw
from plategait.study.questions.information import PARAMETERS, Slopes, changed, measure_variants, slopes_of
from plategait.study.questions.profiles import INTERVAL, Profiles, profiles_of
from plategait.study.runs import Runs
from plategait.thesis.item import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

BASE = CHEESE.replace(duration=1.4, transient=0.5, slip_limit=0.02)


def _motions(angle: float, frequencies: Sequence[float], stroke: float = 3e-3) -> list[dict[str, float]]:
    return [{"motion.angle": math.radians(angle), "motion.frequency": f, "motion.stroke": stroke} for f in frequencies]


FLAT = _motions(3, (13.0, 15.0, 16.0, 18.0, 20.0, 22.0, 24.0, 25.0))
"""The source's flat and fast motion."""
OTHERS = [
    *_motions(6, (10.0, 12.0, 14.0, 16.0)), *_motions(12, (9.0, 9.5, 10.0, 10.5, 11.0)),
    *_motions(3, (15.0, 20.0, 24.0), 1.5e-3), *_motions(3, (15.0, 18.0), 6e-3),
]  # fmt: skip
HIGH = [*_motions(0.5, (42.0, 47.0, 52.0, 57.0, 62.0)), *_motions(0.25, (60.0, 70.0, 80.0))]
"""Above 40 Hz, as far as Γ lets the sheet stay."""
MENU = [*FLAT, *OTHERS, *HIGH]
LOW = range(len(FLAT) + len(OTHERS))
READINGS = ("spin_rate", "bending_amplitude")
WEIGHED = 0.01
"""Of the mass, relative."""
WANTED = (0.2, 0.2, 0.1, 0.1)
"""Standard deviation wanted of the logarithm of each of the four; k_b within 20 % is ω_n within 10 %."""
HEAVIER = 1.5
STIFF = 33 * math.pi
"""rad/s: an object whose second and third modes are within the plate's frequencies."""


def heavier(runs: Runs) -> Measured:
    """The cheese, then one heavier by `HEAVIER` and as much stiffer and more viscous, bending and stretching alike."""
    sheet = BASE.sheet
    fields = ("mass", "bending_stiffness", "bending_damping", "axial_stiffness", "axial_damping")
    other = BASE.replace(sheet=sheet.replace(**{name: HEAVIER * getattr(sheet, name) for name in fields}))
    return runs.measure([s.replace(**m) for s in (BASE, other) for m in FLAT], repeats=2, half_step=True)


def heavier_change(columns: Columns, reading: str) -> float:
    """R.m.s. relative change of a reading with the mass, stiffness and viscosity kept in proportion."""
    one, other = columns[reading].reshape(2, len(FLAT))
    return float(np.sqrt(np.nanmean((other / one - 1) ** 2)))


def menu(columns: Columns) -> Slopes:
    """Slopes of both readings under each motion of the menu: rates first."""
    return slopes_of(columns, len(MENU), READINGS)


def rows_of(motions: Sequence[int], readings: Sequence[str] = READINGS) -> list[int]:
    """Rows of `menu` of some motions and readings."""
    return [READINGS.index(reading) * len(MENU) + i for reading in readings for i in motions]


FLAT_ROWS = range(len(FLAT))
SETS: dict[str, list[int]] = {
    "rates at 3 deg": rows_of(FLAT_ROWS, ("spin_rate",)),
    "with bending": rows_of(FLAT_ROWS),
    "rates, several motions": rows_of(LOW, ("spin_rate",)),
    "both, several motions": rows_of(LOW),
    "rates above 40 Hz": rows_of(range(len(LOW), len(MENU)), ("spin_rate",)),
    "both above 40 Hz": rows_of(range(len(LOW), len(MENU))),
}
"""What may be measured."""


def weakest(slopes: Slopes) -> tuple[float, Array]:
    """Standard deviation along the combination that is known least, no mass weighed, and its direction."""
    values, vectors = np.linalg.eigh(slopes.information())
    return 1 / math.sqrt(values[0]), vectors[:, 0]


def alignment(columns: Columns) -> float:
    """How nearly the weakest combination is M, k_b and c_b together: the cosine."""
    direction = weakest(menu(columns).of(SETS["both, several motions"]))[1]
    return abs(float(direction[:3].sum()) / math.sqrt(3))


def excess(slopes: Slopes, rows: Sequence[int]) -> float:
    """Sum of the logarithms by which the bounds of the four, the mass weighed, are too wide."""
    return float(np.maximum(0.0, np.log(slopes.of(rows).bounds(WEIGHED)[1:] / np.array(WANTED))).sum())


def shortest_list(slopes: Slopes) -> list[int]:
    """Rows that pin all four, the mass weighed: the best added one by one, then shortened while exchanges find one."""
    rows = range(len(slopes.noise))
    chosen: list[int] = []
    while len(chosen) < len(rows) and (not chosen or excess(slopes, chosen) > 0):
        left = [i for i in rows if i not in chosen]
        chosen.append(min(left, key=lambda i: excess(slopes, [*chosen, i])))
    while len(chosen) > 1 and (shorter := _exchanged(slopes, chosen[:-1])) is not None:
        chosen = shorter
    return chosen


def _exchanged(slopes: Slopes, chosen: Sequence[int]) -> list[int] | None:
    """As many rows that pin all four, by exchanging one at a time for the best; None where that ends before."""
    best, least = list(chosen), excess(slopes, chosen)
    while least > 0:
        trials = [[*best[:k], i, *best[k + 1 :]] for k in range(len(best)) for i in range(len(slopes.noise))
                  if i not in best]  # fmt: skip
        found = min(trials, key=lambda rows: excess(slopes, rows))
        if excess(slopes, found) >= least:
            return None
        best, least = found, excess(slopes, found)
    return best


def stiff_ones(runs: Runs) -> Measured:
    """A sheet of `STIFF` and its stiffness up and down, under `FLAT` and `HIGH`."""
    stiff = BASE.replace(sheet=BASE.sheet.with_natural_frequency(STIFF))
    return measure_variants(runs, stiff, [*FLAT, *HIGH], ("stiffness",), repeats=3)


def information_per_reading(slopes: Slopes, which: Sequence[int], column: int) -> float:
    """R.m.s. slope over noise of some readings on one parameter: what one of them tells of it."""
    part = slopes.of(which)
    return float(np.sqrt(np.mean((part.values[:, column] / part.noise) ** 2)))


def high_over_low(columns: Columns, reading: str, stiff: bool) -> float:
    """What a reading above 40 Hz tells of the stiffness, over what one at 3 deg below 26 Hz does."""
    names = ("stiffness",) if stiff else PARAMETERS
    motions = len(FLAT) + len(HIGH) if stiff else len(MENU)
    slopes = slopes_of(columns, motions, (reading,), names)
    low, high = range(len(FLAT)), range(motions - len(HIGH), motions)
    column = names.index("stiffness")
    return information_per_reading(slopes, high, column) / information_per_reading(slopes, low, column)


def bound_claims(found: Measured) -> list[Claim]:
    """What is claimed of bounds."""

    def widest(name: str, weighed: float | None = WEIGHED) -> Number:
        return number_of(found, lambda c: float(menu(c).of(SETS[name]).bounds(weighed)[1:].max()))

    flat, bent, several = (widest(n) for n in ("rates at 3 deg", "with bending", "both, several motions"))
    aligned = number_of(found, alignment)
    along = number_of(found, lambda c: weakest(menu(c).of(SETS["both, several motions"]))[0])
    count = number_of(found, lambda c: float(len(shortest_list(menu(c)))))
    told = "standard deviation of the logarithm of the one known least"
    return [
        Claim("of the five logarithms, M, k_b and c_b together are what no kinematic reading tells: cosine above 0.95",
              aligned.value > 0.95, aligned, note=f"known to ± {along.value:.1f} along it, where the prior is 2"),
        Claim("with the mass weighed, rates to 2 % at 3 deg leave one of k_b, c_b, μ_s, β open by more than 20 %",
              flat.value > 0.20, flat, note=told),
        Claim("with the bending to 5 % all four are known within 25 %", bent.value < 0.25, bent, note=told),
        Claim("with other motions besides within 15 %", several.value < 0.15, several, note=told),
        Claim("six readings and a balance pin k_b and c_b within 20 %, μ_s and β within 10 %", count.value <= 6, count,
              note=", ".join(reading_text(menu(found.means), i) for i in shortest_list(menu(found.means)))),
    ]  # fmt: skip


def mode_claims(found: Measured, stiff: Measured) -> list[Claim]:
    """What is claimed of frequencies above 40 Hz."""
    claims = []
    for name, measured, is_stiff in (("10π", found, False), ("33π", stiff, True)):
        rate, angle = (number_of(measured, lambda c, r=r, s=is_stiff: high_over_low(c, r, s)) for r in READINGS)
        claims.append(
            Claim(f"a rate above 40 Hz tells more of the stiffness of a sheet of {name} than one below 26 Hz",
                  rate.value > 1, rate, note=f"bending amplitude: {angle.value:.2g} times")
        )  # fmt: skip
    return claims


def profile_claims(found: Profiles, bounds: Array) -> list[Claim]:
    """Whether profile likelihoods are as narrow as the bounds."""
    ratio = found.sds / bounds
    worst = float(ratio[np.argmax(np.abs(np.log(ratio)))])
    return [
        Claim("profile likelihoods of that list are as wide as the bounds, within 40 %", 1 / 1.4 < worst < 1.4,
              Number(worst), note="half of their 68 % intervals over the bounds, the farthest from 1; "
              f"of k_b, c_b, μ_s, β: {', '.join(f'{r:.2f}' for r in ratio)}"),
        Claim("each has one minimum, closed on both sides", found.closed, Number(float(found.closed)),
              note=f"χ² {INTERVAL:g} above its least is reached on both sides"),
    ]  # fmt: skip


def reading_text(slopes: Slopes, row: int) -> str:
    """A reading in words."""
    i, reading = slopes.names[row]
    motion = MENU[i]
    what = "rate" if reading == "spin_rate" else "bending"
    stroke = motion["motion.stroke"]
    other = "" if stroke == 3e-3 else f", B_p {1e3 * stroke:g} mm"
    return f"{what} at {math.degrees(motion['motion.angle']):.3g} deg, {motion['motion.frequency']:g} Hz{other}"


def answer(runs: Runs, question: Question) -> Answer:
    """Answer the question."""
    twice, found, stiff = heavier(runs), measure_variants(runs, BASE, MENU, repeats=3), stiff_ones(runs)
    slopes = menu(found.means)
    chosen = shortest_list(slopes)
    read = [(MENU[slopes.names[i][0]], slopes.names[i][1]) for i in chosen]
    profiles = profiles_of(runs, BASE, read)
    rate, angle = (number_of(twice, lambda c, r=r: heavier_change(c, r)) for r in READINGS)
    claims = (
        Claim("an object half again as heavy, stiff and viscous spins alike within 2 %", rate.value < 0.02, rate,
              note=f"r.m.s. over 13 to 25 Hz at 3 deg; bending amplitude {100 * angle.value:.1f} %"),
        *bound_claims(found), *mode_claims(found, stiff),
        *profile_claims(profiles, slopes.of(chosen).bounds(WEIGHED)[1:]),
    )  # fmt: skip
    v = [claim.number.value for claim in claims]
    verdict = (
        f"Mass cannot be told by how an object moves: half again as heavy, stiff and viscous it spins alike to "
        f"{100 * v[0]:.1f} %, and the combination known least is that one (cosine {v[1]:.3f}). What can are k_b/M, "
        f"c_b/M, μ_s and β: rates at one amplitude leave {100 * v[2]:.0f} % of one of them, with the bending "
        f"{100 * v[3]:.0f} %, with several motions {100 * v[4]:.0f} %; {v[5]:.0f} readings and a balance pin k_b and "
        f"c_b within 20 %, μ_s and β within 10 %. Higher modes add little: above 40 Hz a rate tells {v[6]:.2g} times "
        f"as much of the stiffness as below 26 Hz, of a stiff sheet {v[7]:.2g} times."
    )
    table = _bounds_table(found)
    tables = (table, _list_table(slopes, chosen), _slope_table(slopes))
    figure = figure_of(found, chosen, profiles)
    return Answer(question.name, question.asks, verdict, claims, tables, (("identifiability", figure),))


def figure_of(found: Measured, chosen: Sequence[int], profiles: Profiles) -> Figure:
    """The picture of the study."""
    slopes = menu(found.means)
    bounds = {name: slopes.of(rows).bounds(WEIGHED)[1:] for name, rows in SETS.items()}
    steps = [slopes.of(chosen[: n + 1]).bounds(WEIGHED)[1:] for n in range(len(chosen))]
    return draw(bounds, steps, [reading_text(slopes, i) for i in chosen], profiles)


def _bounds_table(found: Measured) -> Table:
    rows = []
    for name, which in SETS.items():
        for weighed in (None, WEIGHED):
            bounds = menu(found.means).of(which).bounds(weighed)
            rows.append((name, "no" if weighed is None else "yes", *map(float, bounds)))
    return Table("identifiability-bounds", ("measured", "mass weighed", *(f"ln {n}" for n in PARAMETERS)), tuple(rows))


def _list_table(slopes: Slopes, chosen: Sequence[int]) -> Table:
    rows = [(n + 1, reading_text(slopes, i), *map(float, slopes.of(chosen[: n + 1]).bounds(WEIGHED)[1:]))
            for n, i in enumerate(chosen)]  # fmt: skip
    return Table("identifiability-list", ("", "reading", *(f"ln {n}" for n in PARAMETERS[1:])), tuple(rows))


def _slope_table(slopes: Slopes) -> Table:
    rows = [(reading_text(slopes, i), *map(float, slopes.values[i])) for i in range(len(slopes.noise))]
    return Table("identifiability-slopes", ("reading", *(f"by ln {n}" for n in PARAMETERS)), tuple(rows))


def with_logs(base: Scenario, values: Array) -> Scenario:
    """Scenario with the four logarithms changed by so much."""
    return changed(base, dict(zip(PARAMETERS[1:], map(float, values), strict=True)))
