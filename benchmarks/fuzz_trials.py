"""One trial of `benchmarks.fuzz`: a random scenario or command is run, and its answer judged."""

from __future__ import annotations

import contextlib
import io
import json
import math
import pprint
import subprocess
import sys
import tempfile
import traceback
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.fuzz_edge import absurdities, edge_fields
from benchmarks.fuzz_inputs import Draw, command, motion_fields, scenario_fields
from plategait import cli
from plategait.errors import InputError
from plategait.model.scenario import Scenario
from plategait.model.scenario_file import read_scenario, write_scenario
from plategait.simulation.dataset import dataset_of
from plategait.simulation.result import Simulation
from plategait.simulation.run import simulate_all
from plategait.simulation.session import Session

LONGEST_LINE = 1000  # characters of a message
# Of a scenario, and of one at an edge, which takes its time to fall: longer ones are cut, so that thousands take
# minutes.
NODE_STEPS, EDGE_NODE_STEPS = 400_000, 2_000_000
LARGEST_SHEET = 20_000  # nodes; larger ones are described, not run
SUBPROCESSES = 25  # one command in so many is run as its own process
KINDS = ("scenario", "command", "edge")


@dataclass
class Case:
    """What became of a case: an outcome to count, and what was wrong with it."""

    outcome: str
    problem: str = ""


# Scenarios -----------------------------------------------------------------------------------------------------------


def try_scenario(seed: int, index: int, tell: Callable[[str], None]) -> Case:
    """Make and run one scenario, in some cases from several starts or beside another one."""
    draw = Draw(np.random.default_rng((seed, KINDS.index("scenario"), index)))
    fields = scenario_fields(draw)
    tell(pprint.pformat(fields, width=120))
    try:
        scenario = Scenario(**fields)
        if scenario.sheet.lattice.n_nodes > LARGEST_SHEET:
            return Case("too large to run")
        scenarios = [_cut(scenario)]
        if draw.chance(0.2):
            scenarios.append(_cut(scenario.replace(motion=motion_fields(draw))))
        tell("\n".join(write_scenario(s) for s in scenarios))
        found = simulate_all(
            scenarios, repeats=draw.whole(1, 3), seed=draw.whole(0, 9), engine=draw.choice(["cpu", "cpu64"]),
            threads=draw.choice([None, 1, 2, 5]), snapshot_interval=draw.choice([0.0, 0.0, 2e-3, 1e-30, 1e30]),
        )  # fmt: skip
        wrong = [w for simulation in found for w in _nonsense(simulation)]
        if draw.chance(0.1):
            wrong += _unlike_its_file(scenario)
        if draw.chance(0.2):
            wrong += _unlike_in_pieces(draw, scenarios[0])
        if draw.chance(0.01):
            dataset_of(found[0])
    except InputError as error:
        return Case("refused", _unfit_message(str(error)))
    except Exception:
        return Case("raised", traceback.format_exc())
    return Case("failed" if any(s.failed for s in found) else "ran", "; ".join(wrong))


def _unlike_in_pieces(draw: Draw, scenario: Scenario) -> list[str]:
    """What differs between a session in two pieces, each of another motion, and the same in many."""
    motions = [scenario.motion, scenario.motion.replace(angle=0.02, stroke=1e-3, ramp=draw.choice([0.01, 0.1]))]
    sessions = [Session([scenario], engine="cpu"), Session([scenario], engine="cpu")]
    for session, pieces in zip(sessions, (1, draw.whole(2, 9)), strict=True):
        for motion in motions:
            for _ in range(pieces):
                session.advance(motion, 0.5 * scenario.duration / pieces)
    one, many = (session.recording(0) for session in sessions)
    differ = [name for name in one.channels if not np.array_equal(one[name], many[name], equal_nan=True)]
    return [f"in pieces {', '.join(differ)} differ"] if differ else []


def _cut(scenario: Scenario, node_steps: int = NODE_STEPS) -> Scenario:
    most = node_steps / scenario.sheet.lattice.n_nodes * scenario.dt
    return scenario if scenario.duration <= most else scenario.replace(duration=most, transient=None)


