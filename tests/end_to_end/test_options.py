"""Every option of every command, in every mode of it: it changes what comes out, or it is refused.

`MODES` holds, for each command and each way to use it, a command line and what each of its options would add to that.
An option that is listed must change what is printed, written, or asked of the work behind the command; all others of
the command must be refused. A new option therefore has to be placed here, and has to do something there.
"""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest
import typer

from plategait.cli import app, main
from plategait.cli.command import Command
from plategait.identify import examples
from plategait.simulation.registry import all_observables

Typed = tuple[str, ...]
# Commands that are made from the catalogue; a name that it has and this list has not is found out.
QUESTIONS = (
    "freshness",
    "friction",
    "gait",
    "identifiability",
    "phases",
    "sizes",
    "strides",
    "stroke",
    "torsion",
    "viscosity",
)


@dataclass(frozen=True)
class Mode:
    """A way to use a command: what is typed, what its options add, and which others are refused (None: all)."""

    typed: Typed
    options: dict[str, Typed]
    refused: Typed | None = None

    @property
    def words(self) -> Typed:
        return self.typed[:2] if self.typed[0] in ("identify", "study") else self.typed[:1]


def typed(**options: str) -> dict[str, Typed]:
    """Options by name with a value to type; an empty one for a switch."""
    named = {f"--{name.strip('_').replace('_', '-')}": value for name, value in options.items()}
    return {name: (name, value) if value else (name,) for name, value in named.items()}


def but(options: dict[str, Typed], *names: str) -> dict[str, Typed]:
    return {name: value for name, value in options.items() if name not in names}


JSON = typed(json="")
MOVED = typed(
    rate="2 kHz", machine="shaker.toml", duration="1 s", frequency="20 Hz", angle="2 deg", stroke="2 mm", json=""
)  # fmt: skip
FRAGMENT = typed(out="o.toml", plot="p.png", json="")
WINDOW = typed(_from="0.02 s", to="0.2 s")
MADE = typed(
    outline="rectangle 60 mm", pitch="8 mm", mass="5 g", material="silicone-dragon-skin-30", young="0.5 MPa"
)  # fmt: skip
OF_A_MATERIAL = typed(
    thickness="1 mm", density="1100 kg/m^3", poisson="0.5", loss_factor="0.1", damping_ratio="0.1"
)  # fmt: skip
OBJECT = MADE | typed(
    natural_frequency="8 Hz", angle="5 deg", stroke="2 mm", mu_s="0.6", mu_k="0.3", _with="measured.toml",
    plate_size="60 mm", slip_limit="0.01 mm",
)  # fmt: skip
RUN = OBJECT | typed(
    sheet="pancake", friction_law="adams", duration="0.15 s", dt="5e-5 s", repeats="2", engine="cpu64", plot="p.png"
)
SHORT, LONGER = ("--duration", "0.1 s", "--json"), ("--duration", "0.4 s", "--json")
POSTERIOR = typed(
    scenario="pancake", _with="measured.toml", stroke="2 mm", angle="5 deg", mass="10 g", radius="30 mm",
    method="linear", beta="0.5", free="mass", noise="5%", duration="3 s", slip_limit="15 mm", ramp="0.2 s",
    model_error="0.5", any_law="", confidence="95%", next="", seed="3", want_frequency="1 rad/s", want_angle="1 deg",
    out="o.toml", plot="p.png", json="", friction_scatter="3 deg", fixed="bending_damping", height="6 mm",
    thickness="2 mm",
    outline="rectangle 60 mm", pitch="8 mm", material="silicone-dragon-skin-30", young="0.5 MPa",
)  # fmt: skip
MANY = but(POSTERIOR, "--next", "--want-frequency", "--want-angle", "--plot", "--out") | typed(
    store="kept", dask="host:1", fragments="objects", out="o.csv"
)  # fmt: skip
BENDING = typed(mass="0.3 g", length="11 mm", width="12 mm", no_centripetal="") | WINDOW | FRAGMENT
PRESS = typed(thickness="3 mm", length="12 mm", offset="", _from="0.004 s", to="0.008 s") | FRAGMENT
RING = typed(sheet="pancake", mode="2") | WINDOW | FRAGMENT
FILMED = typed(
    plate_size="120 mm", fiducial="10 mm", scale="1 mm", plate="outline", object="texture", fps="60",
    calibration="lens.json", duration="1 s", out="o.csv", json="",
)  # fmt: skip
TRACK = FILMED | typed(frequency="24 Hz", preview="seen.mp4")
SHOT = OBJECT | typed(
    frequency="20 Hz", fps="60", size="640x360", elevation="70", no_markers="", noise="4", exposure="0.5", crf="30",
    hidden="0.3", seed="4", seconds="0.3", json="",
)  # fmt: skip
OPTIMIZE = MADE | typed(
    machine="shaker.toml", spin="2 rad/s", along="0.1 m/s", across="0 mm/s", frequency="20:30 Hz", angle="1:5 deg",
    stroke="2 mm", free="phase,ratio", _with="measured.toml", duration="3 s", slip_limit="20 mm",
    chance_of_failure="10%", confidence="95%", searches="2", seed="3", engine="cpu64", store="runs", dask="host:1",
    out="o.toml", plot="p.png", json="",
)  # fmt: skip
MOVES = MADE | typed(
    machine="shaker.toml", free="phase,offset", cell_along="40 mm/s", cell_across="10 mm/s", cell_turn="90 deg/s",
    duration="2 s", reach="10 mm", generations="2", seed="3", engine="cpu64", store="moved", dask="host:1",
    out="o.json", plot="p.png", json="",
)  # fmt: skip
STEER = MADE | typed(
    machine="shaker.toml", to="0 mm, 5 mm", _from="0 mm, 1 mm", hold="1 s", within="2 mm", timeout="20 s",
    plate_size="300 mm", _with="measured.toml", through_pixels="", camera_rate="30 Hz", camera_noise="1 mm, 1 deg",
    camera_delay="10 ms", missed="10%", dark="1:2 s", method="one-pulse", generations="2", menu="menu.json", seed="3",
    out="o.csv", plot="p.png", film="f.mp4", trajectory="t.csv", json="",
)  # fmt: skip

