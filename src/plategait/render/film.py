"""The film and the filmstrip."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

from plategait.engine.recording import Recording
from plategait.errors import InputError
from plategait.files.output import whole_file
from plategait.model.scenario import Scenario
from plategait.render.shots import Shots
from plategait.render.stage import Stage
from plategait.render.text import caption, motion_in_words, write_text
from plategait.simulation.observation import observe

# Film time of one plate period, s: 15 frames at 30 fps, enough to tell sliding, walking and running apart by eye.
PERIOD_ON_FILM = 0.5

# What falls off the plate is shown falling for so long, s: a hand's breadth.
FALL_SHOWN = 0.15


def film(
    scenario: Scenario,
    recording: Recording,
    path: Path | str,
    *,
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
    recording : Recording
        With snapshots.
    path : Path or str
        File to write, ending in .mp4. It appears when the film is complete, never half.
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
        plate is shown falling.
    progress : callable, optional
        Called with the fraction done.

    Raises
    ------
    InputError
        For a recording without snapshots or with too few, or a path or number that cannot be used.
    """
    slower = max(1.0, PERIOD_ON_FILM * scenario.motion.frequency) if slow_motion is None else slow_motion
    for field, value, works in (("fps", fps, "30"), ("slow_motion", slower, "10"), ("seconds", seconds, "4")):
        if not (math.isfinite(value) and value > 0):
            raise InputError(field, value, "above 0", works)
    if min(size) < 64 or size[0] % 2 or size[1] % 2:
        raise InputError("size", size, "two even numbers of pixels, 64 or more", "(1280, 720)")
    shots = Shots.of(scenario, recording, 1 / (fps * slower))
    end = shots.end(scenario, recording, until, fall=FALL_SHOWN)
    frames = max(1, round(min(seconds, (end - shots.time[0]) * slower) * fps))
    times = end - np.arange(frames)[::-1] / (fps * slower)
    with whole_file(path, (".mp4",)) as unfinished:
        import av
        from av.video.reformatter import ColorRange, Colorspace

        stage = Stage(scenario, shots.at(times)[1], size)
        with av.open(str(unfinished), "w", format="mp4", options={"movflags": "+faststart"}) as container:
            stream: Any = container.add_stream("libx264", rate=Fraction(fps).limit_denominator(1001))
            stream.width, stream.height, stream.pix_fmt = *size, "yuv420p"
            stream.options = {"crf": "18", "preset": "medium"}
            stream.codec_context.colorspace, stream.codec_context.color_range = Colorspace.ITU709, ColorRange.MPEG
            for done, time in enumerate(times):
                picture = stage.picture(*shots.at(time))
                caption(picture, scenario, time, slower)
                frame = av.VideoFrame.from_image(picture).reformat(format="yuv420p", dst_colorspace=Colorspace.ITU709)
                container.mux(stream.encode(frame))
                if progress is not None:
                    progress((done + 1) / frames)
            container.mux(stream.encode())
    return Path(path)


def filmstrip(
    scenario: Scenario, recording: Recording, path: Path | str, *, panels: int = 8, until: float | None = None
) -> Path:
    """Draw snapshots over the last whole plate period of a run, as Fig. 4.3 does: a PNG file.

    Parameters
    ----------
    recording, path, until
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
    period = scenario.motion.period
    shots = Shots.of(scenario, recording, 0)
    start = max(float(shots.time[0]), (math.floor(shots.end(scenario, recording, until) / period + 1e-6) - 1) * period)
    times = start + np.arange(panels) * period / panels
    width, height, gap, top = 480, 330, 6, 64
    columns = math.ceil(panels / math.ceil(panels / 4))
    stage = Stage(scenario, shots.at(times)[1], (width, height))
    strip = Image.new(
        "RGB", (columns * (width + gap) + gap, math.ceil(panels / columns) * (height + gap) + top), "white"
    )
    rate = math.degrees(observe(scenario, recording).spin.rate)
    spin = f"spinning at {rate:.0f} deg/s" if math.isfinite(rate) else "spin rate not measured"
    title = f"{scenario.name}:  {motion_in_words(scenario)},  {spin}"
    write_text(ImageDraw.Draw(strip), (strip.width / 2, top / 2), title, 26, "mm", strip.width - 4 * gap)
    for k, time in enumerate(times):
        panel = stage.picture(*shots.at(time))
        write_text(
            ImageDraw.Draw(panel), (14, height - 14), f"({chr(97 + k)})  {1e3 * (time - start):.1f} ms", 20, "ls"
        )
        strip.paste(panel, (gap + k % columns * (width + gap), top + k // columns * (height + gap)))
    with whole_file(path, (".png",)) as unfinished:
        strip.save(unfinished, format="PNG")
    return Path(path)
