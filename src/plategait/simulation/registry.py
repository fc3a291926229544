"""Observables by name: what a run shows beside its spin, gait and failure, each with its unit and how it is measured.

Adding one is a row in `BUILT_IN`, a call of `add_observable`, or an installed package with an entry point of the group
``plategait.observables`` (CONTRIBUTING.md shows it). Tables, JSON, CSV of curves, data files and stores have it, and
`plategait plot STORE --show NAME` draws it.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Collection, Container, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from plategait.arrays import Array, Flags
from plategait.engine.channels import CHANNELS
from plategait.errors import InputError, check_kind
from plategait.model.scenario import Scenario
from plategait.simulation import observables
from plategait.simulation.energy import EnergyLedger
from plategait.simulation.ensemble import mean_of_unfailed
from plategait.units import parse

GROUP = "plategait.observables"
"""Entry points of installed packages that bring observables."""
RESERVED = {
    *CHANNELS, "spin_rate", "spin_rate_sd", "spin_rate_low", "spin_rate_high", "settled", "gait", "failure",
    "failure_time", "failed", "failed_runs", "failures", "runs", "counted_runs", "energy_closed", "open_ledgers", "dt",
    "steps", "status", "checksum", "time", "point", "repeat", "run", "sample", "snapshot", "snapshot_time", "node",
    "axis", "position", "plate_pose", "degree_of_freedom", "frequency", "angle", "engine", "seed", "wall",
}  # fmt: skip
"""Names that data files, stores, tables and JSON use for something else."""


@dataclass(frozen=True, eq=False)
class Window:
    """What observables are measured from.

    Attributes
    ----------
    scenario : Scenario
    channels : mapping of str to (n,) array
        Time series of the run, SI (`plategait.engine.channels`), over all of it.
    start, end : float
        From the first whole plate period after the transient to the end or the failure, s; equal where there is none.
    energy : EnergyLedger
        Of the whole run.
    """

    scenario: Scenario
    channels: Mapping[str, Array]
    start: float
    end: float
    energy: EnergyLedger

    @property
    def time(self) -> Array:
        """(n,) times of the samples, s."""
        return self.channels["time"]

    @cached_property
    def inside(self) -> Flags:
        """(n,) samples that lie in the window."""
        return (self.time > self.start) & (self.time <= self.end)

    @cached_property
    def twist(self) -> observables.Twist:
        """Mean velocity in the plate's plane."""
        channels, period = self.channels, self.scenario.motion.period
        angle = observables.rotation(channels["spin_cross"], channels["spin_dot"])
        moves = np.stack([channels["centre_x"], channels["centre_y"], angle])
        return observables.twist(self.time, moves, period, self.start, self.end)

    def period_means(self, name: str) -> Array:
        """Mean of a channel over each whole plate period of the window."""
        period = self.scenario.motion.period
        return observables.period_means(self.time, self.channels[name], period, self.start, self.end)

    def period_maxima(self, name: str) -> Array:
        """Largest sample of a channel in each whole plate period of the window."""
        period = self.scenario.motion.period
        return observables.period_maxima(self.time, self.channels[name], period, self.start, self.end)

    def mean(self, name: str) -> float:
        """Mean of a channel over the window; NaN where it is empty."""
        values = self.period_means(name)
        return float(values.mean()) if len(values) else np.nan


