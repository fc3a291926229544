"""Runs of trials, a row of numbers for each: on this machine, or on a Dask cluster. Both give the same bits."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from plategait.arrays import Array
from plategait.campaign.cluster import hand_out
from plategait.engine.engines import Engine
from plategait.model.scenario import Scenario
from plategait.simulation.result import Simulation
from plategait.simulation.run import simulate_all

COLUMNS = ("velocity_x", "velocity_y", "spin_rate", "bending", "lasted", "failed")
"""What is kept of each run: SI, the share of its time before it failed, and whether it did; then what else is asked."""
MOST_AT_ONCE = 512
"""Runs that are made side by side here: more bring no speed, and a megabyte of recordings each."""
ON_A_WORKER = 16
"""Runs that a worker of a cluster is given at once: they fill the widest lanes, and more would leave others idle."""

Measure = Callable[[Simulation], float]


@dataclass(frozen=True)
class Portion:
    """Runs to make together: `scenarios`, of which the first is the `first` of all."""

    first: int
    scenarios: Sequence[Scenario]


def portions(scenarios: Sequence[Scenario], most: int) -> list[Portion]:
    """Scenarios in portions of so many at most."""
    return [Portion(first, scenarios[first : first + most]) for first in range(0, len(scenarios), most)]


def rows_of(
    portion: Portion,
    engine: Engine,
    further: Sequence[Measure],
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> Array:
    """(runs, columns) `COLUMNS` of each run of a portion, and what else is measured of it."""
    made = simulate_all(portion.scenarios, engine=engine, threads=threads, progress=progress)
    return np.array([_row(run) + [measure(run) for measure in further] for run in made])


def on_dask(
    client: Any, scenarios: Sequence[Scenario], engine: Engine, further: Sequence[Measure]
) -> Iterator[tuple[Portion, Array]]:
    """Rows of runs that the workers of a Dask cluster make, portion by portion as they end.

    Raises
    ------
    InputError
        When a worker has another plategait, instruction set or machine.
    """
    return hand_out(client, _on_a_core, portions(scenarios, ON_A_WORKER), engine, tuple(further))


def _on_a_core(portion: Portion, engine: Engine, further: Sequence[Measure]) -> Array:
    return rows_of(portion, engine, further, threads=1)


def _row(run: Simulation) -> list[float]:
    o, duration = run.observations[0], run.scenario.duration
    lasted = 1.0 if o.failure is None else min(o.failure.sound_until / duration, 1.0)
    return [o["velocity_x"], o["velocity_y"], o.spin.rate, o["bending_amplitude"], lasted, float(o.failure is not None)]
