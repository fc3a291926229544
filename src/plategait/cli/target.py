"""The command that prints what a plate and an object need to be tracked."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from plategait.cli import filmed, options, report
from plategait.files.output import check_writable


def target(
    out: Annotated[Path, typer.Argument(metavar="TARGET.pdf", help="File to write.")],
    plate_size: filmed.PlateSize = "100 mm",
    fiducial: filmed.Fiducial = None,
    as_json: options.Json = False,
) -> None:
    """Print the markers for a plate's corners and for the object, at true scale."""
    check_writable(out, (".pdf",), "TARGET.pdf")
    from plategait.camera.fiducials import plate_target, write_target_pdf

    size = filmed.read_size(plate_size)
    side = filmed.LENGTH.read(fiducial, "--fiducial") if fiducial is not None else min(size) / 6
    write_target_pdf(plate_target(*size, side), out)
    if as_json:
        return report.print_json({
            "out": str(out), "plate_length_mm": 1e3 * size[0], "plate_width_mm": 1e3 * size[1],
            "fiducial_mm": 1e3 * side,
        })  # fmt: skip
    print(f"{out}: print at 100 %, check by the ruler; plate {_mm(size[0])} x {_mm(size[1])}, markers {_mm(side)}")


def _mm(length: float) -> str:
    return f"{1e3 * length:.4g} mm"
