"""Scenario files: written, read back the same, and refused by name where they are wrong."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

from plategait.errors import InputError
from plategait.model.contact import Contact, Friction
from plategait.model.motion import AXES, PlateMotion, Samples, Wave
from plategait.model.outline import Disk, Ellipse, Mask, Polygon, Rectangle
from plategait.model.presets import PRESETS, preset
from plategait.model.scenario import Plate, Scenario, Start
from plategait.model.scenario_file import read_scenario, write_scenario
from plategait.model.sheet import Sheet

CHEESE = preset("cheese").scenario


def through_file(scenario: Scenario, path) -> Scenario:
    path.write_text(write_scenario(scenario), encoding="utf-8")
    return read_scenario(path)


@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_comes_back_the_same(name, tmp_path):
    found = preset(name)
    path = tmp_path / "p.toml"
    path.write_text(write_scenario(found.scenario, notes=found.notes), encoding="utf-8")
    assert read_scenario(path) == found.scenario
    assert through_file(found.scenario, path) == found.scenario


@pytest.mark.parametrize("name", PRESETS)
def test_a_printed_preset_says_where_its_numbers_come_from(name):
    found = preset(name)
    lines = write_scenario(found.scenario, notes=found.notes).splitlines()
    assert any("published: " in line for line in lines)
    assert any("inferred: " in line for line in lines)
    for dotted, remark in found.notes.items():
        field = dotted.split(".")[-1]
        assert any(line.startswith(f"{field} = ") and remark in line for line in lines), dotted


# Random scenarios. Sizes keep the lattices small.
lengths = st.floats(0.02, 0.06)
offsets = st.floats(-0.05, 0.05)
angles = st.floats(-7, 7)


def cells(rows: int, columns: int):
    # A full bottom row keeps every mask in one piece; full columns from there up keep it in one piece at every pitch.
    heights = st.lists(st.integers(1, rows), min_size=columns, max_size=columns)
    return heights.map(
        lambda h: tuple("".join("#" if h[c] >= rows - r else "." for c in range(columns)) for r in range(rows))
    )


outlines = st.one_of(
    st.builds(Disk, radius=lengths),
    st.builds(Ellipse, length=lengths, width=lengths),
    st.builds(Rectangle, length=lengths, width=lengths),
    st.tuples(lengths, lengths, offsets).map(
        lambda t: Polygon(corners=((t[2], 0), (t[2] + t[0], 0), (t[2] + t[0], t[1]), (t[2], t[1])))
    ),
    cells(3, 4).map(lambda rows: Mask(width_of_picture=0.04, rows=rows)),
)
# Every text that TOML can hold.
names = st.text(st.characters(exclude_categories=["Cs"]), max_size=12)
sheets = st.builds(
    Sheet, name=names, outline=outlines, mass=st.floats(1e-3, 0.1), pitch=st.just(0.005),
    thickness=st.floats(1e-4, 1e-2), bending_stiffness=st.floats(0, 1e-2), bending_damping=st.floats(0, 1e-6),
    axial_stiffness=st.floats(1, 1e5), axial_damping=st.floats(0, 1), torsion_stiffness=st.floats(0, 1e-2),
    shear_ratio=st.floats(0.1, 100),
)  # fmt: skip
waves = st.builds(
    Wave, axis=st.sampled_from(AXES), amplitude=st.floats(-0.1, 0.1), ratio=st.floats(0.1, 5), phase=angles
)


@st.composite
def samples(draw):
    steps = draw(st.lists(st.floats(1e-3, 1), min_size=1, max_size=5))
    time = [0.0]
    for step in steps:
        time.append(time[-1] + step)
    values = {
        axis: tuple(draw(st.lists(offsets, min_size=len(time), max_size=len(time))))
        for axis in draw(st.sets(st.sampled_from(AXES), max_size=3))
    }
    return Samples(time=tuple(time), **values)


motions = st.builds(
    PlateMotion, frequency=st.floats(0.1, 100), angle=st.floats(-1.5, 1.5), stroke=offsets, ramp=st.floats(0, 1),
    waves=st.lists(waves, max_size=3), samples=st.none() | samples(),
)  # fmt: skip
frictions = st.tuples(st.floats(0, 2), st.floats(0, 1), st.floats(1e-3, 1), st.sampled_from(["thesis", "adams"])).map(
    lambda t: Friction(static=t[0], kinetic=t[0] * t[1], transition_speed=t[2], law=t[3])
)
contacts = st.builds(Contact, stiffness=st.floats(1, 1e6), damping=st.floats(0, 1e3), damping_ramp=st.floats(0, 1e-3))


@st.composite
def scenarios(draw):
    duration = draw(st.floats(0.1, 100))
    share = draw(st.none() | st.floats(0, 0.9))
    sheet = draw(sheets)
    step = draw(st.none() | st.floats(0.5, 1))
    return Scenario(
        name=draw(names), sheet=sheet, motion=draw(motions), contact=draw(contacts), friction=draw(frictions),
        start=draw(st.builds(Start, x=offsets, y=offsets, angle=angles)), duration=duration,
        plate=draw(st.none() | st.builds(Plate, length=lengths, width=lengths)), gravity=draw(st.floats(0, 30)),
        slip_limit=draw(st.floats(1e-3, 1)), transient=None if share is None else share * duration,
        time_step=None if step is None else min(1e-4, step * sheet.stable_time_step),
    )  # fmt: skip


@settings(deadline=None, max_examples=60)
@given(scenario=scenarios())
def test_any_scenario_comes_back_the_same(scenario, tmp_path_factory):
    back = through_file(scenario, tmp_path_factory.getbasetemp() / "any.toml")
    assert back == scenario
    assert back.dt == scenario.dt


@pytest.mark.parametrize(
    "name", ['a "b"', "a\\b", "a\nb", "a\r\nb", "tab\t", "\x00\x1f\x7f", "# no comment", "é π 漢", "'"]
)
def test_any_name_comes_back_the_same(name, tmp_path):
    assert through_file(CHEESE.replace(name=name), tmp_path / "n.toml").name == name


# Files that a scenario names


def mask_scenario(folder, image: str):
    (folder / "leaf.toml").write_text(
        f"""
