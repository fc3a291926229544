"""The reference engine behind the contract of all engines: runs in, recordings of rigid tiles out.

Double precision, one core, hundreds of times slower than the native engine: a second opinion on a few runs.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.engine.channels import CHANNELS
from plategait.engine.memory import check_memory
from plategait.engine.recording import Recording, RunRequest
from plategait.engine.tile_step import Plate, Tiles, Work, step
from plategait.engine.tiles import Pull, TileModel, contact_energy, joint_energy, joint_loss, stable_step
from plategait.errors import InputError
from plategait.model.motion import AXES

Which = NDArray[np.intp]

# Share of a uniform tile's rotary inertia. The bending equation (3.3) has point masses, which tiles cannot have.
ROTARY_INERTIA = 0.25
# Share of the stable step that is taken; half of it moves spin rates by less than 2 % (docs/numerics.md).
SHARE_OF_STABLE_STEP = 0.85


def run(
    runs: Sequence[RunRequest], *, threads: int | None = None, progress: Callable[[float], object] | None = None
) -> list[Recording]:
    """Advance runs, those of like sheets and steps side by side.

    Parameters
    ----------
    runs : sequence of RunRequest
        On a plate without end that moves by (4.1) and (4.2). Tiles start level.
    threads : int, optional
        Cores to use at most; this engine uses one.
    progress : callable, optional
        Called with the fraction done at every sample; whatever it raises stops the runs.

    Raises
    ------
    InputError
        For what tiles cannot do, or runs that need more memory than there is.
    """
    for r in runs:
        _check(r)
    check_memory(runs, 8 * len(CHANNELS), len(CHANNELS))
    groups = _groups(runs)
    recordings: dict[int, Recording] = {}
    total, done = float(sum(r.steps for r in runs)), 0.0
    for substeps, group in groups:
        members = [runs[i] for i in group]
        share = sum(r.steps for r in members) / total

        def report(fraction: float, done: float = done, share: float = share) -> None:
            if progress is not None:
                progress(min(done + share * fraction, 1.0))

        recordings.update(zip(group, _advance(members, substeps, report), strict=True))
        done += share
    return [recordings[i] for i in range(len(runs))]


def _check(run: RunRequest) -> None:
    """Refuse what tiles cannot do."""
    motion, ratio = run.scenario.motion, run.scenario.sheet.shear_ratio
    for field, asked, got, allowed in (
        ("plate", run.scenario.plate is not None, "a plate that ends", "one without end"),
        ("motion.waves", bool(motion.waves), f"{len(motion.waves)} further sines", "none beside (4.1) and (4.2)"),
        ("motion.samples", motion.samples is not None, "a sampled trajectory", "the sines of (4.1) and (4.2)"),
        ("sheet.shear_ratio", ratio != 1, ratio, "1, as rigid tiles do not shear,"),
        ("held", run.held is not None, "held nodes", "a free sheet"),
        ("sheet", len(run.lattice.rest) > 1 and not len(run.lattice.axial_edges), "tiles that share no edge", "joints"),
    ):
        if asked:
            raise InputError(field, got, f'{allowed} for the engine "tiles"', 'the engine "cpu"')


def _shared(run: RunRequest) -> tuple[object, ...]:
    """What the runs of a batch have in common."""
    s = run.scenario
    friction = (s.friction.transition_speed, s.friction.kinetic_speed_ratio, s.friction.law)
    sheet = (run.lattice.key, s.sheet.pitch, s.sheet.thickness, s.sheet.node_mass)
    return (*sheet, s.contact.damping_ramp, s.motion.height, s.motion.ramp, s.gravity, *friction, run.steps, s.dt)


def _groups(runs: Sequence[RunRequest]) -> list[tuple[int, list[int]]]:
    """Runs that are advanced together, with the tiles' steps in each of theirs: those that each needs by itself."""
    alike: dict[tuple[object, ...], list[int]] = {}
    for i, r in enumerate(runs):
        alike.setdefault(_shared(r), []).append(i)
    groups: dict[tuple[int, tuple[object, ...]], list[int]] = {}
    for shared, members in alike.items():
        longest = SHARE_OF_STABLE_STEP * stable_step(tile_model([runs[i] for i in members]))
        for i, most in zip(members, longest, strict=True):
            groups.setdefault((math.ceil(runs[i].scenario.dt / most), shared), []).append(i)
    return [(substeps, group) for (substeps, _), group in groups.items()]