LAB = OBJECT | typed(
    frequency="20 Hz", sheet="pancake", friction_law="adams", duration="2 s", dt="5e-5 s", out="o.html", no_open="",
    json="",
)  # fmt: skip

MODES = [
    Mode(("simulate", *SHORT), RUN | typed(frequency="20 Hz", out="o.nc", filmstrip="s.png"), ("--seed", "--draws")),
    Mode(("simulate", *SHORT, "--young", "0.5 MPa"), OF_A_MATERIAL, ("--sheet", "--natural-frequency")),
    Mode(("simulate", "--duration", "0.02 s"), typed(film="f.mp4"), ()),
    Mode(("simulate", "--duration", "0.1 s"), JSON, ()),
    Mode(("simulate", *LONGER, "--repeats", "3"), typed(seed="4"), ()),
    Mode(("simulate", *LONGER, "--with", "measured.toml"), typed(draws="2"), ()),
    Mode(("simulate", *LONGER, "--with", "measured.toml", "--draws", "2"), typed(seed="4"), ()),
    Mode(("curve", "--frequency", "22:24:1Hz", *SHORT), RUN | typed(frequency="20:26:2Hz", out="o.csv")),
    Mode(("curve", "--frequency", "22:24:1Hz", "--duration", "0.1 s"), JSON, ()),
    Mode(("curve", "--frequency", "22:22:1Hz", *SHORT, "--young", "0.5 MPa"), OF_A_MATERIAL, ()),
    Mode(("curve", "--frequency", "22:24:1Hz", *SHORT, "--repeats", "3"), typed(seed="4"), ()),
    Mode(("fit", "peak.csv"), typed(plot="p.png", json="")),
    Mode(("export", "--out", "m.csv", "--frequency", "12 Hz"), MOVED | typed(out="n.csv", cycle="")),
    Mode(("export", "--out", "m.csv", "--cycle"), JSON, ("--duration",)),
    Mode(("export", "--out", "m.xml"),
         MADE
         | typed(out="n.xml", form="shell", dt="5e-5 s", frequency="20 Hz", angle="2 deg", stroke="2 mm", json="")),
    Mode(("export", "--out", "m.xml", "--young", "0.5 MPa"), OF_A_MATERIAL, ()),
    Mode(("export", "--out", "m.mcap", "--frequency", "12 Hz"), MOVED | typed(out="n.mcap", joints="a,b", topic="/to")),
    Mode(("modes",), MADE | typed(sheet="pancake", natural_frequency="8 Hz", count="3", plot="p.png", json="")),
    Mode(("modes", "--young", "0.5 MPa"), OF_A_MATERIAL, ("--sheet", "--natural-frequency")),
    Mode(("lab",), LAB),
    Mode(("lab", "measured.toml"), but(LAB, "--stroke", "--mass", "--with") | typed(scenario="pancake"), ()),
    Mode(("lab", "--young", "0.5 MPa"), OF_A_MATERIAL, ()),
    Mode(("lab", "poses.csv"), LAB | typed(scenario="pancake"), ()),
    Mode(("lab", "done.zarr"), typed(out="o.html", no_open="", json="")),
    Mode(("needs",), typed(machine="shaker.toml", frequency="20 Hz", angle="5 deg", stroke="2 mm", json="")),
    Mode(("optimize",), OPTIMIZE, ("--least", "--draws")),
    Mode(("optimize", "--young", "0.5 MPa"), OF_A_MATERIAL, ()),
    Mode(("moves", "--young", "0.5 MPa"), OF_A_MATERIAL, ()),
    Mode(("optimize", "--spin", "2 rad/s"), typed(least="power", along="0 mm/s"), ()),
    Mode(("optimize", "--with", "measured.toml"), typed(draws="4"), ()),
    Mode(("moves",), MOVES, ("--beside",)),
    Mode(("moves", "--plot", "q.png"), typed(beside="six.json"), ()),
    Mode(("steer", "--to", "0 mm, 0 mm"), STEER, ("--goals", "--height", "--rate")),
    Mode(("steer", "--to", "0 mm, 0 mm", "--trajectory", "u.csv"), typed(rate="2 kHz", trajectory="t.mcap"), ()),
    Mode(("steer", "--to", "0 mm, 0 mm", "--out", "p.csv"), typed(out="o.json"), ()),
    Mode(("steer", "--to", "0 mm, 0 mm", "--young", "0.5 MPa"), OF_A_MATERIAL, ()),
    Mode(("steer", "--goals", "goals.csv"), typed(goals="other.csv"), ("--to",)),
    Mode(("steer", "--path", "figure of eight"),
         but(STEER, "--to", "--hold", "--method") | typed(path="L", height="30 mm"), ("--goals", "--hold", "--method")),
    Mode(("steer", "--path", "goals.csv"), typed(path="other.csv"), ("--height",)),
    Mode(("steer", "--to", "0 mm, 0 mm", "--through-pixels"),
         typed(camera_rate="60 Hz", camera_delay="10 ms", dark="1:2 s"), ("--camera-noise", "--missed")),
    Mode(("materials",), JSON),
    Mode(("scenario",), typed(print="cheese", json="")),
    Mode(("scenario", "cheese"), JSON),
    Mode(("scenario", "--print", "cheese"), MADE | typed(plate_size="150 mm", slip_limit="15 mm")),
    Mode(("scenario", "--print", "cheese", "--material", "silicone-dragon-skin-30"), OF_A_MATERIAL, ()),
    Mode(("estimate", "peak.csv"), POSTERIOR),
    Mode(("estimate", "peak.csv", "--young", "0.5 MPa"), OF_A_MATERIAL, ()),
    Mode(("estimate-all", "peak.csv", "--young", "0.5 MPa"), OF_A_MATERIAL, ()),
    Mode(("estimate", "peak.csv", "--next"),
         typed(candidate_angle="5 deg", candidate_stroke="2 mm", candidate_height="0:20 mm", candidate_phase="90 deg",
               candidate_frequency="10:20 Hz", machine="shaker.toml"), ("--coefficients",)),
    Mode(("estimate", "told.csv"), but(POSTERIOR, "--noise", "--angle")),
    Mode(("estimate", "peak.csv", "--method", "linear"),
         typed(scenario="wide.toml", angle="12 deg", stroke="2 mm", radius="50 mm", coefficients="refitted",
               out="o.toml", json="")),
    Mode(("estimate", "peak.csv", "--method", "linear", "--out", "o.toml"),
         typed(mass="10 g", _with="measured.toml"), ("--noise", "--plot", "--seed")),
    Mode(("estimate", "told.csv", "--method", "linear"), JSON, ("--angle",)),
    Mode(("estimate", "peak.csv", "--method", "any-size"),
         typed(scenario="wide.toml", angle="3.1 deg", stroke="2 mm", radius="41 mm", beta="0.6", _with="measured.toml",
               outline="rectangle 72 mm", pitch="9 mm", out="o.toml", json="")),
    Mode(("estimate", "peak.csv", "--method", "any-size", "--out", "o.toml"), typed(mass="10 g"), ("--noise",)),
    Mode(("estimate-all", "peak.csv", "few.csv"), MANY, ("--coefficients",)),
    Mode(("estimate-all", "told.csv"), but(MANY, "--noise", "--angle"), ("--noise", "--angle")),
    Mode(("estimate-all", "peak.csv", "--method", "linear"),
         typed(scenario="wide.toml", angle="12 deg", stroke="2 mm", radius="50 mm", coefficients="refitted",
               store="kept", dask="host:1", fragments="objects", out="o.csv", json=""),
         ("--beta", "--mass", "--with", "--seed")),
    Mode(("estimate-all", "peak.csv", "--method", "any-size"),
         typed(scenario="wide.toml", angle="3.1 deg", stroke="2 mm", radius="41 mm", beta="0.6", _with="measured.toml",
               store="kept", fragments="objects", out="o.csv", json=""),
         ("--coefficients", "--mass", "--noise")),
    Mode(("estimate-all", "peak.csv", "--method", "linear", "--fragments", "objects"),
         typed(mass="10 g", _with="measured.toml"), ("--noise", "--height")),
    Mode(("identify", "bending", "bending.csv"), BENDING | typed(method="regression", wall="joint"), ()),
    Mode(("identify", "bending", "bending.csv", "--method", "regression"), BENDING, ("--wall",)),
    Mode(("identify", "bending", "down.csv"), typed(y_down=""), ()),
    Mode(("identify", "bending", "angles.csv"), JSON, ("--y-down",)),
    Mode(("identify", "compression", "compression.csv"), PRESS | typed(method="regression")),
    Mode(("identify", "compression", "compression.csv", "--method", "regression"), PRESS),
    Mode(("identify", "friction", "friction.csv"), FRAGMENT),
    Mode(("identify", "modes", "modes.csv"), RING | typed(support="cantilever")),
    Mode(("identify", "modes", "modes.csv", "--support", "cantilever", "--length", "20 mm"),
         RING | typed(length="21 mm", length_sd="1 mm", mass_per_area="3 kg/m^2")),
    *(Mode(("identify", "example", kind, "o.csv"), typed(seed="4", json="")) for kind in examples.WRITERS),
    Mode(("sweep", "plan.toml"),
         typed(store="other.zarr", refine="2", repair="", dask="host:1", status="", json="")),
    Mode(("sweep", "done.toml", "--status"), JSON),
    Mode(("plot", "done.zarr"), typed(out="p.png", show="drift", json="")),
    Mode(("thesis", "fig5.7"), typed(seed="4", repeats="2", out="report", json="")),
    Mode(("thesis", "fig5.7", "--repeats", "1"), JSON, ("--seed",)),
    Mode(("thesis", "fig2.6"), typed(out="report", json="")),
    Mode(("study", "source"),
         typed(out="other", seeds="2", evaluations="40", generations="3", dask="host:1", json="")),
    *(Mode(("study", name), typed(out="other", json="")) for name in ("all", *QUESTIONS)),
    Mode(("track", "clip.mp4"), TRACK),
    Mode(("track", "clip.mp4", "--plate", "outline"), but(TRACK, "--fiducial", "--scale", "--plate")),
    Mode(("track", "clip.mp4", "--plate", "fiducials"), but(TRACK, "--scale", "--plate")),
    Mode(("track", "clip.mp4", "--plate", "scale", "--scale", "2 mm"), but(TRACK, "--fiducial", "--plate")),
    Mode(("track-folder", "clips"), FILMED | typed(frequencies="table.csv")),
    Mode(("track-folder", "clips", "--plate", "outline"), JSON, ("--fiducial", "--scale")),
    Mode(("track-strip", "strip.mp4"), typed(fps="960", duration="0.1 s", link_length="10 mm", out="o.csv", json="")),
    Mode(("target", "t.pdf"), typed(plate_size="120 mm", fiducial="10 mm", json="")),
    Mode(("shoot", "cheese", "new.mp4", "--seconds", "0.2"), SHOT),
    Mode(("shoot", "cheese", "new.mp4", "--seconds", "0.2", "--young", "0.5 MPa"), OF_A_MATERIAL, ()),
    Mode(("shoot", "cheese", "new.mp4", "--no-markers"), JSON, ("--hidden",)),
]  # fmt: skip


