"""What was tracked, for people and programs: a film with the pose drawn over it, and a table of poses."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from plategait.files.output import whole_file
from plategait.vision.frames import Frame
from plategait.vision.object.pose import Pose
from plategait.vision.plate.view import PlateView, project
from plategait.vision.velocity import HALF_95, local_velocity

if TYPE_CHECKING:
    from plategait.camera.writer import FilmWriter
    from plategait.vision.track import FrameCallback, Track

# Blue, green, red.
SURE, UNSURE, PLATE = (115, 158, 0), (0, 94, 213), (220, 150, 40)
PAPER, INK = (245, 245, 245), (30, 30, 30)
COLUMNS = ("time_s", "x_mm", "y_mm", "angle_deg", "sure", "reason")
# With half of the 95 % interval: of each frame's surroundings, and of the whole clip.
LOCAL = ("velocity_x_mm_s", "velocity_x_half_mm_s", "velocity_y_mm_s", "velocity_y_half_mm_s", "spin_rate_deg_s",
         "spin_rate_half_deg_s")  # fmt: skip
OF_CLIP = ("radius_mm", "radius_half_mm", "area_mm2", "area_half_mm2", "rim_lift_mm", "rim_lift_half_mm")
# Quality of the film (H.264's constant rate factor), and frames per second where a camera does not tell.
QUALITY, USUAL_FPS = 24, 30.0


@contextmanager
def preview(path: Path | str, size: tuple[float, float], fps: float = USUAL_FPS) -> Iterator[FrameCallback]:
    """Write a film of what is tracked; gives what `plategait.vision.track.track` takes as `follow`.

    Sure poses are green rings, uncertain ones red crosses with the reason; the plate is blue.

    Parameters
    ----------
    path : Path or str
        File to write, ending in .mp4, .mkv or .mov; it appears when it is complete.
    size : (length, width)
        Of the plate, m.
    fps : float
        Frames per second, about: each frame keeps its own time.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    from plategait.camera.writer import film_file

    with ExitStack() as open_files:
        writer: FilmWriter | None = None

        def follow(frame: Frame, view: PlateView, pose: Pose) -> None:
            nonlocal writer
            picture = overlaid(frame, view, pose, size)
            if writer is None:  # the size is known by the first picture
                height, width = picture.shape[:2]
                writer = open_files.enter_context(film_file(path, (width, height), fps, QUALITY))
            writer.add(picture, frame.time)

        yield follow


def overlaid(frame: Frame, view: PlateView, pose: Pose, size: tuple[float, float]) -> NDArray[np.uint8]:
    """(height, width, 3) picture of a frame with the plate's outline, the object's pose, and why it is uncertain."""
    import cv2

    picture = frame.bgr()
    width = max(1, round(picture.shape[0] / 360))
    if view.homography is not None:
        x, y = size[0] / 2, size[1] / 2
        _line(picture, project(view.homography, np.array([[-x, -y], [x, -y], [x, y], [-x, y]])), PLATE, width, True)
        if math.isfinite(pose.x):
            colour = UNSURE if pose.reason else SURE
            middle = np.array([pose.x, pose.y])
            spot = np.round(project(view.homography, middle)).astype(int)
            here = int(spot[0]), int(spot[1])
            if pose.reason:
                cv2.drawMarker(picture, here, colour, cv2.MARKER_TILTED_CROSS, 8 * width, width + 1, cv2.LINE_AA)
            else:
                cv2.circle(picture, here, 3 * width, colour, width + 1, cv2.LINE_AA)
            if math.isfinite(pose.angle):
                tip = middle + 0.3 * min(size) * np.array([math.cos(pose.angle), math.sin(pose.angle)])
                _line(picture, project(view.homography, np.stack([middle, tip])), colour, width + 1, False)
    _write(picture, f"{frame.time:.3f} s   {pose.reason or 'sure'}", UNSURE if pose.reason else INK, width)
    return picture


def _write(picture: NDArray[np.uint8], text: str, colour: tuple[int, int, int], width: int) -> None:
    """Write a line at the foot of a picture, on paper of its own, so that it is read whatever lies behind it."""
    import cv2

    scale, margin, foot = picture.shape[0] / 800, 6 * width, picture.shape[0]
    (length, height), below = cv2.getTextSize(text, cv2.FONT_HERSHEY_SIMPLEX, scale, width)
    top = foot - height - below - 2 * margin
    cv2.rectangle(picture, (0, top), (length + 2 * margin, foot), PAPER, cv2.FILLED)
    cv2.putText(picture, text, (margin, foot - below - margin), cv2.FONT_HERSHEY_SIMPLEX, scale, colour, width,
                cv2.LINE_AA)  # fmt: skip


def _line(
    picture: NDArray[np.uint8], points: NDArray[np.float64], colour: tuple[int, int, int], width: int, closed: bool
) -> None:
    import cv2

    if np.isfinite(points).all() and np.abs(points).max() < 1e5:
        cv2.polylines(picture, [np.round(points).astype(np.int32)], closed, colour, width, cv2.LINE_AA)


def write_poses(track: Track, path: Path | str) -> None:
    """Write one row per frame as CSV: `COLUMNS`, `LOCAL`, `OF_CLIP`; empty where not seen.

    The last ones say the same in each row. The velocities are those around each frame, the plate's swing included.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    found = track.findings
    place = np.where(track.placed[:, None], found.place, math.nan)
    angle = np.where(track.sure, track.angle, math.nan)
    local = [column for line, scale in ((place[:, 0], 1e3), (place[:, 1], 1e3), (angle, math.degrees(1)))
             for column in scale * np.array(local_velocity(track.time, line))]  # fmt: skip
    of_clip = [value for known, scale in ((found.radius, 1e3), (found.area, 1e6), (found.rim_lift, 1e3))
               for value in (scale * known[0], scale * HALF_95 * known[1])]  # fmt: skip
    with (
        whole_file(path, (".csv",), "--out") as unfinished,
        open(unfinished, "w", newline="", encoding="utf-8") as file,
    ):
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([*COLUMNS, *LOCAL, *OF_CLIP])
        numbers = np.stack([track.time, 1e3 * track.x, 1e3 * track.y, np.degrees(track.angle)], axis=1)
        for pose, sure, reason, around in zip(numbers, track.sure, track.reason, np.stack(local, axis=1), strict=True):
            writer.writerow([*map(_cell, pose), int(sure), reason, *map(_cell, around), *map(_cell, of_clip)])


def _cell(value: float) -> str:
    return f"{value:.7g}" if math.isfinite(value) else ""
