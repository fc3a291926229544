"""A folder of clips, one for each plate frequency, becomes a spin curve that `fit` and `estimate` take."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from plategait.curve.curve import Curve
from plategait.curve.protocol import USUAL
from plategait.errors import InputError
from plategait.files.rows import read_rows
from plategait.vision.plate.swing import PlateSwing
from plategait.vision.setup import Setup
from plategait.vision.track import Track, track
from plategait.vision.velocity import HALF_95

CLIPS = (".mp4", ".mov", ".avi", ".mkv", ".m4v", ".webm", ".mpg", ".mpeg", ".mts")
# "24Hz", "24.5 hz", "24p5Hz", "24,5_Hz": a number with its unit, wherever it stands in the name.
_IN_NAME = re.compile(r"(?<![\d.,])(\d+(?:[.,p]\d+)?)[\s_-]*hz", re.IGNORECASE)


@dataclass(frozen=True, eq=False)
class Clip:
    """One clip of a folder.

    Attributes
    ----------
    path : Path
    frequency : float
        Of the plate, Hz; NaN where unknown.
    source : str
        Of the frequency: "given" by a table or the clip's name, or "measured" on the plate.
    track : Track or None
    trouble : str
        Why there is no track or no rate; empty where there is one.
    """

    path: Path
    frequency: float
    source: str
    track: Track | None
    trouble: str = ""

    @property
    def failure(self) -> str:
        """What happened to the object, in words of the curve; empty where it stayed or nothing is known."""
        return "" if self.track is None else self.track.failure


def frequency_in_name(path: Path) -> float | None:
    """Plate frequency that a file's name tells, Hz: "cheese_24Hz.mp4", "12p5 Hz.mov"; None where it tells none.

    Raises
    ------
    InputError
        When the name tells two different ones.
    """
    frequencies = {
        float(text.replace(",", ".").replace("p", ".").replace("P", ".")) for text in _IN_NAME.findall(path.stem)
    }
    if len(frequencies) > 1:
        listed = " and ".join(f"{f:g}" for f in sorted(frequencies))
        raise InputError("clip", f"{path.name}, which tells {listed} Hz", "a name with one frequency", "24Hz.mp4")
    return frequencies.pop() if frequencies else None


def read_frequencies(path: Path | str) -> dict[str, float]:
    """Plate frequency (Hz) by clip, from a CSV with the columns clip and frequency_hz.

    Raises
    ------
    InputError
        When it cannot be read or a frequency is no number above 0.
    """
    path = Path(path)
    example = "clip,frequency_hz"
    rows = [[cell.strip() for cell in row] for _, row in read_rows(path, "--frequencies", example)[0]]
    heading = rows[0] if rows else []
    if len(rows) < 2 or not {"clip", "frequency_hz"} <= set(heading):
        raise InputError("--frequencies", str(path), "a table of clip and frequency_hz", example)
    frequencies = {}
    for row in rows[1:]:
        cells = dict(zip(heading, row, strict=False))
        clip, text = cells.get("clip", ""), cells.get("frequency_hz", "")
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not 0 < value < math.inf:
            raise InputError(f"{path.name}, {clip}", text, "a frequency above 0 Hz", "24.0")
        frequencies[Path(clip).stem] = value
    return frequencies


def clips_in(folder: Path | str) -> list[Path]:
    """Video files of a folder, by name.

    Raises
    ------
    InputError
        When it is no folder, or has none.
    """
    folder = Path(folder)
    if not os.path.isdir(folder):  # as `is_dir`, but for names too long
        raise InputError("FOLDER", str(folder), "a folder of clips", "clips/ with 14Hz.mp4, 16Hz.mp4, …")
    clips = sorted(p for p in folder.iterdir() if p.suffix.lower() in CLIPS and not p.name.startswith("."))
    if not clips:
        raise InputError("FOLDER", f"{folder} without a clip", f"a folder of {', '.join(CLIPS[:4])}", "clips/24Hz.mp4")
    return clips


def track_folder(
    folder: Path | str,
    setup: Setup,
    *,
    frequencies: Mapping[str, float] | None = None,
    progress: Callable[[float], object] | None = None,
) -> list[Clip]:
    """Follow the object in every clip of a folder.

    The plate frequency comes from the table given, else from the file's name, else from the plate as it was seen, but
    for a clip in which another frequency would look the same: that has none. A clip that cannot be followed stays in
    the list with the reason, so that one bad clip costs no other.

    Parameters
    ----------
    folder : Path or str
    setup : Setup
        How they were filmed; its plate frequency is not used.
    frequencies : mapping of str to float, optional
        Plate frequency (Hz) by file name without its ending.
    progress : callable, optional
        Called with the fraction done.

    Raises
    ------
    InputError
        When the folder has no clips, or a name tells two frequencies.
    """
    paths = clips_in(folder)
    nominal = [(frequencies or {}).get(path.stem, frequency_in_name(path)) for path in paths]
    clips = []
    for i, (path, frequency) in enumerate(zip(paths, nominal, strict=True)):

        def report(done: float, i: int = i) -> None:
            if progress is not None:
                progress((i + done) / len(paths))

        try:
            result = track(path, replace(setup, plate_frequency=frequency), progress=report)
        except InputError as error:
            clips.append(Clip(path, frequency or math.nan, "given", None, str(error)))
            continue
        source = "given" if frequency is not None else "measured"
        used = result.plate_frequency if frequency is None else frequency
        trouble = result.spin.reason if math.isnan(result.spin.rate) else ""
        if math.isnan(used):
            trouble = _unknown_frequency(result.plate)
        clips.append(Clip(path, used, source, result, trouble))
    return clips


def _unknown_frequency(plate: PlateSwing) -> str:
    """Why a plate's frequency is not known from its clip, and what to do about it."""
    cure = "name the clip by it (24Hz.mp4) or give --frequencies"
    if plate.aliases:
        seen = ", ".join(f"{f:.4g}" for f in sorted((plate.frequency, *plate.aliases)))
        return f"its plate frequency may be any of {seen} Hz, which look the same in these frames; {cure}"
    if plate.sways:
        return f"what sways at {plate.frequency:.4g} Hz in its picture may be the camera; {cure}"
    return f"its plate frequency is neither in the name nor to be seen; {cure}"