# The commands, and what they take


def commands() -> Iterator[tuple[Typed, object]]:
    """Every command by its words."""

    def below(command, words):
        inner = getattr(command, "commands", None)
        if inner is None:
            yield words, command
        for name, each in (inner or {}).items():
            yield from below(each, (*words, name))

    yield from below(typer.main.get_command(app), ())


COMMANDS = dict(commands())


def options_of(words: Typed) -> set[str]:
    """Options of a command, but for its help; of a switch with two names the one that is not the default."""
    found = set()
    for p in COMMANDS[words].params:
        if p.param_type_name == "option" and "--help" not in p.opts:
            found.add(p.secondary_opts[0] if p.secondary_opts and p.default else p.opts[0])
    return found


TO_TYPE = {(mode.words, name): value for mode in MODES for name, value in mode.options.items()}
EFFECTS = [pytest.param(m, name, id=" ".join((*m.typed, name))) for m in MODES for name in m.options]
REFUSALS = [
    pytest.param(m, name, id=" ".join((*m.typed, name)))
    for m in MODES
    for name in (sorted(options_of(m.words) - set(m.options) - set(m.typed)) if m.refused is None else m.refused)
]


def test_every_option_of_every_command_is_placed():
    placed = {words: {name for w, name in TO_TYPE if w == words} for words in COMMANDS}
    assert placed == {words: options_of(words) for words in COMMANDS}


