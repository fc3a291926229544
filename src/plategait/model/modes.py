"""Free-vibration modes of a sheet: no plate, no gravity, small motion out of its plane."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.model.lattice import Lattice
from plategait.shown import Shown

# A lattice of 1,500 nodes takes a dense solver about a second.
LARGEST_DENSE_LATTICE = 3000

_ROUNDING = 1e-12  # of the largest ω²: what differs by less is one frequency, and what is less is none
_FLAT = 1e-9  # share of a shape that is rounding once the rigid motion is taken out of it
_ALIKE = 6  # decimals in which two shares, or two nodes, are alike
_MOSTLY, _PARTLY = 0.6, 0.3  # share of a shape at which a space is mostly that shape, and below which it is not it


@dataclass(frozen=True, repr=False)
class Mode(Shown):
    """One free-vibration mode.

    Attributes
    ----------
    omega : float
        Natural angular frequency, rad/s.
    damping_ratio : float
        Of the joints' Kelvin–Voigt damping, 1 is critical.
    shape : (n_nodes,) array
        Deflection out of the plane, largest 1.
    name : str
        "saddle" (x² − y²), "twist" (xy), "dish" (x² + y²), or "" for anything else.
    """

    omega: float
    damping_ratio: float
    shape: Array
    name: str

    def told(self) -> list[tuple[str, str]]:
        """Its shape, frequency and damping."""
        return [("shape", self.name or "no name"), ("frequency", self._in_words)]

    @property
    def _in_words(self) -> str:
        return f"{self.frequency:.4g} Hz ({self.omega / math.pi:.4g} π rad/s), damping ratio {self.damping_ratio:.3g}"

    @property
    def frequency(self) -> float:
        """Natural frequency, Hz."""
        return self.omega / (2 * math.pi)


@dataclass(frozen=True, repr=False)
class Modes(Shown):
    """Modes in order of frequency, the rigid ones left out."""

    modes: tuple[Mode, ...]

    def told(self) -> list[tuple[str, str]]:
        """The lowest modes that bend the sheet, and how many have no stiffness."""
        stiff = [mode for mode in self.modes if mode.omega > 0]
        rows = [(mode.name or "–", mode._in_words) for mode in stiff[:7]]
        return [("modes", f"{len(self.modes)}, {len(self.modes) - len(stiff)} of them without stiffness"), *rows]

    def _named(self, name: str) -> Mode:
        for mode in self.modes:
            if mode.name == name:
                return mode
        raise InputError(
            "modes",
            "nothing of that shape",
            f"a sheet that has a {name} mode",
            "a sheet about as long as wide, 3 nodes or more across both ways",
        )

    @property
    def dish(self) -> Mode:
        """The mode in which the sheet bends up and down alike along both axes."""
        return self._named("dish")

    @property
    def saddle(self) -> Mode:
        """Bent up along one axis of the grid and down along the other."""
        return self._named("saddle")

    @property
    def twist(self) -> Mode:
        """Twisted; no stiffness at all while torsion is free."""
        return self._named("twist")

    @property
    def natural(self) -> Mode:
        """The mode of the dissertation's ω_n: the dish, or where no mode is one the lowest that bends the sheet."""
        for mode in self.modes:
            if mode.name == "dish":
                return mode
        for mode in self.modes:
            if mode.omega > 0 and mode.name != "twist":
                return mode
        raise InputError(
            "modes", "none that bends the sheet", "a bending stiffness above 0, and 3 nodes or more in a row",
            "a finer pitch",
        )  # fmt: skip


def bending_operator(lattice: Lattice) -> Array:
    """(n_bends, n_nodes) small angle of each bending joint, times the pitch, per deflection."""
    operator = np.zeros((len(lattice.bends), lattice.n_nodes))
    rows = np.arange(len(lattice.bends))
    for column, weight in zip(lattice.bends.T, (1.0, -2.0, 1.0), strict=True):
        np.add.at(operator, (rows, column), weight)
    return operator


def twist_operator(lattice: Lattice) -> Array:
    """(n_cells, n_nodes) twist of each cell, times the pitch, per deflection."""
    operator = np.zeros((len(lattice.cells), lattice.n_nodes))
    rows = np.arange(len(lattice.cells))
    for column, weight in zip(lattice.cells.T, (1.0, -1.0, -1.0, 1.0), strict=True):
        np.add.at(operator, (rows, column), weight)
    return operator


def transverse_matrix(lattice: Lattice, pitch: float, bending: float, torsion: float) -> Array:
    """(n_nodes, n_nodes) matrix of the nodes' deflections, from the joints' bending and torsion constants.

    With k_b and k_t it is the stiffness matrix (N/m), with c_b and c_t the damping matrix (N s/m).
    """
    bend, twist = bending_operator(lattice), twist_operator(lattice)
    return (bending * bend.T @ bend + 2 * torsion * twist.T @ twist) / pitch**2


