"""What the lab gives away is what the package reads: files and links that hold the very numbers of the page."""

from __future__ import annotations

from typing import Any

import pytest
from lab_scripts import NODE, SCRIPTS, asked
from lab_sheets import plain, random_groups

import plategait as pg
from plategait.lab.facts import facts
from plategait.model.presets import PRESETS

LIBRARIES = SCRIPTS.parents[1] / "node_modules"
pytestmark = pytest.mark.skipif(
    NODE is None or not LIBRARIES.exists(), reason="node or the page's libraries are not installed: npm ci in lab/"
)

FILES = {
    '[sheet]\nmass = "13 g"\n': "sheet.outline.shape",
    "name = 3\n": "sheet",
    "[sheet\n": "TOML",
    '[sheet]\nmas = "13 g"\noutline = { shape = "disk", radius = 0.04 }\n': "sheet.mas",
    '[sheet]\nmass = "13 parsec"\noutline = { shape = "disk", radius = 0.04 }\n': "sheet.mass",
    '[sheet]\noutline = { shape = "mask", image = "leaf.png", width_of_picture = 0.1 }\n': "plategait lab",
}
LINKS = {
    "#%7B": "spoilt",
    "#" + "x" * 30_000: "long",
    '#{"of":"cheese","with":{"__proto__.x":1}}': "no scenario has",
    '#{"of":"constructor","with":{}}': "no preset",
    "#null": "no preset",
    '#{"of":"cheese","with":{"sheet.mass.more":1}}': "",
}


@pytest.fixture(scope="module")
def told() -> tuple[list[pg.Scenario], dict[str, Any]]:
    strangers = [scenario for group in random_groups(25, 1, seed=5) for scenario in group]
    scenarios = [pg.preset(name).scenario for name in PRESETS] + strangers
    question = {"facts": facts(), "scenarios": [plain(scenario) for scenario in scenarios]}
    return scenarios, asked("share.js", question | {"files": list(FILES), "links": list(LINKS)})


def test_a_saved_file_is_the_scenario_to_the_bit(told, tmp_path):
    scenarios, answer = told
    for scenario, shared in zip(scenarios, answer["shared"], strict=True):
        path = tmp_path / "saved.toml"
        path.write_text(shared["toml"])
        assert pg.read_scenario(path) == scenario


def test_a_saved_file_comes_back_into_the_page(told):
    scenarios, answer = told
    for scenario, shared in zip(scenarios, answer["shared"], strict=True):
        assert pg.Scenario(**shared["back"]) == scenario


def test_a_link_holds_the_scenario(told):
    scenarios, answer = told
    for scenario, shared in zip(scenarios, answer["shared"], strict=True):
        assert pg.Scenario(**shared["linked"]) == scenario


def test_a_saved_file_gives_the_same_rate(told, tmp_path):
    """The very scenario gives the very bits: the first preset stands for all."""
    scenarios, answer = told
    path = tmp_path / "saved.toml"
    path.write_text(answer["shared"][0]["toml"])
    short = [scenario.replace(duration="0.6 s") for scenario in (pg.read_scenario(path), scenarios[0])]
    assert pg.simulate(short[0]).spin_rate == pg.simulate(short[1]).spin_rate


def test_what_is_no_scenario_is_refused_in_a_line(told):
    _, answer = told
    for (text, word), got in zip(FILES.items(), answer["files"], strict=True):
        if word == "sheet.outline.shape":
            assert got["sheet"]["outline"] == {}  # the check of the scenario says what is missing
        else:
            assert word in got["refused"], text
            assert "\n" not in got["refused"]


def test_a_spoilt_link_is_refused_or_harmless(told):
    _, answer = told
    for (text, word), got in zip(LINKS.items(), answer["links"], strict=True):
        assert word in got.get("refused", ""), text[:60]
