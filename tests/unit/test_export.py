"""Trajectories for a machine: they agree with themselves, close, keep the limits, and read back."""

from __future__ import annotations

import math

import numpy as np
import pytest

import plategait as pg
from plategait.export.trajectory import LEAST_SAMPLES
from plategait.model.motion import AXES, read_samples

RICH = pg.PlateMotion(
    frequency=24.0, angle="3 deg", stroke="2 mm", offset={"rx": "2 deg", "z": "0.5 mm"},
    waves=(pg.Wave(axis="x", amplitude="0.4 mm", ratio=2.0, phase="50 deg"),
           pg.Wave(axis="ry", amplitude="1 deg", ratio=1.5, phase="-20 deg")),
)  # fmt: skip
ANY = pg.Machine(name="any", **{a: ({"angle": "60 deg"} if a[0] == "r" else {"stroke": "50 mm"}) for a in AXES})


def moves(made: pg.Trajectory) -> np.ndarray:
    return np.stack([made.position, made.speed, made.acceleration])


def test_a_way_from_rest_to_rest_agrees_with_itself():
    made = pg.trajectory(RICH, "20 kHz", ANY, duration=0.5)
    assert np.diff(made.time) == pytest.approx(1 / made.rate, rel=1e-9)
    p, v, a = moves(made)
    h = 1 / made.rate
    for whole, slope in ((p, v), (v, a)):
        # Trapezia err by h²/12 of the second derivative, (2π 48 Hz h)²/12 = 2e-5 of the slope.
        grown = np.cumsum(0.5 * h * (slope[:, 1:] + slope[:, :-1]), axis=1)
        assert whole[:, 1:] - whole[:, :1] == pytest.approx(grown, abs=1e-4 * np.abs(whole).max())
        central = (whole[:, 2:] - whole[:, :-2]) / (2 * h)
        assert central == pytest.approx(slope[:, 1:-1], abs=2e-4 * np.abs(slope).max())
    # At rest, where the motion holds the plate, at both ends.
    held = np.array(RICH.offset.pose)
    for end in (0, -1):
        assert p[:, end] == pytest.approx(held, abs=1e-15)
        assert np.abs([v[:, end], a[:, end]]).max() < 1e-9
    assert made.duration == pytest.approx(0.5 + RICH.ramp)
    assert made.axes == ("x", "z", "rx", "ry")


@pytest.mark.parametrize(("frequency", "rate", "duration"), [(24.0, 1000, 0.25), (17.0, 850, 2 / 17), (12.5, 640, 0.8)])
def test_a_cycle_closes_without_a_jump(frequency, rate, duration):
    made = pg.trajectory(RICH.replace(frequency=frequency), rate, ANY, cycle=True)
    # Ratios of 1, 1.5 and 2 repeat after two periods; the cycle is the first multiple of that in whole samples.
    assert made.duration == pytest.approx(duration, rel=1e-12)
    assert len(made.time) == round(rate * duration)
    twice = np.concatenate([moves(made), moves(made)], axis=2)
    inside = np.abs(np.diff(moves(made), 2, axis=2)).max(axis=2)
    across = np.abs(np.diff(twice, 2, axis=2)[:, :, len(made.time) - 2 : len(made.time)]).max(axis=2)
    # Where it begins anew each curve bends no more than it does elsewhere.
    assert (across <= 1.05 * inside + 1e-12).all()
    steady = pg.trajectory(RICH.replace(frequency=frequency), rate, ANY, duration=4.0)
    n = len(made.time)
    first = math.ceil(0.2 * rate / n) * n  # past the ramp, on a whole number of cycles
    assert moves(steady)[:, :, first : first + n] == pytest.approx(moves(made), rel=1e-7, abs=1e-7)


def test_frequencies_without_a_common_period_are_told():
    odd = RICH.replace(waves=(pg.Wave(axis="x", amplitude="0.4 mm", ratio=math.sqrt(2)),))
    with pytest.raises(pg.InputError, match=r"33\.94\d* Hz and 24 Hz, which have no common period.*17/12"):
        pg.trajectory(odd, 1000, ANY, cycle=True)
    assert pg.trajectory(odd.replace(**{"waves.0.ratio": 17 / 12}), 1000, ANY, cycle=True).duration == pytest.approx(
        0.5
    )
    assert pg.trajectory(odd, 1000, ANY, duration=1).duration == pytest.approx(1.1)


def test_a_rate_that_fits_no_periods_is_refused_with_one_that_does():
    with pytest.raises(pg.InputError, match="whole number of samples") as refused:
        pg.trajectory(RICH.replace(frequency=23.4567, waves=()), 1000, ANY, cycle=True)
    better = refused.value.hint.strip('"')
    assert pg.trajectory(RICH.replace(frequency=23.4567, waves=()), better, ANY, cycle=True).cycle


