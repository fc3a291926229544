"""The lab's page in a browser, as a person uses it: every control, what it refuses; share, compare, undo, drop."""

from __future__ import annotations

import math
import re
import time
from pathlib import Path

import pytest
from lab_tab import Lab, Tab

from plategait.model.parameters import find_parameter, value_of
from plategait.model.presets import PRESETS, preset
from plategait.model.scenario_file import read_scenario, write_scenario
from plategait.units import parse

pytestmark = pytest.mark.browser


@pytest.fixture(scope="module")
def cheese(lab_file) -> Path:
    return lab_file("cheese")


@pytest.fixture(scope="module")
def opened(browser, cheese):
    """The page of the cheese, opened once."""
    context = browser.new_context(offline=True, viewport={"width": 1280, "height": 900})
    lab = Lab(Tab(context.new_page()))
    lab.tab.open(cheese)
    yield lab
    context.close()


@pytest.fixture
def lab(opened):
    """The page as it was when it was opened; afterwards it must have been silent."""
    opened.reset()
    yield opened
    opened.tab.check()


def test_the_page_is_alive_and_says_what_it_shows(lab):
    lab.moves()
    assert lab.page.title() == "cheese – plategait lab"
    lab.tab.until("document.querySelector('.scene .word').textContent.includes('°/s')")
    assert re.match(r"(sliding|walking|running) · \d+ °/s", lab.word)
    lab.until_clock("now > 1")
    assert lab.page.evaluate("document.querySelector('canvas').getBoundingClientRect().height") > 200
    # What a screen reader is told of the picture.
    lab.tab.until("document.querySelector('canvas').getAttribute('aria-label').includes('walking')")


# Every control

TYPED = {
    "motion.frequency": "20 Hz", "motion.angle": "5 deg", "motion.stroke": "2 mm", "motion.offset.rx": "-1 deg",
    "motion.offset.ry": "0.5 deg", "motion.height": "10 mm", "motion.ramp": "0.2 s", "sheet.mass": "20 g",
    "sheet.bending_stiffness": "5e-3 N*mm/deg", "sheet.bending_damping": "1e-5 N*mm/(deg/s)",
    "sheet.torsion_stiffness": "1e-3 N*mm/deg", "sheet.torsion_damping": "1e-6 N*mm/(deg/s)",
    "sheet.axial_stiffness": "1 N/mm", "sheet.axial_damping": "1e-3 N/(mm/s)", "sheet.shear_ratio": "1.5",
    "sheet.thickness": "3 mm", "sheet.pitch": "8 mm", "sheet.outline.radius": "35 mm", "friction.static": "0.9",
    "friction.kinetic": "0.3", "friction.transition_speed": "80 mm/s", "friction.kinetic_speed_ratio": "8",
    "contact.stiffness": "10 N/mm",
    "contact.damping": "5e-3 N/(mm/s)", "contact.damping_ramp": "0.05 mm", "start.x": "5 mm", "start.y": "-3 mm",
    "start.angle": "30 deg", "gravity": "5 m/s^2", "slip_limit": "15 mm", "duration": "3 s",
}  # fmt: skip


@pytest.mark.slow
def test_every_number_is_typed_with_its_unit_and_simulated(lab):
    lab.begin()
    lab.button("Pause").click()
    fields = lab.page.locator("[data-field]").evaluate_all("(rows) => rows.map((row) => row.dataset.field)")
    shown = [name for name in fields if lab.row(name).is_visible()]
    assert set(shown) - {"natural_frequency", "motion.phase"} == set(TYPED)
    before = lab.scenario()
    for name, text in TYPED.items():
        lab.type(name, text)
        assert lab.fault(name) == ""
    after = lab.scenario()
    for name, text in TYPED.items():
        quantity = find_parameter(name, before).quantity
        assert quantity is not None
        expected = parse(text, quantity.unit)
        assert value_of(after, name) == pytest.approx(expected, rel=1e-12), name
        factor = parse(f"1 {quantity.display}", quantity.unit) if quantity.display else 1.0
        assert float(lab.value(name)) == pytest.approx(expected / factor, rel=1e-3), name
        assert lab.row(name).locator(".origin").get_attribute("class") == "origin yours"
    lab.button("Play").click()
    lab.moves()


