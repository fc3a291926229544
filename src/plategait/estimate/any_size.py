"""The any-size method: stiffness and friction of an object of any size, regressed on its dimensionless spin curve.

Source: section 5.7 of the dissertation asks for "an extra parameter" by which (5.6) and (5.7) hold for any size.
"""

from __future__ import annotations

import csv
import math
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from plategait.arrays import Array, Flags
from plategait.curve.curve import Curve
from plategait.errors import InputError
from plategait.estimate.kriging import Kriging
from plategait.estimate.linear import LinearEstimate
from plategait.estimate.shipped import shipped
from plategait.model.scenario import Scenario
from plategait.model.similarity import bending_over_weight, elongation, equivalent_radius

ACCELERATIONS = (1.7, 2.2, 2.9, 3.6, 4.4, 5.4)
"""Γ = r A_p ω_p²/g at which a curve is read."""
FIRST, LAST = 1.9, 7.0
"""Γ that the slowest point must not be above; where the fastest must reach unless the object ran off before."""
LEAST_POINTS = 5
INPUTS = (*(f"root_rate_{a:g}" for a in ACCELERATIONS), "log_run_off", "log_angle", "log_stroke", "log_radius", "beta")
"""What is read off a curve and told: the root of ω_B √(r/g) r/B_p at each Γ (the last before the run-off from there
on); logarithms of the run-off's Γ (at most `LAST`), of A_p, of B_p/r and of r; and β."""
SOUGHT = ("log_stiffness", "alpha_deg")
"""Logarithm of √(D/(ρ g r³)), and α."""
# Told or read numbers may lie outside of those that it was made from by this share of their range.
_BEYOND = 0.05
_RATES = len(ACCELERATIONS)


@dataclass(frozen=True)
class Reading:
    """What a curve says in dimensionless numbers, `INPUTS`, and the standard deviation of each from the rates'."""

    values: Array
    sds: Array


def reading(curve: Curve, scenario: Scenario) -> Reading:
    """Read a curve.

    Parameters
    ----------
    curve : Curve
        Points in any order, several at a frequency too.
    scenario : Scenario
        Tells size, A_p, B_p and β.

    Raises
    ------
    InputError
        For a curve that begins too fast, ends too slow, or has too few points before the run-off.
    """
    sheet, motion, g = scenario.sheet, scenario.motion, scenario.gravity
    radius = equivalent_radius(sheet.lattice, sheet.pitch)
    stroke = motion.stroke / radius
    if min(stroke, motion.angle, g) <= 0:
        raise InputError("motion", "a plate without A_p, B_p or gravity", "one with all three", "--method posterior")
    order = np.argsort(curve.frequency_hz, kind="stable")
    frequency, failed = curve.frequency_hz[order], curve.failed[order]
    to_gamma = radius * motion.angle * 4 * math.pi**2 / g
    stays = ~failed & np.isfinite(curve.spin_rate_deg_s[order])
    run_off = _run_off(frequency, failed)
    stays &= frequency < run_off
    _check_range(frequency[stays], run_off, to_gamma)
    unit = math.radians(1) * math.sqrt(radius / g) / stroke
    rates = np.abs(curve.spin_rate_deg_s[order][stays]) * unit
    sds = np.nan_to_num(curve.spin_rate_sd_deg_s[order][stays]) * unit
    x = np.log(to_gamma * frequency[stays] ** 2)
    roots, root_sds = (np.interp(np.log(ACCELERATIONS), x, y) for y in (np.sqrt(rates), _root_sds(rates, sds)))
    told = (min(math.log(to_gamma * run_off**2), math.log(LAST)), math.log(motion.angle), math.log(stroke),
            math.log(radius), scenario.friction.ratio)  # fmt: skip
    return Reading(np.array([*roots, *told]), np.array([*root_sds, *np.zeros(len(told))]))


def _root_sds(rates: Array, sds: Array) -> Array:
    """Standard deviation of the root; of a rate within its own spread, of the root of that spread."""
    return sds / (2 * np.sqrt(np.maximum(rates, np.maximum(sds, 1e-12))))


def _run_off(frequency: Array, failed: Flags) -> float:
    """Frequency between the last point that stays and a failure that another follows, or none after; inf for none."""
    for i in np.flatnonzero(failed):
        after = failed[frequency > frequency[i]]
        if len(after) == 0 or after[0]:
            return math.sqrt(frequency[i] * (frequency[i - 1] if i else frequency[i]))
    return math.inf


