"""Options of the steer command in groups, and what each group adds up to."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from plategait.cli.command import refuse
from plategait.cli.filmed import read_size
from plategait.cli.material_options import MaterialOptions
from plategait.cli.options import build, read_share
from plategait.errors import InputError
from plategait.files.ranges import parse_range
from plategait.model.scenario import Plate
from plategait.units import Quantity

if TYPE_CHECKING:
    from plategait.control.camera import Camera
    from plategait.control.goal import Goal
    from plategait.control.path import Path as AlongPath
    from plategait.control.pixels import PixelCamera
    from plategait.control.plant import Plant
    from plategait.model.scenario import Scenario

_HOLD = Quantity("s", "s", "2 s", at_least=0, at_most=3600)
_TIMEOUT = Quantity("s", "s", "30 s", above=0, at_most=3600)
_DISTANCE = Quantity("m", "mm", "3 mm", above=0, at_most=1)
_HEIGHT = Quantity("m", "mm", "40 mm", above=0, at_most=1)
_TURN = Quantity("rad", "deg", "5 deg", above=0, at_most=math.pi)
_DARK = Quantity("s", "s", "1:1.5 s", at_least=0)
_SHARE = Quantity("", "", "0.05", at_least=0, at_most=0.99)


@dataclass(frozen=True)
class AimOptions:
    """Where the object is to go, as typed."""

    to: Annotated[
        list[str] | None,
        typer.Option(
            "--to",
            help='Along the bar, across it, and the angle where it matters: "30 mm, -10 mm, 90 deg". Repeatable.',
        ),
    ] = None
    goals: Annotated[
        Path | None, typer.Option("--goals", help="Goals one after the other: .csv with x_mm, y_mm and angle_deg.")
    ] = None
    path: Annotated[
        str | None,
        typer.Option(
            "--path", help='Carry it along this at any angle: "figure of eight", a word, or a .csv with x_mm and y_mm.'
        ),
    ] = None
    height: Annotated[str, typer.Option("--height", help="Of the figure of eight, or of the word's letters.")] = "40 mm"
    start: Annotated[
        str | None, typer.Option("--from", help='Where the object lies at first: "0 mm, 20 mm, 45 deg".')
    ] = None
    hold: Annotated[str, typer.Option("--hold", help="How long it is to stay at each goal.")] = "2 s"
    within: Annotated[
        str | None, typer.Option("--within", help='How near counts as there: "3 mm, 5 deg", or the distance alone.')
    ] = None
    timeout: Annotated[
        str | None,
        typer.Option(
            "--timeout",
            help="After which a goal, 30 s if left out, or a path is given up: four times what is expected of it.",
        ),
    ] = None

    def check(self, context: typer.Context) -> None:
        """Refuse what would change nothing along a path, or without one."""
        if self.path is None:
            refuse(context, ["height"], "where there is no path", '--path "figure of eight"')
            return
        refuse(context, ["to", "goals"], "with --path", "the one or the other")
        refuse(context, ["hold", "method"], "with --path, which pulses go along without a stop", "--to for a place")
        if _is_file(self.path):
            refuse(context, ["height"], "with a file, which tells its own", "the path in the size that it is to have")

    def path_sought(self) -> AlongPath | None:
        """Path in SI, if one was typed."""
        from plategait.control.path import FIGURE_OF_EIGHT, figure_of_eight, read_path, word_path

        if self.path is None:
            return None
        if _is_file(self.path):
            return read_path(self.path, "--path")
        height = _HEIGHT.read(self.height, "--height")
        if self.path.lower().replace("-", " ").split() == FIGURE_OF_EIGHT.split():
            return figure_of_eight(height)
        return word_path(self.path, height, "--path")

    def aimed_for(self) -> list[Goal]:
        """Goals in SI."""
        from plategait.control.goal import read_goal, read_goals

        if self.to and self.goals is not None:
            raise InputError("--goals", str(self.goals), "left out with --to", "all goals in the file")
        if self.goals is not None:
            return read_goals(self.goals, "--goals")
        if not self.to:
            raise InputError("--to", "nothing", "a pose on the plate", '--to "30 mm, -10 mm, 90 deg"')
        return [read_goal(typed, "--to") for typed in self.to]

    def spelt(self, error: InputError) -> InputError:
        """The error about a goal, naming the option that it came from."""
        head, _, number = error.field.partition(".")
        if head != "goals":
            return error
        field = f"--goals row {number}" if self.goals is not None else "--to"
        return InputError(field, error.got, error.allowed, error.hint)

    def tolerances(self) -> tuple[float, float]:
        """How near counts as there, m and rad."""
        from plategait.control.goal import WITHIN_ANGLE

        typed = self.within or ("3 mm" if self.path is not None else "3 mm, 5 deg")
        parts = [part.strip() for part in typed.split(",")]
        if len(parts) > (1 if self.path is not None else 2):
            allowed = "a distance alone, along a path" if self.path is not None else "a distance, and an angle"
            raise InputError("--within", typed, allowed, f'"{parts[0]}"')
        angle = _TURN.read(parts[1], "--within") if len(parts) == 2 else WITHIN_ANGLE
        return _DISTANCE.read(parts[0], "--within"), angle

    def seconds(self) -> tuple[float, float]:
        """How long to stay at a goal, and when to give one up, s."""
        hold, timeout = _HOLD.read(self.hold, "--hold"), self.given_up("30 s")
        assert timeout is not None
        if hold >= timeout:
            raise InputError("--hold", f"{hold:g} s", f"less than the {timeout:g} s after which a goal is given up",
                             f'--timeout "{hold + 30:g} s"')  # fmt: skip
        return hold, timeout

    def given_up(self, usual: str | None = None) -> float | None:
        """When something is given up, s; None where nobody said so."""
        typed = self.timeout or usual
        return None if typed is None else _TIMEOUT.read(typed, "--timeout")

    def laid(self, scenario: Scenario) -> Scenario:
        """Scenario with the object where it is to begin."""
        from plategait.control.goal import check_place, read_goal

        if self.start is None:
            return scenario
        begin = read_goal(self.start, "--from")
        check_place(begin, scenario, "--from")
        angle = scenario.start.angle if begin.angle is None else begin.angle
        return scenario.replace(**{"start.x": begin.x, "start.y": begin.y, "start.angle": angle})


@dataclass(frozen=True)
class ObjectOptions(MaterialOptions):
    """What lies on the plate, and what it is believed to be, as typed."""

    plate_size: Annotated[
        str | None,
        typer.Option(
            "--plate-size", help='Along the bar and across it: "300 mm x 200 mm". The scenario\'s, or 200 mm.'
        ),
    ] = None
    measured: Annotated[
        list[Path] | None,
        typer.Option(
            "--with",
            help="What the controller believes of the object (.toml of identify or estimate), while the scenario is "
            "what truly lies there; repeatable.",
        ),
    ] = None

    def true_and_believed(self, name: str) -> tuple[Scenario, Scenario]:
        """The object that lies on the plate, and the one that the controller knows."""
        true, believed = build(name, made=self), build(name, made=self, measured=self.measured)
        if self.plate_size is not None:
            length, width = read_size(self.plate_size)
            plate = Plate(length=length, width=width)
            true, believed = true.replace(plate=plate), believed.replace(plate=plate)
            _check_room(true)
        return true, believed


def _is_file(path: str) -> bool:
    """Whether a path as typed is a file, and not a word."""
    return path.lower().endswith(".csv")


def _check_room(scenario: Scenario) -> None:
    """Refuse a plate as typed that is too small for the object."""
    from plategait.control.room import room_of

    try:
        room_of(scenario)
    except InputError as error:
        raise InputError("--plate-size", error.got, error.allowed, error.hint) from None


@dataclass(frozen=True)
class CameraOptions:
    """What is seen of the object, as typed."""

    through_pixels: Annotated[
        bool,
        typer.Option(
            "--through-pixels",
            help="Poses as track reads them in rendered frames of the plate, with their own noise and misses.",
        ),
    ] = False
    camera_rate: Annotated[
        str | None, typer.Option("--camera-rate", help='Frames per second: "60 Hz", or 30 Hz through pixels.')
    ] = None
    camera_noise: Annotated[
        str | None,
        typer.Option("--camera-noise", help='Standard deviation of a place, and of an angle: "0.5 mm, 1 deg".'),
    ] = None
    camera_delay: Annotated[str, typer.Option("--camera-delay", help="From a frame until its pose is known.")] = "30 ms"
    missed: Annotated[
        str | None, typer.Option("--missed", help="Chance of each frame to be missed: 0.05 or 5%, which it is.")
    ] = None
    dark: Annotated[
        list[str] | None, typer.Option("--dark", help='Times between which it sees nothing: "1:1.5 s". Repeatable.')
    ] = None

    def snapshots(self) -> float:
        """Time between the shapes that pictures are made of, s; 0 where none are taken."""
        if not self.through_pixels:
            return 0.0
        from plategait.control.pixels import SNAPSHOTS

        return SNAPSHOTS

    def look(self, plant: Plant, seed: int) -> PixelCamera | None:
        """What reads the plant's pictures, if any are taken."""
        if not self.through_pixels:
            return None
        from plategait.control.pixels import PixelCamera

        return PixelCamera(plant, seed=seed)

    def camera(self) -> Camera:
        """Camera in SI: of one through pixels what the controller knows of it."""
        from plategait.control.camera import PIXELS, Camera

        usual = PIXELS if self.through_pixels else Camera()
        if self.through_pixels:
            for name, given in (("--camera-noise", self.camera_noise), ("--missed", self.missed)):
                if given is not None:
                    raise InputError(name, given, "left out with --through-pixels, whose frames have their own",
                                     "--camera-rate or --camera-delay")  # fmt: skip
        noise = [part.strip() for part in (self.camera_noise or "").split(",")]
        if self.camera_noise is not None and len(noise) != 2:
            raise InputError("--camera-noise", self.camera_noise, "a length and an angle", '"0.5 mm, 1 deg"')
        place, angle = noise if len(noise) == 2 else (usual.position_noise, usual.angle_noise)
        missed = usual.missed if self.missed is None else read_share(self.missed, "--missed", _SHARE)
        spelt = {"rate": "--camera-rate", "position_noise": "--camera-noise", "angle_noise": "--camera-noise",
                 "delay": "--camera-delay", "missed": "--missed", "dark": "--dark"}  # fmt: skip
        try:
            return Camera(
                rate=usual.rate if self.camera_rate is None else self.camera_rate, position_noise=place,
                angle_noise=angle, delay=self.camera_delay, missed=missed,
                dark=tuple(parse_range(typed, _DARK, "--dark") for typed in self.dark or []),
            )  # type: ignore[arg-type]  # fmt: skip
        except InputError as error:
            name = error.field.partition(".")[0]
            hint = '"1:1.5 s"' if name == "dark" else error.hint  # as the command line has it
            raise InputError(spelt.get(name, error.field), error.got, error.allowed, hint) from None
