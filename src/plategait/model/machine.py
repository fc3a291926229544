"""Machines that shake a plate: what each degree of freedom can do, and what it has to move."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import Annotated

import numpy as np
from pydantic import Field, model_validator

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.files.toml import read_toml
from plategait.model.base import Kept, Model
from plategait.model.motion import AXES
from plategait.theory.rigid import inertial_loads
from plategait.units import Quantity

_M_S2 = Quantity("m/s^2", "m/s^2", "50 m/s^2", above=0)
_DEG_S2 = Quantity("rad/s^2", "deg/s^2", "50000 deg/s^2", above=0)
_INERTIA = Quantity("kg*m^2", "kg*m^2", "4.5e-5 kg*m^2", above=0)
_POWER = Quantity("W", "W", "50 W", above=0)


class Sliding(Model):
    """Limits of a translation; what is left out has none."""

    stroke: Annotated[float, Quantity("m", "mm", "3 mm", above=0, at_most=10)] | None = Field(
        default=None, description="furthest from its rest"
    )
    speed: Annotated[float, Quantity("m/s", "mm/s", "500 mm/s", above=0)] | None = Field(default=None)
    acceleration: Annotated[float, _M_S2] | None = Field(default=None)
    jerk: Annotated[float, Quantity("m/s^3", "m/s^3", "1e4 m/s^3", above=0)] | None = Field(default=None)
    force: Annotated[float, Quantity("N", "N", "20 N", above=0)] | None = Field(default=None)

    @property
    def limits(self) -> tuple[float | None, ...]:
        """Position, speed, acceleration, jerk, load."""
        return self.stroke, self.speed, self.acceleration, self.jerk, self.force


class Turning(Model):
    """Limits of a rotation; what is left out has none."""

    angle: Annotated[float, Quantity("rad", "deg", "24 deg", above=0)] | None = Field(
        default=None, description="furthest from its rest"
    )
    speed: Annotated[float, Quantity("rad/s", "deg/s", "2000 deg/s", above=0)] | None = Field(default=None)
    acceleration: Annotated[float, _DEG_S2] | None = Field(default=None)
    jerk: Annotated[float, Quantity("rad/s^3", "deg/s^3", "1e7 deg/s^3", above=0)] | None = Field(default=None)
    torque: Annotated[float, Quantity("N*m", "N*m", "1 N*m", above=0)] | None = Field(default=None)

    @property
    def limits(self) -> tuple[float | None, ...]:
        """Position, speed, acceleration, jerk, load."""
        return self.angle, self.speed, self.acceleration, self.jerk, self.torque


class Machine(Model):
    """What shakes a plate. A degree of freedom that is left out cannot be moved.

    The loads are those of section 2.2.1 of the dissertation: the plate's mass and moments of inertia, the latter across
    the bar with its mass at the end of an arm L. A support carries the weight.
    """

    name: str = Field(default="machine", description="what the results call it", examples=['"my shaker"'])
    frequency: Annotated[float, Quantity("Hz", "Hz", "40 Hz", above=0)] | None = Field(
        default=None, description="of its fastest sine"
    )
    x: Sliding | None = Field(default=None, description="along the bar", examples=['{ stroke = "3 mm" }'])
    y: Sliding | None = Field(default=None, description="across the bar", examples=['{ stroke = "3 mm" }'])
    z: Sliding | None = Field(default=None, description="upwards", examples=['{ stroke = "3 mm" }'])
    rx: Turning | None = Field(default=None, description="about the bar", examples=['{ angle = "24 deg" }'])
    ry: Turning | None = Field(default=None, description="about y", examples=['{ angle = "24 deg" }'])
    rz: Turning | None = Field(default=None, description="about z", examples=['{ angle = "24 deg" }'])
    plate_mass: Annotated[float, Quantity("kg", "g", "54 g", above=0, at_most=1000)] | None = Field(
        default=None, description="m_p, of the plate and what is fixed to it"
    )
    inertia_x: Annotated[float, _INERTIA] | None = Field(default=None, description="I_x about the bar")
    inertia_y: Annotated[float, _INERTIA] | None = Field(default=None, description="I_y")
    inertia_z: Annotated[float, _INERTIA] | None = Field(default=None, description="I_z")
    arm: Annotated[float, Quantity("m", "mm", "500 mm", at_least=0, at_most=100)] = Field(
        default=0.0, description="L, from the drives to the plate's centre of mass"
    )
    power: Annotated[float, _POWER] | None = Field(default=None, description="of all drives together")

    @model_validator(mode="after")
    def _loads_are_known(self) -> Machine:
        told = [self.plate_mass, self.inertia_x, self.inertia_y, self.inertia_z]
        limited = self.power is not None or bool(
            np.isfinite(self.limits[4][[bool(getattr(self, a)) for a in AXES]]).any()
        )
        if None in told and (limited or any(value is not None for value in told)):
            field = ("plate_mass", "inertia_x", "inertia_y", "inertia_z")[told.index(None)]
            example = "54 g" if field == "plate_mass" else _INERTIA.example
            raise InputError(field, "nothing", "given with the other masses, which loads and power follow from",
                             f'{field} = "{example}"')  # fmt: skip
        return self

    @property
    def limits(self) -> Array:
        """(5, 6) largest position, speed, acceleration, jerk and load of each degree of freedom, SI; ∞ without limit.

        Zero for a degree of freedom that cannot be moved.
        """
        limits = self._limits.array
        assert limits is not None
        return limits

    @cached_property
    def _limits(self) -> Kept:
        rows = [(axis.limits if (axis := getattr(self, name)) else (0.0,) * 5) for name in AXES]
        limits = np.array([[np.inf if limit is None else limit for limit in row] for row in rows]).T
        limits.flags.writeable = False
        return Kept(limits)

    @cached_property
    def limits_rates(self) -> bool:
        """Whether it limits more than frequency and position: a speed, acceleration, jerk, load or the power."""
        moved = np.array([getattr(self, name) is not None for name in AXES])
        return self.power is not None or bool(np.isfinite(self.limits[1:, moved]).any())

    @property
    def inertial_loads(self) -> Array:
        """(6,) what each degree of freedom has to move, kg and kg·m²; NaN where it is not told."""
        if self.plate_mass is None or self.inertia_x is None or self.inertia_y is None or self.inertia_z is None:
            return np.full(len(AXES), np.nan)
        return inertial_loads(self.plate_mass, (self.inertia_x, self.inertia_y, self.inertia_z), self.arm)


MACHINES: Mapping[str, Machine] = {
    "source-robot": Machine(
        name="source-robot", frequency="40 Hz", x=Sliding(stroke="3 mm"), rx=Turning(angle="24 deg"),
        # The plate measures 100 mm by 100 mm (2.2.2). Its mass is not told: that of 2 mm of aluminium is taken, and
        # half a metre for the "long bar", which the two degrees of freedom do not feel.
        plate_mass="54 g", inertia_x=4.5e-5, inertia_y=4.5e-5, inertia_z=9.0e-5, arm="500 mm",
    ),
    "planar": Machine(
        name="planar", frequency="40 Hz", x=Sliding(stroke="3 mm"), y=Sliding(stroke="3 mm"), rz=Turning(angle="6 deg"),
        plate_mass="54 g", inertia_x=4.5e-5, inertia_y=4.5e-5, inertia_z=9.0e-5,
    ),
    "six-axis": Machine(
        name="six-axis", frequency="40 Hz", x=Sliding(stroke="3 mm"), y=Sliding(stroke="3 mm"),
        z=Sliding(stroke="3 mm"), rx=Turning(angle="24 deg"), ry=Turning(angle="24 deg"), rz=Turning(angle="6 deg"),
        plate_mass="54 g", inertia_x=4.5e-5, inertia_y=4.5e-5, inertia_z=9.0e-5,
    ),
}  # fmt: skip
"""Machines by name. The source's robot slides 3 mm along its bar and turns it by 24 deg, up to 40 Hz.

`planar` and `six-axis` are nobody's: the source's plate on the degrees of freedom of the Universal Planar Manipulator
(Reznik and Canny 1998) and of PPOD (Vose, Umbanhowar and Lynch 2009), with the source's amplitudes.
"""


def machine_of(told: Machine | Path | str, field: str = "machine") -> Machine:
    """Machine of what tells one: itself, a name of `MACHINES`, or a TOML file.

    Parameters
    ----------
    told : Machine, Path or str
        A machine, its name, or its file.
    field : str, optional
        What errors call it.

    Raises
    ------
    InputError
        When there is none, or the file is not as it must be.
    """
    if isinstance(told, Machine):
        return told
    if isinstance(told, str) and told in MACHINES:
        return MACHINES[told]
    data, _ = read_toml(told, field, f"a machine's file or one of {', '.join(MACHINES)}", next(iter(MACHINES)))
    return Machine(**data)
