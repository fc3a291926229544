"""Whether the intervals hold the truth and the check is silent, also on data of other models.

``python -m benchmarks.coverage [--objects 60] [--model …] [--noise 0.01] [--model-error 1] [--kept FILE]``

Objects over the source's whole range (those of ``benchmarks.recovery``) are simulated at twelve plate frequencies by
our engine, by itself and with another friction law, with torsion, and by the rigid tiles; noise is laid on the rates,
and the estimator, which knows of none of this, reads ω_n, α and β off them, c_b and the plate's height unknown. The
tiles take a minute an object: ``--kept`` holds each curve without noise and each estimate in a file, so that
a measurement that was stopped goes on where it was.
"""

from __future__ import annotations

import argparse
import json
import math
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.recovery import BASE, curve_of, true_object
from benchmarks.robustness import smooth_friction, with_torsion
from plategait.engine.engines import Engine
from plategait.estimate.result import Estimate, estimate_parameters
from plategait.model.scenario import Scenario
from plategait.simulation.run import START_SPREAD, START_TURN, simulate_all

FREQUENCIES = tuple(float(f) for f in np.linspace(13, 31, 12))
MODELS = ("as modelled", "smooth friction law", "torsion stiffness", "rigid tiles")
TOGETHER = 10  # objects simulated side by side, which the tiles take half the time for
Points = dict[str, tuple[float, str]]


@dataclass(frozen=True)
class Trial:
    """One estimate beside its truth: errors (ω_n in π rad/s, α in deg, β), what was covered, what the check said."""

    error: tuple[float, ...]
    covered: tuple[bool, ...]
    sd: tuple[float, ...]
    complaints: tuple[str, ...]
    p: float
    seconds: float

    @property
    def text(self) -> str:
        """In one line."""
        numbers = " ".join(f"{e:+.2f} ± {sd:.2f}" for e, sd in zip(self.error, self.sd, strict=True))
        held = "".join("y" if c else "n" for c in self.covered)
        return f"{numbers} held {held} p {self.p:.2f} {self.seconds:.1f} CPU s {'; '.join(self.complaints)}"


def changed(scenario: Scenario, model: str) -> Scenario:
    """The object by another model of ours."""
    changes = {"smooth friction law": smooth_friction, "torsion stiffness": with_torsion}
    return changes[model](scenario) if model in changes else scenario


def simulated(numbers: Sequence[int], model: str) -> list[Points]:
    """Rates (deg/s) without noise and failures of objects by plate frequency, laid down anew at each."""
    scenarios = []
    for number in numbers:
        _, truth = true_object(number)
        generator = np.random.default_rng([number, 7])
        for f in FREQUENCIES:
            (x, y), turn = generator.normal(0, START_SPREAD, 2), generator.normal(0, START_TURN)
            start = {"start.x": x, "start.y": y, "start.angle": turn}
            scenarios.append(changed(truth, model).replace(**{"motion.frequency": f, **start}))
    engine: Engine = "tiles" if model == "rigid tiles" else "cpu"
    seen = [(math.degrees(r.spin_rate), r.failure.kind if r.failure else "")
            for r in simulate_all(scenarios, engine=engine)]  # fmt: skip
    return [
        {f"{f:g}": point for f, point in zip(FREQUENCIES, seen[i : i + len(FREQUENCIES)], strict=True)}
        for i in range(0, len(seen), len(FREQUENCIES))
    ]


def noisy(points: Points, noise: float, seed: int) -> dict[float, tuple[float, str]]:
    """Points with relative noise on their rates."""
    generator = np.random.default_rng([seed, 11])
    return {float(f): (rate * (1 + noise * generator.normal()), kind) for f, (rate, kind) in points.items()}


def trial(number: int, points: Points, noise: float, told: bool, model_error: float, any_law: bool) -> Trial:
    """Estimate one object."""
    truth, _ = true_object(number)
    curve = curve_of(noisy(points, noise, number))
    told_noise, begun = noise if told else None, time.process_time()
    estimate = estimate_parameters(
        curve, BASE, noise=told_noise, model_error=model_error, any_law=any_law, seed=number
    )  # fmt: skip
    return judged(estimate, truth, time.process_time() - begun)


