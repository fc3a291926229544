"""`plategait simulate`: one scenario, run once or as an ensemble."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from plategait.cli import options, report
from plategait.cli.command import refuse
from plategait.cli.groups import grouped
from plategait.engine.recording import RunRequest
from plategait.files.output import PICTURES, check_outputs
from plategait.model.scenario import Scenario
from plategait.model.symmetry import symmetry_in_words
from plategait.simulation import run
from plategait.simulation.dataset import check_room, write_dataset
from plategait.simulation.expectation import expect
from plategait.simulation.result import Simulation
from plategait.simulation.run import FILM_INTERVAL


@dataclass(frozen=True)
class OutputOptions:
    """Files that a run is written to, as typed."""

    out: Annotated[Path | None, typer.Option("--out", help="Write the run as labelled data: .nc.")] = None
    plot: options.Plot = None
    film: Annotated[Path | None, typer.Option("--film", help="Write a film: .mp4.")] = None
    filmstrip: Annotated[
        Path | None, typer.Option("--filmstrip", help="Write snapshots over one plate period: .png.")
    ] = None

    def check_room(self, scenario: Scenario, repeats: int) -> None:
        """Refuse data that would not fit the memory or the disk, before the work."""
        if self.out:
            check_room(RunRequest(scenario, snapshot_interval=FILM_INTERVAL), repeats, self.out)

    def check_names(self) -> None:
        """Refuse names that cannot be written to, before anything is read."""
        check_outputs(
            (self.out, (".nc",), "--out"),
            (self.plot, PICTURES, "--plot"),
            (self.film, (".mp4",), "--film"),
            (self.filmstrip, (".png",), "--filmstrip"),
        )

    @property
    def snapshot_interval(self) -> float:
        """Time between the shapes that they need, s; 0 where they need none."""
        return FILM_INTERVAL if self.out or self.film or self.filmstrip else 0.0

    def write(self, result: Simulation) -> None:
        """Write them all."""
        if self.out:
            write_dataset(result, self.out)
        if self.plot:
            from plategait.plots.figures import plot_run
            from plategait.plots.style import save

            save(plot_run(result), self.plot)
        if self.film or self.filmstrip:
            from plategait import render

            if self.film:
                with report.progress_bar("filming") as progress:
                    render.film(result, self.film, progress=progress)
            if self.filmstrip:
                render.filmstrip(result, self.filmstrip)


@grouped
def simulate(
    context: typer.Context,
    scenario: options.ScenarioName = "cheese",
    frequency: Annotated[str | None, typer.Option("--frequency", help='Plate frequency: "24 Hz".')] = None,
    *,
    laid_over: options.ScenarioOptions,
    draws: options.Draws = 0,
    ensemble: options.EnsembleOptions,
    files: OutputOptions,
    as_json: options.Json = False,
) -> None:
    """Run one scenario: how fast it spins, in which gait, and whether it stays.

    Exit status 1 when any of its runs failed or has an energy that does not balance.
    """
    files.check_names()
    if not laid_over.measured:
        refuse(context, ["draws"], "where --with gives nothing to draw from", "--with bending.toml")
    if not draws:
        options.refuse_idle_seed(context, ensemble.repeats)
    build = partial(laid_over.over, scenario, frequency)
    nominal = build()
    files.check_room(nominal, ensemble.repeats)
    with report.progress_bar("simulating") as progress:
        result = run.simulate(nominal, **asdict(ensemble), progress=progress, snapshot_interval=files.snapshot_interval)
    files.write(result)
    drawn = _drawn(build, draws, ensemble) if draws else None
    taken = laid_over.taken(scenario, nominal, friction_told=laid_over.mu_s is not None)
    expected, symmetry = expect(nominal), symmetry_in_words(nominal.motion)
    if as_json:
        told = {"draws": drawn, "taken": taken, "expected": expected and expected.summary(), "symmetry": symmetry}
        report.print_json(result.summary() | {name: value for name, value in told.items() if value})
    else:
        report.print_simulation(result, drawn)
        report.print_notes([*taken, *([expected.words] if expected else []), *([symmetry] if symmetry else [])])
    raise typer.Exit(0 if result.sound else 1)


def _drawn(
    build: Callable[..., Scenario], draws: int, ensemble: options.EnsembleOptions
) -> dict[str, float | int | None]:
    """Spin rates of draws of what was measured: median and 95 % interval, deg/s, and how many failed."""
    import numpy as np

    generator = np.random.default_rng(ensemble.seed)
    scenarios = [build(generator=generator) for _ in range(draws)]
    with report.progress_bar("simulating draws") as progress:
        runs = run.simulate_all(scenarios, seed=ensemble.seed, engine=ensemble.engine, progress=progress)
    failed = sum(r.failed for r in runs)
    rates = np.degrees([r.spin_rate for r in runs if math.isfinite(r.spin_rate)])
    low, middle, high = np.quantile(rates, [0.025, 0.5, 0.975]).tolist() if len(rates) else (None, None, None)
    return {"runs": draws, "failed": failed, "spin_rate_deg_s": middle, "low": low, "high": high}
