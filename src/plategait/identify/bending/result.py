"""Stiffness and damping of the bending joint from a strip that is released and sags (section 3.3.1, Fig. 3.5(a))."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Literal, get_args

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.identify.bending.sag import SagCase, SagFit, Wall, follow_wall, prepare, regress, simulate_both
from plategait.identify.fit import determined, fragment_of, if_determined, scaled, undetermined_note
from plategait.identify.series import Window
from plategait.model.fragment import Fragment
from plategait.model.measured import Measured, as_json
from plategait.shown import Shown
from plategait.theory.two_links import LEAST_ROWS, Angles, Strip

Method = Literal["trajectory", "regression"]

PER_DEGREE = 1e3 * math.radians(1)  # from N m/rad to N mm/deg

_CORRELATED = 0.9  # beyond which stiffness and damping are hard to tell apart
_LARGE_RESIDUAL = 0.2  # share of the range of φ2


@dataclass(frozen=True, eq=False, repr=False)
class BendingResult(Shown):
    """What a bending recording says of the joint.

    Parameters
    ----------
    stiffness, damping : Measured
        k_b and c_b of a tile edge, N m/rad and N m s/rad.
    correlation : float
        Between the two.
    method, wall : str
        How they were found: see `identify_bending`.
    wall_stiffness, wall_damping : Measured or None
        Of joint 1, where they were fitted, as measured on the strip.
    strip : Strip
        Link that was assumed.
    time, phi_2, reconstruction : (n,) arrays
        Time used (s), measured and reconstructed φ2 (rad).
    residual_rms : float
        Of φ2, rad.
    notes : tuple of str
        What a reader should know.
    """

    stiffness: Measured
    damping: Measured
    correlation: float
    method: Method
    wall: Wall
    wall_stiffness: Measured | None
    wall_damping: Measured | None
    strip: Strip
    time: Array
    phi_2: Array
    reconstruction: Array
    notes: tuple[str, ...]

    @property
    def residual_rms(self) -> float:
        """Root mean square of what the reconstruction misses of φ2, rad."""
        return float(np.sqrt(np.mean((self.phi_2 - self.reconstruction) ** 2)))

    @property
    def parameters(self) -> dict[str, Measured]:
        """Parameters that the recording determines, by their name in a scenario."""
        both = {"sheet.bending_stiffness": self.stiffness, "sheet.bending_damping": self.damping}
        return {name: measured for name, measured in both.items() if determined(measured)}

    def to_fragment(self) -> Fragment:
        """Part of a scenario with what was determined."""
        source = f"identified from a bending recording by {self.method}, {len(self.time)} samples"
        return fragment_of(self.parameters, self.correlation, source)

    def summary(self) -> dict[str, Any]:
        """Numbers for a program, in the units of Table 4.1."""
        return {
            "bending_stiffness_n_mm_per_deg": as_json(if_determined(self.stiffness), PER_DEGREE),
            "bending_damping_n_mm_s_per_deg": as_json(if_determined(self.damping), PER_DEGREE),
            "correlation": self.correlation,
            "wall_stiffness_n_mm_per_deg": as_json(if_determined(self.wall_stiffness), PER_DEGREE),
            "wall_damping_n_mm_s_per_deg": as_json(if_determined(self.wall_damping), PER_DEGREE),
            "method": self.method,
            "wall": self.wall,
            "link_mass_g": 1e3 * self.strip.mass,
            "link_length_mm": 1e3 * self.strip.length,
            "samples": len(self.time),
            "residual_rms_deg": math.degrees(self.residual_rms),
            "notes": list(self.notes),
        }


def identify_bending(
    recording: Angles,
    *,
    strip: Strip | None = None,
    width: float | None = None,
    method: Method = "trajectory",
    wall: Wall = "measured",
    centripetal: bool = True,
    window: Window | None = None,
) -> BendingResult:
    """Find k_b and c_b from the sagging of a released strip.

    Parameters
    ----------
    recording : Angles
        Joint angles over time; rows before the release are cut off by `window`.
    strip : Strip, optional
        Mass and length of one link; those of section 3.3.2 by default.
    width : float, optional
        Of the strip, m. A tile edge is as wide as the link is long, so that k_b and c_b are scaled by l/width.
    method : {"trajectory", "regression"}
        "trajectory": the motion is simulated and fitted to the angles. "regression": (3.3) to (3.5), on derivatives of
        smoothing splines. Camera noise then stands in the regressors, which shrinks c_b most, and the smoothing takes
        away from the accelerations; the interval does not know of either.
    wall : {"measured", "free", "joint"}
        What moves link 1 in a simulation. "measured": its own recorded motion, as a spline that is fitted together
        with the rest, so that nothing is assumed of the clamp. "free": joint 1 with stiffness and damping of its own,
        fitted too; needs a clamp that acts as a Kelvin–Voigt joint. "joint": joint 1 is as joint 2; the narrowest
        intervals, but wrong for most clamps, as half a link bends between wall and first node, not a whole one.
    centripetal : bool
        Whether the term that (3.3) drops is kept.
    window : Window, optional
        Times used.

    Raises
    ------
    InputError
        Fewer than 12 rows; angles that do not change; a strip that rises; unknown method or wall.
    """
    strip = strip or Strip()
    for option, got, allowed in (("--method", method, get_args(Method)), ("--wall", wall, get_args(Wall))):
        if got not in allowed:
            raise InputError(option, got, f"one of {', '.join(allowed)}", allowed[0])
    rows = (window or Window()).cut(recording.time, recording.phi_1, recording.phi_2, least=LEAST_ROWS)
    _check(*rows[1:])
    case, notes = prepare(strip, rows, centripetal)
    sag = _fit_sag(case, method, wall)
    scale = 1.0 if width is None else strip.length / width
    result = BendingResult(
        stiffness=scaled(sag.stiffness, scale),
        damping=scaled(sag.damping, scale),
        correlation=sag.correlation,
        method=method,
        wall=wall if method == "trajectory" else "measured",
        wall_stiffness=sag.wall_stiffness,
        wall_damping=sag.wall_damping,
        strip=strip,
        time=case.begun + case.t,
        phi_2=case.phi[:, 1],
        reconstruction=sag.reconstruction,
        notes=(),
    )
    return replace(result, notes=(*notes, *sag.notes, *_doubts(result)))


def _fit_sag(case: SagCase, method: Method, wall: Wall) -> SagFit:
    if method == "regression":
        return regress(case)
    return follow_wall(case) if wall == "measured" else simulate_both(case, wall)


def _check(phi_1: Array, phi_2: Array) -> None:
    if np.ptp(phi_2) == 0:
        raise InputError("recording, phi2", f"{math.degrees(phi_2[0]):.4g} deg in every row", "an angle that changes",
                         "a recording of a strip that is released and sags")  # fmt: skip
    last = len(phi_2) // 3
    if phi_1[-last:].mean() + phi_2[-last:].mean() <= 0:
        raise InputError("recording", "a strip that ends above the horizontal", "one that sags, with angles downwards",
                         "--y-down for pictures, or the angles with their signs turned")  # fmt: skip


def _doubts(result: BendingResult) -> list[str]:
    """What speaks against taking the numbers as they are."""
    doubts = []
    if abs(result.correlation) > _CORRELATED:
        doubts.append(f"stiffness and damping correlate by {result.correlation:.2f}: mostly their combination is known")
    if result.residual_rms > _LARGE_RESIDUAL * float(np.ptp(result.phi_2)):
        doubts.append(
            "the reconstruction misses a large part of the motion: check mass, length, and the release (--from)"
        )
    doubts += undetermined_note("stiffness", result.stiffness, PER_DEGREE, "N*mm/deg")
    doubts += undetermined_note("damping", result.damping, PER_DEGREE, "N*mm/(deg/s)")
    return doubts
