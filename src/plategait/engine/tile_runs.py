"""The reference engine behind the contract of all engines: runs in, pieces of recordings of rigid tiles out.

Double precision, one core, hundreds of times slower than the native engine: a second opinion on a few runs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.engine.channels import CHANNELS
from plategait.engine.memory import check_memory
from plategait.engine.piece import Piece
from plategait.engine.recording import Recording, RunRequest
from plategait.engine.session import Counts, Progress, advance_once
from plategait.engine.tile_group import Group, advanced, substeps_of
from plategait.errors import InputError
from plategait.model.course import Course, course_of
from plategait.model.motion import PlateMotion


class Session:
    """Runs that are advanced piece by piece; the plate keeps its motion.

    Parameters
    ----------
    runs : sequence of RunRequest
        On a plate without end that moves by (4.1) and (4.2). Tiles start level.
    ends : bool
        Whether each run ends with its scenario's duration: those of like sheets and steps are then advanced side by
        side.

    Raises
    ------
    InputError
        For what tiles cannot do, or runs that need more memory than there is.
    """

    def __init__(self, runs: Sequence[RunRequest], *, ends: bool = False) -> None:
        for r in runs:
            _check(r)
        if ends:
            check_memory(runs, 8 * len(CHANNELS), len(CHANNELS))
        self._runs = len(runs)
        self._indices = [
            indices for _, group in _groups(runs) for indices in ([group] if ends else [[i] for i in group])
        ]
        self._groups = [Group.begun([runs[i] for i in indices]) for indices in self._indices]

    def copy(self) -> Session:
        """The same runs where they are, to go on with by themselves."""
        other = Session.__new__(Session)
        other.__dict__.update(self.__dict__)
        other._groups = list(self._groups)
        return other

    def advance(
        self, steps: Counts, *, threads: int | None = None, progress: Progress | None = None
    ) -> Iterator[tuple[Counts, Piece]]:
        """Take steps, `steps` of each run, on one core; yields which runs recorded a piece, and the piece."""
        groups, total, done = [], float(steps.sum()), 0.0
        for indices, group in zip(self._indices, self._groups, strict=True):
            share = float(steps[indices].sum()) / total if total else 0.0

            def report(fraction: float, done: float = done, share: float = share) -> None:
                if progress is not None:
                    progress(min(done + share * fraction, 1.0))

            after, piece = advanced(group, int(steps[indices[0]]), report)
            groups.append(after)
            done += share
            yield np.array(indices), piece
        self._groups = groups

    def change(self, changes: Sequence[tuple[int, PlateMotion, float]]) -> None:
        """Refuse other motions."""
        if not changes:
            return
        raise InputError("motions", "another motion", 'the same throughout for the engine "tiles"', 'the engine "cpu"')

    def reset(self, run: int, request: RunRequest) -> None:
        """Let a run start anew, as another."""
        _check(request)
        self._groups[self._indices.index([run])] = Group.begun([request])

    def become(self, run: int, request: RunRequest) -> None:
        """Refuse other numbers midway."""
        raise InputError("scenario", "another midway", 'the same throughout for the engine "tiles"', 'the engine "cpu"')

    def push(self, run: int, velocity: Array) -> None:
        """Refuse a push."""
        raise InputError("velocity", "a push", 'left out for the engine "tiles"', 'the engine "cpu"')

    @property
    def courses(self) -> list[Course]:
        """Course of each run's plate."""
        first = dict(
            (run, course_of(group.runs[0].scenario.motion))
            for group, indices in zip(self._groups, self._indices, strict=True)
            for run in indices
        )
        return [first[run] for run in range(self._runs)]

    @property
    def taken(self) -> Counts:
        """(n,) steps that each run has taken."""
        return self._side_by_side(lambda group: np.full(len(group.runs), group.count // group.substeps))

    @property
    def diverged(self) -> NDArray[np.bool_]:
        """(n,) runs that ceased to be finite, and go on no further."""
        return self._side_by_side(lambda group: group.broken)

    def now(self, channel: str) -> Array:
        """(n,) what the runs show now of a channel, SI; NaN before they first advance, and of what adds up."""
        return self._side_by_side(lambda group: group.shows(channel))

    def _side_by_side(self, of: Callable[[Group], NDArray]) -> NDArray:
        parts = [of(group) for group in self._groups]
        whole = np.empty(self._runs, dtype=parts[0].dtype)
        for indices, part in zip(self._indices, parts, strict=True):
            whole[indices] = part
        return whole


def run(runs: Sequence[RunRequest], *, threads: int | None = None, progress: Progress | None = None) -> list[Recording]:
    """Advance runs to their ends, as a session does.

    Raises
    ------
    InputError
        For what tiles cannot do, or runs that need more memory than there is.
    """
    return advance_once(Session(runs, ends=True), runs, threads=threads, progress=progress)


def _check(run: RunRequest) -> None:
    """Refuse what tiles cannot do."""
    motion, ratio = run.scenario.motion, run.scenario.sheet.shear_ratio
    for field, asked, got, allowed in (
        ("plate", run.scenario.plate is not None, "a plate that ends", "one without end"),
        ("motion.waves", bool(motion.waves), f"{len(motion.waves)} further sines", "none beside (4.1) and (4.2)"),
        ("motion.offset", any(motion.offset.pose), "a plate held off its rest", "none beside (4.1) and (4.2)"),
        ("motion.samples", motion.samples is not None, "a sampled trajectory", "the sines of (4.1) and (4.2)"),
        ("sheet.shear_ratio", ratio != 1, ratio, "1, as rigid tiles do not shear,"),
        ("held", run.held is not None, "held nodes", "a free sheet"),
        ("sheet", len(run.lattice.rest) > 1 and not len(run.lattice.axial_edges), "tiles that share no edge", "joints"),
    ):
        if asked:
            raise InputError(field, got, f'{allowed} for the engine "tiles"', 'the engine "cpu"')


def _shared(run: RunRequest) -> tuple[object, ...]:
    """What the runs of a batch have in common."""
    s = run.scenario
    friction = (s.friction.transition_speed, s.friction.kinetic_speed_ratio, s.friction.law)
    sheet = (run.lattice.key, s.sheet.pitch, s.sheet.thickness, s.sheet.node_mass)
    return (*sheet, s.contact.damping_ramp, s.motion.height, s.motion.ramp, s.gravity, *friction, run.steps, s.dt)


def _groups(runs: Sequence[RunRequest]) -> list[tuple[int, list[int]]]:
    """Runs that are advanced together, with the tiles' steps in each of theirs: those that each needs by itself."""
    alike: dict[tuple[object, ...], list[int]] = {}
    for i, r in enumerate(runs):
        alike.setdefault(_shared(r), []).append(i)
    groups: dict[tuple[int, tuple[object, ...]], list[int]] = {}
    for shared, members in alike.items():
        for i, substeps in zip(members, substeps_of([runs[i] for i in members]), strict=True):
            groups.setdefault((substeps, shared), []).append(i)
    return [(substeps, group) for (substeps, _), group in groups.items()]
