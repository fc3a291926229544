"""Poses through pixels: frames of the plates as a camera above them takes them, each read by the tracker of films."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from plategait.arrays import Array, Picture
from plategait.control.camera import NEARLY, Seen
from plategait.control.plant import Plant
from plategait.errors import InputError
from plategait.render.clip.appearance import Appearance
from plategait.render.clip.clip import usual_camera
from plategait.render.clip.scene import Scene
from plategait.render.clip.synthetic_camera import SyntheticCamera
from plategait.render.snapshots import Snapshots
from plategait.vision.frames import Frame, frame_of
from plategait.vision.pose_reader import PoseReader, learnt
from plategait.vision.setup import Setup

EXPOSURE = 1.5e-3
"""For which the shutter is open, s, or a quarter of the frame interval where that is less: bright light, as over
machines. With 8 ms a plate that rocks blurs the markers of three frames in ten."""
SNAPSHOTS = 1 / 600
"""Time between the recorded shapes that exposures are made of, s."""
SIZE = (480, 360)
"""Of a picture, px."""
FIDUCIAL = 1 / 8
"""Side of the fiducials at the plate's corners over its shorter side: smaller than for clips, whose objects stay near
the middle, as an object that lies over one of them hides where the plate is."""
STARTUP = 0.5
"""Time at rest from whose frames the tracker learns what plate and object look like, s."""
# Straight down: from a slant the object's thickness and lift shift it by millimetres.
_ELEVATION = math.radians(88)

Follow = Callable[[int, float, Picture, Array | None], object]


class PixelCamera:
    """A camera over each plate of a plant, and the tracker of `plategait track` on each of its frames.

    The tracker is told how large the plate is, and nothing else: it finds the plate by its fiducials and the object by
    its markers. Frame rate, delay and times in the dark are those of the plant's own camera; its noise is what the
    controller believes, `PIXELS` by default. Making one lets the sheets rest for half a second, from which the tracker
    learns; times count from then on.

    Parameters
    ----------
    plant : Plant
        ``Plant(scenarios, camera=PIXELS, snapshot_interval=SNAPSHOTS)``.
    size : (width, height)
        px.
    exposure : float, optional
        s; `EXPOSURE` by default.
    appearance : Appearance, optional
        Of objects, plates and light.
    seed : int
        Of textures and noise where no appearance is told.
    elevation : float
        Of the cameras above the plates, rad.
    follow : callable, optional
        Called with the lane, the time, the picture (height, width, 3) in red, green and blue, and the pose read in it,
        or None.

    Raises
    ------
    InputError
        For a plant that records no shapes, an exposure that is too long, or objects that the tracker does not find by
        markers.
    """

    def __init__(
        self,
        plant: Plant,
        *,
        size: tuple[int, int] = SIZE,
        exposure: float | None = None,
        appearance: Appearance | None = None,
        seed: int = 0,
        elevation: float = _ELEVATION,
        follow: Follow | None = None,
    ) -> None:
        told = plant.camera
        exposure = min(EXPOSURE, 0.25 / told.rate) if exposure is None else exposure
        if not 0 <= exposure <= 0.5 / told.rate:
            raise InputError("exposure", f"{exposure:g} s", f"from 0 to {0.5 / told.rate:.3g} s, half a frame", "3 ms")
        self._rate, self._late = told.rate, max(told.delay, exposure / 2)
        # Nothing of this camera's time in the dark falls to what it learns from.
        self._dark: tuple[tuple[float, float], ...] = ()
        self._exposure, self._follow = exposure, follow
        self._cameras, self._setups = [], []
        for i, scenario in enumerate(plant.session.scenarios):
            plate = Scene.plate_size(scenario)
            look = appearance or Appearance(seed=seed, fiducial_size=FIDUCIAL * min(plate))
            nodes, pose = plant.session.shape(i)
            now = Snapshots(np.zeros(1), nodes[None], pose[None])
            view = usual_camera(scenario, *size, elevation=elevation)
            self._cameras.append(SyntheticCamera(scenario, now, view, look, exposure))
            self._setups.append(Setup(plate_size=plate, fiducial=look.fiducial_size, object="markers"))
        n = len(plant)
        self._begun, self._next = plant.time, np.zeros(n, dtype=np.int64)
        # Poses on their way: when each was taken, and the pose.
        self._waiting: list[list[tuple[float, Array]]] = [[] for _ in range(n)]
        self._newest, self._taken = np.full((n, 3), np.nan), np.full(n, np.nan)
        self._readers = self._learnt(plant)
        self._dark = told.dark

    def _learnt(self, plant: Plant) -> list[PoseReader]:
        """Readers that know plate and object, from frames at rest."""
        frames: list[list[Frame]] = [[] for _ in range(len(plant))]
        for _ in range(math.ceil((STARTUP + self._exposure) / plant.tick)):
            plant.step(None)
            for i in range(len(plant)):
                frames[i] += [frame for frame, _ in self._due(plant, i)]
        readers = []
        for i, (own, setup) in enumerate(zip(frames, self._setups, strict=True)):
            reader, *_ = learnt(iter(own), setup)
            readers.append(reader)
            for frame in own[::-1]:
                pose = _read(reader, frame)
                if pose is not None:
                    self._newest[i], self._taken[i] = pose, 0.0
                    break
        self._begun, self._next = plant.time, np.ones_like(self._next)
        return readers

    def _due(self, plant: Plant, i: int) -> list[tuple[Frame, Picture]]:
        """Frames of a lane whose exposures are over by now."""
        taken = []
        while self._next[i] / self._rate + self._exposure / 2 <= plant.time[i] - self._begun[i] + NEARLY:
            time = float(self._next[i] / self._rate)
            self._next[i] += 1
            if plant.failed[i] or any(begin <= time < end for begin, end in self._dark):
                continue
            recorded = plant.session.recording(i)
            if len(recorded.snapshots) < 2:
                raise InputError("plant", "one that records no shapes", "shapes to take pictures of",
                                 "Plant(…, snapshot_interval=SNAPSHOTS)")  # fmt: skip
            camera = self._cameras[i]
            camera.snapshots = Snapshots(recorded.snapshot_time, recorded.snapshots.astype(float), recorded.plate_pose)
            picture, _ = camera.picture(float(self._begun[i]) + time, [])
            taken.append((frame_of(picture[:, :, ::-1], int(self._next[i]) - 1, time), picture))
        return taken

    def __call__(self, plant: Plant) -> Seen:
        """Take the frames that are due, and tell what has arrived by now, as `Plant.seen` does."""
        n = len(plant)
        new = np.zeros(n, dtype=bool)
        for i in range(n):
            for frame, picture in self._due(plant, i):
                pose = _read(self._readers[i], frame)
                if pose is not None:
                    self._waiting[i].append((frame.time, pose))
                if self._follow is not None:
                    self._follow(i, frame.time, picture, pose)
            now = plant.time[i] - self._begun[i] + NEARLY
            while self._waiting[i] and self._waiting[i][0][0] + self._late <= now:
                self._taken[i], self._newest[i] = self._waiting[i].pop(0)
                new[i] = True
        return Seen(poses=self._newest.copy(), taken=self._taken.copy(), new=new)


def _read(reader: PoseReader, frame: Frame) -> Array | None:
    """(3,) pose in a frame, x, y, m, and angle, rad; None where it is not sure."""
    _, poses = reader.read(frame)
    pose = poses["markers"]
    return None if pose.reason else np.array([pose.x, pose.y, math.remainder(pose.angle, 2 * math.pi)])
