"""From poses to a rate, step by step: the rate of steps, whole turns, outliers, swings, and what parallax adds."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plategait.vision.object.pose import NO_POSE, Pose
from plategait.vision.pose_series import PoseSeries
from plategait.vision.spin import fitted, outliers, rate_of_steps, unwrapped

FPS = 30.0
TIME = np.arange(90) / FPS


def wrapped(angle: np.ndarray) -> np.ndarray:
    return (angle + np.pi) % (2 * np.pi) - np.pi


@pytest.mark.parametrize("rate", [-3000.0, 0.0, 56.6, 1200.0])
def test_steps_tell_the_rate_and_those_a_turn_a_frame_away(rate: float) -> None:
    steps = wrapped(np.diff(np.radians(rate) * TIME))
    best, agreement, rivals = rate_of_steps(np.diff(TIME), steps)
    assert math.degrees(best) == pytest.approx(rate, abs=1e-6)
    assert agreement == pytest.approx(1)
    assert sorted(math.degrees(r) for r in rivals) == pytest.approx([rate - 360 * FPS, rate + 360 * FPS])


def test_uneven_steps_have_no_rivals() -> None:
    time = np.cumsum(np.random.default_rng(0).uniform(0.02, 0.05, 80))
    best, _, rivals = rate_of_steps(np.diff(time), wrapped(np.diff(2.0 * time)))
    assert best == pytest.approx(2.0)
    assert rivals == ()


def test_turns_are_joined_over_short_gaps_and_parted_at_long_ones() -> None:
    rate, swing = math.radians(400), 0.1 * np.sin(2 * math.pi * 7 * TIME)
    phase = rate * TIME + swing
    short = np.ones(90, bool)
    short[30:36] = False
    line, part = unwrapped(TIME[short], wrapped(phase[short]), rate)
    assert (part == 0).all()
    np.testing.assert_allclose(line - line[0], (phase - phase[0])[short], atol=1e-9)
    # Over 2 s at a rate that may have changed by 15 % the turn is unknown by 120 deg.
    long = np.ones(90, bool)
    long[15:75] = False
    assert set(unwrapped(TIME[long], wrapped(phase[long]), rate)[1]) == {0, 1}


def test_a_line_is_fitted_beside_the_swing_and_each_part_has_its_height() -> None:
    part = (TIME > 1.5).astype(int)
    swing = 0.2 * np.sin(2 * math.pi * 7 * TIME + 1)
    smooth, slope = fitted(TIME, 3.0 * TIME + swing + 40 * part, part, (7.0,))
    # Exact data: rounding alone.
    assert slope == pytest.approx(3.0, abs=1e-9)
    np.testing.assert_allclose(smooth, 3.0 * TIME + 40 * part, atol=1e-8)


def test_outliers_are_those_put_in() -> None:
    angle = 2.0 * TIME + 0.1 * np.sin(2 * math.pi * 7 * TIME) + 0.005 * np.random.default_rng(1).normal(size=90)
    wrong = [12, 40, 77]
    angle[wrong] += 0.3
    flags = outliers(TIME, angle, np.zeros(90, int), 7.0, FPS)
    assert np.nonzero(flags)[0].tolist() == wrong


def poses(angle: np.ndarray) -> list[Pose]:
    return [Pose(0.001, 0.002, float(a), "", 0.024) for a in wrapped(angle)]


def test_a_series_is_sure_where_nothing_speaks_against_a_frame() -> None:
    series = poses(math.radians(150) * TIME)
    series[3], series[50] = NO_POSE, series[50]._replace(reason="marker partly hidden")
    repeated = np.zeros(90, bool)
    repeated[[3, 8]] = True
    track = PoseSeries.of(TIME, series, repeated)
    assert np.nonzero(~track.sure)[0].tolist() == [3, 8, 50]
    assert [track.reason[k] for k in (3, 8, 50)] == ["markers not seen", "repeated picture", "marker partly hidden"]


def test_a_series_spin_joins_its_turns_and_marks_what_is_out_of_line() -> None:
    angle = math.radians(300) * TIME
    seen_wrongly = angle.copy()
    seen_wrongly[33] += 0.5
    track = PoseSeries.of(TIME, poses(seen_wrongly), np.zeros(90, bool))
    spin = track.spin(1, FPS, None, None, notes := [])
    assert math.degrees(spin.rate) == pytest.approx(300, abs=1e-6)
    assert notes == []
    assert track.reason[33] == "out of line with the frames around it"
    np.testing.assert_allclose(track.angle[track.sure], angle[track.sure], atol=1e-9)


def test_a_series_takes_out_the_parallax_of_a_lifted_marker() -> None:
    length, f = 0.024, 7.0
    eye = np.tile([0.16, -0.03, 0.27], (90, 1))
    true = math.radians(250) * TIME
    lift = 0.004 * (1 + np.sin(2 * math.pi * f * TIME))
    flat = np.sqrt(length**2 - lift**2)
    place = flat[:, None] * np.column_stack([np.cos(true), np.sin(true)])
    # As a point at that height falls on the plate's plane, seen from the eye.
    apparent = eye[:, :2] + (place - eye[:, :2]) * (eye[:, 2] / (eye[:, 2] - lift))[:, None]
    angle, spacing = np.arctan2(apparent[:, 1], apparent[:, 0]), np.hypot(*apparent.T)
    series = [Pose(0.0, 0.0, float(a), "", float(s)) for a, s in zip(angle, spacing, strict=True)]
    raw, freed = (PoseSeries.of(TIME, series, np.zeros(90, bool)) for _ in range(2))
    raw.spin(1, FPS, f, None, [])
    freed.spin(1, FPS, f, eye, notes := [])
    errors = [np.degrees(np.std((s.angle - true)[s.sure])) for s in (raw, freed)]
    # Its harmonics are among those that the lift is made of; what is left is the ridge on them.
    assert errors[0] > 2
    assert errors[1] < 0.2 * errors[0]
    assert len(notes) == 1
    assert notes[0].startswith("angles are freed of the parallax of bending")
