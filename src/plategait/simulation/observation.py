"""What one run shows, and what the runs of an ensemble show together: from recordings to plain numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array
from plategait.engine.recording import Recording
from plategait.model.scenario import Scenario
from plategait.shown import Shown
from plategait.simulation import observables
from plategait.simulation.energy import EnergyLedger, energy_ledger, least_energy
from plategait.simulation.ensemble import Ensemble, together
from plategait.simulation.observables import Failure, SpinRate
from plategait.simulation.registry import Observable, Window, find_observable, measure_all


@dataclass(frozen=True, repr=False)
class Observation(Shown):
    """What one run shows. SI; NaN where a failure left nothing to measure.

    Attributes
    ----------
    spin : SpinRate
    gait : str
        Empty where nothing was measured.
    failure : Failure or None
    energy : EnergyLedger
    values : mapping of str to float
        Every observable by its name (`plategait.simulation.registry`).
    """

    spin: SpinRate
    gait: str
    failure: Failure | None
    energy: EnergyLedger
    values: Mapping[str, float]

    def __getitem__(self, name: str) -> float:
        """Observable by its name: ``observation["drift"]``."""
        return self.values[name]


@dataclass(frozen=True, repr=False)
class Glance(Shown):
    """The few numbers of a run that somebody asked for. SI.

    Attributes
    ----------
    spin : SpinRate
    failure : Failure or None
    values : mapping of str to float
        Observables by name.
    """

    spin: SpinRate
    failure: Failure | None
    values: Mapping[str, float]


def glance(scenario: Scenario, recording: Recording, names: Sequence[str] = ()) -> Glance:
    """Measure a recording as `observe` does, but of the observables only those named: a tenth of the time."""
    failure = _failure(scenario, recording)
    values: Mapping[str, float] = {}
    if names:
        window = _window(scenario, recording, failure, energy_ledger(recording.channels, _least_energy(scenario)))
        values = {name: find_observable(name).measure(window) for name in names}
    return Glance(_spin(scenario, recording, failure), failure, values)


def observe(scenario: Scenario, recording: Recording) -> Observation:
    """Measure a recording over whole plate periods, from the end of the transient to the end or to its failure."""
    failure = _failure(scenario, recording)
    energy = energy_ledger(recording.channels, _least_energy(scenario))
    window = _window(scenario, recording, failure, energy)
    legs = [window.period_means(name) for name in ("left_contact", "right_contact", "flight")]
    return Observation(
        spin=_spin(scenario, recording, failure),
        gait=observables.gait(*legs),
        failure=failure,
        energy=energy,
        values=measure_all(window),
    )


def _failure(scenario: Scenario, recording: Recording) -> Failure | None:
    plate = (scenario.plate.length, scenario.plate.width) if scenario.plate else None
    return observables.first_failure(
        recording.channels, scenario.motion.period, scenario.slip_limit, plate, recording.diverged
    )


def _sound_until(recording: Recording, failure: Failure | None) -> float:
    return float(recording["time"][-1]) if failure is None else failure.sound_until


def _spin(scenario: Scenario, recording: Recording, failure: Failure | None) -> SpinRate:
    angle = observables.rotation(recording["spin_cross"], recording["spin_dot"])
    end = _sound_until(recording, failure)
    return observables.spin_rate(recording["time"], angle, scenario.motion.period, scenario.measured_from, end)


def _window(scenario: Scenario, recording: Recording, failure: Failure | None, energy: EnergyLedger) -> Window:
    """Whole plate periods, as many as there are from the end of the transient."""
    period, end = scenario.motion.period, _sound_until(recording, failure)
    whole_periods = max(0, math.floor((end - scenario.measured_from) / period + 1e-6))
    return Window(scenario, recording.channels, end - whole_periods * period, end, energy)


def _least_energy(scenario: Scenario) -> float:
    sheet = scenario.sheet
    size = float(np.ptp(sheet.lattice.rest, axis=0).max() + 1) * sheet.pitch
    return least_energy(sheet.mass * scenario.gravity, size)


def values_of(observable: Observable, observations: Sequence[Sequence[Observation]]) -> Array:
    """(n,) an observable over the runs of each point, SI; NaN where no run has it."""
    values = [[o.values.get(observable.name, math.nan) for o in point] for point in observations]
    return observable.over(values, [[o.failure is not None for o in point] for point in observations])


def ensemble_of(observations: Sequence[Sequence[Observation]]) -> Ensemble:
    """What points show together, from the observations of each one's runs, the same number for each."""

    def each(of: Callable[[Observation], object]) -> np.ndarray:
        return np.array([[of(o) for o in point] for point in observations])

    return together(
        spin_rate=each(lambda o: o.spin.rate),
        spin_rate_sd=each(lambda o: o.spin.sd),
        spin_rate_low=each(lambda o: o.spin.low),
        spin_rate_high=each(lambda o: o.spin.high),
        settled=each(lambda o: o.spin.settled),
        gait=each(lambda o: o.gait),
        failure=each(lambda o: o.failure.kind if o.failure else ""),
        failure_time=each(lambda o: o.failure.time if o.failure else math.nan),
    )
