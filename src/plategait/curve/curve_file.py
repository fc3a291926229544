"""Spin curves as CSV files."""

from __future__ import annotations

import csv
import math
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from plategait.curve.curve import Curve
from plategait.curve.oddities import lone_frequencies, unread_columns
from plategait.curve.outcome import UNTOLD, Outcome, read_outcome
from plategait.errors import InputError, check_kind
from plategait.files.headings import Column
from plategait.files.output import whole_file
from plategait.files.table import Table, read_table
from plategait.simulation.observables import FAILURES, GAITS
from plategait.simulation.registry import all_observables
from plategait.units import parse

COLUMNS = ("frequency_hz", "spin_rate_deg_s", "spin_rate_sd_deg_s", "gait", "failure", "runs", "failed_runs")
"""Of every file; observables follow."""
# With the names that people give them.
_NUMBERS = {
    "frequency": Column("Hz", above=0.0, by_unit=True,
                        also=("freq", "f", "plate_frequency", "plate_freq", "drive_frequency", "frequenz")),
    "spin_rate": Column("rad/s", "deg/s", blank=True, by_unit=True,
                        also=("rate", "spin", "rotation_rate", "spin_speed", "omega", "drehrate", "drehzahl")),
    "spin_rate_sd": Column("rad/s", "deg/s", required=False, above=0.0,
                           also=("spin_rate_std", "rate_sd", "rate_std", "spin_sd", "sd", "std", "sigma", "±", "+/-")),
    "angle": Column("rad", "deg", required=False, above=0.0,
                    also=("plate_angle", "angular_amplitude", "angle_amplitude", "a_p", "ap")),
    "duration": Column("s", required=False, above=0.0, also=("clip_duration", "observed_for")),
    "slip_limit": Column("m", required=False, above=0.0),
    "stroke": Column("m", "mm", required=False, at_least=0.0,
                     also=("plate_stroke", "linear_amplitude", "stroke_amplitude", "b_p", "bp")),
    "height": Column("m", "mm", required=False, also=("plate_height",)),
    "phase": Column("rad", "deg", required=False, also=("stroke_phase",)),
    "runs": Column("", required=False, at_least=1.0),
    "failed_runs": Column("", required=False, at_least=0.0),
}  # fmt: skip
# Of the object itself, as a film shows it: SI unit, and the one that people read.
_OF_OBJECT = {"radius": ("m", "mm"), "area": ("m^2", "mm^2")}
_WORDS = {
    "gait": ("gaits",),
    "failure": ("failed", "fail", "fails", "status", "state", "outcome", "result", "ran_off", "run_off", "runoff",
                "fell_off"),
}  # fmt: skip


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
    """Write a curve as CSV with the columns of `COLUMNS` and its observables, whole or not at all.

    Parameters
    ----------
    curve : Curve
        Simulated or measured.
    path : Path or str
        File that ends in .csv; frequencies in Hz, rates in deg/s.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    check_kind(curve, Curve, "curve", "spin_curve(scenario, …)")
    with whole_file(path, (".csv",), "out") as temporary, open(temporary, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        observables = _written(curve)
        told = [(heading, x) for heading, x in _protocol(curve) if x is not None]
        writer.writerow([*COLUMNS, *(heading for heading, _ in observables + told)])
        unknown = np.full(len(curve.failure), math.nan)
        runs, failed = (unknown if x is None else x for x in (curve.runs, curve.failed_runs))
        # Runs that agree to the last digit show no spread; none is known of the measurement.
        sd = np.where(curve.spin_rate_sd_deg_s > 0, curve.spin_rate_sd_deg_s, math.nan)
        columns = (
            curve.frequency_hz,
            curve.spin_rate_deg_s,
            sd,
            curve.gait,
            curve.failure,
            runs,
            failed,
            *(values for _, values in observables + told),
        )
        for row in zip(*columns, strict=True):
            writer.writerow([v if isinstance(v, str) else f"{v:.10g}" if math.isfinite(v) else "" for v in row])


def _protocol(curve: Curve) -> tuple[tuple[str, NDArray[np.float64] | None], ...]:
    """Heading and cells, in its unit, of how each point was measured."""
    limit = None if curve.slip_limit is None else 1e3 * curve.slip_limit
    return ("duration_s", curve.duration), ("slip_limit_mm", limit)


def _motions(curve: Curve) -> tuple[tuple[str, NDArray[np.float64] | None], ...]:
    """Heading and cells of what a curve tells of the plate's motion at each point."""
    millimetres = (None if x is None else 1e3 * x for x in (curve.stroke, curve.height))
    phase = None if curve.phase is None else np.degrees(curve.phase)
    return tuple(zip(("angle_deg", "stroke_mm", "height_mm", "phase_deg"), (curve.angle_deg, *millimetres, phase),
                     strict=True))  # fmt: skip


def _written(curve: Curve) -> list[tuple[str, NDArray[np.float64]]]:
    """Heading and cells, in its unit, of each motion, observable and size of a curve, and how well it is known."""
    written = [(heading, column) for heading, column in _motions(curve) if column is not None]
    for o in all_observables().values():
        for kind, heading in ((curve.values, o.heading), (curve.value_sds, o.sd_heading)):
            if o.name in kind:
                written.append((heading, o.scale * kind[o.name]))
    for name, (unit, display) in _OF_OBJECT.items():
        for column in (name, f"{name}_sd"):
            if column in curve.of_object:
                written.append((f"{column}_{display}", curve.of_object[column] / parse(f"1 {display}", unit)))
    return written


