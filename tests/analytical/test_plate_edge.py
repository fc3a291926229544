"""The edge of a finite plate: what comes from beside, what hangs over, tips, slides off and falls."""

from __future__ import annotations

import math

import numpy as np
import pytest
from bench import STILL, flat, run, strip

from plategait.engine import cpu
from plategait.engine.recording import RunRequest
from plategait.model.contact import Contact, Friction
from plategait.model.motion import PlateMotion, Wave
from plategait.model.presets import preset
from plategait.model.scenario import Plate
from plategait.simulation.observation import observe
from plategait.simulation.run import simulate, simulate_all

NODE = strip(1)
PLATE = Plate(length=0.1, width=0.1)
CHEESE = preset("cheese").scenario.replace(
    plate=PLATE, **{"motion.frequency": "14 Hz", "motion.angle": "6 deg", "duration": 0.6, "slip_limit": 0.2}
)


@pytest.mark.parametrize("depth", [2e-4, 2e-3, 5e-2])
@pytest.mark.parametrize("way", [(-1, 0), (1, 0), (0, -1), (0, 1)])
def test_a_node_from_beside_the_plate_gets_no_force(depth, way):
    # No gravity: whatever it feels would change its speed. It crosses the whole plate beneath the surface.
    start, speed = -0.06 * np.array(way), 0.5 * np.array(way)
    recording = run(
        NODE, duration=0.3, dt=1e-4, gravity=0.0, plate=PLATE,
        positions=[[*start, -depth]], velocities=[[*speed, 0.0]],
    )  # fmt: skip
    assert recording.velocities[0].tolist() == [*speed, 0.0]
    assert not recording["contact_energy"].any()


def test_a_node_that_rises_from_beneath_passes_and_lies_on_top_when_it_comes_down():
    # Up through the plate from 5 mm beneath it, no force on the way; then down on its top face like any other.
    recording = run(
        NODE, duration=0.3, dt=1e-4, plate=PLATE, positions=[[0.0505, 0.0, -5e-3]], velocities=[[-0.3, 0.0, 1.0]],
        snapshots=1, friction=Friction(static=0.0, kinetic=0.0),
    )  # fmt: skip
    height = recording.snapshots[:, 0, 2]
    assert height.max() == pytest.approx(-5e-3 + 1 / (2 * 9.81), rel=2e-3), "a free throw, to v dt/2"
    assert height[-1] == pytest.approx(-Contact().static_depth(NODE.node_mass, NODE.pitch, 9.81), abs=2e-5)


def test_a_node_that_slides_over_the_edge_falls_freely():
    depth = Contact().static_depth(NODE.node_mass, NODE.pitch, 9.81)
    recording = run(
        NODE, duration=0.3, dt=1e-4, plate=PLATE, positions=[[0.045, 0.0, -depth]], velocities=[[0.4, 0.0, 0.0]],
        friction=Friction(static=0.0, kinetic=0.0),
    )  # fmt: skip
    # Over the edge after 5 mm at 0.4 m/s.
    falling = 0.3 - 0.005 / 0.4
    assert recording.positions[0, 2] == pytest.approx(-9.81 * falling**2 / 2, rel=2e-3)
    assert recording.velocities[0, 0] == pytest.approx(0.4, rel=1e-6)


@pytest.mark.parametrize("nodes", [6, 7])
@pytest.mark.parametrize("axis", ["x", "y"])
@pytest.mark.parametrize("beyond", [-1.5e-3, -5e-4, 5e-4, 1.5e-3])
def test_a_strip_tips_where_statics_says(nodes, axis, beyond):
    # Stiff, so it tips as a whole, and as soon as its centre of mass is beyond the edge: whatever part of a pitch lies
    # between its nodes and the edge. The contact gives way by less than 0.1 mm.
    sheet = strip(nodes, bending_stiffness=0.05)
    positions = flat(sheet, -Contact().static_depth(sheet.node_mass, sheet.pitch, 9.81))
    positions[:, 0] += 0.05 + beyond
    if axis == "y":
        positions = positions[:, [1, 0, 2]]
    recording = run(sheet, duration=0.5, dt=2e-5, positions=positions, plate=PLATE)
    low = float(recording["height_low"].min())
    if beyond < 0:
        assert low > -5e-3
    else:
        assert low < -2e-2


