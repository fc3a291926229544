"""What docs/architecture.md claims of the tree is so: its files and floors; and nothing is too long to be read."""

from __future__ import annotations

import ast
import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]
SOURCE = ROOT / "src" / "plategait"
MODULES = sorted(SOURCE.rglob("*.py"))
TEXT = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
LONGEST_FUNCTION, LONGEST_MODULE = 80, 400


def drawn() -> list[str]:
    """Every path in the tree, folders with a closing slash.

    Each line has the names of one folder, or of files that share a caption, two blanks further in than the folder that
    holds them; the caption follows after two blanks or more.
    """
    tree = next(block for block in re.findall(r"^```\n(.*?)^```$", TEXT, re.M | re.S) if "src/plategait/\n" in block)
    folders: list[str] = []
    paths = []
    for line in tree.splitlines():
        depth = (len(line) - len(line.lstrip())) // 2
        names = re.split(r"  +", line.strip())[0].split()
        paths += ["".join(folders[:depth]) + name for name in names]
        if names[0].endswith("/"):
            folders[depth:] = names
    return paths


def test_every_path_of_the_tree_exists_once():
    paths = drawn()
    assert len(paths) == len(set(paths))
    assert [path for path in paths if not list(ROOT.glob(path.rstrip("/")))] == []
    assert [path for path in paths if path.endswith("/") != all(p.is_dir() for p in ROOT.glob(path.rstrip("/")))] == []


def test_every_module_and_package_has_its_line():
    here = {
        f"{module.parent}/" if module.name == "__init__.py" and module.parent != SOURCE else f"{module}"
        for module in (module.relative_to(ROOT) for module in MODULES)
    }
    covered = {f"{p.relative_to(ROOT)}{'/' * p.is_dir()}" for path in drawn() for p in ROOT.glob(path.rstrip("/"))}
    assert sorted(here - covered) == []


def test_the_floors_are_those_that_the_linter_enforces():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    contracts = project["tool"]["importlinter"]["contracts"]
    layers = next(contract["layers"] for contract in contracts if contract["type"] == "layers")
    enforced = [set(layer.split(" | ")) for layer in layers if layer != "__main__"]
    floors = re.findall(r"^\| (\d+) \| (.+?) \|", TEXT, re.M)
    assert [int(number) for number, _ in floors] == list(range(len(floors), 0, -1))
    assert [set(re.findall(r"`(\w+)`", rooms)) for _, rooms in floors] == enforced


def test_no_module_is_too_long_to_be_read_at_once():
    lines = {str(path.relative_to(SOURCE)): len(path.read_text(encoding="utf-8").splitlines()) for path in MODULES}
    assert {path: n for path, n in lines.items() if n > LONGEST_MODULE} == {}


def test_no_function_is_too_long_to_be_a_sentence():
    lines = {
        f"{path.relative_to(SOURCE)}: {node.name}": node.end_lineno - node.lineno + 1
        for path in MODULES
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) and node.end_lineno is not None
    }
    assert {name: n for name, n in lines.items() if n > LONGEST_FUNCTION} == {}
