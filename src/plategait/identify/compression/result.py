"""Stiffness and damping of the axial joint from a pressed link (section 3.3.1, Fig. 3.5(b))."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.files.table import Column, read_table
from plategait.identify.fit import determined, fit, fragment_of, if_determined, interval, scaled, undetermined_note
from plategait.identify.series import Window, follow, smooth, thin
from plategait.model.fragment import Fragment
from plategait.model.measured import Measured, as_json
from plategait.shown import Shown

Method = Literal["trajectory", "regression"]

LEAST_ROWS = 6  # of fewer, speed and scatter cannot both be told
_MOST_ROWS = 2000
_REACH = 50.0  # times the first guess, up to which stiffness and damping are sought
_LARGE_RESIDUAL = 0.1  # share of the range of the force
_EXAMPLE = "headings time_s,displacement_mm,force_N"


@dataclass(frozen=True, eq=False)
class Pressing:
    """A press: time (rising, s), displacement into the link (m) and force on it (N), each (n,)."""

    time: Array
    displacement: Array
    force: Array


@dataclass(frozen=True, eq=False, repr=False)
class CompressionResult(Shown):
    """What a compression recording says of the joint.

    Parameters
    ----------
    surface_stiffness, surface_damping : Measured
        k_s and c_s over the upper surface, N/m and N s/m.
    conversion : float
        (d/l)² of (3.9), from k_s, c_s to k_c, c_c.
    correlation : float
        Between stiffness and damping.
    offset : Measured or None
        Force where the displacement reads zero, N, if it was fitted.
    method : str
        How they were fitted: see `identify_compression`.
    time, displacement, force, reconstruction : (n,) arrays
        What was used (s, m, N), and the reconstructed force (N).
    notes : tuple of str
        What a reader should know.
    """

    surface_stiffness: Measured
    surface_damping: Measured
    conversion: float
    correlation: float
    offset: Measured | None
    method: Method
    time: Array
    displacement: Array
    force: Array
    reconstruction: Array
    notes: tuple[str, ...]

    @property
    def stiffness(self) -> Measured:
        """k_c of (3.9), N/m."""
        return scaled(self.surface_stiffness, self.conversion)

    @property
    def damping(self) -> Measured:
        """c_c of (3.9), N s/m."""
        return scaled(self.surface_damping, self.conversion)

    @property
    def residual_rms(self) -> float:
        """Root mean square of what the reconstruction misses of the force, N."""
        return float(np.sqrt(np.mean((self.force - self.reconstruction) ** 2)))

    @property
    def parameters(self) -> dict[str, Measured]:
        """Parameters that the recording determines, by their name in a scenario."""
        both = {"sheet.axial_stiffness": self.stiffness, "sheet.axial_damping": self.damping}
        return {name: measured for name, measured in both.items() if determined(measured)}

    def to_fragment(self) -> Fragment:
        """Part of a scenario with what was determined."""
        source = f"identified from a compression recording by {self.method}, {len(self.time)} samples"
        return fragment_of(self.parameters, self.correlation, source)

    def summary(self) -> dict[str, Any]:
        """Numbers for a program, in the units of Table 4.1."""
        return {
            "surface_stiffness_n_per_mm": as_json(if_determined(self.surface_stiffness), 1e-3),
            "surface_damping_n_s_per_mm": as_json(if_determined(self.surface_damping), 1e-3),
            "axial_stiffness_n_per_mm": as_json(if_determined(self.stiffness), 1e-3),
            "axial_damping_n_s_per_mm": as_json(if_determined(self.damping), 1e-3),
            "correlation": self.correlation,
            "conversion": self.conversion,
            "offset_n": as_json(self.offset),
            "method": self.method,
            "samples": len(self.time),
            "residual_rms_n": self.residual_rms,
            "notes": list(self.notes),
        }


def read_pressing(path: Path | str) -> Pressing:
    """Read a press from a CSV file with time, displacement and force.

    Raises
    ------
    InputError
        See `read_table`.
    """
    columns = {"time": Column("s"), "displacement": Column("m"), "force": Column("N")}
    table = read_table(path, columns, field="recording", example=_EXAMPLE, least_rows=LEAST_ROWS, rising="time")
    return Pressing(table["time"], table["displacement"], table["force"])


def convert(p_s: float, thickness: float, length: float) -> float:
    """Turn a parameter of the upper surface into that of the lateral one, p_c = p_s (d/l)², equation (3.9).

    The source's k_c of 0.79 N/mm goes back to a k_s of 12.6 N/mm, which it prints as 12.
    """
    return p_s * (thickness / length) ** 2


def identify_compression(
    recording: Pressing,
    *,
    thickness: float = 0.0025,
    length: float = 0.01,
    method: Method = "trajectory",
    offset: bool = False,
    window: Window | None = None,
) -> CompressionResult:
    """Find k_s and c_s of a pressed link, and k_c and c_c by (3.9).

    Parameters
    ----------
    recording : Pressing
    thickness, length : float
        d and l of the link, m; those of section 3.3.2 by default.
    method : {"trajectory", "regression"}
        "trajectory": the displacement is a spline, fitted to its own samples and, through (3.6), to those of the force,
        each weighted by its own scatter, so that noise of the encoder is not taken for motion. "regression": (3.6) to
        (3.8), with the speed from a spline of the displacement alone.
    offset : bool
        Whether to fit a force at displacement zero as well. A preload, a load cell that does not read zero and a jaw
        that touches where the encoder does not read zero all show as this one number.
    window : Window, optional
        Times used.

    Raises
    ------
    InputError
        Too few rows; a displacement or force that does not change; a force that falls as the jaw closes; unknown
        method.
    """
    if method not in get_args(Method):
        raise InputError("--method", method, f"one of {', '.join(get_args(Method))}", "trajectory")
    rows = (window or Window()).cut(recording.time, recording.displacement, recording.force, least=LEAST_ROWS)
    (time, s, f), block = thin(*rows, most=_MOST_ROWS)
    _check(s, f)
    estimate = _regress if method == "regression" else _follow
    result = replace(estimate(time, s, f, offset), conversion=convert(1.0, thickness, length))
    thinned = (f"thinned: means over {block} rows at a time",) if block > 1 else ()
    return replace(result, notes=(*thinned, *result.notes, *_doubts(result)))


def _check(s: Array, f: Array) -> None:
    for name, values in (("displacement", s), ("force", f)):
        if not np.isfinite(values).all():
            raise InputError(
                f"recording, {name}", "a value that is no number", "a number in every row", "leaving it out"
            )
        if np.ptp(values) == 0:
            raise InputError(f"recording, {name}", f"{values[0]:.4g} in every row", "a signal that changes",
                             "a recording of a jaw that closes")  # fmt: skip
    if _slope(s, f) <= 0:
        raise InputError("recording", "a force that falls as the displacement grows", "a force that resists the jaw",
                         "the sign of one of them turned")  # fmt: skip


def _slope(s: Array, f: Array) -> float:
    """Slope of the force over the displacement, N/m."""
    centred = s - s.mean()
    return float(centred @ f / (centred @ centred))


def _regress(time: Array, s: Array, f: Array, offset: bool) -> CompressionResult:
    """(3.6) to (3.8) with the speed from a spline."""
    columns = [smooth(time, s)(time, 1), s, *([np.ones_like(s)] if offset else [])]
    matrix = np.column_stack(columns)
    size = np.abs(matrix).max(axis=0)
    scaled = matrix / np.where(size > 0, size, 1.0)
    p = np.linalg.lstsq(scaled, f, rcond=None)[0]
    residual = f - scaled @ p
    dof = len(f) - len(p)
    covariance = np.linalg.pinv(scaled.T @ scaled) * float(residual @ residual) / dof
    sd = np.sqrt(np.diag(covariance))
    c_s, k_s, *rest = (interval(v / z, d / z, dof) for v, d, z in zip(p, sd, size, strict=True))
    correlation = float(covariance[0, 1] / (sd[0] * sd[1])) if sd[0] * sd[1] > 0 else 0.0
    notes = ("regression: noise of the displacement stands in the regressors; compare with the trajectory fit",)
    return CompressionResult(
        k_s, c_s, 1.0, correlation, rest[0] if rest else None, "regression", time, s, f, scaled @ p, notes
    )


def _follow(time: Array, s: Array, f: Array, offset: bool) -> CompressionResult:
    """Displacement as a spline, fitted to displacement and force together."""
    # Finer than cross-validation would have it, which would smooth some of the motion away: the force restrains it too.
    t, start = time - time[0], follow(time - time[0], s)
    value, speed = start.matrix(t), start.matrix(t, 1)
    depth, slope = float(np.ptp(s)), _slope(s, f)
    # Damping in units that would make its force as large as the whole.
    unit_k, unit_c, unit_f = (
        slope,
        float(np.ptp(f)) / max(float(np.abs(speed @ start.coefficients).max()), 1e-300),
        float(np.ptp(f)),
    )
    extra = 1 if offset else 0

    def model(p: Array) -> Array:
        spline = depth * p[2 + extra :]
        force = unit_c * p[1] * (speed @ spline) + unit_k * p[0] * (value @ spline)
        return np.stack([value @ spline, force + (unit_f * p[2] if offset else 0.0)], axis=1)

    begin = np.r_[[1.0, 0.1], [0.0] * extra, start.coefficients / depth]
    free = np.full(len(begin) - 2, np.inf)
    # Damping below zero is allowed, so that an interval can say that there may be none.
    fitted = fit(model, np.stack([s, f], axis=1), begin, np.r_[[1e-3, -_REACH], -free], np.r_[[_REACH] * 2, free],
                correlated=False)  # fmt: skip
    notes = (fitted.structure_note,) if fitted.structured else ()
    reconstruction = model(fitted.parameters[:, None])[:, 1, 0]
    return CompressionResult(
        fitted.measured(0, unit_k), fitted.measured(1, unit_c), 1.0, fitted.correlation(0, 1),
        fitted.measured(2, unit_f) if offset else None, "trajectory", time, s, f, reconstruction, notes,
    )  # fmt: skip


def _doubts(result: CompressionResult) -> tuple[str, ...]:
    """What speaks against taking the numbers as they are."""
    doubts = []
    if result.residual_rms > _LARGE_RESIDUAL * float(np.ptp(result.force)):
        hint = "" if result.offset else ", or try --offset"
        doubts.append(f"the reconstruction misses a large part of the force: press less far{hint}")
    doubts += undetermined_note("stiffness k_s", result.surface_stiffness, 1e-3, "N/mm")
    doubts += undetermined_note("damping c_s", result.surface_damping, 1e-3, "N/(mm/s); press faster")
    return tuple(doubts)
