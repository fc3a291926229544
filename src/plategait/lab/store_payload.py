"""A store (`plategait sweep`): what is varied, what each point showed, and what to set to run it again."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plategait.campaign.opened import Campaign, open_sweep
from plategait.campaign.points import Point, grid_shape
from plategait.errors import InputError
from plategait.lab.lean import every, lean
from plategait.lab.scenario_json import flat, plain_scenario
from plategait.model.parameters import SHORTHANDS
from plategait.model.remade import OF_A_MATERIAL, THICKNESS
from plategait.simulation.registry import all_observables

MOST_POINTS = 1500


def store_payload(path: Path) -> dict[str, Any]:
    """Parameters, observables and points of a store; of a large one a coarser grid, or points evenly apart.

    `set` of a point is what to put in the nominal scenario, by dotted name: shorthands as the fields that they change.

    Raises
    ------
    InputError
        When there is no store, it is damaged, or nothing of it has been run.
    """
    store = open_sweep(path)
    if not store.done.any():
        raise InputError(
            "WHAT", f"{path}, of which nothing has been run", "a store with points", f"plategait sweep {path.stem}.toml"
        )
    plain, notes = plain_scenario(store.plan.scenario)
    kept = _kept(store)
    if len(kept) < (there := int(store.done.sum())):
        notes.append(f"{len(kept)} of the store's {there} points are shown")
    if not store.complete:
        notes.append(f"{int(store.done[: store.n_base].sum())} of {store.n_base} points have been run")
    observables = [o for name, o in all_observables().items() if o.label and name in store.attributes["observables"]]
    values = {o.name: lean(store.observable(o.name)[0][kept]) for o in observables}
    points = store.points
    return {
        "scenario": plain,
        "parameters": [_parameter(store, i, [points[k] for k in kept]) for i in range(len(store.plan.parameters))],
        "observables": [{"name": o.name, "unit": o.unit, "display": o.read_in, "scale": o.scale, "label": o.label}
                        for o in observables],
        "grid": bool(store.plan.grid),
        "repeats": store.plan.repeats,
        "points": [
            {**point, "values": {name: column[i] for name, column in values.items()}}
            for i, point in enumerate(_points(store, kept, points))
        ],
        "notes": notes,
    }  # fmt: skip


def _kept(store: Campaign) -> NDArray[np.int64]:
    """Places in the store's data that are shown: all where they fit, or of a whole grid a coarser one."""
    done = int(store.done.sum())
    shape = grid_shape(store.plan)
    if done <= MOST_POINTS or not shape or not store.complete:
        return every(done, MOST_POINTS)
    steps = np.ones(len(shape), dtype=int)
    while np.prod(counts := -(-np.array(shape) // steps)) > MOST_POINTS:
        steps[int(np.argmax(counts))] += 1
    places = np.arange(int(np.prod(shape))).reshape(shape)
    return places[tuple(slice(None, None, step) for step in steps)].ravel()


def _parameter(store: Campaign, which: int, points: list[Point]) -> dict[str, Any]:
    parameter = store.plan.parameters[which]
    values = [point[parameter.name] for point in points]
    quantity = parameter.quantity
    return {
        "name": parameter.name, "unit": parameter.unit, "display": quantity.display if quantity else "",
        "values": sorted(set(values)),  # type: ignore[type-var]
    }  # fmt: skip


def _points(store: Campaign, kept: NDArray[np.int64], points: list[Point]) -> list[dict[str, Any]]:
    out = store.outcomes
    rate, spread, time = (lean(column[kept]) for column in (out.rate, out.spread, out.failure_time))
    names = [p.name for p in store.plan.parameters]
    by_field = not any(name in SHORTHANDS or name in OF_A_MATERIAL or name == THICKNESS for name in names)
    nominal = flat(plain_scenario(store.plan.scenario)[0])
    told = []
    for i, place in enumerate(kept.tolist()):
        point = points[place]
        told.append({
            "at": [point[name] for name in names], "set": dict(point) if by_field else _changed(store, point, nominal),
            "spin_rate": rate[i], "spread": spread[i], "gait": out.gait[place],
            "failure": out.failure[place] or None, "failure_time": time[i], "failed": bool(out.failed[place]),
            "failed_runs": int(out.failed_runs[place]),
        })  # fmt: skip
    return told


def _changed(store: Campaign, point: Point, nominal: dict[str, Any]) -> dict[str, Any]:
    """Fields of the scenario at a point that differ from the nominal one's."""
    there = flat(plain_scenario(store.plan.at(point))[0])
    return {name: value for name, value in there.items() if nominal.get(name) != value}
