"""Steering: responses fitted to pulses, the observer, ways counted in pulses, and a sheet brought to its goal."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import plategait.control.menu as menu_module
from plategait.control.blend import BLIND
from plategait.control.camera import Camera, Seen
from plategait.control.futures import Futures
from plategait.control.goal import Goal, check_goals, off, read_goal
from plategait.control.identify import TAIL, PulseRuns, fitted
from plategait.control.learn import Learner
from plategait.control.menu import Menu, menu_of
from plategait.control.observer import Observer
from plategait.control.plant import Plant
from plategait.control.pulse import Pulses
from plategait.control.reach import Reach
from plategait.control.response import ACROSS, DELAY, LONGEST, TICK, Field, Response, resting
from plategait.control.room import on_a_plate
from plategait.control.steer import Arrival, Method, steer
from plategait.control.value import TimeToGo
from plategait.errors import InputError
from plategait.simulation.session import Session

# Of v_x, v_y and the turning: everywhere, and by each 50 mm across the bar and its square.
RATES = np.array([[0.02, -0.075, 0.0], [0.05, -0.01, 0.03], [1.0, 0.15, -0.5]])
FIELD = Field(ACROSS[:3])


def response_of(rates: np.ndarray, lag: float = 0.1) -> Response:
    still = resting(1, FIELD)
    return Response(
        np.concatenate([still.rates, rates[None]]), np.concatenate([still.lags, np.full((1, 3), lag)]),
        np.full((2, 3), 1e-3), np.zeros(2, dtype=bool), FIELD,
    )  # fmt: skip


def gone(response: Response, start: np.ndarray, ticks: int) -> np.ndarray:
    state, track = np.array([*start, 0, 0, 0]), [start]
    for k in range(LONGEST + TAIL + DELAY):
        state = response.step(1 if DELAY <= k < ticks + DELAY else 0, state)
        track.append(state[:3])
    return np.array(track)


def test_response_is_found_again_from_pulses_that_follow_it():
    true = response_of(RATES)
    starts = np.random.default_rng(1).uniform(-0.03, 0.03, (12, 3))
    ticks = np.tile([6, LONGEST], 6)
    tracks = np.array([gone(true, start, n) for start, n in zip(starts, ticks, strict=True)])
    room = np.full(2, np.inf)
    run = PulseRuns(tracks, np.ones(12, dtype=np.int64), ticks, np.ones(12, dtype=bool), room)
    found = fitted(run, 2, FIELD)
    np.testing.assert_allclose(found.lags[1], 0.1)
    # The fit takes an object's place at the begin of each tick, as the steps do: only rounding differs.
    np.testing.assert_allclose(found.rates[1], RATES, atol=1e-8)
    assert found.spread[1].max() < 1e-9
    assert not found.failed.any()


def test_slopes_are_those_of_the_steps():
    response = response_of(RATES)
    state, small = np.array([0.01, -0.02, 0.3, 0.05, -0.02, 1.0]), 1e-6
    found = np.column_stack([
        (response.step(1, state + small * unit) - response.step(1, state - small * unit)) / (2 * small)
        for unit in np.eye(6)
    ])  # fmt: skip
    # Central differences of a parabola are exact but for rounding.
    np.testing.assert_allclose(response.slope(1, state), found, atol=1e-8)


def test_pulses_end_where_the_response_brings_an_object():
    response = response_of(RATES)
    pulses, state = Pulses(response), np.array([0.01, -0.02, 0.3, 0.0, 0.0, 0.0])
    for ends, ticks in zip(pulses.ends(state[:3])[1:], pulses.ticks[1:], strict=True):
        moved = pulses.going(1, state, int(ticks))[-1] - state[:3]
        # A parabola stands for what is one but for how far the object goes meanwhile: a few hundredths of its way.
        np.testing.assert_allclose(ends - state[:3], moved, rtol=0.04)


def test_time_to_go_is_what_the_pulses_take():
    """Two motions each way along every component: a way takes as many pulses as it is long, whatever the order."""
    rates = np.concatenate([np.diag([0.1, 0.1, 2.0]), -np.diag([0.1, 0.1, 2.0])])[:, :, None] * [1.0, 0.0, 0.0]
    still = resting(1, FIELD)
    response = Response(np.concatenate([still.rates, rates]), np.full((7, 3), 0.02), np.zeros((7, 3)),
                        np.zeros(7, dtype=bool), FIELD)  # fmt: skip
    pulses = Pulses(response)
    costs = pulses.times + 0.2
    to_go = TimeToGo(pulses, costs, np.array([0.0, 0.0, 0.0]), 0.08)
    poses = np.array([[0.06, 0.0, 0.0], [0.0, 0.04, 0.0], [0.0, 0.0, 2.0], [0.06, 0.04, 2.0]])
    times = to_go.of(poses)
    # At the best share of time in motion, 26 ticks of each 26 + 12: 0.68 of the speed, and near the goal, where short
    # pulses count, 8 of 20. The grid tells it to a tenth.
    for time, least, most in zip(times[:3], (0.6, 0.4, 1.0), (1.6, 1.2, 2.6), strict=True):
        assert least / 0.68 * 0.9 <= time <= most
    assert times[3] == pytest.approx(times[:3].sum(), rel=0.15)


def test_observer_follows_what_the_plate_was_told_through_delay_and_missing_frames():
    response = response_of(RATES)
    draw = np.random.default_rng(2)
    observer = Observer(Camera(), response, np.zeros(3))
    state, states = np.zeros(6), []
    held = [0] * DELAY
    for k in range(60):
        states.append(state)
        if k >= 2 and draw.random() > 0.05:
            noise = draw.standard_normal(3) * [0.5e-3, 0.5e-3, math.radians(1)]
            observer.saw(states[k - 2][:3] + noise, (k - 2) * TICK)
        motion = 1 if 10 <= k < 40 else 0
        observer.told(motion)
        held.append(motion)
        state = response.step(held.pop(0), state)
    for motion in held:
        state = response.step(motion, state)
    # Within four standard deviations of one frame, though it is two ticks late.
    assert np.abs(observer.pose - state[:3])[:2].max() < 2e-3
    assert abs(observer.pose[2] - state[2]) < math.radians(4)


def test_observer_finds_a_sheet_that_was_pushed_away():
    observer = Observer(Camera(), resting(), np.zeros(3))
    moved = []
    for k in range(1, 8):
        observer.told(0)
        moved.append(observer.saw(np.array([0.02, 0.01, 0.3]), k * TICK))
    assert any(moved)
    np.testing.assert_allclose(observer.pose[:2], [0.02, 0.01], atol=1e-3)


def test_learner_comes_to_what_pulses_did():
    known, true = response_of(RATES), response_of(1.4 * RATES)
    learner, draw = Learner(known), np.random.default_rng(3)
    for _ in range(30):
        before = draw.uniform(-0.02, 0.02, 3)
        learner.saw(1, 8, before, gone(true, before, 8)[-1], np.full(3, 1e-4))
    # Places change within a pulse, and its middle stands for them: V_x of -2.1/s by 2 mm are 4 mm/s.
    np.testing.assert_allclose(learner.rates[1][:, 0], 1.4 * RATES[:, 0], rtol=0.1, atol=5e-3)


def test_ways_take_as_long_as_the_best_mixture_of_pulses():
    moved = np.concatenate([np.eye(3), -np.eye(3)]) * 0.01
    reach = Reach(moved, np.full(6, 0.22))
    # Along one pulse, 0.22 s for each 10 mm; two ways add up.
    assert reach.time(np.array([0.02, 0, 0])) == pytest.approx(0.44)
    assert reach.time(np.array([0.02, -0.01, 0])) == pytest.approx(0.66)
    with pytest.raises(InputError, match="cannot carry"):
        Reach(np.abs(moved) + 1e-3 * np.random.default_rng(0).random((6, 3)), np.full(6, 0.1))


def test_goals_are_read_and_those_off_the_plate_refused():
    goal = read_goal("30 mm, -10 mm, 90 deg")
    assert (goal.x, goal.y, goal.angle) == pytest.approx((0.03, -0.01, math.pi / 2))
    assert read_goal("1 cm, 0 mm").angle is None
    assert off(np.array([0.033, -0.01, -math.pi * 1.5]), goal.pose) == pytest.approx((0.003, 0.0))
    with pytest.raises(InputError, match="stays on its plate"):
        check_goals([Goal(0.08, 0.0)], on_a_plate("cheese"))
    with pytest.raises(InputError, match="two lengths"):
        read_goal("30 mm")


@pytest.fixture(scope="module")
def menu() -> Menu:
    """A menu from a third of the motions that are usual."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(menu_module, "_FIRST", 64)
        return menu_of("cheese", generations=0)


