"""The stroke: why the spin rate goes with B_p, which section 4.4 denies, and what would have to be so if it did not."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.engine.recording import Recording
from plategait.model.outline import Disk
from plategait.model.scenario import Scenario
from plategait.plots.style import BLUE, GREEN, GREY, RED, label_axes, new_figure
from plategait.simulation.observables import rotation
from plategait.simulation.stride import stride_row
from plategait.study.catalogue import Question
from plategait.study.claims import Answer, Claim, number_of
from plategait.study.measured import Columns, Measured, Row
from plategait.study.questions.gait import at_gamma, cheese, strangers
from plategait.study.runs import Runs
from plategait.thesis.item import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Change = Callable[[Scenario], Scenario]
STROKES = (1.5e-3, 3e-3, 6e-3)
"""B_p of the exponents, m."""
MANY_STROKES = (0.75e-3, 1.5e-3, 3e-3, 4.5e-3, 6e-3, 9e-3, 12e-3, 18e-3)
GAMMAS = (3.5, 4.0, 4.5, 5.0)
ANGLES = (3.0, 12.0)
RADII = (0.02, 0.04, 0.08)
PUBLISHED_PEAK = math.radians(599)
"""Fastest spin of Fig. 5.2(a), rad/s, at 25.1 Hz and A_p = 3 deg."""
INDEPENDENT = 0.25
"""Power of B_p up to which doubling the stroke changes a rate by less than a fifth, which may pass for no effect."""
FIRST_PERIODS = 8
STRANGERS = 12
"""Disks of the study of gaits, on which the speed of the rim is held against the plate's."""


def _lag(scenario: Scenario, degrees: float) -> Scenario:
    wave = {"axis": "x", "amplitude": scenario.motion.stroke, "phase": math.radians(degrees)}
    return scenario.replace(**{"motion.stroke": 0.0, "motion.waves": [wave]})


def _set(scenario: Scenario, **changes: float | str) -> Scenario:
    return scenario.replace(**{name.replace("__", "."): value for name, value in changes.items()})


def _rough(scenario: Scenario, degrees: float) -> Scenario:
    return scenario.replace(friction=scenario.friction.with_angle(math.radians(degrees)))


CANDIDATES: dict[str, tuple[str, Change]] = {
    "as it is": ("", lambda s: s),
    "lag 30 deg": ("phase", partial(_lag, degrees=30.0)),
    "lag 60 deg": ("phase", partial(_lag, degrees=60.0)),
    "lag 120 deg": ("phase", partial(_lag, degrees=120.0)),
    "soft contact": ("contact", partial(_set, contact__stiffness=1000.0)),
    "no contact damping": ("contact", partial(_set, contact__damping=0.0)),
    "tenfold contact damping": ("contact", partial(_set, contact__damping=76.5)),
    "V = 5 mm/s": ("friction", partial(_set, friction__transition_speed=0.005)),
    "V = 500 mm/s": ("friction", partial(_set, friction__transition_speed=0.5)),
    "μ_k = μ_s": ("friction", lambda s: s.replace(friction=s.friction.with_ratio(1.0))),
    "smooth law": ("friction", partial(_set, friction__law="adams")),
    "smooth law, V = 500 mm/s": ("friction", partial(_set, friction__law="adams", friction__transition_speed=0.5)),
    "plate on its axis": ("frame", partial(_set, motion__height=0.0)),
    "plate 15 mm above it": ("frame", partial(_set, motion__height=0.015)),
    "α = 10 deg": ("low friction", partial(_rough, degrees=10.0)),
    "α = 3 deg": ("low friction", partial(_rough, degrees=3.0)),
    "α = 1 deg": ("low friction", partial(_rough, degrees=1.0)),
    "α = 0.3 deg": ("low friction", partial(_rough, degrees=0.3)),
}
"""What might differ in the source's simulation: a kind and a change of the scenario."""


def with_stroke(scenario: Scenario, stroke: float) -> Scenario:
    """Scenario at another B_p, m, that counts as failed no sooner than it has slipped 50 mm."""
    return scenario.replace(**{"motion.stroke": stroke, "slip_limit": 0.05})


