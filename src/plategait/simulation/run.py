"""Runs: from scenarios through an engine to what they show. The only module that knows both."""

from __future__ import annotations

import difflib
import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypedDict, Unpack

import numpy as np

from plategait.engine import engines
from plategait.engine.engines import Engine
from plategait.engine.recording import Recording, Run
from plategait.errors import InputError
from plategait.model.presets import PRESETS, Preset, as_scenario
from plategait.model.scenario import Scenario
from plategait.simulation.ensemble import Ensemble, mean_of_unfailed
from plategait.simulation.observables import Failure
from plategait.simulation.observation import Observation, ensemble_of, observe
from plategait.units import Quantity

if TYPE_CHECKING:
    import xarray

_INTERVAL = Quantity("s", "s", "0.002 s", at_least=0)

# Spread of the starts of an ensemble: a tenth of a millimetre and a degree are what a hand cannot place better.
START_SPREAD = 1e-4
START_TURN = math.radians(1)

MOST_THREADS = 1000
MOST_REPEATS = 10**5

# Time between the shapes that films and files are made of, s: a fifth of a fast plate's quarter period.
FILM_INTERVAL = 2e-3


class RunOptions(TypedDict, total=False):
    """How scenarios are run: the options of `simulate_all`, which says what they are."""

    repeats: int
    seed: int
    engine: Engine
    snapshot_interval: float | str
    threads: int | None
    progress: Callable[[float], object] | None


def check_options(options: Mapping[str, object]) -> None:
    """Refuse a name that is none of `RunOptions`.

    Raises
    ------
    InputError
        With the nearest that is, or how a scenario's number is changed.
    """
    known = list(RunOptions.__annotations__)
    for name in options:
        if name not in known:
            close = difflib.get_close_matches(name, known, 1)
            hint = close[0] if close else 'scenario.replace(**{"motion.frequency": "24 Hz"}) for what belongs to it'
            raise InputError(name, "nothing known by that name", f"one of {', '.join(known)}", hint)


@dataclass(frozen=True, eq=False)
class Simulation:
    """One scenario, run once or as an ensemble of slightly different starts.

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

    @cached_property
    def _shown(self) -> Ensemble:
        return ensemble_of([self.observations])

    @property
    def failed(self) -> bool:
        """Whether at least half of the runs failed (see `plategait.simulation.ensemble` for this and the means)."""
        return bool(self._shown.failed[0])

    @property
    def failed_runs(self) -> int:
        """Number of runs that failed."""
        return int(self._shown.failed_runs[0])

    @property
    def counted_runs(self) -> int:
        """Number of runs that the spin rate is over."""
        return int(self._shown.counted_runs[0])

    @property
    def failure(self) -> Failure | None:
        """Commonest failure with its median time; None where no run failed."""
        kind = self._shown.failure[0]
        return Failure(kind, float(self._shown.failure_time[0])) if kind else None

    @property
    def failures(self) -> dict[str, list[float]]:
        """Times at which runs failed, s, by kind, the commonest first."""
        times: dict[str, list[float]] = {}
        for failure in (o.failure for o in self.observations if o.failure is not None):
            times.setdefault(failure.kind, []).append(failure.time)
        return dict(sorted(times.items(), key=lambda item: -len(item[1])))

    @property
    def spin_rate(self) -> float:
        """Mean spin rate of the runs that did not fail, rad/s, counter-clockwise positive; NaN where there is none."""
        return float(self._shown.rate[0])

    @property
    def spin_rate_interval(self) -> tuple[float, float]:
        """95 % interval of the spin rate, rad/s: within the run, or of the ensemble's mean."""
        return float(self._shown.low[0]), float(self._shown.high[0])

    @property
    def spin_rate_sd(self) -> float:
        """Standard deviation of the spin rate, rad/s: over the ensemble, or for one run over its blocks of periods."""
        return float(self._shown.spread[0])

    @property
    def settled(self) -> bool:
        """Whether every run that counts has settled, and the scenario has not failed."""
        return bool(self._shown.settled[0])

    @property
    def gait(self) -> str:
        """Gait of most runs that did not fail, of equals the livelier; empty where there is none."""
        return self._shown.gait[0]

    @property
    def open_ledgers(self) -> int:
        """Number of runs whose energy does not balance, failed ones included."""
        return sum(not o.energy.closes for o in self.observations)

    @property
    def sound(self) -> bool:
        """Whether no run failed and every run's energy balances."""
        return not self.failed_runs and not self.open_ledgers

    def _mean(self, of: Callable[[Observation], float]) -> float:
        """Mean of a number over the runs that did not fail."""
        failed = [o.failure is not None for o in self.observations]
        return float(mean_of_unfailed([of(o) for o in self.observations], failed))

    def _worst(self, of: Callable[[Observation], float]) -> float:
        """Number of the run in which it is furthest from zero; NaN where a run has none."""
        return max((of(o) for o in self.observations), key=lambda x: math.inf if math.isnan(x) else abs(x))

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
            "settled": self.settled,
            "gait": self.gait or None,
            "failed": self.failed,
            "failed_runs": self.failed_runs,
            "failure": failure.kind if failure else None,
            "failure_time_s": failure.time if failure else None,
            "failures": {kind: len(times) for kind, times in self.failures.items()},
            "drift_mm": 1e3 * self._mean(lambda o: o.drift),
            "contact_fraction": self._mean(lambda o: o.contact_fraction),
            "flight_fraction": self._mean(lambda o: o.flight_fraction),
            "bending_amplitude_deg": math.degrees(self._mean(lambda o: o.bending_amplitude)),
            "plate_power_mw": 1e3 * self._mean(lambda o: o.plate_power),
            "energy_residual": self._worst(lambda o: o.energy.relative_residual),
            "energy_imbalance": self._worst(lambda o: o.energy.imbalance),
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

    def to_dataset(self) -> xarray.Dataset:
        """Labelled samples, shapes and summary of every run (see `plategait.simulation.dataset`)."""
        from plategait.simulation.dataset import dataset_of

        return dataset_of(self)


