"""`plategait curve` and `plategait fit`: spin rate over the plate's frequency, and its peak."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from plategait.cli import options, report
from plategait.files.output import PICTURES, check_outputs

if TYPE_CHECKING:
    from plategait.curve.curve import Curve


def curve(
    context: typer.Context,
    scenario: options.ScenarioName = "cheese",
    sheet: options.Sheet = None,
    natural_frequency: options.NaturalFrequency = None,
    frequency: Annotated[
        str, typer.Option("--frequency", help='Plate frequencies, first:last:step: "12:30:1Hz".')
    ] = "12:30:1Hz",
    angle: options.Angle = None,
    stroke: options.Stroke = None,
    mu_s: options.MuS = None,
    mu_k: options.MuK = None,
    friction_law: options.Law = None,
    duration: options.Duration = None,
    measured: options.With = None,
    repeats: options.Repeats = 1,
    seed: options.Seed = 0,
    dt: options.Dt = None,
    engine: options.Engine = "cpu",
    out: Annotated[Path | None, typer.Option("--out", help="Write the curve: .csv.")] = None,
    plot: options.Plot = None,
    as_json: options.Json = False,
) -> None:
    """Spin rate over a range of plate frequencies, with gaits, failures and the Lorentz fit."""
    from plategait.curve.curve_file import write_curve
    from plategait.curve.spin_curve import spin_curve
    from plategait.files.ranges import parse_frequencies

    check_outputs((out, (".csv",), "--out"), (plot, PICTURES, "--plot"))
    options.refuse_idle_seed(context, repeats)
    chosen = options.build(
        scenario, sheet=sheet, natural_frequency=natural_frequency, angle=angle, stroke=stroke, mu_s=mu_s, mu_k=mu_k,
        friction_law=friction_law, duration=duration, dt=dt, measured=measured,
    )  # fmt: skip
    with report.progress_bar("simulating") as progress:
        result = spin_curve(
            chosen, parse_frequencies(frequency), repeats=repeats, seed=seed, engine=engine, progress=progress
        )
    if out:
        write_curve(result, out)
    _plot_curve(result, plot)
    report.print_json(result.summary()) if as_json else report.print_curve(result)
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
        report.print_json(fit_summary(result.fit) | {"no_fit": result.no_fit or None})
    else:
        report.print_fit(result.fit, result.no_fit)
    raise typer.Exit(0 if result.fit else 1)


def _plot_curve(result: Curve, plot: Path | None) -> None:
    if plot:
        from plategait.plots.figures import plot_curve
        from plategait.plots.style import save

        save(plot_curve(result), plot)
