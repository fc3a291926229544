"""Synthetic films: what an ordinary camera would see of a simulated run, with the truth beside it."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np

from plategait.arrays import Array, Picture
from plategait.camera.camera import Camera
from plategait.camera.writer import SUFFIXES, FilmWriter, Schedule, film_file, schedule
from plategait.errors import InputError
from plategait.files.output import check_writable, whole_file
from plategait.model.scenario import Scenario
from plategait.render.clip.appearance import Appearance
from plategait.render.clip.scene import Scene
from plategait.render.clip.synthetic_camera import SyntheticCamera, occlusions
from plategait.render.clip.truth import Truth, truth_of, truth_path
from plategait.render.snapshots import Snapshots
from plategait.simulation.result import Simulation

__all__ = ["SyntheticCamera", "Truth", "film", "occlusions", "truth_path", "usual_camera"]


_FIELD_OF_VIEW, _ELEVATION, _AZIMUTH = math.radians(26), math.radians(58), math.radians(-12)
_FILLED = 0.92  # share of the picture that the plate takes at most


def usual_camera(
    scenario: Scenario,
    width: int = 1280,
    height: int = 720,
    *,
    elevation: float = _ELEVATION,
    azimuth: float = _AZIMUTH,
    distortion: tuple[float, ...] = (),
) -> Camera:
    """Stand where the plate just fills the picture, with room for its motion.

    Parameters
    ----------
    width, height : int
        px.
    elevation, azimuth : float
        Of the camera above the plate and to the side of the bar's free end, rad; an elevation of pi/2 looks straight
        down.
    distortion : tuple of float
        See `Calibration`.
    """
    size = Scene.plate_size(scenario)
    corners = np.array([[sx * size[0] / 2, sy * size[1] / 2, 0] for sx in (-1, 1) for sy in (-1, 1)])
    direction = np.array(
        [math.cos(elevation) * math.cos(azimuth), math.cos(elevation) * math.sin(azimuth), math.sin(elevation)]
    )
    away = np.array([-math.cos(azimuth), -math.sin(azimuth), 0.0])
    distance = max(size)
    while True:
        # The world's vertical lies in the picture's, also for a camera that looks straight down.
        eye = distance * direction
        camera = Camera.looking_at(eye, (0, 0, 0), width, height, _FIELD_OF_VIEW, distortion, up=(*away[:2], 1e-3))
        pixels, depth = camera.project_with_depth(corners)
        if (
            depth.min() > 0
            and (np.abs(pixels - np.array([width, height]) / 2) * 2 <= np.array([width, height]) * _FILLED).all()
        ):
            return camera
        distance *= 1.03


def film(
    simulation: Simulation,
    path: Path | str,
    camera: Camera | None = None,
    fps: float = 30.0,
    appearance: Appearance | None = None,
    *,
    start: float | None = None,
    seconds: float | None = None,
    run: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Truth:
    """Film a simulated run as an ordinary camera would see it, and write the truth beside the film.

    Parameters
    ----------
    simulation : Simulation
        With snapshots: ``simulate(scenario, snapshot_interval=scenario.motion.period / 24)``.
    path : Path or str
        File to write, ending in .mp4, .mkv or .mov: clip.mp4. The truth goes to clip.truth.csv.
    camera : Camera, optional
        By default one that the plate fills, at 1280 x 720.
    fps : float
        Frames per second.
    appearance : Appearance, optional
    start : float, optional
        Time of the run at which the film starts, s; by default when the run is taken to have settled.
    seconds : float, optional
        Length of the film; by default to the end of the run.
    run : int
        Which run of an ensemble.
    progress : callable, optional
        Called with the fraction done.

    Returns
    -------
    Truth

    Raises
    ------
    InputError
        For a run without snapshots or with too few, a time outside it, or a file that cannot be written.
    """
    appearance = appearance or Appearance()
    scenario, recording = simulation.scenario, simulation.recordings[run]
    if not 1 <= fps <= 10_000:
        raise InputError("fps", fps, "from 1 to 10000", "30")
    check_writable(path, SUFFIXES)
    snapshots = Snapshots.of(scenario, recording, 0)
    start = scenario.measured_from if start is None else start
    seconds = _length(snapshots, start, seconds, fps)
    camera = camera or usual_camera(scenario, distortion=appearance.distortion)
    if camera.width % 2 or camera.height % 2:
        raise InputError("camera", f"{camera.width} x {camera.height}", "even numbers of pixels", "1280 x 720")
    times = schedule(
        seconds, fps, jitter=appearance.jitter, drop=appearance.drop, duplicate=appearance.duplicate,
        seed=appearance.seed,
    )  # fmt: skip
    filming = SyntheticCamera(scenario, snapshots, camera, appearance, appearance.exposure / fps)
    # Both are there in the end, or neither.
    with (
        whole_file(truth_path(path), (".csv",)) as beside,
        film_file(path, (camera.width, camera.height), fps, appearance.crf) as file,
    ):
        shares = _take_frames(filming, times, start, file, progress)
        truth = truth_of(filming, recording, times, start, shares)
        truth.write_rows(beside)
    return truth


def _length(snapshots: Snapshots, start: float, seconds: float | None, fps: float) -> float:
    """Length of the film, s, as asked or to the end of the run, which it must lie within."""
    first, end = float(snapshots.time[0]), float(snapshots.time[-1])
    longest = end - start
    seconds = longest if seconds is None else seconds
    if not (first <= start < end and 1 / fps <= seconds <= longest + 1e-6):
        raise InputError("seconds", f"{seconds:g} s from {start:g} s", f"within the run, which has shapes from "
                         f"{first:g} s to {end:g} s", f"start=0, seconds={0.9 * end:.3g}")  # fmt: skip
    return seconds


def _take_frames(
    filming: SyntheticCamera,
    times: Schedule,
    start: float,
    file: FilmWriter,
    progress: Callable[[float], object] | None,
) -> Array:
    """Write all frames; gives how much of each marker they show, (n, 2)."""
    appearance, n = filming.appearance, len(times.time)
    occluders = occlusions(n, appearance.hidden, appearance.seed)
    shares = np.zeros((n, 2))
    picture: Picture | None = None
    for k, (stamp, moment) in enumerate(zip(times.time, times.pictured, strict=True)):
        if picture is None or stamp == moment:
            picture, shares[k] = filming.picture(start + moment, occluders[k])
        else:
            shares[k] = shares[k - 1]
        file.add(picture, stamp)
        if progress is not None:
            progress((k + 1) / n)
    return shares
