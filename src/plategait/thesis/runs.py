"""One batch of simulations for all figures and tables, shared between them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.curve.quick_lorentz import Shape, fit_shape
from plategait.curve.spin_curve import curve_of
from plategait.simulation.observation import Observation, observe
from plategait.simulation.result import Simulation
from plategait.simulation.run import simulate_all
from plategait.thesis.cases import FIT_FROM, Case, fitted_cases

# Runs side by side: more only takes memory, as each brings its samples.
BATCH = 400
STRICT_SLIP_LIMIT = 0.01
"""The source's own limit of drift, m."""


@dataclass(frozen=True, eq=False)
class CaseRuns:
    """What the runs of one case show.

    Attributes
    ----------
    case : Case
    observations : tuple of tuples of Observation
        By frequency, then by start.
    strict : same
        With the source's own limit of drift; of the fitted cases only.
    """

    case: Case
    observations: tuple[tuple[Observation, ...], ...]
    strict: tuple[tuple[Observation, ...], ...]

    @cached_property
    def curve(self) -> Curve:
        """Mean over the starts."""
        return curve_of(self.case.label, self.case.frequencies, self.observations)

    @property
    def fit_from(self) -> float:
        """Lowest frequency that the fit uses, Hz."""
        return FIT_FROM.get(int(self.case.angle_deg), 0.0)

    @cached_property
    def fit(self) -> Shape | None:
        """Lorentz fit of the mean curve below its run-off."""
        return _fit(self.curve, self.fit_from)

    def refit(self, fit_from: float, strict: bool = False) -> Shape | None:
        """Fit made otherwise: from another frequency, or with the source's own limit of drift."""
        curve = curve_of(self.case.label, self.case.frequencies, self.strict) if strict else self.curve
        return _fit(curve, fit_from)

    @cached_property
    def member_fits(self) -> tuple[Shape | None, ...]:
        """Fit of each start by itself: how far chaos carries the numbers."""
        members = ([(o[m],) for o in self.observations] for m in range(len(self.observations[0])))
        curves = (curve_of(self.case.label, self.case.frequencies, member) for member in members)
        return tuple(_fit(curve, self.fit_from) for curve in curves)

    def member_spread(self, name: str) -> float:
        """Standard deviation over the starts of "f0_hz", "half_width_hz", "peak" or "b_over_f0"."""
        values = [value_of(fit, name) for fit in self.member_fits if fit is not None]
        return float(np.std(values, ddof=1)) if len(values) > 1 else math.nan

    def first_starts(self, count: int) -> CaseRuns:
        """Same case with the first `count` starts only."""
        return CaseRuns(self.case, tuple(o[:count] for o in self.observations), tuple(o[:count] for o in self.strict))

    @property
    def acceleration(self) -> Array:
        """A_p ω_p² at each frequency, 10⁴ deg/s²."""
        return self.case.angle_deg * (math.tau * np.array(self.case.frequencies)) ** 2 / 1e4

    @property
    def best_frequency(self) -> float:
        """Plate frequency of the highest rate below the run-off, Hz; NaN where nothing stays on the plate."""
        return float(self.curve.frequency_hz[self.best]) if self.best >= 0 else math.nan

    @property
    def best_rate(self) -> float:
        """Highest rate below the run-off, deg/s; NaN where nothing stays on the plate."""
        return float(self.curve.spin_rate_deg_s[self.best]) if self.best >= 0 else math.nan

    @property
    def best_sd(self) -> float:
        """Spread of that rate over the starts, deg/s."""
        return float(self.curve.spin_rate_sd_deg_s[self.best]) if self.best >= 0 else math.nan

    @property
    def best(self) -> int:
        """Index of the highest rate below the run-off, -1 where nothing stays on the plate."""
        rates = np.where(self.curve.fitted, self.curve.spin_rate_deg_s, -math.inf)
        return int(np.argmax(rates)) if np.isfinite(rates).any() else -1


