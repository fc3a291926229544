"""`plategait simulate`: one scenario, run once or as an ensemble."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from plategait.cli import options, report
from plategait.cli.command import refuse
from plategait.files.output import PICTURES, check_outputs
from plategait.units import FREQUENCY

if TYPE_CHECKING:
    from plategait.model.scenario import Scenario
    from plategait.simulation.result import Simulation


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
        from plategait.engine.recording import RunRequest
        from plategait.simulation.dataset import check_room

        check_room(RunRequest(chosen, snapshot_interval=simulation.FILM_INTERVAL), repeats, out)
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
        from plategait.plots.figures import plot_run
        from plategait.plots.style import save

        save(plot_run(result), plot)
    if film or filmstrip:
        from plategait import render

        if film:
            render.film(result, film)
        if filmstrip:
            render.filmstrip(result, filmstrip)
