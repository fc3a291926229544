"""Where the plate is in each picture: a homography from plate coordinates to pixels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from plategait.arrays import Array, Picture
from plategait.camera.fiducials import DICTIONARY, PlateTarget

# Corners of the fiducials that lie further than this from where the homography puts them are not theirs: px, or a share
# of their side.
WORST_CORNER, WORST_SHARE = 4.0, 0.08
# Frames between searches of the whole picture while a fiducial is missing.
SEARCH_EVERY = 10
# Parts of a picture smaller than this are not searched, px.
SMALLEST_MARKER = 16


@dataclass(frozen=True, eq=False)
class PlateView:
    """The plate in one picture.

    Attributes
    ----------
    homography : (3, 3) array or None
        From plate coordinates (x along the bar, y across, m, origin in its middle) to pixels; None where not found.
    reason : str
        Why it is uncertain; empty where it is sure.
    """

    homography: Array | None
    reason: str = ""


class PlateFinder(Protocol):
    """Finds the plate, picture by picture.

    Attributes
    ----------
    lens : (3, 3) array or None
        Focal lengths and middle, px, where known.
    """

    lens: Array | None

    def find(self, luma: Picture) -> PlateView:
        """Plate in a picture."""
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

    def find(self, luma: Picture) -> PlateView:
        """Give the same place in every picture."""
        w, h = self.picture
        return PlateView(np.array([[1 / self.scale, 0, w / 2], [0, -1 / self.scale, h / 2], [0, 0, 1.0]]))

    def occupied(self) -> list[Array]:
        """Nothing is printed."""
        return []


class FiducialPlate:
    """The plate by the fiducials printed at its corners.

    Each fiducial is looked for where it was seen before, and in the whole picture while one is missing. One that is too
    blurred to be read still shows its outline, which is taken for it where only it can be. Two are enough for a sure
    view.

    Parameters
    ----------
    target : PlateTarget
        Which fiducials lie where.
    """

    def __init__(self, target: PlateTarget) -> None:
        import cv2

        self.target = target
        self.size = target.size
        self.lens: Array | None = None
        dictionary = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, DICTIONARY))
        self._detectors = []
        # Thoroughly over the whole picture, and more quickly where a fiducial is expected.
        for low, high, step in ((5, 53, 12), (45, 45, 10)):
            parameters = cv2.aruco.DetectorParameters()
            parameters.adaptiveThreshWinSizeMin, parameters.adaptiveThreshWinSizeMax = low, high
            parameters.adaptiveThreshWinSizeStep = step
            self._detectors.append(cv2.aruco.ArucoDetector(dictionary, parameters))
        self._boxes: dict[int, Array] = {}
        self._last_corners: dict[int, Array] = {}
        self._searched = -SEARCH_EVERY
        self._frames = 0

    def find(self, luma: Picture) -> PlateView:
        """Plate in a picture."""
        self._frames += 1
        read, outlined = self._near(luma)
        if len(read) + len(outlined) < len(self.target.corners) and self._frames - self._searched >= SEARCH_EVERY:
            self._searched = self._frames
            read = self._within(luma, None)[0] | read
        for k, corners in read.items():
            low, high = corners.min(axis=0), corners.max(axis=0)
            box = self._boxes.get(k)
            # The box keeps all places of the swing, and lets go of one-time excursions slowly.
            self._boxes[k] = (
                np.array([low, high])
                if box is None
                else np.array([np.minimum(low, box[0] + 0.02 * (low - box[0])), np.maximum(high, box[1])])
            )
            self._last_corners[k] = corners
        return self._view(read, {k: quad for k, quad in outlined.items() if k not in read})

    def occupied(self) -> list[Array]:
        """Fiducials, with their white margins."""
        return [c.mean(axis=0) + 1.35 * (c - c.mean(axis=0)) for c in np.asarray(self.target.corners)]

    def _near(self, luma: Picture) -> tuple[dict[int, Array], dict[int, Array]]:
        """Fiducials where they were seen before: those read, and those known by their outline only."""
        read: dict[int, Array] = {}
        outlined: dict[int, Array] = {}
        height, width = luma.shape
        for k, box in self._boxes.items():
            margin = 0.4 * (self._last_corners[k].max(axis=0) - self._last_corners[k].min(axis=0)).max() + 6
            low = np.maximum(box[0] - margin, 0).astype(int)
            high = np.minimum(box[1] + margin, (width, height)).astype(int)
            if (high - low).min() < SMALLEST_MARKER:
                continue
            inside, others = self._within(luma, (low[0], low[1], high[0], high[1]))
            if k in inside:
                read[k] = inside[k]
            elif (quad := _most_similar(others, self._last_corners[k])) is not None:
                outlined[k] = _refined(luma, quad)
        return read, outlined

    def _within(self, luma: Picture, box: tuple[int, int, int, int] | None) -> tuple[dict[int, Array], list[Array]]:
        """Corners (4, 2), px, of the fiducials in a part of the picture, by number, and of other quadrilaterals."""
        x, y = (0, 0) if box is None else box[:2]
        part = np.ascontiguousarray(luma if box is None else luma[box[1] : box[3], box[0] : box[2]])
        corners, numbers, others = self._detectors[box is not None].detectMarkers(part)

        def placed(quad: Array) -> Array:
            return np.asarray(quad, dtype=float).reshape(4, 2) + np.array([x, y])

        own = range(len(self.target.corners))
        listed = [] if numbers is None else zip(np.ravel(numbers), corners, strict=True)
        read = {int(n): _refined(luma, placed(c)) for n, c in listed if int(n) in own}
        return read, [placed(c) for c in others]

    def _view(self, read: dict[int, Array], outlined: dict[int, Array]) -> PlateView:
        fiducials = read | outlined
        if not read:
            return PlateView(None, "no fiducial seen")
        while True:
            plate = np.concatenate([np.asarray(self.target.corners[k], dtype=float) for k in fiducials])
            pixels = np.concatenate(list(fiducials.values()))
            H = self._fitted(plate, pixels)
            if H is None:
                return PlateView(None, "fiducials in a line")
            residual = np.linalg.norm(project(H, plate) - pixels, axis=1).reshape(-1, 4).max(axis=1)
            side = min(float(np.linalg.norm(c - np.roll(c, 1, axis=0), axis=1).min()) for c in fiducials.values())
            worst = max(WORST_CORNER, WORST_SHARE * side)
            if residual.max() <= worst or len(fiducials) <= 2:
                break
            # Those that were not read go first.
            order = list(fiducials)
            del fiducials[max(order, key=lambda k: (k not in read, residual[order.index(k)]))]
        if residual.max() > worst:
            return PlateView(H, "fiducials do not fit together")
        return PlateView(H, "" if len(fiducials) > 1 else "a single fiducial seen")

    def _fitted(self, plate: Array, pixels: Array) -> Array | None:
        """Homography; of a rigid plate before a known lens, which needs less to be seen."""
        H = homography(plate, pixels)
        return H if H is None or self.lens is None else rigid(H, plate, pixels, self.lens)


def _refined(luma: Picture, quad: Array) -> Array:
    """Corners (4, 2), px, finer than a pixel."""
    import cv2

    side = float(np.linalg.norm(quad - np.roll(quad, 1, axis=0), axis=1).min())
    reach = int(np.clip(side / 12, 2, 10))  # half of a square of the pattern
    room = reach + 3
    low = np.maximum(np.floor(quad.min(axis=0)).astype(int) - room, 0)
    high = np.ceil(quad.max(axis=0)).astype(int) + room + 1
    part = np.ascontiguousarray(luma[low[1] : high[1], low[0] : high[0]])
    stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 30, 0.01)
    points = (quad - low).astype(np.float32)
    return cv2.cornerSubPix(part, points, (reach, reach), (-1, -1), stop).astype(float) + low


def _most_similar(quads: list[Array], last: Array) -> Array | None:
    """Quadrilateral most like the last one seen there, in its order of corners; None where none is alike."""
    shape = last - last.mean(axis=0)
    side = float(np.linalg.norm(last - np.roll(last, 1, axis=0), axis=1).min())
    best, least = None, 0.25 * side
    for quad in quads:
        for k in range(4):
            turned = np.roll(quad, k, axis=0)
            off = float(np.linalg.norm(turned - turned.mean(axis=0) - shape, axis=1).max())
            if off < least:
                best, least = turned, off
    return best


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
