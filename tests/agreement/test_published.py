"""The published spin curves: where they peak, how the gait changes along them, soft against rigid."""

from __future__ import annotations

import math

import numpy as np
import pytest
from published import F0, frequencies, scenario

from plategait.curve.protocol import measured_as
from plategait.curve.spin_curve import spin_curve
from plategait.model.presets import preset
from plategait.simulation.observables import GAITS
from plategait.simulation.run import simulate, simulate_all

ORDER = {gait: i for i, gait in enumerate((*GAITS, "failed"))}


@pytest.fixture(scope="module")
def curves():
    return {case: spin_curve(measured_as(scenario(*case)), frequencies(case[0]), repeats=4, seed=1) for case in F0}


@pytest.mark.parametrize("case", F0, ids=lambda c: f"{c[0]}deg-{c[1]:g}pi")
def test_peaks_lie_where_they_were_published(curves, case):
    # Nothing is tuned per case; the largest deviation measured is 4.3 %, 4.6 % at half the step.
    assert curves[case].peak_frequency == pytest.approx(F0[case], rel=0.05)


@pytest.mark.parametrize("case", F0, ids=lambda c: f"{c[0]}deg-{c[1]:g}pi")
def test_fits_lie_below_the_published_fits(curves, case):
    # Like with like: the published f0 are Lorentz fits. Ours are 0.5 to 5.9 % low, at 33π 8.8 % where 30 Hz runs off.
    fit = curves[case].fit
    assert fit is not None
    assert -0.1 < fit.f0_hz / F0[case] - 1 < 0.01


def test_stiffer_sheets_peak_at_higher_frequencies(curves):
    for angle in (3, 12):
        cases = sorted(c for c in F0 if c[0] == angle)
        peaks = [curves[c].peak_frequency for c in cases]
        # 1.4π and 3.5π at 12 deg were published 0.2 Hz apart, half a frequency step.
        assert peaks[-1] > peaks[0] + 0.5
        assert np.all(np.diff(peaks) > -0.3)


@pytest.mark.parametrize("omega", [6.5, 10.0, 15.0])
def test_gaits_follow_in_order_as_the_frequency_rises(omega):
    # Sliding → walking → running → failed, by the source's own limit of 10 mm: all four appear, in that order.
    simulations = simulate_all(
        [scenario(12, omega).replace(**{"motion.frequency": f}) for f in np.arange(6, 17, 0.5)], repeats=4, seed=1
    )
    steps = [ORDER["failed" if s.failed else s.gait] for s in simulations]
    # A lone failure by wandering before the run-off is allowed for (10π at 11.5 Hz); a gait out of order is not.
    run_off = next(i for i in range(len(steps)) if steps[i : i + 2] == [3, 3])
    gaits = [step for step in steps[:run_off] if step < 3]
    assert set(gaits) == {0, 1, 2}
    assert gaits == sorted(gaits)


def test_the_softest_sheets_run_off_before_they_run():
    # The source's run first: what the damping that its widths ask for does not give (docs/studies.md).
    each = [scenario(12, 3.5).replace(**{"motion.frequency": f}) for f in np.arange(6, 17, 0.5)]
    steps = [ORDER["failed" if s.failed else s.gait] for s in simulate_all(each, repeats=4, seed=1)]
    assert steps == sorted(steps)
    assert set(steps) == {0, 1, 3}


def test_at_a_small_amplitude_a_soft_disk_slides_then_walks_then_fails():
    simulations = simulate_all(
        [scenario(3, 10.0).replace(**{"motion.frequency": f}) for f in np.arange(12, 32, 1.0)], repeats=4, seed=1
    )
    steps = [ORDER["failed" if s.failed else s.gait] for s in simulations]
    assert {0, 1, 3} <= set(steps)
    assert steps[: steps.index(3)] == sorted(steps[: steps.index(3)])


def test_a_soft_disk_spins_several_times_as_fast_as_its_rigid_twin():
    # Section 2.4: 56.6 against 15.7 deg/s at the same plate motion. Here, the best of each before it fails.
    best = {}
    for omega in (10.0, 320.0):
        curve = spin_curve(scenario(3, omega), np.arange(12, 28, 1.0), repeats=4, seed=1)
        best[omega] = curve.spin_rate_deg_s[curve.fitted].max()
    assert best[10.0] > 3 * best[320.0] > 0


def test_the_spin_rate_at_12_deg_and_12_hz_is_near_the_published_one():
    # Fig. 4.3: 350 deg/s in the source's simulation. Ours are 10 to 20 % lower throughout (docs/fidelity.md).
    result = simulate(preset("cheese").scenario.replace(**{"motion.frequency": 12.0, "motion.angle": math.radians(12)}))
    assert math.degrees(result.spin_rate) == pytest.approx(350, rel=0.20)
