"""Every object that the dissertation names, with what of it is published and what is inferred."""

from __future__ import annotations

import difflib
import math
import os
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from plategait.errors import InputError
from plategait.model.base import in_words
from plategait.model.contact import Contact, Friction
from plategait.model.inferred import NOTES, with_departures
from plategait.model.motion import PlateMotion
from plategait.model.outline import Disk
from plategait.model.scenario import Scenario
from plategait.model.scenario_file import read_scenario
from plategait.model.sheet import Sheet
from plategait.published import NOMINAL_NATURAL_FREQUENCY
from plategait.shown import Shown


@dataclass(frozen=True, repr=False)
class Preset(Shown):
    """A scenario, and where its numbers come from, by dotted field name."""

    scenario: Scenario
    summary: str
    published: dict[str, str]
    inferred: dict[str, str]

    @property
    def notes(self) -> dict[str, str]:
        """Remarks for `write_scenario`."""
        return {name: f"published: {where}" for name, where in self.published.items()} | {
            name: f"inferred: {why}" for name, why in self.inferred.items()
        }


_TABLE_4_1 = Sheet(
    name="cheese",
    outline=Disk(radius="40 mm"),
    mass="13.6 g",
    pitch="10 mm",
    thickness="2.5 mm",
    bending_stiffness="2.72e-3 N*mm/deg",
    bending_damping="4.23e-6 N*mm/(deg/s)",
    axial_stiffness="0.79 N/mm",
    axial_damping="4.9e-4 N/(mm/s)",
)
_CONTACT = Contact(stiffness="11.86 N/mm", damping="7.65e-3 N/(mm/s)")
_FRICTION = Friction(static=0.75, kinetic=0.40, transition_speed="100 mm/s")
_PANCAKE_FRICTION = Friction(static=0.60, kinetic=0.32, transition_speed="100 mm/s")
_FAST_AND_FLAT = PlateMotion(frequency="24 Hz", angle="3 deg", stroke="3 mm")
_SLOW_AND_WIDE = PlateMotion(frequency="12 Hz", angle="12 deg", stroke="3 mm")
_PANCAKE_MOTION = PlateMotion(frequency="7 Hz", angle="16 deg", stroke="2 mm")

_JOINTS_AND_CONTACT: tuple[str, ...] = (
    "sheet.axial_stiffness", "sheet.axial_damping", "contact.stiffness", "contact.damping",
    "friction.static", "friction.kinetic", "friction.transition_speed",
)  # fmt: skip

_SECTION_5_6_2 = ("sheet.outline.radius", "sheet.mass", "motion.angle", "motion.stroke")


def _like_the_cheese(*names: str) -> dict[str, str]:
    return dict.fromkeys((*names, *_JOINTS_AND_CONTACT), "as the slice of cheese, Table 4.1")


def _cheese_as_printed() -> Preset:
    fields: tuple[str, ...] = (
        "sheet.outline.radius",
        "sheet.mass",
        "sheet.pitch",
        "sheet.thickness",
        "sheet.bending_stiffness",
        "sheet.bending_damping",
        *_JOINTS_AND_CONTACT,
    )
    return Preset(
        Scenario(
            name="cheese-as-printed", sheet=_TABLE_4_1, motion=_FAST_AND_FLAT, contact=_CONTACT, friction=_FRICTION
        ),
        "the same with nothing inferred: Table 4.1 to the letter, the plate on its axis",
        dict.fromkeys(fields, "Table 4.1") | dict.fromkeys(("motion.angle", "motion.stroke"), "section 5.3.1"),
        {
            "motion.frequency": "near the peak of Fig. 5.2(a)",
            "motion.ramp": "the source does not say how its motion starts",
        },
    )


def _cheese() -> Preset:
    printed = _cheese_as_printed()
    return replace(
        printed,
        scenario=printed.scenario.replace(name="cheese"),
        summary="the slice of cheese of Table 4.1, natural frequency 10π rad/s by the source",
    )


def _cheese_with_lead() -> Preset:
    sheet = _TABLE_4_1.replace(name="cheese-with-lead", mass="39.5 g")
    return Preset(
        Scenario(name="cheese-with-lead", sheet=sheet, motion=_SLOW_AND_WIDE, contact=_CONTACT, friction=_FRICTION),
        "the slice of cheese weighed down with lead balls, section 5.6.2",
        {
            "sheet.outline.radius": "section 5.6.2",
            "sheet.mass": "section 5.6.2",
            "motion.angle": "section 5.6.2",
            "motion.stroke": "section 5.6.2",
        },
        _like_the_cheese("sheet.bending_stiffness", "sheet.thickness") | {"sheet.pitch": "modelling choice"},
    )


def _dumpling_skin() -> Preset:
    mass = 6.9e-3
    stiffness = _TABLE_4_1.bending_stiffness * (mass / _TABLE_4_1.mass) * (11.9 / 10) ** 2
    sheet = _TABLE_4_1.replace(name="dumpling-skin", mass=mass, thickness="1 mm", bending_stiffness=stiffness)
    return Preset(
        Scenario(name="dumpling-skin", sheet=sheet, motion=_SLOW_AND_WIDE, contact=_CONTACT, friction=_FRICTION),
        "the skin of a Chinese dumpling, natural frequency 11.9π rad/s, section 5.6.2",
        dict.fromkeys(_SECTION_5_6_2, "section 5.6.2"),
        _like_the_cheese()
        | {"sheet.bending_stiffness": "from the published ω_n = 11.9π and mass, by the cheese's k_b and 10π",
           "sheet.thickness": "typical of the food", "sheet.pitch": "modelling choice"},
    )  # fmt: skip


