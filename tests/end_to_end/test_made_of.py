"""Objects typed by what they are cut to and made of: as in Python and in files, and refused where they clash."""

from __future__ import annotations

import json
import math

import pytest

import plategait as pg
from plategait.model.presets import preset
from plategait.model.scenario_file import read_scenario

CORNERS = ((0.0, 0.0), (0.08, 0.0), (0.06, 0.06), (0.01, 0.05))
SILICONE = (
    "--outline", "corners.csv", "--pitch", "5 mm", "--mass", "5 g", "--young", "0.5 MPa", "--thickness", "1 mm",
    "--poisson", "0.5", "--loss-factor", "0.1", "--plate-size", "150 mm",
)  # fmt: skip


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "corners.csv").write_text("x_mm,y_mm\n" + "".join(f"{1e3 * x:g},{1e3 * y:g}\n" for x, y in CORNERS))
    return tmp_path


def silicone():
    sheet = pg.Sheet.from_material(
        pg.Polygon(corners=CORNERS), "0.5 MPa", "1 mm", mass="5 g", pitch="5 mm", poisson_ratio=0.5, loss_factor=0.1
    )
    return preset("cheese").scenario.replace(
        name="sheet", sheet=sheet, plate=pg.Plate(length=0.15, width=0.15), slip_limit=math.hypot(0.15, 0.15)
    )


def test_a_polygon_of_silicone_on_a_finite_plate_is_typed_in_a_line(called, folder):
    printed = called("scenario", "--print", "cheese", *SILICONE, cwd=folder, check=0).stdout
    (folder / "mine.toml").write_text(printed, encoding="utf-8")
    assert read_scenario(folder / "mine.toml") == silicone()
    assert "D of E = 0.5 MPa, h = 1 mm, ν = 0.5, η = 0.1" in printed
    assert "published: Table 4.1" not in printed.partition("[contact]")[0]
    typed = json.loads(called("simulate", *SILICONE, "--duration", "0.3 s", "--json", cwd=folder, check=0).stdout)
    run = pg.simulate(silicone().replace(duration=0.3)).summary()
    assert typed["spin_rate_deg_s"] == run["spin_rate_deg_s"]
    taken, sheet = typed["taken"]
    assert taken == (
        "taken, as nobody told otherwise: friction 0.75/0.40 from 60 mm/s on as for the preset cheese, "
        "contact as for the preset cheese, "
        "no limit of slip below the plate's diagonal, 212 mm: its edge decides (--slip-limit for one)"
    )
    made = silicone().sheet
    nodes = made.lattice.n_nodes
    # 25 mm² a node, 1 mm thick.
    assert sheet == f"sheet: 5 g over {nodes / 4:.4g} cm² ({nodes} nodes): {5e-3 / (nodes * 25e-9):,.0f} kg/m³ at 1 mm"


def test_a_file_that_tells_no_friction_is_said_to_take_the_cheeses(called, tmp_path):
    (tmp_path / "mine.toml").write_text(
        '[sheet]\nthickness = "2 mm"\nmaterial = "silicone-dragon-skin-30"\n'
        '[sheet.outline]\nshape = "disk"\nradius = "30 mm"\n'
    )
    said = called("simulate", "mine.toml", "--duration", "0.1 s", cwd=tmp_path, check=0).stdout
    assert (
        "friction 0.75/0.40 from 100 mm/s on as for the slice of cheese, contact as for the slice of cheese, no damping"
        in said
    )
    said = called("simulate", "mine.toml", "--duration", "0.1 s", "--mu-s", "0.5", cwd=tmp_path, check=0).stdout
    assert "friction" not in said.partition("taken")[2]


@pytest.mark.parametrize(
    ("typed", "nodes"),
    [("disk 40 mm", 52), ("rectangle 60 mm x 40 mm", 24), ("ellipse 90x50 mm", 37), ("rectangle 0.04", 16)],
)
def test_shapes_are_typed_as_words(typed, nodes, called, tmp_path):
    printed = called("scenario", "--print", "cheese", "--outline", typed, cwd=tmp_path, check=0).stdout
    (tmp_path / "mine.toml").write_text(printed, encoding="utf-8")
    sheet = read_scenario(tmp_path / "mine.toml").sheet
    assert sheet.lattice.n_nodes == nodes
    # The same slice cut anew: its mass per area stays.
    assert sheet.node_mass == pytest.approx(preset("cheese").scenario.sheet.node_mass, rel=1e-9)


