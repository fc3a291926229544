"""What the surfaces of a synthetic film are painted with: one picture that holds the textures of all of them."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array, Picture
from plategait.camera.fiducials import IDS, MODULES, PlateTarget, marker_modules
from plategait.render.clip.appearance import Appearance, Colour

_PIXELS = 900  # of a tile's longer side
_GAP = 6  # px around a tile, so that interpolation never reaches its neighbour
_PLAIN = 24  # px of a plain tile

METAL: Colour = (150, 156, 163)


@dataclass(frozen=True)
class Tile:
    """A surface's part of the atlas: its first pixel (column, row), its size (px), and half its extent (m)."""

    first: tuple[int, int]
    size: tuple[int, int]
    half: tuple[float, float]

    def texels(self, points: Array) -> Array:
        """Columns and rows (…, 2) of points (…, 2) on the surface, m: x to the right, y up."""
        share = (np.asarray(points) * (1, -1) / self.half + 1) / 2
        return share * self.size - 0.5 + self.first


@dataclass(frozen=True, eq=False)
class TextureAtlas:
    """The textures of all surfaces.

    Parameters
    ----------
    pixels : (height, width, 3) uint8 array
        Blue, green, red.
    plate, upper, under : Tile
        Of the plate's upper side, and the object's two sides.
    background : (2,) array
        First column and row of the background, which is as large as the picture.
    side, metal, occluder : (2,) arrays
        Plain colours: of the object's rim, of bar and slab, and of occluders, which cover markers.
    """

    pixels: Picture
    plate: Tile
    upper: Tile
    under: Tile
    background: Array
    side: Array
    metal: Array
    occluder: Array


def paint_atlas(
    appearance: Appearance,
    target: PlateTarget,
    extent: tuple[float, float],
    markers: list[tuple[float, float, float, float]],
    picture: tuple[int, int],
) -> TextureAtlas:
    """Paint a plate and an object.

    Parameters
    ----------
    target : PlateTarget
        Of the plate.
    extent : (float, float)
        Of the object, m.
    markers : list of (x, y, length, width)
        Middle on the flat object, and size along x and y, m.
    picture : (rows, columns)
        Of what is filmed, for the background.
    """
    half_plate = (target.size[0] / 2, target.size[1] / 2)
    half_sheet = (0.55 * extent[0], 0.55 * extent[1])
    upper = _food(_shape(half_sheet), half_sheet, appearance.object_colour, appearance.texture, appearance.seed)
    under = _food(_shape(half_sheet), half_sheet, appearance.object_colour, appearance.texture, appearance.seed + 1)
    if appearance.markers:
        for x, y, length, width in markers:
            corners = [(x - length / 2, y - width / 2), (x + length / 2, y + width / 2)]
            _fill(upper, half_sheet, corners, appearance.marker_colour)
    plate = _plate(_shape(half_plate), appearance)
    if appearance.fiducials:
        _print(plate, half_plate, target)
    occluder = tuple(round(0.86 * c) for c in appearance.object_colour)
    plain = [
        np.full((_PLAIN, _PLAIN, 3), colour[::-1], np.uint8) for colour in (appearance.object_colour, METAL, occluder)
    ]
    pixels, firsts = _side_by_side([plate, upper, under, _bench(picture, appearance.seed), *plain])
    tiles = [
        Tile(first, (image.shape[1], image.shape[0]), half)
        for first, image, half in zip(firsts, (plate, upper, under), (half_plate, half_sheet, half_sheet), strict=False)
    ]
    middles = [np.array(first) + (_PLAIN - 1) / 2 for first in firsts[4:]]
    return TextureAtlas(pixels, tiles[0], tiles[1], tiles[2], np.array(firsts[3]), middles[0], middles[1], middles[2])


def clouds(shape: tuple[int, int], grain: float, generator: np.random.Generator) -> NDArray[np.float32]:
    """Smooth random field of mean 0 and standard deviation 1, whose lumps are about `grain` px."""
    coarse = [max(3, round(n / grain) + 3) for n in shape]
    field = generator.normal(size=coarse).astype(np.float32)
    field = cv2.resize(field, (shape[1], shape[0]), interpolation=cv2.INTER_CUBIC)
    return (field - field.mean()) / max(float(field.std()), 1e-6)


def _shape(half: tuple[float, float]) -> tuple[int, int]:
    """Rows and columns of a tile."""
    scale = _PIXELS / max(half)
    return max(8, round(scale * half[1])), max(8, round(scale * half[0]))