def plain(value: Any) -> Any:
    """JSON knows no NaN."""
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return [plain(v) for v in value] if isinstance(value, list) else value


def starts(repeats: int, seed: int) -> list[tuple[float, float, float]]:
    """(x, y, angle) added to the start of each run of an ensemble; the first is the nominal start."""
    generator = np.random.default_rng(seed)
    spread = generator.normal(0.0, 1.0, (repeats, 3)) * (START_SPREAD, START_SPREAD, START_TURN)
    return [(0.0, 0.0, 0.0), *(tuple(map(float, row)) for row in spread[1:])]  # type: ignore[list-item]


def simulate(scenario: Scenario | Preset | Path | str, **options: Unpack[RunOptions]) -> Simulation:
    """Run one scenario, once or as an ensemble of slightly different starts.

    Parameters
    ----------
    scenario : Scenario, or what tells one
        A preset or its name, or a TOML file.
    **options
        See `simulate_all`.

    Raises
    ------
    InputError
        For no scenario, an unknown option, or one out of range.
    """
    check_options(options)
    return simulate_all([scenario], **options)[0]


def simulate_all(
    scenarios: Sequence[Scenario | Preset | Path | str],
    *,
    repeats: int = 1,
    seed: int = 0,
    engine: Engine = "cpu",
    snapshot_interval: float | str = 0.0,
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> list[Simulation]:
    """Run many scenarios side by side. A run that fails or diverges is a status, never an exception.

    Parameters
    ----------
    scenarios : sequence of Scenario, or of what tells one
        May differ in everything.
    repeats : int
        Runs; the first starts where the scenario says, the others within a tenth of a millimetre and a degree of it.
    seed : int
        Of the starts.
    engine : {"cpu", "cpu64", "tiles"}
        The native core in single or double precision, or rigid tiles (`plategait.engine.engines`).
    snapshot_interval : float or str
        Time between recorded shapes, s; 0 records none.
    threads : int, optional
        Cores to use; all by default.
    progress : callable, optional
        Called with the fraction done.

    Raises
    ------
    InputError
        For an unknown engine or what it cannot do, no scenario, a number out of range, or runs that need more memory
        than there is.
    KeyboardInterrupt
        When interrupted from the keyboard.
    """
    row = engines.engine(engine)
    whole = [("repeats", repeats, 1, MOST_REPEATS), ("seed", seed, 0, 10**6)]
    whole += [("threads", threads, 1, MOST_THREADS)] if threads is not None else []
    for name, number, least, most in whole:
        if isinstance(number, bool) or not isinstance(number, (int, np.integer)) or not least <= number <= most:
            raise InputError(name, number, f"a whole number from {least} to {most}", str(max(least, 4)))
    interval = _INTERVAL.read(snapshot_interval, "snapshot_interval")
    chosen = _scenarios(scenarios)
    offsets = starts(repeats, seed)
    runs = [Run(scenario, offset, interval) for scenario in chosen for offset in offsets]
    begun = time.perf_counter()
    recordings = row.load()(runs, threads=threads, progress=progress)
    wall = time.perf_counter() - begun
    total = sum(r.steps * r.dt for r in recordings)
    simulations = []
    for i, scenario in enumerate(chosen):
        own = tuple(recordings[i * repeats : (i + 1) * repeats])
        share = sum(r.steps * r.dt for r in own) / total if total else 0.0
        observations = tuple(observe(scenario, r) for r in own)
        simulations.append(Simulation(scenario, own, observations, engine, seed, wall * share))
    return simulations


def _scenarios(given: Sequence[Scenario | Preset | Path | str]) -> list[Scenario]:
    """Scenarios of a list of what tells them."""
    if isinstance(given, (str, Path, Scenario, Preset)) or not hasattr(given, "__iter__"):
        raise InputError("scenarios", "nothing like a list", "a list of scenarios", f'["{PRESETS[0]}"]')
    chosen = [as_scenario(each, "scenarios") for each in given]
    if not chosen:
        raise InputError("scenarios", "nothing", "at least one scenario", 'preset("cheese").scenario')
    return chosen
