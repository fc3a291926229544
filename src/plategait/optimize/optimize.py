"""The whole of it: from an object, a machine and a goal to the optimum, its sensitivities and its confirmation."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from plategait.campaign.cluster import connected
from plategait.engine.engines import Engine
from plategait.errors import InputError, check_kind
from plategait.model.fragment import Fragment, overlay
from plategait.model.machine import Machine, machine_of
from plategait.model.presets import Preset, as_scenario
from plategait.model.scenario import Scenario
from plategait.model.scenario_file import write_scenario
from plategait.optimize.diary import open_diary
from plategait.optimize.goal import Goal
from plategait.optimize.optimum import Optimum, Sensitivity, best_of
from plategait.optimize.proof import CONFIRMED, FINER
from plategait.optimize.search import CONFIRMATION, Effort, search, usual_effort
from plategait.optimize.space import Freedom, Space, Variable, freedoms_of, space_of
from plategait.optimize.trials import Bench, Tally, Trial
from plategait.simulation.run import check_whole

PERMITTED, CONFIDENCE = 0.05, 0.9
"""Chance of failure that is permitted unless asked otherwise, and the confidence with which it is bounded."""
APART, AROUND = 0.05, 16
"""How far each variable is moved for the sensitivities, as a share of its value, and runs of each motion there."""
MOST_SEARCHES = 20

# What an object that is to travel may slip beyond its way, and shares nearer to none or all than any test can tell.
_ROOM, _LEAST_SHARE = 1.5, 0.001
# Batches of these are numbered apart from those of the searches.
_SENSITIVITIES = 10**6


def optimize_motion(
    scenario: Scenario | Preset | Path | str = "cheese",
    machine: Machine | Path | str = "source-robot",
    goal: Goal | None = None,
    *,
    ranges: Mapping[str, tuple[float, float] | str] | None = None,
    free: Sequence[Freedom] | None = None,
    measured: Sequence[Fragment] = (),
    draws: int = 0,
    chance_of_failure: float = PERMITTED,
    confidence: float = CONFIDENCE,
    searches: int = 1,
    seed: int = 0,
    effort: Effort | None = None,
    engine: Engine = "cpu",
    store: Path | str | None = None,
    dask: object = None,
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> Optimum:
    """Find the motion that does best with an object on a machine (how: docs/optimize.md).

    Parameters
    ----------
    scenario : Scenario, or what tells one
        The object, contact, friction, plate, how long each run lasts and how far the object may slip; where it is to
        travel, it may slip half as far again as its way (`with_room`).
    machine : Machine, its name or file
    goal : Goal, optional
        The fastest spin by default.
    ranges : mapping of str to (low, high), optional
        Of "frequency", "angle", "stroke", SI or text ("10:30 Hz"); the machine's by default, alike to vary nothing.
    free : sequence of str, optional
        Further freedoms (`plategait.optimize.space.FREEDOMS`); by default none, or where the object is to travel all.
    measured : sequence of Fragment
        Laid over the scenario, at their values.
    draws : int
        How many draws of what was measured the motion is to work for; 0 takes the values alone.
    chance_of_failure, confidence : float
        Chance of failure that is permitted, and the confidence with which it is to be bounded.
    searches : int
        Independent ones, of which the best counts.
    seed : int
        Of the first; the others follow it.
    effort : Effort, optional
        How much is run; follows from the number of variables by default.
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
        For bad input, when the package `cma` is not installed, or no cluster answers.
    """
    goal = _read_goal(goal)
    _check_numbers(draws, searches, seed, {"chance_of_failure": chance_of_failure, "confidence": confidence})
    objects = _objects(as_scenario(scenario), measured, goal, draws, seed)
    shaker = machine_of(machine)
    space = _space(objects[0], shaker, goal, ranges or {}, free)
    effort = effort or usual_effort(space, goal, chance_of_failure, confidence)
    chances = {"permitted": chance_of_failure, "confidence": confidence}
    wanted = _identity(objects, space, [repr(goal), repr(effort), chances, searches, seed, engine])
    expected = searches * effort.expected + 2 * AROUND * len(space.variables) + CONFIRMED * FINER
    tally = Tally(progress, expected)
    with connected(dask) as client, open_diary(None if store is None else Path(store), wanted) as diary:
        bench = Bench(tuple(objects[1:] or objects), shaker, seed, engine, diary, threads, tally, client=client)
        benches = [replace(bench, seed=seed + i) for i in range(searches)]
        found = tuple(search(space, goal, own, effort=effort, seed=own.seed, **chances) for own in benches)
        best = best_of(found, goal).proof.trial
        around = sensitivities(space, best, bench)
        (fine,) = bench.try_motions([(best.shares, best.motion)], CONFIRMED, CONFIRMATION, finer=FINER)
    return Optimum(objects[0].replace(motion=best.motion), goal, shaker, space, found, sensitivities=around,
                   confirmation=fine, **chances)  # fmt: skip


def _objects(scenario: Scenario, measured: Sequence[Fragment], goal: Goal, draws: int, seed: int) -> list[Scenario]:
    """The object at what was measured of it, then draws of that."""
    generator = np.random.default_rng(seed)
    made = [overlay(scenario, measured), *(overlay(scenario, measured, generator) for _ in range(draws))]
    return [with_room(each, goal) for each in made]


def _check_numbers(draws: int, searches: int, seed: int, shares: Mapping[str, float]) -> None:
    for name, number, least, most in (
        ("draws", draws, 0, 10**4), ("searches", searches, 1, MOST_SEARCHES), ("seed", seed, 0, 10**6)
    ):  # fmt: skip
        check_whole(name, number, least, most)
    for name, share in shares.items():
        if not _LEAST_SHARE <= share <= 1 - _LEAST_SHARE:
            raise InputError(name, share, f"a share from {_LEAST_SHARE} to {1 - _LEAST_SHARE}",
                             "0.9" if name == "confidence" else "0.05")  # fmt: skip


def _read_goal(goal: Goal | None) -> Goal:
    goal = Goal() if goal is None else goal
    check_kind(goal, Goal, "goal", 'Goal(spin="300 deg/s")')
    return goal


def _space(
    scenario: Scenario,
    machine: Machine,
    goal: Goal,
    ranges: Mapping[str, tuple[float, float] | str],
    free: Sequence[Freedom] | None,
) -> Space:
    """Motions to choose from for an object; refuses a plate that is too small for it, and a cost that is not known."""
    check_object(scenario, goal)
    if goal.cost in ("torque", "power") and not np.isfinite(machine.inertial_loads).all():
        raise InputError("least", goal.cost, f"a cost that is known, and {machine.name} does not tell its masses",
                         "acceleration, or plate_mass and the inertias in the machine's file")  # fmt: skip
    travels = goal.way > 0
    if free is None:
        free = freedoms_of(machine) if travels else ()
    return space_of(scenario.motion, machine, ranges, free, both_ways=not goal.fastest, may_rest=travels)


def _identity(objects: Sequence[Scenario], space: Space, rest: list[Any]) -> dict[str, Any]:
    """What decides a search, as JSON can hold it."""
    searched = [repr(space.machine), repr(space.variables), repr(space.fixed)]
    return {"objects": [write_scenario(each) for each in objects], "space": searched, "rest": rest}


def with_room(scenario: Scenario, goal: Goal) -> Scenario:
    """Scenario in which the object may slip half as far again as it is to travel, where it is to travel."""
    if goal.way == 0:
        return scenario
    return scenario.replace(slip_limit=max(scenario.slip_limit, _ROOM * goal.way * scenario.duration))


def check_object(scenario: Scenario, goal: Goal) -> None:
    """Refuse a plate that is too small for the object or for the way that it is to go.

    Raises
    ------
    InputError
    """
    if scenario.plate is None:
        return
    size, plate = scenario.sheet.outline.size(), (scenario.plate.length, scenario.plate.width)
    said = f"{1e3 * plate[0]:g} mm by {1e3 * plate[1]:g} mm"
    if max(size) > min(plate):
        raise InputError("plate", said, f"{1e3 * max(size):.4g} mm each way at least, as the object is that long",
                         "a larger plate, or a smaller object")  # fmt: skip
    for velocity, length in ((goal.along, plate[0]), (goal.across, plate[1])):
        way = abs(velocity or 0.0) * scenario.duration
        if way > length / 2:
            shorter = 0.8 * scenario.duration * length / 2 / way
            raise InputError("plate", said, f"so large that the object may go {1e3 * way:.4g} mm from its middle",
                             f'--duration "{shorter:.2g} s", or a larger plate')  # fmt: skip


def sensitivities(space: Space, best: Trial, bench: Bench) -> tuple[Sensitivity, ...]:
    """What a little less and a little more of each variable does, all from the same starts."""
    values = space.values(best.shares)
    moved: list[tuple[Variable, float, float]] = []
    for variable in space.variables:
        value = values[variable.name]
        step = APART * (value if variable.log else variable.high - variable.low)
        # A variable of a few steps has no little more.
        around = (value - step, value + step) if not variable.steps else ()
        moved += [(variable, value, to) for to in around if variable.low <= to <= variable.high]
    motions = [space.motion({**values, variable.name: to}) for variable, _, to in moved]
    # What the machine does not let change changes nothing.
    tried = [i for i, motion in enumerate(motions) if motion != best.motion]
    made = bench.try_motions([(best.shares, motions[i]) for i in tried], AROUND, _SENSITIVITIES) if tried else []
    trials = dict(zip(tried, made, strict=True))
    sides: dict[str, dict[bool, tuple[float, Trial]]] = {}
    for i, trial in trials.items():
        variable, value, to = moved[i]
        sides.setdefault(variable.name, {})[to > value] = (to, trial)
    return tuple(
        Sensitivity(v, values[v.name], sides.get(v.name, {}).get(False), sides.get(v.name, {}).get(True))
        for v in space.variables
    )
