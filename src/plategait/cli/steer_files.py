"""Files that a steering is written to, as they are typed."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from plategait.cli import options, report
from plategait.cli.command import refuse
from plategait.files.output import PICTURES, check_outputs
from plategait.units import FREQUENCY

if TYPE_CHECKING:
    from plategait.control.film import Shots
    from plategait.control.follow import Following
    from plategait.control.goal import Goal
    from plategait.control.steer import Steering
    from plategait.model.scenario import Scenario


@dataclass(frozen=True)
class SteeringFiles:
    """Files that a steering is written to, as typed."""

    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            help="Write where the object was, was seen and was to go, tick by tick: .csv; or all of it: .json.",
        ),
    ] = None
    plot: options.Plot = None
    film: Annotated[Path | None, typer.Option("--film", help="Write a film in real time: .mp4.")] = None
    trajectory: Annotated[
        Path | None,
        typer.Option(
            "--trajectory", help="Write what the plate did, for a machine: .csv, or .mcap, .db3 (a ROS 2 bag)."
        ),
    ] = None
    rate: Annotated[str, typer.Option("--rate", help="Samples per second of that.")] = "1 kHz"

    def check_names(self, context: typer.Context) -> None:
        """Refuse names that cannot be written to, before anything is read."""
        from plategait.export import bag, trajectory_file

        if self.trajectory is None:
            refuse(context, ["rate"], "where no trajectory is written", "--trajectory plate.csv")
        elif self.trajectory.suffix.lower() in bag.SUFFIXES:
            bag.check_bag(self.trajectory, "--trajectory")
        check_outputs(
            (self.out, (".csv", ".json"), "--out"), (self.plot, PICTURES, "--plot"), (self.film, (".mp4",), "--film"),
            (self.trajectory, (*trajectory_file.SUFFIXES, *bag.SUFFIXES), "--trajectory"),
        )  # fmt: skip
        FREQUENCY.read(self.rate, "--rate")

    def shots(self) -> Shots | None:
        """What takes the film's frames, where there is to be one."""
        from plategait.control.film import Shots

        return Shots() if self.film else None

    def write_film(self, shots: Shots | None, done: Steering | Following, true: Scenario) -> None:
        """Write the film, where there is to be one."""
        if self.film is None or shots is None:
            return
        from plategait.control.film import film_steering
        from plategait.control.steer import Steering

        way, strokes = (done, []) if isinstance(done, Steering) else (done.way, done.path.strokes)
        with report.progress_bar("filming") as progress:
            film_steering(shots, way, true, self.film, strokes=strokes, progress=progress)

    def write_trajectory(self, done: Steering | Following, true: Scenario, machine: str) -> None:
        """Write what the plate was told, as the machine makes it, where that is wanted."""
        if self.trajectory is None:
            return
        from plategait.control.plant import at_rest
        from plategait.control.steer import Steering
        from plategait.export import bag, trajectory_file
        from plategait.export.stitched import stitched

        way = done if isinstance(done, Steering) else done.way
        # The motions were told at whole steps.
        told = [(round(time / true.dt) * true.dt, motion) for time, motion in way.motions]
        made = stitched(told, at_rest(true).motion, float(way.times[-1]), self.rate, machine)
        if self.trajectory.suffix.lower() in bag.SUFFIXES:
            bag.write_bag(made, self.trajectory, field="--trajectory")
        else:
            trajectory_file.write_trajectory(made, self.trajectory, "--trajectory")

    def write(
        self, done: Steering | Following, goals: list[Goal], true: Scenario, machine: str, within: tuple[float, float]
    ) -> None:
        """Write them all."""
        from plategait.control.figures import plot_following, plot_steering
        from plategait.control.report import write_way
        from plategait.control.steer import Steering
        from plategait.control.way_file import WAYS, write_way_whole
        from plategait.plots.style import save

        if self.out and self.out.suffix.lower() in WAYS:
            write_way_whole(done, goals, true, machine, self.out, "--out")
        elif self.out:
            write_way(done if isinstance(done, Steering) else done.way, self.out, "--out")
        if self.plot and isinstance(done, Steering):
            save(plot_steering(done, goals, true, within, true.name), self.plot)
        elif self.plot and not isinstance(done, Steering):
            save(plot_following(done, true, true.name), self.plot)
