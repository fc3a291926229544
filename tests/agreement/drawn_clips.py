"""Quickly drawn clips of a flat object that turns on a tilting plate: exact, without bending, through a real file."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np

from plategait.camera.camera import Camera
from plategait.camera.fiducials import marker_modules, plate_target
from plategait.camera.writer import film_file

SIDE, FIDUCIAL = 0.1, 0.1 / 6
GRAIN = 2e-4  # m in a pixel of the plate's drawing
BLUE, CHEESE, METAL = (140, 64, 18), (72, 196, 250), (204, 200, 196)


@dataclass(frozen=True)
class Clip:
    """What is drawn. Rates in deg/s, angles in deg, lengths in m, times in s."""

    rate: float = 250.0
    fps: float = 30.0
    seconds: float = 1.5
    frequency: float = 11.0
    tilt: float = 6.0
    swing: float = 2.0
    size: tuple[int, int] = (640, 360)
    markers: bool = True
    speckle: float = 0.0
    corners: int = 0
    fiducials: bool = True
    overhead: bool = False
    hidden: Callable[[int], bool] | None = None
    objects: int = 1
    drift: float = 0.0
    noise: float = 2.0
    repeat: tuple[int, ...] = ()
    dropped: tuple[int, ...] = ()
    times: tuple[float, ...] = ()
    seed: int = 1

    def with_(self, **changes: object) -> Clip:
        """Give the same clip but for some changes."""
        return replace(self, **changes)  # type: ignore[arg-type]

    @property
    def time(self) -> np.ndarray:
        """Of each frame."""
        n = round(self.seconds * self.fps)
        time = np.array(self.times) if self.times else np.arange(n) / self.fps
        return np.delete(time, list(self.dropped))

    def angle(self, time: np.ndarray) -> np.ndarray:
        """Orientation, rad."""
        swing = math.radians(self.swing) * np.sin(2 * math.pi * self.frequency * time + 0.7)
        return math.radians(self.rate) * time + swing + 0.3


def object_drawing(clip: Clip) -> tuple[np.ndarray, np.ndarray]:
    """Colour and cover of the object, 70 mm square, centred."""
    n = round(0.07 / GRAIN)
    generator = np.random.default_rng(clip.seed)
    cover = np.zeros((n, n), np.uint8)
    r = 0.03 / GRAIN if clip.objects == 1 else 0.014 / GRAIN
    if clip.corners:
        turns = 2 * math.pi * np.arange(clip.corners) / clip.corners
        points = n / 2 + r * np.stack([np.cos(turns), np.sin(turns)], axis=1)
        cv2.fillPoly(cover, [np.round(points).astype(np.int32)], 255)
    else:
        cv2.circle(cover, (n // 2, n // 2), round(r), 255, -1)
    colour = np.full((n, n, 3), CHEESE, float)
    if clip.speckle:
        grain = cv2.GaussianBlur(generator.normal(size=(n, n)).astype(np.float32), (0, 0), 6)
        colour *= (1 + clip.speckle * grain / grain.std())[..., None]
    if clip.markers:
        scale = 1.0 if clip.objects == 1 else 0.45
        for middle, length in ((0.0, 0.012), (0.024, 0.006)):
            a = n / 2 + (scale * middle + scale * np.array([-length, length]) / 2) / GRAIN
            b = n / 2 + scale * np.array([-0.003, 0.003]) / GRAIN
            colour[round(b[0]) : round(b[1]), round(a[0]) : round(a[1])] = BLUE
    return np.clip(colour, 0, 255).astype(np.uint8), cover


def plate_drawing(clip: Clip) -> np.ndarray:
    """Plate from above, rows against y."""
    n = round(SIDE / GRAIN)
    plate = np.full((n, n, 3), METAL, np.uint8)
    if clip.fiducials:
        for k, corners in enumerate(plate_target(SIDE, SIDE, FIDUCIAL).corners):
            side = round(FIDUCIAL / GRAIN)
            left, top = round((corners[0, 0] + SIDE / 2) / GRAIN), round((SIDE / 2 - corners[0, 1]) / GRAIN)
            white = round(FIDUCIAL / 6 / GRAIN)
            plate[top - white : top + side + white, left - white : left + side + white] = 245
            black = cv2.resize(marker_modules(k).astype(np.uint8), (side, side), interpolation=cv2.INTER_NEAREST)
            plate[top : top + side, left : left + side][black > 0] = 15
    return plate


def camera_of(clip: Clip) -> Camera:
    """A camera at 60 deg of elevation, or straight above."""
    eye = (0.0, 0.0, 0.33) if clip.overhead else (0.165, -0.03, 0.29)
    return Camera.looking_at(eye, (0, 0, 0), *clip.size, field_of_view=math.radians(26 if not clip.overhead else 20))


def homography_of(camera: Camera, theta: float, stroke: float) -> np.ndarray:
    """From plate coordinates to pixels, of a plate turned about x and moved along it."""
    c, s = math.cos(theta), math.sin(theta)
    R = camera.rotation @ np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    t = camera.rotation @ np.array([stroke, 0, 0]) + camera.translation
    return camera.matrix @ np.stack([R[:, 0], R[:, 1], t], axis=1)


def draw(clip: Clip, path: Path) -> np.ndarray:
    """Write the clip; give the true orientations, rad, at its frames."""
    generator = np.random.default_rng(clip.seed + 1)
    plate, (colour, cover), camera = plate_drawing(clip), object_drawing(clip), camera_of(clip)
    n, half = plate.shape[0], SIDE / 2
    to_plate = np.array([[GRAIN, 0, GRAIN / 2 - half], [0, -GRAIN, half - GRAIN / 2], [0, 0, 1.0]])
    spots = [(0.0, 0.0)] if clip.objects == 1 else [(-0.017, 0.0), (0.017, 0.0)]
    picture = np.zeros(0)
    with film_file(path, clip.size, clip.fps, 18) as file:
        for k, time in enumerate(clip.time):
            if k not in clip.repeat:
                on_plate = plate.copy()
                for x, y in spots:
                    turn = math.degrees(float(clip.angle(np.array(time))))
                    M = cv2.getRotationMatrix2D(((colour.shape[1] - 1) / 2,) * 2, turn, 1.0)
                    M[:, 2] += (n - colour.shape[1]) / 2 + np.array([x + clip.drift * time, -y]) / GRAIN
                    mask = cv2.warpAffine(cover, M, (n, n))[..., None] / np.float32(255)
                    on_plate = (on_plate * (1 - mask) + cv2.warpAffine(colour, M, (n, n)) * mask).astype(np.uint8)
                    if clip.hidden is not None and clip.hidden(k):
                        tip = np.array([n / 2, n / 2]) + 0.024 / GRAIN * np.array(
                            [math.cos(math.radians(turn)), -math.sin(math.radians(turn))]
                        )
                        cv2.circle(on_plate, (round(tip[0]), round(tip[1])), round(0.006 / GRAIN), CHEESE, -1)
                phase = 2 * math.pi * clip.frequency * time
                H = homography_of(camera, math.radians(clip.tilt) * math.sin(phase), 3e-3 * math.sin(phase))
                picture = np.full((clip.size[1], clip.size[0], 3), (70, 60, 55), np.uint8)
                # The drawing is finer than the picture: average, or its edges would be ragged.
                finer = np.array([[2, 0, 0.5], [0, 2, 0.5], [0, 0, 1.0]])
                fine = cv2.resize(picture, None, fx=2, fy=2)
                size = (2 * clip.size[0], 2 * clip.size[1])
                border = cv2.BORDER_TRANSPARENT
                fine = cv2.warpPerspective(on_plate, finer @ H @ to_plate, size, dst=fine, borderMode=border)
                picture = cv2.resize(fine, clip.size, interpolation=cv2.INTER_AREA)
                noisy = picture + clip.noise * generator.standard_normal(picture.shape, np.float32)
                picture = np.clip(noisy, 0, 255).astype(np.uint8)
            file.add(picture, float(time))
    return clip.angle(clip.time)
