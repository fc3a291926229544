"""What a synthetic film shows: plate, bar, object and what covers markers, as one mesh with light on it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import cv2
import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.camera.camera import Camera
from plategait.camera.fiducials import CENTRE_MARKER, CORNER_SIGNS, RIM_MARKER, RIM_PLACE, PlateTarget, plate_target
from plategait.model.motion import rotation_of
from plategait.model.scenario import Scenario
from plategait.render.clip.appearance import Appearance
from plategait.render.clip.texture_atlas import TextureAtlas, paint_atlas
from plategait.render.sheet_mesh import SheetMesh, SheetSpline, unit_vectors

Indices = NDArray[np.int32]

MATT = 1.15
"""Light on a vertex up to this multiplies its texture; what is above is shine, and adds white."""

_CELLS = 48  # of the plate's grid, each way: light and shadow are exact at its corners
_SLAB, _BAR = 0.045, 0.05  # thickness of the plate and radius of the bar over the plate's half width
_AMBIENT = 0.5
_SHARPNESS = 400.0  # of the shine: a patch of about 30 mm on a flat plate

Occluder = tuple[int, float, float]
"""What covers a marker: which marker, and how far off its middle along the radial line and across it, m."""

_OCCLUDER_RADIUS, _OCCLUDER_HEIGHT, _OCCLUDER_SPREAD = 0.009, 0.004, 0.004  # m, above the object, of its place
_TURN = np.linspace(0, math.tau, 20, endpoint=False)
_DISK = np.concatenate([[[0.0, 0.0]], _OCCLUDER_RADIUS * np.column_stack([np.cos(_TURN), np.sin(_TURN)])])
_FAN = np.column_stack([np.zeros(20), np.arange(1, 21), np.roll(np.arange(1, 21), -1)]).astype(np.int32)


@dataclass(frozen=True, eq=False)
class LitMesh:
    """A lit mesh: (n, 3) vertices in the world, m; (n,) light; (n, 2) texels in the atlas; (k, 3) triangles."""

    vertices: NDArray[np.float32]
    light: NDArray[np.float32]
    texels: NDArray[np.float32]
    triangles: Indices


class Scene:
    """Everything that is filmed; `lit_mesh` gives it at one moment.

    Parameters
    ----------
    scenario : Scenario
        What was simulated. Where it has no plate size, the plate is half as wide again as the object.
    appearance : Appearance
    camera : Camera
        The shine depends on where it stands.
    """

    def __init__(self, scenario: Scenario, appearance: Appearance, camera: Camera) -> None:
        self.appearance, self.eye, self.height = appearance, camera.eye, scenario.motion.height
        extent, plate = scenario.sheet.outline.size(), self.plate_size(scenario)
        size = min(plate) / 6 if appearance.fiducial_size is None else appearance.fiducial_size
        self.target: PlateTarget = plate_target(*plate, size)
        self.sheet_mesh = SheetMesh(scenario.sheet)
        lattice, pitch = scenario.sheet.lattice, scenario.sheet.pitch
        self.rest = lattice.rest * pitch
        spline = SheetSpline(scenario.sheet)
        flat = np.column_stack([(lattice.squares - spline.centre) * pitch, np.zeros(lattice.n_nodes)])
        material, _ = self.sheet_mesh.surface(flat)
        # The centre marker lies on the centre of mass, the rim marker from there along x.
        x0, y0 = (float(v) for v in flat[:, :2].mean(axis=0))
        inside = material[np.unique(self.sheet_mesh.whole)]
        reach = float(inside[np.abs(inside[:, 1] - y0) <= self.sheet_mesh.step, 0].max(initial=x0))
        self.marker_sizes = (CENTRE_MARKER, RIM_MARKER)
        self.marker_places = ((x0, y0), (x0 + RIM_PLACE * (reach - x0), y0))
        around = np.array([-0.5e-3, 0.0, 0.5e-3])
        self._marker_onto = [spline.onto(x + around, y + around) for x, y in self.marker_places]
        drawn = [(*place, *size) for place, size in zip(self.marker_places, self.marker_sizes, strict=True)]
        self.atlas: TextureAtlas = paint_atlas(appearance, self.target, extent, drawn, (camera.height, camera.width))
        self.light = unit_vectors(np.array([0.35, -0.5, 1.0]))
        # The lamp that shines is seen in the plate when it lies level, a little beside its middle.
        self.lamp = unit_vectors(unit_vectors(self.eye * (-1, -1, 1)) + np.array([0.06, 0.1, 0.0]))
        self._build_plate()
        self._build_sheet(material[:, :2])

    @staticmethod
    def plate_size(scenario: Scenario) -> tuple[float, float]:
        """Plate along and across the bar, m."""
        side = 1.5 * max(scenario.sheet.outline.size())
        return (side, side) if scenario.plate is None else (scenario.plate.length, scenario.plate.width)

    def _build_plate(self) -> None:
        """Vertices and normals in the plate's own frame; the grid of its upper side comes first."""
        half = np.array(self.target.size) / 2
        self.half, self.slab, self.bar = half, 2 * _SLAB * half[1], _BAR * half[1]
        x, y = (np.linspace(-h, h, _CELLS + 1) for h in half)
        grid = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
        self.grid = grid
        vertices = [np.column_stack([grid, np.zeros(len(grid))])]
        normals = [np.tile([0.0, 0.0, 1.0], (len(grid), 1))]
        triangles = [_grid_triangles(_CELLS + 1, _CELLS + 1)]
        corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half
        angle = np.linspace(0, math.tau, 17)
        ring = np.column_stack([0 * angle, np.cos(angle), np.sin(angle)])
        quads, outward = [], []
        for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
            quads.append([(*a, -self.slab), (*b, -self.slab), (*b, 0), (*a, 0)])
            outward.append(4 * [np.cross([*(b - a), 0], [0, 0, 1])])
        quads.append([(*c, -self.slab) for c in corners[::-1]])
        outward.append(4 * [[0, 0, -1]])
        for a, b in pairwise(ring):
            near, far = (-half[0], 0, -self.slab / 2), (-8 * half[0], 0, -self.slab / 2)
            quads.append([self.bar * a + near, self.bar * a + far, self.bar * b + far, self.bar * b + near])
            outward.append([a, a, b, b])
        faces = len(grid) + np.arange(4 * len(quads)).reshape(-1, 4)
        vertices.append(np.array(quads, dtype=float).reshape(-1, 3))
        normals.append(unit_vectors(np.array(outward, dtype=float).reshape(-1, 3)))
        triangles += [faces[:, [0, 1, 2]], faces[:, [0, 2, 3]]]
        self.body, self.body_normals = np.concatenate(vertices), np.concatenate(normals)
        self.body_triangles = np.concatenate(triangles)
        plain = np.tile(self.atlas.metal, (4 * len(quads), 1))
        self.body_texels = np.concatenate([self.atlas.plate.texels(grid), plain])

    def _build_sheet(self, material: Array) -> None:
        """Upper and lower side and rim; `material` (n, 2) are the vertices' places on the flat object."""
        sheet_mesh, n = self.sheet_mesh, len(material)
        fans = [sheet_mesh.trimmed[:, [0, k, k + 1]] for k in range(1, 5)]
        upper = np.concatenate([sheet_mesh.whole[:, [0, 1, 2]], sheet_mesh.whole[:, [0, 2, 3]], *fans])
        # Corners of a trimmed polygon are repeated: triangles without area are left out.
        upper = upper[(upper[:, 0] != upper[:, 1]) & (upper[:, 1] != upper[:, 2]) & (upper[:, 0] != upper[:, 2])]
        a, b = sheet_mesh.rim.T
        under, above = a + 2 * n, a + 3 * n
        rim = [np.column_stack([under, b + 2 * n, b + 3 * n]), np.column_stack([under, b + 3 * n, above])]
        sheet = np.concatenate([upper, upper[:, ::-1] + n, *rim])
        self.triangles = np.concatenate([self.body_triangles, sheet + len(self.body)]).astype(np.int32)
        side = np.tile(self.atlas.side, (2 * n, 1))
        sides = [self.atlas.upper.texels(material), self.atlas.under.texels(material)]
        self.texels = np.concatenate([self.body_texels, *sides, side]).astype(np.float32)

    def plate_frame(self, pose: Array) -> tuple[Array, Array]:
        """Rotation (3, 3) of the plate, and the middle of its surface (3,), m, at a pose (6,)."""
        rotation = rotation_of(pose)
        return rotation, pose[:3] + self.height * (rotation[:, 2] - (0.0, 0.0, 1.0))

    def corners(self, poses: Array) -> Array:
        """(n, 4, 3) corners of the plate's surface in the world, m, at poses (n, 6)."""
        flat = np.array([(sx * self.half[0], sy * self.half[1], self.height) for sx, sy in CORNER_SIGNS])
        return flat @ rotation_of(poses).swapaxes(-1, -2) + poses[:, None, :3] - (0, 0, self.height)

    def sheet_frame(self, nodes: Array, pose: Array) -> tuple[float, Array]:
        """Best-fit rotation (rad) and centre (2,) of the object in plate coordinates, as the simulation observes."""
        rotation, middle = self.plate_frame(pose)
        flat = (nodes - middle) @ rotation[:, :2]
        centre = flat.mean(axis=0)
        x0, y0 = self.rest.T
        cross = (x0 * flat[:, 1] - y0 * flat[:, 0]).sum()
        return float(np.arctan2(cross, (x0 * flat[:, 0] + y0 * flat[:, 1]).sum())), centre

    def marker_frames(self, nodes: Array) -> tuple[Array, Array, Array]:
        """Middles (2, 3) of both markers in the world, m, and their unit directions outwards and up, (2, 3) each."""
        middles, along, up = [], [], []
        for onto in self._marker_onto:
            patch = onto(nodes)
            u, v = patch[2, 1] - patch[0, 1], patch[1, 2] - patch[1, 0]
            normal = unit_vectors(np.cross(u, v))
            middles.append(patch[1, 1] + self.sheet_mesh.thickness * normal)
            along.append(unit_vectors(u))
            up.append(normal)
        return np.array(middles), np.array(along), np.array(up)

    def shadow(self, nodes: Array, pose: Array) -> Array:
        """(n,) factor on the light at the plate's grid: darker where the object hides the light."""
        if self.appearance.shadow == 0:
            return np.ones(len(self.grid))
        rotation, middle = self.plate_frame(pose)
        low = (self.sheet_mesh.surface(nodes)[0][self.sheet_mesh.used] - middle) @ rotation
        ray = self.light @ rotation
        lift = np.maximum(low[:, 2], 0)
        falls = low[:, :2] - lift[:, None] * ray[:2] / max(ray[2], 0.2)
        cell = 2 * self.half / _CELLS
        places = np.round((falls + self.half) / cell).astype(int)
        on = ((places >= 0) & (places <= _CELLS)).all(axis=1)
        weight = self.sheet_mesh.step**2 / cell.prod()
        cover = np.bincount(places[on] @ (_CELLS + 1, 1), minlength=(_CELLS + 1) ** 2) * weight
        soft = cv2.GaussianBlur(np.minimum(cover, 1).reshape(_CELLS + 1, -1), (0, 0), 0.9)
        return 1 - self.appearance.shadow * soft.ravel()

    def lit_mesh(self, nodes: Array, pose: Array, shadow: Array, occluders: list[Occluder]) -> LitMesh:
        """Mesh at one moment, with what covers markers."""
        rotation, middle = self.plate_frame(pose)
        body = self.body @ rotation.T + middle
        n = len(shadow)
        body_light = self._matt(self.body_normals @ rotation.T)
        body_light[:n] *= shadow
        body_light[:n] += self._shine(body[:n], np.broadcast_to(rotation[:, 2], (n, 3)))
        low, up = self.sheet_mesh.surface(nodes)
        high = low + self.sheet_mesh.thickness * up
        side = self._matt(self._edge_normals(low, up))
        light = [body_light, self._matt(up) + self._shine(high, up), self._matt(-up), side, side]
        vertices = [body, high, low, low, high]
        if not occluders:
            return LitMesh(_joined(vertices), _joined(light), self.texels, self.triangles)
        texels, triangles = [self.texels], [self.triangles]
        for occluder, normal in self._occluder_disks(nodes, occluders):
            triangles.append(_FAN + sum(map(len, vertices)))
            vertices.append(occluder)
            light.append(self._matt(np.broadcast_to(normal, occluder.shape)))
            texels.append(np.broadcast_to(self.atlas.occluder, (len(occluder), 2)).astype(np.float32))
        return LitMesh(_joined(vertices), _joined(light), np.concatenate(texels), np.concatenate(triangles))

    def _occluder_disks(self, nodes: Array, occluders: list[Occluder]) -> Iterator[tuple[Array, Array]]:
        """Corners of the disks that cover markers, their middle first, and which way they look."""
        middles, along, normals = self.marker_frames(nodes)
        for k, x, y in occluders:
            plane = np.stack([along[k], np.cross(normals[k], along[k])])
            yield middles[k] + _OCCLUDER_HEIGHT * normals[k] + (_DISK + np.array([x, y])) @ plane, normals[k]

    def _edge_normals(self, low: Array, up: Array) -> Array:
        """Directions in which the rim looks, at its vertices."""
        rim = self.sheet_mesh.rim
        outward = np.zeros_like(low)
        along = low[rim[:, 1]] - low[rim[:, 0]]
        np.add.at(outward, rim[:, 0], np.cross(along, up[rim[:, 0]]))
        np.add.at(outward, rim[:, 1], np.cross(along, up[rim[:, 1]]))
        outward[:, 2] += 1e-12
        return unit_vectors(outward)

    def _matt(self, normals: Array) -> Array:
        """Light on surfaces that look along normals, shine apart: the brightness asked for on a level one."""
        level = _AMBIENT + (1 - _AMBIENT) * self.light[2]
        matt = (_AMBIENT + (1 - _AMBIENT) * np.maximum(normals @ self.light, 0)) / level
        return np.minimum(self.appearance.brightness * matt, MATT)

    def _shine(self, points: Array, normals: Array) -> Array:
        """Light on top that makes points white where they mirror the lamp."""
        if self.appearance.glare == 0:
            return np.zeros(len(points))
        halfway = unit_vectors(unit_vectors(self.eye - points) + self.lamp)
        cosine = np.einsum("ij,ij->i", normals, halfway)
        # Next to nothing is left beyond 10 deg.
        near = cosine > 0.985
        shine = np.zeros(len(points))
        shine[near] = 1.2 * self.appearance.glare * cosine[near] ** _SHARPNESS
        return shine


def random_occluders(generator: np.random.Generator) -> list[Occluder]:
    """Choose which markers are covered, the rim's most often, and how far off their middle."""
    covered = ((1,), (1,), (1,), (0,), (0, 1))[int(generator.integers(5))]
    return [
        (k, float(x), float(y))
        for k, (x, y) in zip(covered, generator.normal(0, _OCCLUDER_SPREAD, (2, 2)), strict=False)
    ]


def _joined(arrays: list[Array]) -> NDArray[np.float32]:
    return np.concatenate(arrays, dtype=np.float32, casting="same_kind")


def _grid_triangles(rows: int, columns: int) -> NDArray[np.intp]:
    number = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    return np.concatenate([np.stack(t, axis=-1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])
