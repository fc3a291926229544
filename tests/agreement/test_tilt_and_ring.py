"""Recordings made from known friction, frequency and damping: what is recovered, and how sure it says it is."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plategait.identify.friction.recording import TiltRecording
from plategait.identify.friction.result import identify_friction
from plategait.identify.friction.synthetic import tilt_recording
from plategait.identify.modes.fit import identify_ring
from plategait.identify.modes.recording import RingRecording
from plategait.identify.modes.synthetic import ring_recording
from plategait.model.presets import preset

CHEESE = preset("cheese").scenario.sheet
SEEDS = range(40)
# Nominal 95 %: fewer than 34 of 40 has a chance of 0.3 % (binomial), and each bound below is met with room.
LEAST_COVERED = 0.85


def tilt(seed, static, kinetic, **options):
    return identify_friction([TiltRecording("tilt", *tilt_recording(static, kinetic, seed=seed, **options))])


@pytest.mark.parametrize("fps", [30, 60, 240])
@pytest.mark.parametrize(("static", "beta"), [(0.3, 0.3), (0.3, 0.95), (0.75, 0.53), (1.2, 0.3), (1.2, 0.95)])
@pytest.mark.parametrize("noise", [2e-4, 5e-4])
def test_friction_is_recovered_over_the_range_of_cameras_and_objects(fps, static, beta, noise):
    kinetic = beta * static
    results = [tilt(seed, static, kinetic, fps=fps, noise=noise) for seed in range(3)]
    for result in results:
        assert result.static is not None
        assert result.kinetic is not None
        # Largest of hundreds of trials: 0.04 deg, 7e-4 (1 + μ²) in μ_s. A slide of 0.15 m at β = 0.3 tells μ_k to
        # 5 % (sd) at 30 fps and 0.5 mm; four sds.
        assert abs(result.static.value - static) < 1.2e-3 * (1 + static**2)
        assert abs(result.kinetic.value - kinetic) < max(0.2 * kinetic, 3e-3)


def test_intervals_of_friction_hold_what_they_promise():
    inside = []
    for k, options in enumerate(({"fps": 30}, {"fps": 240, "noise": 2e-4}, {"fps": 60, "creep": 1e-3})):
        results = [tilt(40 * k + seed, 0.75, 0.4, **options) for seed in SEEDS]
        inside += [(r.static.low <= 0.75 <= r.static.high, r.kinetic.low <= 0.4 <= r.kinetic.high) for r in results]
        # And they are no wider than they need to be: the errors are about a quarter of the intervals.
        errors = np.std([r.static.value for r in results]), np.std([r.kinetic.value for r in results])
        widths = [
            np.median([m.high - m.low for m in (getattr(r, name) for r in results)]) for name in ("static", "kinetic")
        ]
        np.testing.assert_allclose(widths, 3.92 * np.array(errors), rtol=0.45)  # the sd of 40 is 11 % off, four times
    assert (np.mean(inside, axis=0) >= LEAST_COVERED + 0.03).all()  # three times as many trials: three sds are 6 %


def test_the_mean_of_several_tilts_covers_their_scatter():
    # The object's own friction scatters by 5 %, far more than each tilt is unsure: only the scatter tells.
    generator = np.random.default_rng(11)
    inside = []
    for k in range(30):
        statics = 0.75 * (1 + 0.05 * generator.normal(size=4))
        recordings = [TiltRecording(f"{i}", *tilt_recording(s, 0.5 * s, seed=4 * k + i)) for i, s in enumerate(statics)]
        mean = identify_friction(recordings).static
        assert mean is not None
        inside.append(mean.low <= 0.75 <= mean.high)
    assert np.mean(inside) >= LEAST_COVERED


def ring(seed, frequency, ratio, **options):
    cycles = 10 if ratio < 0.1 else 4
    made = ring_recording(
        [frequency], [ratio], duration=max(cycles / frequency, 0.25), seed=seed, **options
    )  # fmt: skip
    return identify_ring(RingRecording("ring", "deflection", *made), CHEESE)


@pytest.mark.parametrize("rate", [120, 400])
@pytest.mark.parametrize(("frequency", "ratio"), [(2, 0.01), (5, 0.05), (5, 0.4), (20, 0.01), (20, 0.2), (2, 0.4)])
def test_ringing_is_recovered_over_the_range_of_sheets(frequency, ratio, rate):
    for seed in range(3):
        mode = ring(seed, frequency, ratio, rate=rate).mode
        assert mode is not None
        # Noise of 1 % of the amplitude. Frequencies are told to 0.1 % where it rings for ten cycles and to 1.5 % (sd)
        # where two are all there is; damping to 5 % (sd) at worst.
        assert mode.frequency == pytest.approx(frequency, rel=0.003 if ratio < 0.1 else 0.05)
        assert mode.damping_ratio.value == pytest.approx(ratio, rel=0.2)


@pytest.mark.parametrize(("frequency", "ratio"), [(5, 0.02), (8, 0.3)])
def test_intervals_of_ringing_hold_what_they_promise(frequency, ratio):
    modes = [ring(seed, frequency, ratio, noise=1e-4).mode for seed in SEEDS]
    omega = 2 * math.pi * frequency
    inside = [
        (m.omega.low <= omega <= m.omega.high, m.damping_ratio.low <= ratio <= m.damping_ratio.high) for m in modes
    ]
    assert (np.mean(inside, axis=0) >= LEAST_COVERED).all()
    errors = np.std([m.omega.value for m in modes]), np.std([m.damping_ratio.value for m in modes])
    widths = [
        np.median([m.high - m.low for m in intervals])
        for intervals in zip(*((m.omega, m.damping_ratio) for m in modes), strict=True)
    ]
    np.testing.assert_allclose(widths, 3.94 * np.array(errors), rtol=0.35)  # the sd of 40 is 11 % off, three times


def test_two_modes_are_told_apart_and_the_number_is_not_overdone():
    for seed in range(5):
        made = ring_recording([4, 5], [0.05, 0.08], amplitudes=[3e-3, 5e-3], duration=3, noise=5e-5, seed=seed)
        modes = identify_ring(RingRecording("ring", "deflection", *made), CHEESE).modes
        assert len(modes) == 2
        # A fifth of an octave apart with decays of half that: the sds are about 0.3 %.
        np.testing.assert_allclose([m.frequency for m in modes], [4, 5], rtol=0.015)


def test_the_free_sheet_s_fragment_brings_back_its_frequency_and_damping():
    result = ring(1, 5.0, 0.05)
    sheet = result.to_fragment().apply(preset("cheese").scenario).sheet
    # k_b is scaled by the square of the frequency, exactly; TOML is not involved.
    assert sheet.natural_frequency == pytest.approx(result.mode.omega.value, rel=1e-9)
    assert sheet.free_modes.dish.damping_ratio == pytest.approx(result.mode.damping_ratio.value, rel=1e-9)


def test_k_b_and_c_b_scatter_together_as_their_correlation_says():
    results = [ring(seed, 5, 0.05, noise=2e-4) for seed in SEEDS]
    logs = np.log([(r.stiffness.value, r.damping.value) for r in results])
    said = (
        np.median([r.stiffness.sd / r.stiffness.value for r in results]),
        np.median([r.damping.sd / r.damping.value for r in results]),
    )
    np.testing.assert_allclose(logs.std(axis=0), said, rtol=0.35)  # the sd of 40 is 11 % off, three times
    # Correlations of 40 pairs are off by 0.16 (sd).
    assert np.corrcoef(logs.T)[0, 1] == pytest.approx(np.median([r.correlation for r in results]), abs=0.45)
