"""Strides as a map: a sheet seen once each plate period, its few smooth coordinates, and how twins of it part.

A stride is a fixed point of the map from one plate period to the next, the spin factored out: the sheet's coordinates
are taken in the plate's axes, where it lies and how it is turned apart from its shape. Contact and friction make the
map bend at every size, so no derivative is taken of it: twins are pushed further apart than that, and followed.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.engine.engines import engine
from plategait.engine.recording import RunRequest
from plategait.model.scenario import Scenario

State = tuple[Array, Array]
"""Positions and velocities of the nodes, each (n_nodes, 3), m and m/s, as the plate passes through its middle."""
POSE, SHAPE = slice(0, 3), slice(3, 18)
"""Coordinates that a spinning sheet leaves behind, where it lies and how it is turned; and all others."""
COORDINATES = (
    "x", "y", "angle", "x'", "y'", "angle'",
    *(f"{name}{prime}" for prime in ("", "'") for name in ("z", "z_x", "z_y", "z_xx", "z_xy", "z_yy")),
)  # fmt: skip
"""Lengths over half of the sheet's longest side r, velocities over r ω: centre, angle and their rates, and a parabola
through the heights and one through the nodes' vertical velocities, in the plate's axes about the centre."""


def stroboscopic(scenario: Scenario) -> Scenario:
    """Scenario of one plate period from the plate's middle on, in whole steps."""
    period = scenario.motion.period
    once = scenario.replace(**{"motion.ramp": 0.0, "duration": period, "transient": 0.0})
    return once.replace(time_step=period / math.ceil(period / scenario.dt))


def at_rest(scenario: Scenario) -> State:
    """State of a sheet that lies still."""
    return RunRequest(scenario).start()


def advance(scenarios: Sequence[Scenario], states: Sequence[State], periods: int = 1) -> list[State]:
    """States after so many plate periods, in double precision; NaN where a run diverged.

    Parameters
    ----------
    scenarios : sequence of Scenario
        Of `stroboscopic`.
    """
    longer = [s if periods == 1 else s.replace(duration=periods * s.motion.period) for s in scenarios]
    requests = [
        RunRequest(s, initial=state, sample_interval=s.motion.period) for s, state in zip(longer, states, strict=True)
    ]
    recordings = engine("cpu64").run(requests, threads=None, progress=None)
    return [(r.positions, r.velocities) for r in recordings]


def _units(scenario: Scenario) -> tuple[float, float]:
    radius = max(scenario.sheet.outline.size()) / 2
    return radius, radius * math.tau * scenario.motion.frequency


def _parabola(flat: Array) -> Array:
    """(n_nodes, 6) terms of a parabola at places over the radius."""
    x, y = flat.T
    return np.column_stack([np.ones_like(x), x, y, x * x, x * y, y * y])


def coordinates(scenario: Scenario, state: State) -> Array:
    """(18,) smooth coordinates of a state, `COORDINATES`."""
    (positions, velocities), (radius, speed) = state, _units(scenario)
    rest = scenario.sheet.lattice.rest[:, :2]
    rest = rest - rest.mean(axis=0)
    centre = positions.mean(axis=0)
    flat = (positions - centre)[:, :2]
    angle = math.atan2(
        float((rest[:, 0] * flat[:, 1] - rest[:, 1] * flat[:, 0]).sum()), float((rest * flat).sum())
    )  # fmt: skip
    moment = flat[:, 0] * velocities[:, 1] - flat[:, 1] * velocities[:, 0]
    spin = moment.sum() / (flat**2).sum() * radius / speed
    terms = _parabola(flat / radius)
    height, rise = (
        np.linalg.lstsq(terms, z, rcond=None)[0] for z in (positions[:, 2] / radius, velocities[:, 2] / speed)
    )
    return np.array([*(centre[:2] / radius), angle, *(velocities.mean(axis=0)[:2] / speed), spin, *height, *rise])


def pushed(scenario: Scenario, state: State, change: Array) -> State:
    """State with its coordinates changed by so much, and nothing else."""
    (positions, velocities), (radius, speed) = state, _units(scenario)
    centre = positions.mean(axis=0)
    about = positions - centre
    cos, sin = math.cos(change[2]), math.sin(change[2])
    turn = np.array([[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]])
    about, velocities = about @ turn, velocities @ turn
    terms = _parabola(about[:, :2] / radius)
    velocities = velocities + speed * np.array([change[3], change[4], 0.0])
    velocities[:, 0] -= change[5] * speed / radius * about[:, 1]
    velocities[:, 1] += change[5] * speed / radius * about[:, 0]
    velocities[:, 2] += speed * (terms @ change[12:18])
    about[:, 2] += radius * (terms @ change[6:12])
    return centre + about + radius * np.array([change[0], change[1], 0.0]), velocities


