"""What an estimate assumes of the set-up: what was told or taken as usual, and what is left open and how far."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from plategait.estimate.handling import SLOWEST_RAMP, Handling
from plategait.estimate.observations import Condition
from plategait.estimate.unknowns import BENDING_DAMPING, PLATE_HEIGHT, Unknown, Unknowns
from plategait.model.outline import Disk
from plategait.model.parameters import find_parameter, value_of


@dataclass(frozen=True)
class Assumption:
    """One number or word that the estimate rests on.

    Attributes
    ----------
    name : str
        Dotted name in a scenario.
    label : str
        What it is, in words.
    value : float or str
        SI, or a word.
    unit : str
        SI unit.
    text : str
        Value with its unit for people, and how far it is left open.
    sought : bool
        Whether it is left open: estimated too, over its prior.
    """

    name: str
    label: str
    value: float | str
    unit: str
    text: str
    sought: bool = False

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`, SI."""
        return {"value": self.value, "unit": self.unit or None, "sought": self.sought, "text": self.text}


# In the order in which people measure them; those of the run after those of the object and the plate.
_LABELS = {
    "sheet.outline.radius": "radius",
    "sheet.mass": "mass",
    "sheet.thickness": "thickness",
    "sheet.bending_damping": "bending damping c_b",
    "sheet.torsion_stiffness": "torsion stiffness k_t",
    "motion.stroke": "stroke B_p",
    "motion.height": "height of the plate above its axis",
    "friction.law": "law of friction",
    "friction.transition_speed": "speed V of that law",
    "motion.ramp": "start of the plate, to full swing in",
    "duration": "each frequency observed for",
    "transient": "of which left out",
    "slip_limit": "run off once slipped by",
}
_SOUGHT = {"sheet.bending_damping": BENDING_DAMPING.name, "motion.height": PLATE_HEIGHT.name, "sheet.mass": "mass"}


def assumptions(
    unknowns: Unknowns, conditions: Sequence[Condition], thickness_sd: float = 0.0, handling: Handling | None = None
) -> tuple[Assumption, ...]:
    """What an estimate of these unknowns assumes.

    Parameters
    ----------
    unknowns : Unknowns
    conditions : sequence of Condition
        Plate motions that were measured, which tell the strokes.
    thickness_sd : float
        How well the thickness is known, m.
    handling : Handling, optional
        What of the measurement differs from point to point; the usual if left out.
    """
    return tuple(_each(unknowns, conditions, thickness_sd, handling or Handling()))


def _each(
    unknowns: Unknowns, conditions: Sequence[Condition], thickness_sd: float, handling: Handling
) -> Iterator[Assumption]:
    base, by_name = unknowns.base, {p.name: p for p in unknowns.parameters}
    for name, label in _LABELS.items():
        if name == "sheet.outline.radius" and not isinstance(base.sheet.outline, Disk):
            yield Assumption("sheet.outline.shape", "outline", base.sheet.outline.shape, "", base.sheet.outline.shape)
            continue
        parameter = find_parameter(name, base)
        value = value_of(base, name) if name != "motion.ramp" or handling.ramp is None else handling.ramp
        text = parameter.text_of(value)
        if name == "sheet.thickness" and thickness_sd > 0:
            text = f"{text} ± {parameter.text_of(thickness_sd)}"
        if name == "motion.stroke":
            text = _listed([parameter.text_of(stroke) for stroke in sorted({c.stroke for c in conditions})])
        if name == "motion.ramp" and handling.ramp is None:
            text = f"not known, up to {parameter.text_of(SLOWEST_RAMP)}"
        if name in ("duration", "slip_limit"):
            of_points = {getattr(c, name) for c in conditions} - {0.0}
            if len(of_points) > 1:
                text = f"{parameter.text_of(min(of_points))} to {parameter.text_of(max(of_points))}"
        unknown = by_name.get(_SOUGHT.get(name, ""))
        if unknown is not None:
            text = f"sought, {_reach(unknown, text)}"
        yield Assumption(name, label, value, parameter.unit, text, unknown is not None)
    if scatter := handling.friction_scatter:
        text = f"scatters by {math.degrees(scatter):.3g} deg"
        yield Assumption("friction_scatter", "friction angle from point to point", scatter, "rad", text)


def _listed(texts: Sequence[str]) -> str:
    """Few of them each, of many the first and the last."""
    return " and ".join(texts) if len(texts) <= 3 else f"{texts[0]} to {texts[-1]}"


def _reach(unknown: Unknown, told: str) -> str:
    """How far a parameter is left open, as the end of "sought, …"."""
    low, high = (f"{end / unknown.scale:.3g}" for end in (unknown.low, unknown.high))
    factor = "" if unknown.unit else f" times {told}"
    unit = f" {unknown.unit}" if unknown.unit else ""
    return f"{'about' if unknown.shape == 'normal' else 'from'} {low} to {high}{unit}{factor}"
