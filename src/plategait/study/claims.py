"""Claims and answers: what a study says, each number with its errors, so that a test can fail it."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from plategait.files.plain import plain
from plategait.study.measured import Columns, Measured
from plategait.thesis.item import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Of the starts, with no factor for how few they are: 95 % of many, 82 % of three, 70 % of two (Student's t).
_STANDARD_ERRORS = 2.0


@dataclass(frozen=True)
class Number:
    """A number with what it is uncertain by.

    Attributes
    ----------
    value : float
        From the mean over the starts.
    step_error : float
        Change when the time step is halved, from the same starts; NaN where that was not run.
    ensemble_error : float
        Standard error over the starts; NaN for one start.
    """

    value: float
    step_error: float = math.nan
    ensemble_error: float = math.nan

    @property
    def interval(self) -> tuple[float, float] | None:
        """Two standard errors to either side, and the change with the step on top; None where neither is known."""
        errors = [abs(e) for e in (_STANDARD_ERRORS * self.ensemble_error, self.step_error) if math.isfinite(e)]
        reach = math.hypot(*errors)
        return (self.value - reach, self.value + reach) if errors and math.isfinite(self.value) else None

    def scaled(self, factor: float) -> Number:
        """The same in another unit."""
        return Number(factor * self.value, factor * self.step_error, abs(factor) * self.ensemble_error)


def number_of(measured: Measured, function: Callable[[Columns], float]) -> Number:
    """Number that a function makes of the columns of all points, with its errors.

    Parameters
    ----------
    measured : Measured
        What runs showed, from each start and, where that was run, at half the time step.
    function : callable
        From `Columns` to the number. It gets the means over the starts, each start by itself, and the half step's.
    """
    return numbers_of(measured, lambda columns: {"": function(columns)})[""]


def numbers_of(measured: Measured, function: Callable[[Columns], Mapping[str, float]]) -> dict[str, Number]:
    """Several numbers that one function makes, by name: where what they share takes time. See `number_of`."""
    values = function(measured.means)
    half = None if measured.half_means is None else function(measured.half_means)
    each = [function(columns) for columns in measured.by_start]
    return {
        name: _number(float(value), math.nan if half is None else float(half[name]), [e[name] for e in each])
        for name, value in values.items()
    }


def _number(value: float, half: float, each: Sequence[float]) -> Number:
    there = np.array(each, dtype=float)
    there = there[np.isfinite(there)]
    error = float(there.std(ddof=1)) / math.sqrt(len(there)) if len(there) > 1 else math.nan
    return Number(value, half - value, error)


@dataclass(frozen=True)
class Claim:
    """One sentence that holds or does not, with the number that decides it.

    Attributes
    ----------
    claim : str
        A sentence with its bound: "sliding ends within 15 % of one Γ at every A_p".
    holds : bool
        Whether the number is within that bound. A claim that is refuted stays, as refuted.
    number : Number
    unit : str
        Of the number, "1" for none.
    note : str
        Conditions.
    interval : (low, high), optional
        95 %, of something else than starts and step; by default that of the number.
    """

    claim: str
    holds: bool
    number: Number
    unit: str = "1"
    note: str = ""
    interval: tuple[float, float] | None = None

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`."""
        interval = self.interval or self.number.interval
        return {
            "claim": self.claim,
            "holds": bool(self.holds),
            "number": plain(self.number.value),
            "interval": None if interval is None else [plain(end) for end in interval],
            "step_error": plain(self.number.step_error),
            "ensemble_error": plain(self.number.ensemble_error),
            "unit": self.unit,
            "note": self.note,
        }


@dataclass(frozen=True, eq=False)
class Answer:
    """What a study answers.

    Attributes
    ----------
    name, question : str
    verdict : str
        One sentence.
    claims : tuple of Claim
    tables : tuple of Table
    figures : tuple of (file stem, Figure)
        The first says it at a glance.
    notes : tuple of str
        What else to know, a paragraph each.
    """

    name: str
    question: str
    verdict: str
    claims: tuple[Claim, ...]
    tables: tuple[Table, ...]
    figures: tuple[tuple[str, Figure], ...]
    notes: tuple[str, ...] = ()

    def claim(self, start: str) -> Claim:
        """Claim that begins so."""
        return next(claim for claim in self.claims if claim.claim.startswith(start))

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`."""
        return {
            "name": self.name,
            "question": self.question,
            "verdict": self.verdict,
            "claims": [claim.summary() for claim in self.claims],
            "notes": list(self.notes),
        }
