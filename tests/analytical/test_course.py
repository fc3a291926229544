"""The course of a plate: continuous to the acceleration, and the same in the core as in closed form."""

from __future__ import annotations

import numpy as np
import pytest

import plategait as pg
from plategait.model.course import course_of, gone_over, kinematics
from plategait.model.machine import Machine, Sliding, Turning
from plategait.model.motion import Samples, Wave
from plategait.model.needs import excess, join_duration, needs

FIRST = pg.PlateMotion(frequency=20.0, angle="3 deg", stroke="3 mm", offset={"rx": "4 deg"})
SECOND = FIRST.replace(
    frequency=13.0, stroke="-2 mm", offset={"z": "1 mm"}, waves=(Wave(axis="rz", amplitude="2 deg"),)
)
THIRD = FIRST.replace(samples=Samples(time=(0.0, 0.02, 0.05, 0.06, 0.2, 0.6), y=(0.0, 1e-3, -1e-3, 2e-3, 0.0, 0.0)))


def course():
    """Each motion before the last is gone over to."""
    two = gone_over(course_of(FIRST), SECOND, 0.53, 0.1)
    return gone_over(two, THIRD, 0.58, 0.2)


@pytest.mark.parametrize("derivative", ["position", "speed", "acceleration"])
def test_a_change_of_motion_is_continuous(derivative):
    nearly = 1e-9
    scale = np.abs(getattr(kinematics(course(), np.linspace(0.58, 0.9, 2000)), derivative)).max(axis=1)
    before, at = course_of(FIRST), gone_over(course_of(FIRST), SECOND, 0.53, 0.1)
    pairs = [
        (kinematics(before, np.array([0.53 - nearly])), kinematics(at, np.array([0.53]))),
        (kinematics(at, np.array([0.58 - nearly])), kinematics(course(), np.array([0.58]))),
        (kinematics(course(), np.array([0.78 - nearly])), kinematics(course(), np.array([0.78 + nearly]))),
    ]
    for one, other in pairs:
        # A nanosecond of the fastest motion here moves each by less than a millionth of its size.
        step = np.abs(getattr(one, derivative) - getattr(other, derivative))[:, 0]
        assert (step <= 1e-6 * (scale + 1e-12) + 1e-9).all()


def test_derivatives_are_the_slopes_of_one_another():
    time, h = np.linspace(0.585, 0.9, 50), 1e-6
    early, now, late = (kinematics(course(), time + shift) for shift in (-h, 0.0, h))
    for below, above in (("position", "speed"), ("speed", "acceleration"), ("acceleration", "jerk")):
        slope = (getattr(late, below) - getattr(early, below)) / (2 * h)
        size = np.abs(slope).max()
        # Central differences over 1 µs, but where the jerk of the spline jumps.
        off = np.abs(slope - getattr(now, above)) > 1e-4 * size
        assert off.mean() < 0.02, below


@pytest.mark.parametrize(("engine", "digits"), [("cpu", 2e-7), ("cpu64", 1e-12)])
def test_the_core_moves_the_plate_as_the_closed_form_says(engine, digits):
    scenario = pg.preset("cheese").scenario.replace(motion=FIRST)
    session = pg.Session([scenario], engine=engine)
    session.advance(None, 0.53)
    session.advance(SECOND, 0.05)
    session.advance(THIRD.replace(ramp=0.2), 0.4)
    recording = session.recording(0)
    late = recording["time"] > 0.58
    # Where the core's table holds a spline by cubic pieces twice as fine, the two agree to 1e-6 m.
    moves = kinematics(course(), recording["time"][late]).position
    for d, axis in enumerate(("x", "y", "z", "rx", "ry", "rz")):
        np.testing.assert_allclose(recording[f"plate_{axis}"][late], moves[d], atol=2e-6 if axis == "y" else digits)


def test_what_a_sine_needs_in_closed_form():
    machine = Machine(
        x=Sliding(), rx=Turning(), plate_mass=0.1, inertia_x=2e-4, inertia_y=3e-4, inertia_z=4e-4, arm=0.5
    )
    motion = pg.PlateMotion(frequency=20.0, angle=0.05, stroke=0.003)
    told, omega = needs(motion, machine, start=False), 2 * np.pi * 20
    for d, amplitude, load in ((0, 0.003, 0.1), (3, 0.05, 2e-4)):
        np.testing.assert_allclose(told.peaks[:4, d], amplitude * omega ** np.arange(4), rtol=1e-4)
        assert told.peaks[4, d] == pytest.approx(load * amplitude * omega**2, rel=1e-4)
    # Each drive gives m A² ω³ sin 2ωt / 2 in two quarters of a period and gets it back in the other two.
    largest = 0.5 * omega**3 * (0.1 * 0.003**2 + 2e-4 * 0.05**2)
    assert told.power == pytest.approx(largest, rel=1e-3)
    assert told.mean_power == pytest.approx(largest / np.pi, rel=1e-2)
    assert told.frequency == pytest.approx(20)
    # Across the bar the plate's mass is at the end of the arm.
    across = needs(pg.PlateMotion(stroke=0, angle=0, frequency=20, waves=(Wave(axis="rz", amplitude=0.01),)), machine)
    assert across.peaks[4, 5] > (4e-4 + 0.1 * 0.25) * 0.01 * omega**2 * 0.999


def test_a_start_and_an_offset_count():
    machine = Machine(x=Sliding(), rx=Turning(angle="5 deg"))
    motion = pg.PlateMotion(frequency=20, angle="3 deg", stroke="3 mm", ramp=0.02)
    assert needs(motion, machine).peaks[2, 0] > 1.05 * needs(motion, machine, start=False).peaks[2, 0]
    assert not excess(needs(motion, machine), machine)
    (said,) = excess(needs(motion.replace(offset={"rx": "2.5 deg"}), machine), machine)
    assert said == "5.5 deg of position on rx, above 5 deg"


@pytest.mark.parametrize("room", [1.02, 1.1, 3.0])
def test_a_join_takes_as_long_as_the_limits_ask_for(room):
    motion = pg.PlateMotion(frequency=20.0, angle="3 deg", stroke="3 mm", ramp=0.05)
    against = motion.replace(stroke="-3 mm", angle="-3 deg")
    peaks = room * needs(motion, Machine(x=Sliding(), rx=Turning()), start=False).peaks
    machine = Machine(x=Sliding(acceleration=peaks[2, 0], jerk=peaks[3, 0]), rx=Turning(speed=peaks[1, 3]))
    duration = join_duration(course_of(motion), against, 0.5123, machine, "motion")
    joined = gone_over(course_of(motion), against, 0.5123, duration)
    moves = kinematics(joined, np.linspace(0.5123, 0.5123 + duration, 20_000))
    assert np.abs(moves.acceleration[0]).max() <= peaks[2, 0] * (1 + 1e-4)
    assert np.abs(moves.jerk[0]).max() <= peaks[3, 0] * (1 + 1e-4)
    assert np.abs(moves.speed[3]).max() <= peaks[1, 3] * (1 + 1e-4)
    assert (duration > 0.05) == (room < 3)
