"""The plate in MJCF, and what drives it: a rotor for each sine, which MuJoCo turns by itself.

MJCF has no functions of time. A heavy rotor that turns at a constant rate carries a pin at the sine's amplitude; a line
from the pin to a point very far away is then shorter by amplitude · sin(2π f t + phase), and an equality of tendons
moves the plate's joint by what its lines are shorter by together. So a file runs without a line of code, in any viewer.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from xml.etree import ElementTree as ET

import numpy as np

from plategait.arrays import Array
from plategait.export.mjcf.markup import Value, add
from plategait.model.course import course_of, kinematics
from plategait.model.motion import AXES, PlateMotion
from plategait.model.scenario import Scenario

# The far point, in amplitudes: its line is straight within a part in twice as many.
_FAR = 1e5
# Nothing on the plate is heavier than a millionth of these, kg and kg m².
_ROTOR, _PLATE, _PLATE_INERTIA = 1e6, 100.0, 1.0
_HALF_THICKNESS, _ENDLESS = 0.005, 1.0
# The plate follows within 1e-4 of what it is pulled by otherwise, MuJoCo's most.
_TIGHT = (0.9999, 0.9999, 0.001, 0.5, 2.0)
# Share of the smooth start after which a rotor has all but 1/e of its rate.
_SHARE_OF_RAMP = 0.2


@dataclass(frozen=True)
class PlateState:
    """Position and speed of the plate's joints and of the rotors, in the order of MuJoCo's."""

    position: tuple[float, ...]
    speed: tuple[float, ...]


def start_of_plate(motion: PlateMotion) -> Array:
    """(6,) pose of a plate that moves at once."""
    return kinematics(course_of(motion), np.zeros(1)).position[:, 0]


def add_plate(
    world: ET.Element, sections: Mapping[str, ET.Element], scenario: Scenario, motion: PlateMotion, time_step: float
) -> PlateState:
    """Add plate, rotors, their lines and equalities; give the state at full speed at time 0."""
    terms = motion.terms()
    moved = [d for d in range(len(AXES)) if motion.offset.pose[d] or any(term[0] == d for term in terms)]
    start = kinematics(course_of(motion), np.zeros(1))
    position, speed = [], []
    for i, (_, amplitude, frequency, phase) in enumerate(terms):
        _add_rotor(world, sections["actuator"], i, amplitude, frequency, phase, scenario.motion.ramp)
        position.append(0.0)
        speed.append(2 * math.pi * frequency)
    plate = add(world, "body", name="plate", pos=(0.0, 0.0, -motion.height), gravcomp=1.0)
    add(plate, "inertial", pos=(0.0, 0.0, 0.0), mass=_PLATE, diaginertia=(_PLATE_INERTIA,) * 3)
    for d in moved:
        kind = "hinge" if AXES[d].startswith("r") else "slide"
        add(plate, "joint", name=AXES[d], type=kind, axis=tuple(np.eye(3)[d % 3]))
        position.append(float(start.position[d, 0]))
        speed.append(float(start.speed[d, 0]))
        _add_drive(
            sections, d, [i for i, term in enumerate(terms) if term[0] == d], motion, start.position[d, 0], time_step
        )
    _add_top(plate, scenario)
    return PlateState(tuple(position), tuple(speed))


def _add_rotor(
    world: ET.Element, actuators: ET.Element, i: int, amplitude: float, frequency: float, phase: float, ramp: float
) -> None:
    """One sine: a rotor with a pin, its far point, and what brings it to its rate and keeps it there."""
    size, turn = abs(amplitude), 2 * math.pi * phase + (math.pi if amplitude < 0 else 0.0)
    rotor = add(world, "body", name=f"rotor{i}", pos=(0.0, 0.0, -1.0))
    add(rotor, "inertial", pos=(0.0, 0.0, 0.0), mass=_ROTOR, diaginertia=(_ROTOR,) * 3)
    add(rotor, "joint", name=f"rotor{i}", type="hinge", axis=(0.0, 0.0, 1.0))
    add(rotor, "site", name=f"pin{i}", pos=(size * math.sin(turn), -size * math.cos(turn), 0.0), group=5, size=(1e-4,))
    add(world, "site", name=f"far{i}", pos=(size * _FAR, 0.0, -1.0), group=5, size=(1e-4,))
    rate, gain = 2 * math.pi * frequency, _ROTOR / max(_SHARE_OF_RAMP * ramp, 1e-3)
    add(actuators, "general", name=f"rate{i}", joint=f"rotor{i}", gainprm=(0.0,), biastype="affine",
        biasprm=(gain * rate, 0.0, -gain))  # fmt: skip


def _add_drive(
    sections: Mapping[str, ET.Element], d: int, sines: list[int], motion: PlateMotion, start: float, time_step: float
) -> None:
    """What moves one joint of the plate: all its lines together, or its offset alone."""
    axis, tendons, equality = AXES[d], sections["tendon"], sections["equality"]
    tight: dict[str, Value] = {"solref": (2 * time_step, 1.0), "solimp": _TIGHT}
    if not sines:
        add(equality, "joint", joint1=axis, polycoef=(motion.offset.pose[d], 0.0, 0.0, 0.0, 0.0), **tight)
        return
    lines = add(tendons, "spatial", name=f"lines_{axis}", group=5, rgba=(0.0, 0.0, 0.0, 0.0))
    for n, i in enumerate(sines):
        if n:
            add(lines, "pulley", divisor=1.0)
        add(lines, "site", site=f"far{i}")
        add(lines, "site", site=f"pin{i}")
    add(add(tendons, "fixed", name=f"plate_{axis}"), "joint", joint=axis, coef=1.0)
    add(equality, "tendon", tendon1=f"plate_{axis}", tendon2=f"lines_{axis}", polycoef=(start, -1.0, 0.0, 0.0, 0.0),
        **tight)  # fmt: skip


def _add_top(plate: ET.Element, scenario: Scenario) -> None:
    """The plate's surface, half a sheet lower: this package's contact is at the sheet's middle."""
    radius = 0.5 * scenario.sheet.thickness
    half = (_ENDLESS, _ENDLESS)
    if scenario.plate is not None:
        half = (0.5 * scenario.plate.length, 0.5 * scenario.plate.width)
    add(plate, "geom", name="plate", type="box", size=(*half, _HALF_THICKNESS), contype=0, conaffinity=1,
        pos=(0.0, 0.0, scenario.motion.height - radius - _HALF_THICKNESS), rgba=(0.8, 0.82, 0.85, 1.0))  # fmt: skip
