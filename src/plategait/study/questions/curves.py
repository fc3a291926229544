"""Spin curves of the cheese for the studies: their points, and their fits from the columns that runs gave."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.curve.lorentz import LorentzFit
from plategait.curve.protocol import Protocol, measured_as
from plategait.curve.spin_curve import fit_curve
from plategait.model.presets import preset
from plategait.model.scenario import Scenario
from plategait.study.measured import Columns

CHEESE = preset("cheese").scenario.replace(duration=1.6, transient=0.6, slip_limit=0.015)
FREQUENCIES = (13.0, 15.0, 16.0, 17.0, 18.0, 20.0, 22.0, 23.0, 24.0, 25.0, 26.0, 27.0, 28.0, 29.0, 30.0)
"""Of the plate at A_p = 3 deg, Hz."""


def at_frequencies(scenarios: Sequence[Scenario], frequencies: Sequence[float] = FREQUENCIES) -> list[Scenario]:
    """Each scenario at each frequency in turn."""
    return [s.replace(**{"motion.frequency": f}) for s in scenarios for f in frequencies]


def as_run(scenario: Scenario) -> Scenario:
    """Scenario as an estimator is told that it was measured: as long, from when on and to the slip that it was run."""
    return measured_as(scenario, Protocol(scenario.duration, scenario.measured_from, scenario.slip_limit))


def curves_of(columns: Columns, frequencies: Sequence[float] = FREQUENCIES) -> list[Curve]:
    """Spin curves, deg/s over Hz, of points in the order of `at_frequencies`; failed where half the starts are."""
    n = len(frequencies)
    rates, failed = (columns[name].reshape(-1, n) for name in ("spin_rate", "failed"))
    return [
        Curve(
            name=f"curve {i}", frequency_hz=np.array(frequencies), spin_rate_deg_s=np.degrees(rate),
            spin_rate_sd_deg_s=np.full(n, math.nan), gait=("",) * n,
            failure=tuple("slipped" if share >= 0.5 else "" for share in off),
        )
        for i, (rate, off) in enumerate(zip(rates, failed, strict=True))
    ]  # fmt: skip


def fits_of(columns: Columns, frequencies: Sequence[float] = FREQUENCIES) -> list[LorentzFit | None]:
    """Lorentz fit of each curve, None where it has no peak."""
    return [fit_curve(curve).fit for curve in curves_of(columns, frequencies)]


def run_offs(columns: Columns, frequencies: Sequence[float] = FREQUENCIES) -> Array:
    """(curves,) frequency from which on runs fail, Hz: the range's end less the width of failing, by share.

    The lowest frequency at which most fail would jump with one island of stability.
    """
    failed = columns["failed"].reshape(-1, len(frequencies))
    return np.asarray(frequencies[-1] - np.trapezoid(failed, np.array(frequencies), axis=1), dtype=np.float64)


def rates_at(columns: Columns, frequency: float, frequencies: Sequence[float] = FREQUENCIES) -> Array:
    """(curves,) spin rate at one of the frequencies, deg/s."""
    return np.degrees(columns["spin_rate"].reshape(-1, len(frequencies))[:, list(frequencies).index(frequency)])
