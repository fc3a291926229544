"""Two sheets on one plate, brought to a goal each by the same motions, and held there."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.control.blend import BLIND, REST, BlendingController
from plategait.control.goal import HOLD, WITHIN, WITHIN_ANGLE, Goal, check_goals, off
from plategait.control.menu import Menu
from plategait.control.observer import Observer
from plategait.control.pair_value import PairTable, PairTime
from plategait.control.plant import Plant
from plategait.control.pulse import Pulses
from plategait.control.response import TICK, stopped, wrapped
from plategait.control.steer import DARK, Arrival, Steering
from plategait.errors import InputError
from plategait.model.motion import PlateMotion
from plategait.model.scenario import Scenario

TIMEOUT = 60.0
"""Time after which a pair of goals is given up, s."""
APART = 8e-3
"""What is kept between two sheets, m: they would push each other, which is not simulated."""
TOUCHED = "the sheets touched"
# Both are there within this share of the tolerances, and brought nearer than that where they are not.
_THERE, _WELL = 0.85, 0.6
# What not being there yet counts, s.
_FURTHER = 0.4
# How much nearer counts as a second, m; how near no pulse may bring them, m, and what it counts if it does, s.
_CLOSER, _NEVER, _REFUSED = 4e-3, 2e-3, 1e3
# What ways leave between the sheets, m.
_CLEAR = 6e-3
# What the lesser of the times that places and angles take counts beside the greater.
_LESSER = 0.3
# First pulses that a second one is thought of after, and ticks of those.
_KEPT, _LATER = 48, (3, 8, 18)
# Where the goals are farther than this, s, pulses must move a sheet by some way, m and rad: times are not that sure.
_FAR, _LITTLE = 2.0, np.array([4e-3, 4e-3, math.radians(15)])
# How much longer than planned a pulse may go on.
_LONGER, _LATE = 1.5, 4


def breadth(scenario: Scenario) -> float:
    """Diameter of the circle about an object's middle that holds it, m."""
    outline = scenario.sheet.outline
    x, y = (0.5 * size * np.linspace(-1, 1, 201) for size in outline.size())
    grid = [axis.ravel() for axis in np.meshgrid(x, y)]
    return 2 * float(np.hypot(*grid)[outline.contains(*grid)].max())


