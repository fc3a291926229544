"""Films of a steering: the object on its plate in real time, its goal or path, and the way that it has gone."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.control.plant import Plant
from plategait.control.scene import traced
from plategait.control.steer import Steering
from plategait.model.scenario import Scenario
from plategait.render.film import film_file
from plategait.render.painter import MARK, Painter
from plategait.render.text import write_text

if TYPE_CHECKING:
    from PIL.Image import Image

FPS = 30
"""Frames per second: every other tick."""
_EVERY = 2
SIZE = (960, 540)
# The way that it has gone, and the middle of the object.
_TRACE, _MIDDLE = (0, 114, 178), (0, 70, 130)
# Of the mark at the object's middle, m.
_CROSS = 2.5e-3


@dataclass(eq=False)
class Shots:
    """Shapes of a sheet while it is steered: pass it as `each_tick`."""

    ticks: int = 0
    nodes: list[NDArray[np.float32]] = field(default_factory=list)
    plates: list[Array] = field(default_factory=list)

    def __call__(self, plant: Plant, time: float) -> None:
        """Take the shape of the first lane, of every other tick."""
        if self.ticks % _EVERY == 0:
            nodes, plate = plant.session.shape(0)
            self.nodes.append(nodes.astype(np.float32))
            self.plates.append(plate)
        self.ticks += 1


def film_steering(
    shots: Shots,
    way: Steering,
    scenario: Scenario,
    path: Path | str,
    *,
    strokes: Sequence[Array] = (),
    progress: Callable[[float], object] | None = None,
) -> Path:
    """Film a steering in real time: H.264 in an MP4 file.

    Parameters
    ----------
    shots : Shots
        As taken while it was steered.
    way : Steering
    scenario : Scenario
    path : Path or str
        File to write, ending in .mp4.
    strokes : sequence of (n, 2) arrays
        Of the path that was to be followed, m; the goals' outlines are drawn without any.
    progress : callable, optional
        Called with the fraction done.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    painter = Painter(scenario, np.array(shots.plates).reshape(-1, 6), SIZE)
    outline = [] if len(strokes) else traced(scenario.sheet)
    with film_file(path, SIZE, FPS) as add:
        for k, (nodes, plate) in enumerate(zip(shots.nodes, shots.plates, strict=True)):
            tick = min(k * _EVERY, len(way.poses) - 1)
            if not np.isfinite(nodes).all():
                break
            under = [_laid(line, way.aims[tick]) for line in outline]
            over = [(line, MARK) for line in strokes]
            over += [(way.poses[: tick + 1, :2], _TRACE), *((line, _MIDDLE) for line in _cross(way.poses[tick]))]
            picture = painter.picture(nodes.astype(float), plate, under, over)
            _caption(picture, scenario, way, tick, bool(len(strokes)))
            add(picture)
            if progress is not None:
                progress((k + 1) / len(shots.nodes))
    return Path(path)


def _laid(line: Array, pose: Array) -> Array:
    """A line about an object's middle, where the object has a pose; as it is drawn where any angle will do."""
    x, y, angle = np.nan_to_num(pose)
    turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    return line @ turn + (x, y)


def _cross(pose: Array) -> list[Array]:
    """A cross at the object's middle, its longer arm the way that it looks."""
    arms = [np.array([[-1.0, 0.0], [2.5, 0.0]]), np.array([[0.0, -1.0], [0.0, 1.0]])]
    return [_laid(_CROSS * arm, pose) for arm in arms]


def _caption(picture: Image, scenario: Scenario, way: Steering, tick: int, along: bool) -> None:
    from PIL import ImageDraw

    draw, (width, height) = ImageDraw.Draw(picture), picture.size
    unit, off = height / 720, way.poses[tick] - way.aims[tick]
    write_text(draw, (width - 32 * unit, 28 * unit), scenario.name, 34 * unit, "rt", width / 2, bold=True)
    told = f"{1e3 * math.hypot(off[0], off[1]):.1f} mm"
    if math.isfinite(off[2]):
        told += f", {abs(math.degrees(math.remainder(off[2], 2 * math.pi))):.0f} deg"
    if not along:
        write_text(draw, (width - 32 * unit, 76 * unit), f"to the goal: {told}", 22 * unit, "rt", width * 0.55)
    write_text(draw, (32 * unit, height - 30 * unit), f"{way.times[tick]:6.2f} s", 26 * unit, "ls")
    write_text(draw, (width - 32 * unit, height - 30 * unit), "real time", 22 * unit, "rs")
