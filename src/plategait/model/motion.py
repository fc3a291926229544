"""How the plate moves: sines on each degree of freedom, or a sampled trajectory, with a smooth start."""

from __future__ import annotations

import math
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, field_validator, model_validator

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.files.rows import read_rows
from plategait.model.base import Kept, Model
from plategait.units import ANGLE, PLATE_ANGLE, PLATE_STROKE, STROKE, Angle, Delay, Frequency, Offset, Quantity, Ratio

AXES = ("x", "y", "z", "rx", "ry", "rz")
Axis = Literal["x", "y", "z", "rx", "ry", "rz"]

# Samples nearer to each other or larger than any plate's are slips, and their speeds leave floating point.
SHORTEST_SAMPLE, LARGEST_SAMPLE = 1e-9, 1e9  # s; m or rad

# A ramp no longer than this is none, s: the core adds as much to what it divides by.
SHORTEST_RAMP = 1e-12


class Wave(Model):
    """One sine on one degree of freedom: amplitude · sin(2π · ratio · f · t + phase).

    Source: (4.1), (4.2) of the dissertation are two of them in phase.
    """

    axis: Axis = Field(
        description="x (along the bar), y, z, or a rotation rx (about the bar), ry, rz", examples=['"z"']
    )
    amplitude: float = Field(description="length on x, y, z; angle on rx, ry, rz", examples=["0.003"])
    ratio: Ratio = Field(default=1.0, description="frequency over the motion's frequency")
    phase: Angle = Field(default=0.0, description="phase at the start")

    @model_validator(mode="before")
    @classmethod
    def _amplitude_by_axis(cls, data: Any) -> Any:
        if isinstance(data, dict) and "amplitude" in data and data.get("axis") in AXES:
            quantity = _amplitude_on(data["axis"])
            return {**data, "amplitude": quantity.read(data["amplitude"], "amplitude")}
        return data

    def quantity(self, name: str) -> Quantity | None:
        """What a field measures: the amplitude a length or an angle, by the axis."""
        return _amplitude_on(self.axis) if name == "amplitude" else super().quantity(name)


def _amplitude_on(axis: Axis) -> Quantity:
    return ANGLE if axis.startswith("r") else STROKE


class Samples(Model):
    """A trajectory given point by point; missing axes stay put, and the last pose is kept. SI units."""

    time: tuple[float, ...] = Field(description="times of the samples, s, from 0", examples=["[0.0, 0.01, 0.02]"])
    x: tuple[float, ...] = Field(default=(), description="along the bar, m")
    y: tuple[float, ...] = Field(default=(), description="across the bar, m")
    z: tuple[float, ...] = Field(default=(), description="upwards, m")
    rx: tuple[float, ...] = Field(default=(), description="about the bar, rad")
    ry: tuple[float, ...] = Field(default=(), description="about y, rad")
    rz: tuple[float, ...] = Field(default=(), description="about z, rad")

    @model_validator(mode="after")
    def _consistent(self) -> Samples:
        time = np.array(self.time)
        if len(time) > 1 and 0 < np.diff(time).min() < SHORTEST_SAMPLE:
            raise InputError(
                "time",
                f"samples {np.diff(time).min():.2g} s apart",
                f"samples at least {SHORTEST_SAMPLE:g} s apart",
                "[0.0, 0.01, 0.02]",
            )
        if len(time) < 2 or not np.isfinite(time).all() or (np.diff(time) <= 0).any() or time[0] != 0:
            raise InputError(
                "time", f"{len(time)} values", "2 or more finite times that rise from 0 s", "[0.0, 0.01, 0.02]"
            )
        for axis in AXES:
            values = getattr(self, axis)
            if values and (len(values) != len(time) or not np.abs(values).max() <= LARGEST_SAMPLE):
                raise InputError(
                    axis,
                    f"{len(values)} values",
                    f"{len(time)} values, one for each time, of at most {LARGEST_SAMPLE:g} in size",
                    f"[0.0] * {len(time)}",
                )
        return self

    def knots(self, step: float, end: float = math.inf) -> NDArray[np.float64]:
        """Position and speed on each axis every `step` seconds, from a cubic spline: (n, 12).

        They reach a knot past `end` or past the last sample, whichever comes first.
        """
        from scipy.interpolate import CubicSpline

        time = np.arange(0, min(self.time[-1], end) + 2 * step, step)
        within = np.minimum(time, self.time[-1])
        table = np.zeros((len(time), 12))
        for d, axis in enumerate(AXES):
            if values := getattr(self, axis):
                spline = CubicSpline(self.time, values, bc_type="natural")
                table[:, 2 * d] = spline(within)
                table[:, 2 * d + 1] = np.where(time < self.time[-1], spline(within, 1), 0.0)
        return table

    def derivatives(self, time: Array) -> Array:
        """(4, 6, n) position, speed, acceleration and jerk of the spline at times; it stays past its last sample."""
        from scipy.interpolate import CubicSpline

        moves = np.zeros((4, len(AXES), len(time)))
        within = np.clip(time, 0.0, self.time[-1])
        for d, axis in enumerate(AXES):
            if values := getattr(self, axis):
                spline = CubicSpline(self.time, values, bc_type="natural")
                moves[:, d] = [spline(within, n) for n in range(4)]
        moves[1:, :, time > self.time[-1]] = 0.0
        return moves

    @property
    def finest_step(self) -> float:
        """Shortest time between two samples, s."""
        return float(np.diff(self.time).min())


