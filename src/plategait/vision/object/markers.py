"""Two rectangular markers on the object, one in its middle and one near its rim (section 2.2.2, Fig. 2.4)."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from itertools import permutations

import numpy as np

from plategait.arrays import Array, Picture
from plategait.vision.object.blobs import FULL_LIKENESS, Blob, blobs_in
from plategait.vision.object.pose import NO_POSE, Pose
from plategait.vision.plate.rectified import Grid

# Distances between the markers' middles, m, that are looked for.
LEAST_SPACING, MOST_SPACING = 6e-3, 80e-3
# A rectangle fills this share of the smallest box around it.
LEAST_FILL = 0.72
# Levels that markers differ by from what is around them, and how alike the two are.
LEAST_CONTRAST, MOST_UNLIKE = 18.0, 0.45
# The centre's long side points at the rim within this, rad.
POINTS_AT = math.radians(20)
# Share of the frames looked at first that must show the same pair.
LEAST_VOTES = 0.15
# What a marker's area may be over its usual one, and the distance of the two, for a sure frame.
SURE_AREA, SURE_SPACING = (0.55, 1.6), (0.72, 1.15)
# The middle does not move faster than this between frames, m.
MOST_MOVE = 10e-3


@dataclass(frozen=True, eq=False)
class MarkerAppearance:
    """What the two markers of a clip look like.

    Attributes
    ----------
    marker : (3,) array
        Their colour, in Y, U, V.
    grounds : (k, 3) array
        Colours that they are told from: of the object around them, and of the plate.
    areas : (2,) array
        Of the centre and the rim marker, m².
    spacing : float
        Distance of their middles, m.
    long : bool
        Whether the centre marker is long enough that its direction counts.
    centre : (2,) array
        Where the centre marker was seen, m.
    others : int
        Further pairs that look the same: other objects.
    tracked : (2,) array or None
        Areas as a tracker sees them, m²: markers near the plate's colour lose their edges.
    """

    marker: Array
    grounds: Array
    areas: Array
    spacing: float
    long: bool
    centre: Array
    others: int = 0
    tracked: Array | None = None

    def likeness(self, patch: Picture) -> Picture:
        """(rows, columns): 0 for the grounds' colours, `FULL_LIKENESS` for the markers' (bytes are quick)."""
        import cv2

        kernels = []
        for ground in self.grounds:
            difference = self.marker - ground
            # Colour outlives shade: where there is enough of it, brightness counts less.
            weight = np.array([0.25 if np.hypot(*difference[1:]) > 30 else 1.0, 1.0, 1.0])
            along = weight * difference / float(weight @ difference**2)
            kernels.append(FULL_LIKENESS * np.append(along, -float(along @ ground)))
        # Sums below 0 become 0, those above 255 become 255.
        likenesses = [cv2.transform(patch, kernel[None]) for kernel in kernels]
        return (likenesses[0] if len(likenesses) == 1 else cv2.min(*likenesses)).astype(np.uint8, copy=False)


def learn_markers(patches: list[Picture], grid: Grid, mask: Picture) -> MarkerAppearance | None:
    """What the markers look like, from some frames of a clip; None where there is no such pair in enough of them."""
    candidates = [pairs_in(patch, grid, mask) for patch in patches]
    best = [pairs[0] for pairs in candidates if pairs]
    if len(best) < max(2, LEAST_VOTES * len(patches)):
        return None
    colours = np.array([pair.marker - pair.ground for pair in best])
    middle = np.median(colours, axis=0)
    same = np.linalg.norm(colours - middle, axis=1) < MOST_UNLIKE * np.linalg.norm(middle)
    agreeing = [pair for pair, like in zip(best, same, strict=True) if like]
    spacing = float(np.median([pair.spacing for pair in agreeing]))
    agreeing = [pair for pair in agreeing if abs(pair.spacing - spacing) < 0.2 * spacing]
    if len(agreeing) < max(2, LEAST_VOTES * len(patches)):
        return None
    marker, ground, areas = (
        np.median([getattr(p, k) for p in agreeing], axis=0) for k in ("marker", "ground", "areas")
    )
    plate = np.median([plate_colour(patch, mask) for patch in patches], axis=0)
    grounds = np.array([g for g in (ground, plate) if np.linalg.norm(marker - g) > LEAST_CONTRAST])
    centre = np.median([p.centre for p in agreeing[: max(3, len(agreeing) // 4)]], axis=0)
    others = np.median(
        [sum(_is_other_object(pairs[0], q, spacing) for q in pairs[1:]) for pairs in candidates if pairs]
    )
    return MarkerAppearance(
        marker, grounds, areas, spacing, bool(np.mean([p.long for p in agreeing]) > 0.5), centre, int(others)
    )


def as_tracked(appearance: MarkerAppearance, patches: list[Picture], grid: Grid, mask: Picture) -> MarkerAppearance:
    """The same with the areas that a tracker sees."""
    tracker = MarkerTracker(appearance)
    areas = [tracker.areas for patch in patches if math.isfinite(tracker.find(patch, grid, mask).spacing)]
    return replace(appearance, tracked=np.median(areas, axis=0)) if len(areas) > 1 else appearance


def plate_colour(patch: Picture, allowed: Picture) -> Array:
    """Median colour of the plate's rim, in a picture of the whole plate."""
    rows, columns = patch.shape[:2]
    rim = np.zeros((rows, columns), bool)
    # The picture reaches a little beyond the plate.
    rim[rows // 25 : -(rows // 25), columns // 25 : -(columns // 25)] = True
    rim[rows // 8 : -(rows // 8), columns // 8 : -(columns // 8)] = False
    return np.median(patch[rim & (allowed > 0)], axis=0)


@dataclass(frozen=True, eq=False)
class Pair:
    """A candidate for the two markers in one picture."""

    centre: Array
    rim: Array
    areas: Array
    spacing: float
    long: bool
    marker: Array
    ground: Array
    score: float


def _is_other_object(first: Pair, pair: Pair, spacing: float) -> bool:
    """Whether a pair is one of another object: as large, and nowhere near the first."""
    far = min(np.linalg.norm(a - b) for a in (first.centre, first.rim) for b in (pair.centre, pair.rim)) > 3e-3
    alike = np.linalg.norm((first.marker - first.ground) - (pair.marker - pair.ground)) < MOST_UNLIKE * np.linalg.norm(
        first.marker - first.ground
    )
    return bool(far and alike and pair.long == first.long and abs(pair.spacing - spacing) < 0.2 * spacing
                and np.all(np.abs(np.log(pair.areas / first.areas)) < 0.4))  # fmt: skip


def pairs_in(patch: Picture, grid: Grid, mask: Picture) -> list[Pair]:
    """Pairs of rectangles of one colour that form a radial line, the likeliest first."""
    import cv2

    width = max(3, round(15e-3 / grid.pitch) | 1)
    kernel = np.ones((width, width), np.uint8)
    pairs: list[Pair] = []
    for channel in range(3):
        plane = np.ascontiguousarray(patch[..., channel])
        for operation in (cv2.MORPH_BLACKHAT, cv2.MORPH_TOPHAT):
            hat = cv2.morphologyEx(plane, operation, kernel) * mask
            level, _ = cv2.threshold(hat[mask > 0], 0, 255, cv2.THRESH_BINARY + cv2.THRESH_OTSU)
            if level < LEAST_CONTRAST / 2:
                continue
            blobs = [b for b in blobs_in((hat > level).astype(np.uint8), grid) if b.fill > LEAST_FILL]
            pairs += _pairs(blobs[:12], patch, grid)
    return sorted(pairs, key=lambda pair: -pair.score)


def _pairs(blobs: list[Blob], patch: Picture, grid: Grid) -> list[Pair]:
    colours = [_colours(patch, grid, blob) for blob in blobs]
    pairs = []
    for i, j in permutations(range(len(blobs)), 2):
        a, b = blobs[i], blobs[j]
        line = b.middle - a.middle
        spacing = float(np.hypot(*line))
        if not LEAST_SPACING < spacing < MOST_SPACING or max(a.area, b.area) > 4 * min(a.area, b.area):
            continue
        long = a.aspect > 1.5
        aligned = math.cos(_half_turn(math.atan2(line[1], line[0]) - a.axis)) if long else 0.0
        if (long and aligned < math.cos(POINTS_AT)) or a.aspect < b.aspect - 0.3:
            continue
        (m1, g1), (m2, g2) = colours[i], colours[j]
        contrast = float(min(np.linalg.norm(m1 - g1), np.linalg.norm(m2 - g2)))
        unlike = float(np.linalg.norm(m1 - m2) + np.linalg.norm(g1 - g2)) / max(contrast, 1.0)
        if contrast < LEAST_CONTRAST or unlike > 1.0:
            continue
        score = contrast * a.fill * b.fill * (1.0 + 0.5 * aligned) * (1 - 0.5 * unlike)
        areas = np.array([a.area, b.area])
        pairs.append(Pair(a.middle, b.middle, areas, spacing, long, (m1 + m2) / 2, (g1 + g2) / 2, score))
    return pairs


def _colours(patch: Picture, grid: Grid, blob: Blob) -> tuple[Array, Array]:
    """Colour inside a blob and in a ring around it."""
    column, row = grid.pixels(blob.middle)
    inner = max(1.0, 0.3 * math.sqrt(blob.area) / grid.pitch)
    outer = 1.1 * math.sqrt(blob.area * max(blob.aspect, 1.0)) / grid.pitch + 2
    r = int(outer) + 2
    top, left = max(0, int(row) - r), max(0, int(column) - r)
    part = patch[top : int(row) + r + 1, left : int(column) + r + 1].astype(float)
    ys, xs = np.mgrid[top : top + part.shape[0], left : left + part.shape[1]]
    distance = np.hypot(xs - column, ys - row)
    ring = np.abs(distance - outer) < 1.5
    inside = distance < inner
    if not ring.any() or not inside.any():
        return np.zeros(3), np.zeros(3)
    return np.median(part[inside], axis=0), np.median(part[ring], axis=0)


class MarkerTracker:
    """Follows the two markers from picture to picture.

    Parameters
    ----------
    appearance : MarkerAppearance

    Attributes
    ----------
    areas : (2,) array
        Of the markers when they were last found, m².
    """

    def __init__(self, appearance: MarkerAppearance) -> None:
        self.appearance = appearance
        self._centre = appearance.centre
        self._lost = 0
        self.usual = appearance.areas if appearance.tracked is None else appearance.tracked
        self.areas = self.usual

    @property
    def window(self) -> tuple[Array, float]:
        """Middle and reach, m, of where to look next."""
        return self._centre, 1.25 * self.appearance.spacing + 8e-3 + self._reach

    @property
    def _reach(self) -> float:
        return MOST_MOVE + 2e-3 * min(self._lost, 30)

    def alike(self, patch: Picture, grid: Grid, mask: Picture) -> Array:
        """(n, 2) where something in a warped picture has the colour and the area of one of the markers, m."""
        spots = [
            b.middle for b in self._blobs(patch, grid, mask) if any(_within(b.area / a, SURE_AREA) for a in self.usual)
        ]
        return np.array(spots).reshape(-1, 2)

    def _blobs(self, patch: Picture, grid: Grid, mask: Picture) -> list[Blob]:
        likeness = self.appearance.likeness(patch) * mask
        return blobs_in((likeness > FULL_LIKENESS // 2).astype(np.uint8), grid, likeness)

    def find(self, patch: Picture, grid: Grid, mask: Picture) -> Pose:
        """Pose in a warped picture, among what the mask allows."""
        blobs = self._blobs(patch, grid, mask)
        reach = self._reach
        area, rim_area = self.usual
        centres = [b for b in blobs if _within(b.area / area, (0.4, 1.9)) and self._off(b) < reach]
        pairs = [
            (c, r)
            for c in centres
            for r in blobs
            if r is not c and _within(r.area / rim_area, (0.35, 1.9)) and _within(self._stretch(c, r), (0.55, 1.25))
            and self._aside(c, r) < 2 * POINTS_AT
        ]  # fmt: skip
        if not pairs:
            self._lost += 1
            return NO_POSE._replace(reason="rim marker not seen" if centres else "centre marker not seen")
        pairs.sort(key=lambda pair: self._cost(*pair))
        centre, rim = pairs[0]
        self.areas = np.array([centre.area, rim.area])
        line = rim.middle - centre.middle
        reason = ""
        if not (_within(centre.area / area, SURE_AREA) and _within(rim.area / rim_area, SURE_AREA)):
            reason = "marker partly hidden"
        elif not _within(self._stretch(centre, rim), SURE_SPACING):
            reason = "markers at another distance"
        elif self._aside(centre, rim) > POINTS_AT:
            reason = "markers not in line"
        elif len(pairs) > 1 and self._cost(*pairs[1]) < self._cost(*pairs[0]) + 0.25:
            reason = "two pairs of markers alike"
        if not reason:
            self._centre, self._lost = centre.middle, 0
        else:
            self._lost += 1
        x, y = (float(v) for v in centre.middle)
        return Pose(x, y, math.atan2(line[1], line[0]), reason, float(np.hypot(*line)))

    def _off(self, blob: Blob) -> float:
        return float(np.hypot(*(blob.middle - self._centre)))

    def _stretch(self, centre: Blob, rim: Blob) -> float:
        return float(np.hypot(*(rim.middle - centre.middle))) / self.appearance.spacing

    def _aside(self, centre: Blob, rim: Blob) -> float:
        """Angle between the centre marker's long side and the line to the rim marker, rad; 0 for a square one."""
        if not self.appearance.long or centre.aspect < 1.25:
            return 0.0
        line = rim.middle - centre.middle
        return abs(_half_turn(math.atan2(line[1], line[0]) - centre.axis))

    def _cost(self, centre: Blob, rim: Blob) -> float:
        areas = np.log(np.array([centre.area, rim.area]) / self.usual)
        spacing = 3 * abs(self._stretch(centre, rim) - 1)
        return float(np.abs(areas).sum() + spacing + self._aside(centre, rim) + self._off(centre) / MOST_MOVE)


def _half_turn(angle: float) -> float:
    """Angle modulo half a turn, from -90 to 90 deg."""
    return (angle + math.pi / 2) % math.pi - math.pi / 2


def _within(value: float, limits: tuple[float, float]) -> bool:
    return limits[0] <= value <= limits[1]
