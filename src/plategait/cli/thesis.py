"""The command that regenerates the dissertation's figures and tables."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from plategait.cli import options, report
from plategait.cli.command import refuse

Names = Annotated[
    list[str] | None, typer.Argument(metavar="[NAME]…", help="Figures and tables: fig5.7 table5.9. All by default.")
]
Folder = Annotated[
    Path, typer.Option("--out", metavar="FOLDER", help="Folder for report.html, figures and CSV; made if missing.")
]


def thesis(
    context: typer.Context,
    names: Names = None,
    out: Folder = Path("thesis"),
    seed: options.Seed = 0,
    repeats: options.Repeats = 4,
    as_json: options.Json = False,
) -> None:
    """Regenerate the dissertation's simulated figures and tables, each beside its published value."""
    from plategait.thesis import reproduce
    from plategait.thesis.page import prepare_folder
    from plategait.thesis.report import write_report
    from plategait.thesis.study import item_name, simulates

    items = [item_name(name) for name in names or ()]
    options.refuse_idle_seed(context, repeats)
    if items and not simulates(items):
        refuse(context, ["repeats", "seed"], f"for {' and '.join(items)}, made without a run", "fig4.7")
    prepare_folder(out)
    with report.progress_bar("simulating") as progress:
        study = reproduce(items or None, seed=seed, repeats=repeats, progress=progress)
    with report.progress_bar("drawing") as progress:
        page = write_report(study, out, progress)
    if as_json:
        return report.print_json(study.summary() | {"report": str(page)})
    for item in study.items:
        print(f"{item.name:10} {item.verdict}")
    print(f"{page}: {len(study.items)} items, {study.simulated:.0f} simulated seconds in {study.wall:.0f} s")