def steered(menu: Menu, method: Method = "blend", sheets: int = 4, **also: Any) -> list[Arrival]:
    goals = [Goal(0.01, 0.01, 0.5), Goal(-0.015, 0.0, -1.0), Goal(0.0, -0.015), Goal(0.02, 0.005, 2.0)][:sheets]
    laid = [menu.scenario.replace(**{"start.x": x}) for x in (0.0, 0.01, -0.01, 0.0)[:sheets]]
    ways = steer(Plant(laid), [[goal] for goal in goals], menu, method=method, timeout=15.0, **also)
    return [way.arrivals[0] for way in ways]


def check(arrivals: list[Arrival], least: int) -> None:
    # All but one in a hundred come home with a menu well sought, with a poorer one a few less.
    assert sum(arrival.reached for arrival in arrivals) >= least
    for arrival in arrivals:
        if arrival.reached:
            assert arrival.error <= 3e-3
            assert arrival.angle_error <= math.radians(5)
        else:
            assert arrival.status


@pytest.mark.slow
def test_sheets_are_brought_to_their_goals(menu):
    check(steered(menu), 3)


@pytest.mark.slow
def test_sheets_are_brought_to_their_goals_by_futures_of_the_engine(menu):
    arrivals = steered(menu, "mppi", 2)
    check(arrivals, 1)
    assert max(arrival.pulses for arrival in arrivals) > 0


