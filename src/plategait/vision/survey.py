"""What a clip's first frames teach: how its plate is found, and what lens it was filmed with.

Frames are taken a batch at a time, until one of them shows what is looked for; a live camera's are kept and read like
all others.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import islice

import numpy as np

from plategait.arrays import Array
from plategait.camera.camera import Calibration
from plategait.camera.fiducials import plate_target
from plategait.errors import InputError
from plategait.vision.frames import Frame, Video
from plategait.vision.lens import scaled_matrix, undistorter
from plategait.vision.plate.fiducials import FiducialPlate
from plategait.vision.plate.outline import OutlinePlate
from plategait.vision.plate.swing import focal_of
from plategait.vision.plate.trouble import check_size, no_plate
from plategait.vision.plate.view import PlateFinder, PlateView, ScalePlate
from plategait.vision.setup import Setup

# Frames of a batch, and most bytes of them.
LEARNING_FRAMES, LEARNING_BYTES = 60, 150e6
# Batches that are looked at, at most.
MOST_BATCHES = 10
# Fewest pictures of a batch that must show the plate.
LEAST_SURE = 2
# Fewest views of the plate that show the lens's focal length.
LEAST_TILTS = 10


@dataclass(eq=False)
class Survey:
    """A batch of a clip's frames, and the plate in them.

    Attributes
    ----------
    frames : list of Frame
        Without the lens's distortion, in memory of their own.
    plate : PlateFinder
        That has learnt where to look.
    views : list of PlateView
        Of these frames.
    """

    frames: list[Frame]
    plate: PlateFinder
    views: list[PlateView]

    @property
    def picture(self) -> tuple[int, int]:
        """Width and height of the pictures, px."""
        height, width = self.frames[0].luma.shape
        return width, height

    @property
    def sure(self) -> list[tuple[Frame, Array]]:
        """Frames that surely show the plate, and its homography in each."""
        pairs = zip(self.frames, self.views, strict=True)
        return [(f, v.homography) for f, v in pairs if v.homography is not None and not v.reason]


def straight_frames(video: Video, calibration: Calibration | None) -> Iterator[Frame]:
    """Frames of a video as a lens without distortion would have taken them."""
    straight: Callable[[Frame], Frame] | None = None
    for frame in video.frames():
        if straight is None:
            height, width = frame.luma.shape
            straight = undistorter(calibration, width, height)
        yield straight(frame)


def batches(frames: Iterator[Frame]) -> Iterator[list[Frame]]:
    """Frames by the batch, each in memory of its own; not more than are worth looking at."""
    for _ in range(MOST_BATCHES):
        batch = [_kept(frame) for frame in islice(frames, 1)]
        if not batch:
            break
        most = max(8, min(LEARNING_FRAMES, int(LEARNING_BYTES / (1.5 * batch[0].luma.size))))
        yield batch + [_kept(frame) for frame in islice(frames, most - 1)]


def surveyed(batch: list[Frame], setup: Setup) -> Survey:
    """Find the plate in a batch of frames.

    Raises
    ------
    NothingSeenError
        When none shows the plate, with what is wrong with them.
    InputError
        When they show another plate than the one told.
    """
    plate, views = _plate_of(batch, setup)
    survey = Survey(batch, plate, views)
    plate.lens = _lens_of(views, setup.calibration, survey.picture)
    # What the first frames taught helps with those before.
    survey.views = [
        plate.again(view) if not view.reason else plate.find(frame) for frame, view in zip(batch, views, strict=True)
    ]
    return survey


def without_picture(frame: Frame) -> Frame:
    """Give a frame of which only when it was taken and how much changed is kept."""
    nothing = np.zeros((0, 0), np.uint8)
    return replace(frame, luma=nothing, chroma=(nothing, nothing))


def _kept(frame: Frame) -> Frame:
    """Frame in memory of its own: a decoder uses its again."""
    return replace(frame, luma=frame.luma.copy(), chroma=(frame.chroma[0].copy(), frame.chroma[1].copy()))


def _plate_of(frames: list[Frame], setup: Setup) -> tuple[PlateFinder, list[PlateView]]:
    """First way of finding the plate that works on these frames, and its views."""
    height, width = frames[0].luma.shape
    makers: dict[str, Callable[[], PlateFinder]] = {
        "fiducials": lambda: FiducialPlate(plate_target(*setup.plate_size, setup.fiducial_side)),
        "scale": lambda: ScalePlate(setup.scale or 1.0, (width, height), setup.plate_size),
        "outline": lambda: OutlinePlate(setup.plate_size),
    }
    ways = ("fiducials", "scale" if setup.scale else "outline") if setup.plate == "auto" else (setup.plate,)
    fiducials: tuple[FiducialPlate | None, list[PlateView]] = None, []
    outlines: list[PlateView] = []
    for way in ways:
        try:
            finder = makers[way]()
        except InputError:
            if setup.plate != "auto":
                raise
            continue
        views = [finder.find(frame) for frame in frames]
        if isinstance(finder, FiducialPlate):
            fiducials = finder, views
            check_size(views, setup)
        elif isinstance(finder, OutlinePlate):
            outlines = views
        if sum(not v.reason for v in views) >= min(LEAST_SURE, len(frames)):
            return finder, views
    raise no_plate(ways, frames, fiducials[1], outlines, fiducials[0])


def _lens_of(views: list[PlateView], calibration: Calibration | None, picture: tuple[int, int]) -> Array | None:
    """Lens of a calibration, else as the plate's tilt shows it; None where it does not."""
    width, height = picture
    if calibration is not None:
        return scaled_matrix(calibration, width)
    middle = np.array([[1, 0, (width - 1) / 2], [0, 1, (height - 1) / 2], [0, 0, 1.0]])
    centred = [np.linalg.inv(middle) @ v.homography for v in views if v.homography is not None and not v.reason]
    focal = focal_of(np.array(centred), width) if len(centred) >= LEAST_TILTS else None
    return None if focal is None else middle @ np.diag([focal, focal, 1.0])
