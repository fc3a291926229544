"""The core's own door: arrays that do not belong together are refused, and nothing is written past one."""

from __future__ import annotations

import numpy as np
import plategait._native as native
import pytest

N_RUNS, N_NODES, N_SAMPLES = 3, 6, 3
CHANNELS = len(native.CHANNELS)
VECTORS = (N_RUNS, N_NODES, 3)


def arguments(precision: str = "float32") -> dict:
    """Three runs of 2 × 3 nodes that fall freely, sampled every other step, one of them on a table of knots."""
    rest = np.array([(i, j) for j in range(2) for i in range(3)], dtype=float) - (1.0, 0.5)
    numbers = dict.fromkeys(native.PARAMETERS, 1.0) | {"time_step": 1e-4, "kinetic_speed": 2.0}
    layers = np.zeros((2, len(native.LAYER), N_RUNS))
    layers[:, native.LAYER.index("table_step")] = 1e-3
    start = np.concatenate([0.01 * rest, np.ones((N_NODES, 1))], axis=1)
    return {
        "line_start": np.array([0, 3, 6, 8, 10, 12], dtype=np.int32),
        "line_nodes": np.array([0, 1, 2, 3, 4, 5, 0, 3, 1, 4, 2, 5], dtype=np.int32),
        "n_axial_lines": 5,
        "cells": np.array([[0, 1, 3, 4], [1, 2, 4, 5]], dtype=np.int32),
        "rest": rest,
        "mobility": np.ones(N_NODES),
        "features": [True, True, True, True],
        "parameters": np.array([[numbers[name]] * N_RUNS for name in native.PARAMETERS]),
        "layer_terms": np.array([0, 1, 2], dtype=np.int32),
        "term_dof": np.array([0, 3], dtype=np.int32),
        "terms": np.ones((2, 3, N_RUNS)),
        "knots": np.zeros((5, 12)),
        "layers": layers,
        "first_knot": np.array([[0, 0, 2], [0, 1, 0]], dtype=np.int64),
        "n_knots": np.array([[2, 2, 3], [5, 4, 2]], dtype=np.int64),
        "steps": np.full(N_RUNS, 4, dtype=np.int64),
        "stride": np.full(N_RUNS, 2, dtype=np.int64),
        "thinning": np.ones(N_RUNS, dtype=np.int64),
        "x": np.repeat(start[None], N_RUNS, axis=0),
        "v": np.zeros(VECTORS),
        "edge": np.zeros(VECTORS),
        "tally": np.zeros((N_RUNS, native.N_TALLIES)),
        "clock": np.zeros((N_RUNS, native.N_CLOCKS), dtype=np.int64),
        "samples": np.full((N_RUNS, N_SAMPLES, CHANNELS), np.nan, dtype=precision),
        "snapshots": np.full((N_RUNS, N_SAMPLES, N_NODES, 3), np.nan, dtype=np.float32),
        "last": np.full((N_RUNS, CHANNELS), np.nan, dtype=precision),
        "level": native.available_levels()[0],
        "threads": 1,
        "progress": None,
    }


@pytest.mark.parametrize("precision", ["float32", "float64"])
def test_the_arguments_run_and_fill_every_output(precision):
    given = arguments(precision)
    getattr(native, f"advance_{precision}")(**given)
    for name in ("samples", "snapshots", "x", "v", "last"):
        assert np.isfinite(given[name]).all(), name
    # Taken, last sampled, due, sampled.
    assert given["clock"].tolist() == [[4, 4, 6, 3]] * N_RUNS


def changed(name: str, value) -> dict:
    return {name: value}


def with_entry(name: str, index, value) -> dict:
    array = arguments()[name].copy()
    array[index] = value
    return {name: array}


def with_parameter(name: str, value: float) -> dict:
    return with_entry("parameters", (native.PARAMETERS.index(name), 1), value)


def with_layer(name: str, value: float) -> dict:
    return with_entry("layers", (1, native.LAYER.index(name), 1), value)


def with_clock(taken: int, seen: int, due: int) -> dict:
    return {"clock": np.array([[taken, seen, due, 2]] * N_RUNS)}


