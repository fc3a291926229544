"""What one run shows, and what the runs of an ensemble show together: from recordings to plain numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array
from plategait.engine.recording import Recording
from plategait.model.scenario import Scenario
from plategait.simulation import observables
from plategait.simulation.energy import EnergyLedger, energy_ledger, least_energy
from plategait.simulation.ensemble import Ensemble, together
from plategait.simulation.observables import Failure, SpinRate
from plategait.simulation.registry import Observable, Window, measure_all


@dataclass(frozen=True)
class Observation:
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


def observe(scenario: Scenario, recording: Recording) -> Observation:
    """Measure a recording over whole plate periods, from the end of the transient to the end or to its failure."""
    period, channels = scenario.motion.period, recording.channels
    plate = (scenario.plate.length, scenario.plate.width) if scenario.plate else None
    failure = observables.first_failure(channels, period, scenario.slip_limit, plate, recording.diverged)
    times, start = channels["time"], scenario.measured_from
    end = float(times[-1]) if failure is None else failure.sound_until
    angle = observables.rotation(channels["spin_cross"], channels["spin_dot"])
    whole_periods = max(0, math.floor((end - start) / period + 1e-6))
    energy = energy_ledger(channels, _least_energy(scenario))
    window = Window(scenario, channels, end - whole_periods * period, end, energy)
    legs = [window.period_means(name) for name in ("left_contact", "right_contact", "flight")]
    return Observation(
        spin=observables.spin_rate(times, angle, period, start, end),
        gait=observables.gait(*legs),
        failure=failure,
        energy=energy,
        values=measure_all(window),
    )


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
