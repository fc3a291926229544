"""The commands that read a spin rate off a video, and print what a plate needs for it."""

from __future__ import annotations

import math
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from plategait.cli import options, report
from plategait.errors import InputError
from plategait.output import check_outputs, check_writable
from plategait.units import FREQUENCY, Quantity

if TYPE_CHECKING:
    from plategait.vision.survey import Setup
    from plategait.vision.track import Track

_LENGTH = Quantity("m", "mm", "100 mm", above=0)
_SCALE = Quantity("m", "mm", "0.2 mm", above=0)
_TIME = Quantity("s", "s", "10 s", above=0)
_FILMS = (".mp4", ".mkv", ".mov")

PlateSize = Annotated[
    str, typer.Option("--plate-size", help='Of the plate, along the bar and across it: "100 mm x 100 mm".')
]
Fiducial = Annotated[
    str | None,
    typer.Option("--fiducial", help="Side of the markers at the plate's corners; a sixth of the plate if left out."),
]


def track(
    video: Annotated[
        str,
        typer.Argument(metavar="VIDEO", help="A video file, the number of a camera, or a folder of clips for --curve."),
    ],
    plate_size: PlateSize = "100 mm",
    fiducial: Fiducial = None,
    plate: Annotated[
        str, typer.Option("--plate", help="Known by: auto, fiducials (plategait target), outline, or scale.")
    ] = "auto",
    scale: Annotated[
        str | None, typer.Option("--scale", help='Of a camera straight above, one pixel: "0.2 mm".')
    ] = None,
    object_by: Annotated[str, typer.Option("--object", help="Known by: auto, markers, texture, or outline.")] = "auto",
    frequency: Annotated[
        str | None, typer.Option("--frequency", help='Of the plate: "24 Hz". Measured where the frame rate allows.')
    ] = None,
    fps: Annotated[
        float | None, typer.Option("--fps", help="Frames per second it was taken at, where the file says otherwise.")
    ] = None,
    calibration: Annotated[
        Path | None, typer.Option("--calibration", help="Of the lens: a JSON file with matrix and distortion.")
    ] = None,
    seconds: Annotated[
        str | None, typer.Option("--duration", help='Part of the clip to use, or time to film: "10 s".')
    ] = None,
    preview: Annotated[
        Path | None, typer.Option("--preview", help="Write a film with what was tracked drawn over it: .mp4.")
    ] = None,
    out: Annotated[Path | None, typer.Option("--out", help="Write the pose in each frame: .csv.")] = None,
    curve: Annotated[
        Path | None,
        typer.Option("--curve", help="Of a folder with a clip for each plate frequency: the spin curve, .csv."),
    ] = None,
    frequencies: Annotated[
        Path | None, typer.Option("--frequencies", help="Plate frequencies of the clips: .csv of clip, frequency_hz.")
    ] = None,
    cantilever: Annotated[
        bool, typer.Option("--cantilever", help="Follow three red markers on a strip, for identify bending.")
    ] = False,
    link_length: Annotated[
        str | None, typer.Option("--link-length", help='Between the markers of --cantilever, gives mm: "10 mm".')
    ] = None,
    as_json: options.Json = False,
) -> None:
    """Spin rate of an object on the plate from a video: by its two markers, its texture or its outline."""
    check_outputs((preview, _FILMS, "--preview"), (out, (".csv",), "--out"), (curve, (".csv",), "--curve"))
    require_opencv()
    if cantilever:
        return _cantilever(video, fps, seconds, link_length, out, as_json)
    from plategait.vision.camera import read_calibration
    from plategait.vision.survey import Setup
    from plategait.vision.track import track as follow_object

    size = read_size(plate_size)
    setup = Setup(
        plate_size=size,
        fiducial=_LENGTH.read(fiducial, "--fiducial") if fiducial is not None else None,
        plate=plate,
        scale=_SCALE.read(scale, "--scale") if scale is not None else None,
        object=object_by,
        calibration=read_calibration(calibration) if calibration is not None else None,
        fps=fps,
        plate_frequency=FREQUENCY.read(frequency, "--frequency") if frequency is not None else None,
        seconds=_TIME.read(seconds, "--duration") if seconds is not None else None,
    )
    if curve is not None or Path(video).is_dir():
        return _folder(video, setup, curve, frequencies, as_json)
    with ExitStack() as open_files:
        follow = open_files.enter_context(_preview(preview, setup)) if preview else None
        progress = open_files.enter_context(report.progress_bar("tracking"))
        result = follow_object(video, setup, follow=follow, progress=progress)
    if out:
        from plategait.vision.preview import write_poses

        write_poses(result, out)
    report.print_json(result.summary()) if as_json else print_track(result)
    raise typer.Exit(0 if math.isfinite(result.spin.rate) else 1)