[sheet]
outline = {{ shape = "mask", image = "{image}", width_of_picture = "40 mm" }}
mass = "5 g"
bending_stiffness = 1e-4
axial_stiffness = "1 N/mm"
[motion]
samples = "motion.csv"
""",
        encoding="utf-8",
    )
    Image.new("L", (4, 4), 0).save(folder / "leaf.png")
    (folder / "motion.csv").write_text("time_s,z_mm\n0,0\n0.5,1\n1,0\n")
    return folder / "leaf.toml"


def test_named_files_count_from_the_scenario(tmp_path, monkeypatch):
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    path = mask_scenario(folder, "leaf.png")
    for cwd, name in ((tmp_path, "elsewhere/leaf.toml"), (folder, "leaf.toml"), (tmp_path, str(path))):
        monkeypatch.chdir(cwd)
        scenario = read_scenario(name)
        assert scenario.sheet.lattice.n_nodes == 16
        assert scenario.motion.samples is not None
        assert scenario.motion.samples.z == pytest.approx((0, 1e-3, 0))


def test_an_absolute_name_stays(tmp_path):
    path = mask_scenario(tmp_path, str(tmp_path / "leaf.png"))
    assert read_scenario(path).sheet.lattice.n_nodes == 16


@pytest.mark.parametrize("copy", ["elsewhere/copy.toml", "copy.toml"])
def test_a_scenario_with_a_picture_is_written_so_that_it_reads_back(tmp_path, monkeypatch, copy):
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    mask_scenario(folder, "leaf.png")
    monkeypatch.chdir(tmp_path)
    scenario = read_scenario("elsewhere/leaf.toml")
    assert through_file(scenario, tmp_path / copy) == scenario


def test_a_missing_picture_or_motion_is_named(tmp_path):
    path = mask_scenario(tmp_path, "tree.png")
    with pytest.raises(InputError) as caught:
        read_scenario(path)
    assert caught.value.field == "sheet.outline.image"
    assert "tree.png" in str(caught.value.got)
    path = mask_scenario(tmp_path, "leaf.png")
    (tmp_path / "motion.csv").unlink()
    with pytest.raises(InputError) as caught:
        read_scenario(path)
    assert caught.value.field == "motion.samples"


# Files that are wrong


@pytest.mark.parametrize("spoil", ["missing", "folder", "latin", "not toml", "twice"])
def test_a_file_that_is_no_toml_is_refused(tmp_path, spoil):
    path = tmp_path / "s.toml"
    if spoil == "folder":
        path.mkdir()
    elif spoil == "latin":
        path.write_bytes('name = "Käse"\n'.encode("latin-1"))
    elif spoil == "not toml":
        path.write_text("name = \n")
    elif spoil == "twice":
        path.write_text("name = 'a'\nname = 'b'\n")
    with pytest.raises(InputError) as caught:
        read_scenario(path)
    assert caught.value.field == "scenario"
    assert "s.toml" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_file_with_a_byte_order_mark_is_read(tmp_path):
    path = tmp_path / "s.toml"
    path.write_text(write_scenario(CHEESE), encoding="utf-8-sig")  # what some editors write
    assert read_scenario(path) == CHEESE


def test_an_empty_file_lacks_its_sheet(tmp_path):
    path = tmp_path / "s.toml"
    path.write_text("")
    with pytest.raises(InputError) as caught:
        read_scenario(path)
    assert caught.value.field == "sheet"


@pytest.mark.parametrize(
    ("table", "line", "field"),
    [
        ("", "durration = 3", "durration"),
        ("[sheet]", "masss = 3", "sheet.masss"),
        ("[sheet.outline]", "radus = 3", "sheet.outline.radus"),
        ("[sheet.outline]", "disk = 3", "sheet.outline.disk"),
        ("[motion]", "frequenzy = 3", "motion.frequenzy"),
        ("[motion]", 'waves = [{ axis = "x", amplitude = 0.1, fase = 1 }]', "motion.waves.0.fase"),
        ("[motion]", "samples = { time = [0, 1], u = [0, 1] }", "motion.samples.u"),
        ("[contact]", "sticky = true", "contact.sticky"),
        ("[friction]", "mu = 1", "friction.mu"),
        ("[start]", "z = 1", "start.z"),
        ("[motion]", 'waves = [{ axis = "x", amplitude = "3 deg" }]', "motion.waves.0.amplitude"),
        ("[motion]", "samples = { time = [0, 1], x = [0] }", "motion.samples.x"),
        ("[friction]", "", None),
    ],
)
def test_an_unknown_or_wrong_key_is_named_at_any_depth(tmp_path, table, line, field):
    path = tmp_path / "s.toml"
    text = write_scenario(CHEESE)
    path.write_text(text.replace(f"{table}\n", f"{table}\n{line}\n", 1) if table else f"{line}\n{text}")
    if field is None:
        assert read_scenario(path) == CHEESE
        return
    with pytest.raises(InputError) as caught:
        read_scenario(path)
    assert caught.value.field == field
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("bad", ["nan", "inf", "true", "[]", "{ a = 1 }", "2024-01-01", '"3 parsecs^5"'])
def test_a_wrong_value_is_named(tmp_path, bad):
    path = tmp_path / "s.toml"
    lines = write_scenario(CHEESE).splitlines()
    for at, key in ((at, line.split(" = ")[0]) for at, line in enumerate(lines) if '= "' in line):
        if key in ("name", "law") and bad.startswith('"'):
            continue
        path.write_text("\n".join([*lines[:at], f"{key} = {bad}", *lines[at + 1 :]]))
        with pytest.raises(InputError) as caught:
            read_scenario(path)
        assert caught.value.field.split(".")[-1] == key
        assert "\n" not in str(caught.value)


def test_text_units_and_bare_si_numbers_are_the_same_scenario(tmp_path):
    path = tmp_path / "s.toml"
    sheet = "[sheet]\noutline = {{ shape = 'disk', radius = {} }}\nmass = {}\npitch = {}\n" + (
        "bending_stiffness = {}\naxial_stiffness = {}\n[motion]\nangle = {}\n"
    )
    path.write_text(sheet.format("'40 mm'", "'13.6 g'", "'1 cm'", "'1.56e-4 N*m/rad'", "'790 N/m'", "'90 deg'"))
    a = read_scenario(path)
    path.write_text(sheet.format(0.04, 0.0136, 0.01, 1.56e-4, 790, math.pi / 2))
    b = read_scenario(path)
    assert a.sheet.mass == pytest.approx(b.sheet.mass, rel=1e-15)
    assert a.sheet.pitch == b.sheet.pitch
    assert a.sheet.bending_stiffness == b.sheet.bending_stiffness
    assert a.motion.angle == b.motion.angle


def test_a_scenario_is_written_to_a_file(tmp_path):
    text = write_scenario(CHEESE, tmp_path / "nb.toml", {"sheet.mass": "weighed"})
    assert (tmp_path / "nb.toml").read_text(encoding="utf-8") == text
    assert "weighed" in text
    assert read_scenario(tmp_path / "nb.toml") == CHEESE
    with pytest.raises(InputError, match="path"):
        write_scenario(CHEESE, {"sheet.mass": "weighed"})  # type: ignore[arg-type]
    with pytest.raises(InputError, match=r"\.toml"):
        write_scenario(CHEESE, tmp_path / "nb.txt")
