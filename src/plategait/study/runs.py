"""Runs of the studies: simulated once, kept in a journal, and found there by what they were of."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from plategait.campaign.journal import Journal, open_journal
from plategait.campaign.seal import hash_of
from plategait.engine.engines import engine
from plategait.engine.recording import Recording, RunRequest
from plategait.errors import InputError
from plategait.model.plain import plain_model
from plategait.model.scenario import Scenario
from plategait.simulation.observables import GAITS
from plategait.simulation.observation import observe
from plategait.simulation.run import starts as starts_of
from plategait.study.measured import Measured, Row
from plategait.study.progress import Progress

SEED = 0
"""Of the starts."""
Measure = Callable[[Scenario, Recording], Row]
"""From a run to its plain numbers, by name."""
# Runs side by side, and lost where a study is killed: enough to fill the engine's lanes on all cores.
_BATCH = 128


def everything(scenario: Scenario, recording: Recording) -> Row:
    """Every observable of a run, SI; `gait` 0, 1, 2 for sliding, walking, running; `failed` 0 or 1.

    A run that failed has no number that it did not keep until its end: all but `gait`, `failed` and `failure_time`
    are NaN.
    """
    seen = observe(scenario, recording)
    failed = seen.failure is not None
    values = {"spin_rate": seen.spin.rate, "spin_rate_sd": seen.spin.sd, **seen.values}
    row = {name: math.nan if failed else float(value) for name, value in values.items()}
    gait = float(GAITS.index(seen.gait)) if seen.gait else math.nan
    return row | {
        "gait": gait,
        "failed": float(failed),
        "failure_time": seen.failure.time if seen.failure else math.nan,
    }


class Runs:
    """Runs simulated where they are missing, and remembered; the same bits however often the work was interrupted.

    Parameters
    ----------
    journal : Journal, optional
        Where what was done is kept; in memory by default.
    progress : callable, optional
        Called with the simulated time that was done or found, s.
    """

    def __init__(self, journal: Journal | None = None, progress: Callable[[float], object] | None = None) -> None:
        self._journal = Journal() if journal is None else journal
        self._done = {key: row for entry in self._journal.entries for key, row in entry["rows"].items()}
        self.progress = progress
        self.simulated = 0.0

    def measure(
        self,
        scenarios: Sequence[Scenario],
        *,
        repeats: int = 1,
        half_step: bool = False,
        measure: Measure = everything,
        interval: float = 0.0,
    ) -> Measured:
        """What scenarios show, from several starts, and where asked for again at half the time step.

        Parameters
        ----------
        scenarios : sequence of Scenario
        repeats : int
            Starts of each, as of `plategait.simulation.run.simulate_all`, with `SEED`.
        half_step : bool
            Whether all of it is run at half the time step too.
        measure : callable
            A module's function from scenario and recording to a row of numbers; its name is part of the key.
        interval : float
            Time between samples, s; 0 for what observables need.
        """
        offsets = starts_of(repeats, SEED)
        halved = [s.replace(time_step=s.dt / 2) for s in scenarios] if half_step else []
        requests = [
            RunRequest(s, offset, sample_interval=interval) for s in (*scenarios, *halved) for offset in offsets
        ]
        rows = self._rows(requests, measure)
        points = tuple(tuple(rows[i : i + repeats]) for i in range(0, len(rows), repeats))
        return Measured(points[: len(scenarios)], points[len(scenarios) :] if half_step else None)

    def once(
        self, what: Mapping[str, Any], work: Callable[[], dict[str, Any]], simulated: float = 0.0
    ) -> dict[str, Any]:
        """What a piece of work gives that is no plain run: done once, and remembered.

        Parameters
        ----------
        what : mapping
            All that decides it, as JSON can hold it.
        work : callable
            Gives what JSON can hold.
        simulated : float
            How much it simulates, s, for the progress.
        """
        key = hash_of(what)
        if key not in self._done:
            self._keep({key: work()})
        self._tell(simulated)
        return self._done[key]

    def _rows(self, requests: Sequence[RunRequest], measure: Measure) -> list[Row]:
        keys = [_key(request, measure) for request in requests]
        missing = list({key: i for i, key in enumerate(keys) if key not in self._done}.values())
        self._tell(sum(r.scenario.duration for r in requests) - sum(requests[i].scenario.duration for i in missing))
        for begin in range(0, len(missing), _BATCH):
            some = missing[begin : begin + _BATCH]
            recordings = engine("cpu").run([requests[i] for i in some], threads=None, progress=None)
            pairs = zip(some, recordings, strict=True)
            self._keep({keys[i]: measure(requests[i].scenario, recording) for i, recording in pairs})
            self._tell(sum(requests[i].scenario.duration for i in some))
        return [self._done[key] for key in keys]

    def _keep(self, rows: dict[str, dict[str, Any]]) -> None:
        # A line for a batch: each is waited for until it lies on the disk.
        self._journal.add({"rows": rows})
        self._done |= rows

    def _tell(self, simulated: float) -> None:
        self.simulated += simulated
        if self.progress is not None:
            self.progress(self.simulated)


def _key(request: RunRequest, measure: Measure) -> str:
    """Hash of all that decides a run's row; of the nodes too, as the picture of an outline may change."""
    lattice = hashlib.sha256(request.lattice.key).hexdigest()
    return hash_of([plain_model(request.scenario), lattice, request.offset, request.sample_interval, measure.__name__])


@contextmanager
def open_runs(folder: Path | None, progress: Progress | None = None, expected: float = 1.0) -> Iterator[Runs]:
    """Runs kept in a folder, or in memory alone.

    Parameters
    ----------
    folder : Path, optional
        Made where there is none; one of another version or kind of machine is refused.
    progress : callable, optional
        Called with the share that is done.
    expected : float
        Simulated time that is expected in all, s.

    Raises
    ------
    InputError
        When the folder is none of these, is held by another process, or cannot be written to.
    """
    try:
        with open_journal(folder, "study", {"format": 2}) as journal:
            tell = None if progress is None else lambda done: progress(min(done / expected, 1.0))
            yield Runs(journal, tell)
    except InputError as error:
        if error.field != "store":
            raise
        raise InputError("--out", error.got, error.allowed, "another --out") from None
