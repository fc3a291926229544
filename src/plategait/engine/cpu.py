"""The native engine: packs runs into batches of like lattices and calls the C++ core."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from typing import Literal

import numpy as np
from numpy.typing import NDArray

import plategait._native as _native  # pyright: ignore[reportMissingImports]
from plategait.engine.memory import batch_size, check_memory
from plategait.engine.recording import Recording, RunRequest
from plategait.engine.trajectories import table_step, tables
from plategait.model.lattice import Lattice
from plategait.model.motion import AXES
from plategait.model.scenario import Scenario

Precision = Literal["float32", "float64"]
Progress = Callable[[float], object]

# A plate that never ends, m.
_ENDLESS = 1e9


def core_count() -> int:
    """Cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def instruction_sets() -> list[str]:
    """Instruction sets that this processor and build can run, best first."""
    return list(_native.available_levels())


def run(
    runs: Sequence[RunRequest],
    precision: Precision = "float32",
    *,
    threads: int | None = None,
    instruction_set: str | None = None,
    progress: Progress | None = None,
) -> list[Recording]:
    """Advance runs, those of like lattices side by side.

    Parameters
    ----------
    runs : sequence of RunRequest
        May differ in everything.
    precision : {"float32", "float64"}
        Of the arithmetic.
    threads : int, optional
        Cores to use; all by default. The results are the same bits for any number and any grouping.
    instruction_set : str, optional
        One of `instruction_sets`; the best by default.
    progress : callable, optional
        Called with the fraction done about 20 times a second; whatever it raises stops the runs.

    Raises
    ------
    InputError
        When the runs need more memory than there is.
    KeyboardInterrupt
        When interrupted from the keyboard.
    """
    channels = len(_native.CHANNELS)
    sample_bytes = np.dtype(precision).itemsize * channels
    check_memory(runs, sample_bytes, channels)
    recordings: dict[int, Recording] = {}
    total = float(sum(r.steps for r in runs))
    done = 0.0
    for group in _batches(runs, sample_bytes):
        members = [runs[i] for i in group]
        share = float(sum(r.steps for r in members))

        def report(steps: int, done: float = done, share: float = share) -> None:
            if progress is not None:
                progress(min(done + min(steps, share), total) / total)

        batch = _advance(members, precision, threads or core_count(), instruction_set or instruction_sets()[0], report)
        recordings.update(zip(group, batch, strict=True))
        done += share
    return [recordings[i] for i in range(len(runs))]


def _batches(runs: Sequence[RunRequest], sample_bytes: int) -> list[list[int]]:
    """Indices of the runs that share a lattice, in pieces whose recordings fit in memory."""
    groups: dict[bytes, list[int]] = {}
    for i, r in enumerate(runs):
        groups.setdefault(r.lattice.key, []).append(i)
    batches = []
    for group in groups.values():
        size = batch_size(max(runs[i].samples for i in group), sample_bytes)
        batches += [group[i : i + size] for i in range(0, len(group), size)]
    return batches


def parameters_of(scenario: Scenario) -> dict[str, float]:
    """Every number the core wants of a scenario, by the core's names, SI."""
    sheet, contact, friction, motion = scenario.sheet, scenario.contact, scenario.friction, scenario.motion
    share = sheet.pitch**2 / contact.tile_area
    return {
        "pitch": sheet.pitch,
        "node_mass": sheet.node_mass,
        "axial_stiffness": sheet.axial_stiffness,
        "axial_damping": sheet.axial_damping,
        "shear_ratio": sheet.shear_ratio,
        "bending_stiffness": sheet.bending_stiffness,
        "bending_damping": sheet.bending_damping,
        "torsion_stiffness": sheet.torsion_stiffness,
        "torsion_damping": sheet.torsion_damping,
        "contact_stiffness": contact.stiffness * 1e-3 * share,  # force at 1 mm, as (3.1) counts
        "contact_damping": contact.damping * share,
        "contact_ramp": contact.damping_ramp,
        "static_friction": friction.static,
        "kinetic_friction": friction.kinetic,
        "static_speed": friction.transition_speed,
        "kinetic_speed": friction.transition_speed * friction.kinetic_speed_ratio,
        "smooth_friction": float(friction.law == "adams"),
        "gravity": scenario.gravity,
        "plate_half_length": scenario.plate.length / 2 if scenario.plate else _ENDLESS,
        "plate_half_width": scenario.plate.width / 2 if scenario.plate else _ENDLESS,
        "plate_height": motion.height,
        "ramp_duration": motion.ramp,
        "table_step": table_step(scenario),
        "time_step": scenario.dt,
    }


