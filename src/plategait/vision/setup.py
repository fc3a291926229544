"""How a clip was filmed, which tracking takes as told."""

from __future__ import annotations

from dataclasses import dataclass

from plategait.camera.camera import Calibration
from plategait.errors import InputError


@dataclass(frozen=True)
class Setup:
    """How a clip was filmed.

    Attributes
    ----------
    plate_size : (length, width)
        m, along the bar and across it.
    fiducial : float, optional
        Side of the fiducials at the plate's corners, m; by default a sixth of the plate's shorter side.
    plate : {"auto", "fiducials", "outline", "scale"}
        What the plate is known by.
    scale : float, optional
        Metres in a pixel, for a camera that looks straight down on the plate; then `plate` is "scale".
    object : {"auto", "markers", "texture", "outline"}
        What the object's orientation is known by.
    calibration : Calibration, optional
        Of the lens.
    fps : float, optional
        Frames per second at which it was taken, where the file says otherwise.
    plate_frequency : float, optional
        Of the plate, Hz.
    seconds : float, optional
        Of the clip to use; of a camera, how long to film.
    """

    plate_size: tuple[float, float] = (0.1, 0.1)
    fiducial: float | None = None
    plate: str = "auto"
    scale: float | None = None
    object: str = "auto"
    calibration: Calibration | None = None
    fps: float | None = None
    plate_frequency: float | None = None
    seconds: float | None = None

    @property
    def fiducial_side(self) -> float:
        """Side of the fiducials, m."""
        return min(self.plate_size) / 6 if self.fiducial is None else self.fiducial

    def __post_init__(self) -> None:
        """Refuse what cannot be."""
        for name, value, among in (
            ("--plate", self.plate, ("auto", "fiducials", "outline", "scale")),
            ("--object", self.object, ("auto", "markers", "texture", "outline")),
        ):
            if value not in among:
                raise InputError(name, value, f"one of {', '.join(among)}", "auto")
        for name, length, used in (
            ("--fiducial", self.fiducial, ("auto", "fiducials")),
            ("--scale", self.scale, ("auto", "scale")),
        ):
            if length is not None and self.plate not in used:
                raise InputError(name, f"{1e3 * length:g} mm", f"left out with --plate {self.plate}", "--plate auto")
        if self.plate == "scale" and self.scale is None:
            raise InputError("--scale", "nothing", "the size of a pixel on the plate", "0.2 mm")