def _food(shape: tuple[int, int], half: tuple[float, float], colour: Colour, contrast: float, seed: int) -> Picture:
    """Speckle of lumps from 15 mm down to 1 mm, and some darker spots, as on cheese or a pancake."""
    generator = np.random.default_rng(seed)
    per_mm = 1e-3 * shape[1] / (2 * half[0])
    field = np.zeros(shape, np.float32)
    for grain, weight in ((15, 0.35), (5, 0.35), (2, 0.3), (1, 0.2)):
        field += weight * clouds(shape, grain * per_mm, generator)
    spots = np.zeros(shape, np.float32)
    area = 4e6 * half[0] * half[1]
    for _ in range(max(3, round(area / 120))):
        middle = (int(generator.integers(shape[1])), int(generator.integers(shape[0])))
        axes = tuple(max(1, int(per_mm * r)) for r in generator.uniform(0.4, 1.8, 2))
        cv2.ellipse(spots, middle, axes, float(generator.uniform(0, 180)), 0, 360, float(generator.uniform(0.3, 1)), -1)
    spots = cv2.GaussianBlur(spots, (0, 0), 0.3 * per_mm)
    light = 1 + contrast * (0.22 * field - 0.55 * spots)
    base = np.array(colour[::-1], np.float32)
    return np.clip(base * light[..., None] * (1, 1, 1), 0, 255).astype(np.uint8)


def _bench(shape: tuple[int, int], seed: int) -> Picture:
    """Out-of-focus workshop behind the plate."""
    generator = np.random.default_rng(seed + 3)
    field = 0.6 * clouds(shape, shape[1] / 5, generator) + 0.4 * clouds(shape, shape[1] / 14, generator)
    tint, grey = clouds(shape, shape[1] / 3, generator), 92 + 16 * field
    return np.clip(np.stack([grey - 6 * tint, grey, grey + 6 * tint + 8], axis=-1), 0, 255).astype(np.uint8)


def _plate(shape: tuple[int, int], appearance: Appearance) -> Picture:
    """Brushed along x, with a few stains."""
    generator = np.random.default_rng(appearance.seed + 2)
    brushing = cv2.GaussianBlur(generator.normal(size=shape).astype(np.float32), (0, 0), sigmaX=25, sigmaY=0.8)
    brushing /= max(float(brushing.std()), 1e-6)
    light = 1 + appearance.plate_texture * (0.08 * brushing + 0.10 * clouds(shape, 90, generator))
    return np.clip(np.array(appearance.plate_colour[::-1], np.float32) * light[..., None], 0, 255).astype(np.uint8)


def _fill(
    image: Picture, half: tuple[float, float], corners: list[tuple[float, float]] | Array, colour: Colour
) -> None:
    """Fill the rectangle between two corners (m), its edges mixed as far as they cover a pixel."""
    tile = Tile((0, 0), (image.shape[1], image.shape[0]), half)
    corner_texels = tile.texels(np.asarray(corners))
    low, high = corner_texels.min(axis=0), corner_texels.max(axis=0)
    columns, rows = (
        np.arange(max(0, round(low[k])), min(n, round(high[k]) + 1), dtype=float) for k, n in enumerate(tile.size)
    )
    across, down = (
        np.clip(np.minimum(p + 0.5, high[k]) - np.maximum(p - 0.5, low[k]), 0, 1) for k, p in enumerate((columns, rows))
    )
    part = image[max(0, round(low[1])) :, max(0, round(low[0])) :][: len(rows), : len(columns)]
    cover = np.outer(down, across)[..., None]
    part[:] = np.round(part * (1 - cover) + cover * np.array(colour[::-1]))


def _print(image: Picture, half: tuple[float, float], target: PlateTarget) -> None:
    """Print the corner markers on white paper."""
    module = target.marker / MODULES
    for number, corners in zip(IDS, target.corners, strict=True):
        (left, top), (right, bottom) = corners[0], corners[2]
        _fill(image, half, [(left - module, bottom - module), (right + module, top + module)], (240, 240, 238))
        black = marker_modules(number)
        for row in range(MODULES):
            for column in np.nonzero(black[row])[0]:
                x, y = left + column * module, top - row * module
                _fill(image, half, [(x, y - module), (x + module, y)], (24, 24, 26))


def _side_by_side(images: list[Picture]) -> tuple[Picture, list[tuple[int, int]]]:
    """Put images into one, each with its edge repeated around it, and say where their first pixels are."""
    framed = [cv2.copyMakeBorder(i, _GAP, _GAP, _GAP, _GAP, cv2.BORDER_REPLICATE) for i in images]
    height = max(i.shape[0] for i in framed)
    firsts = np.cumsum([0, *(i.shape[1] for i in framed)])[:-1] + _GAP
    filled = [cv2.copyMakeBorder(i, 0, height - i.shape[0], 0, 0, cv2.BORDER_REPLICATE) for i in framed]
    return np.concatenate(filled, axis=1, dtype=np.uint8, casting="unsafe"), [(int(f), _GAP) for f in firsts]
