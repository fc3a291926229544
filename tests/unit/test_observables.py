"""What a motion shows, on motions made by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plategait.simulation.observables import (
    FAILURES,
    GAITS,
    first_failure,
    gait,
    period_maxima,
    period_means,
    rotation,
    slip,
    spin_rate,
)

PERIOD = 1 / 24
DEG = math.pi / 180


def sample_times(periods: float, per_period: float = 24) -> np.ndarray:
    return np.arange(round(periods * per_period) + 1) * (PERIOD / per_period)


# Spin rate


@given(rate=st.floats(-10, 10), periods=st.integers(2, 100), start=st.floats(0, 0.5), lead=st.floats(-7, 7))
def test_a_steady_turn_has_its_rate(rate, periods, start, lead):
    time = sample_times(periods + 0.5 * 24)
    found = spin_rate(time, lead + rate * time, PERIOD, 0.5, 0.5 + periods * PERIOD)
    # A straight line: only the round-off of least squares, of angles up to 50 rad.
    assert found.rate == pytest.approx(rate, abs=1e-9)
    assert found.low - 1e-9 <= found.rate <= found.high + 1e-9
    assert found.high - found.low < 1e-8
    assert found.settled


@pytest.mark.parametrize("periods", [2, 3, 7, 8, 9, 20, 67, 100])
@pytest.mark.parametrize("per_period", [24, 24.7])
def test_the_swing_within_a_period_leaves_no_trace(periods, per_period):
    # A swing of 5 deg at the plate's frequency and of 1 deg at twice it at any phase: over whole periods it is no spin.
    rate, end = 30 * DEG, (periods + 0.3) * PERIOD
    time = sample_times(periods + 2, per_period)
    for phase in np.linspace(0, 2 * np.pi, 8, endpoint=False):
        swing = 5 * np.sin(2 * np.pi * time / PERIOD + phase) + np.sin(4 * np.pi * time / PERIOD + 2 * phase)
        found = spin_rate(time, rate * time + swing * DEG, PERIOD, 0.3 * PERIOD, end)
        # Straight lines between 24 samples a period miss up to (2π/24)²/8 of the swing, 0.05 deg: over the window's
        # length that is a rate of twice it.
        assert found.rate == pytest.approx(rate, abs=2 * 0.05 * DEG / (periods * PERIOD) + 1e-3 * rate)
        assert found.settled


def test_the_window_is_cut_to_whole_periods_at_its_start():
    # Before the last two whole periods it turns the other way: that must not count.
    time = sample_times(4)
    turn = np.where(time < 2 * PERIOD, -5 * (time - 2 * PERIOD), 3 * (time - 2 * PERIOD))
    assert spin_rate(time, turn, PERIOD, 1.2 * PERIOD, 4 * PERIOD).rate == pytest.approx(3, abs=1e-9)


def test_the_interval_covers_what_it_says():
    # A rate that wanders as a random walk of the angle: blocks are independent, as the interval takes them to be.
    rng = np.random.default_rng(11)
    time, rate, runs = sample_times(64), 30 * DEG, 1500
    covered = 0
    for _ in range(runs):
        walk = np.cumsum(rng.normal(0, 0.02, len(time)))
        found = spin_rate(time, rate * time + walk, PERIOD, 0, time[-1])
        covered += found.low <= rate <= found.high
    # Three standard deviations of a binomial count of 1500 at 95 %: 1.7 %.
    assert covered / runs == pytest.approx(0.95, abs=3 * math.sqrt(0.95 * 0.05 / runs))


def test_the_interval_is_not_too_narrow_for_a_noisy_tracker():
    # White noise on every angle. Neighbouring blocks share their edge, so the interval is wider than need be.
    rng = np.random.default_rng(12)
    time, rate, runs = sample_times(40), 30 * DEG, 400
    covered = 0
    for _ in range(runs):
        found = spin_rate(time, rate * time + rng.normal(0, 0.01, len(time)), PERIOD, 0, time[-1])
        covered += found.low <= rate <= found.high
    assert covered / runs >= 0.95 - 3 * math.sqrt(0.95 * 0.05 / runs)


def test_a_rate_that_grows_has_not_settled():
    time = sample_times(48)
    assert not spin_rate(time, 0.5 * time**2, PERIOD, 0, 2).settled
    assert spin_rate(time, 0.5 * time**2, PERIOD, 0, 2).rate == pytest.approx(1, rel=1e-9)
    # Halves that differ by under 5 % have: 2 + 0.05 t turns 2.025 and 2.075 rad/s.
    assert spin_rate(time, 2 * time + 0.025 * time**2, PERIOD, 0, 2).settled


def test_a_slow_creep_counts_as_settled_below_two_degrees_a_second():
    time = sample_times(48)
    for difference, settled in ((1.5 * DEG, True), (3 * DEG, False)):  # limit: 2 deg/s between the halves
        assert spin_rate(time, difference / 2 * time**2, PERIOD, 0, 2).settled is settled


@pytest.mark.parametrize(("start", "end"), [(0, 1.9 * PERIOD), (0, 0), (1, 0.5), (0, PERIOD)])
def test_too_short_a_window_gives_no_rate(start, end):
    time = sample_times(10)
    found = spin_rate(time, time, PERIOD, start, end)
    assert math.isnan(found.rate)
    assert math.isnan(found.low)
    assert math.isnan(found.high)
    assert not found.settled


def test_two_periods_are_enough():
    time = sample_times(2)
    assert spin_rate(time, 3 * time, PERIOD, 0, time[-1]).rate == pytest.approx(3, rel=1e-12)


def test_what_comes_after_the_window_may_be_missing():
    time = sample_times(20)
    angle = np.where(time > 10.01 * PERIOD, np.nan, 3 * time)
    assert spin_rate(time, angle, PERIOD, 0, 10 * PERIOD).rate == pytest.approx(3, rel=1e-9)


# Rotation


@pytest.mark.parametrize("turns", [-3.4, -1.2, 0.3, 1.0, 5.7])
def test_the_rotation_goes_on_past_a_full_turn(turns):
    angle = 2 * np.pi * turns * np.linspace(0, 1, 200)
    size = 1e-3 * (1 + 0.5 * np.linspace(0, 1, 200))  # a sheet that bends has a shorter shadow: no matter
    np.testing.assert_allclose(rotation(size * np.sin(angle), size * np.cos(angle)), angle, atol=1e-12)


# Means and gait


def test_each_sample_counts_for_the_period_it_ends():
    time = sample_times(6)
    values = np.ceil(time / PERIOD - 1e-9)  # 1 in the first period, 2 in the second, …
    np.testing.assert_array_equal(period_means(time, values, PERIOD, 0, 6 * PERIOD), [1, 2, 3, 4, 5, 6])
    np.testing.assert_array_equal(period_means(time, values, PERIOD, 2 * PERIOD, 5 * PERIOD), [3, 4, 5])
    stacked = period_means(time, np.stack([values, 2 * values], axis=1), PERIOD, 4 * PERIOD, 6 * PERIOD)
    np.testing.assert_array_equal(stacked, [[5, 10], [6, 12]])
    assert len(period_means(time, values, PERIOD, 0, 0)) == 0
    assert len(period_maxima(time, values, PERIOD, 0, 0)) == 0
    np.testing.assert_array_equal(period_maxima(time, values + np.sin(time), PERIOD, 2 * PERIOD, 5 * PERIOD),
                                  [(values + np.sin(time))[values == k].max() for k in (3, 4, 5)])  # fmt: skip


def test_means_hold_over_a_long_run():
    # Times of 24 · 10,000 periods are rounded; no sample may slip into the next period.
    time = sample_times(10_000)
    phase = np.arange(len(time)) % 24 == 0
    np.testing.assert_allclose(period_means(time, phase.astype(float), PERIOD, 0, time[-1]), 1 / 24, rtol=1e-12)


@pytest.mark.parametrize(
    ("left", "right", "flight", "expected"),
    [
        ([1, 1, 1], [1, 1, 1], [0, 0, 0], "sliding"),
        ([0.7, 0.7, 0.7], [0.8, 0.8, 0.8], [0, 0, 0], "walking"),
        ([1, 1, 1], [0.5, 0.5, 0.5], [0, 0, 0], "walking"),
        ([0.3, 0.3, 0.3], [0.3, 0.3, 0.3], [0.4, 0.4, 0.4], "running"),
        ([0.9, 0.9, 0.9], [0.9, 0.9, 0.9], [0.05, 0.05, 0.05], "running"),
        ([0, 0], [0, 0], [1, 1], "running"),
        ([1, 1, 0.5], [1, 1, 0.5], [0, 0, 0], "sliding"),
        ([1, 0.5, 0.5], [1, 0.5, 0.5], [0, 0, 0], "walking"),
        ([0.5, 0.5, 0.5], [0.5, 0.5, 0.5], [0, 0.2, 0.2], "running"),
        ([0.995, 0.995], [1, 1], [0.005, 0.005], "sliding"),  # a rattle under 1 % is no stride
        ([0.98, 0.98], [1, 1], [0.0, 0.0], "walking"),
        ([], [], [], ""),
    ],
)
def test_the_gait_is_that_of_most_periods(left, right, flight, expected):
    assert gait(np.array(left), np.array(right), np.array(flight)) == expected
    assert gait(np.array(right), np.array(left), np.array(flight)) == expected, "left and right are alike"
    assert expected in ("", *GAITS)


# Slip and failures


def drifting(periods: float = 96, *, speed: float = 0.0, swing: float = 0.0, since: float = 0.0) -> dict:
    time = sample_times(periods)
    along = np.maximum(time - since, 0) * speed
    return {
        "time": time,
        "centre_x": 0.02 + 0.6 * along + swing * np.sin(2 * np.pi * time / PERIOD),
        "centre_y": -0.01 + 0.8 * along,
    }


def test_slip_takes_out_the_swing_within_a_period():
    channels = drifting(swing=0.012)
    found = slip(channels["time"], channels["centre_x"], channels["centre_y"], PERIOD)
    # An average over 25 samples of 24 leaves a 25th of the swing. Near an end there is no whole period
    # around to average over: at worst (1 − cos a)/a = 0.725 of it is left.
    assert found[12:-12].max() < 0.012 / 24
    assert found.max() < 0.73 * 0.012
    assert first_failure(channels, PERIOD, 0.01) is None


def test_a_slip_on_a_slow_plate_is_not_seen_before_it_happens():
    # A slide of 1 m/s on a plate whose period is as long as the recording: 10 mm after 0.01 s, not at the start.
    time = np.arange(601) / 600
    channels = {"time": time, "centre_x": time, "centre_y": 0 * time}
    failure = first_failure(channels, 1.0, 0.01)
    assert failure is not None
    assert failure.time == pytest.approx(0.01, abs=2 / 600)  # two samples


def test_a_drift_of_10_mm_is_caught_when_it_happens():
    channels = drifting(speed=0.01, swing=0.003, since=1.0)
    failure = first_failure(channels, PERIOD, 0.01)
    assert failure is not None
    assert failure.kind == "slipped"
    # 10 mm at 10 mm/s from 1 s on; what the average leaves of the swing is 0.003/25 m, 0.012 s of drift, and a sample.
    assert failure.time == pytest.approx(2.0, abs=0.02)
    assert first_failure(channels, PERIOD, 0.05) is None


def test_the_slip_counts_from_where_the_object_lay():
    channels = drifting()
    assert slip(channels["time"], channels["centre_x"], channels["centre_y"], PERIOD).max() == pytest.approx(
        0, abs=1e-12
    )


def test_slip_of_a_recording_shorter_than_a_period():
    time = sample_times(0.5)
    assert slip(time, 3 * time, 4 * time, PERIOD) == pytest.approx(5 * time)
    assert slip(time[:1], time[:1], time[:1], PERIOD) == pytest.approx([0])


def with_area(channels: dict, area) -> dict:
    area = np.broadcast_to(np.array(area, dtype=float), (len(channels["time"]), 3))
    return channels | {f"area_{axis}": area[:, i] for i, axis in enumerate("xyz")}


def area_after(channels: dict, when: float, area) -> dict:
    late = (channels["time"] >= when)[:, None]
    return with_area(channels, np.where(late, np.array(area, dtype=float), [0.0, 0.0, 0.95]))


@pytest.mark.parametrize(
    ("area", "kind"),
    [((0.0, 0.0, -0.9), "turned over"), ((0.8, 0, -0.1), "turned over"), ((0, 0.1, 0.2), "folded"),
     ((0, 0, -0.2), "folded"), ((0.9, 0, 0.1), None), ((0, 0, 0.6), None)],
)  # fmt: skip
def test_a_sheet_that_folds_or_turns_over_is_seen(area, kind):
    failure = first_failure(area_after(drifting(), 1.5, area), PERIOD, 0.01)
    if kind is None:
        assert failure is None
    else:
        assert failure is not None
        assert failure.kind == kind
        assert failure.time == pytest.approx(1.5, abs=PERIOD / 24)  # the next sample


def test_a_sheet_that_leaves_the_plate_is_seen():
    channels = drifting(speed=0.01)  # from (20, −10) mm, 6 mm/s along and 8 mm/s across
    assert first_failure(channels, PERIOD, 1.0) is None, "a plate that never ends"
    for size, when in (((0.05, 1.0), 5 / 6), ((1.0, 0.024), 22 / 8), ((1.0, 1.0), None), ((0.02, 0.1), 0.0)):
        failure = first_failure(channels, PERIOD, 1.0, size)
        if when is None:
            assert failure is None
        else:
            assert failure is not None
            assert failure.kind == "left the plate"
            assert failure.time == pytest.approx(when, abs=PERIOD / 24 + 1e-9)


def test_a_motion_that_ceases_to_be_finite_is_seen():
    channels = drifting()
    channels["centre_x"][100:] = np.nan
    failure = first_failure(channels, PERIOD, 0.01)
    assert failure is not None
    assert (failure.kind, failure.time) == ("diverged", channels["time"][99])
    whole = first_failure(drifting(), PERIOD, 0.01, diverged=True)
    assert whole is not None
    assert (whole.kind, whole.time) == ("diverged", channels["time"][-1])


def test_an_energy_that_ceases_to_be_finite_tells_the_time():
    channels = drifting()
    channels["kinetic_energy"] = np.where(channels["time"] < 1.5, 1.0, np.inf)
    failure = first_failure(channels, PERIOD, 0.01, diverged=True)
    assert failure is not None
    assert failure.kind == "diverged"
    assert failure.time == pytest.approx(1.5, abs=PERIOD / 24 + 1e-9)


def test_a_motion_that_was_never_finite_is_seen():
    channels = drifting()
    channels["centre_y"][:] = np.inf
    failure = first_failure(with_area(channels, (0, 0, np.nan)), PERIOD, 0.01, (0.1, 0.1), True)
    assert failure is not None
    assert (failure.kind, failure.time) == ("diverged", 0.0)


def test_the_first_of_several_failures_counts():
    channels = area_after(drifting(speed=0.01), 0.5, (0, 0, -1))
    failure = first_failure(channels, PERIOD, 0.01, (0.05, 1.0), True)
    assert failure is not None
    assert failure.kind == "turned over"
    assert failure.kind in FAILURES


def test_tracked_motion_without_area_can_only_slip():
    assert first_failure(drifting(), PERIOD, 0.01) is None


def test_a_calm_run_has_not_failed():
    assert first_failure(with_area(drifting(swing=0.003), (0.1, 0, 0.9)), PERIOD, 0.01, (0.1, 0.1)) is None
