"""What an engine takes and gives back: plain arrays, the same for every engine."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from plategait.model.lattice import Lattice
from plategait.model.motion import PlateMotion, rotation_of
from plategait.model.scenario import Scenario
from plategait.shown import Shown

# A plate period holds this many samples, and none is further from the next than the longest interval.
SAMPLES_PER_PERIOD = 24
LONGEST_SAMPLE_INTERVAL = 2e-3


@dataclass(frozen=True, eq=False, repr=False)
class RunRequest(Shown):
    """One run to make: a scenario, and how its start differs from the nominal one.

    Attributes
    ----------
    offset : (x, y, angle)
        Added to the scenario's start, m and rad.
    snapshot_interval : float
        Time between recorded shapes, s; 0 records none.
    sample_interval : float
        Time between samples, s; 0 for what a plate period asks for.
    initial : (positions, velocities), optional
        Each (n_nodes, 3), m and m/s: start from there instead, in the world frame.
    held : (n_nodes,) bool array, optional
        Nodes clamped where they start (cantilevers).
    """

    scenario: Scenario
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0)
    snapshot_interval: float = 0.0
    sample_interval: float = 0.0
    initial: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None
    held: NDArray[np.bool_] | None = None

    @cached_property
    def lattice(self) -> Lattice:
        """Topology of the sheet, with the held nodes marked."""
        lattice = self.scenario.sheet.lattice
        return lattice if self.held is None else Lattice(lattice.occupied, self.held)

    @property
    def steps(self) -> int:
        """Steps to take."""
        return max(1, round(self.scenario.duration / self.scenario.dt))

    @property
    def stride(self) -> int:
        """Steps between samples: at the least the end is sampled."""
        return self.stride_with(self.scenario.motion)

    def stride_with(self, motion: PlateMotion) -> int:
        """Steps between samples while the plate moves otherwise, at the same time step."""
        interval = self.sample_interval or min(LONGEST_SAMPLE_INTERVAL, motion.period / SAMPLES_PER_PERIOD)
        return max(1, min(round(interval / self.scenario.dt), self.steps))

    @property
    def thinning(self) -> int:
        """Samples between snapshots, 0 for none."""
        if self.snapshot_interval <= 0:
            return 0
        return max(1, round(min(self.snapshot_interval / (self.stride * self.scenario.dt), self.samples)))

    @property
    def samples(self) -> int:
        """Samples that a run to the end leaves."""
        return self.steps // self.stride + 1

    @property
    def pictures(self) -> int:
        """Snapshots that a run to the end leaves."""
        return (self.samples - 1) // self.thinning + 1 if self.thinning else 0

    def start(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Node positions and velocities at the start: at rest, flat on the plate, which carries the weight."""
        if self.initial is not None:
            return self.initial
        s = self.scenario
        x, y, angle = (a + b for a, b in zip((s.start.x, s.start.y, s.start.angle), self.offset, strict=True))
        rest = self.lattice.rest * s.sheet.pitch
        turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
        depth = s.contact.static_depth(s.sheet.node_mass, s.sheet.pitch, s.gravity)
        laid = np.column_stack([rest @ turn + (x, y), np.full(len(rest), -depth)])
        pose, height = s.motion.pose_at_start(), (0.0, 0.0, s.motion.height)
        positions = (laid + height) @ rotation_of(pose).T - height + pose[:3] if pose.any() else laid
        return positions, np.zeros_like(positions)


@dataclass(frozen=True, eq=False, repr=False)
class Recording(Shown):
    """What a run left behind.

    Attributes
    ----------
    channels : mapping of str to (n_samples,) array
        Time series by name, SI: those of `plategait.engine.channels`.
    snapshot_time : (n_snapshots,) array
        s.
    snapshots : (n_snapshots, n_nodes, 3) array
        Node positions in the world frame, m.
    plate_pose : (n_snapshots, 6) array
        Plate translations and rotations at the snapshots, m and rad.
    positions, velocities : (n_nodes, 3) arrays
        At the end, m and m/s.
    dt : float
        Time step, s.
    steps : int
        Steps taken; fewer than asked when the run diverged.
    diverged : bool
        Whether the motion, or anything recorded of it, ceased to be finite.
    """

    channels: Mapping[str, NDArray[np.float64]]
    snapshot_time: NDArray[np.float64]
    snapshots: NDArray[np.float32]
    plate_pose: NDArray[np.float64]
    positions: NDArray[np.float64]
    velocities: NDArray[np.float64]
    dt: float
    steps: int
    diverged: bool

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        """One time series by name."""
        return self.channels[name]
