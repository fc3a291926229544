"""Spin rates at the default step against a step ten times smaller, in double precision."""

from __future__ import annotations

import math

import pytest
from published import scenario

from plategait.simulation import simulate_all

# The rate is measured over 1.2 s here, to keep the test short.
SHORT = {"duration": 2.0, "transient": 0.8}
# Left out is 3.5π at 3 deg and 19 Hz, 3 % off (docs/numerics.md).
CASES = [
    (3, 3.5, [12, 16, 18, 22]),
    (3, 10.0, [12, 14, 16, 18, 20, 22, 24]),
    (3, 23.0, [14, 18, 20, 22, 24]),
    (12, 3.5, [8, 9, 10, 11]),
    (12, 10.0, [8, 9, 10, 11, 12]),
]


@pytest.mark.parametrize(("angle", "omega", "frequencies"), CASES)
@pytest.mark.parametrize("law", ["thesis", "adams"])
def test_the_default_step_is_within_two_per_cent(angle, omega, frequencies, law):
    if law == "adams":
        frequencies = frequencies[::3]  # its step is shorter: fewer points
    base = scenario(angle, omega).replace(**SHORT, **{"friction.law": law})
    assert base.dt == pytest.approx(9e-5 if law == "thesis" else 3.5e-5, rel=0.1)
    coarse_runs = [base.replace(**{"motion.frequency": float(f)}) for f in frequencies]
    coarse = simulate_all(coarse_runs, repeats=2, seed=2)
    fine = simulate_all([s.replace(time_step=base.dt / 10) for s in coarse_runs], repeats=2, seed=2, engine="cpu64")
    compared = [(a.spin_rate, b.spin_rate) for a, b in zip(coarse, fine, strict=True) if not (a.failed or b.failed)]
    assert len(compared) >= min(2, len(frequencies)), "hardly any of these fails"
    for a, b in compared:
        # 2 % of the rate; below 20 deg/s, where nothing spins yet, 0.4 deg/s.
        assert a == pytest.approx(b, rel=0.02, abs=math.radians(0.4))
