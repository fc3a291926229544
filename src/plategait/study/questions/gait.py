"""Gait: where sliding, walking and running begin, and what of it a rigid object does too."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.model.outline import Disk, Ellipse, Mask, Rectangle
from plategait.model.presets import preset
from plategait.model.scenario import Scenario
from plategait.simulation.expectation import expect
from plategait.simulation.stride import stride_row
from plategait.study.catalogue import Question
from plategait.study.claims import Answer, Claim, number_of
from plategait.study.measured import Columns, Measured
from plategait.study.questions import gait_figures
from plategait.study.runs import Runs
from plategait.thesis.item import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

GAMMAS = (*np.arange(1.75, 6.0, 0.25).tolist(), *np.arange(6.0, 9.01, 0.5).tolist())
"""Γ = r A_p ω_p²/g at the rim, of every boundary."""
CHEESES = ((1.5, 10.0), (3.0, 3.5), (3.0, 10.0), (3.0, 33.0), (6.0, 10.0), (12.0, 10.0))
"""A_p in deg and ω_n in π rad/s."""
STRANGERS, SHAPES = 32, 8
SEED = 11
"""Of the strangers: not that of the sheets which the laws were fitted to."""
BODIES = ("soft", "rigid", "three legs")
BODY_ANGLES = (3.0, 12.0)
BODY_GAMMAS = tuple(np.arange(1.5, 6.01, 0.25).tolist())
_TRIPOD = (*(5 * ("...##...",)), "########", "########")
# A leg lifts, and nothing touches, for longer than this share of the stride: as gaits are told.
_STRIDE = 0.01


def at_gamma(scenario: Scenario, gamma: float) -> Scenario:
    """Scenario whose plate's frequency gives Γ under the rim, for twelve periods and 1.2 s at least."""
    at_1_hz = expect(scenario.replace(**{"motion.frequency": 1.0}))
    assert at_1_hz is not None
    frequency = math.sqrt(gamma / at_1_hz.gamma)
    return scenario.replace(**{"motion.frequency": frequency, "duration": max(1.2, 12 / frequency),
                               "slip_limit": scenario.sheet.outline.size()[1] / 4})  # fmt: skip


def cheese(angle: float, omega: float = 10.0) -> Scenario:
    """The cheese at A_p in deg, with ω_n in π rad/s."""
    base = preset("cheese").scenario
    return base.replace(**{"sheet": base.sheet.with_natural_frequency(omega * math.pi),
                           "motion.angle": math.radians(angle)})  # fmt: skip


def strangers(count: int, seed: int = SEED) -> list[Scenario]:
    """Disks: A_p 1.5 to 12 deg, ω_n 3.5π to 60π, α 12 to 60 deg, B_p 1 to 6 mm, c_b from 1 to 25 times the least."""
    from scipy.stats import qmc

    base, found = preset("cheese").scenario, []
    for u in qmc.LatinHypercube(5, rng=seed).random(count):
        sheet = base.sheet.with_natural_frequency(math.pi * 3.5 * (60 / 3.5) ** u[1])
        found.append(base.replace(**{
            "sheet": sheet.replace(bending_damping=2.42e-7 * 25 ** u[4]),
            "friction": base.friction.with_angle(math.radians(12 + 48 * u[2])),
            "motion.angle": math.radians(1.5 * 8 ** u[0]), "motion.stroke": 1e-3 * 6 ** u[3],
        }))  # fmt: skip
    return found


def other_shapes(count: int, seed: int = SEED) -> list[Scenario]:
    """Disks, ellipses and rectangles 25 to 120 mm wide across the bar, eight nodes each, otherwise as `strangers`."""
    generator, found = np.random.default_rng(seed), []
    for i, base in enumerate(strangers(count, seed + 1)):
        width, ratio = 0.025 * 4.8 ** generator.random(), 1 + generator.random()
        outline = (Disk(radius=width / 2), Ellipse(length=ratio * width, width=width),
                   Rectangle(length=ratio * width, width=width))[i % 3]  # fmt: skip
        sheet = base.sheet.replace(outline=outline, pitch=width / 8)
        scale = (width / 0.08) ** 2
        mass = base.sheet.node_mass * sheet.lattice.n_nodes * scale
        sheet = sheet.replace(mass=mass).with_natural_frequency(base.sheet.natural_frequency)
        loss = base.sheet.bending_damping / base.sheet.bending_stiffness
        sheet = sheet.replace(bending_damping=loss * sheet.bending_stiffness)
        found.append(base.replace(**{"sheet": sheet, "motion.stroke": base.motion.stroke * width / 0.08}))
    return found


