"""The next measurement: which plate motion tells most, and how many are still needed.

The engine runs draws of the posterior under candidate motions. Emulators of what it gives tell, for every sample of the
posterior, the rate and the run-off to expect; the best candidate is the one that leaves least spread on average.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from plategait.errors import InputError, check_kind
from plategait.estimate.candidates import Reach, reach_of
from plategait.estimate.forecast import MOST_MEASUREMENTS, forecast_of, measurements_needed, programme
from plategait.estimate.observations import Condition
from plategait.estimate.posterior import Posterior

# Measurements that a programme holds.
PROGRAMME = 6
# Standard deviations worth having, SI: what the method is made for. What is only sought because nobody knows it counts
# as far as it helps these.
PRECISION = {
    "natural_frequency": 0.3 * math.pi,
    "friction_angle": math.radians(1),
    "friction_ratio": 0.05,
    "mass": 0.02,
    "contact_damping": 0.3,
}


@dataclass(frozen=True)
class Plan:
    """What to measure next.

    Attributes
    ----------
    condition : Condition
        Plate motion.
    runs_off : float
        Probability that the object runs off there: a run-off tells as well as a rate does.
    sd_now, sd_after : dict
        Standard deviation of each parameter now and as expected after that measurement, SI.
    runners_up : tuple of (Condition, float)
        Best other candidates and how much of the spread they leave, relative to now.
    needed : tuple of (int, int, int) or None
        Further measurements until every wanted precision holds, each the best at its time: least, median and most of
        several futures. `MOST_MEASUREMENTS` stands for that many or more.
    programme : tuple of (Condition, dict)
        The next few measurements where all are to be made before the next estimate, each the best after those before
        it, with the standard deviation of each parameter to expect after it, SI.
    height : float
        Of the plate over its axis in the scenario, m, which the motions' heights are told against.
    """

    condition: Condition
    runs_off: float
    sd_now: dict[str, float]
    sd_after: dict[str, float]
    runners_up: tuple[tuple[Condition, float], ...]
    needed: tuple[int, int, int] | None
    programme: tuple[tuple[Condition, dict[str, float]], ...] = ()
    height: float = 0.0

    def text_of(self, condition: Condition) -> str:
        """A motion for people, its height told where not all that are proposed have the scenario's."""
        proposed = [self.condition, *(c for c, _ in self.programme)]
        told = condition.text_at(self.height) if any(c.height for c in proposed) else condition.text
        return f"{condition.frequency:.2f} Hz with {told}"

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`."""
        return {
            **self._numbers(self.condition),
            "probability_of_run_off": self.runs_off, "sd_now": self.sd_now, "sd_after": self.sd_after,
            "needed": list(self.needed) if self.needed else None, "needed_at_most_shown": MOST_MEASUREMENTS,
            "programme": [{**self._numbers(condition), "sd_after": sd} for condition, sd in self.programme],
        }  # fmt: skip

    def _numbers(self, c: Condition) -> dict[str, float]:
        """Plate motion in plain numbers."""
        return {"frequency_hz": c.frequency, "angle_deg": math.degrees(c.angle), "stroke_mm": 1e3 * c.stroke,
                "height_mm": 1e3 * (self.height + c.height), "height_change_mm": 1e3 * c.height,
                "phase_deg": math.degrees(c.phase)}  # fmt: skip


def next_measurement(
    posterior: Posterior,
    *,
    reach: Reach | None = None,
    wanted: dict[str, float] | None = None,
    noise: float | None = None,
    seed: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Plan:
    """Choose the next plate frequency and amplitude.

    Source: docs/estimation.md.

    Parameters
    ----------
    posterior : Posterior
        Of what was measured so far.
    reach : Reach, optional
        What the plate can make; what it made in the measurement if left out.
    wanted : dict, optional
        Standard deviation wanted of each parameter, SI; `PRECISION` by default. Sets what matters how much.
    noise : float, optional
        Relative noise of a measurement; that of the posterior if left out.
    seed : int
        Of the simulated futures.
    progress : callable, optional
        Called with the share that is done, 0 to 1.

    Raises
    ------
    InputError
        For a wanted precision that is no parameter's, or not above 0.
    """
    check_kind(posterior, Posterior, "posterior", "estimate_parameters(…).posterior")
    names = posterior.unknowns.names
    for name, value in (wanted or {}).items():
        if name not in names or not value > 0:
            raise InputError(f"--want {name}", value, f"above 0, of one of {', '.join(names)}",
                             '--want-angle "1 deg"')  # fmt: skip
    scale = np.array([(PRECISION | (wanted or {})).get(name, math.inf) for name in names])
    reach = reach or reach_of(posterior.data.conditions, posterior.unknowns.base.motion)
    forecast = forecast_of(posterior, reach, noise=noise, seed=seed, progress=progress)
    now, after = forecast.variances(forecast.even), forecast.expected_variances(forecast.even)
    loss = np.sum(after / scale**2, axis=1)
    best, *others = (int(i) for i in np.argsort(loss, kind="stable"))
    goals = np.array([(wanted or {}).get(name, math.inf) for name in names])
    return Plan(
        condition=forecast.conditions[best],
        runs_off=float(1 - forecast.stays[:, best].mean()),
        sd_now=dict(zip(names, np.sqrt(now).tolist(), strict=True)),
        sd_after=dict(zip(names, np.sqrt(after[best]).tolist(), strict=True)),
        runners_up=tuple(
            (forecast.conditions[i], float(math.sqrt(loss[i] / np.sum(now / scale**2)))) for i in others[:3]
        ),
        needed=measurements_needed(forecast, scale, goals, seed) if wanted else None,
        programme=tuple(
            (forecast.conditions[i], dict(zip(names, np.sqrt(np.maximum(variance, 0.0)).tolist(), strict=True)))
            for i, variance in programme(forecast, scale, PROGRAMME)
        ),
        height=posterior.unknowns.base.motion.height,
    )
