"""Three red markers on a strip that sags, from a high-speed film to what `identify bending` reads (section 3.3.2)."""

from __future__ import annotations

import csv
import itertools
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from plategait.arrays import Array, Flags
from plategait.errors import InputError
from plategait.files.output import whole_file
from plategait.theory.two_links import LEAST_ROWS, Angles, angles_of_markers
from plategait.vision.frames import Frame, Video, open_video, repeats

_LEAST_REDNESS = 35.0  # grey levels by which red exceeds green and blue on a marker
_LEAST_PIXELS, _MOST_SPOTS = 6, 12
_ALIKE = 0.25  # of the third largest spot: one that is larger than this share may be a marker too
_EDGE = 4  # px by which a marker's soft edge reaches beyond where it is half as red
_AROUND = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * _EDGE + 1, 2 * _EDGE + 1))
_JUMP = 0.25  # of the strip's length: further than this no marker moves from one frame to the next
_MOVES = 0.5  # px from frame to frame: a strip that moves as fast cannot look the same twice
_STRETCH = 0.15  # by which a link's length may differ from its median
_LARGE_SCATTER = 0.015  # of the swing of phi2
_LEAST_SHARE = 0.5  # of the frames must show all three


@dataclass(frozen=True, eq=False)
class StripTrack:
    """Markers of a strip over time.

    Parameters
    ----------
    time : (n,) array
        s from the first frame.
    pixels : (n, 3, 2) array
        Middles of the markers at wall, joint and tip, x to the right and y upwards from the picture's lower edge, px;
        NaN where they are not sure.
    sure : (n,) bool array
        Whether all three were seen for certain.
    scale : float or None
        Metres of a pixel, where known.
    notes : tuple of str
        What a reader should know.
    """

    time: Array
    pixels: Array
    sure: Flags
    scale: float | None
    notes: tuple[str, ...]

    @property
    def angles(self) -> Angles:
        """Joint angles of the sure frames, as `identify_bending` takes them."""
        return Angles(self.time[self.sure], *angles_of_markers(self.pixels[self.sure]))

    def write(self, path: Path | str) -> Path:
        """Write the sure frames as CSV: time_s and x0, y0 … y2 in mm, or in px where the scale is not known.

        Raises
        ------
        InputError
            When the file cannot be written.
        """
        unit, factor = ("px", 1.0) if self.scale is None else ("mm", 1e3 * self.scale)
        places = factor * self.pixels[self.sure].reshape(-1, 6)
        with whole_file(path, (".csv",)) as unfinished, open(unfinished, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["time_s", *(f"{axis}{i}_{unit}" for i in range(3) for axis in "xy")])
            for time, row in zip(self.time[self.sure], places, strict=True):
                writer.writerow([f"{time:.9g}", *(f"{v:.7g}" for v in row)])
        return Path(path)


def track_cantilever(
    path: Path | str, *, fps: float | None = None, link_length: float | None = None, seconds: float | None = None
) -> StripTrack:
    """Follow three red markers on a strip, from the side.

    The marker at the wall is the end that moves least.

    Parameters
    ----------
    path : Path or str
        Film.
    fps : float, optional
        Pictures per second of the camera, where the file plays them at another rate.
    link_length : float, optional
        Distance between neighbouring markers, m, which gives the scale; angles need none.
    seconds : float, optional
        Part of the film from its start, s.

    Raises
    ------
    InputError
        When it is no film; when fewer than half of the frames, or fewer than 12, show three red markers.
    """
    if link_length is not None and not 0 < link_length < 10:
        raise InputError("--link-length", link_length, "a length above 0, m", "0.01")
    with open_video(path, fps=fps, seconds=seconds) as video:
        time, pixels = _read_markers(video)
        height, notes = video.height, list(video.notes)
    sure = np.asarray(np.isfinite(pixels).all(axis=(1, 2)), dtype=bool)
    _check_enough(path, sure)
    links = np.linalg.norm(np.diff(pixels, axis=1), axis=2)
    usual = np.median(links[sure], axis=0)
    sure &= (np.abs(np.nan_to_num(links) - usual) < _STRETCH * usual).all(axis=1)
    _check_enough(path, sure)
    spread = pixels[sure].std(axis=0).max(axis=1)
    if spread[0] > spread[2]:
        pixels = pixels[:, ::-1]
    notes += _doubts(pixels, links, sure, spread)
    pixels = np.where(sure[:, None, None], pixels, np.nan) * (1, -1) + (0, height - 1)
    scale = None if link_length is None else 2 * link_length / float(usual.sum())
    return StripTrack(time, pixels, sure, scale, tuple(notes))


def _read_markers(video: Video) -> tuple[Array, Array]:
    """Times (n,), s, and markers (n, 3, 2), px with y downwards, in order along the strip; NaN where not certain."""
    times, changes, pixels = [], [], []
    last: Array | None = None
    for frame in video.frames():
        markers = _chain(red_spots(frame), last)
        last = last if markers is None else markers
        times.append(frame.time)
        changes.append(frame.change)
        pixels.append(np.full((3, 2), np.nan) if markers is None else markers)
    places = np.array(pixels)
    places[_repeated(np.array(changes), places)] = np.nan
    return np.array(times), places


