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

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.estimate.emulator import RateEmulator, RunOffEmulator, fit_rates, fit_run_off
from plategait.estimate.observations import Condition
from plategait.estimate.posterior import Posterior
from plategait.estimate.trials import run_trials

DRAWS = 40
SAMPLES = 2000
# Candidates span the gaits about the usual run-off, A_p ω_p² = 8e4 deg/s² in the source.
USUAL_ACCELERATION = math.radians(8e4)
SPAN = np.linspace(0.5, 1.2, 15)
MOST_MEASUREMENTS = 40
FUTURES = 8
USUAL_NOISE = 0.05
LEAST_EFFECTIVE = 40
# Standard deviations worth having, SI: what the method is made for.
WANTED = {"natural_frequency": 0.3 * math.pi, "friction_angle": math.radians(1), "friction_ratio": 0.05,
          "mass": 0.02, "bending_damping": 0.5, "contact_damping": 0.3}  # fmt: skip


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
        Standard deviation wanted of each parameter, SI; `WANTED` by default. Sets what matters how much.
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
    scale = np.array([(WANTED | (wanted or {}))[name] for name in names])
    cloud = _Cloud.of(posterior, _amplitudes(posterior, angles), noise, seed, progress)
    weight = np.full(len(cloud.values), 1 / len(cloud.values))
    left = cloud.expected_variances(weight)
    loss = np.sum(left / scale**2, axis=1)
    best = int(np.argmin(loss))
    now = np.sum(cloud.variances(weight) / scale**2)
    order = [int(i) for i in np.argsort(loss) if i != best][:3]
    return Plan(
        condition=cloud.conditions[best],
        runs_off=float(1 - cloud.stays[:, best].mean()),
        sd_now=dict(zip(names, np.sqrt(cloud.variances(weight)).tolist(), strict=True)),
        sd_after=dict(zip(names, np.sqrt(left[best]).tolist(), strict=True)),
        runners_up=tuple((cloud.conditions[i], float(math.sqrt(loss[i] / now))) for i in order),
        needed=cloud.needed(scale, names, wanted, seed) if wanted else None,
    )


def _amplitudes(posterior: Posterior, angles: Sequence[float]) -> list[tuple[float, float]]:
    """Amplitudes to choose from."""
    measured = list(dict.fromkeys(c.amplitude for c in posterior.data.conditions))
    stroke = measured[0][1]
    if angles:
        return [(float(a), stroke) for a in angles]
    largest = max(a for a, _ in measured)
    return measured + [(k * largest, stroke) for k in (2, 4) if k * largest <= math.radians(24)]


