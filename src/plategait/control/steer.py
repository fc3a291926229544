"""Steering: sheets brought to poses, held there, or carried from place to place, with all that it took."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from plategait.arrays import Array
from plategait.control.blend import REST, BlendingController
from plategait.control.camera import Seen
from plategait.control.futures import Futures
from plategait.control.goal import HOLD, WITHIN, WITHIN_ANGLE, Goal, check_goals, off
from plategait.control.learn import Learner
from plategait.control.menu import Menu
from plategait.control.mppi import FUTURES, SamplingController
from plategait.control.observer import Observer
from plategait.control.plant import Plant
from plategait.control.pulse import Pulses
from plategait.control.response import TICK
from plategait.errors import InputError
from plategait.model.motion import PlateMotion
from plategait.shown import Shown

Method = Literal["blend", "mppi", "open-loop", "one-pulse"]
METHODS: tuple[Method, ...] = ("blend", "mppi", "open-loop", "one-pulse")
"""Controllers by name: blending pulses; sampling futures by the engine; blending without looking; one pulse only."""
TIMEOUT = 30.0
"""Time after which a goal is given up, s."""
DARK = 2.0
"""Time without a frame after which steering ends with a stopped plate, s."""


@dataclass(frozen=True, eq=False)
class Arrival:
    """How it went with one goal.

    Attributes
    ----------
    goal : Goal
    reached : bool
        Whether it was held within the tolerances for as long as asked.
    time : float
        When it came there to stay, s from when it was aimed for; NaN where it did not.
    error, angle_error : float
        How far from it the object truly was in the end, m and rad.
    pulses : int
    status : str
        Why not, in a word or two; "" where it was reached.
    """

    goal: Goal
    reached: bool
    time: float
    error: float
    angle_error: float
    pulses: int
    status: str


@dataclass(frozen=True, eq=False, repr=False)
class Steering(Shown):
    """A sheet's way to its goals.

    Attributes
    ----------
    arrivals : tuple of Arrival
        Of each goal that was aimed for.
    times : (n,) array
        s.
    poses : (n, 3) array
        True poses, tick by tick.
    seen : (n, 3) array
        What the camera had delivered by then, NaN before the first frame.
    aims : (n, 3) array
        Goal at each tick.
    motions : tuple of (s, PlateMotion)
        What the plate was told, and when.
    """

    arrivals: tuple[Arrival, ...]
    times: Array
    poses: Array
    seen: Array
    aims: Array
    motions: tuple[tuple[float, PlateMotion], ...]

    def told(self) -> list[tuple[str, str]]:
        """How it went with each goal."""
        ways = [
            (f"goal {k}", f"reached in {a.time:.2f} s" if a.reached else a.status or "not reached")
            for k, a in enumerate(self.arrivals, start=1)
        ]
        reached = sum(a.reached for a in self.arrivals)
        return [("reached", f"{reached} of {len(self.arrivals)}"), ("ticks", str(len(self.times))), *ways]

    @property
    def reached(self) -> bool:
        """Whether all goals were reached."""
        return all(arrival.reached for arrival in self.arrivals)


@dataclass(eq=False)
class _Lane:
    """One sheet while it is steered."""

    goals: Sequence[Goal]
    motions: tuple[PlateMotion, ...]
    controller: BlendingController
    observer: Observer
    learner: Learner | None
    looks: bool = True
    number: int = 0
    begun: float = 0.0
    inside: float = math.nan
    arrivals: list[Arrival] = field(default_factory=list)
    poses: list[Array] = field(default_factory=list)
    seen: list[Array] = field(default_factory=list)
    aims: list[Array] = field(default_factory=list)
    told: list[tuple[float, PlateMotion]] = field(default_factory=list)
    motion: int = 0
    resting: int = REST
    before: Array | None = None
    last: tuple[int, int] = (0, 0)

    @property
    def over(self) -> bool:
        return self.number >= len(self.goals)


def steer(
    plant: Plant,
    goals: Sequence[Sequence[Goal]],
    menu: Menu,
    *,
    method: Method = "blend",
    learns: bool = True,
    hold: float = HOLD,
    within: tuple[float, float] = (WITHIN, WITHIN_ANGLE),
    timeout: float = TIMEOUT,
    each_tick: Callable[[Plant, float], object] | None = None,
    look: Callable[[Plant], Seen] | None = None,
    controller: Callable[[Pulses], BlendingController] | None = None,
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> list[Steering]:
    """Steer the sheets of a plant, each to its goals one after the other.

    Parameters
    ----------
    plant : Plant
        Its tick is 1/60 s.
    goals : sequence of sequences of Goal
        One for each lane.
    menu : Menu
        Motions, and how the object that is believed to lie there responds to them.
    method : {"blend", "mppi", "open-loop", "one-pulse"}
    learns : bool
        Whether the responses are learnt as the object moves; MPPI asks the engine and learns none.
    hold : float
        How long the object is to stay at each goal, s; 0 for a way from place to place.
    within : (float, float)
        How near counts as there, m and rad.
    timeout : float
        Time after which a goal is given up, s.
    each_tick : callable, optional
        Called with the plant and the time before each tick: for kicks, wet spots, and whatever else may happen.
    look : callable, optional
        What tells poses instead of the plant's own cameras, such as a tracker.
    controller : callable, optional
        Makes each lane's controller of the menu's pulses, in place of a method's.
    threads : int, optional
        Cores that futures are rolled forward on; all by default.
    progress : callable, optional
        Called with the fraction of the goals that are done.

    Raises
    ------
    InputError
        For a goal off the plate, another number of goals, or another tick.
    """
    if len(goals) != len(plant):
        raise InputError("goals", f"{len(goals)} lists", f"one for each of {len(plant)} sheets", "[[Goal(0, 0)]]")
    if method not in METHODS:
        raise InputError("method", method, f"one of {', '.join(METHODS)}", "blend")
    if abs(plant.tick - TICK) > 1e-9:
        raise InputError("tick", f"{plant.tick:g} s", f"{TICK:g} s, which responses are measured at", "1 / 60")
    for own in goals:
        check_goals(own, menu.scenario)
    total = sum(len(own) for own in goals)
    controlled = _controlled(method, menu, within, threads) if controller is None else _given(controller, menu)
    seen = plant.seen if look is None else look(plant)
    learns, looks = learns and method != "mppi", method != "open-loop"
    lanes = [_lane(plant, i, own, menu, controlled, learns, looks, seen) for i, own in enumerate(goals)]
    time = 0.0
    while not all(lane.over for lane in lanes):
        for i, lane in enumerate(lanes):
            _decide(lane, plant, i, seen, time, hold, within, timeout)
        if each_tick is not None:
            each_tick(plant, time)
        seen = plant.step([lane.controller.told(lane.motions) for lane in lanes])
        seen = seen if look is None else look(plant)
        time += plant.tick
        if progress is not None:
            progress(sum(lane.number for lane in lanes) / max(total, 1))
    return [_told(lane, plant.tick) for lane in lanes]


def _lane(
    plant: Plant, i: int, goals: Sequence[Goal], menu: Menu, controlled: Callable[[Array, int], BlendingController],
    learns: bool, looks: bool, seen: Seen,
) -> _Lane:  # fmt: skip
    scenario = plant.session.scenarios[i]
    start = np.array([scenario.start.x, scenario.start.y, scenario.start.angle])
    first = seen.poses[i] if np.isfinite(seen.poses[i]).all() else start
    return _Lane(
        goals, menu.raised(scenario.motion.height), controlled(goals[0].pose if goals else np.zeros(3), i),
        Observer(plant.camera, menu.response, first), Learner(menu.response) if learns and looks else None, looks,
    )  # fmt: skip


def _controlled(
    method: Method, menu: Menu, within: tuple[float, float], threads: int | None
) -> Callable[[Array, int], BlendingController]:
    """What makes the controller of a goal and a lane."""
    pulses = Pulses(menu.response)
    if method == "mppi":
        futures = Futures(menu.scenario.with_valid(motion=menu.motions[0]), FUTURES, threads)
        return lambda goal, lane: SamplingController(menu, pulses, goal, futures, within, seed=lane)
    most, looks = 1 if method == "one-pulse" else None, method != "open-loop"
    return lambda goal, _: BlendingController(menu, pulses, goal, most, within, looks)


def _given(
    controller: Callable[[Pulses], BlendingController], menu: Menu
) -> Callable[[Array, int], BlendingController]:
    pulses = Pulses(menu.response)
    return lambda _, __: controller(pulses)


def _decide(
    lane: _Lane, plant: Plant, i: int, seen: Seen, time: float, hold: float,
    within: tuple[float, float], timeout: float,
) -> None:  # fmt: skip
    """Look, judge, learn and choose for one sheet."""
    pose, status = plant.poses[i], plant.status[i]
    observer = lane.observer
    moved = False
    if seen.new[i] and np.isfinite(seen.poses[i]).all() and (lane.looks or time < 0.2):
        moved = observer.saw(seen.poses[i], float(seen.taken[i]))
    if lane.over:
        lane.motion = 0
    else:
        lane.poses.append(pose)
        lane.seen.append(seen.poses[i])
        lane.aims.append(lane.controller.goal)
        _judge(lane, pose, status, time, hold, within, timeout)
    if not lane.over:
        _learn(lane, moved)
        before, lane.motion = lane.motion, lane.controller.choose(observer)
        if lane.motion != before:
            lane.told.append((time, lane.controller.told(lane.motions)))
    observer.told(lane.motion)


def _judge(
    lane: _Lane, pose: Array, status: str, time: float, hold: float, within: tuple[float, float], timeout: float
) -> None:
    """Note whether the goal is reached, or given up."""
    goal = lane.goals[lane.number]
    distance, turn = off(pose, goal.pose)
    there = distance <= within[0] and turn <= within[1] and lane.controller.finished
    if not there or status:
        lane.inside = math.nan
    elif math.isnan(lane.inside):
        lane.inside = time
    dark = lane.looks and lane.observer.since_seen > DARK
    status = status or ("the camera sees nothing" if dark else "")
    reached = not status and there and time - lane.inside >= hold - 1e-9
    if not reached and not status and time - lane.begun >= timeout:
        status = "not within the time"
    if reached or status:
        arrived = lane.inside - lane.begun if reached else math.nan
        pulses = lane.controller.made
        lane.arrivals.append(Arrival(goal, reached, arrived, distance, turn, pulses, "" if reached else status))
        lost = bool(status) and status != "not within the time"
        lane.number = len(lane.goals) if lost else lane.number + 1
        lane.begun, lane.inside = time, math.nan
        if not lane.over:
            lane.controller.aim(lane.goals[lane.number].pose)


def _learn(lane: _Lane, moved: bool) -> None:
    """Learn from a pulse once the object rests, and follow how it turns meanwhile."""
    if lane.motion:
        ticks = 0 if lane.resting else lane.last[1]
        lane.last, lane.resting = (lane.motion, ticks + 1), 0
        return
    lane.resting += 1
    if lane.resting != REST:
        return
    after = lane.observer.pose
    if lane.before is not None and lane.last[0] and lane.learner is not None and not moved:
        motion, ticks = lane.last
        ends = lane.controller.pulses.going(motion, np.array([*lane.before, 0.0, 0.0, 0.0]), ticks)
        expected = ends[-1]
        # The angle as it went on: the turn next to what was expected.
        turn = expected[2] + math.remainder(after[2] - expected[2], 2 * math.pi)
        rates = lane.learner.saw(motion, ticks, lane.before, np.array([*after[:2], turn]), lane.observer.deviation)
        lane.controller.learnt(motion, rates)
        lane.observer.response = lane.controller.pulses.response
    lane.before, lane.last = after, (0, 0)


def _told(lane: _Lane, tick: float) -> Steering:
    count = len(lane.poses)
    return Steering(
        tuple(lane.arrivals), np.arange(count).astype(float) * tick, np.array(lane.poses).reshape(count, 3),
        np.array(lane.seen).reshape(count, 3), np.array(lane.aims).reshape(count, 3), tuple(lane.told),
    )  # fmt: skip
