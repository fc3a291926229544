"""What all tests of commands share."""

from __future__ import annotations

import functools
import shutil
import sys
from pathlib import Path
from subprocess import CompletedProcess
from typing import Any

import pytest
import typer
from lab_tab import Tab

from plategait.cli import main


@pytest.fixture(scope="session", autouse=True)
def a_terminal_of_a_known_width():
    """Print tables as wide on any machine: in a narrow terminal lines break elsewhere."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("COLUMNS", "120")
        yield


@pytest.fixture(scope="session", autouse=True)
def commands_built_once():
    """Build the tree of commands once, as a process that runs one command does, and not for each of a thousand."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(typer.main, "get_command", functools.cache(typer.main.get_command))
        yield


@pytest.fixture
def called(monkeypatch, capsys):
    """Run a command line without the half second and more that a process takes to start.

    The installed command is nothing but this call; each file of tests starts it as a process too.
    """

    def run(*arguments: str, cwd: Path, check: int) -> CompletedProcess[str]:
        monkeypatch.chdir(cwd)
        monkeypatch.setattr(sys, "argv", ["plategait", *arguments])
        with pytest.raises(SystemExit) as end:
            main()
        done = CompletedProcess(arguments, end.value.code, *capsys.readouterr())
        assert done.returncode == check, done.stderr + done.stdout
        return done

    return run


# Chromium as systems call it, drawing by itself where there is no graphics card.
CHROMIUM = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
DRAWING = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox")


@pytest.fixture(scope="session")
def browser():
    """A browser without a window; skips with the reason where there is none."""
    sync = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    path = next(filter(None, map(shutil.which, CHROMIUM)), None)
    if path is None:
        pytest.skip(f"no browser here: none of {', '.join(CHROMIUM)}")
    with sync.sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path=path, args=list(DRAWING))
        yield opened
        opened.close()


@pytest.fixture
def new_tab(browser):
    """Open tabs, each in a browser as fresh as a stranger's; keywords are those of playwright's contexts."""
    contexts = []

    def new(**options: Any) -> Tab:
        context = browser.new_context(**options)
        contexts.append(context)
        return Tab(context.new_page())

    yield new
    for context in contexts:
        context.close()


@pytest.fixture(scope="session")
def lab_file(tmp_path_factory):
    """Write the lab's page for what a user names, as `plategait lab` does."""
    from plategait.lab.page import page
    from plategait.lab.payload import named
    from plategait.model.presets import as_scenario

    folder = tmp_path_factory.mktemp("lab")

    def write(what: str = "cheese", scenario: Any = "cheese", payload: dict[str, Any] | None = None) -> Path:
        if payload is None:
            shown = named(what)
            base = as_scenario(what if shown.kind == "scenario" else scenario)
            payload = shown.payload(None if shown.own_scenario else base)
        path = folder / f"{len(list(folder.iterdir()))}.html"
        path.write_text(page(payload), encoding="utf-8")
        return path

    return write
