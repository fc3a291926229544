"""An object from `plategait estimate --out` or `plategait identify`: its numbers, and a cloud of sheets of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from plategait.errors import InputError
from plategait.lab.scenario_json import flat, plain_scenario
from plategait.model.fragment import Fragment, read_fragment
from plategait.model.parameters import find_parameter
from plategait.model.scenario import Scenario

DRAWS = 24
"""Sheets of a cloud."""
SEED = 0


def object_payload(path: Path, scenario: Scenario) -> dict[str, Any]:
    """Object laid over a scenario at its values, and draws of what is uncertain of it, the same at each call.

    `set` of a sample is what to put in the scenario, by dotted name.

    Raises
    ------
    InputError
        When the file cannot be read, or its values do not fit the scenario.
    """
    fragment = read_fragment(path, "WHAT")
    nominal = fragment.apply(scenario)
    plain, _ = plain_scenario(nominal)
    samples = _cloud(fragment, scenario, flat(plain))
    uncertain = any(m.sd > 0 for m in fragment.parameters.values())
    notes = ["the file tells no uncertainty: there is one sheet and no cloud"] if not uncertain else []
    if uncertain and len(samples) < DRAWS:
        notes.append(f"{DRAWS - len(samples)} of {DRAWS} draws make no valid scenario and are left out")
    return {
        "scenario": plain, "source": fragment.source, "confidence": fragment.confidence,
        "parameters": [_parameter(fragment, name) for name in fragment.parameters],
        "samples": samples if uncertain else [], "notes": notes,
    }  # fmt: skip


def _cloud(fragment: Fragment, scenario: Scenario, nominal: dict[str, Any]) -> list[dict[str, Any]]:
    generator = np.random.default_rng(SEED)
    samples = []
    for _ in range(DRAWS):
        try:
            drawn = flat(plain_scenario(fragment.draw(scenario, generator))[0])
        except InputError:
            continue
        samples.append({"set": {name: value for name, value in drawn.items() if nominal.get(name) != value}})
    return samples


def _parameter(fragment: Fragment, name: str) -> dict[str, Any]:
    measured, quantity = fragment.parameters[name], find_parameter(name).quantity
    assert quantity is not None
    low, high = (end if np.isfinite(end) else None for end in (measured.low, measured.high))
    return {
        "name": name, "unit": quantity.unit, "display": quantity.display, "value": measured.value, "sd": measured.sd,
        "low": low, "high": high,
    }  # fmt: skip
