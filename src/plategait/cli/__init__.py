"""The command line. Exit status: 0; 1 when it ran and the answer is a failure; 2 for usage or bad input."""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from typer.exceptions import TyperException

from plategait.cli import options, report
from plategait.cli.command import Command, refuse, usage_line
from plategait.cli.estimate import estimate
from plategait.cli.identify.commands import identify
from plategait.cli.shoot import shoot
from plategait.cli.sweep import plot_store, sweep
from plategait.cli.target import target
from plategait.cli.thesis import thesis
from plategait.cli.track import track
from plategait.cli.track_folder import track_folder
from plategait.cli.track_strip import track_strip
from plategait.errors import InputError, printable
from plategait.files.output import PICTURES, check_outputs
from plategait.model.presets import PRESETS, as_scenario, preset
from plategait.model.scenario import write_scenario
from plategait.units import FREQUENCY

if TYPE_CHECKING:
    from plategait.curve.curve import Curve
    from plategait.model.scenario import Scenario
    from plategait.simulation.run import Simulation

INTERRUPTED = 130

app = typer.Typer(
    add_completion=False, pretty_exceptions_enable=False, context_settings={"help_option_names": ["-h", "--help"]},
    help="Simulates a thin soft object on a vibrating plate: how it slides, walks, runs and spins.",
)  # fmt: skip


@app.callback(invoke_without_command=True)
def root(
    context: typer.Context, version: Annotated[bool, typer.Option("--version", help="Print the version.")] = False
) -> None:
    """Simulates a thin soft object on a vibrating plate: how it slides, walks, runs and spins."""
    if version:
        from plategait.version import __version__

        print(f"plategait {__version__}")
    elif context.invoked_subcommand is None:
        print(context.get_help())


@app.command(cls=Command)
def simulate(
    context: typer.Context,
    scenario: options.ScenarioName = "cheese",
    sheet: options.Sheet = None,
    natural_frequency: options.NaturalFrequency = None,
    frequency: Annotated[str | None, typer.Option("--frequency", help='Plate frequency: "24 Hz".')] = None,
    angle: options.Angle = None,
    stroke: options.Stroke = None,
    mu_s: options.MuS = None,
    mu_k: options.MuK = None,
    friction_law: options.Law = None,
    duration: options.Duration = None,
    measured: options.With = None,
    draws: options.Draws = 0,
    repeats: options.Repeats = 1,
    seed: options.Seed = 0,
    dt: options.Dt = None,
    engine: options.Engine = "cpu",
    out: Annotated[Path | None, typer.Option("--out", help="Write the run as labelled data: .nc.")] = None,
    plot: options.Plot = None,
    film: Annotated[Path | None, typer.Option("--film", help="Write a film: .mp4.")] = None,
    filmstrip: Annotated[
        Path | None, typer.Option("--filmstrip", help="Write snapshots over one plate period: .png.")
    ] = None,
    as_json: options.Json = False,
) -> None:
    """Run one scenario: how fast it spins, in which gait, and whether it stays.

    Exit status 1 when any of its runs failed or has an energy that does not balance.
    """
    from plategait.simulation import run as simulation

    check_outputs(
        (out, (".nc",), "--out"),
        (plot, PICTURES, "--plot"),
        (film, (".mp4",), "--film"),
        (filmstrip, (".png",), "--filmstrip"),
    )
    if not measured:
        refuse(context, ["draws"], "where --with gives nothing to draw from", "--with bending.toml")
    if not draws:
        options.refuse_idle_seed(context, repeats)
    build = partial(
        options.build, scenario, sheet=sheet, natural_frequency=natural_frequency, angle=angle, stroke=stroke,
        mu_s=mu_s, mu_k=mu_k, friction_law=friction_law, duration=duration, dt=dt, measured=measured,
        frequency=FREQUENCY.read(frequency, "--frequency") if frequency is not None else None,
    )  # fmt: skip
    chosen = build()
    if out:
        from plategait.engine.recording import Run
        from plategait.simulation.dataset import check_room

        check_room(Run(chosen, snapshot_interval=simulation.FILM_INTERVAL), repeats, out)
    with report.progress_bar("simulating") as progress:
        result = simulation.simulate(
            chosen, repeats=repeats, seed=seed, engine=engine, progress=progress,
            snapshot_interval=simulation.FILM_INTERVAL if out or film or filmstrip else 0.0,
        )  # fmt: skip
    _write_pictures(result, out, plot, film, filmstrip)
    drawn = _drawn(build, draws, seed, engine) if draws else None
    report.print_json(result.summary() | ({"draws": drawn} if drawn else {})) if as_json else report.print_simulation(
        result, drawn
    )
    raise typer.Exit(0 if result.sound else 1)


@app.command(cls=Command)
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
    from plategait.curve.curve import parse_frequencies, spin_curve, write_curve

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


@app.command(cls=Command)
def fit(
    curve_file: Annotated[Path, typer.Argument(metavar="CURVE.csv", help="Columns frequency_hz, spin_rate_deg_s, …")],
    plot: options.Plot = None,
    as_json: options.Json = False,
) -> None:
    """Fit the Lorentz function (5.5) to a spin curve; failed points are left out."""
    from plategait.curve.curve import fit_curve, fit_summary, read_curve

    check_outputs((plot, PICTURES, "--plot"))
    result = fit_curve(read_curve(curve_file))
    _plot_curve(result, plot)
    if as_json:
        report.print_json(fit_summary(result.fit) | {"no_fit": result.no_fit or None})
    else:
        report.print_fit(result.fit, result.no_fit)
    raise typer.Exit(0 if result.fit else 1)


