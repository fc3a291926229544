"""A thousand random settings and damaged data: the page stays whole, says what is wrong, and never stands still."""

from __future__ import annotations

import json
import random
import re
import string

import pytest
from lab_tab import Lab

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SETTINGS, BLOBS = 960, 40
LONGEST = 0.5
"""That the page's own thread may be held up, s."""
# By the page's own controls, faster than any hand.
SHAKE = """async ([seed, count]) => {
  let state = seed;
  const chance = () => { state = (Math.imul(state, 1664525) + 1013904223) >>> 0; return state / 4294967296; };
  const one = (list) => list[Math.floor(chance() * list.length)];
  const strange = ["", "-1", "0", "1e999", "nan", "-0", "1e-30", "1e30", "５", "<b>x</b>", "3 parsec", "__proto__"];
  const rows = () => [...document.querySelectorAll("#controls [data-field]")];
  for (let k = 0; k < count; k++) {
    const row = one(rows());
    const name = row.dataset.field;
    const text = row.querySelector("input.number");
    if (chance() < 0.4) {
      const number = chance() < 0.3 ? one(strange) : String((chance() * 40).toPrecision(3));
      text.value = name === "sheet.pitch" ? String(6 + 8 * chance()) : number;
      text.dispatchEvent(new Event("change"));
    } else {
      const slider = row.querySelector("input[type=range]");
      slider.value = String(Math.floor(chance() * 401));
      // Thousands of nodes are for a computer that has nothing else to do.
      if (name === "sheet.pitch") slider.value = String(250 + Math.floor(chance() * 150));
      slider.dispatchEvent(new Event("input"));
    }
    if (chance() < 0.1) {
      const select = one([...document.querySelectorAll("#controls select, .layers select")]);
      select.selectedIndex = Math.floor(chance() * select.options.length);
      select.dispatchEvent(new Event("change"));
    }
    if (chance() < 0.05) one([...document.querySelectorAll("#transport button, .layers button")]).click();
    if (k % 10 === 9) await new Promise((done) => setTimeout(done, 60));
  }
}"""
HELD_UP = """window.held = [];
new PerformanceObserver((list) => list.getEntries().forEach((entry) => window.held.push(entry.duration / 1000)))
  .observe({ type: "longtask", buffered: true });"""
NO_NUMBER = re.compile(r"\bNaN\b|\bundefined\b|\bInfinity\b|\[object")


def slowness() -> float:
    """How much longer work takes here than its processor's time: others may want it too."""
    import time

    wall, own = time.perf_counter(), time.process_time()
    while time.process_time() - own < 0.3:
        pass
    return max(1.0, (time.perf_counter() - wall) / 0.3)