def test_a_picture_is_typed_with_its_width(called, tmp_path):
    from PIL import Image

    picture = Image.new("L", (40, 20), 255)
    picture.paste(0, (5, 5, 35, 15))
    picture.save(tmp_path / "my leaf.png")
    printed = called("scenario", "--print", "cheese", "--outline", "my leaf.png 80 mm", cwd=tmp_path, check=0).stdout
    (tmp_path / "mine.toml").write_text(printed, encoding="utf-8")
    assert read_scenario(tmp_path / "mine.toml").sheet.lattice.n_nodes == 12


def test_materials_are_listed_with_their_sources(called, tmp_path):
    listed = json.loads(called("materials", "--json", cwd=tmp_path, check=0).stdout)["materials"]
    assert [row["name"] for row in listed] == list(pg.MATERIALS)
    table = called("materials", cwd=tmp_path, check=0).stdout
    assert all(name in table for name in pg.MATERIALS)
    assert "Smooth-On" in table


YOUNG = ("--young", "0.5 MPa")
MISUSES = {
    "modulus without a unit": (("--young", "0.5"), "--young", '"0.5 MPa"'),
    "modulus in another unit": (("--young", "0.5 mm"), "--young", '"0.5 MPa"'),
    "modulus and sheet": ((*YOUNG, "--sheet", "pancake"), "--sheet", "left out"),
    "modulus and frequency": ((*YOUNG, "--natural-frequency", "5 Hz"), "--natural-frequency", "left out"),
    "mass and density": ((*YOUNG, "--mass", "5 g", "--density", "1100 kg/m^3"), "--density", "one of the two"),
    "both dampings": ((*YOUNG, "--loss-factor", "0.1", "--damping-ratio", "0.1"), "--damping-ratio", "loss_factor"),
    "ratio too large": ((*YOUNG, "--poisson", "0.7"), "--poisson", "0.3"),
    "thickness alone": (("--thickness", "1 mm"), "--thickness", "--young"),
    "new outline without a mass": (("--outline", "disk 30 mm", *YOUNG), "--density", "--mass"),
    "unknown material": (("--material", "silicon dragon skin 30"), "--material", "silicone-dragon-skin-30"),
    "unknown shape": (("--outline", "disc 40 mm"), "--outline", '"disk 40 mm"'),
    "a shape without a size": (("--outline", "disk"), "--outline", '"disk 40 mm"'),
    "a size that is none": (("--outline", "rectangle a x b"), "--outline", "100 mm"),
    "no such corners": (("--outline", "none.csv"), "--outline", "x_mm,y_mm"),
    "no such picture": (("--outline", "none.png 70 mm"), "none.png", "leaf.png"),
    "corners without headings": (("--outline", "bare.csv"), "--outline", "x_mm,y_mm as the first line"),
    "corners without a unit": (("--outline", "xy.csv"), "--outline", "x_mm,y_mm as the first line"),
    "a corner too far off": (("--outline", "far.csv"), "far.csv line 4, y", "11000 mm"),
    "corners on a line": (("--outline", "line.csv"), "--outline", "[["),
    "pitch too fine": (("--outline", "corners.csv", "--pitch", "0.01 mm"), "--pitch", '"0.8 mm"'),
    "plate of no size": (("--plate-size", "0 mm"), "--plate-size", "100 mm"),
}


@pytest.mark.parametrize("misuse", MISUSES)
def test_a_misuse_is_one_line_that_says_what_to_type(misuse, called, folder):
    typed, option, instead = MISUSES[misuse]
    (folder / "line.csv").write_text("x_mm,y_mm\n0,0\n10,10\n20,20\n")
    (folder / "bare.csv").write_text("0,0\n80,0\n60,60\n")
    (folder / "xy.csv").write_text("x,y\n0,0\n80,0\n60,60\n")
    (folder / "far.csv").write_text("x_mm,y_mm\n0,0\n80,0\n60,11000\n")
    done = called("simulate", *typed, cwd=folder, check=2)
    assert len(done.stderr.splitlines()) == 1
    assert option in done.stderr
    assert instead in done.stderr
    assert not done.stdout


