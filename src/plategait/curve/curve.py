"""Spin curves: spin rate over plate frequency, simulated or measured, with their Lorentz fit (section 5.3)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from plategait.arrays import Array, Flags
from plategait.curve.lorentz import LorentzFit
from plategait.curve.peak import unseen_top
from plategait.files.plain import plain
from plategait.shown import Shown
from plategait.simulation.ensemble import fails
from plategait.simulation.result import Simulation

# Successive failed frequencies that end a curve.
RUN_OFF = 3


@dataclass(frozen=True, eq=False, repr=False)
class Curve(Shown):
    """Spin rate over plate frequency.

    Source: section 5.3 of the dissertation.

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
    stroke, height, phase : (n,) arrays or None
        Stroke B_p of each point, m, height of the plate above its axis, m, and phase of the stroke before the turning,
        rad, where the file tells them.
    values : mapping of str to (n,) array
        Observables by name (`plategait.simulation.registry`), SI, where they are known.
    value_sds : mapping of str to (n,) array
        Standard deviation of each observable's values, SI, where it is known.
    duration, slip_limit : (n,) arrays or None
        How long each point was observed, s, and the slip at which the object counted as run off, m, where it is known.
    of_object : mapping of str to (n,) array
        What a film shows of the object itself: radius (of a circle with its area), area; with `_sd` their standard
        deviations; SI.
    notes : tuple of str
        What the file that it was read from has that nothing reads, or that is probably not meant.
    """

    name: str
    frequency_hz: Array
    spin_rate_deg_s: Array
    spin_rate_sd_deg_s: Array
    gait: tuple[str, ...]
    failure: tuple[str, ...]
    fit: LorentzFit | None = None
    no_fit: str = ""
    simulations: tuple[Simulation, ...] = ()
    angle_deg: Array | None = None
    stroke: Array | None = None
    height: Array | None = None
    phase: Array | None = None
    runs: Array | None = None
    failed_runs: Array | None = None
    values: Mapping[str, Array] = field(default_factory=dict)
    value_sds: Mapping[str, Array] = field(default_factory=dict)
    duration: Array | None = None
    slip_limit: Array | None = None
    of_object: Mapping[str, Array] = field(default_factory=dict)
    notes: tuple[str, ...] = ()

    def told(self) -> list[tuple[str, str]]:
        """What a person asks first."""
        measured = int(np.isfinite(self.spin_rate_deg_s).sum())
        span = f"{self.frequency_hz.min():g} to {self.frequency_hz.max():g} Hz" if len(self.frequency_hz) else "none"
        gaits = ", ".join(f"{self.gait.count(kind)} {kind}" for kind in dict.fromkeys(self.gait) if kind)
        rows = [("name", self.name), ("points", f"{len(self.frequency_hz)} from {span}, {measured} measured"),
                ("failed", str(int(self.failed.sum()))), ("gaits", gaits or "–")]  # fmt: skip
        if self.fastest:
            rows.append(("fastest", f"{self.fastest[1]:.0f} deg/s at {self.fastest[0]:g} Hz"))
        fit = self.fit
        if fit is None:
            return [*rows, ("Lorentz fit", f"none: {self.no_fit}" if self.no_fit else "none")]
        return [*rows, ("f0", f"{fit.f0_hz:.2f} Hz"), ("half width", f"{fit.half_width_hz:.2f} Hz"),
                ("peak", f"{fit.peak:.0f} deg/s"), ("R²", f"{fit.r2:.3f}")]  # fmt: skip

    @property
    def failed(self) -> Flags:
        """Which failed: by the rule of `simulation.ensemble` where the runs are known, else those with a failure."""
        has_failure = np.array([bool(kind) for kind in self.failure], dtype=bool)
        if self.runs is None or self.failed_runs is None:
            return has_failure
        return np.where(np.isfinite(self.runs + self.failed_runs), fails(self.failed_runs, self.runs), has_failure)

    @property
    def partly_failed(self) -> Flags:
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
    def fitted(self) -> Flags:
        """Points that the fit may use: measured, not failed, and below the run-off.

        The source's curves stop where the object becomes unstable (section 4.4). So does the fit: at the first of
        `RUN_OFF` successive frequencies that all failed; islands of stability beyond it belong to another motion.
        """
        order = np.argsort(self.frequency_hz, kind="stable")
        failed = self.failed[order]
        runs = (
            np.convolve(failed, np.ones(RUN_OFF), "valid") == RUN_OFF if len(failed) >= RUN_OFF else np.zeros(0, bool)
        )
        usable = ~failed
        if runs.any():
            usable[int(np.argmax(runs)) :] = False
        out = np.empty_like(usable)
        out[order] = usable
        return out & np.isfinite(self.spin_rate_deg_s)

    @property
    def ends_in_failure(self) -> bool:
        """Whether the object failed at a frequency above those that the fit may use."""
        highest = self.frequency_hz[self.fitted].max(initial=0)
        return bool(self.failed[self.frequency_hz > highest].any())

    @property
    def fastest(self) -> tuple[float, float] | None:
        """Fastest point that did not fail: frequency, Hz, and spin rate, deg/s; None where nothing was measured."""
        rate = np.where(self.failed, math.nan, self.spin_rate_deg_s)
        if not np.isfinite(rate).any():
            return None
        i = int(np.nanargmax(np.abs(rate)))
        return float(self.frequency_hz[i]), float(rate[i])

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
        peak, (at, rate) = self.peak_frequency, self.fastest or (None, None)
        numbers = fit_summary(self.fit) | {
            "no_fit": self.no_fit or None,
            "peak_frequency_hz": peak if math.isfinite(peak) else None,
            "fastest_hz": at,
            "fastest_deg_s": rate,
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
