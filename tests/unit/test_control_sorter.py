"""Sorting: rates read off angles, classes told by them or declined, and sheets sent off by a side."""

import math

import numpy as np
import pytest

from plategait.control.camera import PERFECT, Camera
from plategait.control.feeder import SIDES, from_now, send_off, spin
from plategait.control.goal import Goal
from plategait.control.menu import Menu, drive_of
from plategait.control.plant import Plant
from plategait.control.response import resting
from plategait.control.room import on_a_plate
from plategait.control.sorter import Sorter, learn_sorter
from plategait.control.spinning import MOTIONS, SPUN, rate_of
from plategait.control.steer import steer
from plategait.errors import InputError
from plategait.model.machine import machine_of
from plategait.model.motion import Wave

CHEESE = on_a_plate("cheese")


@pytest.fixture(scope="module")
def sorter() -> Sorter:
    """Three of the motions, from a third of the sheets."""
    return learn_sorter("cheese", motions=MOTIONS[:3], sets=64, seed=4)


def test_the_slope_of_angles_is_as_sure_as_it_says():
    time = np.arange(36) / 60
    noise = math.hypot(math.radians(1.0), math.radians(1.0))
    draw = np.random.default_rng(2)
    told = []
    for _ in range(200):
        angle = math.radians(-210) * time + 3.0 + noise * draw.standard_normal(36)
        told.append(rate_of(np.column_stack([time, np.angle(np.exp(1j * angle))]), math.radians(1.0)))
    rates, sd = np.array(told).T
    assert rates.mean() == pytest.approx(-210, abs=4 * sd[0] / math.sqrt(200))
    assert rates.std() == pytest.approx(sd[0], rel=0.2)  # of 200: 5 %, four times
    assert math.isnan(rate_of(np.zeros((3, 2)), 0.01)[0])


@pytest.mark.slow
def test_classes_are_told_from_spin_rates(sorter):
    kinds, draw = np.repeat(np.arange(3), 4), np.random.default_rng(3)
    stiffness = 1.4 ** (kinds - 1.0)
    sheets = [
        CHEESE.replace(**{
            "sheet.bending_stiffness": k * CHEESE.sheet.bending_stiffness, "start.y": draw.normal(0, 4e-3),
            "start.angle": draw.uniform(-3, 3), "friction.static": CHEESE.friction.static * draw.uniform(0.9, 1.1),
        })
        for k in stiffness
    ]  # fmt: skip
    verdicts, times = spin(Plant(sheets, camera=Camera(), seeds=range(12)), sorter)
    np.testing.assert_allclose(times, 3 * SPUN + 0.2)
    assert all(v.shares.sum() == pytest.approx(1) for v in verdicts)
    # Known to 8 % (sd), a class ends 18 % from its middle: one of twelve in twenty is wrong. By chance two thirds are.
    assert sum(int(v.shares.argmax()) == kind for v, kind in zip(verdicts, kinds, strict=True)) >= 10
    # Binomial: of twelve intervals of 90 %, eight or fewer hold once in 200 times.
    assert sum(v.low <= k <= v.high for v, k in zip(verdicts, stiffness, strict=True)) >= 9
    # What is asked to be surer is declined, and never turned into another class.
    for verdict in verdicts:
        assert verdict.kind(0.0) == verdict.shares.argmax()
        assert verdict.kind(1.01) is None
    # Who need not be sure is spun less.
    few, shorter = spin(Plant(sheets[:3], camera=Camera()), sorter, sure=0.5)
    assert (shorter < 3 * SPUN + 0.1).any()
    assert all(v.kind(0.5) is not None for v, time in zip(few, shorter, strict=True) if time < 3 * SPUN)


def test_what_was_not_spun_is_not_told(sorter):
    nothing = np.full(3, math.nan)
    verdict = sorter.judge(nothing, nothing, nothing)
    assert verdict.kind() is None
    # The prior: even in the logarithm over the classes and half a class beyond, which falls to the outer ones.
    np.testing.assert_allclose(verdict.shares, [3 / 8, 1 / 4, 3 / 8], atol=0.04)
    with pytest.raises(InputError, match="one for each of 3"):
        sorter.judge(nothing[:2], nothing[:2], nothing[:2])
    with pytest.raises(InputError, match="classes"):
        learn_sorter("cheese", classes=1)
    with pytest.raises(InputError, match="steps"):
        learn_sorter("cheese", steps=1.0)


def test_a_sheet_leaves_by_the_side_that_it_is_sent_to():
    drive = drive_of(CHEESE, machine_of("source-robot"))
    still = drive.base.replace(angle=0.0, stroke=0.0)
    # Shaken fast along the bar a sheet slides down a plate that is held at a slant.
    shaken = still.replace(frequency=40.0, waves=(Wave(axis="x", amplitude=2.9e-3),), **{"offset.rx": -0.2})
    response = resting(2)
    response.rates[1, 1, 0] = 0.2
    menu = Menu(CHEESE, drive, (still, shaken), np.zeros((2, len(drive))), response, 0.05)
    plant = Plant([CHEESE, CHEESE], camera=PERFECT)
    for _ in range(10):
        plant.step(still)
    # A controller takes over where sheets were handled before: its time begins anew.
    alone = Menu(CHEESE, drive, (still,), np.zeros((1, len(drive))), resting(), 0.05)
    ways = steer(plant, [[Goal(0.0, 0.0)]] * 2, alone, hold=0.1, look=from_now(plant))
    assert all(way.reached for way in ways)
    left, times = send_off(plant, [SIDES.index("+y"), None], menu)
    assert left == [SIDES.index("+y"), None]
    assert plant.poses[0, 1] > 0.1
    assert abs(plant.poses[1, 1]) < 1e-3
    assert 0 < times[0] < 3
    assert times[1] == 0
