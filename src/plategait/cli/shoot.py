"""The command that films a simulated run as a lab's camera would, with the truth beside it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from plategait.cli import filmed, options, report
from plategait.cli.command import refuse
from plategait.cli.groups import grouped
from plategait.errors import InputError
from plategait.files.output import check_writable

if TYPE_CHECKING:
    from plategait.camera.camera import Camera
    from plategait.model.scenario import Scenario
    from plategait.render.clip.appearance import Appearance

SUFFIXES = (".mp4", ".mkv", ".mov")
# Shapes recorded per plate period, which a film interpolates between.
SHAPES_PER_PERIOD = 24


@dataclass(frozen=True)
class CameraOptions:
    """The camera and what it films, as typed."""

    fps: Annotated[float, typer.Option("--fps", help="Frames per second.")] = 30.0
    seconds: Annotated[float, typer.Option("--seconds", help="Length of the clip, from when the run has settled.")] = (
        3.0
    )
    size: Annotated[str, typer.Option("--size", help="Of the picture, px.")] = "1280x720"
    elevation: Annotated[
        float, typer.Option("--elevation", help="Of the camera above the plate, deg, from 10 to 90; 90 looks down.")
    ] = 55.0
    markers: Annotated[bool, typer.Option("--markers/--no-markers", help="Two markers on the object.")] = True
    noise: Annotated[float, typer.Option("--noise", help="Of the sensor, grey levels.")] = 2.0
    exposure: Annotated[float, typer.Option("--exposure", help="Share of the frame for which the shutter is open.")] = (
        0.25
    )
    crf: Annotated[int, typer.Option("--crf", help="Quality of the file: 18 good, 35 poor.")] = 20
    hidden: Annotated[float, typer.Option("--hidden", help="Share of frames in which a marker is covered.")] = 0.0

    def check(self, context: typer.Context) -> None:
        """Refuse what cannot be filmed, or would change nothing."""
        if not 0.2 <= self.seconds <= 600:
            raise InputError("--seconds", self.seconds, "from 0.2 to 600", "3")
        if not 10 <= self.elevation <= 90:
            raise InputError("--elevation", self.elevation, "from 10 to 90 deg", "55")
        _pixels(self.size)
        if not self.markers:
            refuse(context, ["hidden"], "with --no-markers", "--markers")

    def camera(self, scenario: Scenario) -> Camera:
        """Where it stands."""
        from plategait.render.clip.clip import usual_camera

        return usual_camera(scenario, *_pixels(self.size), elevation=math.radians(self.elevation))

    def appearance(self, seed: int) -> Appearance:
        """What the film looks like."""
        from plategait.render.clip.appearance import Appearance

        return Appearance(
            markers=self.markers, noise=self.noise, exposure=self.exposure, crf=self.crf, hidden=self.hidden, seed=seed
        )


@grouped
def shoot(
    context: typer.Context,
    scenario: Annotated[str, typer.Argument(metavar="SCENARIO", help="A TOML file or a preset.")],
    out: Annotated[Path, typer.Argument(metavar="CLIP.mp4", help="Film to write; the truth goes to CLIP.truth.csv.")],
    filming: CameraOptions,
    laid_over: options.ObjectOptions,
    frequency: Annotated[str | None, typer.Option("--frequency", help='Plate frequency: "24 Hz".')] = None,
    seed: options.Seed = 0,
    as_json: options.Json = False,
) -> None:
    """Film a simulated run as an ordinary camera would see it: to plan a set-up, and to try `track` on known truth."""
    check_writable(out, SUFFIXES, "CLIP.mp4")
    filming.check(context)
    filmed.require_opencv()
    from plategait.render.clip.clip import film
    from plategait.simulation.run import simulate

    to_film = laid_over.over(scenario, frequency)
    settle = min(1.0, to_film.measured_from)
    to_film = to_film.replace(duration=settle + filming.seconds + 0.05, transient=settle)
    appearance = filming.appearance(seed)
    shapes = to_film.motion.period / SHAPES_PER_PERIOD
    with report.progress_bar("simulating") as progress:
        run = simulate(to_film, seed=seed, snapshot_interval=shapes, progress=progress)
    with report.progress_bar("filming") as progress:
        truth = film(
            run, out, filming.camera(to_film), filming.fps, appearance, seconds=filming.seconds, progress=progress
        )
    rate = math.degrees(truth.spin.rate)
    numbers = {
        "clip": str(out), "frames": len(truth.time), "fps": filming.fps,
        "spin_rate_deg_s": rate if math.isfinite(rate) else None, "failure": run.summary()["failure"],
    }  # fmt: skip
    taken = laid_over.taken(scenario, to_film, friction_told=laid_over.mu_s is not None)
    if as_json:
        report.print_json(numbers | ({"taken": taken} if taken else {}))
        return
    print(
        f"{out}: {len(truth.time)} frames of {to_film.name} at {to_film.motion.frequency:g} Hz, "
        f"spinning at {rate:.1f} deg/s" + (f", {numbers['failure']}" if numbers["failure"] else "")
    )
    report.print_notes(taken)


def _pixels(text: str) -> tuple[int, int]:
    """Width and height of a picture."""
    parts = text.lower().replace("×", "x").split("x")
    if len(parts) == 2 and all(p.strip().isdigit() and 64 <= int(p) <= 7680 and int(p) % 2 == 0 for p in parts):
        return int(parts[0]), int(parts[1])
    raise InputError("--size", text, "two even numbers from 64 to 7680 with an x between", "1280x720")
