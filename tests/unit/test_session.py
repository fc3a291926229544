"""Sessions: rollouts, resets, what they show on the way, and what they refuse."""

from __future__ import annotations

import numpy as np
import pytest

import plategait as pg
from plategait.model.course import course_of, gone_over, kinematics, most_on
from plategait.model.machine import Sliding, Turning
from plategait.model.needs import join_duration, surely_within

CHEESE = pg.preset("cheese").scenario
MOTION = CHEESE.motion.replace(frequency=18.0)


def test_a_rollout_leaves_the_session_as_it_is_and_can_be_taken_back():
    session = pg.Session([CHEESE] * 2)
    session.advance(MOTION, 0.05)
    saved, poses = session.copy(), session.poses
    session.advance(MOTION.replace(angle=0.2), 0.1)
    there = session.poses
    np.testing.assert_array_equal(saved.poses, poses)
    session.restore(saved)
    np.testing.assert_array_equal(session.poses, poses)
    session.advance(MOTION.replace(angle=0.2), 0.1)
    np.testing.assert_array_equal(session.poses, there)
    np.testing.assert_array_equal(saved.poses, poses)


def test_observables_on_the_way_are_those_of_a_run():
    session = pg.Session([CHEESE.replace(duration=1.0)])
    for _ in range(60):
        session.advance(None, 1 / 60)
    ours, theirs = session.observe(0), pg.simulate(CHEESE.replace(duration=1.0)).observations[0]
    assert ours.spin == theirs.spin
    assert ours.values == theirs.values
    assert ours.energy == theirs.energy


def test_an_observation_is_of_the_motion_since_it_changed():
    session = pg.Session([CHEESE.replace(**{"motion.frequency": 18.0})])
    session.advance(None, 0.5)
    session.advance(MOTION.replace(angle=-MOTION.angle), 1.0)
    assert session.observe(0, transient=0.3).spin.rate < 0 < pg.simulate(session.scenarios[0]).spin_rate


def test_a_session_keeps_as_much_as_it_is_told():
    session = pg.Session([CHEESE], keep=0.1)
    for _ in range(30):
        session.advance(None, 0.02)
    assert np.ptp(session.recording(0)["time"]) == pytest.approx(0.1, abs=0.02)
    assert session.recording(0)["time"][-1] == pytest.approx(0.6, abs=2e-3)


def test_poses_before_and_after_the_first_advance():
    start = CHEESE.replace(**{"start.x": 1e-3, "start.angle": "30 deg"})
    session = pg.Session([start])
    at_first = session.poses[0].copy()
    assert at_first == pytest.approx([1e-3, 0, np.pi / 6])
    session.advance(None, 1e-4)
    assert session.poses[0] == pytest.approx(at_first, abs=1e-5)


def test_a_session_may_mix_lattices_and_reset_one_by_a_flag():
    small = CHEESE.replace(**{"sheet.outline": pg.Rectangle(length=0.05, width=0.03), "sheet.mass": 4e-3})
    session = pg.Session([CHEESE, small, CHEESE])
    session.advance([None, MOTION, MOTION], 0.1)
    assert [m.frequency for m in session.motions] == [CHEESE.motion.frequency, 18.0, 18.0]
    session.reset(np.array([False, True, False]))
    assert session.time.tolist() == pytest.approx([0.1, 0.0, 0.1])


def test_what_a_session_refuses():
    session = pg.Session([CHEESE] * 2)
    session.advance(None, 0.01)
    other = CHEESE.replace(**{"sheet.pitch": CHEESE.sheet.pitch / 2})
    for call, field in (
        (lambda: session.advance([MOTION], 0.1), "motions"),
        (lambda: session.advance([MOTION, 3], 0.1), r"motions\.1"),  # type: ignore[list-item]
        (lambda: session.advance(MOTION, 0), "duration"),
        (lambda: session.advance(MOTION, 1e9), "duration"),
        (lambda: session.advance(MOTION.replace(ramp=0), 0.1), r"motions\.0\.ramp"),
        (lambda: session.advance(MOTION.replace(height=0.05), 0.1), r"motions\.0\.height"),
        (lambda: session.advance(MOTION.replace(frequency=2000), 0.1), r"motions\.0\.frequency"),
        (lambda: session.reset(2), "runs"),
        (lambda: session.reset([0], other), r"scenarios\.0"),
        (lambda: session.reset([0, 1], [CHEESE]), "scenarios"),
        (lambda: session.now("speed"), "channel"),
        (lambda: session.observe(7), "runs"),
        (lambda: session.restore(None), "saved"),  # type: ignore[arg-type]
        (lambda: pg.Session([]), "scenarios"),
        (lambda: pg.Session([CHEESE], keep=0), "keep"),
        (lambda: pg.Session([CHEESE], threads=0), "threads"),
        (lambda: pg.Session([CHEESE], engine="gpu"), "engine"),  # type: ignore[arg-type]
        (lambda: pg.Session([CHEESE]).recording(0), "runs"),
    ):
        with pytest.raises(pg.InputError, match=rf"^{field}: "):
            call()
    np.testing.assert_array_equal(session.time, 0.01)


