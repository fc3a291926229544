"""A run from a data file (`plategait simulate --out run.nc`): its series and shapes, thinned to what a page shows."""

from __future__ import annotations

import base64
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from plategait.arrays import Array
from plategait.engine.channels import CHANNELS, Channel
from plategait.errors import InputError
from plategait.lab.lean import every, lean, stride
from plategait.lab.scenario_json import plain_scenario, told_scenario

if TYPE_CHECKING:
    import xarray

# Numbers of all series, and bytes of all shapes.
MOST_NUMBERS, MOST_SHAPES = 40_000, 300_000
# Samples and shapes of a file that are read at all.
MOST_SAMPLES = 20_000_000
_ALLOWED, _HINT = "a run that plategait wrote", "plategait simulate cheese --out run.nc"


def run_payload(path: Path) -> dict[str, Any]:
    """Scenario, series and shapes of the first run in a file: that from the nominal start.

    Raises
    ------
    InputError
        When the file is damaged, or none of ours.
    """
    import xarray

    try:
        with xarray.open_dataset(path, engine="h5netcdf", decode_times=False) as data:
            return _told(path, data)
    except InputError:
        raise
    except Exception as error:  # h5py's own, and Python's for what is spoilt
        raise InputError("WHAT", f"{path} ({type(error).__name__} while reading it)", _ALLOWED, _HINT) from None


def _told(path: Path, data: xarray.Dataset) -> dict[str, Any]:
    if not {"scenario", "summary", "plategait_version"} <= set(data.attrs) or "time" not in data.coords:
        raise InputError("WHAT", f"{path}, a data file of another kind", _ALLOWED, _HINT)
    if max(data.sizes.values()) > MOST_SAMPLES:
        raise InputError("WHAT", f"{path}, of {max(data.sizes.values())} samples", _ALLOWED, _HINT)
    scenario, notes = plain_scenario(told_scenario(str(data.attrs["scenario"])))
    run = data.isel(run=0)
    if data.sizes["run"] > 1:
        notes.append(f"the first of {data.sizes['run']} runs is shown")
    time, channels, note = _series(run)
    told = {
        "scenario": scenario, "summary": json.loads(str(data.attrs["summary"])), "time": lean(time),
        "channels": {name: lean(values) for name, values in channels.items()},
        "gait": str(run["gait"].item()), "failure": str(run["failure"].item()) or None,
        "spin_rate": lean([run["spin_rate"].item()])[0],
    }  # fmt: skip
    shapes, more = _shapes(run)
    return told | shapes | {"notes": [*notes, *note, *more]}


def _series(run: xarray.Dataset) -> tuple[Array, dict[str, Array], list[str]]:
    """Times and series of a run to its end, and what was left out."""
    there = [CHANNELS[name] for name in CHANNELS if name in run.data_vars]
    time = run["time"].values
    whole = int(np.isfinite(run["centre_x"].values).sum())
    step = stride(whole * (len(there) + 1), MOST_NUMBERS)
    channels = {channel.name: _thinned(run[channel.name].values[:whole], channel, step) for channel in there}
    note = [f"of the series one sample in {step} is shown"] if step > 1 else []
    return time[:whole:step], channels, note


def _thinned(values: Array, channel: Channel, step: int) -> Array:
    """Every so many samples: states as they are, amounts summed and shares averaged since the one kept before."""
    if channel.kind == "state" or step == 1:
        return values[::step]
    sums = np.add.reduceat(values[1:], np.arange(0, max(1, len(values) - 1), step)) if len(values) > 1 else values[1:]
    kept = np.concatenate([values[:1], sums])[: len(values[::step])]
    return kept if channel.kind == "amount" else np.concatenate([kept[:1], kept[1:] / step])


def _shapes(run: xarray.Dataset) -> tuple[dict[str, Any], list[str]]:
    """Shapes (base64 of single precision, [n][nodes][3], world) and plate poses of a run, and what was left out."""
    if "position" not in run:
        return {"snapshot_time": [], "snapshots": "", "plate_pose": []}, ["the file holds no shapes"]
    nodes = run.sizes["node"]
    whole = int(np.isfinite(run["position"][:, 0, 0].values).sum())
    kept = every(whole, max(1, MOST_SHAPES // (12 * nodes)))
    # A file of hours is read where it is shown.
    shapes = (
        run["position"].isel(snapshot_time=slice(0, whole, stride(whole, max(1, MOST_SHAPES // (12 * nodes))))).values
    )
    note = [f"of the shapes {len(kept)} of {whole} are shown"] if len(kept) < whole else []
    return {
        "snapshot_time": lean(run["snapshot_time"].values[kept]),
        "snapshots": base64.b64encode(np.ascontiguousarray(shapes, dtype="<f4").tobytes()).decode(),
        "plate_pose": [lean(pose) for pose in run["plate_pose"].values[kept]],
    }, note