def tile_model(runs: Sequence[RunRequest]) -> TileModel:
    """Tiles of like sheets, their coefficients one for each run."""
    scenarios, first = [r.scenario for r in runs], runs[0].scenario
    sheets = [s.sheet for s in scenarios]
    share = np.array([s.sheet.pitch**2 / s.contact.tile_area for s in scenarios])

    def of_sheets(name: str) -> Array:
        return np.array([getattr(sheet, name) for sheet in sheets])

    return TileModel(
        runs[0].lattice.rest, runs[0].lattice.axial_edges, pitch=first.sheet.pitch, thickness=first.sheet.thickness,
        node_mass=first.sheet.node_mass,
        k_c=of_sheets("axial_stiffness"), c_c=of_sheets("axial_damping"),
        k_b=of_sheets("bending_stiffness"), c_b=of_sheets("bending_damping"),
        k_t=of_sheets("torsion_stiffness"), c_t=of_sheets("torsion_damping"),
        k_contact=share * [1e-3 * s.contact.stiffness for s in scenarios],  # force at 1 mm, as (3.1) counts
        c_contact=share * [s.contact.damping for s in scenarios],
        contact_ramp=first.contact.damping_ramp, rotary_inertia=ROTARY_INERTIA,
    )  # fmt: skip


def _plate(runs: Sequence[RunRequest]) -> Plate:
    motions, frictions, first = [r.scenario.motion for r in runs], [r.scenario.friction for r in runs], runs[0].scenario
    return Plate(
        angle=np.array([m.angle for m in motions]), stroke=np.array([m.stroke for m in motions]),
        omega=2 * math.pi * np.array([m.frequency for m in motions]),
        mu_s=np.array([f.static for f in frictions]), mu_k=np.array([f.kinetic for f in frictions]),
        ramp=first.motion.ramp, height=first.motion.height, gravity=first.gravity,
        V=first.friction.transition_speed, ratio=first.friction.kinetic_speed_ratio, law=first.friction.law,
    )  # fmt: skip


def _start(runs: Sequence[RunRequest]) -> Tiles:
    """Level tiles, turned as the sheet is."""
    x, v = (np.stack(vectors, axis=-1).swapaxes(0, 1) for vectors in zip(*(r.start() for r in runs), strict=True))
    half = np.array([0.5 * (r.scenario.start.angle + r.offset[2]) for r in runs])
    q = np.zeros((4, *x.shape[1:]))
    q[0], q[3] = np.cos(half), np.sin(half)
    return Tiles(np.ascontiguousarray(x), np.ascontiguousarray(v), q, np.zeros_like(x))


class _Tally:
    """What adds up between two samples: (runs,) arrays."""

    def __init__(self, n: int) -> None:
        self.steps = np.zeros(n)
        self.left, self.right, self.flight, self.contact = np.zeros((4, n))
        self.joint_loss, self.contact_work, self.friction_loss, self.plate_work = np.zeros((4, n))

    def add(self, work: Work, left: NDArray[np.bool_]) -> None:
        """Count a step, in which the tiles on the `left` half are as told."""
        on_left = np.any(work.touched & left, axis=0)
        on_right = np.any(work.touched & ~left, axis=0)
        self.steps += 1
        self.left += on_left
        self.right += on_right
        self.flight += ~(on_left | on_right)
        self.contact += work.touched.mean(axis=0)
        self.contact_work += work.contact
        self.friction_loss += work.friction
        self.plate_work += work.plate

    def take(self, due: Which) -> dict[str, Array]:
        """Channels of the runs that are sampled, which then begin anew."""
        steps = np.maximum(self.steps[due], 1)
        shares = {"left_contact": self.left, "right_contact": self.right, "flight": self.flight}
        shares["contact"] = self.contact
        amounts = {name: getattr(self, name) for name in ("joint_loss", "contact_work", "friction_loss", "plate_work")}
        taken = {n: a[due] / steps for n, a in shares.items()} | {n: a[due] for n, a in amounts.items()}
        for counted in (self.steps, *shares.values(), *amounts.values()):
            counted[due] = 0
        return taken