def _terms(runs: Sequence[RunRequest]) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
    """Sines of every run in shared slots: degree of freedom of each slot, (n_slots, 3, n_runs) numbers."""
    by_run = [r.scenario.motion.terms() for r in runs]
    slots = [d for d in range(len(AXES)) for _ in range(max(sum(t[0] == d for t in terms) for terms in by_run))]
    numbers = np.zeros((len(slots), 3, len(runs)))
    for j, terms in enumerate(by_run):
        free = list(range(len(slots)))
        for dof, *values in terms:
            slot = next(s for s in free if slots[s] == dof)
            free.remove(slot)
            numbers[slot, :, j] = values
    return np.array(slots, dtype=np.int32), numbers


def _lines(lattice: Lattice) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
    lines = lattice.axial_lines + lattice.diagonal_lines
    starts = np.cumsum([0] + [len(line) for line in lines]).astype(np.int32)
    return starts, np.array([node for line in lines for node in line], dtype=np.int32)


def _advance(
    runs: Sequence[RunRequest], precision: Precision, threads: int, level: str, report: Callable[[int], None]
) -> list[Recording]:
    lattice, n = runs[0].lattice, len(runs)
    rows = [parameters_of(r.scenario) for r in runs]
    parameters = np.array([[row[name] for row in rows] for name in _native.PARAMETERS])
    # In the order of the core's `Features`: phases that no run of the batch needs are left out.
    features = [
        any(row["torsion_stiffness"] or row["torsion_damping"] for row in rows),
        any(row["smooth_friction"] for row in rows),
        any(r.scenario.plate is not None for r in runs),
        any(row["contact_ramp"] for row in rows),
    ]
    term_dof, terms = _terms(runs)
    knots, first_knot, n_knots = tables(runs)
    line_start, line_nodes = _lines(lattice)
    steps = np.array([r.steps for r in runs], dtype=np.int64)
    stride = np.array([r.stride for r in runs], dtype=np.int64)
    thinning = np.array([r.thinning for r in runs], dtype=np.int64)
    n_samples, n_snapshots = max(r.samples for r in runs), max(r.pictures for r in runs)
    x0, v0 = (np.stack(vectors).copy(order="C") for vectors in zip(*(r.start() for r in runs), strict=True))
    samples = np.full((n, n_samples, len(_native.CHANNELS)), np.nan, dtype=precision)
    snapshots = np.zeros((n, n_snapshots, lattice.n_nodes, 3), dtype=np.float32)
    x1, v1, steps_done = np.zeros_like(x0), np.zeros_like(x0), np.zeros(n, dtype=np.int64)
    getattr(_native, f"advance_{precision}")(
        line_start=line_start, line_nodes=line_nodes, n_axial_lines=len(lattice.axial_lines), cells=lattice.cells,
        rest=lattice.rest, mobility=lattice.mobility, features=features, parameters=parameters, term_dof=term_dof,
        terms=terms, knots=knots, first_knot=first_knot, n_knots=n_knots, steps=steps, stride=stride, thinning=thinning,
        x0=x0, v0=v0, samples=samples, snapshots=snapshots, x1=x1, v1=v1, steps_done=steps_done, level=level,
        threads=threads, progress=report,
    )  # fmt: skip
    recordings = []
    for j, r in enumerate(runs):
        n_samples = int(steps_done[j] // stride[j] + 1)
        n_snapshots = int((n_samples - 1) // thinning[j] + 1) if thinning[j] else 0
        series = samples[j, :n_samples].astype(np.float64)
        channels = {name: series[:, c] for c, name in enumerate(_native.CHANNELS)}
        # Time counts in steps: the core's own precision does not reach a long run's end.
        channels["time"] = np.arange(n_samples, dtype=np.float64) * (int(stride[j]) * r.scenario.dt)
        pose = np.stack([channels[f"plate_{axis}"] for axis in AXES], axis=1)
        diverged = steps_done[j] < steps[j] or not (np.isfinite(series).all() and np.isfinite(x1[j]).all())
        every = slice(0, None, max(1, int(thinning[j])))
        recordings.append(
            Recording(
                channels=channels, snapshot_time=channels["time"][every][:n_snapshots],
                snapshots=snapshots[j, :n_snapshots], plate_pose=pose[every][:n_snapshots],
                positions=x1[j], velocities=v1[j], dt=r.scenario.dt, steps=int(steps_done[j]), diverged=bool(diverged),
            )
        )  # fmt: skip
    return recordings
