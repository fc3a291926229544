"""Two sheets on one plate: what they can do apart, how long it takes, and a pair brought to its places."""

import numpy as np
import pytest

from plategait.control.camera import PERFECT
from plategait.control.goal import Goal
from plategait.control.menu import Menu, drive_of
from plategait.control.observer import Observer
from plategait.control.pair import APART, PairController, breadth, check_pair, pair_tables, steer_pairs
from plategait.control.pair_reach import WAY, pair_reach
from plategait.control.pair_value import PairTable, PairTime
from plategait.control.plant import Plant
from plategait.control.pulse import PAUSE, Pulses
from plategait.control.response import ACROSS, ANYHOW, TICK, Field, Response, resting
from plategait.control.room import on_a_plate
from plategait.errors import InputError
from plategait.model.machine import machine_of
from plategait.model.presets import preset

REACH = 0.07
# Each component of the velocity by itself, everywhere, and in proportion to the place: m/s, m/s, rad/s at 50 mm.
SPEED = np.array([0.06, 0.06, 2.0])


def menu_like(powers: tuple[tuple[int, int], ...], linear: bool) -> Menu:
    """Menu of made-up responses to motions that are never made."""
    field = Field(powers, REACH)
    rates = [
        sign * SPEED[c] * np.outer(np.eye(3)[c], np.eye(len(powers))[k])
        for c in range(3) for k in range(2 if linear else 1) for sign in (1, -1)
    ]  # fmt: skip
    still, count = resting(1, field), len(rates)
    response = Response(
        np.concatenate([still.rates, rates]), np.concatenate([still.lags, np.full((count, 3), 0.03)]),
        np.zeros((count + 1, 3)), np.zeros(count + 1, dtype=bool), field,
    )  # fmt: skip
    small = {"sheet.outline.radius": "25 mm", "sheet.mass": "5.3 g"}
    scenario = on_a_plate(preset("cheese").scenario.replace(**small))
    drive = drive_of(scenario, machine_of("source-robot"))
    plate = drive.base.replace(angle=0.0, stroke=0.0)
    return Menu(scenario, drive, (plate,) * (count + 1), np.zeros((count + 1, len(drive))), response, REACH)


MENU = menu_like(ACROSS[:2], linear=True)
PULSES = Pulses(MENU.response)


def test_sheets_at_one_place_across_the_bar_cannot_be_told_apart():
    found = pair_reach(PULSES, REACH, 5)
    apart = ~np.eye(5, dtype=bool)
    assert (found.rank[apart] == 6).all()
    assert (found.ways[apart] == 12).all()
    assert (np.diag(found.rank) == 3).all()
    assert (np.diag(found.ways) == 0).all()


def test_ways_apart_take_as_long_as_the_places_are_near():
    """The first, at the bar, by 10 mm: what moves both alike, and then the second back by what grows with the place."""
    found = pair_reach(PULSES, REACH, 7)
    times, gaps = found.times[3, 4:, 0], found.places[4:]
    fastest = (PULSES.at(np.zeros(2))[:, 0] / (PULSES.times + PAUSE))[np.isin(PULSES.ticks, (3, 8, 18))].max()
    # At 50 mm the second kind is as fast as the first. Displacements are rounded to 1e-9 of the ways.
    np.testing.assert_allclose(times, WAY[0] / fastest * (1 + 0.05 / gaps), rtol=1e-6)


def test_only_what_is_the_same_for_both_is_reached_without_a_gradient():
    found = pair_reach(Pulses(menu_like(ACROSS[:1], linear=False).response), REACH, 3)
    assert (found.rank == 3).all()
    assert (found.ways == 0).all()