def body(name: str, angle: float) -> Scenario:
    """The cheese, its rigid twin (ω_n = 320π), or a rigid T that stands on three arms."""
    base = cheese(angle)
    rigid = base.sheet.with_natural_frequency(320 * math.pi)
    stiff = rigid.bending_stiffness
    if name == "rigid":
        return base.replace(sheet=rigid)
    if name == "three legs":
        legs = Mask(rows=_TRIPOD, width_of_picture=0.08)
        sheet = rigid.replace(outline=legs, mass=rigid.mass / 2, bending_stiffness=stiff, torsion_stiffness=stiff)
        return base.replace(sheet=sheet)
    return base


def boundaries(runs: Runs, scenarios: list[Scenario], repeats: int, half_step: bool) -> Measured:
    """Strides of every scenario at every Γ of `GAMMAS`: points by scenario, then by Γ."""
    points = [at_gamma(scenario, gamma) for scenario in scenarios for gamma in GAMMAS]
    return runs.measure(points, repeats=repeats, half_step=half_step, measure=stride_row)


def crossing(gammas: Array, values: Array, threshold: float) -> float:
    """Γ at which a number first comes to a threshold, interpolated; NaN where it does not before it is unknown."""
    beyond = np.sign(values - threshold) * np.sign(values[0] - threshold)
    for i in range(1, len(gammas)):
        if not math.isfinite(values[i]):
            return math.nan
        if beyond[i] <= 0:
            share = (threshold - values[i - 1]) / (values[i] - values[i - 1])
            return float(gammas[i - 1] + (gammas[i] - gammas[i - 1]) * share)
    return math.nan


def ends(columns: Columns, name: str) -> Array:
    """(scenarios,) Γ at which sliding ends ("duty") or running begins ("flight")."""
    threshold = 1 - _STRIDE if name == "duty" else _STRIDE
    return np.array([crossing(np.array(GAMMAS), row, threshold) for row in columns[name].reshape(-1, len(GAMMAS))])


def run_offs(columns: Columns) -> Array:
    """(scenarios,) lowest Γ from which on at least half of the starts fail at two in a row."""
    failed = columns["failed"].reshape(-1, len(GAMMAS)) >= 0.5
    twice = failed[:, :-1] & failed[:, 1:]
    return np.where(twice.any(axis=1), np.array(GAMMAS)[np.argmax(twice, axis=1)], math.nan)


def law(scenarios: list[Scenario], gammas: Array, name: str) -> Array:
    """(scenarios,) where `plategait.simulation.expectation` has a change of gait; Λ is taken where it was found.

    Where it was not found, Λ is that at Γ = 5.
    """
    told = [expect(at_gamma(s, g if math.isfinite(g) else 5.0)) for s, g in zip(scenarios, gammas, strict=True)]
    return np.array([math.nan if each is None else getattr(each, name) for each in told])


def scatter(found: Array, expected: Array | float = 1.0) -> float:
    """Standard deviation of the logarithm of what was found over what was expected."""
    return float(np.nanstd(np.log(found / expected)))


def answer(runs: Runs, question: Question) -> Answer:
    """Answer the question."""
    cheeses = boundaries(runs, [cheese(*c) for c in CHEESES], 2, True)
    disks, shapes = strangers(STRANGERS), other_shapes(SHAPES)
    found = boundaries(runs, [*disks, *shapes], 1, True)
    bodies = runs.measure(
        [at_gamma(body(name, a), g) for a in BODY_ANGLES for name in BODIES for g in BODY_GAMMAS],
        repeats=2, half_step=True, measure=stride_row,
    )  # fmt: skip
    claims = (*cheese_claims(cheeses), *collapse_claims(found, disks, shapes), *body_claims(bodies))
    gain, walker = (next(c.number.value for c in claims if s in c.claim) for s in ("twice as far", "pendulum's"))
    verdict = (
        "That two legs step in turn is appearance: the plate imposes it on a rigid disk and a T with three arms too. "
        "When they lift is a ball's matter, of Γ at the rim: 3π/4 for a rigid disk, a quarter more for each unit of "
        f"softness. Gait is what only the soft one makes of it: {gain:.1f} times the rigid one's turn with each stride "
        f"at Γ = 3, and at 12 deg a walk in which energies give each other {100 * walker:.0f} % of their work."
    )
    figures = (
        ("gait", draw_collapse(found.means, disks, shapes)),
        ("gait-bodies", draw_bodies(bodies.means)),
    )
    tables = (boundary_table(found, disks, shapes), body_table(bodies))
    return Answer(question.name, question.asks, verdict, claims, tables, figures, _NOTES)


