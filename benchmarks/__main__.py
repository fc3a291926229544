"""The speed report: ``make bench``, or ``python -m benchmarks [--json]``. Ratios and medians, and their machine.

Shared machines drift: each figure is the median of several runs, and what is compared is run in turn.
"""

from __future__ import annotations

import json
import platform
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median

import numpy as np

from benchmarks import environment, sessions
from plategait.engine import cpu
from plategait.engine.recording import RunRequest
from plategait.model.outline import Disk
from plategait.model.presets import preset

REPEATS = 5
TARGET = 300.0  # simulated seconds per second, two AVX-512 cores, 64 runs of 52 nodes
AIM = 600.0


def batch(n_runs: int = 64, duration: float = 4.0) -> list[RunRequest]:
    """Runs of the 52-node disk that all differ."""
    cheese = preset("cheese").scenario
    return [
        RunRequest(
            cheese.replace(
                **{
                    "duration": duration,
                    "motion.frequency": 10.0 + 20.0 * i / n_runs,
                    "motion.angle": 0.04 + 0.0005 * i,
                    "sheet.bending_stiffness": cheese.sheet.bending_stiffness * (0.5 + i / n_runs),
                }
            )
        )
        for i in range(n_runs)
    ]


def simulated_per_second(runs: list[RunRequest], **options) -> float:
    """Simulated seconds per second of wall time, the packing in Python included."""
    begun = time.perf_counter()
    recordings = cpu.run(runs, **options)
    wall = time.perf_counter() - begun
    return sum(r.steps * r.dt for r in recordings) / wall


def medians(ways: dict[str, Callable[[], float]]) -> dict[str, float]:
    """Median of each, taken in turn."""
    taken: dict[str, list[float]] = {name: [] for name in ways}
    for _ in range(REPEATS):
        for name, way in ways.items():
            taken[name].append(way())
    return {name: median(values) for name, values in taken.items()}


def throughput() -> dict[str, float]:
    """Simulated seconds per second of the batch of 64, over cores, precisions and instruction sets."""
    runs, cores = batch(), cpu.core_count()
    best = cpu.instruction_sets()[0]
    ways = {
        f"float32 {best}, {cores} cores": lambda: simulated_per_second(runs),
        f"float32 {best}, 1 core": lambda: simulated_per_second(runs, threads=1),
        f"float64 {best}, {cores} cores": lambda: simulated_per_second(runs, precision="float64"),
    }
    for level in cpu.instruction_sets()[1:]:
        ways[f"float32 {level}, {cores} cores"] = lambda level=level: simulated_per_second(runs, instruction_set=level)
    return medians(ways)


def scaling() -> dict[int, float]:
    """Nanoseconds per step, run and node of a full block, as the lattice grows at a fixed pitch."""
    cheese = preset("cheese").scenario
    ways: dict[str, Callable[[], float]] = {}
    counts = {}
    for across in (8, 16, 32, 64, 80):
        sheet = cheese.sheet.replace(outline=Disk(radius=across * 0.005), mass=cheese.sheet.mass * (across / 8) ** 2)
        n = sheet.lattice.n_nodes
        steps = max(100, 400_000 // n)
        scenario = cheese.replace(sheet=sheet, duration=steps * 1e-4, time_step=1e-4)
        runs = [RunRequest(scenario.replace(**{"motion.frequency": 10.0 + i})) for i in range(16)]

        def cost(runs: list[RunRequest] = runs, n: int = n, steps: int = steps) -> float:
            cpu.run(runs[:1], threads=1)  # the lattice's tables are made once
            begun = time.perf_counter()
            cpu.run(runs, threads=1)
            return 1e9 * (time.perf_counter() - begun) / (steps * len(runs) * n)

        ways[str(n)], counts[str(n)] = cost, n
    return {counts[name]: value for name, value in medians(ways).items()}


def session_throughput() -> dict[str, float]:
    """Simulated seconds per second of a session of the batch of 64, by how it is cut into pieces."""
    scenarios = [run.scenario for run in batch()]
    taken = [sessions.ways(scenarios) for _ in range(REPEATS)]
    return {name: median(each[name] for each in taken) for name in taken[0]}


def environment_throughput() -> dict[str, float]:
    """Environment steps a second of 64 lanes, bare and in the vectorised environment."""
    taken = [environment.ways() for _ in range(REPEATS)]
    return {name: median(each[name] for each in taken) for name in taken[0]}


def command_times() -> dict[str, float]:
    """Wall seconds of whole commands, from typing to the last line."""
    command = str(Path(sys.executable).with_name("plategait"))

    def timed(*arguments: str) -> Callable[[], float]:
        def run() -> float:
            begun = time.perf_counter()
            subprocess.run(arguments, check=False, capture_output=True)
            return time.perf_counter() - begun

        return run

    import_time = "import time; t = time.perf_counter(); import plategait; print(time.perf_counter() - t)"
    return medians(
        {
            "import plategait": lambda: float(subprocess.check_output([sys.executable, "-c", import_time])),
            "plategait simulate (4 s of the cheese)": timed(command, "simulate"),
            "plategait curve (19 frequencies, 4 s each)": timed(command, "curve"),
            "python -c pass": timed(sys.executable, "-c", "pass"),
        }
    )


def main() -> None:
    """Measure and print."""
    np.seterr(all="ignore")
    rates, pieces, lanes = throughput(), session_throughput(), environment_throughput()
    costs, commands = scaling(), command_times()
    machine = {"machine": platform.machine(), "cores": cpu.core_count(), "instruction_sets": cpu.instruction_sets()}
    if "--json" in sys.argv:
        measured = {
            "simulated_s_per_s": rates,
            "session_simulated_s_per_s": pieces,
            "environment_steps_per_s": lanes,
            "ns_per_step_run_node": costs,
            "seconds": commands,
        }
        print(json.dumps({**machine, **measured}, indent=2))
        return
    first = next(iter(rates.values()))
    levels = ", ".join(machine["instruction_sets"])
    print(f"{machine['machine']}, {machine['cores']} cores, {levels}; medians of {REPEATS}\n")
    print("64 different runs of 52 nodes, 4 s each, default step      simulated s per s    ratio")
    for name, rate in rates.items():
        print(f"  {name:55} {rate:14.0f} {rate / first:14.2f}")
    print(f"  target {TARGET:.0f}: {first / TARGET:.2f} of it; aim {AIM:.0f}: {first / AIM:.2f} of it\n")
    whole = next(iter(pieces.values()))
    print("a session of these 64 runs                                simulated s per s    ratio")
    for name, rate in pieces.items():
        print(f"  {name:55} {rate:14.0f} {rate / whole:14.2f}")
    print(f"  target {sessions.TARGET:.2f} in pieces\n")
    whole = next(iter(lanes.values()))
    print(f"{environment.LANES} lanes of the environment, 60 actions a second            steps per s    ratio")
    for name, rate in lanes.items():
        print(f"  {name:55} {rate:14.0f} {rate / whole:14.2f}")
    print(f"  target {environment.TARGET:.2f}\n")
    print("one core, 16 runs side by side                            ns per step, run and node")
    smallest = next(iter(costs.values()))
    for n, cost in costs.items():
        print(f"  {n:5} nodes {'':43} {cost:14.2f} {cost / smallest:14.2f}")
    print("\nwhole commands                                                 s")
    for name, seconds in commands.items():
        print(f"  {name:55} {seconds:14.2f}")


if __name__ == "__main__":
    main()
