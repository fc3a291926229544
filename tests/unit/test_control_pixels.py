"""Poses through pixels: rendered frames, read by the tracker, against where the sheets truly lie."""

import math

import numpy as np
import pytest

from plategait.control.camera import PIXELS
from plategait.control.goal import Goal
from plategait.control.menu import Menu, drive_of
from plategait.control.pixels import SNAPSHOTS, STARTUP, PixelCamera
from plategait.control.plant import Plant
from plategait.control.response import resting
from plategait.control.room import on_a_plate
from plategait.control.steer import steer
from plategait.errors import InputError
from plategait.model.machine import machine_of
from plategait.render.clip.appearance import Appearance

CHEESE = on_a_plate("cheese").replace(**{"start.x": 0.02, "start.y": -0.01, "start.angle": 2.5})
# Few pixels: a millimetre of the plate is one and a half.
SMALL = (400, 300)


def plant_of(**camera) -> Plant:
    return Plant([CHEESE], camera=PIXELS.replace(**camera), snapshot_interval=SNAPSHOTS)


def off(seen: np.ndarray, true: np.ndarray) -> tuple[float, float]:
    return math.hypot(*(seen - true)[:2]), abs(math.remainder(seen[2] - true[2], 2 * math.pi))


@pytest.mark.slow
def test_frames_tell_where_a_sheet_lies_when_they_have_arrived():
    plant = plant_of(delay=0.05, dark=((0.6, 0.8),))
    eye = PixelCamera(plant, size=SMALL)
    assert plant.time[0] >= STARTUP
    first = eye(plant)
    assert first.taken[0] == 0.0
    still = plant.session.scenarios[0].motion
    rocking = still.replace(frequency=20.0, angle=math.radians(2), stroke=2e-3, ramp=0.06)
    poses, begun, taken = {}, float(plant.time[0]), []
    for tick in range(1, 61):
        plant.step(rocking if tick <= 15 else still)
        poses[tick] = plant.poses[0]
        seen = eye(plant)
        if seen.new[0]:
            taken.append((float(seen.taken[0]), float(plant.time[0]) - begun, seen.poses[0]))
    assert math.hypot(*(poses[60] - poses[1])[:2]) + abs(poses[60][2] - poses[1][2]) > 0.02, "it was moved"
    at = np.array([time for time, _, _ in taken])
    np.testing.assert_allclose(at * 30, np.round(at * 30), atol=1e-9)
    assert not ((at >= 0.6) & (at < 0.8)).any()
    # Of 17 frames that are lit, and old enough by the end, the tracker may lose some of a plate that rocks.
    assert len(at) >= 14
    for time, arrived, _ in taken:
        assert 0.05 - 1e-6 <= arrived - time <= 0.05 + plant.tick
    # At rest: half a millimetre is 0.8 px, which thickness seen at a slant has a third of.
    for time, _, pose in [(0.0, 0.0, first.poses[0]), taken[-1]]:
        far, turned = off(pose, poses[max(round(60 * time), 1)])
        assert far < 0.6e-3
        assert turned < math.radians(1)


@pytest.mark.slow
def test_a_controller_goes_by_what_the_pixels_show():
    """The camera of a plant that believes in 30 Hz, and a goal at which the object lies: held without a pulse."""
    drive = drive_of(CHEESE, machine_of("source-robot"))
    menu = Menu(CHEESE, drive, (drive.base.replace(angle=0.0, stroke=0.0),), np.zeros((1, len(drive))), resting(), 0.05)
    plant = plant_of()
    (way,) = steer(plant, [[Goal(0.02, -0.01, 2.5)]], menu, hold=0.3, look=PixelCamera(plant, size=SMALL))
    assert way.reached
    assert way.arrivals[0].pulses == 0
    seen = way.seen[np.isfinite(way.seen).all(axis=1)]
    assert len(np.unique(seen, axis=0)) > 5
    assert (np.abs(seen - way.poses[-1]) > 1e-7).all(), "never the truth itself"


def test_what_cannot_be_seen_is_refused():
    with pytest.raises(InputError, match="snapshot_interval"):
        PixelCamera(Plant([CHEESE], camera=PIXELS), size=SMALL)
    with pytest.raises(InputError, match="exposure"):
        PixelCamera(plant_of(), exposure=0.1)
    with pytest.raises(InputError, match="object"):
        PixelCamera(plant_of(), size=(160, 120), appearance=Appearance(markers=False))