BAD = {
    "no line_start": changed("line_start", np.zeros(0, dtype=np.int32)),
    "line_start not from 0": with_entry("line_start", 0, 1),
    "line_start falls": with_entry("line_start", 2, 2),
    "line_start far back": with_entry("line_start", 2, -(2**31)),
    "an empty line": with_entry("line_start", 2, 3),
    "line_start short of the end": with_entry("line_start", -1, 11),
    "line_start past the end": with_entry("line_start", -1, 13),
    "line_nodes out of range": with_entry("line_nodes", 0, N_NODES),
    "line_nodes below 0": with_entry("line_nodes", 3, -1),
    "more axial lines than lines": changed("n_axial_lines", 6),
    "fewer axial lines than none": changed("n_axial_lines", -1),
    "cells no multiple of 4": changed("cells", np.zeros(7, dtype=np.int32)),
    "cells out of range": with_entry("cells", (1, 1), N_NODES),
    "no nodes": changed("mobility", np.zeros(0)),
    "rest too short": changed("rest", np.zeros((N_NODES - 1, 2))),
    "mobility not finite": with_entry("mobility", 0, np.nan),
    "3 features": changed("features", [True] * 3),
    "5 features": changed("features", [True] * 5),
    "no runs": changed("steps", np.zeros(0, dtype=np.int64)),
    "parameters too short": changed("parameters", np.ones((len(native.PARAMETERS) - 1, N_RUNS))),
    "parameters not finite": with_parameter("pitch", np.inf),
    "no time step": with_parameter("time_step", 0.0),
    "time step below 0": with_parameter("time_step", -1e-4),
    "no table step": with_layer("table_step", 0.0),
    "table step not a number": with_layer("table_step", np.nan),
    "a table that begins later": with_layer("table_begin", 1.0),
    "layers too few": changed("layers", np.zeros((1, len(native.LAYER), N_RUNS))),
    "no layers": changed("layer_terms", np.zeros(1, dtype=np.int32)),
    "layer_terms short of the end": with_entry("layer_terms", 2, 1),
    "layer_terms past the end": with_entry("layer_terms", 2, 3),
    "layer_terms fall": changed("layer_terms", np.array([0, 2, 1, 2], dtype=np.int32)),
    "term_dof out of range": with_entry("term_dof", 0, 6),
    "term_dof below 0": with_entry("term_dof", 1, -1),
    "terms too short": changed("terms", np.ones((2, 3, N_RUNS - 1))),
    "terms not finite": with_entry("terms", (0, 1, 0), np.nan),
    "knots no multiple of 12": changed("knots", np.zeros(59)),
    "knots not finite": with_entry("knots", (2, 0), np.inf),
    "first_knot too short": changed("first_knot", np.zeros(2 * N_RUNS - 1, dtype=np.int64)),
    "first_knot below 0": with_entry("first_knot", (0, 0), -1),
    "first_knot past the end": with_entry("first_knot", (0, 0), 5),
    "one knot": with_entry("n_knots", (0, 0), 1),
    "n_knots past the end": with_entry("n_knots", (0, 2), 4),
    "n_knots past the type": with_entry("n_knots", (0, 2), 2**63 - 1),
    "steps below 0": with_entry("steps", 0, -1),
    "stride 0": with_entry("stride", 2, 0),
    "stride too long": changed("stride", np.ones(N_RUNS + 1, dtype=np.int64)),
    "thinning below 0": with_entry("thinning", 0, -1),
    "x too short": changed("x", np.zeros((N_RUNS, N_NODES, 2))),
    "v not finite": with_entry("v", (0, 0, 0), np.nan),
    "no edge": changed("edge", np.zeros(0)),
    "tally too short": changed("tally", np.zeros((N_RUNS, native.N_TALLIES - 1))),
    "clock too short": changed("clock", np.zeros((N_RUNS, native.N_CLOCKS - 1), dtype=np.int64)),
    "clock below 0": with_entry("clock", (0, 0), -1),
    "a sample seen later": with_entry("clock", (0, 1), 1),
    "a sample due before": with_clock(taken=4, seen=2, due=3),
    "a sample due and not taken": with_clock(taken=4, seen=2, due=4),
    "steps past the type": with_entry("steps", 0, 2**63 - 2),
    "samples of other channels": changed("samples", np.zeros((N_RUNS, 2, CHANNELS - 1), dtype=np.float32)),
    "snapshots of other nodes": changed("snapshots", np.zeros((N_RUNS, 2, N_NODES + 1, 3), dtype=np.float32)),
    "last too short": changed("last", np.zeros((N_RUNS, CHANNELS - 1), dtype=np.float32)),
    "no threads": changed("threads", 0),
    "threads below 0": changed("threads", -1),
    "unknown level": changed("level", "sse9"),
}


@pytest.mark.parametrize("case", BAD)
def test_what_does_not_belong_together_is_refused(case):
    given = arguments() | BAD[case]
    with pytest.raises(ValueError, match=r"[a-z]"):
        native.advance_float32(**given)
    assert np.isnan(given["samples"]).all() or case.startswith("samples"), "nothing was run"


def of_other_type(name: str) -> np.ndarray:
    array = arguments()[name]
    return array.astype({"f": np.float16, "i": np.int32}[array.dtype.kind])


def of_other_layout(name: str) -> np.ndarray:
    return np.repeat(arguments()[name], 2, axis=0)[::2]


def read_only(name: str) -> np.ndarray:
    array = arguments()[name]
    array.flags.writeable = False
    return array


OUTPUTS = ("samples", "snapshots", "last", "x", "v", "edge", "tally", "clock")


@pytest.mark.parametrize("name", OUTPUTS)
@pytest.mark.parametrize("spoil", [of_other_type, of_other_layout, read_only])
def test_an_output_that_would_be_filled_in_a_copy_is_refused(name, spoil):
    output = spoil(name)
    before = output.copy()
    with pytest.raises((TypeError, ValueError, BufferError)):
        native.advance_float32(**(arguments() | {name: output}))
    np.testing.assert_array_equal(output, before)


def test_samples_of_the_other_precision_are_refused():
    with pytest.raises(TypeError):
        native.advance_float64(**arguments("float32"))


def test_too_small_an_output_keeps_what_fits():
    given = arguments() | {"samples": np.full((N_RUNS, 1, CHANNELS), np.nan, dtype=np.float32),
                           "snapshots": np.zeros((N_RUNS, 0, N_NODES, 3), dtype=np.float32)}  # fmt: skip
    native.advance_float32(**given)
    assert np.isfinite(given["samples"]).all()


def test_the_longest_stride_does_not_count_past_the_type():
    given = arguments() | with_entry("stride", 1, 2**52 - 1)
    native.advance_float32(**given)
    assert given["clock"][:, 0].tolist() == [4, 4, 4]
    assert np.isnan(given["samples"][1, 1:]).all()


def test_what_is_under_way_may_have_any_state_and_no_step_may_be_asked():
    given = arguments() | with_clock(taken=4, seen=4, due=6) | {"steps": np.array([0, 2, 2])}
    given["x"][1] = np.nan
    native.advance_float32(**given)
    assert given["clock"][:, 0].tolist() == [4, 6, 6]
    assert np.isnan(given["samples"][0]).all()
    assert np.isfinite(given["samples"][2, 0]).all()