def test_a_soft_sheet_hangs_over_the_edge_and_stays():
    # A quarter of the disk overhangs a plate at rest: it sags, friction holds it, nothing gains energy.
    still = CHEESE.replace(motion=STILL.replace(frequency=14.0), duration=3.0, **{"start.y": "25 mm"})
    hanging = simulate(still, snapshot_interval=0.1)
    assert hanging.failure is None
    assert hanging.observations[0].energy.closes
    recording = hanging.recordings[0]
    over = np.abs(recording.positions[:, 1]) < 0.05
    assert recording.positions[over, 2].min() > -2e-4, "what is over the plate lies on it"
    assert recording.positions[~over, 2].max() < 0, "and what is not hangs"
    assert recording["kinetic_energy"][-1] < 1e-3 * recording["kinetic_energy"].max()


@pytest.mark.parametrize("y", ["20 mm", "25 mm", "30 mm"])
def test_the_books_of_a_sheet_that_hangs_and_rests_stand_still(y):
    # Between samples a hundred times the energy that is given would pass through books that took the edge's own push
    # for motion. What is left is round-off and what the step is out by: a share of some 1e-3.
    hanging = simulate(CHEESE.replace(motion=STILL.replace(frequency=14.0), duration=2.0, **{"start.y": y}))
    (recording,), (observation,) = hanging.recordings, hanging.observations
    assert observation.energy.imbalance < 5e-3
    assert np.abs(recording["contact_work"][-300:]).sum() < 1e-3 * observation.energy.given
    # The first sample knows the edge's share of the weight as the next one does, which is within a hundredth.
    assert recording["contact_energy"][0] == pytest.approx(recording["contact_energy"][1], rel=0.01)


def test_a_sheet_driven_over_the_edge_leaves_the_plate_and_falls():
    # Both precisions and a halved step tell the same story at the same time; chaos decides about milliseconds.
    driven = [CHEESE.replace(**{"start.y": f"{y} mm"}) for y in (15, 20, 30, 40)]
    told = {}
    for name, engine, share in (("default", "cpu", 1.0), ("halved", "cpu", 0.5), ("double", "cpu64", 0.5)):
        runs = simulate_all([s.replace(time_step=share * s.dt) for s in driven], engine=engine)
        for one in runs:
            (observation,), (recording,) = one.observations, one.recordings
            assert observation.failure is not None
            assert observation.failure.kind == "left the plate"
            assert observation.energy.closes
            # It cannot be faster than what the plate gave plus its fall.
            fall = one.scenario.sheet.mass * 9.81 * max(0.0, -float(recording["centre_z"].min()) + 0.01)
            assert recording["kinetic_energy"].max() < fall + np.abs(recording["plate_work"]).sum()
            assert recording["contact_energy"].max() < 1e-3, "a node pressed in by less than a millimetre"
        told[name] = [one.observations[0].failure.time for one in runs]
    assert told["halved"] == pytest.approx(told["default"], abs=0.03)
    assert told["double"] == pytest.approx(told["default"], abs=0.03)


def test_a_slip_on_the_way_off_is_the_first_sign_and_ends_what_is_measured():
    limited = CHEESE.replace(**{"start.y": "20 mm", "slip_limit": 0.01})
    observation = simulate(limited).observations[0]
    assert observation.failure is not None
    assert observation.failure.kind == "left the plate"
    assert observation.failure.sound_until < observation.failure.time
    free = simulate(CHEESE.replace(**{"start.y": "20 mm"})).observations[0]
    assert free.failure is not None
    assert free.failure.time == observation.failure.time


