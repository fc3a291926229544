"""How a clip was filmed: the options that the track commands share, and what they add up to."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from plategait.errors import InputError
from plategait.units import Quantity

if TYPE_CHECKING:
    from plategait.vision.setup import Setup

LENGTH = Quantity("m", "mm", "100 mm", above=0, at_most=10)
_SCALE = Quantity("m", "mm", "0.2 mm", above=0, at_most=0.1)
_TIME = Quantity("s", "s", "10 s", above=0)

PlateSize = Annotated[
    str, typer.Option("--plate-size", help='Of the plate, along the bar and across it: "100 mm x 100 mm".')
]
Fiducial = Annotated[
    str | None,
    typer.Option("--fiducial", help="Side of the markers at the plate's corners; a sixth of the plate if left out."),
]
PlateBy = Annotated[
    str, typer.Option("--plate", help="Known by: auto, fiducials (plategait target), outline, or scale.")
]
Scale = Annotated[str | None, typer.Option("--scale", help='Of a camera straight above, one pixel: "0.2 mm".')]
ObjectBy = Annotated[str, typer.Option("--object", help="Known by: auto, markers, texture, or outline.")]
Fps = Annotated[
    float | None, typer.Option("--fps", help="Frames per second it was taken at, where the file says otherwise.")
]
Lens = Annotated[
    Path | None, typer.Option("--calibration", help="Of the lens: a JSON file with matrix and distortion.")
]
Part = Annotated[
    str | None, typer.Option("--duration", help='Part of the clip to use, or time to film: "10 s". All if left out.')
]


@dataclass(frozen=True)
class FilmedOptions:
    """How a clip was filmed, as it was typed."""

    plate_size: PlateSize = "100 mm"
    fiducial: Fiducial = None
    plate: PlateBy = "auto"
    scale: Scale = None
    object_by: ObjectBy = "auto"
    fps: Fps = None
    calibration: Lens = None
    seconds: Part = None

    def setup(self, plate_frequency: float | None = None) -> Setup:
        """Set-up that the options tell, each read under its own name."""
        from plategait.camera.camera import read_calibration
        from plategait.vision.setup import Setup

        return Setup(
            plate_size=read_size(self.plate_size),
            fiducial=LENGTH.read(self.fiducial, "--fiducial") if self.fiducial is not None else None,
            plate=self.plate,
            scale=_SCALE.read(self.scale, "--scale") if self.scale is not None else None,
            object=self.object_by,
            calibration=read_calibration(self.calibration) if self.calibration is not None else None,
            fps=self.fps,
            plate_frequency=plate_frequency,
            seconds=read_part(self.seconds),
        )


def read_part(text: str | None) -> float | None:
    """Part of a clip to use, s; None for all of it."""
    return _TIME.read(text, "--duration") if text is not None else None


# Two lengths with something else than an x between.
_BETWEEN = re.compile(r"(\d[\d.]*\s*[a-z]*)\s*(?:by|and|,|\*|;|/)\s*(\d[\d.]*\s*[a-z]*)")


def read_size(text: str, option: str = "--plate-size") -> tuple[float, float]:
    """Length and width of a plate or an outline, m, from "100 mm x 80 mm", or "100 mm" for a square one."""
    parts = [part.strip() for part in text.lower().replace("×", "x").split("x")]
    if not 1 <= len(parts) <= 2 or not all(parts):
        raise InputError(option, text, "one length, or two with an x between", '"100 mm x 80 mm"')
    if len(parts) == 1 and (between := _BETWEEN.fullmatch(parts[0])):
        hint = f'"{between[1].strip()} x {between[2].strip()}"'
        raise InputError(option, text, "one length, or two with an x between", hint)
    unit = parts[-1].lstrip("0123456789.eE+- ")
    sizes = [LENGTH.read(p if p[-1:].isalpha() else f"{p} {unit}".strip(), option) for p in parts]
    return sizes[0], sizes[-1]


def require_opencv() -> None:
    """Say what to install where OpenCV is missing."""
    try:
        import cv2  # noqa: F401
    except ImportError:
        raise InputError(
            "track", "nothing to see with", "OpenCV installed", 'pip install "plategait[vision]"'
        ) from None
