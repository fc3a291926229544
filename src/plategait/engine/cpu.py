"""The native engine: packs runs into batches of like lattices and lets the C++ core advance them."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

import plategait._native as _native  # pyright: ignore[reportMissingImports]
from plategait.arrays import Array, Flags
from plategait.engine.batch import CHANNEL, TAKEN, Batch, Precision, State
from plategait.engine.memory import batch_size, check_memory, check_room
from plategait.engine.piece import Piece
from plategait.engine.recording import Recording, RunRequest
from plategait.engine.session import Counts, Progress, advance_once
from plategait.model.course import Course
from plategait.model.motion import PlateMotion


def core_count() -> int:
    """Cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def instruction_sets() -> list[str]:
    """Instruction sets that this processor and build can run, best first."""
    return list(_native.available_levels())


class Session:
    """Runs that are advanced piece by piece, those of like lattices side by side.

    The results are the same bits however the way is cut into pieces, for any number of threads and any grouping.

    Parameters
    ----------
    runs : sequence of RunRequest
        May differ in everything.
    precision : {"float32", "float64"}
        Of the arithmetic.
    ends : bool
        Whether each run ends with its scenario's duration.
    instruction_set : str, optional
        One of `instruction_sets`; the best by default.

    Raises
    ------
    InputError
        When the runs need more memory than there is.
    """

    def __init__(
        self,
        runs: Sequence[RunRequest],
        precision: Precision = "float32",
        *,
        ends: bool = False,
        instruction_set: str | None = None,
    ) -> None:
        self._ends, self._precision, self._level = ends, precision, instruction_set or instruction_sets()[0]
        sample_bytes = np.dtype(precision).itemsize * len(CHANNEL)
        if ends:
            check_memory(runs, sample_bytes, len(CHANNEL))
        self._groups = [np.array(group) for group in _batches(runs, sample_bytes, ends)]
        self._batches = [Batch([runs[i] for i in group], precision, ends) for group in self._groups]
        places = {int(i): (b, j) for b, group in enumerate(self._groups) for j, i in enumerate(group)}
        self._place = [places[i] for i in range(len(runs))]

    def copy(self) -> Session:
        """The same runs where they are, to go on with by themselves."""
        other = Session.__new__(Session)
        other.__dict__.update(self.__dict__)
        other._batches = [batch.copy() for batch in self._batches]
        return other

    def advance(
        self, steps: Counts, *, threads: int | None = None, progress: Progress | None = None
    ) -> Iterator[tuple[Counts, Piece]]:
        """Take steps, `steps` of each run; none are taken of a run that has diverged.

        What stops it midway, an interrupt or what `progress` raises, leaves all runs where they were.

        Yields
        ------
        (runs, piece)
            Which runs recorded a piece, and the piece.
        """
        total, done = float(steps.sum()), 0.0
        states: list[State] = []
        for group, batch in zip(self._groups, self._batches, strict=True):
            share = float(steps[group].sum())

            def report(count: int, done: float = done, share: float = share) -> None:
                if progress is not None:
                    progress(min(done + min(count, share), total) / total if total else 1.0)

            if not self._ends:
                check_room(
                    batch.samples_within(steps[group]), len(CHANNEL), self._precision, batch.knots_for(steps[group])
                )
            state, piece = batch.advanced(steps[group], threads or core_count(), self._level, report)
            states.append(state)
            done += share
            yield group, piece
        for batch, state in zip(self._batches, states, strict=True):
            batch.state = state

    def change(self, changes: Sequence[tuple[int, PlateMotion, float]]) -> None:
        """Let the plates of runs go over to other motions from now on: run, motion, and within which duration, s."""
        for run, motion, duration in changes:
            batch, j = self._place[run]
            self._batches[batch].change(j, motion, duration)

    def reset(self, run: int, request: RunRequest) -> None:
        """Let a run start anew, as another of the same lattice."""
        batch, j = self._place[run]
        self._batches[batch].reset(j, request)

    def become(self, run: int, request: RunRequest) -> None:
        """Let a run be another of the same lattice, plate and time step from now on, where it is."""
        batch, j = self._place[run]
        self._batches[batch].become(j, request)

    def push(self, run: int, velocity: Array) -> None:
        """Give a run's sheet a velocity more, as to a rigid body: (3,) along x and y, m/s, and about z, rad/s."""
        batch, j = self._place[run]
        self._batches[batch].push(j, velocity)

    @property
    def courses(self) -> list[Course]:
        """Course of each run's plate."""
        return [self._batches[batch].courses[j] for batch, j in self._place]

    @property
    def taken(self) -> Counts:
        """(n,) steps that each run has taken."""
        return self._side_by_side([batch.state.clock[:, TAKEN] for batch in self._batches])

    @property
    def diverged(self) -> Flags:
        """(n,) runs that ceased to be finite, and go on no further."""
        return self._side_by_side([batch.state.diverged for batch in self._batches])

    def now(self, channel: str) -> Array:
        """(n,) what the runs show now of a channel, SI; NaN before they first advance."""
        return self._side_by_side([batch.state.last[:, CHANNEL[channel]].astype(float) for batch in self._batches])

    def _side_by_side(self, parts: Sequence[NDArray]) -> NDArray:
        whole = np.empty(len(self._place), dtype=parts[0].dtype)
        for group, part in zip(self._groups, parts, strict=True):
            whole[group] = part
        return whole


def run(
    runs: Sequence[RunRequest],
    precision: Precision = "float32",
    *,
    threads: int | None = None,
    instruction_set: str | None = None,
    progress: Progress | None = None,
) -> list[Recording]:
    """Advance runs to their ends: a session advanced once.

    Parameters
    ----------
    runs, precision, instruction_set
        As of a `Session`.
    threads : int, optional
        Cores to use; all by default. The results are the same bits for any number and any grouping.
    progress : callable, optional
        Called with the fraction done about 20 times a second; whatever it raises stops the runs.

    Raises
    ------
    InputError
        When the runs need more memory than there is.
    KeyboardInterrupt
        When interrupted from the keyboard.
    """
    session = Session(runs, precision, ends=True, instruction_set=instruction_set)
    return advance_once(session, runs, threads=threads, progress=progress)


def _batches(runs: Sequence[RunRequest], sample_bytes: int, ends: bool) -> list[list[int]]:
    """Indices of the runs that share a lattice; of runs that end, in pieces whose recordings fit in memory."""
    groups: dict[bytes, list[int]] = {}
    for i, r in enumerate(runs):
        groups.setdefault(r.lattice.key, []).append(i)
    if not ends:
        return list(groups.values())
    batches = []
    for group in groups.values():
        size = batch_size(max(runs[i].samples for i in group), sample_bytes)
        batches += [group[i : i + size] for i in range(0, len(group), size)]
    return batches
