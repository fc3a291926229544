"""What other models of the same object do to its curve: ``python -m benchmarks.model_error [--objects 6]``.

Objects of ``benchmarks.recovery`` at A_p = 3 deg, from 13 to 31 Hz in steps of half a hertz, by the engine as the
estimator uses it and by each of `plategait.estimate.discrepancy.ALTERNATIVES`, by half the step and by stiffer shear.
``--curves`` takes those of the rigid tiles from a file of ``benchmarks.coverage``. In percent of the rate, below the
run-off of both; and by how many hertz the run-off moves.
"""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Callable
from pathlib import Path

import numpy as np

from benchmarks.coverage import FREQUENCIES, simulated
from benchmarks.recovery import true_object
from plategait.estimate.discrepancy import ALTERNATIVES
from plategait.estimate.emulator import brackets
from plategait.model.scenario import Scenario
from plategait.simulation.run import simulate_all

GRID = np.arange(13.0, 31.1, 0.5)
BANDS = ((13.0, 16.0), (16.0, 19.0), (19.0, 22.0), (22.0, 25.0), (25.0, 31.0))
OTHERS: dict[str, Callable[[Scenario], Scenario]] = {
    "half the step": lambda scenario: scenario.replace(time_step=0.5 * scenario.dt),
    "shear three times as stiff": lambda scenario: scenario.replace(**{"sheet.shear_ratio": 3.0}),
}
Measured = tuple[np.ndarray, np.ndarray]


def measured(scenario: Scenario) -> Measured:
    """Rates (deg/s) and failures over the grid."""
    runs = simulate_all([scenario.replace(**{"motion.frequency": float(f)}) for f in GRID])
    return np.array([math.degrees(r.spin_rate) for r in runs]), np.array([r.failed for r in runs])


def compared(grid: np.ndarray, one: Measured, other: Measured) -> tuple[np.ndarray, float]:
    """Relative change of the rates (points,), NaN from the first failure of either, and the run-off's shift, Hz."""
    ends = [brackets(failed[None], grid) for _, failed in (one, other)]
    first = min(float(high[0]) for _, high in ends)
    change = np.where(grid < first, other[0] / one[0] - 1, math.nan)
    middles = [0.5 * (low[0] + high[0]) for low, high in ends]
    return change, float(middles[1] - middles[0]) if all(map(math.isfinite, middles)) else math.nan


def row(name: str, grid: np.ndarray, found: list[tuple[np.ndarray, float]]) -> str:
    """One line of the table: mean and standard deviation over objects and frequencies, by band."""
    changes = np.array([change for change, _ in found])
    cells = []
    for low, high in BANDS:
        x = 100 * changes[:, (grid >= low) & (grid < high)]
        x = x[np.isfinite(x)]
        cells.append(f"{x.mean():+.1f} ± {x.std():.1f}" if len(x) else "–")
    shifts = np.array([shift for _, shift in found if math.isfinite(shift)])
    return f"| {name} | {' | '.join(cells)} | {shifts.mean():+.2f} ± {shifts.std():.2f} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--objects", type=int, default=6)
    parser.add_argument("--curves", type=Path, help="file of benchmarks.coverage with curves of the tiles: .json")
    arguments = parser.parse_args()
    names = " | ".join(f"{low:g} to {high:g} Hz" for low, high in BANDS)
    print(f"| instead | {names} | run-off (Hz) |\n|---|{'---|' * (len(BANDS) + 1)}")
    objects = [true_object(number)[1] for number in range(arguments.objects)]
    as_modelled = [measured(o) for o in objects]
    for name, change in {**{a.label: a.applied for a in ALTERNATIVES}, **OTHERS}.items():
        found = [compared(GRID, own, measured(change(o))) for o, own in zip(objects, as_modelled, strict=True)]
        print(row(name, GRID, found), flush=True)
    if arguments.curves:
        kept = json.loads(arguments.curves.read_text())["curves"]
        numbers = [n for n in range(1000) if f"rigid tiles {n}" in kept]
        own = simulated(numbers, "as modelled")
        pairs = [(a, kept[f"rigid tiles {n}"]) for n, a in zip(numbers, own, strict=True)]
        grid = np.array(FREQUENCIES)
        arrays = [[(np.array([r for r, _ in p.values()]), np.array([bool(k) for _, k in p.values()])) for p in pair]
                  for pair in pairs]  # fmt: skip
        print(row(f"rigid tiles ({len(numbers)} objects)", grid, [compared(grid, a, b) for a, b in arrays]))


if __name__ == "__main__":
    main()
