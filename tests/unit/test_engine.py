"""What the engine takes of memory, threads and time; sampled trajectories as tables."""

from __future__ import annotations

import math
import os
import subprocess
import sys
import time

import numpy as np
import pytest

from plategait.engine import cpu, memory
from plategait.engine.recording import RunRequest
from plategait.engine.trajectories import followed, table_bytes, tables
from plategait.errors import InputError
from plategait.model.motion import PlateMotion, Samples
from plategait.model.outline import Disk
from plategait.model.presets import preset
from plategait.model.scenario import Scenario
from plategait.model.sheet import Sheet
from plategait.simulation.run import simulate, simulate_all

CHEESE = preset("cheese").scenario
ONE_NODE = Scenario(
    sheet=Sheet(outline=Disk(radius=0.004), mass=1e-3, bending_stiffness=1e-4, axial_stiffness=790.0),
    motion=PlateMotion(angle=0, stroke=0), duration=0.1,
)  # fmt: skip
# A sanitizer reserves terabytes of addresses: no limit can be put on them.
limited = pytest.mark.skipif(
    sys.platform != "linux" or "asan" in os.environ.get("LD_PRELOAD", ""), reason="needs a limit on addresses"
)


def along(samples: Samples, **changes) -> Scenario:
    return ONE_NODE.replace(**{"motion.samples": samples, "motion.ramp": 0.0, **changes})


def wave(rate: float, end: float) -> Samples:
    """A sine of 3 mm at 10 Hz along the bar, `rate` samples a second."""
    times = np.arange(round(end * rate) + 1) / rate
    return Samples(time=tuple(times), x=tuple(3e-3 * np.sin(20 * math.pi * times)))


# Trajectories


def test_a_trajectory_is_tabulated_to_the_end_of_the_run_only():
    scenario = along(wave(1000, 300.0))
    knots, first, count = tables([followed(RunRequest(scenario))])
    assert first.tolist() == [0]
    # 0.1 s at half a sample's step of 1 ms, and the knot past the end.
    assert 201 <= len(knots) == count[0] <= 203
    assert table_bytes([RunRequest(scenario)]) < 100_000


def test_a_last_sample_far_away_is_no_burden():
    far = Samples(time=(0.0, 1e-3, 2e-3, 36000.0), x=(0.0, 1e-4, 2e-4, 0.0))
    recording = cpu.run([RunRequest(along(far))])[0]
    assert not recording.diverged
    assert len(tables([followed(RunRequest(along(far)))])[0]) < 210


def test_runs_on_equal_trajectories_share_one_table():
    runs = [RunRequest(along(wave(1000, 1.0), duration=0.1 + 0.01 * (i % 3))) for i in range(12)]
    knots, first, count = tables([followed(run) for run in runs])
    assert set(first.tolist()) == {0}
    assert set(count.tolist()) == {len(knots)}
    assert 241 <= len(knots) <= 243, "to the end of the longest run"


def test_runs_without_a_trajectory_stand_among_those_with_one():
    runs = [
        RunRequest(ONE_NODE),
        RunRequest(along(wave(1000, 1.0))),
        RunRequest(along(wave(500, 1.0))),
        RunRequest(ONE_NODE),
    ]
    knots, first, count = tables([followed(run) for run in runs])
    assert len(set(first.tolist())) == 3
    assert (first + count).max() == len(knots)
    together = cpu.run(runs)
    for run, recording in zip(runs, together, strict=True):
        np.testing.assert_array_equal(cpu.run([run])[0].positions, recording.positions)
    assert not together[0]["plate_x"].any()
    assert together[1]["plate_x"].any()


@pytest.mark.parametrize("precision", ["float32", "float64"])
def test_the_plate_is_where_the_samples_say_however_late(precision):
    recording = cpu.run([RunRequest(along(wave(1000, 20.0), duration=20.0))], precision)[0]
    t = recording["time"]
    late = t > 19
    # A spline of 100 points a period is off by 1e-9 m; a step rounded to single precision in the core, but not in the
    # table, would be off by 5e-8 of the time: 2e-7 m here.
    np.testing.assert_allclose(recording["plate_x"][late], 3e-3 * np.sin(20 * math.pi * t[late]), atol=2e-8)