def exponents(runs: Runs) -> Measured:
    """Strides of every candidate at both A_p, three strokes and four Γ: points in that order."""
    points = [
        change(with_stroke(at_gamma(cheese(angle), gamma), stroke))
        for _, change in CANDIDATES.values()
        for angle in ANGLES
        for stroke in STROKES
        for gamma in GAMMAS
    ]
    return runs.measure(points, repeats=2, half_step=True, measure=stride_row)


def peaks(columns: Columns) -> Array:
    """(candidates, angles, strokes) fastest spin over Γ, rad/s."""
    spin = np.abs(columns["spin_rate"]).reshape(len(CANDIDATES), len(ANGLES), len(STROKES), len(GAMMAS))
    return np.nanmax(spin, axis=-1)


def power(columns: Columns, name: str, angle: float) -> float:
    """Power of B_p that the fastest spin of a candidate goes with."""
    spin = peaks(columns)[list(CANDIDATES).index(name), ANGLES.index(angle)]
    return float(np.polyfit(np.log(STROKES), np.log(spin), 1)[0])


def scaled(radius: float) -> Scenario:
    """The cheese at 3 deg, cut to another radius in 52 nodes, of the same ω_n and loss."""
    base = cheese(3.0)
    sheet = base.sheet.replace(
        outline=Disk(radius=radius), pitch=radius / 4, mass=base.sheet.mass * (radius / 0.04) ** 2
    )
    sheet = sheet.with_natural_frequency(base.sheet.natural_frequency)
    loss = base.sheet.bending_damping / base.sheet.bending_stiffness
    return base.replace(sheet=sheet.replace(bending_damping=loss * sheet.bending_stiffness))


def _others() -> list[Scenario]:
    return strangers(STRANGERS, seed=21)


def speeds(runs: Runs) -> Measured:
    """Strides at 3 deg by stroke at 40 mm, then by radius at 3 mm, then of strangers; each over `GAMMAS`."""
    points = [with_stroke(at_gamma(cheese(3.0), g), b) for b in MANY_STROKES for g in GAMMAS]
    points += [with_stroke(at_gamma(scaled(r), g), 3e-3) for r in RADII for g in GAMMAS]
    points += [at_gamma(stranger, g) for stranger in _others() for g in GAMMAS]
    return runs.measure(points, repeats=2, half_step=True, measure=stride_row)


def rim_over_plate(columns: Columns) -> Array:
    """(strokes, radii and strangers,) greatest speed of the rim over the plate's greatest, B_p ω_p: over `GAMMAS`."""
    others = [s.motion.stroke for s in _others()]
    strokes = np.array([*MANY_STROKES, *(len(RADII) * (3e-3,)), *others])
    radii = np.array([*(len(MANY_STROKES) * (0.04,)), *RADII, *(len(others) * (0.04,))])
    turn = np.nanmax(columns["turn"].reshape(len(strokes), len(GAMMAS)), axis=1)
    return turn / math.tau * radii / strokes


def first_turns(scenario: Scenario, recording: Recording) -> Row:
    """Turn in each of the first plate periods, rad."""
    angle = np.unwrap(rotation(recording["spin_cross"], recording["spin_dot"]))
    ends = np.interp(np.arange(FIRST_PERIODS + 1) * scenario.motion.period, recording["time"], angle)
    return {f"turn_{i}": float(turn) for i, turn in enumerate(np.diff(ends))}


def spin_up(runs: Runs) -> Measured:
    """Turns of the first periods at 3 deg, Γ = 4.5, by stroke; the plate starts at once."""
    scenario = at_gamma(cheese(3.0), 4.5).replace(**{"motion.ramp": 0.0})
    points = [with_stroke(scenario, stroke) for stroke in STROKES]
    return runs.measure(points, repeats=2, half_step=True, measure=first_turns)


def first_power(columns: Columns, period: int) -> float:
    """Power of B_p that the turn in one of the first periods goes with."""
    return float(np.polyfit(np.log(STROKES), np.log(columns[f"turn_{period}"]), 1)[0])