def test_every_command_names_options_as_they_are_typed():
    assert all(isinstance(command, Command) for command in COMMANDS.values())


# Files to work on, and what is seen of a command


@pytest.fixture(scope="module")
def files(tmp_path_factory) -> Path:
    """Folder with a file of each kind."""
    from plategait.campaign.run import sweep
    from plategait.identify.bending.recording import read_angles
    from plategait.model.presets import preset
    from plategait.model.scenario_file import write_scenario
    from plategait.render.clip.strip import film_cantilever

    folder = tmp_path_factory.mktemp("files")
    frequency = np.arange(14.0, 29.0)
    rows = [f"{f:g},{520 / (1 + ((f - 25) / 5.2) ** 2):.6g}" for f in frequency]
    (folder / "peak.csv").write_text("\n".join(["frequency_hz,spin_rate_deg_s", *rows]))
    (folder / "few.csv").write_text("\n".join(["frequency_hz,spin_rate_deg_s", rows[0], rows[6], rows[11]]))
    rows = [f"{row},3,5" for row in rows]
    (folder / "told.csv").write_text("\n".join(["frequency_hz,spin_rate_deg_s,angle_deg,spin_rate_sd_deg_s", *rows]))
    (folder / "measured.toml").write_text(
        '[sheet]\nmass = "11 g"\n[motion]\nstroke = "2.99 mm"\n[uncertainty.sd]\n"sheet.mass" = "1 g"\n'
    )
    wide = preset("cheese").scenario.replace(**{"motion.stroke": "4 mm"})
    (folder / "wide.toml").write_text(write_scenario(wide))
    for kind, write in examples.WRITERS.items():
        write(folder / f"{kind}.csv", 0)
    seen = read_angles(folder / "bending.csv")
    table = np.column_stack([seen.time, np.degrees(seen.phi_1), np.degrees(seen.phi_2)])
    np.savetxt(folder / "angles.csv", table, "%.9g", ",", header="time_s,phi1_deg,phi2_deg", comments="")
    heading = (folder / "bending.csv").read_text().partition("\n")[0]
    table = np.loadtxt(folder / "bending.csv", delimiter=",", skiprows=1)
    table[:, [i for i, name in enumerate(heading.split(",")) if name.startswith("y")]] *= -1
    np.savetxt(folder / "down.csv", table, "%.9g", ",", header=heading, comments="")
    plan = 'scenario = "cheese"\n[set]\nduration = "0.05 s"\n[grid]\n"motion.frequency" = ["20 Hz", "24 Hz"]\n'
    (folder / "plan.toml").write_text(plan)
    sweep(folder / "plan.toml", folder / "done.zarr")
    lens = {"width": 640, "height": 480, "matrix": [[600, 0, 320], [0, 600, 240], [0, 0, 1]], "distortion": [0]}
    (folder / "lens.json").write_text(json.dumps(lens))
    (folder / "table.csv").write_text("clip,frequency_hz\n20Hz,21\n")
    (folder / "shaker.toml").write_text('x = { acceleration = "50 m/s^2" }\nrx = { angle = "4 deg" }\n')
    (folder / "six.json").write_text('{"machine": "six", "cells": [{"velocity_mm_s": [1, 2], "turn_deg_s": 3}]}')
    (folder / "goals.csv").write_text("x_mm,y_mm\n0,0\n5,0\n")
    (folder / "other.csv").write_text("x_mm,y_mm,angle_deg\n1,0,90\n0,9,\n")
    (folder / "poses.csv").write_text("time_s,x_mm,y_mm,angle_deg\n0,1,0,90\n1,0,9,\n")
    (folder / "clips").mkdir()
    film_cantilever(examples.K_B, examples.C_B, folder / "strip.mp4")
    return folder


