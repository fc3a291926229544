"""Random scenarios and commands: none may crash, hang, leave a traceback, or answer with nonsense.

``python -m benchmarks.fuzz [--scenarios 12000] [--commands 500] [--edges 1000] [--seed 1]``, or ``make fuzz``. Each
case is made from the seed and its own number, in a process that may take only so much memory and time. What goes wrong
is printed with the scenario or the command; ``--only scenario:37`` runs that one again. Exit status 1 when anything
did.
"""

from __future__ import annotations

import argparse
import contextlib
import multiprocessing
import os
import sys
import tempfile
import time
import warnings
from collections import Counter
from collections.abc import Iterator
from multiprocessing.connection import Connection, wait

from benchmarks.fuzz_trials import KINDS, TRIALS, Case
from plategait.engine import cpu

STARTING = 60.0  # seconds that a process may take before its first case


def work(connection: Connection, seed: int, cases: list[tuple[str, int]], memory: float) -> None:
    """Run cases one after the other, telling when each begins, what it is, and what became of it."""
    if memory:
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (int(memory * 1e9), int(memory * 1e9)))
    warnings.simplefilter("error")
    os.environ["COLUMNS"] = "100"
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        for kind, index in cases:
            connection.send((kind, index))
            connection.send(TRIALS[kind](seed, index, connection.send))
    connection.send(None)


class Worker:
    """A process with its share of the cases, which another one takes over where it is lost."""

    def __init__(self, seed: int, memory: float, cases: list[tuple[str, int]]) -> None:
        context = multiprocessing.get_context("spawn")
        self.seed, self.memory, self.cases = seed, memory, cases
        self.connection, theirs = context.Pipe()
        self.process = context.Process(target=work, args=(theirs, seed, cases, memory))
        self.process.start()
        theirs.close()
        self.current, self.given = cases[0], ""
        self.heard = time.monotonic() + STARTING
        self.done = self.lost = False

    def answer(self) -> Case | None:
        """Take what the process says: a case that ended, or None."""
        try:
            message = self.connection.recv()
        except EOFError:
            self.process.join()
            self.lost = True
            return Case("lost", f"the process ended with status {self.process.exitcode}")
        self.heard = time.monotonic()
        if isinstance(message, Case):
            return message
        if isinstance(message, str):
            self.given = message
        elif message is None:
            self.done = True
        else:
            self.current, self.given = message, ""
        return None

    def overdue(self, limit: float) -> Case | None:
        """Whether nothing has been heard for too long."""
        self.lost = time.monotonic() - self.heard > limit
        return Case("lost", f"no answer within {limit:g} s") if self.lost else None

    def successors(self) -> list[Worker]:
        """End the process; another one takes the cases after the current one."""
        if self.lost:
            self.process.kill()
        self.process.join()
        rest = self.cases[self.cases.index(self.current) + 1 :]
        return [Worker(self.seed, self.memory, rest)] if self.lost and rest else []


def run_cases(
    seed: int, cases: list[tuple[str, int]], n_workers: int, memory: float, limit: float
) -> Iterator[tuple[str, int, Case, str]]:
    """What became of each case, and what it was, as they end; `limit` is how long one may take, s."""
    workers = [Worker(seed, memory, cases[i::n_workers]) for i in range(n_workers) if cases[i::n_workers]]
    while workers:
        ready = wait([w.connection for w in workers], timeout=0.5)
        for worker in list(workers):
            case = worker.answer() if worker.connection in ready else worker.overdue(limit)
            if case is not None:
                kind, index = worker.current
                yield kind, index, case, worker.given
            if worker.lost or worker.done:
                workers.remove(worker)
                workers += worker.successors()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenarios", type=int, default=12_000)
    parser.add_argument("--commands", type=int, default=500)
    parser.add_argument("--edges", type=int, default=1000, help="scenarios at a plate's edge or on a turntable")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--memory", type=float, default=4.0, help="GB that a process may take; 0 for no limit")
    parser.add_argument("--limit", type=float, default=30.0, help="seconds that a case may take")
    parser.add_argument("--workers", type=int, default=cpu.core_count())
    parser.add_argument("--only", metavar="KIND:NUMBER", help="one case, which is printed")
    told = parser.parse_args()
    if told.only:
        kind, _, index = told.only.partition(":")
        cases = [(kind, int(index))]
    else:
        numbers = zip(KINDS, (told.scenarios, told.commands, told.edges), strict=True)
        cases = [(kind, i) for kind, number in numbers for i in range(number)]
    outcomes: Counter[tuple[str, str]] = Counter()
    problems, begun = 0, time.monotonic()
    for kind, index, case, given in run_cases(told.seed, cases, max(1, told.workers), told.memory, told.limit):
        outcomes[kind, case.outcome] += 1
        problems += bool(case.problem)
        if case.problem or told.only:
            print(f"--- {kind}:{index} of seed {told.seed}: {case.outcome}; {case.problem[:4000] or 'nothing wrong'}")
            print(given[:8000], flush=True)
    for kind in KINDS:
        counts = {outcome: n for (k, outcome), n in sorted(outcomes.items()) if k == kind}
        if counts:
            listed = ", ".join(f"{n} {outcome}" for outcome, n in counts.items())
            print(f"{sum(counts.values())} of {kind}: {listed}")
    print(f"{problems} problems in {time.monotonic() - begun:.0f} s")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
