"""A session gives the same bits however its way is cut into pieces, and those of `simulate`."""

from __future__ import annotations

import math

import numpy as np
import pytest

import plategait as pg
from plategait.engine import cpu
from plategait.engine.channels import CHANNELS
from plategait.model.motion import Samples, Wave

CHEESE = pg.preset("cheese").scenario.replace(duration=0.3)
SHAKE = Samples(time=tuple(0.01 * i for i in range(21)), z=tuple(2e-4 * math.sin(i) for i in range(21)))


def scenarios() -> list[pg.Scenario]:
    """Runs that differ in lattice, step, friction, plate and motion; one hangs over the edge of its plate."""
    varied = []
    for i in range(20):
        changes: dict = {
            "motion.frequency": 10.0 + i,
            "motion.angle": 0.02 + 0.003 * i,
            "friction.law": ("thesis", "adams")[i % 2],
            "sheet.torsion_stiffness": 1e-5 * (i % 3),
            "time_step": 1e-4 / (1 + i % 2),
            "start.angle": 0.1 * i,
            "motion.offset.rx": 0.01 * (i % 4),
        }
        if i % 4 == 0:
            changes |= {"motion.samples": SHAKE}
        if i % 5 == 0:
            changes |= {"sheet.outline": pg.Rectangle(length=0.05, width=0.03), "sheet.mass": 4e-3}
        if i % 3 == 0:
            changes |= {"plate": pg.Plate(length=0.085, width=0.09), "start.x": 0.008}
        varied.append(CHEESE.replace(**changes))
    return varied


def assert_same(a, b) -> None:
    for name in CHANNELS:
        np.testing.assert_array_equal(a[name], b[name], err_msg=name)
    for part in ("snapshot_time", "snapshots", "plate_pose", "positions", "velocities"):
        np.testing.assert_array_equal(getattr(a, part), getattr(b, part), err_msg=part)
    assert a.steps == b.steps


@pytest.mark.parametrize("engine", ["cpu", "cpu64"])
def test_pieces_give_the_bits_of_one_run(engine):
    runs = scenarios()
    whole = pg.simulate_all(runs, engine=engine, snapshot_interval=0.01)
    session = pg.Session(runs, engine=engine, snapshot_interval=0.01, threads=1)
    for duration in (1e-4, 1 / 60, 1 / 60, 0.1, 1 / 30, 0.3 - 1e-4 - 1 / 15 - 0.1):
        session.advance(None, duration)
    for i, simulation in enumerate(whole):
        assert_same(session.recording(i), simulation.recordings[0])


def changed_on_the_way(session: pg.Session, pieces: int) -> pg.Session:
    """Three motions, a change of each before the last is gone over to, in so many pieces each."""
    for k, duration in enumerate((0.05, 0.04, 0.2)):
        motions = [
            m.replace(angle=0.03 + 0.01 * k, frequency=12.0 + 5 * k, waves=(Wave(axis="z", amplitude=2e-4 * k + 1e-4),),
                      samples=SHAKE if k == 1 else None)
            for m in (s.motion for s in session.scenarios)
        ]  # fmt: skip
        for _ in range(pieces):
            session.advance(motions, duration / pieces)
    return session


@pytest.mark.parametrize("engine", ["cpu", "cpu64"])
def test_changes_of_motion_keep_the_bits_too(engine):
    runs = scenarios()
    one, many = (changed_on_the_way(pg.Session(runs, engine=engine, threads=2), pieces) for pieces in (1, 7))
    alone = [changed_on_the_way(pg.Session([run], engine=engine), 3) for run in runs[::7]]
    for i in range(len(runs)):
        assert_same(one.recording(i), many.recording(i))
    for i, session in zip(range(0, len(runs), 7), alone, strict=True):
        assert_same(one.recording(i), session.recording(0))


