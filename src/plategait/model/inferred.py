"""What the presets take beyond what the dissertation prints: few numbers, the same for all its objects and motions.

`plategait study source` finds them among all unknowns together, the smallest set that pays for itself: docs/studies.md.
"""

from __future__ import annotations

from dataclasses import dataclass

from plategait.model.parameters import value_of, with_values
from plategait.model.scenario import Scenario


@dataclass(frozen=True)
class Departure:
    """One number that the source does not print, or that its solver may have changed.

    Attributes
    ----------
    name : str
        Dotted name of the parameter of a scenario.
    number : float
        Value, SI; or factor on the parameter `of`.
    interval : tuple of float
        90 % of its posterior where all unknowns are found together.
    why : str
    of : str, optional
        Dotted name of the parameter that it multiplies.
    unit : str
        Of `number`, as people read it.
    scale : float
        SI over that unit.
    """

    name: str
    number: float
    interval: tuple[float, float]
    why: str
    of: str = ""
    unit: str = ""
    scale: float = 1.0

    @property
    def note(self) -> str:
        """Where the number comes from, in one line."""
        low, high = (f"{end / self.scale:.2g}" for end in self.interval)
        what = f"{self.number / self.scale:g}{self.unit and ' ' + self.unit}"
        factor = f" times {self.of} as printed" if self.of else ""
        return f"{what}{factor}, {self.why} ({low} to {high} where all unknowns are found together: docs/studies.md)"


DEPARTURES = (
    Departure("sheet.bending_damping", 6.0, (3.6, 6.7),
              "for the damping that the source's implicit solver adds", of="sheet.bending_damping"),
    Departure("motion.height", 5e-3, (4.0e-3, 7.4e-3), "as the plate lies on the bar", unit="mm", scale=1e-3),
    Departure("friction.transition_speed", 0.06, (0.045, 0.081),
              "as the printed V may be that of the solver's own law", unit="mm/s", scale=1e-3),
)  # fmt: skip
NOTES = {departure.name: departure.note for departure in DEPARTURES}
"""Remarks by dotted name."""


def with_departures(printed: Scenario) -> Scenario:
    """Scenario with the inferred numbers in place of what is printed."""
    values = {d.name: d.number * (float(value_of(printed, d.of)) if d.of else 1.0) for d in DEPARTURES}
    return with_values(printed, values)


def number_of(name: str) -> float:
    """Inferred number of a parameter, its value or factor; 1 where it is as printed."""
    return next((departure.number for departure in DEPARTURES if departure.name == name), 1.0)
