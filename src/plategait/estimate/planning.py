"""The next measurement: which plate motion tells most, and how many are still needed.

The engine runs draws of the posterior under candidate motions. Emulators of what it gives tell, for every sample of the
posterior, the rate and the run-off to expect; the best candidate is the one that leaves least spread on average.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from plategait.errors import InputError
from plategait.estimate.forecast import MOST_MEASUREMENTS, forecast_of, measurements_needed
from plategait.estimate.observations import Condition
from plategait.estimate.posterior import Posterior

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
        Plate frequency (Hz) and amplitudes.
    runs_off : float
        Probability that the object runs off there: a run-off tells as well as a rate does.
    sd_now, sd_after : dict
        Standard deviation of each parameter now and as expected after that measurement, SI.
    runners_up : tuple of (Condition, float)
        Best other candidates and how much of the spread they leave, relative to now.
    needed : tuple of (int, int, int) or None
        Further measurements until every wanted precision holds, each the best at its time: least, median and most of
        several futures. `MOST_MEASUREMENTS` stands for that many or more.
    """

    condition: Condition
    runs_off: float
    sd_now: dict[str, float]
    sd_after: dict[str, float]
    runners_up: tuple[tuple[Condition, float], ...]
    needed: tuple[int, int, int] | None

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`."""
        c = self.condition
        return {
            "frequency_hz": c.frequency, "angle_deg": math.degrees(c.angle), "stroke_mm": 1e3 * c.stroke,
            "probability_of_run_off": self.runs_off, "sd_now": self.sd_now, "sd_after": self.sd_after,
            "needed": list(self.needed) if self.needed else None, "needed_at_most_shown": MOST_MEASUREMENTS,
        }  # fmt: skip


def next_measurement(
    posterior: Posterior,
    *,
    angles: Sequence[float] = (),
    wanted: dict[str, float] | None = None,
    noise: float | None = None,
    seed: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Plan:
    """Choose the next plate frequency and amplitude.

    Parameters
    ----------
    posterior : Posterior
        Of what was measured so far.
    angles : sequence of float
        Angular amplitudes A_p that the plate can make, rad; those measured, and twice and four times them if left out.
    wanted : dict, optional
        Standard deviation wanted of each parameter, SI; `PRECISION` by default. Sets what matters how much.
    noise : float, optional
        Relative noise of a measurement; that of the posterior if left out.
    seed : int

    Raises
    ------
    InputError
        For a wanted precision that is no parameter's, or not above 0.
    """
    names = posterior.unknowns.names
    for name, value in (wanted or {}).items():
        if name not in names or not value > 0:
            raise InputError(f"--want {name}", value, f"above 0, of one of {', '.join(names)}",
                             '--want-angle "1 deg"')  # fmt: skip
    scale = np.array([(PRECISION | (wanted or {})).get(name, math.inf) for name in names])
    forecast = forecast_of(posterior, _amplitudes(posterior, angles), noise=noise, seed=seed, progress=progress)
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
    )


def _amplitudes(posterior: Posterior, angles: Sequence[float]) -> list[tuple[float, float]]:
    """Amplitudes to choose from."""
    measured = list(dict.fromkeys(c.amplitude for c in posterior.data.conditions))
    stroke = measured[0][1]
    if angles:
        return [(float(a), stroke) for a in angles]
    largest = max(a for a, _ in measured)
    return measured + [(k * largest, stroke) for k in (2, 4) if k * largest <= math.radians(24)]
