"""The menu: motions that a controller chooses from, and how an object responds to them."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.stats import qmc

from plategait.arrays import Array, Flags
from plategait.control.drive import Drive
from plategait.control.response import DELAY, LONGEST, TAIL, Response, fitted, pulses, resting
from plategait.engine.engines import Engine
from plategait.errors import InputError
from plategait.model.machine import Machine, machine_of
from plategait.model.motion import PlateMotion
from plategait.model.presets import Preset, as_scenario
from plategait.model.scenario import Plate, Scenario
from plategait.optimize.symmetry import changes_sign
from plategait.simulation.run import check_whole

PLATE = 0.2
"""Length and width of the plate where the scenario has none, m."""
RAMP = 0.06
"""Time in which the plate goes over from one motion to the next, s."""
ACCELERATION = 20.0
"""Of a plate's sines, m/s²: harder ones are faster, but fold sheets and throw them off the edge now and then."""
GENERATIONS = 3
"""Of motions about the best ones."""
_FIRST, _CHILDREN = 192, 112
_STEP = 0.08
# Displacements over a pulse that weigh the same, m and rad; what goes elsewhere, and what is not sure, weighs so much.
_SCALE = np.array([0.02, 0.02, math.radians(40)])
_ASIDE, _UNSURE = 0.7, 0.7
# Where responses are weighed: on the bar and beside it, in shares of the reach.
_PLACES = (-0.75, 0.0, 0.75)
# What may remain unexplained where a pulse ends, m and rad.
_MOST_SPREAD = np.array([6e-3, 6e-3, math.radians(15)])
_DIRECTIONS = np.array([d for d in itertools.product((-1, 0, 1), repeat=3) if any(d)], dtype=float)
_DIRECTIONS /= np.linalg.norm(_DIRECTIONS, axis=1)[:, None]


@dataclass(frozen=True, eq=False)
class Menu:
    """Motions to choose from, the first a plate that stands, and the response to each.

    Attributes
    ----------
    scenario : Scenario
        The object, on its plate.
    drive : Drive
    motions : tuple of PlateMotion
    response : Response
    reach : float
        How far from the middle of the plate the responses were measured, each way, m.
    """

    scenario: Scenario
    drive: Drive
    motions: tuple[PlateMotion, ...]
    response: Response
    reach: float

    def __len__(self) -> int:
        """Return the number of motions."""
        return len(self.motions)


def on_a_plate(scenario: Scenario | Preset | Path | str) -> Scenario:
    """Scenario on a plate that ends, free to travel."""
    made = as_scenario(scenario, "scenario")
    return made.replace(slip_limit=1.0, plate=made.plate or Plate(length=PLATE, width=PLATE))


def room_of(scenario: Scenario) -> Array:
    """(2,) how far from the middle an object's centre may be, along the bar and across it, with all of it on the plate.

    Raises
    ------
    InputError
        For a plate that is too small for the object.
    """
    plate = scenario.plate or Plate(length=PLATE, width=PLATE)
    room = np.array([plate.length, plate.width]) / 2 - max(scenario.sheet.outline.size()) / 2
    if room.min() <= 5e-3:
        size = 1e3 * max(scenario.sheet.outline.size())
        raise InputError("plate", f"{1e3 * plate.length:g} mm by {1e3 * plate.width:g} mm",
                         f"larger than the object, {size:g} mm, by 10 mm at least",
                         f'"{size + 100:.0f} mm"')  # fmt: skip
    return room


def drive_of(placed: Scenario, machine: Machine) -> Drive:
    """What the motors of a machine can do with a plate while an object is steered on it."""
    return Drive(machine, placed.motion.replace(waves=(), samples=None), ramp=RAMP)


