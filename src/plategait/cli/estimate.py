"""The command that reads material parameters off spin curves."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import numpy as np
import typer

from plategait.cli import estimate_report, options, report
from plategait.cli.command import refuse, take_only
from plategait.cli.estimate_options import (
    Coefficients,
    CoefficientsName,
    MeasurementOptions,
    Method,
    MethodName,
    OutputOptions,
    PlanOptions,
    SetupOptions,
)
from plategait.cli.estimate_untold import treated_as, warnings_of
from plategait.cli.groups import grouped
from plategait.curve.protocol import measured_as
from plategait.files.output import PICTURES, check_outputs
from plategait.model.scenario import Scenario

if TYPE_CHECKING:
    from plategait.curve.curve import Curve
    from plategait.estimate.direct import Direct
    from plategait.estimate.result import Estimate
    from plategait.model.motion import PlateMotion


@dataclass(frozen=True)
class Said:
    """What is said before the answer: of what nobody told, and of how the object is taken."""

    warnings: list[str]
    notes: list[str]

    @property
    def lines(self) -> list[str]:
        """All of it, the warnings first."""
        return [*self.warnings, *self.notes]


CANDIDATES = [
    "candidate_angle", "candidate_stroke", "candidate_height", "candidate_phase", "candidate_frequency", "machine",
]  # fmt: skip


@grouped
def estimate(
    context: typer.Context,
    curve_files: Annotated[
        list[Path],
        typer.Argument(metavar="CURVE.csv...", help="Columns frequency_hz, spin_rate_deg_s, …; one or more."),
    ],
    *,
    setup: SetupOptions,
    method: MethodName = "posterior",
    coefficients: CoefficientsName = None,
    measurement: MeasurementOptions,
    planning: PlanOptions,
    seed: options.Seed = 0,
    output: OutputOptions,
) -> None:
    """Read stiffness and friction off measured spin curves, with intervals."""
    from plategait.curve.curve_file import read_curve
    from plategait.estimate.size import sized_by_film

    check_outputs((output.out, (".toml",), "--out"), (output.plot, PICTURES, "--plot"))
    _refuse_idle(context, method, planning, output)
    base = setup.build()
    curves = [read_curve(path) for path in curve_files]
    refuse_redundant(context, curves)
    mass_counts = method == "posterior" or output.out is not None
    said = Said(warnings_of(context, setup, [curves], mass_counts=mass_counts), treated_as(setup, base, method))
    base, curves = sized_by_film(base, curves, told=setup.size_told)
    motions = setup.motions(base, len(curves))
    if method == "posterior":
        base = measured_as(base, measurement.protocol)
        _posterior(curves, base, motions, setup, measurement, planning, output, seed, said)
    else:
        beta = measurement.friction_ratio
        base = base.replace(friction=base.friction.with_ratio(beta)) if beta is not None else base
        _directly(curves, base.replace(motion=motions[0]), method, coefficients, output, said)


def _refuse_idle(context: typer.Context, method: Method, planning: PlanOptions, output: OutputOptions) -> None:
    """Refuse options that the method has no use for."""
    if method == "posterior":
        refuse(context, ["coefficients"], "with --method posterior", "--method linear")
        if not planning.asked:
            refuse(context, CANDIDATES, "without --next", "--next")
        return
    if not output.out:
        # Only the stiffness that is written is that of an object of a certain mass.
        refuse(context, idle_without_file(method), f"with --method {method} and no --out", "--out object.toml")
    used = (
        "curve_files", "scenario", "measured", "mass", "angle", "stroke", "radius", "method", "out", "as_json",
        *(("beta", "outline", "pitch") if method == "any-size" else ("coefficients",)),
    )  # fmt: skip
    take_only(context, used, f"with --method {method}", "--method posterior")


def idle_without_file(method: Method) -> list[str]:
    """Options that only what is written follows from, by a method other than the posterior."""
    # A file for --with may tell β, which the any-size method takes.
    return ["mass"] if method == "any-size" else ["measured", "mass"]


def refuse_redundant(context: typer.Context, curves: list[Curve]) -> None:
    """Refuse what the curves tell themselves, point by point."""
    if all(c.angle_deg is not None and np.isfinite(c.angle_deg).all() for c in curves):
        refuse(context, ["angle"], "with curves that have a column angle_deg", "the file without that column")
    for name, unit, columns in (
        ("stroke", "mm", [c.stroke for c in curves]),
        ("height", "mm", [c.height for c in curves]),
        ("duration", "s", [c.duration for c in curves]),
        ("slip_limit", "mm", [c.slip_limit for c in curves]),
    ):
        if all(x is not None and np.isfinite(x).all() for x in columns):
            refuse(context, [name], f"with curves that have a column {name}_{unit}", "the file without that column")
    rated = [np.isfinite(c.spin_rate_deg_s) for c in curves]
    if all((c.spin_rate_sd_deg_s[r] > 0).all() for c, r in zip(curves, rated, strict=True)):
        refuse(context, ["noise"], "with curves that have a column spin_rate_sd_deg_s", "the file without that column")


def _directly(
    curves: list[Curve],
    base: Scenario,
    method: Direct,
    coefficients: Coefficients | None,
    output: OutputOptions,
    said: Said,
) -> None:
    """One curve without the engine: the source's method, or the regression for any size."""
    from plategait.estimate.direct import estimate_directly
    from plategait.model.fragment import write_fragment

    result, fit = estimate_directly(curves, base, method, coefficients)
    if output.out and not result.refused:
        write_fragment(result.to_fragment(base), output.out)
    if output.as_json:
        report.print_json(result.summary() | {"warnings": said.warnings, "notes": [*said.notes, *fit.notes]})
    else:
        report.print_notes(said.lines)
        report.print_notes(fit.notes)
        estimate_report.print_linear(result)
    raise typer.Exit(1 if result.refused else 0)


