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
from plategait.control.identify import fitted, pulses
from plategait.control.response import ACROSS, ANYHOW, LONGEST, Field, Response, resting
from plategait.control.room import MARGIN, on_a_plate, room_of
from plategait.engine.engines import Engine
from plategait.errors import InputError
from plategait.model.machine import Machine, machine_of
from plategait.model.motion import PlateMotion
from plategait.model.presets import Preset
from plategait.model.scenario import Scenario
from plategait.optimize.symmetry import changes_sign
from plategait.simulation.run import check_whole

RAMP = 0.06
"""Time in which the plate goes over from one motion to the next, s."""
ACCELERATION = 30.0
"""Of a plate's sines, m/s²: harder ones are faster, but fold sheets and throw them off the edge now and then."""
GENERATIONS = 3
"""Of motions about the best ones."""
_ALONG_THE_BAR = ("frequency", "angle", "stroke", "phase", "offset")
_FIRST, _CHILDREN = 192, 112
_STEP = 0.08
# Displacements over a pulse that weigh the same, m and rad; what goes elsewhere, and what is not sure, weighs so much.
_SCALE = np.array([0.02, 0.02, math.radians(40)])
_ASIDE, _UNSURE = 0.7, 0.7
# Ways that motions are chosen for: ticks, the scale, and how far at most, in it; what does nothing is not chosen.
_WAYS = ((LONGEST, _SCALE, 1e9), (9, _SCALE / 5, 1.0))
_LEAST = 0.15
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
    actions : (m, d) array
        Actions of the drive that stand for them; of the first, zeros.
    response : Response
    reach : float
        How far from the middle of the plate the responses were measured, each way, m.
    """

    scenario: Scenario
    drive: Drive
    motions: tuple[PlateMotion, ...]
    actions: Array
    response: Response
    reach: float

    def __len__(self) -> int:
        """Return the number of motions."""
        return len(self.motions)

    def raised(self, height: float) -> tuple[PlateMotion, ...]:
        """The motions of a plate that lies so far above its axis, m."""
        if height == self.scenario.motion.height:
            return self.motions
        return tuple(motion.with_valid(height=height) for motion in self.motions)


def drive_of(placed: Scenario, machine: Machine, acceleration: float | str = ACCELERATION) -> Drive:
    """What the motors of a machine can do with a plate while an object is steered on it."""
    base = placed.motion.replace(waves=(), samples=None)
    return Drive(machine, base, ramp=RAMP, acceleration=acceleration)


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
    reach = float(min(room_of(placed).min() - MARGIN, 0.2))
    drive = drive_of(placed, machine_of(machine), acceleration)
    still = drive.base.replace(angle=0.0, stroke=0.0)
    # What only rocks about the bar and shakes along it does the same all along it.
    powers = ACROSS if set(drive.names) <= set(_ALONG_THE_BAR) else ANYHOW
    field, rough = Field(powers, reach), Field(tuple(each for each in powers if max(each) <= 2), reach)
    generator = np.random.default_rng(seed)
    shares = qmc.Sobol(len(drive), rng=np.random.default_rng(seed)).random_base2(8)[:_FIRST]
    tried, actions, response = 2 * shares - 1, np.zeros((0, len(drive))), resting(0, rough)
    report = progress or (lambda _: None)
    best: Sequence[int] = ()
    for generation in range(generations + 1):
        made = [still, *drive.motions(tried)]
        run = pulses([placed], made, (LONGEST // 4, LONGEST), 4, 100 * seed + generation, reach,
                     engine=engine, threads=threads)  # fmt: skip
        actions, response = np.concatenate([actions, tried]), joined(response, fitted(run, len(made), rough))
        best = _best(response, reach)
        if not len(best):
            raise InputError("machine", drive.machine.name, "one that moves the object without losing it",
                             "a larger plate, or a machine with smaller motions")  # fmt: skip
        report((generation + 1) / (generations + 2))
        tried = children(actions[list(best)], drive, generation == 0, generator)
    chosen = actions[list(best)]
    motions = (still, *drive.motions(chosen))
    last = pulses([placed], motions, (6, 12, LONGEST), 12, 100 * seed + 99, reach, engine=engine, threads=threads)
    told = fitted(last, len(motions), field)
    sure = [0, *np.flatnonzero(usable(told, 2.0) & followed(told, reach)).tolist()]
    if len(sure) < 2:
        raise InputError("machine", drive.machine.name, "one whose motions the object follows", "a larger plate")
    report(1.0)
    actions = np.concatenate([np.zeros((1, len(drive))), chosen])[sure]
    return Menu(placed, drive, tuple(motions[i] for i in sure), actions, told.of(sure), reach)


def usable(response: Response, times: float = 1.0) -> Flags:
    """(m,) motions that lose nothing, and that do what is expected, within so many times what is unsure at most."""
    return ~response.failed & (response.spread < times * _MOST_SPREAD).all(axis=1)


def followed(response: Response, reach: float) -> Flags:
    """(m,) motions that carry an object twice as far as what is unsure of it, in the mean over places."""
    moved = np.stack([displaced(response, np.array([0.0, place * reach])) for place in _PLACES])
    return np.sqrt(((moved / _SCALE) ** 2).sum(axis=2).mean(axis=0)) > 2 * np.linalg.norm(
        response.spread / _SCALE, axis=1
    )


def joined(one: Response, other: Response) -> Response:
    """Responses to the motions of one, and to those of another but the first."""
    rates, lags, spread, failed = (
        np.concatenate([getattr(one, name), getattr(other, name)[1:]]) for name in ("rates", "lags", "spread", "failed")
    )
    return Response(rates, lags, spread, failed, one.field)


def displaced(response: Response, place: Array, ticks: int = LONGEST) -> Array:
    """(m, 3) displacement by a pulse of so many ticks, from rest at a place (x, y), m, to rest."""
    begin = np.tile([*place, 0.0, 0.0, 0.0, 0.0], (len(response), 1))
    return response.going(np.arange(len(response)), begin, ticks)[:, -1] - begin[:, :3]


def _best(response: Response, reach: float) -> Sequence[int]:
    """Motions that go farthest for sure some way from some place, and those that go a little way the straightest."""
    best: set[int] = set()
    allowed = usable(response)
    for place, (ticks, scale, most) in itertools.product(_PLACES, _WAYS):
        unsure = np.linalg.norm(response.spread / scale, axis=1) * math.sqrt(ticks / LONGEST)
        moved = displaced(response, np.array([0.0, place * reach]), ticks) / scale
        length = np.linalg.norm(moved, axis=1)
        along = moved @ _DIRECTIONS.T
        aside = np.sqrt(np.maximum(length[:, None] ** 2 - along**2, 0.0))
        # A shorter pulse goes less far, along and aside.
        share = np.minimum(most / np.maximum(along, most), 1.0)
        goes = (allowed & (length > np.maximum(unsure, _LEAST)))[:, None]
        merit = np.where(goes, share * (along - _ASIDE * aside) - _UNSURE * unsure[:, None], -np.inf)
        best.update(merit.argmax(axis=0)[merit.max(axis=0) > -np.inf].tolist())
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