def small_atlas() -> object:
    """An atlas of few motions."""
    from plategait.moves import atlas as making

    with pytest.MonkeyPatch.context() as patched:
        for name, value in (("POPULATION", 8), ("_FIRST", 32), ("VERIFIED", 2), ("CONFIRMED", 2)):
            patched.setattr(making, name, value)
        return making.atlas(duration=0.3, generations=1)


def small_steering() -> tuple[object, ...]:
    """A menu of one motion, and an object that lies where it is to lie, and that does not follow a path."""
    from plategait.control.follow import Following
    from plategait.control.goal import Goal
    from plategait.control.menu import Menu, drive_of
    from plategait.control.path import figure_of_eight
    from plategait.control.response import resting
    from plategait.control.room import on_a_plate
    from plategait.control.steer import Arrival, Steering
    from plategait.model.machine import machine_of

    cheese = on_a_plate("cheese")
    drive = drive_of(cheese, machine_of("source-robot"))
    still = np.zeros((2, 3))
    arrival = Arrival(Goal(0.0, 0.0), True, 0.0, 0.0, 0.0, 0, "")
    way = Steering((arrival,), np.arange(2) / 60, still, still, still, ((0.0, cheese.motion),))
    path = figure_of_eight(0.04)
    off = np.full(len(path.points), 1e-3)
    return (
        Menu(cheese, drive, (drive.base,), np.zeros((1, len(drive))), resting(), 0.05),
        way,
        Following(path, way, off, off, off),
    )


