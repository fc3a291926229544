"""The plan of a sweep: which points, how often, and what is kept. Read from TOML."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal

from pydantic import Field, model_validator

from plategait.campaign.values import read_values
from plategait.engine.channels import check_series
from plategait.engine.engines import Engine
from plategait.errors import InputError, check_kind
from plategait.files.toml import read_toml
from plategait.model.base import Model
from plategait.model.parameters import Parameter, Value, find_parameter, with_values
from plategait.model.presets import PRESETS, as_scenario
from plategait.model.scenario import Scenario
from plategait.model.scenario_file import read_scenario, write_scenario
from plategait.units import ANGULAR_FREQUENCY, Duration

EXAMPLE = "examples/sweep.toml"


class Sample(Model):
    """Points spread evenly over ranges."""

    count: int = Field(gt=0, le=10**7, description="points", examples=["128"])
    method: Literal["sobol", "latin-hypercube"] = Field(default="sobol", description="how they are spread")
    ranges: dict[str, Any] = Field(
        description="from and to, by parameter", examples=['{ "motion.frequency" = ["10 Hz", "30 Hz"] }']
    )


class Record(Model):
    """What is kept of each run beside its summary."""

    channels: tuple[str, ...] = Field(default=(), description="time series by name", examples=['["rotation"]'])
    interval: Duration = Field(default=0.01, description="time between their samples")
    snapshots: Duration | None = Field(default=None, description="time between recorded shapes")


class Sweep(Model):
    """A plan: exactly one of `grid`, `points` and `sample` says which points.

    ``grid`` takes every combination of its lists, ``points`` takes its lists side by side. Beside what is stored here,
    ``set`` may be given: parameters that are the same at every point.
    """

    name: str = Field(default="sweep", description="what the results call it", examples=['"sweep"'])
    scenario: Scenario = Field(description="what is varied: a preset, a file or a table", examples=['"cheese"'])
    grid: dict[str, Any] = Field(default={}, description="every combination of lists by parameter")
    points: dict[str, Any] = Field(default={}, description="lists side by side, by parameter")
    sample: Sample | None = Field(default=None, description="space-filling points")
    repeats: int = Field(default=1, ge=1, le=10**4, description="runs of each point, from different starts")
    seed: int = Field(default=0, ge=0, le=2**63 - 1, description="of the starts and of the sample", examples=["0"])
    engine: Engine = Field(default="cpu", description="what runs it: the native core, or rigid tiles")
    batch: int | None = Field(default=None, ge=1, le=10**5, description="points written at a time", examples=["64"])
    record: Record = Field(default_factory=Record, description="what is kept beside the summary")
    nominal_natural_frequency: float | None = Field(
        default=None, description="what the sheet's own natural frequency is called", examples=['"10 pi rad/s"']
    )

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any) -> Any:
        if not isinstance(data, dict) or "scenario" not in data:
            return data
        data = dict(data)
        scenario = _scenario(data["scenario"])
        nominal = data.get("nominal_natural_frequency")
        if nominal is not None:
            nominal = ANGULAR_FREQUENCY.read(nominal, "nominal_natural_frequency")
        fixed = _flat(data.pop("set", {}), "set")
        fixed = {name: find_parameter(name, scenario).read(value) for name, value in fixed.items()}
        scenario = with_values(scenario, fixed, nominal)
        for kind in ("grid", "points"):
            lists = _flat(data.get(kind) or {}, kind)
            data[kind] = {name: read_values(find_parameter(name, scenario), lists[name]) for name in lists}
        return data | {"scenario": scenario, "nominal_natural_frequency": nominal}

    @model_validator(mode="after")
    def _one_kind(self) -> Sweep:
        kinds = [kind for kind in ("grid", "points", "sample") if getattr(self, kind)]
        if len(kinds) != 1:
            raise InputError("sweep", "nothing of the three" if not kinds else " and ".join(kinds),
                             "one of grid, points and sample", '[grid] "motion.frequency" = "12:30:1 Hz"')  # fmt: skip
        lengths = {name: len(values) for name, values in self.points.items()}
        if len(set(lengths.values())) > 1:
            got = ", ".join(f"{name} {length}" for name, length in lengths.items())
            raise InputError("points", got, "lists of one length", "a grid for every combination")
        self.sample_ranges()
        if self.record.interval < 1e-4 or (self.record.snapshots or 1.0) < 1e-3:
            raise InputError("record", "an interval too short", "0.1 ms or more, 1 ms for snapshots", '"10 ms"')
        check_series(self.record.channels, "record.channels")
        return self

    def sample_ranges(self) -> dict[str, tuple[float, float]]:
        """From and to of each sampled parameter, SI."""
        ranges: dict[str, tuple[float, float]] = {}
        if self.sample is None:
            return ranges
        for name, values in _flat(self.sample.ranges, "sample.ranges").items():
            parameter = find_parameter(name, self.scenario)
            ends = read_values(parameter, values)
            if parameter.quantity is None or len(ends) != 2 or not ends[0] < ends[1]:  # type: ignore[operator]
                hint = f"[{parameter.example}, twice as much]"
                raise InputError(f"sample.ranges.{name}", values, "two numbers that rise", hint)
            ranges[name] = (float(ends[0]), float(ends[1]))
        if not ranges:
            raise InputError("sample.ranges", "nothing", "at least one range", '"motion.frequency" = ["9 Hz", "30 Hz"]')
        return ranges

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """What is varied, in order."""
        names = self.sample_ranges() or self.grid or self.points
        return tuple(find_parameter(name, self.scenario) for name in names)

    def at(self, values: Mapping[str, Value]) -> Scenario:
        """Scenario at a point."""
        return with_values(self.scenario, values, self.nominal_natural_frequency)

    def to_json(self) -> str:
        """Everything but the batch size, as text that `sweep_of_json` reads back the same."""
        sample = self.sample and {"count": self.sample.count, "method": self.sample.method,
                                  "ranges": self.sample_ranges()}  # fmt: skip
        record = {name: getattr(self.record, name) for name in type(self.record).model_fields}
        plain = {name: getattr(self, name) for name in ("name", "grid", "points", "repeats", "seed", "engine")}
        nominal = self.nominal_natural_frequency
        return json.dumps(
            plain | {"scenario": write_scenario(self.scenario), "sample": sample, "record": record,
                     "nominal_natural_frequency": nominal}
        )  # fmt: skip


def sweep_of_json(text: str) -> Sweep:
    """Sweep from the text of `Sweep.to_json`."""
    data = json.loads(text)
    return Sweep(**data | {"scenario": tomllib.loads(data["scenario"])})


def read_sweep(path: Path | str) -> Sweep:
    """Read a sweep from a TOML file.

    Parameters
    ----------
    path : Path or str
        TOML file; `examples/sweep.toml` is a commented one.

    Raises
    ------
    InputError
        When the file cannot be read, is no TOML, or a field is not as it must be.
    """
    check_kind(path, (str, Path), "plan", EXAMPLE)
    path = Path(path)
    data, _ = read_toml(path, "sweep", "a sweep file", EXAMPLE)
    scenario = data.get("scenario")
    if isinstance(scenario, str) and scenario not in PRESETS:
        data["scenario"] = read_scenario(path.parent / scenario)
    return Sweep(**{"name": path.stem} | data)


def _scenario(scenario: Any) -> Scenario:
    """Scenario of a table, or whatever else tells one."""
    if isinstance(scenario, Mapping):
        try:
            return Scenario(**scenario)
        except InputError as error:
            raise InputError(f"scenario.{error.field}", error.got, error.allowed, error.hint) from None
    return as_scenario(scenario)


def _flat(table: Any, field: str) -> dict[str, Any]:
    """Dotted names of nested tables: in TOML ``motion.frequency = …`` is a table in a table."""
    if not isinstance(table, Mapping):
        raise InputError(field, table, "a table of parameters", f'[{field}] "motion.frequency" = …')
    flat: dict[str, Any] = {}
    for name, value in table.items():
        if isinstance(value, Mapping) and not {"from", "to", "count"} & set(value):
            flat |= {f"{name}.{inner}": v for inner, v in _flat(value, field).items()}
        else:
            flat[name] = value
    return flat