def red_spots(frame: Frame) -> list[tuple[float, Array]]:
    """Red spots of a picture, the largest first: how many pixels, and their middle (2,), px with y downwards."""
    blue, green, red = (plane.astype(np.float32) for plane in cv2.split(frame.bgr()))
    # Yellow and brown food must count for as little as grey, or markers would grow towards it.
    redness = np.maximum(red - green - 0.5 * np.abs(green - blue), 0)
    redness = cv2.GaussianBlur(redness, (0, 0), 0.8)
    # Half of what the reddest places have: markers under uneven light are not equally red.
    level = max(_LEAST_REDNESS, 0.5 * float(np.partition(redness.ravel(), -_LEAST_PIXELS * 3)[-_LEAST_PIXELS * 3]))
    count, labels, stats, _ = cv2.connectedComponentsWithStats((redness > level).astype(np.uint8))
    spots = []
    # In a noisy picture there may be thousands, of which the largest matter.
    for k in 1 + np.argsort(-stats[1:count, cv2.CC_STAT_AREA])[:_MOST_SPOTS]:
        left, top, width, height, area = map(int, stats[k])
        if area < _LEAST_PIXELS:
            continue
        # The whole soft edge counts, out to where it is lost in the noise: a middle cut at half height jumps by pixels.
        part = slice(max(0, top - _EDGE), top + height + _EDGE), slice(max(0, left - _EDGE), left + width + _EDGE)
        around = cv2.dilate((labels[part] == k).astype(np.uint8), _AROUND)
        weight = np.maximum(redness[part] - 0.2 * level, 0) * around
        rows, columns = np.indices(weight.shape)
        middle = np.array([(weight * columns).sum(), (weight * rows).sum()]) / weight.sum()
        middle += part[1].start, part[0].start
        spots.append((float(area), middle))
    return sorted(spots, key=lambda spot: -spot[0])


def _chain(spots: list[tuple[float, Array]], last: Array | None) -> Array | None:
    """Three of the spots (3, 2) in the order along the strip, or None where it is not certain which they are."""
    if len(spots) < 3:
        return None
    alike = [middle for area, middle in spots if area > _ALIKE * spots[2][0]]
    if last is None:
        return _in_line(np.array(alike)) if len(alike) == 3 else None
    reach = _JUMP * float(np.linalg.norm(last[2] - last[0]))
    nearest = [min(range(len(alike)), key=lambda k: float(np.linalg.norm(alike[k] - place))) for place in last]
    moved = [float(np.linalg.norm(alike[k] - place)) for k, place in zip(nearest, last, strict=True)]
    return np.array([alike[k] for k in nearest]) if len(set(nearest)) == 3 and max(moved) < reach else None


def _in_line(spots: Array) -> Array:
    """Put three places in order along the line that they make, the ends being furthest apart."""
    first, last = max(
        itertools.combinations(range(3), 2), key=lambda pair: float(np.linalg.norm(spots[pair[0]] - spots[pair[1]]))
    )
    return spots[[first, 3 - first - last, last]]


def _doubts(pixels: Array, links: Array, sure: Flags, spread: Array) -> list[str]:
    """What speaks against a film: frames left out, ends that both move, links whose lengths scatter."""
    notes = []
    if not sure.all():
        notes.append(
            f"{(~sure).sum()} of {len(sure)} frames repeat a picture or do not show three markers for certain, and are "
            "left out"
        )
    if min(spread[0], spread[2]) > 0.2 * max(spread[0], spread[2]):
        notes.append("both ends of the strip move: is the camera still, and is the first marker at the wall?")
    # The links' lengths ought to be constant: what they scatter, the angles do too.
    scatter = float(links[sure].std(axis=0).max())
    swing = float(np.ptp(angles_of_markers(pixels[sure] * (1, -1))[1]))
    share = scatter / float(links[sure].mean()) / max(swing, 1e-9)
    if not share < _LARGE_SCATTER:
        notes.append(
            f"lengths between markers scatter by {scatter:.2g} px, {100 * share:.0f} % of the swing of phi2: film "
            "closer, or store the film with less compression"
        )
    return notes


def _repeated(changes: Array, pixels: Array) -> Flags:
    """Frames (n,) that repeat the one before while the strip moves: a fault of the file, not a strip at rest."""
    moving = np.full(len(pixels), False)
    moving[1:-1] = np.nan_to_num(np.abs(pixels[2:] - pixels[:-2])).max(axis=(1, 2)) > _MOVES
    return moving & repeats(changes)


def _check_enough(path: Path | str, sure: Flags) -> None:
    if sure.sum() >= max(LEAST_ROWS, _LEAST_SHARE * len(sure)):
        return
    raise InputError("video", f"{path} ({sure.sum()} of {len(sure)} frames show three red markers)",
                     f"a film with three red markers in at least {LEAST_ROWS} frames and half of all",
                     "red markers at the wall, the joint and the tip, seen from the side in good light")  # fmt: skip