def test_a_machine_s_limits_are_kept_at_the_start_and_at_every_change():
    alone = pg.needs(MOTION, pg.MACHINES["source-robot"], start=False).peaks
    tight = pg.Machine(x=Sliding(acceleration=1.05 * alone[2, 0]), rx=Turning(acceleration=1.05 * alone[2, 3]))
    session = pg.Session([CHEESE.replace(motion=MOTION.replace(ramp=0.01))], machine=tight)
    session.advance(None, 0.1)
    course = session._engine.courses[0]
    assert course[0].duration > 0.01, "a start that the machine can make"
    session.advance(MOTION.replace(stroke=-MOTION.stroke, ramp=0.01), 0.5)
    course = session._engine.courses[0]
    moves = kinematics(course, np.linspace(0.1, 0.6, 50_000))
    assert np.abs(moves.acceleration[0]).max() <= 1.05 * alone[2, 0] * (1 + 1e-5)
    assert np.abs(moves.acceleration[3]).max() <= 1.05 * alone[2, 3] * (1 + 1e-5)
    for wrong in (MOTION.replace(frequency=20.0), MOTION.replace(waves=({"axis": "z", "amplitude": 1e-4},))):
        with pytest.raises(pg.InputError, match=r"^motions\.0: .*machine"):
            session.advance(wrong, 0.1)
    with pytest.raises(pg.InputError, match=r"^motion: "):
        pg.Session([CHEESE.replace(**{"motion.frequency": 50.0})], machine="source-robot")
    with pytest.raises(pg.InputError, match=r"^machine: "):
        pg.Session([CHEESE], machine="no-such-machine")


def test_what_a_plate_never_exceeds_is_never_exceeded():
    rng = np.random.default_rng(3)
    for _ in range(20):
        motions = [
            MOTION.replace(frequency=f, angle=a, stroke=1e-3, offset={"rx": o}, waves=({"axis": "x", "amplitude": w},))
            for f, a, o, w in rng.uniform([5, -0.2, -0.2, 0], [40, 0.2, 0.2, 2e-3], (3, 4))
        ]
        course = gone_over(gone_over(course_of(motions[0]), motions[1], 1.0, 0.015), motions[2], 1.01, 0.02)
        moves, most = kinematics(course, np.linspace(1.01, 1.3, 20_000)), most_on(course, 1.01)
        assert most is not None
        for bound, reached in zip(most, (moves.position, moves.speed, moves.acceleration, moves.jerk), strict=True):
            assert (np.abs(reached) <= bound[:, None] * (1 + 1e-9)).all()
    # Of one sine on each axis, once it is gone over to, they are what it reaches: at 240 times a period within 1e-4.
    settled, most = needs_of(MOTION, 2.0)
    np.testing.assert_allclose(most, settled, rtol=1e-4)


def needs_of(motion: pg.PlateMotion, since: float) -> tuple[np.ndarray, np.ndarray]:
    """What a motion reaches, sampled, and what its bounds say, (4, 6) each."""
    most = most_on(course_of(motion), since)
    assert most is not None
    return pg.needs(motion, pg.MACHINES["source-robot"], start=False).peaks[:4], most


def test_what_bounds_tell_is_what_sampling_tells():
    # A machine that bounds alone cannot be sure of, and one of which they are: the same time to go over.
    still, other = MOTION.replace(angle=0, stroke=0, ramp=0.02), MOTION.replace(ramp=0.02)
    loose = pg.Machine(x=Sliding(acceleration=1e3), rx=Turning(acceleration=1e6))
    needed = kinematics(gone_over(course_of(still), other, 0.0, 0.02), np.linspace(0, 0.2, 20_000))
    most = np.abs(needed.acceleration).max(axis=1)
    close = pg.Machine(x=Sliding(acceleration=1.01 * most[0]), rx=Turning(acceleration=1.01 * most[3]))
    assert surely_within(most_on(gone_over(course_of(still), other, 0.0, 0.02), 0.0), None, loose)
    assert not surely_within(most_on(gone_over(course_of(still), other, 0.0, 0.02), 0.0), None, close)
    for machine in (loose, close, pg.MACHINES["source-robot"], None):
        assert join_duration(course_of(still), other, 0.0, machine, "motion") == 0.02