def apart(one: Array, other: Array) -> Array:
    """Differences of coordinates, the angle's in ±π."""
    difference = other - one
    difference[..., 2] = np.remainder(difference[..., 2] + math.pi, math.tau) - math.pi
    return difference


@dataclass(frozen=True, eq=False)
class Parting:
    """How the shapes of twins of a stride part, a plate period at a time.

    Attributes
    ----------
    growth, error : float
        Mean logarithm of the growth in a period, the largest Lyapunov exponent at that distance; its standard error.
    multipliers : (2,) complex array
        The two leading Floquet multipliers, the larger first: -1 leaves the unit circle where strides begin to differ
        in turn, a pair where they circle about the stride (a torus).
    """

    growth: float
    error: float
    multipliers: NDArray[np.complex128]


def leading_pair(pushes: Array, grown: Array) -> NDArray[np.complex128]:
    """Two leading multipliers of a linear map, from what it made of pushes in the direction that grows.

    Of a linear map J with two leading multipliers, J² d = a J d + b d for what their directions span: a and b by least
    squares over all periods, the multipliers the roots of μ² = a μ + b.

    Parameters
    ----------
    pushes, grown : (series, periods, m) arrays
        What twins were pushed by, and what it had become a period later. Each push is what the one before it had
        become, set back to the same size.
    """
    rates = np.linalg.norm(grown, axis=-1) / np.linalg.norm(pushes, axis=-1)
    one = pushes[:, 1:].reshape(-1)
    before = (pushes[:, :-1] / rates[:, :-1, None]).reshape(-1)
    (a, b), *_ = np.linalg.lstsq(np.column_stack([one, before]), grown[:, 1:].reshape(-1))
    roots = np.roots([1.0, -a, -b]).astype(np.complex128)
    return roots[np.argsort(-np.abs(roots))]


def partings(
    scenarios: Sequence[Scenario],
    states: Sequence[State],
    size: float,
    periods: int = 40,
    series: int = 3,
    seed: int = 0,
) -> list[Parting]:
    """How twins of several strides part at a distance.

    After each period a twin is set back to that distance, in the direction in which it has parted, where its stride now
    lies. What it has come to lie or be turned apart by is left out, as an endless plate does not know of it.

    Parameters
    ----------
    size : float
        Distance of the coordinates: above what the map's bends make of less, which 1e-3 is.
    periods : int
        The first five are left out: there the direction that grows is found.
    series : int
        Twins of each, pushed each its own way at first.
    seed : int
        Of the first pushes.
    """
    generator = np.random.default_rng(seed)
    many = [s for s in scenarios for _ in range(series)]
    now = list(states)
    change = [np.concatenate([np.zeros(3), generator.standard_normal(len(COORDINATES) - 3)]) for _ in many]
    pushes, grown = [], []
    for _ in range(periods):
        away = [size / float(np.linalg.norm(c)) * c for c in change]
        origin = [state for state in now for _ in range(series)]
        moved = [pushed(s, state, c) for s, state, c in zip(many, origin, away, strict=True)]
        after = advance([*scenarios, *many], [*now, *moved])
        now, moved = after[: len(scenarios)], after[len(scenarios) :]
        here = [coordinates(s, state) for s, state in zip(scenarios, now, strict=True)]
        told = [coordinates(s, state) for s, state in zip(many, moved, strict=True)]
        change = [apart(here[i // series], each) for i, each in enumerate(told)]
        for each in change:
            each[POSE] = 0.0
        pushes.append(np.array(away))
        grown.append(np.array(change))
    shape = (periods, len(scenarios), series, len(COORDINATES))
    all_pushes, all_grown = (np.array(x).reshape(shape).transpose(1, 2, 0, 3)[:, :, 5:] for x in (pushes, grown))
    return [_parting(p, g) for p, g in zip(all_pushes, all_grown, strict=True)]


def _parting(pushes: Array, grown: Array) -> Parting:
    rates = np.log(np.linalg.norm(grown, axis=-1) / np.linalg.norm(pushes, axis=-1))
    error = float(rates.std(ddof=1)) / math.sqrt(rates.size)
    return Parting(float(rates.mean()), error, leading_pair(pushes, grown))
