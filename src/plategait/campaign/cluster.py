"""A Dask cluster: how it is reached, and how tasks are handed to its workers, which give the same bits."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, TypeVar

from plategait.campaign.identity import maker
from plategait.errors import InputError
from plategait.files.input import LARGEST_JSON, read_bytes

# Lost workers that a task outlives.
RETRIES = 5
# For which a scheduler is waited for, s.
TIMEOUT = 15

Task = TypeVar("Task")
Made = TypeVar("Made")


def hand_out(
    client: Any, work: Callable[..., Made], tasks: Sequence[Task], *shared: object
) -> Iterator[tuple[Task, Made]]:
    """Do tasks on the workers of a cluster as they become free, each by `work(task, *shared)`; as they end.

    Parameters
    ----------
    client : distributed.Client
    work : callable
        A function of a module, which is sent by its name.
    tasks : sequence
    *shared
        What all tasks take: plain data, or what the cluster holds already (`client.scatter`).

    Raises
    ------
    InputError
        When a worker has another plategait, instruction set or machine, whose bits would differ.
    """
    from distributed import as_completed

    wanted, waiting = maker(), list(tasks)[::-1]
    # Enough that no worker waits, few enough that results do not pile up.
    ahead = 3 * max(1, sum(client.nthreads().values()))

    def submit() -> Any:
        task = waiting.pop()
        future = client.submit(_on_worker, work, task, *shared, pure=False, retries=RETRIES)
        futures[future] = task
        return future

    futures: dict[Any, Task] = {}
    queue = as_completed([submit() for _ in range(min(ahead, len(waiting)))])
    try:
        for future in queue:
            made_by, made = future.result()
            if made_by != wanted:
                differ = {k: v for k, v in made_by.items() if v != wanted[k]}
                needed = ", ".join(f"{k} {wanted[k]}" for k in differ)
                raise InputError("dask", f"a worker with {differ}", f"workers with {needed}", "workers alike")
            task = futures.pop(future)
            if waiting:
                queue.add(submit())
            yield task, made
    finally:
        client.cancel(list(futures))


def _on_worker(work: Callable[..., Made], task: object, *shared: object) -> tuple[dict[str, Any], Made]:
    return maker(), work(task, *shared)


@contextmanager
def connected(dask: object) -> Iterator[Any]:
    """Client of a Dask cluster while it is needed; None where no cluster was asked for.

    Parameters
    ----------
    dask : str, path or distributed.Client, optional
        The cluster's address, its scheduler file, or a client already there, which stays open.

    Raises
    ------
    InputError
        When Dask is missing or nobody answers.
    """
    client = None if dask is None else _connect(dask)
    try:
        yield client
    finally:
        if client is not None and client is not dask:
            client.close()


def _connect(address: object) -> Any:
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
