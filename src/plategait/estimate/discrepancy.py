"""Model error: how far the curve of the same object by other models lies from ours, as part of what is not known.

No law of friction or lattice is an object. What another law, or joints that resist twisting, would do to the measured
curve is found by running them at parameters that fit. Any amount of each change is then allowed for, normal about none
(after Kennedy and O'Hagan, 2001, with shapes that physics gives); what is left is a scatter of its own.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.estimate.candidates import USUAL_ACCELERATION
from plategait.estimate.observations import Condition
from plategait.estimate.runs import EngineRuns
from plategait.model.scenario import Scenario

Change = Callable[[Scenario], Scenario]

OWN_SLIDING, OWN_WALKING = 0.02, 0.055
"""Relative scatter of the rates that no alternative gives, of slow sliding and beyond: what rigid tiles are off by."""
SLIDES_TO = 0.35
"""Share of the usual run-off's angular acceleration up to which an object slides slowly."""
OWN_RUN_OFF = 0.02
"""The same of the run-off's frequency."""
PRESUMED = 0.04
"""Relative scatter of the rates that stands for the other models before any is run: what torsion mostly does."""
# Pairs of runs that stayed, short of which a change is taken from the frequency beside.
LEAST_PAIRS = 6
# Rates near 0 change by any factor, which says nothing.
LARGEST_FALL, LARGEST_RISE = -0.6, 1.5
# Run-offs that move by a larger share of their frequency are another island of stability's.
LARGEST_SHIFT = 0.1
# Of the slopes, in pairs of runs: what few runs say is taken as the same everywhere.
RIDGE = 0.1


@dataclass(frozen=True)
class Alternative:
    """Another model of the same object.

    Attributes
    ----------
    name, label : str
        For programs and people.
    applied : callable
        From a scenario of ours to that of the other model.
    """

    name: str
    label: str
    applied: Change


def _other_friction(scenario: Scenario) -> Scenario:
    law = "adams" if scenario.friction.law == "thesis" else "thesis"
    return scenario.replace(**{"friction.law": law})


def _with_torsion(scenario: Scenario) -> Scenario:
    """Joints that resist twisting as they resist bending, or not at all where they do; ω_n stays."""
    sheet = scenario.sheet
    torsion = 0.0 if sheet.torsion_stiffness else sheet.bending_stiffness
    twisted = sheet.replace(torsion_stiffness=torsion)
    return scenario.replace(sheet=twisted.with_natural_frequency(sheet.natural_frequency))


ALTERNATIVES = (
    Alternative("torsion", "joints that resist twisting", _with_torsion),
    Alternative("friction_law", "the other law of friction", _other_friction),
)
WITHIN_THE_LAW = ALTERNATIVES[:1]
"""Those with the scenario's own law of friction, which a few rates cannot tell from another friction angle."""


@dataclass(frozen=True, eq=False)
class Discrepancy:
    """What other models change, by alternative.

    Attributes
    ----------
    alternatives : tuple of Alternative
    coefficients : (k, d + 1, c) array
        Of the relative change of each column of the runs: at `centre`, and its slope by each parameter's share.
    centre : (d,) array
        Parameters about which the change was learnt, as shares of their priors.
    scatter : (c,) array
        What other models change beyond that at each condition, relative: the shapes' own errors, and `own_scatter`.
    run_offs : dict
        By amplitude, how far the run-off's frequency may be off, Hz.
    share : float
        Standard deviation of the amount of each change that is allowed for; 0 takes our model as right.
    """

    alternatives: tuple[Alternative, ...]
    coefficients: Array
    centre: Array
    scatter: Array
    run_offs: dict[Condition, float]
    share: float

    @property
    def own(self) -> Array:
        """Relative scatter (c,) of each rate by itself."""
        return self.share * self.scatter

    def changes(self, u: Array) -> Array:
        """Relative changes (n, k, c) of the rates at parameters (n, d), one standard deviation of their amounts."""
        changes = np.einsum("nt,ktc->nkc", _terms(u - self.centre), self.coefficients)
        return self.share * np.clip(changes, LARGEST_FALL, LARGEST_RISE)

    def run_off(self, amplitude: Condition) -> float:
        """Standard deviation of the run-off's frequency, Hz."""
        return self.share * self.run_offs[amplitude]


