"""An optimum in the units that people use, as plain data."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from plategait.files.plain import plain
from plategait.model.motion import PlateMotion
from plategait.optimize.goal import COSTS
from plategait.optimize.optimum import Optimum, Sensitivity, front
from plategait.optimize.proof import Proof
from plategait.optimize.search import Found
from plategait.optimize.trials import Trial
from plategait.units import Quantity, parse

FLAT = 0.9
"""Share of the best rate above which a motion counts as one on the ridge (as in Fig. 4.7: the tops are flat)."""


def summary(optimum: Optimum) -> dict[str, Any]:
    """Plain numbers for `--json`; None where nothing could be measured."""
    trial, fine = optimum.trial, optimum.confirmation
    numbers: dict[str, Any] = {
        "scenario": optimum.scenario.name,
        "machine": optimum.machine.name,
        "goal": optimum.goal.words,
        "reached": optimum.reached,
        **_shown(trial),
        **_motion(trial.motion),
        "waves": [_wave(wave) for wave in trial.motion.waves],
        **_costs(trial),
        "evaluations": optimum.evaluations,
        "chance_of_failure": optimum.chance_of_failure,
        "confidence": optimum.confidence,
        "certain": optimum.certain,
        "failed_runs": trial.failed,
        "runs": trial.runs,
        "confirmed": optimum.confirmed,
        "confirmation": {**_shown(fine), "failed_runs": fine.failed, "runs": fine.runs},
        **_gain(optimum),
        "variables": {v.name: _plain_range(v.low, v.high, v.quantity) for v in optimum.space.variables},
        "sensitivities": [_sensitivity(each) for each in optimum.sensitivities],
        "ridge_deg_s2": _ridge(optimum.trials),
        "front": {name: [_point(each) for each in front(optimum.trials, name)] for name in known_costs(trial)},
        "searches": [_search(each) for each in optimum.found],
    }
    return {key: _plain(value) for key, value in numbers.items()}


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _plain(each) for key, each in value.items()}
    return [_plain(each) for each in value] if isinstance(value, list) else plain(value)


def known_costs(trial: Trial) -> list[str]:
    """Costs that are known: all of them, where the machine tells its masses."""
    return [name for name in COSTS if math.isfinite(trial.cost(name))]


def in_peoples(value: float, quantity: Quantity) -> float:
    """An SI number in the unit that people read."""
    return value / parse(f"1 {quantity.display}", quantity.unit) if quantity.unit else value


def angular_acceleration(motion: PlateMotion) -> float:
    """A_p ω_p², deg/s²: what is nearly the same for the best motions of every amplitude (section 4.4)."""
    return math.degrees(abs(motion.angle)) * (2 * math.pi * motion.frequency) ** 2


def _shown(trial: Trial) -> dict[str, Any]:
    twist, half = trial.twist, trial.half_width
    rate, off = math.degrees(twist[2]), math.degrees(half[2])
    return {
        "spin_rate_deg_s": rate,
        "spin_rate_sd_deg_s": math.degrees(trial.spread[2]),
        "spin_rate_interval_deg_s": [rate - off, rate + off],
        "velocity_x_mm_s": 1e3 * float(twist[0]),
        "velocity_y_mm_s": 1e3 * float(twist[1]),
    }


def _motion(motion: PlateMotion) -> dict[str, Any]:
    return {
        "frequency_hz": motion.frequency,
        "angle_deg": math.degrees(motion.angle),
        "stroke_mm": 1e3 * motion.stroke,
        "offset_deg": math.degrees(motion.offset.rx),
    }


def _wave(wave: Any) -> dict[str, Any]:
    turns = wave.axis.startswith("r")
    amplitude = math.degrees(wave.amplitude) if turns else 1e3 * wave.amplitude
    unit = "amplitude_deg" if turns else "amplitude_mm"
    return {"axis": wave.axis, unit: amplitude, "ratio": wave.ratio, "phase_deg": math.degrees(wave.phase)}


def _costs(trial: Trial) -> dict[str, float]:
    keys = {"acceleration": "acceleration_m_s2", "torque": "torque_n_m", "power": "power_w", "bending": "bending_deg"}
    return {keys[name]: in_peoples(trial.cost(name), quantity) for name, quantity in COSTS.items()}


def _point(trial: Trial) -> dict[str, Any]:
    return {**_shown(trial), **_motion(trial.motion), **_costs(trial)}


def _plain_range(low: float, high: float, quantity: Quantity) -> dict[str, Any]:
    return {"from": in_peoples(low, quantity), "to": in_peoples(high, quantity), "unit": quantity.display}


def _gain(optimum: Optimum) -> dict[str, Any]:
    """What the freedoms add to the spin rate, where some were asked for."""
    if optimum.gain is None:
        return {}
    gain, half = map(math.degrees, optimum.gain)
    return {"gain_deg_s": gain, "gain_interval_deg_s": [gain - half, gain + half]}


def _sensitivity(each: Sensitivity) -> dict[str, Any]:
    quantity = each.variable.quantity

    def side(moved: tuple[float, Trial] | None) -> dict[str, Any] | None:
        if moved is None:
            return None
        value, trial = moved
        return {"value": in_peoples(value, quantity), **_shown(trial), "failed_runs": trial.failed, "runs": trial.runs}

    value = in_peoples(each.value, quantity)
    return {"variable": each.variable.name, "unit": quantity.display, "value": value,
            "less": side(each.less), "more": side(each.more)}  # fmt: skip


def _ridge(trials: Sequence[Trial]) -> list[float] | None:
    """A_p ω_p² from which to which lie all motions within a tenth of the fastest of those that did not fail, deg/s²."""
    stays = [trial for trial in trials if not trial.failed and trial.counted]
    if not stays:
        return None
    rates = np.abs([trial.spin_rate for trial in stays])
    top = [
        angular_acceleration(trial.motion)
        for trial, rate in zip(stays, rates, strict=True)
        if rate >= FLAT * rates.max()
    ]
    return [min(top), max(top)]


def _search(found: Found) -> dict[str, Any]:
    return {"seed": found.seed, **_proof(found.proof), "evaluations": found.runs,
            "freedoms_at_rest": None if found.at_rest is None else _proof(found.at_rest)}  # fmt: skip


def _proof(proof: Proof) -> dict[str, Any]:
    trial = proof.trial
    return {**_point(trial), "failed_runs": trial.failed, "runs": trial.runs, "tests": proof.tests,
            "certain": proof.certain}  # fmt: skip