def _posterior(
    curves: list[Curve],
    base: Scenario,
    motions: list[PlateMotion],
    setup: SetupOptions,
    measurement: MeasurementOptions,
    planning: PlanOptions,
    output: OutputOptions,
    seed: int,
    said: Said,
) -> None:
    """The engine in the loop."""
    from plategait.estimate.observations import Condition
    from plategait.model.fragment import write_fragment

    wanted = planning.wanted
    planning.reach([Condition(base.motion.angle, base.motion.stroke, 1.0)], base.motion)  # refused before the work
    result = measurement.run(curves, base, motions, setup, seed)
    # What to measure next follows from the posterior, which is worth nothing where no parameters explain the data.
    plan = None
    if planning.asked and result.goodness.explained:
        reach = planning.reach(result.posterior.data.conditions, result.posterior.unknowns.base.motion)
        plan = planning.run(result, reach, wanted, seed)
    if output.plot:
        _plot(result, output.plot, seed)
    written = output.out if any(m.determined for m in result.marginals) else None
    if written:
        write_fragment(result.to_fragment(), written)
    if output.as_json:
        told = {"warnings": said.warnings, "notes": [*said.notes, *result.summary()["notes"]]}
        told |= {"next": plan.summary() if plan else None} if planning.asked else {}
        report.print_json(result.summary() | told)
    else:
        report.print_notes(said.lines)
        estimate_report.print_estimate(result, plan)
        if not result.goodness.explained:
            estimate_report.print_unexplained(written, planned=planning.asked)
    raise typer.Exit(0 if result.answered else 1)


def _plot(result: Estimate, path: Path, seed: int) -> None:
    from plategait.estimate.figures import plot_estimate
    from plategait.estimate.prediction import predict
    from plategait.plots.style import save

    with report.progress_bar("predicting") as progress:
        predictions = predict(result.posterior, seed=seed, progress=progress)
    save(plot_estimate(result, predictions), path)
