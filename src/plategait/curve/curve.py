"""Spin curves: spin rate over plate frequency, simulated or measured, with their Lorentz fit (section 5.3)."""

from __future__ import annotations

import csv
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from plategait.curve.lorentz import LorentzFit, fit_lorentzian
from plategait.curve.peak import unseen_top
from plategait.errors import InputError
from plategait.files.output import whole_file
from plategait.files.plain import plain
from plategait.files.ranges import parse_frequencies
from plategait.files.table import Column, read_table
from plategait.model.presets import Preset, as_scenario
from plategait.model.scenario import Scenario
from plategait.simulation.ensemble import Ensemble, fails
from plategait.simulation.observables import GAITS
from plategait.simulation.observation import Observation, ensemble_of
from plategait.simulation.result import Simulation
from plategait.simulation.run import RunOptions, check_options, simulate_all
from plategait.units import FREQUENCY

COLUMNS = ("frequency_hz", "spin_rate_deg_s", "spin_rate_sd_deg_s", "gait", "failure", "runs", "failed_runs")
_MEASURED = {
    "frequency": Column("Hz", above=0.0),
    "spin_rate": Column("rad/s", "deg/s", blank=True),
    "spin_rate_sd": Column("rad/s", "deg/s", required=False, at_least=0.0),
    "angle": Column("rad", "deg", required=False, above=0.0),
    "runs": Column("", required=False, at_least=1.0),
    "failed_runs": Column("", required=False, at_least=0.0),
}
# Successive failed frequencies that end a curve.
RUN_OFF = 3