def _advance(runs: Sequence[RunRequest], substeps: int, report: Callable[[float], object]) -> list[Recording]:
    model, plate, tiles, first = tile_model(runs), _plate(runs), _start(runs), runs[0]
    dt, strides = first.scenario.dt / substeps, np.array([r.stride for r in runs])
    samples = [np.full((r.samples, len(CHANNELS)), np.nan) for r in runs]
    shapes = [np.zeros((r.pictures, r.lattice.n_nodes, 3), dtype=np.float32) for r in runs]
    tally, before, nobody = _Tally(len(runs)), None, np.zeros(0, dtype=np.intp)
    with np.errstate(all="ignore"):  # a run that diverges is told by its recording
        for count in range(first.steps * substeps + 1):
            time, now = count * dt, count // substeps
            pull = tiles.pull(model)
            if before is not None:
                tally.joint_loss += joint_loss(model, before, pull.rates, dt)
            due = np.flatnonzero(now % strides == 0) if count % substeps == 0 else nobody
            if len(due):
                channels = {**_sample(model, plate, runs[0], tiles, pull, time, due), **tally.take(due)}
                rows = np.stack([np.broadcast_to(channels[name], len(due)) for name in CHANNELS], axis=1)
                for row, j in zip(rows, due.tolist(), strict=True):
                    i = now // runs[j].stride
                    samples[j][i] = row
                    if runs[j].thinning and i % runs[j].thinning == 0:
                        shapes[j][i // runs[j].thinning] = tiles.x[..., j].T
                report(now / first.steps)
            if now == first.steps:
                break
            across = plate.across(tiles.x, time)
            tiles, work = step(model, plate, tiles, pull, time, dt)
            tally.add(work, across > across.mean(axis=0))
            before = pull
    return [_recording(r, samples[j], shapes[j], tiles, j) for j, r in enumerate(runs)]


def _in_plate(plate: Plate, x: Array, time: float) -> Array:
    """(3, n, runs) places in the plate frame, above its surface."""
    angle, shift, _, _ = plate.pose(time)
    sine, cosine, z = np.sin(angle), np.cos(angle), x[2] + plate.height
    return np.stack([x[0] - shift, plate.across(x, time), cosine * z - sine * x[1] - plate.height])


def _sample(
    model: TileModel, plate: Plate, run: RunRequest, tiles: Tiles, pull: Pull, time: float, due: Which
) -> dict[str, Array | float]:
    """State of the runs that are sampled, by channel."""
    angle, shift, _, _ = plate.pose(time)
    p = _in_plate(plate, tiles.x, time)
    x0, y0 = (run.lattice.rest.T * model.pitch)[..., None]
    corners = p[:, run.lattice.cells.reshape(-1, 4).T]  # (3, corner, cells, runs)
    area = np.cross(corners[:, 3] - corners[:, 0], corners[:, 2] - corners[:, 1], axis=0).sum(axis=1)
    area /= 2 * max(corners.shape[2], 1) * model.pitch**2
    (I_x, I_z), turning = model.inertia, (tiles.w * tiles.axes[2]).sum(axis=0)
    kinetic = model.node_mass * (tiles.v**2).sum(axis=0) + I_x * (tiles.w**2).sum(axis=0) + (I_z - I_x) * turning**2
    axial, bending, torsion = joint_energy(model, pull)
    state: dict[str, Array] = {
        "centre_x": p[0].mean(axis=0), "centre_y": p[1].mean(axis=0), "centre_z": p[2].mean(axis=0),
        "spin_cross": (x0 * p[1] - y0 * p[0]).sum(axis=0), "spin_dot": (x0 * p[0] + y0 * p[1]).sum(axis=0),
        "area_x": area[0], "area_y": area[1], "area_z": area[2],
        "bend_rms": np.sqrt((pull.bend**2).mean(axis=0)) if len(pull.bend) else np.zeros_like(angle),
        "height_low": p[2].min(axis=0), "height_high": p[2].max(axis=0),
        "kinetic_energy": 0.5 * kinetic.sum(axis=0), "axial_energy": axial, "bending_energy": bending,
        "torsion_energy": torsion, "gravity_energy": model.node_mass * plate.gravity * tiles.x[2].sum(axis=0),
        "contact_energy": contact_energy(model, -p[2]).sum(axis=0), "plate_x": shift, "plate_rx": angle,
    }  # fmt: skip
    still = dict.fromkeys((f"plate_{axis}" for axis in AXES if axis not in ("x", "rx")), 0.0)
    return {"time": time, **still, **{name: values[due] for name, values in state.items()}}


def _recording(run: RunRequest, samples: Array, shapes: np.ndarray, tiles: Tiles, j: int) -> Recording:
    """Recording of a run, to where it ceased to be finite."""
    broken = np.flatnonzero(~np.isfinite(samples).all(axis=1))
    n_samples = int(broken[0]) + 1 if len(broken) else len(samples)
    channels: dict[str, Array] = {name: samples[:n_samples, c] for c, name in enumerate(CHANNELS)}
    channels["time"] = np.arange(n_samples, dtype=np.float64) * (run.stride * run.scenario.dt)
    every = slice(0, None, max(1, run.thinning))
    n_snapshots = (n_samples - 1) // run.thinning + 1 if run.thinning else 0
    pose = np.stack([channels[f"plate_{axis}"] for axis in AXES], axis=1)
    positions, velocities = tiles.x[..., j].T.copy(), tiles.v[..., j].T.copy()
    return Recording(
        channels=channels, snapshot_time=channels["time"][every][:n_snapshots], snapshots=shapes[:n_snapshots],
        plate_pose=pose[every][:n_snapshots], positions=positions, velocities=velocities, dt=run.scenario.dt,
        steps=(n_samples - 1) * run.stride if len(broken) else run.steps,
        diverged=bool(len(broken)) or not np.isfinite(positions).all(),
    )  # fmt: skip
