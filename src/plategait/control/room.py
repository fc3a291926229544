"""Where an object lies wholly on its plate."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.model.presets import Preset, as_scenario
from plategait.model.scenario import Plate, Scenario

PLATE = 0.2
"""Length and width of the plate where the scenario has none, m."""
MARGIN = 5e-3
"""What is to be left between an object and the edge of its plate, m."""


def on_a_plate(scenario: Scenario | Preset | Path | str) -> Scenario:
    """Scenario on a plate that ends, free to travel."""
    made = as_scenario(scenario, "scenario")
    return made.replace(slip_limit=1.0, plate=made.plate or Plate(length=PLATE, width=PLATE))


def room_of(scenario: Scenario) -> Array:
    """(2,) how far from the middle an object's centre may be, along the bar and across it, with all of it on the plate.

    Raises
    ------
    InputError
        For a plate that is too small for the object.
    """
    plate = scenario.plate or Plate(length=PLATE, width=PLATE)
    room = np.array([plate.length, plate.width]) / 2 - max(scenario.sheet.outline.size()) / 2
    if room.min() <= 5e-3:
        size = 1e3 * max(scenario.sheet.outline.size())
        raise InputError("plate", f"{1e3 * plate.length:g} mm by {1e3 * plate.width:g} mm",
                         f"larger than the object, {size:g} mm, by 10 mm at least",
                         f'"{size + 100:.0f} mm"')  # fmt: skip
    return room
