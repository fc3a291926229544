"""The command that reads friction off recordings of a tilted plate."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from plategait.cli import report
from plategait.cli.groups import grouped
from plategait.cli.identify.shared import OutputOptions
from plategait.model.measured import as_text

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from plategait.identify.friction.result import FrictionResult


@grouped
def friction(
    tilts: Annotated[
        list[Path],
        typer.Argument(metavar="TILT.csv…", help="Columns time_s, angle_deg, position_mm; a file per trial."),
    ],
    *,
    output: OutputOptions,
) -> None:
    """Friction of an object on a plate that is slowly tilted: the angle at which it slips, and the slide after it."""
    output.check()
    from plategait.identify.friction.recording import read_tilt
    from plategait.identify.friction.result import identify_friction

    result = identify_friction([read_tilt(path) for path in tilts])
    determined = result.static is not None
    output.deliver(
        result,
        determined=determined,
        answered=determined,
        draw=_draw,
        show=_print,
    )


def _draw(result: FrictionResult) -> Figure:
    from plategait.identify.friction.figures import plot_tilt

    return plot_tilt(result)


def _print(result: FrictionResult) -> None:
    columns = ["", "slip angle (deg)", "mu_s", "mu_k"]
    rows = [
        [t.name, as_text(t.slip_angle, ".2f", math.degrees(1)), as_text(t.static, ".4f"), as_text(t.kinetic, ".4f")]
        for t in result.trials
    ]
    if len(rows) > 1:
        mean = [
            as_text(result.slip_angle, ".2f", math.degrees(1)),
            as_text(result.static, ".4f"),
            as_text(result.kinetic, ".4f"),
        ]
        rows.append(["mean of all", *mean])
    report.print_table("friction, with 95 % intervals", columns, rows)
    for trial in result.trials:
        for note in trial.notes:
            print(f"{trial.name}: {note}")
    for note in result.notes:
        print(note)
