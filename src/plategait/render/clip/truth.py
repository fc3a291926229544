"""What a synthetic film shows, frame by frame."""

from __future__ import annotations

import csv
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from plategait.arrays import Array, Flags
from plategait.camera.camera import Camera
from plategait.camera.fiducials import PlateTarget
from plategait.camera.writer import Schedule
from plategait.engine.recording import Recording
from plategait.files.output import whole_file
from plategait.render.clip.synthetic_camera import SyntheticCamera
from plategait.simulation import observables
from plategait.simulation.observables import SpinRate

# Of a marker that lies flat: as much as must be seen to call it visible.
_VISIBLE = 0.5


@dataclass(frozen=True, eq=False)
class Truth:
    """What a synthetic film shows, frame by frame.

    Parameters
    ----------
    time : (n,) array
        Time stamps of the frames, s from the first: the middle of the exposure.
    angle : (n,) array
        Orientation of the object in plate coordinates, unwrapped, rad: the best-fit rotation of all its nodes.
    x, y : (n,) arrays
        Its centre in plate coordinates, m.
    marker_angle : (n,) array
        Direction from the middle of the centre marker to that of the rim marker, in the plate's plane, unwrapped, rad.
        It swings about `angle` where the object bends.
    plate_pose : (n, 6) array
        Translations (m) and rotations (rad) of the plate.
    marker_pixels : (n, 2, 2) array
        Where the middles of centre and rim marker fall in the picture, px.
    marker_share : (n, 2) array
        How much of each marker the picture shows, over what it would show of one that lies flat.
    duplicate : (n,) bool array
        Whether the frame repeats the picture before. All else here is what the stamped time has.
    spin : SpinRate
        Of the simulated run, over the whole plate periods in the film.
    started : float
        Time of the run at the first frame, s.
    camera : Camera
    target : PlateTarget
        Corner markers, and the plate's size.
    """

    time: Array
    angle: Array
    x: Array
    y: Array
    marker_angle: Array
    plate_pose: Array
    marker_pixels: Array
    marker_share: Array
    duplicate: Flags
    spin: SpinRate
    started: float
    camera: Camera
    target: PlateTarget

    @property
    def visible(self) -> Flags:
        """(n, 2) whether at least half of the centre and the rim marker is seen."""
        return self.marker_share >= _VISIBLE

    def write(self, path: Path | str) -> None:
        """Write one row per frame as CSV, in s, mm, deg and px, whole or not at all."""
        with whole_file(path, (".csv",)) as unfinished:
            self.write_rows(unfinished)

    def write_rows(self, path: Path) -> None:
        """Write the rows of `write` to a file that is published elsewhere."""
        pose = self.plate_pose * ([1e3] * 3 + [180 / math.pi] * 3)
        columns = {
            "time_s": self.time, "angle_deg": np.degrees(self.angle), "x_mm": 1e3 * self.x, "y_mm": 1e3 * self.y,
            "marker_angle_deg": np.degrees(self.marker_angle),
            **{f"plate_{axis}": pose[:, k] for k, axis in enumerate(
                ("x_mm", "y_mm", "z_mm", "rx_deg", "ry_deg", "rz_deg"))},
            "centre_px": self.marker_pixels[:, 0, 0], "centre_py": self.marker_pixels[:, 0, 1],
            "rim_px": self.marker_pixels[:, 1, 0], "rim_py": self.marker_pixels[:, 1, 1],
            "centre_seen": self.marker_share[:, 0], "rim_seen": self.marker_share[:, 1],
            "duplicate": self.duplicate,
        }  # fmt: skip
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(columns)
            writer.writerows([f"{float(v):.7g}" for v in row] for row in zip(*columns.values(), strict=True))


def truth_of(filming: SyntheticCamera, recording: Recording, times: Schedule, start: float, shares: Array) -> Truth:
    """What a camera films of a run at these times, s from `start`; `shares` (n, 2) is how much of each marker."""
    scene, snapshots, moments = filming.scene, filming.snapshots, start + times.time
    nodes, pose = snapshots.at(moments)
    frames = [scene.sheet_frame(n, p) for n, p in zip(nodes, pose, strict=True)]
    markers = [filming.markers(n, p) for n, p in zip(nodes, pose, strict=True)]
    centres = np.array([centre for _, centre in frames])
    samples = recording.channels["time"]
    rotation = observables.rotation(recording.channels["spin_cross"], recording.channels["spin_dot"])
    angle = _unwrapped(np.array([a for a, _ in frames]), np.interp(moments, samples, rotation))
    return Truth(
        time=times.time,
        angle=angle,
        x=centres[:, 0],
        y=centres[:, 1],
        marker_angle=_unwrapped(np.array([a for _, a in markers]), angle),
        plate_pose=pose,
        marker_pixels=filming.camera.project(np.array([m for m, _ in markers])),
        marker_share=shares,
        duplicate=times.duplicate,
        spin=observables.spin_rate(samples, rotation, filming.scenario.motion.period, start, float(moments[-1])),
        started=start,
        camera=filming.camera,
        target=scene.target,
    )


def _unwrapped(directions: Array, near: Array) -> Array:
    """Directions, rad, on the turn that is nearest to others."""
    return near + (directions - near + np.pi) % (2 * np.pi) - np.pi


def truth_path(path: Path | str) -> Path:
    """Name of the file with the truth beside a film: clip.mp4 has clip.truth.csv."""
    return Path(path).with_suffix(".truth.csv")
