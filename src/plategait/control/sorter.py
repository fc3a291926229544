"""A sorter: classes of stiffness told from the rates at which a sheet spins under a few motions, or "cannot tell"."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.control.camera import PERFECT
from plategait.control.plant import Plant
from plategait.control.room import on_a_plate
from plategait.control.spinning import MOTIONS, Spins, plate_motion
from plategait.errors import InputError
from plategait.estimate.emulator import RateEmulator, fit_rates
from plategait.estimate.likelihood import Likelihood
from plategait.estimate.observations import Condition, Observations
from plategait.estimate.particles import stratified
from plategait.estimate.unknowns import (
    BENDING_DAMPING,
    FRICTION_ANGLE,
    FRICTION_RATIO,
    MASS,
    NATURAL_FREQUENCY,
    Unknown,
    Unknowns,
)
from plategait.model.machine import Machine
from plategait.model.motion import PlateMotion
from plategait.model.presets import Preset
from plategait.model.scenario import Scenario

STEPS = 1.4
"""Between the stiffnesses of neighbouring classes."""
SURE = 0.9
"""Probability from which a class is told."""
SETS, _SAMPLES = 192, 2048
"""Sheets that the sorter learns from."""
# Where sheets are laid down, sd, m; distance from the bar that counts as one unknown's range.
_LAID, _ACROSS = 5e-3, 0.03


@dataclass(frozen=True)
class Variation:
    """How sheets of one stiffness differ: factors to either side of the nominal sheet.

    Parameters
    ----------
    friction, friction_ratio, mass, damping : float
        Of μ_s, μ_k/μ_s, the mass and c_b.
    """

    friction: float = 1.15
    friction_ratio: float = 1.08
    mass: float = 1.05
    damping: float = 1.25


@dataclass(frozen=True, eq=False)
class Verdict:
    """What the rates of a sheet tell.

    Attributes
    ----------
    shares : (k,) array
        Probability of each class, the softest first.
    stiffness, low, high : float
        Median and 90 % interval of the bending stiffness over the nominal sheet's.
    """

    shares: Array
    stiffness: float
    low: float
    high: float

    def kind(self, sure: float = SURE) -> int | None:
        """Class, or None where none is as sure as that."""
        best = int(self.shares.argmax())
        return best if self.shares[best] >= sure else None


@dataclass(frozen=True, eq=False)
class Sorter:
    """Tells classes of stiffness: the estimator's likelihood over samples of the prior, its emulators learnt once.

    A full estimate runs the engine anew for each object, and takes 15 s; sheets of a known sort under motions that are
    always the same need no more runs, and a verdict takes a tenth of a second.

    Attributes
    ----------
    base : Scenario
        The nominal sheet on its plate.
    motions : tuple of Condition
    edges : (k - 1,) array
        Between the classes, of the bending stiffness over the nominal sheet's.
    emulators : tuple of RateEmulator
        Of each motion, over the unknowns and the distance from the bar.
    u, stiffness : (n, d) and (n,) arrays
        Samples of the prior, and the bending stiffness of each over the nominal sheet's.
    """

    base: Scenario
    motions: tuple[Condition, ...]
    edges: Array
    emulators: tuple[RateEmulator, ...]
    u: Array
    stiffness: Array

    @property
    def plate_motions(self) -> tuple[PlateMotion, ...]:
        """The motions as the plate is told them."""
        return tuple(plate_motion(condition, self.base) for condition in self.motions)

    def judge(self, rates: Array, sd: Array, places: Array) -> Verdict:
        """Tell a sheet's class.

        Parameters
        ----------
        rates, sd, places : (c,) arrays
            Of one sheet, as `Spins` has them; NaN where it was not spun.
        """
        if not (len(rates) == len(sd) == len(places) == len(self.motions)):
            raise InputError("rates", f"{len(rates)} of them", f"one for each of {len(self.motions)} motions", "NaN")
        log = np.zeros(len(self.u))
        spun = np.flatnonzero(np.isfinite(rates))
        if len(spun):
            log = self._likelihood(rates[spun], sd[spun], places[spun], spun)(self.u)
        weight = np.exp(log - log.max())
        weight /= weight.sum()
        order = np.argsort(self.stiffness)
        low, median, high = np.interp((0.05, 0.5, 0.95), np.cumsum(weight[order]), self.stiffness[order])
        kinds = np.searchsorted(self.edges, self.stiffness)
        shares = np.array([weight[kinds == kind].sum() for kind in range(len(self.edges) + 1)])
        return Verdict(shares, float(median), float(low), float(high))

    def _likelihood(self, rates: Array, sd: Array, places: Array, spun: NDArray[np.int64]) -> Likelihood:
        """Of what was seen of one sheet, where it lay known."""
        of = [self.emulators[c] for c in spun]
        splines = tuple((np.array([k]), partial(_at, of[k], place)) for k, place in enumerate(places.tolist()))
        emulated = RateEmulator(splines, np.concatenate([emulator.error for emulator in of]))
        conditions = tuple(self.motions[c] for c in spun)
        data = Observations(conditions, np.arange(len(spun)), rates, sd, np.zeros(len(spun), dtype=bool))
        return Likelihood(data, emulated, {}, None)


def _at(emulator: RateEmulator, place: float, u: Array) -> Array:
    """Rates (n, 1) at unknowns (n, d) of sheets at a place across the bar, m."""
    return emulator(_beside(u, place))


def _beside(u: Array, place: Array | float) -> Array:
    """Unknowns (n, d), and the distance from the bar beside them."""
    return np.column_stack([u, np.broadcast_to(0.5 + np.asarray(place) / _ACROSS, len(u))])


def learn_sorter(
    scenario: Scenario | Preset | Path | str = "cheese",
    machine: Machine | Path | str = "source-robot",
    *,
    classes: int = 3,
    steps: float = STEPS,
    motions: Sequence[Condition] = MOTIONS,
    variation: Variation | None = None,
    sets: int = SETS,
    seed: int = 0,
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> Sorter:
    """Learn how fast sheets of every stiffness spin under the motions, one after the other as they will be spun.

    Parameters
    ----------
    scenario : Scenario, or what tells one
        The sheet of the class in the middle.
    machine : Machine, its name or file
    classes : int
    steps : float
        Between the stiffnesses of neighbouring classes, as a factor.
    motions : sequence of Condition
    variation : Variation, optional
        In what else sheets differ.
    sets : int
        Sheets to learn from.
    seed : int
    threads : int, optional
    progress : callable, optional
        Called with the fraction done.

    Raises
    ------
    InputError
        For fewer than two classes, classes of one stiffness, or motions under which sheets run off.
    """
    if classes < 2:
        raise InputError("classes", classes, "2 or more", "3")
    if not 1.0 < steps <= 10:
        raise InputError("steps", steps, "above 1, up to 10", "1.4")
    base = on_a_plate(scenario)
    sought = Unknowns(base, _priors(base, classes, steps, variation or Variation()))
    generator, d = np.random.default_rng(seed), 5
    u = stratified(sets, d, generator)
    laid = np.column_stack([_LAID * generator.standard_normal((sets, 2)), generator.uniform(-math.pi, math.pi, sets)])
    sheets = [
        sought.scenario(values).replace(**dict(zip(("start.x", "start.y", "start.angle"), at.tolist(), strict=True)))
        for values, at in zip(sought.values(u), laid, strict=True)
    ]
    plant, spins = Plant(sheets, machine=machine, camera=PERFECT, threads=threads), Spins.none(sets, len(motions))
    for c, condition in enumerate(motions):
        spins.read(c, plant, plate_motion(condition, base), ~plant.failed)
        if progress is not None:
            progress((c + 1) / len(motions))
    emulators = []
    for c, condition in enumerate(motions):
        emulator = fit_rates(_beside(u, spins.places[:, c]), spins.rates[:, c : c + 1], np.ones(sets, dtype=bool))
        if not np.isfinite(emulator.error).all():
            raise InputError("motions", f"{condition.frequency:g} Hz, {condition.text}, under which sheets run off",
                             "motions under which they spin and stay", "smaller amplitudes")  # fmt: skip
        emulators.append(emulator)
    edges = np.asarray(steps ** (np.arange(1, classes) - classes / 2), dtype=float)
    samples = stratified(_SAMPLES, d, generator)
    omega, _, _, mass, _ = sought.values(samples).T
    stiffness = (omega / base.sheet.natural_frequency) ** 2 * mass
    return Sorter(base, tuple(motions), edges, tuple(emulators), samples, stiffness)


def _priors(base: Scenario, classes: int, steps: float, variation: Variation) -> tuple[Unknown, ...]:
    """Priors even over the classes and half a class beyond, and over what else differs."""
    omega, static = base.sheet.natural_frequency, base.friction.static
    ratio, reach = base.friction.kinetic / static, steps ** ((classes + 1) / 4)
    return (
        replace(NATURAL_FREQUENCY, low=omega / reach, high=omega * reach),
        replace(FRICTION_ANGLE, low=math.atan(static / variation.friction),
                high=math.atan(static * variation.friction)),
        replace(FRICTION_RATIO, low=ratio / variation.friction_ratio,
                high=min(1.0, ratio * variation.friction_ratio)),
        replace(MASS, low=1 / variation.mass, high=variation.mass),
        replace(BENDING_DAMPING, low=1 / variation.damping, high=variation.damping),
    )  # fmt: skip
