"""Slides and free vibrations in closed form, and the engine's own ringing, through the identification."""

from __future__ import annotations

import math

import numpy as np
import pytest
from bench import flat, run, strip

from plategait.identify.friction.recording import Tilt, TiltRecording, smooth_tilt
from plategait.identify.friction.result import identify_friction
from plategait.identify.friction.slide import fit_slide
from plategait.identify.friction.synthetic import slide_length, tilt_recording
from plategait.identify.modes.decay import fit_decays, matrix_pencil, mode_columns
from plategait.identify.modes.fit import identify_ring
from plategait.identify.modes.recording import RingRecording
from plategait.identify.modes.synthetic import ring_recording
from plategait.model.presets import preset
from plategait.theory.rigid import GRAVITY

pytestmark = pytest.mark.linear_algebra

CHEESE = preset("cheese").scenario.sheet
QUIET = {"noise": 0.0, "angle_noise": 0.0}


def test_on_a_still_slope_the_slide_is_a_parabola():
    time = np.linspace(0, 1, 61)
    theta, kinetic, slip = math.radians(35), 0.4, 0.3123
    acceleration = GRAVITY * (math.sin(theta) - kinetic * math.cos(theta))
    position = 0.02 + acceleration * np.maximum(time - slip, 0) ** 2 / 2
    fit = fit_slide(Tilt(time, np.full(61, theta)), position, (0.1, 0.8))
    assert fit.slip_time is not None
    # The grid of slip times closes in to 1e-9 s; that times the acceleration over the slide's 0.7 s is far below 1e-6.
    assert fit.slip_time.value == pytest.approx(slip, abs=1e-7)
    assert fit.kinetic.value == pytest.approx(kinetic, abs=1e-6)
    np.testing.assert_allclose(fit.fitted, position, atol=1e-8)


def test_the_made_up_slide_obeys_its_equation_of_motion():
    t, alpha, rate, kinetic = np.linspace(0, 0.5, 101), 0.6, 0.05, 0.4
    s = slide_length(t, alpha, rate, kinetic)
    h = t[1]
    theta = alpha + rate * t[1:-1]
    # Second differences of 5 ms: truncation h²/12 g Ω² ~ 5e-8, rounding g 1e-16/Ω²/h² ~ 2e-8 a few times over.
    expected = GRAVITY * (np.sin(theta) - kinetic * np.cos(theta))
    np.testing.assert_allclose(np.diff(s, 2) / h**2, expected, atol=1e-6)
    assert s[0] == 0
    assert s[1] == pytest.approx(h**2 / 2 * expected[0], rel=1e-3)  # begins at rest


@pytest.mark.parametrize(("static", "kinetic"), [(0.3, 0.1), (0.75, 0.4), (1.2, 1.14), (0.75, 0.75)])
@pytest.mark.parametrize("fps", [30, 240])
def test_a_noiseless_tilt_is_recovered_between_the_frames(static, kinetic, fps):
    result = identify_friction([TiltRecording("made up", *tilt_recording(static, kinetic, fps=fps, seed=3, **QUIET))])
    # sin θ is taken as straight between frames: off by (Ω/fps)²/8 ~ 2e-7 of it at 30 fps. Where μ_k = μ_s the slide
    # begins as t³, and a position off by that much moves the slip by a hundred times more.
    tolerance = 2e-6 if kinetic < 0.9 * static else 2e-4
    assert result.static is not None
    assert result.kinetic is not None
    assert result.static.value == pytest.approx(static, abs=tolerance)
    assert result.kinetic.value == pytest.approx(kinetic, abs=tolerance)
    assert result.kinetic.value <= result.static.value


def test_the_slip_angle_is_not_that_of_the_first_frame_that_shows_it():
    # 30 fps at 10 deg/s: the first frame that shows 3 sds of motion is late by a third of a degree and more.
    late, errors = [], []
    for seed in range(12):
        time, angle, position = tilt_recording(0.75, 0.4, rate=math.radians(10), fps=30, rest=1.5, seed=seed)
        row = int(np.argmax(position > 3 * 3e-4))
        late.append(math.degrees(smooth_tilt(time, angle).at(time[row]) - math.atan(0.75)))
        trial = identify_friction([TiltRecording("made up", time, angle, position)]).trials[0]
        assert trial.slip_angle is not None
        errors.append(math.degrees(trial.slip_angle.value - math.atan(0.75)))
    assert np.median(late) > 0.3
    # Sds of the single trials are 0.02 deg: three of the mean of twelve.
    assert abs(np.mean(errors)) < 0.02


@pytest.mark.slow
def test_a_smoothed_angle_is_as_sure_as_it_says():
    time = np.linspace(0, 2, 121)
    tilts = [smooth_tilt(time, 0.1 * time + np.random.default_rng(s).normal(0, 1e-3, 121)) for s in range(200)]
    scatter = np.std([float(t.at(1.5)) for t in tilts])
    claimed = math.sqrt(np.mean([t.sd(1.5) ** 2 for t in tilts]))
    # A straight line has no bias: what is claimed for it, a factor √(0.354/0.265) = 1.16 inside, is spare.
    # The scatter of 200 is 5 % off, three times.
    assert 0.85 < claimed / scatter < 1.16 * 1.15


