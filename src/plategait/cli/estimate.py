"""The command that reads material parameters off spin curves."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
import typer

from plategait.cli import options, report
from plategait.cli.command import refuse, take_only
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


def estimate(
    context: typer.Context,
    curve_files: Annotated[
        list[Path],
        typer.Argument(metavar="CURVE.csv...", help="Columns frequency_hz, spin_rate_deg_s, …; one or more."),
    ],
    scenario: Annotated[
        str, typer.Option("--scenario", help="Preset or TOML file with the object's size, shape and mass.")
    ] = "cheese",
    measured: options.With = None,
    angle: Annotated[
        list[str] | None, typer.Option("--angle", help='Angular amplitude A_p, one for all curves or each: "3 deg".')
    ] = None,
    stroke: options.Stroke = None,
    mass: Annotated[str | None, typer.Option("--mass", help='Mass of the object: "13.6 g".')] = None,
    radius: Annotated[str | None, typer.Option("--radius", help='Radius of a disk: "40 mm".')] = None,
    method: Annotated[
        Method, typer.Option("--method", help="posterior, linear (5.6, 5.7) or quadratic.")
    ] = "posterior",
    coefficients: Annotated[
        Coefficients | None,
        typer.Option("--coefficients", help="Of linear: published, or refitted to our simulations as quadratic's are."),
    ] = None,
    beta: Annotated[str | None, typer.Option("--beta", help="Kinetic over static friction, where it is known.")] = None,
    free: Annotated[
        list[str] | None,
        typer.Option("--free", help="Estimate this too: mass, bending_damping, contact_damping; repeatable."),
    ] = None,
    noise: Annotated[
        str | None, typer.Option("--noise", help="Relative noise of the rates: 0.05 or 5%. Estimated if left out.")
    ] = None,
    duration: Annotated[
        str, typer.Option("--duration", help="How long each frequency was observed.")
    ] = f"{USUAL.duration:g} s",
    slip_limit: Annotated[
        str, typer.Option("--slip-limit", help="Slip at which the object counts as run off.")
    ] = f"{1e3 * USUAL.slip_limit:g} mm",
    confidence: Annotated[str, typer.Option("--confidence", help="Of the intervals: 0.9 or 90%.")] = "90%",
    plan: Annotated[bool, typer.Option("--next", help="Say also what to measure next.")] = False,
    candidate: Annotated[
        list[str] | None,
        typer.Option("--candidate-angle", help="Amplitude that the plate can make, for --next; repeatable."),
    ] = None,
    want_frequency: Annotated[
        str | None, typer.Option("--want-frequency", help='Precision wanted of ω_n, for --next: "0.5 pi rad/s".')
    ] = None,
    want_angle: Annotated[
        str | None, typer.Option("--want-angle", help='Precision wanted of the friction angle, for --next: "1 deg".')
    ] = None,
    seed: options.Seed = 0,
    out: Annotated[Path | None, typer.Option("--out", help="Write a scenario fragment for --with: .toml.")] = None,
    plot: options.Plot = None,
    as_json: options.Json = False,
) -> None:
    """Read stiffness and friction off measured spin curves, with intervals."""
    from plategait.curve.curve_file import read_curve

    check_outputs((out, (".toml",), "--out"), (plot, PICTURES, "--plot"))
    _refuse_idle(context, method)
    base = _object(options.build(scenario, stroke=stroke, measured=measured), mass, radius)
    curves = [read_curve(path) for path in curve_files]
    _refuse_told(context, curves)
    motions = _motions(base, angle or [], len(curves))
    if method != "posterior":
        return _linear(curves, base.replace(motion=motions[0]), method, coefficients, out, as_json)
    base = measured_as(
        base,
        Protocol(_TIME.read(duration, "--duration"), slip_limit=_LENGTH.read(slip_limit, "--slip-limit")),
    )
    _posterior(
        curves, base, motions, out, plot, as_json, seed=seed,
        given={
            "noise": None if noise is None else _share(noise, "--noise"),
            "friction_ratio": None if beta is None else _SHARE.read(beta, "--beta"),
            "free": tuple(free or ()), "confidence": _share(confidence, "--confidence"),
        },
        asked=_wanted(want_frequency, want_angle) if plan or want_frequency or want_angle else None,
        angles=[PLATE_ANGLE.read(c, "--candidate-angle") for c in candidate or []],
    )  # fmt: skip


def _refuse_idle(context: typer.Context, method: str) -> None:
    """Refuse options that the method has no use for."""
    given = context.params
    if method == "posterior":
        refuse(context, ["coefficients"], "with --method posterior", "--method linear")
        if not (given["plan"] or given["want_frequency"] or given["want_angle"]):
            refuse(context, ["candidate"], "without --next", "--next")
        return
    if not given["out"]:
        # Only the stiffness that is written is that of an object of a certain mass.
        refuse(context, ["measured", "mass"], f"with --method {method} and no --out", "--out object.toml")
    used = (
        "curve_files", "scenario", "measured", "mass", "angle", "stroke", "radius", "method", "coefficients", "out",
        "as_json",
    )  # fmt: skip
    take_only(context, used, f"with --method {method}", "--method posterior")


def _refuse_told(context: typer.Context, curves: list[Curve]) -> None:
    """Refuse what the curves tell themselves, point by point."""
    if all(c.angle_deg is not None and np.isfinite(c.angle_deg).all() for c in curves):
        refuse(context, ["angle"], "with curves that have a column angle_deg", "the file without that column")
    rated = [np.isfinite(c.spin_rate_deg_s) for c in curves]
    if all((c.spin_rate_sd_deg_s[r] > 0).all() for c, r in zip(curves, rated, strict=True)):
        refuse(context, ["noise"], "with curves that have a column spin_rate_sd_deg_s", "the file without that column")


def _object(base: Scenario, mass: str | None, radius: str | None) -> Scenario:
    """Scenario of an object of another mass and radius; the lattice grows with it."""
    changes: dict[str, Any] = {}
    if radius is not None:
        wanted, old = _LENGTH.read(radius, "--radius"), base.sheet.outline
        if not isinstance(old, Disk):
            raise InputError(
                "--radius", radius, "left out for an object that is no disk", f"--scenario {base.name}.toml"
            )
        changes["sheet.outline"] = Disk(radius=wanted)
        changes["sheet.pitch"] = base.sheet.pitch * wanted / old.radius
    if mass is not None:
        changes["sheet.mass"] = _MASS.read(mass, "--mass")
    return base.replace(**changes) if changes else base


def _motions(base: Scenario, angles: list[str], count: int) -> list[PlateMotion]:
    if len(angles) not in (0, 1, count):
        raise InputError(
            "--angle", f"{len(angles)} of them", f"given once, or once for each of {count} curves", '"3 deg"'
        )
    read = [PLATE_ANGLE.read(a, "--angle") for a in angles] or [base.motion.angle]
    read = read * count if len(read) == 1 else read
    return [base.motion.replace(angle=a) for a in read]


def _share(text: str, option: str) -> float:
    """A share as a number, or in percent."""
    if text.strip().endswith("%"):
        return _SHARE.read(text.strip()[:-1].strip(), option) / 100
    return _SHARE.read(text, option)


def _wanted(frequency: str | None, angle: str | None) -> dict[str, float]:
    wanted = {}
    if frequency is not None:
        wanted["natural_frequency"] = ANGULAR_FREQUENCY.read(frequency, "--want-frequency")
    if angle is not None:
        wanted["friction_angle"] = ANGLE.read(angle, "--want-angle")
    return wanted


def _linear(
    curves: list[Curve],
    base: Scenario,
    method: Literal["linear", "quadratic"],
    coefficients: Coefficients | None,
    out: Path | None,
    as_json: bool,
) -> None:
    """The source's method on one curve."""
    from plategait.curve.spin_curve import fit_curve
    from plategait.estimate.linear import estimate_linear
    from plategait.model.fragment import write_fragment

    if len(curves) != 1:
        raise InputError("CURVE.csv", f"{len(curves)} curves", f"one curve for --method {method}", "--method posterior")
    base = _told_by(curves[0], base, method)
    fit = fit_curve(curves[0])
    if fit.fit is None:
        raise InputError("CURVE.csv", f"a curve without a Lorentz fit ({fit.no_fit})",
                         f"one with a peak for --method {method}", "--method posterior")  # fmt: skip
    found = estimate_linear(fit.fit, base, method=method, coefficients=coefficients)
    if out and not found.refused:
        write_fragment(found.to_fragment(base), out)
    if as_json:
        report.print_json(found.summary())
    elif found.refused:
        print("no estimate: outside the method's domain")
        for reason in found.refused:
            print(f"  {reason}")
        print("try --method posterior, which has no such bounds")
    else:
        numbers = found.summary()["parameters"]
        rows = [[_WORDS[n], f"{v['median']:.2f} ± {v['sd']:.2f} {v['unit']}"] for n, v in numbers.items()]
        report.print_table(f"{found.method} method, {found.coefficients} coefficients", ["", "± one sd"], rows)
    raise typer.Exit(1 if found.refused else 0)