_NOTES = (
    "Gait: how far a stride turns the object, and what it costs. Ball: when the legs lift, which follows from Γ and "
    "the inertia of half an object, and that running has no spring in it. Appearance: that two legs step in turn, "
    "which a rigid disk and a T with three arms do as well, as the plate tilts about the bar.",
    "Γ is r A_p ω_p²/g with r the rim's distance from the bar; a leg is half of the object on one side of it. Sliding "
    "ends where the legs' duty factor falls below 0.99, running begins where nothing touches for 0.01 of the stride.",
    "Softness is Λ = (ω/ω_n)/(1 + (ω c_b/k_b)²)^¼. The laws' constants were fitted to 64 other disks.",
)


def cheese_claims(measured: Measured) -> list[Claim]:
    """Whether the cheese stops sliding at one Γ, as was seen before."""
    usual = [i for i, (angle, _) in enumerate(CHEESES) if angle < 12]

    def spread(columns: Columns) -> float:
        gammas = ends(columns, "duty")[usual]
        return float(np.max(np.abs(gammas / np.median(gammas) - 1)))

    def wide(columns: Columns) -> float:
        gammas = ends(columns, "duty")
        return float(gammas[-1] / np.median(gammas[usual]))

    one, less = number_of(measured, spread), number_of(measured, wide)
    middle = number_of(measured, lambda c: float(np.median(ends(c, "duty")[usual])))
    return [
        Claim("the cheese stops sliding within 20 % of one Γ for A_p = 1.5 to 6 deg and ω_n = 3.5π to 33π",
              one.value <= 0.2, one, note=f"about Γ = {middle.value:.2f}"),
        Claim("at A_p = 12 deg it stops at 0.85 of that Γ or sooner", less.value <= 0.85, less),
    ]  # fmt: skip


def collapse_claims(measured: Measured, disks: list[Scenario], shapes: list[Scenario]) -> list[Claim]:
    """Whether Γ alone, or Γ with the softness, says where gaits change, on sheets that nothing was fitted to."""
    n = len(disks)

    def left(name: str, row: str, scenarios: list[Scenario], which: slice, lawful: bool) -> Callable[[Columns], float]:
        def value(columns: Columns) -> float:
            found = ends(columns, row)[which]
            return scatter(found, law(scenarios, found, name) if lawful else 1.0)

        return value

    first, rest = slice(0, n), slice(n, None)
    alone = number_of(measured, left("sliding_ends", "duty", disks, first, False))
    with_law = number_of(measured, left("sliding_ends", "duty", disks, first, True))
    other = number_of(measured, left("sliding_ends", "duty", shapes, rest, True))
    running = number_of(measured, left("running_begins", "flight", disks, first, True))

    def power(columns: Columns, of: Callable[[Scenario], float]) -> float:
        found = ends(columns, "duty")[:n]
        rest = np.log(found / law(disks, found, "sliding_ends"))
        there = np.isfinite(rest)
        return float(np.polyfit(np.log([of(s) for s in disks])[there], rest[there], 1)[0])

    off = number_of(measured, lambda c: scatter(run_offs(c), law([*disks, *shapes], run_offs(c), "runs_off")))
    friction = number_of(measured, partial(power, of=lambda s: s.friction.static))
    stroke = number_of(measured, partial(power, of=lambda s: s.motion.stroke))
    return [
        Claim("over stiffness, damping, friction and stroke Γ alone says within 25 % (s.d.) where sliding ends",
              alone.value <= 0.25, alone, note=f"{n} disks"),
        Claim("Γ_s = 3π/4 (1 + Λ/4) says so within 25 %", with_law.value <= 0.25, with_law, note=f"{n} disks"),
        Claim("it says so within 25 % for other shapes and sizes", other.value <= 0.25, other,
              note=f"{len(shapes)} disks, ellipses and rectangles, 25 to 120 mm wide"),
        Claim("Γ_r = 4.8 Λ^0.4 says within 25 % where running begins", running.value <= 0.25, running,
              note="of those that run before they run off"),
        Claim("1.09 (B_p/r)^-0.29 over the rigid limit says within 30 % where sheets run off", off.value <= 0.3, off,
              note="slipped a quarter of their width, of those that do below Γ = 9"),
        Claim("friction does not move the end of sliding: its power of μ is within 0.2", abs(friction.value) <= 0.2,
              friction),
        Claim("the stroke hardly moves it: its power of B_p is within 0.2", abs(stroke.value) <= 0.2, stroke),
    ]  # fmt: skip


