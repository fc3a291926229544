"""From film to material: ``python -m benchmarks.loop [--engine cpu|tiles] [--design spread|mixed] [--objects 6]``.

Objects over the source's whole range (ω_n 3.5 to 33π rad/s, evenly in the logarithm; α 24 to 57 deg; β 0.3 to 0.9), on
a plate whose height and with a damping c_b that the estimator does not know (2 to 8 mm, a third to three times the
preset's), are simulated by our engine or by the rigid tiles. Each is filmed under twelve plate motions, 3 s at 30
frames a second and 640 × 360 pixels: "spread", evenly from 13 to 31 Hz, or "mixed", as ``benchmarks.bounds`` chooses
them and the tiles cannot make. The films are tracked, and ω_n, α and β are estimated from the curve that `track-folder`
makes, with the model's error allowed for by default and with the model taken as right. ``--work`` keeps curves and
estimates: what was stopped goes on where it was.
"""

from __future__ import annotations

import argparse
import json
import math
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from benchmarks.bounds import best_motions
from benchmarks.coverage import Trial, judged
from plategait.cli.shoot import SHAPES_PER_PERIOD
from plategait.curve.curve import Curve
from plategait.curve.curve_file import read_curve, write_curve
from plategait.curve.protocol import measured_as
from plategait.engine.engines import Engine
from plategait.estimate.observations import Condition
from plategait.estimate.result import estimate_parameters
from plategait.estimate.unknowns import unknowns
from plategait.model.presets import preset
from plategait.model.scenario import Scenario
from plategait.render.clip.appearance import Appearance
from plategait.render.clip.clip import film, usual_camera
from plategait.render.clip.scene import Scene
from plategait.simulation.result import Simulation
from plategait.simulation.run import START_SPREAD, START_TURN, simulate_all
from plategait.vision.folder import curve_of_clips, track_folder
from plategait.vision.setup import Setup

SETTLED, SECONDS, FPS, SIZE = 1.0, 3.0, 30.0, (640, 360)
BASE = measured_as(preset("cheese").scenario)
MODEL_ERRORS = (1.0, 0.0)


def motions(design: str) -> tuple[Condition, ...]:
    """Twelve motions by rising frequency."""
    if design == "mixed":
        return tuple(sorted(best_motions(), key=lambda c: c.frequency))
    return tuple(Condition(BASE.motion.angle, BASE.motion.stroke, float(f)) for f in np.linspace(13, 31, 12).round(2))


@dataclass(frozen=True)
class Object:
    """A truth: ω_n (π rad/s), α (deg) and β, and the object and set-up that have it."""

    truth: np.ndarray
    scenario: Scenario


def drawn(number: int, seed: int) -> Object:
    """One object of a seed."""
    generator = np.random.default_rng([seed, number])
    omega = 3.5 * (33 / 3.5) ** generator.random()
    truth = np.array([omega, generator.uniform(24, 57), generator.uniform(0.3, 0.9)])
    damping, height = 3.0 ** generator.uniform(-1, 1), generator.uniform(2e-3, 8e-3)
    si = truth * (math.pi, math.radians(1), 1.0)
    return Object(truth, unknowns(BASE).scenario(np.array([*si, damping, height])))


def simulated(scenario: Scenario, design: Sequence[Condition], engine: Engine, seed: Sequence[int]) -> list[Simulation]:
    """An object under every motion, laid down anew each time, with the shapes that a film needs."""
    generator = np.random.default_rng(seed)
    runs = []
    for condition in design:
        (x, y), turn = generator.normal(0, START_SPREAD, 2), generator.normal(0, START_TURN)
        runs.append(scenario.replace(duration=SETTLED + SECONDS + 0.05, transient=SETTLED, **{
            "motion": condition.motion(scenario.motion), "start.x": x, "start.y": y, "start.angle": turn,
        }))  # fmt: skip
    shapes = 1 / (SHAPES_PER_PERIOD * max(c.frequency for c in design))
    return simulate_all(runs, engine=engine, snapshot_interval=shapes)


