"""Trials of motions: each run from several starts, and with several draws of what is not known of the object."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from plategait.arrays import Array, Flags
from plategait.campaign.points import seed_of
from plategait.campaign.seal import hash_of
from plategait.engine.engines import Engine
from plategait.model.machine import Machine
from plategait.model.motion import PlateMotion
from plategait.model.needs import needs
from plategait.model.scenario import Scenario
from plategait.optimize.diary import Diary
from plategait.optimize.goal import Cost
from plategait.optimize.runs import COLUMNS, MOST_AT_ONCE, Measure, Portion, on_dask, portions, rows_of
from plategait.simulation.observables import student_95
from plategait.simulation.run import starts

_BENDING, _LASTED, _FAILED = 3, 4, 5


@dataclass(frozen=True, eq=False)
class Trial:
    """A motion and what its runs showed.

    Attributes
    ----------
    shares : (d,) array
        Where it lies in the space that is searched.
    motion : PlateMotion
    needed : mapping of str to float
        What it costs the machine (`plategait.optimize.goal.COSTS`), SI; NaN where the machine does not tell its masses.
    rows : (runs, columns) array
        `COLUMNS` of each run, and what else was asked; NaN where a failure left nothing to measure.
    """

    shares: Array
    motion: PlateMotion
    needed: Mapping[Cost, float]
    rows: Array

    @property
    def runs(self) -> int:
        """Number of runs."""
        return len(self.rows)

    @property
    def failed(self) -> int:
        """Number of runs that failed."""
        return int(self.rows[:, _FAILED].sum())

    @property
    def lasted(self) -> float:
        """Mean share of the time before a failure: 1 where none failed."""
        return float(self.rows[:, _LASTED].mean())

    @cached_property
    def _counted(self) -> Array:
        sound = self.rows[(self.rows[:, _FAILED] == 0) & np.isfinite(self.rows[:, :_BENDING]).all(axis=1)]
        return sound

    @property
    def counted(self) -> int:
        """Number of runs that the velocity is over: those that did not fail."""
        return len(self._counted)

    @cached_property
    def twist(self) -> Array:
        """(3,) mean velocity along, across and turning of the runs that did not fail, SI; NaN where all did."""
        return self._counted[:, :3].mean(axis=0) if self.counted else np.full(3, math.nan)

    @property
    def spread(self) -> Array:
        """(3,) standard deviation of that over the runs; NaN for fewer than two."""
        return self._counted[:, :3].std(axis=0, ddof=1) if self.counted > 1 else np.full(3, math.nan)

    @property
    def twists(self) -> Array:
        """(counted, 3) velocity of each run that did not fail, SI."""
        return self._counted[:, :3]

    @property
    def further(self) -> Array:
        """(counted, …) what else was asked of each run that did not fail."""
        return self._counted[:, len(COLUMNS) :]

    @property
    def half_width(self) -> Array:
        """(3,) half the 95 % interval of the mean velocity; NaN for fewer than two runs."""
        return student_95(max(self.counted - 1, 1)) * self.spread / math.sqrt(max(self.counted, 1))

    @property
    def spin_rate(self) -> float:
        """Mean spin rate, rad/s."""
        return float(self.twist[2])

    def cost(self, name: Cost) -> float:
        """What it costs, SI; NaN where that is not known."""
        if name != "bending":
            return self.needed[name]
        return float(self._counted[:, _BENDING].mean()) if self.counted else math.nan

    def joined(self, more: Trial) -> Trial:
        """With the runs of another trial of the same motion."""
        return Trial(self.shares, self.motion, self.needed, np.concatenate([self.rows, more.rows]))


class Tally:
    """How much of the work is done.

    Parameters
    ----------
    progress : callable, optional
        Takes the fraction done.
    total : float
        Runs that are expected, each as often as its time step is fine.
    """

    def __init__(self, progress: Callable[[float], object] | None, total: float) -> None:
        self._progress, self._total, self._done = progress, total, 0.0

    @property
    def done(self) -> float:
        """Runs that were made."""
        return self._done

    def add(self, runs: float) -> None:
        """Count runs that were made, and report."""
        self._done += runs
        if self._progress is not None:
            self._progress(min(self._done / self._total, 1.0))

    def of(self, runs: float) -> Callable[[float], object] | None:
        """What takes the fraction done of so many runs more."""
        if self._progress is None:
            return None
        report = self._progress
        return lambda fraction: report(min((self._done + fraction * runs) / self._total, 1.0))


Placing = Callable[[int, int], Sequence[tuple[float, float, float]]]
"""Starts of so many runs with a seed: x, y and angle added to the scenario's own."""


def near(runs: int, seed: int) -> Sequence[tuple[float, float, float]]:
    """Starts that differ slightly. The first of an ensemble's is the nominal one, the same in every batch: left out."""
    return starts(runs + 1, seed)[1:]


