"""What chapters 4 and 5 find beside the fits, under a choice: best accelerations and friction, and what matters not."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from plategait import published
from plategait.arrays import Array
from plategait.campaign.plan import Sweep
from plategait.campaign.run import sweep
from plategait.curve.curve import Curve
from plategait.simulation.observables import GAITS
from plategait.study.aims import MAY_MISS, NO_FIT
from plategait.study.evaluation import FITS_FROM, base, curve_of, fit_from, printed_values
from plategait.study.progress import Progress, part
from plategait.study.unknowns import Choice, parameters
from plategait.thesis.cases import STIFFNESSES, Case, damping_factor, reference_cases
from plategait.thesis.items.acceleration import best_at_all, flat_top, stiffness_cases
from plategait.thesis.items.friction import FrictionMap, friction_cases
from plategait.thesis.items.trends import damping_cases, damping_change

STROKE = 3e-3
"""B_p of all figures, m."""
STROKES = (2e-3, 4e-3)
"""B_p whose influence is looked at, m (section 4.4)."""
_STROKE_FREQUENCIES = (16.0, 18.0, 20.0, 22.0)
FRICTION_MAY_MISS = 10.0
"""Deviation of a best friction angle that counts as one, deg."""


@dataclass(frozen=True, eq=False)
class Findings:
    """What a choice makes of the findings that are no numbers of the 44 curves.

    Attributes
    ----------
    acceleration_gap : (8,) array
        Of each object of Fig. 4.7 how far apart the accelerations are that are best at each amplitude, over their
        middle: 0 where one is best at all; NaN where nothing stays.
    friction_deg : (3,) array
        Best friction angle sliding, walking and running (Fig. 4.8), deg; NaN where no sheet shows the gait.
    damping_change : float
        Relative change of b/f0 over eightfold damping (Fig. 5.10).
    stroke_exponent : float
        Power of B_p that the rate goes with (section 4.4 says that it has no influence).
    """

    acceleration_gap: Array
    friction_deg: Array
    damping_change: float
    stroke_exponent: float

    def deviations(self) -> dict[str, Array]:
        """Deviations from what is published by kind, each over what it may miss, as those of the 44 curves."""
        wanted = np.array([published.single(f"friction_{gait}").value for gait in GAITS])
        kinds = {
            "best acceleration": self.acceleration_gap / MAY_MISS["peak"],
            "best friction": (self.friction_deg - wanted) / FRICTION_MAY_MISS,
            "damping": np.array([self.damping_change / MAY_MISS["peak"]]),
            "stroke": np.array([self.stroke_exponent / MAY_MISS["line"]]),
        }
        return {
            kind: np.where(np.isfinite(values), np.clip(values, -2 * NO_FIT, 2 * NO_FIT), NO_FIT)
            for kind, values in kinds.items()
        }

    def loss(self) -> float:
        """Sum of squares of all of them."""
        return float(sum((values**2).sum() for values in self.deviations().values()))

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`; None where there is none."""
        plain = [float(x) if math.isfinite(x) else None for x in self.friction_deg]
        return {
            "objects_with_one_best_acceleration": int((self.acceleration_gap == 0).sum()),
            "best_friction_deg": dict(zip(GAITS, plain, strict=True)),
            "change_of_b_over_f0_with_damping": self.damping_change,
            "stroke_exponent": self.stroke_exponent,
            "loss": self.loss(),
        }


@dataclass(frozen=True)
class _Line:
    """One line of points: a case over the plate's frequency, at a B_p (m)."""

    case: Case
    frequencies: tuple[float, ...]
    stroke: float = STROKE

    def settings(self, choice: Choice, printed: Mapping[str, float]) -> dict[str, Any]:
        """Parameters under a choice, but for the frequency."""
        settled = parameters(choice, printed, self.case.omega_pi * math.pi)
        for name in ("sheet.bending_damping", "sheet.axial_damping"):
            settled[name] *= damping_factor(self.case.variant)
        return settled | {
            "motion.angle": math.radians(self.case.angle_deg),
            "motion.stroke": self.stroke,
            "friction_angle": math.radians(self.case.alpha_deg),
        }


