"""Runs: from scenarios through an engine to what they show. The only module that knows both."""

from __future__ import annotations

import difflib
import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, TypedDict, Unpack

import numpy as np

from plategait import observables
from plategait.engine.recording import Recording, Run
from plategait.errors import InputError
from plategait.observables import EnergyLedger, Failure, SpinRate
from plategait.presets import PRESETS, Preset, as_scenario
from plategait.scenario import Scenario
from plategait.units import Quantity

if TYPE_CHECKING:
    import xarray

Engine = Literal["cpu", "cpu64"]
ENGINES: tuple[Engine, ...] = ("cpu", "cpu64")

_INTERVAL = Quantity("s", "s", "0.002 s", at_least=0)

# Spread of the starts of an ensemble: a tenth of a millimetre and a degree are what a hand cannot place better.
START_SPREAD = 1e-4
START_TURN = math.radians(1)

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


@dataclass(frozen=True)
class Observation:
    """What one run shows. SI; NaN where a failure left nothing to measure."""

    spin: SpinRate
    gait: str
    failure: Failure | None
    drift: float
    contact_fraction: float
    flight_fraction: float
    bending_amplitude: float
    plate_power: float
    energy: EnergyLedger


def observe(scenario: Scenario, recording: Recording) -> Observation:
    """Measure a recording over whole plate periods, from the end of the transient to the end or to its failure."""
    period, channels = scenario.motion.period, recording.channels
    plate = (scenario.plate.length, scenario.plate.width) if scenario.plate else None
    failure = observables.first_failure(channels, period, scenario.slip_limit, plate, recording.diverged)
    times, start = channels["time"], scenario.measured_from
    end = float(times[-1]) if failure is None else failure.time
    angle = observables.rotation(channels["spin_cross"], channels["spin_dot"])
    whole = max(0, math.floor((end - start) / period + 1e-6))
    start_whole = end - whole * period

    def means(name: str) -> np.ndarray:
        return observables.period_means(times, channels[name], period, start_whole, end)

    def mean(name: str) -> float:
        values = means(name)
        return float(values.mean()) if len(values) else math.nan

    within = (times > start_whole) & (times <= end)
    bends = channels["bend_rms"][within]
    slipped = observables.slip(times, channels["centre_x"], channels["centre_y"], period)
    averaged = (times <= times[-1] - period / 2) | (times[-1] < period)
    finite = slipped[np.isfinite(slipped) & averaged]
    return Observation(
        spin=observables.spin_rate(times, angle, period, start, end),
        gait=observables.gait(means("left_contact"), means("right_contact"), means("flight")),
        failure=failure,
        drift=float(finite.max()) if len(finite) else math.nan,
        contact_fraction=mean("contact"),
        flight_fraction=mean("flight"),
        bending_amplitude=float(bends.max()) if len(bends) else math.nan,
        plate_power=float(channels["plate_work"][within].sum()) / (end - start_whole) if whole else math.nan,
        energy=observables.energy_ledger(channels),
    )


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

    @property
    def failed(self) -> bool:
        """Whether more than half of the runs failed."""
        return sum(o.failure is not None for o in self.observations) * 2 > len(self.observations)

    @property
    def failure(self) -> Failure | None:
        """Commonest failure with its median time, where the scenario failed."""
        failures = [o.failure for o in self.observations if o.failure is not None]
        if not self.failed:
            return None
        kinds = [f.kind for f in failures]
        kind = max(observables.FAILURES, key=kinds.count)
        return Failure(kind, float(np.median([f.time for f in failures if f.kind == kind])))

    @cached_property
    def _valid(self) -> list[Observation]:
        """Runs that count for the means: those that did not fail, or all where the scenario failed."""
        return [o for o in self.observations if o.failure is None or self.failed]

    def _mean(self, values: Sequence[float]) -> float:
        finite = [v for v in values if math.isfinite(v)]
        return float(np.mean(finite)) if finite else math.nan

    @property
    def spin_rate(self) -> float:
        """Mean spin rate, rad/s, counter-clockwise positive; NaN where nothing could be measured."""
        return self._mean([o.spin.rate for o in self._valid])

    @property
    def spin_rate_interval(self) -> tuple[float, float]:
        """95 % interval of the spin rate, rad/s: within the run, or of the ensemble's mean."""
        if len(self._valid) == 1:
            return self._valid[0].spin.low, self._valid[0].spin.high
        rates = [o.spin.rate for o in self._valid if math.isfinite(o.spin.rate)]
        if len(rates) < 2:
            return math.nan, math.nan
        half = observables.student_95(len(rates) - 1) * self.spin_rate_sd / math.sqrt(len(rates))
        return self.spin_rate - half, self.spin_rate + half

    @property
    def spin_rate_sd(self) -> float:
        """Standard deviation of the spin rate, rad/s: over the ensemble, or for one run over its blocks of periods."""
        rates = [o.spin.rate for o in self._valid if math.isfinite(o.spin.rate)]
        if len(rates) > 1:
            return float(np.std(rates, ddof=1))
        return self._valid[0].spin.sd

    @property
    def settled(self) -> bool:
        """Whether every run that counts has settled, and nothing failed."""
        return not self.failed and all(o.spin.settled for o in self._valid)

    @property
    def gait(self) -> str:
        """Gait of most runs."""
        gaits = [o.gait for o in self._valid]
        return max(("", *observables.GAITS), key=gaits.count)

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
            "failed_runs": sum(o.failure is not None for o in self.observations),
            "failure": failure.kind if failure else None,
            "failure_time_s": failure.time if failure else None,
            "drift_mm": 1e3 * self._mean([o.drift for o in self._valid]),
            "contact_fraction": self._mean([o.contact_fraction for o in self._valid]),
            "flight_fraction": self._mean([o.flight_fraction for o in self._valid]),
            "bending_amplitude_deg": math.degrees(self._mean([o.bending_amplitude for o in self._valid])),
            "plate_power_mw": 1e3 * self._mean([o.plate_power for o in self._valid]),
            "energy_residual": self._mean([o.energy.relative_residual for o in self._valid]),
            "runs": len(self.recordings),
            "engine": self.engine,
            "seed": self.seed,
            "dt_s": self.recordings[0].dt,
            "steps": self.recordings[0].steps,
            "wall_s": self.wall,
            "simulated_s_per_wall_s": self.simulated / self.wall if self.wall > 0 else None,
        }
        return {key: plain(value) for key, value in numbers.items()}

    def to_dataset(self) -> xarray.Dataset:
        """Labelled samples, shapes and summary of every run (see `plategait.dataset`)."""
        from plategait.dataset import dataset_of

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
    engine : {"cpu", "cpu64"}
        The native core in single or double precision.
    snapshot_interval : float or str
        Time between recorded shapes, s; 0 records none.
    threads : int, optional
        Cores to use; all by default.
    progress : callable, optional
        Called with the fraction done.

    Raises
    ------
    InputError
        For an unknown engine, no scenario, or fewer than one repeat.
    KeyboardInterrupt
        When interrupted from the keyboard.
    """
    from plategait.engine import cpu

    if engine not in ENGINES:
        raise InputError("engine", engine, f"one of {', '.join(ENGINES)}", "cpu")
    for name, number, least in (("repeats", repeats, 1), ("seed", seed, 0)):
        if isinstance(number, bool) or not isinstance(number, (int, np.integer)) or not least <= number <= 10**6:
            raise InputError(name, number, f"a whole number from {least} to a million", str(max(least, 4)))
    interval = _INTERVAL.read(snapshot_interval, "snapshot_interval")
    chosen = _scenarios(scenarios)
    offsets = starts(repeats, seed)
    runs = [Run(scenario, offset, interval) for scenario in chosen for offset in offsets]
    begun = time.perf_counter()
    recordings = cpu.run(runs, "float64" if engine == "cpu64" else "float32", threads=threads, progress=progress)
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