def curve_of_clips(clips: list[Clip], name: str) -> Curve:
    """Spin curve of tracked clips, by rising frequency; clips of unknown frequency are left out.

    Raises
    ------
    InputError
        When no clip gave a frequency.
    """
    placed = sorted((c for c in clips if math.isfinite(c.frequency)), key=lambda c: c.frequency)
    if not placed:
        raise InputError(
            "FOLDER", "clips of unknown plate frequency", "clips named by it", "24Hz.mp4, or --frequencies FILE"
        )

    def seconds(clip: Clip) -> float:
        return math.nan if clip.track is None else float(np.ptp(clip.track.time))

    def each(of: Callable[[Track], float], *, failed: bool = False) -> np.ndarray:
        """A number of each clip; of one in which the object failed only if it counts nevertheless."""
        return np.array([math.nan if c.track is None or (c.failure and not failed) else of(c.track) for c in placed])

    def half(high: float, low: float) -> float:
        return (high - low) / (2 * HALF_95)

    def length(of: Callable[[Track], float], *, failed: bool = False) -> np.ndarray:
        """The same of what is measured by the plate's size: of none where that may be another."""
        return each(lambda t: of(t) if t.true_to_scale else math.nan, failed=failed)

    values = {
        "velocity_x": length(lambda t: t.findings.velocity.x),
        "velocity_y": length(lambda t: t.findings.velocity.y),
        "rim_lift": length(lambda t: t.findings.rim_lift[0]),
    }
    sds = {
        "velocity_x": length(lambda t: t.findings.velocity.x_half / HALF_95),
        "velocity_y": length(lambda t: t.findings.velocity.y_half / HALF_95),
        "rim_lift": length(lambda t: t.findings.rim_lift[1]),
    }
    of_object = {
        "radius": length(lambda t: t.findings.radius[0], failed=True),
        "radius_sd": length(lambda t: t.findings.radius[1], failed=True),
        "area": length(lambda t: t.findings.area[0], failed=True),
        "area_sd": length(lambda t: t.findings.area[1], failed=True),
    }
    return Curve(
        name=name,
        frequency_hz=np.array([c.frequency for c in placed]),
        spin_rate_deg_s=np.degrees(each(lambda t: t.spin.rate)),
        spin_rate_sd_deg_s=np.degrees(each(lambda t: half(t.spin.high, t.spin.low))),
        gait=("",) * len(placed),
        failure=tuple(c.failure for c in placed),
        duration=np.array([seconds(c) for c in placed]),
        slip_limit=np.full(len(placed), USUAL.slip_limit),
        values=_known(values),
        value_sds=_known(sds),
        of_object=_known(of_object),
    )


def _known(columns: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Those that any clip tells something of."""
    return {name: values for name, values in columns.items() if np.isfinite(values).any()}