def _check_range(frequency: Array, run_off: float, to_gamma: float) -> None:
    first, last = (math.sqrt(gamma / to_gamma) for gamma in (FIRST, LAST))
    told = f"rates from {frequency[0]:.3g} to {frequency[-1]:.3g} Hz" if len(frequency) else "no rates"
    late = (
        len(frequency) < LEAST_POINTS or frequency[0] > first or (frequency[-1] < 0.97 * last and run_off == math.inf)
    )
    if late:
        raise InputError(
            "CURVE.csv", f"{told} at {len(frequency)} points before the run-off",
            f"{LEAST_POINTS} or more, from {first:.3g} Hz or less up to the run-off, or to {last:.3g} Hz, for an "
            "object of this size at this A_p and --method any-size", "--method posterior",
        )  # fmt: skip


@cache
def regressions() -> Mapping[str, Kriging]:
    """Regressions of `SOUGHT`, as shipped."""
    rows = list(csv.DictReader(shipped("any_size.csv").splitlines()))
    inputs = np.array([[float(row[name]) for name in INPUTS] for row in rows])
    learnt = tomllib.loads(shipped("any_size.toml"))
    return {
        name: Kriging(inputs, np.array([float(row[name]) for row in rows]), np.array(learnt[name]["lengths"]),
                      learnt[name]["signal"], learnt[name]["noise"])
        for name in SOUGHT
    }  # fmt: skip


@cache
def _domain() -> Mapping[str, Any]:
    return tomllib.loads(shipped("any_size.toml"))["domain"]


def estimate_any_size(curve: Curve, scenario: Scenario) -> LinearEstimate:
    """Estimate ω_n and α of an object of any size, about as long as wide.

    Parameters
    ----------
    curve : Curve
        A measured spin curve; its spreads widen the estimate's.
    scenario : Scenario
        Tells the object's outline, A_p, B_p and β. Its stiffness and α say nothing; ω_n is then the dish mode's.

    Raises
    ------
    InputError
        For a curve that does not reach from slow sliding to the run-off, or an object longer than wide.
    """
    longer = elongation(scenario.sheet.lattice)
    most = _domain()["elongation"]
    if longer > most:
        raise InputError("sheet.outline", f"{longer:.2g} times as long as wide",
                         f"at most {most:g} times for --method any-size", "--method posterior")  # fmt: skip
    seen = reading(curve, scenario)
    (log_stiffness, log_sd), (alpha, alpha_sd) = (_told(regressions()[name], seen) for name in SOUGHT)
    own = bending_over_weight(scenario.sheet, scenario.gravity)
    omega = scenario.sheet.natural_frequency * math.exp(log_stiffness) / own
    return LinearEstimate(
        natural_frequency=omega, natural_frequency_sd=omega * log_sd,
        friction_angle=math.radians(alpha), friction_angle_sd=math.radians(alpha_sd),
        method="any-size", coefficients="simulated", refused=_outside(seen), nominal=False, logarithmic=True,
    )  # fmt: skip


def _told(regression: Kriging, seen: Reading) -> tuple[float, float]:
    """Value and standard deviation, that of what was read included."""
    step = 0.05 * regression.inputs.std(axis=0)
    steps = np.diag(step)
    at = np.concatenate([seen.values[None], seen.values + steps, seen.values - steps])
    means, sds = regression(at)
    half = len(step)
    slopes = (means[1 : half + 1] - means[half + 1 :]) / (2 * step)
    return float(means[0]), math.hypot(float(sds[0]), float(np.linalg.norm(slopes * seen.sds)))


def _outside(seen: Reading) -> tuple[str, ...]:
    """What of the told lies outside of what the method was made from."""
    inputs = next(iter(regressions().values())).inputs
    reasons = []
    for name, label, scale, is_log in (
        ("log_angle", "A_p in deg", math.degrees(1), True), ("log_stroke", "B_p over the radius", 1.0, True),
        ("log_radius", "the radius in mm", 1e3, True), ("beta", "β", 1.0, False),
    ):  # fmt: skip
        i = INPUTS.index(name)
        low, high, value = inputs[:, i].min(), inputs[:, i].max(), seen.values[i]
        reach = _BEYOND * (high - low)
        if not low - reach <= value <= high + reach:
            low, high, value = (scale * (math.exp(x) if is_log else x) for x in (low, high, value))
            reasons.append(f"{label} is {value:.3g}, and the method holds from {low:.2g} to {high:.2g}")
    return tuple(reasons)
