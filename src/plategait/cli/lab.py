"""`plategait lab`: one HTML file in which the engine itself runs, opened in a browser."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from plategait.cli import options, report
from plategait.cli.command import refuse, take_only
from plategait.cli.groups import grouped
from plategait.files.output import check_writable, write_whole

PAGES = (".html",)

What = Annotated[
    str,
    typer.Argument(
        metavar="[WHAT]",
        help="A preset, a scenario or an object (.toml), a run (.nc), a store (.zarr), poses or a steering.",
    ),
]


@grouped
def lab(
    context: typer.Context,
    what: What = "cheese",
    scenario: Annotated[
        str | None, typer.Option("--scenario", help="What an object, poses or a steering are of: a preset or .toml.")
    ] = None,
    frequency: Annotated[str | None, typer.Option("--frequency", help='Plate frequency: "24 Hz".')] = None,
    *,
    laid_over: options.ScenarioOptions,
    out: Annotated[Path, typer.Option("--out", help="File to write: .html.")] = Path("lab.html"),
    no_open: Annotated[bool, typer.Option("--no-open", help="Write the file and open no browser.")] = False,
    as_json: options.Json = False,
) -> None:
    """Write a page in which this sheet moves, alive, and open it: one file, without a network or a server."""
    check_writable(out, PAGES, "--out")
    from plategait.lab.opening import open_page
    from plategait.lab.page import page
    from plategait.lab.payload import named

    shown = named(what)
    if shown.own_scenario:
        where = f"for a {shown.kind}, which has a scenario of its own"
        take_only(context, ["what", "out", "no_open", "as_json"], where, f"plategait lab {what}")
    if shown.kind == "scenario":
        refuse(context, ["scenario"], "where WHAT is one itself", f"plategait lab {scenario}")
    base = what if shown.kind == "scenario" else scenario or "cheese"
    shaken = None if shown.own_scenario else laid_over.over(base, frequency)
    html = page(shown.payload(shaken)).encode()
    write_whole(html, out, PAGES, "--out")
    opened = not no_open and open_page(out)
    taken = [] if shaken is None else laid_over.taken(base, shaken, friction_told=laid_over.mu_s is not None)
    if as_json:
        told = {"out": str(out), "kind": shown.kind, "shown": what, "bytes": len(html), "opened": opened}
        return report.print_json(told | ({"taken": taken} if taken else {}))
    unopened = "" if opened or no_open else "; no browser to open it in"
    report.print_notes([f"{out}: {shown.kind} {Path(what).name}, {len(html) / 1e6:.2f} MB{unopened}", *taken])