def test_past_the_last_sample_the_plate_stays():
    ends = Samples(time=(0.0, 0.01, 0.02, 0.03), z=(0.0, 1e-3, 2e-3, 5e-3))
    recording = cpu.run([RunRequest(along(ends)), RunRequest(along(wave(1000, 1.0)))])[0]
    after = recording["time"] > 0.04
    np.testing.assert_allclose(recording["plate_z"][after], 5e-3, rtol=1e-6)


# Memory


def test_what_needs_more_memory_than_there_is_is_refused_in_one_line(monkeypatch):
    monkeypatch.setattr(memory, "available_memory", lambda: 8e9)
    fast = CHEESE.replace(**{"motion.frequency": "1e9 Hz", "duration": 0.05})
    for scenario, options, field in (
        (fast, {}, "duration"),
        (CHEESE.replace(duration=1e5), {"snapshot_interval": 2e-3}, "duration"),
        (CHEESE, {"repeats": 20_000}, "runs"),
        (CHEESE.replace(duration=1e5), {"repeats": 3}, "duration"),
    ):
        with pytest.raises(InputError) as caught:
            simulate(scenario, **options)
        assert caught.value.field == field
        assert "8 GB of memory" in str(caught.value)
        assert "\n" not in str(caught.value)


def test_what_the_refusal_proposes_fits(monkeypatch):
    monkeypatch.setattr(memory, "available_memory", lambda: 2e6)
    with pytest.raises(InputError) as caught:
        simulate(ONE_NODE.replace(duration=60.0))
    simulate(ONE_NODE.replace(duration=caught.value.hint.strip('"')))
    with pytest.raises(InputError) as caught:
        simulate(ONE_NODE.replace(duration=1.0), repeats=200)
    simulate(ONE_NODE.replace(duration=1.0), repeats=int(caught.value.hint.split()[0]))


def test_a_sheet_of_too_many_nodes_is_told_so(monkeypatch):
    monkeypatch.setattr(memory, "available_memory", lambda: 1e5)
    with pytest.raises(InputError, match=r"sheet\.pitch: got '2\d+ nodes'"):
        simulate(CHEESE.replace(**{"sheet.pitch": 0.0015, "duration": 0.01}))


def test_the_recordings_of_all_runs_count(monkeypatch):
    one = [ONE_NODE.replace(duration=1.0)]
    monkeypatch.setattr(memory, "available_memory", lambda: 1e6)
    simulate_all(one)
    with pytest.raises(InputError, match="runs"):
        simulate_all(one * 20)


LIMITED = """
import resource, sys
import numpy as np
from plategait.engine import cpu, memory
from plategait.engine.recording import RunRequest
from plategait.model.presets import preset

def leave(room):
    taken = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (taken + room, resource.RLIM_INFINITY))

runs = [RunRequest(preset("cheese").scenario.replace(duration=0.02)) for _ in range(64)]
alone = cpu.run(runs, threads=1, instruction_set="baseline")
"""

FEW_THREADS = """
leave(28 << 20)
assert 0 < memory.available_memory() <= 28 << 20
try:
    many = cpu.run(runs, threads=16, instruction_set="baseline")
except MemoryError:
    sys.exit(3)
for a, b in zip(alone, many):
    np.testing.assert_array_equal(a.positions, b.positions)
"""