def _lines() -> tuple[_Line, ...]:
    """All lines, each once."""
    cases = (*stiffness_cases(), *friction_cases(), *damping_cases())
    lines = [_Line(case, case.frequencies) for case in cases]
    lines += [_Line(case, _STROKE_FREQUENCIES, stroke) for case in _slow_cases() for stroke in STROKES]
    return tuple(dict.fromkeys(lines))


def _slow_cases() -> list[Case]:
    """Cases whose rates at several B_p are compared."""
    return [case for case in reference_cases() if case.angle_deg == 3]


def find(
    choices: Sequence[Choice],
    folder: Path,
    name: str,
    *,
    starts: int,
    seed: int,
    dask: object = None,
    progress: Progress | None = None,
) -> tuple[Findings, ...]:
    """Simulate what the findings stand on under each choice, in stores that resume.

    Parameters
    ----------
    choices, folder, name, starts, seed, dask, progress
        See `plategait.study.evaluation.evaluate`; what is found is over all starts together.

    Raises
    ------
    InputError
        When a store is another's, damaged, or cannot be written.
    """
    lines, printed = _lines(), printed_values()
    found: list[Findings] = []
    for i, choice in enumerate(choices):
        rows = [line.settings(choice, printed) | {"motion.frequency": f} for line in lines for f in line.frequencies]
        points = {key: [row[key] for row in rows] for key in rows[0]}
        plan = Sweep(name=name, scenario=base(), points=points, repeats=1 + starts, seed=seed, batch=2000)
        report = part(progress, i / len(choices), 1 / len(choices))
        outcomes = sweep(plan, folder / f"{name}-{i:04d}.zarr", dask=dask, progress=report).outcomes
        curves: dict[_Line, Curve] = {}
        first = 0
        for line in lines:
            curves[line] = curve_of(outcomes, slice(first, first + len(line.frequencies)), line.frequencies)
            first += len(line.frequencies)
        found.append(_findings(curves))
    return tuple(found)


def _findings(curves: Mapping[_Line, Curve]) -> Findings:
    """What is found of curves by line."""

    def curve(case: Case) -> Curve:
        return curves[_Line(case, case.frequencies)]

    gaps = []
    for omega in STIFFNESSES:
        cases = [case for case in stiffness_cases() if case.omega_pi == omega]
        low, high = best_at_all(omega, ((c.angle_deg, flat_top(curve(c), _acceleration(c))) for c in cases))
        gaps.append(max(0.0, low - high) / ((low + high) / 2) if math.isfinite(low + high) else math.nan)
    cases = friction_cases()
    alphas = np.array([case.alpha_deg for case in cases])
    friction = FrictionMap(alphas, _acceleration(cases[0]), tuple(curve(case) for case in cases))
    best = [friction.best_in(gait) for gait in GAITS]
    damped = damping_cases()
    eta = np.array([damping_factor(case.variant) for case in damped])
    fits = [fit_from(curve(case), FITS_FROM[0][3]) for case in damped]
    ratio = np.array([math.nan if fit is None else fit.b_over_f0 for fit in fits])
    exponents: list[float] = []
    for case in _slow_cases():
        small, large = (curves[_Line(case, _STROKE_FREQUENCIES, stroke)] for stroke in STROKES)
        both = small.fitted & large.fitted
        ratios = large.spin_rate_deg_s[both] / small.spin_rate_deg_s[both]
        exponents += (np.log(ratios[ratios > 0]) / math.log(STROKES[1] / STROKES[0])).tolist()
    return Findings(
        np.array(gaps),
        np.array([float(np.nanmedian(of_gait)) if of_gait.size else math.nan for of_gait in best]),
        damping_change(eta, ratio),
        float(np.median(exponents)) if exponents else math.nan,
    )


def _acceleration(case: Case) -> Array:
    """A_p ω_p² at each frequency of a case, 10⁴ deg/s²."""
    return case.angle_deg * (math.tau * np.array(case.frequencies)) ** 2 / 1e4