def judged(estimate: Estimate, truth: np.ndarray, seconds: float) -> Trial:
    """An estimate beside the truth."""
    values = estimate.posterior.values[:, :3] / [math.pi, math.radians(1), 1.0]
    low, middle, high = np.quantile(values, [0.05, 0.5, 0.95], axis=0)
    return Trial(tuple(middle - truth), tuple(((low <= truth) & (truth <= high)).tolist()), tuple(values.std(axis=0)),
                 estimate.goodness.complaints, estimate.goodness.p, seconds)  # fmt: skip


def row(model: str, trials: list[Trial]) -> str:
    """One line of the table."""
    error = np.median(np.abs([t.error for t in trials]), axis=0)
    sd = np.median([t.sd for t in trials], axis=0)
    covered = np.sum([t.covered for t in trials], axis=0)
    alarms = sum(bool(t.complaints) for t in trials)
    return (f"| {model} | {len(trials)} | {error[0]:.2f} ({sd[0]:.2f}) | {error[1]:.2f} ({sd[1]:.2f}) "
            f"| {covered[0]} | {covered[1]} | {covered[2]} | {100 * covered.sum() / (3 * len(trials)):.0f} | {alarms} "
            f"| {np.median([t.seconds for t in trials]):.1f} |")  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--objects", type=int, default=60)
    parser.add_argument("--first", type=int, default=0, help="number of the first object")
    parser.add_argument("--model", choices=MODELS, action="append", help="only this one; repeatable")
    parser.add_argument("--noise", type=float, default=0.05)
    parser.add_argument("--model-error", type=float, default=1.0, help="as `plategait estimate` takes it")
    parser.add_argument("--any-law", action="store_true", help="as `plategait estimate` takes it")
    parser.add_argument("--unknown-noise", action="store_true", help="the estimator is not told the noise")
    parser.add_argument("--kept", type=Path, help="file of curves and estimates, written and read: .json")
    parser.add_argument("--only-curves", action="store_true", help="estimate nothing")
    arguments = parser.parse_args()
    told, noise, error, law = (
        not arguments.unknown_noise, arguments.noise, arguments.model_error, arguments.any_law
    )  # fmt: skip
    kept: dict[str, dict[str, Any]] = {"curves": {}, "estimates": {}}
    if arguments.kept and arguments.kept.exists():
        kept = json.loads(arguments.kept.read_text())

    def save() -> None:
        if arguments.kept:
            arguments.kept.write_text(json.dumps(kept))

    lines = []
    for model in arguments.model or MODELS:
        trials = []
        numbers = range(arguments.first, arguments.first + arguments.objects)
        missing = [n for n in numbers if f"{model} {n}" not in kept["curves"]]
        for some in (missing[i : i + TOGETHER] for i in range(0, len(missing), TOGETHER)):
            kept["curves"] |= {f"{model} {n}": p for n, p in zip(some, simulated(some, model), strict=True)}
            save()
        if arguments.only_curves:
            continue
        for number in numbers:
            points = kept["curves"][f"{model} {number}"]
            key = f"{model} {number} noise {noise:g} told {told} model error {error:g} any law {law}"
            if key not in kept["estimates"]:
                kept["estimates"][key] = asdict(trial(number, points, noise, told, error, law))
                save()
            trials.append(Trial(**kept["estimates"][key]))
            print(number, true_object(number)[0].round(2), trials[-1].text, flush=True)
        if trials:
            lines.append(row(model, trials))
    print("| data from | objects | error of ω_n, and its sd (π rad/s) | of α (deg) | covers ω_n | α | β | of all (%) "
          "| alarms | CPU s |\n|---|---|---|---|---|---|---|---|---|---|")  # fmt: skip
    print("\n".join(lines))


if __name__ == "__main__":
    main()
