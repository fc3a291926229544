"""Vibration of thin beams and plates in closed form, which the lattice's modes tend to as its pitch shrinks. SI."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.theory.rigid import require_positive

CANTILEVER_ROOTS = (1.875104068711961, 4.694091132974174, 7.854757438237613)
"""First three roots βL of cos βL cosh βL = -1."""


def cantilever_frequencies(flexural_rigidity: float, mass_per_length: float, length: float) -> Array:
    """First three natural angular frequencies of an Euler-Bernoulli cantilever, ω = (βL)² √(EI / (m' L⁴)).

    Parameters
    ----------
    flexural_rigidity : float
        EI, N·m², above 0.
    mass_per_length : float
        m', kg/m, above 0.
    length : float
        L, m, above 0.

    Returns
    -------
    (3,) array
        rad/s.

    Raises
    ------
    InputError
        An argument not above 0.
    """
    require_positive(flexural_rigidity=flexural_rigidity, mass_per_length=mass_per_length, length=length)
    return np.array(CANTILEVER_ROOTS) ** 2 * np.sqrt(flexural_rigidity / (mass_per_length * length**4))


def free_disk_parameter(diameters: int, circles: int, poisson: float = 0.0) -> float:
    """Frequency parameter λ² = ω R² √(σ / D) of a free circular Kirchhoff plate.

    The deflection (A J_n(λr/R) + C I_n(λr/R)) cos nφ must carry neither bending moment nor Kelvin-Kirchhoff shear at
    the edge (A. W. Leissa, Vibration of Plates, 1969, chapter 2); λ is the root that this leaves.

    Parameters
    ----------
    diameters, circles : int
        Nodal diameters n and nodal circles s, at least 0. (0, 0) and (1, 0) move the plate as a whole: no frequency.
    poisson : float
        Poisson's ratio ν, above -1 and at most 0.5. The lattice has 0, and is isotropic where k_t = k_b.

    Returns
    -------
    float

    Raises
    ------
    InputError
        A negative count, a rigid motion, or a ratio out of range.
    """
    from scipy.optimize import root_scalar

    if diameters < 0 or circles < 0 or (diameters < 2 and circles == 0):
        raise InputError("(diameters, circles)", (diameters, circles), "a mode that bends the plate", "(2, 0)")
    if not -1 < poisson <= 0.5:
        raise InputError("poisson", poisson, "above -1 and at most 0.5", "0.0")

    # Roots lie about π apart and the first above λ = n/2; the root 0 of a rigid motion is left out.
    which = circles if diameters > 1 else circles - 1
    grid = np.arange(max(0.5, diameters / 2), 2 * diameters + np.pi * (which + 3), 0.1)
    value = _free_edge(grid, diameters, poisson)
    low = grid[:-1][value[:-1] * value[1:] < 0][which]
    return float(root_scalar(_free_edge, args=(diameters, poisson), bracket=(low, low + 0.1)).root) ** 2


def free_disk_frequency(
    diameters: int,
    circles: int,
    *,
    radius: float,
    plate_stiffness: float,
    mass_per_area: float,
    poisson: float = 0.0,
) -> float:
    """Natural angular frequency of a free circular plate, ω = λ²/R² √(D / σ): see `free_disk_parameter`.

    Parameters
    ----------
    diameters, circles : int
        Nodal diameters n and nodal circles s: (2, 0) is the saddle, (0, 1) the dish.
    radius : float
        R, m, above 0.
    plate_stiffness : float
        D, N·m, above 0; k_b (per rad) of a lattice.
    mass_per_area : float
        σ, kg/m², above 0; node mass over pitch² of a lattice.
    poisson : float
        Poisson's ratio ν.

    Returns
    -------
    float
        rad/s.

    Raises
    ------
    InputError
        A length, stiffness or mass not above 0, or what `free_disk_parameter` refuses.
    """
    require_positive(radius=radius, plate_stiffness=plate_stiffness, mass_per_area=mass_per_area)
    scale = np.sqrt(plate_stiffness / mass_per_area) / radius**2
    return float(free_disk_parameter(diameters, circles, poisson) * scale)


def _free_edge(root: ArrayLike, n: int, poisson: float) -> Array:
    """Determinant of moment and shear at the edge r = 1 for J_n(λr) and I_n(λr), at λ = `root`."""
    from scipy.special import ive, jv, jvp

    square, stiff = np.square(root), (1 - poisson) * n**2
    j, j_slope = jv(n, root), root * jvp(n, root)
    i = ive(n, root)  # I_n e^-λ: no overflow, same roots
    i_slope = root * ive(n + 1, root) + n * i
    j_moment, i_moment = (
        sign * square * value + stiff * value - (1 - poisson) * slope
        for sign, value, slope in ((-1, j, j_slope), (1, i, i_slope))
    )
    j_shear, i_shear = (
        sign * square * slope - stiff * (slope - value) for sign, value, slope in ((-1, j, j_slope), (1, i, i_slope))
    )
    return j_moment * i_shear - i_moment * j_shear
