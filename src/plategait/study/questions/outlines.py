"""Outlines that the studies put beside the disk: some as long as wide, some oblong, a leaf and a fish."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from plategait.model.outline import Disk, Ellipse, Outline, Polygon, Rectangle
from plategait.model.scenario import Scenario
from plategait.model.sheet import Sheet
from plategait.model.similarity import equivalent_radius

_LEAF = [(x, 0.42 * side * (1 - x * x)) for side in (1, -1) for x in side * np.linspace(-1, 1, 17)]
_FISH_BACK = [(-1.0, 0.35), (-0.62, 0.12), (-0.2, 0.36), (0.25, 0.42), (0.65, 0.32), (0.95, 0.1)]
_FISH = [*_FISH_BACK, (1.0, 0.0), *((x, -y) for x, y in reversed(_FISH_BACK))]

SHAPES: dict[str, Callable[[float], Outline]] = {
    "disk": lambda r: Disk(radius=r),
    "square": lambda r: Rectangle(length=1.75 * r, width=1.75 * r),
    "ellipse 5:4": lambda r: Ellipse(length=2.24 * r, width=1.79 * r),
    "ellipse 3:2": lambda r: Ellipse(length=2.4 * r, width=1.6 * r),
    "ellipse 2:1": lambda r: Ellipse(length=2.8 * r, width=1.4 * r),
    "rectangle 8:5": lambda r: Rectangle(length=2.1 * r, width=1.3 * r),
    "leaf": lambda r: _polygon(_LEAF, 1.6 * r),
    "fish": lambda r: _polygon(_FISH, 1.5 * r),
}
"""Outlines about as large as a disk of a radius, m."""


def _polygon(corners: list[tuple[float, float]], size: float) -> Polygon:
    return Polygon(corners=tuple((float(size * x), float(size * y)) for x, y in corners))


def cut_to(scenario: Scenario, shape: str) -> Scenario:
    """Scenario with its disk cut to a shape of the same radius of gyration, material and thickness.

    The lattice has steps of its pitch: the radius is met within 5 %, and what it is, the sheet tells.
    """
    sheet = scenario.sheet
    wanted, size = equivalent_radius(sheet.lattice, sheet.pitch), max(sheet.outline.size()) / 2
    cut: Sheet = sheet
    for _ in range(8):
        cut = sheet.replace(outline=SHAPES[shape](size))
        size *= (wanted / equivalent_radius(cut.lattice, cut.pitch)) ** 0.7
    return scenario.replace(sheet=cut.replace(mass=sheet.node_mass * cut.lattice.n_nodes))
