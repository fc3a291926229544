"""The sheet as polygons: a smooth surface through its nodes, trimmed to the outline, with a rim and two markers."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array, Flags
from plategait.errors import InputError
from plategait.model.sheet import Sheet

# Cells along the sheet's longer side, and nodes its surface is drawn through (a finer lattice is thinned out).
CELLS, MOST_NODES = 80, 1000
SHEET_COLOUR, MARKER_COLOUR = (250, 196, 72), (24, 66, 116)


@dataclass(frozen=True, eq=False)
class Faces:
    """Polygons of one colour: (n, k, 3) corners counter-clockwise seen from outside, (n, 3) outward directions."""

    corners: Array
    outward: Array
    colour: tuple[int, int, int]
    nearer: float = 0.0  # how much closer to the camera to take them when sorting, m


class SheetSpline:
    """Thin-plate spline through a sheet's nodes: smooth between them and on to the outline, half a pitch beyond."""

    def __init__(self, sheet: Sheet) -> None:
        lattice = sheet.lattice
        stride = math.ceil(math.sqrt(lattice.n_nodes / MOST_NODES))
        self.retained = np.nonzero((lattice.squares % stride == 0).all(axis=1))[0]
        self.centre = (np.array(lattice.occupied.shape) - 1) / 2
        self.nodes = lattice.squares[self.retained] - self.centre
        self.pitch, self.reach, self.wide = sheet.pitch, float(stride), np.ptp(self.nodes, axis=0) > 0
        n, basis = len(self.nodes), self._basis(self.nodes)
        system = np.zeros((basis.shape[1], basis.shape[1]))
        system[:n], system[n:, :n] = basis, basis[:, n:].T
        self.solution = np.linalg.inv(system)[:, :n]

    def _basis(self, points: Array) -> Array:
        from scipy.spatial.distance import cdist

        square = np.asarray(cdist(points, self.nodes, "sqeuclidean"), dtype=np.float64)
        kernel = square * np.log(np.maximum(square, 1e-30))
        return np.concatenate([kernel, np.ones((len(points), 1)), points[:, self.wide]], axis=1, dtype=np.float64)

    def reaches(self, points: Array) -> Flags:
        """Whether points (n, 2), m, are within a pitch of a node."""
        from scipy.spatial.distance import cdist

        return cdist(points / self.pitch, self.nodes).min(axis=1, initial=np.inf) <= self.reach

    def onto(self, x: Array, y: Array) -> Callable[[Array], Array]:
        """Give what takes values at all nodes (n_nodes, k) to values (len(x), len(y), k) on a grid of points, m."""
        basis = self._basis(np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2) / self.pitch)
        return lambda values: (basis @ (self.solution @ values[self.retained])).reshape(len(x), len(y), -1)


