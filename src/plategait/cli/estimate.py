"""The command that reads material parameters off spin curves."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
import typer

from plategait.cli import estimate_report, options, report
from plategait.cli.command import refuse, take_only
from plategait.cli.groups import grouped
from plategait.curve.protocol import USUAL, Protocol, measured_as
from plategait.errors import InputError
from plategait.files.output import PICTURES, check_outputs
from plategait.model.outline import Disk
from plategait.model.scenario import Scenario
from plategait.units import ANGLE, ANGULAR_FREQUENCY, PLATE_ANGLE, Quantity

if TYPE_CHECKING:
    from plategait.curve.curve import Curve
    from plategait.estimate.planning import Plan
    from plategait.estimate.result import Estimate
    from plategait.model.motion import PlateMotion

Method = Literal["posterior", "linear", "quadratic"]
Coefficients = Literal["published", "refitted"]

_MASS = Quantity("kg", "g", "13.6 g", above=0, at_most=10)
_LENGTH = Quantity("m", "mm", "40 mm", above=0, at_most=10)
_TIME = Quantity("s", "s", "2 s", above=0)
_SHARE = Quantity("", "", "0.05", above=0)


@dataclass(frozen=True)
class SetupOptions:
    """The object as far as it is known, and the plate."""

    scenario: Annotated[
        str, typer.Option("--scenario", help="Preset or TOML file with the object's size, shape and mass.")
    ] = "cheese"
    measured: options.With = None
    angle: Annotated[
        list[str] | None, typer.Option("--angle", help='Angular amplitude A_p, one for all curves or each: "3 deg".')
    ] = None
    stroke: options.Stroke = None
    mass: Annotated[str | None, typer.Option("--mass", help='Mass of the object: "13.6 g".')] = None
    radius: Annotated[str | None, typer.Option("--radius", help='Radius of a disk: "40 mm".')] = None

    def build(self) -> Scenario:
        """Scenario of the object; the lattice grows with the radius."""
        base = options.build(self.scenario, stroke=self.stroke, measured=self.measured)
        changes: dict[str, Any] = {}
        if self.radius is not None:
            radius, outline = _LENGTH.read(self.radius, "--radius"), base.sheet.outline
            if not isinstance(outline, Disk):
                raise InputError(
                    "--radius", self.radius, "left out for an object that is no disk", f"--scenario {base.name}.toml"
                )
            changes["sheet.outline"] = Disk(radius=radius)
            changes["sheet.pitch"] = base.sheet.pitch * radius / outline.radius
        if self.mass is not None:
            changes["sheet.mass"] = _MASS.read(self.mass, "--mass")
        return base.replace(**changes) if changes else base

    def motions(self, base: Scenario, count: int) -> list[PlateMotion]:
        """Plate motion of each of so many curves."""
        angles = self.angle or []
        if len(angles) not in (0, 1, count):
            raise InputError(
                "--angle", f"{len(angles)} of them", f"given once, or once for each of {count} curves", '"3 deg"'
            )
        amplitudes = [PLATE_ANGLE.read(a, "--angle") for a in angles] or [base.motion.angle]
        amplitudes = amplitudes * count if len(amplitudes) == 1 else amplitudes
        return [base.motion.replace(angle=a) for a in amplitudes]


@dataclass(frozen=True)
class MeasurementOptions:
    """How the curves were measured, and what is estimated of them."""

    beta: Annotated[str | None, typer.Option("--beta", help="Kinetic over static friction, where it is known.")] = None
    free: Annotated[
        list[str] | None,
        typer.Option("--free", help="Estimate this too: mass, bending_damping, contact_damping; repeatable."),
    ] = None
    noise: Annotated[
        str | None, typer.Option("--noise", help="Relative noise of the rates: 0.05 or 5%. Estimated if left out.")
    ] = None
    duration: Annotated[str, typer.Option("--duration", help="How long each frequency was observed.")] = (
        f"{USUAL.duration:g} s"
    )
    slip_limit: Annotated[str, typer.Option("--slip-limit", help="Slip at which the object counts as run off.")] = (
        f"{1e3 * USUAL.slip_limit:g} mm"
    )
    confidence: Annotated[str, typer.Option("--confidence", help="Of the intervals: 0.9 or 90%.")] = "90%"

    @property
    def protocol(self) -> Protocol:
        """Protocol of the measurement."""
        return Protocol(
            _TIME.read(self.duration, "--duration"), slip_limit=_LENGTH.read(self.slip_limit, "--slip-limit")
        )

    def run(self, curves: list[Curve], base: Scenario, motions: list[PlateMotion], seed: int) -> Estimate:
        """Estimate with the engine in the loop."""
        from plategait.estimate.result import estimate_parameters

        with report.progress_bar("estimating") as progress:
            return estimate_parameters(
                curves,
                base,
                motions=motions,
                noise=None if self.noise is None else _share(self.noise, "--noise"),
                friction_ratio=None if self.beta is None else _SHARE.read(self.beta, "--beta"),
                free=tuple(self.free or ()),
                confidence=_share(self.confidence, "--confidence"),
                seed=seed,
                progress=progress,
            )


@dataclass(frozen=True)
class PlanOptions:
    """What to measure next."""

    plan: Annotated[bool, typer.Option("--next", help="Say also what to measure next.")] = False
    candidate: Annotated[
        list[str] | None,
        typer.Option("--candidate-angle", help="Amplitude that the plate can make, for --next; repeatable."),
    ] = None
    want_frequency: Annotated[
        str | None, typer.Option("--want-frequency", help='Precision wanted of ω_n, for --next: "0.5 pi rad/s".')
    ] = None
    want_angle: Annotated[
        str | None, typer.Option("--want-angle", help='Precision wanted of the friction angle, for --next: "1 deg".')
    ] = None

    @property
    def asked(self) -> bool:
        """Whether a plan is asked for."""
        return bool(self.plan or self.want_frequency or self.want_angle)

    @property
    def angles(self) -> list[float]:
        """Amplitudes of the candidates, rad."""
        return [PLATE_ANGLE.read(c, "--candidate-angle") for c in self.candidate or []]

    @property
    def wanted(self) -> dict[str, float]:
        """Precision wanted by parameter, SI."""
        wanted = {}
        if self.want_frequency is not None:
            wanted["natural_frequency"] = ANGULAR_FREQUENCY.read(self.want_frequency, "--want-frequency")
        if self.want_angle is not None:
            wanted["friction_angle"] = ANGLE.read(self.want_angle, "--want-angle")
        return wanted

    def run(self, estimate: Estimate, angles: list[float], wanted: dict[str, float], seed: int) -> Plan:
        """Plan the next measurement."""
        from plategait.estimate.planning import next_measurement

        with report.progress_bar("planning") as progress:
            return next_measurement(estimate.posterior, angles=angles, wanted=wanted, seed=seed, progress=progress)


@dataclass(frozen=True)
class OutputOptions:
    """What is written and printed."""

    out: Annotated[Path | None, typer.Option("--out", help="Write a scenario fragment for --with: .toml.")] = None
    plot: options.Plot = None
    as_json: options.Json = False


@grouped
def estimate(
    context: typer.Context,
    curve_files: Annotated[
        list[Path],
        typer.Argument(metavar="CURVE.csv...", help="Columns frequency_hz, spin_rate_deg_s, …; one or more."),
    ],
    *,
    setup: SetupOptions,
    method: Annotated[
        Method, typer.Option("--method", help="posterior, linear (5.6, 5.7) or quadratic.")
    ] = "posterior",
    coefficients: Annotated[
        Coefficients | None,
        typer.Option("--coefficients", help="Of linear: published, or refitted to our simulations as quadratic's are."),
    ] = None,
    measurement: MeasurementOptions,
    planning: PlanOptions,
    seed: options.Seed = 0,
    output: OutputOptions,
) -> None:
    """Read stiffness and friction off measured spin curves, with intervals."""
    from plategait.curve.curve_file import read_curve

    check_outputs((output.out, (".toml",), "--out"), (output.plot, PICTURES, "--plot"))
    _refuse_idle(context, method, planning, output)
    base = setup.build()
    curves = [read_curve(path) for path in curve_files]
    _refuse_redundant(context, curves)
    motions = setup.motions(base, len(curves))
    if method == "posterior":
        _posterior(curves, measured_as(base, measurement.protocol), motions, measurement, planning, output, seed)
    else:
        _linear(curves, base.replace(motion=motions[0]), method, coefficients, output)


def _refuse_idle(context: typer.Context, method: Method, planning: PlanOptions, output: OutputOptions) -> None:
    """Refuse options that the method has no use for."""
    if method == "posterior":
        refuse(context, ["coefficients"], "with --method posterior", "--method linear")
        if not planning.asked:
            refuse(context, ["candidate"], "without --next", "--next")
        return
    if not output.out:
        # Only the stiffness that is written is that of an object of a certain mass.
        refuse(context, ["measured", "mass"], f"with --method {method} and no --out", "--out object.toml")
    used = (
        "curve_files", "scenario", "measured", "mass", "angle", "stroke", "radius", "method", "coefficients", "out",
        "as_json",
    )  # fmt: skip
    take_only(context, used, f"with --method {method}", "--method posterior")


def _refuse_redundant(context: typer.Context, curves: list[Curve]) -> None:
    """Refuse what the curves tell themselves, point by point."""
    if all(c.angle_deg is not None and np.isfinite(c.angle_deg).all() for c in curves):
        refuse(context, ["angle"], "with curves that have a column angle_deg", "the file without that column")
    rated = [np.isfinite(c.spin_rate_deg_s) for c in curves]
    if all((c.spin_rate_sd_deg_s[r] > 0).all() for c, r in zip(curves, rated, strict=True)):
        refuse(context, ["noise"], "with curves that have a column spin_rate_sd_deg_s", "the file without that column")


def _share(text: str, option: str) -> float:
    """A share as a number, or in percent."""
    if text.strip().endswith("%"):
        return _SHARE.read(text.strip()[:-1].strip(), option) / 100
    return _SHARE.read(text, option)


def _linear(
    curves: list[Curve],
    base: Scenario,
    method: Literal["linear", "quadratic"],
    coefficients: Coefficients | None,
    output: OutputOptions,
) -> None:
    """The source's method on one curve."""
    from plategait.curve.spin_curve import fit_curve
    from plategait.estimate.linear import estimate_linear
    from plategait.model.fragment import write_fragment

    if len(curves) != 1:
        raise InputError("CURVE.csv", f"{len(curves)} curves", f"one curve for --method {method}", "--method posterior")
    base = _at_amplitude_of(curves[0], base, method)
    fit = fit_curve(curves[0])
    if fit.fit is None:
        raise InputError("CURVE.csv", f"a curve without a Lorentz fit ({fit.no_fit})",
                         f"one with a peak for --method {method}", "--method posterior")  # fmt: skip
    result = estimate_linear(fit.fit, base, method=method, coefficients=coefficients)
    if output.out and not result.refused:
        write_fragment(result.to_fragment(base), output.out)
    report.print_json(result.summary()) if output.as_json else estimate_report.print_linear(result)
    raise typer.Exit(1 if result.refused else 0)


