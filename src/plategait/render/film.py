"""The film and the filmstrip."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.files.output import whole_file
from plategait.model.scenario import Scenario
from plategait.render.painter import Painter
from plategait.render.snapshots import Snapshots
from plategait.render.text import caption, motion_in_words, write_text
from plategait.simulation.result import Simulation

if TYPE_CHECKING:
    from PIL.Image import Image

# Film time of one plate period, s: 15 frames at 30 fps, enough to tell sliding, walking and running apart by eye.
PERIOD_ON_FILM = 0.5

# What falls off the plate is filmed falling for so long, s: a hand's breadth.
FALL_TIME = 0.15

# Of a filmstrip: panel (width, height), the gap between panels, and the room for the title, px.
PANEL, GAP, TITLE_HEIGHT = (480, 330), 6, 64


def film(
    simulation: Simulation,
    path: Path | str,
    *,
    run: int = 0,
    fps: float = 30,
    slow_motion: float | None = None,
    size: tuple[int, int] = (1280, 720),
    seconds: float = 4.0,
    until: float | None = None,
    progress: Callable[[float], object] | None = None,
) -> Path:
    """Film the last part of a run, when its gait has settled: H.264 in an MP4 file.

    Parameters
    ----------
    simulation : Simulation
        With snapshots: ``simulate(scenario, snapshot_interval=scenario.motion.period / 24)``.
    path : Path or str
        File to write, ending in .mp4. It appears when the film is complete, never half.
    run : int
        Which run of an ensemble.
    fps : float
        Frames per second.
    slow_motion : float, optional
        How much longer the film takes than the motion. By default half a second for each plate period: 12 at 24 Hz.
    size : (width, height)
        Pixels, both even.
    seconds : float
        Length of the film; less where the run is shorter.
    until : float, optional
        Time of the run at which the film ends, s; by default where the run failed, or its end; what leaves the
        plate is filmed falling.
    progress : callable, optional
        Called with the fraction done.

    Raises
    ------
    InputError
        For a run without snapshots or with too few, or a path or number that cannot be used.
    """
    scenario = simulation.scenario
    slower = max(1.0, PERIOD_ON_FILM * scenario.motion.frequency) if slow_motion is None else slow_motion
    _check_film(fps, slower, seconds, size)
    snapshots = Snapshots.of(scenario, simulation.recordings[run], 1 / (fps * slower))
    end = snapshots.end(simulation.observations[run].failure, until, fall=FALL_TIME)
    frames = max(1, round(min(seconds, (end - snapshots.time[0]) * slower) * fps))
    times = end - np.arange(frames)[::-1] / (fps * slower)
    with film_file(path, size, fps) as add:
        for done, picture in enumerate(_captioned(scenario, snapshots, times, size, slower), start=1):
            add(picture)
            if progress is not None:
                progress(done / frames)
    return Path(path)


def _check_film(fps: float, slower: float, seconds: float, size: tuple[int, int]) -> None:
    for field, value, works in (("fps", fps, "30"), ("slow_motion", slower, "10"), ("seconds", seconds, "4")):
        if not (math.isfinite(value) and value > 0):
            raise InputError(field, value, "above 0", works)
    if min(size) < 64 or size[0] % 2 or size[1] % 2:
        raise InputError("size", size, "two even numbers of pixels, 64 or more", "(1280, 720)")


def _captioned(
    scenario: Scenario, snapshots: Snapshots, times: Array, size: tuple[int, int], slower: float
) -> Iterator[Image]:
    """Picture of each time, s, with what there is to read on it."""
    painter = Painter(scenario, snapshots.at(times)[1], size)
    for time in times:
        picture = painter.picture(*snapshots.at(time))
        caption(picture, scenario, time, slower)
        yield picture


@contextmanager
def film_file(path: Path | str, size: tuple[int, int], fps: float) -> Iterator[Callable[[Image], None]]:
    """Open an MP4 file, which appears when it is complete; gives what adds a picture to it."""
    with whole_file(path, (".mp4",)) as unfinished:
        import av
        from av.video.reformatter import ColorRange, Colorspace

        with av.open(str(unfinished), "w", format="mp4", options={"movflags": "+faststart"}) as container:
            stream: Any = container.add_stream("libx264", rate=Fraction(fps).limit_denominator(1001))
            stream.width, stream.height, stream.pix_fmt = *size, "yuv420p"
            stream.options = {"crf": "18", "preset": "medium"}
            stream.codec_context.colorspace, stream.codec_context.color_range = Colorspace.ITU709, ColorRange.MPEG

            def add(picture: Image) -> None:
                frame = av.VideoFrame.from_image(picture).reformat(format="yuv420p", dst_colorspace=Colorspace.ITU709)
                container.mux(stream.encode(frame))

            yield add
            container.mux(stream.encode())


def filmstrip(
    simulation: Simulation, path: Path | str, *, run: int = 0, panels: int = 8, until: float | None = None
) -> Path:
    """Draw snapshots over the last whole plate period of a run, as Fig. 4.3 does: a PNG file.

    Parameters
    ----------
    simulation, path, run, until
        As for `film`; the path ends in .png.
    panels : int
        Snapshots, evenly spaced over the period.

    Raises
    ------
    InputError
        As for `film`.
    """
    from PIL import Image, ImageDraw

    if not 1 <= panels <= 26:
        raise InputError("panels", panels, "from 1 to 26", "8")
    scenario, observation = simulation.scenario, simulation.observations[run]
    period = scenario.motion.period
    snapshots = Snapshots.of(scenario, simulation.recordings[run], 0)
    end = snapshots.end(observation.failure, until)
    start = max(float(snapshots.time[0]), (math.floor(end / period + 1e-6) - 1) * period)
    times = start + np.arange(panels) * period / panels
    (width, height), columns = PANEL, math.ceil(panels / math.ceil(panels / 4))
    rows = math.ceil(panels / columns)
    size = columns * (width + GAP) + GAP, rows * (height + GAP) + TITLE_HEIGHT
    strip = Image.new("RGB", size, "white")
    title = _title(scenario, observation.spin.rate)
    write_text(ImageDraw.Draw(strip), (size[0] / 2, TITLE_HEIGHT / 2), title, 26, "mm", size[0] - 4 * GAP)
    painter = Painter(scenario, snapshots.at(times)[1], PANEL)
    for k, time in enumerate(times):
        panel = painter.picture(*snapshots.at(time))
        label = f"({chr(97 + k)})  {1e3 * (time - start):.1f} ms"
        write_text(ImageDraw.Draw(panel), (14, height - 14), label, 20, "ls")
        strip.paste(panel, (GAP + k % columns * (width + GAP), TITLE_HEIGHT + k // columns * (height + GAP)))
    with whole_file(path, (".png",)) as unfinished:
        strip.save(unfinished, format="PNG")
    return Path(path)


def _title(scenario: Scenario, spin_rate: float) -> str:
    rate = math.degrees(spin_rate)
    spin = f"spinning at {rate:.0f} deg/s" if math.isfinite(rate) else "spin rate not measured"
    return f"{scenario.name}:  {motion_in_words(scenario)},  {spin}"