def test_layers_that_are_left_out_change_no_bit():
    # A long piece keeps the layer beneath to its end; short pieces drop it as soon as it is gone over.
    one, many = (pg.Session([CHEESE]) for _ in range(2))
    new = CHEESE.motion.replace(angle=0.1, offset={"rx": 0.03})
    for session, pieces in ((one, 1), (many, 30)):
        session.advance(None, 0.05)
        for _ in range(pieces):
            session.advance(new, 0.6 / pieces)
    assert_same(one.recording(0), many.recording(0))
    assert len(many._engine.courses[0]) == 1, "dropped"
    assert len(one._engine.courses[0]) == 2, "kept"


def test_tiles_in_pieces_are_tiles_in_one():
    short = CHEESE.replace(duration=0.03)
    whole = pg.simulate(short, engine="tiles", snapshot_interval=0.005).recordings[0]
    session = pg.Session([short], engine="tiles", snapshot_interval=0.005)
    for _ in range(4):
        session.advance(None, 0.0075)
    assert_same(session.recording(0), whole)
    with pytest.raises(pg.InputError, match="tiles"):
        session.advance(short.motion.replace(angle=0.1), 0.01)


def test_a_run_that_is_reset_is_a_new_one_among_others_under_way():
    session = pg.Session(scenarios()[:6])
    session.advance(None, 0.07)
    session.reset([1, 4])
    session.advance(None, 0.3)
    anew = pg.simulate_all([session.scenarios[i] for i in (1, 4)])
    for i, simulation in zip((1, 4), anew, strict=True):
        assert_same(session.recording(i), simulation.recordings[0])
    assert session.time[[0, 1]] == pytest.approx([0.37, 0.3])


def test_a_plate_that_ends_may_come_into_a_session_without():
    # The second knocks the sheet off its plate again and again, so that nodes lie deep when the first is reset.
    runs = [CHEESE, CHEESE.replace(**{"motion.angle": "9 deg", "motion.waves": [{"axis": "z", "amplitude": "2 mm"}]})]
    ending = CHEESE.replace(plate=pg.Plate(length=0.085, width=0.09))
    session = pg.Session(runs)
    session.advance(None, 0.13)
    session.reset(0, ending)
    session.advance(None, 0.17)
    assert_same(session.recording(1), pg.simulate(runs[1]).recordings[0])
    session.advance(None, 0.13)
    assert_same(session.recording(0), pg.simulate(ending).recordings[0])
    session.reset(0, CHEESE)
    session.advance(None, 0.3)
    assert_same(session.recording(0), pg.simulate(CHEESE).recordings[0])


def test_a_diverged_run_stays_and_the_others_go_on():
    wild = CHEESE.replace(gravity=1e30)
    session = pg.Session([CHEESE, wild])
    for _ in range(30):
        session.advance(None, 0.01)
    assert session.diverged.tolist() == [False, True]
    assert session.time[1] < session.time[0] == pytest.approx(0.3)
    assert_same(session.recording(0), pg.simulate(CHEESE).recordings[0])
    session.reset(1, CHEESE.replace(**{"motion.angle": "2 deg"}))
    assert not session.diverged.any()


def test_an_interrupted_advance_leaves_all_where_they_were(monkeypatch):
    session, calls = pg.Session(scenarios()[:6]), []
    session.advance(None, 0.02)
    before, real = session.poses, cpu.Batch.advanced

    def second_fails(self, *arguments):
        calls.append(1)
        if len(calls) == 2:
            raise KeyboardInterrupt
        return real(self, *arguments)

    monkeypatch.setattr(cpu.Batch, "advanced", second_fails)
    with pytest.raises(KeyboardInterrupt):
        session.advance(CHEESE.motion.replace(angle=0.2), 0.05)
    monkeypatch.undo()
    np.testing.assert_array_equal(session.poses, before)
    assert session.time == pytest.approx(0.02)
    assert session.motions == [s.motion for s in session.scenarios]
