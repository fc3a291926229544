"""The command that turns a film of a sagging strip into the table that `identify bending` reads."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from plategait.cli import filmed, options, report
from plategait.files.output import check_outputs
from plategait.units import Quantity

_LINK = Quantity("m", "mm", "10 mm", above=0, at_most=1)


def track_strip(
    film: Annotated[str, typer.Argument(metavar="FILM", help="A strip from the side, with three red markers on it.")],
    fps: filmed.Fps = None,
    seconds: filmed.Part = None,
    link_length: Annotated[
        str | None, typer.Option("--link-length", help='Between neighbouring markers, for mm: "10 mm". px if left out.')
    ] = None,
    out: Annotated[Path | None, typer.Option("--out", help="Write the markers, for identify bending: .csv.")] = None,
    as_json: options.Json = False,
) -> None:
    """Markers of a strip that sags after its release, from a high-speed film."""
    check_outputs((out, (".csv",), "--out"))
    filmed.require_opencv()
    from plategait.vision.strip import track_cantilever

    track = track_cantilever(
        film, fps=fps, seconds=filmed.read_part(seconds),
        link_length=_LINK.read(link_length, "--link-length") if link_length is not None else None,
    )  # fmt: skip
    if out:
        track.write(out)
    sure, n = int(track.sure.sum()), len(track.sure)
    scale = None if track.scale is None else 1e3 * track.scale
    if as_json:
        return report.print_json({
            "clip": film, "frames": n, "sure_frames": sure, "duration_s": float(track.time[-1]), "mm_per_pixel": scale,
            "notes": list(track.notes), "out": str(out) if out else None,
        })  # fmt: skip
    print(
        f"{film}: three markers in {sure} of {n} frames over {track.time[-1]:.3g} s"
        + (f", a pixel is {scale:.3g} mm" if scale else "")
        + (f"; try plategait identify bending {out}" if out else "")
    )
    for note in track.notes:
        print(note)
