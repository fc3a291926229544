"""A sheet of a material, of another modulus, density or thickness: as if it had been made so from the beginning."""

from __future__ import annotations

import pytest

import plategait as pg
from plategait.model.parameters import find_parameter, value_of, with_values
from plategait.model.remade import material_of
from plategait.model.scenario_file import read_scenario

OUTLINE = pg.Disk(radius="30 mm")
TOLD = {"young_modulus": 5e5, "thickness": 1e-3, "density": 1100.0, "poisson_ratio": 0.4, "loss_factor": 0.1}
NAMES = {"sheet.young_modulus": 2e5, "sheet.thickness": 2.5e-3, "sheet.density": 900.0}


def of(**changed: float) -> pg.Sheet:
    return pg.Sheet.from_material(OUTLINE, **TOLD | changed)


def scenario(sheet: pg.Sheet) -> pg.Scenario:
    return pg.Scenario(sheet=sheet, duration=0.5)


@pytest.mark.parametrize("names", [[name] for name in NAMES] + [list(NAMES)], ids=str)
def test_a_sheet_made_anew_is_the_one_made_so_from_the_beginning(names):
    changed = with_values(scenario(of()), {name: NAMES[name] for name in names}).sheet
    wanted = of(**{name.partition(".")[2]: NAMES[name] for name in names})
    for name in pg.Sheet.model_fields:
        if isinstance(value := getattr(wanted, name), float):
            # Rounding, of an eigenvalue problem among others.
            assert getattr(changed, name) == pytest.approx(value, rel=1e-8), name
    assert changed.outline == wanted.outline


@pytest.mark.parametrize("nu", [-0.5, 0.0, 0.3, 0.5])
def test_joints_tell_the_material(nu):
    made = material_of(of(poisson_ratio=nu))
    assert (made.young_modulus, made.density) == pytest.approx((5e5, 1100.0), rel=1e-12)
    assert made.poisson_ratio == pytest.approx(nu, abs=1e-12)


def test_a_file_keeps_enough_of_the_joints_to_tell_it(tmp_path):
    (tmp_path / "mine.toml").write_text(pg.write_scenario(scenario(of())))
    read = read_scenario(tmp_path / "mine.toml")
    assert value_of(read, "sheet.young_modulus") == pytest.approx(5e5, rel=1e-9)
    assert with_values(read, {"sheet.young_modulus": "1 MPa"}).sheet.bending_stiffness == pytest.approx(
        2 * read.sheet.bending_stiffness, rel=1e-9
    )


def test_what_is_of_no_material_has_no_modulus_and_keeps_its_thickness_for_show():
    cheese = pg.preset("cheese").scenario
    assert material_of(cheese.sheet) is None
    for name in ("sheet.young_modulus", "sheet.density"):
        with pytest.raises(pg.InputError, match=r"joints are those of no material.*natural_frequency"):
            find_parameter(name, cheese)
    assert with_values(cheese, {"sheet.thickness": 1e-3}).sheet == cheese.sheet.replace(thickness=1e-3)


def test_a_weighed_mass_or_a_measured_joint_beside_it_holds():
    changed = with_values(scenario(of()), {"sheet.thickness": "2 mm", "sheet.mass": "5 g"}).sheet
    assert changed.mass == 5e-3
    assert changed.bending_stiffness == pytest.approx(of(thickness=2e-3).bending_stiffness, rel=1e-12)


def test_a_modulus_beside_the_frequency_that_follows_is_refused():
    with pytest.raises(pg.InputError, match="left out beside natural_frequency"):
        with_values(scenario(of()), {"sheet.young_modulus": 1e6, "natural_frequency": 10.0})


def test_a_plan_sweeps_the_modulus():
    plan = pg.Sweep(scenario=scenario(of()), grid={"sheet.young_modulus": ["0.1 MPa", "1 MPa"]})
    soft, stiff = (plan.at({"sheet.young_modulus": value}).sheet for value in (1e5, 1e6))
    assert stiff.bending_stiffness == pytest.approx(10 * soft.bending_stiffness, rel=1e-12)
    assert plan.parameters[0].text_of(1e5) == "0.1 MPa"
