"""The lab's page measures runs as the package does: observables, energy and ensembles, field by field."""

from __future__ import annotations

import base64
import json
import math
from typing import Any

import numpy as np
import pytest
from lab_scripts import NODE, asked

import plategait as pg
from plategait.engine.recording import Recording
from plategait.simulation.ensemble import Ensemble
from plategait.simulation.observation import Observation, ensemble_of, observe, values_of
from plategait.simulation.registry import BUILT_IN

pytestmark = pytest.mark.skipif(NODE is None, reason="node is not installed: the lab's measures are not compared")

CHEESE = pg.preset("cheese").scenario.replace(duration=0.4, transient=0.1)


def scenarios() -> list[pg.Scenario]:
    """Runs of every gait and failure, short ones, plates that stand still, and waves that repeat late."""
    plate = pg.Plate(length=0.09, width=0.09)
    ways: list[dict[str, Any]] = [
        *(
            {"motion.frequency": 8.0 + 3 * i, "motion.angle": 0.04 + 0.02 * i, "start.angle": 0.3 * i}
            for i in range(12)
        ),
        *({"motion.frequency": 20.0, "motion.stroke": 1e-3 * i, "friction.law": "adams"} for i in range(4)),
        {"duration": 0.06, "transient": 0.0},
        {"duration": 0.02, "transient": 0.001},
        {"duration": 0.2, "transient": 0.19},
        {"motion.angle": 0.0, "motion.stroke": 0.0},
        {"motion.angle": 0.0, "motion.stroke": 0.0, "motion.frequency": 1.0},
        {"motion.angle": 0.6, "motion.frequency": 25.0},
        {"motion.angle": 0.9, "motion.frequency": 18.0, "sheet.bending_stiffness": 3e-5},
        {"motion.angle": 0.5, "motion.frequency": 30.0, "slip_limit": 0.002},
        {"slip_limit": 1e-4},
        {"slip_limit": 1e-5, "transient": 0.0},
        {"plate": plate, "start.x": 0.044, "motion.frequency": 30.0, "motion.angle": 0.2, "slip_limit": 0.5},
        {"plate": plate, "start.x": 0.046, "slip_limit": 0.5},
        {"plate": plate, "start.y": 0.03, "start.x": 0.0449, "slip_limit": 0.001},
        {"plate": pg.Plate(length=0.05, width=0.05), "start.x": 0.02, "slip_limit": 0.5, "duration": 0.8},
        {"motion.waves": [{"axis": "z", "amplitude": 5e-4, "ratio": 1.5, "phase": 0.2}]},
        {"motion.waves": [{"axis": "x", "amplitude": 5e-4, "ratio": 2 / 3}], "motion.frequency": 30.0},
        {"motion.offset.rx": 0.3, "friction.static": 0.1, "friction.kinetic": 0.05},
        {"contact.damping": 0.0, "motion.frequency": 30.0, "motion.angle": 0.25},
        {"sheet.outline": pg.Rectangle(length=0.05, width=0.03), "sheet.mass": 4e-3},
    ]
    return [CHEESE.replace(**way) for way in ways]