@pytest.mark.slow
def test_every_slider_reaches_its_ends_by_keys_and_leaves_a_valid_scenario(lab):
    lab.begin()
    lab.button("Pause").click()
    for name in [*TYPED, "natural_frequency", "motion.phase"]:
        if name == "sheet.pitch":  # 2 mm make 1256 nodes, which take their time
            continue
        slider = lab.row(name).locator("input[type=range]")
        values = []
        for key in ("Home", "End", "ArrowLeft"):
            slider.press(key)
            values.append(lab.value(name) if not lab.fault(name) else None)
        assert len(set(values)) >= 2, name
        assert slider.get_attribute("aria-valuetext")
        lab.begin()
    lab.scenario()


@pytest.mark.slow
def test_numbers_may_be_typed_bare_and_in_other_units(lab):
    lab.begin()
    for name, text, says in (
        ("motion.angle", "5", "5"), ("motion.angle", "0.1 rad", "5.73"), ("motion.frequency", "18,5", "18.5"),
        ("sheet.mass", "0.02 kg", "20"), ("natural_frequency", "5 Hz", "10"), ("natural_frequency", "8 pi rad/s", "8"),
        ("motion.stroke", "0.2 cm", "2"), ("motion.phase", "90", "90"), ("motion.stroke", "2.5", "2.5"),
    ):  # fmt: skip
        lab.type(name, text)
        assert (lab.value(name), lab.fault(name)) == (says, ""), (name, text)
    scenario = lab.scenario()
    assert scenario.sheet.natural_frequency == pytest.approx(8 * math.pi, rel=1e-9)
    (wave,) = scenario.motion.waves
    assert (wave.axis, wave.amplitude, wave.phase) == ("x", 0.0025, pytest.approx(math.pi / 2))


REFUSED = [
    ("motion.frequency", "0", "Type 24 Hz"), ("motion.frequency", "-3 Hz", "above 0"), ("motion.angle", "3 mm", "unit"),
    ("motion.angle", "120 deg", "at most 90"), ("sheet.mass", "heavy", "begin with a number"),
    ("sheet.mass", "", "number"), ("sheet.mass", "20 kg", "at most 1e+4 g"), ("motion.stroke", "nan", "number"),
    ("friction.kinetic", "0.9", "at most the static"), ("friction.static", "-1", "at least 0"),
    ("sheet.pitch", "0.01 mm", "coarse enough"), ("gravity", "-1", "at least 0"),
    ("motion.frequency", "1e999", "number"),
    ("duration", "<img src=x onerror=alert(1)>", "number"), ("motion.frequency", "24 __proto__", "no unit"),
    ("motion.frequency", "24 constructor", "no unit"),
]  # fmt: skip


@pytest.mark.slow
def test_what_cannot_be_is_refused_beside_the_field_and_changes_nothing(lab):
    lab.begin()
    before = lab.scenario()
    for name, text, said in REFUSED:
        lab.type(name, text)
        assert lab.fault(name), (name, text)
        assert said in lab.fault(name), (name, text, lab.fault(name))
        assert lab.row(name).locator("input.number").get_attribute("aria-invalid") == "true"
        assert lab.scenario() == before, (name, text)
        lab.row(name).locator("input.number").press("Escape")
    lab.moves()


