"""The contract of all engines: a session keeps runs where they are, and lets them go on."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array, Flags
from plategait.engine.piece import Piece
from plategait.engine.recording import Recording, RunRequest
from plategait.model.course import Course
from plategait.model.motion import PlateMotion

Counts = NDArray[np.int64]
Progress = Callable[[float], object]


class Session(Protocol):
    """What every engine does: it keeps runs where they are, and lets them go on."""

    def copy(self) -> Session:
        """The same runs where they are, to go on with by themselves."""
        ...

    def advance(
        self, steps: Counts, *, threads: int | None = None, progress: Progress | None = None
    ) -> Iterator[tuple[Counts, Piece]]:
        """Take steps, `steps` of each run; yields which runs recorded a piece, and the piece.

        A piece holds every one of `plategait.engine.channels`, sampled when the run's request says (`stride` steps of
        the scenario's `dt`, whatever steps the engine itself takes), and the same in whatever company the run was made
        and however its way is cut into pieces: the same bits by the native core, to rounding by others. A run that
        diverges is told by its piece, and goes on no further; what the engine cannot do, or has not the memory for, is
        refused with an `InputError` before it starts. `threads` are cores to use at most, all by default; `progress` is
        called with the fraction done, and what it raises stops the runs, which are then where they were.
        """
        ...

    def change(self, changes: Sequence[tuple[int, PlateMotion, float]]) -> None:
        """Let the plates of runs go over to other motions from now on: run, motion, and within which duration, s."""
        ...

    def reset(self, run: int, request: RunRequest) -> None:
        """Let a run start anew, as another of the same lattice."""
        ...

    def become(self, run: int, request: RunRequest) -> None:
        """Let a run be another of the same lattice, plate and time step from now on, where it is."""
        ...

    def push(self, run: int, velocity: Array) -> None:
        """Give a run's sheet a velocity more, as to a rigid body: (3,) along x and y, m/s, and about z, rad/s."""
        ...

    @property
    def courses(self) -> list[Course]:
        """Course of each run's plate."""
        ...

    @property
    def taken(self) -> Counts:
        """(n,) steps that each run has taken."""
        ...

    @property
    def diverged(self) -> Flags:
        """(n,) runs that ceased to be finite, and go on no further."""
        ...

    def now(self, channel: str) -> Array:
        """(n,) what the runs show now of a channel, SI; NaN before they first advance."""
        ...


class Opener(Protocol):
    """Opens a session of an engine."""

    def __call__(self, runs: Sequence[RunRequest], *, ends: bool = False) -> Session:
        """Session of runs that may differ in everything; each ends with its scenario's duration where `ends`."""
        ...


def advance_once(
    session: Session, runs: Sequence[RunRequest], *, threads: int | None = None, progress: Progress | None = None
) -> list[Recording]:
    """Advance the runs of a session to their ends: a recording of each, in their order."""
    recordings: dict[int, Recording] = {}
    steps = np.array([r.steps for r in runs], dtype=np.int64)
    for indices, piece in session.advance(steps, threads=threads, progress=progress):
        recordings.update((int(i), piece.recording(j)) for j, i in enumerate(indices))
    return [recordings[i] for i in range(len(runs))]
