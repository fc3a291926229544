"""A camera: where the world's points fall in its picture, and its calibration."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.files.input import LARGEST_JSON, read_text
from plategait.files.output import whole_file

LEAST_SIZE, MOST_SIZE = 64, 16384
_EXAMPLE = '{"width": 1280, "height": 720, "matrix": [[900, 0, 640], [0, 900, 360], [0, 0, 1]], "distortion": [0]}'


@dataclass(frozen=True, eq=False)
class Calibration:
    """What a lens does, wherever the camera stands: the model of OpenCV.

    Parameters
    ----------
    width, height : int
        Size of the pictures that it holds for, px.
    matrix : (3, 3) array
        Focal lengths and middle, px; whole numbers are the middles of pixels.
    distortion : (5,) array
        k1, k2, p1, p2, k3 of radial and tangential distortion.

    Raises
    ------
    InputError
        For numbers that no camera has.
    """

    width: int
    height: int
    matrix: Array
    distortion: Array

    def __post_init__(self) -> None:
        """Refuse what is no camera."""
        for name, size in (("width", self.width), ("height", self.height)):
            if not LEAST_SIZE <= size <= MOST_SIZE:
                raise InputError(name, size, f"a number of pixels from {LEAST_SIZE} to {MOST_SIZE}", "1280")
        matrix = np.asarray(self.matrix, dtype=float)
        distortion = np.asarray(self.distortion, dtype=float).ravel()
        whole = matrix.shape == (3, 3) and np.isfinite(matrix).all()
        if not whole or matrix[0, 0] <= 0 or matrix[1, 1] <= 0 or (matrix[2] != (0, 0, 1)).any():
            raise InputError("matrix", matrix.tolist(), "[[fx, 0, cx], [0, fy, cy], [0, 0, 1]] in pixels",
                             "[[900, 0, 640], [0, 900, 360], [0, 0, 1]]")  # fmt: skip
        if len(distortion) > 5 or not np.isfinite(distortion).all():
            raise InputError("distortion", distortion.tolist(), "up to 5 numbers k1, k2, p1, p2, k3", "[-0.1, 0.02]")
        object.__setattr__(self, "matrix", matrix)
        object.__setattr__(self, "distortion", np.concatenate([distortion, np.zeros(5 - len(distortion))]))

    def pixels(self, rays: Array) -> Array:
        """Pixels (…, 2) of rays (…, 2), x/z and y/z in the camera's frame, with distortion.

        Beyond 1.2 times the picture's corner, where the polynomial may turn back, the distortion stays as it is there.
        """
        k1, k2, p1, p2, k3 = self.distortion
        x, y = rays[..., 0], rays[..., 1]
        square = x**2 + y**2
        corner = 1.2**2 * ((self.width / self.matrix[0, 0]) ** 2 + (self.height / self.matrix[1, 1]) ** 2) / 4
        near = np.minimum(square, corner)
        radial = 1 + near * (k1 + near * (k2 + near * k3))
        within = square <= corner
        bent_x = x * radial + np.where(within, 2 * p1 * x * y + p2 * (square + 2 * x**2), 0.0)
        bent_y = y * radial + np.where(within, p1 * (square + 2 * y**2) + 2 * p2 * x * y, 0.0)
        return np.stack([bent_x, bent_y, np.ones_like(x)], axis=-1) @ self.matrix[:2].T


def read_calibration(path: Path | str) -> Calibration:
    """Read a calibration from JSON: width, height, matrix and distortion, as OpenCV's calibration gives them.

    Raises
    ------
    InputError
        When the file cannot be read or is not as said.
    """
    allowed = "a JSON file that can be read"
    text = read_text(path, LARGEST_JSON, "calibration", allowed, _EXAMPLE)
    try:
        data: Any = json.loads(text)
    except (ValueError, RecursionError):
        raise InputError("calibration", f"{path} (no JSON)", allowed, _EXAMPLE) from None
    names = ("width", "height", "matrix", "distortion")
    if not isinstance(data, dict) or not set(names) <= set(data):
        raise InputError("calibration", str(path), f"an object with {', '.join(names)}", _EXAMPLE)
    try:
        numbers = [np.array(data[name], dtype=float) for name in names]
        return Calibration(int(numbers[0]), int(numbers[1]), numbers[2], numbers[3])
    except (TypeError, ValueError, OverflowError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError("calibration", str(path), "made of numbers", _EXAMPLE) from None


def write_calibration(calibration: Calibration, path: Path | str) -> None:
    """Write a calibration that `read_calibration` reads back the same.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    data = {
        "width": calibration.width,
        "height": calibration.height,
        "matrix": calibration.matrix.tolist(),
        "distortion": calibration.distortion.tolist(),
    }
    with whole_file(path, (".json",), "calibration") as unfinished:
        unfinished.write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")