class Held(Model):
    """Where the plate is held off its rest, about which it moves."""

    x: Offset = Field(default=0.0, description="along the bar")
    y: Offset = Field(default=0.0, description="across the bar")
    z: Offset = Field(default=0.0, description="upwards")
    rx: Annotated[float, PLATE_ANGLE] = Field(default=0.0, description="about the bar, which is off level by it")
    ry: Annotated[float, PLATE_ANGLE] = Field(default=0.0, description="about y")
    rz: Annotated[float, PLATE_ANGLE] = Field(default=0.0, description="about z")

    @cached_property
    def pose(self) -> tuple[float, ...]:
        """Offset on each axis, m and rad, in the order of `AXES`."""
        return tuple(getattr(self, axis) for axis in AXES)


def read_samples(path: Path, field: str = "samples") -> Samples:
    """Read a trajectory from CSV with the columns time_s and any of x_mm, y_mm, z_mm, rx_deg, ry_deg, rz_deg.

    Speeds and accelerations beside them, as `plategait export` writes them (x_mm_s, x_mm_s2), are left out: they are
    those of the spline through the positions.

    Parameters
    ----------
    path : Path
        File to read.
    field : str
        What errors call it.

    Raises
    ------
    InputError
        When the file cannot be read, or a column or number is not as said.
    """
    scale = {"time_s": 1.0} | {
        f"{a}_deg" if a.startswith("r") else f"{a}_mm": math.pi / 180 if a.startswith("r") else 1e-3 for a in AXES
    }
    rows = [row for _, row in read_rows(path, field, '"motion.csv"')[0]]
    names = rows.pop(0) if rows else []
    slopes = {f"{name}{per}" for name in names for per in ("_s", "_s2") if name in scale}
    kept = [i for i, name in enumerate(names) if name not in slopes]
    # Of a row that is short or long nothing is kept, so that it is refused.
    rows = [[row[i] for i in kept] if len(row) == len(names) else [] for row in rows]
    names = [names[i] for i in kept]
    if "time_s" not in names or not set(names) <= set(scale) or len(set(names)) < len(names):
        said = ", ".join(names) if set(names) & set(scale) else f"{len(names)} of no known name" if names else "none"
        raise InputError(field, f"columns {said} in {path.name}",
                         f"time_s and any of {', '.join(list(scale)[1:])}, once each",
                         "a first line such as time_s,x_mm,rx_deg")  # fmt: skip
    try:
        columns = {
            name.split("_")[0]: tuple(float(cell) * scale[name] for cell in column)
            for name, column in zip(names, zip(*rows, strict=True), strict=True)
        }
    except ValueError:
        raise InputError(field, str(path), "one number for each column in every row", "a file without gaps") from None
    return Samples(**columns)


def rotation_of(pose: NDArray[np.float64]) -> NDArray[np.float64]:
    """(…, 3, 3) rotation Rx Ry Rz of (…, 6) poses: its columns are the plate's axes as the world sees them."""
    (cx, cy, cz), (sx, sy, sz) = np.moveaxis(np.cos(pose[..., 3:]), -1, 0), np.moveaxis(np.sin(pose[..., 3:]), -1, 0)
    rows = [[cy * cz, -cy * sz, sy],
            [cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy],
            [sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy]]  # fmt: skip
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


