"""Actions and the motions that they stand for: within every machine's limits, and back."""

from __future__ import annotations

import math

import numpy as np
import pytest

import plategait as pg
from plategait.control.drive import DEAD, Drive
from plategait.model.machine import Sliding, Turning
from plategait.model.needs import check_motion

TIGHT = pg.Machine(
    name="tight", frequency=60.0, plate_mass=0.05, inertia_x=4.5e-5, inertia_y=4.5e-5, inertia_z=9e-5, power="0.9 W",
    x=Sliding(stroke="4 mm", speed="250 mm/s", acceleration="40 m/s^2", jerk="8e3 m/s^3", force="1.5 N"),
    z=Sliding(acceleration="20 m/s^2"), rx=Turning(angle="10 deg", speed="900 deg/s", torque="0.06 N*m"),
)  # fmt: skip


@pytest.mark.parametrize("machine", [*pg.MACHINES.values(), TIGHT], ids=lambda machine: machine.name)
def test_every_action_is_within_the_machine_and_stands_for_one_motion(machine: pg.Machine):
    drive = Drive(machine)
    rng = np.random.default_rng(1)
    actions = np.vstack([rng.uniform(-1, 1, (60, len(drive))), np.ones(len(drive)), -np.ones(len(drive))])
    for motion in drive.motions(actions):
        check_motion(motion, machine, start=False)  # what is sampled, finer than the bounds that the drive knows
        assert pg.PlateMotion(**{name: getattr(motion, name) for name in pg.PlateMotion.model_fields}) == motion
        again = drive.motions(drive.action(motion)[None])[0]
        np.testing.assert_allclose(np.array(again.terms()), np.array(motion.terms()), rtol=1e-6)
        np.testing.assert_allclose(again.offset.pose, motion.offset.pose, atol=1e-12)


def test_what_the_numbers_stand_for():
    drive = Drive("source-robot")
    assert drive.names == ("frequency", "angle", "stroke", "phase", "offset")
    motion = drive.motions(np.array([[0.0, -1.0, 1.0, 0.5, 1.0]]))[0]
    assert motion.frequency == pytest.approx(40 / math.sqrt(8))
    assert math.degrees(motion.offset.rx) == pytest.approx(12)
    assert math.degrees(motion.angle) == pytest.approx(-12)  # the reach that the offset leaves
    assert motion.waves[0].amplitude == pytest.approx(3e-3)
    assert math.degrees(motion.waves[0].phase) == pytest.approx(45)


def test_a_plate_can_be_told_to_stand():
    drive = Drive("six-axis")
    still = drive.motions(np.vstack([drive.rest, drive.rest + 0.7 * DEAD]))
    assert [motion.terms() for motion in still] == [(), ()]
    assert drive.motions((drive.rest + 1.1 * DEAD)[None])[0].terms()


def test_what_is_not_free_is_the_base_s():
    base = pg.PlateMotion(frequency=18, angle="3 deg", stroke="2 mm", height="5 mm")
    drive = Drive("source-robot", base, free=("angle", "offset"), ramp="20 ms")
    motion = drive.motions(np.array([[0.0, 0.25]]))[0]
    assert (motion.frequency, motion.stroke, motion.height, motion.ramp) == (18, 0.002, 0.005, 0.02)
    assert motion.angle == 0
    assert math.degrees(motion.offset.rx) == pytest.approx(3)


def test_a_motion_half_a_period_later_is_the_same():
    drive = Drive("planar")
    told = pg.PlateMotion(frequency=20, angle=0, stroke=-1e-3, waves=({"axis": "rz", "amplitude": "2 deg"},))
    motion = drive.motions(drive.action(told)[None])[0]
    assert (motion.stroke, abs(motion.waves[0].phase)) == pytest.approx((1e-3, math.pi))


def test_what_a_drive_refuses():
    drive = Drive("source-robot")
    rest = drive.base
    for call, field in (
        (lambda: Drive("source-robot", free=["y sine"]), "free"),
        (lambda: Drive(pg.Machine(frequency=40.0, x=Sliding())), "machine"),
        (lambda: Drive(pg.Machine(x=Sliding(stroke="3 mm"))), "machine"),
        (lambda: Drive("planar", pg.PlateMotion(waves=({"axis": "x", "amplitude": 1e-3},))), "base"),
        (lambda: drive.motions(np.zeros((2, 4))), "actions"),
        (lambda: drive.motions(np.full((1, 5), np.nan)), "actions"),
        (lambda: drive.action(rest.replace(frequency=60)), "motion"),
        (lambda: drive.action(rest.replace(angle="30 deg")), "motion"),
        (lambda: drive.action(rest.replace(waves=({"axis": "x", "amplitude": 1e-3, "ratio": 2},))), "motion.waves"),
        (lambda: drive.action(rest.replace(waves=({"axis": "y", "amplitude": 1e-3},))), "motion.waves"),
    ):
        with pytest.raises(pg.InputError, match=rf"^{field}"):
            call()


@pytest.mark.parametrize("machine", ["source-robot", "six-axis"])
def test_what_a_drive_works_out_is_what_the_motion_would(machine: str):
    drive = Drive(machine, pg.PlateMotion(offset={"rx": "2 deg"}, angle="1 deg"))
    rng = np.random.default_rng(2)
    actions = np.vstack([rng.uniform(-1, 1, (40, len(drive))), np.zeros(len(drive)), drive.rest])
    actions[:10, 3] = 0  # shaking in phase, and 10 where the plate does not shake
    actions[10:20, 2] = -1
    for motion in drive.motions(actions, heights=[0.004] * len(actions)):
        fresh = pg.PlateMotion(**{name: getattr(motion, name) for name in pg.PlateMotion.model_fields})
        assert fresh == motion
        assert (motion.terms(), motion.period, motion.shortest_period) == (
            fresh.terms(),
            fresh.period,
            fresh.shortest_period,
        )
        np.testing.assert_allclose(motion.most, fresh.most, rtol=1e-14)
        assert motion.offset.pose == pg.Held(**{a: getattr(motion.offset, a) for a in pg.Held.model_fields}).pose
        assert motion.height == 0.004