class PairController:
    """Chooses a motion each tick, so that two sheets that feel the same motion both come to their goals.

    From rest the pulse is chosen that begins the quickest way: what it takes, what one more after it takes, and the
    time that both sheets then have to go together (`PairTime`). Ends at which the sheets are near the edge or each
    other count against it. While one goes, it is stopped where both come nearest to where they were to end.

    Parameters
    ----------
    menu : Menu
        Its response is that of either sheet, which depends on where they lie across the bar alone.
    goals : (2, 3) array
        x, y, m, and the angle, rad, of either; NaN for any angle.
    tables : sequence of PairTable
        `pair_tables` makes them; they serve all goals.
    pulses : Pulses
    within : (float, float)
        How near to the goals counts as there, m and rad.
    """

    def __init__(
        self,
        menu: Menu,
        goals: Array,
        tables: Sequence[PairTable],
        pulses: Pulses,
        within: tuple[float, float] = (WITHIN, WITHIN_ANGLE),
    ) -> None:
        self.pulses, self.goals = pulses, goals
        self.each = [BlendingController(menu, pulses, goal, within=within) for goal in goals]
        self._within, self._scale = within, np.array([within[0], within[0], within[1]])
        self._breadth = breadth(menu.scenario)
        self._own, self._later = self.each[0].costs(), np.flatnonzero(np.isin(pulses.ticks, _LATER)).astype(np.int64)
        asked = [table for table in tables if np.isfinite(goals[:, table.part]).all()]
        self._times = [PairTime(table, goals, self._breadth + _CLEAR) for table in asked]
        self._little = _LITTLE if np.isfinite(goals[:, 2]).all() else np.array([*_LITTLE[:2], math.inf])
        self.motion, self.made = 0, 0
        self._rested, self._going, self._planned = REST, 0, 0
        self._targets = goals

    def choose(self, observers: Sequence[Observer]) -> int:
        """Motion to take hold from now on, as its place in the menu."""
        blind = max(observer.since_seen for observer in observers) > BLIND
        if self.motion == 0:
            self._rested += 1
            if self._rested >= REST and not blind:
                self._begin(np.array([observer.expected() for observer in observers]))
        else:
            self._going += 1
            if blind or self._nearest(np.array([observer.expected() for observer in observers])) == 0:
                self.motion, self._rested = 0, 0
        return self.motion

    def _begin(self, states: Array) -> None:
        pulse, ends = self.plan(stopped(states))
        motion = int(self.pulses.motion[pulse])
        if motion:
            self.motion, self._targets = motion, ends
            self._planned, self._going, self._rested = int(self.pulses.ticks[pulse]), 0, 0
            self.made += 1

    def _nearest(self, states: Array) -> int:
        """Ticks more after which the sheets come nearest to where they were to end."""
        most = round(_LONGER * self._planned) + _LATE
        ends = self.pulses.response.going(np.full(2, self.motion), states, max(most - self._going, 0))
        away = wrapped(ends - self._targets[:, None]) / self._scale
        return int((away**2).sum(axis=(0, 2)).argmin())

    def left(self, poses: Array) -> Array:
        """(…,) time that the ways from poses (2, …, 3) to the goals take yet, s."""
        parts = np.array([time.of(poses) for time in self._times])
        time = parts.max(axis=0) + _LESSER * (parts.sum(axis=0) - parts.max(axis=0))
        return np.where(self._off(poses) < _WELL, 0.3 * time, time + _FURTHER)

    def _off(self, poses: Array) -> Array:
        """(…,) how far from the goals poses (2, …, 3) are, over the tolerances: the greatest distance or angle."""
        away = [wrapped(np.nan_to_num(goal) - own) for goal, own in zip(self.goals, poses, strict=True)]
        distances = [np.hypot(way[..., 0], way[..., 1]) / self._within[0] for way in away]
        turns = [np.abs(way[..., 2]) / self._within[1] for way, goal in zip(away, self.goals, strict=True)
                 if not math.isnan(goal[2])]  # fmt: skip
        return np.max([*distances, *turns], axis=0)

    def _costs(self, begin: Array, ends: Array, which: NDArray[np.int64]) -> Array:
        """(…, k) what pulses from poses (2, …, 1, 3) to ends (2, …, k, 3) count, s."""
        spread = self.pulses.spread[which]
        costs = self._own[which] + sum(c.outside(own, spread) for c, own in zip(self.each, ends, strict=True))
        before, middle, after = (np.hypot(*np.moveaxis(poses[0] - poses[1], -1, 0)[:2])
                                 for poses in (begin, (begin + ends) / 2, ends))  # fmt: skip
        nearest = np.minimum(middle, after) - spread[:, :2].max(axis=1)
        costs = costs + np.maximum(self._breadth + APART - nearest, 0.0) / _CLOSER
        return costs + np.where(
            (nearest < self._breadth + _NEVER) & (np.minimum(middle, after) < before), _REFUSED, 0.0
        )

    def plan(self, poses: Array) -> tuple[int, Array]:
        """Pulse to make from rest at poses (2, 3), and where it ends; the first, none, where both are there."""
        ends = self.pulses.ends(poses)
        if self._off(poses) < _THERE:
            return 0, ends[:, 0]
        every = np.arange(len(self.pulses.ticks), dtype=np.int64)
        one = self._costs(poses[:, None], ends, every)
        left = self.left(ends)
        if left[0] > _FAR:
            little = np.abs(wrapped(ends - ends[:, :1]) / self._little).max(axis=(0, 2)) < 1
            one = np.where(little, one + _REFUSED, one)
        hopes = one + left
        kept = np.argpartition(hopes[1:], min(_KEPT, len(hopes) - 2))[:_KEPT] + 1
        second = self.pulses.ends(ends[:, kept])[:, :, self._later]
        both = one[kept, None] + self._costs(ends[:, kept, None], second, self._later) + self.left(second)
        # Only where the first brings both there is none to follow: pulses that hardly do anything would win else.
        there = self._off(ends[:, kept]) < _WELL
        alone = np.where(there, hopes[kept], np.inf)
        best = int(kept[np.minimum(alone, both.min(axis=1)).argmin()])
        return best, ends[:, best]


