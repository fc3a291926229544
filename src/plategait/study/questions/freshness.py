"""Freshness: whether films tell two batches of an ageing food apart, of which one is 20 % stiffer, and how surely."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array, Flags
from plategait.curve.curve import Curve
from plategait.errors import InputError
from plategait.estimate.any_size import estimate_any_size
from plategait.model.plain import plain_model
from plategait.model.scenario import Scenario
from plategait.study.catalogue import Question
from plategait.study.claims import Answer, Claim, Number, number_of, numbers_of
from plategait.study.measured import Columns, Measured
from plategait.study.questions.batches import Rule, learn_rule, separation, told_aged, told_apart, told_wrong
from plategait.study.questions.curves import CHEESE, FREQUENCIES, at_frequencies
from plategait.study.questions.freshness_figures import draw
from plategait.study.runs import Runs
from plategait.thesis.item import Table

if TYPE_CHECKING:
    from plategait.simulation.result import Simulation
    from plategait.vision.spin import Spin

SEED = 29
AGEING = 1.2
"""Stiffness of the aged batch over that of the fresh one."""
FRICTION = math.radians(2)
"""α of an object lies so far to either side of its batch's at most, that of a film half as far from its object's."""
SCATTER = {"stiffness": 0.06, "damping": 0.06, "mass": 0.02, "radius": 0.01}
"""Standard deviations of the logarithms within a batch; mass at the same size."""
ANGLES = {3: (16.0, 17.0, 18.0, 19.0, 20.0), 6: (12.0, 12.5, 13.0, 14.0, 15.0, 15.5, 16.0), 12: (9.0, 10.0, 11.0, 12.0)}
"""Plate frequencies on the rising side, Hz, by A_p in deg, at which it is asked what rates tell."""
ANGLE, FILMED = 6, (12.5, 14.0, 15.5)
"""A_p in deg and frequencies in Hz of an object's three films."""
ONE = 1
"""Which of them is taken where there is one film alone."""
SIZES = (1, 3, 10)
"""Objects of a batch that are filmed."""
LEARNT, TESTED, BENCH, FILMS_OF = 14, 60, 20, 1
"""Objects of a batch that the rule learns from, that it is tried on, that the any-size method reads, and that are
filmed to know how well films are read."""
ON = (-FRICTION, 0.0, FRICTION)
"""α of the three batches of each age that the rule learns from, less the cheese's: so it learns what friction does."""
SECONDS, FPS, PICTURE = 1.5, 30.0, (480, 270)
_RESAMPLED = 200
_STANDARD_95, _STANDARD_90 = 1.96, 1.645


def stiffer(scenario: Scenario, factor: float) -> Scenario:
    """The object with so many times its stiffness."""
    sheet = scenario.sheet
    return scenario.replace(**{"sheet.bending_stiffness": factor * sheet.bending_stiffness,
                               "sheet.torsion_stiffness": factor * sheet.torsion_stiffness})  # fmt: skip


def rougher(scenario: Scenario, more: float) -> Scenario:
    """The object with an α larger by so much, rad."""
    return scenario.replace(friction=scenario.friction.with_angle(scenario.friction.angle + more))


def batch(count: int, seed: int, stiffness: float = 1.0, alpha: float = 0.0) -> list[list[Scenario]]:
    """Objects of a batch, each as it lies in its `FILMED` films, of 6 deg.

    Parameters
    ----------
    count, seed : int
    stiffness : float
        The batch's over the cheese's.
    alpha : float
        The batch's less the cheese's, rad.
    """
    rng, objects = np.random.default_rng([SEED, seed]), []
    for _ in range(count):
        k, c, m, r = np.exp(rng.normal(size=4) * list(SCATTER.values())).tolist()
        lies, of_films = rng.uniform(-1, 1), rng.uniform(-1, 1, len(FILMED)) / 2
        sheet = CHEESE.sheet
        changed = stiffer(CHEESE, stiffness * k).replace(**{
            "sheet.outline.radius": r * sheet.outline.size()[0] / 2, "sheet.pitch": r * sheet.pitch,
            "sheet.mass": m * r * r * sheet.mass, "sheet.bending_damping": c * sheet.bending_damping,
            "motion.angle": math.radians(ANGLE),
        })  # fmt: skip
        objects.append([rougher(changed, alpha + FRICTION * (lies + own)).replace(**{"motion.frequency": f})
                        for f, own in zip(FILMED, of_films.tolist(), strict=True)])  # fmt: skip
    return objects


