"""The lattice: mass nodes on a square grid, cut to an outline, and how they are joined (section 3.2.2)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

AXIAL_DIRECTIONS = ((1, 0), (0, 1))
DIAGONAL_DIRECTIONS = ((1, 1), (1, -1))


@dataclass(frozen=True, eq=False)
class Lattice:
    """Topology of a sheet, in units of the pitch.

    Parameters
    ----------
    occupied : (columns, rows) bool array
        Grid squares that carry a node; column along x, row along y.
    held : (n_nodes,) bool array, optional
        Nodes clamped where they are (cantilevers and other closed forms).
    """

    occupied: NDArray[np.bool_]
    held: NDArray[np.bool_] | None = None

    @cached_property
    def squares(self) -> NDArray[np.intp]:
        """(n_nodes, 2) column and row of each node, row by row."""
        rows, columns = np.nonzero(self.occupied.T)
        return np.stack([columns, rows], axis=1)

    @property
    def n_nodes(self) -> int:
        """Number of mass nodes."""
        return len(self.squares)

    @cached_property
    def number(self) -> NDArray[np.int32]:
        """(columns, rows) node number of each square, -1 where there is none."""
        number = np.full(self.occupied.shape, -1, dtype=np.int32)
        number[self.squares[:, 0], self.squares[:, 1]] = np.arange(self.n_nodes)
        return number

    @cached_property
    def rest(self) -> NDArray[np.float64]:
        """(n_nodes, 2) rest positions about the centroid, in pitches."""
        squares = self.squares.astype(float)
        return squares - squares.mean(axis=0)

    def _chains(self, direction: tuple[int, int]) -> list[list[int]]:
        """Maximal straight chains of at least two neighbouring nodes along a grid direction."""
        number, (di, dj) = self.number, direction
        columns, rows = number.shape

        def node_at(i: int, j: int) -> int:
            return int(number[i, j]) if 0 <= i < columns and 0 <= j < rows else -1

        chains = []
        for i, j in self.squares.tolist():
            if node_at(i - di, j - dj) >= 0:
                continue
            chain = []
            while (node := node_at(i, j)) >= 0:
                chain.append(node)
                i, j = i + di, j + dj
            if len(chain) > 1:
                chains.append(chain)
        return chains

    @cached_property
    def axial_lines(self) -> list[list[int]]:
        """Chains along the grid: they stretch and bend."""
        return [chain for direction in AXIAL_DIRECTIONS for chain in self._chains(direction)]

    @cached_property
    def diagonal_lines(self) -> list[list[int]]:
        """Chains along the diagonals: they carry the in-plane shear."""
        return [chain for direction in DIAGONAL_DIRECTIONS for chain in self._chains(direction)]

    @cached_property
    def axial_edges(self) -> NDArray[np.int32]:
        """(n, 2) neighbours along the grid."""
        return _edges(self.axial_lines)

    @cached_property
    def diagonal_edges(self) -> NDArray[np.int32]:
        """(n, 2) neighbours along the diagonals."""
        return _edges(self.diagonal_lines)

    @cached_property
    def bends(self) -> NDArray[np.int32]:
        """(n, 3) successive nodes along the grid: each has a bending joint at its middle."""
        triples = [line[i : i + 3] for line in self.axial_lines for i in range(len(line) - 2)]
        return np.array(triples, dtype=np.int32).reshape(-1, 3)

    @cached_property
    def cells(self) -> NDArray[np.int32]:
        """(n, 4) nodes at the corners 00, 10, 01, 11 of each full square of four."""
        n = self.number
        corners = np.stack([n[:-1, :-1], n[1:, :-1], n[:-1, 1:], n[1:, 1:]], axis=-1).reshape(-1, 4)
        return np.ascontiguousarray(corners[(corners >= 0).all(axis=1)])

    @cached_property
    def mobility(self) -> NDArray[np.float64]:
        """(n_nodes,) 1 where a node is free, 0 where it is held."""
        return np.ones(self.n_nodes) if self.held is None else (~self.held).astype(float)

    @cached_property
    def key(self) -> bytes:
        """Equal for lattices whose runs can share a batch."""
        return repr(self.occupied.shape).encode() + self.occupied.tobytes() + self.mobility.tobytes()


def _edges(lines: list[list[int]]) -> NDArray[np.int32]:
    pairs = [line[i : i + 2] for line in lines for i in range(len(line) - 1)]
    return np.array(pairs, dtype=np.int32).reshape(-1, 2)
