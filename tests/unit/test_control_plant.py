"""The plant: the same in any company, what goes wrong told, sheets kicked and made wet on the way."""

from __future__ import annotations

import numpy as np
import pytest

import plategait as pg
from plategait.control.camera import PERFECT, Camera
from plategait.control.drive import Drive
from plategait.control.plant import Plant

CHEESE = pg.preset("cheese").scenario.replace(slip_limit="1 m", plate={"length": "200 mm", "width": "200 mm"})
SMALL = CHEESE.replace(**{"sheet.outline": pg.Rectangle(length=0.04, width=0.03), "sheet.mass": 3e-3})
DRIVE = Drive("source-robot", CHEESE.motion.replace(angle=0, stroke=0))


def gentle(seed: int, ticks: int, n: int) -> np.ndarray:
    """Actions (ticks, n, d) that shake without throwing the sheet over."""
    return np.random.default_rng(seed).uniform(-0.4, 0.4, (ticks, n, len(DRIVE)))


def test_lanes_do_not_know_of_each_other():
    starts = [CHEESE.replace(**{"start.x": x}) for x in (0.0, 0.01)] + [SMALL]
    camera = Camera(rate="50 Hz", missed=0.2)
    actions = gentle(1, 12, 3)
    together = Plant(starts, camera=camera, seeds=[4, 5, 6])
    alone = [Plant([start], camera=camera, seeds=[seed]) for start, seed in zip(starts, (4, 5, 6), strict=True)]
    for tick, action in enumerate(actions):
        if tick == 7:  # one of them begins anew, so that its frames fall between the others'
            together.reset([1])
            alone[1].reset()
        seen = together.step(DRIVE.motions(action))
        for lane, plant in enumerate(alone):
            own = plant.step(DRIVE.motions(action[lane : lane + 1]))
            np.testing.assert_array_equal(seen.poses[lane], own.poses[0])
            np.testing.assert_array_equal(seen.taken[lane], own.taken[0])
            np.testing.assert_array_equal(together.poses[lane], plant.poses[0])
    assert together.time.tolist() == pytest.approx([12 / 60, 5 / 60, 12 / 60])


def test_frames_between_ticks_show_where_the_sheet_was_then():
    motion = CHEESE.motion.replace(frequency=20.0, ramp=0.015)
    plant = Plant([CHEESE], camera=PERFECT.replace(rate=90.0), tick=1 / 60)
    session = pg.Session([CHEESE.replace(motion=motion.replace(angle=0, stroke=0))], machine="source-robot")
    for frame in range(1, 7):
        session.advance(motion, 1 / 90)
        if frame % 3 != 2:
            seen = plant.step(motion)
            assert seen.taken[0] == pytest.approx(frame / 90)
            np.testing.assert_allclose(seen.poses, session.poses, atol=1e-12)


def test_a_plate_stands_until_it_is_told_to_move():
    plant = Plant([CHEESE], camera=PERFECT)
    for _ in range(10):
        plant.step(None)
    np.testing.assert_allclose(plant.poses, 0, atol=1e-6)
    assert plant.status == [""]


def test_a_copy_is_a_rollout():
    plant = Plant([CHEESE] * 2)
    actions = gentle(2, 6, 2)
    for action in actions[:3]:
        plant.step(DRIVE.motions(action))
    saved = plant.copy()
    there = [plant.step(DRIVE.motions(action)).poses for action in actions[3:]]
    plant.restore(saved)
    again = [plant.step(DRIVE.motions(action)).poses for action in actions[3:]]
    np.testing.assert_array_equal(there, again)
    with pytest.raises(pg.InputError, match=r"^saved: "):
        plant.restore(Plant([CHEESE]))


def test_what_goes_wrong_is_told_and_stays_told():
    endless = CHEESE.replace(plate=None)
    plant = Plant([CHEESE, CHEESE.replace(**{"start.x": 0.099}), CHEESE, endless], machine=None)
    plant.push(1, (0.5, 0.0, 0.0))
    throw = CHEESE.motion.replace(frequency=30.0, angle=0.4, stroke=0.003, ramp=0.015)
    for _ in range(40):
        plant.step([None, None, throw, None])
    status = plant.status
    assert status[:2] == ["", "left the plate"]
    assert status[2] in ("turned over", "folded", "left the plate")
    plant.reset([1])
    assert plant.status[1] == ""
    assert plant.status[2] == status[2]
    plant.reset([3])
    plant.push(3, (1e4, 0.0, 0.0))
    plant.step(None)
    assert plant.status[3] == "diverged"