@pytest.mark.slow
def test_outlines_waveforms_laws_sines_and_the_plates_end(lab):
    lab.begin()
    outline = lab.page.get_by_label("Outline", exact=True)
    for kind, shape in (("ellipse", "ellipse"), ("rectangle", "rectangle"), ("leaf", "polygon"), ("fish", "polygon"),
                        ("triangle", "polygon"), ("hexagon", "polygon"), ("disk", "disk")):  # fmt: skip
        outline.select_option(kind)
        assert outline.input_value() == kind
        assert lab.scenario().sheet.outline.shape == shape
        lab.moves()
    outline.select_option("rectangle")
    lab.type("sheet.outline.width", "30 mm")
    assert lab.scenario().sheet.outline.size()[1] == pytest.approx(0.03)
    waveform = lab.page.get_by_label("Shape of the swing")
    kinds = [k for k in waveform.locator("option").evaluate_all("(all) => all.map((o) => o.value)") if k != "own"]
    seen = set()
    for kind in kinds:
        waveform.select_option(kind)
        assert waveform.input_value() == kind
        seen.add(lab.scenario().motion)
    assert len(seen) == len(kinds) >= 3
    waveform.select_option("sine")
    lab.button("Add a sine").click()
    lab.page.get_by_label("Axis", exact=True).select_option("rz")
    for label, text in (("amplitude in deg", "2"), ("times f", "2"), ("phase in deg", "45 deg")):
        box = lab.page.get_by_label(label)
        box.fill(text)
        box.press("Enter")
    (wave,) = lab.scenario().motion.waves
    assert (wave.axis, wave.ratio) == ("rz", 2)
    assert [wave.amplitude, wave.phase] == pytest.approx([math.radians(2), math.radians(45)])
    lab.button("Remove the sine on rz").click()
    assert lab.scenario().motion.waves == ()
    lab.page.get_by_label("Law of friction").select_option("adams")
    assert lab.scenario().friction.law == "adams"
    lab.page.get_by_label("The plate ends").check()
    lab.type("plate.length", "300 mm")
    assert lab.scenario().plate.length == pytest.approx(0.3)
    lab.page.get_by_label("The plate ends").uncheck()
    assert lab.scenario().plate is None


def test_a_preset_lies_there_with_what_is_published_of_it(lab):
    for name in PRESETS:
        lab.begin(name)
        assert lab.scenario() == preset(name).scenario
        told = preset(name)
        for field in ("sheet.mass", "motion.frequency", "friction.transition_speed", "sheet.bending_damping"):
            kind = "published" if field in told.published else "inferred" if field in told.inferred else "yours"
            assert lab.row(field).locator(".origin").get_attribute("class") == f"origin {kind}", field
        lab.moves()


# Time


@pytest.mark.slow
def test_time_is_stopped_stepped_slowed_and_scrubbed(lab):
    lab.until_clock("now > 0.3")
    lab.button("Pause").click()
    lab.page.wait_for_timeout(300)
    stopped = lab.clock
    lab.page.wait_for_timeout(300)
    assert lab.clock == stopped
    lab.button("One picture back").click()
    lab.until_clock("now < of.was && now > of.was - 0.1", was=stopped)
    earlier = lab.clock
    lab.button("One picture forward").click()
    lab.until_clock("now > of.was && now <= of.stopped + 0.1", was=earlier, stopped=stopped)
    track = lab.page.get_by_label("Time, to scrub")
    track.press("Home")
    lab.until_clock("now < 0.01")
    track.press("End")
    lab.until_clock("now >= of.was", was=stopped)
    speed = lab.page.get_by_role("slider", name="Speed", exact=True)
    speed.press("End")
    lab.tab.until("document.querySelector('output[for=speed]').textContent === '1/200'")
    lab.button("Play").click()
    before, began = lab.clock, time.monotonic()
    lab.page.wait_for_timeout(1000)
    assert 0 < lab.clock - before < 0.02 * (time.monotonic() - began)
    speed.press("Home")
    lab.tab.until("document.querySelector('output[for=speed]').textContent === 'real time'")
    lab.until_clock("now > 0.5")
    lab.button("Lay down anew").click()
    lab.until_clock("now < 0.5")
    lab.moves()


@pytest.mark.slow
def test_the_keys_do_what_the_page_says(lab):
    lab.moves()
    lab.page.locator("canvas").first.focus()
    lab.page.keyboard.press(" ")
    lab.tab.until("document.querySelector('#transport .play').textContent === 'Play'")
    was = lab.clock
    lab.page.keyboard.press(",")
    lab.until_clock("now < of.was", was=was)
    lab.page.keyboard.press("s")
    lab.tab.until("document.querySelector('output[for=speed]').textContent === '1/2'")
    lab.page.keyboard.press("f")
    lab.tab.until("document.querySelector('output[for=speed]').textContent === 'real time'")
    lab.page.keyboard.press("?")
    lab.says("space: play or pause")
    lab.page.keyboard.press("r")
    lab.until_clock("now < 0.4")
    lab.page.keyboard.press("k")
    lab.moves()
    lab.page.get_by_role("tab", name="Now").press("ArrowRight")
    assert lab.page.get_by_role("tab", name="Spin curve").get_attribute("aria-selected") == "true"


