"""What the estimated object would do at plate frequencies that were not measured, with its uncertainty."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np

from plategait.arrays import Array
from plategait.estimate.observations import Condition
from plategait.estimate.posterior import Posterior
from plategait.estimate.runs import run_engine

DRAWS = 24
POINTS = 25


@dataclass(frozen=True, eq=False)
class Prediction:
    """Predicted spin curves of one amplitude, by the engine at draws of the posterior.

    Attributes
    ----------
    amplitude : (angle, stroke)
        rad and m.
    frequency : (c,) array
        Hz.
    rates : (n, c) array
        deg/s; NaN where a draw runs off.
    failed : (n, c) bool array
    values : mapping of str to (n, c) array
        Observables that were read, by name, SI; NaN where a draw runs off.
    """

    amplitude: tuple[float, float]
    frequency: Array
    rates: Array
    failed: np.ndarray
    values: Mapping[str, Array] = field(default_factory=dict)


def predict(
    posterior: Posterior, *, seed: int = 0, progress: Callable[[float], object] | None = None
) -> list[Prediction]:
    """Run the engine at draws of the posterior over a little more than the measured range, for each amplitude."""
    generator = np.random.default_rng(seed)
    u = posterior.u[generator.choice(len(posterior.u), DRAWS, replace=False)]
    predictions = []
    amplitudes = list(dict.fromkeys(c.amplitude for c in posterior.data.conditions))
    for i, amplitude in enumerate(amplitudes):
        f = [c.frequency for c in posterior.data.conditions if c.amplitude == amplitude]
        grid = np.linspace(0.95 * min(f), 1.05 * max(f), POINTS)
        conditions = [Condition(*amplitude, float(g)) for g in grid]

        def report(done: float, i: int = i) -> None:
            if progress is not None:
                progress((i + done) / len(amplitudes))

        names = [r.name for r in posterior.data.readings]
        runs = run_engine(posterior.unknowns, u, conditions, handling=posterior.data.handling, observables=names,
                          seed=seed, progress=report)  # fmt: skip
        predictions.append(Prediction(amplitude, grid, runs.rates, runs.failed, runs.values))
    return predictions