def _at_amplitude_of(curve: Curve, base: Scenario, method: str) -> Scenario:
    """Scenario at the amplitude in the curve's own column, if it has one."""
    angles = [] if curve.angle_deg is None else np.unique(curve.angle_deg[np.isfinite(curve.angle_deg)]).tolist()
    if len(angles) > 1:
        raise InputError("CURVE.csv", f"points at {' and '.join(f'{a:g}' for a in angles[:4])} deg",
                         f"of one amplitude for --method {method}", "--method posterior")  # fmt: skip
    return base.replace(**{"motion.angle": math.radians(angles[0])}) if angles else base


def _posterior(
    curves: list[Curve],
    base: Scenario,
    motions: list[PlateMotion],
    measurement: MeasurementOptions,
    planning: PlanOptions,
    output: OutputOptions,
    seed: int,
) -> None:
    """The engine in the loop."""
    from plategait.model.fragment import write_fragment

    wanted, angles = planning.wanted, planning.angles
    result = measurement.run(curves, base, motions, seed)
    plan = planning.run(result, angles, wanted, seed) if planning.asked else None
    if output.plot:
        _plot(result, output.plot, seed)
    if output.out and any(m.determined for m in result.marginals):
        write_fragment(result.to_fragment(), output.out)
    if output.as_json:
        report.print_json(result.summary() | ({"next": plan.summary()} if plan else {}))
    else:
        estimate_report.print_estimate(result, plan)
    raise typer.Exit(0 if result.answered else 1)


def _plot(result: Estimate, path: Path, seed: int) -> None:
    from plategait.estimate.figures import plot_estimate
    from plategait.estimate.prediction import predict
    from plategait.plots.style import save

    with report.progress_bar("predicting") as progress:
        predictions = predict(result.posterior, seed=seed, progress=progress)
    save(plot_estimate(result, predictions), path)
