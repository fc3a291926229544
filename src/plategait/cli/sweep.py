"""Commands for campaigns: run or resume one, say how far it is, draw it."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from plategait.cli import options, report
from plategait.cli.command import refuse, take_only
from plategait.files.output import PICTURES, check_writable

if TYPE_CHECKING:
    from plategait.campaign.opened import Campaign


def sweep(
    context: typer.Context,
    plan: Annotated[Path, typer.Argument(metavar="SWEEP.toml", help="What to run; with --status also a store.")],
    store: Annotated[
        Path | None, typer.Option("--store", help="Where the results go: .zarr. Beside the plan if left out.")
    ] = None,
    refine: Annotated[int, typer.Option("--refine", help="Points to add at peaks, gait changes, failures.", min=0)] = 0,
    repair: Annotated[bool, typer.Option("--repair", help="Run the points of damaged batches again.")] = False,
    dask: options.Dask = None,
    status: Annotated[bool, typer.Option("--status", help="Say how far it is; run nothing.")] = False,
    as_json: options.Json = False,
) -> None:
    """Run a campaign into a labelled store, or go on with one that was interrupted."""
    beside = plan.parent / f"{plan.stem}.zarr"  # `with_suffix` takes no "/"
    if status:
        if store is not None:
            refuse(context, ["store"], "with --status", f"plategait sweep {store} --status")
        take_only(context, ["plan", "status", "as_json"], "with --status", f"plategait sweep {plan}")
        return _status(beside, as_json)
    path = store or beside
    from plategait.campaign.run import sweep as run

    with report.going_on_in(path), report.progress_bar("sweeping") as progress:
        done = run(plan, path, refine=refine, repair=repair, dask=dask, progress=progress)
    report.print_json(done.summary()) if as_json else _print(done)


def plot_store(
    store: Annotated[Path, typer.Argument(metavar="STORE", help="A store that sweep wrote, finished or not.")],
    out: Annotated[
        Path | None, typer.Option("--out", help="Picture: .png, .pdf or .svg. Beside the store if left out.")
    ] = None,
    show: Annotated[
        str, typer.Option("--show", help="What to draw: spin_rate, drift, bending_amplitude, or another observable.")
    ] = "spin_rate",
    as_json: options.Json = False,
) -> None:
    """Draw a campaign: curves over one swept parameter, families of curves or a map over two."""
    from plategait.campaign.opened import open_sweep

    opened = open_sweep(store)
    picture = check_writable(out or store.with_suffix(".png"), PICTURES, "--out")
    from plategait.campaign.figures import plot_campaign
    from plategait.plots.style import save

    save(plot_campaign(opened, show), picture)
    report.print_json({"plot": str(picture)}) if as_json else print(picture)


def _status(path: Path, as_json: bool) -> None:
    from plategait.campaign.opened import open_sweep

    opened = open_sweep(path, damaged=True)
    report.print_json(opened.summary()) if as_json else _print(opened)
    raise typer.Exit(1 if opened.said else 0)


def _print(campaign: Campaign) -> None:
    s = campaign.summary()
    total = s["points"] + s["refined_points"]
    rows = [
        ["points run", f"{s['points_done']} of {total}"],
        ["refining points", str(s["refined_points"])],
        ["runs of each", str(s["repeats"])],
        ["damaged", s["damaged"] or "none"],
    ]
    if "gaits" in s:
        rows.append(["gaits", ", ".join(f"{gait} {count}" for gait, count in s["gaits"].items())])
        rows.append(["failed", f"{s['failed_points']} points"])
        rows.append(["failed in part", f"{s['partly_failed_points']} points"])
        rows.append(["energy does not balance", f"{s['open_ledgers']} runs"])
    if "fastest" in s:
        where = ", ".join(f"{p.name} {p.text_of(s['fastest']['at'][p.name])}" for p in campaign.plan.parameters)
        rows.append(["fastest spin", f"{math.degrees(s['fastest']['spin_rate_rad_s']):.1f} deg/s at {where}"])
    report.print_table(f"{s['title']}: {s['store']}", ["", ""], rows)
