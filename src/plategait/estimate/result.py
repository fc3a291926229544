"""Estimates: what a measured spin curve says of the object, ready to print, store and simulate with."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.curve.curve_file import as_curve
from plategait.errors import InputError
from plategait.estimate.judgement import CONFIDENCE, Finding, FitCheck, check_fit, judge
from plategait.estimate.observations import observe_curves
from plategait.estimate.posterior import Posterior, estimate_posterior
from plategait.estimate.unknowns import unknowns
from plategait.files.plain import plain
from plategait.model.fragment import Fragment
from plategait.model.measured import Measured
from plategait.model.motion import PlateMotion
from plategait.model.presets import Preset, as_scenario
from plategait.model.scenario import Scenario
from plategait.units import Quantity

_SHARE = Quantity("", "", "0.9")


@dataclass(frozen=True, eq=False)
class Estimate:
    """Parameters of an object, read off its spin curve.

    Attributes
    ----------
    posterior : Posterior
    findings : tuple of Finding
        One for each parameter; see `Finding.verdict` before using its numbers.
    check : FitCheck
    confidence : float
        Of the intervals.
    """

    posterior: Posterior
    findings: tuple[Finding, ...]
    check: FitCheck
    confidence: float

    def __getitem__(self, name: str) -> Finding:
        """Finding for one parameter by name."""
        return next(f for f in self.findings if f.parameter.name == name)

    @cached_property
    def correlation(self) -> Array:
        """(d, d) correlation of the parameters."""
        return np.atleast_2d(np.corrcoef(self.posterior.u, rowvar=False))

    @property
    def answered(self) -> bool:
        """Whether the data are explained and determine at least one parameter."""
        return self.check.explained and any(f.verdict == "determined" for f in self.findings)

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`; numbers that the gate withholds are None."""
        numbers: dict[str, Any] = {}
        for f in self.findings:
            scale, shown = f.parameter.scale, f.verdict == "determined"
            numbers[f.parameter.name] = {
                "verdict": f.verdict,
                "unit": f.parameter.unit or None,
                "median": f.median / scale if shown else None,
                "sd": f.sd / scale if shown else None,
                "low": f.low / scale if shown or f.verdict == "at least" else None,
                "high": f.high / scale if shown or f.verdict == "at most" else None,
                "sd_over_prior": f.contraction,
            }
        names = [f.parameter.name for f in self.findings]
        check = self.check
        return {
            "method": "posterior",
            "confidence": self.confidence,
            "parameters": numbers,
            "correlation": {"between": names, "matrix": self.correlation.tolist()},
            "explained": check.explained,
            "complaints": list(check.complaints),
            "chi2": plain(check.chi2),
            "freedom": check.freedom,
            "p": plain(check.p),
            "noise": plain(check.noise),
            "outliers_hz": list(check.outliers),
            "notes": list(self.posterior.data.notes),
            "points": len(self.posterior.data.which),
            "runs": int(self.posterior.trials.rates.size),
        }

    def to_fragment(self) -> Fragment:
        """Scenario fragment of what the data determine, with intervals and correlations.

        Raises
        ------
        InputError
            When they determine nothing that a scenario has.
        """
        values = self.posterior.values
        by_name = {f.parameter.name: i for i, f in enumerate(self.findings) if f.verdict == "determined"}
        columns: dict[str, Array] = {}
        unknown = self.posterior.unknowns
        sheet = unknown.base.sheet
        mass = values[:, by_name["mass"]] if "mass" in by_name else np.ones(len(values))
        if "mass" in by_name:
            columns["sheet.mass"] = sheet.mass * mass
        if "natural_frequency" in by_name:
            one = unknown.scenario(values[0]).sheet.bending_stiffness / values[0, by_name["natural_frequency"]] ** 2
            columns["sheet.bending_stiffness"] = one * values[:, by_name["natural_frequency"]] ** 2 * mass / mass[0]
        if "bending_damping" in by_name:
            columns["sheet.bending_damping"] = sheet.bending_damping * values[:, by_name["bending_damping"]]
        if "friction_angle" in by_name:
            columns["friction.static"] = np.tan(values[:, by_name["friction_angle"]])
            if "friction_ratio" in by_name:
                columns["friction.kinetic"] = columns["friction.static"] * values[:, by_name["friction_ratio"]]
        if "contact_damping" in by_name:
            columns["contact.damping"] = unknown.base.contact.damping * values[:, by_name["contact_damping"]]
        if not columns:
            raise InputError("--out", "nothing that the data determine", "a curve that says more",
                             "plategait estimate CURVE.csv --next")  # fmt: skip
        tail = (1 - self.confidence) / 2
        parameters = {
            name: Measured(float(np.median(x)), float(np.std(x)), *map(float, np.quantile(x, [tail, 1 - tail])))
            for name, x in columns.items()
        }
        correlation = np.atleast_2d(np.corrcoef(np.stack(list(columns.values()))))
        return Fragment(parameters, correlation, self.confidence, "plategait estimate, posterior of a spin curve")


