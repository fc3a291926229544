"""How a synthetic film looks: what is on the object and the plate, the light, the camera's faults, the file's."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

from plategait.errors import InputError

Colour = tuple[int, int, int]

CHEESE: Colour = (250, 196, 72)
MARKER_BLUE: Colour = (18, 64, 140)

_RANGES: dict[str, tuple[float, float]] = {
    "texture": (0, 1), "plate_texture": (0, 1), "glare": (0, 2), "gradient": (0, 0.9), "brightness": (0.05, 3),
    "shadow": (0, 1), "noise": (0, 64), "exposure": (0, 1), "defocus": (0, 20), "crf": (0, 51), "drop": (0, 0.9),
    "duplicate": (0, 0.9), "jitter": (0, 0.9), "hidden": (0, 0.9), "samples": (1, 64),
}  # fmt: skip


@dataclass(frozen=True)
class Appearance:
    """What a film looks like; the defaults are a plain indoor scene.

    Parameters
    ----------
    markers : bool
        Whether the object carries its two rectangular markers.
    fiducials : bool
        Whether the plate carries its four corner markers.
    fiducial_size : float, optional
        Side of a corner marker, m; by default a sixth of the plate's shorter side.
    object_colour, marker_colour, plate_colour : (red, green, blue)
        0 to 255.
    texture : float
        Contrast of the object's own speckle, as food has; 0 is plain.
    plate_texture : float
        Contrast of the plate's brushing and stains.
    seed : int
        Of textures, noise, and everything that happens by chance.
    glare : float
        Strength of the shine on the plate and the object; at 1 it reaches white.
    gradient : float
        Share of the light that the darkest corner lacks.
    brightness : float
        Factor on the light.
    shadow : float
        How much darker it is under the object's edge.
    exposure : float
        Share of the frame interval for which the shutter is open; 0 freezes all motion.
    samples : int
        Fewest moments that an exposure is made of; fast motion takes more.
    defocus : float
        Standard deviation of the blur of a lens out of focus, px.
    noise : float
        Standard deviation, grey levels.
    distortion : tuple of float
        k1, k2, p1, p2, k3 of the lens, used where no camera is given.
    crf : int
        Quality of the H.264 file: 18 is good, 35 is poor, 0 loses nothing but colour resolution.
    drop : float
        Share of frames that are missing; the time stamps of the others stay true.
    duplicate : float
        Share of frames that repeat the picture before.
    jitter : float
        Spread of the frame interval over its mean: a variable frame rate, with true time stamps.
    hidden : float
        Share of frames in which something covers a marker, wholly or in part.
    """

    markers: bool = True
    fiducials: bool = True
    fiducial_size: float | None = None
    object_colour: Colour = CHEESE
    marker_colour: Colour = MARKER_BLUE
    plate_colour: Colour = (196, 200, 204)
    texture: float = 0.3
    plate_texture: float = 0.2
    seed: int = 0
    glare: float = 0.15
    gradient: float = 0.15
    brightness: float = 0.9
    shadow: float = 0.4
    exposure: float = 0.25
    samples: int = 4
    defocus: float = 0.5
    noise: float = 2.0
    distortion: tuple[float, ...] = ()
    crf: int = 20
    drop: float = 0.0
    duplicate: float = 0.0
    jitter: float = 0.0
    hidden: float = 0.0

    def __post_init__(self) -> None:
        """Refuse what cannot be filmed."""
        for field in fields(self):
            value = getattr(self, field.name)
            if field.name in _RANGES:
                low, high = _RANGES[field.name]
                if not (math.isfinite(value) and low <= value <= high):
                    # Who types 40 for a share means 40 %.
                    works = value / 100 if high <= 1 and low <= value / 100 <= high else field.default
                    raise InputError(f"appearance.{field.name}", value, f"from {low:g} to {high:g}", f"{works:g}")
            elif field.name.endswith("colour") and not (len(value) == 3 and all(0 <= c <= 255 for c in value)):
                raise InputError(
                    f"appearance.{field.name}", value, "red, green, blue from 0 to 255", f"{field.default}"
                )
