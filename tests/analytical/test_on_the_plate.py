"""A whole sheet on a moving plate: the rigid disk against (2.3), energy, plate motion."""

from __future__ import annotations

import math

import numpy as np
import pytest
from bench import STILL, flat, observed_order, run, strip

from plategait.model.motion import PlateMotion, Samples, Wave
from plategait.model.presets import PRESETS, preset
from plategait.simulation.energy import LEDGER_TOLERANCE, energy_ledger
from plategait.simulation.observables import rotation
from plategait.simulation.run import simulate, simulate_all

CHEESE = preset("cheese").scenario
RIGID = CHEESE.sheet.with_natural_frequency(320 * math.pi)


def test_a_sheet_lies_on_a_plate_that_does_not_start_where_it_rests():
    # Turned, lifted, tilted by less than friction holds (the angle of 0.22 rad against atan 0.75): it stays as laid.
    pose = {"x": 0.01, "z": 0.005, "rx": 0.2, "ry": -0.1, "rz": 2.0}
    samples = Samples(time=(0.0, 10.0), **{axis: (value, value) for axis, value in pose.items()})
    motion = PlateMotion(angle=0.0, stroke=0.0, ramp=0.0, height="7 mm", samples=samples)
    laid = simulate(CHEESE.replace(motion=motion, duration=0.3, **{"start.x": "5 mm", "start.y": "-10 mm"}))
    (recording,), (observation,) = laid.recordings, laid.observations
    # Within a micrometre: it creeps, and the contact carries cos 0.22 of the weight.
    assert recording["centre_x"] == pytest.approx(0.005, abs=1e-6)
    assert recording["centre_y"] == pytest.approx(-0.01, abs=1e-6)
    assert recording["centre_z"] == pytest.approx(recording["centre_z"][0], abs=1e-6)
    assert observation.failure is None
    assert observation.energy.closes


def test_a_plate_that_starts_at_the_end_of_its_swing_throws_nothing():
    # A cosine without a smooth start: the sheet lies on the tilted plate, at rest as that is.
    motion = PlateMotion(angle=0.0, stroke=0.0, ramp=0.0, waves=(Wave(axis="rx", amplitude=0.05, phase="90 deg"),))
    swung = simulate(CHEESE.replace(motion=motion, duration=0.5, **{"motion.frequency": "14 Hz"}))
    assert swung.failure is None
    assert swung.observations[0].energy.imbalance < 0.01


def test_a_sliding_rigid_disk_spins_up_as_2_3_says():
    # The plate turns about the bar at constant Θ'' while the disk slides along the bar: the moment (2.3) is
    # mu_k Θ'' Σ m y², against the inertia Σ m (x² + y²), twice as large: the disk spins up at mu_k Θ''/2.
    # Θ'' y stays below g, so it keeps full contact; Θ stays below 0.02 rad, whose cosine is 1 to 2e-4.
    acceleration, duration = 100.0, 0.02
    time = np.linspace(0, duration, 201)
    motion = PlateMotion(
        angle=0.0, stroke=0.0, ramp=0.0, samples=Samples(time=tuple(time), rx=tuple(-acceleration * time**2 / 2))
    )
    depth = CHEESE.contact.static_depth(RIGID.node_mass, RIGID.pitch, 9.81)
    positions = flat(RIGID, -depth)
    rates = {}
    for way in (1.0, -1.0):
        velocities = np.zeros_like(positions)
        velocities[:, 0] = 0.6 * way
        velocities[:, 2] = 0.0
        recording = run(
            RIGID,
            duration=duration,
            dt=2e-5,
            positions=positions,
            velocities=velocities,
            motion=motion,
            friction=CHEESE.friction,
        )
        t, angle = recording["time"], rotation(recording["spin_cross"], recording["spin_dot"])
        # The contact takes its first milliseconds to carry the new load: fit the spin-up after them.
        late = t > 0.008
        rates[way] = 2 * np.polyfit(t[late], angle[late], 2)[0]
    expected = CHEESE.friction.kinetic * acceleration / 2
    # Loading the nonlinear contact leaves the pressure a few per cent off (2.1)'s straight line.
    assert abs(rates[1.0]) == pytest.approx(expected, rel=0.05)
    assert rates[-1.0] == pytest.approx(-rates[1.0], rel=1e-6), "slip the other way, spin the other way"


def test_positive_amplitudes_spin_counter_clockwise():
    # Section 4.2: A_p > 0 and B_p > 0 rotate the object counter-clockwise; either sign changed, clockwise.
    rates = []
    for angle, stroke in ((0.05, 0.003), (-0.05, 0.003), (0.05, -0.003)):
        rates.append(
            simulate(
                CHEESE.replace(**{"motion.angle": angle, "motion.stroke": stroke, "motion.frequency": 18.0})
            ).spin_rate
        )
    assert rates[0] > 1.0
    # Mirror images: the same rate but for round-off grown over 4 s.
    assert rates[1] == pytest.approx(-rates[0], rel=0.02)
    assert rates[2] == pytest.approx(-rates[0], rel=0.02)


def test_the_energy_ledger_closes_as_the_step_shrinks():
    # Over a vigorous half second, plate work = stored + lost + a residual of at least first order in the step.
    steps = np.array([4e-5, 2e-5, 1e-5])
    residuals = []
    for dt in steps:
        scenario = CHEESE.replace(duration=0.5, time_step=dt)
        residuals.append(simulate(scenario, engine="cpu64").observations[0].energy.relative_residual)
    assert abs(residuals[-1]) < 2e-3
    assert observed_order(residuals, steps) > 1.2  # 1.8 was measured