@dataclass(frozen=True, eq=False)
class Curve:
    """Spin rate over plate frequency.

    Attributes
    ----------
    name : str
    frequency_hz, spin_rate_deg_s, spin_rate_sd_deg_s : (n,) arrays
        NaN where nothing was measured or no spread is known.
    gait, failure : tuple of str
        Empty where unknown, or where no run failed.
    runs, failed_runs : (n,) arrays or None
        How many runs each point is made of, and how many of them failed; NaN or None where it is not known.
    fit : LorentzFit or None
        Of the points that did not fail; in deg/s and Hz.
    no_fit : str
        Why there is no fit.
    simulations : tuple of Simulation
        Behind each point; empty for a measured curve.
    angle_deg : (n,) array or None
        Angular amplitude A_p of each point, where the file tells it.
    """

    name: str
    frequency_hz: NDArray[np.float64]
    spin_rate_deg_s: NDArray[np.float64]
    spin_rate_sd_deg_s: NDArray[np.float64]
    gait: tuple[str, ...]
    failure: tuple[str, ...]
    fit: LorentzFit | None = None
    no_fit: str = ""
    simulations: tuple[Simulation, ...] = ()
    angle_deg: NDArray[np.float64] | None = None
    runs: NDArray[np.float64] | None = None
    failed_runs: NDArray[np.float64] | None = None

    @property
    def failed(self) -> NDArray[np.bool_]:
        """Which failed: by the rule of `simulation.ensemble` where the runs are known, else those with a failure."""
        told = np.array([bool(kind) for kind in self.failure], dtype=bool)
        if self.runs is None or self.failed_runs is None:
            return told
        return np.where(np.isfinite(self.runs + self.failed_runs), fails(self.failed_runs, self.runs), told)

    @property
    def partly_failed(self) -> NDArray[np.bool_]:
        """Points at which some runs failed and some did not."""
        if self.runs is None or self.failed_runs is None:
            return np.zeros(len(self.failure), dtype=bool)
        return (self.failed_runs > 0) & (self.failed_runs < self.runs)

    @property
    def failure_in_words(self) -> tuple[str, ...]:
        """Failure of each point, with how many of its runs failed where they are several."""
        words = list(self.failure)
        if self.runs is not None and self.failed_runs is not None:
            for i in np.nonzero((self.failed_runs > 0) & (self.runs > 1))[0]:
                words[i] = f"{self.failed_runs[i]:g} of {self.runs[i]:g} failed: {words[i] or 'unknown'}"
        return tuple(words)

    @property
    def fitted(self) -> NDArray[np.bool_]:
        """Points that the fit may use: measured, not failed, and below the run-off.

        The source's curves stop where the object becomes unstable (section 4.4). So does the fit: at the first of
        `RUN_OFF` successive frequencies that all failed; islands of stability beyond it belong to another motion.
        """
        order = np.argsort(self.frequency_hz, kind="stable")
        failed = self.failed[order]
        runs = (
            np.convolve(failed, np.ones(RUN_OFF), "valid") == RUN_OFF if len(failed) >= RUN_OFF else np.zeros(0, bool)
        )
        kept = ~failed
        if runs.any():
            kept[int(np.argmax(runs)) :] = False
        out = np.empty_like(kept)
        out[order] = kept
        return out & np.isfinite(self.spin_rate_deg_s)

    @property
    def ends_in_failure(self) -> bool:
        """Whether the object failed at a frequency above those that the fit may use."""
        highest = self.frequency_hz[self.fitted].max(initial=0)
        return bool(self.failed[self.frequency_hz > highest].any())

    @property
    def peak_frequency(self) -> float:
        """Frequency of the highest spin rate, Hz: vertex of the parabola through the points above 85 % of it.

        The tops are flat and the highest single point wanders along them. NaN for fewer than three such points, or
        where the curve shows no top: see `plategait.curve.peak.unseen_top`.
        """
        f, rate = self.frequency_hz[self.fitted], self.spin_rate_deg_s[self.fitted]
        top = rate > 0.85 * rate.max() if len(rate) else np.zeros(0, bool)
        if top.sum() < 3 or unseen_top(f, rate, ends_in_failure=self.ends_in_failure):
            return math.nan
        middle = f[top].mean()
        curvature, slope, _ = np.polyfit(f[top] - middle, rate[top], 2)
        vertex = middle - slope / (2 * curvature)
        return float(vertex) if curvature < 0 and f[top].min() <= vertex <= f[top].max() else float(f[np.argmax(rate)])

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`: the fit, and every point."""
        peak = self.peak_frequency
        numbers = fit_summary(self.fit) | {
            "no_fit": self.no_fit or None,
            "peak_frequency_hz": peak if math.isfinite(peak) else None,
        }
        if self.simulations:
            return numbers | {"points": [s.summary() for s in self.simulations]}
        points = zip(self.frequency_hz, self.spin_rate_deg_s, self.gait, self.failure, self.failed, strict=True)
        return numbers | {
            "points": [
                {
                    "frequency_hz": f,
                    "spin_rate_deg_s": r if math.isfinite(r) else None,
                    "gait": g or None,
                    "failure": x or None,
                    "failed": bool(failed),
                }
                for f, r, g, x, failed in points
            ]
        }


def fit_summary(fit: LorentzFit | None) -> dict[str, Any]:
    """Plain numbers of a Lorentz fit; None where there is none."""
    names = {"f0_hz": "f0_hz", "half_width_hz": "half_width_hz", "peak_deg_s": "peak", "r2": "r2"}
    numbers: dict[str, Any] = {key: getattr(fit, name) if fit else None for key, name in names.items()}
    for key, name in (
        ("f0_hz", "f0_interval"),
        ("half_width_hz", "half_width_interval"),
        ("peak_deg_s", "peak_interval"),
    ):
        numbers[f"{key}_interval"] = list(getattr(fit, name)) if fit else None
    return {key: plain(value) for key, value in numbers.items()}


def as_curve(given: Curve | Path | str, field: str = "curve") -> Curve:
    """Curve that is meant: itself, or what a CSV file holds.

    Raises
    ------
    InputError
        For anything else, or when the file is not as it must be.
    """
    if isinstance(given, Curve):
        return given
    if isinstance(given, (str, Path)):
        return read_curve(given)
    raise InputError(field, given, "a Curve or the name of its CSV file", '"curve.csv"')


def fit_curve(curve: Curve | Path | str) -> Curve:
    """Same curve with the Lorentz fit (5.5) of its `fitted` points, or with the reason why there is none."""
    curve = as_curve(curve)
    kept = curve.fitted
    try:
        fit = fit_lorentzian(
            curve.frequency_hz[kept], curve.spin_rate_deg_s[kept], ends_in_failure=curve.ends_in_failure
        )
    except InputError as error:
        return replace(curve, fit=None, no_fit=str(error))
    return replace(curve, fit=fit, no_fit="")


def spin_curve(
    scenario: Scenario | Preset | Path | str, frequencies: Sequence[float | str] | str, **options: Unpack[RunOptions]
) -> Curve:
    """Simulate a spin curve and fit it.

    Parameters
    ----------
    scenario : Scenario, or what tells one
        Run at each frequency in turn; see `plategait.simulation.run.simulate`.
    frequencies : sequence of float, or str
        Hz; or text such as "12:30:1Hz", see `parse_frequencies`.
    **options
        See `plategait.simulation.run.simulate_all`.

    Raises
    ------
    InputError
        For what is no scenario or no frequencies, an unknown option, or one out of range.
    """
    check_options(options)
    chosen, frequencies = as_scenario(scenario), _frequencies(frequencies)
    scenarios = [chosen.replace(**{"motion.frequency": f}) for f in frequencies]
    simulations = simulate_all(scenarios, **options)
    shown = curve_of(chosen.name, frequencies, [s.observations for s in simulations])
    return fit_curve(replace(shown, simulations=tuple(simulations)))


def curve_of(name: str, frequencies: Sequence[float], observations: Sequence[Sequence[Observation]]) -> Curve:
    """Curve without a fit, from the observations of each frequency's runs."""
    shown: Ensemble = ensemble_of(observations)
    return Curve(
        name=name,
        frequency_hz=np.array(frequencies, dtype=float),
        spin_rate_deg_s=np.degrees(shown.rate),
        spin_rate_sd_deg_s=np.degrees(shown.spread),
        gait=shown.gait,
        failure=shown.failure,
        runs=np.full(len(shown.rate), float(shown.runs)),
        failed_runs=shown.failed_runs.astype(float),
    )


def _frequencies(given: Sequence[float | str] | str) -> list[float]:
    """Frequencies of a range as text, or of a list of numbers, Hz."""
    if isinstance(given, str):
        return parse_frequencies(given)
    if not hasattr(given, "__iter__"):
        raise InputError("frequencies", given, "several frequencies in Hz", f'"{given}, 24 Hz" or "12:30:1Hz"')
    return [FREQUENCY.read(f, "frequencies") for f in given]


def write_curve(curve: Curve, path: Path | str) -> None:
    """Write a curve as CSV with the columns of `COLUMNS`, whole or not at all."""
    with whole_file(path, (".csv",), "out") as temporary, open(temporary, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(COLUMNS)
        unknown = np.full(len(curve.failure), math.nan)
        runs, failed = (unknown if x is None else x for x in (curve.runs, curve.failed_runs))
        columns = (curve.frequency_hz, curve.spin_rate_deg_s, curve.spin_rate_sd_deg_s, curve.gait, curve.failure,
                   runs, failed)  # fmt: skip
        for row in zip(*columns, strict=True):
            writer.writerow([v if isinstance(v, str) else f"{v:.10g}" if math.isfinite(v) else "" for v in row])


def read_curve(path: Path | str) -> Curve:
    """Read a curve from CSV: frequency_hz, spin_rate_deg_s; where known the other `COLUMNS` and angle_deg.

    Other units in the headings are read as well (see `plategait.files.table`). Empty cells are points without that
    knowledge.

    Raises
    ------
    InputError
        When the file cannot be read, lacks a column, or holds what is no number; names the line.
    """
    table = read_table(path, _MEASURED, text=("gait", "failure"), field="curve", example="frequency_hz,spin_rate_deg_s")
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
    )


def _check_runs(runs: NDArray[np.float64], failed: NDArray[np.float64], failure: Sequence[str]) -> None:
    """Refuse numbers of runs that cannot be, or that a failure contradicts."""
    told = np.array([bool(kind) for kind in failure], dtype=bool)
    wrong = (np.isnan(runs) != np.isnan(failed)) | (failed > runs) | (runs % 1 > 0) | (failed % 1 > 0)
    for field, odd, allowed in (
        ("failed_runs", wrong, "whole, at most the runs of the point, and given where they are"),
        ("failure", np.isfinite(failed) & (told != (failed > 0)), "told where failed_runs is above 0, and only there"),
    ):
        if odd.any():
            i = int(np.argmax(odd))
            got = f"{failure[i] or 'nothing'} at {failed[i]:g} of {runs[i]:g} runs"
            raise InputError(field, got, allowed, "leaving runs and failed_runs out")