def pair_tables(menu: Menu, pulses: Pulses) -> tuple[PairTable, PairTable]:
    """What pulses do to two sheets at once: with x of both, and with their angles.

    Raises
    ------
    InputError
        For a machine on whose plate it matters where a sheet lies along the bar.
    """
    if any(i for i, _ in menu.response.field.powers):
        raise InputError("machine", menu.drive.machine.name, "one that rocks a plate about the bar and shakes it "
                         "along it, where two sheets are steered", '"source-robot"')  # fmt: skip
    costs = BlendingController(menu, pulses, np.zeros(3)).costs()
    return PairTable(pulses, costs, menu.reach, 0), PairTable(pulses, costs, menu.reach, 2)


def check_pair(
    goals: tuple[Goal, Goal], starts: Array, menu: Menu, within: float = WITHIN, field: str = "goals"
) -> None:
    """Refuse goals that two sheets cannot both come to from starts (2, 3).

    Raises
    ------
    InputError
        For goals off the plate, so near that the sheets would touch, one with an angle and one without, or in another
        order across the bar: what a pulse does to a sheet depends on its place across the bar alone, so that none takes
        one past the other.
    """
    check_goals(goals, menu.scenario)
    one, other = goals
    if (one.angle is None) != (other.angle is None):
        raise InputError(field, "an angle for one of two sheets", "angles for both, or for neither", "Goal(0, 0.03)")
    least = breadth(menu.scenario) + APART
    if math.hypot(one.x - other.x, one.y - other.y) < least:
        raise InputError(field, f"{1e3 * math.hypot(one.x - other.x, one.y - other.y):.1f} mm apart",
                         f"{1e3 * least:.1f} mm apart at least, so that the sheets do not touch",
                         "goals farther apart")  # fmt: skip
    if (one.y - other.y) * (starts[0, 1] - starts[1, 1]) < 0 and abs(one.y - other.y) > 2 * within:
        raise InputError(field, f"y of {1e3 * one.y:g} mm and {1e3 * other.y:g} mm, where the sheets begin at "
                         f"{1e3 * starts[0, 1]:.1f} mm and {1e3 * starts[1, 1]:.1f} mm",
                         "in the order in which they begin: no common motion takes one past the other",
                         "the goals exchanged")  # fmt: skip


@dataclass(eq=False)
class _Pair:
    """Two sheets while they are steered."""

    goals: tuple[Goal, Goal]
    controller: PairController
    observers: tuple[Observer, Observer]
    touch: float
    over: bool = False
    inside: float = math.nan
    motion: int = 0
    arrivals: tuple[Arrival, ...] = ()
    poses: list[Array] = field(default_factory=list)
    seen: list[Array] = field(default_factory=list)
    told: list[tuple[float, PlateMotion]] = field(default_factory=list)

    def judge(self, time: float, status: str, hold: float, timeout: float, within: tuple[float, float]) -> None:
        """Note whether both are there, or given up."""
        errors = [off(pose, goal.pose) for pose, goal in zip(self.poses[-1], self.goals, strict=True)]
        there = all(distance <= within[0] and turn <= within[1] for distance, turn in errors)
        if float(np.hypot(*(self.poses[-1][0] - self.poses[-1][1])[:2])) < self.touch:
            status = status or TOUCHED
        if max(observer.since_seen for observer in self.observers) > DARK:
            status = status or "the camera sees nothing"
        if not there or status:
            self.inside = math.nan
        elif math.isnan(self.inside):
            self.inside = time
        reached = not status and there and time - self.inside >= hold - 1e-9
        if not reached and not status and time >= timeout:
            status = "not within the time"
        self.over = reached or bool(status)
        if self.over:
            arrived = self.inside if reached else math.nan
            self.arrivals = tuple(
                Arrival(goal, reached, arrived, distance, turn, self.controller.made, status)
                for goal, (distance, turn) in zip(self.goals, errors, strict=True)
            )

    def steerings(self, tick: float) -> tuple[Steering, Steering]:
        """What became of each."""
        poses, seen = np.array(self.poses), np.array(self.seen)
        times = np.arange(len(poses)).astype(float) * tick
        one, other = (
            Steering((self.arrivals[i],), times, poses[:, i], seen[:, i], np.tile(self.goals[i].pose, (len(poses), 1)),
                     tuple(self.told))
            for i in (0, 1)
        )  # fmt: skip
        return one, other