def menu_of(
    scenario: Scenario | Preset | Path | str = "cheese",
    machine: Machine | Path | str = "source-robot",
    *,
    acceleration: float | str = ACCELERATION,
    generations: int = GENERATIONS,
    seed: int = 0,
    engine: Engine = "cpu",
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> Menu:
    """Find motions that carry an object every way in short pulses, and how it responds to them.

    Motions spread over all that the machine can do, and generations about those that go farthest in each of 26
    directions on the bar and on both sides of it, with what goes elsewhere and what is not sure counted against them.

    Parameters
    ----------
    scenario : Scenario, or what tells one
        The object and its plate; 200 mm by 200 mm where it has none.
    machine : Machine, its name or file
    acceleration : float or str
        The most that sines may give the middle of the plate, and its surface 50 mm off the axis it turns about, m/s².
    generations : int
        Of motions about the best ones; fewer go less far.
    seed : int
    engine : {"cpu", "cpu64", "tiles"}
    threads : int, optional
    progress : callable, optional
        Called with the fraction done.

    Raises
    ------
    InputError
        For a plate that is too small, or where no motion moves the object without losing it.
    """
    check_whole("generations", generations, 0, 100)
    placed = on_a_plate(scenario)
    reach = float(min(0.75 * room_of(placed).min(), 0.2))
    drive = drive_of(placed, machine_of(machine), acceleration)
    still = drive.base.replace(angle=0.0, stroke=0.0)
    generator = np.random.default_rng(seed)
    shares = qmc.Sobol(len(drive), rng=np.random.default_rng(seed)).random_base2(8)[:_FIRST]
    tried, actions, response = 2 * shares - 1, np.zeros((0, len(drive))), resting(0)
    report = progress or (lambda _: None)
    best: Sequence[int] = ()
    for generation in range(generations + 1):
        made = [still, *drive.motions(tried)]
        run = pulses([placed], made, (LONGEST // 4, LONGEST), 4, 100 * seed + generation, reach,
                     engine=engine, threads=threads)  # fmt: skip
        actions, response = np.concatenate([actions, tried]), joined(response, fitted(run, len(made)), 1)
        best = _best(response, reach)
        if not len(best):
            raise InputError("machine", drive.machine.name, "one that moves the object without losing it",
                             "a larger plate, or a machine with smaller motions")  # fmt: skip
        report((generation + 1) / (generations + 2))
        tried = children(actions[list(best)], drive, generation == 0, generator)
    chosen = actions[list(best)]
    motions = (still, *drive.motions(chosen))
    last = pulses([placed], motions, (4, 8, 16, LONGEST), 6, 100 * seed + 99, reach, engine=engine, threads=threads)
    told = fitted(last, len(motions))
    sure = [0, *(i for i in range(1, len(motions)) if usable(told, 2.0)[i])]
    if len(sure) < 2:
        raise InputError("machine", drive.machine.name, "one whose motions the object follows", "a larger plate")
    report(1.0)
    return Menu(placed, drive, tuple(motions[i] for i in sure), told.of(sure), reach)


def usable(response: Response, times: float = 1.0) -> Flags:
    """(m,) motions that lose nothing, and that do what is expected, within so many times what is unsure at most."""
    return ~response.failed & (response.spread < times * _MOST_SPREAD).all(axis=1)


def joined(one: Response, other: Response, first: int = 0) -> Response:
    """Responses to the motions of one, and to those of another from one on."""
    return Response(*(np.concatenate([getattr(one, name), getattr(other, name)[first:]])
                      for name in ("rates", "lags", "spread", "failed")))  # fmt: skip


def displaced(response: Response, place: Array, ticks: int = LONGEST) -> Array:
    """(m, 3) displacement by a pulse of so many ticks, from rest at a place (x, y), m, to rest."""
    begin = np.array([1.0, *place, 0.0, 0.0, 0.0, 0.0])
    moved = np.linalg.matrix_power(response.maps, ticks) @ begin
    return (moved @ np.linalg.matrix_power(resting().maps[0], TAIL + DELAY).T)[:, 1:4] - begin[1:4]


def _best(response: Response, reach: float) -> Sequence[int]:
    """Motions that go farthest for sure in some direction from some place."""
    best: set[int] = set()
    unsure = _UNSURE * np.linalg.norm(response.spread / _SCALE, axis=1)
    allowed = usable(response)
    for place in _PLACES:
        moved = displaced(response, np.array([0.0, place * reach])) / _SCALE
        along = moved @ _DIRECTIONS.T
        aside = np.sqrt(np.maximum((moved**2).sum(axis=1)[:, None] - along**2, 0.0))
        merit = np.where(allowed[:, None], along - _ASIDE * aside - unsure[:, None], -np.inf)
        best.update(int(i) for i, most in zip(merit.argmax(axis=0), merit.max(axis=0), strict=True) if most > -np.inf)
    return sorted(best)


def children(parents: Array, drive: Drive, first: bool, generator: np.random.Generator) -> Array:
    """Actions about those of parents, the first time beside their mirror images."""
    names = ["sense" if name == "angle" else name for name in drive.names]
    signs = np.array([np.where(changes_sign(names, mirror), -1.0, 1.0) for mirror in (0, 1)])
    images = np.concatenate([parents * sign for sign in signs]) if first else np.zeros((0, len(drive)))
    count = max(_CHILDREN - len(images), _CHILDREN // 4)
    one, other = generator.integers(len(parents), size=(2, count))
    line = 0.2 * generator.standard_normal((count, 1)) * (parents[other] - parents[one])
    mutated = parents[one] + _STEP * generator.standard_normal((count, len(drive))) + line
    mirror = signs[generator.integers(2, size=count)]
    mutated = np.where(generator.random((count, 1)) < 0.25, mutated * mirror, mutated)
    return np.clip(np.concatenate([images, mutated]), -1.0, 1.0)
