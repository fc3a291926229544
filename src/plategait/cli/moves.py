"""`plategait moves`: the atlas of what an object does on a machine."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from plategait.cli import options, report
from plategait.cli.command import refuse
from plategait.cli.groups import grouped
from plategait.cli.material_options import MaterialOptions
from plategait.cli.needs import MachineName
from plategait.files.output import PICTURES, check_outputs, write_whole
from plategait.units import Quantity

if TYPE_CHECKING:
    from plategait.moves.atlas import Atlas

_DURATION = Quantity("s", "s", "3 s", above=0)
_REACH = Quantity("m", "mm", "20 mm", at_least=0, at_most=10)


@dataclass(frozen=True)
class AtlasOptions:
    """How the atlas is made, as typed."""

    free: Annotated[
        list[str] | None,
        typer.Option("--free", help="What may vary beside frequency and amplitudes, as for optimize; repeatable. "
                     "All that the machine can if left out."),
    ] = None  # fmt: skip
    cell_along: Annotated[str, typer.Option("--cell-along", help="Size of a cell along the bar.")] = "50 mm/s"
    cell_across: Annotated[str, typer.Option("--cell-across", help="Size of a cell across it.")] = "20 mm/s"
    cell_turn: Annotated[str, typer.Option("--cell-turn", help="Size of a cell in turning.")] = "100 deg/s"
    duration: Annotated[str, typer.Option("--duration", help="Time of each run, a fifth of it unmeasured.")] = "3 s"
    reach: Annotated[
        str, typer.Option("--reach", help="How far from the plate's middle runs start, each way; at any angle.")
    ] = "20 mm"
    generations: Annotated[int, typer.Option("--generations", help="Of 256 motions each.", min=1)] = 24
    seed: Annotated[int, typer.Option("--seed", help="Of what is tried and of the starts.")] = 0
    engine: options.Engine = "cpu"

    def read(self) -> dict[str, Any]:
        """Options of `plategait.moves.atlas.atlas`, SI."""
        from plategait.optimize.goal import RATE, VELOCITY

        cell = (VELOCITY.read(self.cell_along, "cell_along"), VELOCITY.read(self.cell_across, "cell_across"),
                RATE.read(self.cell_turn, "cell_turn"))  # fmt: skip
        free = None if self.free is None else [name.strip() for typed in self.free for name in typed.split(",")]
        return {"free": free, "cell": cell, "duration": _DURATION.read(self.duration, "duration"),
                "reach": _REACH.read(self.reach, "reach"), "generations": self.generations, "seed": self.seed,
                "engine": self.engine}  # fmt: skip


@grouped
def moves(
    context: typer.Context,
    scenario: options.ScenarioName = "cheese",
    machine: MachineName = "source-robot",
    *,
    made: MaterialOptions,
    sought: AtlasOptions,
    store: Annotated[
        Path | None, typer.Option("--store", help="Folder that keeps what was run: killed, it goes on from there.")
    ] = None,
    dask: options.Dask = None,
    out: Annotated[Path | None, typer.Option("--out", help="Write the atlas: .json.")] = None,
    plot: options.Plot = None,
    beside: Annotated[
        list[Path] | None,
        typer.Option("--beside", help="Another atlas's .json whose reach is drawn beside this one's; repeatable."),
    ] = None,
    as_json: options.Json = False,
) -> None:
    """Find what an object does on a machine: for each velocity along, across and turning a motion of the plate.

    Exit status 1 where a direction has no primitive that every one of a hundred fresh runs follows.
    """
    check_outputs((out, (".json",), "--out"), (plot, PICTURES, "--plot"))
    if plot is None:
        refuse(context, ["beside"], "where nothing is drawn", "--plot moves.png")
    from plategait.moves.atlas import atlas
    from plategait.moves.report import reached_in, summary

    laid_over = options.build(scenario, made=made)
    others = [reached_in(path, "--beside") for path in beside or []]
    with report.going_on_in(store), report.progress_bar("searching") as progress:
        found = atlas(laid_over, machine, **sought.read(), store=store, dask=dask, progress=progress)
    numbers = summary(found)
    if out:
        write_whole(json.dumps(numbers, indent=1, ensure_ascii=False).encode(), out, (".json",), "--out")
    if plot:
        from plategait.moves.figures import plot_atlas
        from plategait.plots.style import save

        save(plot_atlas(found, others), plot)
    report.print_json(numbers) if as_json else _print(found, numbers)
    raise typer.Exit(0 if found.complete else 1)


def _print(found: Atlas, numbers: dict[str, Any]) -> None:
    reached = numbers["reached"]
    report.print_table(f"{numbers['scenario']} on {numbers['machine']}", ["", ""], [
        ["velocities with a motion", str(len(numbers["cells"]))],
        ["along the bar", _range(reached["along_mm_s"], "mm/s")],
        ["across it", _range(reached["across_mm_s"], "mm/s")],
        ["turning", _range(reached["turn_deg_s"], "deg/s")],
        ["runs", str(numbers["runs"])],
    ])  # fmt: skip
    rows = [
        [p["name"], *(f"{value:.0f}" for value in p["velocity_mm_s"]), f"{p['turn_deg_s']:.0f}",
         f"{p['settling_s']:.2f}", f"{p['motion']['frequency']:.1f}", f"{p['failed_runs']} of {p['runs']}",
         "yes" if p["verified"] else "NO"]
        for p in numbers["primitives"]
    ]  # fmt: skip
    columns = ["", "along mm/s", "across mm/s", "turn deg/s", "settles s", "Hz", "failed", "every run that way"]
    report.print_table("primitives, from a hundred fresh poses", columns, rows)
    if found.missing:
        print(f"NO PRIMITIVE: {', '.join(found.missing)}; more --generations, or another machine")


def _range(ends: list[float], unit: str) -> str:
    return f"{ends[0]:.0f} to {ends[1]:.0f} {unit}"
