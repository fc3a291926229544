"""What one run shows, and what the runs of an ensemble show together: from recordings to plain numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from plategait.engine.recording import Recording
from plategait.model.scenario import Scenario
from plategait.simulation import observables
from plategait.simulation.energy import EnergyLedger, energy_ledger, least_energy
from plategait.simulation.ensemble import Ensemble, together
from plategait.simulation.observables import Failure, SpinRate


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
    end = float(times[-1]) if failure is None else failure.sound_until
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
        energy=energy_ledger(channels, _least_energy(scenario)),
    )


def _least_energy(scenario: Scenario) -> float:
    sheet = scenario.sheet
    size = float(np.ptp(sheet.lattice.rest, axis=0).max() + 1) * sheet.pitch
    return least_energy(sheet.mass * scenario.gravity, size)


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
