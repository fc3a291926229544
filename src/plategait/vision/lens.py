"""Pictures as a lens without distortion would take them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from plategait.camera.camera import Calibration
from plategait.errors import InputError
from plategait.vision.frames import Frame


def scaled_matrix(calibration: Calibration, width: int) -> NDArray[np.float64]:
    """(3, 3) focal lengths and middle, px, for pictures of another width. Whole numbers are the middles of pixels."""
    share = width / calibration.width
    return np.array([[share, 0, (share - 1) / 2], [0, share, (share - 1) / 2], [0, 0, 1.0]]) @ calibration.matrix


def undistorter(calibration: Calibration | None, width: int, height: int) -> Callable[[Frame], Frame]:
    """Give what takes a lens's distortion out of frames of this size, px; frames as they are without a calibration.

    Raises
    ------
    InputError
        When the calibration is for pictures of another shape.
    """
    if calibration is None or not np.any(calibration.distortion):
        return lambda frame: frame
    if abs(calibration.width / calibration.height / (width / height) - 1) > 0.01:
        raise InputError(
            "--calibration", f"one of {calibration.width} × {calibration.height} pixels",
            f"one of pictures shaped as {width} × {height}", "a calibration made with the settings of the clip",
        )  # fmt: skip
    import cv2

    maps = []
    # Planes of brightness, and of colour at half the size.
    for size in ((width, height), (width // 2, height // 2)):
        K = scaled_matrix(calibration, size[0])
        maps.append(cv2.initUndistortRectifyMap(K, calibration.distortion, None, K, size, cv2.CV_16SC2))

    def undistort(frame: Frame) -> Frame:
        (x, y), (half_x, half_y) = maps
        luma = cv2.remap(frame.luma, x, y, cv2.INTER_LINEAR)
        u, v = (cv2.remap(plane, half_x, half_y, cv2.INTER_LINEAR, borderValue=(128,)) for plane in frame.chroma)
        return replace(frame, luma=luma, chroma=(u, v))

    return undistort
