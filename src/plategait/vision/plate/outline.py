"""Where the plate is in each picture, by its own outline."""

from __future__ import annotations

from typing import Any

import numpy as np

from plategait.arrays import Array, Picture
from plategait.vision.frames import Frame
from plategait.vision.plate.view import PlateView, homography, rigid

# Shares of the picture that a plate's outline fills.
LEAST_OUTLINE, MOST_OUTLINE = 0.02, 0.9
# The plate's bar is narrower than this share of the picture.
BAR = 0.045


class OutlinePlate:
    """The plate by its four edges: the largest quadrilateral that stands out from what is behind it.

    The corners are followed from picture to picture; in the first one x runs along the edge that is most level. Which
    of the two ways, and the direction of the bar, cannot be known from an outline.

    Parameters
    ----------
    size : (length, width)
        Of the plate, m.
    """

    def __init__(self, size: tuple[float, float]) -> None:
        self.size = size
        self.lens: Array | None = None
        self._corners: Array | None = None
        x, y = size[0] / 2, size[1] / 2
        self._plate = np.array([[-x, -y], [x, -y], [x, y], [-x, y]])

    def find(self, frame: Frame) -> PlateView:
        """Plate in a picture."""
        quad = self._quadrilateral(frame.luma)
        if quad is None:
            return PlateView(None, "outline of the plate not found")
        self._corners = quad
        return self._view(quad)

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

    def _quadrilateral(self, luma: Picture) -> Array | None:
        import cv2

        shrink = max(1, round(max(luma.shape) / 640))
        small = cv2.resize(luma, None, fx=1 / shrink, fy=1 / shrink, interpolation=cv2.INTER_AREA)
        small = cv2.GaussianBlur(small, (5, 5), 0)
        _, light = cv2.threshold(small, 0, 255, cv2.THRESH_BINARY + cv2.THRESH_OTSU)
        best, best_area = None, LEAST_OUTLINE * small.size
        for mask in (light, cv2.bitwise_not(light)):
            closed = cv2.morphologyEx(mask, cv2.MORPH_CLOSE, np.ones((5, 5), np.uint8))
            # The bar is cut off.
            wide = max(5, round(BAR * small.shape[1]))
            closed = cv2.morphologyEx(closed, cv2.MORPH_OPEN, np.ones((wide, wide), np.uint8))
            contours, _ = cv2.findContours(closed, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
            for contour in contours:
                hull = cv2.convexHull(contour)
                area = cv2.contourArea(hull)
                if not best_area < area < MOST_OUTLINE * small.size:
                    continue
                quad = cv2.approxPolyDP(hull, 0.03 * cv2.arcLength(hull, True), True).reshape(-1, 2)
                if len(quad) == 4 and cv2.contourArea(quad) > 0.93 * area:
                    refined = _refined(quad.astype(float), hull.reshape(-1, 2).astype(float), contour.reshape(-1, 2))
                    if refined is not None:
                        best, best_area = refined, area
        if best is None:
            return None
        return self._ordered((best + 0.5) * shrink - 0.5)

    def _ordered(self, quad: Array) -> Array:
        """Corners in the order of the plate's: as before where they are known, else from the lower left."""
        if _area(quad) > 0:  # clockwise on the plate seen from above is positive here, because y of pixels points down
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


def _refined(quad: Array, hull: Array, contour: Any) -> Array | None:
    """Corners where the straight lines through the four sides' points meet: finer than a pixel."""
    import cv2

    points = np.asarray(contour, dtype=float)
    lines = []
    for a, b in zip(quad, np.roll(quad, -1, axis=0), strict=True):
        along = (b - a) / np.linalg.norm(b - a)
        share = (points - a) @ along / np.linalg.norm(b - a)
        off = np.abs((points - a) @ np.array([-along[1], along[0]]))
        own = points[(share > 0.1) & (share < 0.9) & (off < 4)]
        if len(own) < 8:
            return None
        vx, vy, x, y = np.ravel(cv2.fitLine(own.astype(np.float32), cv2.DIST_HUBER, 0, 0.01, 0.01))
        lines.append((np.array([x, y]), np.array([vx, vy])))
    corners = []
    for (p, u), (q, v) in zip([lines[-1], *lines[:-1]], lines, strict=True):
        if abs(u[0] * v[1] - u[1] * v[0]) < 0.1:
            return None
        t = np.linalg.solve(np.column_stack([u, -v]), q - p)[0]
        corners.append(p + t * u)
    return np.array(corners)


def _area(quad: Array) -> float:
    x, y = quad.T
    return float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) / 2)
