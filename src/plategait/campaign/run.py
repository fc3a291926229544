"""Running a campaign: what is missing in its store, batch by batch, then the refinement."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from plategait.campaign.batch import Rows, variables
from plategait.campaign.cluster import connected
from plategait.campaign.held import open_to_write
from plategait.campaign.opened import Campaign, open_sweep
from plategait.campaign.plan import Sweep, read_sweep
from plategait.campaign.points import Point
from plategait.campaign.refine import propose, refined_parameter
from plategait.campaign.store import Store, with_coordinates
from plategait.campaign.workers import Job, Workers, on_dask, on_this_machine
from plategait.errors import InputError
from plategait.simulation.ensemble import TAKEN, Ensemble, together

# Runs of a batch at least, and for each core: enough to fill the engine's lanes.
RUNS_OF_BATCH = 64
RUNS_PER_CORE = 32


def sweep(
    plan: Sweep | Path | str | Mapping[str, Any],
    store: Path | str,
    *,
    refine: int = 0,
    repair: bool = False,
    dask: object = None,
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> Campaign:
    """Run a sweep into a store, or go on with one that was interrupted.

    Killed at any moment, it loses at most the batch in flight, and the same call ends with the same bits.

    Parameters
    ----------
    plan : Sweep, path of a TOML file, or mapping of `Sweep`'s fields
    store : path
        Folder ending in .zarr, opened by anyone with ``xarray.open_zarr(store)``.
    refine : int
        Points to add where they tell most (`plategait.campaign.refine`); a store keeps the largest number asked for.
    repair : bool
        Run the points of damaged batches again instead of refusing the store.
    dask : str or distributed.Client, optional
        Cluster to run on: its address, scheduler file or client. This machine's cores by default.
    threads : int, optional
        Cores to use here; all by default.
    progress : callable, optional
        Called with the fraction done.

    Raises
    ------
    InputError
        For a plan or store that is not as it must be.
    """
    sweep_plan = plan if isinstance(plan, Sweep) else Sweep(**plan) if isinstance(plan, Mapping) else read_sweep(plan)
    if isinstance(refine, bool) or not isinstance(refine, int) or not 0 <= refine <= 10**6:
        raise InputError("refine", refine, "a whole number from 0 to a million", "20")
    if refine:
        refined_parameter(sweep_plan)
    path, size = Path(store), batch_size(sweep_plan)
    with connected(dask) as client, open_to_write(path, sweep_plan, size, repair) as (opened, points):
        _Running(sweep_plan, opened, points, client, threads, progress).run(refine)
    return open_sweep(path)


def batch_size(plan: Sweep) -> int:
    """Points of a batch: as the plan says, or so many that their runs keep all cores busy and fit in memory."""
    from plategait.engine.cpu import core_count

    if plan.batch is not None:
        return plan.batch
    return max(1, math.ceil(max(RUNS_OF_BATCH, RUNS_PER_CORE * core_count()) / plan.repeats))


class _Running:
    """One campaign while it runs."""

    def __init__(
        self,
        plan: Sweep,
        store: Store,
        points: Sequence[Point],
        client: Any,
        threads: int | None,
        progress: Callable[[float], object] | None,
    ) -> None:
        self.plan, self.store, self.base = plan, store, list(points)
        self.done, _ = store.state()
        self.arrays = variables(plan, points)
        self.workers: Workers = (
            on_dask(plan, self.arrays, client)
            if client is not None
            else on_this_machine(plan, self.arrays, threads, self._within)
        )
        self.progress, self.total, self.finished, self.current = progress, len(points), 0, 0

    def run(self, refine: int) -> None:
        """Run what is missing."""
        target = max(refine, int(self.store.attributes["refine"]))
        self.store.grow(len(self.base), refine=target)
        self.total = len(self.base) + target
        self._run_missing(self.base, 0)
        if target:
            self._refine(target)

    def _refine(self, target: int) -> None:
        points = list(self.base)
        while len(points) - len(self.base) < target:
            room = target - (len(points) - len(self.base))
            new = propose(self.plan, points, self._outcomes(len(points)))[:room]
            if not new:
                return
            first = len(points)
            points += new
            self.store.grow(len(points))
            self.done = np.append(self.done, np.zeros(max(0, len(points) - len(self.done)), dtype=bool))
            self._run_missing(points, first)

    def _run_missing(self, points: Sequence[Point], first: int) -> None:
        """Run those of the points from the first on that the store has not."""
        missing = np.nonzero(~self.done[first : len(points)])[0] + first
        self.finished = int(self.done[: len(points)].sum())
        by_batch: dict[int, list[int]] = {}
        for index in map(int, missing):
            by_batch.setdefault(index // self.store.batch, []).append(index)
        jobs = [Job(indices, [points[i] for i in indices]) for indices in by_batch.values()]
        self.current = len(jobs[0].indices) if jobs else 0
        for number, (job, rows) in enumerate(self.workers(jobs)):
            self._commit(job, rows, points)
            self.finished += len(job.indices)
            self.current = len(jobs[number + 1].indices) if number + 1 < len(jobs) else 0
            self._within(0.0)

    def _commit(self, job: Job, rows: Rows, points: Sequence[Point]) -> None:
        """Write a job's rows, behind those that the batch has already."""
        batch = job.indices[0] // self.store.batch
        start, stop = batch * self.store.batch, job.indices[-1] + 1
        if job.indices[0] > start:
            have = range(start, job.indices[0])
            rows = {name: np.concatenate([self.store.read(name, have), new]) for name, new in rows.items()}
        self.store.commit(batch, with_coordinates(rows, points[start:stop]))
        self.done[start:stop] = True

    def _outcomes(self, count: int) -> Ensemble:
        return together(**{name: self.store.read(name, range(count)) for name in TAKEN})

    def _within(self, fraction: float) -> None:
        if self.progress is not None:
            self.progress(min(1.0, (self.finished + fraction * self.current) / self.total))
