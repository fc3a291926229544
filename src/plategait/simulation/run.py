"""Runs: from scenarios through an engine to what they show."""

from __future__ import annotations

import difflib
import math
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TypedDict, Unpack

import numpy as np

from plategait.engine import engines
from plategait.engine.engines import Engine
from plategait.engine.recording import RunRequest
from plategait.errors import InputError
from plategait.model.presets import PRESETS, Preset, as_scenario
from plategait.model.scenario import Scenario
from plategait.simulation.observation import observe
from plategait.simulation.result import Simulation
from plategait.units import Quantity

INTERVAL = Quantity("s", "s", "0.002 s", at_least=0)

# Spread of the starts of an ensemble: a tenth of a millimetre and a degree are what a hand cannot place better.
START_SPREAD = 1e-4
START_TURN = math.radians(1)

MOST_THREADS = 1000
MOST_REPEATS = 10**5

# Time between the shapes that films and files are made of, s: a fifth of a fast plate's quarter period.
FILM_INTERVAL = 2e-3


class RunOptions(TypedDict, total=False):
    """How scenarios are run: the options of `simulate_all`, which says what they are."""

    repeats: int
    seed: int
    engine: Engine
    snapshot_interval: float | str
    threads: int | None
    progress: Callable[[float], object] | None


def check_options(options: Mapping[str, object]) -> None:
    """Refuse a name that is none of `RunOptions`.

    Raises
    ------
    InputError
        With the nearest that is, or how a scenario's number is changed.
    """
    names = list(RunOptions.__annotations__)
    for name in options:
        if name not in names:
            close = difflib.get_close_matches(name, names, 1)
            hint = close[0] if close else 'scenario.replace(**{"motion.frequency": "24 Hz"}) for what belongs to it'
            raise InputError(name, "nothing known by that name", f"one of {', '.join(names)}", hint)


def starts(repeats: int, seed: int) -> list[tuple[float, float, float]]:
    """(x, y, angle) added to the start of each run of an ensemble; the first is the nominal start."""
    generator = np.random.default_rng(seed)
    spread = generator.normal(0.0, 1.0, (repeats, 3)) * (START_SPREAD, START_SPREAD, START_TURN)
    return [(0.0, 0.0, 0.0), *(tuple(map(float, row)) for row in spread[1:])]  # type: ignore[list-item]


def simulate(scenario: Scenario | Preset | Path | str, **options: Unpack[RunOptions]) -> Simulation:
    """Run one scenario, once or as an ensemble of slightly different starts.

    Source: joints, contact and friction of section 3.2 of the dissertation; the scheme is in docs/numerics.md.

    Parameters
    ----------
    scenario : Scenario, or what tells one
        A preset or its name, or a TOML file.
    **options
        See `simulate_all`.

    Raises
    ------
    InputError
        For no scenario, an unknown option, or one out of range.
    """
    check_options(options)
    return simulate_all([scenario], **options)[0]


def simulate_all(
    scenarios: Sequence[Scenario | Preset | Path | str],
    *,
    repeats: int = 1,
    seed: int = 0,
    engine: Engine = "cpu",
    snapshot_interval: float | str = 0.0,
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> list[Simulation]:
    """Run many scenarios side by side. A run that fails or diverges is a status, never an exception.

    Parameters
    ----------
    scenarios : sequence of Scenario, or of what tells one
        May differ in everything.
    repeats : int
        Runs; the first starts where the scenario says, the others within a tenth of a millimetre and a degree of it.
    seed : int
        Of the starts.
    engine : {"cpu", "cpu64", "tiles"}
        The native core in single or double precision, or rigid tiles (`plategait.engine.engines`).
    snapshot_interval : float or str
        Time between recorded shapes, s; 0 records none.
    threads : int, optional
        Cores to use; all by default.
    progress : callable, optional
        Called with the fraction done.

    Raises
    ------
    InputError
        For an unknown engine or what it cannot do, no scenario, a number out of range, or runs that need more memory
        than there is.
    KeyboardInterrupt
        When interrupted from the keyboard.
    """
    row = engines.engine(engine)
    check_whole("repeats", repeats, 1, MOST_REPEATS)
    check_whole("seed", seed, 0, 10**6)
    check_threads(threads)
    interval = INTERVAL.read(snapshot_interval, "snapshot_interval")
    checked = scenarios_of(scenarios)
    offsets = starts(repeats, seed)
    runs = [RunRequest(scenario, offset, interval) for scenario in checked for offset in offsets]
    begun = time.perf_counter()
    recordings = row.run(runs, threads=threads, progress=progress)
    wall = time.perf_counter() - begun
    total = sum(r.steps * r.dt for r in recordings)
    simulations = []
    for i, scenario in enumerate(checked):
        own = tuple(recordings[i * repeats : (i + 1) * repeats])
        share = sum(r.steps * r.dt for r in own) / total if total else 0.0
        observations = tuple(observe(scenario, r) for r in own)
        simulations.append(Simulation(scenario, own, observations, engine, seed, wall * share))
    return simulations


def check_whole(name: str, number: object, least: int, most: int) -> None:
    """Refuse what is no whole number within bounds.

    Raises
    ------
    InputError
    """
    if isinstance(number, bool) or not isinstance(number, (int, np.integer)) or not least <= number <= most:
        raise InputError(name, number, f"a whole number from {least} to {most}", str(max(least, 4)))


def check_threads(threads: int | None) -> None:
    """Refuse a number of threads that no machine has; None stands for all cores.

    Raises
    ------
    InputError
    """
    if threads is not None:
        check_whole("threads", threads, 1, MOST_THREADS)


def scenarios_of(scenarios: Sequence[Scenario | Preset | Path | str]) -> list[Scenario]:
    """Scenarios of a list of what tells them."""
    if isinstance(scenarios, (str, Path, Scenario, Preset)) or not hasattr(scenarios, "__iter__"):
        raise InputError("scenarios", "nothing like a list", "a list of scenarios", f'["{PRESETS[0]}"]')
    checked = [as_scenario(each, "scenarios") for each in scenarios]
    if not checked:
        raise InputError("scenarios", "nothing", "at least one scenario", 'preset("cheese").scenario')
    return checked
