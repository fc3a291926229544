"""The plant: sheets on shaking plates, advanced tick by tick, as cameras see them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array, Flags
from plategait.control.camera import NEARLY, Camera, Seen, Stream
from plategait.errors import InputError
from plategait.model.machine import Machine
from plategait.model.presets import Preset
from plategait.model.scenario import Scenario
from plategait.simulation.observables import FOLDED_AREA, HANGING_DEPTH
from plategait.simulation.run import scenarios_of
from plategait.simulation.session import Motions, Session
from plategait.units import Quantity

Counts = NDArray[np.int64]

_TICK = Quantity("s", "s", "0.0166667 s", above=0, at_most=10)
# Recorded past that is kept, and the time between samples, s, where nobody asks for pictures: what is shown now needs
# none, and samples that fall at other times in each lane cost as much as half the steps.
_KEEP = _SAMPLED = 0.1


def at_rest(scenario: Scenario) -> Scenario:
    """Scenario whose plate stands still where its motion holds it."""
    still = scenario.motion.with_valid(angle=0.0, stroke=0.0, waves=(), samples=None)
    return scenario.with_valid(motion=still)


class Plant:
    """Sheets, each on a plate of its own that stands at first, all advanced together from tick to tick.

    Lanes do not know of each other: what happens in one, and what is seen of it, is the same bits in any company.

    Parameters
    ----------
    scenarios : sequence of Scenario, or of what tells one
        A lane each. Their motions say how the plate is held and how smoothly it starts; durations say nothing.
    machine : Machine, name of one, or its file, optional
        Whose limits every motion and change keep; none are kept without.
    camera : Camera, optional
        What sees the sheets; 60 Hz, 0.5 mm, 1 deg, 30 ms late, 5 % missed by default.
    tick : float or str
        Time between what `step` is told, s.
    seeds : sequence of int, optional
        Of each lane's noise; 0, 1, 2, … by default.
    threads : int, optional
        Cores to use; all by default.
    snapshot_interval : float or str
        Time between recorded shapes, s, for pictures; 0 records none.

    Raises
    ------
    InputError
        For what is out of range, or beyond the machine.
    """

    def __init__(
        self,
        scenarios: Sequence[Scenario | Preset | Path | str],
        *,
        machine: Machine | Path | str | None = "source-robot",
        camera: Camera | None = None,
        tick: float | str = 1 / 60,
        seeds: Sequence[int] | None = None,
        threads: int | None = None,
        snapshot_interval: float | str = 0.0,
    ) -> None:
        self.tick = _TICK.read(tick, "tick")
        self.session = Session(
            [at_rest(scenario) for scenario in scenarios_of(scenarios)],
            machine=machine, threads=threads, keep=_KEEP, snapshot_interval=snapshot_interval,
            sample_interval=_SAMPLED if snapshot_interval == 0 else 0.0,
        )  # fmt: skip
        n = len(self.session)
        self._stream = Stream(camera or Camera(), _seeds(list(range(n)) if seeds is None else seeds, n))
        self._ticks = np.zeros(n, dtype=np.int64)
        self._failed = np.full(n, "", dtype="<U14")
        self._poses = self.session.poses
        self._half, self._flat = np.full((2, n), np.inf), np.zeros(n, dtype=bool)
        self._measure(range(n))
        self._expose(np.arange(n))
        self.seen = self._stream.look(self.time)

    def __len__(self) -> int:
        """Return the number of lanes."""
        return len(self.session)

    @property
    def camera(self) -> Camera:
        """What sees the sheets."""
        return self._stream.camera

    @property
    def time(self) -> Array:
        """(n,) time since each sheet was laid down, s."""
        return self._ticks.astype(float) * self.tick

    @property
    def poses(self) -> Array:
        """(n, 3) where the sheets truly lie: x, y, m, and the angle, rad, in ±π."""
        return self._poses

    @property
    def status(self) -> list[str]:
        """What went wrong first with each lane: "left the plate", "turned over", "folded", "diverged", or ""."""
        return self._failed.tolist()

    @property
    def failed(self) -> Flags:
        """(n,) lanes with a status."""
        return self._failed != ""

    def step(self, motions: Motions | None) -> Seen:
        """Go on for a tick, and tell what the cameras have delivered by then.

        Parameters
        ----------
        motions : PlateMotion, or one for each lane, or None
            Motions from now on: one for all, or one each, None for a plate that keeps its own.

        Raises
        ------
        InputError
            For a motion that the machine cannot make or go over to; nothing has moved then.
        """
        session, stream = self.session, self._stream
        begun, at = self.time, 0.0
        while True:
            ahead = stream.due - begun
            stop = float(ahead.min())
            if stop > self.tick + NEARLY:
                break
            if stop > at + NEARLY:
                session.advance(motions, stop - at)
                at, motions, self._poses = stop, None, session.poses
            self._expose(np.flatnonzero(ahead <= stop + NEARLY))
        if self.tick > at + NEARLY:
            session.advance(motions, self.tick - at)
            self._poses = session.poses
        self._ticks = self._ticks + 1
        self._judge()
        self.seen = stream.look(self.time)
        return self.seen

    def reset(
        self,
        lanes: int | Iterable[int] | Flags | None = None,
        scenarios: Scenario | Sequence[Scenario | Preset | Path | str] | None = None,
        seeds: Sequence[int] | None = None,
    ) -> Seen:
        """Lay sheets down anew, all by default, on plates that stand.

        Parameters
        ----------
        lanes : int, several, or (n,) bool array, optional
        scenarios : Scenario, or one for each of those lanes, optional
            What they become, on the same lattice; what they were, by default.
        seeds : sequence of int, optional
            Of the noise of each of those lanes from now on; by default it goes on to what was not drawn before.

        Raises
        ------
        InputError
            For a lane that there is not, or a scenario of another lattice.
        """
        which = self.session.which(lanes)
        if seeds is not None:
            seeds = _seeds(seeds, len(which))
        if isinstance(scenarios, Scenario):
            scenarios = at_rest(scenarios)
        elif scenarios is not None:
            scenarios = [at_rest(scenario) for scenario in scenarios_of(scenarios)]
        self.session.reset(which, scenarios)
        self._stream.reset(which, seeds)
        self._ticks, self._failed = self._ticks.copy(), self._failed.copy()
        self._ticks[which], self._failed[which] = 0, ""
        self._poses = self.session.poses
        self._measure(which)
        self._expose(np.array(which, dtype=np.int64))
        self.seen = self._stream.look(self.time)
        return self.seen

    def push(self, lane: int, velocity: Sequence[float] | Array) -> None:
        """Kick a sheet: along x and y, m/s, and turning, rad/s, in the world; `Session.push`."""
        self.session.push(lane, velocity)

    def become(self, lane: int, scenario: Scenario) -> None:
        """Let a lane be another from now on, where it is, such as on a wet spot; `Session.become`."""
        self.session.become(lane, at_rest(scenario))

    def copy(self) -> Plant:
        """The same sheets where they are, to go on with by themselves: a rollout leaves this plant as it is."""
        other = Plant.__new__(Plant)
        other.__dict__.update(self.__dict__)
        other.session, other._stream = self.session.copy(), self._stream.copy()
        return other

    def restore(self, saved: Plant) -> None:
        """Put the sheets back to where a copy of this plant has them; the copy stays as it is."""
        if not isinstance(saved, Plant) or len(saved) != len(self):
            raise InputError("saved", type(saved).__name__, "a copy of this plant", "plant.copy()")
        self.__dict__.update(saved.copy().__dict__)

    def _measure(self, lanes: Iterable[int]) -> None:
        """Note half the size of each lane's plate, and whether its sheet spans an area."""
        self._half, self._flat = self._half.copy(), self._flat.copy()
        for i in lanes:
            plate = self.session.scenarios[i].plate
            self._half[:, i] = (plate.length / 2, plate.width / 2) if plate else np.inf
            self._flat[i] = len(self.session.scenarios[i].sheet.lattice.cells) > 0

    def _expose(self, lanes: Counts) -> None:
        self._stream.take(lanes, self._poses[lanes])

    def _judge(self) -> None:
        """Note what has gone wrong, as `plategait.simulation.observables.first_failure` tells it of a run."""
        session = self.session
        x, y, z = (session.now(f"centre_{axis}") for axis in "xyz")
        area = np.stack([session.now(f"area_{axis}") for axis in "xyz"])
        size = np.sqrt((area**2).sum(axis=0))
        # Squares cease to be finite before the centre does.
        broken = session.diverged | ~np.isfinite(x + y + z + size)
        with np.errstate(invalid="ignore"):
            folded, over = self._flat & (size < FOLDED_AREA), self._flat & (size >= FOLDED_AREA) & (area[2] < 0)
            hanging = (z < -HANGING_DEPTH) & np.isfinite(self._half[0])
            left = (np.abs(x) > self._half[0]) | (np.abs(y) > self._half[1]) | (hanging & (folded | over))
        kinds = np.select(
            [broken, left, over, folded], ["diverged", "left the plate", "turned over", "folded"], default=""
        )
        self._failed = np.where(self._failed == "", kinds, self._failed)


def _seeds(seeds: Sequence[int], n: int) -> list[int]:
    given = [int(seed) for seed in seeds]
    if len(given) != n or min(given, default=0) < 0:
        raise InputError("seeds", str(list(seeds)), f"{n} whole numbers, 0 or more", str(list(range(n))))
    return given
