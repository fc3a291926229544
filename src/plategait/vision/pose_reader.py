"""Reads the poses off each frame, as a clip's first frames teach: how to find its plate, and the object on it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from plategait.arrays import Array, Picture
from plategait.camera.camera import Calibration
from plategait.camera.fiducials import plate_target
from plategait.errors import InputError
from plategait.vision.frames import Frame, open_video
from plategait.vision.lens import scaled_matrix, undistorter
from plategait.vision.object.markers import MarkerTracker, learn_markers
from plategait.vision.object.pose import NO_POSE, Pose
from plategait.vision.object.texture import TextureTracker, learn_object
from plategait.vision.plate.outline import OutlinePlate
from plategait.vision.plate.rectified import Grid
from plategait.vision.plate.swing import focal_of
from plategait.vision.plate.view import FiducialPlate, PlateFinder, PlateView, ScalePlate
from plategait.vision.setup import Setup

# Frames at a clip's start from which its plate, markers and object are learnt, and most bytes of them.
LEARNING_FRAMES, LEARNING_BYTES = 60, 150e6
# Of those, pictures looked at closely, and the least that must show the plate.
MOST_PATCHES, LEAST_PATCHES = 15, 2
# Share of the pictures in which what was learnt as markers must be found again.
LEAST_FOLLOWED = 0.3
# Fewest views of the plate that show the lens's focal length.
LEAST_TILTS = 10


class PoseReader:
    """Finds the plate and the object in each frame, as the first frames taught it to.

    Parameters
    ----------
    source : Path or str
        A video file, or the number of a camera.
    setup : Setup
        How it was filmed.

    Raises
    ------
    InputError
        When it is no video, shows no plate or no object, or shows several objects.
    """

    def __init__(self, source: Path | str, setup: Setup) -> None:
        frames = first_frames(source, setup)
        height, width = frames[0].luma.shape
        self.picture = (width, height)
        self.plate, views = _plate_of(frames, setup, self.picture)
        self.plate.lens = _lens_of(views, setup.calibration, self.picture)
        if self.plate.lens is not None:
            views = [self.plate.find(frame.luma) for frame in frames]
        pairs = zip(frames, views, strict=True)
        sure = [(f, v.homography) for f, v in pairs if v.homography is not None and not v.reason]
        spaced = sure[:: max(1, len(sure) // MOST_PATCHES)]
        self.grid = Grid.over(setup.plate_size, spaced[0][1])
        self.allowed = self.grid.mask(self.plate.occupied())
        self.markers: MarkerTracker | None = None
        self.texture: TextureTracker | None = None
        if self._learn(setup.object, [self.grid.warp(f, H) for f, H in spaced]):
            raise InputError(
                "video",
                "more than one object on the plate",
                "a clip of a single object",
                "filming one object at a time",
            )

    def _learn(self, known_by: str, patches: list[Picture]) -> int:
        """Learn what the object looks like; gives how many others look the same."""
        if known_by in ("auto", "markers"):
            markers = learn_markers(patches, self.grid, self.allowed)
            if markers is not None and self._followed(MarkerTracker(markers), patches) >= LEAST_FOLLOWED:
                self.markers = MarkerTracker(markers)
                return markers.others
        whole = None if known_by == "markers" else learn_object(patches, self.grid, self.allowed)
        if whole is None:
            raise InputError(
                "video", "nothing like an object on the plate in its first frames",
                "a clip that begins with the object in view",
                "--object texture, or two markers on it (plategait target)",
            )  # fmt: skip
        self.texture = TextureTracker(whole)
        return whole.others

    def _followed(self, tracker: MarkerTracker, patches: list[Picture]) -> float:
        """Share of the pictures in which a tracker surely finds its markers."""
        return sum(not tracker.find(p, self.grid, self.allowed).reason for p in patches) / len(patches)

    def read(self, frame: Frame) -> tuple[PlateView, dict[str, Pose]]:
        """Plate and poses, by method, in one frame."""
        view = self.plate.find(frame.luma)
        if view.homography is None:
            lost = NO_POSE._replace(reason=view.reason)
            return view, dict.fromkeys(self.methods, lost)
        if self.markers is not None:
            grid, part = self.grid.part(*self.markers.window)
            patch = grid.warp(frame, view.homography)
            poses = {"markers": self.markers.find(patch, grid, self.allowed[part])}
        else:
            assert self.texture is not None
            patch = self.grid.warp(frame, view.homography)
            poses = dict(zip(self.methods, self.texture.find(patch, self.grid, self.allowed), strict=True))
        if view.reason:
            poses = {name: pose._replace(reason=pose.reason or view.reason) for name, pose in poses.items()}
        return view, poses

    @property
    def methods(self) -> tuple[str, ...]:
        """Ways in which the object's orientation is found."""
        return ("markers",) if self.markers is not None else ("texture", "outline")


