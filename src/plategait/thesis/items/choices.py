"""Modelling choices that the source leaves open, and how much each moves the results."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait import published
from plategait.thesis.cases import FIT_FROM, VARIANTS, Case, fitted_cases
from plategait.thesis.fits import published_curves
from plategait.thesis.item import Cell, Item, Spec, Table
from plategait.thesis.regressions import regress
from plategait.thesis.runs import CaseRuns, Results, value_of

WEIGHED = (Case(3, 10.0), Case(3, 33.0), Case(12, 1.4), Case(12, 10.0))
"""Curves on which each choice is weighed: soft and stiff at both amplitudes, α = 36.87 deg."""

_LEFT_OPEN = {
    "half step": "no choice: what the time step itself moves",
    "plate on its axis": "the height of the surface over the axis is not printed; it is inferred",
    "plate at 12 mm": "the same",
    "printed damping": "the damping that the source's implicit solver added is not reported; c_b is inferred",
    "smooth friction": "(3.2) is printed, but the source's solver is known for a smooth law",
    "one friction": "β = 0.53 is printed; shown for its weight",
    "damped torsion": "torsion is left free and undamped in section 3.2.2; a real sheet's is not",
    "slow start": "how the motion starts is not printed; 0.1 s is used",
    "dish mode": "the source calls Table 4.1's sheet 10π; its own model would have to say",
    "soft impact": "(3.1) has no ramp; the source's solver ramps its damping over a depth",
}


def choice_cases() -> list[Case]:
    """Cases that the page needs."""
    return [*fitted_cases(), *(case.but(variant) for case in WEIGHED for variant in VARIANTS)]


_COLUMNS = (
    "choice",
    "why it is open",
    "curve",
    "Δf0 (%)",
    "Δ(b/f0) (%)",
    "Δω_Br max (%)",
    "stable frequencies more",
)
_NUMBERS = ("f0_hz", "b_over_f0", "peak")


@dataclass(frozen=True)
class _Effect:
    """What one choice made otherwise does to one curve.

    Attributes
    ----------
    variant : str
    case : Case
        The curve as it is made.
    change : tuple of float
        Of `_NUMBERS`, percent; NaN without a fit.
    stable : int
        Frequencies that it stays on the plate at, beyond those of the base.
    """

    variant: str
    case: Case
    change: tuple[float, ...]
    stable: int

    @property
    def of_width(self) -> float:
        """Size of the change of b/f0, percent; 0 without a fit."""
        return float(abs(np.nan_to_num(self.change[1])))

    @property
    def row(self) -> tuple[Cell, ...]:
        """Row of the table."""
        return (
            VARIANTS[self.variant],
            _LEFT_OPEN[self.variant],
            f"{self.case.angle_deg:g} deg, {self.case.omega_pi:g}π",
            *(round(x, 1) if math.isfinite(x) else None for x in self.change),
            self.stable,
        )


def choices(spec: Spec, results: Results) -> Item:
    """Table of the choices: change of f0, b/f0 and peak on each weighed curve."""
    effects = [_effect(results, variant, case) for variant in VARIANTS for case in WEIGHED]
    return spec.item(
        remark=_largest(effects),
        tables=[Table("choices", _COLUMNS, tuple(effect.row for effect in effects)), _ways_of_fitting(results)],
        notes=[
            "Each choice is made otherwise alone, on four curves, from the same two starts as the base.",
            "Run length and limit of drift are not printed as a pair: here 1.6 s, the first 0.6 s unmeasured, and 20 "
            "mm; the second table has the source's 10 mm.",
            "Where the fit starts is not printed either, and matters: a Lorentzian has no onset, the object has one.",
        ],
    )


def _effect(results: Results, variant: str, case: Case) -> _Effect:
    other = results[case.but(variant)]
    base = results[case].first_starts(len(other.observations[0]))
    change = tuple(100 * (value_of(other.fit, name) / value_of(base.fit, name) - 1) for name in _NUMBERS)
    return _Effect(variant, case, change, int(other.curve.fitted.sum()) - int(_same_range(base, other).sum()))


def _largest(effects: list[_Effect]) -> str:
    """What moves the results most, in a line."""
    largest = max((e for e in effects if e.variant != "half step"), key=lambda e: e.of_width)
    halved = [e.row for e in effects if e.variant == "half step"]
    f0, width = (max(abs(float(row[column] or 0)) for row in halved) for column in (3, 4))
    return (
        f"The largest, {VARIANTS[largest.variant]}, moves b/f0 by {largest.of_width:.0f} %; halving the step moves f0 "
        f"by at most {f0:.1f} % and b/f0 by {width:.1f} %."
    )


def _same_range(base: CaseRuns, other: CaseRuns) -> NDArray[np.bool_]:
    """Stable frequencies of the base among those that the other was run at."""
    frequencies = np.array(base.case.frequencies)
    return base.curve.fitted & np.isin(frequencies, other.case.frequencies)


_WAYS = (
    ("as reported", FIT_FROM, False),
    ("limit of drift 10 mm instead of 20 mm", FIT_FROM, True),
    ("from 17 Hz at 3 deg instead of 13 Hz", FIT_FROM | {3: 17.0}, False),
    ("from 10 Hz at 12 deg instead of 9 Hz", FIT_FROM | {12: 10.0}, False),
)
"""Ways of fitting: in words, lowest frequency (Hz) by A_p, and whether the source's own limit of drift holds."""


def _ways_of_fitting(results: Results) -> Table:
    """All 44 fits made otherwise: from another frequency, with the source's limit of drift."""
    columns = (
        "way of fitting",
        "median |Δf0| (%)",
        "median |Δ(b/f0)| (%)",
        "R² of ω_n on f0, 3 deg",
        "R² of α on b/f0, 3 deg",
        "R² of ω_n on f0, 12 deg",
        "R² of α on b/f0, 12 deg",
    )
    rows = tuple((words, *_deviations(results, start, strict)) for words, start, strict in _WAYS)
    return Table("fitting", columns, rows)


def _deviations(results: Results, start: dict[int, float], strict: bool) -> tuple[float, ...]:
    """Median |Δf0| and |Δ(b/f0)| in percent, and R² of both regressions at each amplitude, of one way of fitting."""
    f0: list[float] = []
    width: list[float] = []
    r2: list[float] = []
    for angle in published.AMPLITUDES:
        curves = published_curves(angle)
        refits = [results[Case(angle, c.omega_pi, c.alpha_deg)].refit(start[angle], strict) for c in curves]
        ours_f0, ours_width = (np.array([value_of(fit, name) for fit in refits]) for name in ("f0_hz", "b_over_f0"))
        f0 += list(np.abs(ours_f0 / np.array([c.f0_hz for c in curves]) - 1))
        width += list(np.abs(ours_width / np.array([c.b_over_f0 for c in curves]) - 1))
        r2.append(regress(ours_f0, [c.omega_pi for c in curves]).r2)
        r2.append(regress(ours_width, [c.alpha_deg for c in curves]).r2)
    return 100 * float(np.nanmedian(f0)), 100 * float(np.nanmedian(width)), *r2
