"""Frames of runs for looking at the picture: sheets of all outlines as the native core moves them.

The forces that the frames hold are made up from how deep nodes lie, for their marks to be looked at: the page's own
come from the core.
"""

from __future__ import annotations

import base64
import json
import math

import numpy as np

from plategait import Disk, Ellipse, Mask, Plate, Polygon, Rectangle, Scenario, preset, simulate
from plategait.model.motion import rotation_of

FISH = (
    (-55, 0), (-40, 14), (-15, 20), (12, 14), (30, 8), (52, 24), (46, 0), (52, -24), (30, -8), (12, -14), (-15, -20),
    (-40, -14),
)  # fmt: skip
"""Corners, mm."""
FOLD = 0.012  # m; radius that a sheet is turned over with


def leaf() -> tuple[str, ...]:
    """A leaf with a stalk, as rows of text."""
    x, y = np.meshgrid(np.linspace(-1, 1, 160), np.linspace(0.7, -0.7, 112))
    lobes = 0.42 * np.clip(1 - x**2, 0, None) ** 0.8 * (1 + 0.18 * np.cos(9 * x))
    dark = (np.abs(y - 0.08 * x) < lobes) | ((np.abs(y - 0.08 * x) < 0.08) & (x > -1) & (x < 0.2))
    return tuple("".join("#" if d else "." for d in row) for row in dark)


def sheet(outline: Disk | Ellipse | Mask | Polygon | Rectangle, pitch: float, **more: object) -> Scenario:
    """Cheese of another outline, about as heavy for its area."""
    base = preset("cheese").scenario
    mass = base.sheet.mass * math.prod(outline.size()) / 0.08**2
    return base.replace(**{"sheet.outline": outline, "sheet.pitch": pitch, "sheet.mass": mass, **more})


def cases() -> dict[str, Scenario]:
    """What is looked at."""
    cheese = preset("cheese").scenario
    return {
        "cheese": cheese,
        "plate": cheese.replace(plate=Plate(length=0.15, width=0.12)),
        "folded": cheese,
        "fish": sheet(Polygon(corners=tuple((x / 1000, y / 1000) for x, y in FISH)), 0.005),
        "leaf": sheet(Mask(width_of_picture=0.12, rows=leaf()), 0.005),
        "ellipse": sheet(Ellipse(length=0.12, width=0.05), 0.008),
        "rectangle": sheet(Rectangle(length=0.1, width=0.06), 0.01, **{"start.angle": 0.5}),
        "fine": sheet(Disk(radius=0.04), 0.0025),
    }


def turned_over(nodes: np.ndarray) -> np.ndarray:
    """Shapes (n, nodes, 3) with what is far along x rolled up and back over the rest."""
    past = nodes[..., 0] - nodes[..., 0].mean(axis=1, keepdims=True) - FOLD
    angle = np.clip(past / FOLD, 0, math.pi)
    x = FOLD * np.sin(angle) - np.maximum(past - math.pi * FOLD, 0)
    folded = nodes.copy()
    folded[..., 0] = np.where(past > 0, nodes[..., 0] - past + x, nodes[..., 0])
    folded[..., 2] += np.where(past > 0, FOLD * (1 - np.cos(angle)), 0)
    return folded


def packed(values: np.ndarray) -> str:
    """Numbers as text: single precision, base 64."""
    return base64.b64encode(np.ascontiguousarray(values, dtype=np.float32).tobytes()).decode()


def frames_of(name: str, duration: float) -> dict[str, object]:
    """A run's frames, every 4 ms, as `view_page.js` takes them."""
    scenario = cases()[name].replace(duration=duration)
    recording = simulate(scenario, snapshot_interval=0.004).recordings[0]
    nodes, pose, time = recording.snapshots, recording.plate_pose, recording.snapshot_time
    if name == "folded":
        nodes = turned_over(nodes)
    turn, height = rotation_of(pose), np.array([0, 0, scenario.motion.height])
    origin = pose[:, :3] + turn @ height - height
    onto = np.einsum("tnd,tde->tne", nodes - origin[:, None], turn)
    normal = np.maximum(-onto[..., 2], 0) * scenario.contact.stiffness * scenario.sheet.pitch**2
    normal /= scenario.contact.tile_area
    speed = np.gradient(onto[..., :2], time, axis=0)
    size = np.linalg.norm(speed, axis=-1, keepdims=True)
    friction = -scenario.friction.kinetic * normal[..., None] * speed / np.maximum(size, 0.06)
    return {
        "scenario": json.loads(scenario.model_dump_json()),
        "time": time.tolist(),
        "nodes": packed(nodes),
        "pose": packed(pose),
        "forces": packed(np.concatenate([normal[..., None], friction], axis=-1)),
        "count": len(time),
    }