def _pancake(rigid: bool) -> Preset:
    # ω_n² goes with k_b/(M r²): the lattice keeps its 52 nodes at a slightly wider pitch.
    omega = (320 if rigid else 7) * math.pi
    mass, pitch = 10e-3, 10.5e-3
    scale = (mass / _TABLE_4_1.mass) * (pitch / _TABLE_4_1.pitch) ** 2 * (omega / NOMINAL_NATURAL_FREQUENCY) ** 2
    name = "rigid-twin" if rigid else "pancake"
    sheet = _TABLE_4_1.replace(
        name=name,
        outline=Disk(radius=0.042),
        mass=mass,
        pitch=pitch,
        thickness="1 mm",
        bending_stiffness=_TABLE_4_1.bending_stiffness * scale,
    )
    why = (
        "as stiff as the source's stiffest object, ω_n = 320π (Fig. 4.7h), which it calls rigid"
        if rigid
        else "ω_n = 7π, at which it spins about as fast as in Fig. 2.8; the source gives no stiffness"
    )
    slippery = (
        "as rough as lets the pancake spin as in Fig. 2.8, and its twin about half as fast; the source gives none"
    )
    return Preset(
        Scenario(name=name, sheet=sheet, motion=_PANCAKE_MOTION, contact=_CONTACT, friction=_PANCAKE_FRICTION),
        "the plastic twin of the pancake, same size and mass, section 2.4"
        if rigid
        else "the 10 g pancake of section 2.4",
        dict.fromkeys(
            (
                "sheet.outline.radius",
                "sheet.mass",
                "sheet.thickness",
                "motion.frequency",
                "motion.angle",
                "motion.stroke",
            ),
            "section 2.4",
        ),
        _like_the_cheese()
        | {
            "sheet.bending_stiffness": why,
            "sheet.pitch": "modelling choice, 8 nodes across",
            "friction.static": slippery,
            "friction.kinetic": "the cheese's ratio to the static one",
        },
    )


def _with_departures(printed: Preset) -> Preset:
    return replace(
        printed,
        scenario=with_departures(printed.scenario),
        published={name: where for name, where in printed.published.items() if name not in NOTES},
        inferred=printed.inferred | NOTES,
    )


_MAKERS = {
    "cheese": _cheese,
    "cheese-as-printed": _cheese_as_printed,
    "cheese-with-lead": _cheese_with_lead,
    "dumpling-skin": _dumpling_skin,
    "pancake": lambda: _pancake(rigid=False),
    "rigid-twin": lambda: _pancake(rigid=True),
}

PRESETS = tuple(_MAKERS)
"""Names of the presets."""


def preset(name: str) -> Preset:
    """Look a preset up by name.

    Parameters
    ----------
    name : str
        One of `PRESETS`.

    Raises
    ------
    InputError
        When there is none of that name.
    """
    if not isinstance(name, str) or name not in _MAKERS:
        raise InputError("preset", name, f"one of {', '.join(PRESETS)}", _nearest(name))
    return _made(name)


@cache
def _made(name: str) -> Preset:
    """Preset of a name, once: looking it up again is what scripts do at each of thousands of points."""
    printed = _MAKERS[name]()
    return printed if name == "cheese-as-printed" else _with_departures(printed)


def nominal_natural_frequency(sheet: Sheet) -> float:
    """ω_n of a sheet as the dissertation counts it, rad/s: Table 4.1's is 10π, and not its dish mode's 10.32π."""
    return sheet.natural_frequency * NOMINAL_NATURAL_FREQUENCY / _TABLE_4_1.natural_frequency


def as_scenario(scenario: Scenario | Preset | Path | str, field: str = "scenario") -> Scenario:
    """Scenario that is meant: itself, that of a preset or of a preset's name, or what a TOML file holds.

    Raises
    ------
    InputError
        For anything else, under the name `field`; or when the file is not as it must be.
    """
    if isinstance(scenario, Scenario):
        return scenario
    if isinstance(scenario, Preset):
        return scenario.scenario
    if isinstance(scenario, str) and scenario in _MAKERS:
        return preset(scenario).scenario
    if isinstance(scenario, Path) or (
        isinstance(scenario, str) and (Path(scenario).suffix or os.path.isfile(scenario))
    ):
        return read_scenario(scenario, field)
    if isinstance(scenario, Sheet):
        raise InputError(field, "a Sheet", "a Scenario, a preset or a TOML file", "Scenario(sheet=…)")
    if isinstance(scenario, (list, tuple)):
        raise InputError(field, "a list", f"a TOML file or one of {', '.join(PRESETS)}",
                         "cheese, or simulate_all for a list")  # fmt: skip
    raise InputError(field, in_words(scenario), f"a TOML file or one of {', '.join(PRESETS)}", _nearest(scenario))


def _nearest(name: object) -> str:
    """Preset that may be meant."""
    return next(iter(difflib.get_close_matches(str(name).lower(), PRESETS, 1)), "cheese")
