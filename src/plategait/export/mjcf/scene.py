"""A scenario as an MJCF file: what MuJoCo 4 is told of time, gravity, plate, sheet and contact."""

from __future__ import annotations

from pathlib import Path
from typing import Literal, get_args
from xml.etree import ElementTree as ET

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError, printable
from plategait.export.mjcf.markup import add
from plategait.export.mjcf.plate import add_plate, start_of_plate
from plategait.export.mjcf.sheet import add_bodies, add_nodes, add_shell
from plategait.files.output import write_whole
from plategait.model.motion import rotation_of
from plategait.model.presets import Preset, as_scenario
from plategait.model.scenario import Scenario
from plategait.version import __version__

SUFFIXES = (".xml",)
Form = Literal["nodes", "shell"]
FORMS: tuple[Form, ...] = get_args(Form)


def mjcf(scenario: Scenario | Preset | Path | str, form: Form = "nodes", time_step: float | None = None) -> str:
    """MJCF of a scenario, for MuJoCo 4.

    Source: docs/export.md says how near the scene is to this package's own runs.

    Parameters
    ----------
    scenario : Scenario, or what tells one
    form : {"nodes", "shell"}
        The sheet as this package's lattice (point masses, springs along its lines, rods that bend), or as MuJoCo's own
        shell of the same plate stiffness and in-plane stiffness.
    time_step : float, optional
        s; the scenario's by default.

    Raises
    ------
    InputError
        When the plate follows a sampled trajectory, whose drive MJCF has no words for, or the form is not known.
    """
    if form not in FORMS:
        raise InputError("form", form, " or ".join(FORMS), FORMS[0])
    scenario = as_scenario(scenario)
    motion = scenario.motion.replace(ramp=0.0)
    if motion.samples is not None:
        raise InputError("motion.samples", "a sampled trajectory", "left out: MJCF drives a plate by sines",
                         "waves, or the trajectory as .csv for a drive of your own")  # fmt: skip
    root = ET.Element("mujoco", model=printable(scenario.name))
    root.append(ET.Comment(f" by plategait {__version__}: m, kg, s, rad "))
    add(root, "compiler", angle="radian", autolimits=True)
    step = scenario.dt if time_step is None else time_step
    option = add(root, "option", timestep=step, gravity=(0.0, 0.0, -scenario.gravity), integrator="discrete",
                 solver="Newton", cone="elliptic")  # fmt: skip
    # Contacts are as stiff and damped as they are told, and not as the step would have them.
    add(option, "flag", refsafe="disable")
    size = scenario.sheet.outline.size()
    add(root, "statistic", center=(0.0, 0.0, 0.0), extent=1.5 * max(size))
    world = add(root, "worldbody")
    add(world, "light", pos=(0.0, -0.5, 1.0), dir=(0.0, 0.4, -1.0))
    sections = {name: ET.Element(name) for name in ("deformable", "tendon", "equality", "actuator", "keyframe")}
    state = add_plate(world, sections, scenario, motion, step)
    names = add_bodies(world, scenario, start_of_sheet(scenario), contact=form == "nodes")
    (add_nodes if form == "nodes" else add_shell)(sections, scenario, names)
    still = np.zeros(3 * len(names))
    add(sections["keyframe"], "key", name="start", qpos=(*state.position, *still), qvel=(*state.speed, *still))
    root.extend(section for section in sections.values() if len(section))
    ET.indent(root)
    return ET.tostring(root, encoding="unicode") + "\n"


def write_mjcf(
    scenario: Scenario | Preset | Path | str,
    path: Path | str,
    form: Form = "nodes",
    time_step: float | None = None,
    field: str = "output",
) -> None:
    """Write a scenario as an MJCF file, which ends in .xml (see `mjcf`).

    Parameters
    ----------
    scenario : Scenario
        What is simulated.
    path : Path or str
        File that ends in .xml.
    form : {"nodes", "shell"}, optional
        This package's lattice, or MuJoCo's own shell.
    time_step : float, optional
        Of the scene, s; chosen if left out.
    field : str, optional
        What errors call it.

    Raises
    ------
    InputError
        As `mjcf`, or when the file cannot be written.
    """
    write_whole(mjcf(scenario, form, time_step).encode(), path, SUFFIXES, field)


def start_of_sheet(scenario: Scenario) -> Array:
    """(n_nodes, 3) where the nodes lie at the start, on a plate that moves at once; m."""
    sheet, start = scenario.sheet, scenario.start
    pose, height = start_of_plate(scenario.motion.replace(ramp=0.0)), (0.0, 0.0, scenario.motion.height)
    turn = np.array([[np.cos(start.angle), np.sin(start.angle)], [-np.sin(start.angle), np.cos(start.angle)]])
    depth = scenario.contact.static_depth(sheet.node_mass, sheet.pitch, scenario.gravity)
    flat = sheet.lattice.rest * sheet.pitch @ turn + (start.x, start.y)
    laid = np.column_stack([flat, np.full(len(flat), -depth)])
    return (laid + height) @ rotation_of(pose).T - height + pose[:3]
