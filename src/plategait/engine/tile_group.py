"""Rigid tiles of like sheets, side by side: what they are, where they are, and how they go on."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from copy import deepcopy
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.engine.channels import CHANNELS
from plategait.engine.piece import Piece
from plategait.engine.recording import RunRequest
from plategait.engine.tile_step import Plate, Tiles, Work, step
from plategait.engine.tiles import Pull, TileModel, contact_energy, joint_energy, joint_loss, stable_step
from plategait.model.motion import AXES

Which = NDArray[np.intp]
Counts = NDArray[np.int64]

# Share of a uniform tile's rotary inertia. The bending equation (3.3) has point masses, which tiles cannot have.
ROTARY_INERTIA = 0.25
# Share of the stable step that is taken; half of it moves spin rates by less than 2 % (docs/numerics.md).
SHARE_OF_STABLE_STEP = 0.85


def substeps_of(runs: Sequence[RunRequest]) -> list[int]:
    """Tiles' steps in each step of like runs: those that each needs by itself."""
    longest = SHARE_OF_STABLE_STEP * stable_step(tile_model(runs))
    return [math.ceil(r.scenario.dt / most) for r, most in zip(runs, longest, strict=True)]


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


@dataclass(frozen=True, eq=False)
class Group:
    """Runs of like sheets and steps, after `count` of the tiles' steps.

    Attributes
    ----------
    runs : list of RunRequest
    substeps : int
        Tiles' steps in each of theirs.
    model, plate, tiles
        What they are, what they lie on, where they are.
    tally : _Tally
        What has added up since the last sample.
    before : Pull or None
        What the joints did a step ago.
    count : int
    broken : (runs,) bool array
        Runs that ceased to be finite.
    """

    runs: list[RunRequest]
    substeps: int
    model: TileModel
    plate: Plate
    tiles: Tiles
    tally: _Tally
    before: Pull | None
    count: int
    broken: NDArray[np.bool_]

    @staticmethod
    def begun(runs: list[RunRequest]) -> Group:
        """Runs at their start."""
        n = len(runs)
        return Group(
            runs,
            substeps_of(runs)[0],
            tile_model(runs),
            _plate(runs),
            _start(runs),
            _Tally(n),
            None,
            0,
            np.zeros(n, bool),
        )

    def shows(self, channel: str) -> Array:
        """(runs,) what they show now of a channel; NaN of what adds up, and before the first step."""
        everyone = np.arange(len(self.runs))
        with np.errstate(all="ignore"):
            time = self.count * self.runs[0].scenario.dt / self.substeps
            state = _sample(
                self.model, self.plate, self.runs[0], self.tiles, self.tiles.pull(self.model), time, everyone
            )
        known = channel in state and self.count > 0
        return np.broadcast_to(state[channel] if known else np.nan, len(self.runs)).astype(float)


def advanced(group: Group, steps: int, report: Callable[[float], object]) -> tuple[Group, Piece]:
    """Where a group is some steps later, and what it recorded on the way."""
    runs, model, plate, substeps = group.runs, group.model, group.plate, group.substeps
    tiles, tally, before, n = group.tiles, deepcopy(group.tally), group.before, len(group.runs)
    dt, strides = runs[0].scenario.dt / substeps, np.array([r.stride for r in runs])
    begun, end = group.count, group.count + steps * substeps
    first = begun // substeps // strides + 1 if begun else np.zeros(n, dtype=np.int64)
    most = end // substeps // strides + 1 - first
    samples = np.full((n, int(most.max()), len(CHANNELS)), np.nan)
    thinning = np.array([r.thinning for r in runs])
    pictured = np.array([
        sum(i % t == 0 for i in range(f, f + m)) if t else 0
        for f, m, t in zip(first.tolist(), most.tolist(), thinning.tolist(), strict=True)
    ])  # fmt: skip
    shapes = np.zeros((n, int(pictured.max()), tiles.x.shape[1], 3), dtype=np.float32)
    seen, nobody = np.zeros(n, dtype=int), np.zeros(0, dtype=np.intp)
    with np.errstate(all="ignore"):  # a run that diverges is told by its recording
        for count in range(begun, end + 1):
            time, now = count * dt, count // substeps
            pull = tiles.pull(model)
            if before is not None and count > begun:
                tally.joint_loss += joint_loss(model, before, pull.rates, dt)
            new = count % substeps == 0 and (count > begun or begun == 0)
            due = np.flatnonzero(now % strides == 0) if new else nobody
            if len(due):
                channels = {**_sample(model, plate, runs[0], tiles, pull, time, due), **tally.take(due)}
                rows = np.stack([np.broadcast_to(channels[name], len(due)) for name in CHANNELS], axis=1)
                for row, j in zip(rows, due.tolist(), strict=True):
                    i = now // runs[j].stride
                    samples[j, i - first[j]] = row
                    if runs[j].thinning and i % runs[j].thinning == 0:
                        shapes[j, seen[j]] = tiles.x[..., j].T
                        seen[j] += 1
                report((count - begun) / max(end - begun, 1))
            if count == end:
                break
            across = plate.across(tiles.x, time)
            tiles, work = step(model, plate, tiles, pull, time, dt)
            tally.add(work, across > across.mean(axis=0))
            before = pull
    after = replace(group, tiles=tiles, tally=tally, before=before, count=end)
    return _piece(after, steps, samples, first, most, shapes, pictured)


def _piece(
    group: Group, steps: int, samples: Array, first: Counts, most: Counts, shapes: NDArray[np.float32], pictured: Counts
) -> tuple[Group, Piece]:
    """A group and the piece that it recorded, each run to where it ceased to be finite."""
    runs, dt, n = group.runs, group.runs[0].scenario.dt, len(group.runs)
    stride, thinning = np.array([r.stride for r in runs]), np.array([r.thinning for r in runs])
    positions, velocities = group.tiles.x.transpose(2, 1, 0).copy(), group.tiles.v.transpose(2, 1, 0).copy()
    unsound = [np.flatnonzero(~np.isfinite(samples[j, : most[j]]).all(axis=1)) for j in range(n)]
    written = np.array([int(at[0]) + 1 if len(at) else int(m) for at, m in zip(unsound, most, strict=True)])
    ended = written < most
    broken = group.broken | np.array([len(at) > 0 for at in unsound]) | ~np.isfinite(positions).all(axis=(1, 2))
    begun = group.count // group.substeps - steps
    taken = np.where(ended, (first + written - 1) * stride - begun, steps)
    piece = Piece(
        samples=samples, written=written, first=first, snapshots=shapes, thinning=thinning,
        pictured=np.minimum(pictured, np.where(thinning > 0, -(-written // np.maximum(thinning, 1)), 0)),
        since_sample=np.zeros(n, dtype=np.int64), since_time=np.zeros(n), interval=stride * dt, x=positions,
        v=velocities, dt=np.full(n, dt), steps=taken, stopped=broken,
    )  # fmt: skip
    return replace(group, broken=broken), piece


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
