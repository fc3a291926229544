"""What else was read of the object beside its spin rate: bending, drift, contact, each with how well it is known."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.simulation.registry import Observable, find_observable

READABLE = ("bending_amplitude", "rim_lift", "contact_fraction", "flight_fraction", "drift")
"""Observables that tell something of the object: how large they are, not which way."""


@dataclass(frozen=True, eq=False)
class Readings:
    """Readings of one observable.

    Attributes
    ----------
    name : str
        Of the observable (`plategait.simulation.registry`).
    which : (m,) int array
        Condition of each.
    value, sd : (m,) arrays
        SI.
    """

    name: str
    which: NDArray[np.int64]
    value: Array
    sd: Array

    @property
    def observable(self) -> Observable:
        """What was read."""
        return find_observable(self.name)

    @property
    def relative(self) -> float:
        """Median standard deviation over the value: how well the next one will be read."""
        return float(np.median(self.sd / np.maximum(np.abs(self.value), 1e-300)))


def is_read(curve: Curve, i: int) -> bool:
    """Whether a curve's point has a reading that can be compared."""
    return any(np.isfinite(value[i] + sd[i]) for _, value, sd in _columns(curve))


def gather(points: Iterable[tuple[Curve, int, int]]) -> tuple[Readings, ...]:
    """Readings of points, each a curve, the place in it, and the number of its condition."""
    found: dict[str, list[tuple[int, float, float]]] = {}
    for curve, i, condition in points:
        for name, value, sd in _columns(curve):
            if np.isfinite(value[i] + sd[i]):
                found.setdefault(name, []).append((condition, float(value[i]), float(sd[i])))
    return tuple(
        Readings(name, *(np.array(column) for column in zip(*found[name], strict=True)))
        for name in READABLE
        if name in found
    )


def unused(curves: Sequence[Curve]) -> str:
    """Note of the observables in the curves that cannot be compared for want of their spread; empty where none is."""
    names = dict.fromkeys(n for c in curves for n in READABLE if n in c.values and n not in c.value_sds)
    if not names:
        return ""
    listed = ", ".join(find_observable(name).heading for name in names)
    return f"not used: {listed}; a column {find_observable(next(iter(names))).sd_heading} says how well it is known"


def _columns(curve: Curve) -> Iterator[tuple[str, Array, Array]]:
    """Name, values and spreads of each observable that comes with both."""
    for name in READABLE:
        if name in curve.values and name in curve.value_sds:
            yield name, curve.values[name], curve.value_sds[name]
