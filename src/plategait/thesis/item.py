"""One figure or table of the source, regenerated: pictures, numbers, comparison and verdict."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from plategait.files.plain import plain
from plategait.published import Number
from plategait.thesis.cases import Case
from plategait.thesis.runs import Results

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Cell = str | float | int | None


@dataclass(frozen=True)
class Table:
    """Columns and rows, written as CSV and shown in the report."""

    name: str
    columns: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]


@dataclass(frozen=True)
class Comparison:
    """One number beside its published value.

    Attributes
    ----------
    quantity : str
    published : Number
    measured : float
    allowed : float
        Deviation up to which it counts as reproduced: relative, or absolute where `absolute`.
    absolute : bool
    spread : float
        Standard deviation over the starts of the ensemble.
    half_step : float
        Change when the time step is halved, in the unit of the number; NaN where that was not run.
    """

    quantity: str
    published: Number
    measured: float
    allowed: float
    absolute: bool = False
    spread: float = math.nan
    half_step: float = math.nan

    @property
    def deviation(self) -> float:
        """Measured less published, over published unless `absolute`."""
        difference = self.measured - self.published.value
        return difference if self.absolute or self.published.value == 0 else difference / abs(self.published.value)

    @property
    def holds(self) -> bool:
        """Whether the deviation is within what is allowed."""
        return math.isfinite(self.deviation) and abs(self.deviation) <= self.allowed

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`."""
        return {
            "quantity": self.quantity,
            "published": self.published.value,
            "where": self.published.where,
            "measured": plain(self.measured),
            "deviation": plain(self.deviation),
            "spread": plain(self.spread),
            "half_step": plain(self.half_step),
            "holds": bool(self.holds),
        }


@dataclass(frozen=True)
class Check:
    """A target or a finding in words that holds or does not."""

    what: str
    target: str
    measured: str
    holds: bool

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`."""
        return {"what": self.what, "target": self.target, "measured": self.measured, "holds": bool(self.holds)}


@dataclass(frozen=True, eq=False)
class Item:
    """One figure or table, done.

    Attributes
    ----------
    name, title : str
    verdict : str
        One line.
    figures : tuple of (file stem, Figure, or PNG as bytes)
    tables : tuple of Table
    comparisons : tuple of Comparison
    checks : tuple of Check
    notes : tuple of str
        Why it differs, and what else to know.
    """

    name: str
    title: str
    verdict: str
    figures: tuple[tuple[str, Figure | bytes], ...] = ()
    tables: tuple[Table, ...] = ()
    comparisons: tuple[Comparison, ...] = ()
    checks: tuple[Check, ...] = ()
    notes: tuple[str, ...] = ()

    @property
    def reproduced(self) -> bool:
        """Whether every comparison and check holds."""
        return all(x.holds for x in (*self.comparisons, *self.checks))

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`."""
        return {
            "name": self.name,
            "title": self.title,
            "verdict": self.verdict,
            "reproduced": self.reproduced,
            "comparisons": [c.summary() for c in self.comparisons],
            "checks": [c.summary() for c in self.checks],
        }


@dataclass(frozen=True)
class Spec:
    """How an item is made: the cases that it needs, and the function that makes it of their runs."""

    name: str
    title: str
    make: Callable[[Spec, Results], Item]
    cases: Callable[[], Sequence[Case]] = field(default=list)

    def item(
        self,
        *,
        figures: Sequence[tuple[str, Figure | bytes]] = (),
        tables: Sequence[Table] = (),
        comparisons: Sequence[Comparison] = (),
        checks: Sequence[Check] = (),
        notes: Sequence[str] = (),
        remark: str = "",
    ) -> Item:
        """Item of this name, its verdict read off its comparisons and checks; see `Item` and `verdict`."""
        return Item(
            name=self.name,
            title=self.title,
            verdict=verdict(comparisons, checks, remark),
            figures=tuple(figures),
            tables=tuple(tables),
            comparisons=tuple(comparisons),
            checks=tuple(checks),
            notes=tuple(notes),
        )


def verdict(comparisons: Sequence[Comparison] = (), checks: Sequence[Check] = (), remark: str = "") -> str:
    """Write the one line that says how many of the numbers and findings hold."""
    held = [x.holds for x in (*comparisons, *checks)]
    if not held:
        return remark
    if all(held):
        start = "Reproduced"
    elif any(held):
        start = f"Partly reproduced: {sum(held)} of {len(held)} hold"
    else:
        start = "Not reproduced"
    worst = [x.what for x in checks if not x.holds] + [x.quantity for x in comparisons if not x.holds]
    missed = f" (not: {', '.join(worst[:3])}{', …' if len(worst) > 3 else ''})" if any(held) and worst else ""
    return f"{start}{missed}." + (f" {remark}" if remark else "")
