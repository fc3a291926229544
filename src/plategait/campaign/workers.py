"""Where batches are run: on this machine, or on a Dask cluster. Both give the same bits."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from plategait.campaign.batch import Rows, Variable, run_batch
from plategait.campaign.identity import maker
from plategait.campaign.plan import Sweep
from plategait.campaign.points import Point
from plategait.errors import InputError
from plategait.files.input import LARGEST_JSON, read_bytes

# Lost workers that a batch outlives.
RETRIES = 5
# For which a scheduler is waited for, s.
TIMEOUT = 15


@dataclass(frozen=True)
class Job:
    """Points to run together."""

    indices: Sequence[int]
    points: Sequence[Point]


Progress = Callable[[int, float], object]
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
    """Run jobs on the workers of a Dask cluster, as they become free.

    Raises
    ------
    InputError
        When a worker has another plategait, instruction set or machine, whose bits would differ.
    """

    def run(jobs: Sequence[Job]) -> Iterator[tuple[Job, Rows]]:
        from distributed import as_completed

        plan, wanted = client.scatter((sweep, tuple(arrays)), broadcast=True, hash=False), maker()
        waiting = list(jobs)[::-1]
        # Enough that no worker waits, few enough that results do not pile up.
        ahead = 3 * max(1, sum(client.nthreads().values()))

        def submit() -> Any:
            job = waiting.pop()
            future = client.submit(_on_worker, plan, job, pure=False, retries=RETRIES)
            futures[future] = job
            return future

        futures: dict[Any, Job] = {}
        queue = as_completed([submit() for _ in range(min(ahead, len(waiting)))])
        try:
            for future in queue:
                made_by, rows = future.result()
                if made_by != wanted:
                    differ = {k: v for k, v in made_by.items() if v != wanted[k]}
                    needed = ", ".join(f"{k} {wanted[k]}" for k in differ)
                    raise InputError("dask", f"a worker with {differ}", f"workers with {needed}", "workers alike")
                job = futures.pop(future)
                if waiting:
                    queue.add(submit())
                yield job, rows
        finally:
            client.cancel(list(futures))

    return run


def _on_worker(plan: tuple[Sweep, tuple[Variable, ...]], job: Job) -> tuple[dict[str, Any], Rows]:
    sweep, arrays = plan
    return maker(), run_batch(sweep, arrays, job.points, job.indices, threads=1)


def connect(address: object) -> Any:
    """Client of a Dask cluster: its address, a scheduler file, or a client already there.

    Raises
    ------
    InputError
        When Dask is missing or nobody answers.
    """
    try:
        from distributed import Client
    except ImportError:
        raise InputError("dask", "nothing installed", "installed", 'pip install "plategait[dask]"') from None
    if isinstance(address, Client):
        return address
    scheduler = "the address of a scheduler that answers"
    if str(address).endswith(".json"):
        # Dask waits for the file for ever; a scheduler that was just started writes it in a moment.
        given_up = time.monotonic() + TIMEOUT
        while not os.path.lexists(str(address)) and time.monotonic() < given_up:
            time.sleep(0.1)
        read_bytes(str(address), LARGEST_JSON, "dask", scheduler, "tcp://127.0.0.1:8786")
    try:
        if str(address).endswith(".json"):
            return Client(scheduler_file=str(address), timeout=TIMEOUT)
        return Client(str(address), timeout=TIMEOUT)
    except (OSError, ValueError, TimeoutError):
        raise InputError("dask", address, scheduler, "tcp://127.0.0.1:8786") from None