@pytest.fixture(scope="module")
def answers(files) -> dict[str, object]:
    """What the work behind the commands answers, whatever it is asked; what can be is a true answer."""
    from matplotlib.figure import Figure

    from plategait.campaign.opened import open_sweep
    from plategait.collection.collection import Outcome
    from plategait.collection.objects import Item
    from plategait.estimate.observations import Condition
    from plategait.estimate.planning import Plan
    from plategait.estimate.result import estimate_parameters
    from plategait.model.presets import preset
    from plategait.optimize.optimize import optimize_motion
    from plategait.optimize.search import Effort, Generations
    from plategait.render.clip.clip import film, usual_camera
    from plategait.simulation.run import simulate
    from plategait.study.claims import Answer, Claim, Number
    from plategait.study.evaluation import Evaluation
    from plategait.study.inference import Step
    from plategait.study.search import Learnt
    from plategait.study.source import SourceStudy
    from plategait.study.unknowns import UNKNOWNS, Choice
    from plategait.thesis.study import Study
    from plategait.vision.folder import Clip
    from plategait.vision.track import track

    cheese = preset("cheese").scenario.replace(duration=0.8, transient=0.2)
    run = simulate(cheese, snapshot_interval=cheese.motion.period / 24)
    truth = film(run, files / "clip.mp4", usual_camera(cheese, 480, 270), 30.0, seconds=0.5)
    seen = track(files / "clip.mp4")
    estimate = estimate_parameters(files / "few.csv", cheese, noise=0.1, friction_ratio=0.53, fixed="natural_frequency",
                                   model_error=0)  # fmt: skip
    menu, way, followed = small_steering()
    names = estimate.posterior.unknowns.names
    plan = Plan(Condition(0.1, 0.003, 20.0), 0.0, dict.fromkeys(names, 1.0), dict.fromkeys(names, 0.5), (), None)
    told = {"summary": estimate.summary() | {"answered": True}, "fragment": "[sheet]\n", "failure": ""}
    return {
        "plategait.collection.collection.estimate_all": (Outcome(Item("few", (files / "few.csv",)), **told),),
        "plategait.estimate.result.estimate_parameters": estimate,
        "plategait.estimate.planning.next_measurement": plan,
        "plategait.estimate.prediction.predict": None,
        "plategait.estimate.figures.plot_estimate": Figure(),
        "plategait.export.bag.check_bag": None,
        "plategait.lab.page.page": "<!doctype html>",
        "plategait.lab.opening.open_page": True,
        "plategait.export.bag.write_bag": None,
        "plategait.campaign.figures.plot_campaign": Figure(),
        "plategait.campaign.run.sweep": open_sweep(files / "done.zarr"),
        "plategait.optimize.optimize.optimize_motion": optimize_motion(
            cheese.replace(duration=0.4), effort=Effort(8, (Generations(6, 3),), test=4)
        ),
        "plategait.moves.atlas.atlas": small_atlas(),
        "plategait.moves.figures.plot_atlas": Figure(),
        "plategait.control.menu_file.kept_menu": menu,
        "plategait.control.goal.check_reach": None,
        "plategait.control.pixels.PixelCamera": None,
        "plategait.control.plant.Plant": None,
        "plategait.control.film.film_steering": None,
        "plategait.control.steer.steer": [way],
        "plategait.control.follow.follow": followed,
        "plategait.thesis.reproduce": Study((), 0.0, 0.0, 1, 0),
        "plategait.study.answers.answer_questions": [
            Answer("torsion", "Does it?", "It does.", (Claim("it does", True, Number(1.0)),), (), ())
        ],
        "plategait.study.source.study_source": SourceStudy(
            learnt=Learnt(Evaluation((Choice({}),), np.ones((1, 3, 44, 3)), np.ones(1), np.zeros((1, 5))), ()),
            steps=(Step((), "thesis", np.zeros(len(UNKNOWNS)), 1.0),),
            chosen=Step((), "thesis", np.zeros(len(UNKNOWNS)), 1.0),
            by_seed=(),
            samples=np.zeros((2, len(UNKNOWNS))),
            told=(),
            out_of_sample=(),
        ),
        "plategait.study.figures.draw_trades": Figure(),
        "plategait.vision.track.track": seen,
        "plategait.vision.folder.track_folder": [Clip(files / "clips" / "20Hz.mp4", 20.0, "told", seen)],
        "plategait.render.clip.clip.film": truth,
    }