def _lens_of(views: list[PlateView], calibration: Calibration | None, picture: tuple[int, int]) -> Array | None:
    """Lens of a calibration, else as the plate's tilt shows it; None where it does not."""
    width, height = picture
    if calibration is not None:
        return scaled_matrix(calibration, width)
    middle = np.array([[1, 0, (width - 1) / 2], [0, 1, (height - 1) / 2], [0, 0, 1.0]])
    centred = [np.linalg.inv(middle) @ v.homography for v in views if v.homography is not None and not v.reason]
    focal = focal_of(np.array(centred), width) if len(centred) >= LEAST_TILTS else None
    return None if focal is None else middle @ np.diag([focal, focal, 1.0])


def first_frames(source: Path | str, setup: Setup) -> list[Frame]:
    """Frames at the start of a clip, undistorted, in memory of their own."""
    frames: list[Frame] = []
    with open_video(source, fps=setup.fps, seconds=setup.seconds) as video:
        undistorted = undistorter(setup.calibration, video.width, video.height)
        most = max(8, min(LEARNING_FRAMES, int(LEARNING_BYTES / (1.5 * video.width * video.height))))
        for frame in video.frames():
            f = undistorted(frame)
            frames.append(Frame(f.index, f.time, f.luma.copy(), (f.chroma[0].copy(), f.chroma[1].copy())))
            if len(frames) == most:
                break
    return frames


def _plate_of(frames: list[Frame], setup: Setup, picture: tuple[int, int]) -> tuple[PlateFinder, list[PlateView]]:
    """First way of finding the plate that works on these frames, and its views."""
    makers: dict[str, Callable[[], PlateFinder]] = {
        "fiducials": lambda: FiducialPlate(plate_target(*setup.plate_size, setup.fiducial_side)),
        "scale": lambda: ScalePlate(setup.scale or 1.0, picture, setup.plate_size),
        "outline": lambda: OutlinePlate(setup.plate_size),
    }
    ways = ("fiducials", "scale" if setup.scale else "outline") if setup.plate == "auto" else (setup.plate,)
    for way in ways:
        try:
            finder = makers[way]()
        except InputError:
            if setup.plate != "auto":
                raise
            continue
        views = [finder.find(frame.luma) for frame in frames]
        # The first frames taught it where to look.
        if sum(not v.reason for v in views) >= min(LEAST_PATCHES, len(frames)):
            return finder, views
        if sum("fit together" in v.reason for v in views) > len(frames) // 2:
            length, width = (f"{1e3 * s:.4g}" for s in setup.plate_size)
            raise InputError(
                "--plate-size", f"{length} x {width} mm with fiducials of {1e3 * setup.fiducial_side:.4g} mm",
                "the plate and the fiducials that the clip shows", "the sizes printed on the plate's target",
            )  # fmt: skip
    raise InputError(
        "video", f"nothing like a plate ({' or '.join(ways)}) in its first frames", "a clip that shows the whole plate",
        '--scale "0.2 mm" for a camera straight above, or print fiducials with plategait target',
    )  # fmt: skip