def marks(runs: Runs, repeats: int = 2) -> Measured:
    """Runs of the cheese, of one that is 20 % stiffer, and of one on a plate 2 deg rougher, at all of `ANGLES`."""
    scenarios = [s.replace(**{"motion.angle": math.radians(angle)}) for angle in ANGLES
                 for s in (CHEESE, stiffer(CHEESE, AGEING), rougher(CHEESE, FRICTION))]  # fmt: skip
    frequencies = [f for f in ANGLES.values() for _ in range(3)]
    points = [p for s, f in zip(scenarios, frequencies, strict=True) for p in at_frequencies([s], f)]
    return runs.measure(points, repeats=repeats, half_step=True)


def marks_of(columns: Columns) -> dict[int, Array]:
    """(2, frequencies) relative change of the rate by 20 % of stiffness and by 2 deg of α, by A_p in deg."""
    found, at = {}, 0
    for angle, frequencies in ANGLES.items():
        plain, stiff, rough = columns["spin_rate"][at : at + 3 * len(frequencies)].reshape(3, -1)
        found[angle] = np.array([stiff / plain - 1, rough / plain - 1])
        at += 3 * len(frequencies)
    return found


@dataclass(frozen=True)
class Film:
    """What a film of a run gave: its rate over that of the run, less 1, and half its 95 % interval over the rate."""

    error: float
    half: float


def film_of(scenario: Scenario, clip: Path, seed: int = 0, seconds: float = SECONDS) -> tuple[Simulation, Spin]:
    """Run an object, film it as a phone would, and track the film: the run, and the spin that the film tells.

    Parameters
    ----------
    scenario : Scenario
    clip : Path
        Film to write.
    seed : int
        Of the film's noise.
    seconds : float
        Length of the film, from when the run has settled.
    """
    from plategait.render.clip.appearance import Appearance
    from plategait.render.clip.clip import film, usual_camera
    from plategait.simulation.run import simulate
    from plategait.vision.setup import Setup
    from plategait.vision.track import track

    settle, motion = scenario.measured_from, scenario.motion
    run = simulate(scenario.replace(duration=settle + seconds + 0.05), snapshot_interval=motion.period / 24)
    camera = usual_camera(scenario, *PICTURE)
    film(run, clip, camera, FPS, Appearance(seed=seed), start=settle, seconds=seconds)
    return run, track(clip, Setup(plate_size=(0.12, 0.12), plate_frequency=motion.frequency)).spin


def read_film(scenario: Scenario, seed: int) -> dict[str, float]:
    """Film an object and compare with its run: the numbers of a `Film`."""
    with tempfile.TemporaryDirectory() as folder:
        run, spin = film_of(scenario, Path(folder) / "clip.mp4", seed)
    return {"error": spin.rate / run.spin_rate - 1, "half": (spin.high - spin.low) / 2 / abs(spin.rate)}


def films(runs: Runs, objects: Sequence[Sequence[Scenario]]) -> list[list[Film]]:
    """Films of each of the objects, each made once."""
    found = []
    for i, lain in enumerate(objects):
        what = [{"film": plain_model(s), "seconds": SECONDS, "fps": FPS, "picture": PICTURE, "seed": i} for s in lain]
        found.append([Film(**runs.once(w, lambda s=s, i=i: read_film(s, i), 150.0))
                      for w, s in zip(what, lain, strict=True)])  # fmt: skip
    return found