@dataclass(frozen=True, eq=False)
class _Cloud:
    """Samples of the posterior with what to expect of each under every candidate.

    `values` (n, d) SI; `rates` (n, c) deg/s, `sd` (n, c) their noise, `stays` (n, c) probability that it stays.
    """

    conditions: tuple[Condition, ...]
    values: Array
    rates: Array
    sd: Array
    stays: Array

    @staticmethod
    def of(
        posterior: Posterior,
        amplitudes: Sequence[tuple[float, float]],
        noise: float | None,
        seed: int,
        progress: Callable[[float], object] | None,
    ) -> _Cloud:
        """Run the engine at draws of the posterior under candidates, and emulate it at many more samples."""
        generator = np.random.default_rng(seed)
        draws = posterior.u[generator.choice(len(posterior.u), DRAWS, replace=False)]
        samples = posterior.u[generator.choice(len(posterior.u), SAMPLES, replace=False)]
        grid = [Condition(a, s, round(float(x * math.sqrt(USUAL_ACCELERATION / a) / math.tau), 2))
                for a, s in amplitudes for x in SPAN]  # fmt: skip
        trials = run_trials(posterior.unknowns, draws, grid, seed=seed, progress=progress)
        near = np.ones(len(draws), dtype=bool)
        rates = fit_rates(draws, trials.rates, near)
        run_offs = {a: fit_run_off(draws, *trials.brackets(a), near) for a in amplitudes}
        used = float(np.median(posterior.noise)) if noise is None else noise
        relative = np.full(SAMPLES, used if used > 0 else USUAL_NOISE)
        conditions: list[Condition] = []
        columns: list[tuple[Array, Array, Array]] = []
        for amplitude in amplitudes:
            mine = [c for c in grid if c.amplitude == amplitude]
            emulator = run_offs[amplitude]
            if emulator is not None:
                # Between the grid's points too, where the run-off is expected.
                where = emulator(samples)
                mine += [
                    Condition(*amplitude, round(float(f), 2)) for f in np.quantile(where, [0.2, 0.35, 0.5, 0.65, 0.8])
                ]
            for condition in mine:
                conditions.append(condition)
                columns.append(_expected(condition, grid, rates, emulator, samples, trials.failed, relative))
        stacked = [np.stack([column[k] for column in columns], axis=1) for k in range(3)]
        return _Cloud(tuple(conditions), posterior.unknowns.values(samples), *stacked)

    def variances(self, weight: Array) -> Array:
        """Weighted variance (d,) of the parameters."""
        mean = weight @ self.values
        return weight @ (self.values - mean) ** 2

    def expected_variances(self, weight: Array) -> Array:
        """Variance (c, d) of the parameters to expect after each candidate, its rate taken as Gaussian."""
        stays = weight[:, None] * self.stays
        fails = weight[:, None] - stays
        return self._left(stays, told=True) + self._left(fails, told=False)

    def _left(self, weight: Array, told: bool) -> Array:
        """Share of the expected variance (c, d) that comes of one outcome, with weights (n, c)."""
        total = weight.sum(axis=0) + 1e-300
        share = weight / total
        mean = share.T @ self.values
        variance = np.maximum(share.T @ self.values**2 - mean**2, 0.0)
        if told:
            rate = np.sum(share * self.rates, axis=0)
            deviation = self.rates - rate
            spread = np.sum(share * (deviation**2 + self.sd**2), axis=0) + 1e-300
            covariance = (share * deviation).T @ self.values
            variance = np.maximum(variance - covariance**2 / spread[:, None], 0.0)
        return total[:, None] * variance

    def needed(
        self, scale: Array, names: list[str], wanted: dict[str, float] | None, seed: int
    ) -> tuple[int, int, int]:
        """Least, median and most measurements until the wanted precision, over several futures."""
        generator = np.random.default_rng(seed)
        goals = np.array([(wanted or {}).get(name, math.inf) for name in names])
        counts = sorted(self._future(scale, goals, generator) for _ in range(FUTURES))
        return counts[0], counts[len(counts) // 2], counts[-1]

    def _future(self, scale: Array, goals: Array, generator: np.random.Generator) -> int:
        """Measurements that one future takes, its truth one of the samples."""
        n = len(self.values)
        truth = int(generator.integers(n))
        weight = np.full(n, 1 / n)
        for count in range(MOST_MEASUREMENTS):
            sd = np.sqrt(self.variances(weight))
            if (sd <= goals).all():
                return count
            if count and 1 / np.sum(weight**2) < LEAST_EFFECTIVE:
                # Too few samples left to go on: from here the spread falls with the root of the number.
                return min(MOST_MEASUREMENTS, math.ceil(count * float(np.max(sd / goals)) ** 2))
            c = int(np.argmin(np.sum(self.expected_variances(weight) / scale**2, axis=1)))
            if generator.random() < self.stays[truth, c]:
                rate = generator.normal(self.rates[truth, c], self.sd[truth, c])
                score = -0.5 * ((rate - self.rates[:, c]) / self.sd[:, c]) ** 2 - np.log(self.sd[:, c])
                weight = weight * self.stays[:, c] * np.exp(score - score.max())
            else:
                weight = weight * (1 - self.stays[:, c])
            weight = weight / weight.sum()
        return MOST_MEASUREMENTS


def _expected(
    condition: Condition,
    grid: Sequence[Condition],
    rates: RateEmulator,
    run_off: RunOffEmulator | None,
    samples: Array,
    failed: np.ndarray,
    noise: Array,
) -> tuple[Array, Array, Array]:
    """Rate (n,), its noise (n,) and probability to stay (n,) of the samples under one candidate."""
    from scipy.special import ndtr

    nearest = min((i for i, c in enumerate(grid) if c.amplitude == condition.amplitude),
                  key=lambda i: abs(grid[i].frequency - condition.frequency))  # fmt: skip
    if run_off is not None:
        stays = ndtr((run_off(samples) - condition.frequency) / run_off.width)
    else:
        stays = np.full(len(samples), 1.0 - failed[:, nearest].mean())
    known = math.isfinite(rates.error[nearest]) and grid[nearest].frequency == condition.frequency
    # Where no rate was learnt, only whether it stays is told.
    rate = rates(samples)[:, nearest] if known else np.zeros(len(samples))
    sd = np.hypot(noise * np.abs(rate) + 1.0, rates.error[nearest]) if known else np.full(len(samples), 1e6)
    return rate, sd, stays
