"""The command that reads friction off recordings of a tilted plate."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from plategait.cli import options, report
from plategait.cli.identify import shared as identified
from plategait.model.measured import words

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from plategait.identify.friction.result import FrictionResult


def friction(
    tilts: Annotated[
        list[Path],
        typer.Argument(metavar="TILT.csv…", help="Columns time_s, angle_deg, position_mm; a file per trial."),
    ],
    out: identified.Out = None,
    plot: options.Plot = None,
    as_json: options.Json = False,
) -> None:
    """Friction of an object on a plate that is slowly tilted: the angle at which it slips, and the slide after it."""
    identified.check_files(out, plot)
    from plategait.identify.friction.recording import read_tilt
    from plategait.identify.friction.result import identify_friction

    result = identify_friction([read_tilt(path) for path in tilts])

    def draw() -> Figure:
        from plategait.identify.friction.figures import plot_tilt

        return plot_tilt(result)

    identified.deliver(
        result, result.static is not None, out=out, plot=plot, as_json=as_json, draw=draw, show=lambda: _print(result)
    )


def _print(result: FrictionResult) -> None:
    columns = ["", "slip angle (deg)", "mu_s", "mu_k"]
    rows = [
        [t.name, words(t.slip_angle, ".2f", math.degrees(1)), words(t.static, ".4f"), words(t.kinetic, ".4f")]
        for t in result.trials
    ]
    if len(rows) > 1:
        mean = [
            words(result.slip_angle, ".2f", math.degrees(1)),
            words(result.static, ".4f"),
            words(result.kinetic, ".4f"),
        ]
        rows.append(["mean of all", *mean])
    report.print_table("friction, with 95 % intervals", columns, rows)
    for trial in result.trials:
        for note in trial.notes:
            print(f"{trial.name}: {note}")
    for note in result.notes:
        print(note)
