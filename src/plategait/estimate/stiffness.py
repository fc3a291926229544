"""Stiffness of the object in the units of its material: k_b, the plate stiffness D and Young's modulus."""

from __future__ import annotations

import math

import numpy as np

from plategait.arrays import Array
from plategait.estimate.identifiability import Marginal
from plategait.estimate.unknowns import NATURAL_FREQUENCY, Unknown, Unknowns
from plategait.units import Quantity

BENDING_STIFFNESS = Unknown(
    name="bending_stiffness", low=0.0, high=math.inf, quantity=Quantity("N*m/rad", "N*mm/deg", "2.72e-3 N*mm/deg")
)
"""k_b, of a joint as long as the pitch is wide."""
PLATE_STIFFNESS = Unknown(name="plate_stiffness", low=0.0, high=math.inf, quantity=Quantity("N*m", "mN*m", "0.16 mN*m"))
"""D, moment per width over curvature: the lattice's is k_b, whatever the pitch."""
YOUNGS_MODULUS = Unknown(name="youngs_modulus", low=0.0, high=math.inf, quantity=Quantity("Pa", "kPa", "120 kPa"))
"""E = 12 D / d³: a plate of Poisson ratio zero, as the lattice is one."""


def bending_stiffness(unknowns: Unknowns, values: Array) -> Array:
    """k_b (n,) of samples (n, d) of the unknowns, N·m/rad; with the natural frequency among these."""
    names = unknowns.names
    omega = values[:, names.index(NATURAL_FREQUENCY.name)]
    mass = values[:, names.index("mass")] if "mass" in names else np.ones(len(values))
    first = unknowns.scenario(values[0]).sheet.bending_stiffness
    return first * (omega / omega[0]) ** 2 * mass / mass[0]


def stiffness_of(
    unknowns: Unknowns, values: Array, omega: Marginal, confidence: float, thickness_sd: float = 0.0
) -> tuple[Marginal, ...]:
    """k_b, D and E with their intervals; determined as far as the natural frequency is.

    Parameters
    ----------
    unknowns : Unknowns
        Whose scenario tells the thickness d.
    values : (n, d) array
        Samples of the posterior, SI.
    omega : Marginal
        Of the natural frequency.
    confidence : float
        Of the intervals.
    thickness_sd : float
        How well the thickness is known, m.
    """
    k_b = bending_stiffness(unknowns, values)
    thickness = unknowns.base.sheet.thickness
    normal = np.random.default_rng(0).normal(size=len(k_b))
    drawn = thickness * np.exp(normal * thickness_sd / thickness)
    samples = ((BENDING_STIFFNESS, k_b), (PLATE_STIFFNESS, k_b), (YOUNGS_MODULUS, 12 * k_b / drawn**3))
    return tuple(_marginal(parameter, x, omega, confidence) for parameter, x in samples)


def _marginal(parameter: Unknown, x: Array, omega: Marginal, confidence: float) -> Marginal:
    """Marginal of what follows from the natural frequency, open where that is."""
    tail = (1 - confidence) / 2
    low, median, high = (float(q) for q in np.quantile(x, [tail, 0.5, 1 - tail]))
    if omega.verdict == "at most":
        high = float(np.quantile(x, confidence))
    if omega.verdict == "at least":
        low = float(np.quantile(x, 1 - confidence))
    return Marginal(parameter, omega.verdict, median, float(np.std(x)), low, high, omega.contraction)
