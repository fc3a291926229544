"""A picture of a run: plate, bar, light, shadow and sheet, by a painter's algorithm on supersampled images."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plategait.arrays import Array
from plategait.model.motion import rotation_of
from plategait.model.scenario import Scenario
from plategait.render.sheet_mesh import Faces, SheetMesh, unit_vectors
from plategait.render.viewpoint import framing

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw


# Pixels are drawn this many times finer each way, then averaged.
FINER = 2
# Thickness of the plate and radius of the bar over the plate's width.
SLAB, BAR = 0.045, 0.03

_SKY, _FLOOR, _SHADOW = (250, 251, 252), (216, 223, 230), (36, 46, 62)
_PLATE, _GRID, _AXIS, _METAL = (203, 212, 221), (186, 196, 207), (112, 126, 143), (165, 172, 181)
MARK = (196, 78, 82)
"""Colour of what is marked on the plate."""
_AMBIENT, _DIFFUSE, _SHINE = 0.50, 0.56, 0.18


class Painter:
    """Draws the frames of a run; holds what does not change from frame to frame."""

    def __init__(self, scenario: Scenario, poses: Array, size: tuple[int, int]) -> None:
        from PIL import Image

        self.sheet_mesh = SheetMesh(scenario.sheet)
        self.height = scenario.motion.height
        side = 1.5 * max(scenario.sheet.outline.size())
        self.half = (
            np.array([side, side] if scenario.plate is None else [scenario.plate.length, scenario.plate.width]) / 2
        )
        self.slab, self.bar = 2 * SLAB * self.half[1], 2 * BAR * self.half[1]
        corners = np.concatenate([self._corners(0.0), self._corners(-self.slab)])
        framed = (corners @ rotation_of(poses).swapaxes(-1, -2) + self._origin(poses)[:, None]).reshape(-1, 3)
        self.camera = framing(framed, (size[0] * FINER, size[1] * FINER))
        right, below, forward = self.camera.rotation
        self.light = unit_vectors(-0.8 * below - 0.6 * right - 0.2 * forward + (0.0, 0.0, 0.4))
        self.halfway = unit_vectors(self.light - forward)
        fall = Image.linear_gradient("L").resize((size[0] * FINER, size[1] * FINER))
        self.background = Image.composite(Image.new("RGB", fall.size, _FLOOR), Image.new("RGB", fall.size, _SKY), fall)

    def _origin(self, poses: Array) -> Array:
        """(…, 3) middle of the plate's surface: it lies `height` above the point that the plate turns about."""
        return poses[..., :3] + self.height * (rotation_of(poses)[..., 2] - (0.0, 0.0, 1.0))

    def _corners(self, z: float) -> Array:
        """(4, 3) corners of the plate at a height in its own frame, counter-clockwise from above."""
        return np.column_stack([np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * self.half, np.full(4, z)])

    def picture(
        self, nodes: Array, pose: Array, marked: Sequence[Array] = (),
        over: Sequence[tuple[Array, tuple[int, int, int]]] = (),
    ) -> Image:  # fmt: skip
        """One frame, with lines (n, 2), m, marked on the plate, and others in colours that the sheet does not hide."""
        from PIL import Image, ImageDraw

        rotation, origin = rotation_of(pose), self._origin(pose)
        low, up = self.sheet_mesh.surface(nodes)
        polygons, colours, corners = self._visible(self.sheet_mesh.faces(nodes, low, up))
        # The plane of the plate parts what it hides from what hides it.
        towards = rotation[:, 2] * np.sign((self.camera.eye - origin) @ rotation[:, 2])
        hidden = (corners - origin) @ towards < -2 * self.sheet_mesh.thickness
        canvas = self.background.copy()
        draw = ImageDraw.Draw(canvas)
        for k in np.nonzero(hidden)[0]:
            draw.polygon(polygons[k], colours[k])
        self._draw_plate(draw, rotation, origin)
        for line in marked:
            self._draw_line(draw, line, MARK, rotation, origin)
        picture = canvas.reduce(FINER)
        self._cast_shadow(picture, (low[self.sheet_mesh.used] - origin) @ rotation, rotation, origin)
        layer = Image.new("RGBA", canvas.size)
        draw = ImageDraw.Draw(layer)
        for k in np.nonzero(~hidden)[0]:
            draw.polygon(polygons[k], colours[k])
        for line, colour in over:
            self._draw_line(draw, line, colour, rotation, origin)
        box = layer.getbbox()
        if box:
            left, top = box[0] // FINER, box[1] // FINER
            smooth = layer.crop((left * FINER, top * FINER, box[2], box[3])).reduce(FINER)
            picture.paste(smooth, (left, top), smooth)
        return picture

    def _draw_line(
        self, draw: ImageDraw, line: Array, colour: tuple[int, int, int], rotation: Array, origin: Array
    ) -> None:
        """Draw a line (n, 2), m, on the plate."""
        points = np.column_stack([line, np.zeros(len(line))]) @ rotation.T + origin
        draw.line(self.camera.project(points).ravel().tolist(), colour, round(2.5 * FINER))

    def _visible(self, groups: list[Faces]) -> tuple[list[list[float]], list[tuple[int, int, int]], Array]:
        """Polygons in pixels and their colours, the furthest first, and the middle of each in the world."""
        polygons: list[list[float]] = []
        colours, middles, depths = [], [], []
        for group in groups:
            pixels, depth = self.camera.project_with_depth(group.corners)
            x, y = np.moveaxis(pixels, -1, 0)
            facing = (x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1) < 0
            visible = facing & (depth.min(axis=1) > 1e-3) & (np.abs(pixels).max(axis=(1, 2)) < 1e5)
            polygons += pixels[visible].reshape(-1, 2 * pixels.shape[1]).tolist()
            colours.append(self._lit(group.colour, group.outward[visible]))
            middles.append(group.corners[visible].mean(axis=1))
            depths.append(depth[visible].mean(axis=1) - group.nearer)
        order = np.argsort(-np.concatenate(depths))
        colour = np.concatenate(colours)[order].tolist()
        return [polygons[k] for k in order], [tuple(c) for c in colour], np.concatenate(middles)[order]

    def _lit(self, colour: tuple[int, int, int], outward: Array) -> NDArray[np.uint8]:
        """(n, 3) colours of faces that look outward (n, 3): ambient, diffuse and a little shine."""
        outward = unit_vectors(outward)
        matt = _AMBIENT + _DIFFUSE * np.maximum(outward @ self.light, 0)
        shine = 255 * _SHINE * np.maximum(outward @ self.halfway, 0) ** 30
        return np.clip(np.outer(matt, colour) + shine[:, None], 0, 255).astype(np.uint8)

    def _draw_plate(self, draw: ImageDraw, rotation: Array, origin: Array) -> None:
        def pixels(points: ArrayLike) -> Array:
            return self.camera.project(np.asarray(points, dtype=float) @ rotation.T + origin)

        def lines(points: ArrayLike, colour: tuple[int, int, int], width: float) -> None:
            for line in pixels(points).reshape(-1, 4).tolist():
                draw.line(line, colour, round(width * FINER))

        length, width = self.half
        top, bottom = self._corners(0.0), self._corners(-self.slab)
        # The bar leaves the plate at its far edge.
        angle = np.linspace(0, 2 * math.pi, 25)
        ring = self.bar * np.column_stack([0 * angle, np.cos(angle), np.sin(angle)]) - (0, 0, self.slab / 2)
        near, far = ring - (length, 0, 0), ring - (6 * length, 0, 0)
        sides = np.stack([near[:-1], far[:-1], far[1:], near[1:]], axis=1)
        slab = np.stack([bottom, np.roll(bottom, -1, axis=0), np.roll(top, -1, axis=0), top], axis=1)
        slab = np.concatenate([slab, [top, bottom[::-1]]])
        for corners, colour in ((sides, _METAL), (slab, _PLATE)):
            outward = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) @ rotation.T
            for polygon, tint in zip(
                *self._visible([Faces(corners @ rotation.T + origin, outward, colour)])[:2], strict=True
            ):
                draw.polygon(polygon, tint)
        if (self.camera.eye - origin) @ rotation[:, 2] > 0:
            pitch = 10 ** round(math.log10(2 * max(length, width) / 8))
            for k in range(-int(length / pitch), int(length / pitch) + 1):
                lines([(k * pitch, -width, 0), (k * pitch, width, 0)], _GRID, 1)
            for k in range(-int(width / pitch), int(width / pitch) + 1):
                lines([(-length, k * pitch, 0), (length, k * pitch, 0)], _GRID, 1)
            lines([(-length, 0, 0), (length, 0, 0)], _AXIS, 1.5)

    def _cast_shadow(self, picture: Image, sheet: Array, rotation: Array, origin: Array) -> None:
        """Darken the plate under the sheet (n, 3), plate frame: sharply where it touches, softly where it is lifted."""
        from PIL import Image
        from scipy.ndimage import gaussian_filter

        if (self.camera.eye - origin) @ rotation[:, 2] <= 0:
            return
        grain = self.half.max() / 80
        shape = np.ceil(2 * self.half / grain).astype(int)
        sheet = sheet[sheet[:, 2] > -2 * self.sheet_mesh.thickness]
        ray = self.light @ rotation
        height = np.maximum(sheet[:, 2], 0)
        falls = (sheet[:, :2] - height[:, None] * ray[:2] / ray[2] + self.half) / grain
        places = np.floor(falls).astype(int)
        on = ((places >= 0) & (places < shape)).all(axis=1)
        index = places[on, 0] * shape[1] + places[on, 1]
        close = np.exp(-height[on] / 3e-3)

        def cover(weights: Array, blur: float) -> Array:
            share = np.bincount(index, weights, shape.prod()).reshape(shape) * (self.sheet_mesh.step / grain) ** 2
            return np.minimum(gaussian_filter(share, blur / grain), 1)

        dark = 0.45 * cover(close, 1.5e-3) + 0.4 * cover(1 - close, 4e-3) + 0.3 * cover(close, 5e-3)
        texture = Image.fromarray((255 * np.clip(dark, 0, 0.7)).astype(np.uint8).T)
        plane = self.camera.plane(origin, rotation[:, 0], rotation[:, 1])
        scale = np.diag([FINER, FINER, 1.0])
        to_texture = (
            np.array([[1, 0, self.half[0]], [0, 1, self.half[1]], [0, 0, grain]]) @ np.linalg.inv(plane) @ scale
        )
        to_texture /= to_texture[2, 2]
        mask = texture.transform(
            picture.size, Image.Transform.PERSPECTIVE, to_texture.ravel()[:8].tolist(), Image.Resampling.BILINEAR
        )
        picture.paste(_SHADOW, (0, 0), mask)
