"""A scenario: one sheet on one plate motion, with everything a run needs. Read from and written to TOML."""

from __future__ import annotations

import json
import math
import re
import tomllib
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any

from pydantic import Field, model_validator

from plategait.errors import InputError
from plategait.files.input import LARGEST_TOML, read_text
from plategait.model.base import Model, quantity_of
from plategait.model.contact import Contact, Friction
from plategait.model.motion import PlateMotion
from plategait.model.sheet import Sheet
from plategait.units import Acceleration, Angle, Delay, Duration, Length, Offset, Quantity, show

# Step that the reference disk's spin rates allow within 1 % r.m.s. (docs/numerics.md), and the share of the stable step
# that stiffer or finer sheets take.
LARGEST_TIME_STEP = 1e-4
SHARE_OF_STABLE_STEP = 0.85
STEPS_PER_SINE = 20
MOST_STEPS = 2e9

# Keys of so many parts that the reader, whose time grows with their square, would not end.
_LONG_KEY = re.compile(r"(?<![\w\"'-])[\w\"'-]++(?:[ \t]*+\.[ \t]*+[\w\"'-]++){32}")
_PLACE = re.compile(r"(?<=\()at [^()]*(?=\)$)")


class Start(Model):
    """Where the object lies at the start, about the middle of the plate."""

    x: Offset = Field(default=0.0, description="along the bar")
    y: Offset = Field(default=0.0, description="across the bar")
    angle: Angle = Field(default=0.0, description="orientation")


class Plate(Model):
    """Size of the plate; the source takes it as large enough never to drop the object."""

    length: Length = Field(default=0.1, description="along the bar")
    width: Length = Field(default=0.1, description="across the bar")


class Scenario(Model):
    """Everything one run needs: what is simulated, how the plate moves, for how long."""

    name: str = Field(default="scenario", description="what the results call it", examples=['"cheese"'])
    sheet: Sheet = Field(
        description="the object",
        examples=[
            '{ outline = { shape = "disk", radius = "40 mm" }, mass = "13.6 g", '
            'bending_stiffness = "2.72e-3 N*mm/deg", axial_stiffness = "0.79 N/mm" }'
        ],
    )
    motion: PlateMotion = Field(default_factory=PlateMotion, description="how the plate moves")
    contact: Contact = Field(default_factory=Contact, description="contact between sheet and plate (3.1)")
    friction: Friction = Field(default_factory=Friction, description="friction between sheet and plate (3.2)")
    start: Start = Field(default_factory=Start, description="where the object lies at the start")
    plate: Plate | None = Field(
        default=None,
        description="size of the plate; leave out for one that never ends",
        examples=['{ length = "200 mm", width = "200 mm" }'],
    )
    gravity: Acceleration = Field(default=9.81, description="g")
    duration: Duration = Field(default=4.0, description="simulated time")
    transient: Delay | None = Field(
        default=None, description="time before anything is measured (30 % of the duration if left out)"
    )
    slip_limit: Length = Field(default=0.01, description="failed once the centre has slipped this far (section 4.3)")
    time_step: Annotated[float, Quantity("s", "s", "1e-4 s", above=0)] | None = Field(
        default=None, description="integration step (chosen from the stiffness if left out)"
    )

    @model_validator(mode="after")
    def _times_fit(self) -> Scenario:
        if self.measured_from >= self.duration:
            raise InputError(
                "transient",
                f"{self.measured_from:g} s",
                f"below the duration {self.duration:g} s",
                f'"{0.3 * self.duration:g} s"',
            )
        joints, sine = self.sheet.stable_time_step, self._step_of_fastest_sine
        largest, usual = min(joints, sine), self._usual_step
        if self.duration / usual > MOST_STEPS and usual == sine:
            fastest = self.motion.frequency * sine * MOST_STEPS / self.duration
            raise InputError("motion.frequency", f"{self.motion.frequency:g} Hz",
                             f"at most {fastest:.3g} Hz where {self.duration:g} s are simulated",
                             f'"{min(24.0, 0.5 * fastest):.2g} Hz"')  # fmt: skip
        if self.duration / usual > MOST_STEPS:
            raise InputError("duration", f"{self.duration:g} s",
                             f"at most {MOST_STEPS * usual:.3g} s at a time step of {usual:.2g} s",
                             f'"{min(4.0, 0.5 * MOST_STEPS * usual):.2g} s"')  # fmt: skip
        least = self.duration / MOST_STEPS
        if self.time_step is not None and not least <= self.time_step <= largest:
            reason = "the joints stay stable" if joints < sine else f"the fastest sine gets {STEPS_PER_SINE} steps"
            raise InputError("time_step", f"{self.time_step:g} s",
                             f"at least {least:.3g} s and at most {largest:.3g} s, where {reason}",
                             f'"{SHARE_OF_STABLE_STEP * usual:.2g} s", or leave it out')  # fmt: skip
        return self

    @property
    def _step_of_fastest_sine(self) -> float:
        # A plate that stands still has a period too, over which everything is measured.
        return min(self.motion.shortest_period, self.motion.period) / STEPS_PER_SINE

    @property
    def _usual_step(self) -> float:
        stable = SHARE_OF_STABLE_STEP * self.sheet.stable_time_step
        return min(LARGEST_TIME_STEP, stable, self._step_of_fastest_sine)

    @property
    def measured_from(self) -> float:
        """Time from which the observables are measured, s."""
        return 0.3 * self.duration if self.transient is None else self.transient

    @cached_property
    def dt(self) -> float:
        """Time step used, s: the one given, or the least of 1e-4 s, 85 % of the stable one and 1/20 of a fast sine."""
        return self._usual_step if self.time_step is None else self.time_step


