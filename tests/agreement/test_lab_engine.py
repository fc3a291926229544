"""The lab's engine against the package's: what the core is told, bit for bit, and what comes of it."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np
import plategait._native as _native
import pytest
from lab_native import CHEESE, GROUPS, RUNS, advanced, is_same, is_within_the_spread
from lab_scripts import ENGINE, asked, needs_engine
from lab_sheets import SHAPES, plain

from plategait.engine.channels import CHANNELS
from plategait.engine.cpu import Session
from plategait.engine.packing import Told, features_of, lines_of, pack_courses, parameters_of
from plategait.engine.recording import Recording, RunRequest
from plategait.model.course import course_of
from plategait.simulation.observation import observe

pytestmark = needs_engine

KINDS = {"float64": "<f8", "float32": "<f4", "int32": "<i4", "int64": "<i8"}

# What is not chaotic stays within some thousand roundings of 1e-7.
SAME_PLACE, SAME_ANGLE = 2e-5, 1e-3  # m, rad
# What a channel must swing by to be told from roundings of places of some centimetres, by its unit.
LEAST = {"s": 1e-3, "m": 1e-6, "m^2": 1e-6, "1": 1e-2, "rad": 1e-4, "J": 1e-7}


def decoded(coded: dict[str, str]) -> np.ndarray:
    return np.frombuffer(base64.b64decode(coded["bytes"]), KINDS[coded["kind"].removeprefix("big")])


# A sheet under way, told of one thing after the other.
LIVED = CHEESE.replace(**{"plate": {"length": 0.2, "width": 0.2}, "start.x": 0.05, "motion.angle": "2 deg"})
SHAKEN = LIVED.replace(**{"motion.waves": [{"axis": "z", "amplitude": 2e-4, "ratio": 2.0, "phase": 1.0}]})
DRAWN = LIVED.replace(**{"motion.samples": {"time": [0.0, 0.02, 0.05, 0.08], "x": [0.0, 1e-3, -1e-3, 0.0]}})
WET = DRAWN.replace(**{"friction.static": 0.3, "friction.kinetic": 0.2, "motion.frequency": 12.0})
WAYS: list[dict[str, Any]] = [
    {"seconds": 0.05},
    {"seconds": 0.03, "change": {"motion": plain(SHAKEN)["motion"], "ramp": 0.02}},
    {"seconds": 0.01, "change": {"motion": plain(DRAWN)["motion"], "ramp": 0.05}},
    {"seconds": 0.07, "push": {"velocity": [0.05, -0.02, 0], "spin": 0.5}},
    {"seconds": 0.09, "become": {"scenario": plain(WET), "ramp": 0.04}},
]


@pytest.fixture(scope="module")
def answer() -> dict[str, Any]:
    """What the lab makes of all of them, in one process."""
    return asked("engine.js", {
        "engine": str(ENGINE),
        "told": [[plain(s) for s in group] for group in GROUPS], "runs": [plain(s) for s in RUNS],
        "sessions": [{"scenario": plain(LIVED), "ways": WAYS}],
    })  # fmt: skip


@pytest.fixture(scope="module")
def native() -> list[Recording]:
    return advanced([RunRequest(s) for s in RUNS])


def test_scenarios_are_of_every_kind():
    """Or the rest of this file would say less than it seems to."""
    assert {s.sheet.outline.shape for s in RUNS} == set(SHAPES)
    for has in (
        lambda s: s.friction.law == "adams", lambda s: s.sheet.torsion_stiffness > 0, lambda s: s.plate is not None,
        lambda s: s.motion.waves, lambda s: s.motion.samples is not None, lambda s: s.motion.ramp == 0,
        lambda s: any(s.motion.offset.pose), lambda s: s.contact.damping_ramp > 0, lambda s: s.time_step is not None,
        lambda s: s.motion.samples is not None and s.motion.ramp == 0, lambda s: s.gravity == 0,
    ):  # fmt: skip
        assert sum(map(bool, map(has, RUNS))) >= 1


def test_the_core_is_told_the_same(answer):
    for group, told in zip(GROUPS, answer["told"], strict=True):
        requests = [RunRequest(s) for s in group]
        rows = [parameters_of(s) for s in group]
        parameters = np.array([[row[name] for row in rows] for name in _native.PARAMETERS])
        packed, _ = pack_courses(
            Told(group, [course_of(s.motion) for s in group], [r.steps * r.scenario.dt for r in requests]), {}
        )
        lines = lines_of(requests[0].lattice)
        del lines["mobility"]  # every node of the lab's is free
        knots, start = packed.pop("knots"), np.stack([r.start()[0] for r in requests])
        want = {**lines, **packed, "parameters": parameters, "features": np.array(features_of(requests, parameters))}
        got = {name: decoded(coded) for name, coded in told["arrays"].items()}
        for name, array in want.items():
            assert np.array_equal(got[name], np.ravel(array)), name
        # Sums of a few products in another order.
        assert np.allclose(got["knots"], knots.ravel(), rtol=1e-12, atol=1e-14 * max(np.abs(knots).max(initial=0), 1))
        assert np.allclose(got["start"], start.ravel(), rtol=1e-14, atol=1e-16)
        assert told["numbers"] == {
            "steps": [r.steps for r in requests], "stride": [r.stride for r in requests],
            "dt": [r.scenario.dt for r in requests], "n_axial_lines": len(requests[0].lattice.axial_lines),
        }  # fmt: skip


def angle_of(channels: dict[str, np.ndarray]) -> np.ndarray:
    return np.unwrap(np.arctan2(channels["spin_cross"], channels["spin_dot"]))


def apart(recording: Recording, channels: dict[str, np.ndarray]) -> bool:
    """Whether the paths of a sheet part: one that is chaotic goes its own way after some thousand steps."""
    place = max(np.abs(channels[f"centre_{axis}"] - recording[f"centre_{axis}"]).max() for axis in "xyz")
    turned = np.abs(angle_of(channels) - angle_of(dict(recording.channels))).max()
    return bool(place > SAME_PLACE or turned > SAME_ANGLE)


@pytest.fixture(scope="module")
def chaotic(answer, native) -> list[bool]:
    found = []
    for recording, told in zip(native, answer["recordings"], strict=True):
        channels = {name: decoded(coded) for name, coded in told["channels"].items()}
        assert set(channels) == set(recording.channels)
        assert np.array_equal(channels["time"], recording["time"])
        assert (told["steps"], told["diverged"]) == (recording.steps, recording.diverged)
        found.append(apart(recording, channels))
    return found


def test_paths_are_the_same_but_of_the_chaotic(chaotic):
    # Of sheets that fly, slide off and fold, a few in a hundred double a rounding a dozen times so soon.
    assert np.mean(chaotic) <= 0.2


def test_runs_are_the_same_before_chaos_tells(answer, native):
    for recording, told in zip(native, answer["recordings"], strict=True):
        channels = {name: decoded(coded) for name, coded in told["channels"].items()}
        early = recording["time"] < 0.05
        for name, series in recording.channels.items():
            size = max(float(np.abs(series[early]).max()), LEAST[CHANNELS[name].unit])
            assert np.abs(channels[name][early] - series[early]).max() <= 0.02 * size, name


def test_rates_failures_gaits_and_energies_agree(answer, native, chaotic):
    told = answer["observations"]
    mine = [observe(s, recording) for s, recording in zip(RUNS, native, strict=True)]
    unlike = [i for i, observation in enumerate(mine) if not is_same(observation, told[i])]
    assert all(chaotic[i] for i in unlike)
    assert all(is_within_the_spread(RUNS[i], told[i]) for i in unlike)


def test_what_a_sheet_under_way_is_told(answer):
    session = Session([RunRequest(LIVED)], instruction_set="baseline")
    dt, wanted, taken = LIVED.dt, 0.0, 0
    for way, told in zip(WAYS, answer["sessions"][0], strict=True):
        if "change" in way:
            session.change([(0, (SHAKEN if way["seconds"] == 0.03 else DRAWN).motion, way["change"]["ramp"])])
        if "push" in way:
            session.push(0, np.array([0.05, -0.02, 0.5]))
        if "become" in way:
            # The package tells a plate and a sheet of it apart.
            session.become(0, RunRequest(WET.replace(time_step=dt)))
            session.change([(0, WET.motion, 0.04)])
        wanted += way["seconds"]
        steps = round(wanted / dt) - taken
        taken += steps
        [(_, piece)] = session.advance(np.array([steps]))
        recording = piece.recording(0)
        channels = {name: decoded(coded) for name, coded in told["channels"].items()}
        assert told["steps"] == recording.steps
        assert np.allclose(channels["time"], recording["time"], rtol=0, atol=1e-12)
        for axis in ("x", "y", "z", "rx", "ry", "rz"):
            # The plate's course has no chaos: single precision, and times of double.
            assert np.allclose(channels[f"plate_{axis}"], recording[f"plate_{axis}"], rtol=1e-6, atol=1e-9)
        assert not apart(recording, channels)
