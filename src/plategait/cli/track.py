"""The command that reads a spin rate off a video."""

from __future__ import annotations

import math
import os
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from plategait.cli import filmed, options, report
from plategait.cli.groups import grouped
from plategait.errors import InputError
from plategait.files.output import check_outputs
from plategait.units import FREQUENCY

if TYPE_CHECKING:
    from plategait.vision.setup import Setup
    from plategait.vision.track import Track

_FILMS = (".mp4", ".mkv", ".mov")


@grouped
def track(
    video: Annotated[str, typer.Argument(metavar="VIDEO", help="A video file, or the number of a camera.")],
    filmed_as: filmed.FilmedOptions,
    frequency: Annotated[
        str | None, typer.Option("--frequency", help='Of the plate: "24 Hz". Measured where the frame rate allows.')
    ] = None,
    preview: Annotated[
        Path | None, typer.Option("--preview", help="Write a film with what was tracked drawn over it: .mp4.")
    ] = None,
    out: Annotated[Path | None, typer.Option("--out", help="Write the pose in each frame: .csv.")] = None,
    as_json: options.Json = False,
) -> None:
    """Spin rate of an object on the plate from a video: by its two markers, its texture or its outline."""
    check_outputs((preview, _FILMS, "--preview"), (out, (".csv",), "--out"))
    if os.path.isdir(video):
        raise InputError("VIDEO", video, "a video file; a folder has a command of its own",
                         f"plategait track-folder {video}")  # fmt: skip
    filmed.require_opencv()
    from plategait.vision.track import track as follow_object

    setup = filmed_as.setup(FREQUENCY.read(frequency, "--frequency") if frequency is not None else None)
    with ExitStack() as open_files:
        follow = open_files.enter_context(_preview(preview, setup)) if preview else None
        progress = open_files.enter_context(report.progress_bar("tracking"))
        result = follow_object(video, setup, follow=follow, progress=progress)
    if out:
        from plategait.vision.preview import write_poses

        write_poses(result, out)
    report.print_json(result.summary()) if as_json else print_track(result)
    raise typer.Exit(0 if math.isfinite(result.spin.rate) else 1)


def print_track(result: Track) -> None:
    """Print what a clip shows."""
    s = result.summary()

    def number(value: float | None, unit: str, digits: int = 1) -> str:
        return "–" if value is None else f"{value:.{digits}f} {unit}"

    low, high = s["spin_rate_interval_deg_s"]
    rows = [
        ["spin rate", number(s["spin_rate_deg_s"], "deg/s", 2)],
        ["95 % interval", "–" if low is None else f"{low:.2f} to {high:.2f} deg/s"],
        ["settled", "yes" if s["settled"] else "no"],
        ["looks the same at", _rates(s["indistinguishable_rates_deg_s"])],
        ["drift of the centre", number(s["drift_mm"], "mm")],
        ["what became of it", f"{s['failure']} at {s['failure_time_s']:.2f} s" if s["failure"] else "stayed"],
        ["radius", _with_half(s, "radius", "mm", 2)],
        ["area", _with_half(s, "area", "mm2", 0)],
        ["velocity along the bar", _with_half(s, "velocity_x", "mm_s", 2)],
        ["velocity across the bar", _with_half(s, "velocity_y", "mm_s", 2)],
        ["lift of the rim", _with_half(s, "rim_lift", "mm", 1)],
        ["bending amplitude", _with_half(s, "bending_amplitude", "deg", 1)],
        ["followed by", s["method"] + (f", alike after 1/{s['symmetry']} turn" if s["symmetry"] > 1 else "")],
        ["sure frames", f"{s['sure_frames']} of {s['frames']}, {number(s['fps'], 'per second', 2)}"],
        ["plate frequency", _plate_frequency(s)],
        ["plate tilt A_p", number(s["plate_tilt_deg"], "deg")],
    ]
    rows += [[f"  {reason}", f"{count} frames"] for reason, count in list(s["uncertain"].items())[:5]]
    report.print_table(s["clip"], ["", ""], rows)
    if s["no_spin_rate"]:
        print(f"no spin rate: {s['no_spin_rate']}")
    for what, reason in (("outline", s["no_outline"]), ("lift of the rim", s["no_rim_lift"])):
        if reason and not (what != "outline" and s["no_outline"]):
            print(f"no {what}: {reason}")
    for note in s["notes"]:
        print(note)


def _with_half(s: dict[str, Any], name: str, unit: str, digits: int) -> str:
    """A number with half its 95 % interval."""
    value, interval = s[f"{name}_{unit}"], s[f"{name}_interval_{unit}"]
    if value is None:
        return "–"
    spoken = {"mm2": "mm²", "mm_s": "mm/s"}.get(unit, unit)
    return f"{value:.{digits}f} ± {interval[1] - value:.{max(digits, 1)}f} {spoken}"


def _rates(rates: list[float]) -> str:
    return ", ".join(f"{r:.0f}" for r in rates) + " deg/s" if rates else "–"


def _plate_frequency(s: dict[str, Any]) -> str:
    """Plate frequency where it is known; one that was only seen never without those that look the same."""
    if s["plate_frequency_hz"] is not None:
        return f"{s['plate_frequency_hz']:.2f} Hz"
    if s["plate_frequency_seen_hz"] is None:
        return "–"
    return (
        " or ".join(f"{f:.4g}" for f in sorted([s["plate_frequency_seen_hz"], *s["plate_frequency_aliases_hz"]]))
        + " Hz"
    )


def _preview(path: Path, setup: Setup) -> Any:
    from plategait.vision.preview import USUAL_FPS, preview

    return preview(path, setup.plate_size, setup.fps or USUAL_FPS)
