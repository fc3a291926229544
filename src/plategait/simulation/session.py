"""A session: sheets that stay where they are while their plates go on, from one motion to the next."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

from plategait.arrays import Array, Flags
from plategait.engine import engines
from plategait.engine.channels import CHANNELS, check_series
from plategait.engine.engines import Engine
from plategait.engine.piece import Piece
from plategait.engine.recording import Recording, RunRequest
from plategait.errors import InputError
from plategait.model.course import Course
from plategait.model.machine import Machine, machine_of
from plategait.model.motion import AXES, PlateMotion
from plategait.model.needs import join_durations, start_duration
from plategait.model.presets import Preset
from plategait.model.scenario import MOST_STEPS, STEPS_PER_SINE, Scenario
from plategait.simulation.observation import Observation, observe
from plategait.simulation.pieces import joined
from plategait.simulation.run import INTERVAL, check_threads, scenarios_of
from plategait.units import Quantity

Motions = PlateMotion | Sequence[PlateMotion | None]

_DURATION = Quantity("s", "s", "0.1 s", above=0)
_KEPT = Quantity("s", "s", "10 s", above=0)


class Session:
    """Runs that go on from where they are: ``session.advance(motions, 1 / 60)``.

    A change of motion is gone over to smoothly: position, speed and acceleration of the plate are continuous. It takes
    the new motion's `ramp`, or as much longer as the machine's limits ask for. Sines count from the start of the run,
    so that a changed amplitude keeps the phase; a new sampled trajectory begins when it is given.

    The results are the same bits however a way is cut into pieces, for any number of threads and in any company; and
    those of `simulate`, which is a session advanced once. How motions are joined is in docs/sessions.md.

    Parameters
    ----------
    scenarios : sequence of Scenario, or of what tells one
        A run each; they may differ in everything. Their durations say nothing here.
    engine : {"cpu", "cpu64", "tiles"}
        As of `simulate_all`.
    machine : Machine, name of one, or its file, optional
        Whose limits every motion, start and change keep.
    snapshot_interval : float or str
        Time between recorded shapes, s; 0 records none.
    sample_interval : float or str
        Time between samples, s; 0 for a 24th of each plate's period, at most 2 ms, as observables need.
    threads : int, optional
        Cores to use; all by default.
    keep : float or str
        How much is kept of what the runs recorded, s: no observable looks back further.

    Raises
    ------
    InputError
        For no scenario, or what is out of range or beyond the machine's limits.
    """

    def __init__(
        self,
        scenarios: Sequence[Scenario | Preset | Path | str],
        *,
        engine: Engine = "cpu",
        machine: Machine | Path | str | None = None,
        snapshot_interval: float | str = 0.0,
        sample_interval: float | str = 0.0,
        threads: int | None = None,
        keep: float | str = 10.0,
    ) -> None:
        opener = engines.engine(engine).load()
        check_threads(threads)
        self._interval, self._keep = INTERVAL.read(snapshot_interval, "snapshot_interval"), _KEPT.read(keep, "keep")
        self._sampled = INTERVAL.read(sample_interval, "sample_interval")
        self._machine = None if machine is None else machine_of(machine)
        self._threads = threads
        self.scenarios = scenarios_of(scenarios)
        requests = [self._request(scenario) for scenario in self.scenarios]
        self._engine = opener(requests)
        self._dt = np.array([r.scenario.dt for r in requests])
        self._wanted = np.zeros(len(requests))
        self._places: dict[int, tuple[int, int]] = {}
        self._pieces: deque[tuple[float, list[Piece]]] = deque()
        self._kept = 0.0
        # Advances that came before the first kept one, and those from which each run's pieces and motion count.
        self._forgotten, self._since_reset, self._since_change = 0, [0] * len(requests), [0] * len(requests)

    def _request(self, scenario: Scenario) -> RunRequest:
        """A run, whose start takes as long as the machine asks for."""
        if self._machine is not None:
            ramp = start_duration(scenario.motion, self._machine, "motion")
            if ramp != scenario.motion.ramp:
                scenario = scenario.with_valid(motion=scenario.motion.with_valid(ramp=ramp))
        return RunRequest(scenario, snapshot_interval=self._interval, sample_interval=self._sampled)

    def __len__(self) -> int:
        """Return the number of runs."""
        return len(self.scenarios)

    def copy(self) -> Session:
        """The same runs where they are, to go on with by themselves: a rollout leaves this session as it is."""
        other = Session.__new__(Session)
        other.__dict__.update(self.__dict__)
        other._engine, other._pieces, other._wanted = self._engine.copy(), self._pieces.copy(), self._wanted.copy()
        other.scenarios, other._dt = list(self.scenarios), self._dt.copy()
        other._since_reset, other._since_change = list(self._since_reset), list(self._since_change)
        return other

    def restore(self, saved: Session) -> None:
        """Put the runs back to where a copy of this session has them; the copy stays as it is."""
        if not isinstance(saved, Session) or len(saved) != len(self):
            raise InputError("saved", type(saved).__name__, "a copy of this session", "session.copy()")
        self.__dict__.update(saved.copy().__dict__)

    def advance(self, motions: Motions | None, duration: float | str) -> None:
        """Let all runs go on.

        A run that has diverged stays where it is until it is reset. What stops the runs midway, such as an interrupt
        from the keyboard, leaves the session as it was.

        Parameters
        ----------
        motions : PlateMotion, or one for each run, or None
            Motions from now on: one for all, or one each, None for a plate that keeps its own.
        duration : float or str
            How long, s. Durations add up exactly: sixty times 1/60 s is as good as one second.

        Raises
        ------
        InputError
            For a motion that the run's time step is too long for, or that the machine cannot make or go over to.
        """
        length = _DURATION.read(duration, "duration")
        if length > MOST_STEPS * float(self._dt.min()):
            raise InputError(
                "duration", f"{length:g} s", f"at most {MOST_STEPS * float(self._dt.min()):.3g} s", '"1 s"'
            )
        changes = self._changes(motions)
        engine = self._engine.copy() if changes else self._engine
        if changes:
            engine.change(changes)
        wanted = self._wanted + length
        steps = np.rint(wanted / self._dt).astype(np.int64) - engine.taken
        pieces = []
        for indices, piece in engine.advance(np.maximum(steps, 0), threads=self._threads):
            if not self._pieces and not self._forgotten:
                self._places.update((int(i), (len(pieces), j)) for j, i in enumerate(indices))
            pieces.append(piece)
        self._engine, self._wanted = engine, wanted
        for i, *_ in changes:
            self._since_change[i] = self._forgotten + len(self._pieces)
        self._pieces.append((length, pieces))
        self._kept += length
        while len(self._pieces) > 1 and self._kept - self._pieces[0][0] >= self._keep:
            self._kept -= self._pieces.popleft()[0]
            self._forgotten += 1

    def _changes(self, motions: Motions | None) -> list[tuple[int, PlateMotion, float]]:
        """Runs whose motion changes, with the new one and how long the plate takes to go over to it."""
        if motions is None:
            return []
        each = [motions] * len(self) if isinstance(motions, PlateMotion) else list(motions)
        if len(each) != len(self):
            raise InputError(
                "motions", f"{len(each)} motions", f"one, or one for each of {len(self)} runs", "one for all"
            )
        engine, dt, time = self._engine, self._dt.tolist(), self.time.tolist()
        runs: list[int] = []
        changed: list[PlateMotion] = []
        courses: list[Course] = []
        for i, (motion, course) in enumerate(zip(each, engine.courses, strict=True)):
            if motion is None:
                continue
            if not isinstance(motion, PlateMotion):
                raise InputError(f"motions.{i}", type(motion).__name__, "a PlateMotion", "scenario.motion.replace(...)")
            last = course[-1].motion
            # Most that differ do so in their frequency.
            if motion is last or (motion.frequency == last.frequency and motion == last):
                continue
            _check_change(i, last, motion, dt[i])
            runs.append(i)
            changed.append(motion)
            courses.append(course)
        fields, times = [f"motions.{i}" for i in runs], [time[i] for i in runs]
        joins = join_durations(courses, changed, times, self._machine, fields)
        return list(zip(runs, changed, joins, strict=True))

    def reset(
        self,
        runs: int | Iterable[int] | Flags | None = None,
        scenarios: Scenario | Sequence[Scenario | Preset | Path | str] | None = None,
    ) -> None:
        """Let runs start anew, all by default.

        Parameters
        ----------
        runs : int, several, or (n,) bool array, optional
        scenarios : Scenario, or one for each of those runs, optional
            What they become; what they were, by default. The lattice stays the same.

        Raises
        ------
        InputError
            For a run that there is not, or a scenario of another lattice.
        """
        which = self.which(runs)
        given = [scenarios] * len(which) if isinstance(scenarios, Scenario) else scenarios
        becoming = [self.scenarios[i] for i in which] if given is None else scenarios_of(given)
        if len(becoming) != len(which):
            raise InputError(
                "scenarios", f"{len(becoming)} scenarios", f"one for each of {len(which)} runs", "one for all"
            )
        requests = [self._request(scenario) for scenario in becoming]
        for i, request in zip(which, requests, strict=True):
            if request.lattice.key != RunRequest(self.scenarios[i]).lattice.key:
                raise InputError(
                    f"scenarios.{i}", "a sheet of another lattice", "one with the same nodes", "another session"
                )
        for i, scenario, request in zip(which, becoming, requests, strict=True):
            self._engine.reset(i, request)
            self.scenarios[i], self._dt[i], self._wanted[i] = scenario, request.scenario.dt, 0.0
            self._since_reset[i] = self._since_change[i] = self._forgotten + len(self._pieces)

    def become(self, run: int, scenario: Scenario) -> None:
        """Let a run be another from now on, where it is: a spot where the plate is wet, a sheet that warms up.

        Sheet, contact, friction and gravity take effect at once; lattice, time step and motion stay. A later `reset`
        starts what the run became.

        Parameters
        ----------
        run : int
        scenario : Scenario
            As ``session.scenarios[run].replace(**{"friction.static": 0.3})``.

        Raises
        ------
        InputError
            For a run that there is not, another lattice, plate, start or motion, or a sheet too stiff for the time
            step.
        """
        i = self._one(run)
        own, dt = self.scenarios[i], float(self._dt[i])
        for field in ("plate", "start", "motion"):
            if getattr(scenario, field) != getattr(own, field):
                raise InputError(
                    f"scenario.{field}", "another", f"that of run {i}", "session.scenarios[run].replace(…)"
                )
        if (scenario.sheet.lattice.key, scenario.sheet.pitch) != (own.sheet.lattice.key, own.sheet.pitch):
            raise InputError("scenario.sheet", "a sheet of another lattice", "one with the same nodes", "a reset")
        if scenario.sheet.stable_time_step < dt or scenario.time_step not in (own.time_step, dt):
            raise InputError("scenario.time_step", f"a sheet that needs {scenario.dt:.3g} s", f"the run's {dt:.3g} s",
                             "a session of scenarios with a shorter time_step")  # fmt: skip
        became = scenario.with_valid(time_step=dt)
        engine = self._engine.copy()
        engine.become(i, RunRequest(became, snapshot_interval=self._interval, sample_interval=self._sampled))
        self._engine, self.scenarios[i] = engine, became

    def push(self, run: int, velocity: Sequence[float] | Array) -> None:
        """Kick a run's sheet: give it a velocity more, as to a rigid body.

        Parameters
        ----------
        run : int
        velocity : (3,) numbers
            Along x and y, m/s, and turning counter-clockwise about the middle of its mass, rad/s; in the world, level.

        Raises
        ------
        InputError
            For a run that there is not, or what are not three finite numbers.
        """
        i, given = self._one(run), np.asarray(velocity, dtype=float)
        if given.shape != (3,) or not np.isfinite(given).all():
            raise InputError("velocity", str(velocity), "three numbers: m/s, m/s, rad/s", "(0.2, 0.0, 0.0)")
        engine = self._engine.copy()
        engine.push(i, given)
        self._engine = engine

    def which(self, runs: int | Iterable[int] | Flags | None) -> list[int]:
        """Numbers of the runs that are meant: one, several, those of a flag for each, or all."""
        if runs is None:
            return list(range(len(self)))
        told = np.atleast_1d(np.asarray(list(runs) if isinstance(runs, Iterable) else runs))
        which = np.flatnonzero(told) if told.dtype == bool and len(told) == len(self) else told
        if which.dtype.kind not in "iu" or (which.size and not 0 <= which.min() <= which.max() < len(self)):
            raise InputError("runs", told.tolist(), f"numbers from 0 to {len(self) - 1}, or a flag for each run", "0")
        return which.tolist()

    @property
    def time(self) -> Array:
        """(n,) time that each run has come to since its start, s."""
        return self._engine.taken.astype(float) * self._dt

    @property
    def diverged(self) -> Flags:
        """(n,) runs that ceased to be finite, and stay where they are."""
        return self._engine.diverged

    @property
    def motions(self) -> list[PlateMotion]:
        """Motion that each plate has, or goes over to."""
        return [course[-1].motion for course in self._engine.courses]

    def now(self, channel: str) -> Array:
        """(n,) what the runs show now of a channel, SI; NaN before their first advance.

        Raises
        ------
        InputError
            For a channel that there is not.
        """
        if channel not in CHANNELS:
            check_series([channel], "channel")
            return np.arctan2(self._engine.now("spin_cross"), self._engine.now("spin_dot"))
        return self._engine.now(channel)

    @property
    def poses(self) -> Array:
        """(n, 3) where the sheets lie now on their plates: x, y, m, and the angle they are turned by, rad, in ±π."""
        poses = np.stack([self.now("centre_x"), self.now("centre_y"), self.now("rotation")], axis=1)
        for i in np.flatnonzero(self._engine.taken == 0):
            start = self.scenarios[i].start
            poses[i] = start.x, start.y, math.remainder(start.angle, 2 * math.pi)
        return poses

    def shape(self, run: int) -> tuple[Array, Array]:
        """Where a sheet's nodes are now, (n_nodes, 3), m, in the world; and its plate, (6,), m and rad."""
        i = self._one(run)
        if self._engine.taken[i] == 0:
            request = self._request(self.scenarios[i])
            return request.start()[0], request.scenario.motion.pose_at_start()
        group, j = self._places[i]
        pose = np.array([self.now(f"plate_{axis}")[i] for axis in AXES])
        return self._pieces[-1][1][group].x[j].copy(), pose

    def recording(self, run: int) -> Recording:
        """What is kept of what a run recorded since its start.

        Raises
        ------
        InputError
            For a run that there is not, or nothing recorded.
        """
        return self._recorded(self._one(run), self._since_reset)

    def observe(self, run: int, transient: float | str | None = None) -> Observation:
        """What a run shows since its motion last changed, as far back as is kept.

        Failures and drift count from where the sheet was then.

        Parameters
        ----------
        run : int
        transient : float or str, optional
            Time after the change before anything is measured, s; 30 % of the time since then by default, or the
            scenario's own.
        """
        i = self._one(run)
        recording = self._recorded(i, self._since_change)
        begin, end = float(recording["time"][0]), float(recording["time"][-1])
        length = max(end - begin, float(self._dt[i]))
        skipped = self.scenarios[i].transient if transient is None else INTERVAL.read(transient, "transient")
        skipped = 0.3 * length if skipped is None else min(skipped, length)
        measured = self.scenarios[i].with_valid(
            motion=self._engine.courses[i][-1].motion, duration=length, transient=skipped, time_step=float(self._dt[i])
        )
        channels = {**recording.channels, "time": recording["time"] - begin}
        return observe(measured, joined([recording], channels))

    def _one(self, run: int) -> int:
        return self.which(run)[0]

    def _recorded(self, i: int, since: Sequence[int]) -> Recording:
        first = max(since[i] - self._forgotten, 0)
        group, j = self._places.get(i, (0, 0))
        pieces = [pieces[group].recording(j) for _, pieces in list(self._pieces)[first:]]
        if not any(len(piece["time"]) for piece in pieces):
            raise InputError("runs", f"run {i}, of which nothing was recorded yet", "advanced first", "session.advance")
        return joined(pieces)


def _check_change(i: int, before: PlateMotion, motion: PlateMotion, dt: float) -> None:
    """Refuse a motion that a run under way cannot be given."""
    if motion.height != before.height:
        raise InputError(f"motions.{i}.height", f"{motion.height:g} m", f"{before.height:g} m, as it was",
                         "another session")  # fmt: skip
    if min(motion.shortest_period, motion.period) < STEPS_PER_SINE * dt:
        raise InputError(f"motions.{i}.frequency", f"a sine of {1 / motion.shortest_period:g} Hz",
                         f"at most {1 / (STEPS_PER_SINE * dt):g} Hz at the session's time step of {dt:g} s",
                         "scenarios with a shorter time_step")  # fmt: skip
