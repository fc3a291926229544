"""What a clip shows of the object beside its turning: outline, size, velocity, the lift of its rim, and if it left."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from plategait.arrays import Array, Flags
from plategait.vision.departure import Departure, departure_of
from plategait.vision.object.form import Form, fit_form
from plategait.vision.object.rim import DIRECTIONS, RAYS
from plategait.vision.velocity import HALF_95, UNKNOWN, Velocity, velocity_of

# Bending joints in the source's sheets are so long, as a share of the radius: four of them from the middle to the rim.
LINK = 0.25
# Share of the edge that must be seen for its middle.
LEAST_SEEN = 0.6
# What the angles of joints are known to beside the lift: how the sheet bends from its middle to its rim is not seen.
SHAPE_SHARE = 0.35
# Every so many rays are told.
TOLD = 4
UNTOLD = (math.nan, math.nan)


@dataclass(frozen=True, eq=False)
class Findings:
    """What a clip shows of the object.

    Attributes
    ----------
    place : (n, 2) array
        Of the outline's middle, m; of the centre marker or of what is seen of the object where it has none.
    area_seen : (n,) array
        As it is seen on the plate's plane, thickness and lift included, m²; NaN where it was not.
    form : Form or None
    no_form : str
        Why there is none.
    velocity : Velocity
    departure : Departure
    """

    place: Array
    area_seen: Array
    form: Form | None
    no_form: str
    velocity: Velocity
    departure: Departure

    @property
    def radius(self) -> tuple[float, float]:
        """Of a circle with the object's area, m, and its standard deviation."""
        return UNTOLD if self.form is None else (self.form.radius, self.form.radius_sd)

    @property
    def area(self) -> tuple[float, float]:
        """Of the object lying flat, m², and its standard deviation."""
        return UNTOLD if self.form is None else (self.form.area, self.form.area_sd)

    @property
    def rim_lift(self) -> tuple[float, float]:
        """Greatest height of the rim over its lowest place in a period of the swing, m, and its standard deviation."""
        return UNTOLD if self.form is None else (self.form.rim_lift, self.form.rim_lift_sd)

    @property
    def bending_amplitude(self) -> tuple[float, float]:
        """Largest rms angle of bending joints a quarter of the radius long, rad, and its standard deviation.

        Of a rim that lifts as a parabola: its curvature along the radius, all around.
        """
        lift, sd = self.rim_lift
        bent = math.nan if self.form is None else _bending(self.form)
        return bent * lift, bent * math.hypot(sd, SHAPE_SHARE * lift)

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`."""
        form, v = self.form, self.velocity
        return {
            "failure": self.departure.kind or None,
            "failure_time_s": self.departure.time,
            **_told("radius", "mm", self.radius, 1e3),
            **_told("area", "mm2", self.area, 1e6),
            "outline_mm": None if form is None else [round(1e3 * float(r), 3) for r in form.outline[::TOLD]],
            "no_outline": self.no_form or None,
            **_told("velocity_x", "mm_s", (v.x, v.x_half / HALF_95), 1e3),
            **_told("velocity_y", "mm_s", (v.y, v.y_half / HALF_95), 1e3),
            **_told("rim_lift", "mm", self.rim_lift, 1e3, least=0.0),
            **_told("bending_amplitude", "deg", self.bending_amplitude, math.degrees(1), least=0.0),
            "no_rim_lift": self.no_form or (form.lift_unknown if form is not None else "") or None,
        }


def _told(name: str, unit: str, known: tuple[float, float], scale: float, least: float = -math.inf) -> dict[str, Any]:
    """A number and its 95 % interval, of which what is below the least that it may be is cut off."""
    value, half = scale * known[0], scale * HALF_95 * known[1]
    return {f"{name}_{unit}": value, f"{name}_interval_{unit}": [max(value - half, least), value + half]}


def _bending(form: Form) -> float:
    """Largest rms angle of joints at any phase of the swing, rad a m of lift: of parabolas through the whole rim."""
    if not form.lift.size:
        return math.nan
    height = form.lift - form.lift.min(axis=0)
    curvature = 2 * height / height.max() / form.radius**2
    return float(np.sqrt(np.mean(curvature**2, axis=1)).max()) * LINK * form.radius


def outline_middle(seen: Array, rims: Array) -> tuple[Array, Array]:
    """(n, 2) middle of the area within edges (n, RAYS) about points (n, 2), m, and (n,) area, m²; NaN where too few."""
    enough = np.isfinite(rims).mean(axis=1) > LEAST_SEEN
    filled = np.where(np.isfinite(rims), rims, np.nanmedian(np.where(enough[:, None], rims, 0.0), axis=1)[:, None])
    towards = np.stack([np.cos(DIRECTIONS), np.sin(DIRECTIONS)], axis=-1)
    area = (filled**2).mean(axis=1) * math.pi
    moment = (filled**3) @ towards * (2 * math.pi / RAYS / 3)
    middle = seen + moment / np.maximum(area, 1e-12)[:, None]
    return np.where(enough[:, None], middle, math.nan), np.where(enough, area, math.nan)


def whereabouts(
    time: Array, seen: Array, sure: Flags, rims: Array, plate: tuple[float, float]
) -> tuple[Array, Array, Departure]:
    """Where the object's middle is (n, 2), m, its area (n,), m², and whether and when it left; arguments as below."""
    middle, area = outline_middle(seen, rims)
    known = np.isfinite(area)
    # What the edge says of the middle is taken where it says it; a marker stays off by what it was off.
    off = np.median((middle - seen)[known & sure], axis=0) if (known & sure).any() else np.zeros(2)
    place = np.where(known[:, None], middle, np.where(sure[:, None], seen + off, math.nan))
    size = float(np.sqrt(np.nanmedian(area[known & sure]) / math.pi)) if (known & sure).any() else 0.0
    return place, area, departure_of(time, place, size, plate)


def findings(
    time: Array,
    seen: Array,
    angle: Array,
    sure: Flags,
    rims: Array,
    *,
    eye: Array | None,
    swing: float | None,
    fps: float,
    plate: tuple[float, float],
    pixel: float,
    marked: bool,
    no_edge: str = "",
) -> Findings:
    """What a clip shows of the object, from where it and its edge were seen.

    Parameters
    ----------
    time, angle : (n,) arrays
        s, rad.
    seen : (n, 2) array
        Of the object, m; NaN where it was not.
    sure : (n,) bool array
        Frames whose pose is sure.
    rims : (n, RAYS) array
        Distances of the edge from there, m.
    eye : (n, 3) array, optional
        Of the camera in the plate's frame, m.
    swing, fps : float
        Plate's frequency as it is or is seen, and frames per second, Hz.
    plate : (length, width)
        m.
    pixel : float
        m on the plate.
    marked : bool
        Whether what is seen is a marker in the object's middle.
    no_edge : str
        Why the edge was not looked for.
    """
    place, area, departure = whereabouts(time, seen, sure, rims, plate)
    stays = sure & ~(time > departure.time)
    form, no_form = None, no_edge
    if not no_edge:
        phase = None if swing is None else 2 * math.pi * swing * time[stays]
        form = fit_form(
            angle[stays], seen[stays], rims[stays], None if eye is None else eye[stays], phase, pixel, marked=marked
        )
        no_form = "" if form else "its edge is seen in too few frames"
    velocity = velocity_of(time[stays], place[stays], swing, fps) if stays.any() else UNKNOWN
    return Findings(place, area, form, no_form, velocity, departure)
