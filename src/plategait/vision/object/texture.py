"""An object without markers: its orientation from its own texture, or from its outline when it is not round.

The object is cut out by its colour and unrolled about its middle, so that turning becomes shifting. A picture is laid
over a template of the object at every shift of the whole circle at once; the template is the mean of the first sure
pictures and then stays as it is, so that no error adds up over turns.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array, Picture
from plategait.vision.object.markers import plate_colour
from plategait.vision.object.pose import Pose
from plategait.vision.plate.rectified import Grid

# Angles and rings of an unrolled picture, and the share of the radius that the rings cover.
ANGLES, RINGS, INNER, OUTER = 512, 28, 0.2, 0.9
# Shading is smoother than this over the circle, texture is finer, rad.
SMOOTH = math.radians(30)
# Brighter than this is glare.
GLARE = 245
# Least correlation with the template, and how far the second best of other angles stays below it.
LEAST_FIT, LEAST_LEAD = {"texture": 0.25, "outline": 0.8}, 0.08
# Angles nearer than this to the best are the same peak, rad.
PEAK = math.radians(20)
# Sure pictures that the template is made of.
TEMPLATE_PICTURES = 60
# Least contrast of a texture, levels, and of an outline, share of its radius.
LEAST_TEXTURE, LEAST_OUTLINE = 1.0, 0.02
# Areas of an object over the plate's.
LEAST_OBJECT, MOST_OBJECT = 0.01, 0.8
# Least difference of the object's colour from the plate's, levels, and least share of its usual area in a sure frame.
LEAST_COLOUR, SURE_AREA = 16.0, 0.55
# Turns of a circle over 2 to 8 are looked at for symmetry; as like as this is the same.
SYMMETRIES, SYMMETRIC = range(8, 1, -1), 0.9


@dataclass(frozen=True, eq=False)
class ObjectAppearance:
    """What the object of a clip looks like as a whole.

    Attributes
    ----------
    colour, ground : (3,) arrays
        Its colour and the plate's, in Y, U, V.
    area : float
        m².
    others : int
        Further patches of that colour and about that size: other objects.
    """

    colour: Array
    ground: Array
    area: float
    others: int = 0

    @property
    def radius(self) -> float:
        """Of a disk with its area, m."""
        return math.sqrt(self.area / math.pi)

    def mask(self, patch: Picture, allowed: Picture) -> Picture:
        """1 where a picture shows the object's colour rather than the plate's."""
        import cv2

        difference = self.colour - self.ground
        along = difference / float(difference @ difference)
        # In bytes, 64 for the object's own colour, which are quick.
        likeness = cv2.transform(patch, 64 * np.append(along, -float(along @ self.ground))[None])
        binary = ((likeness > 32) & (likeness < 160)).astype(np.uint8) & allowed
        return cv2.morphologyEx(binary, cv2.MORPH_OPEN, np.ones((5, 5), np.uint8)).astype(np.uint8, copy=False)


def learn_object(patches: list[Picture], grid: Grid, allowed: Picture) -> ObjectAppearance | None:
    """What the object looks like, from some frames of a clip; None where nothing stands out from the plate."""
    appearances = [a for a in (_appearance_in(patch, grid, allowed) for patch in patches) if a is not None]
    if len(appearances) < max(2, len(patches) // 3):
        return None
    colour, ground, area, others = (
        np.median([getattr(a, name) for a in appearances], axis=0) for name in ("colour", "ground", "area", "others")
    )
    return ObjectAppearance(colour, ground, float(area), int(others))


def standing_out(patch: Picture, grid: Grid, allowed: Picture) -> list[Picture]:
    """What stands out from the plate in one picture and may be an object by its size: masks, the largest first."""
    import cv2

    ground = plate_colour(patch, allowed)
    distance = np.linalg.norm(patch.astype(np.float32) - ground.astype(np.float32), axis=2)
    levels = np.clip(distance, 0, 255).astype(np.uint8)
    level, _ = cv2.threshold(levels[grid.inner & (allowed > 0)], 0, 255, cv2.THRESH_BINARY + cv2.THRESH_OTSU)
    if level < LEAST_COLOUR / 2:
        return []
    parts = _parts(((levels > level) & (allowed > 0) & grid.inner).astype(np.uint8), grid)
    return [p for p in parts if LEAST_OBJECT < p.sum() / p.size < MOST_OBJECT]


def _appearance_in(patch: Picture, grid: Grid, allowed: Picture) -> ObjectAppearance | None:
    """What the largest thing on the plate looks like in one picture; None where nothing stands out."""
    large = standing_out(patch, grid, allowed)
    if not large:
        return None
    ground = plate_colour(patch, allowed)
    colour = np.median(patch[large[0] > 0], axis=0)
    if np.linalg.norm(colour - ground) < LEAST_COLOUR:
        return None
    alike = sum(
        p.sum() > 0.5 * large[0].sum() and np.linalg.norm(np.median(patch[p > 0], axis=0) - colour) < 25
        for p in large[1:]
    )
    return ObjectAppearance(colour, ground, float(large[0].sum()) * grid.pitch**2, int(alike))


def _parts(binary: Picture, grid: Grid) -> list[Picture]:
    """Connected parts without their holes, the largest first."""
    import cv2

    width = max(3, round(1.2e-3 / grid.pitch) | 1)
    opened = cv2.morphologyEx(binary, cv2.MORPH_OPEN, np.ones((width, width), np.uint8))
    contours, _ = cv2.findContours(opened, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    parts = []
    for contour in sorted(contours, key=cv2.contourArea, reverse=True)[:6]:
        part = np.zeros(binary.shape, np.uint8)
        cv2.drawContours(part, [contour], -1, 1, cv2.FILLED)
        parts.append(part)
    return parts


@dataclass(eq=False)
class PolarTemplate:
    """Unrolled object in its own frame: rows that shift when it turns.

    Attributes
    ----------
    name : str
        "texture" or "outline".
    """

    name: str
    total: Array | None = None
    count: int = 0
    spectrum: NDArray[np.complex128] | None = None

    def angle(self, rows: Array) -> tuple[float, float, float]:
        """Turn against the template, rad, its correlation, and its lead over other angles."""
        spectrum = np.fft.rfft(rows, axis=0)
        if self.spectrum is None:
            self.total, self.count, self.spectrum = rows.copy(), 1, spectrum
        template = self.spectrum
        energy = math.sqrt(float(_energy(template).sum() * _energy(spectrum).sum()))
        curve = np.fft.irfft((spectrum * template.conj()).sum(axis=1), ANGLES) * ANGLES / max(energy, 1e-12)
        k = int(np.argmax(curve))
        a, b, c = curve[k - 1], curve[k], curve[(k + 1) % ANGLES]
        turn = 2 * math.pi * (k + 0.5 * (a - c) / min(a - 2 * b + c, -1e-12)) / ANGLES
        away = np.abs((np.arange(ANGLES) - k + ANGLES // 2) % ANGLES - ANGLES // 2) * 2 * math.pi / ANGLES > PEAK
        return turn, float(b), float(b - curve[away].max())

    def learn(self, rows: Array, turn: float) -> None:
        """Add a sure picture to the template while it is not complete."""
        if self.total is None or self.count >= TEMPLATE_PICTURES:
            return
        harmonics = np.arange(ANGLES // 2 + 1)[:, None]
        back = np.fft.irfft(np.fft.rfft(rows, axis=0) * np.exp(1j * harmonics * turn), ANGLES, axis=0)
        self.total, self.count = self.total + back, self.count + 1
        self.spectrum = np.fft.rfft(self.total / self.count, axis=0)

    def symmetry(self) -> int:
        """Turns of a full circle over this look the same to the template."""
        if self.spectrum is None:
            return 1
        curve = np.fft.irfft((np.abs(self.spectrum) ** 2).sum(axis=1), ANGLES)
        curve /= max(curve[0], 1e-12)
        for k in SYMMETRIES:
            turns = np.arange(1, k) * ANGLES / k
            if np.interp(turns, np.arange(ANGLES), curve).min() > SYMMETRIC:
                return k
        return 1


def _energy(spectrum: NDArray[np.complex128]) -> Array:
    """Power of each harmonic as the sum over a whole spectrum counts it."""
    power = np.abs(spectrum) ** 2
    power[1:-1] *= 2
    return power


class TextureTracker:
    """Follows an object by its texture and by its outline, whichever tells more.

    Parameters
    ----------
    appearance : ObjectAppearance
    """

    def __init__(self, appearance: ObjectAppearance) -> None:
        self.appearance = appearance
        self.texture, self.outline = PolarTemplate("texture"), PolarTemplate("outline")

    def find(self, patch: Picture, grid: Grid, allowed: Picture) -> tuple[Pose, Pose]:
        """Pose in a warped picture by texture, and by outline; `allowed` is where the object may be."""
        import cv2

        parts = _parts(self.appearance.mask(patch, allowed), grid)
        if not parts or parts[0].sum() * grid.pitch**2 < SURE_AREA * self.appearance.area:
            lost = Pose(math.nan, math.nan, math.nan, "object not seen whole")
            return lost, lost
        m = cv2.moments(parts[0], True)
        middle = (m["m10"] / m["m00"], m["m01"] / m["m00"])
        x, y = grid.plate(np.array(middle))
        rows, contrast = self._unrolled(patch[..., 0], middle, grid.pitch)
        rim = self._rim(parts[0], middle, grid.pitch)
        return (
            self._pose(self.texture, rows, float(x), float(y), "" if contrast > LEAST_TEXTURE else "no texture"),
            self._pose(self.outline, rim, float(x), float(y), "" if rim.std() > LEAST_OUTLINE else "round outline"),
        )

    def _pose(self, template: PolarTemplate, rows: Array, x: float, y: float, reason: str) -> Pose:
        if reason:
            return Pose(x, y, math.nan, reason)
        turn, fit, lead = template.angle(rows)
        symmetric = template.symmetry() if template.name == "outline" else 1
        if fit < LEAST_FIT[template.name]:
            reason = f"{template.name} not recognised"
        elif lead < LEAST_LEAD and symmetric == 1:
            reason = f"{template.name} fits at several angles"
        if not reason:
            template.learn(rows, turn)
        return Pose(x, y, turn, reason)

    def _unrolled(self, luma: Picture, middle: tuple[float, float], pitch: float) -> tuple[Array, float]:
        """(ANGLES, RINGS) texture by angle counter-clockwise and radius, shading taken out; its contrast, levels."""
        import cv2

        radius = self.appearance.radius / pitch
        total = round(RINGS / (OUTER - INNER))
        polar = cv2.warpPolar(luma, (total, ANGLES), middle, radius, _polar())
        first = round(INNER * total)
        rings = polar[::-1, first : first + RINGS].astype(np.float32)  # rows of a picture run against y
        glare = rings > GLARE
        window = round(SMOOTH / (2 * math.pi) * ANGLES) | 1
        padded = np.concatenate([rings[-window:], rings, rings[:window]])
        smooth = cv2.blur(padded, (5, window))[window:-window]
        fine = rings - smooth
        fine[glare] = 0
        contrast = float(np.median(np.abs(fine))) * 1.48
        # Edges of shadows and of the plate must not outshout the texture.
        return np.clip(fine, -3 * contrast, 3 * contrast).astype(float), contrast

    def _rim(self, part: Picture, middle: tuple[float, float], pitch: float) -> Array:
        """(ANGLES, 1) distance of the outline by angle counter-clockwise, over its mean, less 1."""
        import cv2

        reach = 2.0 * self.appearance.radius / pitch
        steps = 256
        polar = cv2.warpPolar(
            part * 255,
            (steps, ANGLES),
            middle,
            reach,
            _polar(),
        )
        radius = polar[::-1].astype(float).sum(axis=1) / 255
        return (radius / max(radius.mean(), 1e-9) - 1)[:, None]


def _polar() -> int:
    """Flags of an unrolled picture; what lies beyond the picture is black."""
    import cv2

    return cv2.WARP_POLAR_LINEAR | cv2.WARP_FILL_OUTLIERS | cv2.INTER_LINEAR
