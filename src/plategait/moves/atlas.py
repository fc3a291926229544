"""The atlas: for every velocity that an object can be given a motion, found, confirmed, and tried from fresh poses."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from plategait.arrays import Array
from plategait.campaign.cluster import connected
from plategait.engine.engines import Engine
from plategait.errors import InputError
from plategait.model.machine import Machine, machine_of
from plategait.model.presets import Preset, as_scenario
from plategait.model.scenario import Scenario
from plategait.model.scenario_file import write_scenario
from plategait.moves.cells import SIZES, Archive, Cell, check_sizes
from plategait.moves.certainty import covariance, widening
from plategait.moves.primitives import DIRECTIONS, Primitive, candidates, in_turn, still
from plategait.moves.settling import settling_time
from plategait.moves.vary import children
from plategait.optimize.diary import open_diary
from plategait.optimize.space import Freedom, Space, freedoms_of, space_of
from plategait.optimize.spread import scattered
from plategait.optimize.symmetry import mirrored
from plategait.optimize.trials import Bench, Placing, Tally, Trial
from plategait.shown import Shown
from plategait.simulation.run import check_whole

DURATION = 3.0
"""Time of each run unless asked otherwise, s."""
REACH = 20e-3
"""How far from the middle of the plate runs start, along the bar and across it, m."""
POPULATION, GENERATIONS = 256, 24
STARTS, CONFIRMED, VERIFIED = 2, 12, 100
"""Runs of a motion while searching, confirming, and verifying a primitive, each from a pose of its own."""
CONFIDENCE = 0.9
"""With which the chance of failure is bounded."""
_FIRST = 4 * POPULATION
# Share of the last generations that goes to the primitives.
_FOR_PRIMITIVES = 0.25
_ROUNDS = 2
TRIED = 6
"""Motions that are tried as a primitive."""
# What an object that travels may slip: the failure that is looked for is another.
_NO_LIMIT = 10.0
_CONFIRMING, _CHOOSING, _VERIFYING = 10**6, 2 * 10**6, 3 * 10**6


@dataclass(frozen=True, eq=False, repr=False)
class Atlas(Shown):
    """What an object does on a machine.

    Attributes
    ----------
    scenario : Scenario
    machine : Machine
    space : Space
    sizes : (3,) array
        Of a cell, SI.
    cells : dict of Cell to Trial
        The motion of each cell, by its confirmed mean velocity.
    primitives : tuple of Primitive
    widening : float
        Factor on all covariances (`plategait.moves.certainty`).
    runs : int
        All runs that were made.
    reach : float
        How far from the middle runs start, m.
    """

    scenario: Scenario
    machine: Machine
    space: Space
    sizes: Array
    cells: dict[Cell, Trial]
    primitives: tuple[Primitive, ...]
    widening: float
    runs: int
    reach: float

    def told(self) -> list[tuple[str, str]]:
        """How much of the velocities it reaches."""
        return [
            ("object", self.scenario.name), ("machine", self.machine.name), ("velocities", f"{len(self.cells)} cells"),
            ("primitives", ", ".join(each.name for each in self.primitives) or "none"),
            ("missing", ", ".join(self.missing) or "none"), ("runs", str(self.runs)),
        ]  # fmt: skip

    def covariance(self, trial: Trial) -> Array:
        """(3, 3) covariance of the velocity of a fresh run, SI."""
        return self.widening * covariance(trial.twists, self.sizes)

    @property
    def missing(self) -> list[str]:
        """Directions without a primitive."""
        return [name for name in DIRECTIONS if name not in {each.name for each in self.primitives}]

    @property
    def complete(self) -> bool:
        """Whether there is a primitive of each direction, and every fresh run of them went that way."""
        return not self.missing and all(each.verified for each in self.primitives)

    @property
    def twists(self) -> Array:
        """(cells, 3) velocities, SI."""
        return np.array([trial.twist for trial in self.cells.values()]).reshape(-1, 3)


def anywhere(reach: float) -> Placing:
    """Poses within `reach` (m) of the middle of the plate each way, at any angle."""

    def placed(runs: int, seed: int) -> list[tuple[float, float, float]]:
        shares = np.random.default_rng(seed).uniform(-1, 1, (runs, 3))
        return [(reach * x, reach * y, math.pi * turn) for x, y, turn in shares.tolist()]

    return placed


def atlas(
    scenario: Scenario | Preset | Path | str = "cheese",
    machine: Machine | Path | str = "source-robot",
    *,
    free: Sequence[Freedom] | None = None,
    cell: tuple[float, float, float] = SIZES,
    duration: float = DURATION,
    reach: float = REACH,
    generations: int = GENERATIONS,
    seed: int = 0,
    engine: Engine = "cpu",
    store: Path | str | None = None,
    dask: object = None,
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> Atlas:
    """Find what an object does on a machine: for each velocity the motion of least effort and greatest certainty.

    Quality-diversity search (MAP-Elites: Mouret and Clune 2015) with the iso+line variation of Vassiliades and Mouret
    2018, over the engine's batches.

    Source: docs/moves.md says how it searches, and what was measured.

    Parameters
    ----------
    scenario : Scenario, or what tells one
        The object, contact, friction, plate and the height of the plate.
    machine : Machine, its name or file
    free : sequence of str, optional
        What may vary beside frequency and amplitudes (`plategait.optimize.space.FREEDOMS`); all that the machine can by
        default.
    cell : (along, across, turn)
        Size of a cell of the atlas, m/s and rad/s.
    duration : float
        Of each run, s, a fifth of it before anything is measured.
    reach : float
        How far from the middle of the plate runs start each way, m; at any angle.
    generations : int
        Of `POPULATION` motions each.
    seed : int
    engine : {"cpu", "cpu64", "tiles"}
    store : path, optional
        Folder that keeps what was run: killed at any moment, the same call ends with the same bits.
    dask : str or distributed.Client, optional
        Cluster to run on: its address, scheduler file or client. This machine's cores by default.
    threads : int, optional
        Cores to use here; all by default.
    progress : callable, optional
        Called with the fraction done.

    Raises
    ------
    InputError
        For bad input, where no cluster answers, and where no motion was found that the object stays on the plate with.
    """
    check_whole("generations", generations, 1, 10**4)
    check_whole("seed", seed, 0, 10**6)
    sizes = check_sizes(cell)
    placed = prepared(as_scenario(scenario, "scenario"), duration, reach)
    shaker = machine_of(machine)
    space = space_of(placed.motion, shaker, {}, freedoms_of(shaker) if free is None else free, both_ways=True)
    wanted = {"scenario": write_scenario(placed), "space": [repr(shaker), repr(space.variables)],
              "rest": [sizes.tolist(), reach, generations, seed, engine]}  # fmt: skip
    work = STARTS * (_FIRST + generations * POPULATION)
    tally = Tally(progress, 1.25 * work)
    with connected(dask) as client, open_diary(None if store is None else Path(store), wanted) as diary:
        bench = Bench((placed,), shaker, seed, engine, diary, threads, tally, anywhere(reach),
                      (settling_time,), client)  # fmt: skip
        archive = _searched(space, bench, sizes, generations, seed)
        cells = _confirmed(archive, bench)
        if not cells:
            raise InputError("machine", shaker.name, "one that moves the object without losing it",
                             "a larger plate, or a machine with smaller motions")  # fmt: skip
        wide = widening(list(cells.values()), sizes)
        primitives = _primitives(cells, space, bench, sizes)
    return Atlas(placed, shaker, space, sizes, cells, primitives, wide, int(tally.done), reach)


def prepared(scenario: Scenario, duration: float, reach: float) -> Scenario:
    """Scenario as the atlas runs it: free to travel, of its duration.

    Raises
    ------
    InputError
        For a duration or reach that is none, or a plate that is too small for the object where it starts.
    """
    if not (math.isfinite(reach) and reach >= 0):
        raise InputError("reach", reach, "a length of at least 0", "20 mm")
    made = scenario.replace(duration=duration, transient=duration / 5, slip_limit=_NO_LIMIT)
    if made.plate is not None:
        room = min(made.plate.length, made.plate.width) / 2 - max(made.sheet.outline.size()) / 2
        if room < reach:
            raise InputError("plate", f"{1e3 * made.plate.length:g} mm by {1e3 * made.plate.width:g} mm",
                             f"large enough for the object up to {1e3 * reach:g} mm from its middle",
                             f'--reach "{max(0.0, 1e3 * room):.3g} mm", or a larger plate')  # fmt: skip
    return made


def _searched(space: Space, bench: Bench, sizes: Array, generations: int, seed: int) -> Archive:
    """Archive after the spread motions, their mirror images, and the generations."""
    archive, generator = Archive(sizes), np.random.default_rng(seed)
    shares = scattered(space, _FIRST, seed)
    archive.add(_tried(space, bench, shares, 0))
    for generation in range(1, generations + 1):
        elites = archive.elites
        if not elites:
            shares = scattered(space, POPULATION, seed + generation)
        elif generation == generations // 2:
            # What is known of one side is a guess at the others, better than any variation.
            images = mirrored(space, _shares(elites)).reshape(-1, len(space.variables))
            shares = images[generator.permutation(len(images))[:POPULATION]]
        else:
            parents = _shares(elites)
            if generation > (1 - _FOR_PRIMITIVES) * generations:
                parents = _shares([trial for each in candidates(elites, sizes).values() for trial in each[:8]])
            shares = children(space, parents, POPULATION, generator)
        archive.add(_tried(space, bench, shares, generation))
    return archive


def _shares(trials: Sequence[Trial]) -> Array:
    return np.array([trial.shares for trial in trials])


def _tried(space: Space, bench: Bench, shares: Array, batch: int) -> list[Trial]:
    return bench.try_motions([(row, space.at(row)) for row in shares], STARTS, batch)


def _confirmed(archive: Archive, bench: Bench) -> dict[Cell, Trial]:
    """Motion of each cell by what more runs say of it; the next best where the best fails or belongs elsewhere."""
    confirmed = Archive(archive.sizes)
    for number in range(_ROUNDS):
        missing = [cell for cell in sorted(archive.best) if cell not in confirmed.best]
        asked = [archive.best[cell][number] for cell in missing if len(archive.best[cell]) > number]
        if asked:
            confirmed.add(bench.try_motions([(t.shares, t.motion) for t in asked], CONFIRMED, _CONFIRMING + number))
    return {cell: confirmed.best[cell][0] for cell in sorted(confirmed.best)}


def _primitives(cells: dict[Cell, Trial], space: Space, bench: Bench, sizes: Array) -> tuple[Primitive, ...]:
    """Motions forward, back, left, right, turning both ways and holding, from fresh poses."""
    made: list[Primitive] = []
    for number, (name, asked) in enumerate(candidates(list(cells.values()), sizes).items()):
        pairs = [(t.shares, t.motion) for t in asked[:TRIED]]
        trials = bench.try_motions(pairs, 2 * CONFIRMED, _CHOOSING + number) if pairs else []
        # The first that holds in fresh runs; each is tried from poses of its own, and only what they gave is told.
        for turn, best in enumerate(in_turn(name, trials, sizes)):
            batch = _VERIFYING + len(DIRECTIONS) * turn + number
            (fresh,) = bench.try_motions([(best.shares, best.motion)], VERIFIED, batch)
            tried = Primitive(name, fresh)
            if tried.verified or turn == 0:
                made = [*(each for each in made if each.name != name), tried]
            if tried.verified:
                break
    held = still(space)
    (fresh,) = bench.try_motions([(np.full(len(space.variables), math.nan), held)], VERIFIED, _VERIFYING - 1)
    return (*made, Primitive("hold", fresh))
