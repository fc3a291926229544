"""Estimates: what a measured spin curve says of the object, ready to print, store and simulate with."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, TypedDict

import numpy as np

from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.curve.curve_file import as_curve
from plategait.curve.protocol import USUAL, Protocol, measured_as
from plategait.errors import InputError
from plategait.estimate.assumptions import Assumption, assumptions
from plategait.estimate.goodness import Goodness, goodness_of_fit
from plategait.estimate.handling import handling_of
from plategait.estimate.identifiability import CONFIDENCE, Marginal, marginal_of
from plategait.estimate.observations import observe_curves
from plategait.estimate.posterior import Posterior, estimate_posterior
from plategait.estimate.stiffness import bending_stiffness, stiffness_of
from plategait.estimate.unknowns import unknowns
from plategait.files.plain import plain
from plategait.model.fragment import Fragment
from plategait.model.measured import Measured
from plategait.model.motion import PlateMotion
from plategait.model.presets import Preset, as_scenario
from plategait.model.scenario import Scenario
from plategait.shown import Shown
from plategait.simulation.run import check_whole
from plategait.units import Quantity

_SHARE = Quantity("", "", "0.9")
_MODEL_ERROR = Quantity("", "", "1", at_least=0, at_most=10)

LABELS = {
    "natural_frequency": "natural frequency ω_n",
    "friction_angle": "friction angle α",
    "friction_ratio": "β = μ_k/μ_s",
    "mass": "mass over that told",
    "bending_damping": "c_b over that told",
    "plate_height": "plate above its axis",
    "contact_damping": "contact damping over that told",
    "bending_stiffness": "bending stiffness k_b",
    "plate_stiffness": "plate stiffness D",
    "youngs_modulus": "Young's modulus E",
}
"""What people call each number of an estimate."""


@dataclass(frozen=True, eq=False, repr=False)
class Estimate(Shown):
    """Parameters of an object, read off its spin curve.

    Source: docs/estimation.md says how it is made, and how often its intervals hold.

    Attributes
    ----------
    posterior : Posterior
    marginals : tuple of Marginal
        One for each parameter; see `Marginal.verdict` before using its numbers.
    goodness : Goodness
    confidence : float
        Of the intervals.
    thickness_sd : float
        How well the scenario's thickness is known, m: Young's modulus goes with its third power.
    """

    posterior: Posterior
    marginals: tuple[Marginal, ...]
    goodness: Goodness
    confidence: float
    thickness_sd: float = 0.0

    def told(self) -> list[tuple[str, str]]:
        """Each parameter with its interval, and whether the data are explained."""
        rows = [
            (m.parameter.name.replace("_", " "), f"{m.text} ({m.interval_text})" if m.determined else m.text)
            for m in (*self.marginals, *self.stiffness[1:])
        ]
        said = "yes" if self.goodness.explained else f"no: {'; '.join(self.goodness.complaints)}"
        return [*rows, ("intervals", f"{100 * self.confidence:g} %"), ("data explained", said)]

    def __getitem__(self, name: str) -> Marginal:
        """Marginal posterior of one parameter by name."""
        return next(m for m in self.marginals if m.parameter.name == name)

    @cached_property
    def correlation(self) -> Array:
        """(d, d) correlation of the parameters."""
        return np.atleast_2d(np.corrcoef(self.posterior.u, rowvar=False))

    @cached_property
    def stiffness(self) -> tuple[Marginal, ...]:
        """k_b, plate stiffness and Young's modulus; none where the natural frequency is not sought."""
        posterior = self.posterior
        omega = next((m for m in self.marginals if m.parameter.name == "natural_frequency"), None)
        if omega is None:
            return ()
        return stiffness_of(posterior.unknowns, posterior.values, omega, self.confidence, self.thickness_sd)

    @property
    def assumed(self) -> tuple[Assumption, ...]:
        """What of the set-up the numbers rest on."""
        data = self.posterior.data
        return assumptions(self.posterior.unknowns, data.conditions, self.thickness_sd, data.handling)

    @property
    def answered(self) -> bool:
        """Whether the data are explained and determine at least one parameter."""
        return self.goodness.explained and any(m.determined for m in self.marginals)

    @property
    def model_error(self) -> dict[str, Any] | None:
        """What was allowed for, and how much of it the data take: plain numbers; None where the model is right."""
        likelihood, full = self.posterior.likelihood, self.posterior.full
        discrepancy = likelihood.discrepancy
        if discrepancy is None:
            return None
        draws = full[:: max(1, len(full) // 500)]
        taken = np.median(likelihood.deviations(draws)[1], axis=0).tolist()
        rates = discrepancy.changes(likelihood.split(draws)[0])[:, :, : len(self.posterior.data.conditions)]
        sizes = np.sqrt(np.mean(rates**2, axis=(0, 2))).tolist()
        changes = [
            {"instead": a.name, "label": a.label, "rates": size, "taken": amount}
            for a, size, amount in zip(discrepancy.alternatives, sizes, taken, strict=True)
        ]
        own = float(np.median(discrepancy.own[: len(self.posterior.data.conditions)]))
        return {"share": discrepancy.share, "changes": changes, "own": own}

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`; numbers that the gate withholds are None."""
        goodness = self.goodness
        return {
            "method": "posterior",
            "confidence": self.confidence,
            "parameters": {m.parameter.name: m.summary() for m in self.marginals},
            "stiffness": {m.parameter.name: m.summary() for m in self.stiffness},
            "assumed": {a.name: a.summary() for a in self.assumed},
            "correlation": {
                "between": [m.parameter.name for m in self.marginals],
                "matrix": self.correlation.tolist(),
            },
            "explained": goodness.explained,
            "complaints": list(goodness.complaints),
            "chi2": plain(goodness.chi2),
            "inliers": goodness.inliers,
            "p": plain(goodness.p),
            "p_runs": plain(goodness.p_runs),
            "noise": plain(goodness.noise),
            "outliers_hz": list(goodness.outliers),
            "outlying_readings": list(goodness.outlying_readings),
            "readings": {r.name: len(r.value) for r in self.posterior.data.readings},
            "model_error": self.model_error,
            "notes": list(self.posterior.data.notes),
            "points": len(self.posterior.data.which),
            "runs": int(self.posterior.runs.rates.size),
        }

    def to_fragment(self) -> Fragment:
        """Scenario fragment of what the data determine, with intervals and correlations.

        Where the data are not explained, its source says so and why.

        Raises
        ------
        InputError
            When they determine nothing that a scenario has.
        """
        columns = self._scenario_values()
        if not columns:
            raise InputError("--out", "nothing that the data determine", "a curve that says more",
                             "plategait estimate CURVE.csv --next")  # fmt: skip
        tail = (1 - self.confidence) / 2
        parameters = {
            name: Measured(float(np.median(x)), float(np.std(x)), *map(float, np.quantile(x, [tail, 1 - tail])))
            for name, x in columns.items()
        }
        correlation = np.atleast_2d(np.corrcoef(np.stack(list(columns.values()))))
        source = "plategait estimate, posterior of a spin curve"
        if not self.goodness.explained:
            source += f"; NOT TO BE RELIED ON, as no parameters explain it: {'; '.join(self.goodness.complaints)}"
        return Fragment(parameters, correlation, self.confidence, source, tuple(self._remarks()))

    def _remarks(self) -> Iterator[str]:
        """What to know beside the numbers of a fragment, in lines."""
        for m in self.stiffness[1:]:
            interval = f" ({m.interval_text}, {100 * self.confidence:g} %)" if m.determined else ""
            yield f"{LABELS[m.parameter.name]}: {m.text}{interval}"
        for a in self.assumed:
            yield f"assumed: {a.label} {a.text}"

    def _scenario_values(self) -> dict[str, Array]:
        """Samples (n,) of the scenario's fields that the determined parameters set, SI, by dotted name.

        The plate's height is the set-up's and no property of the object. c_b goes with the stiffness whether it is
        determined or not: their errors are tied to each other.
        """
        posterior, base = self.posterior, self.posterior.unknowns.base
        sought = {m.parameter.name: posterior.values[:, i] for i, m in enumerate(self.marginals)}
        sampled = {name: x for name, x in sought.items() if self[name].determined}
        columns: dict[str, Array] = {}
        if "mass" in sampled:
            columns["sheet.mass"] = base.sheet.mass * sampled["mass"]
        if "natural_frequency" in sampled:
            columns["sheet.bending_stiffness"] = bending_stiffness(posterior.unknowns, posterior.values)
        if "bending_damping" in sampled or ("natural_frequency" in sampled and "bending_damping" in sought):
            columns["sheet.bending_damping"] = base.sheet.bending_damping * sought["bending_damping"]
        if "friction_angle" in sampled:
            columns["friction.static"] = np.tan(sampled["friction_angle"])
            if "friction_ratio" in sampled:
                columns["friction.kinetic"] = columns["friction.static"] * sampled["friction_ratio"]
        if "contact_damping" in sampled:
            columns["contact.damping"] = base.contact.damping * sampled["contact_damping"]
        return columns


class EstimateOptions(TypedDict, total=False):
    """What `estimate_parameters` takes beside curves, scenario and motions."""

    noise: float | None
    friction_ratio: float | None
    free: tuple[str, ...]
    fixed: tuple[str, ...]
    measured: dict[str, tuple[float, float]]
    thickness_sd: float
    confidence: float
    ramp: float | None
    model_error: float
    any_law: bool
    friction_scatter: float | str
    seed: int


def estimate_parameters(
    curves: Curve | Path | str | Sequence[Curve | Path | str],
    scenario: Scenario | Preset | Path | str,
    *,
    motions: Sequence[PlateMotion] | None = None,
    noise: float | None = None,
    friction_ratio: float | None = None,
    free: Sequence[str] = (),
    fixed: Sequence[str] = (),
    measured: Mapping[str, tuple[float, float]] | None = None,
    thickness_sd: float = 0.0,
    confidence: float = CONFIDENCE,
    ramp: float | None = None,
    model_error: float = 1.0,
    any_law: bool = False,
    friction_scatter: float | str = 0.0,
    seed: int = 0,
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> Estimate:
    """Read an object's natural frequency and friction off its spin curve: (5.6), (5.7) or docs/estimation.md.

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
        What else is unknown: "mass", "contact_damping".
    fixed : sequence of str
        Parameters that are not sought: "bending_damping", "plate_height", "natural_frequency", "friction_angle".
    measured : mapping of str to (value, sd), optional
        What is known from elsewhere of "plate_height" (m) or of "bending_damping" (as a factor on the scenario's).
    thickness_sd : float
        How well the scenario's thickness is known, m, for Young's modulus.
    confidence : float
        Of the intervals.
    ramp : float, optional
        Time in which the plate comes to its full swing, s. Not known if left out, whatever the scenario says: where an
        object runs off depends on it.
    model_error : float
        How far the model may be off: 1 as far as other models, 0 not at all. See `plategait.estimate.discrepancy`.
    any_law : bool
        Whether the law of friction may be another than the scenario's, too: the intervals grow several times.
    friction_scatter : float or str
        Standard deviation of the friction angle from point to point, rad, or text such as "3 deg": food's wanders.
    seed : int
        Of the sampling: the same data and seed give the same estimate.
    threads : int, optional
        Cores for the engine; all by default. The same estimate with any.
    progress : callable, optional

    Raises
    ------
    InputError
        For too few or too many points, or options out of range.
    """
    curves = _read_curves(curves)
    scenario = as_scenario(scenario)
    free, fixed = ([name] if isinstance(name, str) else name for name in (free, fixed))
    confidence, noise = _read_confidence(confidence), _read_noise(noise)
    model_error = _read_model_error(model_error, any_law)
    check_whole("seed", seed, 0, 2**63 - 1)
    given = _read_motions(motions, len(curves)) or [scenario.motion] * len(curves)
    scenario, motions = _at_height_of(curves, scenario, given)
    data = observe_curves(curves, motions, handling_of(ramp, friction_scatter, fixed))
    scenario = _observed_as(scenario, curves)
    parameters = unknowns(scenario, free=free, friction_ratio=friction_ratio, fixed=fixed, measured=measured)
    posterior = estimate_posterior(data, parameters, noise=noise, model_error=model_error, any_law=any_law,
                                   seed=seed, threads=threads, progress=progress)  # fmt: skip
    marginals = tuple(marginal_of(p, posterior.u[:, i], confidence) for i, p in enumerate(parameters.parameters))
    return Estimate(posterior, marginals, goodness_of_fit(posterior), confidence, thickness_sd)


def _read_curves(curves: Curve | Path | str | Iterable[Curve | Path | str]) -> list[Curve]:
    alone = isinstance(curves, (Curve, str, Path)) or not isinstance(curves, Iterable)
    return [as_curve(c) for c in ([curves] if alone else curves)]  # type: ignore[union-attr]


def _read_motions(motions: Sequence[PlateMotion] | None, count: int) -> Sequence[PlateMotion] | None:
    if motions is None:
        return None
    if isinstance(motions, str) or not isinstance(motions, Sequence):
        raise InputError("motions", motions if isinstance(motions, str) else f"a {type(motions).__name__}",
                         "a list of plate motions, one for each curve", "[scenario.motion]")  # fmt: skip
    if len(motions) != count:
        raise InputError("motions", f"{len(motions)} of them", f"one for each of {count} curves", "[scenario.motion]")
    return motions


def _read_confidence(value: float) -> float:
    confidence = _SHARE.read(value, "confidence")
    if not 0.5 <= confidence < 1:
        raise InputError("confidence", confidence, "at least 0.5 and below 1", "0.9")
    return confidence


def _observed_as(scenario: Scenario, curves: Sequence[Curve]) -> Scenario:
    """Scenario run as long, and up to the slip, that most points of the curves were, where they tell it."""
    told = [
        np.concatenate([x for x in columns if x is not None] or [np.zeros(0)])
        for columns in ([c.duration for c in curves], [c.slip_limit for c in curves])
    ]
    duration, limit = (
        float(f"{np.nanmedian(x):.2g}") if np.isfinite(x).any() else default
        for x, default in zip(told, (scenario.duration, scenario.slip_limit), strict=True)
    )
    if (duration, limit) == (scenario.duration, scenario.slip_limit):
        return scenario
    return measured_as(scenario, Protocol(duration, USUAL.transient, limit))


def _read_model_error(value: float, any_law: bool) -> float:
    model_error = _MODEL_ERROR.read(value, "model_error")
    if any_law and not model_error:
        raise InputError("any_law", "another law of friction, with a model that is taken as right",
                         "a model error above 0", "--model-error 1")  # fmt: skip
    return model_error


def _at_height_of(
    curves: Sequence[Curve], scenario: Scenario, motions: Sequence[PlateMotion]
) -> tuple[Scenario, list[PlateMotion]]:
    """Scenario and motions with the plate at the median height that the curves tell, if any does."""
    told = np.concatenate([np.zeros(0), *(c.height for c in curves if c.height is not None)])
    if not np.isfinite(told).any():
        return scenario, list(motions)
    height = float(np.nanmedian(told))
    return scenario.replace(**{"motion.height": height}), [m.replace(height=height) for m in motions]


def _read_noise(value: float | None) -> float | None:
    if value is None:
        return None
    noise = _SHARE.read(value, "noise")
    if not 0.001 <= noise <= 1:
        raise InputError("noise", noise, "at least 0.001 and at most 1 (0.05 for 5 %)", "0.05")
    return noise


def correlated(estimate: Estimate, least: float = 0.7) -> list[tuple[str, str, float]]:
    """Pairs of parameters whose errors go together, with their correlation."""
    names, matrix = [m.parameter.name for m in estimate.marginals], estimate.correlation
    pairs = [(names[i], names[j], float(matrix[i, j])) for i in range(len(names)) for j in range(i)]
    return [pair for pair in pairs if abs(pair[2]) >= least and math.isfinite(pair[2])]