def estimate_parameters(
    curves: Curve | Path | str | Sequence[Curve | Path | str],
    scenario: Scenario | Preset | Path | str,
    *,
    motions: Sequence[PlateMotion] | None = None,
    noise: float | None = None,
    friction_ratio: float | None = None,
    free: Sequence[str] = (),
    known: Sequence[str] = (),
    confidence: float = CONFIDENCE,
    seed: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Estimate:
    """Read an object's natural frequency and friction off its spin curve, with intervals.

    Parameters
    ----------
    curves : Curve, name of its CSV file, or a sequence of these
        Measured. Several may have been measured at different plate amplitudes.
    scenario : Scenario, or what tells one
        A preset or its name, or a TOML file. The object's size, shape and mass, the plate's motion and the duration of
        a run; its stiffness and friction are what is sought. See `plategait.curve.protocol`.
    motions : sequence of PlateMotion, optional
        One for each curve; the scenario's by default.
    noise : float, optional
        Relative standard deviation of rates that come without one; estimated too if left out.
    friction_ratio : float, optional
        β = μ_k/μ_s where it is known.
    free : sequence of str
        What else is unknown: "mass", "bending_damping", "contact_damping".
    known : sequence of str
        Parameters that are not sought, since the scenario has them: "natural_frequency", "friction_angle".
    confidence : float
        Of the intervals.
    seed : int
        Of the sampling: the same data and seed give the same estimate.
    progress : callable, optional
        Called with the fraction done.

    Raises
    ------
    InputError
        For too few or too many points, or options out of range.
    """
    curves = [as_curve(c) for c in ([curves] if isinstance(curves, (Curve, str, Path)) else curves)]
    scenario = as_scenario(scenario)
    free, known = ([name] if isinstance(name, str) else name for name in (free, known))
    confidence = _SHARE.read(confidence, "confidence")
    noise = None if noise is None else _SHARE.read(noise, "noise")
    if motions is not None and len(motions) != len(curves):
        raise InputError("motions", f"{len(motions)} of them", f"one for each of {len(curves)} curves",
                         "[scenario.motion]")  # fmt: skip
    if not 0.5 <= confidence < 1:
        raise InputError("confidence", confidence, "at least 0.5 and below 1", "0.9")
    if noise is not None and not 0.001 <= noise <= 1:
        raise InputError("noise", noise, "at least 0.001 and at most 1 (0.05 for 5 %)", "0.05")
    data = observe_curves(curves, motions or [scenario.motion] * len(curves))
    sought = unknowns(scenario, free=free, friction_ratio=friction_ratio, known=known)
    posterior = estimate_posterior(data, sought, noise=noise, seed=seed, progress=progress)
    findings = tuple(judge(p, posterior.u[:, i], confidence) for i, p in enumerate(sought.parameters))
    return Estimate(posterior, findings, check_fit(posterior), confidence)


def correlated(estimate: Estimate, least: float = 0.7) -> list[tuple[str, str, float]]:
    """Pairs of parameters whose errors go together, with their correlation."""
    names, matrix = [f.parameter.name for f in estimate.findings], estimate.correlation
    pairs = [(names[i], names[j], float(matrix[i, j])) for i in range(len(names)) for j in range(i)]
    return [pair for pair in pairs if abs(pair[2]) >= least and math.isfinite(pair[2])]
