"""The lab's picture in a browser that draws by itself: what is seen of sheets, pushes, lost contexts and no WebGL.

`PICTURES=folder pytest tests/end_to_end/test_lab_picture.py` keeps the pictures there, to be looked at.
"""

from __future__ import annotations

import importlib.util
import io
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

LAB = Path(__file__).parents[2] / "lab"
ESBUILD = LAB / "node_modules" / ".bin" / "esbuild"
WITHOUT_WEBGL = """
const before = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
  return kind.startsWith("webgl") ? null : before.call(this, kind, ...more);
};
OffscreenCanvas.prototype.getContext = () => null;
"""
DURATION = 0.2  # s

pytestmark = [
    pytest.mark.browser,
    pytest.mark.slow,
    pytest.mark.skipif(not ESBUILD.exists(), reason="the lab's libraries are not installed: make lab"),
]


@pytest.fixture(scope="module")
def frames():
    """Frames of a case, made once."""
    spec = importlib.util.spec_from_file_location("view_frames", LAB / "tests" / "view_frames.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    made: dict[str, dict[str, object]] = {}
    return lambda name: made.get(name) or made.setdefault(name, module.frames_of(name, DURATION))


@pytest.fixture(scope="module")
def page(tmp_path_factory) -> Path:
    """The picture alone, in a file."""
    folder = tmp_path_factory.mktemp("picture")
    options = ["--bundle", "--format=iife", "--log-level=warning", f"--outfile={folder / 'page.js'}"]
    subprocess.run([ESBUILD, LAB / "tests" / "view_page.js", *options], check=True)
    script = (folder / "page.js").read_text().replace("</script", "<\\/script")
    html = (LAB / "tests" / "view_page.html").read_text()
    (folder / "page.html").write_text(html.replace("</body>", f"<script>{script}</script></body>"))
    return folder / "page.html"


class Picture:
    """The picture in a tab."""

    def __init__(self, tab, page: Path, frames, before: str = "", theme: str = "") -> None:
        self.tab, self.frames = tab, frames
        if before:
            tab.page.add_init_script(before)
        tab.open(page)
        self.js(f"document.documentElement.dataset.theme = {theme!r}; harness.open() && 0")

    def js(self, script: str, argument: object = None):
        return self.tab.page.evaluate(script, argument)

    def lay(self, name: str, last: int = 45) -> None:
        self.js("run => harness.lay(run)", self.frames(name))
        assert self.js("last => harness.play(last)", last)

    def look(self, name: str) -> np.ndarray:
        """(height, width, 3) what is seen, from 0 to 1."""
        self.js("harness.still()")
        png = self.tab.page.screenshot()
        if folder := os.environ.get("PICTURES"):
            (Path(folder) / f"{name}.png").write_bytes(png)
        return np.asarray(Image.open(io.BytesIO(png)).convert("RGB")) / 255


@pytest.fixture
def picture(new_tab, page, frames):
    """Open the picture in a tab of its own; what the tab said is looked at in the end."""
    opened = []

    def new(width: int = 600, height: int = 400, scale: float = 1, **more: str) -> Picture:
        tab = new_tab(viewport={"width": width, "height": height}, device_scale_factor=scale)
        opened.append(tab)
        return Picture(tab, page, frames, **more)

    yield new
    for tab in opened:
        tab.check()


def share(seen: np.ndarray, colour: tuple[float, float, float], off: float = 0.14) -> float:
    """Share of a picture that is of about a colour."""
    return float((np.abs(seen - colour).max(axis=2) < off).mean())


GOLD, BLUE, BROWN, PAPER, NIGHT = (
    (0.91, 0.69, 0.29),
    (0.1, 0.46, 0.66),
    (0.7, 0.46, 0.05),
    (0.95, 0.95, 0.94),
    (0.11, 0.13, 0.15),
)


@pytest.mark.parametrize("name", ["folded", "fish", "leaf"])
def test_every_outline_is_seen_whole_in_the_middle_of_the_picture(picture, name):
    p = picture()
    p.lay(name)
    p.js("harness.view.setLayers({legs: false, contact: false, forces: false, trail: false})")
    seen = p.look(name)
    sheet = np.abs(seen - GOLD).max(axis=2) < 0.25
    assert 0.03 < sheet.mean() < 0.4
    rows, columns = np.nonzero(sheet)
    assert 0.3 < rows.mean() / 400 < 0.7
    assert 0.3 < columns.mean() / 600 < 0.7
    assert rows.min() > 20
    assert rows.max() < 380
    assert columns.min() > 20
    assert columns.max() < 580


def test_a_phone_at_night_sees_it_too_and_the_page_keeps_its_layout(picture):
    p = picture(390, 500, 2, theme="dark")
    p.lay("cheese")
    seen = p.look("phone")
    assert share(seen, NIGHT) > 0.15
    assert share(seen, PAPER) < 0.02
    size = "(() => { const c = harness.view.canvas; return [c.clientWidth, c.clientHeight]; })()"
    assert p.js(size) == [390, 500]
    p.tab.page.set_viewport_size({"width": 500, "height": 390})
    p.look("phone-turned")
    assert p.js(size) == [500, 390]


def test_layers_show_and_hide_what_they_name(picture):
    p = picture()
    p.lay("cheese")
    p.js("harness.view.setLayers({legs: true, contact: false, forces: false})")
    legs = p.look("legs")
    assert share(legs, BLUE) > 0.02
    assert share(legs, BROWN) > 0.02
    p.js("harness.view.setLayers({legs: false})")
    assert share(p.look("no-legs"), BLUE) < 0.002
    p.js("harness.view.setLayers({bending: true}); harness.view.setExaggeration(5)")
    bent = p.look("bent")
    assert np.abs(bent - legs).max(axis=2)[340:, 360:].max() > 0.3  # the corner says what is drawn how
    p.js("harness.view.setLayers({bending: false}); harness.view.setExaggeration(1)")
    before = p.look("no-goal")
    for call in ("setGoal({x: 0.03, y: 0.01, angle: 1})", "setGhost({x: -0.02, y: 0, angle: 2})",
                 "setCloud(harness.run.frames.slice(0, 40).filter((_, k) => k % 4 == 0))"):  # fmt: skip
        p.js(f"harness.view.{call}")
        now = p.look(call.split("(")[0])
        assert (np.abs(now - before).max(axis=2) > 0.1).mean() > 0.001, call
        before = now


def test_a_frame_that_is_not_finite_is_refused_and_changes_nothing(picture):
    p = picture()
    p.lay("cheese")
    before = p.look("before")
    told = p.js("""() => {
      const frame = harness.run.frames[30], spoilt = frame.nodes.slice();
      spoilt[7] = NaN;
      return [{ ...frame, nodes: spoilt }, { ...frame, pose: [0, 0, Infinity, 0, 0, 0] },
        { ...frame, nodes: frame.nodes.slice(3) }, { ...frame, time: NaN }].map((each) => harness.view.show(each));
    }""")
    assert told == [False] * 4
    assert np.abs(p.look("after") - before).max() < 0.02


def test_a_drag_on_the_sheet_pushes_it_and_one_beside_it_turns_the_picture(picture):
    p = picture()
    p.lay("cheese")
    still, mouse = p.look("still"), p.tab.page.mouse
    mouse.move(300, 213)
    mouse.down()
    mouse.move(374, 213, steps=3)
    aimed = p.look("aimed")
    mouse.up()
    (push,) = p.js("harness.pushes")
    assert np.hypot(*push["at"]) < 0.02
    assert push["velocity"][1] > 0.05
    assert abs(push["velocity"][2]) < 0.1
    assert np.abs(aimed - still)[167:267, 293:387].max() > 0.3
    mouse.move(40, 373)
    mouse.down()
    mouse.move(110, 360, steps=3)
    mouse.up()
    assert len(p.js("harness.pushes")) == 1
    assert (np.abs(p.look("turned") - still).max(axis=2) > 0.1).mean() > 0.05
    p.js("harness.view.pushWith({direction: 'up', speed: 0.3})")
    assert p.js("harness.pushes[1].velocity") == [0, 0, 0.3]
    mouse.move(300, 213)
    mouse.down()
    mouse.move(333, 213)
    p.tab.page.keyboard.press("Escape")
    mouse.up()
    assert len(p.js("harness.pushes")) == 2


def test_keys_turn_the_picture_and_take_it_back(picture):
    p = picture()
    p.lay("cheese")
    p.js("harness.view.canvas.focus()")
    first = p.look("first")
    before = first
    for keys in (["ArrowLeft"] * 3, ["ArrowUp"] * 3, ["+"] * 3, ["Shift+ArrowRight"] * 3, ["1"], ["2"], ["3"]):
        for key in keys:
            p.tab.page.keyboard.press(key)
        now = p.look(f"after-{keys[0]}")
        assert (np.abs(now - before).max(axis=2) > 0.1).mean() > 0.02, keys
        before = now
    p.tab.page.keyboard.press("0")
    assert np.abs(p.look("back") - first).mean() < 0.01


def test_when_the_context_is_lost_a_plain_picture_stands_in_until_it_is_back(picture):
    p = picture()
    p.lay("cheese")
    before = p.look("whole")
    lose = "harness.view.canvas.getContext('webgl2').getExtension('WEBGL_lose_context')"
    p.js(f"globalThis.context = {lose}; context.loseContext()")
    p.tab.page.wait_for_timeout(100)
    assert p.js("document.querySelectorAll('canvas').length") == 2
    assert p.js("harness.play(45)")
    lost = p.look("lost")
    assert share(lost, GOLD) > 0.05
    p.js("context.restoreContext()")
    p.tab.page.wait_for_timeout(100)
    assert p.js("document.querySelectorAll('canvas').length") == 1
    assert p.js("harness.play(45)")
    assert np.abs(p.look("restored") - before).mean() < 0.01


def test_without_webgl_the_plain_picture_shows_and_pushes_the_same(picture):
    p = picture(before=WITHOUT_WEBGL)
    p.lay("fish")
    p.js("harness.view.setGoal({x: 0.03, y: 0.02, angle: 0.5}); harness.view.setExaggeration(5)")
    p.js("harness.view.setLayers({forces: false})")
    assert share(p.look("flat"), GOLD) > 0.03
    mouse = p.tab.page.mouse
    mouse.move(198, 200)
    mouse.down()
    mouse.move(198, 160, steps=3)
    mouse.up()
    (push,) = p.js("harness.pushes")
    assert push["velocity"][1] > 0.03
    assert abs(push["velocity"][0]) < 0.02
    assert p.js("harness.view.snapshot().then((blob) => blob.type)") == "image/png"
    p.js("harness.view.setLayers({bending: 'height'})")
    assert share(p.look("flat-bent"), (0.0, 0.13, 0.3)) > 0.01
    p.js("harness.view.destroy()")


def test_many_sheets_after_one_another_leave_nothing_behind(picture):
    p = picture()
    counted = []
    for _ in range(3):
        for name in ("cheese", "fish"):
            p.lay(name, 3)
        counted.append(
            p.js("(({geometries, textures}) => [geometries, textures])(harness.view.picture.renderer.info.memory)")
        )
    assert counted[1] == counted[2]


def test_a_picture_can_be_taken_and_the_view_let_go_of(picture):
    p = picture()
    p.lay("plate")
    kind, size = p.js("harness.view.snapshot().then((blob) => [blob.type, blob.size])")
    assert kind == "image/png"
    assert size > 20_000
    p.js("harness.view.destroy()")
    p.tab.page.set_viewport_size({"width": 700, "height": 500})
    p.js("document.documentElement.dataset.theme = 'dark'")
    p.tab.page.wait_for_timeout(300)