@pytest.mark.parametrize(
    ("changes", "options", "field"),
    [
        ({"samples": pg.Samples(time=(0.0, 0.1), x=(0.0, 1e-3))}, {"cycle": True}, "cycle"),
        ({"angle": 0.0, "stroke": 0.0, "waves": ()}, {"cycle": True}, "cycle"),
        ({"angle": 0.0, "stroke": 0.0, "waves": (), "offset": {}}, {}, "motion"),
        ({}, {"rate": (LEAST_SAMPLES - 1) * 48.0}, "rate"),
        ({}, {"rate": "1 MHz", "duration": "2 s"}, "duration"),
        ({"ramp": 0.0}, {}, "motion.ramp"),
    ],
)
def test_what_makes_no_trajectory_is_refused(changes, options, field):
    with pytest.raises(pg.InputError) as refused:
        pg.trajectory(RICH.replace(**changes), **{"rate": 1000, "machine": ANY} | options)
    assert refused.value.field == field


@pytest.mark.parametrize(
    "changes", [{"angle": "30 deg"}, {"frequency": "50 Hz"}, {"stroke": "5 mm", "angle": "28 deg"}]
)
def test_a_motion_beyond_the_machine_is_refused_with_one_within(changes):
    motion = pg.PlateMotion(frequency=12.0).replace(**changes)
    with pytest.raises(pg.InputError) as refused:
        pg.trajectory(motion, 1000)
    words = refused.value.hint.replace('" ', '"\n').splitlines()
    instead = {word.split()[0].strip("-"): word.partition(" ")[2].strip('"') for word in words}
    assert pg.trajectory(motion.replace(**instead), 1000, duration=1).axes == ("x", "rx")


def test_a_stop_takes_as_long_as_the_machine_asks_for():
    fast = pg.PlateMotion(frequency=24.0, angle=0.0, stroke="3 mm", ramp=0.005)
    weak = pg.Machine(name="weak", x={"acceleration": "70 m/s^2"})
    made = pg.trajectory(fast, 5000, weak, duration=0.3)
    # A sine of 3 mm at 24 Hz has 68 m/s²; over a ramp of 5 ms it would have more.
    assert np.abs(made.acceleration).max() <= 70
    assert made.duration > 0.3 + 2 * fast.ramp


def test_a_file_reads_back_as_samples(tmp_path):
    made = pg.trajectory(RICH, 1000, ANY, duration=0.3)
    pg.write_trajectory(made, tmp_path / "motion.csv")
    heading, first = (tmp_path / "motion.csv").read_text().splitlines()[:2]
    assert heading.split(",")[:4] == ["time_s", "x_mm", "x_mm_s", "x_mm_s2"]
    assert first.split(",")[heading.split(",").index("rx_deg")] == "2"
    samples = read_samples(tmp_path / "motion.csv")
    shown = samples.derivatives(made.time)
    # Twelve digits of mm and deg; the spline's speeds within (2π 48 Hz · 1 ms)³/24 of the largest, 0.1 %.
    assert shown[0] == pytest.approx(made.position, abs=1e-12)
    assert shown[1][:, 5:-5] == pytest.approx(made.speed[:, 5:-5], abs=2e-3 * np.abs(made.speed).max())
    again = pg.PlateMotion(angle=0.0, stroke=0.0, samples=str(tmp_path / "motion.csv"), ramp=0.0)
    assert again.samples == samples


@pytest.mark.parametrize("name", ["m.mcap", "m.db3"])
def test_a_bag_is_read_back_without_ros(name, tmp_path):
    highlevel = pytest.importorskip("rosbags.highlevel")
    made = pg.trajectory(RICH, 1000, ANY, duration=0.3)
    for _ in range(2):  # the second takes the place of the first
        pg.write_bag(made, tmp_path / name, joints=("slide", "lift", "rock", "pitch"), topic="/shaker/command")
    with highlevel.AnyReader([tmp_path / name]) as reader:
        (connection,) = reader.connections
        assert (connection.topic, connection.msgtype) == ("/shaker/command", "trajectory_msgs/msg/JointTrajectory")
        ((_, _, raw),) = reader.messages()
        message = reader.deserialize(raw, connection.msgtype)
    assert message.joint_names == ["slide", "lift", "rock", "pitch"]
    at = [point.time_from_start.sec + 1e-9 * point.time_from_start.nanosec for point in message.points]
    assert at == pytest.approx(made.time, abs=1e-9)
    for d, axis in enumerate(made.axes):
        told = [(p.positions[d], p.velocities[d], p.accelerations[d]) for p in message.points]
        assert np.array_equal(np.transpose(told), made.of(axis))
    assert [path.name for path in tmp_path.iterdir()] == [name]


@pytest.mark.parametrize(("joints", "topic"), [(("a",), "/x"), (("a", "a", "b", "c"), "/x"), (None, "/no topic")])
def test_names_that_ros_does_not_take_are_refused(joints, topic, tmp_path):
    pytest.importorskip("rosbags")
    made = pg.trajectory(RICH, 1000, ANY, duration=0.3)
    with pytest.raises(pg.InputError, match=r"^(joints|topic):"):
        pg.write_bag(made, tmp_path / "m.mcap", joints=joints, topic=topic)
    assert list(tmp_path.iterdir()) == []
    cycle = pg.trajectory(RICH, 1000, ANY, cycle=True)
    with pytest.raises(pg.InputError, match="plays a trajectory once"):
        pg.write_bag(cycle, tmp_path / "m.mcap")