def test_time_of_a_common_way_is_that_of_one_sheet():
    table = PairTable(PULSES, PULSES.times + 0.2, REACH, 0)
    goals = np.array([[0.0, -0.03, 0.0], [0.02, 0.03, 0.0]])
    time = PairTime(table, goals, 0.05)
    assert time.of(goals[:, None])[0] == pytest.approx(0.0, abs=1e-6)
    both = goals + np.array([0.05, 0.0, 0.0])
    one = goals + np.array([[0.05, 0.0, 0.0], [0.0, 0.0, 0.0]])
    # 50 mm at 60 mm/s, in pulses of 18 ticks of each 30: 1.4 s; the grid, 12.5 mm wide, tells it to a fifth.
    assert time.of(both[:, None])[0] == pytest.approx(1.4, rel=0.2)
    # Half of it by what moves both alike, half by what moves them apart, at 30 mm 0.6 times as fast: 4/3; farther apart
    # that is faster.
    assert 1.05 < time.of(one[:, None])[0] / time.of(both[:, None])[0] < 4 / 3


def test_no_way_leads_through_the_other_sheet():
    table = PairTable(PULSES, PULSES.times + 0.2, REACH, 0)
    goals, start = np.array([[0.04, -0.01, 0.0], [0.0, 0.01, 0.0]]), np.array([[-0.04, -0.01, 0.0], [0.0, 0.01, 0.0]])
    free, kept = (PairTime(table, goals, apart).of(start[:, None])[0] for apart in (0.0, 0.04))
    assert kept > free + 0.3


def test_controller_brings_both_to_their_places_by_the_response_that_it_knows():
    goals = np.array([[0.03, -0.02, np.nan], [-0.02, 0.035, np.nan]])
    controller = PairController(MENU, goals, pair_tables(MENU, PULSES), PULSES)
    states = np.array([[-0.03, -0.03, 0, 0, 0, 0], [0.03, 0.03, 1, 0, 0, 0]])
    observers = [Observer(PERFECT, MENU.response, state[:3]) for state in states]
    held, nearest = [0, 0], 1.0
    for tick in range(600):
        for observer, state in zip(observers, states, strict=True):
            observer.saw(state[:3], tick * TICK)
        motion = controller.choose(observers)
        for observer in observers:
            observer.told(motion)
        held.append(motion)
        states = MENU.response.step(np.full(2, held.pop(0)), states)
        nearest = min(nearest, float(np.hypot(*(states[0] - states[1])[:2])))
    assert np.hypot(*(states[:, :2] - goals[:, :2]).T).max() < 3e-3
    assert controller.motion == 0
    assert nearest > breadth(MENU.scenario)


def test_goals_that_cannot_both_be_reached_are_refused():
    starts = np.array([[0.0, -0.03, 0.0], [0.0, 0.03, 0.0]])
    check_pair((Goal(0, -0.02), Goal(0, 0.04)), starts, MENU)
    with pytest.raises(InputError, match="past the other"):
        check_pair((Goal(0, 0.04), Goal(0, -0.02)), starts, MENU)
    with pytest.raises(InputError, match="do not touch"):
        check_pair((Goal(0, 0.0), Goal(0, breadth(MENU.scenario) + APART - 1e-3)), starts, MENU)
    with pytest.raises(InputError, match="for neither"):
        check_pair((Goal(0, -0.02, 0.0), Goal(0, 0.04)), starts, MENU)
    with pytest.raises(InputError, match="stays on its plate"):
        check_pair((Goal(0, -0.02), Goal(0, 0.09)), starts, MENU)
    with pytest.raises(InputError, match="along it"):
        pair_tables(menu_like(ANYHOW, linear=True), PULSES)
    with pytest.raises(InputError, match="one for each two"):
        steer_pairs(Plant([MENU.scenario] * 3), [(Goal(0, -0.02), Goal(0, 0.04))], MENU)


def test_pairs_are_told_one_motion_and_given_up_together():
    sheets = [MENU.scenario.replace(**{"start.y": y}) for y in ("-30 mm", "30 mm", "-30 mm", "30 mm")]
    goals = [(Goal(0, -0.03), Goal(0, 0.03)), (Goal(0.02, -0.03), Goal(0.02, 0.03))]
    # The plate stands whatever it is told here: those that are there are held, the others given up.
    (there, _), (away, other) = steer_pairs(Plant(sheets, camera=PERFECT), goals, MENU, hold=0.2, timeout=0.5)
    assert there.reached
    assert there.arrivals[0].pulses == 0
    assert (away.arrivals[0].status, other.arrivals[0].status) == ("not within the time",) * 2
    assert away.motions == other.motions
    assert len(away.motions) > 0
