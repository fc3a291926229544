"""`plategait optimize`: the motion that spins an object fastest, or carries it at the least cost, on a machine."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from plategait.cli import options, report
from plategait.cli.command import refuse
from plategait.cli.groups import grouped
from plategait.cli.material_options import MaterialOptions
from plategait.cli.needs import MachineName
from plategait.files.output import PICTURES, check_outputs, write_whole
from plategait.files.ranges import parse_range

if TYPE_CHECKING:
    from plategait.model.scenario import Scenario
    from plategait.optimize.goal import Goal
    from plategait.optimize.optimum import Optimum


@dataclass(frozen=True)
class GoalOptions:
    """What is sought, as typed."""

    spin: Annotated[
        str | None, typer.Option("--spin", help='Spin to reach, counter-clockwise positive: "300 deg/s".')
    ] = None
    along: Annotated[str | None, typer.Option("--along", help='Velocity to reach along the bar: "100 mm/s".')] = None
    across: Annotated[str | None, typer.Option("--across", help='Velocity to reach across the bar: "0 mm/s".')] = None
    least: Annotated[
        str | None,
        typer.Option("--least", help="What is to be least meanwhile: acceleration, torque, power or bending."),
    ] = None

    def goal(self) -> Goal:
        """Goal in SI."""
        from plategait.optimize.goal import Goal

        return Goal(self.along, self.across, self.spin, self.least)  # type: ignore[arg-type]


@dataclass(frozen=True)
class RangeOptions:
    """What may vary, as typed."""

    frequency: Annotated[
        str | None, typer.Option("--frequency", help='Range of the plate\'s frequency, or its value: "10:30 Hz".')
    ] = None
    angle: Annotated[str | None, typer.Option("--angle", help='Range of A_p, or its value: "1:12 deg".')] = None
    stroke: Annotated[str | None, typer.Option("--stroke", help='Range of B_p, or its value: "3 mm".')] = None
    free: Annotated[
        list[str] | None,
        typer.Option(
            "--free",
            help="What may vary as well: phase, ratio (of frequencies), harmonics, offset, y, z, ry, rz; repeatable. "
            "All that the machine can, but ratio, where the object is to travel.",
        ),
    ] = None

    def ranges(self) -> dict[str, tuple[float, float]]:
        """Ranges that were typed, SI."""
        from plategait.optimize.space import PLAIN

        return {
            name: parse_range(typed, quantity, name)
            for name, quantity in PLAIN.items()
            if (typed := getattr(self, name)) is not None
        }

    def freedoms(self) -> list[str] | None:
        """Freedoms that were typed, by commas or one by one; None where none was."""
        return None if self.free is None else [name.strip() for typed in self.free or [] for name in typed.split(",")]


@dataclass(frozen=True)
class TrialOptions:
    """How motions are tried, as typed."""

    duration: options.Duration = None
    slip_limit: options.SlipLimit = None
    chance_of_failure: Annotated[
        str, typer.Option("--chance-of-failure", help="Chance of failure that is permitted: 0.05 or 5%.")
    ] = "5%"
    confidence: Annotated[str, typer.Option("--confidence", help="With which that is bounded: 0.9 or 90%.")] = "90%"
    searches: Annotated[
        int, typer.Option("--searches", help="Independent searches, of which the best counts.", min=1)
    ] = 1
    seed: Annotated[int, typer.Option("--seed", help="Of what is tried and of the starts.")] = 0
    engine: options.Engine = "cpu"

    def laid_over(self, scenario: str, made: MaterialOptions) -> Scenario:
        """Scenario of a name with these laid over it."""
        return options.build(scenario, made=made, duration=self.duration, slip_limit=self.slip_limit)


@grouped
def optimize(
    context: typer.Context,
    scenario: options.ScenarioName = "cheese",
    machine: MachineName = "source-robot",
    *,
    made: MaterialOptions,
    sought: GoalOptions,
    may_vary: RangeOptions,
    measured: options.With = None,
    draws: options.Draws = 0,
    tried: TrialOptions,
    store: Annotated[
        Path | None, typer.Option("--store", help="Folder that keeps what was run: killed, it goes on from there.")
    ] = None,
    dask: options.Dask = None,
    out: Annotated[Path | None, typer.Option("--out", help="Write the object on its best motion: .toml.")] = None,
    plot: options.Plot = None,
    as_json: options.Json = False,
) -> None:
    """Find the motion that spins an object fastest, or reaches a velocity at the least cost, on a machine.

    Exit status 1 where it is not reached, fails too often or does not hold at a tenth of the time step.
    """
    check_outputs((out, (".toml",), "--out"), (plot, PICTURES, "--plot"))
    if not measured:
        refuse(context, ["draws"], "where --with gives nothing to draw from", "--with object.toml --draws 32")
    from plategait.model.fragment import read_fragment
    from plategait.optimize.optimize import optimize_motion

    permitted = options.read_share(tried.chance_of_failure, "--chance-of-failure")
    confidence = options.read_share(tried.confidence, "--confidence")
    with report.going_on_in(store), report.progress_bar("optimizing") as progress:
        optimum = optimize_motion(
            tried.laid_over(scenario, made), machine, sought.goal(), ranges=may_vary.ranges(),
            free=may_vary.freedoms(),  # type: ignore[arg-type]
            measured=[read_fragment(path) for path in measured or []], draws=draws,
            chance_of_failure=permitted, confidence=confidence,
            searches=tried.searches, seed=tried.seed, engine=tried.engine, store=store, dask=dask,
            progress=progress,
        )  # fmt: skip
    if out:
        write_whole(optimum.toml().encode(), out, (".toml",), "--out")
    if plot:
        from plategait.optimize.figures import plot_optimum
        from plategait.plots.style import save

        save(plot_optimum(optimum), plot)
    from plategait.optimize.report import summary

    numbers = summary(optimum)
    report.print_json(numbers) if as_json else _print(optimum, numbers)
    raise typer.Exit(0 if optimum.sound else 1)


def _print(optimum: Optimum, s: dict[str, Any]) -> None:
    motion = f"{s['frequency_hz']:.2f} Hz, {s['angle_deg']:.3g} deg, {s['stroke_mm']:.3g} mm"
    off_level = [["held off level by", f"{s['offset_deg']:.3g} deg"]] if s["offset_deg"] else []
    tests = f"{s['failed_runs']} of {s['runs']} runs fail, at most {100 * s['chance_of_failure']:.2g} %"
    sure = f" at {100 * s['confidence']:g} % confidence"
    report.print_table(f"{s['scenario']} on {s['machine']}: {s['goal']}", ["", ""], [
        ["motion", motion],
        *off_level,
        *(["further sine", _sine(wave)] for wave in s["waves"]),
        ["spin rate", _rate(s)],
        ["velocity along, across", _velocity(s)],
        ["failure", tests + sure + ("" if s["certain"] else ": MORE THAN IS PERMITTED")],
        ["at a tenth of the step", _rate(s["confirmation"]) + ("" if s["confirmed"] else ": NOT CONFIRMED")],
        ["costs", _costs(s)],
        ["A_p ω_p² within a tenth of the fastest", _ridge(s["ridge_deg_s2"])],
        *_gain(s),
        ["runs", str(s["evaluations"])],
    ])  # fmt: skip
    rows = [
        [each["variable"], f"{each['value']:.4g} {each['unit']}", *(_side(each[side]) for side in ("less", "more"))]
        for each in s["sensitivities"]
    ]
    report.print_table("a twentieth less and more of each", ["", "optimum", "less", "more"], rows)
    if len(s["searches"]) > 1:
        rows = [
            [str(each["seed"]), _rate(each), f"{each['frequency_hz']:.2f} Hz", f"{each['angle_deg']:.3g} deg",
             f"{each['stroke_mm']:.3g} mm", f"{each['failed_runs']} of {each['runs']}"]
            for each in s["searches"]
        ]  # fmt: skip
        report.print_table("by search", ["seed", "spin rate", "frequency", "A_p", "B_p", "failed"], rows)
    if not optimum.reached:
        what = "NOTHING SPINS" if optimum.goal.fastest else f"NOT REACHED: {s['goal']}"
        print(f"{what}; try wider ranges, --free phase,offset or another machine")


def _rate(s: dict[str, Any]) -> str:
    if s["spin_rate_deg_s"] is None:
        return "–"
    low, high = s["spin_rate_interval_deg_s"]
    spread = f" ± {(high - low) / 2:.1f}" if low is not None else ""
    return f"{s['spin_rate_deg_s']:.1f}{spread} deg/s"


def _velocity(s: dict[str, Any]) -> str:
    if s["velocity_x_mm_s"] is None:
        return "–"
    return f"{s['velocity_x_mm_s']:.1f}, {s['velocity_y_mm_s']:.1f} mm/s"


def _sine(wave: dict[str, Any]) -> str:
    amplitude = f"{wave['amplitude_deg']:.3g} deg" if "amplitude_deg" in wave else f"{wave['amplitude_mm']:.3g} mm"
    return f"{wave['axis']}: {amplitude}, frequency × {wave['ratio']:.3g}, phase {wave['phase_deg']:.0f} deg"


def _costs(s: dict[str, Any]) -> str:
    said = (("acceleration_m_s2", "m/s²"), ("torque_n_m", "N·m"), ("power_w", "W"), ("bending_deg", "deg of bending"))
    return ", ".join(f"{s[key]:.3g} {unit}" for key, unit in said if s[key] is not None)


def _gain(s: dict[str, Any]) -> list[list[str]]:
    """What the freedoms add, where some were asked for."""
    if "gain_deg_s" not in s:
        return []
    low, high = s["gain_interval_deg_s"]
    return [["gain by what was freed", f"{s['gain_deg_s']:.1f} deg/s, {low:.1f} to {high:.1f}"]]


def _ridge(ends: list[float] | None) -> str:
    return "–" if ends is None else f"{1e-4 * ends[0]:.2g} to {1e-4 * ends[1]:.2g} × 10⁴ deg/s²"


def _side(side: dict[str, Any] | None) -> str:
    if side is None:
        return "–"
    rate = side["spin_rate_deg_s"]
    failed = f", {side['failed_runs']} of {side['runs']} fail" if side["failed_runs"] else ""
    return ("–" if rate is None or math.isnan(rate) else f"{rate:.0f} deg/s") + failed
