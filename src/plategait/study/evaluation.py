"""The 44 published curves simulated under many choices at once: a campaign each, and the fits of its curves."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from plategait import published
from plategait.arrays import Array
from plategait.campaign.plan import Sweep
from plategait.campaign.run import sweep
from plategait.curve.curve import Curve
from plategait.curve.quick_lorentz import Shape, fit_shape
from plategait.model.presets import preset
from plategait.model.scenario import Scenario
from plategait.published import FRICTION_RATIO, PublishedCurve
from plategait.simulation.ensemble import Ensemble
from plategait.simulation.observables import GAITS
from plategait.study.progress import Progress, part
from plategait.study.unknowns import Choice, parameters

FREQUENCIES = {3: tuple(np.arange(13.0, 32.0, 1.0)), 12: tuple(np.arange(9.0, 16.0, 0.5))}
"""Plate frequencies of the curves, Hz, by A_p in deg."""
FITS_FROM = ({3: 13.0, 12: 9.0}, {3: 15.0, 12: 9.5}, {3: 17.0, 12: 10.0})
"""Where the fit begins, Hz by A_p: the source does not say, so that a choice has to hold for three."""
TRANSIENT = 0.6
"""Unmeasured start of each run, s."""
CHOICES_OF_STORE = 16
"""Choices of one store: enough runs to fill the engine, few enough to lose little."""
OUTPUTS = ("f0_hz", "b_over_f0", "peak")
"""What is kept of each fit: Hz, none, deg/s."""


@dataclass(frozen=True, eq=False)
class Evaluation:
    """What choices make of the published curves.

    Attributes
    ----------
    choices : tuple of Choice
    fits : (choices, fits_from, curves, outputs) array
        `OUTPUTS` of each fit in the order of `published.curves`; NaN where a curve has none.
    at_12 : (choices,) array
        Spin rate of Table 4.1's sheet at A_p = 12 deg and 12 Hz, deg/s (section 4.3); NaN where it fails.
    gaits : (choices, 5) array
        Points out of the order of sliding, walking and running, and `ABSENT` for each gait that is missing, of the four
        objects of A_p = 12 deg at the reference friction angle, softest first; and as much for each gait between Table
        4.1's at its fastest and running.
    """

    choices: tuple[Choice, ...]
    fits: Array
    at_12: Array
    gaits: Array

    def only(self, i: int) -> Evaluation:
        """Of one choice."""
        one = slice(i, i + 1)
        return Evaluation(self.choices[one], self.fits[one], self.at_12[one], self.gaits[one])


def _points(choices: Sequence[Choice]) -> dict[str, list[Any]]:
    """Lists by parameter: every frequency of every curve of every choice."""
    printed = printed_values()
    rows: list[dict[str, Any]] = []
    for choice in choices:
        for curve in published.curves():
            settled = parameters(choice, printed, curve.omega_pi * math.pi)
            settled |= {
                "motion.angle": math.radians(curve.angle_deg),
                "friction_angle": math.radians(curve.alpha_deg),
            }
            rows += [settled | {"motion.frequency": f} for f in FREQUENCIES[curve.angle_deg]]
    return {name: [row[name] for row in rows] for name in rows[0]}


def printed_values() -> dict[str, float]:
    """Printed values of Table 4.1 that a choice scales, SI."""
    scenario = preset("cheese-as-printed").scenario
    sheet = scenario.sheet
    return {
        "sheet.bending_stiffness": sheet.bending_stiffness,
        "sheet.bending_damping": sheet.bending_damping,
        "sheet.axial_stiffness": sheet.axial_stiffness,
        "sheet.axial_damping": sheet.axial_damping,
        "contact.damping": scenario.contact.damping,
    }


def base() -> Scenario:
    """What all curves have in common."""
    scenario = preset("cheese-as-printed").scenario
    return scenario.replace(transient=TRANSIENT, friction=scenario.friction.with_ratio(FRICTION_RATIO))


def evaluate(
    choices: Sequence[Choice],
    folder: Path,
    name: str,
    *,
    starts: int = 0,
    seed: int = 0,
    dask: object = None,
    progress: Progress | None = None,
) -> tuple[Evaluation, ...]:
    """Simulate the published curves under each choice, in stores that resume, and fit them.

    Parameters
    ----------
    choices : sequence of Choice
    folder : Path
        Of the stores.
    name : str
        Of this round; the same choices under the same name go on where they were interrupted.
    starts : int
        Slightly different starts of each run, beside the nominal one.
    seed : int
        Of those starts.
    dask, progress
        See `plategait.campaign.run.sweep`.

    Returns
    -------
    evaluations : tuple of Evaluation
        From the nominal start, and from each of the others.

    Raises
    ------
    InputError
        When a store is another's, damaged, or cannot be written.
    """
    made: list[list[Evaluation]] = [[] for _ in range(1 + starts)]
    for first in range(0, len(choices), CHOICES_OF_STORE):
        some = tuple(choices[first : first + CHOICES_OF_STORE])
        plan = Sweep(name=name, scenario=base(), points=_points(some), repeats=1 + starts, seed=seed, batch=2000)
        report = part(progress, first / len(choices), len(some) / len(choices))
        campaign = sweep(plan, folder / f"{name}-{first:04d}.zarr", dask=dask, progress=report)
        for start, evaluations in enumerate(made):
            evaluations.append(Evaluation(some, *_fits(campaign.from_start(start), len(some))))
    return tuple(joined(*evaluations) for evaluations in made)


def _fits(points: Ensemble, n_choices: int) -> tuple[Array, Array, Array]:
    """Fits, rates at 12 deg and 12 Hz, and gaits (see `Evaluation`) of the points of a store."""
    curves = published.curves()
    fits = np.full((n_choices, len(FITS_FROM), len(curves), len(OUTPUTS)), math.nan)
    at_12, gaits, first = np.full(n_choices, math.nan), np.zeros((n_choices, N_GAITS)), 0
    for i in range(n_choices):
        for j, published_curve in enumerate(curves):
            frequencies = FREQUENCIES[published_curve.angle_deg]
            curve = curve_of(points, slice(first, first + len(frequencies)), frequencies, published_curve.table)
            first += len(frequencies)
            for k, start in enumerate(FITS_FROM):
                fit = fit_from(curve, start[published_curve.angle_deg])
                if fit is not None:
                    fits[i, k, j] = [getattr(fit, name) for name in OUTPUTS]
            if published_curve.angle_deg == 12 and is_reference(published_curve):
                gaits[i, GAIT_OBJECTS.index(published_curve.omega_pi)] = out_of_order(curve)
                if published_curve.omega_pi == 10.0:
                    at = frequencies.index(12.0)
                    at_12[i] = math.nan if curve.failed[at] else curve.spin_rate_deg_s[at]
                    gaits[i, -1] = short_of_running(curve)
    return fits, at_12, gaits


GAIT_OBJECTS = sorted({c.omega_pi for c in published.curves() if c.angle_deg == 12})
"""ω_n of the objects whose gaits are looked at, π rad/s."""
N_GAITS = len(GAIT_OBJECTS) + 1
"""Numbers that tell the gaits of a choice: one of each object, and of the fastest point of Table 4.1's."""
ABSENT = 3.0
"""Deviations that a missing gait counts as, as much as a number that cannot be measured: the source shows it."""