@pytest.mark.parametrize("ratio", [0.0, 0.3, 1 - 1e-9, 1.0, 1 + 1e-9, 3.0])
def test_a_mode_solves_its_equation_at_any_damping(ratio):
    omega, h = 20.0, 1e-4
    time = np.arange(0, 0.3, h)
    y = mode_columns(time, omega, ratio)
    first, second = (y[2:] - y[:-2]) / (2 * h), np.diff(y, 2, axis=0) / h**2
    left = second + 2 * ratio * omega * first + omega**2 * y[1:-1]
    # Central differences: h²/6 · 2 ζ ω r³ with the fastest rate r, half of the motion at ζ = 3: 0.16 of 13,000.
    assert np.abs(left).max() < (0.16 if ratio > 2 else 0.01)
    np.testing.assert_allclose(y[0], [1, 0], atol=1e-12)


def test_the_matrix_pencil_is_exact_on_sums_of_decays():
    time = np.arange(200) / 400
    poles = np.array([-1 + 30j, -4 + 95j, -0.2 + 260j])
    signal = np.sum([np.real(w * np.exp(p * time)) for w, p in zip((1, 0.3j, 0.1), poles, strict=True)], axis=0)
    fitted = matrix_pencil(signal, 1 / 400, 6)
    fitted = np.sort_complex(1j * fitted[fitted.imag > 0])[::-1] / 1j
    np.testing.assert_allclose(fitted, poles, rtol=1e-6)


@pytest.mark.parametrize(
    ("frequencies", "ratios"),
    [([5], [0.01]), ([2], [0.5]), ([5, 31], [0.03, 0.05]), ([4, 5, 12], [0.1, 0.02, 0.3])],
)
def test_noiseless_rings_are_recovered_exactly(frequencies, ratios):
    amplitudes = [5e-3, 2e-3, 3e-3][: len(frequencies)]
    time, y = ring_recording(frequencies, ratios, amplitudes=amplitudes, noise=0, drift=2e-3, seed=1)
    fit = fit_decays(time, y, modes=len(frequencies))
    # Gauss–Newton on residuals that vanish converges quadratically, past its own tolerance of 1e-8.
    np.testing.assert_allclose(fit.omega / (2 * math.pi), frequencies, rtol=1e-6)
    np.testing.assert_allclose(fit.damping_ratio, ratios, rtol=1e-6)


@pytest.mark.parametrize("damping", ["4.23e-6 N*mm/(deg/s)", "42.3e-6 N*mm/(deg/s)"])
def test_the_engine_s_free_sheet_is_identified_from_its_ringing(damping):
    sheet = CHEESE.replace(bending_damping=damping)
    dish = sheet.free_modes.dish
    dt = 1e-4
    positions = flat(sheet, 1.0)
    positions[:, 2] += 1e-5 * dish.shape
    recording = run(sheet, duration=0.8, dt=dt, gravity=0.0, positions=positions, snapshots=1)
    middle = recording.snapshots[::20, :, 2].astype(float) @ dish.shape / (dish.shape @ dish.shape)
    ringing = RingRecording("engine", "deflection", recording.snapshot_time[::20], middle)
    result = identify_ring(ringing, CHEESE)
    assert result.mode is not None
    assert result.stiffness is not None
    assert result.damping is not None
    # Semi-implicit Euler with explicit damping is first order, ω dt/2 = 0.16 %; snapshots are kept in single precision,
    # at a height of 1 m to 6e-8 m, which is noise of 0.6 % of the amplitude in single nodes.
    assert result.mode.omega.value == pytest.approx(dish.omega, rel=4e-3)
    assert result.mode.damping_ratio.value == pytest.approx(dish.damping_ratio, rel=1e-2)
    assert result.stiffness.value == pytest.approx(sheet.bending_stiffness, rel=8e-3)
    assert result.damping.value == pytest.approx(sheet.bending_damping, rel=1.5e-2)


@pytest.mark.slow
def test_the_engine_s_cantilever_is_identified_as_it_sags_from_level():
    # Let go level, it rings about its sag, which is 2 % of its length: gravity changes nothing to first order.
    length, pitch, area_mass = 0.01, 0.01 / 16, 2.6
    sheet = strip(17, pitch=pitch, bending_stiffness=1.56e-4, bending_damping=2.4e-8)
    held = np.arange(17) < 2
    dt = 0.8 * sheet.stable_time_step
    recording = run(sheet, duration=0.15, dt=dt, positions=flat(sheet, 0.05), held=held, snapshots=100)
    tip = recording.snapshots[:, -1, 2].astype(float)
    ringing = RingRecording("engine", "deflection", recording.snapshot_time, tip)
    result = identify_ring(ringing, CHEESE, support="cantilever", length=length, mass_per_area=area_mass)
    assert result.stiffness is not None
    assert result.damping is not None
    # A lattice of 16 pitches is 0.3 % off in frequency (second order in the pitch, see test_joints); k_b goes as its
    # square.
    assert result.stiffness.value == pytest.approx(sheet.bending_stiffness, rel=0.01)
    assert result.damping.value == pytest.approx(sheet.bending_damping, rel=0.02)
    assert not any("sags" in note for note in result.notes)
