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
LEAST_OF_A_CURVE = 3


@dataclass(frozen=True, eq=False)
class Prediction:
    """What the engine gives at draws of the posterior: a spin curve of one amplitude, or the motions that make none.

    Attributes
    ----------
    amplitude : Condition or None
        All of the plate motion but its frequency; None where the motions differ in more than that.
    conditions : tuple of Condition
        Plate motions.
    rates : (n, c) array
        deg/s; NaN where a draw runs off.
    failed : (n, c) bool array
    values : mapping of str to (n, c) array
        Observables that were read, by name, SI; NaN where a draw runs off.
    """

    amplitude: Condition | None
    conditions: tuple[Condition, ...]
    rates: Array
    failed: np.ndarray
    values: Mapping[str, Array] = field(default_factory=dict)

    @property
    def frequency(self) -> Array:
        """Plate frequencies (c,), Hz."""
        return np.array([c.frequency for c in self.conditions])


def predict(
    posterior: Posterior, *, seed: int = 0, progress: Callable[[float], object] | None = None
) -> list[Prediction]:
    """Run the engine at draws of the posterior, a little beyond the measured frequencies of each amplitude.

    Amplitudes at fewer than `LEAST_OF_A_CURVE` frequencies make no curve: they are predicted together, as measured.
    """
    generator = np.random.default_rng(seed)
    u = posterior.u[generator.choice(len(posterior.u), DRAWS, replace=False)]
    measured = posterior.data.conditions
    of = {a: [c.frequency for c in measured if c.amplitude == a] for a in dict.fromkeys(c.amplitude for c in measured)}
    wanted: list[tuple[Condition | None, tuple[Condition, ...]]] = [
        (amplitude, tuple(amplitude.at(float(g)) for g in np.linspace(0.95 * min(f), 1.05 * max(f), POINTS)))
        for amplitude, f in of.items()
        if len(f) >= LEAST_OF_A_CURVE
    ]
    mixed = tuple(c for c in measured if len(of[c.amplitude]) < LEAST_OF_A_CURVE)
    if mixed:
        wanted.append((None, mixed))
    names, predictions = [r.name for r in posterior.data.readings], []
    for i, (amplitude, conditions) in enumerate(wanted):

        def report(done: float, i: int = i) -> None:
            if progress is not None:
                progress((i + done) / len(wanted))

        runs = run_engine(posterior.unknowns, u, conditions, handling=posterior.data.handling, observables=names,
                          seed=seed, progress=report)  # fmt: skip
        predictions.append(Prediction(amplitude, conditions, runs.rates, runs.failed, runs.values))
    return predictions
