"""Profile likelihoods of an object's parameters, from readings that are emulated by quadratics."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array
from plategait.model.scenario import Scenario
from plategait.study.questions.information import PARAMETERS, changed, noise_of
from plategait.study.runs import Runs

SOUGHT = PARAMETERS[1:]
"""The mass is weighed."""
SPREAD = 0.35
"""Objects are drawn so far to either side, in logarithms."""
DRAWS = 48
GRID = np.linspace(-0.5, 0.5, 41)
INTERVAL = 1.0
"""χ² over its least at the ends of a 68 % interval."""
SEED = 17


@dataclass(frozen=True, eq=False)
class Profiles:
    """Least χ² over all other parameters, of each parameter along `GRID`.

    Attributes
    ----------
    values : (parameters, grid) array
        Over the least of all.
    error : (readings,) array
        R.m.s. error of each reading's quadratic, of the logarithm, each draw left out in turn.
    """

    values: Array
    error: Array

    @property
    def sds(self) -> Array:
        """(parameters,) half of the 68 % intervals; NaN where one is open."""
        return np.array([_half_width(profile) for profile in self.values])

    @property
    def closed(self) -> bool:
        """Whether each profile rises through `INTERVAL` once on either side."""
        inside = self.values < INTERVAL
        edges = np.abs(np.diff(inside.astype(int), axis=1)).sum(axis=1)
        return bool((edges == 2).all() and not inside[:, [0, -1]].any())


def _half_width(profile: Array) -> float:
    least = int(np.argmin(profile))
    sides = []
    for part, grid in ((profile[least:], GRID[least:]), (profile[: least + 1][::-1], GRID[: least + 1][::-1])):
        above = np.flatnonzero(part > INTERVAL)
        if not len(above):
            return float("nan")
        i = above[0]
        share = (INTERVAL - part[i - 1]) / (part[i] - part[i - 1])
        sides.append(float(grid[i - 1] + share * (grid[i] - grid[i - 1])))
    return abs(sides[0] - sides[1]) / 2


def quadratic_terms(x: Array) -> Array:
    """(n, t) terms of a quadratic of (n, d) values."""
    d = x.shape[1]
    return np.stack([np.ones(len(x)), *x.T, *(x[:, i] * x[:, j] for i in range(d) for j in range(i, d))], axis=1)


def profiles_of(runs: Runs, base: Scenario, read: Sequence[tuple[Mapping[str, float], str]]) -> Profiles:
    """Profiles of readings that are exactly those of the base object, each with its noise.

    Parameters
    ----------
    base : Scenario
    read : sequence of (motion, reading)
    """
    rng = np.random.default_rng(SEED)
    x = np.concatenate([np.zeros((1, len(SOUGHT))), rng.uniform(-SPREAD, SPREAD, (DRAWS - 1, len(SOUGHT)))])
    objects = [changed(base, dict(zip(SOUGHT, map(float, row), strict=True))) for row in x]
    found = runs.measure([o.replace(**motion) for o in objects for motion, _ in read], repeats=2).means
    seen = np.stack([found[name].reshape(len(x), len(read))[:, i] for i, (_, name) in enumerate(read)], axis=1)
    with np.errstate(invalid="ignore", divide="ignore"):
        logs = np.log(seen)
    use = np.isfinite(logs).all(axis=1)
    terms = quadratic_terms(x[use])
    coefficients: Array = np.asarray(np.linalg.lstsq(terms, logs[use], rcond=None)[0], dtype=np.float64)
    hat = terms @ np.linalg.pinv(terms)
    error = np.sqrt(np.mean(((logs[use] - hat @ logs[use]) / (1 - np.diag(hat))[:, None]) ** 2, axis=0))
    noise = np.array([float(noise_of(name, seen[0, i])) for i, (_, name) in enumerate(read)])
    truth = np.asarray(quadratic_terms(np.zeros((1, len(SOUGHT))))[0] @ coefficients, dtype=np.float64)
    values = np.array([_profile(coefficients, truth, noise, i) for i in range(len(SOUGHT))])
    return Profiles(values - values.min(), error)


def _profile(coefficients: Array, truth: Array, noise: Array, which: int) -> Array:
    """Least χ² with one parameter held along the grid, from where the neighbour's least was."""
    from scipy.optimize import least_squares

    others = [i for i in range(len(SOUGHT)) if i != which]
    values = np.empty(len(GRID))
    middle = len(GRID) // 2
    for order in (range(middle, len(GRID)), range(middle, -1, -1)):
        at = np.zeros(len(others))
        for k in order:

            def residuals(rest: Array, held: float = float(GRID[k])) -> Array:
                x = np.zeros((1, len(SOUGHT)))
                x[0, others], x[0, which] = rest, held
                return (quadratic_terms(x)[0] @ coefficients - truth) / noise

            fit = least_squares(residuals, at, bounds=(-0.7, 0.7))
            at, values[k] = fit.x, 2 * fit.cost
    return values