def steer_pairs(
    plant: Plant,
    goals: Sequence[tuple[Goal, Goal]],
    menu: Menu,
    *,
    hold: float = HOLD,
    within: tuple[float, float] = (WITHIN, WITHIN_ANGLE),
    timeout: float = TIMEOUT,
    progress: Callable[[float], object] | None = None,
) -> list[tuple[Steering, Steering]]:
    """Steer pairs of equal sheets, each pair on one plate: lanes 0 and 1, 2 and 3, … are always told the same motion.

    Parameters
    ----------
    plant : Plant
        Two lanes for each pair; its tick is 1/60 s.
    goals : sequence of (Goal, Goal)
        One for each pair. It is reached when both sheets are there and stay there together.
    menu : Menu
        Motions, and how either sheet responds to them.
    hold : float
        How long both are to stay there, s.
    within : (float, float)
        How near counts as there, m and rad.
    timeout : float
        Time after which a pair is given up, s.
    progress : callable, optional
        Called with the fraction of the pairs that are done.

    Raises
    ------
    InputError
        For another number of goals, another tick, or goals that `check_pair` or `pair_tables` refuses.
    """
    if len(plant) != 2 * len(goals):
        raise InputError("goals", f"{len(goals)} pairs", f"one for each two of {len(plant)} sheets", "[(Goal, Goal)]")
    if abs(plant.tick - TICK) > 1e-9:
        raise InputError("tick", f"{plant.tick:g} s", f"{TICK:g} s, which responses are measured at", "1 / 60")
    pulses, touch, starts = Pulses(menu.response), breadth(menu.scenario), plant.poses.reshape(-1, 2, 3)
    tables = pair_tables(menu, pulses)
    for number, (pair, begun) in enumerate(zip(goals, starts, strict=True), start=1):
        check_pair(pair, begun, menu, within[0], f"goals.{number}")
    pairs = []
    for number, pair in enumerate(goals):
        controller = PairController(menu, np.array([g.pose for g in pair]), tables, pulses, within)
        one, other = (Observer(plant.camera, menu.response, pose) for pose in starts[number])
        pairs.append(_Pair(pair, controller, (one, other), touch))
    seen, time = plant.seen, 0.0
    while not all(pair.over for pair in pairs):
        poses, status = plant.poses.reshape(-1, 2, 3), plant.status
        for i, pair in enumerate(pairs):
            for j, observer in enumerate(pair.observers):
                lane = 2 * i + j
                if seen.new[lane] and np.isfinite(seen.poses[lane]).all():
                    observer.saw(seen.poses[lane], float(seen.taken[lane]))
            if not pair.over:
                pair.poses.append(poses[i])
                pair.seen.append(seen.poses[2 * i : 2 * i + 2])
                pair.judge(time, status[2 * i] or status[2 * i + 1], hold, timeout, within)
            before = pair.motion
            pair.motion = 0 if pair.over else pair.controller.choose(pair.observers)
            if pair.motion != before:
                pair.told.append((time, menu.motions[pair.motion]))
            for observer in pair.observers:
                observer.told(pair.motion)
        seen = plant.step([menu.motions[pair.motion] for pair in pairs for _ in (0, 1)])
        time += plant.tick
        if progress is not None:
            progress(sum(pair.over for pair in pairs) / len(pairs))
    return [pair.steerings(plant.tick) for pair in pairs]
