"""The command that turns a folder of clips, one for each plate frequency, into a spin curve."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from plategait.cli import filmed, options, report
from plategait.cli.groups import grouped
from plategait.files.output import check_outputs

if TYPE_CHECKING:
    from plategait.vision.folder import Clip


@grouped
def track_folder(
    folder: Annotated[
        str, typer.Argument(metavar="FOLDER", help="A clip for each plate frequency: 14Hz.mp4, 16Hz.mp4, …")
    ],
    filmed_as: filmed.FilmedOptions,
    frequencies: Annotated[
        Path | None, typer.Option("--frequencies", help="Plate frequencies of the clips: .csv of clip, frequency_hz.")
    ] = None,
    out: Annotated[Path | None, typer.Option("--out", help="Write the spin curve, for fit and estimate: .csv.")] = None,
    as_json: options.Json = False,
) -> None:
    """Spin curve of a folder of clips, all filmed alike."""
    check_outputs((out, (".csv",), "--out"))
    filmed.require_opencv()
    from plategait.curve.curve_file import write_curve
    from plategait.vision import folder as clips_of

    setup = filmed_as.setup()
    table = clips_of.read_frequencies(frequencies) if frequencies is not None else None
    with report.progress_bar("tracking") as progress:
        clips = clips_of.track_folder(folder, setup, frequencies=table, progress=progress)
    curve = clips_of.curve_of_clips(clips, Path(folder).name)
    if out:
        write_curve(curve, out)
    if as_json:
        summaries = [c.track.summary() if c.track else {"clip": c.path.name, "no_spin_rate": c.trouble} for c in clips]
        report.print_json({"curve": str(out) if out else None, "points": curve.summary()["points"], "clips": summaries})
    else:
        columns = ["clip", "plate (Hz)", "deg/s", "± 95 %", "remark"]
        report.print_table(str(out or folder), columns, [_row(clip) for clip in clips])
    raise typer.Exit(0 if any(math.isfinite(r) for r in curve.spin_rate_deg_s) else 1)


def _row(clip: Clip) -> list[str]:
    spin = clip.track.spin if clip.track else None
    rate = f"{math.degrees(spin.rate):.1f}" if spin and math.isfinite(spin.rate) else "–"
    half = f"{math.degrees(spin.high - spin.low) / 2:.2g}" if spin and math.isfinite(spin.rate) else "–"
    frequency = f"{clip.frequency:.4g} ({clip.source})" if math.isfinite(clip.frequency) else "–"
    return [clip.path.name, frequency, rate, half, clip.failure or clip.trouble or "–"]