def reading_errors(read: Sequence[Sequence[Film]]) -> tuple[Array, Array]:
    """(films,) standard deviation of a reading over the rate, as the films' intervals tell it, and as it came out."""
    halves, errors = (np.array([[getattr(f, name) for f in lain] for lain in read]) for name in ("half", "error"))
    return np.sqrt(np.mean(halves**2, axis=0)) / _STANDARD_95, np.sqrt(np.mean(errors**2, axis=0))


@dataclass(frozen=True, eq=False)
class Population:
    """Objects whose batch is known: some to learn from, others to be told.

    Attributes
    ----------
    measured : Measured
        A point for each film, in the order of `known_and_unknown`.
    learnt, tested : int
        Objects of each age that the rule learns from, and of each batch that it is tried on.
    sds : (films,) array
        Standard deviation of a reading over the rate.
    """

    measured: Measured
    learnt: int
    tested: int
    sds: Array

    def rates(self, columns: Columns, films: Sequence[int]) -> list[Array]:
        """Logarithms of the rates as films are read: fresh and aged to learn from; fresh, aged and rough to tell."""
        rate = columns["spin_rate"].reshape(-1, len(FILMED))
        read = np.random.default_rng(SEED).normal(size=rate.shape) * self.sds
        seen = (np.log(np.abs(rate)) + read)[:, list(films)]
        ends = np.cumsum([self.learnt, self.learnt, self.tested, self.tested])
        return [some[np.isfinite(some).all(axis=1)] for some in np.split(seen, ends)]


def known_and_unknown(learnt: int = LEARNT, tested: int = TESTED) -> list[Scenario]:
    """Films of a `Population`: fresh and aged objects on three frictions; then fresh, aged, 2 deg rougher."""
    known = [lain for seed, age in ((10, 1.0), (20, AGEING)) for i, alpha in enumerate(ON)
             for lain in batch(learnt, seed + i, age, alpha)]  # fmt: skip
    unknown = [*batch(tested, 3), *batch(tested, 4, AGEING), *batch(tested, 5, alpha=FRICTION)]
    return [s for lain in (*known, *unknown) for s in lain]


def errors_of(rates: Sequence[Array]) -> dict[str, float]:
    """How often the rule is wrong, by what and the number of objects; see `Population.rates`."""
    rule: Rule = learn_rule(rates[0], rates[1])
    fresh, aged, rough = (rule.scores(some) for some in rates[2:])
    found = {"separation": separation(fresh, aged)}
    for n in SIZES:
        found |= {f"wrong {n}": told_wrong(fresh, aged, n), f"missed {n}": 1 - told_aged(fresh, aged, n),
                  f"alike {n}": told_apart(fresh, fresh, n),
                  f"friction {n}": told_apart(fresh, rough, n)}  # fmt: skip
    return found


def over_objects(rates: Sequence[Array]) -> dict[str, tuple[float, float]]:
    """95 % interval of each of `errors_of` over the objects that might have been drawn, by bootstrap."""
    rng = np.random.default_rng(SEED)
    drawn = [errors_of([r[rng.integers(len(r), size=len(r))] for r in rates]) for _ in range(_RESAMPLED)]
    ends = {name: np.percentile([d[name] for d in drawn], (2.5, 97.5)) for name in drawn[0]}
    return {name: (float(low), float(high)) for name, (low, high) in ends.items()}


@dataclass(frozen=True, eq=False)
class Told:
    """Error rates with some of the films: each a number with the errors of its runs, and its interval over objects."""

    numbers: dict[str, Number]
    intervals: dict[str, tuple[float, float]]


def told_by(found: Population, films: Sequence[int]) -> Told:
    """Error rates where an object is filmed under some of `FILMED` alone."""
    numbers = numbers_of(found.measured, lambda columns: errors_of(found.rates(columns, films)))
    return Told(numbers, over_objects(found.rates(found.measured.means, films)))


