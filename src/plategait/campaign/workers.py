"""Where batches are run: on this machine, or on a Dask cluster. Both give the same bits."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from plategait.campaign.batch import Rows, Variable, run_batch
from plategait.campaign.cluster import hand_out
from plategait.campaign.plan import Sweep
from plategait.campaign.points import Point


@dataclass(frozen=True)
class Job:
    """Points to run together."""

    indices: Sequence[int]
    points: Sequence[Point]


Workers = Callable[[Sequence[Job]], Iterator[tuple[Job, Rows]]]


def on_this_machine(
    sweep: Sweep, arrays: Sequence[Variable], threads: int | None, progress: Callable[[float], object]
) -> Workers:
    """Run jobs one after the other, each on all cores; `progress` takes the fraction of a job."""

    def run(jobs: Sequence[Job]) -> Iterator[tuple[Job, Rows]]:
        for job in jobs:
            yield job, run_batch(sweep, arrays, job.points, job.indices, threads, progress)

    return run


def on_dask(sweep: Sweep, arrays: Sequence[Variable], client: Any) -> Workers:
    """Run jobs on the workers of a Dask cluster, as they become free (`plategait.campaign.cluster.hand_out`)."""

    def run(jobs: Sequence[Job]) -> Iterator[tuple[Job, Rows]]:
        plan = client.scatter((sweep, tuple(arrays)), broadcast=True, hash=False)
        yield from hand_out(client, _run_job, jobs, plan)

    return run


def _run_job(job: Job, plan: tuple[Sweep, tuple[Variable, ...]]) -> Rows:
    sweep, arrays = plan
    return run_batch(sweep, arrays, job.points, job.indices, threads=1)