def out_of_order(curve: Curve) -> float:
    """How far points below the run-off fall back from an earlier gait, and `ABSENT` for each gait that is missing."""
    steps = np.array([GAITS.index(g) for g, fitted in zip(curve.gait, curve.fitted, strict=True) if fitted and g])
    if not len(steps):
        return ABSENT * len(GAITS)
    return float((np.maximum.accumulate(steps) - steps).sum()) + ABSENT * (len(GAITS) - len(set(steps)))


def short_of_running(curve: Curve) -> float:
    """`ABSENT` for each gait between that of the fastest point below the run-off and running."""
    rate = np.where(curve.fitted, curve.spin_rate_deg_s, -math.inf)
    fastest = curve.gait[int(rate.argmax())] if curve.fitted.any() else ""
    return ABSENT * (len(GAITS) - 1 - (GAITS.index(fastest) if fastest else 0))


def is_reference(curve: PublishedCurve) -> bool:
    """Whether a published curve is of the reference friction angle."""
    return curve.alpha_deg == published.REFERENCE_ALPHA


def curve_of(points: Ensemble, part: slice, frequencies: Sequence[float], name: str = "") -> Curve:
    """Part of a store's points as a curve."""
    return Curve(
        name=name,
        frequency_hz=np.array(frequencies),
        spin_rate_deg_s=np.degrees(points.rate[part]),
        spin_rate_sd_deg_s=np.degrees(points.spread[part]),
        gait=points.gait[part],
        failure=points.failure[part],
        runs=np.full(part.stop - part.start, float(points.runs)),
        failed_runs=points.failed_runs[part].astype(float),
    )


def fit_from(curve: Curve, start: float) -> Shape | None:
    """Lorentz fit of a curve from a frequency (Hz) up to its run-off."""
    used = curve.fitted & (curve.frequency_hz >= start)
    return fit_shape(curve.frequency_hz[used], curve.spin_rate_deg_s[used], ends_in_failure=curve.ends_in_failure)


def joined(*evaluations: Evaluation) -> Evaluation:
    """Several evaluations as one."""
    choices = tuple(choice for each in evaluations for choice in each.choices)
    fits, at_12, gaits = (
        np.concatenate([getattr(e, name) for e in evaluations]) for name in ("fits", "at_12", "gaits")
    )
    return Evaluation(choices, fits, at_12, gaits)