@pytest.mark.slow
def test_futures_are_what_becomes_of_the_sheet(menu):
    ticks = np.array([6, 12])
    futures = Futures(menu.scenario.with_valid(motion=menu.motions[0]), 2)
    ends, sound = futures.ends(np.array([0.01, -0.02, 0.5]), menu.motions[1:3], ticks)
    for motion, ticked, end in zip(menu.motions[1:3], ticks.tolist(), ends, strict=True):
        start = {"start.x": 0.01, "start.y": -0.02, "start.angle": 0.5}
        session = Session([menu.scenario.replace(motion=menu.motions[0], **start)])
        session.advance(None, 0.03)
        session.advance(motion, ticked * TICK)
        session.advance(menu.motions[0], 0.6)
        # What is left of the way when the futures end is reckoned, not run.
        np.testing.assert_allclose(end, session.poses[0], atol=5e-4)
    assert sound.all()


@pytest.mark.slow
def test_kicked_sheets_come_home_none_the_less(menu):
    def kick(plant: Plant, now: float) -> None:
        if abs(now - 1.0) < plant.tick / 2:
            for lane in range(len(plant)):
                plant.push(lane, (0.2, 0.1, 3.0))

    check(steered(menu, each_tick=kick), 3)


@pytest.mark.slow
def test_friction_that_halves_midway_is_learnt(menu):
    def wet(plant: Plant, now: float) -> None:
        if abs(now - 1.0) < plant.tick / 2:
            for lane, own in enumerate(plant.session.scenarios):
                half = {f"friction.{name}": getattr(own.friction, name) / 2 for name in ("static", "kinetic")}
                plant.become(lane, own.replace(**half))

    check(steered(menu, each_tick=wet), 3)


def test_a_plate_stands_while_the_camera_is_dark(menu):
    def look(plant: Plant, since: float, until: float) -> Seen:
        return replace(plant.seen, new=plant.seen.new & ((plant.time < since) | (plant.time >= until)))

    check(steered(menu, look=lambda plant: look(plant, 0.5, 1.0)), 3)
    plant = Plant([menu.scenario.replace(**{"start.x": 0.03})])
    (way,) = steer(plant, [[Goal(-0.03, 0.02, 3.0)]], menu, look=lambda plant: look(plant, 0.3, math.inf))
    assert way.arrivals[0].status == "the camera sees nothing"
    # What it was told last, before it stood, was told within the time that a camera may be silent.
    assert way.motions[-1][1] == menu.motions[0]
    assert way.motions[-1][0] < 0.3 + BLIND + 4 * TICK