class SheetMesh:
    """A sheet's surfaces: grid cells trimmed to the outline, its rim, and two markers that form a radial line."""

    def __init__(self, sheet: Sheet) -> None:
        self.sheet, self.spline = sheet, SheetSpline(sheet)
        extent = np.array(sheet.outline.size())
        if not self.spline.wide.all():
            raise InputError(
                "sheet", "a single row of nodes", "at least 2 nodes across both ways", "a finer sheet.pitch"
            )
        self.thickness, self.step = sheet.thickness, float(extent.max()) / CELLS
        x, y = (self.step * np.arange(-half - 1, half + 2) for half in np.ceil(extent / 2 / self.step))
        self.onto = self.spline.onto(x, y)
        grid = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
        within = self._inside(grid)
        number = np.arange(len(grid)).reshape(len(x), len(y))
        cells = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1).reshape(-1, 4)
        corners_in = within[cells].sum(axis=1)
        self.whole = cells[corners_in == 4]
        self.trimmed, self.rim, self.edges = _trim(cells[(corners_in > 0) & (corners_in < 4)], within, len(grid))
        self.crossing = self._crossings(grid)
        self.used = np.unique(self.whole)
        along = grid[within & (np.abs(grid[:, 1]) <= self.step), 0]
        places = (0.0, 0.8 * float(along.max(initial=0.0)))
        self.markers = [self._marker(place, float(extent.min()) / 2) for place in places]

    def _inside(self, points: Array) -> Flags:
        """Whether points (n, 2), m, lie within the outline and near enough to a node."""
        return self.sheet.outline.contains(points[:, 0], points[:, 1]) & self.spline.reaches(points)

    def _crossings(self, grid: Array) -> Array:
        """Where the outline crosses the edges, as a share of their length, by halving."""
        low, high = np.zeros(len(self.edges)), np.ones(len(self.edges))
        for _ in range(20):
            middle = (low + high) / 2
            inside = self._inside(_between(grid, self.edges, middle))
            low, high = np.where(inside, middle, low), np.where(inside, high, middle)
        return low

    def _marker(self, place: float, size: float) -> tuple[Callable[[Array], Array], Flags]:
        """What draws a marker at x = `place`, m, on a sheet of half this size: see `SheetSpline.onto`; cells inside."""
        x, y = place + size * np.linspace(-0.17, 0.17, 9), size * np.linspace(-0.085, 0.085, 5)
        middles = np.stack(np.meshgrid((x[1:] + x[:-1]) / 2, (y[1:] + y[:-1]) / 2, indexing="ij"), axis=-1)
        return self.spline.onto(x, y), self._inside(middles.reshape(-1, 2))

    def surface(self, nodes: Array) -> tuple[Array, Array]:
        """(n, 3) vertices of the lower face and their upward unit normals."""
        grid = self.onto(nodes)
        normals = _normals(grid).reshape(-1, 3)
        grid = grid.reshape(-1, 3)
        low = np.concatenate([grid, _between(grid, self.edges, self.crossing)])
        return low, np.concatenate([normals, _between(normals, self.edges, self.crossing)])

    def faces(self, nodes: Array, low: Array, up: Array) -> list[Faces]:
        """All that can be seen of the sheet, given its surface."""
        high = low + self.thickness * up
        faces = []
        for cells in (self.whole, self.trimmed):
            faces.append(Faces(high[cells], up[cells].mean(axis=1), SHEET_COLOUR))
            faces.append(Faces(low[cells[:, ::-1]], -up[cells].mean(axis=1), SHEET_COLOUR))
        a, b = self.rim.T
        faces.append(
            Faces(np.stack([low[a], low[b], high[b], high[a]], axis=1), np.cross(low[b] - low[a], up[a]), SHEET_COLOUR)
        )
        for onto, inside in self.markers:
            patch = onto(nodes)
            patch = patch + (self.thickness + 2e-4) * _normals(patch)
            cells = _cells(patch)[inside]
            faces.append(
                Faces(
                    cells,
                    np.cross(cells[:, 2] - cells[:, 0], cells[:, 3] - cells[:, 1]),
                    MARKER_COLOUR,
                    1.5 * self.step,
                )
            )
        return faces


def _cells(grid: Array) -> Array:
    """(n, 4, 3) corners of the cells of a grid of points."""
    return np.stack([grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]], axis=2).reshape(-1, 4, 3)


def _normals(grid: Array) -> Array:
    return unit_vectors(np.cross(np.gradient(grid, axis=0), np.gradient(grid, axis=1)))


def unit_vectors(vectors: Array) -> Array:
    """Make the vectors (…, 3) of length one."""
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-30)


def _between(points: Array, edges: NDArray[np.intp], share: Array) -> Array:
    return points[edges[:, 0]] + share[:, None] * (points[edges[:, 1]] - points[edges[:, 0]])


def _trim(
    cells: NDArray[np.intp], within: Flags, n: int
) -> tuple[NDArray[np.intp], NDArray[np.intp], NDArray[np.intp]]:
    """Cut the cells that an outline crosses.

    Returns
    -------
    polygons : (n_cells, 6) array
        Corners and crossings counter-clockwise, the last repeated. Crossings are numbered from `n`.
    rim : (n_segments, 2) array
        Crossings at both ends of each piece of outline, the sheet on its left.
    edges : (n_crossings, 2) array
        Grid points inside and outside.
    """
    crossings: dict[tuple[int, int], int] = {}
    polygons, rim = [], []
    for cell in cells.tolist():
        polygon: list[int] = []
        leaving = None
        # Start at a corner inside whose predecessor is outside, so that each way out is followed by the way in.
        first = next(k for k in range(4) if within[cell[k]] and not within[cell[k - 1]])
        for k in range(first, first + 4):
            a, b = cell[k % 4], cell[(k + 1) % 4]
            if within[a]:
                polygon.append(a)
            if within[a] != within[b]:
                crossing = n + crossings.setdefault((a, b) if within[a] else (b, a), len(crossings))
                polygon.append(crossing)
                if within[a]:
                    leaving = crossing
                else:
                    rim.append((leaving, crossing))
        polygons.append((polygon + 6 * polygon[-1:])[:6])
    return (
        np.array(polygons, dtype=np.intp).reshape(-1, 6),
        np.array(rim, dtype=np.intp).reshape(-1, 2),
        np.array(list(crossings), dtype=np.intp).reshape(-1, 2),
    )
