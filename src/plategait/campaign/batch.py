"""One batch: points in, a row of numbers for each run out. Pure, so it gives the same bits on any machine alike."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from plategait.campaign.plan import Sweep
from plategait.campaign.points import Point, seed_of
from plategait.campaign.series import sample_count, snapshots, thinned
from plategait.engine.channels import SERIES
from plategait.engine.engines import engine
from plategait.errors import InputError
from plategait.simulation.registry import all_observables
from plategait.simulation.result import Simulation
from plategait.simulation.run import simulate_all, starts

Rows = dict[str, NDArray]


@dataclass(frozen=True)
class Variable:
    """One array of the store.

    Attributes
    ----------
    kind : str
        "float64", "float32", "int64", "bool", "int8" or "string".
    inner : dict of str to int
        Dimensions after ``point`` and ``repeat``, with their sizes.
    by_run : bool
        Whether it has the dimension ``repeat``.
    """

    name: str
    kind: str
    long_name: str
    unit: str = ""
    inner: Mapping[str, int] = field(default_factory=dict)
    by_run: bool = True


SUMMARY = (
    Variable("spin_rate", "float64", "mean spin rate, counter-clockwise positive", "rad/s"),
    Variable("spin_rate_sd", "float64", "standard deviation over blocks of whole periods", "rad/s"),
    Variable("spin_rate_low", "float64", "lower end of the 95 % interval", "rad/s"),
    Variable("spin_rate_high", "float64", "upper end of the 95 % interval", "rad/s"),
    Variable("settled", "bool", "whether the two halves of what was measured agree"),
    Variable("gait", "string", "sliding, walking or running; empty where nothing was measured"),
    Variable("failure", "string", "how the run failed; empty where it did not"),
    Variable("failure_time", "float64", "when it failed", "s"),
    Variable("energy_closed", "bool", "whether the energy balances within the tolerance"),
    Variable("dt", "float64", "time step", "s"),
    Variable("steps", "int64", "steps taken", "1"),
)
STATUS = Variable("status", "int8", "1 where the point has been run", by_run=False)


def array_names(sweep: Sweep, observables: Sequence[str]) -> list[str]:
    """Arrays of a sweep's store that are filled batch by batch, coordinates included."""
    names = [*(p.name for p in sweep.parameters), *(v.name for v in SUMMARY), *observables, STATUS.name]
    names += [f"series_{channel}" for channel in sweep.record.channels]
    return names + (["snapshot_time", "position"] if sweep.record.snapshots is not None else [])


def variables(sweep: Sweep, points: Sequence[Point]) -> tuple[Variable, ...]:
    """Every array of a sweep's store that is filled batch by batch, but the coordinates.

    Raises
    ------
    InputError
        When the scenario at a point is not as it must be, or snapshots are asked for of sheets that differ in nodes.
    """
    scenarios = [sweep.at(point) for point in points]
    record, duration = sweep.record, max(s.duration for s in scenarios)
    real = engine(sweep.engine).precision
    arrays = list(SUMMARY)
    arrays += [Variable(o.name, "float64", o.long_name, o.unit) for o in all_observables().values()]
    samples = {"time": sample_count(duration, record.interval)}
    series = [SERIES[name] for name in record.channels]
    arrays += [Variable(f"series_{c.name}", real, c.long_name, c.unit, inner=samples) for c in series]
    if record.snapshots is not None:
        nodes = {s.sheet.lattice.n_nodes for s in scenarios}
        if len(nodes) > 1:
            raise InputError("record.snapshots", f"sheets of {min(nodes)} to {max(nodes)} nodes",
                             "of one lattice at every point", "leaving snapshots out")  # fmt: skip
        shots = {"snapshot": sample_count(duration, record.snapshots)}
        arrays.append(Variable("snapshot_time", "float64", "time of the snapshot", "s", shots))
        shape = {**shots, "node": nodes.pop(), "axis": 3}
        arrays.append(Variable("position", "float32", "node position, world frame", "m", shape))
    return (*arrays, STATUS)


def run_batch(
    sweep: Sweep,
    arrays: Sequence[Variable],
    points: Sequence[Point],
    indices: Sequence[int],
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> Rows:
    """Run points, each `sweep.repeats` times.

    Parameters
    ----------
    arrays : sequence of Variable
        What is wanted (`variables`).
    points : sequence of Point
    indices : sequence of int
        Place of each in the sweep, from which the seed of its starts follows.
    threads, progress
        See `simulate_all`.
    """
    scenarios = []
    for point, index in zip(points, indices, strict=True):
        scenario = sweep.at(point)
        for x, y, angle in starts(sweep.repeats, seed_of(sweep.seed, index)):
            start = scenario.start
            shifted = {"start.x": start.x + x, "start.y": start.y + y, "start.angle": start.angle + angle}
            scenarios.append(scenario.replace(**shifted))
    interval = sweep.record.snapshots or 0.0
    runs = simulate_all(
        scenarios, engine=sweep.engine, snapshot_interval=interval, threads=threads, progress=progress
    )  # fmt: skip
    summaries = [_summary(run) for run in runs]
    rows: Rows = {}
    for variable in arrays:
        if variable is STATUS or variable.name == STATUS.name:
            rows[variable.name] = np.ones(len(points), dtype="int8")
            continue
        values = [s[variable.name] if variable.name in s else _recorded(run, sweep, variable)
                  for run, s in zip(runs, summaries, strict=True)]  # fmt: skip
        dtype = None if variable.kind == "string" else variable.kind
        array = np.array(values, dtype=dtype)
        rows[variable.name] = array.reshape(len(points), sweep.repeats, *array.shape[1:])
    return rows


def _summary(run: Simulation) -> dict[str, float | bool | str | int]:
    o, recording = run.observations[0], run.recordings[0]
    return {
        "spin_rate": o.spin.rate,
        "spin_rate_sd": o.spin.sd,
        "spin_rate_low": o.spin.low,
        "spin_rate_high": o.spin.high,
        "settled": o.spin.settled and o.failure is None,
        "gait": o.gait,
        "failure": o.failure.kind if o.failure else "",
        "failure_time": o.failure.time if o.failure else math.nan,
        **o.values,
        "energy_closed": o.energy.closes,
        "dt": recording.dt,
        "steps": recording.steps,
    }


def _recorded(run: Simulation, sweep: Sweep, variable: Variable) -> NDArray:
    recording = run.recordings[0]
    count = next(iter(variable.inner.values()))
    if variable.name.startswith("series_"):
        return thinned(recording, variable.name.removeprefix("series_"), sweep.record.interval, count)
    assert sweep.record.snapshots is not None
    times, shapes = snapshots(recording, sweep.record.snapshots, count)
    return times if variable.name == "snapshot_time" else shapes