def comparable(value: object) -> object:
    """What was asked of the work, without the clock."""
    if isinstance(value, np.ndarray):
        return hash(value.tobytes())
    if callable(value):
        return "callable"
    if isinstance(value, (tuple, list)):
        return [comparable(v) for v in value]
    if isinstance(value, dict):
        return {k: comparable(v) for k, v in value.items() if k != "wall"}
    whole = hasattr(type(value), "model_fields") or not hasattr(value, "__dict__")
    return repr(value) if whole else comparable(vars(value))


@dataclass(frozen=True)
class Seen:
    """What a command line brings about."""

    status: int
    error: str
    printed: list[str]
    written: dict[str, str]
    asked: list[object]
    whole: str = field(default="", compare=False)


@pytest.fixture
def run(files, answers, tmp_path, monkeypatch, capsys):
    """Run a command line in a folder of its own, as often as wanted."""
    asked: list[object] = []

    def stand_in(target: str):
        def ask(*given, **named):
            asked.append((target, comparable(given), comparable(named)))
            return answers[target]

        return ask

    for target in answers:
        monkeypatch.setattr(target, stand_in(target))

    def once(arguments: Typed) -> Seen:
        folder = tmp_path / str(len(list(tmp_path.iterdir())))
        folder.mkdir()
        for file in files.iterdir():
            os.symlink(file, folder / file.name)
        monkeypatch.chdir(folder)
        monkeypatch.setattr(sys, "argv", ["plategait", *arguments])
        asked.clear()
        with pytest.raises(SystemExit) as end:
            main()
        out, err = capsys.readouterr()
        # The clock, and the width that its digits give a table, differ from run to run.
        lines = [" ".join(line.replace("─", "").split()) for line in out.splitlines()]
        printed = [line for line in lines if "speed" not in line and "wall" not in line]
        new = [p for p in folder.rglob("*") if not p.is_symlink() and p.is_file()]
        text = (".csv", ".toml", ".xml")
        written = {str(p.relative_to(folder)): p.read_text() if p.suffix in text else "" for p in new}
        return Seen(end.value.code, err, printed, written, list(asked), out)

    return once