def read_curve(path: Path | str) -> Curve:
    """Read a curve from CSV: frequency_hz, spin_rate_deg_s; where known the other `COLUMNS`, the plate's motion
    (angle_deg, stroke_mm, height_mm, phase_deg), observables.

    How each point was observed may stand in duration_s and slip_limit_mm. The standard deviation of an observable ends
    in `_sd`: bending_amplitude_deg, bending_amplitude_sd_deg.

    Of a film there are also radius_mm, radius_sd_mm, area_mm^2, area_sd_mm^2.

    Other units and names in the headings are read as well (see `plategait.files.table`), and what people write for a
    failure (`plategait.curve.outcome`). Empty cells are points without that knowledge. What is odd but may be meant is
    among the curve's notes.

    Parameters
    ----------
    path : Path or str
        CSV file: comma, semicolon or tab, any code page that spreadsheets write.

    Raises
    ------
    InputError
        When the file cannot be read, lacks a column, has one that only looks like one of these, or holds what is no
        number; names the line.
    """
    observables = {o.name: Column(o.unit.removeprefix("1"), required=False) for o in all_observables().values()}
    sds = {f"{o.name}_sd": Column(o.unit.removeprefix("1"), required=False, above=0.0, also=(f"{o.name}_std",))
           for o in all_observables().values() if o.label}  # fmt: skip
    of_object = {n: Column(unit, required=False, above=0.0)
                 for name, (unit, _) in _OF_OBJECT.items() for n in (name, f"{name}_sd")}  # fmt: skip
    columns = _NUMBERS | observables | sds | of_object
    table = read_table(path, columns, text=_WORDS, field="curve", example="frequency_hz,spin_rate_deg_s")
    names = {n: name for name, column in columns.items() for n in (name, *column.also)}
    names |= {n: name for name, also in _WORDS.items() for n in (name, *also)}
    file = table.path.name
    notes = [unread_columns(file, table.unread, names, {*table.numbers, *table.text})]
    notes += [f"{file}: taken in {columns[n].wanted}, as its heading tells no unit: {heading}"
              for n, heading in table.unitless.items()]  # fmt: skip
    notes += lone_frequencies(file, table["frequency"], table.lines)
    empty = np.full(len(table), math.nan)
    runs, failed_runs = table.get("runs", empty), table.get("failed_runs", empty)
    outcomes = _outcomes(table, failed_runs)
    _check_runs(table, runs, failed_runs, outcomes)
    return Curve(
        name=table.path.stem,
        frequency_hz=table["frequency"],
        spin_rate_deg_s=table["spin_rate"],
        spin_rate_sd_deg_s=table.get("spin_rate_sd", empty),
        gait=tuple(o.gait for o in outcomes),
        failure=tuple(o.failure for o in outcomes),
        angle_deg=table.numbers.get("angle"),
        duration=table.numbers.get("duration"),
        slip_limit=table.numbers.get("slip_limit"),
        stroke=_in_si(table, "stroke", 1e-3),
        height=_in_si(table, "height", 1e-3),
        phase=_in_si(table, "phase", math.pi / 180),
        runs=runs,
        failed_runs=failed_runs,
        values={name: table[name] for name in observables if name in table.numbers},
        of_object={name: table[name] for name in of_object if name in table.numbers},
        value_sds={n.removesuffix("_sd"): table[n] for n in sds if n in table.numbers},
        notes=tuple(filter(None, notes)),
    )


def _in_si(table: Table, name: str, factor: float) -> NDArray[np.float64] | None:
    """A column in SI, where the file has it."""
    return factor * table[name] if name in table.numbers else None


def _outcomes(table: Table, failed_runs: NDArray[np.float64]) -> list[Outcome]:
    """What the object did at each point, by its gait, its failure, or the number of runs that failed."""
    nothing = ("",) * len(table)
    if "failure" in table.text:
        failure = [_outcome(table, i, "failure", cell) for i, cell in enumerate(table.text["failure"])]
    else:
        failure = [Outcome(failure=UNTOLD * bool(failed > 0)) for failed in failed_runs]
    outcomes = []
    for i, (cell, other) in enumerate(zip(table.text.get("gait", nothing), failure, strict=True)):
        own = _outcome(table, i, "gait", cell)
        outcomes.append(Outcome(own.gait or other.gait, other.failure or own.failure))
    return outcomes


def _outcome(table: Table, i: int, column: str, cell: str) -> Outcome:
    """What one cell says."""
    outcome = read_outcome(cell, answers=column == "failure")
    if outcome is None:
        allowed = f"one of {', '.join(GAITS)}, or empty" if column == "gait" else (
            f"yes, no, empty or what happened: {', '.join(FAILURES)}")  # fmt: skip
        hint = GAITS[1] if column == "gait" else "yes"
        raise InputError(f"{table.path.name} line {table.lines[i]}, {column}", cell, allowed, hint)
    return outcome


def _check_runs(table: Table, runs: NDArray[np.float64], failed: NDArray[np.float64], outcomes: list[Outcome]) -> None:
    """Refuse numbers of runs that cannot be, or that a failure contradicts."""
    has_failure = np.array([bool(o.failure) for o in outcomes], dtype=bool)
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
            got = f"{outcomes[i].failure or 'nothing'} at {failed[i]:g} of {runs[i]:g} runs"
            where = f"{table.path.name} line {table.lines[i]}, {field}"
            raise InputError(where, got, allowed, "leaving runs and failed_runs out")