@pytest.mark.slow
def test_a_kick_moves_the_sheet(lab):
    """On a plate that stands still nothing else does."""
    lab.begin()
    lab.type("motion.angle", "0")
    lab.type("motion.stroke", "0")
    lab.button("Lay down anew").click()
    lab.moves()
    drift = (
        "[...document.querySelectorAll('.readings div')].find((e) => /^drift/.test(e.innerText)).lastChild.innerText"
    )
    # Of the sheet before the numbers stay until the new one's come.
    lab.tab.until(f"parseFloat({drift}) < 0.1")
    lab.button("Kick").click()
    # v²/2μg of 0.15 m/s with μ_k = 0.4 to μ_s = 0.75 is 1.5 to 2.9 mm.
    lab.tab.until(f"parseFloat({drift}) > 1")
    assert float(lab.page.evaluate(drift).split()[0]) < 4


@pytest.mark.slow
def test_layers_heights_and_viewpoints_change_the_picture(lab):
    lab.tab.until("parseFloat(document.querySelector('.clock').textContent) > 0.5")
    lab.button("Pause").click()
    canvas = lab.page.locator("canvas").first

    def picture() -> bytes:
        lab.page.wait_for_timeout(250)
        return canvas.screenshot()

    seen = [picture()]
    for label in ("nodes in contact", "friction", "legs", "way and limit", "bending"):
        box = lab.page.get_by_label(label, exact=True)
        box.set_checked(not box.is_checked())
        seen.append(picture())
    lab.page.get_by_label("Heights are drawn").select_option("10")
    seen.append(picture())
    for view in ("above", "bar", "plate"):
        lab.page.get_by_label("Seen", exact=True).select_option(view)
        seen.append(picture())
    assert len(set(seen)) >= len(seen) - 1


# Compare, undo, share, save, open


@pytest.mark.slow
def test_two_sheets_side_by_side_are_turned_each_by_itself(lab):
    lab.begin()
    lab.button("Compare").click()
    assert lab.page.locator(".scene").count() == 2
    lab.type("motion.frequency", "15 Hz")
    assert lab.scenario().motion.frequency == 15
    lab.page.locator(".scene canvas").first.click()
    assert lab.value("motion.frequency") == "24"
    lab.tab.until("[...document.querySelectorAll('.word')].every((each) => each.textContent.includes('°/s'))")
    words = lab.page.locator(".word").all_inner_texts()
    assert len(set(words)) == 2
    lab.button("Only one").click()
    assert lab.page.locator(".scene").count() == 1
    lab.moves()


def test_undo_goes_back_change_by_change(lab):
    lab.begin()
    lab.type("motion.frequency", "20")
    lab.type("sheet.mass", "20")
    lab.button("Undo").click()
    assert (lab.value("motion.frequency"), lab.value("sheet.mass")) == ("20", "13.6")
    lab.page.locator("canvas").first.focus()
    lab.page.keyboard.press("Control+z")
    assert lab.value("motion.frequency") == "24"


@pytest.mark.slow
def test_a_link_holds_the_scenario_and_opens_with_it(lab, new_tab, cheese):
    lab.begin("pancake")
    lab.type("motion.frequency", "9.5")
    lab.page.get_by_label("Outline", exact=True).select_option("leaf")
    lab.button("Add a sine").click()
    told = lab.scenario()
    other = Lab(new_tab(offline=True))
    other.tab.open(cheese, lab.page.evaluate("location.hash"))
    assert other.scenario() == told
    other.moves()
    # Pasted into the page that is open already.
    link = other.page.evaluate("location.hash")
    lab.begin("cheese")
    assert lab.scenario() != told
    lab.page.evaluate("(link) => { location.hash = link }", link)
    lab.tab.until("document.title.startsWith('pancake')")
    assert lab.scenario() == told
    other.tab.check()


SPOILT = [
    "#x", "#%7B", "#%", '#{"v":1}', '#{"v":1,"of":"toString"}', '#{"v":1,"of":"cheese","with":{"motion.frequency":-1}}',
    '#{"v":1,"of":"cheese","with":{"__proto__.a":1}}', '#{"v":1,"of":"cheese","with":{"sheet.mass":"<b>"}}',
    '#{"v":1,"of":"cheese","with":{"sheet.outline":null}}', '#{"v":1,"of":"cheese","with":{"motion":[1]}}',
    '#{"v":1,"of":"cheese","with":{"sheet.outline.radius":1e9}}', "#" + "x" * 30_000,
    '#{"v":1,"of":"cheese","with":{"motion.waves":{}}}', '#{"v":1,"of":"cheese","with":{"name":{}}}',
]  # fmt: skip


