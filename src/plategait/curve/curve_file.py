"""Spin curves as CSV files."""

from __future__ import annotations

import csv
import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from plategait.curve.curve import Curve
from plategait.errors import InputError
from plategait.files.output import whole_file
from plategait.files.table import Column, read_table
from plategait.simulation.observables import GAITS
from plategait.simulation.registry import all_observables

COLUMNS = ("frequency_hz", "spin_rate_deg_s", "spin_rate_sd_deg_s", "gait", "failure", "runs", "failed_runs")
"""Of every file; observables follow."""
_MEASURED = {
    "frequency": Column("Hz", above=0.0),
    "spin_rate": Column("rad/s", "deg/s", blank=True),
    "spin_rate_sd": Column("rad/s", "deg/s", required=False, at_least=0.0),
    "angle": Column("rad", "deg", required=False, above=0.0),
    "runs": Column("", required=False, at_least=1.0),
    "failed_runs": Column("", required=False, at_least=0.0),
}


def as_curve(curve: Curve | Path | str, field: str = "curve") -> Curve:
    """Curve that is meant: itself, or what a CSV file holds.

    Raises
    ------
    InputError
        For anything else, or when the file is not as it must be.
    """
    if isinstance(curve, Curve):
        return curve
    if isinstance(curve, (str, Path)):
        return read_curve(curve)
    raise InputError(field, curve, "a Curve or the name of its CSV file", '"curve.csv"')


def write_curve(curve: Curve, path: Path | str) -> None:
    """Write a curve as CSV with the columns of `COLUMNS` and its observables, whole or not at all."""
    with whole_file(path, (".csv",), "out") as temporary, open(temporary, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        observables = [(o, curve.values[o.name]) for o in all_observables().values() if o.name in curve.values]
        writer.writerow([*COLUMNS, *(observable.heading for observable, _ in observables)])
        unknown = np.full(len(curve.failure), math.nan)
        runs, failed = (unknown if x is None else x for x in (curve.runs, curve.failed_runs))
        columns = (curve.frequency_hz, curve.spin_rate_deg_s, curve.spin_rate_sd_deg_s, curve.gait, curve.failure,
                   runs, failed, *(observable.scale * values for observable, values in observables))  # fmt: skip
        for row in zip(*columns, strict=True):
            writer.writerow([v if isinstance(v, str) else f"{v:.10g}" if math.isfinite(v) else "" for v in row])


def read_curve(path: Path | str) -> Curve:
    """Read a curve from CSV: frequency_hz, spin_rate_deg_s; where known the other `COLUMNS`, angle_deg, observables.

    Other units in the headings are read as well (see `plategait.files.table`). Empty cells are points without that
    knowledge.

    Raises
    ------
    InputError
        When the file cannot be read, lacks a column, or holds what is no number; names the line.
    """
    observables = {o.name: Column(o.unit.removeprefix("1"), required=False) for o in all_observables().values()}
    table = read_table(
        path, _MEASURED | observables, text=("gait", "failure"), field="curve", example="frequency_hz,spin_rate_deg_s"
    )
    gait = table.text["gait"]
    if unknown := set(gait) - {"", *GAITS}:
        raise InputError("gait", unknown.pop(), f"one of {', '.join(GAITS)}, or empty", "walking")
    empty = np.full(len(table), math.nan)
    runs, failed_runs = table.get("runs", empty), table.get("failed_runs", empty)
    _check_runs(runs, failed_runs, table.text["failure"])
    return Curve(
        name=table.path.stem,
        frequency_hz=table["frequency"],
        spin_rate_deg_s=table["spin_rate"],
        spin_rate_sd_deg_s=table.get("spin_rate_sd", empty),
        gait=gait,
        failure=table.text["failure"],
        angle_deg=table.numbers.get("angle"),
        runs=runs,
        failed_runs=failed_runs,
        values={name: table[name] for name in observables if name in table.numbers},
    )


def _check_runs(runs: NDArray[np.float64], failed: NDArray[np.float64], failure: Sequence[str]) -> None:
    """Refuse numbers of runs that cannot be, or that a failure contradicts."""
    has_failure = np.array([bool(kind) for kind in failure], dtype=bool)
    wrong = (np.isnan(runs) != np.isnan(failed)) | (failed > runs) | (runs % 1 > 0) | (failed % 1 > 0)
    for field, odd, allowed in (
        ("failed_runs", wrong, "whole, at most the runs of the point, and given where they are"),
        (
            "failure",
            np.isfinite(failed) & (has_failure != (failed > 0)),
            "told where failed_runs is above 0, and only there",
        ),
    ):
        if odd.any():
            i = int(np.argmax(odd))
            got = f"{failure[i] or 'nothing'} at {failed[i]:g} of {runs[i]:g} runs"
            raise InputError(field, got, allowed, "leaving runs and failed_runs out")