def read_scenario(path: Path | str, field: str = "scenario") -> Scenario:
    """Read a scenario from a TOML file, which errors call `field`.

    Raises
    ------
    InputError
        When the file cannot be read, is no TOML, or a field is not as it must be.
    """
    hint = "plategait scenario --print cheese > cheese.toml"
    data, _ = read_toml(path, field, "a scenario file or a preset's name", hint)
    return Scenario(**_resolve_files(data, Path(path).parent))


def read_toml(path: Path | str, field: str, allowed: str, hint: str) -> tuple[dict[str, Any], str]:
    """Contents of a TOML file, and its text.

    Raises
    ------
    InputError
        When the file cannot be read, which must be `allowed`, or is no TOML.
    """
    text = read_text(path, LARGEST_TOML, field, allowed, hint)
    why = "names of too many parts"
    if not _LONG_KEY.search(text):
        try:
            return tomllib.loads(text), text
        except tomllib.TOMLDecodeError as error:
            # The rest of the message may hold some of the file, which need not be one of ours.
            why = " ".join(["no TOML", *_PLACE.findall(str(error))])
        except ValueError:
            why = "a number of too many digits"
        except RecursionError:
            why = "lists or tables nested too deep"
    raise InputError(field, f"{path} ({why})", allowed, hint)


def _resolve_files(data: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Names of files in a scenario count from the folder it is in."""
    resolved: dict[str, Any] = {}
    for key, value in data.items():
        if isinstance(value, dict):
            resolved[key] = _resolve_files(value, folder)
        elif key in ("image", "samples") and isinstance(value, str):
            resolved[key] = str(folder / value)
        else:
            resolved[key] = value
    return resolved


def write_scenario(scenario: Scenario, notes: dict[str, str] | None = None) -> str:
    """Write a scenario as commented TOML that `read_scenario` reads back the same.

    Parameters
    ----------
    notes : dict, optional
        Remarks by dotted field name ("sheet.mass"), added to the comments.
    """
    lines = _table(scenario, "", notes or {})
    return "\n".join(lines).strip() + "\n"


def _table(model: Model, prefix: str, notes: dict[str, str]) -> list[str]:
    lines: list[str] = []
    nested: list[str] = []
    for name, field in type(model).model_fields.items():
        value = getattr(model, name)
        dotted = f"{prefix}{name}"
        remark = "; ".join(filter(None, [field.description, notes.get(dotted)]))
        if isinstance(value, Model) and name != "samples":
            nested += ["", f"# {remark}" if remark else "", f"[{dotted}]", *_table(value, f"{dotted}.", notes)]
            continue
        if value is None or value == ():
            if not field.is_required() and name in ("plate", "transient", "time_step"):
                lines.append(f"# {name} is left out: {remark}")
            continue
        quantity = quantity_of(type(model), name)
        lines.append(f"{name} = {_literal(value, quantity)}" + (f"  # {remark}" if remark else ""))
    return [*lines, *nested]


def _literal(value: object, quantity: Quantity | None) -> str:
    """One value as TOML."""
    if quantity is not None and isinstance(value, float) and quantity.unit:
        text = show(value, quantity.unit, quantity.display)
        # Text must come back as the very same number: a run from the file gives the run's bits.
        return f'"{text}"' if quantity.read(text, "") == value else repr(value)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else str(value)
    if isinstance(value, (tuple, list)):
        return "[" + ", ".join(_literal(item, None) for item in value) + "]"
    if isinstance(value, Model):
        items = ((name, getattr(value, name)) for name in type(value).model_fields)
        return (
            "{ "
            + ", ".join(f"{name} = {_literal(item, None)}" for name, item in items if item not in (None, ()))
            + " }"
        )
    # JSON's escapes are TOML's too, save that TOML has no bare DEL.
    return json.dumps(str(value), ensure_ascii=False).replace("\x7f", "\\u007F")