@pytest.fixture(scope="module")
def known() -> dict[Typed, Seen]:
    """What command lines were seen to bring about."""
    return {}


@pytest.mark.parametrize(("mode", "name"), EFFECTS)
def test_an_option_changes_what_comes_out(mode, name, run, known):
    if mode.typed not in known:
        known[mode.typed] = run(mode.typed)
        assert run(mode.typed) == known[mode.typed]
    seen = run((*mode.typed, *mode.options[name]))
    assert seen != known[mode.typed]
    assert "left out" not in seen.error


@pytest.mark.parametrize(("mode", "name"), REFUSALS)
def test_an_option_that_would_change_nothing_is_refused(mode, name, run):
    seen = run((*mode.typed, *TO_TYPE[mode.words, name]))
    assert seen.status == 2
    assert name in seen.error
    assert "left out" in seen.error
    assert len(seen.error.splitlines()) == 1
    assert not seen.written
    assert not seen.asked


# What is printed with --json, and where each key of it is described

DESCRIBED = (Path(__file__).parents[2] / "docs" / "reference" / "json.md").read_text(encoding="utf-8")
# Command lines that print every kind of answer that a command has.
PRINTED = [
    *(mode.typed for mode in MODES if "--json" in mode.options or "--json" in mode.typed),
    ("simulate", "--duration", "0.1 s", "--with", "measured.toml", "--draws", "2"),
    ("simulate", "--young", "0.5 MPa", "--duration", "0.1 s", "--repeats", "2"),
    ("scenario",), ("estimate", "peak.csv", "--next"), ("export", "--out", "m.mcap", "--frequency", "12 Hz"),
    ("optimize", "--free", "phase"), ("lab", "--young", "0.5 MPa", "--no-open"),
]  # fmt: skip


def keys_of(value: object, by_name: frozenset[str], of: str = "") -> Iterator[str]:
    """Every key of what was printed; of those whose keys are names of something, what lies inside these."""
    if isinstance(value, dict):
        for key, inner in value.items():
            if of not in by_name:
                yield key
            yield from keys_of(inner, by_name, "" if of in by_name else key)
    elif isinstance(value, list):
        for each in value:
            yield from keys_of(each, by_name, of)


@pytest.mark.parametrize("line", dict.fromkeys(PRINTED), ids=" ".join)
def test_every_key_of_json_is_described_where_its_command_is(line, run):
    words = " ".join(line[:2] if line[0] in ("identify", "study") else line[:1])
    sections = [part.partition("\n")[::2] for part in DESCRIBED.split("\n## ")[1:]]
    own = [text for title, text in sections if any(f"{words} ".startswith(f"{t} ") for t in title.split(", "))]
    assert own, "a section of the command's own"
    told = "".join([sections[0][1], *own])
    named = re.findall(r"^\| ((?:`[^`]+`(?:, )?)+) \|", told, re.M)
    described = {key for cell in named for key in re.findall(r"`([^`]+)`", cell)}
    by_name = frozenset(key.removesuffix(".*") for key in described if key.endswith(".*"))
    seen = run(line if "--json" in line else (*line, "--json"))
    assert seen.status in (0, 1), seen.error
    found = set(keys_of(json.loads(seen.whole), by_name))
    observables = {observable.key for observable in all_observables().values()}
    assert found - {key.removesuffix(".*") for key in described} - observables == set()