def diverged(recording: Recording, name: str, value: float) -> Recording:
    """Same recording, of which a channel ceases to be finite half-way."""
    channels = {n: x.copy() for n, x in recording.channels.items()}
    channels[name][len(channels[name]) // 2 :] = value
    return Recording(**{**vars(recording), "channels": channels, "diverged": True})


def plain(scenario: pg.Scenario, recording: Recording) -> dict[str, Any]:
    def packed(series: np.ndarray) -> str:
        return base64.b64encode(np.ascontiguousarray(series, "<f8")).decode()

    return {
        "scenario": json.loads(scenario.model_dump_json()),
        "channels": {name: packed(series) for name, series in recording.channels.items()},
        "diverged": recording.diverged,
    }  # fmt: skip


@pytest.fixture(scope="module")
def compared() -> dict[str, Any]:
    """Observations and ensembles of both."""
    repeats, chosen = 3, scenarios()
    simulations = pg.simulate_all(chosen, repeats=repeats, seed=5)
    runs = [(s.scenario, r) for s in simulations for r in s.recordings]
    points = [list(range(repeats * i, repeats * (i + 1))) for i in range(len(chosen))]
    broken = [("kinetic_energy", math.inf), ("centre_x", math.nan), ("plate_work", math.nan), ("area_z", math.inf)]
    points.append([len(runs) + i for i in range(len(broken))])
    runs += [(chosen[0], diverged(simulations[0].recordings[0], *way)) for way in broken]
    ours = [observe(scenario, recording) for scenario, recording in runs]
    theirs = asked("observe.js", {"runs": [plain(*run) for run in runs], "points": points})
    return {"ours": ours, "theirs": theirs, "points": points}


def assert_like(got: object, want: float, what: str) -> None:
    """Sums are added in another order: a few last digits of a number, or of the largest of what cancels in it."""
    number = float(str(got).replace("Infinity", "inf"))
    assert number == pytest.approx(want, rel=1e-9, abs=1e-12, nan_ok=True), what


def test_the_runs_are_of_every_kind(compared):
    kinds = {o.failure.kind if o.failure else "" for o in compared["ours"]}
    assert {"", "slipped", "folded", "left the plate", "diverged"} <= kinds
    assert {o.gait for o in compared["ours"]} == {"", "sliding", "walking", "running"}
    assert any(o.failure and math.isfinite(o.failure.first_sign) for o in compared["ours"])
    assert len({math.isfinite(o.spin.rate) for o in compared["ours"]}) == 2


def test_every_run_shows_the_same(compared):
    for i, (ours, theirs) in enumerate(zip(compared["ours"], compared["theirs"]["observations"], strict=True)):
        assert_same_run(ours, theirs, f"run {i}")


def assert_same_run(ours: Observation, theirs: dict[str, Any], run: str) -> None:
    for name in ("rate", "low", "high", "sd"):
        assert_like(theirs["spin"][name], getattr(ours.spin, name), f"{run}: {name}")
    assert (theirs["spin"]["settled"], theirs["gait"]) == (ours.spin.settled, ours.gait), run
    assert (theirs["failure"] is None) == (ours.failure is None), run
    if ours.failure is not None:
        assert theirs["failure"]["kind"] == ours.failure.kind, run
        assert_like(theirs["failure"]["time"], ours.failure.time, run)
        assert_like(theirs["failure"]["first_sign"], ours.failure.first_sign, run)
    assert list(theirs["values"]) == [o.name for o in BUILT_IN]
    for name, value in theirs["values"].items():
        assert_like(value, ours[name], f"{run}: {name}")
    assert theirs["energy"].pop("closes") == ours.energy.closes, run
    elastic = [float(theirs["energy"].pop(name)) for name in ("axial", "bending", "torsion")]
    assert_like(sum(elastic), ours.energy.elastic, f"{run}: elastic")
    for ledger_name, value in theirs["energy"].items():
        own = "".join(f"_{c.lower()}" if c.isupper() else c for c in ledger_name)
        assert_like(value, getattr(ours.energy, own), f"{run}: {own}")


def test_every_ensemble_shows_the_same(compared):
    for members, theirs in zip(compared["points"], compared["theirs"]["ensembles"], strict=True):
        group = [[compared["ours"][i] for i in members]]
        ours: Ensemble = ensemble_of(group)
        for name in ("rate", "spread", "low", "high", "failure_time"):
            own = theirs[{"failure_time": "failureTime"}.get(name, name)]
            assert_like(own, getattr(ours, name)[0], f"{members}: {name}")
        assert theirs["failedRuns"] == ours.failed_runs[0]
        assert theirs["countedRuns"] == ours.counted_runs[0]
        assert (theirs["failed"], theirs["settled"]) == (ours.failed[0], ours.settled[0])
        assert (theirs["gait"], theirs["failure"]) == (ours.gait[0], ours.failure[0])
        for observable in BUILT_IN:
            assert_like(theirs["values"][observable.name], values_of(observable, group)[0], observable.name)
