"""Where the plate is in each picture, by its own outline."""

from __future__ import annotations

from typing import Any

import numpy as np

from plategait.arrays import Array, Picture
from plategait.vision.frames import Frame
from plategait.vision.plate.cues import CUES, small
from plategait.vision.plate.view import PlateView, homography, rigid

# Shares of the picture that a plate's outline fills.
LEAST_OUTLINE, MOST_OUTLINE = 0.02, 0.9
# The plate's bar is narrower than this share of the picture.
BAR = 0.045
# What a plate's outline fills of the four corners' area at least, and how near a corner may lie to the rim, px.
LEAST_FILL, AT_THE_RIM = 0.93, 3.0
# Pictures in which all cues are tried, and the shares of the usual area that the plate's stays within.
TRIALS, SAME_AREA = 8, (0.7, 1.4)
# Places of the plate that are remembered.
PAST = 10
# An edge is looked for so many pixels to either side, at so many places along it; what brightness and both colour
# differences count for, the least change over two pixels, and the fewest places that must show it.
ACROSS, ALONG, EDGE_WEIGHTS, LEAST_STEEP, FEWEST_POINTS = 6, 40, (1.0, 2.0, 2.0), 6.0, 8
# Share of a side's places that must lie on a straight edge, within so many pixels.
LEAST_EDGE, ON_THE_LINE = 0.5, 1.0
OUTLINE_CROPPED = "outline of the plate reaches the picture's edge"


class OutlinePlate:
    """The plate by its four edges: the largest quadrilateral that stands out by brightness, by colour or by its edges.

    All cues are tried in the first pictures, and later the one that has found most, then the others. The corners are
    followed from picture to picture; in the first one x runs along the edge that is most level. Which of the two ways,
    and the direction of the bar, cannot be known from an outline.

    Parameters
    ----------
    size : (length, width)
        Of the plate, m.
    """

    def __init__(self, size: tuple[float, float]) -> None:
        self.size = size
        self.lens: Array | None = None
        self._corners: Array | None = None
        self._found = dict.fromkeys(CUES, 0)
        self._areas: list[float] = []
        self._past: list[Array] = []
        x, y = size[0] / 2, size[1] / 2
        self._plate = np.array([[-x, -y], [x, -y], [x, y], [-x, y]])

    def find(self, frame: Frame) -> PlateView:
        """Plate in a picture."""
        planes, scale = small(frame)
        quad, cropped = self._quadrilateral(planes)
        if quad is None:
            quad = self._where_it_was(planes)
        if quad is None:
            return PlateView(None, OUTLINE_CROPPED if cropped else "outline of the plate not found")
        self._past = [quad, *self._past[: PAST - 1]]
        self._corners = self._ordered((quad + 0.5) * scale - 0.5)
        return self._view(self._corners)

    def again(self, view: PlateView) -> PlateView:
        """Give the same view with what is known by now of the lens."""
        return self._view(view.read[0]) if view.read else view

    def _view(self, quad: Array) -> PlateView:
        H = homography(self._plate, quad)
        if H is not None and self.lens is not None:
            H = rigid(H, self._plate, quad, self.lens)
        return PlateView(H, "" if H is not None else "outline of the plate not found", {0: quad})

    def occupied(self) -> list[Array]:
        """Nothing is printed."""
        return []

    def _quadrilateral(self, planes: list[Picture]) -> tuple[Array | None, bool]:
        """Corners in a small picture, px, None where not found; and whether the picture's rim cuts them off."""
        usual = float(np.median(self._areas)) if len(self._areas) >= TRIALS else None
        best: tuple[float, str, Array] | None = None
        cut = 0.0
        for name in sorted(CUES, key=lambda cue: -self._found[cue]):
            rough, cropped = quad_in(CUES[name](planes))
            cut = max(cut, cropped)
            quad = None if rough is None else on_edges(rough, planes)
            if quad is None:
                continue
            area = abs(signed_area(quad))
            if usual is not None:
                if SAME_AREA[0] * usual < area < SAME_AREA[1] * usual:
                    best = area, name, quad
                    break
            elif best is None or area > 1.05 * best[0]:
                best = area, name, quad
        if best is None:
            return None, cut > 0
        if best[0] < 0.5 * cut:  # what is cut off is no less than what is left of it
            return None, True
        self._found[best[1]] += 1
        self._areas = [*self._areas[-99:], best[0]]
        return best[2], False

    def _where_it_was(self, planes: list[Picture]) -> Array | None:
        """Corners at edges near those of pictures before: a plate that swings comes by again."""
        for past in self._past:
            quad = on_edges(past, planes)
            if quad is not None and SAME_AREA[0] < signed_area(quad) / signed_area(past) < SAME_AREA[1]:
                return quad
        return None

    def _ordered(self, quad: Array) -> Array:
        """Corners in the order of the plate's: as before where they are known, else from the lower left."""
        if signed_area(quad) > 0:  # clockwise on the plate seen from above: y of pixels points down
            quad = quad[::-1]
        turns = [np.roll(quad, -k, axis=0) for k in range(4)]
        if self._corners is not None:
            before = self._corners - self._corners.mean(axis=0)
            return min(turns, key=lambda q: float(np.sum((q - q.mean(axis=0) - before) ** 2)))
        # Of the turns, the one whose first edge runs most to the right; a long plate's long edge is its x.
        long = self.size[0] > 1.2 * self.size[1]

        def fit(q: Array) -> float:
            edge, next_edge = q[1] - q[0], q[2] - q[1]
            shape = np.linalg.norm(edge) / max(float(np.linalg.norm(next_edge)), 1e-9)
            return float(edge[0] / np.linalg.norm(edge)) + (2.0 * float(shape > 1) if long else 0.0)

        return max(turns, key=fit)


