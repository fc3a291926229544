"""A store opened for reading: checked, labelled, and as a grid where it is one."""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.campaign.plan import Sweep
from plategait.campaign.points import Point, base_points
from plategait.campaign.store import Store, check_path
from plategait.errors import InputError, check_kind
from plategait.shown import Shown
from plategait.simulation.ensemble import TAKEN, Ensemble, mean_of_unfailed, together
from plategait.simulation.registry import all_observables, check_name

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True, eq=False, repr=False)
class Campaign(Shown):
    """A store and how far it has come.

    Attributes
    ----------
    path : Path
    plan : Sweep
    done : (n_points,) bool array
        Points that have been run and are whole on the disk.
    damaged : tuple of int
        Points whose batch is damaged.
    said : str
        What is damaged, in words.
    attributes : dict
    """

    path: Path
    plan: Sweep
    done: NDArray[np.bool_]
    damaged: tuple[int, ...]
    said: str
    attributes: dict[str, Any]

    def told(self) -> list[tuple[str, str]]:
        """What is varied, and how far it has come."""
        more = f", {refined} refine them" if (refined := len(self.done) - self.n_base) else ""
        return [
            ("store", str(self.path)), ("title", self.plan.name),
            ("over", ", ".join(p.name for p in self.plan.parameters)),
            ("points", f"{int(self.done[: self.n_base].sum())} of {self.n_base} run{more}"),
            ("repeats", str(self.plan.repeats)), ("engine", self.plan.engine), ("damage", self.said or "none"),
        ]  # fmt: skip

    @property
    def n_base(self) -> int:
        """Points that the plan names; those after them refine it."""
        return int(self.attributes["base_points"])

    @property
    def complete(self) -> bool:
        """Whether every point that the plan names has been run, and nothing is damaged."""
        return not self.said and bool(self.done[: self.n_base].all())

    @cached_property
    def data(self) -> xarray.Dataset:
        """Points that have been run, dimensions ``point`` × ``repeat``; read when used."""
        import xarray

        everything = xarray.open_zarr(self.path, chunks=None).drop_vars(["checksum", "status"])
        return everything if self.done.all() else everything.isel(point=np.nonzero(self.done)[0])

    @property
    def points(self) -> list[Point]:
        """Values of the swept parameters at each point of `data`."""
        names = [p.name for p in self.plan.parameters]
        values = [self.data[name].values.tolist() for name in names]
        return [dict(zip(names, row, strict=True)) for row in zip(*values, strict=True)]

    @cached_property
    def outcomes(self) -> Ensemble:
        """Rate, gait and failure of each point of `data`, over its repeats."""
        return together(**{name: self.data[name].values for name in TAKEN})

    def from_start(self, number: int) -> Ensemble:
        """Rate, gait and failure of each point of `data` from one of its starts alone; 0 is the nominal one."""
        return together(**{name: self.data[name].values[:, number : number + 1] for name in TAKEN})

    def observable(self, name: str) -> tuple[Array, Array]:
        """(n,) values and standard deviations of an observable at each point of `data`, over its repeats, SI.

        Raises
        ------
        InputError
            For a name that the store has no observable of.
        """
        check_name(name, self.attributes["observables"])
        values, failed = self.data[name].values, self.data["failure"].values.astype(object) != ""
        mean = mean_of_unfailed(values, failed)
        squares = mean_of_unfailed((values - mean[:, None]) ** 2, failed)
        runs = (np.isfinite(values) & ~failed).sum(axis=1)
        observable = all_observables().get(name)  # none where its package is not installed here
        if observable is not None:
            mean = observable.over(values, failed)
        return mean, np.sqrt(squares * runs / np.maximum(runs - 1, 1))

    def as_grid(self) -> xarray.Dataset:
        """Points of a grid with one dimension for each parameter, without those that refine it.

        Raises
        ------
        InputError
            For what is no grid, or is not complete.
        """
        import xarray

        if not self.plan.grid or not self.complete:
            got = "points that are no grid" if not self.plan.grid else f"{int(self.done.sum())} points of {self.n_base}"
            raise InputError("grid", got, "a complete grid", "data, which has a dimension point")
        grid = self.plan.grid
        data, shape = self.data.isel(point=slice(0, self.n_base)), tuple(map(len, grid.values()))
        whole = xarray.Dataset(attrs=data.attrs)
        for name, values in data.data_vars.items():
            reshaped = values.values.reshape(*shape, *values.shape[1:])
            whole[name] = ((*grid, *values.dims[1:]), reshaped, values.attrs)
        if "time" in data:
            whole = whole.assign_coords(time=data["time"])
        for p in self.plan.parameters:
            whole = whole.assign_coords({p.name: (p.name, np.array(grid[p.name]), {"units": p.unit})})
        return whole

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`."""
        numbers: dict[str, Any] = {
            "store": str(self.path),
            "title": self.plan.name,
            "parameters": [p.name for p in self.plan.parameters],
            "points": self.n_base,
            "refined_points": len(self.done) - self.n_base,
            "points_done": int(self.done.sum()),
            "points_damaged": len(self.damaged),
            "damaged": self.said or None,
            "complete": self.complete,
            "repeats": self.plan.repeats,
            "engine": self.plan.engine,
            "seed": self.plan.seed,
            "fingerprint": self.attributes["fingerprint"],
        }
        if not self.done.any() or self.said:
            return numbers
        points = self.outcomes
        height = np.where(points.failed | ~np.isfinite(points.rate), -1.0, np.abs(points.rate))
        best = int(height.argmax())
        numbers["failed_points"] = int(points.failed.sum())
        numbers["partly_failed_points"] = int(points.partly_failed.sum())
        numbers["open_ledgers"] = int((~self.data["energy_closed"].values).sum())
        numbers["gaits"] = {g or "none": points.gait.count(g) for g in dict.fromkeys(points.gait)}
        if height[best] >= 0:
            numbers["fastest"] = {"spin_rate_rad_s": float(points.rate[best]), "at": self.points[best]}
        return numbers


def open_sweep(path: Path | str, *, damaged: bool = False) -> Campaign:
    """Open a store for reading, after checking every batch that claims to be whole.

    Parameters
    ----------
    path : path
        Of the store.
    damaged : bool
        Open it even when some of it is damaged; those points are left out.

    Raises
    ------
    InputError
        When there is no store, or it is damaged.
    """
    check_kind(path, (str, Path), "store", '"sweep.zarr"')
    path = Path(path)
    check_path(path)
    if not os.path.isdir(path):  # as `is_dir`, but for names too long
        raise InputError("store", str(path), "a store", f"plategait sweep {path.stem}.toml")
    store = Store(path)
    plan = store.plan
    done, lost = store.state()
    lines = [store.describe(lost, base_points(plan))] if lost else []
    said = "; ".join(lines + [f"damage in {what}" for what in store.damaged_metadata()])
    if said and not damaged:
        raise InputError("store", f"{path} with {said}", "whole", "plategait sweep … --repair, to run these again")
    points = tuple(i for batch in lost for i in store.batches()[batch])
    return Campaign(path, plan, done, points, said, dict(store.attributes))