@dataclass(frozen=True)
class Observable:
    """One number that a run shows.

    Attributes
    ----------
    name : str
        By which programs know it: "bending_amplitude".
    unit : str
        SI, of what is measured; "1" for a share.
    long_name : str
        What it is, in words.
    measure : callable
        From a `Window` to the number; NaN where there is nothing to measure.
    label : str
        Its row in tables; those without one are in files and JSON alone.
    display : str
        Unit that people read: "mm", "%". By default the SI one.
    over_runs : {"mean", "worst"}
        What several starts show together: the mean over those that did not fail, or the one furthest from zero of all.
    in_curves : bool
        Whether files of curves have it without a label too.
    """

    name: str
    unit: str
    long_name: str
    measure: Callable[[Window], float]
    label: str = ""
    display: str = ""
    over_runs: Literal["mean", "worst"] = "mean"
    in_curves: bool = False

    def __post_init__(self) -> None:
        """Refuse a name that no column could have, and units that do not fit each other."""
        if not re.fullmatch(r"[a-z][a-z0-9_]*", self.name):
            raise InputError("observable", self.name, "a name in small letters, digits and _", "edge_height")
        if not callable(self.measure):
            raise InputError(f"observable {self.name}", self.measure, "a function of a Window", "measure=edge_height")
        try:
            _ = self.scale
        except ValueError:
            raise InputError(
                f"observable {self.name}", f"{self.display} for people", f"a unit of {self.unit}", self.unit
            ) from None

    @property
    def read_in(self) -> str:
        """Unit that people read."""
        return self.display or self.unit

    @cached_property
    def scale(self) -> float:
        """People's numbers over SI's."""
        return 1 / parse(f"1 {self.read_in}", self.unit) if self.read_in not in ("1", "%", self.unit) else 1.0

    @property
    def heading(self) -> str:
        """Its column in CSV files, which tells the unit: "plate_power_mW"; a share stays a share."""
        return self.name if self.read_in in ("1", "%", "") else f"{self.name}_{self.read_in.replace('/', '_')}"

    @property
    def sd_heading(self) -> str:
        """Column of its standard deviation in CSV files: "plate_power_sd_mW"."""
        return self.heading.replace(self.name, f"{self.name}_sd", 1)

    @property
    def key(self) -> str:
        """Its name in JSON: "plate_power_mw"."""
        return re.sub(r"[^a-z0-9]+", "_", self.heading.lower())

    def over(self, values: ArrayLike, failed: ArrayLike) -> Array:
        """What runs show together: (…,) of values (…, runs), of which some failed."""
        if self.over_runs == "mean":
            return mean_of_unfailed(values, failed)
        values = np.asarray(values, dtype=float)
        furthest = np.where(np.isnan(values), np.inf, np.abs(values)).argmax(axis=-1)
        return np.take_along_axis(values, furthest[..., None], axis=-1)[..., 0]


def _velocity(which: int) -> Callable[[Window], float]:
    return lambda window: float(window.twist.mean[which])


def _covariance(one: int, other: int) -> Callable[[Window], float]:
    return lambda window: float(window.twist.covariance[one, other])


def _drift(window: Window) -> float:
    period, time = window.scenario.motion.period, window.time
    slipped = observables.slip(time, window.channels["centre_x"], window.channels["centre_y"], period)
    averaged = (time <= time[-1] - period / 2) | (time[-1] < period)
    finite = slipped[np.isfinite(slipped) & averaged]
    return float(finite.max()) if len(finite) else np.nan


def _bending_amplitude(window: Window) -> float:
    angles = window.channels["bend_rms"][window.inside]
    return float(angles.max()) if len(angles) else np.nan


def _rim_lift(window: Window) -> float:
    heights = window.period_maxima("height_high")
    return float(heights.mean()) if len(heights) else np.nan


def _plate_power(window: Window) -> float:
    if window.end <= window.start:
        return np.nan
    return float(window.channels["plate_work"][window.inside].sum()) / (window.end - window.start)


