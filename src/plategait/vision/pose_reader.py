"""Reads the poses off each frame, as a clip's first frames teach: how to find its plate, and the object on it."""

from __future__ import annotations

from collections.abc import Iterator

from plategait.errors import InputError
from plategait.vision.frames import Frame
from plategait.vision.object.pose import NO_POSE, Pose
from plategait.vision.object.tracker import ObjectTracker
from plategait.vision.plate.rectified import Grid
from plategait.vision.plate.trouble import NothingSeenError
from plategait.vision.plate.view import PlateView
from plategait.vision.setup import Setup
from plategait.vision.spin import FEWEST_SURE
from plategait.vision.survey import Survey, batches, surveyed, without_picture

# Of a batch of frames, pictures looked at closely.
MOST_PATCHES = 15


class PoseReader:
    """Finds the plate and the object in each frame, as the first frames taught it to.

    Parameters
    ----------
    survey : Survey
        Frames and the plate in them.
    setup : Setup
        How it was filmed.

    Raises
    ------
    InputError
        When the frames show no object, or several.
    """

    def __init__(self, survey: Survey, setup: Setup) -> None:
        self.picture, self.plate = survey.picture, survey.plate
        sure = survey.sure
        spaced = sure[:: max(1, len(sure) // MOST_PATCHES)]
        self.grid = Grid.over(setup.plate_size, spaced[0][1])
        self.allowed = self.grid.mask(self.plate.occupied())
        self.object = ObjectTracker(self.grid, self.allowed)
        if not self.object.learn(setup.object, [self.grid.warp(f, H) for f, H in spaced]):
            raise NothingSeenError(
                "video", "nothing like an object on the plate in its first frames",
                "a clip that begins with the object in view",
                "--object texture, or two markers on it (plategait target)",
            )  # fmt: skip
        if self.object.others:
            raise InputError(
                "video",
                "more than one object on the plate",
                "a clip of a single object",
                "filming one object at a time",
            )

    def read(self, frame: Frame, view: PlateView | None = None) -> tuple[PlateView, dict[str, Pose]]:
        """Plate and poses, by method, in one frame, in which the plate may have been found before."""
        view = view or self.plate.find(frame)
        if view.homography is None:
            lost = NO_POSE._replace(reason=view.reason)
            return view, dict.fromkeys(self.object.methods, lost)
        H = view.homography
        poses = self.object.find(lambda grid: grid.warp(frame, H))
        if view.reason:
            poses = {name: pose._replace(reason=pose.reason or view.reason) for name, pose in poses.items()}
        return view, poses


def learnt(frames: Iterator[Frame], setup: Setup) -> tuple[PoseReader, Survey, list[Frame]]:
    """What the first frames teach that show plate and object: reader, those frames, and those before, without pictures.

    Raises
    ------
    InputError
        When none of those looked at do, with what is wrong with the first ones; when they show several objects or
        another plate than the one told.
    """
    passed: list[Frame] = []
    trouble: NothingSeenError | None = None
    every = batches(frames)
    for batch in every:
        try:
            survey = surveyed(batch, setup)
            reader = PoseReader(survey, setup)
        except NothingSeenError as error:
            trouble = trouble or error
            passed += [without_picture(frame) for frame in batch]
            continue
        if reader.object.markers is None and setup.object == "auto":
            reader, survey = _second_look(reader, survey, next(every, []), setup)
        return reader, survey, passed
    if len(passed) < FEWEST_SURE:
        raise InputError("video", f"frames: {len(passed)}", f"at least {FEWEST_SURE}, and better two seconds of them",
                         "a longer clip")  # fmt: skip
    assert trouble is not None
    raise trouble


def _second_look(reader: PoseReader, survey: Survey, batch: list[Frame], setup: Setup) -> tuple[PoseReader, Survey]:
    """Look at further frames before an object is taken for one without markers: a hand may have lain over them."""
    if not batch:
        return reader, survey
    try:
        later = surveyed(batch, setup)
        other = PoseReader(later, setup)
    except InputError:
        views, other = [reader.plate.find(frame) for frame in batch], reader
    else:
        views = later.views
    better = other if other.object.markers is not None else reader
    return better, Survey(survey.frames + batch, better.plate, survey.views + views)