def value_of(fit: Shape | None, name: str) -> float:
    """Number of a fit by name; NaN where there is no fit."""
    return math.nan if fit is None else float(getattr(fit, name))


def _fit(curve: Curve, fit_from: float) -> Shape | None:
    used = curve.fitted & (curve.frequency_hz >= fit_from)
    return fit_shape(curve.frequency_hz[used], curve.spin_rate_deg_s[used], ends_in_failure=curve.ends_in_failure)


@dataclass(frozen=True, eq=False)
class Results:
    """All runs by case."""

    runs: dict[Case, CaseRuns]
    repeats: int
    simulated: float

    def __getitem__(self, case: Case) -> CaseRuns:
        """Runs of one case."""
        return self.runs[case]

    def effect(self, case: Case, variant: str, name: str) -> float:
        """Change of a fit's number when one modelling choice is made differently, from the same starts."""
        other = self.runs.get(case.but(variant))
        if other is None:
            return math.nan
        base = self.runs[case].first_starts(len(other.observations[0]))
        return value_of(other.fit, name) - value_of(base.fit, name)


def run_cases(
    cases: Iterable[Case], *, repeats: int, seed: int, progress: Callable[[float], object] | None = None
) -> Results:
    """Simulate every frequency of every case, each case once.

    Parameters
    ----------
    cases : iterable of Case
    repeats : int
        Slightly different starts of each. Departures from the presets, which are only compared, take two at most.
    seed : int
        Of the starts.
    progress : callable, optional
        Called with the fraction done.
    """
    distinct = sorted(set(cases))
    total = sum(_cost(case, repeats) for case in distinct) or 1.0
    runs: dict[Case, CaseRuns] = {}
    simulated = done = 0.0
    for batch in _batches(distinct, repeats):
        share = sum(_cost(case, repeats) for case in batch) / total
        report = None if progress is None else (lambda x, d=done, s=share, p=progress: p(d + s * x))
        for case, simulations in _run_batch(batch, _repeats(batch[0], repeats), seed, report):
            simulated += sum(s.simulated for s in simulations)
            runs[case] = _gather(case, simulations)
        done += share
    return Results(runs, repeats, simulated)


def _run_batch(
    batch: list[Case], repeats: int, seed: int, progress: Callable[[float], object] | None
) -> Iterable[tuple[Case, list[Simulation]]]:
    """Simulations of each case by frequency, all run together."""
    scenarios = [case.scenario.replace(**{"motion.frequency": float(f)}) for case in batch for f in case.frequencies]
    simulations = iter(simulate_all(scenarios, repeats=repeats, seed=seed, progress=progress))
    for case in batch:
        yield case, [next(simulations) for _ in case.frequencies]


def _gather(case: Case, simulations: list[Simulation]) -> CaseRuns:
    """What the runs of a case show; of a fitted one also with the source's own limit of drift."""
    observations = tuple(s.observations for s in simulations)
    if case not in fitted_cases():
        return CaseRuns(case, observations, observations)
    strict = tuple(
        tuple(observe(s.scenario.replace(slip_limit=STRICT_SLIP_LIMIT), r) for r in s.recordings) for s in simulations
    )
    return CaseRuns(case, observations, strict)


def _repeats(case: Case, repeats: int) -> int:
    return min(repeats, 2) if case.variant and not case.variant.startswith("damping") else repeats


def _cost(case: Case, repeats: int) -> float:
    return len(case.frequencies) * _repeats(case, repeats)


def _batches(cases: list[Case], repeats: int) -> Iterable[list[Case]]:
    """Cases of the same number of starts, at most `BATCH` runs together."""
    for starts in sorted({_repeats(case, repeats) for case in cases}):
        batch: list[Case] = []
        for case in (c for c in cases if _repeats(c, repeats) == starts):
            if batch and sum(_cost(c, repeats) for c in batch) + _cost(case, repeats) > BATCH:
                yield batch
                batch = []
            batch.append(case)
        if batch:
            yield batch
