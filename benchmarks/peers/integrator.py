"""MuJoCo as an integrator: this package's own forces, called from C, on point masses that MuJoCo advances."""

from __future__ import annotations

import ctypes
import importlib
import os
import subprocess
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from plategait.engine.packing import lines_of, parameters_of
from plategait.engine.recording import RunRequest
from plategait.model.scenario import Scenario

mujoco, peer = importlib.import_module("mujoco"), importlib.import_module("mujoco.batch")
ROOT = Path(__file__).parents[2]


def _compiled(folder: Path) -> ctypes.CDLL:
    """The forces, compiled for this processor against this MuJoCo."""
    library = folder / "forces.so"
    command = [os.environ.get("CXX", "g++"), "-std=c++20", "-O3", "-march=native", "-shared", "-fPIC",
               f"-I{ROOT / 'native'}", f"-I{Path(str(mujoco.__file__)).parent / 'include'}", "-o", str(library),
               str(Path(__file__).with_name("forces.cpp"))]  # fmt: skip
    subprocess.run(command, check=True)
    return ctypes.CDLL(str(library))


def _model(scenario: Scenario) -> Any:
    slides = "".join(f'<joint type="slide" axis="{axis}"/>' for axis in ("1 0 0", "0 1 0", "0 0 1"))
    mass = f'<inertial pos="0 0 0" mass="{scenario.sheet.node_mass}" diaginertia="1e-9 1e-9 1e-9"/>'
    return mujoco.MjModel.from_xml_string(
        f'<mujoco><size nuserdata="1"/><option timestep="{scenario.dt}" gravity="0 0 {-scenario.gravity}">'
        '<flag constraint="disable"/></option>'
        f"<worldbody>{f'<body>{mass}{slides}</body>' * scenario.sheet.lattice.n_nodes}</worldbody></mujoco>"
    )


def integrate(
    scenarios: Sequence[Scenario], duration: float, folder: Path, threads: int = 0
) -> tuple[float, np.ndarray]:
    """Simulated seconds per second of runs of one lattice and step, and where they end: (runs, nodes, 3), m."""
    import plategait._native as native  # pyright: ignore[reportMissingImports]

    first, told = scenarios[0], [parameters_of(scenario) for scenario in scenarios]
    lattice, lines = first.sheet.lattice, lines_of(first.sheet.lattice)
    starts, nodes = lines["line_start"], lines["line_nodes"]
    rows = np.array([[row[name] for name in native.PARAMETERS] for row in told])
    terms = np.array([[s.motion.stroke, s.motion.angle, s.motion.frequency, s.motion.ramp] for s in scenarios])
    library, pointers = (
        _compiled(folder),
        [array.ctypes.data_as(ctypes.c_void_p) for array in (starts, nodes, rows, terms)],
    )
    library.configure(lattice.n_nodes, len(starts) - 1, len(lattice.axial_lines), *pointers)

    batch = peer.Batch(_model(first), len(scenarios), threads)
    batch.bind("userdata")[:, 0] = np.arange(len(scenarios))
    batch.bind("qpos")[:] = [RunRequest(scenario).start()[0].ravel() for scenario in scenarios]
    steps = round(duration / first.dt)
    before = mujoco.get_mjcb_passive()
    called = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p)(("add_forces", library))
    mujoco.set_mjcb_passive(called)
    try:
        begun = time.perf_counter()
        batch.step(nstep=steps)
        wall = time.perf_counter() - begun
    finally:
        mujoco.set_mjcb_passive(before)
    ends = np.array(batch.bind("qpos")).reshape(len(scenarios), -1, 3)
    return len(scenarios) * steps * first.dt / wall, ends
