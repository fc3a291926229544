"""From a lit mesh to a picture: OpenCV's z-buffer finds what is seen, and its texture is looked up there."""

from __future__ import annotations

import math
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.camera.camera import Camera
from plategait.render.clip.scene import MATT, LitMesh
from plategait.render.clip.texture_atlas import TextureAtlas

Floats = NDArray[np.float32]

# The rasterizer gets points already projected, and puts them back with this angle of its own.
_FIELD = math.pi / 2
_NEAR, _FAR = 1e-3, 1e3


@dataclass(frozen=True, eq=False)
class Fragments:
    """What the pixels of a part of the picture see.

    Parameters
    ----------
    left, top : int
        First pixel of the part.
    values : (rows, columns, 3) array
        Column and row in the texture atlas, and light.
    """

    left: int
    top: int
    values: Floats

    @property
    def part(self) -> tuple[slice, slice]:
        """Rows and columns of the picture."""
        rows, columns = self.values.shape[:2]
        return slice(self.top, self.top + rows), slice(self.left, self.left + columns)


class Rasteriser:
    """Pictures of surfaces by one camera.

    Parameters
    ----------
    camera : Camera
    atlas : TextureAtlas
    """

    def __init__(self, camera: Camera, atlas: TextureAtlas) -> None:
        self.camera, self.atlas = camera, atlas
        rows, columns = np.indices((camera.height, camera.width), dtype=np.float32)
        left, top = atlas.background
        # Before anything is drawn each pixel sees its own of the background.
        self.background = np.stack([columns + left, rows + top, np.ones_like(rows)], axis=-1).astype(np.float32)
        self.settings = (
            cv2.TriangleRasterizeSettings()
            .setCullingMode(cv2.RASTERIZE_CULLING_CW)
            .setShadingType(cv2.RASTERIZE_SHADING_SHADED)
        )

    def rasterise(self, mesh: LitMesh, shift: tuple[float, float] = (0.0, 0.0)) -> Fragments:
        """Find what is seen in the part of the picture that a mesh reaches.

        `shift` (px) moves the picture, so that several with different shifts make smooth edges.
        """
        pixels, depth = self.camera.project_with_depth(mesh.vertices)
        x, y = pixels[:, 0] + shift[0], pixels[:, 1] + shift[1]
        triangles = mesh.triangles
        ahead: NDArray[np.bool_] = np.isfinite(x)
        if not ahead.all():
            triangles = triangles[ahead[triangles].all(axis=1)]
            x, y = np.where(ahead, x, x[ahead][0]), np.where(ahead, y, y[ahead][0])
        left, right = _span(x, self.camera.width)
        top, bottom = _span(y, self.camera.height)
        width, height = right - left, bottom - top
        # A pixel's middle is at 0.5 for the rasterizer, and at 0 for cameras.
        scale = depth / (height / 2)
        points = np.empty((len(x), 3), np.float32)
        points[:, 0] = (x + (0.5 - left - width / 2)) * scale
        points[:, 1] = (height / 2 + top - 0.5 - y) * scale
        points[:, 2] = -depth
        attributes = np.column_stack([mesh.texels, mesh.light])
        values = self.background[top:bottom, left:right].copy()
        distance = np.full((height, width), _FAR, np.float32)
        cv2.triangleRasterize(
            points,
            triangles,
            attributes,
            values,
            distance,
            np.eye(4, dtype=np.float32),
            _FIELD,
            _NEAR,
            _FAR,
            self.settings,
        )
        return Fragments(left, top, values)

    def expose(self, samples: list[Fragments]) -> Floats:
        """(height, width, 3) blue, green, red of one exposure, from 0 to 255 and beyond where it is overexposed.

        Texture and light are averaged apart: within an exposure the light on a place changes too little for the
        product of the means to differ from the mean of the products.
        """
        first = [min(s.top for s in samples), min(s.left for s in samples)]
        last = [max(s.part[k].stop for s in samples) for k in range(2)]
        part = slice(first[0], last[0]), slice(first[1], last[1])
        shape = last[0] - first[0], last[1] - first[1]
        left, top = map(int, self.atlas.background)
        background = self.atlas.pixels[top : top + self.camera.height, left : left + self.camera.width]
        colour, light = np.zeros((*shape, 3), np.float32), np.zeros(shape, np.float32)
        for sample in samples:
            values = sample.values
            if values.shape[:2] != shape:
                values = self.background[part].copy()
                rows, columns = (slice(s.start - f, s.stop - f) for s, f in zip(sample.part, first, strict=True))
                values[rows, columns] = sample.values
            column, row, lit = cv2.split(values)
            cv2.accumulate(cv2.remap(self.atlas.pixels, column, row, cv2.INTER_LINEAR), colour)
            cv2.accumulate(lit, light)
        light /= np.float32(len(samples))
        matt = np.minimum(light, np.float32(MATT))
        picture = background.astype(np.float32)
        shine = cv2.merge([np.float32(255) * (light - matt)] * 3)
        picture[part] = cv2.multiply(colour, cv2.merge([matt / np.float32(len(samples))] * 3)) + shine
        return picture


def _span(values: Array, limit: int) -> tuple[int, int]:
    """First pixel, and the one after the last, of the part of 0 to `limit` that values reach; at least 2 px."""
    first = min(max(math.floor(values.min()) - 1, 0), limit - 2)
    return first, max(first + 2, min(math.ceil(values.max()) + 2, limit))


class Sensor:
    """What a camera makes of light: fall-off, blur of the lens, noise, whole grey levels."""

    def __init__(self, shape: tuple[int, int], gradient: float, defocus: float, noise: float, seed: int) -> None:
        rows, columns = (np.linspace(0, 1, n, dtype=np.float32) for n in shape)
        fall = 1 - gradient * (0.6 * columns[None, :] + 0.4 * rows[:, None])
        self.fall = np.repeat(fall[..., None], 3, axis=2).astype(np.float32)
        self.defocus, self.shape = defocus, shape
        self.generator = np.random.default_rng(seed)
        # Noise is cut from one larger sheet of it: fresh noise for each frame would take longer than the scene.
        self.sheet = self.generator.normal(0, noise, (shape[0] + 97, shape[1] + 89, 3)).astype(np.float32)

    def read(self, picture: Floats) -> NDArray[np.uint8]:
        """(height, width, 3) uint8 picture."""
        shaded = cv2.multiply(picture, self.fall)
        if self.defocus > 0:
            shaded = cv2.GaussianBlur(shaded, (0, 0), self.defocus)
        row, column = (int(self.generator.integers(n)) for n in (97, 89))
        noise = self.sheet[row : row + self.shape[0], column : column + self.shape[1]]
        # Rounds to the nearest level, and stops at 0 and 255.
        return np.asarray(cv2.add(shaded, noise, dtype=cv2.CV_8U), dtype=np.uint8)