def bench(runs: Runs, count: int, sd: float) -> Array:
    """(2, count, 2) logarithm of ω_n by the any-size method over the fresh batch's mean, and its sd; NaN if refused.

    Each of fresh and of aged objects has a whole spin curve at 3 deg, read as well as the films.
    """
    objects = [lain[ONE].replace(**{"motion.angle": math.radians(3)})
               for lain in (*batch(count, 3), *batch(count, 4, AGEING))]  # fmt: skip
    rates = runs.measure(at_frequencies(objects), repeats=1).means
    rng, n, rows = np.random.default_rng(SEED), len(FREQUENCIES), []
    for i, scenario in enumerate(objects):
        rate = np.degrees(rates["spin_rate"][n * i : n * i + n]) * (1 + sd * rng.normal(size=n))
        off = tuple("slipped" if f else "" for f in rates["failed"][n * i : n * i + n])
        curve = Curve(f"object {i}", np.array(FREQUENCIES), rate, sd * np.abs(rate), ("",) * n, off)
        try:
            told = estimate_any_size(curve, scenario)
        except InputError:
            rows.append((math.nan, math.nan))
            continue
        omega = told.natural_frequency
        rows.append((math.log(omega / CHEESE.sheet.natural_frequency), told.natural_frequency_sd / omega))
    return np.array(rows).reshape(2, count, 2)


def excluded(told: Array) -> float:
    """Share of objects whose 90 % interval of ω_n excludes the other batch's mean, of those that have one."""
    means = np.array([[0.5 * math.log(AGEING)], [0.0]])
    usable: Flags = np.isfinite(told[..., 0])
    return float(np.mean((np.abs(told[..., 0] - means) > _STANDARD_90 * told[..., 1])[usable]))


def claims_of(
    scan: Measured, read: Sequence[Sequence[Film]], one: Told, three: Told, best: Told, told: Array
) -> tuple[Claim, ...]:
    """What is claimed of what rates tell, of films, of error rates, and of the any-size method where it was asked."""

    def weight(angle: int, frequency: float) -> Callable[[Columns], float]:
        i = ANGLES[angle].index(frequency)
        return lambda c: float(abs(marks_of(c)[angle][1, i] / marks_of(c)[angle][0, i]))

    sds, errors = reading_errors(read)
    low, high = (number_of(scan, weight(ANGLE, f)) for f in (FILMED[0], FILMED[ONE]))

    def share(text: str, told: Told, name: str, bound: float, more: bool = False, note: str = "") -> Claim:
        number = told.numbers[name]
        return Claim(text, number.value > bound if more else number.value < bound, number, note=note,
                     interval=told.intervals[name])  # fmt: skip

    usable: Flags = np.isfinite(told[..., 0])
    apart = separation(*(told[i, usable[i], 0] for i in (0, 1)))
    better = "with films read as well as they came out, not as their intervals tell"
    return (
        Claim(f"at {ANGLE} deg and {FILMED[ONE]:g} Hz, 2 deg of friction change the rate by less than half of what 20 "
              "% of stiffness do", high.value < 0.5, high),
        Claim(f"at {FILMED[0]:g} Hz by more than they do", low.value > 1, low),
        Claim(f"a film of {SECONDS:g} s at {FPS:g} frames a second is read to 1 % (1 s.d. by its own interval)",
              float(sds.max()) < 0.01, Number(float(sds.max())),
              note=f"r.m.s. error over {len(read)} objects {100 * errors.max():.2g} % at most"),
        share("one film of one object does not tell: wrong in more than a fifth", one, "wrong 1", 0.2, more=True),
        share("nor do three films of one: in more than a tenth", three, "wrong 1", 0.1, more=True),
        share("ten objects, three films each, are told wrong in less than a tenth", three, "wrong 10", 0.1),
        share("of two batches, ten objects of each, the aged one is missed in less than a quarter", three, "missed 10",
              0.25),
        share("two batches that do not differ, ten objects of each, are said to differ in less than 10 %", three,
              "alike 10", 0.1),
        share(f"{better}, they are in less than 10 %", best, "alike 10", 0.1),
        share("two batches that differ by 2 deg of friction alone, ten objects of each: in less than 20 %", three,
              "friction 10", 0.2),
        share(f"{better}, those are in less than 20 %", best, "friction 10", 0.2),
        Claim("the any-size method's 90 % interval of ω_n, from a whole curve, excludes the other batch in less than a "
              "tenth of objects", excluded(told) < 0.1, Number(excluded(told)),
              note=f"{int(usable.sum())} of {usable.size} curves read; its medians are {apart:.2g} s.d. apart"),
    )  # fmt: skip