def test_no_energy_is_made_at_the_edge():
    # Sheets thrown at the edge of a plate at rest, from above and from beside: each ledger closes, and the energy that
    # is there never exceeds what there was.
    generator = np.random.default_rng(11)
    scenario = CHEESE.replace(motion=STILL.replace(frequency=14.0), duration=0.4)
    rest = scenario.sheet.lattice.rest * scenario.sheet.pitch
    runs = []
    for _ in range(48):
        angle, tilt = generator.uniform(0, 2 * math.pi), generator.uniform(-1, 1)
        flat_sheet = np.column_stack([rest[:, 0], rest[:, 1] * math.cos(tilt), rest[:, 1] * math.sin(tilt)])
        turn = np.array([[math.cos(angle), math.sin(angle), 0], [-math.sin(angle), math.cos(angle), 0], [0, 0, 1]])
        centre = [*generator.uniform(-0.09, 0.09, 2), generator.uniform(-0.05, 0.08)]
        centre[2] = max(centre[2], 0.045) if max(np.abs(centre[:2])) < 0.05 else centre[2]
        velocity = generator.normal(0, 0.4, 3)
        runs.append(RunRequest(scenario, initial=(flat_sheet @ turn + centre, np.tile(velocity, (len(rest), 1)))))
    touched = 0
    for case, recording in zip(runs, cpu.run(runs, "float64"), strict=True):
        ledger = observe(case.scenario, recording).energy
        there = sum(recording[f"{kind}_energy"] for kind in ("kinetic", "gravity", "axial", "bending", "contact"))
        assert there.max() - there[0] < 0.02 * ledger.given
        assert ledger.closes
        touched += recording["contact_energy"].max() > 0
    assert touched > 20, "most of them meet the plate"


def test_a_plate_that_the_sheet_never_reaches_the_end_of_changes_no_bit():
    large = CHEESE.replace(plate=Plate(length=1.0, width=1.0), duration=0.5)
    (bounded,), (endless,) = simulate(large).recordings, simulate(large.replace(plate=None)).recordings
    for name in bounded.channels:
        assert np.array_equal(bounded[name], endless[name]), name


@pytest.mark.slow
@pytest.mark.parametrize("turns", [1.5, 4, 40])
@pytest.mark.parametrize("axis", ["rz", "waves"])
def test_a_rough_sheet_turns_with_a_turntable_of_many_turns(turns, axis):
    # Friction holds the sheet to a table whose angle goes through whole turns: no spin against it. The acceleration
    # stays far below what friction can hold at the rim (μ_s g = 7.4 m/s² at 40 mm: 184 rad/s²).
    duration, angle = 2.0, turns * 2 * math.pi
    if axis == "waves":
        # There and back: a sine of that amplitude, slow enough.
        period = 4 * duration * max(1.0, turns / 4)
        motion = PlateMotion(frequency=1 / period, angle=0.0, stroke=0.0, ramp=1.0,
                             waves=(Wave(axis="rz", amplitude=angle),))  # fmt: skip
        duration = period / 2
    else:
        from plategait.model.motion import Samples

        duration *= max(1.0, turns / 4)
        time = np.linspace(0, duration, 400)
        share = time / duration
        smooth = share**3 * (10 - 15 * share + 6 * share**2)
        motion = PlateMotion(
            frequency=10.0, angle=0.0, stroke=0.0, ramp=0.0, samples=Samples(time=tuple(time), rz=tuple(angle * smooth))
        )
    scenario = CHEESE.replace(motion=motion, plate=None, duration=duration)
    (recording,) = simulate(scenario).recordings
    assert recording["plate_rz"].max() == pytest.approx(angle, rel=1e-3)
    drift = np.unwrap(np.arctan2(recording["spin_cross"], recording["spin_dot"]))
    # It creeps while the static law slips each step: a fraction of a degree, not turns.
    assert np.abs(np.degrees(drift)).max() < 2.0
