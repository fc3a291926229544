"""Where the plate is in each picture: a homography from plate coordinates to pixels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from plategait.arrays import Array
from plategait.vision.frames import Frame


@dataclass(frozen=True, eq=False)
class PlateView:
    """The plate in one picture.

    Attributes
    ----------
    homography : (3, 3) array or None
        From plate coordinates (x along the bar, y across, m, origin in its middle) to pixels; None where not found.
    reason : str
        Why it is uncertain; empty where it is sure.
    read, outlined : dict of int to (4, 2) array
        Corners, px, of what the plate is known by in this picture: of fiducials by number, or of its outline as 0; and
        of fiducials of which only the outline was seen.
    """

    homography: Array | None
    reason: str = ""
    read: dict[int, Array] | None = None
    outlined: dict[int, Array] | None = None


class PlateFinder(Protocol):
    """Finds the plate, picture by picture.

    Attributes
    ----------
    lens : (3, 3) array or None
        Focal lengths and middle, px, where known.
    """

    lens: Array | None

    def find(self, frame: Frame) -> PlateView:
        """Plate in a picture."""
        ...

    def again(self, view: PlateView) -> PlateView:
        """Give the same view with what is known by now of the lens."""
        ...

    def occupied(self) -> list[Array]:
        """Polygons (k, 2) on the plate, m, where something printed may be taken for the object's markers."""
        ...


@dataclass
class ScalePlate:
    """A camera that looks straight down on a plate whose scale is known; the plate's motion is not followed.

    Attributes
    ----------
    scale : float
        Metres in a pixel.
    picture : (width, height)
        Pixels. The origin is in its middle, x to the right and y upwards.
    size : (length, width)
        Of the plate, m.
    """

    scale: float
    picture: tuple[int, int]
    size: tuple[float, float]
    lens: Array | None = None

    def find(self, frame: Frame) -> PlateView:
        """Give the same place in every picture."""
        w, h = self.picture
        return PlateView(np.array([[1 / self.scale, 0, w / 2], [0, -1 / self.scale, h / 2], [0, 0, 1.0]]))

    def again(self, view: PlateView) -> PlateView:
        """No lens changes it."""
        return view

    def occupied(self) -> list[Array]:
        """Nothing is printed."""
        return []


def homography(plate: Array, pixels: Array) -> Array | None:
    """(3, 3) homography that takes points (n, 2) on the plate, m, nearest to pixels (n, 2); None where undetermined."""
    import cv2

    # Millimetres, or the plate's numbers would be lost beside the pixels'.
    H, _ = cv2.findHomography(1e3 * plate, pixels, 0)
    if H is None or not np.isfinite(H).all():
        return None
    return np.asarray(H, dtype=float) @ np.diag([1e3, 1e3, 1.0])


def rigid(H: Array, plate: Array, pixels: Array, lens: Array) -> Array:
    """(3, 3) homography of a rigid plate before a lens (3, 3) that takes points nearest to pixels, beginning from H."""
    import cv2

    M = np.linalg.inv(lens) @ H
    M *= 2 / (np.linalg.norm(M[:, 0]) + np.linalg.norm(M[:, 1])) * np.sign(M[2, 2])
    U, _, Vt = np.linalg.svd(np.column_stack([M[:, 0], M[:, 1], np.cross(M[:, 0], M[:, 1])]))
    turn, place = cv2.Rodrigues(U @ Vt)[0], M[:, 2:].copy()
    points = np.column_stack([plate, np.zeros(len(plate))])
    turn, place = cv2.solvePnPRefineLM(points, pixels, lens, np.zeros(5), turn, place)
    out = lens @ np.column_stack([cv2.Rodrigues(turn)[0][:, :2], place])
    return out / out[2, 2] if np.isfinite(out).all() else H


def project(H: Array, points: Array) -> Array:
    """(…, 2) points through a homography."""
    out = points @ H[:, :2].T + H[:, 2]
    return out[..., :2] / out[..., 2:]