def answer(runs: Runs, question: Question) -> Answer:
    """Answer the question."""
    found, sped, begun = exponents(runs), speeds(runs), spin_up(runs)
    claims = claims_of(found, sped, begun)
    share, survivors = float(rim_over_plate(sped.means)[2]), _survivors(found)
    verdict = (
        f"B_p sets the top speed: the rim comes to {share:.2f} of the plate's own speed B_p ω_p, at any stroke from "
        f"1.5 to 6 mm and any radius. Only a slippery plate would hide it ({', '.join(survivors) or 'none'}), on which "
        "the object spins a third as fast as the source's or less; phase, contact, friction law and height do not. No "
        "candidate survives both."
    )
    notes = (
        "Friction drags the sheet along as long as the plate outruns it; a rigid half gets the same moment at any slip "
        "(equation 2.3), so the first period does not know B_p. But the rim cannot outrun the plate: the spin ends "
        "where its own speed turns friction round, and that speed goes with B_p.",
        f"The power is fitted to B_p = 1.5, 3 and 6 mm, of the fastest spin over Γ = 3.5 to 5; up to {INDEPENDENT} may "
        "pass for no effect, as doubling B_p then changes the rate by less than a fifth.",
    )
    return Answer(question.name, question.asks, verdict, tuple(claims), (_table(found),),
                  (("stroke", draw(found, sped, begun)),), notes)  # fmt: skip


def _survivors(measured: Measured) -> list[str]:
    """Candidates under which the spin at 3 deg hardly goes with B_p."""
    return [name for name in CANDIDATES if abs(power(measured.means, name, 3.0)) <= INDEPENDENT]


def claims_of(found: Measured, sped: Measured, begun: Measured) -> list[Claim]:
    """What is claimed of the powers, of the speed of the rim, and of the first periods."""

    def least(columns: Columns, kind: str) -> float:
        return min(power(columns, name, a) for name, (k, _) in CANDIDATES.items() if k == kind for a in ANGLES)

    flat, wide = (number_of(found, partial(power, name="as it is", angle=a)) for a in ANGLES)
    claims = [
        Claim(
            f"at {angle:g} deg the spin rate goes with B_p to the power 0.8 to 1.3", 0.8 <= number.value <= 1.3, number
        )
        for angle, number in zip(ANGLES, (flat, wide), strict=True)
    ]
    words = {"phase": "a phase lag", "contact": "contact", "friction": "the friction law",
             "frame": "the plate's height", "low friction": "low friction"}  # fmt: skip
    for kind, word in words.items():
        number = number_of(found, partial(least, kind=kind))
        claims.append(Claim(f"{word} could make the spin rate independent of B_p", number.value <= INDEPENDENT, number,
                            note="least power of B_p"))  # fmt: skip
    survivors = _survivors(found)

    def fastest(columns: Columns) -> float:
        spins = [peaks(columns)[list(CANDIDATES).index(name), 0, 1] for name in survivors]
        return float(max(spins, default=0.0) / PUBLISHED_PEAK)

    speed = number_of(found, fastest)
    claims.append(Claim("one that does still spins half as fast as the source's fastest", speed.value >= 0.5, speed,
                        note=f"3 deg, 3 mm, over 599 deg/s: {', '.join(survivors) or 'none'}"))  # fmt: skip
    count = len(MANY_STROKES)
    by_radius = slice(count, count + len(RADII))
    spread = number_of(sped, lambda c: float(np.ptp(rim_over_plate(c)[1:5]) / np.mean(rim_over_plate(c)[1:5])))
    across = number_of(
        sped, lambda c: float(np.ptp(rim_over_plate(c)[by_radius]) / np.mean(rim_over_plate(c)[by_radius]))
    )
    share = number_of(sped, lambda c: float(rim_over_plate(c)[2]))
    most = number_of(sped, lambda c: float(np.nanmax(rim_over_plate(c)[count + len(RADII) :])))
    ends = np.array(MANY_STROKES[-2:])
    more = number_of(sped, lambda c: float(np.divide(*(rim_over_plate(c)[count - 2 : count] * ends)[::-1])))
    first, late = (number_of(begun, partial(first_power, period=i)) for i in (0, FIRST_PERIODS - 1))
    return [
        *claims,
        Claim("the rim stays slower than the plate, B_p ω_p", share.value < 1, share, note="over it, 3 mm, 40 mm"),
        Claim(
            "no stranger's rim is faster than its plate by 5 % or more",
            most.value < 1.05,
            most,
            note=f"fastest of {STRANGERS} disks over it: A_p, ω_n, friction, B_p and damping at random",
        ),
        Claim("its share is the same for B_p = 1.5 to 6 mm, within 0.3 of it", spread.value <= 0.3, spread),
        Claim("it is the same for radii of 20 to 80 mm, within 0.3 of it", across.value <= 0.3, across),
        Claim(
            "a stroke of 18 mm turns the sheet further than one of 12 mm",
            more.value > 1,
            more,
            note="greatest turn per stride over the same; the plate's own speed is used best at 3 to 4.5 mm",
        ),
        Claim("the first period does not know B_p", first.value <= INDEPENDENT, first, note="power of its turn"),
        Claim(f"the {FIRST_PERIODS}th does", late.value > 0.5, late, note="power of its turn"),
    ]


