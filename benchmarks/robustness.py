"""How far off estimates are when the model is wrong, and whether the check on the fit notices.

``python -m benchmarks.robustness [--objects 6] [--noise 0.05]``: data from objects that the estimator's model does not
hold and takes as right, 12 plate frequencies spread from 13 to 31 Hz at A_p = 3 deg, β unknown.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable

import numpy as np

from benchmarks.recovery import BASE, NOISE, OBJECT, Outcome, curve_of, measurement, spread
from plategait.estimate.result import Estimate, estimate_parameters
from plategait.model.outline import Disk
from plategait.model.scenario import Scenario
from plategait.simulation.run import simulate_all

OBJECTS = (
    (5.0, 30.0, 0.53),
    (8.0, 45.0, 0.7),
    (12.0, 37.0, 0.53),
    (18.0, 33.0, 0.8),
    (25.0, 48.0, 0.45),
    (30.0, 37.0, 0.6),
)
"""ω_n (π rad/s), α (deg), β."""


def as_modelled(scenario: Scenario) -> Scenario:
    """Nothing wrong: what noise alone does."""
    return scenario


def smooth_friction(scenario: Scenario) -> Scenario:
    """The friction law of the source's solver."""
    return scenario.replace(**{"friction.law": "adams"})


def with_torsion(scenario: Scenario) -> Scenario:
    """Torsion as stiff as bending, k_t = k_b, instead of free; k_b scaled so that the dish mode stays."""
    omega = scenario.sheet.natural_frequency
    sheet = scenario.sheet.replace(torsion_stiffness=scenario.sheet.bending_stiffness)
    return scenario.replace(sheet=sheet.with_natural_frequency(omega))


def larger(scenario: Scenario) -> Scenario:
    """A radius of 44 mm where 40 mm is told; the mass as told, ω_n as asked."""
    sheet = scenario.sheet.replace(outline=Disk(radius=0.044), pitch=0.011)
    return scenario.replace(sheet=sheet.with_natural_frequency(scenario.sheet.natural_frequency))


def measured_on_tiles(scenario: Scenario, generator: np.random.Generator, noise: float) -> dict[float, Outcome]:
    """Rates of rigid tiles, run-off by the same limit of slip."""
    scenarios = [scenario.replace(**{"motion.frequency": float(f)}) for f in np.linspace(13, 31, 12)]
    points: dict[float, Outcome] = {}
    for s in simulate_all(scenarios, engine="tiles"):
        rate = math.degrees(s.observations[0].spin.rate) * (1 + noise * generator.normal())
        points[s.scenario.motion.frequency] = (rate, "slipped" if s.failed else "")
    return points


CHANGES: dict[str, Callable[[Scenario], Scenario]] = {
    "as modelled": as_modelled, "smooth friction law": smooth_friction, "torsion stiffness": with_torsion,
    "disk 10 % larger than told": larger,
}  # fmt: skip


def row(name: str, estimates: list[tuple[Estimate, tuple[float, float, float]]]) -> str:
    """One line of the table."""
    omega = [e["natural_frequency"].median / math.pi - truth[0] for e, truth in estimates]
    alpha = [math.degrees(e["friction_angle"].median) - truth[1] for e, truth in estimates]
    noticed = sum(not e.goodness.explained for e, _ in estimates)
    return (f"| {name} | {np.median(np.abs(omega)):.1f} | {np.median(omega):+.1f} | {np.median(np.abs(alpha)):.1f} "
            f"| {np.median(alpha):+.1f} | {noticed} of {len(estimates)} |")  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--objects", type=int, default=len(OBJECTS))
    parser.add_argument("--noise", type=float, default=NOISE)
    parser.add_argument("--tiles", type=int, default=3, help="objects for the slow tile model")
    arguments = parser.parse_args()
    print(
        "| data from | median error of ω_n (π rad/s) | bias | of α (deg) | bias | noticed |\n|---|---|---|---|---|---|"
    )
    for name in [*CHANGES, "rigid tiles"]:
        estimates = []
        for i, truth in enumerate(OBJECTS[: arguments.tiles if name == "rigid tiles" else arguments.objects]):
            scenario = OBJECT.scenario(np.multiply(truth, (math.pi, math.radians(1), 1.0)))
            generator = np.random.default_rng(i)
            if name == "rigid tiles":
                points = measured_on_tiles(scenario, generator, arguments.noise)
            else:
                points = spread(measurement(CHANGES[name](scenario), generator, arguments.noise))
            estimates.append(
                (estimate_parameters(curve_of(points), BASE, noise=arguments.noise, model_error=0, seed=i), truth)
            )
        print(row(name, estimates), flush=True)


if __name__ == "__main__":
    main()