def test_a_strip_without_an_area_is_not_folded():
    strip = CHEESE.replace(**{"sheet.outline": pg.Rectangle(length=0.05, width=0.01), "sheet.mass": 1e-3})
    assert len(strip.sheet.lattice.cells) == 0
    plant = Plant([strip])
    plant.step(None)
    assert plant.status == [""]


def test_a_kick_is_a_rigid_velocity():
    session = pg.Session([CHEESE])
    session.advance(None, 0.01)
    x, v = (np.array(session.recording(0).positions), np.array(session.recording(0).velocities))
    session.push(0, (0.2, -0.1, 3.0))
    after = session._engine._batches[0].state.v[0]
    given, arm, m = after - v, x - x.mean(axis=0), CHEESE.sheet.node_mass
    np.testing.assert_allclose(m * given.sum(axis=0), CHEESE.sheet.mass * np.array([0.2, -0.1, 0.0]), atol=1e-12)
    inertia = m * (arm[:, :2] ** 2).sum()
    np.testing.assert_allclose(m * np.cross(arm, given).sum(axis=0)[2], 3.0 * inertia, rtol=1e-9)
    np.testing.assert_array_equal(given[:, 2], 0)
    for wrong in ((1.0, 2.0), (np.nan, 0, 0)):
        with pytest.raises(pg.InputError, match=r"^velocity: "):
            session.push(0, wrong)


def test_a_kicked_sheet_slides_as_far_as_friction_lets_it():
    # A level plate that stands: v²/(2 μ_k g). The slow end of the friction law lets it creep a little further.
    plant = Plant([CHEESE], camera=PERFECT)
    plant.step(None)
    start = plant.poses[0, 0]
    plant.push(0, (0.3, 0.0, 0.0))
    for _ in range(20):
        plant.step(None)
    expected = 0.3**2 / (2 * CHEESE.friction.kinetic * CHEESE.gravity)
    assert plant.poses[0, 0] - start == pytest.approx(expected, rel=0.05)


def test_a_wet_spot_changes_nothing_but_friction():
    wet = CHEESE.replace(**{"friction.static": 0.2, "friction.kinetic": 0.15})
    plant = Plant([CHEESE, CHEESE, wet], camera=PERFECT)
    plant.step(None)
    plant.become(1, wet)
    np.testing.assert_array_equal(plant.poses[0], plant.poses[1])
    for lane in range(3):
        plant.push(lane, (0.2, 0.0, 0.0))
    for _ in range(20):
        plant.step(None)
    way = plant.poses[:, 0]
    assert way[1] > 2 * way[0]
    assert way[1] == pytest.approx(way[2], rel=0.01)  # which was wet from the start
    for change in ({"sheet.pitch": 0.004}, {"start.x": 0.01}, {"plate.length": 0.3}, {"motion.frequency": 12},
                   {"sheet.axial_stiffness": 1e6}):  # fmt: skip
        with pytest.raises(pg.InputError, match=r"^scenario"):
            plant.session.become(0, plant.session.scenarios[0].replace(**change))


def test_what_a_plant_refuses():
    plant = Plant([CHEESE])
    for call, field in (
        (lambda: Plant([CHEESE], seeds=[1, 2]), "seeds"),
        (lambda: Plant([CHEESE], seeds=[-1]), "seeds"),
        (lambda: Plant([CHEESE], tick=0), "tick"),
        (lambda: plant.reset([0], seeds=[]), "seeds"),
        (lambda: plant.reset([1]), "runs"),
        (lambda: plant.step(CHEESE.motion.replace(frequency=60)), r"motions\.0"),
    ):
        with pytest.raises(pg.InputError, match=rf"^{field}: "):
            call()
    assert plant.time.tolist() == [0.0]