def quad_in(mask: Picture) -> tuple[Array | None, float]:
    """Corners (4, 2), px, of the largest quadrilateral in a mask; and the area of the largest that its rim cuts off."""
    import cv2

    height, width = mask.shape
    closed = cv2.morphologyEx(mask, cv2.MORPH_CLOSE, np.ones((5, 5), np.uint8))
    contours, _ = cv2.findContours(closed, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    filled = np.zeros_like(mask)  # what lies on the plate is part of it
    cv2.drawContours(filled, contours, -1, (255,), cv2.FILLED)
    # The bar is cut off.
    wide = max(5, round(BAR * width))
    filled = cv2.morphologyEx(filled, cv2.MORPH_OPEN, np.ones((wide, wide), np.uint8))
    contours, _ = cv2.findContours(filled, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    best, best_area, cut = None, LEAST_OUTLINE * mask.size, 0.0
    for contour in contours:
        hull = cv2.convexHull(contour)
        area = cv2.contourArea(hull)
        if not LEAST_OUTLINE * mask.size < area < MOST_OUTLINE * mask.size:
            continue
        x, y, w, h = cv2.boundingRect(contour)
        if min(x, y) < AT_THE_RIM or x + w > width - AT_THE_RIM or y + h > height - AT_THE_RIM:
            cut = max(cut, area)
            continue
        quad = cv2.approxPolyDP(hull, 0.03 * cv2.arcLength(hull, True), True).reshape(-1, 2)
        if area > best_area and len(quad) == 4 and cv2.contourArea(quad) > LEAST_FILL * area:
            refined = _refined(quad.astype(float), contour.reshape(-1, 2))
            if refined is not None:
                best, best_area = refined, area
    return best, cut


def _refined(quad: Array, contour: Any) -> Array | None:
    """Corners where the straight lines along the four sides of a contour meet; None where a side has no points."""
    points = np.asarray(contour, dtype=float)
    lines = []
    for a, b in zip(quad, np.roll(quad, -1, axis=0), strict=True):
        along = (b - a) / np.linalg.norm(b - a)
        share = (points - a) @ along / np.linalg.norm(b - a)
        off = np.abs((points - a) @ np.array([-along[1], along[0]]))
        own = points[(share > 0.1) & (share < 0.9) & (off < 4)]
        if len(own) < FEWEST_POINTS:
            return None
        lines.append(_line(own))
    return _meeting(lines)


def on_edges(quad: Array, planes: list[Picture]) -> Array | None:
    """Corners (4, 2), px, of a quadrilateral whose sides are moved to where brightness and colour change most.

    Across each side the steepest place is looked for at many points, finer than a pixel, and a straight line is laid
    through them. None where a side shows no edge along most of it, or the corners would move far: it is no plate.
    """
    import cv2

    steps = np.arange(-ACROSS, ACROSS + 1.0)
    lines = []
    for a, b in zip(quad, np.roll(quad, -1, axis=0), strict=True):
        side = b - a
        normal = np.array([-side[1], side[0]]) / np.linalg.norm(side)
        places = a + np.linspace(0.06, 0.94, ALONG)[:, None] * side
        grid = (places[:, None] + steps[None, :, None] * normal).astype(np.float32)
        steep = np.zeros((ALONG, len(steps) - 2))
        for plane, weight in zip(planes, EDGE_WEIGHTS, strict=True):
            levels = cv2.remap(plane, grid[..., 0], grid[..., 1], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
            steep += (weight * (levels[:, 2:].astype(float) - levels[:, :-2])) ** 2
        steep = np.sqrt(steep)
        k = np.clip(np.argmax(steep, axis=1), 1, steep.shape[1] - 2)
        row = np.arange(ALONG)
        before, at, after = (steep[row, k + j] for j in (-1, 0, 1))
        bend = before - 2 * at + after
        shift = steps[1 + k] + np.where(bend < 0, 0.5 * (before - after) / np.minimum(bend, -1e-9), 0.0).clip(-0.5, 0.5)
        clear = at > max(LEAST_STEEP, 0.3 * float(np.median(at)))
        found = (places + shift[:, None] * normal)[clear]
        if len(found) < FEWEST_POINTS:
            return None
        p, along = _line(found)
        if np.sum(np.abs((found - p) @ np.array([-along[1], along[0]])) < ON_THE_LINE) < LEAST_EDGE * ALONG:
            return None
        lines.append((p, along))
    moved = _meeting(lines)
    return None if moved is None or np.abs(moved - quad).max() > 2 * ACROSS else moved


def _line(points: Array) -> tuple[Array, Array]:
    """A point on the line through most of these, and its direction."""
    import cv2

    line, own = (points.mean(axis=0), np.zeros(2)), points
    for _ in range(3):  # what does not lie on the edge is left out, as far as most agree
        vx, vy, x, y = np.ravel(cv2.fitLine(own.astype(np.float32), cv2.DIST_HUBER, 0, 0.01, 0.01)).astype(float)
        line = np.array([x, y]), np.array([vx, vy])
        off = np.abs((points - line[0]) @ np.array([-vy, vx]))
        own = points[off <= max(0.3, 3 * float(np.median(off)))]
    return line


def _meeting(lines: list[tuple[Array, Array]]) -> Array | None:
    """Corners (4, 2) where each line meets the one before; None where two hardly do."""
    corners = []
    for (p, u), (q, v) in zip([lines[-1], *lines[:-1]], lines, strict=True):
        if abs(u[0] * v[1] - u[1] * v[0]) < 0.1:
            return None
        t = np.linalg.solve(np.column_stack([u, -v]), q - p)[0]
        corners.append(p + t * u)
    return np.array(corners)


def signed_area(quad: Array) -> float:
    """Area of a polygon (n, 2), px²: positive where it runs clockwise as seen, y pointing down."""
    x, y = quad.T
    return float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) / 2)
