"""Free-vibration modes of a sheet: no plate, no gravity, small motion out of its plane."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.errors import InputError
from plategait.lattice import Lattice

# A lattice of 1,500 nodes takes a dense solver about a second.
LARGEST_DENSE_LATTICE = 3000


@dataclass(frozen=True)
class Mode:
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
    shape: NDArray[np.float64]
    name: str

    @property
    def frequency(self) -> float:
        """Natural frequency, Hz."""
        return self.omega / (2 * math.pi)


@dataclass(frozen=True)
class Modes:
    """Modes in order of frequency, the three rigid ones left out."""

    modes: tuple[Mode, ...]

    def _named(self, name: str) -> Mode:
        for mode in self.modes:
            if mode.name == name:
                return mode
        raise InputError(
            "modes",
            "nothing of that shape",
            f"a sheet that has a {name} mode",
            "a sheet at least 3 nodes across both ways",
        )

    @property
    def dish(self) -> Mode:
        """The mode in which the sheet bends up and down, the dissertation's ω_n."""
        return self._named("dish")

    @property
    def saddle(self) -> Mode:
        """Bent up along one axis of the grid and down along the other."""
        return self._named("saddle")

    @property
    def twist(self) -> Mode:
        """Twisted; no stiffness at all while torsion is free."""
        return self._named("twist")


def bending_operator(lattice: Lattice) -> NDArray[np.float64]:
    """(n_bends, n_nodes) small angle of each bending joint, times the pitch, per deflection."""
    operator = np.zeros((len(lattice.bends), lattice.n_nodes))
    rows = np.arange(len(lattice.bends))
    for column, weight in zip(lattice.bends.T, (1.0, -2.0, 1.0), strict=True):
        np.add.at(operator, (rows, column), weight)
    return operator


def twist_operator(lattice: Lattice) -> NDArray[np.float64]:
    """(n_cells, n_nodes) twist of each cell, times the pitch, per deflection."""
    operator = np.zeros((len(lattice.cells), lattice.n_nodes))
    rows = np.arange(len(lattice.cells))
    for column, weight in zip(lattice.cells.T, (1.0, -1.0, -1.0, 1.0), strict=True):
        np.add.at(operator, (rows, column), weight)
    return operator


def transverse_matrix(lattice: Lattice, pitch: float, bending: float, torsion: float) -> NDArray[np.float64]:
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
    squared, shapes = np.linalg.eigh(stiffness)
    shapes = _without_rigid_motion(lattice, squared, shapes)
    omega = np.sqrt(np.einsum("im,ij,jm->m", shapes, stiffness, shapes, optimize=True).clip(0))
    rates = np.einsum("im,ij,jm->m", shapes, damping, shapes, optimize=True)
    order = np.argsort(omega, kind="stable")
    names = _names(lattice, shapes[:, order])
    modes = []
    for i, m in enumerate(order):
        shape = shapes[:, m] / shapes[np.argmax(np.abs(shapes[:, m])), m]
        # A mode without stiffness has no ratio to speak of.
        ratio = float(rates[m] / (2 * omega[m])) if omega[m] > 1e-6 * omega.max() else 0.0
        modes.append(Mode(float(omega[m]), ratio, shape, names.get(i, "")))
    return Modes(tuple(modes))


def _without_rigid_motion(
    lattice: Lattice, squared: NDArray[np.float64], shapes: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Take heave, roll and pitch out of the modes of zero frequency; free torsion adds the twist to them."""
    x, y = lattice.rest.T
    floppy = squared <= 1e-9 * squared[-1]
    rigid, _ = np.linalg.qr(np.stack([np.ones(len(x)), x, y], axis=1))
    loose = shapes[:, floppy] - rigid @ (rigid.T @ shapes[:, floppy])
    vectors, sizes, _ = np.linalg.svd(loose, full_matrices=False)
    return np.concatenate([vectors[:, sizes > 1e-6], shapes[:, ~floppy]], axis=1)


def _names(lattice: Lattice, shapes: NDArray[np.float64]) -> dict[int, str]:
    """Name the modes by their likeness to x² − y², xy and x² + y² (less its mean)."""
    x, y = lattice.rest.T
    names: dict[int, str] = {}
    for name, ideal in (("saddle", x**2 - y**2), ("twist", x * y), ("dish", x**2 + y**2)):
        if np.ptp(x) == 0 or np.ptp(y) == 0:
            continue
        ideal = ideal - ideal.mean()
        likeness = np.abs(ideal @ shapes) / (np.linalg.norm(ideal) + 1e-300)
        # The lowest mode that is mostly of that shape; a sheet longer than wide mixes saddle and dish.
        alike = [int(i) for i in np.nonzero(likeness > 0.6)[0] if int(i) not in names]
        if alike:
            names[alike[0]] = name
        elif likeness.size and likeness.max() > 0.3 and int(np.argmax(likeness)) not in names:
            names[int(np.argmax(likeness))] = name
    return names