_TWIST = ("velocity along the bar", "velocity across the bar", "spin rate")
BUILT_IN = (
    Observable("drift", "m", "furthest slip of the centre", _drift, "drift of the centre", "mm"),
    Observable("velocity_x", "m/s", "mean velocity of the centre along the bar, plate frame", _velocity(0),
               "velocity along the bar", "mm/s"),
    Observable("velocity_y", "m/s", "mean velocity of the centre across the bar, plate frame", _velocity(1),
               "velocity across the bar", "mm/s"),
    *(Observable(f"twist_{'xyw'[i]}{'xyw'[j]}", unit,
                 f"covariance over strides of the {_TWIST[i]} and the {_TWIST[j]}", _covariance(i, j),
                 display=display, in_curves=True)
      for i, j, unit, display in (
          (0, 0, "m^2/s^2", "mm^2/s^2"), (0, 1, "m^2/s^2", "mm^2/s^2"), (1, 1, "m^2/s^2", "mm^2/s^2"),
          (0, 2, "m*rad/s^2", "mm*deg/s^2"), (1, 2, "m*rad/s^2", "mm*deg/s^2"), (2, 2, "rad^2/s^2", "deg^2/s^2"))),
    Observable("contact_fraction", "1", "mean share of the nodes that touch", lambda w: w.mean("contact"),
               "nodes in contact", "%"),
    Observable("flight_fraction", "1", "share of the time in which nothing touches", lambda w: w.mean("flight"),
               "time in flight", "%"),
    Observable("bending_amplitude", "rad", "largest rms angle of the bending joints", _bending_amplitude,
               "bending amplitude", "deg"),
    Observable("rim_lift", "m", "greatest height of the object above the plate in each plate period, in the mean",
               _rim_lift, "lift of the rim", "mm"),
    Observable("plate_power", "W", "mean power of the plate", _plate_power, "plate power", "mW"),
    Observable("energy_residual", "1", "energy unaccounted for at the end over the energy given",
               lambda w: w.energy.relative_residual, over_runs="worst"),
    Observable("energy_imbalance", "1", "furthest that the energy was out of balance, over the energy given",
               lambda w: w.energy.imbalance, over_runs="worst"),
)  # fmt: skip
_added: dict[str, Observable] = {}


def add_observable(observable: Observable) -> None:
    """Make an observable known to everything that runs in this process.

    A command, or a worker of a campaign elsewhere, knows those of installed packages (`GROUP`).

    Parameters
    ----------
    observable : Observable
        What to measure in every run from now on.

    Raises
    ------
    InputError
        When there is another of that name.
    """
    check_kind(observable, Observable, "observable", "Observable(name, unit, long_name, measure)")
    if _added.get(observable.name) is not observable:
        _check_free(observable.name, all_observables(), "observable")
    _added[observable.name] = observable


def _check_free(name: str, present: Container[str], field: str) -> None:
    if name in present or name in RESERVED:
        raise InputError(field, name, "a name that is not taken", f"{name}_2")


def all_observables() -> dict[str, Observable]:
    """Every observable by its name: ours, those of installed packages, those added."""
    return {o.name: o for o in BUILT_IN} | _installed() | _added


def find_observable(name: str) -> Observable:
    """Observable by its name.

    Raises
    ------
    InputError
        For a name that none has, with the nearest that one has.
    """
    by_name = all_observables()
    check_name(name, by_name)
    return by_name[name]


def check_name(name: str, names: Collection[str]) -> None:
    """Refuse a name that is none of the observables' here, with the nearest that is.

    Raises
    ------
    InputError
    """
    if name not in names:
        close = difflib.get_close_matches(name, names, n=1, cutoff=0) or ["drift"]
        raise InputError("observable", name, f"one of {', '.join(names)}", close[0])


@cache
def _installed() -> dict[str, Observable]:
    """Observables that installed packages bring."""
    from importlib.metadata import entry_points

    installed: dict[str, Observable] = {}
    for point in entry_points(group=GROUP):
        observable = point.load()
        if not isinstance(observable, Observable):
            raise InputError(f"{GROUP} {point.name}", point.value, "an Observable", "package.module:observable")
        _check_free(observable.name, {o.name for o in BUILT_IN} | set(installed), f"{GROUP} {point.name}")
        installed[observable.name] = observable
    return installed


def measure_all(window: Window) -> dict[str, float]:
    """Every observable of a run, SI.

    Raises
    ------
    InputError
        When one that was added cannot be measured; names it.
    """
    ours = {observable.name: observable.measure(window) for observable in BUILT_IN}
    return ours | {name: _of_others(observable, window) for name, observable in (_installed() | _added).items()}


def _of_others(observable: Observable, window: Window) -> float:
    """What somebody else's function measures; an error of theirs is told as such."""
    try:
        return float(observable.measure(window))
    except Exception as error:
        raise InputError(f"observable {observable.name}", f"{type(error).__name__}: {error}", "a number",
                         "NaN where there is nothing to measure") from error  # fmt: skip
