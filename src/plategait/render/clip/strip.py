"""Synthetic high-speed films of a strip that is released and sags, with three red markers (section 3.3.2)."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array, Picture
from plategait.camera.writer import SUFFIXES, film_file
from plategait.errors import InputError
from plategait.files.output import check_writable
from plategait.theory.two_links import Joints, Strip, strip_angles

_MOMENTS = 4  # of an exposure
_FINER = 2  # the scene is drawn this many times finer, then averaged
_SUBPIXEL = 5  # binary digits of a coordinate behind the point
_MARKER, _HALF_STRIP = 0.0011, 0.00125  # radius of a marker, half the thickness of the strip, m
_BACKGROUND, _CLAMP, _CHEESE, _RED = (72, 66, 60), (120, 116, 110), (70, 190, 240), (40, 36, 205)  # blue, green, red


@dataclass(frozen=True, eq=False)
class StripFilm:
    """What a synthetic film of a strip shows.

    Parameters
    ----------
    time : (n,) array
        Middle of each exposure, s after the first.
    markers : (n, 3, 2) array
        Middles of the markers at wall, joint and tip, x and y upwards, m.
    pixels : (n, 3, 2) array
        The same in the picture, y downwards, px.
    """

    time: Array
    markers: Array
    pixels: Array


def film_cantilever(
    k_b: float,
    c_b: float,
    path: Path | str,
    *,
    strip: Strip | None = None,
    fps: float = 480.0,
    plays_at: float | None = None,
    rows: int = 97,
    size: tuple[int, int] = (512, 384),
    exposure: float = 0.3,
    noise: float = 3.0,
    gradient: float = 0.3,
    crf: int = 20,
    left: bool = False,
    seed: int = 0,
) -> StripFilm:
    """Film a strip that is released from the horizontal.

    Parameters
    ----------
    k_b, c_b : float
        Both joints, N m/rad and N m s/rad.
    path : Path or str
        File to write, ending in .mp4, .mkv or .mov.
    strip : Strip, optional
        One link; that of section 3.3.2 by default.
    fps : float
        Pictures per second of the camera.
    plays_at : float, optional
        Pictures per second that the file says, as high-speed cameras that store slow motion do; `fps` by default.
    rows : int
        Pictures.
    size : (width, height)
        px, even.
    exposure : float
        Share of the frame interval for which the shutter is open.
    noise : float
        Standard deviation, grey levels.
    gradient : float
        Share of the light that the darkest corner lacks.
    crf : int
        Quality of the file; see `Appearance`.
    left : bool
        Whether the strip points to the left.
    seed : int

    Raises
    ------
    InputError
        When the file cannot be written, or the size is odd.
    """
    if min(size) < 64 or size[0] % 2 or size[1] % 2:
        raise InputError("size", size, "two even numbers of pixels, 64 or more", "(512, 384)")
    check_writable(path, SUFFIXES)
    strip, generator = strip or Strip(), np.random.default_rng(seed)
    frames = np.arange(rows) / fps
    moments = (np.arange(_MOMENTS) + 0.5) / _MOMENTS * exposure / fps
    markers = _markers(strip, Joints(k_b, c_b), frames[:, None] + moments, left)
    scale = 0.5 * size[0] / (2 * strip.length)
    wall = np.array([0.72 if left else 0.28, 0.35]) * size
    pixels = wall + markers * (scale, -scale)
    light = 1 - gradient * np.linspace(0, 1, size[0], dtype=np.float32)[None, :, None]
    with film_file(path, size, plays_at or fps, crf) as file:
        for k, exposed in enumerate(pixels):
            picture = np.mean([_picture(moment, size, scale, left) for moment in exposed], axis=0) * light
            grain = noise * generator.standard_normal((size[1], size[0], 3), dtype=np.float32)
            file.add(np.clip(np.rint(picture + grain), 0, 255).astype(np.uint8), k / (plays_at or fps))
    return StripFilm(frames, markers.mean(axis=1), pixels.mean(axis=1))


def _markers(strip: Strip, joints: Joints, time: Array, left: bool) -> Array:
    """(n, m, 3, 2) places of the markers, m from the wall, x and y upwards, at times (n, m), s."""
    phi = strip_angles(strip, joints, time.ravel())
    below = np.stack([phi[:, 0], phi[:, 0] + phi[:, 1]], axis=1)
    links = strip.length * np.stack([np.cos(below), -np.sin(below)], axis=2)
    places = np.concatenate([np.zeros((len(links), 1, 2)), np.cumsum(links, axis=1)], axis=1)
    return places.reshape(*time.shape, 3, 2) * ((-1, 1) if left else (1, 1))


def _picture(markers: Array, size: tuple[int, int], scale: float, left: bool) -> Picture:
    """One moment: clamp, strip along a smooth curve through the markers (3, 2), px, and the markers on it."""
    image = np.full((size[1] * _FINER, size[0] * _FINER, 3), _BACKGROUND, np.uint8)
    way = np.array([-1.0 if left else 1.0, 0.0])
    wall = markers[0]
    cv2.fillPoly(image, [_fixed_point(_band(markers, scale, way))], _CHEESE, cv2.LINE_AA, _SUBPIXEL)
    for side in (-1, 1):
        near, far = wall - 2.2 * _MARKER * scale * way, wall - 9e-3 * scale * way
        up = np.array([0.0, side * scale])
        block = np.array([near + 0.9e-3 * up, far + 0.9e-3 * up, far + 7e-3 * up, near + 7e-3 * up])
        cv2.fillPoly(image, [_fixed_point(block)], _CLAMP, cv2.LINE_AA, _SUBPIXEL)
    for marker in markers:
        column, row = _fixed_point(marker).tolist()
        radius = round(_MARKER * scale * _FINER * 2**_SUBPIXEL)
        cv2.circle(image, (column, row), radius, _RED, -1, cv2.LINE_AA, _SUBPIXEL)
    return np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_AREA), dtype=np.uint8)


def _band(markers: Array, scale: float, way: Array) -> Array:
    """Outline (k, 2), px, of the strip along a smooth curve through the markers (3, 2), px; `way` is off the wall."""
    share = np.linspace(-1, 2.08, 61)[:, None]
    # Lagrange's parabola through the markers, level where it is clamped.
    wall, joint, tip = markers
    curve = wall * (share - 1) * (share - 2) / 2 - joint * share * (share - 2) + tip * share * (share - 1) / 2
    curve = np.where(share < 0, wall + share * np.linalg.norm(joint - wall) * way, curve)
    tangent = np.gradient(curve, axis=0)
    normal = tangent[:, ::-1] * (1, -1) / np.linalg.norm(tangent, axis=1, keepdims=True)
    half = _HALF_STRIP * scale
    return np.concatenate([curve + half * normal, (curve - half * normal)[::-1]])


def _fixed_point(points: Array) -> NDArray[np.int32]:
    """Points, px, with `_SUBPIXEL` binary digits, in the picture that is `_FINER`."""
    # The middle of pixel 0 lies at 0; drawn finer, at half of what is finer than one.
    return np.round(((points + 0.5) * _FINER - 0.5) * 2**_SUBPIXEL).astype(np.int32)
