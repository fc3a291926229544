"""Forty misuses of the package that a newcomer makes: one line each, with field, what was got, and what to type."""

from __future__ import annotations

import zipfile
from pathlib import Path

import numpy as np
import pytest

import plategait as pg
from plategait.vision.track import track

CHEESE = pg.preset("cheese").scenario
SHEET = CHEESE.sheet
DISK = pg.Disk(radius="40 mm")
JOINTS = {"mass": "13.6 g", "bending_stiffness": "3e-3 N*mm/deg", "axial_stiffness": "0.8 N/mm"}
PEAK = "frequency_hz,spin_rate_deg_s\n14,90\n18,170\n22,380\n25,520\n28,390\n30,270\n"


def frozen():
    CHEESE.duration = 2.0


# What is typed: the field, what was got, and what to type instead.
MISUSES = {
    # Outlines, sheets, materials
    "a radius without its name": (lambda: pg.Disk(40), "Disk", "40", "Disk(radius=40)"),
    "a diameter": (lambda: pg.Disk(diameter="80 mm"), "diameter", "nothing known", "radius, half of it"),
    "a list for a number": (lambda: pg.Disk(radius=["40 mm"]), "radius", "['40 mm']", '"10 mm"'),
    "a height for a width": (lambda: pg.Rectangle(length="9 mm", height="9 mm"), "height", "nothing known", "width"),
    "points for corners": (lambda: pg.Polygon(points=[(0, 0)]), "points", "nothing known", "corners"),
    "an array for a mass": (lambda: pg.Sheet(outline=DISK, **JOINTS | {"mass": np.array([13.6])}), "mass",
                            "array([13.6])", '"13.6 g"'),
    "a word for an outline": (lambda: pg.Sheet(outline="disk", **JOINTS), "outline", "'disk'",
                              '{ shape = "disk", radius = "40 mm" }'),
    "a circle": (lambda: pg.Sheet(outline={"shape": "circle"}, **JOINTS), "outline.shape", "'circle'", '"disk"'),
    "a field misspelt": (lambda: pg.Sheet(outline=DISK, **JOINTS, thikness="1 mm"), "thikness", "nothing known",
                         "thickness"),
    "a thickness in mm": (lambda: SHEET.replace(thickness=2.5), "thickness", "'2.5 m, as a bare", '"2.5 mm"'),
    "a thickness of 1": (lambda: pg.Sheet.from_material(DISK, "0.5 MPa", 1, "1100 kg/m^3"), "thickness", "'1 m, as",
                         '"1 mm"'),
    "a modulus in MPa": (lambda: pg.Material(young_modulus=0.5), "young_modulus", "'0.5 Pa, as a bare", '"0.5 MPa"'),
    "a material by half its name": (lambda: pg.named_material("cheddar"), "material", "'cheddar'", "cheddar-"),
    # Motions and scenarios
    "an angle of 1": (lambda: pg.PlateMotion(angle=1), "angle", "'1 rad, as a bare number is SI'", '"1 deg"'),
    "a phase in degrees": (lambda: pg.Wave(axis="x", amplitude="3 mm", phase=90), "phase", "'90 rad, as", '"90 deg"'),
    "one wave for a list": (lambda: pg.PlateMotion(waves=pg.Wave(axis="rx", amplitude="3 deg")), "waves", "'one alone'",
                            "waves=[…]"),
    "a decimal comma": (lambda: pg.PlateMotion(frequency="24,5 Hz"), "frequency", "'24,5 Hz'", '"24.5 Hz"'),
    "a coefficient for friction": (lambda: pg.Scenario(sheet=SHEET, friction=0.5), "friction", "0.5",
                                   '{ static = "0.75" }'),
    "coefficients without names": (lambda: pg.Friction(0.75, 0.4), "Friction", "0.75", "Friction(static=0.75)"),
    "a preset's name for a sheet": (lambda: pg.Scenario(sheet="cheese"), "sheet", "'cheese'", "{ outline = "),
    "a scenario changed in place": (frozen, "duration", "2.0", ".replace(duration=…)"),
    "a machine's field cut short": (lambda: pg.Machine(x={"accel": 50}), "x.accel", "nothing known", "acceleration"),
    # Runs and curves
    "a sheet for a scenario": (lambda: pg.simulate(SHEET), "scenarios", "'a Sheet'", "Scenario(sheet=…)"),
    "a list for a scenario": (lambda: pg.simulate([CHEESE]), "scenarios", "'a list'", "cheese, or simulate_all"),
    "text for a count": (lambda: pg.simulate(CHEESE, repeats="3"), "repeats", "'3'", "4"),
    "a scenario's option of a run": (lambda: pg.simulate(CHEESE, frequency="24 Hz"), "frequency", "nothing known",
                                     'scenario.replace(**{"motion.frequency": "24 Hz"})'),
    "one frequency for a curve": (lambda: pg.spin_curve(CHEESE, 24), "frequencies", "24", '"24, 24 Hz"'),
    "a workbook": (lambda: pg.read_curve("lab.xlsx"), "curve", "'lab.xlsx (a workbook", "saving the sheet as lab.csv"),
    "a number for a file": (lambda: pg.read_curve(3), "curve", "3", '"table.csv"'),
    "a run for a curve": (lambda: pg.write_curve(CHEESE, "c.csv"), "curve", "'a Scenario'", "spin_curve(scenario"),
    "words for rates": (lambda: pg.fit_lorentzian([1, 2], ["a", "b"]), "rate", "['a', 'b']", "[20.0"),
    # Estimates, campaigns, machines, films
    "a file for a posterior": (lambda: pg.next_measurement("peak.csv"), "posterior", "'peak.csv'",
                               "estimate_parameters(…).posterior"),
    "an amplitude for motions": (lambda: pg.estimate_parameters("peak.csv", CHEESE, motions="3 deg"), "motions",
                                 "'3 deg'", "[scenario.motion]"),
    "a seed of 1.5": (lambda: pg.estimate_parameters("peak.csv", CHEESE, seed=1.5), "seed", "1.5", "4"),
    "a scenario for a plan": (lambda: pg.sweep(CHEESE, "s.zarr"), "plan", "'a Scenario'", "examples/sweep.toml"),
    "a number for a store": (lambda: pg.open_sweep(3), "store", "3", '"sweep.zarr"'),
    "a scenario for a motion": (lambda: pg.needs(CHEESE, "source-robot"), "motion", "'a Scenario'", "scenario.motion"),
    "a motion for a trajectory": (lambda: pg.write_trajectory(CHEESE.motion, "m.csv"), "trajectory", "'a PlateMotion'",
                                  "trajectory(scenario.motion)"),
    "a spin of 300": (lambda: pg.Goal(spin=300), "spin", "'300 rad/s, as a bare number is SI'", '"300 deg/s"'),
    "nought for a goal": (lambda: pg.optimize_motion(CHEESE, goal=0), "goal", "0", "Goal(spin="),
    "a word for a goal": (lambda: pg.optimize_motion(CHEESE, goal="fast"), "goal", "'fast'", "Goal(spin="),
    "a range misspelt": (lambda: pg.optimize_motion(CHEESE, ranges={"frequncy": (1, 2)}), "frequncy", "nothing known",
                         "frequency"),
    "a function for an observable": (lambda: pg.add_observable(len), "observable", "'a builtin_function",
                                     "Observable(name, unit, long_name, measure)"),
    "a scenario for a run": (lambda: pg.dataset_of(CHEESE), "simulation", "'a Scenario'", "simulate(scenario)"),
    "a sheet for a file": (lambda: pg.write_scenario(SHEET), "scenario", "'a Sheet'", 'preset("cheese").scenario'),
    "a number for a film": (lambda: track(3.5), "video", "3.5", "clip.mp4"),
}  # fmt: skip


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("misuse")
    (folder / "peak.csv").write_text(PEAK)
    with zipfile.ZipFile(folder / "lab.xlsx", "w") as workbook:
        workbook.writestr("xl/workbook.xml", "<workbook/>")
    return folder


@pytest.mark.parametrize("misuse", MISUSES)
def test_a_misuse_is_one_line_that_says_what_to_type(misuse, folder, monkeypatch):
    typed, field, got, instead = MISUSES[misuse]
    monkeypatch.chdir(folder)
    before = sorted(folder.iterdir())
    with pytest.raises(pg.InputError) as caught:
        typed()
    said = str(caught.value)
    assert said.isprintable()
    assert said.startswith(f"{field}: got {got}")
    assert ", must be " in said
    assert said.partition("; try ")[2].startswith(instead)
    assert sorted(folder.iterdir()) == before


def test_what_takes_a_number_takes_text_with_its_unit():
    assert pg.Goal(spin="300 deg/s", along="100 mm/s") == pg.Goal(spin=np.radians(300.0), along=0.1)
    assert pg.mjcf("cheese") == pg.mjcf(CHEESE)
    named, given = (pg.needs(CHEESE.motion, machine) for machine in ("source-robot", pg.MACHINES["source-robot"]))
    assert (named.peaks == given.peaks).all()


def test_a_name_that_there_is_not_is_pointed_to_the_nearest():
    with pytest.raises(AttributeError, match=r"no attribute 'simulte'; try plategait\.simulate$"):
        _ = pg.simulte