def answer(runs: Runs, question: Question) -> Answer:
    """Answer the question."""
    read = films(runs, [*batch(FILMS_OF, 3), *batch(FILMS_OF, 4, AGEING)])
    scan, (sds, errors) = marks(runs), reading_errors(read)
    measured = runs.measure(known_and_unknown(), repeats=2, half_step=True)
    found, better = (Population(measured, len(ON) * LEARNT, TESTED, doubt) for doubt in (sds, errors))
    one, three, best = told_by(found, [ONE]), told_by(found, range(len(FILMED))), told_by(better, range(len(FILMED)))
    claims = claims_of(scan, read, one, three, best, bench(runs, BENCH, float(sds[ONE])))
    n = {name: f"{100 * number.value:.1f} %" for name, number in three.numbers.items()}
    verdict = (
        "Films tell a batch that is 20 % stiffer where several objects are filmed where friction counts least "
        f"({ANGLE} deg, {FILMED[ONE]:g} Hz and beside it): one object is told wrong in {n['wrong 1']}, three in "
        f"{n['wrong 3']}, ten in {n['wrong 10']}; of two batches, ten objects of each, the aged one is missed in "
        f"{n['missed 10']}, alike ones are said to differ in {n['alike 10']}, ones of unlike friction in "
        f"{n['friction 10']}. An estimate of ω_n of each does not tell it."
    )
    notes = (
        "20 % of stiffness change a rate by a percent or two, as the bending is mostly viscous; 1 % of radius and 2 "
        "deg of friction do as much at most frequencies. So it is the choice of motion, a rule that knows how objects "
        "scatter, and their number that tell, not a model of each.",
        "Intervals are over the objects, by bootstrap, those that the rule learns from included.",
    )
    tables = (_error_table({"one film": one, "three films": three, "three films, read as well as they came out": best}),
              _film_table(read), _mark_table(scan))  # fmt: skip
    figure = draw(ANGLES, marks_of(scan.means), (ANGLE, FILMED), found.rates(found.measured.means, range(len(FILMED))),
                  SIZES)  # fmt: skip
    return Answer(question.name, question.asks, verdict, claims, tables, (("freshness", figure),), notes)


def _error_table(by: dict[str, Told]) -> Table:
    rows = [(films, name, told.numbers[name].value, *told.intervals[name], told.numbers[name].step_error,
             told.numbers[name].ensemble_error) for films, told in by.items() for name in told.numbers]  # fmt: skip
    columns = ("films of an object", "share of, objects of a batch", "value", "2.5 %", "97.5 %", "half step",
               "± (starts)")  # fmt: skip
    return Table("freshness-errors", columns, tuple(rows))


def _film_table(read: Sequence[Sequence[Film]]) -> Table:
    rows = [(i + 1, f, 100 * film.error, 100 * film.half)
            for i, lain in enumerate(read) for f, film in zip(FILMED, lain, strict=True)]  # fmt: skip
    return Table("freshness-films", ("object", "f, Hz", "error, %", "half of the 95 % interval, %"), tuple(rows))


def _mark_table(scan: Measured) -> Table:
    rows = [(angle, f, 100 * float(stiff), 100 * float(rough)) for angle, changes in marks_of(scan.means).items()
            for f, stiff, rough in zip(ANGLES[angle], *changes, strict=True)]  # fmt: skip
    return Table("freshness-marks", ("A_p, deg", "f, Hz", "by 20 % of stiffness, %", "by 2 deg of α, %"), tuple(rows))
