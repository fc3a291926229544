"""Where the plate is in each picture, by the fiducials printed at its corners."""

from __future__ import annotations

import math

import numpy as np

from plategait.arrays import Array, Picture
from plategait.camera.fiducials import DICTIONARY, PlateTarget
from plategait.vision.frames import Frame
from plategait.vision.plate.precision import doubt
from plategait.vision.plate.sharpness import sharpness
from plategait.vision.plate.view import PlateView, homography, project, rigid

# Corners of the fiducials that lie further than this from where the homography puts them are not theirs: px, or a share
# of their side.
WORST_CORNER, WORST_SHARE = 4.0, 0.08
# What few fiducials leave open of the middle of a plate that is sure, as a share of its shorter side.
MOST_DOUBT = 0.01
# Frames between searches of the whole picture while a fiducial is missing: from so many, and by so many more.
SEARCH_FROM, SEARCH_MORE = 6, 8
GOLDEN = (math.sqrt(5) - 1) / 2
# Parts of a picture smaller than this are not searched, px.
SMALLEST_MARKER = 16
# A fiducial that is this much less sharp than usual is blurred; frames between looks at how sharp they are.
BLURRED, SHARP_EVERY = 0.6, 16
# One whose edges reach over its side over this can no longer be read: a square of its pattern is a sixth, and sharp
# edges reach over three pixels.
BLURRED_OVER = 4.0
BLURRED_FIDUCIALS = "fiducials blurred"


class FiducialPlate:
    """The plate by the fiducials printed at its corners.

    Each fiducial is looked for where it was seen before. The whole picture is searched in every frame until the plate
    is found, and later while a fiducial is missing, at steps that share no phase with any swing. One that is too
    blurred to be read still shows its outline, which is taken for it where only it can be. Two are enough for a sure
    view where they tell where the plate's middle is, and none that was read may be elsewhere.

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
        self._sharp: dict[int, float] = {}
        self._found = False
        self._frames, self._searches, self._next_search = 0, 0, 0

    def find(self, frame: Frame) -> PlateView:
        """Plate in a picture."""
        luma = frame.luma
        self._frames += 1
        read, outlined = self._near(luma)
        missing = len(read) + len(outlined) < len(self.target.corners)
        if missing and (not self._found or self._frames >= self._next_search):
            self._searches += 1
            # Multiples of the golden ratio come near no period twice.
            self._next_search = self._frames + SEARCH_FROM + int(SEARCH_MORE * (self._searches * GOLDEN % 1))
            read = self.read(luma) | read
        self._remember(luma, read)
        view = self._view(read, {k: quad for k, quad in outlined.items() if k not in read})
        self._found = self._found or (view.homography is not None and not view.reason)
        if view.homography is None and self._is_blurred(luma):
            return PlateView(None, BLURRED_FIDUCIALS)
        return view

    def again(self, view: PlateView) -> PlateView:
        """Give the same view with what is known by now of the lens."""
        return self._view(view.read, view.outlined or {}) if view.read else view

    def occupied(self) -> list[Array]:
        """Fiducials, with their white margins."""
        return [c.mean(axis=0) + 1.35 * (c - c.mean(axis=0)) for c in np.asarray(self.target.corners)]

    def read(self, luma: Picture) -> dict[int, Array]:
        """Corners (4, 2), px, of the fiducials in a whole picture, by number."""
        return self._within(luma, None)[0]

    def _remember(self, luma: Picture, read: dict[int, Array]) -> None:
        """Keep where fiducials were read, and how sharp they are when they can be."""
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
            if k not in self._sharp or (self._frames + k) % SHARP_EVERY == 0:
                sharp = sharpness(_cut(luma, np.array([low, high]), 0.0))
                self._sharp[k] = max(0.94 * self._sharp.get(k, 0.0), sharp)

    def _is_blurred(self, luma: Picture) -> bool:
        """Whether what is seen where fiducials were is too soft to be read, or much softer than at their best."""
        for k, box in self._boxes.items():
            side = float(np.linalg.norm(np.diff(self._last_corners[k], axis=0), axis=1).min())
            soft = max(BLURRED * self._sharp.get(k, 0.0), BLURRED_OVER / side)
            if sharpness(_cut(luma, box, 0.2)) < soft:
                return True
        return False

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
        if not read:
            return PlateView(None, "no fiducial seen")
        fiducials = read | outlined
        while True:
            plate = np.concatenate([np.asarray(self.target.corners[k], dtype=float) for k in fiducials])
            pixels = np.concatenate(list(fiducials.values()))
            H = self._fitted(plate, pixels)
            if H is None:
                return PlateView(None, "fiducials in a line")
            residual = np.linalg.norm(project(H, plate) - pixels, axis=1).reshape(-1, 4).max(axis=1)
            side = min(float(np.linalg.norm(c - np.roll(c, 1, axis=0), axis=1).min()) for c in fiducials.values())
            worst = max(WORST_CORNER, WORST_SHARE * side)
            strays = {k: r for k, r in zip(fiducials, residual, strict=True) if k not in read}
            if residual.max() <= worst or not strays:
                break
            # Only what was not read may be something else.
            del fiducials[max(strays, key=lambda k: strays[k])]
        reason = ""
        if residual.max() > worst:
            reason = "fiducials do not fit together"
        elif len(fiducials) == 1:
            reason = "a single fiducial seen"
        elif len(fiducials) < len(self.target.corners) and (
            doubt(H, plate, pixels, self.size, self.lens) > MOST_DOUBT * min(self.size)
        ):
            reason = "too few fiducials seen"
        return PlateView(H, reason, read, outlined)

    def _fitted(self, plate: Array, pixels: Array) -> Array | None:
        """Homography; of a rigid plate before a known lens, which needs less to be seen."""
        H = homography(plate, pixels)
        return H if H is None or self.lens is None else rigid(H, plate, pixels, self.lens)


def _cut(luma: Picture, box: Array, beyond: float) -> Picture:
    """Part of a picture within a box of pixels (low, high) and a share of it beyond."""
    margin = beyond * (box[1] - box[0])
    low, high = np.maximum(box[0] - margin, 0).astype(int), np.ceil(box[1] + margin).astype(int) + 1
    return luma[low[1] : high[1], low[0] : high[0]]


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
