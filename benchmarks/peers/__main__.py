"""Beside MuJoCo: ``make bench-peers``, or ``python -m benchmarks.peers [--json]``. In turn, on the same cores."""

from __future__ import annotations

import json
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path
from statistics import median

import numpy as np

from benchmarks.__main__ import batch, simulated_per_second
from benchmarks.peers.integrator import integrate
from benchmarks.peers.shell import largest_good_step, run_shells
from plategait.engine import cpu
from plategait.engine.recording import RunRequest
from plategait.model.presets import preset

ROUNDS = 3
# Simulated time of each of 64 runs, s: enough that a round of each takes some seconds.
SHELL_FOR, INTEGRATOR_FOR, OURS_FOR = 0.05, 0.2, 4.0


def agreement(folder: Path, duration: float = 0.2) -> float:
    """How far the nodes of a run differ between MuJoCo with our forces and ours in the same precision, m."""
    scenario = preset("cheese").scenario.replace(**{"motion.frequency": 20.0, "duration": duration, "transient": 0.0})
    _, ends = integrate([scenario], duration, folder)
    ours = cpu.run([RunRequest(scenario, snapshot_interval=scenario.dt)], precision="float64")[0].snapshots[-1]
    return float(np.abs(ends[0] - ours).max())


def main() -> None:
    """Measure and print."""
    runs = batch(duration=OURS_FOR)
    scenarios = [run.scenario for run in runs]
    rates: dict[str, list[float]] = {"shell": [], "integrator": [], "ours": []}
    with tempfile.TemporaryDirectory() as room:
        folder = Path(room)
        off = agreement(folder)
        step, factors = largest_good_step(preset("cheese").scenario.replace(**{"motion.frequency": 20.0}))
        for _ in range(ROUNDS):
            rates["shell"].append(run_shells(scenarios, SHELL_FOR, step))
            rates["integrator"].append(integrate(scenarios, INTEGRATOR_FOR, folder)[0])
            rates["ours"].append(simulated_per_second(runs))
    taken = {name: median(values) for name, values in rates.items()}
    if "--json" in sys.argv:
        told = {"mujoco": version("mujoco-core"), "cores": cpu.core_count(), "simulated_s_per_s": taken,
                "shell_step_s": step, "shell_turns": factors, "integrator_off_mm": 1e3 * off}  # fmt: skip
        print(json.dumps(told, indent=2))
        return
    print(f"MuJoCo {version('mujoco-core')}, {cpu.core_count()} cores; medians of {ROUNDS}, in turn\n")
    print("64 different runs of 52 nodes                             simulated s per s    ours, times")
    for name, words in (
        ("shell", f"mujoco.batch, shell with its own contact, {1e3 * step:g} ms"),
        ("integrator", f"mujoco.batch, as integrator of our forces, {1e3 * scenarios[0].dt:g} ms"),
        ("ours", f"plategait, {1e3 * scenarios[0].dt:g} ms"),
    ):
        print(f"  {words:55} {taken[name]:14.3g} {taken['ours'] / taken[name]:14.3g}")
    steps = ", ".join(f"{1e3 * each:g} ms {factor:.2f}" for each, factor in factors.items())
    print(f"\nthe shell turns, over how far it turns at 0.1 ms: {steps}")
    print(f"MuJoCo with our forces ends within {1e3 * off:.2g} mm of ours after 0.2 s")


if __name__ == "__main__":
    main()
