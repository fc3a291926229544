"""`plategait export`: a scenario's motion for a machine, as CSV or ROS 2 bag, or the whole of it as MJCF."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path
from typing import Annotated, Any

import typer

from plategait.cli import options, report
from plategait.cli.command import refuse
from plategait.cli.groups import grouped
from plategait.cli.material_options import MaterialOptions
from plategait.cli.needs import Frequency, MachineName
from plategait.errors import InputError
from plategait.export import bag, trajectory_file
from plategait.export.mjcf import scene
from plategait.export.trajectory import Trajectory, trajectory
from plategait.files.output import check_writable
from plategait.model.scenario import Scenario
from plategait.units import FREQUENCY

SUFFIXES = (*trajectory_file.SUFFIXES, *bag.SUFFIXES, *scene.SUFFIXES)

Out = Annotated[
    Path, typer.Option("--out", help="What to write: .csv (a table), .mcap, .db3 (a ROS 2 bag) or .xml (MJCF).")
]
Rate = Annotated[str, typer.Option("--rate", help="Samples per second of a trajectory.")]
Cycle = Annotated[
    bool, typer.Option("--cycle", help="One cycle to be played over and over, in place of a start, a way and a stop.")
]
Until = Annotated[
    str | None, typer.Option("--duration", help='Until the plate begins to stop: "4 s". The scenario\'s if left out.')
]
Joints = Annotated[
    str | None, typer.Option("--joints", help='Names of the joints in a bag, in the order of the axes: "slide,rock".')
]
Topic = Annotated[str, typer.Option("--topic", help="Of the message in a bag.")]
Form = Annotated[
    scene.Form, typer.Option("--form", help="The sheet in MJCF: this lattice, or a shell of the same stiffness.")
]


@grouped
def export(
    context: typer.Context,
    out: Out,
    scenario: options.ScenarioName = "cheese",
    rate: Rate = "1 kHz",
    machine: MachineName = "source-robot",
    cycle: Cycle = False,
    duration: Until = None,
    frequency: Frequency = None,
    angle: options.Angle = None,
    stroke: options.Stroke = None,
    joints: Joints = None,
    topic: Topic = bag.TOPIC,
    form: Form = "nodes",
    *,
    made: MaterialOptions,
    dt: options.Dt = None,
    as_json: options.Json = False,
) -> None:
    """Write the plate's motion for a machine (CSV, ROS 2 bag) or the scene for MuJoCo, by the suffix of --out.

    A motion beyond the machine's limits is refused, with one that it can make.
    """
    kind = out.suffix.lower()
    if kind in scene.SUFFIXES:
        refuse(context, ["rate", "machine", "cycle", "duration", "joints", "topic"],
               "for a scene, which MuJoCo moves by itself", "--out motion.csv for a trajectory")  # fmt: skip
    else:
        alone = ["form", "dt", *(field.name for field in fields(MaterialOptions))]
        refuse(context, alone, "for a trajectory", "--out scene.xml for a scene")
    if kind in bag.SUFFIXES:
        refuse(context, ["cycle"], "for a bag, which a controller plays once", "a .csv file for a cycle")
        bag.check_bag(out, "--out")
    elif kind in scene.SUFFIXES:
        check_writable(out, SUFFIXES, "--out")
    else:
        refuse(context, ["joints", "topic"], "where there is no bag", "--out motion.mcap")
        check_writable(out, SUFFIXES, "--out")
    if cycle:
        refuse(context, ["duration"], "for a cycle, which has its own", "--cycle alone")
    hertz = FREQUENCY.read(frequency, "--frequency") if frequency is not None else None
    built = options.build(scenario, made=made, frequency=hertz, angle=angle, stroke=stroke, dt=dt)
    if kind in scene.SUFFIXES:
        _write_scene(built, out, form, as_json)
        return
    way = _trajectory(built, rate, machine, duration, cycle)
    numbers = _numbers(way, out, machine)
    if kind in bag.SUFFIXES:
        names = bag.check_names(way.axes, None if joints is None else joints.split(","), topic)
        bag.write_bag(way, out, joints=names, topic=topic, field="--out")
        numbers |= {"joints": list(names), "topic": topic}
    else:
        trajectory_file.write_trajectory(way, out, "--out")
    if as_json:
        report.print_json(numbers)
    else:
        _print(way, out, machine)


def _write_scene(built: Scenario, out: Path, form: scene.Form, as_json: bool) -> None:
    scene.write_mjcf(built, out, form, field="--out")
    nodes = built.sheet.lattice.n_nodes
    if as_json:
        report.print_json({"out": str(out), "form": form, "nodes": nodes, "time_step_s": built.dt})
    else:
        what = "as a shell of" if form == "shell" else "as a lattice of"
        report.print_notes([f"{out}: {built.sheet.name} {what} {nodes} nodes, in steps of {built.dt:.3g} s"])


def _trajectory(scenario: Scenario, rate: str, machine: str, duration: str | None, cycle: bool) -> Trajectory:
    until = scenario.duration if duration is None else duration
    try:
        return trajectory(scenario.motion, rate, machine, duration=until, cycle=cycle)
    except InputError as error:
        if error.field in ("rate", "machine", "cycle", "duration"):
            raise InputError(f"--{error.field}", error.got, error.allowed, error.hint) from None
        raise


def _numbers(made: Trajectory, out: Path, machine: str) -> dict[str, Any]:
    return {
        "out": str(out), "machine": machine, "rate_hz": made.rate, "samples": len(made.time), "cycle": made.cycle,
        "duration_s": made.duration, "axes": list(made.axes),
    }  # fmt: skip


def _print(made: Trajectory, out: Path, machine: str) -> None:
    what = "one cycle" if made.cycle else "from rest to rest"
    report.print_notes([
        f"{out}: {len(made.time)} samples at {made.rate:.9g} Hz, {what} of {made.duration:.6g} s, "
        f"on {', '.join(made.axes) or 'no axis'}, within the limits of {machine}"
    ])  # fmt: skip