def _folder(folder: str, setup: Setup, out: Path | None, frequencies: Path | None, as_json: bool) -> None:
    """A clip for each plate frequency becomes a spin curve."""
    from plategait.curve import write_curve
    from plategait.vision.folder import curve_of_clips, read_frequencies, track_folder

    if out is None:
        raise InputError(
            "--curve", f"nothing for the folder {folder}", "a file for the spin curve", "--curve curve.csv"
        )
    known = read_frequencies(frequencies) if frequencies is not None else None
    with report.progress_bar("tracking") as progress:
        clips = track_folder(folder, setup, frequencies=known, progress=progress)
    found = curve_of_clips(clips, Path(folder).name)
    write_curve(found, out)
    if as_json:
        summaries = [c.track.summary() if c.track else {"clip": c.path.name, "no_spin_rate": c.trouble} for c in clips]
        report.print_json({"curve": str(out), "points": found.summary()["points"], "clips": summaries})
    else:
        rows = []
        for c in clips:
            spin = c.track.spin if c.track else None
            rate = f"{math.degrees(spin.rate):.1f}" if spin and math.isfinite(spin.rate) else "–"
            half = f"{math.degrees(spin.high - spin.low) / 2:.2g}" if spin and math.isfinite(spin.rate) else "–"
            frequency = f"{c.frequency:.4g} ({c.known_by})" if math.isfinite(c.frequency) else "–"
            rows.append([c.path.name, frequency, rate, half, c.failure or c.trouble or "–"])
        report.print_table(str(out), ["clip", "plate (Hz)", "deg/s", "± 95 %", "remark"], rows)
    raise typer.Exit(0 if any(math.isfinite(r) for r in found.spin_rate_deg_s) else 1)


def _cantilever(
    film: str, fps: float | None, seconds: str | None, link_length: str | None, out: Path | None, as_json: bool
) -> None:
    """Three red markers on a strip become the table that `identify bending` reads."""
    from plategait.vision.cantilever import track_cantilever

    seen = track_cantilever(
        film, fps=fps, seconds=_TIME.read(seconds, "--duration") if seconds is not None else None,
        link_length=_LENGTH.read(link_length, "--link-length") if link_length is not None else None,
    )  # fmt: skip
    if out:
        seen.write(out)
    sure, n = int(seen.sure.sum()), len(seen.sure)
    if as_json:
        report.print_json({"clip": film, "frames": n, "sure_frames": sure, "notes": list(seen.notes),
                           "out": str(out) if out else None})  # fmt: skip
    else:
        print(
            f"{film}: three markers in {sure} of {n} frames"
            + (f"; try plategait identify bending {out}" if out else "")
        )
        for note in seen.notes:
            print(note)


def target(
    out: Annotated[Path, typer.Argument(metavar="TARGET.pdf", help="File to write.")],
    plate_size: PlateSize = "100 mm",
    fiducial: Fiducial = None,
) -> None:
    """Print the markers for a plate's corners and for the object, at true scale."""
    check_writable(out, (".pdf",), "TARGET.pdf")
    require_opencv()
    from plategait.vision.fiducials import plate_target, write_target_pdf

    size = read_size(plate_size)
    side = _LENGTH.read(fiducial, "--fiducial") if fiducial is not None else min(size) / 6
    write_target_pdf(plate_target(*size, side), out)
    print(f"{out}: print at 100 %, check by the ruler; plate {_mm(size[0])} x {_mm(size[1])}, markers {_mm(side)}")


def read_size(text: str) -> tuple[float, float]:
    """Length and width of a plate, m, from "100 mm x 80 mm", or "100 mm" for a square one."""
    parts = [part.strip() for part in text.lower().replace("×", "x").split("x")]
    if not 1 <= len(parts) <= 2:
        raise InputError("--plate-size", text, "one length, or two with an x between", '"100 mm x 80 mm"')
    unit = parts[-1].lstrip("0123456789.eE+- ")
    sizes = [_LENGTH.read(p if p[-1:].isalpha() else f"{p} {unit}", "--plate-size") for p in parts]
    return sizes[0], sizes[-1]


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
        ["followed by", s["method"] + (f", alike after 1/{s['symmetry']} turn" if s["symmetry"] > 1 else "")],
        ["sure frames", f"{s['sure_frames']} of {s['frames']}, {number(s['fps'], 'per second', 2)}"],
        ["plate frequency", number(s["plate_frequency_hz"], "Hz", 2)],
        ["plate tilt A_p", number(s["plate_tilt_deg"], "deg")],
    ]
    rows += [[f"  {reason}", f"{count} frames"] for reason, count in list(s["uncertain"].items())[:5]]
    report.print_table(s["clip"], ["", ""], rows)
    if s["no_spin_rate"]:
        print(f"no spin rate: {s['no_spin_rate']}")
    for note in s["notes"]:
        print(note)


def _rates(rates: list[float]) -> str:
    return ", ".join(f"{r:.0f}" for r in rates) + " deg/s" if rates else "–"


def _preview(path: Path, setup: Setup) -> Any:
    from plategait.vision.preview import USUAL_FPS, preview

    return preview(path, setup.plate_size, setup.fps or USUAL_FPS)


def require_opencv() -> None:
    """Say what to install where OpenCV is missing."""
    try:
        import cv2  # noqa: F401
    except ImportError:
        raise InputError(
            "track", "nothing to see with", "OpenCV installed", 'pip install "plategait[vision]"'
        ) from None


def _mm(length: float) -> str:
    return f"{1e3 * length:.4g} mm"
