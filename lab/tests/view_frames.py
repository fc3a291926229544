"""Frames of runs for looking at the picture: `python view_frames.py OUT.json` simulates several sheets.

The forces that the frames hold are made up from how deep nodes lie, for their marks to be looked at: the page's own
come from the core.
"""

from __future__ import annotations

import base64
import json
import math
import sys
from pathlib import Path

import numpy as np

from plategait import Disk, Ellipse, Mask, Plate, Polygon, Rectangle, Scenario, preset, simulate
from plategait.model.motion import rotation_of

FISH = tuple(
    (0.001 * x, 0.001 * y)
    for x, y in [
        (-55, 0),
        (-40, 14),
        (-15, 20),
        (12, 14),
        (30, 8),
        (52, 24),
        (46, 0),
        (52, -24),
        (30, -8),
        (12, -14),
        (-15, -20),
        (-40, -14),
    ]
)


def leaf() -> tuple[str, ...]:
    """A leaf with a stalk, as rows of text."""
    x, y = np.meshgrid(np.linspace(-1, 1, 160), np.linspace(0.7, -0.7, 112))
    lobes = 0.42 * np.clip(1 - x**2, 0, None) ** 0.8 * (1 + 0.18 * np.cos(9 * x))
    dark = (np.abs(y - 0.08 * x) < lobes) | ((np.abs(y - 0.08 * x) < 0.08) & (x > -1) & (x < 0.2))
    return tuple("".join("#" if d else "." for d in row) for row in dark)


def sheet(outline: object, pitch: float, **more: object) -> Scenario:
    """Cheese of another outline, as heavy for its area."""
    base = preset("cheese").scenario
    area = outline.size()[0] * outline.size()[1] * (math.pi / 4 if isinstance(outline, Disk | Ellipse) else 1.0)  # type: ignore[attr-defined]
    mass = base.sheet.mass * area / (math.pi * 0.04**2)
    return base.replace(**{"sheet.outline": outline, "sheet.pitch": pitch, "sheet.mass": mass, **more})


def cases() -> dict[str, Scenario]:
    """What is looked at."""
    cheese = preset("cheese").scenario
    return {
        "cheese": cheese,
        "plate": cheese.replace(plate=Plate(length=0.15, width=0.12)),
        "soft": cheese.replace(
            **{"sheet.bending_stiffness": 0.3 * cheese.sheet.bending_stiffness, "motion.frequency": 27.0}
        ),
        "fish": sheet(Polygon(corners=FISH), 0.005),
        "leaf": sheet(Mask(width_of_picture=0.12, rows=leaf()), 0.005),
        "ellipse": sheet(Ellipse(length=0.12, width=0.05), 0.008),
        "rectangle": sheet(Rectangle(length=0.1, width=0.06), 0.01, **{"start.angle": 0.5}),
        "fine": sheet(Disk(radius=0.04), 0.0025),
    }


def packed(values: np.ndarray) -> str:
    """Numbers as text: single precision, base 64."""
    return base64.b64encode(np.ascontiguousarray(values, dtype=np.float32).tobytes()).decode()


def frames_of(scenario: Scenario, name: str) -> dict[str, object]:
    """A run's frames as `view_page.js` takes them."""
    short = name == "fine"
    run = scenario.replace(duration=0.25 if short else 1.2)
    recording = simulate(run, snapshot_interval=0.004).recordings[0]
    nodes, pose, time = recording.snapshots, recording.plate_pose, recording.snapshot_time
    if name == "soft":  # turned over: folded about a line across it
        nodes = nodes.copy()
        fold = nodes[..., 0] - nodes[..., 0].mean(axis=1, keepdims=True) - 0.012
        angle = np.clip(fold / 0.012, 0, math.pi)
        over = fold > 0
        past = np.maximum(fold - 0.012 * math.pi, 0)
        x = 0.012 * np.sin(angle) - past
        z = 0.012 * (1 - np.cos(angle))
        nodes[..., 0] = np.where(over, nodes[..., 0] - fold + x, nodes[..., 0])
        nodes[..., 2] = np.where(over, nodes[..., 2] + z, nodes[..., 2])
    turn = rotation_of(pose)
    height = np.array([0, 0, scenario.motion.height])
    origin = pose[:, :3] + turn @ height - height
    onto = np.einsum("tnd,tde->tne", nodes - origin[:, None], turn)
    contact = scenario.contact
    normal = np.maximum(-onto[..., 2], 0) * contact.stiffness * scenario.sheet.pitch**2 / contact.tile_area
    speed = np.gradient(onto[..., :2], time, axis=0)
    size = np.linalg.norm(speed, axis=-1, keepdims=True)
    friction = -scenario.friction.kinetic * normal[..., None] * speed / np.maximum(size, 0.06)
    return {
        "scenario": json.loads(run.model_dump_json()),
        "time": time.tolist(),
        "nodes": packed(nodes),
        "pose": packed(pose),
        "forces": packed(np.concatenate([normal[..., None], friction], axis=-1)),
        "count": len(time),
    }


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(json.dumps({name: frames_of(s, name) for name, s in cases().items()}))
