"""What one scenario shows: its runs, and what they show together."""

from __future__ import annotations

import importlib
import math
import statistics
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from plategait.arrays import Array
from plategait.engine.recording import Recording
from plategait.files.plain import plain
from plategait.model.scenario import Scenario
from plategait.shown import Shown
from plategait.simulation.ensemble import Ensemble
from plategait.simulation.observables import Failure
from plategait.simulation.observation import Observation, ensemble_of, values_of
from plategait.simulation.registry import all_observables, find_observable

# mm/s, mm/s and deg/s over SI.
_PEOPLES = np.array([1e3, 1e3, 180 / math.pi])


def _in_people_units(covariance: Array) -> list[list[float | None]] | None:
    """Covariance of a velocity in mm/s, mm/s and deg/s; None where there is none."""
    return (covariance * np.outer(_PEOPLES, _PEOPLES)).tolist() if np.isfinite(covariance).all() else None


@dataclass(frozen=True, eq=False, repr=False)
class Simulation(Shown):
    """One scenario, run once or as an ensemble of slightly different starts.

    Source: spin rate, gaits and failure of section 4.3 of the dissertation.

    Attributes
    ----------
    scenario : Scenario
    recordings : tuple of Recording
        One for each start; the first start is the scenario's own.
    observations : tuple of Observation
        What each shows.
    engine : str
    seed : int
        Of the starts.
    wall : float
        Time the engine took, s, for the whole batch that this was part of, shared out by simulated time.
    """

    scenario: Scenario
    recordings: tuple[Recording, ...]
    observations: tuple[Observation, ...]
    engine: str
    seed: int
    wall: float

    def told(self) -> list[tuple[str, str]]:
        """What a person asks first."""
        scenario, runs = self.scenario, len(self.recordings)
        motion = scenario.motion
        rate = f"{math.degrees(self.spin_rate):.1f} deg/s" if math.isfinite(self.spin_rate) else "not measured"
        low, high = (math.degrees(end) for end in self.spin_rate_interval)
        spread = f" (95 % {low:.1f} to {high:.1f})" if math.isfinite(low) else ""
        observed = f"{self.recordings[0].steps * self.recordings[0].dt:.3g} s"
        return [
            ("object", f"{scenario.name}, {scenario.sheet.lattice.n_nodes} nodes, {1e3 * scenario.sheet.mass:.3g} g"),
            ("plate", f"{motion.frequency:g} Hz, {math.degrees(motion.angle):.3g} deg, {1e3 * motion.stroke:.3g} mm"),
            ("runs", f"{runs} of {observed}"),
            ("spin rate", rate + spread), ("gait", self.gait or "not measured"),
            ("failure", self.failures_in_words or f"none in {observed}"),
            ("drift", f"{1e3 * self.value('drift'):.3g} mm"),
            ("energy", "closed" if not self.open_ledgers else f"open in {self.open_ledgers} of {runs} runs"),
        ]  # fmt: skip

    def film(self, path: Path | str, **options: Any) -> Path:
        """Film of a run: `plategait.render.film.film`, which says what the options are.

        Raises
        ------
        InputError
            For a run without shapes: simulate it with a `snapshot_interval`.
        """
        # Whoever films stands on a higher floor.
        written: Path = importlib.import_module("plategait.render.film").film(self, path, **options)
        return written

    @cached_property
    def _ensemble(self) -> Ensemble:
        return ensemble_of([self.observations])

    @property
    def failed(self) -> bool:
        """Whether at least half of the runs failed (see `plategait.simulation.ensemble` for this and the means)."""
        return bool(self._ensemble.failed[0])

    @property
    def failed_runs(self) -> int:
        """Number of runs that failed."""
        return int(self._ensemble.failed_runs[0])

    @property
    def counted_runs(self) -> int:
        """Number of runs that the spin rate is over."""
        return int(self._ensemble.counted_runs[0])

    @property
    def failure(self) -> Failure | None:
        """Commonest failure with its median time; None where no run failed."""
        kind = self._ensemble.failure[0]
        return Failure(kind, float(self._ensemble.failure_time[0])) if kind else None

    @property
    def failures(self) -> dict[str, list[float]]:
        """Times at which runs failed, s, by kind, the commonest first."""
        times: dict[str, list[float]] = {}
        for failure in (o.failure for o in self.observations if o.failure is not None):
            times.setdefault(failure.kind, []).append(failure.time)
        return dict(sorted(times.items(), key=lambda item: -len(item[1])))

    @property
    def failures_in_words(self) -> str:
        """Which failures there were, of how many of the runs, and when in the middle; empty where none failed."""
        runs, limit = len(self.observations), f"slipped by more than {1e3 * self.scenario.slip_limit:.3g} mm"
        said = []
        for kind, times in self.failures.items():
            failed = [o.failure for o in self.observations if o.failure is not None and o.failure.kind == kind]
            signs = [f.first_sign for f in failed if math.isfinite(f.first_sign)]
            count = f"{len(times)} of {runs} " if runs > 1 else ""
            first = f" ({limit} on the way, at {statistics.median(signs):.2f} s)" if signs else ""
            what = limit if kind == "slipped" else kind
            middle = " in the middle" * (len(times) > 1)
            said.append(f"{count}{what} at {statistics.median(times):.2f} s{middle}{first}")
        return ", ".join(said)

    @property
    def first_sign(self) -> float:
        """Median time of the first sign of the commonest failure, s; NaN where no run failed.

        That of the slip where a run slips off the plate, else that of the failure itself.
        """
        kind = self._ensemble.failure[0]
        failed = [o.failure for o in self.observations if o.failure is not None and o.failure.kind == kind]
        return statistics.median(f.sound_until for f in failed) if failed else math.nan

    @property
    def spin_rate(self) -> float:
        """Mean spin rate of the runs that did not fail, rad/s, counter-clockwise positive; NaN where there is none."""
        return float(self._ensemble.rate[0])

    @property
    def spin_rate_interval(self) -> tuple[float, float]:
        """95 % interval of the spin rate, rad/s: within the run, or of the ensemble's mean."""
        return float(self._ensemble.low[0]), float(self._ensemble.high[0])

    @property
    def spin_rate_sd(self) -> float:
        """Standard deviation of the spin rate, rad/s: over the ensemble, or for one run over its blocks of periods."""
        return float(self._ensemble.spread[0])

    @cached_property
    def twist(self) -> Array:
        """(3,) mean velocity of the runs that did not fail: along the bar and across it, m/s, and turning, rad/s."""
        return np.array([self.value("velocity_x"), self.value("velocity_y"), self.spin_rate])

    @cached_property
    def stride_covariance(self) -> Array:
        """(3, 3) covariance of the velocity over strides, within the runs that did not fail."""
        entries = [["xx", "xy", "xw"], ["xy", "yy", "yw"], ["xw", "yw", "ww"]]
        return np.array([[self.value(f"twist_{entry}") for entry in row] for row in entries])

    @cached_property
    def start_covariance(self) -> Array:
        """(3, 3) covariance of the velocity over the starts that did not fail; NaN for fewer than two."""
        counted = [o for o in self.observations if o.failure is None and math.isfinite(o.spin.rate)]
        if len(counted) < 2:
            return np.full((3, 3), math.nan)
        return np.cov([[o["velocity_x"] for o in counted], [o["velocity_y"] for o in counted],
                       [o.spin.rate for o in counted]])  # fmt: skip

    @property
    def settled(self) -> bool:
        """Whether every run that counts has settled, and the scenario has not failed."""
        return bool(self._ensemble.settled[0])

    @property
    def gait(self) -> str:
        """Gait of most runs that did not fail, of equals the livelier; empty where there is none."""
        return self._ensemble.gait[0]

    @property
    def open_ledgers(self) -> int:
        """Number of runs whose energy does not balance, failed ones included."""
        return sum(not o.energy.closes for o in self.observations)

    @property
    def sound(self) -> bool:
        """Whether no run failed and every run's energy balances."""
        return not self.failed_runs and not self.open_ledgers

    def value(self, name: str) -> float:
        """Observable by its name, over the runs as it is to be taken, SI; NaN where there is none.

        Raises
        ------
        InputError
            For a name that no observable has.
        """
        return float(values_of(find_observable(name), [self.observations])[0])

    @property
    def simulated(self) -> float:
        """Simulated time over all runs, s."""
        return sum(r.steps * r.dt for r in self.recordings)

    def summary(self) -> dict[str, Any]:
        """Plain numbers in the units that people use, for `--json`; None where nothing could be measured."""
        low, high = self.spin_rate_interval
        failure = self.failure
        numbers: dict[str, Any] = {
            "frequency_hz": self.scenario.motion.frequency,
            "spin_rate_deg_s": math.degrees(self.spin_rate),
            "spin_rate_sd_deg_s": math.degrees(self.spin_rate_sd),
            "spin_rate_interval_deg_s": [math.degrees(low), math.degrees(high)],
            "start_covariance": _in_people_units(self.start_covariance),
            "settled": self.settled,
            "gait": self.gait or None,
            "failed": self.failed,
            "failed_runs": self.failed_runs,
            "failure": failure.kind if failure else None,
            "failure_time_s": failure.time if failure else None,
            "first_sign_s": self.first_sign,
            "failures": {kind: len(times) for kind, times in self.failures.items()},
            **{o.key: o.scale * self.value(o.name) for o in all_observables().values()},
            "energy_closed": not self.open_ledgers,
            "open_ledgers": self.open_ledgers,
            "runs": len(self.recordings),
            "counted_runs": self.counted_runs,
            "engine": self.engine,
            "seed": self.seed,
            "dt_s": self.recordings[0].dt,
            "steps": self.recordings[0].steps,
            "wall_s": self.wall,
            "simulated_s_per_wall_s": self.simulated / self.wall if self.wall > 0 else None,
        }
        return {key: plain(value) for key, value in numbers.items()}
