"""Why no plate was found in a clip, in words that say what to do about it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from scipy.optimize import least_squares

from plategait.arrays import Array
from plategait.camera.fiducials import MODULES
from plategait.errors import InputError
from plategait.vision.frames import Frame
from plategait.vision.plate.fiducials import FiducialPlate
from plategait.vision.plate.outline import OUTLINE_CROPPED
from plategait.vision.plate.sharpness import sharpness
from plategait.vision.plate.view import PlateView, homography, project
from plategait.vision.setup import Setup

# Frames looked at for a reason.
MOST_LOOKED_AT = 12
# Levels that what moves differs by from frame to frame, and the least part of a picture that it is.
MOVED, LEAST_MOVED = 12, 0.003
# Edges that are softer than this share of the picture's width, and than so many pixels, are blurred; sharp ones measure
# up to four and a half.
BLURRED_SHARE, BLURRED_PIXELS = 0.009, 5.2
# Less sharp than this is no edge that way at all.
LEAST_SHARP = 0.02
# A plate's sides that fiducials show are told from those that were typed where they differ by this share, and by what
# so many pixels are of a fiducial's side.
OTHER_SIZE, OTHER_PIXELS = 0.03, 0.8


class NothingSeenError(InputError):
    """What is looked for is not to be seen in these frames, and may be in later ones."""


def no_plate(
    ways: Sequence[str],
    frames: list[Frame],
    views: list[PlateView],
    outlines: list[PlateView],
    finder: FiducialPlate | None,
) -> NothingSeenError:
    """Say why no plate was found in these frames.

    Parameters
    ----------
    ways : sequence of str
        How it was looked for.
    frames : list of Frame
    views : list of PlateView
        What fiducials showed in them; empty where none were looked for.
    outlines : list of PlateView
        What outlines did.
    finder : FiducialPlate, optional
        Who looked for them.
    """
    some = frames[:: max(1, len(frames) // MOST_LOOKED_AT)]
    if finder is not None and _mirrored(finder, some):
        return NothingSeenError(
            "video", "a film that is mirrored: its fiducials read only the other way round", "pictures as they are",
            "the camera's mirroring switched off, or the main camera",
        )  # fmt: skip
    single = [v for v in views if v.homography is not None and v.read]
    width = _blur(frames)
    if width is not None:
        return NothingSeenError(
            "video", f"what moves is blurred over about {width:.0f} pixels, and no plate is made out",
            "frames in which the plate's edges and fiducials are sharp",
            "a shorter exposure (1/500 s or less) with more light, and the camera in focus",
        )  # fmt: skip
    if finder is not None and single:
        return _few_fiducials(single, _cropped(finder, single, frames[0].luma.shape))
    if sum(v.reason == OUTLINE_CROPPED for v in outlines) > len(outlines) / 2:
        return NothingSeenError(
            "video", "no plate whose four edges are in the picture: what may be one is cropped by the picture's edge",
            "a clip that shows the whole plate", "the camera further away, or fiducials printed with plategait target",
        )  # fmt: skip
    return NothingSeenError(
        "video", f"nothing like a plate ({' or '.join(ways)}) in the frames looked at",
        "a clip that shows the whole plate",
        '--scale "0.2 mm" for a camera straight above, or print fiducials with plategait target',
    )  # fmt: skip


def _cropped(finder: FiducialPlate, views: list[PlateView], shape: tuple[int, ...]) -> bool:
    """Whether fiducials that are missing in most of these views would lie outside of the picture.

    One or two tell little of the perspective: an affine map puts the others well enough.
    """
    outside = 0
    for view in views:
        read = view.read or {}
        missing = [c for k, c in enumerate(finder.target.corners) if k not in read]
        if not missing:
            continue
        plate, pixels = np.concatenate([finder.target.corners[k] for k in read]), np.concatenate(list(read.values()))
        affine = np.linalg.lstsq(np.column_stack([plate, np.ones(len(plate))]), pixels, rcond=None)[0]
        others = np.concatenate(missing)
        pixels = np.column_stack([others, np.ones(len(others))]) @ affine
        outside += bool(np.any((pixels < 0) | (pixels > np.array([shape[1], shape[0]]) - 1)))
    return outside > len(views) / 2


def _few_fiducials(views: list[PlateView], cropped: bool) -> NothingSeenError:
    """Some fiducials, and not enough of them: cropped by the picture, or covered."""
    seen = set().union(*(view.read or {} for view in views))
    how = f"only {len(seen)} of the plate's four fiducials" if len(seen) < 4 else "never enough fiducials at once"
    if cropped:
        return NothingSeenError(
            "video", f"{how}: the plate is cropped by the picture's edge", "a clip that shows the whole plate",
            "the camera further away, or turned towards the plate's middle",
        )  # fmt: skip
    return NothingSeenError(
        "video", f"{how}; the others are covered or unreadable", "two or more, not all on one side",
        "nothing lying on the fiducials, even light, and a camera nearer by",
    )  # fmt: skip


def _mirrored(finder: FiducialPlate, frames: list[Frame]) -> bool:
    """Whether fiducials can be read in the mirrored pictures."""
    mirrored = (finder.read(np.ascontiguousarray(frame.luma[:, ::-1])) for frame in frames)
    return sum(len(read) >= 2 for read in mirrored) >= max(1, len(frames) // 6)


def _blur(frames: list[Frame]) -> float | None:
    """Pixels over which the edges of what moves are blurred, where that is many; None where they are sharp."""
    import cv2

    widths = []
    pairs = list(pairwise(frames))
    for before, frame in pairs[:: max(1, len(pairs) // MOST_LOOKED_AT)]:
        moved = cv2.threshold(cv2.absdiff(before.luma, frame.luma), MOVED, 1, cv2.THRESH_BINARY)[1]
        moved = cv2.morphologyEx(moved, cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
        if cv2.countNonZero(moved) < LEAST_MOVED * moved.size:
            continue
        near = np.asarray(cv2.dilate(moved, np.ones((9, 9), np.uint8)) > 0, dtype=bool)
        sharp = sharpness(frame.luma, near)
        if sharp > LEAST_SHARP:
            widths.append(1 / sharp)
    if not widths:
        return None
    width = float(np.median(widths))
    return width if width > max(BLURRED_PIXELS, BLURRED_SHARE * frames[0].luma.shape[1]) else None


def size_of(views: list[PlateView], fiducial: float, typed: tuple[float, float]) -> tuple[float, float] | None:
    """Length and width, m, of the plate at whose corners fiducials of this side (m) lie as seen; None where untold.

    The pattern of four squares tells how far they are apart by their own side.
    """
    whole = [v.read for v in views if v.read is not None and len(v.read) == 4]
    whole = whole[:: max(1, len(whole) // MOST_LOOKED_AT)]
    if not whole:
        return None

    def off(size: Array) -> Array:
        signs = np.array([[-1, 1], [1, 1], [1, -1], [-1, -1]])
        middles = signs * (np.abs(size) / 2 - fiducial / MODULES - fiducial / 2)
        plate = (middles[:, None] + signs * fiducial / 2).reshape(-1, 2)
        out = []
        for read in whole:
            pixels = np.concatenate([read[k] for k in range(4)])
            H = homography(plate, pixels)
            out.append(np.full(pixels.shape, 1e3) if H is None else project(H, plate) - pixels)
        return np.concatenate(out).ravel()

    fit = least_squares(off, np.array(typed), x_scale=min(typed), diff_step=1e-3)
    size = np.abs(fit.x)
    if not fit.success or float(np.sqrt(np.mean(fit.fun**2))) > 1.5 or not np.all(size > 2 * fiducial):
        return None
    return float(size[0]), float(size[1])


def check_size(views: list[PlateView], setup: Setup) -> None:
    """Refuse fiducials that lie otherwise than on the plate that was typed.

    Raises
    ------
    InputError
        When their distances over their side are not those of this plate.
    """
    seen = size_of(views, setup.fiducial_side, setup.plate_size)
    typed = setup.plate_size
    misfit = sum("fit together" in v.reason for v in views) > max(1, len(views) // 2)
    sides = [np.linalg.norm(np.diff(c, axis=0), axis=1).min() for v in views for c in (v.read or {}).values()]
    least = OTHER_SIZE + OTHER_PIXELS / float(np.median(sides)) if sides else math.inf
    other = seen is not None and max(abs(math.log(s / t)) for s, t in zip(seen, typed, strict=True)) > least
    if not (misfit or other):
        return
    length, width = (f"{1e3 * s:.4g}" for s in typed)
    allowed = "the plate and the fiducials that the clip shows"
    if seen is not None and other:
        allowed += f": with fiducials of that size, about {1e3 * seen[0]:.3g} x {1e3 * seen[1]:.3g} mm"
    raise InputError(
        "--plate-size", f"{length} x {width} mm with fiducials of {1e3 * setup.fiducial_side:.4g} mm", allowed,
        "the sizes printed on the plate's target",
    )  # fmt: skip
