"""The same bits at any thread count and any grouping; the same physics at any instruction set and precision."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plategait.engine import cpu
from plategait.engine.recording import RunRequest
from plategait.model.motion import Samples
from plategait.model.outline import Rectangle
from plategait.model.presets import preset
from plategait.simulation.observables import rotation

CHEESE = preset("cheese").scenario.replace(duration=0.4)
# Sampled trajectories of other lengths, ends and steps.
SHAKES = [
    Samples(time=tuple(end * i / 50 for i in range(51)), z=tuple(2e-4 * math.sin(i) for i in range(51)))
    for end in (0.1, 0.5, 300.0)
]


def mixed_runs() -> list[RunRequest]:
    """Runs that differ in everything, lattices, steps, torsion and sampled trajectories among it."""
    runs = []
    for i in range(37):
        scenario = CHEESE.replace(
            **{
                "motion.frequency": 10.0 + i / 2,
                "motion.angle": 0.02 + 0.003 * i,
                "friction.law": ("thesis", "adams")[i % 2],
                "sheet.torsion_stiffness": 1e-5 * (i % 3),
                "sheet.shear_ratio": (1.0, 0.5, 3.0)[i % 3],
                "duration": 0.2 + 0.01 * (i % 7),
                "time_step": 1e-4 / (1 + i % 2),
            }
        )
        if i % 4 == 0:
            scenario = scenario.replace(**{"motion.samples": SHAKES[i % 3]})
        if i % 5 == 0:
            scenario = scenario.replace(**{"sheet.outline": Rectangle(length=0.05, width=0.03), "sheet.mass": 4e-3})
        runs.append(RunRequest(scenario, offset=(1e-4 * i, 0.0, 0.01 * i)))
    return runs


def assert_same(one, two) -> None:
    for a, b in zip(one, two, strict=True):
        assert a.steps == b.steps
        np.testing.assert_array_equal(a.positions, b.positions)
        np.testing.assert_array_equal(a.velocities, b.velocities)
        for name in a.channels:
            np.testing.assert_array_equal(a[name], b[name], err_msg=name)


@pytest.mark.parametrize("precision", ["float32", "float64"])
def test_threads_and_grouping_do_not_change_a_bit(precision):
    runs = mixed_runs()
    together = cpu.run(runs, precision, threads=1)
    assert_same(together, cpu.run(runs, precision, threads=4))
    alone = [cpu.run([run], precision)[0] for run in runs[::6]]
    assert_same(together[::6], alone)
    shuffled = np.random.default_rng(3).permutation(len(runs))
    mixed = cpu.run([runs[i] for i in shuffled], precision, threads=2)
    assert_same([together[i] for i in shuffled], mixed)


def test_a_diverging_neighbour_changes_nothing():
    runs = mixed_runs()[:8]
    hot = runs[3].start()
    wild = RunRequest(
        runs[3].scenario, initial=(hot[0], hot[1] + np.random.default_rng(0).normal(0, 1e5, hot[1].shape))
    )
    spoiled = cpu.run([*runs[:3], wild, *runs[4:]])
    assert spoiled[3].diverged
    assert_same(cpu.run([*runs[:3], *runs[4:]]), [*spoiled[:3], *spoiled[4:]])


@pytest.mark.parametrize("precision", ["float32", "float64"])
def test_instruction_sets_agree(precision):
    # Before chaos sets in: round-off grows by the stretch of a few plate periods.
    runs = [RunRequest(CHEESE.replace(**{"motion.frequency": f})) for f in (12.0, 18.0, 24.0)]
    reference = cpu.run(runs, precision, instruction_set="baseline")
    tolerance = 2e-3 if precision == "float32" else 1e-9
    for level in cpu.instruction_sets():
        for a, b in zip(reference, cpu.run(runs, precision, instruction_set=level), strict=True):
            angles = [rotation(r["spin_cross"], r["spin_dot"])[-1] for r in (a, b)]
            assert angles[1] == pytest.approx(angles[0], abs=tolerance)


def test_single_and_double_precision_agree():
    # The rotation after 0.4 s of 18 Hz, some 60 deg: single precision is within a tenth of a degree.
    run = [RunRequest(CHEESE.replace(**{"motion.frequency": 18.0}))]
    single, double = (cpu.run(run, precision)[0] for precision in ("float32", "float64"))
    angles = [rotation(r["spin_cross"], r["spin_dot"])[-1] for r in (single, double)]
    assert abs(angles[1]) > math.radians(10)
    assert angles[0] == pytest.approx(angles[1], abs=math.radians(0.1))
