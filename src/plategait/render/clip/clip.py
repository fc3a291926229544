"""Synthetic films: what an ordinary camera would see of a simulated run, with the truth beside it."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.camera.camera import Camera
from plategait.camera.writer import SUFFIXES, Schedule, film_file, schedule
from plategait.errors import InputError
from plategait.files.output import check_writable, whole_file
from plategait.model.scenario import Scenario
from plategait.render.clip.look import Look
from plategait.render.clip.scene import Scene
from plategait.render.clip.studio import Studio, covered_frames
from plategait.render.clip.truth import Truth, truth_path
from plategait.render.shots import Shots
from plategait.simulation import observables
from plategait.simulation.result import Simulation

__all__ = ["Studio", "Truth", "covered_frames", "film", "truth_path", "usual_camera"]


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
        seen, depth = camera.project_with_depth(corners)
        if (
            depth.min() > 0
            and (np.abs(seen - np.array([width, height]) / 2) * 2 <= np.array([width, height]) * _FILLED).all()
        ):
            return camera
        distance *= 1.03


def film(
    simulation: Simulation,
    path: Path | str,
    camera: Camera | None = None,
    fps: float = 30.0,
    look: Look | None = None,
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
    look : Look, optional
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
    look = look or Look()
    scenario, recording = simulation.scenario, simulation.recordings[run]
    if not 1 <= fps <= 10_000:
        raise InputError("fps", fps, "from 1 to 10000", "30")
    check_writable(path, SUFFIXES)
    shots = Shots.of(scenario, recording, 0)
    start = scenario.measured_from if start is None else start
    end = float(shots.time[-1])
    longest = end - start
    seconds = longest if seconds is None else seconds
    if not (shots.time[0] <= start < end and 1 / fps <= seconds <= longest + 1e-6):
        raise InputError("seconds", f"{seconds:g} s from {start:g} s", f"within the run, which has shapes from "
                         f"{shots.time[0]:g} s to {end:g} s", f"start=0, seconds={0.9 * end:.3g}")  # fmt: skip
    camera = camera or usual_camera(scenario, distortion=look.distortion)
    if camera.width % 2 or camera.height % 2:
        raise InputError("camera", f"{camera.width} x {camera.height}", "even numbers of pixels", "1280 x 720")
    times = schedule(seconds, fps, jitter=look.jitter, drop=look.drop, duplicate=look.duplicate, seed=look.seed)
    studio = Studio(scenario, shots, camera, look, look.exposure / fps)
    covered = covered_frames(len(times.time), look.hidden, look.seed)
    shares = np.zeros((len(times.time), 2))
    picture: NDArray[np.uint8] | None = None
    # Both are there in the end, or neither.
    with (
        whole_file(truth_path(path), (".csv",)) as beside,
        film_file(path, (camera.width, camera.height), fps, look.crf) as file,
    ):
        for k, (stamp, moment) in enumerate(zip(times.time, times.pictured, strict=True)):
            if picture is None or stamp == moment:
                picture, shares[k] = studio.picture(start + moment, covered[k])
            else:
                shares[k] = shares[k - 1]
            file.add(picture, stamp)
            if progress is not None:
                progress((k + 1) / len(times.time))
        truth = _truth(simulation, run, studio, times, start, shares)
        truth.write_rows(beside)
    return truth


def _truth(simulation: Simulation, run: int, studio: Studio, times: Schedule, start: float, shares: Array) -> Truth:
    scenario, recording = simulation.scenario, simulation.recordings[run]
    scene, shots, moments = studio.scene, studio.shots, start + times.time
    nodes, pose = shots.at(moments)
    frames = [scene.sheet_frame(n, p) for n, p in zip(nodes, pose, strict=True)]
    markers = [studio.markers(n, p) for n, p in zip(nodes, pose, strict=True)]
    centres = np.array([centre for _, centre in frames])
    samples = recording.channels["time"]
    turned = observables.rotation(recording.channels["spin_cross"], recording.channels["spin_dot"])
    about = np.interp(moments, samples, turned)

    def unwrapped(directions: Array, near: Array) -> Array:
        return near + (directions - near + np.pi) % (2 * np.pi) - np.pi

    angle = unwrapped(np.array([a for a, _ in frames]), about)
    end = float(moments[-1])
    return Truth(
        time=times.time,
        angle=angle,
        x=centres[:, 0],
        y=centres[:, 1],
        marker_angle=unwrapped(np.array([a for _, a in markers]), angle),
        plate_pose=pose,
        marker_pixels=studio.camera.project(np.array([m for m, _ in markers])),
        marker_share=shares,
        duplicate=times.duplicate,
        spin=observables.spin_rate(samples, turned, scenario.motion.period, start, end),
        started=start,
        camera=studio.camera,
        target=scene.target,
    )