def of_body(columns: Columns, name: str, angle: float, which: str) -> Array:
    """(Γ,) a number of one body at one A_p."""
    block = BODY_ANGLES.index(angle) * len(BODIES) + BODIES.index(name)
    return columns[which].reshape(-1, len(BODY_GAMMAS))[block]


def body_claims(measured: Measured) -> list[Claim]:
    """What a rigid disk and a T on three arms do at the same Γ, and what the soft disk alone does."""
    gammas = np.array(BODY_GAMMAS)

    def phase(columns: Columns) -> float:
        told = [of_body(columns, name, a, "leg_phase")[gammas <= 3.5] for name in BODIES[1:] for a in BODY_ANGLES]
        return float(np.nanmax(np.abs(np.concatenate(told) - 0.5)))

    def lift(columns: Columns) -> float:
        return crossing(gammas, of_body(columns, "rigid", 3.0, "duty"), 1 - _STRIDE) / (0.75 * math.pi)

    def at(name: str, angle: float, which: str, gamma: float) -> Callable[[Columns], float]:
        return lambda c: float(of_body(c, name, angle, which)[BODY_GAMMAS.index(gamma)])

    def walking(columns: Columns, name: str, which: str) -> float:
        walks = (of_body(columns, name, 12.0, "duty") < 1 - _STRIDE) & (of_body(columns, name, 12.0, "flight") < 0.01)
        return float(np.nanmax(np.where(walks, of_body(columns, name, 12.0, which), math.nan)))

    def cheapest(columns: Columns) -> float:
        cost = of_body(columns, "soft", 12.0, "cost")
        return float(gammas[np.nanargmin(cost)] - crossing(gammas, of_body(columns, "soft", 12.0, "duty"), 0.99))

    alternate, edge = number_of(measured, phase), number_of(measured, lift)
    gain = number_of(measured, lambda c: at("soft", 3.0, "turn", 3.0)(c) / at("rigid", 3.0, "turn", 3.0)(c))
    idle = number_of(measured, lambda c: at("rigid", 3.0, "turn", 3.0)(c) / at("rigid", 3.0, "turn", 2.0)(c))
    soft, rigid = (number_of(measured, partial(walking, name=n, which="pendulum")) for n in ("soft", "rigid"))
    spring = number_of(measured, at("soft", 12.0, "spring", 5.5))
    cost = number_of(measured, cheapest)
    froude = number_of(measured, lambda c: float(np.nanmax(of_body(c, "soft", 3.0, "froude"))))
    return [
        Claim("the legs of rigid bodies alternate, half a stride apart within 0.15", alternate.value <= 0.15,
              alternate, note="rigid disk and T on three arms up to Γ = 3.5: appearance"),
        Claim("a rigid disk lifts half of itself at Γ = 3π/4 within 20 %", abs(edge.value - 1) <= 0.2, edge,
              note="over the closed form: ball"),
        Claim("a rigid disk that walks (Γ = 3) turns at most 1.25 times as far a stride as one that slides (Γ = 2)",
              idle.value <= 1.25, idle, note="ratio, at 3 deg"),
        Claim("the soft disk turns at least twice as far with a stride at Γ = 3", gain.value >= 2, gain,
              note="over the rigid one, at 3 deg: gait"),
        Claim("walking at 12 deg is a pendulum's: kinetic and potential energy give each other half of their work",
              soft.value >= 0.5, soft, note="best of the walking Γ; 0.65 in people"),
        Claim("a rigid disk that walks is none: below 0.3", rigid.value < 0.3, rigid, note="the same"),
        Claim("running is a spring's: bending gives back 30 % of the work on all energies", spring.value >= 0.3,
              spring, note="12 deg, Γ = 5.5"),
        Claim("transport is cheapest in walking", cost.value >= 0, cost, note="Γ of the least cost less Γ_s, 12 deg"),
        Claim("the rim stays below a Froude number of 0.5, at which people begin to run", froude.value < 0.5, froude,
              note="3 deg"),
    ]  # fmt: skip


