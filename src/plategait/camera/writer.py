"""Video files with true time stamps, and the times at which a camera that drops and repeats frames takes them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.files.output import whole_file

CLOCK = 90_000
"""Ticks of the time stamps in a second."""
SUFFIXES = (".mp4", ".mkv", ".mov")


@dataclass(frozen=True, eq=False)
class Schedule:
    """When frames are taken.

    Parameters
    ----------
    time : (n,) array
        Time stamps, s from the first frame.
    pictured : (n,) array
        When what the frame shows was taken: earlier than the stamp where a picture is repeated.
    """

    time: Array
    pictured: Array

    @property
    def duplicate(self) -> NDArray[np.bool_]:
        """(n,) whether the frame repeats the one before."""
        return self.pictured < self.time


def schedule(
    seconds: float, fps: float, *, jitter: float = 0.0, drop: float = 0.0, duplicate: float = 0.0, seed: int = 0
) -> Schedule:
    """Times of the frames in a film; see `Appearance` for what jitter, drop and duplicate mean."""
    generator = np.random.default_rng(seed)
    n = max(1, int(np.floor(seconds * fps + 1e-9)))
    intervals = np.maximum(1 + jitter * generator.normal(size=n), 0.2) / fps if jitter > 0 else np.full(n, 1 / fps)
    time = np.concatenate([[0.0], np.cumsum(intervals)[:-1]])
    time = np.round(time * CLOCK) / CLOCK
    retained = generator.random(n) >= drop
    repeated = generator.random(n) < duplicate
    retained[0], repeated[0] = True, False
    time, repeated = time[retained], repeated[retained]
    source = np.maximum.accumulate(np.where(repeated, 0, np.arange(len(time))))
    return Schedule(time, time[source])


class FilmWriter:
    """Takes pictures and their times; see `film_file`."""

    def __init__(self, container: Any, stream: Any) -> None:
        self._container, self._stream = container, stream

    def add(self, picture: NDArray[np.uint8], time: float) -> None:
        """Add a picture (height, width, 3), blue green red, at a time from the start, s."""
        from av import VideoFrame
        from av.video.reformatter import Colorspace

        frame = VideoFrame.from_ndarray(picture, format="bgr24")
        frame = frame.reformat(format="yuv420p", dst_colorspace=Colorspace.ITU709)
        frame.pts, frame.time_base = round(time * CLOCK), Fraction(1, CLOCK)
        self._container.mux(self._stream.encode(frame))


@contextmanager
def film_file(path: Path | str, size: tuple[int, int], fps: float, crf: int) -> Iterator[FilmWriter]:
    """Write a film: H.264 in an MP4, MKV or MOV file, which appears when it is complete, never half.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    import av
    from av.video.reformatter import ColorRange, Colorspace

    with whole_file(path, SUFFIXES) as unfinished, av.open(str(unfinished), "w") as container:
        stream: Any = container.add_stream("libx264", rate=Fraction(fps).limit_denominator(1001))
        stream.width, stream.height, stream.pix_fmt = *size, "yuv420p"
        # A tree of macroblocks (x264's default) and the number of cores change the file's bits from run to run.
        stream.options = {"crf": str(crf), "preset": "veryfast", "threads": "2", "x264-params": "mbtree=0"}
        stream.codec_context.time_base = Fraction(1, CLOCK)
        stream.codec_context.colorspace, stream.codec_context.color_range = Colorspace.ITU709, ColorRange.MPEG
        yield FilmWriter(container, stream)
        container.mux(stream.encode())
