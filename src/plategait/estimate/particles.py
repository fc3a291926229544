"""Points of the unit cube with their log likelihoods, made ever denser where the data are likely."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array

# Points of the first generation: enough that a tenth of the range of each of four unknowns is hit.
SIZE = 2**14
# Of points that spread about the best; three suffice for three unknowns.
MOST_GENERATIONS = 8
# Effective points for each dimension that a generation spreads about.
LEAST_EFFECTIVE = 50


@dataclass(frozen=True, eq=False)
class Particles:
    """Weighted points of the unit cube.

    Attributes
    ----------
    u : (n, d) array
    score : (n,) array
        Log likelihoods.
    """

    u: Array
    score: Array

    def weight(self, temperature: float) -> Array:
        """Weights (n,), the largest 1, of the likelihood flattened by a temperature."""
        return np.exp((self.score - self.score.max()) / temperature)

    def temperature(self, least: float) -> float:
        """Temperature at which the weights amount to at least so many points."""
        temperature = 1.0
        while temperature < 1e6:
            weight = self.weight(temperature)
            if weight.sum() ** 2 / np.sum(weight**2) >= least:
                break
            temperature *= 1.5
        return temperature

    def resampled(self, temperature: float, size: int, generator: np.random.Generator) -> Array:
        """Points (size, d) drawn by their weights at a temperature."""
        weight = self.weight(temperature)
        return self.u[generator.choice(len(self.score), size=size, p=weight / weight.sum())]

    def joined(self, more: Particles) -> Particles:
        """Both, one after the other."""
        return Particles(np.concatenate([self.u, more.u]), np.concatenate([self.score, more.score]))


def explore(log_likelihood: Callable[[Array], Array], dimensions: int, generator: np.random.Generator) -> Particles:
    """Points all over the cube, ever denser where the likelihood is high (population Monte Carlo).

    Each generation spreads about the best of all before it, at a temperature that keeps enough of them; once that
    temperature is 1, the points cover the likelihood.

    Parameters
    ----------
    log_likelihood : callable
        From points (n, d) to (n,).
    dimensions : int
    generator : numpy.random.Generator
    """
    u = stratified(SIZE, dimensions, generator)
    particles = Particles(u, log_likelihood(u))
    for _ in range(MOST_GENERATIONS):
        temperature = particles.temperature(LEAST_EFFECTIVE * dimensions)
        children = _children(particles.resampled(temperature, SIZE // 4, generator), generator)
        particles = particles.joined(Particles(children, log_likelihood(children)))
        if temperature == 1:
            break
    return particles


def _children(parents: Array, generator: np.random.Generator) -> Array:
    """Points about their parents, half as far spread as these, in the directions in which these spread."""
    spread = np.cov(parents.T) + 1e-8 * np.eye(parents.shape[1])
    step = generator.normal(0, 1, parents.shape) @ np.linalg.cholesky(spread).T
    return folded(parents + 0.5 * step)


def stratified(size: int, dimensions: int, generator: np.random.Generator) -> Array:
    """Latin hypercube: (size, dimensions) points of the unit cube, one in each of `size` strata of each axis."""
    strata = generator.permuted(np.tile(np.arange(size), (dimensions, 1)), axis=1).T
    return (strata + generator.random((size, dimensions))) / size


def folded(u: Array) -> Array:
    """Points beyond the unit cube mirrored back into it."""
    u = np.abs(u) % 2
    return np.where(u > 1, 2 - u, u)
