"""Frames of a video file or a camera: pictures with the time that each was taken at, one after the other."""

from __future__ import annotations

import math
import os
import queue
import threading
import time as clock
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from plategait.arrays import Array, Flags, Picture
from plategait.errors import InputError, check_kind

# Pixels that differ by more levels than this count as changed: a codec changes a repeated picture by less.
CHANGED_LEVELS = 4
# Of the pixels each way, every so many is compared.
CHANGED_STRIDE = 3
# Damaged frames after which a file is given up.
MOST_DAMAGED = 50
# A file that says it lasts longer than its frames by this has lost some, s.
CUT_SHORT = 0.25
# A picture that changes by less than this share of the usual change repeats the one before it.
REPEATED = 0.03
# Pictures of a live camera that may wait for whoever looks at them, bytes.
MOST_WAITING = 150e6
_WORKS = "clip.mp4"


@dataclass(frozen=True, eq=False)
class Frame:
    """One picture.

    Attributes
    ----------
    index : int
        Of the pictures read so far.
    time : float
        When it was taken, s from the first one.
    luma : (height, width) array
        Brightness.
    chroma : pair of (height // 2, width // 2) arrays
        Colour differences U and V, 128 for grey.
    change : float
        Share of the pixels that changed since the frame before: near 0 for a picture taken once and stored twice.
    """

    index: int
    time: float
    luma: Picture
    chroma: tuple[Picture, Picture]
    change: float = 1.0

    def bgr(self) -> Picture:
        """(height, width, 3) picture in colour, as OpenCV draws on it."""
        import cv2

        planes = np.concatenate([self.luma.ravel(), self.chroma[0].ravel(), self.chroma[1].ravel()])
        height, width = self.luma.shape
        return cv2.cvtColor(planes.reshape(height * 3 // 2, width), cv2.COLOR_YUV2BGR_I420).astype(np.uint8, copy=False)


def frame_of(bgr: Picture, index: int, time: float) -> Frame:
    """Frame of a picture (height, width, 3) in blue, green and red, of even height and width."""
    import cv2

    height, width = bgr.shape[:2]
    planes = cv2.cvtColor(bgr, cv2.COLOR_BGR2YUV_I420).astype(np.uint8, copy=False)
    u, v = (plane.reshape(height // 2, width // 2) for plane in np.split(planes[height:].ravel(), 2))
    return Frame(index, time, planes[:height], (u, v))


@dataclass(eq=False)
class Video:
    """An open video: its facts, and its frames to be taken once.

    Attributes
    ----------
    name : str
    width, height : int
        Pixels; even, an odd last row or column is cut off. Of a film taken upright they change places with its first
        frame.
    fps : float
        Frames per second that it says it was taken at; 0 where unknown.
    length : int
        Frames that it says it holds; 0 where unknown.
    notes : list of str
        What turned out on the way: damage, missing times.
    """

    name: str
    width: int
    height: int
    fps: float
    length: int
    read: Callable[[Video], Iterator[Frame]]
    notes: list[str] = field(default_factory=list)

    def frames(self) -> Iterator[Frame]:
        """Frames in the order they were taken, one in memory at a time."""
        return _compared(self.read(self))


@contextmanager
def open_video(source: Path | str, *, fps: float | None = None, seconds: float | None = None) -> Iterator[Video]:
    """Open a video file, or a camera by its number.

    Parameters
    ----------
    source : Path or str
        A file, or the index of a camera ("0").
    fps : float, optional
        Frames per second of the camera, where the file was stored to play at another rate (high-speed cameras): its
        times are stretched accordingly.
    seconds : float, optional
        Time to film for, with a camera; of a file, the part from its start.

    Raises
    ------
    InputError
        When there is no such file or camera, it is no video, holds no picture (audio only), or is cut short so that
        nothing can be read.
    """
    check_kind(source, (str, Path, int), "video", _WORKS)
    if fps is not None and not 0 < fps < 1e6:
        raise InputError("--fps", fps, "frames per second, above 0", "120")
    if seconds is not None and not seconds > 0:
        raise InputError("--seconds", seconds, "a time above 0", "10")
    _silence_opencv()
    if str(source).isdigit() and not os.path.exists(source):
        if fps is not None:
            raise InputError("--fps", fps, "left out with a camera, whose own times are used", "a file of its film")
        with _camera(int(str(source)), 10.0 if seconds is None else seconds) as video:
            yield video
    else:
        with _file(Path(source), fps, seconds) as video:
            yield video


def _silence_opencv() -> None:
    """Keep OpenCV's own lines off the terminal: what is wrong is said in ours."""
    import cv2

    cv2.utils.logging.setLogLevel(cv2.utils.logging.LOG_LEVEL_SILENT)


@contextmanager
def _file(path: Path, fps: float | None, seconds: float | None) -> Iterator[Video]:
    """Open a video file."""
    with _container(path) as container:
        if not container.streams.video:
            what = "sound only" if container.streams.audio else "nothing to see"
            raise InputError("video", f"{path} ({what})", "a file with pictures in it", _WORKS)
        stream = container.streams.video[0]
        stream.thread_type = "AUTO"
        nominal = float(stream.average_rate or stream.guessed_rate or 0)
        context: Any = stream.codec_context
        width, height = context.width // 2 * 2, context.height // 2 * 2
        if min(width, height) < 32:
            raise InputError("video", f"{path} ({width} × {height} pixels)", "pictures of 32 pixels or more", _WORKS)
        slowed = nominal / fps if fps and nominal else 1.0

        def read(video: Video) -> Iterator[Frame]:
            count, last = 0, 0.0
            pictures = _decoded(container, stream, video.notes)
            for moment, picture in _timed(pictures, nominal, slowed, seconds, video.notes):
                frame = _frame_of(picture, count, moment, width, height)
                video.height, video.width = frame.luma.shape
                yield frame
                count, last = count + 1, moment
            if count == 0:
                raise InputError("video", f"{path} (no picture in it)", "a video with at least one frame", _WORKS)
            duration = (container.duration or 0) / 1e6 * slowed  # the container counts in microseconds
            if seconds is None and (video.length > count + 1 or duration > last + CUT_SHORT):
                whole = f"{video.length} frames" if video.length else f"{duration:.2f} s"
                video.notes.append(f"cut short: {count} frames, {last:.2f} s, of {whole}")

        yield Video(path.name, width, height, fps or nominal, stream.frames, read)


# A playlist is a video to FFmpeg, and would have it open other files and addresses: only containers are read.
_SELF_CONTAINED = {
    "protocol_whitelist": "file",
    "format_whitelist": "mov,mp4,m4a,3gp,3g2,mj2,matroska,webm,avi,mpeg,mpegts,mpegvideo,m4v,h264,hevc,ogg,flv,asf,gif,"
    "yuv4mpegpipe,mjpeg,wav,mp3,aac",
}


def _container(path: Path) -> Any:
    """What FFmpeg makes of a file."""
    import av
    from av.error import FFmpegError

    if not os.path.isfile(path):  # as `is_file`, but for names too long
        raise InputError("video", str(path), "a video file that exists, or the number of a camera", _WORKS)
    try:
        return av.open(str(path), options=_SELF_CONTAINED)
    except (FFmpegError, OSError, ValueError) as error:
        message = getattr(error, "strerror", None) or error
        raise InputError("video", f"{path} ({message})", "a video that can be read, whole to its end", _WORKS) from None


def _timed(
    pictures: Iterator[Any], nominal: float, slowed: float, seconds: float | None, notes: list[str]
) -> Iterator[tuple[float, Any]]:
    """Pictures with the time from the first, s, `slowed` times that of the file; those whose stamps run backwards not.

    A picture without a time comes at the nominal rate, per second.
    """
    count, first, last = 0, math.nan, -1e-9
    for picture in pictures:
        stamp = picture.time
        if stamp is None:
            if "frames without a time of their own" not in notes:
                notes.append("frames without a time of their own")
            stamp = count / (nominal or 30.0) + (0.0 if count == 0 else first)
        if count == 0:
            first = stamp
        moment = (stamp - first) * slowed
        if moment <= last:  # a stamp that runs backwards says nothing
            continue
        if seconds is not None and moment > seconds:
            break
        yield moment, picture
        count, last = count + 1, moment


def _decoded(container: Any, stream: Any, notes: list[str]) -> Iterator[Any]:
    """Pictures of a stream, past damaged places."""
    from av.error import EOFError as EndOfFile
    from av.error import FFmpegError

    damaged = 0
    packets = container.demux(stream)
    while True:
        try:
            packet = next(packets)
            yield from packet.decode()
        except (StopIteration, EndOfFile):
            break
        except FFmpegError:
            damaged += 1
            if damaged > MOST_DAMAGED:
                break
    if damaged:
        notes.append(f"{damaged} damaged places in the file were passed over")


def _frame_of(picture: Any, index: int, time: float, width: int, height: int) -> Frame:
    """Planes of a decoded picture, without a copy where the decoder's layout allows."""
    if picture.format.name not in ("yuv420p", "yuvj420p"):
        picture = picture.reformat(format="yuv420p")
    if (picture.width, picture.height) != (width, height) and (
        picture.width // 2 * 2,
        picture.height // 2 * 2,
    ) != (width, height):
        picture = picture.reformat(width=width, height=height)
    y, u, v = (
        np.frombuffer(plane, np.uint8).reshape(-1, plane.line_size)[: plane.height, : plane.width]
        for plane in picture.planes
    )
    y, u, v = y[:height, :width], u[: height // 2, : width // 2], v[: height // 2, : width // 2]
    # A phone that is held upright stores pictures that lie, and how they are to be turned.
    quarters = round(picture.rotation / 90) % 4
    if quarters:
        y, u, v = (np.ascontiguousarray(np.rot90(plane, quarters)) for plane in (y, u, v))
    return Frame(index, time, y, (u, v))


@contextmanager
def _camera(index: int, seconds: float) -> Iterator[Video]:
    import cv2

    device = cv2.VideoCapture(index)
    try:
        if not device.isOpened():
            raise InputError("video", index, "a file, or the number of a camera that is connected", _WORKS)
        width, height = (
            int(device.get(code)) // 2 * 2 for code in (cv2.CAP_PROP_FRAME_WIDTH, cv2.CAP_PROP_FRAME_HEIGHT)
        )

        with _taken(device, seconds, int(MOST_WAITING / (3 * width * height))) as pictures:

            def read(video: Video) -> Iterator[Frame]:
                count = 0
                for moment, bgr in pictures:
                    yield frame_of(bgr[:height, :width], count, moment)
                    count += 1
                if count == 0:
                    raise InputError("video", index, "a camera that gives pictures", _WORKS)

            yield Video(f"camera {index}", width, height, float(device.get(cv2.CAP_PROP_FPS)), 0, read)
    finally:
        device.release()


@contextmanager
def _taken(device: Any, seconds: float, most: int) -> Iterator[Iterator[tuple[float, Any]]]:
    """Pictures of a camera, each with its time from the first, s.

    They are taken beside whoever looks at them, so that none waits in the camera while what the first ones show is
    learnt. Where more than `most` wait, further ones are lost, which the times show.
    """
    waiting: queue.Queue[tuple[float, Any] | None] = queue.Queue(max(2, most))
    enough = threading.Event()

    def take() -> None:
        first = math.nan
        while not enough.is_set():
            taken, bgr = device.read()
            now = clock.monotonic()
            first = now if math.isnan(first) else first
            if not taken or now - first > seconds:
                break
            if not waiting.full():
                waiting.put((now - first, bgr))
        waiting.put(None)

    def pictures() -> Iterator[tuple[float, Any]]:
        while (item := waiting.get()) is not None:
            yield item

    hand = threading.Thread(target=take, daemon=True)
    hand.start()
    try:
        yield pictures()
    finally:
        enough.set()
        while hand.is_alive():  # it may wait for room to say that it has done
            with suppress(queue.Empty):
                waiting.get_nowait()
            hand.join(0.01)


def _compared(frames: Iterator[Frame]) -> Iterator[Frame]:
    """Frames with how much of each changed."""
    import cv2

    before: Picture | None = None
    for frame in frames:
        thin = np.ascontiguousarray(frame.luma[::CHANGED_STRIDE, ::CHANGED_STRIDE])
        if before is not None and before.shape == thin.shape:
            differs = cv2.threshold(cv2.absdiff(before, thin), CHANGED_LEVELS, 1, cv2.THRESH_BINARY)[1]
            frame = replace(frame, change=cv2.countNonZero(differs) / thin.size)
        before = thin
        yield frame


def repeats(changes: Array) -> Flags:
    """Frames (n,) that repeat the picture before, by the share of pixels (n,) that changed in each."""
    return np.asarray(changes < REPEATED * np.median(changes), dtype=bool)