@pytest.mark.slow
def test_a_spoilt_link_is_said_and_changes_nothing(lab, new_tab, cheese):
    lab.moves()
    for fragment in SPOILT:
        lab.page.evaluate("(link) => { location.hash = link }", fragment)
        lab.tab.until("document.querySelector('#notice').textContent !== ''")
        lab.page.evaluate("document.querySelector('#notice').textContent = ''")
        assert lab.scenario() == preset("cheese").scenario, fragment[:80]
        assert lab.page.evaluate("({}).a") is None
    fresh = Lab(new_tab(offline=True))
    fresh.tab.open(cheese, SPOILT[5])
    fresh.says("cheese lies there instead")
    assert fresh.scenario() == preset("cheese").scenario
    fresh.moves()
    fresh.tab.check()


def saved(lab: Lab, folder: Path) -> Path:
    with lab.page.expect_download() as download:
        lab.button("Save TOML").click()
    path = folder / download.value.suggested_filename
    download.value.save_as(path)
    return path


def test_a_saved_file_is_the_very_scenario_and_opens_again(lab, tmp_path, called):
    lab.begin("dumpling-skin")
    lab.type("motion.frequency", "14 Hz")
    lab.type("motion.phase", "40 deg")
    lab.page.get_by_label("Outline", exact=True).select_option("fish")
    lab.page.get_by_label("The plate ends").check()
    told = lab.scenario()
    path = saved(lab, tmp_path)
    assert path.name == "dumpling-skin.toml"
    assert read_scenario(path) == told
    called("simulate", path.name, "--duration", "0.1 s", cwd=tmp_path, check=0)
    lab.begin("cheese")
    drop(lab, path.name, path.read_text())
    lab.says("is on the plate")
    assert lab.scenario() == told


def drop(lab: Lab, name: str, text: str) -> None:
    """Let go of a file over the page."""
    lab.page.evaluate(
        """([name, text]) => {
          const files = new DataTransfer();
          files.items.add(new File([text], name));
          document.dispatchEvent(new DragEvent("dragover", { dataTransfer: files, bubbles: true, cancelable: true }));
          document.dispatchEvent(new DragEvent("drop", { dataTransfer: files, bubbles: true, cancelable: true }));
        }""",
        [name, text],
    )


@pytest.mark.slow
def test_files_that_the_package_writes_open_as_the_same_scenario(lab):
    for name in PRESETS:
        scenario = preset(name).scenario.replace(**{"motion.frequency": "17 Hz", "start.angle": "10 deg"})
        drop(lab, f"{name}.toml", write_scenario(scenario))
        lab.says("is on the plate")
        assert lab.scenario() == scenario


DISK = 'outline = {shape = "disk", radius = "40 mm"}'
NO_FILES = [
    ("a.toml", "[sheet", "no TOML"), ("a.toml", "[motion]\nfrequency = 3", "no [sheet]"),
    ("a.nc", "\0\0", "plategait lab FILE"), ("a.toml", f'[sheet]\nmass = "-1 g"\n{DISK}', "sheet.mass"),
    ("a.toml", f"[sheet]\nmas = 1\n{DISK}", "sheet.mas"), ("a.toml", f'[sheet]\nmass = "1 stone"\n{DISK}', "stone"),
    ("a.toml", '[sheet]\noutline = {shape = "mask", image = "/etc/passwd", width_of_picture = 1}', "image"),
    ("a.toml", '[sheet]\noutline = {shape = "blob"}', "outline"), ("a.toml", "x" * 5_000_000, "at most 4 MB"),
    ("a.toml", f"name = 3\n[sheet]\n{DISK}", "name"), ("a.toml", f"[sheet]\n{DISK}\n[motion]\nwaves = 3", "waves"),
    ("<img src=x onerror=alert(1)>.toml", "", "<img src=x onerror=alert(1)>.toml"),
    ("a.csv", "a,b\n1,2\n", "no column time_s"), ("a.csv", "time_s,x_mm,y_mm,angle_deg\n", "fewer than two poses"),
]  # fmt: skip