def _table(measured: Measured) -> Table:
    spin = np.degrees(peaks(measured.means))
    rows = [
        (kind or "–", name, angle, *map(float, spin[i, j]), power(measured.means, name, angle))
        for i, (name, (kind, _)) in enumerate(CANDIDATES.items())
        for j, angle in enumerate(ANGLES)
    ]
    columns = ("kind", "candidate", "A_p, deg", *(f"deg/s at {1e3 * b:g} mm" for b in STROKES), "power of B_p")
    return Table("stroke", columns, tuple(rows))


def draw(found: Measured, sped: Measured, begun: Measured) -> Figure:
    """Powers of all candidates, the rim's speed over the plate's, and the turns of the first periods."""
    figure = new_figure(12, 4.4)
    left, middle, right = figure.subplots(1, 3, width_ratios=(5, 4, 4))
    names = list(CANDIDATES)
    for angle, colour, marker in zip(ANGLES, (BLUE, RED), "o^", strict=True):
        powers = [power(found.means, name, angle) for name in names]
        left.plot(powers, np.arange(len(names)), marker, ms=5, color=colour, label=f"A_p = {angle:g} deg")
    left.set_yticks(np.arange(len(names)), names, fontsize=7)
    left.invert_yaxis()
    left.axvspan(-INDEPENDENT, INDEPENDENT, color=GREY, alpha=0.2, lw=0)
    left.set_xlim(-0.4, 2)
    label_axes(left, "power of B_p that the spin rate goes with", "")
    left.legend(frameon=False, fontsize=8, loc="lower right")
    share = rim_over_plate(sped.means)
    middle.plot(
        np.array(MANY_STROKES) * 1e3, share[: len(MANY_STROKES)], "o-", ms=4, color=BLUE, label="over the stroke B_p"
    )
    middle.plot(
        np.array(RADII) * 1e3,
        share[len(MANY_STROKES) :][: len(RADII)],
        "^-",
        ms=4,
        color=GREEN,
        label="over the radius r",
    )
    middle.axhline(1, color=GREY, lw=0.8)
    middle.set_xscale("log")
    middle.set_ylim(0, 1.1)
    label_axes(middle, "B_p or r, mm", "speed of the rim over B_p ω_p")
    middle.legend(frameon=False, fontsize=8)
    for i, (stroke, colour) in enumerate(zip(STROKES, (GREEN, BLUE, RED), strict=True)):
        turns = [math.degrees(begun.means[f"turn_{k}"][i]) for k in range(FIRST_PERIODS)]
        right.plot(np.arange(1, FIRST_PERIODS + 1), turns, "o-", ms=4, color=colour, label=f"B_p = {1e3 * stroke:g} mm")
    label_axes(right, "plate period", "turn in it, deg")
    right.legend(frameon=False, fontsize=8)
    return figure