NO_THREAD = """
import plategait._native as native
n = 1_000_000
given = dict(
    line_start=np.zeros(1, dtype=np.int32), line_nodes=np.zeros(0, dtype=np.int32), n_axial_lines=0,
    cells=np.zeros(0, dtype=np.int32), rest=np.zeros((n, 2)), mobility=np.ones(n), features=[False] * 4,
    parameters=np.ones((len(native.PARAMETERS), 1)), layer_terms=np.zeros(2, dtype=np.int32),
    term_dof=np.zeros(0, dtype=np.int32), terms=np.zeros(0), layers=np.zeros((1, len(native.LAYER), 1)),
    knots=np.zeros(0), first_knot=np.zeros(0, dtype=np.int64), n_knots=np.zeros(0, dtype=np.int64),
    steps=np.ones(1, dtype=np.int64), stride=np.ones(1, dtype=np.int64), thinning=np.zeros(1, dtype=np.int64),
    x=np.zeros((n, 3)), v=np.zeros((n, 3)), edge=np.zeros(0), tally=np.zeros((1, native.N_TALLIES)),
    clock=np.zeros((1, native.N_CLOCKS), dtype=np.int64), samples=np.zeros((2, len(native.CHANNELS))),
    snapshots=np.zeros(0, dtype=np.float32), last=np.zeros((1, len(native.CHANNELS))), level="baseline", threads=1,
    progress=None,
)
native.advance_float64(**given)
leave(ROOM)  # the nodes of one block take 144 MB, the stack of a thread 8 MB
try:
    native.advance_float64(**given)
except MemoryError:
    print("refused")
"""


def limited_run(script: str) -> subprocess.CompletedProcess[str]:
    done = subprocess.run([sys.executable, "-c", LIMITED + script], capture_output=True, text=True, timeout=60)
    assert done.stderr == ""
    return done


@limited
def test_threads_that_can_be_started_do_the_work_of_all():
    assert limited_run(FEW_THREADS).returncode == 0


@limited
@pytest.mark.parametrize("room", [1 << 20, 100 << 20], ids=["thread", "block"])
def test_no_memory_for_a_thread_or_a_block_is_a_memory_error(room):
    done = limited_run(NO_THREAD.replace("ROOM", str(room)))
    assert (done.returncode, done.stdout) == (0, "refused\n")


@pytest.mark.filterwarnings("error")
def test_an_energy_past_the_precision_is_a_status_not_a_number():
    # A gravity of 1e30 m/s² presses the sheet in by kilometres, where (3.1) would store more than the 3e38 J that
    # single precision holds.
    result = simulate(CHEESE.replace(gravity=1e30, duration=0.02))
    finite = all(np.isfinite(values).all() for values in result.recordings[0].channels.values())
    assert finite == (result.failure is None)
    assert not finite


@pytest.mark.parametrize("threads", [0, -1, True, 1.5, 10**9])
def test_threads_out_of_range_are_refused(threads):
    with pytest.raises(InputError, match="threads"):
        simulate(ONE_NODE, threads=threads)


# Time


class EnoughError(Exception):
    pass


@pytest.mark.parametrize("changes", [{"duration": 0.1}, {"sheet.pitch": 0.0004, "duration": 0.001}])
def test_an_interruption_is_seen_at_any_step(changes):
    # Between two samples lie 2 million steps; a step of 31,000 nodes alone takes a millisecond.
    scenario = CHEESE.replace(**{"time_step": 1e-9, **changes})
    begun: list[float] = []

    def progress(fraction: float) -> None:
        begun.append(time.monotonic())
        if begun[-1] - begun[0] > 0.3:
            raise EnoughError

    with pytest.raises(EnoughError):
        simulate(scenario, progress=progress)
    assert time.monotonic() - begun[0] < 0.3 + 1


@pytest.mark.parametrize(
    ("changes", "field"),
    [
        ({"motion.frequency": "1e16 Hz"}, "motion.frequency"),
        ({"motion.frequency": "1e9 Hz"}, "motion.frequency"),
        ({"motion.frequency": "1e16 Hz", "motion.angle": 0, "motion.stroke": 0}, "motion.frequency"),
        ({"duration": "1e12 s"}, "duration"),
        ({"time_step": 1e-15}, "time_step"),
    ],
)
def test_more_steps_than_can_be_taken_are_refused_where_they_come_from(changes, field):
    with pytest.raises(InputError) as caught:
        CHEESE.replace(**changes)
    assert caught.value.field == field
    CHEESE.replace(**{field: caught.value.hint.split(",")[0].strip('"')})


def test_a_run_shorter_than_the_stride_is_sampled_at_its_end():
    scenario = ONE_NODE.replace(duration=1e-20, time_step=1e-23)
    recording = cpu.run([RunRequest(scenario)])[0]
    assert recording["time"].tolist() == [0.0, pytest.approx(1e-20)]
    assert RunRequest(scenario, snapshot_interval=1e30).pictures == 1