def filmed_curve(
    thing: Object, design: Sequence[Condition], engine: Engine, seed: Sequence[int]
) -> tuple[Curve, list[float], dict[str, float]]:
    """The curve that its films give, the rates that they show (deg/s), and CPU seconds of each stage."""
    took = {}
    with tempfile.TemporaryDirectory() as folder:
        begun = time.process_time()
        runs = simulated(thing.scenario, design, engine, seed)
        took["simulated"] = time.process_time() - begun
        rates = []
        for i, run in enumerate(runs):
            name = f"{run.scenario.motion.frequency:g}Hz.mp4"
            truth = film(run, Path(folder) / name, usual_camera(run.scenario, *SIZE), FPS, Appearance(seed=i),
                         seconds=SECONDS)  # fmt: skip
            rates.append(math.degrees(truth.spin.rate))
        took["filmed"] = time.process_time() - begun - took["simulated"]
        setup = Setup(plate_size=Scene.plate_size(thing.scenario))
        begun = time.process_time()
        curve = curve_of_clips(track_folder(folder, setup), f"{engine} {seed}")
        took["tracked"] = time.process_time() - begun
    told = replace(
        curve,
        angle_deg=np.degrees([c.angle for c in design]),
        stroke=np.array([c.stroke for c in design]),
        height=np.array([BASE.motion.height + c.height for c in design]),
        phase=np.array([c.phase for c in design]),
    )
    return told, rates, took


def row(label: str, trials: Sequence[Trial]) -> str:
    """One line of the table."""
    error, sd = np.abs([t.error for t in trials]), np.array([t.sd for t in trials])
    covered, n = np.sum([t.covered for t in trials], axis=0), len(trials)
    cells = [f"{np.median(error[:, i]):.2f} ({np.median(sd[:, i]):.2f})" for i in range(3)]
    alarms = sum(bool(t.complaints) for t in trials)
    held = " | ".join(f"{c} of {n}" for c in covered)
    return f"| {label} | {n} | {' | '.join(cells)} | {held} | {alarms} | {np.median([t.seconds for t in trials]):.0f} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--engine", choices=("cpu", "tiles"), default="cpu")
    parser.add_argument("--design", choices=("spread", "mixed"), default="spread")
    parser.add_argument("--objects", type=int, default=6)
    parser.add_argument("--first", type=int, default=0, help="number of the first object")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--work", type=Path, default=Path("build/loop"), help="folder of curves and estimates")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    design = motions(arguments.design)
    print("\n".join(f"{c.frequency:.2f} Hz, {c.text}" for c in design), flush=True)
    trials: dict[float, list[Trial]] = {error: [] for error in MODEL_ERRORS}
    for number in range(arguments.first, arguments.first + arguments.objects):
        thing = drawn(number, arguments.seed)
        stem = arguments.work / f"{arguments.engine}-{arguments.design}-{arguments.seed}-{number}"
        file = stem.with_suffix(".csv")
        print(f"{stem.name}: {thing.truth.round(2)}", flush=True)
        if not file.exists():
            curve, rates, took = filmed_curve(thing, design, arguments.engine, [arguments.seed, number, 7])
            write_curve(curve, file)
            off = curve.spin_rate_deg_s - rates
            print("  rates", np.array(rates).round(1).tolist(), "read off by", off.round(2).tolist(),
                  "to", curve.spin_rate_sd_deg_s.round(2).tolist(), "failed", curve.failure,
                  {k: round(v, 1) for k, v in took.items()}, flush=True)  # fmt: skip
        for error in MODEL_ERRORS:
            kept = Path(f"{stem}-error-{error:g}.json")
            if not kept.exists():
                begun = time.process_time()
                estimate = estimate_parameters(read_curve(file), BASE, model_error=error, seed=number)
                kept.write_text(json.dumps(judged(estimate, thing.truth, time.process_time() - begun).__dict__))
            trials[error].append(Trial(**json.loads(kept.read_text())))
            print(f"  model error {error:g}: {trials[error][-1].text}", flush=True)
    print("| model | objects | error of ω_n, and its sd (π rad/s) | of α (deg) | of β | 90 % intervals hold ω_n | α "
          "| β | unexplained | CPU s |\n|---|---|---|---|---|---|---|---|---|---|")  # fmt: skip
    for error, label in zip(MODEL_ERRORS, ("its error allowed for", "taken as right"), strict=True):
        print(row(f"{arguments.engine}, {arguments.design}, {label}", trials[error]))


if __name__ == "__main__":
    main()