@pytest.mark.slow
def test_a_file_that_is_none_is_refused_and_changes_nothing(lab):
    for name, text, said in NO_FILES:
        drop(lab, name, text)
        lab.says(said)
        assert lab.scenario() == preset("cheese").scenario, (name, text[:80])
    assert lab.page.locator("img").count() == 0
    lab.moves()


# Appearance


@pytest.mark.slow
@pytest.mark.parametrize(
    "options",
    [
        {"viewport": {"width": 1280, "height": 800}, "color_scheme": "light"},
        {"viewport": {"width": 1280, "height": 800}, "color_scheme": "dark", "reduced_motion": "reduce"},
        {"viewport": {"width": 360, "height": 740}, "color_scheme": "light", "has_touch": True, "is_mobile": True},
        {"viewport": {"width": 360, "height": 740}, "color_scheme": "dark"},
    ],
    ids=["desk", "dark", "phone", "dark phone"],
)
def test_the_page_is_accessible_at_every_size_and_in_every_light(new_tab, cheese, options):
    axe = pytest.importorskip("axe_playwright_python.sync_playwright", reason="axe is not installed").Axe()
    lab = Lab(new_tab(offline=True, **options))
    lab.tab.open(cheese)
    lab.moves()
    lab.page.evaluate("document.querySelectorAll('details').forEach((each) => { each.open = true })")
    for tab in ("Now", "Spin curve", "Map"):
        lab.page.get_by_role("tab", name=tab).click()
        found = axe.run(lab.page)
        assert found.violations_count == 0, found.generate_report()
    wide = lab.page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth")
    assert wide <= 0
    small = lab.page.evaluate(
        """[...document.querySelectorAll("button, select, input:not([type=file])")].filter((each) => {
          const { width, height } = each.getBoundingClientRect();
          return width > 0 && each.type !== "checkbox" && each.type !== "range" && Math.min(width, height) < 24;
        }).map((each) => each.outerHTML.slice(0, 80))"""
    )
    assert small == []
    lab.tab.check()


@pytest.mark.slow
def test_the_theme_is_chosen_and_the_layout_stays(lab):
    lab.moves()
    paper = "getComputedStyle(document.body).backgroundColor"
    places = "[...document.querySelectorAll('#controls, #stage, #transport')].map((e) => e.getBoundingClientRect().top)"
    seen, tops = {lab.page.evaluate(paper)}, lab.page.evaluate(places)
    for theme in ("light", "dark"):
        lab.page.get_by_role("button", name="Theme").click()
        assert lab.page.get_by_role("button", name=f"Theme: {theme}").is_visible()
        seen.add(lab.page.evaluate(paper))
    assert len(seen) == 2
    lab.page.wait_for_timeout(500)
    assert lab.page.evaluate(places) == tops


@pytest.mark.slow
def test_everything_is_reached_with_the_keyboard_alone(new_tab, cheese):
    lab = Lab(new_tab(offline=True))
    lab.tab.open(cheese)
    lab.moves()
    lab.page.locator("body").press("Tab")
    assert lab.page.evaluate("document.activeElement.textContent") == "Skip to the controls"
    reached, name = set(), "document.activeElement.ariaLabel || document.activeElement.textContent.trim()"
    for _ in range(150):
        reached.add(lab.page.evaluate(name))
        lab.page.keyboard.press("Tab")
    assert {"Save TOML", "Compare", "Pause", "Time, to scrub", "Kick", "Add a sine", "Outline", "Now"} <= reached
    # One tab of a list is reached, the others by its arrows.
    assert "Map" not in reached


def test_without_an_engine_the_page_says_so(lab_file, new_tab, tmp_path):
    html = lab_file("cheese").read_text()
    spoilt = re.sub(r'(id="engine">)[^<]*', r"\1AGFzbQEAAAA=", html)
    (tmp_path / "spoilt.html").write_text(spoilt)
    tab = new_tab(offline=True)
    tab.open(tmp_path / "spoilt.html")
    tab.until("/engine/.test(document.querySelector('#notice').textContent)")