def test_a_density_that_nothing_has_is_warned_of(called, folder):
    said = called("simulate", "--outline", "disk 40 mm", "--mass", "5 kg", "--young", "0.5 MPa", "--thickness", "1 mm",
                  "--duration", "0.02 s", cwd=folder, check=0).stdout  # fmt: skip
    assert "warning: 961,538 kg/m³ is beyond 20 (foam) to 25,000 kg/m³" in said  # 5 kg over 52 cm² of 1 mm
    usual = called("simulate", "--outline", "disk 40 mm", "--duration", "0.02 s", cwd=folder, check=0).stdout
    assert "warning" not in usual


SLIPPERY = ("simulate", "cheese", "--mu-s", "0", "--angle", "40 deg", "--frequency", "1 Hz")


def test_the_edge_of_a_plate_decides_unless_a_limit_of_slip_is_told(called, folder):
    bare = called(*SLIPPERY, "--duration", "1 s", cwd=folder, check=1).stdout
    assert "slipped by more than 10 mm at 0." in bare
    assert "; --slip-limit to allow more" in bare
    off = called(*SLIPPERY, "--duration", "1 s", "--plate-size", "100 mm", cwd=folder, check=1).stdout
    assert "left the plate at 0." in off
    assert "slip-limit to allow more" not in off
    assert "no limit of slip below the plate's diagonal, 141 mm" in off.replace("\n", " ")
    both = ("--plate-size", "100 mm", "--slip-limit", "15 mm")
    on_the_way = called(*SLIPPERY, "--duration", "1 s", *both, cwd=folder, check=1).stdout
    assert "(slipped by more than 15 mm on the way, at 0." in on_the_way
    told = json.loads(called(*SLIPPERY, "--duration", "1 s", *both, "--json", cwd=folder, check=1).stdout)
    assert told["failure"] == "left the plate"
    assert told["first_sign_s"] < told["failure_time_s"]
    assert "taken" not in told


def test_a_file_keeps_the_limit_of_slip_that_it_tells(called, folder):
    text = 'slip_limit = "12 mm"\nsheet = {sheet}\n[motion]\nfrequency = "1 Hz"\nangle = "40 deg"\n'
    sheet = ('{ outline = { shape = "disk", radius = "40 mm" }, mass = "13.6 g", '
             'bending_stiffness = "2.72e-3 N*mm/deg", axial_stiffness = "0.79 N/mm" }')  # fmt: skip
    (folder / "told.toml").write_text(text.format(sheet=sheet))
    (folder / "untold.toml").write_text(text.format(sheet=sheet).partition("\n")[2])
    typed = ("--mu-s", "0", "--duration", "1 s", "--plate-size", "100 mm")
    assert "by more than 12 mm" in called("simulate", "told.toml", *typed, cwd=folder, check=1).stdout
    assert "by more than" not in called("simulate", "untold.toml", *typed, cwd=folder, check=1).stdout


def test_a_curve_says_which_slip_its_failures_are_beyond(called, folder):
    typed = ("curve", "cheese", "--mu-s", "0", "--angle", "40 deg", "--frequency", "1:2:1Hz", "--duration", "1 s")
    said = called(*typed, "--slip-limit", "11 mm", cwd=folder, check=1).stdout
    assert "slipped: by more than 11 mm; --slip-limit to allow more" in said


def test_modes_are_headed_by_the_scenarios_name(called, folder):
    printed = called("scenario", "--print", "cheese", *SILICONE, cwd=folder, check=0).stdout
    (folder / "sil.toml").write_text(printed.replace('name = "sheet"', 'name = "pentagon 5"', 1), encoding="utf-8")
    assert called("modes", "sil.toml", cwd=folder, check=0).stdout.startswith("pentagon 5: free-vibration modes")
    assert json.loads(called("modes", "sil.toml", "--json", cwd=folder, check=0).stdout)["sheet"] == "pentagon 5"
    assert called("modes", "cheese", "--sheet", "pancake", cwd=folder, check=0).stdout.startswith("pancake: ")