@app.command(cls=Command)
def modes(
    scenario: options.ScenarioName = "cheese",
    sheet: options.Sheet = None,
    natural_frequency: options.NaturalFrequency = None,
    count: Annotated[int, typer.Option("--count", help="How many to print.", min=1)] = 8,
    plot: options.Plot = None,
    as_json: options.Json = False,
) -> None:
    """Free-vibration modes of a sheet; the dish mode is the dissertation's natural frequency."""
    check_outputs((plot, PICTURES, "--plot"))
    chosen = options.build(scenario, sheet=sheet, natural_frequency=natural_frequency).sheet
    found = chosen.free_modes
    if plot:
        from plategait.plots.figures import plot_modes, save

        save(plot_modes(chosen), plot)
    if not as_json:
        return report.print_modes(chosen.name, found, count)
    keys = ("omega", "frequency", "damping_ratio", "name")
    report.print_json(
        {"sheet": chosen.name, "modes": [{_MODE_KEYS[k]: getattr(m, k) for k in keys} for m in found.modes[:count]]}
    )


_MODE_KEYS = {"omega": "omega_rad_s", "frequency": "frequency_hz", "damping_ratio": "damping_ratio", "name": "name"}


@app.command(name="scenario", cls=Command)
def scenario_command(
    context: typer.Context,
    name: Annotated[str | None, typer.Argument(metavar="[FILE]", help="A scenario file to check.")] = None,
    shown: Annotated[str | None, typer.Option("--print", help="Print this preset as a commented TOML file.")] = None,
    as_json: options.Json = False,
) -> None:
    """List the presets, print one as a commented TOML file, or check a scenario file."""
    if shown is not None:
        refuse(context, ["name", "as_json"], "with --print", f"plategait scenario --print {shown}")
        found = preset(shown)
        print(f"# {found.summary}\n\n" + write_scenario(found.scenario, found.notes), end="")
    elif name is not None:
        checked = as_scenario(name)
        facts = {
            "scenario": checked.name,
            "nodes": checked.sheet.lattice.n_nodes,
            "dt_s": checked.dt,
            "duration_s": checked.duration,
        }
        sizes = f"{facts['nodes']} nodes, step {checked.dt:.3g} s"
        report.print_json(facts) if as_json else print(f"{printable(name)}: {printable(checked.name)}, {sizes}")
    elif as_json:
        report.print_json(
            {
                n: {"summary": preset(n).summary, "published": preset(n).published, "inferred": preset(n).inferred}
                for n in PRESETS
            }
        )
    else:
        for each in PRESETS:
            print(f"{each:18}{preset(each).summary}")


app.command(cls=Command)(estimate)
app.add_typer(identify, name="identify")
app.command(cls=Command)(track)
app.command(cls=Command)(track_folder)
app.command(cls=Command)(track_strip)
app.command(cls=Command)(target)
app.command(cls=Command)(shoot)
app.command(cls=Command)(sweep)
app.command(name="plot", cls=Command)(plot_store)
app.command(cls=Command)(thesis)


def _drawn(
    build: Callable[..., Scenario], draws: int, seed: int, engine: options.Engine
) -> dict[str, float | int | None]:
    """Spin rates of draws of what was measured: median and 95 % interval, deg/s, and how many failed."""
    import numpy as np

    from plategait.simulation import run as simulation

    generator = np.random.default_rng(seed)
    scenarios = [build(generator=generator) for _ in range(draws)]
    with report.progress_bar("drawing") as progress:
        runs = simulation.simulate_all(scenarios, seed=seed, engine=engine, progress=progress)
    failed = sum(r.failed for r in runs)
    rates = np.degrees([r.spin_rate for r in runs if math.isfinite(r.spin_rate)])
    low, middle, high = np.quantile(rates, [0.025, 0.5, 0.975]).tolist() if len(rates) else (None, None, None)
    return {"runs": draws, "failed": failed, "spin_rate_deg_s": middle, "low": low, "high": high}


def _write_pictures(
    result: Simulation, out: Path | None, plot: Path | None, film: Path | None, filmstrip: Path | None
) -> None:
    if out:
        from plategait.simulation.dataset import write_dataset

        write_dataset(result, out)
    if plot:
        from plategait.plots.figures import plot_run, save

        save(plot_run(result), plot)
    if film or filmstrip:
        from plategait import render

        if film:
            render.film(result.scenario, result.recordings[0], film)
        if filmstrip:
            render.filmstrip(result.scenario, result.recordings[0], filmstrip)


def _plot_curve(result: Curve, plot: Path | None) -> None:
    if plot:
        from plategait.plots.figures import plot_curve, save

        save(plot_curve(result), plot)


def main() -> None:
    """Run the command line; whatever is wrong is one line on standard error."""
    try:
        # Not standalone, or typer would box its usage errors. An exit status is returned then, 130 for an interrupt.
        status = app(standalone_mode=False, prog_name="plategait")
        sys.stdout.flush()
        if status == INTERRUPTED:
            raise KeyboardInterrupt
    except InputError as error:
        status, message = 2, str(error)
    except TyperException as error:
        status, message = 2, usage_line(error)
    except KeyboardInterrupt:
        status, message = INTERRUPTED, "interrupted, nothing written"
    except MemoryError:
        status, message = 2, "this needs more memory than there is; try a shorter, coarser or smaller one"
    except RecursionError:
        status, message = 2, "a file holds lists or tables nested too deep; try a flat one"
    except ValueError as error:
        if "integer string conversion" not in str(error):
            raise
        status, message = 2, "a number has more digits than can be read; try one of a few digits"
    except OSError as error:
        status, message = 2, f"{error.strerror or error}; try another place with room to write"
        # What could not be printed is not printed again at exit.
        sys.stdout = open(os.devnull, "w")  # noqa: SIM115
    else:
        sys.exit(status or 0)
    print(f"plategait: {message}", file=sys.stderr)
    sys.exit(status)
