"""The any-size method on objects that it has not seen, beside the engine in the loop."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.errors import InputError
from plategait.estimate.any_size import estimate_any_size
from plategait.estimate.any_size_training import ACCELERATIONS, NOISE, drawn
from plategait.estimate.result import estimate_parameters
from plategait.model.scenario import Scenario
from plategait.model.similarity import equivalent_radius, frequency_at
from plategait.plots.style import BLUE, GREY, label_axes
from plategait.study.claims import Number, number_of
from plategait.study.measured import Columns, Measured
from plategait.study.questions.curves import as_run
from plategait.study.runs import Runs
from plategait.thesis.item import Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SEED = 2013
"""Of the objects; the method was made from others."""
COUNT = 20
POSTERIOR_COUNT = 4
"""Objects that the engine in the loop estimates too, of those within its priors."""
_NINETY = 1.645
_RESAMPLED = 2000


def strangers(count: int = COUNT) -> list[Scenario]:
    """Objects of any size."""
    rng = np.random.default_rng(SEED)
    return [drawn(rng) for _ in range(count)]


def curve_of(scenario: Scenario, rates: Array, failed: Array, seed: int) -> Curve:
    """Measured curve of an object from what runs showed, rad/s, with the noise of a measurement."""
    noise = 1 + NOISE * np.random.default_rng([SEED, seed]).normal(size=len(rates))
    seen = np.degrees(rates) * noise
    return Curve(
        name=f"stranger {seed}",
        frequency_hz=np.array([frequency_at(scenario, gamma) for gamma in ACCELERATIONS]),
        spin_rate_deg_s=seen, spin_rate_sd_deg_s=NOISE * np.abs(seen),
        gait=("",) * len(rates), failure=tuple("slipped" if share >= 0.5 else "" for share in failed),
    )  # fmt: skip


@dataclass(frozen=True, eq=False)
class Strangers:
    """What the method says of objects whose truth is known.

    Attributes
    ----------
    scenarios : tuple of Scenario
    measured : Measured
        At `ACCELERATIONS` of each.
    """

    scenarios: tuple[Scenario, ...]
    measured: Measured

    @property
    def count(self) -> int:
        """How many there are."""
        return len(self.scenarios)

    def curves(self, columns: Columns) -> list[Curve]:
        """Measured curve of each."""
        rates, failed = (columns[name].reshape(self.count, -1) for name in ("spin_rate", "failed"))
        return [curve_of(s, rates[i], failed[i], i) for i, s in enumerate(self.scenarios)]

    def estimates(self, columns: Columns) -> Array:
        """(n, 4) logarithm of ω_n over the truth with its sd, α less the truth with its sd, deg; NaN where refused."""
        rows = []
        for scenario, curve in zip(self.scenarios, self.curves(columns), strict=True):
            try:
                found = estimate_any_size(curve, scenario)
            except InputError:
                rows.append([math.nan] * 4)
                continue
            omega = math.log(found.natural_frequency / scenario.sheet.natural_frequency)
            alpha = math.degrees(found.friction_angle - scenario.friction.angle)
            rows.append([omega, found.natural_frequency_sd / found.natural_frequency, alpha,
                         math.degrees(found.friction_angle_sd)])  # fmt: skip
        return np.array(rows)

    def number(self, name: str) -> Number:
        """Error over all objects, with its own errors."""
        return number_of(self.measured, lambda columns: _errors(self.estimates(columns))[name])

    def interval(self, name: str) -> tuple[float, float]:
        """95 % interval of an error over the objects that might have been drawn."""
        return over_objects(self.estimates(self.measured.means), lambda rows: _errors(rows)[name])

    def table(self) -> Table:
        """An object a row."""
        rows = []
        for scenario, row in zip(self.scenarios, self.estimates(self.measured.means), strict=True):
            sheet, motion = scenario.sheet, scenario.motion
            rows.append((1e3 * equivalent_radius(sheet.lattice, sheet.pitch), math.degrees(motion.angle),
                         1e3 * motion.stroke, sheet.natural_frequency / math.pi, 100 * (math.exp(row[0]) - 1),
                         math.degrees(scenario.friction.angle), row[2], row[3]))  # fmt: skip
        columns = ("radius, mm", "A_p, deg", "B_p, mm", "ω_n, π rad/s", "its error, %", "α, deg", "its error, deg",
                   "sd told, deg")  # fmt: skip
        return Table("sizes-estimator", columns, tuple(rows))

    def draw(self, axis: Axes) -> None:
        """α and ω_n told over the truth."""
        rows = self.estimates(self.measured.means)
        truth = np.array([math.degrees(s.friction.angle) for s in self.scenarios])
        radius = np.array([equivalent_radius(s.sheet.lattice, s.sheet.pitch) for s in self.scenarios])
        axis.plot([15, 65], [15, 65], color=GREY, lw=1)
        axis.errorbar(truth, truth + rows[:, 2], _NINETY * rows[:, 3], fmt="none", ecolor=GREY, elinewidth=0.8)
        sizes = 10 + 60 * (np.log(radius) - math.log(0.01)) / math.log(20)
        axis.scatter(truth, truth + rows[:, 2], s=sizes, color=BLUE, zorder=3)
        axis.set_title("objects of 10 to 200 mm by the any-size method, 90 %", fontsize=10)
        label_axes(axis, "true friction angle, deg", "told, deg")


def over_objects(rows: Array, function: Callable[[Array], float]) -> tuple[float, float]:
    """95 % interval of a number that a few objects give, an object a row: by bootstrap."""
    rng = np.random.default_rng(SEED)
    drawn = rng.integers(len(rows), size=(_RESAMPLED, len(rows)))
    low, high = np.nanpercentile([function(rows[which]) for which in drawn], (2.5, 97.5))
    return float(low), float(high)


def _errors(rows: Array) -> dict[str, float]:
    omega, omega_sd, alpha, alpha_sd = rows[np.isfinite(rows).all(axis=1)].T
    held = np.concatenate([np.abs(omega) < _NINETY * omega_sd, np.abs(alpha) < _NINETY * alpha_sd])
    return {
        "omega": float(np.median(np.expm1(np.abs(omega)))), "omega_rms": float(np.sqrt(np.mean(omega**2))),
        "alpha": float(np.median(np.abs(alpha))), "alpha_rms": float(np.sqrt(np.mean(alpha**2))),
        "held": float(np.mean(held)),
    }  # fmt: skip


def met(runs: Runs, count: int = COUNT, repeats: int = 2, half_step: bool = True) -> Strangers:
    """Strangers with what they show."""
    scenarios = strangers(count)
    each = [s.replace(**{"motion.frequency": frequency_at(s, gamma)}) for s in scenarios for gamma in ACCELERATIONS]
    return Strangers(tuple(scenarios), runs.measure(each, repeats=repeats, half_step=half_step))


def posterior_errors(runs: Runs, count: int = POSTERIOR_COUNT) -> dict[str, list[float]]:
    """Errors of both methods on the same curves, of objects within the posterior's priors: shares of ω_n, and deg."""
    some = [s for s in strangers(8 * count) if 0.02 < s.sheet.outline.size()[0] / 2 < 0.15
            and 1.5 * math.pi < s.sheet.natural_frequency < 25 * math.pi][:count]  # fmt: skip
    each = [s.replace(**{"motion.frequency": frequency_at(s, gamma)}) for s in some for gamma in ACCELERATIONS]
    found = Strangers(tuple(some), runs.measure(each))
    curves, rows = found.curves(found.measured.means), found.estimates(found.measured.means)
    told = []
    for i, (scenario, curve) in enumerate(zip(some, curves, strict=True)):
        what = {"posterior of stranger": i, "seed": SEED, "rates": curve.spin_rate_deg_s.tolist()}
        told.append(runs.once(what, lambda s=scenario, c=curve: _posterior(s, c), 400.0))
    return {
        "radius": [1e3 * equivalent_radius(s.sheet.lattice, s.sheet.pitch) for s in some],
        "any_omega": np.expm1(np.abs(rows[:, 0])).tolist(), "any_alpha": np.abs(rows[:, 2]).tolist(),
        "posterior_omega": [math.expm1(abs(t["omega"])) for t in told],
        "posterior_alpha": [abs(t["alpha"]) for t in told],
    }  # fmt: skip


def _posterior(scenario: Scenario, curve: Curve) -> dict[str, Any]:
    """Errors of the posterior's medians, which is told what the any-size method is, and the slip limit."""
    guessed = scenario.sheet.with_natural_frequency(10 * math.pi)
    told = scenario.replace(sheet=guessed, friction=scenario.friction.with_angle("37 deg"), time_step=None)
    found = estimate_parameters(curve, as_run(told), friction_ratio=scenario.friction.ratio, seed=SEED)
    omega, alpha = (found[name].median for name in ("natural_frequency", "friction_angle"))
    return {"omega": math.log(omega / scenario.sheet.natural_frequency),
            "alpha": math.degrees(alpha - scenario.friction.angle)}  # fmt: skip