def draw_collapse(columns: Columns, disks: list[Scenario], shapes: list[Scenario]) -> Figure:
    """Where gaits change over the softness, and against the laws."""
    scenarios = [*disks, *shapes]
    found = ends(columns, "duty"), ends(columns, "flight"), run_offs(columns)
    told, soft = [], []
    rigid = law(scenarios, found[0], "rigid_limit")
    for gammas, name in zip(found, ("sliding_ends", "running_begins", "runs_off"), strict=True):
        told.append(law(scenarios, gammas, name) / rigid)
        soft.append(law(scenarios, gammas, "softness"))
    one, two, three = (gammas / rigid for gammas in found)
    disk = np.arange(len(scenarios)) < len(disks)
    return gait_figures.collapse((one, two, three), (told[0], told[1], told[2]), (soft[0], soft[1], soft[2]), disk)


def draw_bodies(columns: Columns) -> Figure:
    """Strides of the three bodies over Γ."""
    wanted = {"turn per stride, deg": "turn", "duty factor": "duty", "phase of the legs": "leg_phase",
              "pendulum recovery": "pendulum", "cost of transport": "cost"}  # fmt: skip
    numbers = {
        title: {
            (name, angle): of_body(columns, name, angle, which) * (180 / math.pi if which == "turn" else 1)
            for angle in BODY_ANGLES
            for name in BODIES
        }
        for title, which in wanted.items()
    }
    return gait_figures.bodies(np.array(BODY_GAMMAS), numbers)


def boundary_table(measured: Measured, disks: list[Scenario], shapes: list[Scenario]) -> Table:
    """Every stranger with where its gaits change, and where the laws have it."""
    slide, run, off = ends(measured.means, "duty"), ends(measured.means, "flight"), run_offs(measured.means)
    scenarios = [*disks, *shapes]
    told = law(scenarios, slide, "sliding_ends"), law(scenarios, run, "running_begins")
    rows = []
    for i, s in enumerate(scenarios):
        rows.append((
            s.sheet.outline.shape, 1e3 * s.sheet.outline.size()[1], math.degrees(s.motion.angle),
            s.sheet.natural_frequency / math.pi, s.friction.static, 1e3 * s.motion.stroke,
            1e6 * s.sheet.bending_damping, float(slide[i]), float(told[0][i]), float(run[i]), float(told[1][i]),
            float(off[i]),
        ))  # fmt: skip
    columns = ("shape", "width, mm", "A_p, deg", "ω_n, π rad/s", "μ_s", "B_p, mm", "c_b, µN m s/rad", "sliding ends, Γ",
               "by the law", "running begins, Γ", "by the law, Γ", "run-off, Γ")  # fmt: skip
    return Table("gait-boundaries", columns, tuple(rows))


def body_table(measured: Measured) -> Table:
    """Strides of the soft disk, its rigid twin and the T at the same Γ."""
    names = ("duty", "flight", "leg_phase", "pendulum", "spring", "bent", "cost", "froude", "failed")
    rows = []
    for angle in BODY_ANGLES:
        for name in BODIES:
            for i, gamma in enumerate(BODY_GAMMAS):
                row = [float(of_body(measured.means, name, angle, which)[i]) for which in names]
                turn = math.degrees(of_body(measured.means, name, angle, "turn")[i])
                rows.append((name, angle, gamma, turn, *row))
    columns = ("body", "A_p, deg", "Γ", "turn per stride, deg", "duty factor", "flight", "phase of the legs",
               "pendulum", "spring", "bending's share", "cost of transport", "Froude number", "failed")  # fmt: skip
    return Table("gait-bodies", columns, tuple(rows))
