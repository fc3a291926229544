"""Modelling choices that the source leaves open, and how much each moves the results."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from plategait import published
from plategait.thesis.cases import FIT_FROM, VARIANTS, Case, fitted_cases
from plategait.thesis.item import Cell, Item, Spec, Table
from plategait.thesis.regressions import regress
from plategait.thesis.runs import CaseRuns, Results, value_of

WEIGHED = (Case(3, 10.0), Case(3, 33.0), Case(12, 1.4), Case(12, 10.0))
"""Curves on which each choice is weighed: soft and stiff at both amplitudes, α = 36.87 deg."""

_LEFT_OPEN = {
    "half step": "no choice: what the time step itself moves",
    "plate on its axis": "the height of the surface over the axis is not printed; 7 mm is inferred",
    "plate at 12 mm": "the same",
    "printed damping": "the damping that the source's implicit solver added is not reported; ten times c_b is inferred",
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


def choices(spec: Spec, results: Results) -> Item:
    """Table of the choices: change of f0, b/f0 and peak on each weighed curve."""
    rows: list[tuple[Cell, ...]] = []
    largest = ("", 0.0)
    for variant, words in VARIANTS.items():
        for case in WEIGHED:
            other = results[case.but(variant)]
            base = results[case].first_starts(len(other.observations[0]))
            change = {
                n: 100 * (value_of(other.fit, n) / value_of(base.fit, n) - 1) for n in ("f0_hz", "b_over_f0", "peak")
            }
            stays = int(other.curve.fitted.sum()) - int(_same_range(base, other).sum())
            rows.append(
                (
                    words,
                    _LEFT_OPEN[variant],
                    f"{case.angle_deg:g} deg, {case.omega_pi:g}π",
                    *(round(x, 1) if math.isfinite(x) else None for x in change.values()),
                    stays,
                )
            )
            if variant != "half step" and abs(np.nan_to_num(change["b_over_f0"])) > largest[1]:
                largest = (words, abs(change["b_over_f0"]))
    columns = (
        "choice",
        "why it is open",
        "curve",
        "Δf0 (%)",
        "Δ(b/f0) (%)",
        "Δω_Br max (%)",
        "stable frequencies more",
    )
    fits = _ways_of_fitting(results)
    halves = [r for r in rows if r[0] == VARIANTS["half step"]]
    moved = max(abs(float(r[3] or 0)) for r in halves), max(abs(float(r[4] or 0)) for r in halves)
    line = (
        f"The largest, {largest[0]}, moves b/f0 by {largest[1]:.0f} %; halving the step moves f0 by at most "
        f"{moved[0]:.1f} % and b/f0 by {moved[1]:.1f} %."
    )
    return Item(
        spec.name,
        spec.title,
        line,
        tables=(Table("choices", columns, tuple(rows)), fits),
        notes=(
            "Each choice is made otherwise alone, on four curves, from the same two starts as the base.",
            "Run length and limit of drift are not printed as a pair: here 1.6 s, the first 0.6 s unmeasured, and 20 "
            "mm; the second table has the source's 10 mm.",
            "Where the fit starts is not printed either, and matters: a Lorentzian has no onset, the object has one.",
        ),
    )


def _same_range(base: CaseRuns, other: CaseRuns) -> NDArray[np.bool_]:
    """Stable frequencies of the base among those that the other was run at."""
    frequencies = np.array(base.case.frequencies)
    return base.curve.fitted & np.isin(frequencies, other.case.frequencies)


def _ways_of_fitting(results: Results) -> Table:
    """All 44 fits made otherwise: from another frequency, with the source's limit of drift."""
    ways: list[tuple[str, dict[int, float], bool]] = [
        ("as reported", FIT_FROM, False),
        ("limit of drift 10 mm instead of 20 mm", FIT_FROM, True),
        ("from 17 Hz at 3 deg instead of 13 Hz", FIT_FROM | {3: 17.0}, False),
        ("from 10 Hz at 12 deg instead of 9 Hz", FIT_FROM | {12: 10.0}, False),
    ]
    rows: list[tuple[Cell, ...]] = []
    for words, start, strict in ways:
        df0: list[float] = []
        dratio: list[float] = []
        r2: list[float] = []
        for angle in published.AMPLITUDES:
            curves = [c for c in published.curves() if c.angle_deg == angle]
            fits = [results[Case(angle, c.omega_pi, c.alpha_deg)].refit(start[angle], strict) for c in curves]
            f0 = np.array([value_of(f, "f0_hz") for f in fits])
            ratio = np.array([value_of(f, "b_over_f0") for f in fits])
            df0 += list(np.abs(f0 / np.array([c.f0_hz for c in curves]) - 1))
            dratio += list(np.abs(ratio / np.array([c.b_over_f0 for c in curves]) - 1))
            r2.append(regress(f0, [c.omega_pi for c in curves]).r2)
            r2.append(regress(ratio, [c.alpha_deg for c in curves]).r2)
        rows.append((words, 100 * float(np.nanmedian(df0)), 100 * float(np.nanmedian(dratio)), *r2))
    columns = (
        "way of fitting",
        "median |Δf0| (%)",
        "median |Δ(b/f0)| (%)",
        "R² of ω_n on f0, 3 deg",
        "R² of α on b/f0, 3 deg",
        "R² of ω_n on f0, 12 deg",
        "R² of α on b/f0, 12 deg",
    )
    return Table("fitting", columns, tuple(rows))