@dataclass(frozen=True, eq=False)
class Bench:
    """Where motions are tried: the objects, the machine, and how runs are made.

    Attributes
    ----------
    objects : tuple of Scenario
        The object as it may be: one, or draws of what was measured of it.
    machine : Machine
    seed : int
        Of starts and draws.
    engine : str
    diary : Diary
    threads : int, optional
    tally : Tally
        Told of the runs as they are made.
    placing : callable
        Where the runs of a motion start.
    further : tuple of callable
        What else is measured of each run: functions of a module, as workers of a cluster take.
    client : distributed.Client, optional
        Of the Dask cluster that makes the runs; this machine's cores by default.
    """

    objects: tuple[Scenario, ...]
    machine: Machine
    seed: int
    engine: Engine
    diary: Diary
    threads: int | None = None
    tally: Tally = field(default_factory=lambda: Tally(None, 1.0))
    placing: Placing = near
    further: tuple[Measure, ...] = ()
    client: Any = None

    @property
    def reach(self) -> float:
        """Half the object's size, m."""
        return max(max(scenario.sheet.outline.size()) for scenario in self.objects) / 2

    def try_motions(
        self,
        asked: Sequence[tuple[Array, PlateMotion]],
        runs: int,
        batch: int,
        *,
        finer: int = 1,
        engine: Engine | None = None,
    ) -> list[Trial]:
        """Trials of motions, all in one batch.

        Parameters
        ----------
        asked : sequence of (shares, motion)
        runs : int
            Of each motion: starts of their own, and objects in an order of their own, the same for all motions.
        batch : int
            Number of the batch, from which starts and objects follow.
        finer : int
            How many times as fine the time step is.
        engine : str, optional
            The bench's own by default.
        """
        kind = engine or self.engine
        key = hash_of([[repr(motion) for _, motion in asked], self.seed, batch, runs, finer, kind])
        work = float(len(asked) * runs * finer)
        rows = self.diary.told(key)
        if rows is None:
            scenarios = [
                scenario.replace(motion=motion) for _, motion in asked for scenario in self._set_up(runs, batch)
            ]
            if finer > 1:
                scenarios = [scenario.replace(time_step=scenario.dt / finer) for scenario in scenarios]
            rows = self._rows(scenarios, kind, finer)
            self.diary.tell(key, rows)
        else:
            self.tally.add(work)
        each = rows.reshape(len(asked), runs, -1)
        return [
            Trial(shares, motion, costs_of(motion, self.machine, self.reach), own)
            for (shares, motion), own in zip(asked, each, strict=True)
        ]

    def _rows(self, scenarios: Sequence[Scenario], engine: Engine, finer: int) -> Array:
        """What is kept of each run; no more of them at once than their recordings should take memory."""
        rows = np.empty((len(scenarios), len(COLUMNS) + len(self.further)))
        for portion, made in self._made(scenarios, engine, finer):
            rows[portion.first : portion.first + len(made)] = made
            self.tally.add(float(len(made) * finer))
        return rows

    def _made(self, scenarios: Sequence[Scenario], engine: Engine, finer: int) -> Iterator[tuple[Portion, Array]]:
        if self.client is not None:
            yield from on_dask(self.client, scenarios, engine, self.further)
            return
        for portion in portions(scenarios, MOST_AT_ONCE):
            within = self.tally.of(float(len(portion.scenarios) * finer))
            yield portion, rows_of(portion, engine, self.further, self.threads, within)

    def _set_up(self, runs: int, batch: int) -> list[Scenario]:
        """Objects where they start, for each run of a motion in a batch."""
        seed = seed_of(self.seed, batch)
        order = np.random.default_rng(seed).permutation(len(self.objects))
        scenarios = []
        for i, (x, y, angle) in enumerate(self.placing(runs, seed)):
            scenario = self.objects[order[i % len(order)]]
            at = scenario.start
            moved = {"start.x": at.x + x, "start.y": at.y + y, "start.angle": at.angle + angle}
            scenarios.append(scenario.replace(**moved))
        return scenarios


def costs_of(motion: PlateMotion, machine: Machine, reach: float) -> dict[Cost, float]:
    """What a motion costs the machine, SI (`plategait.optimize.goal.COSTS`); NaN where its masses are not told.

    Parameters
    ----------
    motion : PlateMotion
    machine : Machine
    reach : float
        Half the object's size, m: where the plate's acceleration counts.
    """
    needed = needs(motion, machine, start=False)
    accelerations, loads = needed.peaks[2], needed.peaks[4]
    felt = np.hypot(np.linalg.norm(accelerations[:3]), reach * np.linalg.norm(accelerations[3:]))
    return {"acceleration": float(felt), "torque": float(loads[3:].max()), "power": float(needed.power)}


def no_failure(trials: Sequence[Trial]) -> Flags:
    """(n,) trials none of whose runs failed, and that have something to measure."""
    return np.array([trial.failed == 0 and trial.counted > 0 for trial in trials])
