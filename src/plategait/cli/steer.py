"""`plategait steer`: an object brought to poses on a shaking plate and held there, or carried along a path."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from plategait.cli import options, report
from plategait.cli.groups import grouped
from plategait.cli.needs import MachineName
from plategait.cli.steer_files import SteeringFiles
from plategait.cli.steer_options import AimOptions, CameraOptions, ObjectOptions
from plategait.errors import InputError
from plategait.files.output import check_writable

if TYPE_CHECKING:
    from plategait.control.menu import Menu
    from plategait.model.scenario import Scenario


@dataclass(frozen=True)
class ControlOptions:
    """How the object is steered, as typed."""

    method: Annotated[
        str,
        typer.Option(
            "--method",
            help="blend (pulses, one after the other), mppi (futures by the engine), one-pulse, or open-loop (blind).",
        ),
    ] = "blend"
    generations: Annotated[
        int, typer.Option("--generations", help="Of the search for motions; fewer are found sooner.", min=0, max=100)
    ] = 3
    menu: Annotated[
        Path | None,
        typer.Option("--menu", help="Keep the motions that were found in this file (.json), and take them from there."),
    ] = None
    seed: Annotated[int, typer.Option("--seed", help="Of the search for motions and of the camera's noise.", min=0)] = 0

    def check(self) -> None:
        """Refuse a method that there is not."""
        from plategait.control.steer import METHODS

        if self.method not in METHODS:
            raise InputError("--method", self.method, f"one of {', '.join(METHODS)}", METHODS[0])

    def menu_for(self, true: Scenario, believed: Scenario, machine: str) -> Menu:
        """Motions for the object that is believed in, on the plate that there is."""
        from plategait.control.menu_file import kept_menu

        with report.progress_bar("finding motions") as progress:
            menu = kept_menu(self.menu, believed, machine, generations=self.generations, seed=self.seed,
                             progress=progress, field="--menu")  # fmt: skip
        height = true.motion.height
        # The motors do the same where the plate lies higher than it is believed to.
        return replace(menu, motions=tuple(motion.replace(height=height) for motion in menu.motions))


@grouped
def steer(
    context: typer.Context,
    scenario: options.ScenarioName = "cheese",
    machine: MachineName = "source-robot",
    *,
    aims: AimOptions,
    lies_there: ObjectOptions,
    seen: CameraOptions,
    steered: ControlOptions,
    files: SteeringFiles,
    as_json: options.Json = False,
) -> None:
    """Bring an object to poses on a shaking plate and hold it at each, or carry it along a path.

    Exit status 1 where a goal, or the end of the path, was not reached.
    """
    files.check_names(context)
    if steered.menu is not None and not steered.menu.is_file():
        check_writable(steered.menu, (".json",), "--menu")
    steered.check()
    aims.check(context)
    path, within, camera = aims.path_sought(), aims.tolerances(), seen.camera()
    goals = aims.aimed_for() if path is None else []
    hold, timeout = aims.seconds() if path is None else (0.0, aims.given_up())
    from plategait.control.follow import follow
    from plategait.control.goal import check_goals, check_reach
    from plategait.control.path import check_path
    from plategait.control.plant import Plant
    from plategait.control.report import camera_told, following_told, place_told, steering_told
    from plategait.control.room import on_a_plate
    from plategait.control.steer import TIMEOUT
    from plategait.control.steer import steer as steered_by

    true, believed = (on_a_plate(each) for each in lies_there.true_and_believed(scenario))
    try:
        check_goals(goals, true)
        if path is not None:
            check_path(path, true, "--path")
        true = aims.laid(true)
        menu = steered.menu_for(true, believed, machine)
        check_reach(goals, menu)
    except InputError as error:
        raise aims.spelt(error) from None
    plant = Plant([true], machine=machine, camera=camera, seeds=[steered.seed], snapshot_interval=seen.snapshots())
    look, shots = seen.look(plant, steered.seed), files.shots()
    with report.progress_bar("steering") as progress:
        if path is not None:
            done = follow(plant, path, menu, within=within[0], timeout=timeout, each_tick=shots, look=look,
                          progress=progress)  # fmt: skip
            told = following_told(done, within[0]) | {"within": {"mm": 1e3 * within[0]}}
        else:
            (done,) = steered_by(plant, [goals], menu, method=steered.method, hold=hold, within=within,  # type: ignore[arg-type]
                                 timeout=timeout or TIMEOUT, each_tick=shots, look=look, progress=progress)  # fmt: skip
            told = steering_told(done, goals) | {
                "hold_s": hold, "within": {"mm": 1e3 * within[0], "deg": math.degrees(within[1])}, "timeout_s": timeout
            }  # fmt: skip
    files.write(done, goals, true, machine, within)
    files.write_film(shots, done, true)
    files.write_trajectory(done, true, machine)
    numbers = place_told(true) | told | {
        "machine": machine, "method": steered.method, "motions": len(menu), "seed": steered.seed,
        "camera": camera_told(camera), "through_pixels": seen.through_pixels,
    }  # fmt: skip
    if taken := lies_there.taken(scenario, true):
        numbers["taken"] = taken
    report.print_json(numbers) if as_json else _print(numbers)
    raise typer.Exit(0 if numbers["reached"] else 1)


def _print(numbers: dict[str, Any]) -> None:
    report.print_notes(numbers.get("taken", []))
    if "path" in numbers:
        _print_path(numbers)
        return
    rows = [
        [str(number), _pose(goal), "yes" if goal["reached"] else f"NO: {goal['status']}", _shown(goal["time_s"], "s"),
         _shown(goal["error_mm"], "mm"), _shown(goal["error_deg"], "deg"), str(goal["pulses"])]
        for number, goal in enumerate(numbers["goals"], start=1)
    ]  # fmt: skip
    title = f"{numbers['scenario']} on {numbers['machine']}, {numbers['method']}, {numbers['duration_s']:.1f} s in all"
    report.print_table(title, ["", "goal", "reached", "after", "off by", "turned off by", "pulses"], rows)
    missed = sum(not goal["reached"] for goal in numbers["goals"])
    if missed:
        print(f"NOT REACHED: {missed} of {len(rows)}; try more --timeout, a larger --plate-size or wider --within")


def _print_path(numbers: dict[str, Any]) -> None:
    path = numbers["path"]
    report.print_table(f"{numbers['scenario']} on {numbers['machine']}, along a path", ["", ""], [
        ["length of its strokes", _shown(path["length_mm"], "mm")],
        ["followed to the end", "yes" if path["reached"] else f"NO: {path['status']}"],
        ["in", _shown(numbers["duration_s"], "s")],
        ["cross-track error, r.m.s.", _shown(path["rms_mm"], "mm")],
        ["greatest", _shown(path["greatest_mm"], "mm")],
        [f"come within {numbers['within']['mm']:g} mm of", f"{100 * path['coverage']:.0f} %"],
        ["pulses", str(path["pulses"])],
    ])  # fmt: skip
    if not path["reached"]:
        print("NOT FOLLOWED to the end; try more --timeout, a larger --plate-size or a smaller --height")


def _pose(goal: dict[str, Any]) -> str:
    angle = "any angle" if goal["angle_deg"] is None else f"{goal['angle_deg']:.4g} deg"
    return f"{goal['x_mm']:.4g} mm, {goal['y_mm']:.4g} mm, {angle}"


def _shown(value: float | None, unit: str) -> str:
    return "–" if value is None else f"{value:.1f} {unit}"
