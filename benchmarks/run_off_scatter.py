"""How sharp the run-off is: ``python -m benchmarks.run_off_scatter [--objects 12]``.

The first frequency at which an object fails, when nothing of it changes but what nobody knows of a measurement: how it
was laid down, how fast the plate was started, and the step of the simulation. Objects of ``benchmarks.recovery`` at 3
and 12 deg; the standard deviation over eight runs of each frequency, on grids of a quarter and an eighth of a hertz.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable

import numpy as np

from benchmarks.recovery import BASE, true_object
from plategait.estimate.emulator import brackets
from plategait.model.scenario import Scenario
from plategait.simulation.run import START_SPREAD, START_TURN, simulate_all

GRIDS = {3: np.arange(21.0, 33.0, 0.25), 12: np.arange(10.0, 17.5, 0.125)}
"""Plate frequencies, Hz, by A_p (deg)."""
VARIANTS = 8
Change = Callable[[np.random.Generator], dict[str, float]]


def laid_down(by: float) -> Change:
    """Start that differs by as many times the usual spread of ensembles."""

    def change(generator: np.random.Generator) -> dict[str, float]:
        x, y, turn = by * generator.normal(0, 1, 3) * (START_SPREAD, START_SPREAD, START_TURN)
        return {"start.x": x, "start.y": y, "start.angle": turn}

    return change


CHANGES: dict[str, Change] = {
    "start, 0.1 mm and 1 deg": laid_down(1.0),
    "start, 1 mm and 10 deg": laid_down(10.0),
    "ramp, 0 to 0.3 s": lambda generator: {"motion.ramp": generator.uniform(0.0, 0.3)},
    "step, 0.7 to 1 of it": lambda generator: {"time_step": BASE.dt * generator.uniform(0.7, 1.0)},
}


def first_failures(scenario: Scenario, angle: int, change: Change, seed: int) -> np.ndarray:
    """First failing frequency (variants,) of an object, midway to the one below it; NaN where none fails."""
    generator, grid = np.random.default_rng(seed), GRIDS[angle]
    scenarios = [
        scenario.replace(**{"motion.frequency": float(f), "motion.angle": math.radians(angle), **change(generator)})
        for _ in range(VARIANTS)
        for f in grid
    ]
    failed = np.array([s.failed for s in simulate_all(scenarios)]).reshape(VARIANTS, len(grid))
    low, high = brackets(failed, grid)
    return np.where((low > 0) & np.isfinite(high), 0.5 * (low + high), math.nan)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--objects", type=int, default=12)
    arguments = parser.parse_args()
    print(
        "| A_p (deg) | changed | sd of the first failing frequency (Hz): least | median | most |\n|---|---|---|---|---|"
    )
    for angle in GRIDS:
        for name, change in CHANGES.items():
            spread = []
            for number in range(arguments.objects):
                first = first_failures(true_object(number)[1], angle, change, number)
                if np.isfinite(first).sum() >= VARIANTS / 2:
                    spread.append(float(np.nanstd(first, ddof=1)))
            low, middle, high = np.quantile(spread, [0.0, 0.5, 1.0])
            print(f"| {angle} | {name} | {low:.2f} | {middle:.2f} | {high:.2f} |", flush=True)


if __name__ == "__main__":
    main()