def free_modes(
    lattice: Lattice, pitch: float, node_mass: float, k_b: float, c_b: float, k_t: float, c_t: float
) -> Modes:
    """Free-vibration modes of a sheet, out of its plane; `Sheet.free_modes` calls it with the sheet's numbers.

    Parameters
    ----------
    pitch, node_mass : float
        m and kg.
    k_b, c_b, k_t, c_t : float
        Bending and torsion joints, N m/rad and N m s/rad.

    Raises
    ------
    InputError
        For a lattice too large for a dense solver.
    """
    n = lattice.n_nodes
    if n > LARGEST_DENSE_LATTICE:
        raise InputError("sheet.pitch", f"{n} nodes", f"coarse enough for at most {LARGEST_DENSE_LATTICE} nodes here",
                         f'"{1e3 * pitch * math.sqrt(n / LARGEST_DENSE_LATTICE) * 1.05:.3g} mm"')  # fmt: skip
    stiffness = transverse_matrix(lattice, pitch, k_b, k_t) / node_mass
    damping = transverse_matrix(lattice, pitch, c_b, c_t) / node_mass
    rigid = _rigid_motion(lattice)
    flexible = np.linalg.qr(rigid, mode="complete")[0][:, rigid.shape[1] :]
    squared, vectors = np.linalg.eigh(flexible.T @ stiffness @ flexible)
    spaces = _eigenspaces(squared, flexible @ vectors)
    named = _named_directions(lattice, rigid, [basis for _, basis in spaces])
    omegas, names, shapes = [], [], [np.empty((n, 0))]
    for i, (omega_squared, basis) in enumerate(spaces):
        own = {name: direction for name, (space, direction) in named.items() if space == i}
        shapes.append(_settled(basis, list(own.values())))
        names += [*own, *[""] * (basis.shape[1] - len(own))]
        omegas += [math.sqrt(omega_squared)] * basis.shape[1]
    vectors = np.concatenate(shapes, axis=1)
    rates = np.sum(vectors * (damping @ vectors), axis=0)
    return Modes(
        tuple(
            # A mode without stiffness has no ratio to speak of.
            Mode(omega, float(rate) / (2 * omega) if omega > 0 else 0.0, _upwards(vector), name)
            for omega, rate, vector, name in zip(omegas, rates, vectors.T, names, strict=True)
        )
    )


def _rigid_motion(lattice: Lattice) -> Array:
    """(n_nodes, 1 to 3) heave, and roll and pitch of a sheet that is wide enough to have them."""
    return np.stack([np.ones(lattice.n_nodes), *(c for c in lattice.rest.T if np.ptp(c) > 0)], axis=1)


def _eigenspaces(squared: Array, vectors: Array) -> list[tuple[float, Array]]:
    """ω² and an orthonormal basis (n_nodes, m) of each frequency, rising.

    Modes of one frequency, of which symmetric sheets and free torsion have many, are a solver's arbitrary choice; the
    space that they span is the sheet's own.
    """
    if not len(squared):
        return []
    rounding = _ROUNDING * float(np.abs(squared).max())
    parts = np.split(np.arange(len(squared)), np.flatnonzero(np.diff(squared) > rounding) + 1)
    means = [float(squared[part].mean()) for part in parts]
    return [(mean if mean > rounding else 0.0, vectors[:, part]) for mean, part in zip(means, parts, strict=True)]


def _named_directions(lattice: Lattice, rigid: Array, spaces: list[Array]) -> dict[str, tuple[int, Array]]:
    """Space and unit direction (n_nodes,) in it of x² + y², x² − y² and xy, as far as the sheet has such modes.

    A shape is projected onto every space. It belongs to the lowest that holds most of it, or else to the one that holds
    the largest share, unless that direction has a name already: the surest name goes first.
    """
    x, y = lattice.rest.T
    ideals = {}
    for name, ideal in (("dish", x**2 + y**2), ("saddle", x**2 - y**2), ("twist", x * y)):
        bent = ideal - rigid @ np.linalg.lstsq(rigid, ideal, rcond=None)[0]
        size = float(np.linalg.norm(bent))
        # A strip has neither, nor a sheet of 2 × 2 nodes a saddle.
        if spaces and np.ptp(x) > 0 and np.ptp(y) > 0 and size > _FLAT * np.linalg.norm(ideal):
            ideals[name] = bent / size
    held = {
        name: np.array([np.linalg.norm(basis.T @ ideal) for basis in spaces], dtype=np.float64)
        for name, ideal in ideals.items()
    }
    best: dict[str, tuple[int, Array]] = {}
    for name in sorted(held, key=lambda name: -round(float(held[name].max()), _ALIKE)):
        left = [basis @ (basis.T @ ideals[name]) for basis in spaces]
        for space, direction in best.values():
            left[space] = left[space] - direction * (direction @ left[space])
        sizes = np.linalg.norm(left, axis=1)
        mostly = np.flatnonzero(sizes > _MOSTLY)
        space = int(mostly[0]) if len(mostly) else _first_largest(held[name])
        if sizes[space] > _PARTLY:
            best[name] = space, left[space] / sizes[space]
    return best


def _settled(basis: Array, directions: list[Array]) -> Array:
    """Orthonormal basis (n_nodes, m) of the same space that begins with `directions`; the rest is the sheet's own too.

    Of what is left, each vector is the one that moves one node most; weights in a geometric progression keep the nodes
    of a symmetric sheet from being alike.
    """
    first = np.array(directions).reshape(len(directions), len(basis)).T
    size = basis.shape[1] - len(directions)
    if size == 0:
        return first
    rest = basis @ np.linalg.qr(basis.T @ first, mode="complete")[0][:, len(directions) :] if len(directions) else basis
    if size > 1:
        from scipy.linalg import qr

        weight = np.exp(-np.linspace(0, 1, len(basis)))
        rest = rest @ qr((weight[:, None] * rest).T, mode="economic", pivoting=True)[0]
    return np.concatenate([first, rest], axis=1)


def _upwards(vector: Array) -> Array:
    """Shape of largest deflection 1: the first of the nodes that move most moves up."""
    size = np.abs(vector)
    return vector / math.copysign(size.max(), vector[_first_largest(size)])


def _first_largest(values: Array) -> int:
    """Index of the largest value, the first of those that differ from it by rounding."""
    return int(np.argmax(values > (1 - 10**-_ALIKE) * values.max()))
