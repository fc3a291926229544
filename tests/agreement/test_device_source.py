"""The laws and the step are device code too: NVRTC, which needs no GPU, compiles the very headers of the core."""

from __future__ import annotations

from pathlib import Path

import pytest

NATIVE = Path(__file__).parents[2] / "native"

KERNEL = """
#include "record.hpp"
using namespace plategait;

// One thread, one run: arrays are interleaved over the runs.
extern "C" __global__ void advance_runs(Topology topology, const float* parameters, int n_terms,
                                        const int* layer_terms, const int* term_dof, const Term<float>* terms,
                                        int n_layers, const Layer<float>* layers, const double* knots, float* nodes,
                                        int n_runs, int steps, float* channels) {
  const int run = blockIdx.x * blockDim.x + threadIdx.x;
  if (run >= n_runs) return;
  float parameter[N_PARAMETERS];
  for (int p = 0; p < N_PARAMETERS; p++) parameter[p] = parameters[p * n_runs + run];
  const int vectors = 3 * topology.n_nodes * n_runs;
  const Nodes<float> x = {nodes + run, n_runs}, v = {x.data + vectors, n_runs}, f = {v.data + vectors, n_runs};
  const State<float> state = {x, v, f};
  const Trajectory<float> trajectory = {n_layers, layer_terms, term_dof, terms + run * n_terms,
                                        layers + run * n_layers, knots};
  Tally<float> tally = {};
  for (int step = 0; step < steps; step++)
    advance_one_step(state, topology, parameter, trajectory, step * double(parameter[TIME_STEP]), tally);
  record_sample(state, topology, parameter, trajectory, steps * double(parameter[TIME_STEP]), float(steps), tally,
                channels + run * N_CHANNELS);
}
"""


def test_nvrtc_compiles_the_step():
    nvrtc = pytest.importorskip("cuda.bindings.nvrtc", reason="cuda-bindings is only installed on Linux")
    headers = {p.name: p.read_bytes() for p in NATIVE.glob("*.hpp")}
    names = [n for n in headers if n not in ("lanes.hpp", "batch.hpp", "block.hpp", "run_batch.hpp")]
    status, program = nvrtc.nvrtcCreateProgram(
        KERNEL.encode(), b"kernel.cu", len(names), [headers[n] for n in names], [n.encode() for n in names]
    )
    assert status == nvrtc.nvrtcResult.NVRTC_SUCCESS
    options = [b"--std=c++20", b"--gpu-architecture=compute_80"]
    (status,) = nvrtc.nvrtcCompileProgram(program, len(options), options)
    _, size = nvrtc.nvrtcGetProgramLogSize(program)
    log = b" " * size
    nvrtc.nvrtcGetProgramLog(program, log)
    assert status == nvrtc.nvrtcResult.NVRTC_SUCCESS, log.decode()
    _, size = nvrtc.nvrtcGetPTXSize(program)
    ptx = b" " * size
    nvrtc.nvrtcGetPTX(program, ptx)
    assert b".entry advance_runs" in ptx
    assert b"fma.rn.f32" in ptx, "the physics is in it"