def measure_discrepancy(
    run: Callable[[Change], EngineRuns],
    own: EngineRuns,
    share: float,
    alternatives: tuple[Alternative, ...] = ALTERNATIVES,
) -> Discrepancy:
    """Run the alternatives beside our own model.

    Parameters
    ----------
    run : callable
        Runs the parameter sets of `own` with a change to each scenario.
    own : EngineRuns
        By our model.
    share : float
        See `Discrepancy`.
    alternatives : tuple of Alternative
        Which are run.
    """
    others = [run(alternative.applied) for alternative in alternatives]
    coefficients, errors = map(np.stack, zip(*(_change(own, other) for other in others), strict=True))
    scatter = np.sqrt(_own(own) ** 2 + np.sum(errors**2, axis=0))
    amplitudes = dict.fromkeys(c.amplitude for c in own.conditions)
    run_offs = {a: math.hypot(*(_shift(own, other, a) for other in others), _own_run_off(own, a)) for a in amplitudes}
    return Discrepancy(alternatives, coefficients, own.u.mean(axis=0), scatter, run_offs, share)


def presumed_discrepancy(own: EngineRuns, share: float) -> Discrepancy:
    """What to allow for while it is not yet known where the data are likely: a scatter of no shape."""
    amplitudes = dict.fromkeys(c.amplitude for c in own.conditions)
    scatter = np.hypot(_own(own), PRESUMED)
    return Discrepancy((), np.zeros((0, own.u.shape[1] + 1, len(scatter))), own.u.mean(axis=0), scatter,
                       {a: _own_run_off(own, a) for a in amplitudes}, share)  # fmt: skip


def own_scatter(condition: Condition) -> float:
    """Relative scatter of the rate under a motion that no alternative gives: models differ more in how it walks."""
    acceleration = condition.angle * (math.tau * condition.frequency) ** 2
    return OWN_SLIDING if acceleration < SLIDES_TO * USUAL_ACCELERATION else OWN_WALKING


def _own(runs: EngineRuns) -> Array:
    """(c,) the same of each column of the runs."""
    each = np.array([own_scatter(c) for c in runs.conditions])
    return np.tile(each, runs.columns().shape[1] // len(each))


def _terms(off: Array) -> Array:
    """(n, d + 1) one, and how far the parameters are off the middle (n, d)."""
    return np.column_stack([np.ones(len(off)), off])


def _change(own: EngineRuns, other: EngineRuns) -> tuple[Array, Array]:
    """Coefficients (d + 1, c) of the relative change of each column of the runs, and their error (c,).

    Where few stayed, those of the frequency beside.
    """
    terms = _terms(own.u - own.u.mean(axis=0))
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.clip(other.columns() / own.columns() - 1, LARGEST_FALL, LARGEST_RISE)
    coefficients, error = np.zeros((terms.shape[1], ratio.shape[1])), np.zeros(ratio.shape[1])
    known = np.isfinite(ratio).sum(axis=0) >= LEAST_PAIRS
    ridge = np.diag([1e-6, *[RIDGE] * own.u.shape[1]])
    for c in np.flatnonzero(known):
        stayed = np.isfinite(ratio[:, c])
        x, y = terms[stayed], ratio[stayed, c]
        hat = np.linalg.solve(x.T @ x + ridge, x.T)
        coefficients[:, c] = hat @ y
        freedom = max(len(y) - float(np.trace(x @ hat)), 1.0)
        error[c] = math.sqrt(float(np.sum((y - x @ coefficients[:, c]) ** 2)) / freedom)
    beside = _beside(own, known)
    return coefficients[:, beside], error[beside]


def _beside(runs: EngineRuns, known: NDArray[np.bool_]) -> NDArray[np.int64]:
    """The known column (c,) of the same quantity and amplitude that is nearest in frequency; itself where none is."""
    beside = np.arange(len(known))
    conditions = runs.conditions
    for column in np.flatnonzero(~known):
        quantity, i = divmod(int(column), len(conditions))
        near = [
            (abs(c.frequency - conditions[i].frequency), quantity * len(conditions) + j)
            for j, c in enumerate(conditions)
            if known[quantity * len(conditions) + j] and c.amplitude == conditions[i].amplitude
        ]
        beside[column] = min(near)[1] if near else column
    return beside


def _middles(runs: EngineRuns, amplitude: Condition) -> Array:
    """Middle (n,) of the bracket in which each set's run-off lies, Hz; NaN where there is none."""
    low, high = runs.brackets(amplitude)
    return np.where((low > 0) & np.isfinite(high), 0.5 * (low + high), math.nan)


def _own_run_off(own: EngineRuns, amplitude: Condition) -> float:
    middles = _middles(own, amplitude)
    return OWN_RUN_OFF * float(np.nanmedian(middles)) if np.isfinite(middles).any() else 0.0


def _shift(own: EngineRuns, other: EngineRuns, amplitude: Condition) -> float:
    """Mean change of the run-off's frequency, Hz, over the sets in which both models bracket it; 0 where none do."""
    before, after = _middles(own, amplitude), _middles(other, amplitude)
    both = np.isfinite(before + after)
    if not both.any():
        return 0.0
    largest = LARGEST_SHIFT * before[both]  # beyond it lie islands
    return float(np.mean(np.clip((after - before)[both], -largest, largest)))