class PlateMotion(Model):
    """Motion of the plate. The short form is (4.1), (4.2): Θ(t) = −A_p sin ω_p t about the bar, X(t) = B_p sin ω_p t.

    The rotation is Rx(Θx) Ry(Θy) Rz(Θz), about a point `height` below the middle of the plate's surface: the bar's axis
    where the plate lies on the bar. `waves` add to the short form, `samples` to both, and `offset` is where the plate
    is held meanwhile: before it starts, the object lies on a plate that stands there.
    """

    frequency: Frequency = Field(default=24.0, description="f_p, of the sines")
    angle: Annotated[float, PLATE_ANGLE] = Field(
        default=math.radians(3), description="A_p, angular amplitude about the bar"
    )
    stroke: Annotated[float, PLATE_STROKE] = Field(default=0.003, description="B_p, linear amplitude along the bar")
    height: Offset = Field(default=0.0, description="height of the plate's surface above the axis that it turns about")
    ramp: Delay = Field(default=0.1, description="duration of the smooth start")
    offset: Held = Field(default_factory=Held, description="where the plate is held off its rest, from the start on")
    waves: tuple[Wave, ...] = Field(
        default=(),
        description="further sines, on any axis",
        examples=['[{ axis = "z", amplitude = "1 mm" }]'],
    )
    samples: Samples | None = Field(
        default=None, description="CSV file of a sampled trajectory", examples=['"motion.csv"']
    )

    @field_validator("samples", mode="before")
    @classmethod
    def _read_file(cls, value: Any) -> Any:
        return read_samples(Path(value), field="") if isinstance(value, (str, Path)) else value

    @cached_property
    def _terms(self) -> tuple[tuple[int, float, float, float], ...]:
        waves = [
            (AXES.index(w.axis), w.amplitude, w.ratio * self.frequency, w.phase / (2 * math.pi)) for w in self.waves
        ]
        short = [
            (AXES.index("x"), self.stroke, self.frequency, 0.0),
            (AXES.index("rx"), -self.angle, self.frequency, 0.0),
        ]
        return tuple(term for term in (*short, *waves) if term[1] != 0)

    def terms(self) -> tuple[tuple[int, float, float, float], ...]:
        """Sines as (degree of freedom, amplitude, frequency in Hz, phase in turns)."""
        return self._terms

    def pose_at_start(self) -> NDArray[np.float64]:
        """(6,) translations and rotations that the plate starts from, m and rad: its offset in a smooth start."""
        pose = np.array(self.offset.pose)
        if self.ramp > SHORTEST_RAMP:
            return pose
        for d, amplitude, _, phase in self.terms():
            pose[d] += amplitude * math.sin(2 * math.pi * phase)
        for d, axis in enumerate(AXES):
            if self.samples is not None and (values := getattr(self.samples, axis)):
                pose[d] += values[0]
        return pose

    @cached_property
    def shortest_period(self) -> float:
        """Period of the fastest sine, s; infinite where there is none."""
        fastest = max((frequency for _, _, frequency, _ in self.terms()), default=0.0)
        return 1 / fastest if fastest > 0 else math.inf

    @property
    def most(self) -> Array | None:
        """(4, 6) position, speed, acceleration and jerk that its offset and sines never exceed, in the order of `AXES`.

        The sums of what each sine reaches: exact where there is one on an axis. None with a sampled trajectory.
        """
        return self._most.array

    @cached_property
    def _most(self) -> Kept:
        if self.samples is not None:
            return Kept(None)
        most = [[abs(offset) for offset in self.offset.pose], [0.0] * 6, [0.0] * 6, [0.0] * 6]
        for d, amplitude, frequency, _ in self.terms():
            omega, reached = 2 * math.pi * frequency, abs(amplitude)
            for row in most:
                row[d] += reached
                reached *= omega
        return Kept(np.array(most))

    @cached_property
    def period(self) -> float:
        """Time after which the sines repeat, s: that of the frequency, or a multiple where ratios are not whole.

        Finite however slow the plate is.
        """
        denominators = [Fraction(w.ratio).limit_denominator(12).denominator for w in self.waves if w.ratio != 1]
        return min(math.lcm(1, *denominators) / self.frequency, 1e300)
