"""Runs as labelled data that any xarray user opens with one line."""

from __future__ import annotations

import json
import platform
import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from plategait.engine.channels import CHANNELS, ROTATION
from plategait.engine.recording import RunRequest
from plategait.errors import InputError, check_kind
from plategait.files.output import check_writable, write_whole
from plategait.memory import available_memory, in_words
from plategait.model.scenario_file import write_scenario
from plategait.simulation import observables
from plategait.simulation.registry import all_observables
from plategait.version import __version__

if TYPE_CHECKING:
    import xarray

    from plategait.simulation.result import Simulation

SUFFIXES = (".nc",)
# The recordings in both of the core's and our own precision, the dataset, the file in memory while it grows.
_COPIES = 4
# The time is a coordinate.
_SERIES = [channel for channel in CHANNELS.values() if channel.name != "time"]


def dataset_of(simulation: Simulation) -> xarray.Dataset:
    """Samples, shapes and summary of every run of a simulation.

    Dimensions are ``run``, ``time``, and with snapshots ``snapshot_time``, ``node``, ``axis``. Where runs ended early
    the rest is NaN. The attributes hold the scenario (TOML), the summary (JSON), version, engine, time step, seed and
    platform.

    Parameters
    ----------
    simulation : Simulation
        What was simulated; its channels stand there in SI, with units and names.
    """
    from plategait.simulation.result import Simulation

    check_kind(simulation, Simulation, "simulation", "simulate(scenario)")
    import xarray

    longest = max(simulation.recordings, key=lambda r: len(r["time"]))

    variables: dict[str, object] = {}
    for channel in _SERIES:
        series = _side_by_side([r[channel.name] for r in simulation.recordings])
        variables[channel.name] = (("run", "time"), series, {"long_name": channel.long_name, "units": channel.unit})
    turned = [observables.rotation(r["spin_cross"], r["spin_dot"]) for r in simulation.recordings]
    of_rotation = {"long_name": ROTATION.long_name, "units": ROTATION.unit}
    variables[ROTATION.name] = (("run", "time"), _side_by_side(turned), of_rotation)
    coordinates: dict[str, object] = {
        "time": (("time",), longest["time"], {"long_name": "time", "units": "s"}),
        "run": np.arange(len(simulation.recordings)),
    }
    if len(longest.snapshots):
        most = max(simulation.recordings, key=lambda r: len(r.snapshots))
        shapes = _side_by_side([r.snapshots for r in simulation.recordings])
        poses = _side_by_side([r.plate_pose for r in simulation.recordings])
        variables["position"] = (
            ("run", "snapshot_time", "node", "axis"),
            shapes,
            {"long_name": "node position, world frame", "units": "m"},
        )
        variables["plate_pose"] = (
            ("run", "snapshot_time", "degree_of_freedom"),
            poses,
            {"long_name": "x, y, z (m), rx, ry, rz (rad)"},
        )
        coordinates["snapshot_time"] = (("snapshot_time",), most.snapshot_time, {"units": "s"})
        coordinates["axis"] = ["x", "y", "z"]
    for name, values, unit in (
        ("spin_rate", [o.spin.rate for o in simulation.observations], "rad/s"),
        ("failure_time", [o.failure.time if o.failure else np.nan for o in simulation.observations], "s"),
    ):
        variables[name] = (("run",), np.array(values), {"units": unit})
    for observable in all_observables().values():
        values = np.array([o.values.get(observable.name, np.nan) for o in simulation.observations])
        variables[observable.name] = (
            ("run",),
            values,
            {"long_name": observable.long_name, "units": observable.unit},
        )
    variables["gait"] = (("run",), np.array([o.gait for o in simulation.observations]))
    variables["failure"] = (("run",), np.array([o.failure.kind if o.failure else "" for o in simulation.observations]))
    variables["energy_closed"] = (("run",), np.array([o.energy.closes for o in simulation.observations]))
    attributes = {
        "title": simulation.scenario.name,
        "scenario": write_scenario(simulation.scenario),
        "summary": json.dumps(simulation.summary()),
        "plategait_version": __version__,
        "engine": simulation.engine,
        "dt_s": simulation.recordings[0].dt,
        "seed": simulation.seed,
        "platform": f"{platform.system()} {platform.machine()}",
    }
    return xarray.Dataset(variables, coordinates, attributes)


def _side_by_side(series: Sequence[np.ndarray]) -> np.ndarray:
    """(n_runs, longest, …) series of every run; NaN where one ended early."""
    longest = max(len(values) for values in series)
    whole = np.full((len(series), longest, *series[0].shape[1:]), np.nan, dtype=series[0].dtype)
    for row, values in zip(whole, series, strict=True):
        row[: len(values)] = values
    return whole


def write_dataset(simulation: Simulation, path: Path | str) -> None:
    """Write a simulation to a netCDF file, whole or not at all.

    Parameters
    ----------
    simulation : Simulation
        What was simulated.
    path : Path or str
        File that ends in .nc; netCDF 4.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    check_writable(path, SUFFIXES, "out")
    # Put together in memory: HDF5 ends the process where a disk is full.
    write_whole(dataset_of(simulation).to_netcdf(engine="h5netcdf"), path, SUFFIXES, "out")


def dataset_bytes(run: RunRequest) -> int:
    """Size of the arrays of `dataset_of` for a run that goes to its end; that of the file is nearly the same."""
    return 8 * len(_SERIES) * run.samples + (12 * run.lattice.n_nodes + 8 * 6) * run.pictures


def check_room(run: RunRequest, repeats: int, path: Path, field: str = "--out") -> None:
    """Refuse a dataset for which there is not the memory or the disk, before the runs are made.

    Raises
    ------
    InputError
        That says how much it takes and how much there is.
    """
    size, disk = repeats * dataset_bytes(run), shutil.disk_usage(path.absolute().parent).free
    places = (("memory", _COPIES * size, available_memory()), ("disk", size, disk))
    for what, needed, free in places:
        if needed > free:
            shorter = 0.5 * run.scenario.duration * free / needed
            raise InputError(field, f"{path}, which takes {in_words(needed)} of {what}",
                             f"within the {in_words(free)} that are free", f'--duration "{shorter:.3g} s"')  # fmt: skip