def _told_by(curve: Curve, base: Scenario, method: str) -> Scenario:
    """Scenario at the amplitude that the curve's own column tells."""
    told = [] if curve.angle_deg is None else np.unique(curve.angle_deg[np.isfinite(curve.angle_deg)]).tolist()
    if len(told) > 1:
        raise InputError("CURVE.csv", f"points at {' and '.join(f'{a:g}' for a in told[:4])} deg",
                         f"of one amplitude for --method {method}", "--method posterior")  # fmt: skip
    return base.replace(**{"motion.angle": math.radians(told[0])}) if told else base


def _posterior(
    curves: list[Curve],
    base: Scenario,
    motions: list[PlateMotion],
    out: Path | None,
    plot: Path | None,
    as_json: bool,
    *,
    seed: int,
    given: dict[str, Any],
    asked: dict[str, float] | None,
    angles: list[float],
) -> None:
    """The engine in the loop."""
    from plategait.estimate.result import estimate_parameters as run
    from plategait.model.fragment import write_fragment

    with report.progress_bar("estimating") as progress:
        found = run(curves, base, motions=motions, seed=seed, progress=progress, **given)
    planned = None
    if asked is not None:
        from plategait.estimate.planning import next_measurement

        with report.progress_bar("planning") as progress:
            planned = next_measurement(found.posterior, angles=angles, wanted=asked, seed=seed, progress=progress)
    if plot:
        from plategait.estimate.figures import plot_estimate
        from plategait.estimate.prediction import predict
        from plategait.plots.style import save

        with report.progress_bar("predicting") as progress:
            predictions = predict(found.posterior, seed=seed, progress=progress)
        save(plot_estimate(found, predictions), plot)
    if out and any(f.verdict == "determined" for f in found.findings):
        write_fragment(found.to_fragment(), out)
    if as_json:
        report.print_json(found.summary() | ({"next": planned.summary()} if planned else {}))
    else:
        _print(found, planned)
    raise typer.Exit(0 if found.answered else 1)


