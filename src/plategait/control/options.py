"""What the task of laying a sheet at a place can be told: objects, machine, actions, camera, goals, what varies."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, field_validator, model_validator

from plategait.arrays import Array
from plategait.control.camera import Camera
from plategait.errors import InputError
from plategait.model.base import Model
from plategait.model.machine import Machine, machine_of
from plategait.model.motion import SHORTEST_RAMP, PlateMotion
from plategait.model.scenario import Plate, Scenario, Start
from plategait.simulation.run import scenarios_of
from plategait.units import Duration, Length, Offset, Quantity

_FACTOR = Quantity("", "", "1", above=0, at_most=100)
_RATE = Quantity("Hz", "Hz", "60 Hz", at_least=0.1, at_most=1e4)
_TURN = Quantity("rad", "deg", "5 deg", above=0, at_most=math.pi)
_ACCELERATION = Quantity("m/s^2", "m/s^2", "80 m/s^2", above=0)
_RAMP = Quantity("s", "s", "0.05 s", above=0, at_most=10)
# Where an object's scenario has no plate of its own.
PLATE = Plate(length="200 mm", width="200 mm")

Factors = tuple[Annotated[float, _FACTOR], Annotated[float, _FACTOR]]


class Variation(Model):
    """How what is simulated differs from episode to episode: drawn between two ends, evenly; factors by ratios."""

    stiffness: Factors = Field(default=(1.0, 1.0), description="factor of the stiffness in bending and torsion")
    friction: Factors = Field(default=(1.0, 1.0), description="factor of both coefficients of friction")
    mass: Factors = Field(default=(1.0, 1.0), description="factor of the sheet's mass")
    height: tuple[Offset, Offset] | None = Field(
        default=None,
        description="of the plate's surface above the axis that it turns about; the scenario's own if left out",
    )

    @model_validator(mode="after")
    def _from_low_to_high(self) -> Variation:
        for name in type(self).model_fields:
            ends = getattr(self, name)
            if ends is not None and not ends[0] <= ends[1]:
                raise InputError(name, str(ends), "from a lower end to a higher", str(tuple(reversed(ends))))
        return self

    def drawn(self, scenario: Scenario, shares: Sequence[float]) -> Scenario:
        """Scenario at four shares, 0 to 1, of the ways from the lower ends to the higher."""
        stiffness, friction, mass = (
            low * (high / low) ** share
            for (low, high), share in zip((self.stiffness, self.friction, self.mass), shares, strict=False)
        )
        sheet, rubs, motion = scenario.sheet, scenario.friction, scenario.motion
        if (stiffness, mass) != (1.0, 1.0):
            sheet = sheet.made_of(
                bending_stiffness=sheet.bending_stiffness * stiffness,
                torsion_stiffness=sheet.torsion_stiffness * stiffness, mass=sheet.mass * mass,
            )  # fmt: skip
        if friction != 1.0:
            rubs = rubs.with_valid(static=rubs.static * friction, kinetic=rubs.kinetic * friction)
        if self.height is not None:
            low, high = self.height
            motion = motion.with_valid(height=low + (high - low) * shares[3])
        return scenario.with_valid(sheet=sheet, friction=rubs, motion=motion)


class PoseOptions(Model):
    """What the task can be told: ``gymnasium.make("plategait/Pose-v0", …)`` takes each by its name."""

    objects: tuple[Scenario, ...] = Field(
        default=("cheese",), validate_default=True, examples=['"cheese"'],
        description="scenarios, presets or files; a lane keeps the one of its number, counted round",
    )  # fmt: skip
    machine: Machine = Field(default="source-robot", validate_default=True, description="whose limits are kept")
    actions: Literal["drive"] | tuple[PlateMotion, ...] = Field(
        default="drive", description="numbers for the drive, or motions to choose from"
    )
    free: tuple[str, ...] | None = Field(default=None, description="which numbers of the drive an action has")
    acceleration: Annotated[float, _ACCELERATION] | None = Field(
        default=80.0, description="the most that the drive's sines may give the plate"
    )
    ramp: Annotated[float, _RAMP] = Field(default=0.05, description="in which the drive goes over to the next motion")
    rate: Annotated[float, _RATE] = Field(default=60.0, description="actions per second")
    camera: Camera = Field(default_factory=Camera, description="what sees the sheet")
    reach: tuple[Length, Length] = Field(
        default=(0.04, 0.04),
        description="starts and goals lie so far from the plate's middle, at most, along the bar and across it",
    )
    position_tolerance: Length = Field(default=0.003, description="how near to the goal is there")
    angle_tolerance: Annotated[float, _TURN] = Field(
        default=math.radians(5), description="how near to the goal is there"
    )
    hold: Duration = Field(default=2.0, description="how long the sheet must stay there")
    time_limit: Duration = Field(default=20.0, description="after which an episode is cut off")
    variation: Variation = Field(default_factory=Variation, description="what differs from episode to episode")
    threads: int | None = Field(default=None, ge=1, description="cores to use; all by default")

    @field_validator("objects", mode="before")
    @classmethod
    def _as_scenarios(cls, value: Any) -> Any:
        given = [value] if isinstance(value, (str, Path)) or not isinstance(value, Sequence) else list(value)
        return tuple(s if s.plate else s.with_valid(plate=PLATE) for s in scenarios_of(given))

    @field_validator("machine", mode="before")
    @classmethod
    def _as_machine(cls, value: Any) -> Any:
        return machine_of(value) if isinstance(value, (str, Path)) else value

    @field_validator("reach", mode="before")
    @classmethod
    def _as_pair(cls, value: Any) -> Any:
        return value if isinstance(value, (tuple, list)) else (value, value)

    @field_validator("free", mode="before")
    @classmethod
    def _as_names(cls, value: Any) -> Any:
        return (value,) if isinstance(value, str) else value

    @model_validator(mode="after")
    def _fits_together(self) -> PoseOptions:
        if self.actions != "drive":
            told = [name for name in ("free", "acceleration", "ramp") if name in self.model_fields_set]  # type: ignore[attr-defined]
            if told:
                raise InputError(told[0], "given", "left out where motions are chosen from", 'actions="drive"')
            if not self.actions:
                raise InputError("actions", "no motion", '"drive", or motions to choose from', '"drive"')
            if any(motion.ramp <= SHORTEST_RAMP for motion in self.actions):
                raise InputError("actions", "a motion without a ramp", "above 0 s where motions change", '"0.1 s"')
        if self.hold >= self.time_limit:
            raise InputError("hold", f"{self.hold:g} s", f"below the time_limit, {self.time_limit:g} s", '"2 s"')
        # Every scenario that may be drawn must be one: the ends are, and what lies between them.
        for scenario in self.objects:
            for corner in ((0.0, 0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 1.0), (0.0, 1.0, 1.0, 0.0), (1.0, 1.0, 1.0, 1.0)):
                _ = self.variation.drawn(scenario, corner).replace()
        return self

    def scenario(self, lane: int, start: Array, shares: Sequence[float]) -> Scenario:
        """Scenario of an episode: what varies at four shares, the sheet laid at a start (3,), m and rad."""
        x, y, angle = (float(number) for number in start)
        drawn = self.variation.drawn(self.objects[lane % len(self.objects)], shares)
        return drawn.with_valid(start=Start().with_valid(x=x, y=y, angle=angle))
