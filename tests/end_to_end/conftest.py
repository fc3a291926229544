"""What all tests of commands share."""

from __future__ import annotations

import functools
import sys
from pathlib import Path
from subprocess import CompletedProcess

import pytest
import typer

from plategait.cli import main


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