_WORDS = {
    "natural_frequency": "natural frequency ω_n", "friction_angle": "friction angle α", "friction_ratio": "β = μ_k/μ_s",
    "mass": "mass over that told", "bending_damping": "c_b over that told",
    "contact_damping": "contact damping over that told",
}  # fmt: skip


def _print(found: Estimate, planned: Plan | None) -> None:
    from plategait.estimate.result import correlated

    percent = f"{100 * found.confidence:g} % interval"
    rows = []
    for f in found.findings:
        rows.append([_WORDS[f.parameter.name], f.text, f.interval_text])
    title = f"{len(found.posterior.data.which)} points, {found.posterior.trials.rates.size} runs of the engine"
    report.print_table(title, ["", "± one sd", percent], rows)
    for a, b, r in correlated(found):
        print(f"{_WORDS[a]} and {_WORDS[b]} are correlated: {r:+.2f}")
    for note in found.posterior.data.notes:
        print(note)
    if found.check.outliers:
        print(f"probably outliers, left out in effect: {', '.join(f'{f:g}' for f in found.check.outliers)} Hz")
    for complaint in found.check.complaints:
        print(f"warning: not explained by any parameters: {complaint}")
    if planned is not None:
        _print_plan(found, planned)


def _print_plan(found: Estimate, planned: Plan) -> None:
    from plategait.estimate.planning import MOST_MEASUREMENTS

    c = planned.condition
    print(f"measure next at {c.frequency:.2f} Hz with A_p = {math.degrees(c.angle):.3g} deg "
          f"(runs off with a probability of {100 * planned.runs_off:.0f} %)")  # fmt: skip
    for f in found.findings:
        p, now, after = f.parameter, planned.sd_now[f.parameter.name], planned.sd_after[f.parameter.name]
        print(f"  {_WORDS[p.name]}: sd {now / p.scale:.2g} now, {after / p.scale:.2g} expected after {p.unit}".rstrip())
    if planned.needed:
        least, median, most = (f"{n}{' or more' if n >= MOST_MEASUREMENTS else ''}" for n in planned.needed)
        print("  the precision wanted is there" if planned.needed[1] == 0 else
              f"  measurements for the precision wanted: about {median} ({least} to {most})")  # fmt: skip
