"""The lab's page fits curves as the package does, refuses the same ones, and saves files that the package reads."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from lab_scripts import NODE, asked

from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.curve.curve_file import read_curve
from plategait.curve.lorentz import fit_lorentzian, lorentzian
from plategait.errors import InputError
from plategait.simulation.registry import BUILT_IN

pytestmark = pytest.mark.skipif(NODE is None, reason="node is not installed: the lab's fits are not compared")

CURVES = 72
OBSERVED = {o.name: 0.001 * (i + 1) for i, o in enumerate(BUILT_IN)}
POINTS = [
    {"frequency": 20.0, "rate": 3.0, "spread": 0.02, "gait": "walking", "failure": "", "runs": 3, "failedRuns": 0},
    {"frequency": 22.5, "rate": None, "spread": None, "gait": "", "failure": "slipped", "runs": 3, "failedRuns": 3},
]


def curves() -> list[dict[str, Any]]:
    """Lines with noise of every size, turning either way, with gaps, with known scatter; and what has no peak."""
    rng = np.random.default_rng(3)
    drawn = []
    for i in range(CURVES):
        n = int(rng.integers(5, 40))
        f = np.linspace(10, 30, n) if i % 3 else np.sort(rng.uniform(8, 35, n))
        peak, noise = rng.choice([-1, 1]) * 10 ** rng.uniform(-1, 3), (0.01, 0.03, 0.1, 0.4)[i % 4]
        line = lorentzian(f, peak, rng.uniform(13, 28), 10 ** rng.uniform(0.2, 1.2))
        rate = (
            line,
            np.linspace(1, 5, n),  # only rises
            np.exp(-f / 10),  # only falls
            np.zeros(n),
        )[max(0, i % 12 - 8)] + noise * abs(peak) * rng.normal(size=n) * (i % 12 < 9)
        rate[rng.random(n) < 0.15 * (i % 2)] = math.nan
        sd = np.full(n, noise * abs(peak)) * rng.uniform(0.6, 1.5, n) if i % 4 == 2 else None
        drawn.append({"frequency": f, "rate": rate, "sd": sd, "ends": i % 5 == 4})
    return drawn


def failures() -> list[Array]:
    """Frequencies in any order of which some failed."""
    rng = np.random.default_rng(4)
    return [rng.permutation(np.column_stack([np.arange(12.0), rng.random(12) < 0.08 * i])) for i in range(12)]


def plain(values: Array | None) -> list[float | None] | None:
    return None if values is None else [None if math.isnan(x) else x for x in values.tolist()]


@pytest.fixture(scope="module")
def answered() -> dict[str, Any]:
    question = {
        "curves": [{k: v if k == "ends" else plain(v) for k, v in curve.items()} for curve in curves()],
        "failures": [[{"frequency": f, "rate": 1.0, "failed": bool(x)} for f, x in points] for points in failures()],
        "file": {"points": [point | {"values": OBSERVED} for point in POINTS],
                 "protocol": {"duration": 1.5, "slip_limit": 0.02}},
    }  # fmt: skip
    return asked("fit.js", question)


def test_the_same_curves_are_fitted_with_the_same_numbers(answered):
    fitted, advice = 0, []
    for curve, theirs in zip(curves(), answered["fits"], strict=True):
        try:
            ours = fit_lorentzian(curve["frequency"], curve["rate"], sd=curve["sd"], ends_in_failure=curve["ends"])
        except InputError as error:
            advice.append((theirs["advice"], error.hint))
            continue
        fitted += 1
        # MINPACK stops where the sum of squares changes by less than 1e-8: its root, and with it a number, by 1e-4.
        assert [theirs[k] for k in ("peak", "f0", "halfWidth", "r2")] == pytest.approx(
            [ours.peak, ours.f0_hz, ours.half_width_hz, ours.r2], rel=2e-4
        )
        assert (theirs["method"], theirs["scatter"]) == (ours.interval_method, ours.scatter)
        for name, interval in (("peak", ours.peak_interval), ("f0", ours.f0_interval),
                               ("halfWidth", ours.half_width_interval)):  # fmt: skip
            # Both ends are sought, by different ways, to 1e-4 of their distance.
            near = 1e-3 * (interval[1] - interval[0])
            assert theirs[f"{name}Interval"] == pytest.approx(interval, abs=near)
    # Where there is no peak, the place that a line ends at depends on where the search for it stops: the side does not.
    assert all(
        theirs.partition("Hz")[0].split()[:-1] == ours.partition("Hz")[0].split()[:-1] for theirs, ours in advice
    )
    assert 25 < fitted < CURVES - 25, "as many curves to fit as to refuse"


def test_the_same_points_are_left_out(answered):
    for points, theirs in zip(failures(), answered["used"], strict=True):
        f, failed = points[:, 0], points[:, 1] > 0
        words = tuple("slipped" if x else "" for x in failed)
        curve = Curve("drawn", f, np.ones(12), np.ones(12), ("",) * 12, words)
        assert theirs["fitted"] == curve.fitted.tolist()
        assert theirs["ends"] == curve.ends_in_failure


def test_a_saved_curve_is_one_that_the_package_reads(answered, tmp_path: Path):
    (tmp_path / "curve.csv").write_text(answered["csv"])
    curve = read_curve(tmp_path / "curve.csv")
    assert not curve.notes
    assert curve.frequency_hz.tolist() == [20.0, 22.5]
    np.testing.assert_allclose(curve.spin_rate_deg_s, [math.degrees(3.0), math.nan], rtol=1e-9)
    np.testing.assert_allclose(curve.spin_rate_sd_deg_s, [math.degrees(0.02), math.nan], rtol=1e-9)
    assert (curve.gait, curve.failure) == (("walking", ""), ("", "slipped"))
    assert curve.duration is not None
    assert curve.slip_limit is not None
    np.testing.assert_allclose([curve.duration, curve.slip_limit], [[1.5, 1.5], [0.02, 0.02]])
    for name, values in curve.values.items():
        np.testing.assert_allclose(values, OBSERVED[name], rtol=1e-9, err_msg=name)
    assert set(curve.values) == {o.name for o in BUILT_IN if o.label or o.in_curves}
