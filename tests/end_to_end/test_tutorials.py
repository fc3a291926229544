"""Tutorials, how-to pages, gallery and notebooks, typed as they stand."""

from __future__ import annotations

import ast
import json
import re
import shlex
from dataclasses import dataclass
from pathlib import Path

import matplotlib as mpl
import pytest

from plategait.simulation import registry

ROOT = Path(__file__).parents[2]
PAGES = [page for folder in ("tutorials", "howto") for page in sorted((ROOT / "docs" / folder).glob("*.md"))]
BLOCK = re.compile(r"^```(\w+)[ \t]*([^\n`]*)\n(.*?)^```$", re.M | re.S)


@dataclass(frozen=True)
class Block:
    """A block of a page: what language it is in, what is said of it, what is in it."""

    language: str
    said: str
    text: str


def blocks(page: Path) -> list[Block]:
    return [Block(*found) for found in BLOCK.findall(page.read_text(encoding="utf-8"))]


def typed(text: str) -> list[list[str]]:
    """Each command of a shell block."""
    return [shlex.split(line, comments=True) for line in text.replace("\\\n", " ").splitlines() if line.strip()]


def execute(source: str, names: dict[str, object], name: str) -> None:
    exec(compile(source, name, "exec"), names)


@pytest.fixture(autouse=True)
def nothing_added(monkeypatch):
    """An observable that a page adds is gone with it."""
    monkeypatch.setattr(registry, "_added", {})


@pytest.fixture(autouse=True)
def no_display(monkeypatch):
    monkeypatch.setattr(mpl, "rcParams", mpl.rcParams.copy())
    mpl.use("Agg")


@pytest.mark.slow
@pytest.mark.parametrize("page", PAGES, ids=lambda page: f"{page.parent.name}-{page.stem}")
def test_a_page_does_what_it_says(page, called, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "clips").mkdir()
    names: dict[str, object] = {"__name__": "page"}
    for block in blocks(page):
        if block.language in ("toml", "text") and block.said:
            (tmp_path / block.said).write_text(block.text, encoding="utf-8")
        elif block.language == "python":
            execute(block.text, names, page.name)
        elif block.language == "sh" and block.said != "no-run":
            for command in typed(block.text):
                assert command[0] == "plategait", command
                called(*command[1:], cwd=tmp_path, check=1 if block.said == "status 1" else 0)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: f"{page.parent.name}-{page.stem}")
def test_what_is_not_run_has_options_that_exist(page):
    import typer

    from plategait.cli import app

    group = typer.main.get_command(app)
    for block in blocks(page):
        if block.language != "sh":
            continue
        assert block.said in ("", "no-run", "status 1"), block.said
        for command in typed(block.text):
            if command[0] != "plategait":
                continue
            known = group.commands[command[1]]
            known = known.commands[command[2]] if hasattr(known, "commands") and command[2] in known.commands else known
            if hasattr(known, "commands"):
                continue
            options = {name for parameter in known.params for name in parameter.opts}
            told = {word for word in command[2:] if word.startswith("--")}
            assert told <= options, (command, sorted(told - options))


@pytest.mark.slow
@pytest.mark.parametrize(
    "notebook", sorted((ROOT / "examples" / "notebooks").glob("*.ipynb")), ids=lambda notebook: notebook.stem
)
def test_a_notebook_executes(notebook, tmp_path, monkeypatch):
    # Cell by cell in one namespace, as a kernel does; what stands last in a cell is shown as a notebook would show it.
    monkeypatch.chdir(tmp_path)
    book = json.loads(notebook.read_text(encoding="utf-8"))
    names: dict[str, object] = {"__name__": "notebook"}
    for cell in book["cells"]:
        if cell["cell_type"] != "code":
            continue
        assert (cell["outputs"], cell["execution_count"]) == ([], None), "results of a notebook are not committed"
        body = ast.parse("".join(cell["source"]))
        last = body.body.pop() if isinstance(body.body[-1], ast.Expr) else None
        exec(compile(body, notebook.name, "exec"), names)
        if isinstance(last, ast.Expr):
            value = eval(compile(ast.Expression(last.value), notebook.name, "eval"), names)
            html = getattr(value, "_repr_html_", lambda: None)()
            assert "<" in html if html else repr(value)
