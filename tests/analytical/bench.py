"""Small sheets on a bench: single nodes, strips and plates set going by hand, in double precision."""

from __future__ import annotations

import numpy as np

from plategait.engine import cpu
from plategait.engine.recording import Recording, RunRequest
from plategait.model.contact import Contact, Friction
from plategait.model.motion import PlateMotion
from plategait.model.outline import Rectangle
from plategait.model.scenario import Plate, Scenario
from plategait.model.sheet import Sheet

STILL = PlateMotion(frequency=100.0, angle=0.0, stroke=0.0, ramp=0.0)


def strip(length: int, width: int = 1, *, pitch: float = 0.01, **fields) -> Sheet:
    """A strip of length × width nodes, of the cheese's material unless told otherwise."""
    material = {
        "mass": 2.6e-4 * length * width * (pitch / 0.01) ** 2,
        "bending_stiffness": 1.56e-4,
        "axial_stiffness": 790.0,
        "axial_damping": 0.49,
    }
    return Sheet(outline=Rectangle(length=length * pitch, width=width * pitch), pitch=pitch, **{**material, **fields})


def run(
    sheet: Sheet,
    *,
    duration: float,
    dt: float,
    positions=None,
    velocities=None,
    held=None,
    motion: PlateMotion = STILL,
    gravity: float = 9.81,
    contact: Contact | None = None,
    friction: Friction | None = None,
    plate: Plate | None = None,
    snapshots: int = 0,
) -> Recording:
    """Advance one sheet from given positions and velocities; shapes are kept every so many steps."""
    scenario = Scenario(
        sheet=sheet, motion=motion, duration=duration, time_step=dt, gravity=gravity,
        contact=contact or Contact(), friction=friction or Friction(), plate=plate,
    )  # fmt: skip
    if snapshots:
        # Samples follow the plate's period, 24 in each: that of a still plate may be anything.
        scenario = scenario.replace(motion=motion.replace(frequency=1 / (24 * snapshots * dt)))
    start = None
    if positions is not None:
        positions = np.asarray(positions, dtype=float)
        start = (positions, np.zeros_like(positions) if velocities is None else np.asarray(velocities, dtype=float))
    return cpu.run([RunRequest(scenario, initial=start, held=held, snapshot_interval=snapshots * dt)], "float64")[0]


def flat(sheet: Sheet, height: float = 0.0) -> np.ndarray:
    """Positions of a flat sheet at a height."""
    rest = sheet.lattice.rest * sheet.pitch
    return np.column_stack([rest, np.full(len(rest), height)])


def observed_order(errors, steps) -> float:
    """Rate at which errors shrink with the step."""
    return float(np.polyfit(np.log(steps), np.log(np.abs(errors)), 1)[0])