def test_the_books_of_the_presets_balance_at_their_default_steps():
    changes = [{"motion.angle": math.radians(a), "motion.frequency": f} for a in (3, 12) for f in (12.0, 20.0, 28.0)]
    scenarios = [preset(name).scenario.replace(duration=1.0, **change) for name in PRESETS for change in changes]
    worst = max(o.energy.imbalance for s in simulate_all(scenarios) for o in s.observations)
    # 2.2 % over twenty times as many runs (docs/numerics.md), and what another instruction set makes of chaos.
    assert worst < 0.7 * LEDGER_TOLERANCE


@pytest.mark.parametrize("ratio", [8.0, 16.0])
def test_a_sheet_stiff_in_shear_keeps_its_books_at_its_default_step(ratio):
    changes = [{"motion.angle": math.radians(a), "motion.frequency": f} for a in (3, 12) for f in (12.0, 20.0)]
    stiff = CHEESE.replace(duration=1.0, **{"sheet.shear_ratio": ratio})
    assert stiff.dt < stiff.sheet.stable_time_step < CHEESE.sheet.stable_time_step
    for simulation in simulate_all([stiff.replace(**change) for change in changes]):
        assert not any(recording.diverged for recording in simulation.recordings)
        assert all(observation.energy.closes for observation in simulation.observations)


@pytest.mark.parametrize("degrees", [0.0, 1e-6, 1e-4, 1e-2])
def test_round_off_on_a_plate_that_hardly_moves_opens_no_ledger(degrees):
    # In single precision, where all there is are the microjoules stored in the contact.
    change = {"motion.angle": math.radians(degrees), "motion.stroke": 1e-3 * degrees}
    runs = simulate_all([preset(name).scenario.replace(duration=1.0, **change) for name in PRESETS])
    # 0.2 % after a minute.
    assert max(o.energy.imbalance for s in runs for o in s.observations) < 2e-3


def test_the_ledger_of_a_free_fall_is_exact():
    sheet = strip(3, 3)
    recording = run(sheet, duration=0.05, dt=1e-4, positions=flat(sheet, 1.0))
    ledger = energy_ledger(recording.channels)
    # Semi-implicit Euler falls dt/2·v too far: m g · g t dt/2.
    assert ledger.residual == pytest.approx(sheet.mass * 9.81**2 * 0.05 * 1e-4 / 2, rel=1e-6)
    assert ledger.plate_work == 0
    assert ledger.friction_loss == 0


def test_the_recorded_plate_follows_4_1_and_4_2():
    # Θ(t) = −A_p sin ω t, X(t) = B_p sin ω t after the ramp; and any further wave adds to them.
    waves = (Wave(axis="z", amplitude=1e-3, ratio=2.0, phase=math.pi / 2), Wave(axis="rz", amplitude=0.01, ratio=0.5))
    motion = PlateMotion(frequency=11.0, angle=0.2, stroke=0.003, ramp=0.05, waves=waves)
    recording = run(strip(2, 2), duration=0.5, dt=1e-4, motion=motion)
    t = recording["time"]
    after, w = t > 0.05, 2 * math.pi * 11 * t
    for channel, expected in (
        ("plate_rx", -0.2 * np.sin(w)),
        ("plate_x", 0.003 * np.sin(w)),
        ("plate_z", 1e-3 * np.sin(2 * w + math.pi / 2)),
        ("plate_rz", 0.01 * np.sin(w / 2)),
    ):
        np.testing.assert_allclose(recording[channel][after], expected[after], atol=1e-12)
    assert recording["plate_rx"][0] == 0
    assert recording["plate_z"][0] == 0, "the smooth start begins from rest whatever the phase"


def test_a_sampled_trajectory_gives_the_motion_of_its_sines():
    # Sampled at 1 kHz and splined, 20 Hz sines come back within (2π f dt)⁴/384·A = 6e-7 A of themselves.
    short = PlateMotion(frequency=20.0, angle=0.05, stroke=0.003, ramp=0.1)
    time = np.arange(0, 0.5005, 1e-3)
    wave = np.sin(2 * np.pi * 20 * time)
    sampled = PlateMotion(
        frequency=20.0, angle=0.0, stroke=0.0, ramp=0.1,
        samples=Samples(time=tuple(time), x=tuple(0.003 * wave), rx=tuple(-0.05 * wave)),
    )  # fmt: skip
    one, two = (run(CHEESE.sheet, duration=0.45, dt=1e-4, motion=m, friction=CHEESE.friction) for m in (short, sampled))
    np.testing.assert_allclose(two["plate_rx"], one["plate_rx"], atol=0.05 * 2e-6)
    turn = [rotation(r["spin_cross"], r["spin_dot"])[-1] for r in (one, two)]
    assert turn[1] == pytest.approx(turn[0], rel=1e-3)


def test_a_plate_at_rest_moves_nothing():
    recording = run(CHEESE.sheet, duration=0.5, dt=1e-4, motion=STILL)
    np.testing.assert_allclose(recording.positions[:, :2], CHEESE.sheet.lattice.rest * 0.01, atol=1e-12)


def test_a_disk_leaves_a_plate_that_ends():
    # Past the edge nothing carries it.
    from plategait.model.scenario import Plate, Start

    scenario = CHEESE.replace(plate=Plate(), start=Start(y=0.2), duration=0.2)
    result = simulate(scenario)
    assert result.failure is not None
    assert result.failure.kind == "left the plate"
    assert result.recordings[0].positions[:, 2].max() == pytest.approx(-9.81 * 0.2**2 / 2, rel=0.01)
