"""What is documented: every public name in full, and what the pages name exists."""

from __future__ import annotations

import inspect
import re
from pathlib import Path

import pytest

import plategait as pg

ROOT = Path(__file__).parents[2]
PUBLIC = {name: getattr(pg, name) for name in pg.__all__}
CALLED = {name: thing for name, thing in PUBLIC.items() if inspect.isclass(thing) or inspect.isfunction(thing)}
# What is physics, or is read off it; the others are files, plans and shapes.
PHYSICS = (
    "Contact", "Friction", "Material", "PlateMotion", "Wave", "Plate", "Machine", "Needs", "needs", "Sheet", "simulate",
    "Simulation", "Session", "spin_curve", "Curve", "LorentzFit", "fit_lorentzian", "estimate_parameters", "Estimate",
    "next_measurement", "optimize_motion", "atlas", "mjcf", "trajectory",
)  # fmt: skip
HEADING = re.compile(r"^(\w[\w ]*)\n-{3,}$", re.M)


def sections(text: str) -> dict[str, str]:
    """Sections of a NumPy docstring by their headings; what comes before is under ""."""
    parts = HEADING.split(text)
    return {"": parts[0]} | dict(zip(parts[1::2], parts[2::2], strict=True))


def told(section: str) -> set[str]:
    """Names of a section's entries."""
    heads = re.findall(r"^(\S[^\n:]*?)(?: : .*)?$", section, re.M)
    return {name.strip().lstrip("*") for head in heads for name in head.split(",")}


def parameters(thing) -> set[str]:
    kinds = (inspect.Parameter.VAR_KEYWORD, inspect.Parameter.VAR_POSITIONAL)
    return {p.name for p in inspect.signature(thing).parameters.values() if p.kind not in kinds and p.name[0] != "_"}


@pytest.mark.parametrize("name", sorted(CALLED))
def test_every_parameter_is_told(name):
    found = sections(inspect.getdoc(CALLED[name]) or "")
    assert len(found[""].split()) > 2, "says what it is for"
    entries = told(found.get("Parameters", "")) | told(found.get("Attributes", ""))
    assert parameters(CALLED[name]) - entries == set()


@pytest.mark.parametrize("name", sorted(n for n, thing in CALLED.items() if inspect.isfunction(thing)))
def test_a_function_that_refuses_says_so(name):
    if "raise InputError" in inspect.getsource(CALLED[name]):
        assert "InputError" in sections(inspect.getdoc(CALLED[name]) or "").get("Raises", "")


@pytest.mark.parametrize("name", sorted(n for n, thing in CALLED.items() if inspect.isclass(thing)))
def test_every_method_says_what_it_does(name):
    own = {n: value for n, value in vars(CALLED[name]).items() if not n.startswith("_") and inspect.isfunction(value)}
    silent = [n for n, value in own.items() if not inspect.getdoc(value)]
    assert silent == []


@pytest.mark.parametrize("name", PHYSICS)
def test_physics_names_its_source(name):
    text = inspect.getdoc(CALLED[name]) or ""
    assert re.search(r"\(\d\.\d+\)|[Ss]ections? \d\.\d|Table \d|docs/\w+\.md", text)
    pages = re.findall(r"docs/\w+\.md", text)
    assert [page for page in pages if not (ROOT / page).is_file()] == []


def test_the_reference_has_every_public_name_once():
    page = (ROOT / "docs" / "reference" / "api.rst").read_text(encoding="utf-8")
    listed = [word for block in re.findall(r"\.\. public::\n\n((?:   .+\n)+)", page) for word in block.split()]
    assert sorted(listed) == sorted(pg.__all__)


def test_the_tests_that_the_page_of_trust_names_exist():
    page = (ROOT / "docs" / "trust.md").read_text(encoding="utf-8")
    there = {path.name for path in (ROOT / "tests").rglob("test_*.py")}
    named = {Path(name).name for name in re.findall(r"`([\w/]*test_\w+\.py)`", page)}
    assert len(named) > 30
    assert named - there == set()


def test_every_item_of_the_regenerated_dissertation_is_on_the_map():
    from plategait.thesis.study import NAMES

    page = (ROOT / "docs" / "dissertation.md").read_text(encoding="utf-8")
    tables = {f"table5.{i}" for i in range(2, 9)}  # the map says "table5.1 … fig5.12"
    between = {"fig5.7", "fig5.8", "fig5.9", "fig5.11", "targets"} | tables
    assert {name for name in NAMES if name not in page} - between == set()


def test_every_command_and_every_option_says_what_it_is():
    import typer

    from plategait.cli import app

    def below(path, group):
        for name, command in group.commands.items():
            if hasattr(command, "commands"):
                yield from below(f"{path} {name}", command)
            else:
                yield f"{path} {name}", command

    found = list(below("plategait", typer.main.get_command(app)))
    assert len(found) > 25
    silent = [path for path, command in found if not command.help]
    silent += [
        f"{path} {parameter.opts[0]}"
        for path, command in found
        for parameter in command.params
        if parameter.param_type_name == "option" and not parameter.help
    ]
    assert silent == []


def test_the_first_screen_says_what_it_does_and_shows_it_in_ten_lines():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    code, commands, lab = re.findall(r"```(?:python|sh)\n(.*?)```", readme, re.S)[:3]
    pieces = ["Simulates a thin soft object", "![A slice", code, commands, lab, "## What it is for"]
    places = [readme.index(piece) for piece in pieces]
    assert places == sorted(places)
    assert len(code.splitlines()) == 10
    assert readme[: places[-1]].count("\n") < 50, "a screen"
    compile(code, "README.md", "exec")
    assert {name.split(".")[0] for name in re.findall(r"pg\.(\w+)", code)} <= set(pg.__all__)
    assert [line.split("#")[0].strip() for line in commands.splitlines()] == ["make demo", "make test"]
    assert lab.startswith("plategait lab ")
