"""A scenario: one sheet on one plate motion, with everything a run needs. Read from and written to TOML."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated

from pydantic import Field, model_validator

from plategait.errors import InputError
from plategait.model.base import Model
from plategait.model.contact import Contact, Friction
from plategait.model.motion import PlateMotion
from plategait.model.sheet import Sheet
from plategait.units import Acceleration, Angle, Delay, Duration, Length, Offset, Quantity

# Step that the reference disk's spin rates allow within 1 % r.m.s. (docs/numerics.md), and the share of the stable step
# that stiffer or finer sheets take.
LARGEST_TIME_STEP = 1e-4
SHARE_OF_STABLE_STEP = 0.85
STEPS_PER_SINE = 20
MOST_STEPS = 2e9


class Start(Model):
    """Where the object lies at the start, about the middle of the plate."""

    x: Offset = Field(default=0.0, description="along the bar")
    y: Offset = Field(default=0.0, description="across the bar")
    angle: Angle = Field(default=0.0, description="orientation")


class Plate(Model):
    """Size of the plate; the source takes it as large enough never to drop the object.

    Source: what its edge was held against is in docs/numerics.md; the dissertation's plate has none.
    """

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
