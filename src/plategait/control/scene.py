"""Pictures of the task: the sheet on its plate, with the goal marked."""

from __future__ import annotations

import numpy as np

from plategait.arrays import Array, Picture
from plategait.control.task import PoseTask
from plategait.model.sheet import Sheet
from plategait.render.painter import Painter

# Of a picture, px.
SIZE = (480, 360)
# Squares of the grid on which an outline is traced, across the sheet.
_FINE = 96


class Scene:
    """Draws a task's lanes; keeps the painter of each object.

    Parameters
    ----------
    size : (width, height)
        px.
    """

    def __init__(self, size: tuple[int, int]) -> None:
        self.size = size
        self._painters: dict[tuple[int, float], Painter] = {}
        self._outlines: dict[int, list[Array]] = {}

    def picture(self, task: PoseTask, lane: int) -> Picture:
        """Picture of a lane as it is now: (height, width, 3) bytes."""
        session = task.plant.session
        scenario = session.scenarios[lane]
        which = lane % len(task.options.objects)
        key = (which, scenario.motion.height)
        if key not in self._painters:
            self._painters[key] = Painter(scenario, np.zeros((1, 6)), self.size)
        if which not in self._outlines:
            self._outlines[which] = traced(scenario.sheet)
        x, y, angle = task.goal[lane]
        turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
        marked = [line @ turn + (x, y) for line in self._outlines[which]]
        nodes, pose = session.shape(lane)
        if not (np.isfinite(nodes).all() and np.isfinite(pose).all()):
            nodes = np.full_like(nodes, 1e3)  # nowhere in sight
        return np.asarray(self._painters[key].picture(nodes, np.nan_to_num(pose), marked))


def traced(sheet: Sheet) -> list[Array]:
    """Closed lines (n, 2), m, around a sheet about the middle of its nodes, and one from there to its rim along x."""
    from contourpy import contour_generator

    extent = np.array(sheet.outline.size())
    step = float(extent.max()) / _FINE
    x, y = (np.arange(-half - step, half + 1.5 * step, step) for half in extent / 2)
    inside = sheet.outline.contains(*(axis.ravel() for axis in np.meshgrid(x, y))).reshape(len(y), len(x))
    lattice = sheet.lattice
    middle = (lattice.squares.mean(axis=0) - (np.array(lattice.occupied.shape) - 1) / 2) * sheet.pitch
    lines = [np.asarray(line) - middle for line in contour_generator(x, y, inside.astype(float)).lines(0.5)]
    rim = max((float(line[np.abs(line[:, 1]) < 2 * step, 0].max(initial=0.0)) for line in lines), default=0.0)
    return [*lines, np.array([[0.0, 0.0], [rim, 0.0]])]