def test_random_settings_leave_a_page_that_lives(new_tab, lab_file):
    lab = Lab(new_tab(offline=True, viewport={"width": 1000, "height": 700}))
    lab.page.add_init_script(HELD_UP)
    lab.tab.open(lab_file("cheese"))
    lab.moves()
    lab.page.evaluate("window.held = []")
    for seed in range(SETTINGS // 120):
        lab.page.evaluate(SHAKE, [seed, 120])
        text = lab.page.locator("body").inner_text()
        assert not NO_NUMBER.search(text), NO_NUMBER.findall(text)
        assert lab.page.locator("b, img").count() == 0
        lab.scenario()
    held = lab.page.evaluate("window.held")
    print(f"held up {max(held, default=0):.2f} s at most, {len(held)} times over 50 ms, slowness {slowness():.1f}")
    assert max(held, default=0) < LONGEST * 2 * slowness()
    lab.page.get_by_label("Speed", exact=True).press("Home")
    lab.begin()
    lab.moves()
    lab.tab.check()


PAYLOADS = [
    {"kind": "run", "name": "r", "time": [0, 0.1], "channels": {"centre_x": [0, 0]}, "snapshot_time": [0, 0.1],
     "snapshots": "AAAAAAAA", "plate_pose": [[0] * 6] * 2, "gait": "walking", "notes": []},
    {"kind": "store", "name": "s", "grid": True, "repeats": 1, "notes": [], "observables": [],
     "parameters": [{"name": "motion.frequency", "unit": "Hz", "display": "Hz", "values": [20, 24]}],
     "points": [{"at": [20], "set": {"motion.frequency": 20}, "spin_rate": 1, "spread": 0, "gait": "walking",
                 "failure": None, "failure_time": None, "failed": False, "failed_runs": 0, "values": {}}]},
    {"kind": "poses", "name": "p", "time": [0, 0.1], "x": [0, 0], "y": [0, 0], "angle": [0, 0.1], "sure": [True, True],
     "notes": []},
    {"kind": "object", "name": "o", "source": "s", "confidence": 0.95, "notes": [],
     "parameters": [{"name": "sheet.mass", "unit": "kg", "display": "g", "value": 0.01, "sd": 0, "low": 0, "high": 1}],
     "samples": [{"set": {"sheet.mass": 0.011}}]},
    {"kind": "steering", "name": "w", "goals": [{"x": 0, "y": 0, "angle": None, "from": 0}], "motions": [], "told": [],
     "path": [], "notes": [], "ticks": {n: [0, 0.1] for n in ("time", "x", "y", "angle", "goal_x", "goal_y")}},
    {"kind": "scenario", "name": "c", "notes": []},
]  # fmt: skip


def damaged(text: str, generator: random.Random) -> str:
    """JSON with something else in some place of it, or no JSON any more."""
    if generator.random() < 0.3:
        letters = list(text)
        for _ in range(generator.randint(1, 4)):
            letters[generator.randrange(len(letters))] = generator.choice(string.printable.replace("<", ""))
        return "".join(letters)
    data = json.loads(text)
    for _ in range(generator.randint(1, 3)):
        part, path = data, []
        while isinstance(part, dict | list) and part and (not path or generator.random() < 0.75):
            key = generator.choice(list(part)) if isinstance(part, dict) else generator.randrange(len(part))
            path.append((part, key))
            part = part[key]
        holder, key = path[-1]
        strange = [None, -1, 1e300, "", "\u003cimg src=x onerror=window.taken=1>", [], {}, [[[]]], True, "one", 1e308]
        holder[key] = generator.choice(strange)
    return json.dumps(data).replace("<", "\\u003c")


def test_damaged_data_are_said_and_the_page_lives(new_tab, lab_file):
    from plategait.lab.scenario_json import plain_scenario
    from plategait.model.presets import preset

    scenario = plain_scenario(preset("cheese").scenario)[0]
    html = lab_file("cheese").read_text(encoding="utf-8")
    generator = random.Random(5)
    tab = new_tab(offline=True, viewport={"width": 800, "height": 600})
    before, payload, after = re.split(r'(?<=id="payload">)(.*?)(?=</script>)', html, maxsplit=1, flags=re.S)
    del payload
    path = lab_file("pancake")
    for i in range(BLOBS):
        text = damaged(json.dumps(PAYLOADS[i % len(PAYLOADS)] | {"scenario": scenario}), generator)
        path.write_text(before + text + after, encoding="utf-8", errors="replace")
        tab.open(path)
        lab = Lab(tab)
        tab.until("document.querySelectorAll('[role=tab]').length >= 3")
        if lab.page.get_by_role("tab", name="From the file").count():
            lab.page.get_by_role("tab", name="From the file").click()
        tab.until("document.querySelector('.clock').textContent !== ''")
        said = lab.page.locator("body").inner_text()
        assert not NO_NUMBER.search(said), (text, NO_NUMBER.findall(said))
        assert lab.page.locator("img").count() == 0
        assert lab.page.evaluate("window.taken") is None
        assert (tab.messages, tab.errors, tab.requests) == ([], [], []), text
    lab.moves()