def _nonsense(simulation: Simulation) -> Iterator[str]:
    """Numbers that are not finite without a status, and shares that are none."""
    summary = simulation.summary()
    json.dumps(summary, allow_nan=False)
    for key in ("contact_fraction", "flight_fraction"):
        if summary[key] is not None and not 0 <= summary[key] <= 1.0001:
            yield f"{key} {summary[key]}"
    for recording, observation in zip(simulation.recordings, simulation.observations, strict=True):
        arrays = {**recording.channels, "positions": recording.positions, "velocities": recording.velocities,
                  "snapshots": recording.snapshots}  # fmt: skip
        strange = [name for name, values in arrays.items() if not np.isfinite(values).all()]
        if strange and observation.failure is None:
            yield f"not finite without a status: {', '.join(strange)}"
        if observation.failure is not None and not math.isfinite(observation.failure.time):
            yield f"failure at {observation.failure.time}"


def _unlike_its_file(scenario: Scenario) -> Iterator[str]:
    path = Path("written.toml")
    path.write_text(write_scenario(scenario), encoding="utf-8")
    if read_scenario(path) != scenario:
        yield "read back from its file it is another scenario"


def _unfit_message(message: str) -> str:
    if "\n" in message or len(message) > LONGEST_LINE or any(ord(c) < 32 for c in message):
        return f"not one short plain line: {message[:LONGEST_LINE]!r}"
    return ""


def try_edge(seed: int, index: int, tell: Callable[[str], None]) -> Case:
    """Run one sheet at the edge of a plate or on a turntable."""
    draw = Draw(np.random.default_rng((seed, KINDS.index("edge"), index)))
    draw.wildness = 0.0
    fields = edge_fields(draw)
    tell(pprint.pformat(fields, width=120))
    try:
        scenario = _cut(Scenario(**fields), EDGE_NODE_STEPS)
        tell(write_scenario(scenario))
        simulation = simulate_all([scenario], engine=draw.choice(["cpu", "cpu64"]), threads=1)[0]
        wrong = [*_nonsense(simulation), *absurdities(simulation)]
    except InputError as error:
        return Case("refused", _unfit_message(str(error)))
    except Exception:
        return Case("raised", traceback.format_exc())
    ended = simulation.failure.kind if simulation.failure else "stayed"
    return Case(f"{ended}, energy open" if simulation.open_ledgers else ended, "; ".join(wrong))


# Commands ------------------------------------------------------------------------------------------------------------


def try_command(seed: int, index: int, tell: Callable[[str], None]) -> Case:
    """Run one command, most in this process."""
    draw = Draw(np.random.default_rng((seed, KINDS.index("command"), index)))
    fields = scenario_fields(draw)
    try:
        text = write_scenario(_cut(Scenario(**fields)))
    except InputError:
        text = json.dumps(fields, default=str)  # no TOML, which is a case too
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        arguments = command(draw, Path(folder), text)
        tell(f"{arguments}\n{Path('fuzz.toml').read_text(encoding='utf-8')}")
        try:
            status, printed, errors = (_in_its_own_process if index % SUBPROCESSES == 0 else _in_this_process)(
                arguments
            )
        except Exception:
            return Case("raised", traceback.format_exc())
    wrong = [f"status {status}"] if status not in (0, 1, 2) else []
    if "Traceback" in printed + errors:
        wrong.append("a traceback: " + errors[-2000:])
    elif status == 2:
        wrong += [w for w in [_unfit_message(errors.rstrip("\n"))] if w]
        wrong += [] if errors.startswith("plategait: ") else [f"standard error {errors[:LONGEST_LINE]!r}"]
    if status in (0, 1) and "--json" in arguments and "--version" not in arguments:
        wrong += [] if _is_json(printed) else [f"no JSON: {printed[:LONGEST_LINE]!r}"]
    return Case(f"status {status}", "; ".join(wrong))


def _is_json(text: str) -> bool:
    def refuse(constant: str) -> None:
        raise ValueError(constant)

    try:
        json.loads(text, parse_constant=refuse)
    except ValueError:
        return False
    return True


def _in_this_process(arguments: list[str]) -> tuple[int, str, str]:
    out, err = io.StringIO(), io.StringIO()
    told, sys.argv = sys.argv, ["plategait", *arguments]
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            cli.main()
    except SystemExit as end:
        return int(end.code or 0), out.getvalue(), err.getvalue()
    finally:
        sys.argv = told
    raise AssertionError("the command did not end with a status")


def _in_its_own_process(arguments: list[str]) -> tuple[int, str, str]:
    installed = str(Path(sys.executable).with_name("plategait"))
    if any("\x00" in a for a in arguments):
        return _in_this_process(arguments)
    done = subprocess.run([installed, *arguments], capture_output=True, text=True, errors="replace", check=False)
    return done.returncode, done.stdout, done.stderr


TRIALS = {"scenario": try_scenario, "command": try_command, "edge": try_edge}
