"""Where the edge of the object is, all around it, in a picture of the plate from above."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plategait.arrays import Array, Flags, Picture
from plategait.vision.object.pose import Pose
from plategait.vision.object.texture import standing_out
from plategait.vision.plate.rectified import Grid

# Directions in which the edge is looked for, counter-clockwise from x.
RAYS = 96
DIRECTIONS = 2 * math.pi * np.arange(RAYS) / RAYS
# Where it is looked for, over the object's radius, and steps of a ray in a pixel.
NEAREST, FURTHEST, FINER = 0.5, 1.4, 2
# How many standard deviations the object's colours must be apart from the plate's, and are counted as at most.
LEAST_APART, MOST_APART = 2.5, 10.0
# Share of an object that has its own colour.
MOST_OF_IT = 0.7
# Shares by which light and shade may change a colour, tried one after the other; and black in Y, U, V.
SHADES, BLACK = (0.35, 0.15, 0.0), (16.0, 128.0, 128.0)
# The colours on both sides of the edge are those of so many pixels, from so many away from it.
SIDE, GAP = 4, 2
# Furthest that the mark in the middle is off it, and least that the other is on its way to the rim, as shares.
MOST_OFF, LEAST_ALONG = 0.25, 0.4
# Least difference of the two sides for an edge, as a share of the usual one.
LEAST_STEP = 0.35


@dataclass(frozen=True, eq=False)
class RimAppearance:
    """What tells the object from the plate.

    Attributes
    ----------
    axis : (3,) array
        Of Y, U, V, what tells them apart best: a product with it, less `level`, is 0 for the plate, 1 for the object.
    level : float
    plate : (3,) array
        The plate's colour.
    scatter : (3, 3) array
        Takes differences from it to standard deviations of it.
    apart : float
        How many of those count as something else.
    radius : float
        Of a disk with the object's area, m.
    """

    axis: Array
    level: float
    plate: Array
    scatter: Array
    apart: float
    radius: float

    @cached_property
    def channels(self) -> Array:
        """(4, 4) from Y, U, V and 1 to the likeness to the object, and to how far a colour is off the plate."""
        likeness = np.append(self.axis, -self.level)
        off = np.column_stack([self.scatter, -self.scatter @ self.plate]) / self.apart
        return np.concatenate([likeness[None], off])


def learn_rim(
    patches: list[Picture], grid: Grid, allowed: Picture, middles: list[Array | None]
) -> RimAppearance | None:
    """What tells the object from the plate in some frames of a clip; None where their colours are too alike.

    Parameters
    ----------
    patches : list of (rows, columns, 3) arrays
        The plate from above.
    middles : list of (x, y) or None
        Where the object is, m, if that is known: what stands out elsewhere is something else.
    """
    import cv2

    inside: list[Picture] = []
    outside: list[Picture] = []
    areas: list[float] = []
    known = any(middle is not None for middle in middles)
    for patch, middle in zip(patches, middles, strict=True):
        if known and middle is None:
            continue
        parts = standing_out(patch, grid, allowed)
        if middle is not None:
            parts = parts_at(middle, parts, grid)
        if not parts:
            continue
        kernel = np.ones((5, 5), np.uint8)
        core, near = cv2.erode(parts[0], kernel), cv2.dilate(parts[0], kernel)
        bare = (allowed > 0) & (near == 0) & grid.inner
        for chosen, found in ((core > 0, inside), (bare, outside)):
            pixels = patch[chosen]
            found.append(pixels[:: max(1, len(pixels) // 2000)])
        areas.append(float(parts[0].sum()) * grid.pitch**2)
    usual = float(np.median(areas)) if areas else math.nan
    # A hand that reaches over it makes another area of it.
    alike = [k for k, area in enumerate(areas) if abs(area - usual) < 0.15 * usual]
    if len(alike) < max(2, len(patches) // 5):
        return None
    own, ground = (np.concatenate([found[k] for k in alike]).astype(float) for found in (inside, outside))
    return _told_apart(own, ground, math.sqrt(usual / math.pi))


def _told_apart(inside: Array, outside: Array, radius: float) -> RimAppearance | None:
    """Fisher's linear discriminant of two sets of colours (n, 3); None where they overlap.

    Light and shade change both colours: as far as hue tells them apart, their brightness does not count.
    """
    a, b = np.median(inside, axis=0), np.median(outside, axis=0)
    # Most of the object has its own colour: marks and toppings do not.
    away = np.linalg.norm(inside - a, axis=1)
    of_object = np.cov(inside[away <= np.quantile(away, MOST_OF_IT)].T)
    of_plate = np.cov(outside.T) + 4 * np.eye(3)
    for shade in SHADES:
        shaded = [shade * (colour - np.array(BLACK)) for colour in (a, b)]
        plate = of_plate + np.outer(shaded[1], shaded[1])
        along = _with_all_channels(of_object + plate + np.outer(shaded[0], shaded[0]), a - b)
        apart = float(along @ (a - b))
        if apart > LEAST_APART**2:
            whitening = np.asarray(np.linalg.inv(np.linalg.cholesky(plate)), dtype=float)
            distance = float(np.linalg.norm(whitening @ (a - b)))
            return RimAppearance(
                along / apart, float(along @ b) / apart, b, whitening, min(distance, MOST_APART) / 2, radius
            )
    return None


def _with_all_channels(scatter: Array, step: Array) -> Array:
    """Discriminant to which no channel adds against the others: brightness is sharper at an edge than hue is."""
    along, own = np.zeros(3), np.ones(3, bool)
    while own.any():
        along[:] = 0
        along[own] = np.linalg.solve(scatter[np.ix_(own, own)], step[own])
        against = along * step < 0
        if not against.any():
            break
        own &= ~against
    return along


def find_rim(appearance: RimAppearance, patch: Picture, grid: Grid, allowed: Picture, middle: Array) -> Array:
    """(RAYS,) distance of the edge from a point on the object (m) in each of `DIRECTIONS`, m; NaN where it is not seen.

    Along each ray the edge parts best what is like the object from what is like the plate; finer than a pixel, it is
    where the colour is half way between those on both sides, so that shadows and toppings beside it do no harm.
    """
    import cv2

    reach = FURTHEST * appearance.radius
    steps = int(FINER * reach / grid.pitch)
    column, row = (float(v) for v in grid.pixels(middle))
    flags = cv2.WARP_POLAR_LINEAR | cv2.WARP_FILL_OUTLIERS | cv2.INTER_LINEAR
    seen, open_ = (cv2.warpPolar(p, (steps, RAYS), (column, row), reach / grid.pitch, flags) for p in (patch, allowed))
    around = -np.arange(RAYS) % RAYS  # rows of a picture run against y
    open_ = open_[around] > 0
    # Likeness to the object, and how far from the plate's colour. Marks and toppings are as unlike the plate as the
    # object is. What is covered speaks for neither.
    told = cv2.transform(seen[around].astype(np.float32), appearance.channels)
    likeness, off = told[..., 0].astype(float), told[..., 1:]
    unlike = np.sqrt(np.einsum("rsk,rsk->rs", off, off))
    votes = np.clip(unlike - 1, -1, 1) * open_
    first = int(steps * NEAREST / FURTHEST)
    edge = first + np.argmax(np.cumsum(votes, axis=1)[:, first:], axis=1) + 1
    place, clear = _half_way(likeness, open_, edge, first)
    return np.where(clear, place * reach / steps, math.nan)


def _half_way(likeness: Array, open_: Flags, edge: Array, first: int) -> tuple[Array, Flags]:
    """Steps to where each ray is half way between what is on both sides of its edge, and whether that is clear."""
    steps = likeness.shape[1]
    margin = FINER * (SIDE + GAP)
    clear = (edge >= first + margin // 2) & (edge < steps - margin)
    centre = np.clip(edge, margin, steps - margin - 1).astype(int)
    offsets = np.arange(-margin, margin)
    near = likeness[np.arange(RAYS)[:, None], centre[:, None] + offsets]
    clear &= open_[np.arange(RAYS)[:, None], centre[:, None] + offsets].all(axis=1)
    inner, outer = np.median(near[:, : FINER * SIDE], axis=1), np.median(near[:, -FINER * SIDE :], axis=1)
    clear &= inner - outer > LEAST_STEP
    half = (inner + outer) / 2
    above = near > half[:, None]
    # The last crossing downwards nearest to the edge.
    falls = above[:, :-1] & ~above[:, 1:]
    distance = np.where(falls, np.abs(offsets[:-1] + 0.5), np.inf)
    k = np.argmin(distance, axis=1)
    clear &= np.isfinite(distance[np.arange(RAYS), k])
    a, b = near[np.arange(RAYS), k], near[np.arange(RAYS), k + 1]
    share = np.clip((a - half) / np.maximum(a - b, 1e-6), 0, 1)
    return centre + offsets[k] + share, clear


def marked_parts(patches: list[Picture], poses: list[Pose], grid: Grid, allowed: Picture) -> list[Picture | None]:
    """What two marks lie on, in each picture of the plate: of all that stands out from it the largest at their pose."""
    each = zip(patches, poses, strict=True)
    found = [parts_at(np.array([pose.x, pose.y]), standing_out(patch, grid, allowed), grid) for patch, pose in each]
    return [parts[0] if parts else None for parts in found]


def marks_fit(parts: list[Picture | None], poses: list[Pose], grid: Grid) -> bool:
    """Whether two marks lie where an object's do, one in its middle and one near its rim.

    Parameters
    ----------
    parts : list of (rows, columns) arrays or None
        Of `marked_parts`. What does not stand out from the plate contradicts nothing.
    poses : list of Pose
        Of the marks on them.
    """
    off, along = [], []
    for part, pose in zip(parts, poses, strict=True):
        if part is None:
            continue
        rows, columns = np.nonzero(part)
        size = math.sqrt(len(rows) / math.pi) * grid.pitch
        middle = grid.plate(np.array([columns.mean(), rows.mean()]))
        off.append(math.hypot(middle[0] - pose.x, middle[1] - pose.y) / size)
        along.append(pose.spacing / size)
    return not off or (float(np.median(off)) < MOST_OFF and float(np.median(along)) > LEAST_ALONG)


def spots_on_it(parts: list[Picture | None], spots: list[Array], grid: Grid) -> float:
    """How many spots lie on the object that two marks are on: the median over pictures, 0 where it stands out in none.

    Parameters
    ----------
    parts : list of (rows, columns) arrays or None
        Of `marked_parts`.
    spots : list of (n, 2) arrays
        Where something in each picture looks like the marks, m.
    """
    counts = [
        sum(bool(parts_at(place, [part], grid)) for place in places)
        for part, places in zip(parts, spots, strict=True)
        if part is not None
    ]
    return float(np.median(counts)) if counts else 0.0


def parts_at(place: Array, parts: list[Picture], grid: Grid) -> list[Picture]:
    """Of parts of a picture, those at a place, m."""
    column, row = np.round(grid.pixels(place)).astype(int)
    inside = 0 <= row < grid.shape[0] and 0 <= column < grid.shape[1]
    return [p for p in parts if inside and p[row, column]]
