"""`plategait curve` and `plategait fit`: spin rate over the plate's frequency, and its peak."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from plategait.cli import options, report
from plategait.cli.groups import grouped
from plategait.curve.curve_file import write_curve
from plategait.curve.doubts import doubts
from plategait.curve.spin_curve import spin_curve
from plategait.files.output import PICTURES, check_outputs
from plategait.files.ranges import parse_frequencies

if TYPE_CHECKING:
    from plategait.curve.curve import Curve


@grouped
def curve(
    context: typer.Context,
    scenario: options.ScenarioName = "cheese",
    frequency: Annotated[
        str, typer.Option("--frequency", help='Plate frequencies, first:last:step: "12:30:1Hz".')
    ] = "12:30:1Hz",
    *,
    laid_over: options.ScenarioOptions,
    ensemble: options.EnsembleOptions,
    out: Annotated[Path | None, typer.Option("--out", help="Write the curve: .csv.")] = None,
    plot: options.Plot = None,
    as_json: options.Json = False,
) -> None:
    """Spin rate over a range of plate frequencies, with gaits, failures and the Lorentz fit."""
    check_outputs((out, (".csv",), "--out"), (plot, PICTURES, "--plot"))
    options.refuse_idle_seed(context, ensemble.repeats)
    nominal = laid_over.over(scenario)
    with report.progress_bar("simulating") as progress:
        result = spin_curve(nominal, parse_frequencies(frequency), **asdict(ensemble), progress=progress)
    if out:
        write_curve(result, out)
    _plot_curve(result, plot)
    taken = laid_over.taken(scenario, nominal, friction_told=laid_over.mu_s is not None)
    if as_json:
        report.print_json(result.summary() | {"doubts": list(doubts(result))} | ({"taken": taken} if taken else {}))
    else:
        report.print_curve(result)
        report.print_notes(taken)
    raise typer.Exit(0 if result.fit else 1)


def fit(
    curve_file: Annotated[Path, typer.Argument(metavar="CURVE.csv", help="Columns frequency_hz, spin_rate_deg_s, …")],
    plot: options.Plot = None,
    as_json: options.Json = False,
) -> None:
    """Fit the Lorentz function (5.5) to a spin curve; failed points are left out."""
    from plategait.curve.curve import fit_summary
    from plategait.curve.curve_file import read_curve
    from plategait.curve.spin_curve import fit_curve

    check_outputs((plot, PICTURES, "--plot"))
    result = fit_curve(read_curve(curve_file))
    _plot_curve(result, plot)
    if as_json:
        report.print_json(
            fit_summary(result.fit)
            | {"no_fit": result.no_fit or None, "doubts": list(doubts(result)), "notes": list(result.notes)}
        )
    else:
        report.print_notes(result.notes)
        report.print_fit(result)
    raise typer.Exit(0 if result.fit else 1)


def _plot_curve(result: Curve, plot: Path | None) -> None:
    if plot:
        from plategait.plots.figures import plot_curve
        from plategait.plots.style import save

        save(plot_curve(result), plot)
