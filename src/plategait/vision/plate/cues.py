"""What tells a plate from what is behind it: its brightness, its colour, or the edges around it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from plategait.arrays import Array, Picture
from plategait.vision.frames import Frame

# Longest side of the pictures that outlines are looked for in, px.
LONGEST = 640
# Levels that a plate differs by from what is at the picture's rim: so many times the usual difference there, but no
# fewer; brightness wanders more than colour does.
TIMES, LEAST_LIGHT, LEAST_COLOUR = 4.0, 12.0, 7.0
# Changes of brightness and of both colour differences that are an edge.
CANNY = (24, 16, 16)
# Share of the picture along its rim where nothing of the plate is.
RIM = 0.04


def small(frame: Frame) -> tuple[list[Picture], float]:
    """Brightness and both colour differences of a frame at one small size, smoothed; and how many pixels one is."""
    import cv2

    height, width = frame.luma.shape
    shrink = max(1.0, max(height, width) / LONGEST)
    size = (round(width / shrink), round(height / shrink))
    planes = [_resized(plane, size) for plane in (frame.luma, *frame.chroma)]
    return [cv2.GaussianBlur(plane, (5, 5), 0).astype(np.uint8, copy=False) for plane in planes], width / size[0]


def _resized(plane: Picture, size: tuple[int, int]) -> Picture:
    import cv2

    how = cv2.INTER_AREA if plane.shape[1] >= size[0] else cv2.INTER_LINEAR
    return cv2.resize(plane, size, interpolation=how).astype(np.uint8, copy=False)


def _light(planes: list[Picture]) -> Picture:
    import cv2

    return cv2.threshold(planes[0], 0, 255, cv2.THRESH_BINARY + cv2.THRESH_OTSU)[1].astype(np.uint8, copy=False)


def _dark(planes: list[Picture]) -> Picture:
    return 255 - _light(planes)


def _darkest(planes: list[Picture]) -> Picture:
    """Darker than most of what is dark."""
    import cv2

    first, _ = cv2.threshold(planes[0], 0, 255, cv2.THRESH_BINARY + cv2.THRESH_OTSU)
    below = planes[0][planes[0] <= first]
    second, _ = cv2.threshold(below, 0, 255, cv2.THRESH_BINARY + cv2.THRESH_OTSU)
    return np.where(planes[0] <= second, 255, 0).astype(np.uint8)


def _other_light(planes: list[Picture]) -> Picture:
    """As bright as the picture's rim is not."""
    rim = _rim(planes[0])
    off = np.abs(planes[0] - float(np.median(rim)))
    usual = float(np.median(np.abs(rim - np.median(rim))))
    return np.where(off > max(LEAST_LIGHT, TIMES * usual), 255, 0).astype(np.uint8)


def _other_colour(planes: list[Picture]) -> Picture:
    """Coloured as the picture's rim is not."""
    off2, rim2 = np.zeros(planes[0].shape), 0.0
    for plane in planes[1:]:
        rim = _rim(plane)
        middle = float(np.median(rim))
        off2 += (plane - middle) ** 2
        rim2 += float(np.median(np.abs(rim - middle))) ** 2
    return np.where(off2 > max(LEAST_COLOUR, TIMES * rim2**0.5) ** 2, 255, 0).astype(np.uint8)


def _rim(plane: Picture) -> Array:
    """Levels along the picture's rim."""
    h, w = plane.shape
    n = max(2, round(RIM * min(h, w)))
    return np.concatenate([p.ravel() for p in (plane[:n], plane[-n:], plane[n:-n, :n], plane[n:-n, -n:])]).astype(float)


def _within_edges(planes: list[Picture]) -> Picture:
    """Parts of the picture that no edge crosses, without the one along its rim."""
    import cv2

    edges = np.zeros(planes[0].shape, np.uint8)
    for plane, high in zip(planes, CANNY, strict=True):
        edges |= cv2.Canny(plane, high / 2, high).astype(np.uint8, copy=False)
    walls = cv2.copyMakeBorder(cv2.dilate(edges, np.ones((5, 5), np.uint8)), 1, 1, 1, 1, cv2.BORDER_CONSTANT, value=0)
    flooded = walls.copy()
    cv2.floodFill(flooded, None, (0, 0), (255,))  # from the rim to the outermost edges
    return np.where((flooded[1:-1, 1:-1] == 255) & (walls[1:-1, 1:-1] == 0), 0, 255).astype(np.uint8)


CUES: dict[str, Callable[[list[Picture]], Picture]] = {
    "light": _light,
    "dark": _dark,
    "darkest": _darkest,
    "other light": _other_light,
    "other colour": _other_colour,
    "edges": _within_edges,
}
"""By name: from brightness and colour differences (rows, columns) to 255 where the plate may be, 0 elsewhere."""
