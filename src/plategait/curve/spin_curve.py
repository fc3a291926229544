"""Spin curves simulated, and any spin curve with its Lorentz fit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Unpack

import numpy as np

from plategait.curve.curve import Curve
from plategait.curve.curve_file import as_curve
from plategait.curve.lorentz import fit_lorentzian
from plategait.errors import InputError
from plategait.files.ranges import parse_frequencies
from plategait.model.presets import Preset, as_scenario
from plategait.model.scenario import Scenario
from plategait.simulation.observation import Observation, ensemble_of, values_of
from plategait.simulation.registry import all_observables
from plategait.simulation.run import RunOptions, check_options, simulate_all
from plategait.units import FREQUENCY


def fit_curve(curve: Curve | Path | str) -> Curve:
    """Same curve with the Lorentz fit (5.5) of its `fitted` points, or with the reason why there is none."""
    curve = as_curve(curve)
    fitted = curve.fitted
    try:
        fit = fit_lorentzian(
            curve.frequency_hz[fitted], curve.spin_rate_deg_s[fitted], ends_in_failure=curve.ends_in_failure
        )
    except InputError as error:
        return replace(curve, fit=None, no_fit=str(error))
    return replace(curve, fit=fit, no_fit="")


def spin_curve(
    scenario: Scenario | Preset | Path | str, frequencies: Sequence[float | str] | str, **options: Unpack[RunOptions]
) -> Curve:
    """Simulate a spin curve and fit it.

    Source: section 5.3 of the dissertation.

    Parameters
    ----------
    scenario : Scenario, or what tells one
        Run at each frequency in turn; see `plategait.simulation.run.simulate`.
    frequencies : sequence of float, or str
        Hz; or text such as "12:30:1Hz", see `parse_frequencies`.
    **options
        See `plategait.simulation.run.simulate_all`.

    Raises
    ------
    InputError
        For what is no scenario or no frequencies, an unknown option, or one out of range.
    """
    check_options(options)
    checked, frequencies = as_scenario(scenario), _frequencies(frequencies)
    scenarios = [checked.replace(**{"motion.frequency": f}) for f in frequencies]
    simulations = simulate_all(scenarios, **options)
    curve = curve_of(checked.name, frequencies, [s.observations for s in simulations])
    observed, limit = (np.full(len(frequencies), x) for x in (checked.duration, checked.slip_limit))
    return fit_curve(replace(curve, simulations=tuple(simulations), duration=observed, slip_limit=limit))


def curve_of(name: str, frequencies: Sequence[float], observations: Sequence[Sequence[Observation]]) -> Curve:
    """Curve without a fit, from the observations of each frequency's runs."""
    ensemble = ensemble_of(observations)
    return Curve(
        name=name,
        frequency_hz=np.array(frequencies, dtype=float),
        spin_rate_deg_s=np.degrees(ensemble.rate),
        spin_rate_sd_deg_s=np.degrees(ensemble.spread),
        gait=ensemble.gait,
        failure=ensemble.failure,
        runs=np.full(len(ensemble.rate), float(ensemble.runs)),
        failed_runs=ensemble.failed_runs.astype(float),
        values={o.name: values_of(o, observations) for o in all_observables().values() if o.label or o.in_curves},
    )


def _frequencies(frequencies: Sequence[float | str] | str) -> list[float]:
    """Frequencies of a range as text, or of a list of numbers, Hz."""
    if isinstance(frequencies, str):
        return parse_frequencies(frequencies)
    if not hasattr(frequencies, "__iter__"):
        raise InputError(
            "frequencies", frequencies, "several frequencies in Hz", f'"{frequencies}, 24 Hz" or "12:30:1Hz"'
        )
    return [FREQUENCY.read(f, "frequencies") for f in frequencies]
