"""Spin rates at the default step against a step ten times smaller, in double precision."""

from __future__ import annotations

import math

import numpy as np
import pytest
from published import scenario

from plategait.model.presets import preset
from plategait.simulation.run import simulate_all

# The rate is measured over 1.2 s here, to keep the test short.
SHORT = {"duration": 2.0, "transient": 0.8}
CASES = [
    (3, 3.5, [12, 16, 18, 19, 22]),
    (3, 10.0, [12, 14, 16, 18, 20, 22, 24]),
    (3, 23.0, [14, 18, 20, 22, 24]),
    (12, 3.5, [8, 9, 10, 11]),
    (12, 10.0, [8, 9, 10, 11, 12]),
]
PRINTED = {"sheet.bending_damping": preset("cheese-as-printed").scenario.sheet.bending_damping, "motion.height": 0.0}


@pytest.mark.parametrize("changes", [{}, {"friction.law": "adams"}, PRINTED], ids=["cheese", "adams", "as printed"])
def test_the_default_step_is_within_one_per_cent_rms_and_three_at_worst(changes):
    scenarios = []
    for angle, omega, frequencies in CASES if changes is not PRINTED else CASES[:3]:
        base = scenario(angle, omega).replace(**SHORT, **changes)
        assert base.dt == 1e-4
        scenarios += [base.replace(**{"motion.frequency": float(f)}) for f in frequencies]
    coarse = simulate_all(scenarios)
    fine = simulate_all([s.replace(time_step=s.dt / 10) for s in scenarios], engine="cpu64")
    sound = [(a.spin_rate, b.spin_rate) for a, b in zip(coarse, fine, strict=True) if not (a.failed or b.failed)]
    assert len(sound) > 0.7 * len(scenarios), "hardly any of these fails"
    a, b = np.array(sound).T
    # Below 20 deg/s, where nothing spins yet, 0.6 deg/s is 3 %.
    off = (a - b) / np.maximum(np.abs(b), math.radians(20))
    assert np.sqrt(np.mean(off**2)) < 0.01
    assert np.abs(off).max() < 0.03