@dataclass(frozen=True, eq=False)
class Camera:
    """A camera somewhere in the world frame: x along the bar, z up, origin at the middle of the plate's axis.

    Parameters
    ----------
    width, height : int
        Size of its pictures, px.
    matrix, distortion : (3, 3) and (5,) arrays
        See `Calibration`.
    rotation, translation : (3, 3) and (3,) arrays
        World to camera, whose frame has x to the right, y down and z forward; m.
    """

    width: int
    height: int
    matrix: Array
    distortion: Array
    rotation: Array
    translation: Array

    @property
    def calibration(self) -> Calibration:
        """What its lens does."""
        return Calibration(self.width, self.height, self.matrix, self.distortion)

    @property
    def eye(self) -> Array:
        """(3,) where it stands, m."""
        return -self.rotation.T @ self.translation

    def project(self, points: ArrayLike) -> Array:
        """Pixels (…, 2) of points (…, 3), m in the world frame. Points behind the camera give NaN."""
        return self.project_with_depth(points)[0]

    def project_with_depth(self, points: ArrayLike) -> tuple[Array, Array]:
        """Pixels (…, 2) and distance (…) along the view, m, of points (…, 3)."""
        local = np.asarray(points, dtype=float) @ self.rotation.T + self.translation
        depth = local[..., 2]
        ahead = np.where(depth > 1e-6, depth, np.nan)
        return self.calibration.pixels(local[..., :2] / ahead[..., None]), depth

    def plane(self, origin: ArrayLike, u: ArrayLike, v: ArrayLike) -> Array:
        """(3, 3) homography from coordinates along `u` and `v` on the plane through `origin` (m) to pixels.

        Distortion is left out.
        """
        return self.matrix @ self.rotation @ np.stack([u, v, np.asarray(origin) - self.eye], axis=1)

    @classmethod
    def looking_at(
        cls,
        eye: ArrayLike,
        target: ArrayLike = (0.0, 0.0, 0.0),
        width: int = 1280,
        height: int = 720,
        field_of_view: float = math.radians(30),
        distortion: ArrayLike = (),
        up: ArrayLike = (0.0, 0.0, 1.0),
    ) -> Camera:
        """Stand at `eye` and look at `target`, with `up` upwards in the picture (m, world frame).

        A camera straight above its target has the bar's x to the right.

        Parameters
        ----------
        field_of_view : float
            Of the picture's height, rad.
        distortion : (up to 5,) array_like
            See `Calibration`.

        Raises
        ------
        InputError
            When `eye` is at `target`, or the field of view is none.
        """
        eye, target, up = (np.asarray(v, dtype=float) for v in (eye, target, up))
        distance = float(np.linalg.norm(target - eye))
        if not (math.isfinite(distance) and distance > 0):
            raise InputError("eye", eye.tolist(), "somewhere else than the target, m", "(0.3, -0.1, 0.4)")
        if not 0 < field_of_view < math.pi:
            raise InputError("field_of_view", field_of_view, "an angle between 0 and pi rad", "0.5")
        forward = (target - eye) / distance
        if np.linalg.norm(np.cross(forward, up)) < 1e-9 * np.linalg.norm(up):
            up = np.array([0.0, 1.0, 0.0]) if abs(forward[1]) < 0.9 else np.array([0.0, 0.0, 1.0])
        right = np.cross(forward, up)
        right /= np.linalg.norm(right)
        rotation = np.stack([right, np.cross(forward, right), forward])
        focal = height / 2 / math.tan(field_of_view / 2)
        matrix = np.array([[focal, 0.0, (width - 1) / 2], [0.0, focal, (height - 1) / 2], [0.0, 0.0, 1.0]])
        lens = Calibration(width, height, matrix, np.asarray(distortion, dtype=float))
        return cls(width, height, lens.matrix, lens.distortion, rotation, -rotation @ eye)
