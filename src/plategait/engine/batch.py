"""Runs of like lattices, side by side in the core: what they are, where they are, and how they go on."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

import plategait._native as _native  # pyright: ignore[reportMissingImports]
from plategait.arrays import Array, Flags
from plategait.engine.packing import Numbers, Rows, Told, features_of, lines_of, pack_courses, parameters_of
from plategait.engine.piece import Piece
from plategait.engine.recording import RunRequest
from plategait.engine.trajectories import table_step
from plategait.model.course import Course, course_of, gone_over, still_needed
from plategait.model.motion import PlateMotion

Precision = Literal["float32", "float64"]
Counts = NDArray[np.int64]

# Tables of sampled trajectories reach so many times as far as the runs are advanced.
_AHEAD = 2.0

# Places in the core's clock (native/parameters.hpp).
TAKEN, _SEEN, DUE, SAMPLED = range(4)
CHANNEL = {name: c for c, name in enumerate(_native.CHANNELS)}


@dataclass(frozen=True, eq=False)
class State:
    """Where runs are. Its arrays are never written to: a copy is the same state.

    Attributes
    ----------
    x, v, edge : (n, n_nodes, 3) arrays
        Positions, m, velocities, m/s, and what the edge of a finite plate remembers; that one is empty without.
    tally : (n, n_tallies) array
        What has added up since the last sample.
    clock : (n, 4) int array
        Steps taken, when the last sample was taken and when the next is due, samples taken.
    last : (n, n_channels) array
        What the runs show now.
    diverged : (n,) bool array
    """

    x: Array
    v: Array
    edge: Array
    tally: Array
    clock: Counts
    last: NDArray[np.floating]
    diverged: Flags


class Batch:
    """Runs of like lattices.

    Parameters
    ----------
    runs : sequence of RunRequest
        Of one lattice.
    precision : {"float32", "float64"}
        Of the arithmetic.
    ends : bool
        Whether every run ends with its scenario's duration, so that no sampled trajectory is wanted beyond.
    """

    def __init__(self, runs: Sequence[RunRequest], precision: Precision, ends: bool) -> None:
        self.runs, self.precision, self._ends = list(runs), precision, ends
        self.courses: list[Course] = [course_of(r.scenario.motion) for r in runs]
        self.stride = np.array([r.stride for r in runs], dtype=np.int64)
        # A sample's time counts from where the stride was last changed.
        self._since_sample, self._since_time = np.zeros(len(runs), dtype=np.int64), np.zeros(len(runs))
        self._thinning = np.array([r.thinning for r in runs], dtype=np.int64)
        # How far the tables of sampled trajectories reach, s.
        self._tabulated = np.array([r.steps * r.scenario.dt if ends else 0.0 for r in runs])
        self._fixed: Numbers = lines_of(runs[0].lattice)
        rows = [parameters_of(r.scenario) for r in self.runs]
        self._parameters = np.array([[row[name] for row in rows] for name in _native.PARAMETERS])
        self._features = features_of(self.runs, self._parameters)
        self.dt = np.array([r.scenario.dt for r in self.runs])
        self._packed: Numbers | None = None
        self._rows: Rows = {}
        self._seen: tuple[State, list[float]] | None = None
        # When what no longer matters was last dropped from each course.
        self._trimmed = [-1.0] * len(runs)
        self.state = self._start()

    def _start(self) -> State:
        n = len(self.runs)
        x, v = (np.stack(vectors) for vectors in zip(*(r.start() for r in self.runs), strict=True))
        return State(
            x=x, v=v, edge=np.zeros_like(x) if self._features[2] else np.zeros(0),
            tally=np.zeros((n, _native.N_TALLIES)), clock=np.zeros((n, _native.N_CLOCKS), dtype=np.int64),
            last=np.full((n, len(CHANNEL)), np.nan, dtype=self.precision), diverged=np.zeros(n, dtype=bool),
        )  # fmt: skip

    def copy(self) -> Batch:
        """The same runs where they are, to go on with by themselves."""
        other = Batch.__new__(Batch)
        other.__dict__.update(self.__dict__)
        other.runs, other.courses = list(self.runs), list(self.courses)
        other._trimmed = list(self._trimmed)
        other.stride, other._thinning = self.stride.copy(), self._thinning.copy()
        other._since_sample, other._since_time = self._since_sample.copy(), self._since_time.copy()
        return other

    @property
    def time(self) -> Array:
        """(n,) time of each run, s."""
        return self.state.clock[:, TAKEN].astype(float) * self.dt

    @property
    def _now(self) -> list[float]:
        """Time of each run, s, kept as long as the runs stay where they are."""
        if self._seen is None or self._seen[0] is not self.state:
            self._seen = (self.state, self.time.tolist())
        return self._seen[1]

    def change(self, j: int, motion: PlateMotion, duration: float) -> None:
        """Let the plate of a run go over to another motion from now on, within a duration, s."""
        self.courses[j] = gone_over(self.courses[j], motion, self._now[j], duration)
        self._trimmed[j] = self._now[j]
        self._packed = None
        if self.runs[j].sample_interval:
            return
        stride = self.runs[j].stride_with(motion)
        if stride != self.stride[j]:
            clock = self.state.clock[j]
            self._since_time[j] = clock[DUE] * float(self.dt[j])
            self._since_sample[j] = clock[SAMPLED]
            self.stride[j] = stride

    def reset(self, j: int, run: RunRequest) -> None:
        """Let a run start anew, as another of the same lattice."""
        self.runs[j], self.courses[j] = run, course_of(run.scenario.motion)
        self.stride[j], self._thinning[j], self._trimmed[j] = run.stride, run.thinning, -1.0
        self._since_sample[j], self._since_time[j] = 0, 0.0
        row = parameters_of(run.scenario)
        self._parameters, self.dt = self._parameters.copy(), self.dt.copy()
        self._parameters[:, j], self.dt[j] = [row[name] for name in _native.PARAMETERS], run.scenario.dt
        self._features, self._packed = features_of(self.runs, self._parameters), None
        before = self.state
        x, v, tally, clock = before.x.copy(), before.v.copy(), before.tally.copy(), before.clock.copy()
        last, diverged = before.last.copy(), before.diverged.copy()
        x[j], v[j] = run.start()
        tally[j], clock[j], last[j], diverged[j] = 0.0, 0, np.nan, False
        edge = before.edge if self._features[2] else np.zeros(0)
        if self._features[2] and not edge.size:
            # The first plate that ends: all other nodes are on theirs, however deep (native/edge.hpp).
            edge = np.zeros_like(x)
            edge[..., 2] = -2.0
        self.state = State(x, v, edge, tally, clock, last, diverged)

    def become(self, j: int, run: RunRequest) -> None:
        """Let a run be another from now on, where it is: its numbers change, sheet and plate stay where they are."""
        self.runs[j] = run
        row = parameters_of(run.scenario)
        self._parameters = self._parameters.copy()
        self._parameters[:, j] = [row[name] for name in _native.PARAMETERS]
        self._features, self._packed, self._rows = features_of(self.runs, self._parameters), None, {}

    def push(self, j: int, velocity: Array) -> None:
        """Give a run's sheet a velocity more, as to a rigid body: (3,) along x and y, m/s, and about z, rad/s."""
        arm = self.state.x[j] - self.state.x[j].mean(axis=0)
        v = self.state.v.copy()
        v[j, :, 0] += velocity[0] - velocity[2] * arm[:, 1]
        v[j, :, 1] += velocity[1] + velocity[2] * arm[:, 0]
        self.state = replace(self.state, v=v)

    def samples_within(self, steps: Counts) -> Counts:
        """(n,) samples that fall due while so many steps are taken."""
        due, end = self.state.clock[:, DUE], self.state.clock[:, TAKEN] + steps
        return np.where((due <= end) & (steps > 0), (end - due) // self.stride + 1, 0)

    def advanced(self, steps: Counts, threads: int, level: str, report: Callable[[int], None]) -> tuple[State, Piece]:
        """Where the runs are some steps later, and what they recorded on the way; the batch itself stays.

        Parameters
        ----------
        steps : (n,) int array
            Steps to take; none are taken of a run that has diverged.
        """
        n, before = len(self.runs), self.state
        steps = np.where(before.diverged, 0, steps)
        # The core writes into copies.
        x, v, edge = before.x.copy(), before.v.copy(), before.edge.copy()
        tally, clock, last = before.tally.copy(), before.clock.copy(), before.last.copy()
        n_samples, first = self.samples_within(steps), before.clock[:, SAMPLED]
        n_pictures = _multiples(first + n_samples, self._thinning) - _multiples(first, self._thinning)
        samples = np.full((n, int(n_samples.max()), len(CHANNEL)), np.nan, dtype=self.precision)
        snapshots = np.zeros((n, int(n_pictures.max()), *x.shape[1:]), dtype=np.float32)
        getattr(_native, f"advance_{self.precision}")(
            **self._fixed, **self._courses_now(steps), n_axial_lines=len(self.runs[0].lattice.axial_lines),
            features=self._features, parameters=self._parameters, steps=steps, stride=self.stride,
            thinning=self._thinning, x=x, v=v, edge=edge, tally=tally, clock=clock, samples=samples,
            snapshots=snapshots, last=last, level=level, threads=threads, progress=report,
        )  # fmt: skip
        taken = clock[:, TAKEN] - before.clock[:, TAKEN]
        written = clock[:, SAMPLED] - first
        interval = self.stride.astype(float) * self.dt
        piece = Piece(
            samples=samples, written=written, first=first, snapshots=snapshots, thinning=self._thinning.copy(),
            pictured=_multiples(first + written, self._thinning) - _multiples(first, self._thinning),
            since_sample=self._since_sample.copy(), since_time=self._since_time.copy(), interval=interval,
            x=x, v=v, dt=self.dt, steps=taken, stopped=before.diverged | (taken < steps),
        )  # fmt: skip
        return State(x, v, edge, tally, clock, last, before.diverged | (taken < steps)), piece

    def knots_for(self, steps: Counts) -> float:
        """Knots that so many steps may need of the runs' sampled trajectories, beyond those there are, at most."""
        reached = self.time + steps * self.dt
        return sum(
            _AHEAD * reached[j] / table_step(self.runs[j].scenario, layer.motion)
            for j, course in enumerate(self.courses)
            for layer in course
            if layer.motion.samples is not None and reached[j] > self._tabulated[j]
        )

    def _courses_now(self, steps: Counts) -> Numbers:
        time = self._now
        reached = self.time + steps * self.dt
        if (reached > self._tabulated).any() and not self._ends:
            # Further than is needed now, or every piece would make them anew.
            self._tabulated, self._packed = np.maximum(_AHEAD * reached, self._tabulated), None
        for j, course in enumerate(self.courses):
            if len(course) == 1 or self._trimmed[j] == time[j]:
                continue
            if (needed := still_needed(course, time[j])) is not course:
                self.courses[j], self._packed = needed, None
        if self._packed is None:
            told = Told([r.scenario for r in self.runs], self.courses, self._tabulated)
            self._packed, self._rows = pack_courses(told, self._rows)
        return self._packed


def _multiples(count: Counts, of: Counts) -> Counts:
    """How many whole multiples there are below a count, 0 among them; none of 0."""
    return np.where(of > 0, -(-count // np.maximum(of, 1)), 0)
