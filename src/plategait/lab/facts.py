"""What the page knows of the model, from the models themselves: fields with their units and limits, presets, words."""

from __future__ import annotations

import math
import types
from collections.abc import Iterator
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic.fields import FieldInfo

from plategait.curve.protocol import USUAL
from plategait.engine.channels import CHANNELS
from plategait.lab.scenario_json import plain_scenario
from plategait.model.base import Model
from plategait.model.inferred import DEPARTURES
from plategait.model.motion import AXES, Wave
from plategait.model.parameters import SHORTHANDS
from plategait.model.presets import PRESETS, preset
from plategait.model.scenario import Scenario
from plategait.simulation.observables import FAILURES, GAITS
from plategait.simulation.registry import BUILT_IN
from plategait.units import COMMON_UNITS, Quantity, parse
from plategait.version import __version__


def facts() -> dict[str, Any]:
    """Everything that the page shows beside what the engine tells; plain data, the same for every payload."""
    return {
        "version": __version__,
        "presets": {name: _preset(name) for name in PRESETS},
        "departures": {d.name: {"number": d.number, "of": d.of or None, "interval": list(d.interval), "why": d.why}
                       for d in DEPARTURES},
        "fields": list(fields()),
        "shorthands": [_number(name, quantity, "", None) for name, quantity in SHORTHANDS.items()],
        "units": {unit: [factor, si] for unit, (factor, si) in COMMON_UNITS.items()},
        "channels": [{"name": c.name, "unit": c.unit, "description": c.long_name, "kind": c.kind}
                     for c in CHANNELS.values()],
        "observables": [{"name": o.name, "unit": o.unit, "display": o.read_in, "scale": o.scale, "label": o.label,
                         "description": o.long_name} for o in BUILT_IN],
        "failures": list(FAILURES),
        "gaits": list(GAITS),
        "protocol": {"duration": USUAL.duration, "transient": USUAL.transient, "slip_limit": USUAL.slip_limit},
    }  # fmt: skip


def fields() -> Iterator[dict[str, Any]]:
    """Every number and choice of a scenario by its dotted name; elements of lists go by `*`.

    `on` says at which values of the choice beside it a field is there: a radius on a disk, an amplitude as an angle on
    a rotation; None where it always is. `part` is the part that may be left out as a whole, such as the plate.
    """
    yield from _inside(Scenario, "", None)


def _preset(name: str) -> dict[str, Any]:
    told = preset(name)
    return {
        "scenario": plain_scenario(told.scenario)[0], "summary": told.summary, "published": dict(told.published),
        "inferred": dict(told.inferred),
    }  # fmt: skip


def _inside(model: type[Model], prefix: str, part: str | None, on: list[str] | None = None) -> Iterator[dict[str, Any]]:
    for name, info in model.model_fields.items():
        dotted, kinds = f"{prefix}{name}", list(_kinds(info.annotation))
        models = [kind for kind in kinds if isinstance(kind, type) and issubclass(kind, Model)]
        quantity = next((kind for kind in [*info.metadata, *kinds] if isinstance(kind, Quantity)), None)
        words = [word for kind in kinds if get_origin(kind) is Literal for word in get_args(kind)]
        listed = "*." if any(kind is tuple for kind in kinds) else ""
        if name == "samples":  # a trajectory has many numbers and none that is turned
            continue
        if len(models) > 1:
            shapes = [m.model_fields["shape"].default for m in models]
            yield _word(f"{dotted}.shape", shapes, info, part)
            for shape, each in zip(shapes, models, strict=True):
                yield from _inside(each, f"{dotted}.", part, [shape])
        elif models:
            optional = part or (dotted if type(None) in kinds or listed else None)
            yield from _inside(models[0], f"{dotted}.{listed}", optional, on)
        elif model is Wave and name == "amplitude":
            for axes in ([a for a in AXES if not a.startswith("r")], [a for a in AXES if a.startswith("r")]):
                measured = Wave(axis=axes[0], amplitude=0.0).quantity(name)
                assert measured is not None
                yield _number(dotted, measured, info.description or "", None, part=part, on=axes)
        elif quantity is not None and not listed:
            default = None if info.is_required() else info.default
            optional = type(None) in kinds
            yield _number(dotted, quantity, info.description or "", default, part=part, on=on, optional=optional)
        elif words and name != "shape":
            yield _word(dotted, words, info, part)


def _kinds(annotation: Any) -> Iterator[Any]:
    """What a field may be: members of a union, what is listed, and what numbers are annotated with."""
    origin = get_origin(annotation)
    if origin is Annotated:
        yield from annotation.__metadata__
        yield from _kinds(annotation.__origin__)
    elif origin in (Union, types.UnionType):
        for member in get_args(annotation):
            yield from _kinds(member)
    elif origin is tuple:
        yield tuple
        yield from _kinds(get_args(annotation)[0])
    else:
        yield annotation


def _number(
    name: str, quantity: Quantity, description: str, default: float | None,
    *, part: str | None = None, on: list[str] | None = None, optional: bool = False,
) -> dict[str, Any]:  # fmt: skip
    def limit(value: float) -> float | None:
        return value if math.isfinite(value) else None

    factor = parse(f"1 {quantity.display}", quantity.unit) if quantity.display else 1.0
    return {
        "name": name, "kind": "number", "unit": quantity.unit, "display": quantity.display, "factor": factor,
        "example": quantity.example, "above": limit(quantity.above), "at_least": limit(quantity.at_least),
        "at_most": limit(quantity.at_most), "smallest": quantity.smallest if quantity.above == 0 else None,
        "default": default, "optional": optional, "description": description, "choices": None, "part": part, "on": on,
    }  # fmt: skip


def _word(name: str, choices: list[str], info: FieldInfo, part: str | None) -> dict[str, Any]:
    default = None if info.is_required() else info.default
    return {
        "name": name, "kind": "choice", "unit": "", "display": "", "factor": 1.0, "example": choices[0], "above": None,
        "at_least": None, "at_most": None, "smallest": None, "default": default, "optional": False,
        "description": info.description or "", "choices": choices, "part": part, "on": None,
    }  # fmt: skip
